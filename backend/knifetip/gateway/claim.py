"""claim: claim jobs from the server, run them on the machine, and report their end.

A job makes one or more copies of a program, each on a new sheet of board.  The gateway only makes
outgoing connections.  It decides the following by itself:

- It claims jobs only while the controller is connected and idle: a machine that is switched off
  gets no job.
- If the operator must confirm a job, the gateway sends nothing to the machine before the server has
  answered a heartbeat with ``start``.  Until then the controller must stay idle; otherwise the job
  is returned to the queue, and the operator must confirm again.
- If the server cannot be reached, the machine continues until the lease expires.  Then the gateway
  stops the machine with a hold.  The machine does not continue by itself: either the operator
  resumes the job, or the server answers that the job was reassigned (409), and the machine is then
  brought into its safe state.
- The answer ``resume`` to a heartbeat also starts the next copy, and confirms the end of a program
  whose controller does not report it.  The gateway ignores ``resume`` if this heartbeat did not
  report a held machine in the present phase of the run (``JobRun.begin_phase``).  Otherwise a late
  answer, meant for an earlier hold, could start the next copy before its sheet is on the table.
- The end of a job is recorded in the journal and reported until the server has answered.  After a
  restart, a job whose end is not recorded is reported as ``done`` only if the journal records that
  every copy was executed to its last line.
- After an alarm the connection is kept: the person at the machine can unlock or home it (see
  ``station``), and the gateway then claims jobs again.
- If no controller can ever be reached at the address, the gateway ends; if the controller only
  does not answer, the gateway tries again.
- If the server refuses the key of the gateway, the gateway ends: between two jobs at once, and
  with a job when its lease has expired.  The machine then does not stay held, because nobody could
  resume the job; it is brought into its safe state, and the end of the job stays in the journal
  until a gateway with a valid key reports it.
- A controller that still runs a job of this gateway after a restart or a lost connection is first
  stopped and brought into its safe state.
"""

from __future__ import annotations

import asyncio
import logging
import time
from contextlib import aclosing, suppress

import httpx

from knifetip import logs, tracing
from knifetip.errors import ControllerError, GatewayRefused, KnifetipError, NoSuchController
from knifetip.gateway.controller import Controller, SafeState, State
from knifetip.gateway.copy_events import CopyEvents
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.job_run import (
    JobCancelled,
    JobEnd,
    JobReturned,
    JobRun,
    JobWithdrawn,
    Lease,
)
from knifetip.gateway.job_server import FIRST_PAUSE, LONGEST_PAUSE, GatewaySettings, JobServer
from knifetip.gateway.journal import Journal
from knifetip.gateway.machine_link import Connect, MachineLink
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.operations import OperableController
from knifetip.gateway.station import MachineStation
from knifetip.gateway.stream import Progress, stream
from knifetip.messages import Message
from knifetip.model.machine import Station
from knifetip.tracing import SpanKind

_log = logging.getLogger(__name__)


def _cause_of(error: KnifetipError | OSError) -> Message:
    """Return the message that the gateway reports as the cause of the end of a job.

    Parameters
    ----------
    error
        Exception that ended the job.  For an ``OSError``, the result is a message that quotes the
        exception; otherwise it is the message that the exception contains.
    """
    if isinstance(error, KnifetipError):
        return error.message
    return Message("gateway.system-error", reason=error)


def _trace_end(outcome: str, cause: Message | None) -> None:
    """Record in the current span how a job ended."""
    span = tracing.current()
    span.set(outcome=outcome)
    if cause is not None:
        span.set(error=cause.code)
    if outcome == "interrupted":
        span.fail()


class _GatewayLoop:
    """Claims the jobs of one machine from the server and runs them, one after another."""

    def __init__(
        self, settings: GatewaySettings, link: MachineLink, server: JobServer, journal: Journal
    ) -> None:
        self._settings = settings
        self._link = link
        self._server = server
        self._journal = journal
        self._complaint = ""

    # -- the loop ------------------------------------------------------------------------------

    async def run(self, jobs: int | None) -> None:
        """Claim and run the jobs of the machine, one after another.

        Parameters
        ----------
        jobs
            Number of jobs to claim; the method returns when the last one has ended with any
            outcome.  None to run until cancelled.
        """
        await asyncio.gather(self._report_unfinished(), self._recover())
        while jobs is None or jobs > 0:
            await self._wait_until_idle()
            claim = await self._server.claim()
            if claim is not None:
                about = tracing.Attributes(
                    job=claim.job, machine=self._settings.machine.name, copies=claim.copies
                )
                with (
                    logs.about(job=claim.job),
                    tracing.span("run", SpanKind.CONSUMER, claim.traceparent, **about),
                ):
                    await self._run_job(claim)
                if jobs is not None:
                    jobs -= 1

    async def _report_unfinished(self) -> None:
        """Report the end of the job that ran when the gateway was last switched off, if any.

        The report is repeated until the server answers.
        """
        if (unfinished := self._journal.unfinished()) is None:
            return
        outcome, cause = unfinished.outcome, unfinished.cause
        if not outcome and unfinished.copies_done >= unfinished.copies:
            outcome, cause = "done", Message("gateway.switched-off-before-report")
        elif not outcome:
            outcome, cause = "interrupted", Message("gateway.switched-off")
        end = JobEnd(
            unfinished.job,
            unfinished.epoch,
            outcome,
            cause,
            unfinished.line,
            unfinished.copies_done,
        )
        # ``_wait_until_idle`` raises it again, when a machine that may still move was stopped.
        with suppress(GatewayRefused):
            await self._server.finish(end)

    async def _recover(self) -> None:
        """Stop the machine if it may still execute a job or a dry run of the journal.

        If the gateway was killed meanwhile, the machine may still execute it or be held in it.  The
        method connects to the controller, which stops the machine.  If the controller cannot be
        reached, a warning is logged, and the machine is stopped when the gateway next connects.
        """
        if self._journal.unfinished() is None and not self._journal.is_abandoned():
            return
        self._link.abandoned = True
        try:
            await self._link.connected()
        except (ControllerError, OSError) as error:
            self._raise_if_hopeless(error)
            self._complaint = str(error)
            _log.warning("%s", error)

    def _raise_if_hopeless(self, error: Exception) -> None:
        """Raise an error again if it shows that the address of the controller is wrong.

        A controller that was reached is waited for, whatever answers at its address now.
        """
        if isinstance(error, NoSuchController) and not self._link.reached:
            raise error

    async def _wait_until_idle(self) -> None:
        """Wait until the controller is connected and idle; connect to it if necessary.

        Raises
        ------
        NoSuchController
            The address of the controller is wrong.
        GatewayRefused
            The server refuses the key of this gateway.
        """
        pause = FIRST_PAUSE
        while True:
            if self._server.refusal is not None and not self._link.abandoned:
                raise self._server.refusal
            try:
                status = await self._link.status()
                if status.state is State.IDLE:
                    self._complaint = ""
                    # Only now: a gateway that is killed while it stops the machine leaves it held.
                    self._journal.rest()
                    return
                complaint = str(self._not_idle(status.state))
            except (ControllerError, OSError) as error:
                self._raise_if_hopeless(error)
                complaint = str(error)
            if complaint != self._complaint:
                self._complaint = complaint
                _log.warning("%s", complaint)
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, LONGEST_PAUSE)

    # -- one job --------------------------------------------------------------------------------

    def _not_idle(self, state: State) -> Message:
        controller = self._link.controller
        name = self._settings.machine.title if controller is None else controller.name
        return Message("gateway.controller-not-idle", name=name, state=state.value)

    async def _run_job(self, claim: Lease) -> None:
        run = self._link.run = JobRun(claim, self._now())
        heartbeats = asyncio.create_task(self._server.send_heartbeats(run), name="heartbeats")
        begun = time.monotonic()
        outcome: str = "interrupted"
        cause: Message | None = None
        try:
            try:
                if run.waiting:
                    with tracing.span("wait for confirmation"):
                        await self._wait_for_confirmation(run)
                await self._run_copies(run)
                outcome = "done"
            except JobReturned as returned:
                outcome, cause = "returned", returned.cause
            except JobCancelled:
                outcome, cause = "cancelled", Message("gateway.cancelled", line=run.line)
            except JobWithdrawn:
                # The server may still record this report, as evidence of where the machine stopped.
                cause = Message(
                    "gateway.job-withdrawn-before-start" if run.waiting else "gateway.job-withdrawn"
                )
                _log.warning("Job %s: %s", claim.job, cause)
            except (KnifetipError, OSError) as error:
                cause = _cause_of(error)
            except asyncio.CancelledError:
                if run.waiting:
                    outcome, cause = "returned", Message("gateway.switched-off")
                else:
                    cause = Message("gateway.switched-off-in-run")
                with suppress(asyncio.CancelledError, GatewayRefused):
                    await self._server.finish(JobEnd.of(run, outcome, cause), tries=1)
                raise
        finally:
            _trace_end(outcome, cause)
            self._settings.observe(outcome, time.monotonic() - begun)
            self._link.run = None
            heartbeats.cancel()
            await asyncio.gather(heartbeats, return_exceptions=True)
        await self._server.finish(JobEnd.of(run, outcome, cause))
        _log.info("the run ended: %s", outcome)

    async def _wait_for_confirmation(self, run: JobRun) -> None:
        """Wait until the operator has confirmed the job; return at once if that is not necessary.

        During the wait a person may use the machine, for example jog it.

        Raises
        ------
        JobReturned
            The controller is not idle or cannot be reached, or the server refuses the key of this
            gateway, so the job must return to the queue.
        JobWithdrawn
            The server withdrew the job.
        JobCancelled
            The operator cancelled the job.
        """
        while run.waiting:
            run.answered.clear()
            await run.answered.wait()
            run.raise_if_withdrawn()
            if (refusal := self._refusal_of(run)) is not None:
                raise JobReturned(refusal.message)
            if not run.is_waiting and self._link.runs_dry:
                # The dry run stops by itself; the job must not start right behind it.
                raise JobReturned(Message("gateway.started-in-dry-run"))
            if run.waiting and self._link.in_use.locked():
                continue  # a person at the machine uses it
            try:
                state = (await self._link.status()).state
            except (ControllerError, OSError) as error:
                raise JobReturned(_cause_of(error)) from error
            if run.waiting and state is State.JOG and self._link.jogged:
                continue
            if state is not State.IDLE:
                raise JobReturned(self._not_idle(state))

    async def _run_copies(self, run: JobRun) -> None:
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
            self._journal.copy(claim.job, copy + 1)
            run.copies_done, run.line, run.seconds_left = copy + 1, lines, 0.0
            run.copy_running = False

    async def _run_copy(self, run: JobRun, text: bytes, copy: int) -> None:
        async with self._link.in_use:
            with tracing.span("copy", copy=copy + 1, lines=text.count(b"\n")) as span:
                await self._stream_copy(run, text, copy, CopyEvents(span))

    async def _stream_copy(self, run: JobRun, text: bytes, copy: int, events: CopyEvents) -> None:
        controller = await self._link.connected()
        updates = stream(
            text,
            controller,
            limits=Limits.of(self._settings.machine),
            tools=tool_offsets(self._settings.machine),
            check=copy == 0,
            interval=min(self._settings.beat / 2.0, 0.1),
        )
        progress: Progress | None = None
        try:
            async with aclosing(updates) as progress_updates:
                async for progress in progress_updates:
                    self._record(run, progress, copy)
                    events.update(progress)
                    if progress.awaits_end:
                        self._raise_if_refused(run)
                    if progress.executed < progress.lines:
                        # After the last line there is nothing left to stop or to hold.
                        run.raise_if_withdrawn()
                        self._raise_if_refused(run)
                        await self._apply_requests(run, progress, controller)
        finally:
            self._link.abandoned = controller.fault is not None
            run.output = -1
            if progress is not None:
                self._record_stop(run, progress, controller)

    def _record_stop(self, run: JobRun, last: Progress, controller: Controller) -> None:
        """Record the position at which the machine came to rest.

        Z is that of the last progress report, because the tool has been lifted since.

        Parameters
        ----------
        run
            State of the job; changed in place.
        last
            Last progress report.
        controller
            Controller of the machine.
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
        station = self._station(progress.output)
        run.station = None if station is None else station.number
        self._journal.line(run.claim.job, copy, progress.executed, progress.acknowledged)

    async def _apply_requests(
        self, run: JobRun, progress: Progress, controller: Controller
    ) -> None:
        """Hold the machine, or let it continue, as the server has requested for the job.

        The machine also holds if the lease of the job has expired.

        Parameters
        ----------
        run
            State of the job, with the request of the server.  The request is deleted from ``run``
            as soon as a status report shows that the controller has carried it out.
        progress
            Progress of the machine, with the state of the controller.
        controller
            Controller of the machine.
        """
        if self._now() > run.lease_end and progress.state is State.RUN:
            run.begin_phase()
            await controller.hold()
        elif run.requested == "hold":
            if progress.state is State.RUN:
                await controller.hold()
            elif progress.held:
                run.requested = ""
        elif run.requested == "resume":
            if progress.resumable:
                await controller.resume()
            else:
                # While the door is open, a request to resume is dropped: otherwise closing the door
                # would start the machine.
                run.begin_phase()

    def _refusal_of(self, run: JobRun) -> GatewayRefused | None:
        """Return why the server refuses this gateway, if it does so since the lease has expired."""
        return self._server.refusal if self._now() > run.lease_end else None

    def _raise_if_refused(self, run: JobRun) -> None:
        """Raise ``GatewayRefused`` if the server refuses the key and so no operator can act."""
        if (refusal := self._refusal_of(run)) is not None:
            raise refusal

    async def _wait_for_sheet(self, run: JobRun) -> None:
        """Wait until the operator has laid the sheet for the next copy and resumed the job.

        During the wait, the heartbeats report the job as held.

        Raises
        ------
        JobWithdrawn
            The server withdrew the job.
        JobCancelled
            The operator cancelled the job.
        GatewayRefused
            The server refuses the key of this gateway.
        """
        run.begin_phase()
        run.held, run.requested = True, ""
        while run.requested != "resume":
            run.answered.clear()
            await run.answered.wait()
            run.raise_if_withdrawn()
            self._raise_if_refused(run)
        run.begin_phase()
        run.held = False

    def _head(self, axes: Pose, output: int) -> Pose:
        """Return the position of the head on the sheet, as heartbeats report it.

        It is the position of the axes, x, y, z (mm) and c (degrees), minus the tool offset (datum)
        of the station in use.  If no station is in use, nothing is subtracted.

        Parameters
        ----------
        axes
            Position of the axes.
        output
            Digital output that is switched on, which identifies the station in use; -1 for none.
        """
        x, y, z, c = axes
        station = self._station(output)
        if station is None:
            return axes
        return x - station.x, y - station.y, z - station.z, c - station.c

    def _station(self, output: int) -> Station | None:
        """Return the station that a digital output lowers; None if there is none."""
        stations = self._settings.machine.stations if output >= 0 else ()
        return next((one for one in stations if one.output == output), None)

    def _now(self) -> float:
        return asyncio.get_running_loop().time()


async def run_gateway(
    settings: GatewaySettings,
    connect: Connect,
    *,
    client: httpx.AsyncClient | None = None,
    jobs: int | None = None,
) -> None:
    """Run the gateway of a machine until it is cancelled, or until ``jobs`` jobs have ended.

    Cancellation stops the machine, raises the tool and reports the end of the job to the server.

    Parameters
    ----------
    settings
        Settings of the gateway: its server, its machine, its name and its time limits.
    connect
        Function that connects to the controller, brings the machine into its safe state, and
        returns the controller.  It is called at the start and after every failure.  Its first
        argument is the safe state of the machine; its second argument is True if a machine that
        still moves must be stopped.
    client
        HTTP client to use; it is not closed.  None to create a client.
    jobs
        Number of jobs to claim; the function returns when the last one has ended.  None for no
        limit.

    Raises
    ------
    NoSuchController
        The address of the controller is wrong, and was so from the start.
    StaleVersion
        The server has a newer version of the machine.  No job is on the machine.
    GatewayRefused
        The server refuses the key of this gateway.  The machine is in its safe state, if it can be
        reached.
    """
    http = httpx.AsyncClient() if client is None else client
    http.headers.update({"X-Knifetip": "gateway", **settings.headers})
    journal = Journal(settings.journal)
    server = JobServer(http, settings, journal)
    link = MachineLink(SafeState.of(settings.machine), connect)
    station = asyncio.create_task(
        MachineStation(link, server, settings.machine, journal).run(),
        name="station of the machine",
    )
    try:
        try:
            await _GatewayLoop(settings, link, server, journal).run(jobs)
        finally:
            station.cancel()
            await asyncio.gather(station, return_exceptions=True)
    except GatewayRefused:
        # The page can no longer stop operations that it has started, such as a jog or a spindle.
        await link.release()
        raise
    finally:
        await link.close()
        if client is None:
            await http.aclose()
