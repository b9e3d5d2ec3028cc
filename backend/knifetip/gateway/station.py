"""station: reports the machine to the server, and executes operations of the person at it.

The reports go on while a job runs, and while the controller is locked by an alarm.  The server
answers a report with the operations that a person has asked for:

- An operation is refused while a job runs or is held.
- An operation that is older than ``operations.EXPIRY`` before it is sent to the controller is
  dropped.  Its age at the server travels as a duration; the gateway adds the time since then by its
  own monotonic clock.
- Operations are executed one after another, except ``stop_jog``: it does not wait, and cancels
  the operations that do.
- A jog moves only while the person holds its button.  The page states it again and again, and the
  server passes that on with its answers; without it the jog is stopped (``held_jogs``).
- Without an answer of the server for ``operations.EXPIRY`` a running jog or dry run is stopped,
  and a spindle that was switched on by hand is switched off, because the person can no
  longer do it.
- A dry run uses the machine until it ends (``dry_run``).  Its operation is done when it begins;
  meanwhile all operations are refused, except to hold, to resume and to stop it.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import httpx

from knifetip.contract.operations import (
    BETWEEN_COPIES,
    DURING_JOBS,
    EXPIRY,
    OF_RUNS,
    RUNS,
    Operation,
    OperationName,
)
from knifetip.contract.station_report import (
    UNREPORTED,
    OperationRequest,
    OperationResult,
    StationAnswer,
    StationReport,
)
from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    GatewayRefused,
    KnifetipError,
    OperationExpired,
)
from knifetip.gateway.controller import ConfiguredController, State, Status
from knifetip.gateway.dry_programs import DryPrograms
from knifetip.gateway.dry_run import DryRun
from knifetip.gateway.held_jogs import HeldJogs
from knifetip.gateway.job_run import JobRun
from knifetip.gateway.job_server import JobServer
from knifetip.gateway.journal import Journal
from knifetip.gateway.machine_link import MachineLink
from knifetip.gateway.obstacle import notice_of, obstacle_in_job, obstacle_of
from knifetip.gateway.open_loop import OpenLoop
from knifetip.gateway.operations import OperableController, override_feed, perform, require_possible
from knifetip.gateway.tool_check import CheckedPoint, ToolCheck
from knifetip.messages import Message
from knifetip.model.machine import Machine

#: Time between two reports while a page shows the machine (s).
WATCHED_INTERVAL = 0.3
#: Time between two reports while no page shows the machine (s).
IDLE_INTERVAL = 3.0
#: Pause after a report that the server did not answer (s).
_PAUSE = 1.0
#: Longest time by which a report of the machine delays the report of the end of a job (s).
_NOW = 1.0
#: Why a report is not stored: the server is silent, refuses it, or answers something else.
_REFUSED = (httpx.HTTPError, GatewayRefused, ValueError, KeyError, TypeError)

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class _PendingOperation:
    """An operation with the time at which it expires, by the clock of the event loop."""

    request: OperationRequest
    expires: float


class MachineStation:
    """Reports the state of one machine, and executes the operations of the person at it.

    Parameters
    ----------
    link
        Connection to the controller of the machine.
    server
        Server to which the station reports.
    machine
        The machine.
    journal
        Journal of the gateway, in which dry runs are recorded.
    """

    def __init__(
        self, link: MachineLink, server: JobServer, machine: Machine, journal: Journal
    ) -> None:
        self._link = link
        self._server = server
        self._machine = machine
        self._journal = journal
        self._programs = DryPrograms(server, machine)
        self._results: list[OperationResult] = []
        self._tasks: set[asyncio.Task[None]] = set()
        self._homing = False  # an operation homes the machine
        self._cancelled = 0  # number of stops; an operation that was asked before a stop is dropped
        self._answered = 0.0  # time of the last answer of the server
        self._wake = asyncio.Event()  # an operation has ended
        self._jogs = HeldJogs(link)
        self._reporting: set[asyncio.Task[None]] = set()  # at once, besides those of ``run``
        link.on_change = self._report_soon

    async def run(self) -> None:
        """Report and execute operations until cancelled."""
        interval, complaint = WATCHED_INTERVAL, ""
        self._answered = _now()
        try:
            while True:
                results, self._results = self._results, []
                self._wake.clear()
                asked = _now()
                try:
                    answer = await self._server.report_station(
                        self.report(), results, 0.0 if self._tasks else interval
                    )
                except _REFUSED as error:
                    self._results = results + self._results
                    if (reason := repr(error)) != complaint:
                        complaint = reason
                        _log.warning("the server takes no report on the machine: %s", reason)
                    await self._stop_unwatched()
                    await asyncio.sleep(_PAUSE)
                    continue
                complaint = ""
                self._accept(answer, asked)
                interval = WATCHED_INTERVAL if answer.watched else IDLE_INTERVAL
                if self._tasks:
                    with suppress(TimeoutError):
                        # Not ``wait_for``, which loses a cancellation at the moment of a report.
                        async with asyncio.timeout(WATCHED_INTERVAL):
                            await self._wake.wait()
                elif answer.waited < interval and not answer.operations:
                    await asyncio.sleep(interval - answer.waited)
        finally:
            tasks = [*self._tasks, *self._reporting]
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            await self._jogs.stop_all()

    def _accept(self, answer: StationAnswer, asked: float) -> None:
        """Begin the operations in the answer to a report that was sent at the time ``asked``."""
        self._answered = now = _now()
        # The time on the way, at most: the server has waited for the rest.
        transit = max(now - asked - answer.waited, 0.0)
        for request in answer.operations:
            self._begin(_PendingOperation(request, now + EXPIRY - request.age - transit))
        if answer.held is not None:
            self._jogs.renew(answer.held.id, now - answer.held.age - transit)

    def _report_soon(self) -> None:
        """Report a change of the connection at once: a report of ``run`` may wait for seconds."""
        task = asyncio.create_task(self.report_now(), name="report of the connection")
        self._reporting.add(task)
        task.add_done_callback(self._reporting.discard)

    async def report_now(self) -> None:
        """Request a status of the machine and report it, unless server or controller are silent."""
        controller = self._link.controller
        if controller is not None and controller.fault is None:
            with suppress(ControllerError):
                await controller.status()
        asked = _now()
        with suppress(*_REFUSED, TimeoutError):
            async with asyncio.timeout(_NOW):
                answer = await self._server.report_station(self.report(), [], 0.0)
            self._accept(answer, asked)

    async def _stop_unwatched(self) -> None:
        """Stop what a person has begun if the server has not answered for ``EXPIRY`` seconds."""
        controller = self._link.controller
        if _now() - self._answered < EXPIRY or not isinstance(controller, OperableController):
            return
        if self._link.dry_run is not None and self._link.runs_dry:
            with suppress(KnifetipError, OSError):
                await self._link.dry_run.stop()
            return
        if controller.spinning and not self._link.runs_job and not self._link.in_use.locked():
            with suppress(KnifetipError, OSError):
                async with self._link.in_use:
                    await controller.spin(None)
        status = controller.last_status
        if status is not None and status.state is State.JOG and not self._link.runs_job:
            with suppress(KnifetipError, OSError):
                await controller.stop_jog()

    # -- reports --------------------------------------------------------------------------------

    def report(self) -> StationReport:
        """Return the present state of the machine."""
        controller, run = self._link.controller, self._link.run
        if isinstance(controller, OpenLoop):
            return StationReport(connected=controller.fault is None, state=UNREPORTED)
        if not isinstance(controller, OperableController) or not controller.connected:
            refusal = self._link.refusal
            return StationReport(connected=False, notices=() if refusal is None else (refusal,))
        status = controller.last_status
        state = "" if status is None else _state(status, controller.alarm)
        outputs = controller.switched_on
        if run is not None and self._link.runs_job and run.output >= 0:
            outputs = outputs | {run.output}
        if controller.fault is not None:
            outputs = outputs | self._link.left_on
        return StationReport(
            connected=True,
            # Some controllers report nothing while they home.
            state=State.HOME.value if self._homing else state,
            alarm=None if self._homing else controller.alarm,
            obstacle=None
            if controller.alarm is not None
            else self._obstacle(status, controller.name),
            position=None if status is None or not status.located else status.position,
            outputs=tuple(sorted(outputs)),
            outputs_known=self._link.outputs_known,
            operations=tuple(sorted(controller.operations)),
            override=_override(controller, status),
            spindle=controller.spinning or None,
            activity=None if self._link.dry_run is None else self._link.dry_run.activity,
            notices=_notices(controller, status),
        )

    # -- operations -----------------------------------------------------------------------------

    def _begin(self, pending: _PendingOperation) -> None:
        """Start a task that executes an operation."""
        name = pending.request.operation.name
        if name is OperationName.STOP_JOG:
            self._cancelled += 1
            self._jogs.release_all()
        if name is OperationName.JOG:
            self._jogs.begin(pending.request.id, pending.expires - EXPIRY)
        task = asyncio.create_task(self._carry_out(pending, self._cancelled), name="operation")
        self._tasks.add(task)
        task.add_done_callback(self._end)

    def _end(self, task: asyncio.Task[None]) -> None:
        self._tasks.discard(task)
        self._wake.set()

    async def _carry_out(self, pending: _PendingOperation, stops: int) -> None:
        """Carry out an operation and record its result.

        ``stops``: number of stops that were asked before the operation.
        """
        id, operation = pending.request.id, pending.request.operation

        def is_late() -> bool:
            released = operation.name is OperationName.JOG and self._jogs.is_released(id)
            return released or _now() >= pending.expires or self._cancelled != stops

        try:
            self._refuse_during_job(operation.name)
            if operation.name is OperationName.FEED_OVERRIDE:
                await override_feed(operation, self._link.controller, self._machine, is_late)
            elif operation.name in OF_RUNS and await self._change_run(operation.name):
                pass
            elif self._link.runs_dry:
                raise ControllerError("dry-run.uses-machine")
            elif operation.name is OperationName.STOP_JOG:
                await self._perform(operation, is_late)
            elif operation.name in RUNS:
                await self._run(id, operation, is_late)
                return
            else:
                async with self._link.in_use:
                    self._refuse_during_job(operation.name)
                    # ``unlock``, ``home`` and ``release`` clear it
                    with suppress(ControllerAlarm, ControllerOccupied):
                        await self._link.renew()
                    if operation.name is OperationName.JOG:
                        await self._jog(id, operation, is_late)
                    else:
                        await self._perform(operation, is_late)
                        self._link.record_secured()  # by unlock, home or release
        except OperationExpired as late:
            result = OperationResult(id, "expired", late.message)
        except KnifetipError as refused:
            result = OperationResult(id, "refused", refused.message)
        except OSError as error:
            result = OperationResult(id, "refused", Message("gateway.system-error", reason=error))
        else:
            result = OperationResult(id, "done")
        self._results.append(result)

    async def _jog(self, id: str, operation: Operation, is_late: Callable[[], bool]) -> None:
        """Begin a jog; the rest of it follows while its button is held."""
        self._jogs.send(id)
        controller = self._link.controller
        start = None
        if isinstance(controller, OperableController) and controller.alarm is None:
            start = (await controller.status()).position
        await self._perform(operation, is_late)
        if start is not None:
            self._jogs.accept(id, operation, start)

    async def _perform(self, operation: Operation, is_late: Callable[[], bool]) -> None:
        self._refuse_during_job(operation.name)  # a job may have started during the wait
        controller = self._link.controller
        if not isinstance(controller, OperableController):
            raise ControllerError("operation.no-controller", machine=self._machine.name)
        if operation.name in (OperationName.JOG, OperationName.PARK):
            self._link.jogged = True
        if operation.name is not OperationName.HOME:
            await perform(operation, controller, self._machine, is_late)
            return
        self._homing = True
        try:
            await perform(operation, controller, self._machine, is_late)
        finally:
            self._homing = False

    async def _change_run(self, name: OperationName) -> bool:
        """Hold, resume or stop the dry run; return False if none runs that could be stopped.

        Raises ``ControllerError``: no dry run can be held or resumed, or the controller has failed.
        """
        run = self._link.dry_run
        if run is None or not self._link.runs_dry:
            if name is OperationName.STOP_JOG:
                return False
            raise ControllerError("dry-run.not-running")
        match name:
            case OperationName.HOLD:
                await run.hold()
            case OperationName.RESUME:
                await run.resume()
            case _:
                await run.stop()
        return True

    async def _run(self, id: str, operation: Operation, is_late: Callable[[], bool]) -> None:
        """Carry out an operation that runs a program above the board.

        The result of the operation is recorded when the program begins.

        ``is_late``: returns whether the operation has expired.
        Raises ``OperationExpired``: the operation has expired; nothing was sent.
        Raises ``KnifetipError``: the machine cannot do it now, or the program cannot be run above
        the board.
        """
        async with self._link.in_use:
            self._refuse_during_job(operation.name)
            job, controller = self._link.run, self._link.controller
            if not isinstance(controller, OperableController):
                raise ControllerError("operation.no-controller", machine=self._machine.name)
            if job is None or not job.is_waiting:
                raise ControllerError("dry-run.no-job")
            await require_possible(operation, controller, self._machine)
            run = await self._prepare_run(operation, job, controller)
            if is_late():
                raise OperationExpired("operation.expired", seconds=EXPIRY)
            if self._link.run is not job or not job.is_waiting:
                raise ControllerError("dry-run.no-job")
            # A gateway that is killed during the run may leave the machine held.
            self._journal.dry_run(job.claim.job)
            self._link.dry_run = run
            self._results.append(OperationResult(id, "done"))
            self._wake.set()
            try:
                await run.run(controller)
            finally:
                self._link.abandoned = controller.fault is not None
                if not self._link.abandoned:
                    with suppress(OSError):  # recorded when the machine is next seen idle
                        self._journal.rest()

    async def _prepare_run(
        self, operation: Operation, job: JobRun, controller: OperableController
    ) -> DryRun:
        """Return the run of an operation for the job that waits; nothing is sent."""

        def may_go_on() -> bool:
            return self._link.run is job and job.is_waiting

        id, machine = job.claim.job, self._machine
        if operation.name is OperationName.TOOL_CHECK:
            return ToolCheck(
                id, CheckedPoint.from_operation(operation, machine), machine, may_go_on
            )
        start = (await controller.status()).position
        program = await self._programs.prepare(operation, job.claim, start)
        return DryRun(operation.name.value, id, program, machine, may_go_on)

    def _refuse_during_job(self, name: OperationName) -> None:
        """Raise ``ControllerError`` if a job is on the machine, unless it waits for a sheet or the
        operation is one of a running job.
        """
        free = self._link.is_between_copies and name in BETWEEN_COPIES
        if self._link.runs_job and not free and name not in DURING_JOBS:
            raise ControllerError("operation.job-on-machine")

    def _obstacle(self, status: Status | None, name: str) -> Message | None:
        """Return why the machine takes no job, or why that on it does not move; None if it can."""
        if status is None or self._link.runs_dry or self._homing:
            return None
        in_job = self._link.runs_job and not self._link.is_between_copies
        return (obstacle_in_job if in_job else obstacle_of)(status, name)


def _override(controller: OperableController, status: Status | None) -> int | None:
    """Return the feed override of a controller (%); None if it has none."""
    has_one = OperationName.FEED_OVERRIDE in controller.operations
    return None if status is None or not has_one else status.override


def _notices(controller: OperableController, status: Status | None) -> tuple[Message, ...]:
    """Return the harmless differences of the settings, and what else a person should know."""
    settings = controller.notices if isinstance(controller, ConfiguredController) else ()
    notice = None if status is None else notice_of(status, controller.name)
    return settings if notice is None else (notice, *settings)


def _state(status: Status, alarm: Message | None) -> str:
    """Return the state of a controller; after a critical alarm it sends no report of its state."""
    if alarm is not None:
        return State.ALARM.value
    # With its door closed again the machine is only held.
    closed = status.state is State.DOOR and not status.door_open
    return (State.HOLD if closed else status.state).value


def _now() -> float:
    return asyncio.get_running_loop().time()
