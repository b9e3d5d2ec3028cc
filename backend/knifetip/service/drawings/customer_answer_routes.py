"""Routes for answers that are learned from drawings of a customer: list them, switch them off or
on.
"""

from __future__ import annotations

from dataclasses import replace

from fastapi import Response

from knifetip.classification.customer_agreement import learn_answers
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.model.customer_answers import Look
from knifetip.presentation.learned import answer_json
from knifetip.service.accounts.ownership import OwnDrawing
from knifetip.service.components import ServiceDep
from knifetip.service.database.tables import Drawing
from knifetip.service.drawings.customer_answer_models import LookPatch, TaughtLookOut
from knifetip.service.drawings.interpretations import interpretation_of
from knifetip.service.drawings.models import DrawingOut
from knifetip.service.drawings.requests import Change, apply_change, learned_for
from knifetip.service.http.parameters import DrawingId
from knifetip.service.http.revisions import IfMatch, check_match
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import queued

router = ScopedRouter(prefix="/drawings", tags=["drawings"])


@router.get("/{id}/customer-answers")
@requires(AccessScope.VIEWER)
def list_customer_answers(service: ServiceDep, id: DrawingId) -> list[TaughtLookOut]:
    """List the answers learned from other drawings of the same customer, also those switched off.

    The list is empty for a drawing without a customer.
    """
    row = service.store.drawings.get(id)
    if not row.customer:
        return []
    answers = service.store.customer_answers
    refused = answers.refused(row.customer)
    learned = learn_answers(answers.taught(row.customer, row.id), row.sha256)
    by_look = {(one.look, one.line_type): one for one in reversed(learned)}
    return [
        TaughtLookOut.model_validate({**answer_json(one), "used": one.look not in refused})
        for one in by_look.values()
    ]


@router.patch("/{id}/customer-answers", dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER)
@queued
def use_customer_answer(
    service: ServiceDep, response: Response, id: DrawingId, patch: LookPatch, match: IfMatch = None
) -> DrawingOut:
    """Switch a learned answer of a customer on or off, and classify the drawing again.

    It applies to this drawing and to drawings that are uploaded later.
    """
    row = service.store.drawings.get(id)
    check_match(match, row)
    if not row.customer:
        raise WrongState("drawing.no-customer", drawing=id)
    look = Look(patch.layer, patch.colour, patch.true_colour, patch.linetype, patch.line_width)
    service.store.customer_answers.set_refused(row.customer, look, not patch.used)

    def decide(row: Drawing) -> Change:
        before = interpretation_of(row, row.overrides)
        learned = learned_for(service, row.customer, row.sha256, row.id)
        code = "drawing.answer-used" if patch.used else "drawing.answer-taken-back"
        event = Message(code, customer=row.customer)
        return Change(replace(before, learned=learned), event)

    return apply_change(service, response, id, match, decide)
