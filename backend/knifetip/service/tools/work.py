"""The lengths that the stations of a machine have worked in its ended runs, as running sums."""

from __future__ import annotations

from collections.abc import Mapping

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.service.database.engine import insert_into
from knifetip.service.database.tables import ToolEvent, ToolWork


def worked_lengths(session: Session, machine: str) -> dict[int, float]:
    """Return the lengths (mm) that stations have worked in all ended runs, by their numbers."""
    columns = sa.select(ToolWork.station, ToolWork.length).where(ToolWork.machine == machine)
    return {row.station: row.length for row in session.execute(columns)}


def add_work(session: Session, machine: str, ended: float, added: Mapping[int, float]) -> None:
    """Add the lengths of a run to the sums of its machine.

    Parameters
    ----------
    session
        Session with the transaction of the caller.
    machine
        Name of the machine.
    ended
        End of the run (seconds since 1970).
    added
        Lengths (mm) by number of the station: those of the run, or what a late report adds to
        them; negative if the run was shorter than reported before.
    """
    # In one order, so that two transactions do not wait for each other.
    for station, length in sorted(added.items()):
        if length == 0.0:
            continue
        insert = insert_into(session, ToolWork).values(
            machine=machine, station=station, length=length
        )
        session.execute(
            insert.on_conflict_do_update(
                index_elements=[ToolWork.machine, ToolWork.station],
                set_={"length": ToolWork.length + insert.excluded.length},
            )
        )
        # A tool that was changed after the end of the run has not worked in it.
        session.execute(
            sa.update(ToolEvent)
            .where(
                ToolEvent.machine == machine,
                ToolEvent.station == station,
                ToolEvent.kind == "changed",
                ToolEvent.at >= ended,
            )
            .values(worked_before=ToolEvent.worked_before + length)
        )
