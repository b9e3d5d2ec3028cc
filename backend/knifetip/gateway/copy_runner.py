"""copy_runner: makes the copies of a claimed job on the machine, one after another.

The progress of each copy goes into its ``JobRun``, which the heartbeats report, and into the
journal.  The requests of the server are carried out, as described in ``claim``.
"""

from __future__ import annotations

import asyncio
from contextlib import aclosing, suppress
from functools import partial

from knifetip import tracing
from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerReset,
)
from knifetip.gateway.controller import Controller, OverridingController, State
from knifetip.gateway.copy_events import CopyEvents
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.job_run import JobReturned, JobRun
from knifetip.gateway.job_server import GatewaySettings, JobServer
from knifetip.gateway.journal import Journal
from knifetip.gateway.machine_link import MachineLink
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.open_loop import OpenLoop
from knifetip.gateway.operations import OperableController
from knifetip.gateway.station import MachineStation
from knifetip.gateway.stream import Progress, StreamHooks, stream
from knifetip.gateway.takeover import Recalls
from knifetip.messages import Message
from knifetip.model.machine import Station
from knifetip.tracing import SpanKind

#: Failures of a controller that it has reported itself, so that it was observed until it stopped.
_OBSERVED = (ControllerAlarm, ControllerOccupied, ControllerRejected, ControllerReset)


class CopyRunner:
    """Makes the copies of jobs on one machine.

    Parameters
    ----------
    settings
        Settings of the gateway.
    link
        Connection to the controller of the machine.
    server
        Server from which programs are fetched.
    journal
        Journal of the gateway.
    station
        Station of the machine, which reports it between two copies.
    """

    def __init__(
        self,
        settings: GatewaySettings,
        link: MachineLink,
        server: JobServer,
        journal: Journal,
        station: MachineStation,
    ) -> None:
        self._machine = settings.machine
        self._beat = settings.beat
        self._link = link
        self._server = server
        self._journal = journal
        self._station = station

    async def run(self, run: JobRun) -> None:
        """Fetch the program of a claimed job, and make its copies.

        Raises
        ------
        JobWithdrawn
            The server withdrew the job.
        JobCancelled
            The operator cancelled the job.
        JobReturned
            The server did not answer before the first line.
        GatewayRefused
            The server refuses the key of this gateway.
        KnifetipError, OSError
            The program cannot be fetched, or the machine or its connection has failed.  The flag
            ``run.begun`` states whether a line may have been executed.
        """
        claim = run.claim
        with tracing.span("fetch program", SpanKind.CLIENT):
            text = await self._server.program(claim)
        lines = text.count(b"\n")
        self._journal.begin(claim.job, claim.epoch, claim.sha256, lines, claim.copies)
        for copy in range(claim.copies):
            if copy:
                with tracing.span("wait for sheet"):
                    await self._wait_for_sheet(run)
            run.line, run.copy_running = 0, True
            await self._run_copy(run, text, copy)
            self._journal.record_copy(claim.job, copy + 1)
            run.copy_running = run.awaits_end = False
            if copy + 1 < claim.copies:
                await self._station.report_now()
            run.copies_done, run.line, run.seconds_left = copy + 1, lines, 0.0

    async def _run_copy(self, run: JobRun, text: bytes, copy: int) -> None:
        async with self._link.in_use:
            with tracing.span("copy", copy=copy + 1, lines=text.count(b"\n")) as span:
                await self._stream_copy(run, text, copy, CopyEvents(span))

    async def _stream_copy(self, run: JobRun, text: bytes, copy: int, events: CopyEvents) -> None:
        controller = await self._link.connected()
        if copy == 0 and isinstance(controller, OverridingController):
            # A person has chosen the override for another job.
            await controller.override_feed(100)
        updates = stream(
            text,
            controller,
            limits=Limits.from_machine(self._machine),
            tools=tool_offsets(self._machine),
            check=copy == 0,
            interval=min(self._beat / 2.0, 0.1),
            time_left=run.time_left,
            hooks=StreamHooks(
                partial(self._begin, run, copy),
                partial(self._journal.record_sending, run.claim.job, copy),
            ),
        )
        progress: Progress | None = None
        base, program, observed = controller.sent, "", True
        run.line_at_most = None
        try:
            async with aclosing(updates) as progress_updates:
                async for progress in progress_updates:
                    if isinstance(controller, Recalls) and controller.program_name != program:
                        program = controller.program_name
                        self._journal.program(run.claim.job, program)
                    self._record(run, progress, copy)
                    events.update(progress)
                    if progress.awaits_end:
                        self._server.raise_if_refused(run)
                    if progress.executed < progress.lines:
                        # After the last line there is nothing left to stop or to hold.
                        run.raise_if_withdrawn()
                        self._server.raise_if_refused(run)
                        await self._apply_requests(run, progress, controller)
        except ControllerError as error:
            observed = isinstance(error, _OBSERVED)
            raise
        finally:
            self._link.abandoned = controller.fault is not None
            if controller.fault is not None and run.output >= 0:
                self._link.left_on = frozenset({run.output})
            run.output = -1
            run.begun = run.begun or controller.sent > base
            # A controller that was not observed to its stop may have executed all that it got.
            run.line_at_most = max(run.line, 0 if observed else controller.sent - base)
            if progress is not None:
                self._record_stop(run, progress, controller)

    async def _begin(self, run: JobRun, copy: int) -> None:
        """Record that the first line of a copy is sent next, on the server and in the journal.

        Without these records the server, when the lease expires, and the next gateway return the
        job to the queue.

        Raises ``JobWithdrawn, JobCancelled, GatewayRefused, OSError``: as for ``run``.
        Raises ``JobReturned``: the server did not answer within the lease.
        """
        run.begins = True
        while copy == 0:
            run.raise_if_withdrawn()
            self._server.raise_if_refused(run)
            left = run.lease_end - _now()
            if left < 0.0:
                raise JobReturned(Message("gateway.server-silent-before-start"))
            if run.begin_stored:
                break
            run.answered.clear()
            with suppress(TimeoutError):
                # Not ``wait_for``, which loses a cancellation at the moment of an answer.
                async with asyncio.timeout(left + 0.01):
                    await run.answered.wait()
        self._journal.begin_copy(run.claim.job, copy)

    def _record_stop(self, run: JobRun, last: Progress, controller: Controller) -> None:
        """Record the position at which the machine came to rest.

        Z is that of the last progress report, because the tool has been lifted since.

        ``run``: state of the job; changed in place.
        ``last``: last progress report.
        """
        status = controller.last_status if isinstance(controller, OperableController) else None
        if status is not None and status.located and controller.fault is None:
            x, y, _, c = status.position
            run.position = self._head((x, y, last.position[2], c), last.output)

    def _record(self, run: JobRun, progress: Progress, copy: int) -> None:
        if progress.awaits_end and not run.awaits_end:
            run.begin_phase()
        run.awaits_end = progress.awaits_end
        run.line = progress.executed
        run.held = progress.held
        run.seconds_left = progress.seconds_left
        if progress.located:
            run.position = self._head(progress.position, progress.output)
        run.output = progress.output
        station = self._station_of(progress.output)
        run.station = None if station is None else station.number
        self._journal.line(run.claim.job, copy, progress.executed, progress.acknowledged)

    async def _apply_requests(
        self, run: JobRun, progress: Progress, controller: Controller
    ) -> None:
        """Hold the machine, or let it continue, as the server has requested for the job.

        The machine also holds if the lease of the job has expired.

        ``run``: state of the job, with the request of the server.  The request is deleted from
        ``run`` as soon as a status report shows that the controller has carried it out.
        ``progress``: progress of the machine, with the state of the controller.
        """
        if _now() > run.lease_end and progress.state is State.RUN:
            run.begin_phase()
            await controller.hold()
        elif run.requested == "hold":
            if progress.state is State.RUN:
                await controller.hold()
            elif progress.held:
                run.requested = ""
        elif run.requested == "end":
            if progress.awaits_end and isinstance(controller, OpenLoop):
                controller.confirm_end()
            else:
                run.begin_phase()
        elif run.requested == "resume":
            if progress.resumable and not progress.awaits_end:
                await controller.resume()
            else:
                # While the door is open, a request to resume is dropped: otherwise closing the door
                # would start the machine.
                run.begin_phase()

    async def _wait_for_sheet(self, run: JobRun) -> None:
        """Wait until the operator has laid the sheet for the next copy and resumed the job.

        During the wait, the heartbeats report the job as held.

        Raises ``JobWithdrawn``: the server withdrew the job.
        Raises ``JobCancelled``: the operator cancelled the job.
        Raises ``GatewayRefused``: the server refuses the key of this gateway.
        """
        run.begin_phase()
        run.held, run.requested, run.between_copies = True, "", True
        run.seconds_left = run.time_left.expected
        try:
            while run.requested != "resume":
                run.answered.clear()
                await run.answered.wait()
                run.raise_if_withdrawn()
                self._server.raise_if_refused(run)
        finally:
            run.between_copies = False
        run.begin_phase()
        run.held = False

    def _head(self, axes: Pose, output: int) -> Pose:
        """Return the position of the head on the sheet, as heartbeats report it.

        It is the position of the axes, x, y, z (mm) and c (degrees), minus the tool offset (datum)
        of the station in use.  If no station is in use, nothing is subtracted.

        ``output``: digital output that is switched on, which identifies the station in use; -1 for
        none.
        """
        return self._machine.sheet_pose(axes, self._station_of(output))

    def _station_of(self, output: int) -> Station | None:
        """Return the station that a digital output lowers; None if there is none."""
        stations = self._machine.stations if output >= 0 else ()
        return next((one for one in stations if one.output == output), None)


def _now() -> float:
    return asyncio.get_running_loop().time()
