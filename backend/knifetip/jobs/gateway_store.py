"""Repository operations for gateways: claim a job, report its progress, report its end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.errors import MachineBusy
from knifetip.jobs.batches import (
    WornStations,
    begins_batch,
    no_worn_stations,
    uses_worn_tool,
)
from knifetip.jobs.database import Database, rows
from knifetip.jobs.interruption import interruption
from knifetip.jobs.job import (
    CLOCK,
    LEASED,
    Action,
    Actor,
    ActorKind,
    Confirmation,
    State,
    action_between,
)
from knifetip.jobs.left_sheet import unfinished_sheet
from knifetip.jobs.machine_queues import CLAIMED, MachineQueues, lock_queue, next_queued
from knifetip.jobs.machine_runs import end_run
from knifetip.jobs.tables import Job
from knifetip.jobs.transitions import LEASE, Transitions, stale_epoch_error
from knifetip.messages import Message

#: Confirmations with which a machine that feeds its sheets itself begins the next copy.
_CONTINUES = (Confirmation.NONE, Confirmation.GIVEN)


@dataclass(frozen=True, slots=True)
class GatewayReport:
    """Progress of a job, as its gateway reports it in a heartbeat."""

    line: int  #: executed lines of the current copy
    copies_done: int = 0  #: copies completed since this claim
    held: bool = False
    waiting: bool = False  #: nothing was sent to the machine; the gateway waits for ``start``
    position: Sequence[float] | None = None
    seconds_left: float | None = None
    #: Number of the phase of the run since the claim.  A new phase begins when the machine goes on
    #: after a hold, and when the gateway itself begins to wait for the operator: for a new sheet,
    #: for the confirmation of the end, or because its lease has expired.  A request to resume
    #: counts only in the phase in which the operator made it.
    phase: int = 0


@dataclass(frozen=True, slots=True)
class StopPlace:
    """Place at which a machine stopped a job, as its gateway reports it."""

    position: Sequence[float] | None = None  #: on the sheet: x, y, z (mm) and c (degrees)
    station: int | None = None  #: number of the station in use; None if none or unknown


class GatewayStore:
    """Repository operations for gateways on the jobs of their machines."""

    def __init__(
        self, database: Database, transitions: Transitions, machines: MachineQueues
    ) -> None:
        self._db = database
        self._transitions = transitions
        self._machines = machines

    def claim(
        self,
        machine: str,
        gateway: str,
        *,
        manual: bool,
        feeds: bool = False,
        worn: WornStations = no_worn_stations,
    ) -> Job | None:
        """Assign the next queued job of a machine to a gateway, and return the job.

        Returns None if there is no job to assign.  Each claim gives the job a new epoch: a number
        that the gateway sends with all its reports.

        Parameters
        ----------
        machine
            Name of the machine.
        gateway
            Name of the gateway of the machine.
        manual
            Whether the operator must confirm that the sheet is on the table.  If True, the job
            stays ``queued``, and the gateway sends nothing to the machine until ``heartbeat``
            returns ``start``.  If the gateway claims again before that, it gets the same job with a
            new epoch, and the operator must confirm again.  If False, the job is stored as
            ``running`` before this method returns, unless it continues another job: the operator
            must confirm such a job on every machine.
        feeds
            Whether the machine feeds its sheets itself.  The operator must then confirm the first
            sheet of each batch (see ``batches``), a job with a worn tool, and a job before which an
            unfinished sheet may lie on the table.
        worn
            Returns the stations whose tools are at the end of their lives.

        Raises
        ------
        MachineBusy
            Another job is on the table of this machine, or another gateway has claimed a job of
            this machine and waits for the operator's confirmation.
        """
        waiting = sa.select(Job).where(Job.machine == machine, CLAIMED)
        with self._db.reading() as session:
            if not session.scalar(sa.select(waiting.exists() | next_queued(machine).exists())):
                return None
        try:
            with self._db.writing() as session:
                lock_queue(session, machine)
                row = session.scalar(waiting.with_for_update())
                if row is not None and row.owner != gateway:
                    if row.lease >= self._db.clock():
                        raise _busy_error(machine, row.id)
                    self.give_back(session, row, CLOCK, silent_gateway_message(row.owner))
                    row = None
                if row is None:
                    following = next_queued(machine).execution_options(populate_existing=True)
                    row = session.scalar(following.with_for_update())
                if row is None:
                    return None
                id = row.id
                # A begun sheet may have been moved, and a broken tool must have been replaced.
                confirm = manual or row.resumes is not None
                confirm = confirm or (
                    feeds
                    and (
                        begins_batch(session, row)
                        or uses_worn_tool(row, worn)
                        or unfinished_sheet(session, row) != ""
                    )
                )
                self._assign(session, row, gateway, confirm, feeds)
                return self._transitions.lock(session, id)
        except IntegrityError as reason:
            raise _busy_error(machine, self._machines.jobs_on_tables().get(machine, "")) from reason

    def begins_batch(self, row: Job) -> bool:
        """Return whether the next sheet of a job is the first one of a batch (see ``batches``)."""
        with self._db.reading() as session:
            return begins_batch(session, row)

    def unfinished_sheet(self, row: Job) -> str:
        """Return the job whose unfinished sheet may lie on the table before another job starts.

        The result is "" if there is none (see ``left_sheet``).
        """
        with self._db.reading() as session:
            return unfinished_sheet(session, row)

    def _assign(self, session: Session, row: Job, gateway: str, confirm: bool, feeds: bool) -> None:
        changes: dict[str, Any] = {
            "epoch": row.epoch + 1,
            "owner": gateway,
            "owner_epoch": row.epoch + 1,
            "lease": self._db.clock() + LEASE,
            "requested_action": "",
            "line": 0,
            "position": None,
            "copies_before": row.copies_done,
            "phase": 0,
            "feeds": feeds,
            "stopped_at": None,
        }
        if confirm:
            changes |= {"confirmation": Confirmation.AWAITED.value, "updated": self._db.clock()}
            self._change(session, row, changes)
            event = Message("job.claimed-to-confirm")
            self._transitions.write_event(
                session, "job", row.id, State.QUEUED, Actor(ActorKind.GATEWAY, gateway), event
            )
            return
        changes |= {"confirmation": Confirmation.NONE.value}
        self._transitions.move(
            session,
            row.id,
            Action.START,
            Actor(ActorKind.GATEWAY, gateway),
            Message("job.claimed"),
            epoch=row.epoch,
            new_epoch=changes.pop("epoch"),
            **changes,
        )

    def heartbeat(
        self,
        id: str,
        epoch: int,
        report: GatewayReport,
        worn: WornStations = no_worn_stations,
    ) -> str:
        """Store the progress of a job, renew its lease, and return a command for the gateway.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the gateway's claim: a number that increases with each new owner of the job.
        report
            Progress of the job, as the gateway reports it.
        worn
            Returns the stations whose tools are at the end of their lives.  It is called when a
            machine that feeds its sheets itself has completed a copy.

        Returns
        -------
        str
            ``wait``, ``start`` or ``cancel`` if the gateway waits for the operator's confirmation;
            otherwise ``continue``, ``hold``, ``resume`` or ``cancel``.  Before ``start`` is
            returned, the job is stored as ``running``.

        Raises
        ------
        StaleEpoch
            The gateway no longer owns the job and must stop the machine.
        """
        with self._db.writing(urgent=True) as session:
            row = self._transitions.lock(session, id)
            if row.epoch != epoch or not (row.state in LEASED or is_claimed(row)):
                raise stale_epoch_error(id, row.state, row.epoch, epoch)
            if report.waiting:
                return self._answer_waiting(session, row)
            if row.state == State.QUEUED:
                row = self._start(session, row)
            return self._answer_running(session, row, report, worn)

    def _answer_waiting(self, session: Session, row: Job) -> str:
        """Return the command for a gateway that has not sent anything to the machine yet.

        The command is one of the following; each answer also renews the lease of the job:

        - ``cancel`` if the operator has cancelled the job;
        - ``wait`` if the operator has not confirmed the job yet;
        - ``wait`` if the operator has confirmed the job but requested a hold; the job is stored as
          ``held`` until the operator resumes it;
        - ``start`` otherwise; the job is stored as ``running``.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The job that the gateway has claimed.
        """
        renewed: dict[str, Any] = {"lease": self._db.clock() + LEASE}
        if row.requested_action == "cancel":
            self._change(session, row, renewed)
            return "cancel"
        if row.confirmation == Confirmation.AWAITED:
            self._change(session, row, renewed)
            return "wait"
        # If the job is already running, the answer with ``start`` was lost.
        starts = row.requested_action == "resume" or (
            row.state != State.HELD and row.requested_action != "hold"
        )
        goal = State.RUNNING if starts else State.HELD
        renewed["requested_action"] = ""
        if row.state == State.QUEUED:
            self._start(session, row, **renewed)
        elif row.state != goal:
            event = Message("job.started" if starts else "job.held-before-start")
            self._gateway_moves(session, row, goal, event, **renewed)
        else:
            self._change(session, row, renewed)
        return "start" if starts else "wait"

    def _start(self, session: Session, row: Job, **changes: Any) -> Job:
        """Move a claimed job to ``running`` and return it.

        This method is called after the operator's confirmation, or if the gateway reports that it
        has already begun to send the program.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The job.
        """
        confirmed = row.confirmation == Confirmation.GIVEN
        event = Message("job.started" if confirmed else "job.started-unconfirmed")
        self._gateway_moves(session, row, State.RUNNING, event, **changes)
        return self._transitions.lock(session, row.id)

    def _gateway_moves(
        self, session: Session, row: Job, goal: State, event: Message, **changes: Any
    ) -> None:
        self._transitions.move(
            session,
            row.id,
            action_between(State(row.state), goal),
            Actor(ActorKind.GATEWAY, row.owner),
            event,
            epoch=row.epoch,
            **changes,
        )

    def _answer_running(
        self, session: Session, row: Job, report: GatewayReport, worn: WornStations
    ) -> str:
        """Store the report of a gateway on its running job, and return the command for the gateway.

        The command is the first of the following that applies:

        - ``cancel`` if the operator has requested a cancel;
        - ``hold`` if the operator must first confirm the job, or if the machine is not held
          although the operator must confirm the next sheet;
        - ``hold`` or ``resume`` if this action is requested and the machine has not carried it out;
        - ``continue`` in all other cases.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The job.
        report
            Progress of the job.
        worn
            Returns the stations whose tools are at the end of their lives.
        """
        copies_done = min(row.copies_before + report.copies_done, row.copies)
        copy_done = row.copies_done < copies_done < row.copies
        confirmation, requested = row.confirmation, row.requested_action
        # The action is completed: a resume must not also start the copy after the next, or confirm
        # the end of the program.
        if requested == ("hold" if report.held else "resume") or (
            requested == "resume" and (copy_done or report.phase != row.phase)
        ):
            requested = ""
        by_hand = confirmation == Confirmation.GIVEN and not row.feeds
        if copy_done and (by_hand or (row.feeds and uses_worn_tool(row, worn))):
            confirmation = Confirmation.SHEET
        elif copy_done and confirmation in _CONTINUES and report.held:
            # The machine feeds the next sheet itself, unless the operator has requested a hold.
            requested = "resume" if row.requested_action in ("", "resume") else requested
        changes: dict[str, Any] = {
            "line": min(report.line, row.lines),
            "copies_done": copies_done,
            "phase": report.phase,
            "position": None if report.position is None else list(report.position),
            "seconds_left": report.seconds_left,
            "lease": self._db.clock() + LEASE,
            "confirmation": confirmation,
            "requested_action": requested,
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
        if goal != row.state:
            self._gateway_moves(session, row, goal, event, **changes)
        else:
            self._change(session, row, changes)
            if copy_done:
                self._transitions.write_event(
                    session, "job", row.id, goal, Actor(ActorKind.GATEWAY, row.owner), event
                )
        unconfirmed = confirmation == Confirmation.AWAITED or (
            confirmation == Confirmation.SHEET and not report.held
        )
        if unconfirmed and requested != "cancel":
            return "hold"
        return requested or "continue"

    def finish(
        self,
        id: str,
        epoch: int,
        outcome: str,
        cause: Message | None = None,
        *,
        line: int | None = None,
        copies_done: int | None = None,
        place: StopPlace | None = None,
    ) -> Job:
        """Store a gateway's report that a job has ended, and return the job.

        A repeated report has no effect.  The last owner may also report after its lease has expired
        and the job has become ``interrupted``.  The outcome ``done`` then moves the job to
        ``done``; any other outcome only updates the stored progress and the message of the job.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the gateway's claim: a number that increases with each new owner of the job.
        outcome
            ``done``, ``interrupted`` or ``cancelled``; ``returned`` puts the job back into the
            queue, if the gateway has sent nothing to the machine.
        cause
            Cause that the gateway reports; None if it reports none.
        line
            Number of program lines of the current copy that were executed; None for the number in
            the last heartbeat.
        copies_done
            Number of copies completed since the gateway claimed the job; None for the number in the
            last heartbeat.
        place
            Place at which the machine stopped; None for the position in the last heartbeat.

        Raises
        ------
        StaleEpoch
            The gateway no longer owns the job.
        """
        returned = outcome == "returned"
        goal = State.INTERRUPTED if returned else State(outcome)
        with self._db.writing(urgent=True) as session:
            row = self._transitions.lock(session, id)
            repeated = row.state == goal and goal is not State.INTERRUPTED
            if repeated and epoch in (row.epoch, row.owner_epoch):
                return row
            late = row.state == State.INTERRUPTED and epoch == row.owner_epoch
            owned = row.epoch == epoch and (row.state in LEASED or is_claimed(row))
            if not (late or owned):
                raise stale_epoch_error(id, row.state, row.epoch, epoch)
            if returned and row.state == State.QUEUED:
                owner = Actor(ActorKind.GATEWAY, row.owner)
                self.give_back(session, row, owner, cause or Message("job.nothing-sent"))
                return self._transitions.lock(session, id)
            if row.state == State.QUEUED:
                row = self._start(session, row)
            if goal is State.CANCELLED and late:
                goal = State.INTERRUPTED
            done = None if copies_done is None else row.copies_before + copies_done
            self._end(session, row, goal, cause, line, done, place or StopPlace(row.position))
            return self._transitions.lock(session, id)

    def _end(
        self,
        session: Session,
        row: Job,
        goal: State,
        cause: Message | None,
        line: int | None,
        copies_done: int | None,
        place: StopPlace,
    ) -> None:
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
            ended["message"] = None
            if late:
                event = Message("job.late-report", report=event)
        elif goal is State.INTERRUPTED:
            stop = interruption(row, cause or Message("gateway.no-reason"), line, copies_done)
            event = stop.message
            ended |= {"message": event, "line": stop.line, "copies_done": stop.copies_done}
            ended |= stopped(stop.line, place)
            if late:
                if event != row.message:
                    self._change(session, row, ended)
                    end_run(session, row.id, self._db.clock())
                    owner = Actor(ActorKind.GATEWAY, row.owner)
                    report = Message("job.late-report", report=event)
                    self._transitions.write_event(session, "job", row.id, goal, owner, report)
                return
        else:
            ended["line"] = row.line if line is None else min(line, row.lines)
            ended |= stopped(ended["line"], place)
        self._gateway_moves(session, row, goal, event, **ended)

    def give_back(self, session: Session, row: Job, actor: Actor, cause: Message) -> None:
        """Put a claimed job that was never started back into the queue, at its former position.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The job.
        actor
            Person or process that returns the job, for the log of events.
        cause
            Reason for the return, for the log of events.
        """
        self._change(
            session,
            row,
            {
                "epoch": row.epoch + 1,
                "owner": "",
                "lease": 0.0,
                "requested_action": "",
                "confirmation": Confirmation.NONE.value,
                "updated": self._db.clock(),
            },
        )
        event = Message("job.claim-returned", reason=cause)
        self._transitions.write_event(session, "job", row.id, State.QUEUED, actor, event)

    def _change(self, session: Session, row: Job, changes: dict[str, Any]) -> None:
        """Set columns of a job that the transaction of the caller has locked.

        Parameters
        ----------
        session
            Session with the transaction of the caller.
        row
            The locked job.
        changes
            New values of columns, by name of the column.
        """
        statement = sa.update(Job).where(Job.id == row.id, Job.epoch == row.epoch)
        statement = statement.execution_options(synchronize_session=False)
        if not rows(session, statement.values(**changes)):
            raise stale_epoch_error(row.id, row.state, row.epoch + 1, row.epoch)


def stopped(line: int, place: StopPlace) -> dict[str, Any]:
    """Return the columns of a job that record where the machine stopped it.

    Parameters
    ----------
    line
        Number of executed lines of the present copy.
    place
        Position and station.
    """
    position = None if place.position is None else list(place.position)
    where = {"line": line, "position": position, "station": place.station}
    return {"stopped_at": where, "position": position}


def silent_gateway_message(gateway: str) -> Message:
    """Return the message which states that a gateway has stopped responding.

    Parameters
    ----------
    gateway
        Name of the gateway.
    """
    return Message("job.gateway-fell-silent", gateway=gateway)


def is_claimed(row: Job) -> bool:
    """Return whether a gateway has claimed a job and the job is not started yet."""
    return row.state == State.QUEUED and row.confirmation != Confirmation.NONE


def _busy_error(machine: str, job: str) -> MachineBusy:
    if job:
        return MachineBusy("machine.busy", job=job, machine=machine)
    return MachineBusy("machine.busy-with-another", machine=machine)
