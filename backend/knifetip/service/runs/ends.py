"""The end of a job, as its gateway reports it: its state, its progress and where it stopped."""

from __future__ import annotations

from typing import Any

from sqlalchemy.orm import Session

from knifetip.contract.job import Actor, ActorKind, Confirmation, State
from knifetip.messages import Message
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.machine_runs import end_run
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.runs.claimed_jobs import ClaimedJobs
from knifetip.service.runs.interruption import interruption
from knifetip.service.runs.stop_place import StopPlace, most_lines, stopped


class JobEnds:
    """Stores the ends of jobs, each in the transaction of the caller."""

    def __init__(self, database: Database, transitions: Transitions, claimed: ClaimedJobs) -> None:
        self._db = database
        self._transitions = transitions
        self._claimed = claimed

    def store(
        self,
        session: Session,
        row: Job,
        goal: State,
        cause: Message | None,
        line: int | None,
        copies_done: int | None,
        place: StopPlace,
    ) -> None:
        """Store the end of a job; a late report of the same end has no effect.

        Parameters
        ----------
        session, row
            Session of the transaction, and the job; its state is ``interrupted`` if the report is
            late.
        goal
            State in which the job ends: ``done``, ``interrupted`` or ``cancelled``.
        cause
            Cause that the gateway reports; None if it reports none.
        line
            Executed lines of the current copy; None for the number stored in the job.
        copies_done
            Completed copies of the job; None for the number stored in the job.
        place
            Place at which the machine stopped.
        """
        ended: dict[str, Any] = {
            "requested_action": "",
            "lease": 0.0,
            "seconds_left": None,
            "confirmation": Confirmation.NONE.value,
        }
        late = row.state == State.INTERRUPTED
        event = cause or Message("job.executed" if goal is State.DONE else "job.cancelled")
        if goal is State.DONE:
            ended |= {"line": row.lines, "copies_done": row.copies, "seconds_left": 0.0}
            ended |= {"message": None, "stopped_at": None}
            if late:
                event = Message("job.late-report", report=event)
        elif goal is State.INTERRUPTED:
            cause = cause or Message("gateway.no-reason")
            stop = interruption(row, cause, line, copies_done, place.at_most)
            event = stop.message
            ended |= {"message": event, "line": stop.line, "copies_done": stop.copies_done}
            ended |= stopped(stop.line, stop.at_most, place)
            if late:
                if event != row.message:
                    self._claimed.change(session, row, ended)
                    end_run(session, row.id, self._db.clock())
                    owner = Actor(ActorKind.GATEWAY, row.owner)
                    report = Message("job.late-report", report=event)
                    self._transitions.write_job_event(
                        session, row.id, goal, owner, report, row.machine
                    )
                return
        else:
            ended["line"] = row.line if line is None else min(line, row.lines)
            ended |= stopped(ended["line"], most_lines(row, ended["line"], place.at_most), place)
        self._claimed.move(session, row, goal, event, **ended)
