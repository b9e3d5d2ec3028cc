"""Route for the section of the board across an edge, as the program of a job makes it."""

from __future__ import annotations

from typing import Annotated

from fastapi import Query

from knifetip.errors import NotFound
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.sections import edge_section
from knifetip.service.components import ServiceDep
from knifetip.service.http.parameters import JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.program_models import EdgeSectionOut

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.get("/{id}/section")
@requires(AccessScope.VIEWER)
def get_section(
    service: ServiceDep,
    id: JobId,
    edge: Annotated[
        int, Query(ge=0, le=2**31 - 1, description="Row of the edge in the drawing, from 0")
    ],
) -> EdgeSectionOut:
    """Get the section of the board across an edge: what the tools of the program make there.

    Depths come from the tool path, dimensions from the machine and the board for which the job is
    compiled, and measurements from the verdict.
    """
    row = service.store.jobs.get(id)
    toolpath, _ = unpack_columns(service.store.jobs.column(id, "toolpath"))
    verdict, _ = unpack_columns(service.store.jobs.column(id, "verdict"))
    count = len(verdict["deviation"])
    if edge >= count:
        raise NotFound("override.no-such-edge", edge=str(edge), count=count)
    machine = service.store.library.machine(row.machine, row.machine_version)
    board = service.store.library.board(row.board, row.board_version)
    section = edge_section(edge, toolpath, verdict, machine, board)
    return EdgeSectionOut.model_validate(section)
