"""claim: take jobs from the server, run them on the machine, and report what happened.

    POST {api}/api/gateway/claim      -> a job with epoch, lease, program and its SHA-256
    POST {api}/api/gateway/heartbeat  -> wait, start, continue, hold, resume or cancel
    POST {api}/api/gateway/finish     <- done, interrupted, cancelled or returned

The gateway dials out and nobody dials in.  What it decides by itself:

- It asks for work only while the controller is there and idle: a table that is switched off
  takes no job.
- A claim that must be confirmed sends nothing to the machine before the server has answered a
  heartbeat with ``start``.  While it waits the controller must stay idle; otherwise the claim is
  given back, and the operator confirms anew.
- While the server cannot be reached the machine goes on until the lease has run out, then
  holds.  It never goes on by itself: the operator resumes, or the server says that the job is
  no longer ours (409) and the machine is stopped and raised.
- ``resume`` counts only as the answer to a heartbeat that said ``held``, so that a late one
  cannot start the next copy.
- How a job ended is recorded in the journal and reported until the server has answered, after a
  restart too: ``done`` only if the journal has every copy executed to its last line.
- A controller that still runs a job of ours, after a restart or a lost connection, is stopped and
  brought into its safe state before anything else.
"""

from __future__ import annotations

import asyncio
import hashlib
import logging
from collections.abc import Awaitable, Callable, Mapping
from contextlib import aclosing, suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urljoin

import httpx

from knifetip.errors import ControllerError, KnifetipError, ProgramError
from knifetip.gateway.controller import Controller, SafeState, State
from knifetip.gateway.journal import Journal
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.stream import Progress, stream
from knifetip.model.machine import Machine

#: Longest pause between two attempts to reach somebody (s).
PATIENCE = 5.0
#: First pause, doubled from there (s).
HASTE = 0.25

#: Opens a controller; True stops a machine that moves, since its program is ours.
Connect = Callable[[SafeState, bool], Awaitable[Controller]]

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class _Claim:
    """A job for this gateway alone, as the server words it."""

    job: str
    epoch: int
    lease: float
    program: str
    sha256: str
    copies: int
    confirm: bool  #: the operator must confirm before anything is sent to the machine

    @classmethod
    def of(cls, answer: Mapping[str, Any]) -> _Claim:
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
    """The job is no longer ours."""


class _Cancelled(Exception):
    """The operator gave the job up."""


class _Returned(Exception):
    """The claim is given back: the machine cannot be started, and nothing was sent to it."""


class _Run:
    """What the heartbeats say of a job, and what they bring back."""

    def __init__(self, claim: _Claim, now: float) -> None:
        self.claim = claim
        self.line = 0
        self.copies_done = 0
        self.begun = False  #: a copy is under way, of which ``line`` lines are executed
        self.waiting = claim.confirm  #: for the operator's confirmation; nothing is sent yet
        self.held = False
        self.position: Pose | None = None
        self.seconds_left: float | None = None
        self.wish = ""  #: hold, resume or nothing
        self.cancelled = False
        self.stale = False
        self.until = now + claim.lease  #: the lease's end, on our clock
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

    def answered(self, command: str, held: bool) -> None:
        """Take the answer to a heartbeat that said ``held`` or not."""
        if command == "cancel":
            self.cancelled = True
        elif command == "start":
            self.waiting = False
        elif command == "hold" or (command == "resume" and held):
            self.wish = command
        self.heard.set()

    def obey(self) -> None:
        """Leave the job where that is what the server wants."""
        if self.stale:
            raise _Stale
        if self.cancelled:
            raise _Cancelled


@dataclass(frozen=True, slots=True)
class _Ended:
    """How a job ended, as it is reported."""

    job: str
    epoch: int
    outcome: str
    why: str
    line: int  #: executed lines of the copy that was under way; 0 between two copies
    copies_done: int  #: under this claim

    @classmethod
    def of(cls, run: _Run, outcome: str, why: str) -> _Ended:
        line = run.line if run.begun or outcome == "done" else 0
        return cls(run.claim.job, run.claim.epoch, outcome, why, line, run.copies_done)


def _withdrawn(run: _Run) -> str:
    if run.waiting:
        return "The server took the job back before its start; nothing was sent to the machine."
    return "The server took the job back; the machine was stopped."


class _Gateway:
    """One machine's way to the server."""

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
        self._abandoned = False  # the machine may still be carrying out a job of ours
        self._complaint = ""

    # -- the round ------------------------------------------------------------------------------

    async def run(self, jobs: int | None) -> None:
        """Take jobs one after another; for ever, or so many."""
        try:
            await asyncio.gather(self._last_time(), self._recover())
            while jobs is None or jobs > 0:
                await self._ready()
                claim = await self._claim()
                if claim is not None:
                    await self._carry_out(claim)
                    if jobs is not None:
                        jobs -= 1
        finally:
            await self._let_go()

    async def _last_time(self) -> None:
        """Report the job that this gateway was switched off in, until the server has answered."""
        if (left := self._journal.unfinished()) is None:
            return
        outcome, why = left.outcome, left.why
        if not outcome and left.copies_done >= left.copies:
            outcome, why = "done", "The gateway was switched off before it could report."
        elif not outcome:
            outcome, why = "interrupted", "The gateway was switched off."
        ended = _Ended(left.job, left.epoch, outcome, why, left.line, left.copies_done)
        await self._finish(ended)

    async def _recover(self) -> None:
        """Stop a machine that may still be carrying out a job that this gateway was killed in."""
        if self._journal.unfinished() is None:
            return
        self._abandoned = True
        try:
            await self._at_hand()
        except (ControllerError, OSError) as error:
            self._complaint = str(error)
            _log.warning("%s", error)

    async def _ready(self) -> None:
        """Wait until the controller is there and idle."""
        pause = HASTE
        while True:
            try:
                controller = await self._at_hand()
                status = await controller.status()
                if status.state is State.IDLE:
                    self._complaint = ""
                    return
                complaint = f"{controller.name} is not idle: it says {status.state.value}."
            except (ControllerError, OSError) as error:
                complaint = str(error)
            if complaint != self._complaint:
                self._complaint = complaint
                _log.warning("%s", complaint)
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, PATIENCE)

    async def _at_hand(self) -> Controller:
        """Return a controller without a fault, connecting anew where there is none."""
        if self._controller is not None and self._controller.fault is not None:
            await self._let_go()
        if self._controller is None:
            safe = SafeState.of(self._machine)
            self._controller = await self._connect(safe, self._abandoned)
            self._abandoned = False
        return self._controller

    async def _let_go(self) -> None:
        controller, self._controller = self._controller, None
        if controller is not None:
            await controller.close()

    # -- one job --------------------------------------------------------------------------------

    async def _carry_out(self, claim: _Claim) -> None:
        run = _Run(claim, self._now())
        beating = asyncio.create_task(self._heartbeats(run), name="heartbeats")
        outcome, why = "interrupted", ""
        try:
            try:
                await self._confirmed(run)
                await self._copies(run)
                outcome = "done"
            except _Returned as reason:
                outcome, why = "returned", str(reason)
            except _Cancelled:
                outcome, why = "cancelled", f"Cancelled by the operator at line {run.line}."
            except _Stale:
                # The server may still take this report: as evidence of where the machine stopped.
                why = _withdrawn(run)
                _log.warning("Job %s: %s", claim.job, why)
            except (KnifetipError, OSError) as error:
                why = str(error)
            except asyncio.CancelledError:
                if run.waiting:
                    outcome, why = "returned", "The gateway was switched off."
                else:
                    why = "The gateway was switched off; the machine was stopped."
                with suppress(asyncio.CancelledError):
                    await self._finish(_Ended.of(run, outcome, why), tries=1)
                raise
        finally:
            beating.cancel()
            await asyncio.gather(beating, return_exceptions=True)
        await self._finish(_Ended.of(run, outcome, why))

    async def _confirmed(self, run: _Run) -> None:
        """Wait until the operator has confirmed the job; the controller must stay idle."""
        while run.waiting:
            run.heard.clear()
            await run.heard.wait()
            run.obey()
            try:
                controller = await self._at_hand()
                state = (await controller.status()).state
            except (ControllerError, OSError) as error:
                raise _Returned(str(error)) from error
            if state is not State.IDLE:
                raise _Returned(f"{controller.name} is not idle: it reports {state.value}.")

    async def _copies(self, run: _Run) -> None:
        claim = run.claim
        text = await self._program(claim)
        lines = text.count(b"\n")
        self._journal.begin(claim.job, claim.epoch, claim.sha256, lines, claim.copies)
        for copy in range(claim.copies):
            if copy:
                await self._new_sheet(run)
            run.line, run.begun = 0, True
            await self._one_copy(run, text, copy)
            self._journal.copy(claim.job, copy + 1)
            run.copies_done, run.line, run.seconds_left = copy + 1, lines, 0.0
            run.begun = False

    async def _one_copy(self, run: _Run, text: bytes, copy: int) -> None:
        controller = await self._at_hand()
        going = stream(
            text,
            controller,
            limits=Limits.of(self._machine),
            check=copy == 0,
            interval=min(self._beat / 2.0, 0.1),
        )
        try:
            async with aclosing(going) as course:
                async for progress in course:
                    self._note(run, progress, copy)
                    if progress.executed < progress.lines:
                        # After the last line there is nothing left to stop or to hold.
                        run.obey()
                        await self._wishes(run, progress, controller)
        finally:
            self._abandoned = controller.fault is not None

    def _note(self, run: _Run, progress: Progress, copy: int) -> None:
        run.line = progress.executed
        run.held = progress.state is State.HOLD
        run.seconds_left = progress.seconds_left
        run.position = self._head(progress)
        self._journal.line(run.claim.job, copy, progress.executed, progress.acknowledged)

    async def _wishes(self, run: _Run, progress: Progress, controller: Controller) -> None:
        """Hold or resume; a wish is spent when the machine does what was wished."""
        if self._now() > run.until and progress.state is State.RUN:
            await controller.hold()
        elif run.wish == "hold":
            if progress.state is State.RUN:
                await controller.hold()
            elif progress.state is State.HOLD:
                run.wish = ""
        elif run.wish == "resume":
            if progress.state is State.HOLD:
                await controller.resume()
            else:
                run.wish = ""

    async def _new_sheet(self, run: _Run) -> None:
        """Wait, as held, until the operator has put a new sheet on the table."""
        run.held, run.wish = True, ""
        while run.wish != "resume":
            run.heard.clear()
            await run.heard.wait()
            run.obey()
        run.held, run.wish = False, ""

    def _head(self, progress: Progress) -> Pose:
        """Return the head's pose on the sheet: without the datum of the station in use."""
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

    async def _claim(self) -> _Claim | None:
        """Ask for work; None when there is none, or nobody to ask."""
        body = {"gateway": self._name, "machine": self._machine.name, "wait": self._wait}
        try:
            answer = await self._client.post(
                self._url("api/gateway/claim"), json=body, timeout=self._wait + 10.0
            )
            if answer.status_code == 204:
                return None
            if answer.status_code == 200:
                return _Claim.of(answer.json())
            reason = f"{answer.status_code} {answer.text[:200]}"
        except (httpx.HTTPError, ValueError, KeyError, TypeError) as error:
            reason = repr(error)
        if reason != self._complaint:
            self._complaint = reason
            _log.warning("No work to be had from %s: %s", self._api, reason)
        await asyncio.sleep(min(PATIENCE, max(self._wait, HASTE)))
        return None

    async def _program(self, claim: _Claim) -> bytes:
        """Fetch the program, and make sure that it is the one that was verified."""
        reason = ""
        for attempt in range(3):
            try:
                answer = await self._client.get(self._url(claim.program), timeout=30.0)
                answer.raise_for_status()
            except httpx.HTTPError as error:
                reason = repr(error)
                await asyncio.sleep(HASTE * 2.0**attempt)
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

    async def _heartbeats(self, run: _Run) -> None:
        """Say where the machine is, and take what the operator wants, until ended."""
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
                said = answer.json()
                run.until = asked + float(said["lease"])
                run.answered(str(said["command"]), bool(body["held"]))
            await asyncio.sleep(self._beat)

    async def _finish(self, ended: _Ended, tries: int | None = None) -> None:
        """Report how a job ended until the server has answered (or so many times)."""
        job, epoch, outcome, why = ended.job, ended.epoch, ended.outcome, ended.why
        self._journal.outcome(job, outcome, why)
        body = asdict(ended)
        pause = HASTE
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
            pause = min(2.0 * pause, PATIENCE)
        self._journal.end(job, epoch, outcome, why)


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
    """Be the gateway of a machine until cancelled.

    Cancelling it stops the machine, raises the tool and tells the server.

    Parameters
    ----------
    api
        Of the server, for example ``http://127.0.0.1:8080``.
    gateway
        The name under which this gateway is seen.
    connect
        Returns an open controller in its safe state, for example ``lambda safe, stop_motion:
        dial("127.0.0.1:2323", safe, stop_motion=stop_motion)`` with the ``dial`` of the machine's
        language; called again after every failure.
    client
        Used and left open where it is given.
    headers
        For every request, for example an API key; ``X-Knifetip: gateway`` is always sent.
    journal
        File of what was acknowledged and executed.
    wait
        Seconds that the server may keep a claim waiting.
    beat
        Seconds between two heartbeats.
    jobs
        Return after so many jobs.
    """
    own = httpx.AsyncClient() if client is None else client
    own.headers.update({"X-Knifetip": "gateway", **(headers or {})})
    try:
        record = Journal(journal)
        await _Gateway(own, api, machine, gateway, connect, record, wait, beat).run(jobs)
    finally:
        if client is None:
            await own.aclose()
