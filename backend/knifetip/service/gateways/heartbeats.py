"""Heartbeats of gateways: each one updates its job and is answered with a command."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from knifetip.contract.job import Actor, ActorKind, Confirmation, State
from knifetip.messages import Message
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.transitions import LEASE, Transitions
from knifetip.service.machines.station_obstacles import obstacle_on
from knifetip.service.runs.batches import WornStations, uses_worn_tool
from knifetip.service.runs.checks import event_of_feed
from knifetip.service.runs.claimed_jobs import ClaimedJobs

#: Confirmations with which a machine that feeds its sheets itself begins the next copy.
_CONTINUES = (Confirmation.NONE, Confirmation.GIVEN)
#: Requested actions with which the gateway goes on.
_GOES_ON = ("resume", "end")


@dataclass(frozen=True, slots=True)
class GatewayReport:
    """Progress of a job, as its gateway reports it in a heartbeat."""

    line: int  #: executed lines of the current copy
    copies_done: int = 0  #: copies completed since this claim
    held: bool = False
    waiting: bool = False  #: nothing was sent to the machine; the gateway waits for ``start``
    position: Sequence[float] | None = None
    seconds_left: float | None = None
    #: Number of the phase of the run since the claim.  A new phase begins when a machine continues
    #: after a hold, and when the gateway itself begins to wait for the operator: for a new sheet,
    #: for the confirmation of the end, or because its lease has expired.  A request to resume
    #: counts only in the phase in which the operator made it.
    phase: int = 0
    #: the program is handed over, and a person must confirm that the machine has executed it
    awaits_end: bool = False
    #: a line of the program is sent as soon as this report is answered, or was sent already
    begun: bool = True


class Heartbeats:
    """Stores the heartbeats of gateways and answers them.

    If the lease of a job has expired before a heartbeat, for example because the server was down,
    what the operator asked for until then no longer lets the machine move: the operator may have
    given up waiting and be at the table.

    Each method runs in the transaction of the caller, which ``session`` has begun.
    """

    def __init__(self, database: Database, transitions: Transitions, claimed: ClaimedJobs) -> None:
        self._db = database
        self._transitions = transitions
        self._claimed = claimed

    def answer_waiting(self, session: Session, row: Job) -> str:
        """Return the command for a gateway that has not sent anything to the machine yet.

        The command is one of the following; each answer also renews the lease of the job:

        - ``cancel`` if the operator has cancelled the job;
        - ``wait`` if the operator has not confirmed the job yet;
        - ``wait`` if the operator has confirmed the job but requested a hold; the job is stored as
          ``held`` until the operator confirms it again;
        - ``wait`` if the lease has expired since the operator confirmed the job; the operator must
          confirm it again;
        - ``start`` otherwise; the job is stored as ``running``.
        """
        late = self._is_late(row)
        renewed: dict[str, Any] = {"lease": self._db.clock() + LEASE}
        if row.requested_action == "cancel":
            self._claimed.change(session, row, renewed)
            return "cancel"
        if late and row.state == State.QUEUED:
            self._await_confirmation(session, row, renewed)
            return "wait"
        if row.confirmation == Confirmation.AWAITED:
            self._claimed.change(session, row, renewed)
            return "wait"
        # If the job is already running, the answer with ``start`` was lost.
        resumes = row.requested_action == "resume"
        holds = row.state == State.HELD or row.requested_action == "hold"
        starts = not late and (resumes or not holds)
        goal = State.RUNNING if starts else State.HELD
        renewed["requested_action"] = ""
        if not starts and row.confirmation == Confirmation.GIVEN:
            # Hands may be at the table again: the first line needs a new confirmation.
            renewed["confirmation"] = Confirmation.AWAITED.value
        if row.state == State.QUEUED:
            self._claimed.start(session, row, **renewed)
        elif row.state != goal:
            event = Message("job.started" if starts else "job.held-before-start")
            if late:
                event = Message("job.at-line", line=0)
            self._claimed.move(session, row, goal, event, **renewed)
        else:
            self._claimed.change(session, row, renewed)
        return "start" if starts else "wait"

    def _needs_person(self, session: Session, row: Job, worn: WornStations) -> bool:
        """Return whether a machine that feeds its sheets itself must not begin the next copy."""
        obstacle = obstacle_on(session, row.machine, self._db.timer())
        return obstacle is not None or uses_worn_tool(row, worn)

    def _is_late(self, row: Job) -> bool:
        """Return whether the lease of a job has expired, and its gateway still owns the job."""
        return row.lease < self._db.clock()

    def _await_confirmation(self, session: Session, row: Job, renewed: dict[str, Any]) -> None:
        """Let a claimed job wait for a new confirmation, with the renewed lease in ``renewed``."""
        confirmed = row.confirmation == Confirmation.GIVEN
        if confirmed:
            renewed |= {
                "confirmation": Confirmation.AWAITED.value,
                "requested_action": "",
                "updated": self._db.clock(),
            }
        self._claimed.change(session, row, renewed)
        if confirmed:
            gateway, event = Actor(ActorKind.GATEWAY, row.owner), Message("job.claimed-to-confirm")
            self._transitions.write_job_event(
                session, row.id, State.QUEUED, gateway, event, row.machine
            )

    def answer_running(
        self, session: Session, row: Job, report: GatewayReport, worn: WornStations
    ) -> str:
        """Store the report of a gateway on its running job, and return the command for the gateway.

        The command is the first of the following that applies:

        - ``cancel`` if the operator has requested a cancel;
        - ``hold`` if the operator must first confirm the job, or if the machine is not held
          although the operator must confirm the next sheet;
        - ``hold``, ``resume`` or ``end`` if this action is requested and the machine has not
          executed it; ``resume`` and ``end`` only if the lease has not expired since the request;
        - ``continue`` in all other cases.

        Parameters
        ----------
        session, row
            Session of the transaction, and the job.
        report
            Progress of the job.
        worn
            Returns the stations whose tools are at the end of their lives.
        """
        copies_done = min(row.copies_before + report.copies_done, row.copies)
        copy_done = row.copies_done < copies_done < row.copies
        confirmation, requested = row.confirmation, row.requested_action
        # The action is completed: a resume must not also start the copy after the next.
        late = copy_done or report.phase != row.phase or self._is_late(row)
        if (requested == "hold" and report.held) or (
            requested in _GOES_ON and (late or not report.held)
        ):
            requested = ""
        by_hand = confirmation == Confirmation.GIVEN and not row.feeds
        between = report.held and report.copies_done > 0 and row.lines <= report.line
        if copy_done and (by_hand or (row.feeds and self._needs_person(session, row, worn))):
            confirmation = Confirmation.SHEET
        elif between and row.requested_action == "hold" and confirmation in _CONTINUES:
            # A person is at the machine: the next copy starts with a confirmation only.
            confirmation = Confirmation.SHEET
        elif copy_done and confirmation in _CONTINUES and report.held:
            # The machine feeds the next sheet itself.
            requested = "resume" if row.requested_action in ("", *_GOES_ON) else requested
        changes: dict[str, Any] = {
            "line": min(report.line, row.lines),
            "copies_done": copies_done,
            "phase": report.phase,
            "position": None if report.position is None else list(report.position),
            "seconds_left": report.seconds_left,
            "lease": self._db.clock() + LEASE,
            "confirmation": confirmation,
            "requested_action": requested,
            "awaits_end": report.awaits_end,
            "begun": row.begun or report.begun,
        }
        goal = State.HELD if report.held else State.RUNNING
        event = Message("job.at-line", line=report.line)
        if copy_done:
            needs_sheet = confirmation == Confirmation.SHEET
            event = Message(
                "job.copy-done-next-sheet" if needs_sheet else "job.copy-done",
                copy=copies_done,
                copies=row.copies,
            )
        gateway, events = Actor(ActorKind.GATEWAY, row.owner), []
        if goal != row.state:
            self._claimed.move(session, row, goal, event, **changes)
        else:
            self._claimed.change(session, row, changes)
            events += [event] if copy_done else []
        if copy_done and row.feeds and confirmation != Confirmation.SHEET:
            events.append(event_of_feed())
        for one in events:
            self._transitions.write_job_event(session, row.id, goal, gateway, one, row.machine)
        unconfirmed = confirmation == Confirmation.AWAITED or (
            confirmation == Confirmation.SHEET and not report.held
        )
        if unconfirmed and requested != "cancel":
            return "hold"
        return requested or "continue"
