"""Repository of the stations of machines: what gateways report, and what persons ask for.

The gateway of a machine reports the state of its controller.  A person at the machine asks for
operations, such as unlocking the controller.  The gateway fetches each operation once.  An
operation that is not fetched within ``EXPIRY`` seconds expires: it is never executed late.
"""

from __future__ import annotations

import secrets
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sqlalchemy as sa

from knifetip.contract.job import LEASED, ON_TABLE, Confirmation, State
from knifetip.contract.operations import (
    BETWEEN_COPIES,
    DURING_JOBS,
    EXPIRY,
    HANDS_CLEAR,
    JOG_RENEWAL,
    RUNS,
    OperationName,
    needs_clear_hands,
)
from knifetip.contract.station_report import UNREPORTED
from knifetip.errors import NotFound, WrongState
from knifetip.messages import Message
from knifetip.service.database.change_notifier import ALL, machine_topic
from knifetip.service.database.engine import Database, note_change, short
from knifetip.service.database.tables import Job, Operation, Station
from knifetip.service.lifecycle.machine_queues import CLAIMED
from knifetip.service.machines.station_obstacles import (
    SILENCE,
    end_hands_clear,
    locked_station,
    require_hands_clear,
)

#: Seconds for which a machine counts as watched after a person has looked at it.
WATCHED = 12.0
#: Seconds after the last operation of a person before a job may start without a confirmation.
OPERATED = 30.0
_KEPT = 600.0  # seconds for which operations are kept
_WATCH_INTERVAL = 4.0  # least time between two records that a person looks (s)
_REPORT_INTERVAL = 1.0  # least time between two records of unchanged reports (s)


@dataclass(frozen=True, slots=True)
class StationReport:
    """State of a controller, as the gateway of its machine reports it."""

    gateway: str  #: name of the gateway
    connected: bool  #: whether the controller is connected
    state: str  #: of the controller; "" if it is not connected
    alarm: Message | None = None
    position: Sequence[float] | None = None
    outputs: Sequence[int] = ()  #: outputs that are on
    operations: Sequence[str] = ()  #: operations that the controller can do
    activity: Mapping[str, Any] | None = None  #: last run above the board
    spindle: int | None = None  #: station whose spindle was switched on by hand
    #: why the controller is not connected, or harmless differences of its settings
    notices: Sequence[Message] = ()
    obstacle: Message | None = None  #: why it takes no job; None if it is free
    override: int | None = None  #: feed override (%); None if the controller has none
    outputs_known: bool = True  #: all other outputs are off


@dataclass(frozen=True, slots=True)
class OperationResult:
    """Result of an operation, as the gateway reports it."""

    id: str
    state: str  #: done, refused or expired
    message: Message | None = None


@dataclass(frozen=True, slots=True)
class RequestedOperation:
    """An operation that is handed to a gateway, with its age."""

    id: str
    age: float  #: time since the person asked for it (s)
    request: Mapping[str, Any]  #: name and arguments


@dataclass(frozen=True, slots=True)
class HeldJog:
    """A jog whose button a person holds."""

    id: str  #: of the operation
    age: float  #: time since the person last stated it (s)


@dataclass(frozen=True, slots=True)
class StationView:
    """State of a station as persons see it: the last report, and the job on the machine."""

    row: Station
    age: float | None  #: time since the last report (s); None if there was none
    job: str  #: job on the machine; "" for none
    watched: bool  #: whether a person has looked in the last ``WATCHED`` seconds

    @property
    def alive(self) -> bool:
        """Whether the gateway has reported in the last ``SILENCE`` seconds."""
        return self.age is not None and self.age <= SILENCE


class StationStore:
    """Repository of the stations of machines and of the operations of persons at them."""

    def __init__(self, database: Database) -> None:
        self._db = database

    # -- for gateways ---------------------------------------------------------------------------

    def report(
        self, machine: str, report: StationReport, results: Sequence[OperationResult] = ()
    ) -> None:
        """Store the report of a gateway on its machine, and results of operations.

        A report that is equal to the stored one is not stored again within ``_REPORT_INTERVAL``.

        Parameters
        ----------
        machine
            Name of the machine.
        report
            State of its controller.
        results
            Results of operations that were handed to the gateway.
        """
        now = self._db.timer()
        columns: dict[str, Any] = {
            "gateway": report.gateway,
            "connected": report.connected,
            "state": report.state,
            "alarm": report.alarm,
            "position": None if report.position is None else list(report.position),
            "outputs": list(report.outputs),
            "outputs_known": report.outputs_known,
            "operations": list(report.operations),
            "spindle": report.spindle,
            "activity": None if report.activity is None else dict(report.activity),
            "notices": list(report.notices),
            "obstacle": report.obstacle,
            "override": report.override,
        }
        with self._db.reading() as session:
            row = session.get(Station, machine)
        changed = row is None or any(getattr(row, name) != new for name, new in columns.items())
        recent = row is not None and 0.0 <= now - row.reported < _REPORT_INTERVAL
        if not changed and recent and not results:
            return
        with self._db.writing(urgent=True) as session:
            stored = locked_station(session, machine)
            for name, value in columns.items():
                setattr(stored, name, value)
            stored.reported = now
            for result in results:
                session.execute(
                    sa.update(Operation)
                    .where(
                        Operation.id == result.id,
                        Operation.machine == machine,
                        Operation.state == "waiting",
                    )
                    .values(state=result.state, message=result.message)
                )
            if results:
                note_change(session, ALL)

    def hand_out(self, machine: str) -> list[RequestedOperation]:
        """Return the operations that wait for a machine, oldest first, and mark them as handed out.

        Operations that are older than ``EXPIRY`` expire instead.
        """
        waiting = sa.select(Operation).where(
            Operation.machine == machine,
            Operation.state == "waiting",
            Operation.handed.is_(None),
        )
        with self._db.reading() as session:
            if not session.scalar(sa.select(waiting.exists())):
                return []
        with self._db.writing(urgent=True) as session:
            now = self._db.timer()
            found = []
            for row in session.scalars(waiting.order_by(Operation.serial).with_for_update()):
                # A negative age: the computer was started again since.
                if 0.0 <= (age := now - row.asked) < EXPIRY:
                    row.handed = now
                    found.append(RequestedOperation(row.id, age, row.request))
                else:
                    _expire(row)
            return found

    def held_jog(self, machine: str) -> HeldJog | None:
        """Return the jog of a machine whose button a person holds now; None if there is none."""
        now = self._db.timer()
        held = (
            sa.select(Operation.id, Operation.renewed)
            .where(Operation.machine == machine, Operation.renewed > now - JOG_RENEWAL)
            .order_by(Operation.serial.desc())
            .limit(1)
        )
        with self._db.reading() as session:
            found = session.execute(held).first()
        if found is None or not (age := now - found.renewed) >= 0.0:
            return None
        return HeldJog(found.id, age)

    # -- for persons ----------------------------------------------------------------------------

    def get(self, machine: str) -> StationView:
        """Return the state of a station, and record that a person looks at it."""
        now = self._db.timer()
        with self._db.reading() as session:
            row = session.get(Station, machine)
            job = session.scalar(_job_on(machine)) or ""
        if row is None or not 0.0 <= now - row.watched < _WATCH_INTERVAL:
            with self._db.writing() as session:
                row = locked_station(session, machine)
                row.watched = now
        return self._view(row, job, now)

    def all(self) -> list[StationView]:
        """Return the states of all stations that a gateway has reported or a person watches."""
        now = self._db.timer()
        with self._db.reading() as session:
            rows = list(session.scalars(sa.select(Station).order_by(Station.machine)))
            jobs = {row.machine: session.scalar(_job_on(row.machine)) or "" for row in rows}
        return [self._view(row, jobs[row.machine], now) for row in rows]

    def views(self, machines: Collection[str]) -> dict[str, StationView]:
        """Return the states of the stations of some machines, by name, without their jobs."""
        now = self._db.timer()
        with self._db.reading() as session:
            rows = session.scalars(sa.select(Station).where(Station.machine.in_(machines)))
            return {row.machine: self._view(row, "", now) for row in rows}

    def is_watched(self, machine: str) -> bool:
        """Return whether a person has looked at a station in the last ``WATCHED`` seconds."""
        with self._db.reading() as session:
            row = session.get(Station, machine)
        return row is not None and self._view(row, "", self._db.timer()).watched

    def state_hands_clear(self, machine: str) -> float:
        """Store that hands are clear of a machine; return for how long the statement counts (s)."""
        with self._db.writing(urgent=True) as session:
            locked_station(session, machine).hands_clear = self._db.timer()
        return HANDS_CLEAR

    def withdraw_hands_clear(self, machine: str) -> None:
        """End the statement that hands are clear of a machine, if there is one."""
        with self._db.writing(urgent=True) as session:
            end_hands_clear(session, machine)

    def ask(
        self, machine: str, request: Mapping[str, Any], *, hands_clear: bool = False
    ) -> Operation:
        """Store an operation that a person at a machine asks for, and return it.

        Parameters
        ----------
        machine
            Name of the machine.
        request
            Name of the operation (``operation``) and its arguments.
        hands_clear
            Whether the person states with the request that hands are clear of the machine.

        Raises
        ------
        WrongState
            A job is running or held on the machine and the operation is none of a running job, its
            gateway or its controller is not connected,
            or its controller cannot do the operation; it moves the machine, and nobody has stated
            within ``HANDS_CLEAR`` seconds that hands are clear; or it is a run above the board, and
            no job waits for its operator.
        """
        now = self._db.timer()
        with self._db.writing(urgent=True) as session:
            view = self._view(locked_station(session, machine), "", now)
            running = session.execute(
                sa.select(Job.id, Job.state, Job.confirmation).where(
                    Job.machine == machine, Job.state.in_(LEASED)
                )
            ).first()
            name = str(request["operation"])
            waits = running is not None and running.confirmation == Confirmation.SHEET
            allowed = name in DURING_JOBS or (waits and name in BETWEEN_COPIES)
            if running is not None and not allowed:
                raise WrongState(
                    "operation.job-running", job=running.id, state=running.state, machine=machine
                )
            if not view.alive:
                raise WrongState("operation.gateway-absent", machine=machine)
            if not view.row.connected:
                raise WrongState("operation.no-controller", machine=machine)
            if view.row.state == UNREPORTED:
                raise WrongState("operation.unreported", machine=machine, request=name)
            if name not in view.row.operations:
                raise WrongState("operation.unsupported", name=machine, request=name)
            if needs_clear_hands(name, bool(request.get("on"))):
                require_hands_clear(session, machine, name, now, stated=hands_clear)
            if name in RUNS and session.scalar(_waiting_job(machine)) is None:
                raise WrongState("dry-run.no-job")
            session.execute(
                sa.delete(Operation).where(
                    Operation.machine == machine,
                    sa.or_(Operation.asked < now - _KEPT, Operation.asked > now),
                )
            )
            row = Operation(
                id=secrets.token_hex(8),
                machine=machine,
                request=dict(request),
                state="waiting",
                asked=now,
                renewed=now if name == OperationName.JOG else None,
            )
            session.add(row)
            view.row.watched = now
            note_change(session, machine_topic(machine))
        return row

    def renew(self, machine: str, id: str) -> Operation:
        """Store that a person still holds the button of a jog, and return the operation.

        Raises
        ------
        NotFound
            The machine has no operation with this id, or it was removed after some minutes.
        WrongState
            The operation is no jog, or was refused, or the last statement is older than
            ``JOG_RENEWAL`` seconds, so that the jog was stopped.
        """
        with self._db.writing(urgent=True) as session:
            query = sa.select(Operation).where(Operation.id == id, Operation.machine == machine)
            row = session.scalar(query.with_for_update())
            if row is None:
                raise NotFound("operation.unknown", id=short(id), machine=machine)
            now = self._db.timer()
            held = row.renewed is not None and 0.0 <= now - row.renewed < JOG_RENEWAL
            if not held or row.state not in ("waiting", "done"):
                raise WrongState("operation.jog-ended", id=short(id), seconds=JOG_RENEWAL)
            row.renewed = now
            note_change(session, machine_topic(machine))
            return row

    def waiting_job(self, machine: str) -> Job | None:
        """Return the job of a machine that waits for its operator; None if there is none."""
        with self._db.reading() as session:
            return session.scalar(_waiting_job(machine))

    def was_operated(self, machine: str) -> bool:
        """Return whether a person has asked for an operation in the last ``OPERATED`` seconds."""
        now = self._db.timer()
        asked = sa.select(Operation).where(
            Operation.machine == machine, Operation.asked > now - OPERATED, Operation.asked <= now
        )
        with self._db.reading() as session:
            return bool(session.scalar(sa.select(asked.exists())))

    def operation(self, machine: str, id: str) -> Operation:
        """Return an operation with its state; an operation that was not fetched in time expires.

        Raises
        ------
        NotFound
            The machine has no operation with this id, or it was removed after some minutes.
        """
        query = sa.select(Operation).where(Operation.id == id, Operation.machine == machine)
        with self._db.reading() as session:
            row = session.scalar(query)
            station = session.get(Station, machine)
        if row is None:
            raise NotFound("operation.unknown", id=short(id), machine=machine)
        if row.state != "waiting":
            return row
        now = self._db.timer()
        late = row.handed is None and not 0.0 <= now - row.asked < EXPIRY
        silent = station is None or not self._view(station, "", now).alive
        lost = row.handed is not None and silent
        if not (late or lost):
            return row
        with self._db.writing(urgent=True) as session:
            row = session.scalars(query.with_for_update()).one()
            if row.state == "waiting" and late and row.handed is None:
                _expire(row)
            elif row.state == "waiting" and lost:
                row.state, row.message = "expired", Message("operation.no-result")
            return row

    def _view(self, row: Station, job: str, now: float) -> StationView:
        age = now - row.reported
        watched = 0.0 <= now - row.watched < WATCHED
        return StationView(row, age if row.gateway and age >= 0.0 else None, job, watched)


def _job_on(machine: str) -> sa.Select[str]:
    """Return a query for the job that is on the table of a machine, or claimed for it."""
    return sa.select(Job.id).where(Job.machine == machine, sa.or_(Job.state.in_(ON_TABLE), CLAIMED))


def _waiting_job(machine: str) -> sa.Select[Job]:
    """Return a query for the job that a gateway has claimed and that waits for its operator."""
    return sa.select(Job).where(
        Job.machine == machine,
        Job.state == State.QUEUED,
        Job.confirmation == Confirmation.AWAITED,
        Job.requested_action != "cancel",
    )


def _expire(row: Operation) -> None:
    row.state, row.message = "expired", Message("operation.expired", seconds=EXPIRY)
