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
- The answer ``resume`` to a heartbeat also starts the next copy: between two copies the server
  gives it only after a confirmation.  ``end`` confirms the end of a program whose controller does
  not report it.  The gateway ignores both if this heartbeat did not report a held machine in the
  present phase of the run (``JobRun.begin_phase``).  Otherwise a late answer, meant for an earlier
  hold, could start the next copy before its sheet is on the table.
- A job that fails before a line of its program was sent returns to the queue with the reason
  (``refused``).  It is not claimed again before an operator has asked for it, unless only the
  connection to the controller was lost (``returned``).  The first line is
  sent after the check run, when the server has answered a heartbeat that announces it and the
  journal contains it: then the server, which sees the lease expire, and the gateway that takes over
  know a job of which nothing was executed.
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
  asked how far it is (``takeover``), and then stopped and brought into its safe state.
"""

from __future__ import annotations

import asyncio
import logging
import time
from contextlib import suppress

import httpx

from knifetip import logs, tracing
from knifetip.errors import (
    ConnectionLost,
    ControllerError,
    ControllerReset,
    ControllerSilent,
    GatewayRefused,
    KnifetipError,
    NoSuchController,
)
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.copy_runner import CopyRunner
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
from knifetip.gateway.left_job import end_of
from knifetip.gateway.machine_link import Connect, MachineLink
from knifetip.gateway.obstacle import obstacle_of
from knifetip.gateway.station import MachineStation
from knifetip.messages import Message
from knifetip.tracing import SpanKind

_log = logging.getLogger(__name__)

#: Failures before the first line that say nothing about the job or the machine.
_PASSING = (ConnectionLost, ControllerReset, ControllerSilent)


def _cause_of(error: KnifetipError | OSError) -> Message:
    """Return the message that the gateway reports as the cause of the end of a job.

    ``error``: exception that ended the job.  For an ``OSError``, the result is a message that
    quotes the exception; otherwise it is the message that the exception contains.
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
        self,
        settings: GatewaySettings,
        link: MachineLink,
        server: JobServer,
        journal: Journal,
        station: MachineStation,
    ) -> None:
        self._settings = settings
        self._station = station
        self._link = link
        self._server = server
        self._journal = journal
        self._complaint = ""
        self._copies = CopyRunner(settings, link, server, journal, station)

    # -- the loop ------------------------------------------------------------------------------

    async def run(self, jobs: int | None) -> None:
        """Claim and run the jobs of the machine, one after another.

        ``jobs``: number of jobs to claim; the method returns when the last one has ended with any
        outcome.  None to run until cancelled.
        """
        await self._take_over()
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

    async def _take_over(self) -> None:
        """Stop the machine if it may still work, and report the job that ran last, if any.

        The report is repeated until the server answers.
        """
        unfinished = self._journal.unfinished()
        await self._recover()
        if unfinished is None:
            return
        # ``_wait_until_idle`` raises it again, when a machine that may still move was stopped.
        with suppress(GatewayRefused):
            end = await end_of(
                unfinished, self._link.controller, self._server, self._settings.machine
            )
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

        Raises ``NoSuchController``: the address of the controller is wrong.
        Raises ``GatewayRefused``: the server refuses the key of this gateway.
        """
        pause = FIRST_PAUSE
        while True:
            if self._server.refusal is not None and not self._link.abandoned:
                raise self._server.refusal
            try:
                status = await self._link.status()
                if (obstacle := self._obstacle(status)) is None:
                    await self._link.verify_settings()
                    self._complaint = ""
                    # Only now: a gateway that is killed while it stops the machine leaves it held.
                    self._journal.rest()
                    return
                complaint = str(obstacle)
            except (ControllerError, OSError) as error:
                self._raise_if_hopeless(error)
                complaint = str(error)
            if complaint != self._complaint:
                self._complaint = complaint
                _log.warning("%s", complaint)
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, LONGEST_PAUSE)

    # -- one job --------------------------------------------------------------------------------

    def _obstacle(self, status: Status) -> Message | None:
        """Return why the machine takes no job now; None if it is free."""
        controller = self._link.controller
        name = self._settings.machine.title if controller is None else controller.name
        obstacle = obstacle_of(status, name)
        if obstacle is None and status.state is not State.IDLE:
            return Message("gateway.controller-not-idle", name=name, state=status.state.value)
        return obstacle

    async def _run_job(self, claim: Lease) -> None:
        run = self._link.run = JobRun(claim, asyncio.get_running_loop().time())
        heartbeats = asyncio.create_task(self._server.send_heartbeats(run), name="heartbeats")
        begun = time.monotonic()
        outcome: str = "interrupted"
        cause: Message | None = None
        try:
            try:
                if run.waiting:
                    with tracing.span("wait for confirmation"):
                        await self._wait_for_confirmation(run)
                await self._copies.run(run)
                outcome = "done"
            except JobReturned as returned:
                outcome, cause = "returned", returned.cause
            except JobCancelled:
                outcome, cause = "cancelled", Message("gateway.cancelled", line=run.line)
            except JobWithdrawn:
                # The server may still record this report, as evidence of where the machine stopped.
                outcome = outcome if run.begun else "returned"
                cause = Message(
                    "gateway.job-withdrawn" if run.begun else "gateway.job-withdrawn-before-start"
                )
                _log.warning("Job %s: %s", claim.job, cause)
            except (KnifetipError, OSError) as error:
                unbegun = "returned" if isinstance(error, _PASSING) else "refused"
                outcome, cause = outcome if run.begun else unbegun, _cause_of(error)
            except asyncio.CancelledError:
                if not run.begun:
                    outcome, cause = "returned", Message("gateway.switched-off")
                else:
                    cause = Message("gateway.switched-off-in-run")
                with suppress(asyncio.CancelledError, GatewayRefused):
                    await self._server.finish(JobEnd.from_run(run, outcome, cause), tries=1)
                raise
        finally:
            _trace_end(outcome, cause)
            self._settings.observe(outcome, time.monotonic() - begun)
            self._link.run = None
            heartbeats.cancel()
            await asyncio.gather(heartbeats, return_exceptions=True)
        end = JobEnd.from_run(run, outcome, cause)
        self._server.record(end)
        # A person who sees that the job has ended must not see the machine as it was before.
        await self._station.report_now()
        await self._server.finish(end, recorded=True)
        _log.info("the run ended: %s", outcome)

    async def _wait_for_confirmation(self, run: JobRun) -> None:
        """Wait until the operator has confirmed the job; return at once if that is not necessary.

        During the wait a person may use the machine, for example jog it.

        Raises ``JobReturned``: the controller is not idle or cannot be reached, or the server
        refuses the key of this gateway, so the job must return to the queue.
        Raises ``JobWithdrawn``: the server withdrew the job.
        Raises ``JobCancelled``: the operator cancelled the job.
        """
        while run.waiting:
            run.answered.clear()
            await run.answered.wait()
            run.raise_if_withdrawn()
            if (refusal := self._server.refusal_of(run)) is not None:
                raise JobReturned(refusal.message)
            if not run.is_waiting and self._link.runs_dry:
                # The dry run stops by itself; the job must not start right behind it.
                raise JobReturned(Message("gateway.started-in-dry-run"))
            if run.waiting and self._link.in_use.locked():
                continue  # a person at the machine uses it
            try:
                status = await self._link.status()
            except (ControllerError, OSError) as error:
                raise JobReturned(_cause_of(error)) from error
            if run.waiting and status.state is State.JOG and self._link.jogged:
                continue
            if (obstacle := self._obstacle(status)) is not None:
                raise JobReturned(obstacle)


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
    link = MachineLink(SafeState.from_machine(settings.machine), connect)
    station = MachineStation(link, server, settings.machine, journal)
    reports = asyncio.create_task(station.run(), name="station of the machine")
    try:
        try:
            await _GatewayLoop(settings, link, server, journal, station).run(jobs)
        finally:
            reports.cancel()
            await asyncio.gather(reports, return_exceptions=True)
    except GatewayRefused:
        # The page can no longer stop operations that it has started, such as a jog or a spindle.
        await link.release()
        raise
    finally:
        await link.close()
        if client is None:
            await http.aclose()
