"""The unfinished sheet that the last run on a machine may have left on its table."""

from __future__ import annotations

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import State
from knifetip.service.database.tables import Job, MachineRun

#: States of a job that was stopped, in which no operator has stated what became of its sheet.
_LEFT = (State.CONTINUED, State.CANCELLED)


def unfinished_sheet(session: Session, row: Job) -> str:
    """Return the job whose unfinished sheet may lie on the table; "" if there is none.

    The sheet of a stopped job stays on the table, also if the job that was to make its rest is
    cancelled, held or moved before it begins.  Nothing is left for the rest of the sheet itself,
    which needs it there, and after a job that was scrapped or queued again.

    Parameters
    ----------
    session
        Session with a transaction.
    row
        The job that is to start next on its machine.
    """
    last = session.execute(
        sa.select(MachineRun.job, MachineRun.outcome, Job.state)
        .join(Job, Job.id == MachineRun.job, isouter=True)
        # Not ``ended > 0``, for which SQLite would read all runs of the machine.
        .where(MachineRun.machine == row.machine, MachineRun.outcome != "")
        .order_by(MachineRun.id.desc())
        .limit(1)
    ).first()
    if last is None or last.outcome == State.DONE or last.state not in _LEFT:
        return ""
    if row.rest is not None and row.resumes == last.job:
        return ""
    return str(last.job)
