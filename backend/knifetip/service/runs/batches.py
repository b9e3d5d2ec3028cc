"""Whether a machine that feeds its sheets itself may begin the next sheet without the operator.

It continues only with the same board and within the life of the tools: the operator confirms the
first sheet of each batch, and each sheet for which a tool is worn.
"""

from __future__ import annotations

from collections.abc import Callable, Collection

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import State
from knifetip.service.database.tables import Job, MachineRun

#: Returns the numbers of the stations of a machine whose tools are at the end of their lives.
WornStations = Callable[[str], Collection[int]]


def no_worn_stations(machine: str) -> Collection[int]:  # noqa: ARG001  # signature of ``WornStations``
    """Return no station, for a machine whose tools are not recorded."""
    return ()


def uses_worn_tool(row: Job, worn: WornStations) -> bool:
    """Return whether a job uses a tool at the end of its life."""
    stations = worn(row.machine)
    return any(tool["station"] in stations for tool in row.tools)


def begins_batch(session: Session, row: Job) -> bool:
    """Return whether the next sheet of a job is the first one of a batch.

    It is, unless the job has completed a copy, or the run before on its machine was completed and
    used the same board.
    """
    if row.copies_done:
        return False
    last = session.execute(
        sa.select(MachineRun.board, MachineRun.outcome)
        # Not ``ended > 0``, for which SQLite would read all runs of the machine.
        .where(MachineRun.machine == row.machine, MachineRun.outcome != "")
        .order_by(MachineRun.id.desc())
        .limit(1)
    ).first()
    return last is None or last.outcome != State.DONE or last.board != row.board
