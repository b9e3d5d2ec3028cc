"""Records of the runs of jobs on machines, in the transactions of their transitions.

A run begins when a claimed job starts and ends when the job leaves the machine.  Statistics
are computed from runs, which remain when jobs are deleted; the use of tools from their sums.
"""

from __future__ import annotations

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import Action, State
from knifetip.service.database.tables import Job, MachineRun, RunLength
from knifetip.service.tools.work import add_work
from knifetip.service.tools.worked_lengths import Lengths, lengths_of_copies


def record_run(session: Session, id: str, action: Action, now: float) -> None:
    """Store the begin or the end of a run, if an action on a job is one.

    Parameters
    ----------
    session
        Session with the transaction of the caller, which has performed the action.
    id
        Id of the job.
    action
        The action.
    now
        Present time (seconds since 1970).
    """
    if action is Action.START:
        _begin(session, id, now)
    elif action in (Action.FINISH, Action.INTERRUPT, Action.CANCEL):
        end_run(session, id, now)
    elif action is Action.RETURN:
        delete_run(session, id)


def delete_run(session: Session, id: str) -> None:
    """Delete the last run of a job: nothing was executed in it."""
    epoch = sa.select(Job.owner_epoch).where(Job.id == id).scalar_subquery()
    session.execute(sa.delete(MachineRun).where(MachineRun.job == id, MachineRun.epoch == epoch))


def _begin(session: Session, id: str, now: float) -> None:
    claim = sa.select(Job.owner_epoch, Job.machine, Job.board).where(Job.id == id)
    epoch, machine, board = session.execute(claim).one()
    session.add(
        MachineRun(
            job=id,
            epoch=epoch,
            machine=machine,
            board=board,
            started=now,
            ended=0.0,
            outcome="",
            copies=0,
            sheets=0,
        )
    )


def end_run(session: Session, id: str, now: float) -> None:
    """Store the end of the last run of a job, or correct it after a late report.

    The first call for a run determines its duration.  Nothing is stored for a job without a run, or
    if a job is cancelled after its last run has ended.

    Parameters
    ----------
    session
        Session with the transaction of the caller, which has changed the job.
    id
        Id of the job.
    now
        Present time (seconds since 1970).
    """
    columns = sa.select(
        Job.owner_epoch, Job.state, Job.copies, Job.copies_before, Job.copies_done, Job.line,
        Job.lines, Job.lengths,
    )  # fmt: skip
    job = session.execute(columns.where(Job.id == id)).one()
    run = session.scalar(
        sa.select(MachineRun).where(MachineRun.job == id, MachineRun.epoch == job.owner_epoch)
    )
    if run is None or (run.ended and job.state == State.CANCELLED):
        return
    copies, line = job.copies_done - job.copies_before, job.line
    if job.state == State.DONE:
        line = 0
    elif job.state == State.CANCELLED and copies and line >= job.lines:
        # Between two copies ``line`` is the last line of the completed copy.
        line = 0
    run.outcome = job.state
    run.ended = run.ended or now
    run.copies, run.sheets = copies, copies + (line > 0)
    lengths = lengths_of_copies(job.lengths, copies, line)
    added = _lengths_of_stations(lengths)
    for station, length in _stored_lengths(session, run).items():
        added[station] = added.get(station, 0.0) - length
    session.execute(sa.delete(RunLength).where(RunLength.run == run.id))
    session.add_all(
        RunLength(run=run.id, station=station, line_type=line_type, length=length)
        for (station, line_type), length in lengths.items()
        if length > 0.0
    )
    add_work(session, run.machine, run.ended, added)


def _lengths_of_stations(lengths: Lengths) -> dict[int, float]:
    """Return the length of each station (mm), of all line types."""
    found: dict[int, float] = {}
    for (station, _), length in lengths.items():
        found[station] = found.get(station, 0.0) + length
    return found


def _stored_lengths(session: Session, run: MachineRun) -> dict[int, float]:
    """Return the length of each station (mm) that an earlier report of a run has stored."""
    columns = sa.select(RunLength.station, RunLength.line_type, RunLength.length)
    stored = session.execute(columns.where(RunLength.run == run.id))
    return _lengths_of_stations({(station, kind): length for station, kind, length in stored})
