"""claim: claim jobs from the server, run them on the machine, and report the result.

    POST {api}/api/gateway/claim      -> a job with epoch, lease, program and its SHA-256
    POST {api}/api/gateway/heartbeat  -> wait, start, continue, hold, resume or cancel
    POST {api}/api/gateway/finish     <- done, interrupted, cancelled or returned

The gateway only makes outgoing connections.  What it decides by itself:

- It claims jobs only while the controller is connected and idle: a table that is switched off gets
  no job.
- For a job that must be confirmed nothing is sent to the machine before the server has answered a
  heartbeat with ``start``.  Meanwhile the controller must stay idle; otherwise the lease is
  returned, and the operator must confirm again.
- If the server cannot be reached, the machine continues until the lease expires, then holds.  It
  does not continue by itself: the operator resumes, or the server answers that the job was
  reassigned (409), and the machine is stopped and brought into its safe state.
- ``resume`` is only valid as the answer to a heartbeat with ``held``, so that a late one cannot
  start the next copy.
- The result of a job is recorded in the journal and reported until the server has answered, also
  after a restart: ``done`` only if the journal contains every copy up to its last line.
- A controller that still runs a job of this gateway after a restart or a lost connection is first
  stopped and brought into its safe state.
"""

from __future__ import annotations

import asyncio
import hashlib
import logging
from collections.abc import Awaitable, Callable, Mapping
from contextlib import aclosing, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urljoin

import httpx

from knifetip.errors import ControllerError, KnifetipError, ProgramError
from knifetip.gateway.controller import Controller, SafeState, State
from knifetip.gateway.journal import Journal
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.stream import Progress, stream
from knifetip.messages import Message, with_text
from knifetip.model.machine import Machine

#: Longest pause between two attempts to connect (s).
LONGEST_PAUSE = 5.0
#: First pause between attempts, doubled each time (s).
FIRST_PAUSE = 0.25

#: Opens a controller; True stops a moving machine, whose program is then ours.
Connect = Callable[[SafeState, bool], Awaitable[Controller]]

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Lease:
    """A claimed job, as the server describes it."""

    job: str
    epoch: int
    lease: float
    program: str
    sha256: str
    copies: int
    confirm: bool  #: the operator must confirm before anything is sent to the machine

    @classmethod
    def of(cls, answer: Mapping[str, Any]) -> Lease:
        return cls(
            str(answer["job"]),
            int(answer["epoch"]),
            float(answer["lease"]),
            str(answer["program"]),
            str(answer["sha256"]),
            int(answer.get("copies", 1)),
            bool(answer.get("confirm", False)),
        )


class _Stale(Exception):
    """The server has reassigned or withdrawn the job."""


class _Cancelled(Exception):
    """The operator cancelled the job."""


class _Returned(Exception):
    """The lease is returned: the machine cannot start, and nothing was sent to it."""

    def __init__(self, cause: Message) -> None:
        super().__init__(cause)
        self.cause = cause


class JobRun:
    """State of a job for heartbeats, and the requests that they return."""

    def __init__(self, claim: Lease, now: float) -> None:
        self.claim = claim
        self.line = 0
        self.copies_done = 0
        self.begun = False  #: a copy is running, of which ``line`` lines are executed
        self.waiting = (
            claim.confirm
        )  #: for the operator's confirmation; nothing is sent to the machine yet
        self.held = False
        self.position: Pose | None = None
        self.seconds_left: float | None = None
        self.requested = ""  #: hold, resume or ""
        self.cancelled = False
        self.stale = False
        self.until = now + claim.lease  #: end of the lease on the local clock
        self.heard = asyncio.Event()

    def heartbeat(self) -> dict[str, object]:
        return {
            "job": self.claim.job,
            "epoch": self.claim.epoch,
            "line": self.line,
            "copies_done": self.copies_done,
            "held": self.held,
            "waiting": self.waiting,
            "position": self.position,
            "seconds_left": self.seconds_left,
        }

    def apply_answer(self, command: str, held: bool) -> None:
        """Apply the answer to a heartbeat that was sent with ``held``."""
        if command == "cancel":
            self.cancelled = True
        elif command == "start":
            self.waiting = False
        elif command == "hold" or (command == "resume" and held):
            self.requested = command
        self.heard.set()

    def raise_if_withdrawn(self) -> None:
        """Raise if the server cancelled the job or reassigned it."""
        if self.stale:
            raise _Stale
        if self.cancelled:
            raise _Cancelled


@dataclass(frozen=True, slots=True)
class JobEnd:
    """The result of a job, as reported to the server."""

    job: str
    epoch: int
    outcome: str
    cause: Message | None
    line: int  #: executed lines of the running copy; 0 between two copies
    copies_done: int  #: under this lease

    @classmethod
    def of(cls, run: JobRun, outcome: str, cause: Message | None) -> JobEnd:
        line = run.line if run.begun or outcome == "done" else 0
        return cls(run.claim.job, run.claim.epoch, outcome, cause, line, run.copies_done)

    def report(self) -> dict[str, object]:
        """Return the body of the request that reports the end."""
        return {
            "job": self.job,
            "epoch": self.epoch,
            "outcome": self.outcome,
            "why": "" if self.cause is None else with_text(self.cause),
            "line": self.line,
            "copies_done": self.copies_done,
        }


def _not_idle(controller: Controller, state: State) -> Message:
    return Message("gateway.controller-not-idle", name=controller.name, state=state.value)


def _cause_of(error: KnifetipError | OSError) -> Message:
    """Return the message of an error that ended a job."""
    if isinstance(error, KnifetipError):
        return error.message
    return Message("gateway.system-error", reason=error)


class _GatewayLoop:
    """Claims and runs the jobs of one machine."""

    def __init__(
        self,
        client: httpx.AsyncClient,
        api: str,
        machine: Machine,
        name: str,
        connect: Connect,
        journal: Journal,
        wait: float,
        beat: float,
    ) -> None:
        self._client = client
        self._api = api.rstrip("/") + "/"
        self._machine = machine
        self._name = name
        self._connect = connect
        self._journal = journal
        self._wait = wait
        self._beat = beat
        self._controller: Controller | None = None
        self._abandoned = False  # the machine may still be running a job of this gateway
        self._complaint = ""

    # -- the loop ------------------------------------------------------------------------------

    async def run(self, jobs: int | None) -> None:
        """Run jobs one after another, without end or ``jobs`` of them."""
        try:
            await asyncio.gather(self._report_unfinished(), self._recover())
            while jobs is None or jobs > 0:
                await self._wait_until_idle()
                claim = await self._claim()
                if claim is not None:
                    await self._run_job(claim)
                    if jobs is not None:
                        jobs -= 1
        finally:
            await self._disconnect()

    async def _report_unfinished(self) -> None:
        """Report a job during which the gateway was switched off, until the server answers."""
        if (left := self._journal.unfinished()) is None:
            return
        outcome, cause = left.outcome, left.cause
        if not outcome and left.copies_done >= left.copies:
            outcome, cause = "done", Message("gateway.switched-off-before-report")
        elif not outcome:
            outcome, cause = "interrupted", Message("gateway.switched-off")
        ended = JobEnd(left.job, left.epoch, outcome, cause, left.line, left.copies_done)
        await self._finish(ended)

    async def _recover(self) -> None:
        """Stop a machine that may still run a job during which the gateway was killed."""
        if self._journal.unfinished() is None:
            return
        self._abandoned = True
        try:
            await self._connected_controller()
        except (ControllerError, OSError) as error:
            self._complaint = str(error)
            _log.warning("%s", error)

    async def _wait_until_idle(self) -> None:
        """Wait until the controller is connected and idle."""
        pause = FIRST_PAUSE
        while True:
            try:
                controller = await self._connected_controller()
                status = await controller.status()
                if status.state is State.IDLE:
                    self._complaint = ""
                    return
                complaint = str(_not_idle(controller, status.state))
            except (ControllerError, OSError) as error:
                complaint = str(error)
            if complaint != self._complaint:
                self._complaint = complaint
                _log.warning("%s", complaint)
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, LONGEST_PAUSE)

    async def _connected_controller(self) -> Controller:
        """Return a controller without a fault; connect if there is none."""
        if self._controller is not None and self._controller.fault is not None:
            await self._disconnect()
        if self._controller is None:
            safe = SafeState.of(self._machine)
            self._controller = await self._connect(safe, self._abandoned)
            self._abandoned = False
        return self._controller

    async def _disconnect(self) -> None:
        controller, self._controller = self._controller, None
        if controller is not None:
            await controller.close()

    # -- one job --------------------------------------------------------------------------------

    async def _run_job(self, claim: Lease) -> None:
        run = JobRun(claim, self._now())
        heartbeats = asyncio.create_task(self._heartbeats(run), name="heartbeats")
        outcome: str = "interrupted"
        cause: Message | None = None
        try:
            try:
                await self._wait_for_confirmation(run)
                await self._run_copies(run)
                outcome = "done"
            except _Returned as returned:
                outcome, cause = "returned", returned.cause
            except _Cancelled:
                outcome, cause = "cancelled", Message("gateway.cancelled", line=run.line)
            except _Stale:
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
                with suppress(asyncio.CancelledError):
                    await self._finish(JobEnd.of(run, outcome, cause), tries=1)
                raise
        finally:
            heartbeats.cancel()
            await asyncio.gather(heartbeats, return_exceptions=True)
        await self._finish(JobEnd.of(run, outcome, cause))

    async def _wait_for_confirmation(self, run: JobRun) -> None:
        """Wait until the operator has confirmed the job; the controller must stay idle."""
        while run.waiting:
            run.heard.clear()
            await run.heard.wait()
            run.raise_if_withdrawn()
            try:
                controller = await self._connected_controller()
                state = (await controller.status()).state
            except (ControllerError, OSError) as error:
                raise _Returned(_cause_of(error)) from error
            if state is not State.IDLE:
                raise _Returned(_not_idle(controller, state))

    async def _run_copies(self, run: JobRun) -> None:
        claim = run.claim
        text = await self._program(claim)
        lines = text.count(b"\n")
        self._journal.begin(claim.job, claim.epoch, claim.sha256, lines, claim.copies)
        for copy in range(claim.copies):
            if copy:
                await self._wait_for_sheet(run)
            run.line, run.begun = 0, True
            await self._run_copy(run, text, copy)
            self._journal.copy(claim.job, copy + 1)
            run.copies_done, run.line, run.seconds_left = copy + 1, lines, 0.0
            run.begun = False

    async def _run_copy(self, run: JobRun, text: bytes, copy: int) -> None:
        controller = await self._connected_controller()
        updates = stream(
            text,
            controller,
            limits=Limits.of(self._machine),
            check=copy == 0,
            interval=min(self._beat / 2.0, 0.1),
        )
        try:
            async with aclosing(updates) as progress_updates:
                async for progress in progress_updates:
                    self._record(run, progress, copy)
                    if progress.executed < progress.lines:
                        # After the last line there is nothing left to stop or to hold.
                        run.raise_if_withdrawn()
                        await self._apply_requests(run, progress, controller)
        finally:
            self._abandoned = controller.fault is not None

    def _record(self, run: JobRun, progress: Progress, copy: int) -> None:
        run.line = progress.executed
        run.held = progress.state is State.HOLD
        run.seconds_left = progress.seconds_left
        run.position = self._head(progress)
        self._journal.line(run.claim.job, copy, progress.executed, progress.acknowledged)

    async def _apply_requests(
        self, run: JobRun, progress: Progress, controller: Controller
    ) -> None:
        """Hold or resume as requested; a request is cleared when the machine has carried it out."""
        if self._now() > run.until and progress.state is State.RUN:
            await controller.hold()
        elif run.requested == "hold":
            if progress.state is State.RUN:
                await controller.hold()
            elif progress.state is State.HOLD:
                run.requested = ""
        elif run.requested == "resume":
            if progress.state is State.HOLD:
                await controller.resume()
            else:
                run.requested = ""

    async def _wait_for_sheet(self, run: JobRun) -> None:
        """Wait in the held state until the operator has loaded a new sheet."""
        run.held, run.requested = True, ""
        while run.requested != "resume":
            run.heard.clear()
            await run.heard.wait()
            run.raise_if_withdrawn()
        run.held, run.requested = False, ""

    def _head(self, progress: Progress) -> Pose:
        """Return the pose of the head on the sheet, without the datum of the station in use."""
        x, y, z, c = progress.position
        for station in self._machine.stations:
            if progress.output >= 0 and station.output == progress.output:
                return x - station.x, y - station.y, z - station.z, c - station.c
        return x, y, z, c

    # -- the server -----------------------------------------------------------------------------

    def _now(self) -> float:
        return asyncio.get_running_loop().time()

    def _url(self, path: str) -> str:
        return urljoin(self._api, path)

    async def _claim(self) -> Lease | None:
        """Ask for work; None when there is none, or nobody to ask."""
        body = {"gateway": self._name, "machine": self._machine.name, "wait": self._wait}
        try:
            answer = await self._client.post(
                self._url("api/gateway/claim"), json=body, timeout=self._wait + 10.0
            )
            if answer.status_code == 204:
                return None
            if answer.status_code == 200:
                return Lease.of(answer.json())
            reason = f"{answer.status_code} {answer.text[:200]}"
        except (httpx.HTTPError, ValueError, KeyError, TypeError) as error:
            reason = repr(error)
        if reason != self._complaint:
            self._complaint = reason
            _log.warning("No work to be had from %s: %s", self._api, reason)
        await asyncio.sleep(min(LONGEST_PAUSE, max(self._wait, FIRST_PAUSE)))
        return None

    async def _program(self, claim: Lease) -> bytes:
        """Fetch the program, and make sure that it is the one that was verified."""
        reason = ""
        for attempt in range(3):
            try:
                answer = await self._client.get(self._url(claim.program), timeout=30.0)
                answer.raise_for_status()
            except httpx.HTTPError as error:
                reason = repr(error)
                await asyncio.sleep(FIRST_PAUSE * 2.0**attempt)
                continue
            digest = hashlib.sha256(answer.content).hexdigest()
            if digest != claim.sha256:
                raise ProgramError(
                    "program.wrong-checksum",
                    job=claim.job,
                    arrived=digest[:12],
                    expected=claim.sha256[:12],
                )
            return answer.content
        raise ProgramError("program.not-fetched", job=claim.job, reason=reason)

    async def _heartbeats(self, run: JobRun) -> None:
        """Report the machine's position and receive the operator's requests, until the job ends."""
        patience = max(min(run.claim.lease / 3.0, 2.0), self._beat)
        while not run.stale:
            body, asked = run.heartbeat(), self._now()
            with suppress(httpx.HTTPError, ValueError, KeyError, TypeError):
                answer = await self._client.post(
                    self._url("api/gateway/heartbeat"), json=body, timeout=patience
                )
                if answer.status_code == 409:
                    run.stale = True
                    run.heard.set()
                    return
                answer.raise_for_status()
                response = answer.json()
                run.until = asked + float(response["lease"])
                run.apply_answer(str(response["command"]), bool(body["held"]))
            await asyncio.sleep(self._beat)

    async def _finish(self, ended: JobEnd, tries: int | None = None) -> None:
        """Report the result of a job until the server answers, or ``tries`` times."""
        job, epoch, outcome, cause = ended.job, ended.epoch, ended.outcome, ended.cause
        self._journal.outcome(job, outcome, cause)
        body = ended.report()
        pause = FIRST_PAUSE
        while True:
            try:
                answer = await self._client.post(
                    self._url("api/gateway/finish"), json=body, timeout=5.0
                )
                if answer.status_code < 500:
                    if answer.is_error:
                        _log.warning("Job %s: %s %s", job, answer.status_code, answer.text[:200])
                    break
            except httpx.HTTPError as error:
                _log.warning("Job %s is %s; the server does not answer: %r", job, outcome, error)
            if tries is not None and (tries := tries - 1) <= 0:
                return
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, LONGEST_PAUSE)
        self._journal.end(job, epoch, outcome, cause)


async def work(
    api: str,
    machine: Machine,
    gateway: str,
    connect: Connect,
    *,
    client: httpx.AsyncClient | None = None,
    headers: Mapping[str, str] | None = None,
    journal: Path | None = None,
    wait: float = 20.0,
    beat: float = 0.25,
    jobs: int | None = None,
) -> None:
    """Run the gateway of a machine until cancelled.

    Cancellation stops the machine, raises the tool and reports to the server.

    Parameters
    ----------
    api
        Of the server, for example ``http://127.0.0.1:8080``.
    gateway
        Name of this gateway.
    connect
        Returns an open controller in its safe state, for example ``lambda safe, stop_motion:
        dial("127.0.0.1:2323", safe, stop_motion=stop_motion)`` with the ``dial`` of the machine's
        language; called again after every failure.
    client
        HTTP client to use; it is not closed.
    headers
        For every request, for example an API key; ``X-Knifetip: gateway`` is always sent.
    journal
        File in which progress is recorded.
    wait
        Longest time that the server may delay the answer to a claim (s).
    beat
        Time between two heartbeats (s).
    jobs
        Number of jobs after which to return.
    """
    own = httpx.AsyncClient() if client is None else client
    own.headers.update({"X-Knifetip": "gateway", **(headers or {})})
    try:
        record = Journal(journal)
        await _GatewayLoop(own, api, machine, gateway, connect, record, wait, beat).run(jobs)
    finally:
        if client is None:
            await own.aclose()
