"""Repository operations for gateways: claim a job, report its progress, report its end."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.contract.job import (
    CLOCK,
    ENDED,
    LEASED,
    Action,
    Actor,
    ActorKind,
    Confirmation,
    State,
)
from knifetip.errors import MachineBusy
from knifetip.messages import Message
from knifetip.service.database.acting import acting_owner
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport, Heartbeats
from knifetip.service.lifecycle.machine_queues import (
    CLAIMED,
    MachineQueues,
    lock_queue,
    next_queued,
)
from knifetip.service.lifecycle.transitions import LEASE, Transitions, stale_epoch_error
from knifetip.service.runs.batches import (
    WornStations,
    begins_batch,
    no_worn_stations,
    uses_worn_tool,
)
from knifetip.service.runs.checks import event_of_feed
from knifetip.service.runs.claimed_jobs import (
    ClaimedJobs,
    is_claimed,
    return_event,
    silent_gateway_message,
)
from knifetip.service.runs.ends import JobEnds
from knifetip.service.runs.stop_place import StopPlace
from knifetip.service.runs.unfinished_sheet import unfinished_sheet


class GatewayStore:
    """Repository operations for gateways on the jobs of their machines."""

    def __init__(
        self,
        database: Database,
        transitions: Transitions,
        machines: MachineQueues,
        claimed: ClaimedJobs,
    ) -> None:
        self._db = database
        self._transitions = transitions
        self._machines = machines
        self._claimed = claimed
        self._heartbeats = Heartbeats(database, transitions, claimed)
        self._ends = JobEnds(database, transitions, claimed)

    def claim(
        self,
        machine: str,
        gateway: str,
        *,
        manual: bool,
        feeds: bool = False,
        announces: bool = False,
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
            ``running`` before this method returns, unless it continues another job, or has marks
            of a printed sheet: the operator must confirm such a job on every machine.
        feeds
            Whether the machine feeds its sheets itself.  The operator must then confirm the first
            sheet of each batch (see ``batches``), a job with a worn tool, and a job before which an
            unfinished sheet may lie on the table.
        announces
            Whether the gateway sends no line of the program before a heartbeat with ``begun`` is
            answered.
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
                    self._claimed.give_back(session, row, CLOCK, silent_gateway_message(row.owner))
                    row = None
                if row is None:
                    following = next_queued(machine).execution_options(populate_existing=True)
                    row = session.scalar(following.with_for_update())
                if row is None:
                    return None
                id = row.id
                # A begun sheet may have been moved, and a broken tool must have been replaced.
                confirm = manual or row.resumes is not None
                # The operator measures the marks of a printed sheet.
                confirm = confirm or row.options.registration is not None
                confirm = confirm or (
                    feeds
                    and (
                        begins_batch(session, row)
                        or uses_worn_tool(row, worn)
                        or unfinished_sheet(session, row) != ""
                    )
                )
                claim_columns = {"feeds": feeds, "begun": not announces}
                self._assign(session, row, gateway, confirm, claim_columns)
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

    def _assign(
        self, session: Session, row: Job, gateway: str, confirm: bool, claim_columns: dict[str, Any]
    ) -> None:
        changes: dict[str, Any] = {
            "epoch": row.epoch + 1,
            "owner": gateway,
            "owner_epoch": row.epoch + 1,
            "claimed_by": acting_owner(),
            "lease": self._db.clock() + LEASE,
            "requested_action": "",
            "line": 0,
            "position": None,
            "copies_before": row.copies_done,
            "phase": 0,
            "awaits_end": False,
            "stopped_at": None,
            **claim_columns,
        }
        if confirm:
            changes |= {"confirmation": Confirmation.AWAITED.value, "updated": self._db.clock()}
            self._claimed.change(session, row, changes)
            event = Message("job.claimed-to-confirm")
            claimant = Actor(ActorKind.GATEWAY, gateway)
            self._transitions.write_job_event(
                session, row.id, State.QUEUED, claimant, event, machine=row.machine
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
        if claim_columns["feeds"]:
            self._transitions.write_job_event(
                session,
                row.id,
                State.RUNNING,
                Actor(ActorKind.GATEWAY, gateway),
                event_of_feed(),
                row.machine,
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
                return self._heartbeats.answer_waiting(session, row)
            if row.state == State.QUEUED:
                row = self._claimed.start(session, row)
            return self._heartbeats.answer_running(session, row, report, worn)

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

        A repeated report has no effect.  The last owner may also report after its lease has
        expired.  If the job has become ``interrupted``, the outcome ``done`` then moves it to
        ``done``, and a report that no line was executed returns it to the queue; any other outcome
        only updates the stored progress and the message of the job.  If the job has returned to the
        queue, ``refused`` lets it wait there for an operator.

        Parameters
        ----------
        id
            Id of the job.
        epoch
            Epoch of the gateway's claim: a number that increases with each new owner of the job.
        outcome
            ``done``, ``interrupted`` or ``cancelled``; ``returned`` puts the job back into the
            queue, if no program line was executed.  So does ``refused``: the program was not begun
            for a reason that a person must see, and the job is not claimed again by itself.
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
        returned = outcome in ("returned", "refused")
        goal = State.INTERRUPTED if returned else State(outcome)
        with self._db.writing(urgent=True) as session:
            row = self._transitions.lock(session, id)
            repeated = row.state == goal and goal is not State.INTERRUPTED
            if repeated and epoch in (row.epoch, row.owner_epoch):
                return row
            late = row.state == State.INTERRUPTED and epoch == row.owner_epoch
            owned = row.epoch == epoch and (row.state in LEASED or is_claimed(row))
            refused = outcome == "refused"
            unstated = Message("gateway.no-reason" if refused else "job.nothing-sent")
            if returned and _was_returned(row, epoch):
                if refused:
                    self._correct_refusal(session, row, cause or unstated)
                return self._transitions.lock(session, id)
            if not (late or owned):
                raise stale_epoch_error(id, row.state, row.epoch, epoch)
            executed = max(row.line, line or 0, 0 if place is None else place.at_most or 0)
            unbegun = not (copies_done or executed)
            if returned and unbegun and not (late and _is_continued(session, row)):
                owner = Actor(ActorKind.GATEWAY, row.owner)
                # What was interrupted is not begun again without a person.
                refused = refused or late
                self._claimed.put_back(session, row, owner, cause or unstated, refused=refused)
                return self._transitions.lock(session, id)
            if row.state == State.QUEUED:
                row = self._claimed.start(session, row)
            if goal is State.CANCELLED and late:
                goal = State.INTERRUPTED
            done = None if copies_done is None else row.copies_before + copies_done
            self._ends.store(
                session, row, goal, cause, line, done, place or StopPlace(row.position)
            )
            return self._transitions.lock(session, id)

    def _correct_refusal(self, session: Session, row: Job, cause: Message) -> None:
        """Store the reason why the machine refused a job that has returned to the queue."""
        if cause == row.check_refusal:
            return  # a repeated report
        self._claimed.change(session, row, {"check_refusal": cause, "updated": self._db.clock()})
        # The owner of a job in the queue is not stored.
        self._transitions.write_job_event(
            session,
            row.id,
            State.QUEUED,
            Actor(ActorKind.GATEWAY),
            return_event(cause, refused=True),
            row.machine,
        )


def _was_returned(row: Job, epoch: int) -> bool:
    """Return whether a job has returned to the queue after a claim, and nothing followed."""
    unclaimed = row.state == State.QUEUED and not is_claimed(row)
    return unclaimed and row.owner_epoch == epoch == row.epoch - 1


def _is_continued(session: Session, row: Job) -> bool:
    """Return whether another job that continues a job is under way, and so relies on its sheet."""
    rest = sa.select(Job.id).where(Job.resumes == row.id, Job.state.not_in(ENDED))
    return session.scalar(rest.limit(1)) is not None


def _busy_error(machine: str, job: str) -> MachineBusy:
    if job:
        return MachineBusy("machine.busy", job=job, machine=machine)
    return MachineBusy("machine.busy-with-another", machine=machine)
