"""Execute several orders of one request, each of which has a result whatever fails."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from knifetip.errors import KnifetipError, OpenQuestions, StoreError
from knifetip.messages import Message
from knifetip.service.components import Service
from knifetip.service.database.acting import note_refusal
from knifetip.service.database.request_key import fingerprint
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.orders_with_files import InvalidOrder, OrderIn, OrderResult
from knifetip.service.orders.sent_orders import SentOrder, create_sent_job, store_drawing
from knifetip.service.processes.pool import TaskFailed
from knifetip.service.refusals.error_status import answer_status
from knifetip.service.refusals.failures import failure_of
from knifetip.service.refusals.invalid_requests import NamesNear, invalid_request

_log = logging.getLogger("knifetip.api")


@dataclass(slots=True)
class _Progress:
    """What an order has created so far, and why it went no further."""

    drawing: str | None = None
    job_id: str | None = None
    job: JobOut | None = None
    problem: Message | None = None
    status: int = 201
    source: Sequence[str] = ()
    edges: Sequence[int] = ()
    questions: tuple[dict[str, object], ...] = ()
    affects_all: bool = False  #: whether ``problem`` is one of the server

    def result(self, index: int) -> OrderResult:
        return OrderResult.model_validate(
            {
                "index": index,
                "status": self.status,
                "drawing": self.drawing,
                "job_id": self.job_id,
                "job": self.job,
                "problem": self.problem,
                "source": self.source,
                "edges": self.edges,
                "questions": self.questions,
            }
        )


def execute_orders(
    service: Service,
    orders: Sequence[OrderIn | InvalidOrder],
    key: str | None,
    names: NamesNear = lambda _: (),
    permit: Callable[[OrderIn], None] = lambda _: None,
) -> list[OrderResult]:
    """Execute orders one after the other, and return a result for each.

    What an order has stored before it failed is in its result.  After a failure of the database,
    of the disk or of the server itself the remaining orders are not tried: each would wait for
    the same failure.

    Parameters
    ----------
    service
        The server.
    orders
        The orders.
    key
        Idempotency-Key of the request, None if it has none.
    names
        Returns the names that a field may have, for the messages about unknown fields.
    permit
        Raises the error of an order that the sender may not place.
    """
    failed: _Progress | None = None
    results = []
    for index, order in enumerate(orders):
        progress = _Progress()
        if isinstance(order, InvalidOrder):
            progress.status = 422
            progress.problem, progress.source = invalid_request(order.faults_at(index), names)
        elif failed is None:
            own = None if key is None else f"{fingerprint(key)}/{index}"
            _execute(service, index, order, own, permit, progress)
            if progress.affects_all:
                failed = progress
        else:
            progress.status = failed.status
            progress.problem = Message("request.order-not-tried", reason=failed.problem)
        if progress.problem is not None:
            note_refusal()
        results.append(progress.result(index))
    return results


def _execute(
    service: Service,
    index: int,
    order: OrderIn,
    key: str | None,
    permit: Callable[[OrderIn], None],
    progress: _Progress,
) -> None:
    """Execute an order; ``progress`` gets what it creates, and its failure."""
    try:
        permit(order)
        sent = SentOrder(order)
        drawing = store_drawing(service, sent, key)
        progress.drawing = drawing.id
        job = create_sent_job(service, sent, drawing, sent.key(key))
        progress.job_id = job.id
        progress.job = job_out(service.store, job)
    except KnifetipError as reason:
        progress.problem, progress.source = reason.message, reason.source
        progress.edges = reason.edges
        progress.status = answer_status(reason, "POST")
        progress.affects_all = isinstance(reason, StoreError)
        if isinstance(reason, OpenQuestions):
            progress.questions = tuple(reason.questions)
    except TaskFailed as reason:
        progress.problem = Message("job.compile-crashed", incident=reason.incident)
    except Exception as reason:
        failure = failure_of(reason)
        progress.problem, progress.status = failure.message, failure.status
        progress.affects_all = failure.affects_all
        if failure.is_logged:
            _log.exception("order %d of a batch failed", index)
