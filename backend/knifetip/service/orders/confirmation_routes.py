"""Route for what the operator confirms before a machine starts a job or its next copy."""

from __future__ import annotations

from knifetip.messages import render
from knifetip.service.components import ServiceDep
from knifetip.service.http.parameters import JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.confirmation_models import ConfirmationOut
from knifetip.service.orders.operator_actions import awaits_confirmation
from knifetip.service.runs.checks import Check
from knifetip.service.tools.store import ToolUse

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.get("/{id}/confirmation")
@requires(AccessScope.VIEWER)
def get_confirmation(service: ServiceDep, id: JobId) -> ConfirmationOut:
    """Get what the operator confirms before the machine starts a job or its next copy.

    The operator makes each of the `checks` at the machine, and then confirms them all by their ids
    with `POST /api/jobs/{id}/confirm`.
    """
    row = service.store.jobs.get(id)
    machine = service.store.library.machine(row.machine)
    uses = {use.station: use for use in service.store.tools.uses(machine)}
    return ConfirmationOut.model_validate(
        {
            "awaited": awaits_confirmation(row, service.store.database.clock()),
            "checks": [_check(check) for check in service.store.operators.checks(row)],
            "machine": row.machine,
            "board": row.board,
            "tools": [{**tool, **_wear(uses.get(tool["station"]))} for tool in row.tools],
            "placement": machine.origin,
            "sheet": row.options.sheet,
            "copy": min(row.copies_done + 1, row.copies),
            "copies": row.copies,
            "first_of_batch": service.store.gateways.begins_batch(row),
            "rest_of_sheet": row.rest is not None,
            "unfinished_sheet": service.store.gateways.unfinished_sheet(row),
        }
    )


def _check(check: Check) -> dict[str, object]:
    """Return a check for clients."""
    return {
        "id": check.id,
        "text": render(check.text),
        "message": check.text,
        "station": check.station,
    }


def _wear(use: ToolUse | None) -> dict[str, object]:
    """Return the wear of a tool for clients; None for a station that the machine does not have."""
    if use is None:
        return {"used": None, "life": None, "warning": ""}
    return {"used": use.used / 1000.0, "life": use.life / 1000.0 or None, "warning": use.warning}
