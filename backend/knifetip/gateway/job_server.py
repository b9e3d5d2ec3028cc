"""job_server: requests of a gateway to the server that assigns its jobs.

The requests are POST /api/gateway/claim, /heartbeat, /finish and /station, and GET of the program.
"""

from __future__ import annotations

import asyncio
import hashlib
import logging
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urljoin

import httpx

from knifetip import tracing
from knifetip.contract.operations import EXPIRY
from knifetip.contract.station_report import OperationResult, StationAnswer, StationReport
from knifetip.errors import GatewayRefused, ProgramError, StaleVersion
from knifetip.gateway.job_run import JobEnd, JobRun, Lease
from knifetip.gateway.journal import Journal
from knifetip.model.machine import Machine

#: Longest pause between two attempts to connect (s).
LONGEST_PAUSE = 5.0
#: First pause between two attempts to connect, doubled after each attempt (s).
FIRST_PAUSE = 0.25

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class GatewaySettings:
    """Settings of a gateway: its server, its machine, its name and its time limits."""

    api: str  #: URL of the server, for example ``http://127.0.0.1:8080``
    machine: Machine
    name: str  #: name of the gateway
    #: headers of every request, for example an API key; ``X-Knifetip: gateway`` is always sent
    headers: Mapping[str, str] = field(default_factory=dict)
    journal: Path | None = None  #: file in which the progress is recorded
    wait: float = 20.0  #: longest time that the server may delay the answer to a claim (s)
    beat: float = 0.25  #: time between two heartbeats (s)
    #: called with the outcome of each run and its duration (s)
    observe: Callable[[str, float], None] = lambda _outcome, _seconds: None


class JobServer:
    """Client of the server: claims jobs, fetches their programs, and reports progress and end.

    Attributes
    ----------
    refusal
        Why the server refuses the requests of this gateway; None if it answered the last one or
        does not answer.
    """

    def __init__(
        self, client: httpx.AsyncClient, settings: GatewaySettings, journal: Journal
    ) -> None:
        self._client = client
        self._settings = settings
        self._api = settings.api.rstrip("/") + "/"
        self._journal = journal
        self._complaint = ""  # the last logged failure of a claim
        self.refusal: GatewayRefused | None = None

    def _url(self, path: str) -> str:
        return urljoin(self._api, path)

    def _require_access(self, answer: httpx.Response) -> None:
        """Raise ``GatewayRefused`` if the server refuses the key of this gateway."""
        if answer.status_code not in (401, 403):
            self.refusal = None
            return
        self.refusal = GatewayRefused(
            "gateway.access-refused", server=self._settings.api, reason=_reason(answer)
        )
        raise self.refusal

    def refusal_of(self, run: JobRun) -> GatewayRefused | None:
        """Return why the server refuses this gateway, if it does so since the lease has expired."""
        return self.refusal if asyncio.get_running_loop().time() > run.lease_end else None

    def raise_if_refused(self, run: JobRun) -> None:
        """Raise ``GatewayRefused`` if the server refuses the key and so no operator can act."""
        if (refusal := self.refusal_of(run)) is not None:
            raise refusal

    async def claim(self) -> Lease | None:
        """Claim the next job of the machine, and return it with its lease.

        Returns None if the server has no job for the machine or does not answer.  The server waits
        for a new job for at most ``GatewaySettings.wait`` seconds.

        Raises
        ------
        StaleVersion
            The server has a newer version of the machine.
        GatewayRefused
            The server refuses the key of this gateway.
        """
        body = {
            "gateway": self._settings.name,
            "machine": self._settings.machine.name,
            "wait": self._settings.wait,
            "announces_begin": True,
        }
        if self._settings.machine.version:
            body["machine_version"] = self._settings.machine.version
        try:
            answer = await self._client.post(
                self._url("api/gateway/claim"), json=body, timeout=self._settings.wait + 10.0
            )
            self._require_access(answer)
            if answer.status_code == 204:
                self._complaint = ""
                return None
            if answer.status_code == 200:
                self._complaint = ""
                return Lease.from_answer(answer.json())
            if answer.status_code == 412 and self._settings.machine.version:
                machine = self._settings.machine
                raise StaleVersion(
                    "gateway.machine-changed", machine=machine.name, version=machine.version
                )
            reason = f"{answer.status_code} {answer.text[:200]}"
        except (httpx.HTTPError, ValueError, KeyError, TypeError) as error:
            reason = repr(error)
        if reason != self._complaint:
            self._complaint = reason
            _log.warning("%s assigns no job: %s", self._api, reason)
        await asyncio.sleep(min(LONGEST_PAUSE, max(self._settings.wait, FIRST_PAUSE)))
        return None

    async def report_station(
        self, report: StationReport, results: Sequence[OperationResult], wait: float
    ) -> StationAnswer:
        """Report the state of the machine, and return the operations that a person has asked for.

        Parameters
        ----------
        report
            State of the controller.
        results
            Results of operations that have ended since the last report.
        wait
            Longest time that the server may wait for an operation before it answers (s).

        Raises
        ------
        httpx.HTTPError
            The server does not answer, or refuses the report.
        GatewayRefused
            The server refuses the key of this gateway.
        ValueError, KeyError, TypeError
            The answer of the server is malformed.
        """
        body = {
            **report.as_json(),
            "gateway": self._settings.name,
            "machine": self._settings.machine.name,
            "results": [result.as_json() for result in results],
            "wait": wait,
        }
        answer = await self._client.post(
            self._url("api/gateway/station"), json=body, timeout=wait + EXPIRY
        )
        self._require_access(answer)
        answer.raise_for_status()
        return StationAnswer.from_answer(answer.json())

    async def program(self, claim: Lease) -> bytes:
        """Return the program of a claimed job, fetched from the server.

        Raises
        ------
        ProgramError
            The SHA-256 of the program differs from the SHA-256 in the claim, or the server did not
            send the program.
        GatewayRefused
            The server refuses the key of this gateway.
        """
        return await self._download(claim.job, claim.program, claim.sha256)

    async def text_of(self, job: str, sha256: str) -> bytes:
        """Return the program of a job that this gateway has begun; raises as ``program`` does."""
        return await self._download(job, f"api/gateway/program/{job}", sha256)

    async def _download(self, job: str, path: str, sha256: str) -> bytes:
        reason = ""
        for attempt in range(3):
            try:
                answer = await self._client.get(
                    self._url(path), headers=tracing.headers(), timeout=30.0
                )
                self._require_access(answer)
                answer.raise_for_status()
            except httpx.HTTPError as error:
                reason = repr(error)
                await asyncio.sleep(FIRST_PAUSE * 2.0**attempt)
                continue
            digest = hashlib.sha256(answer.content).hexdigest()
            if digest != sha256:
                raise ProgramError(
                    "program.wrong-checksum", job=job, arrived=digest[:12], expected=sha256[:12]
                )
            return answer.content
        raise ProgramError("program.not-fetched", job=job, reason=reason)

    async def send_heartbeats(self, run: JobRun) -> None:
        """Send the progress of a job to the server at intervals.

        The method returns when the server has withdrawn the job; otherwise it must be cancelled.

        Parameters
        ----------
        run
            State of the job with its progress.  The commands in the answers are stored in ``run``.
        """
        patience = max(min(run.claim.lease / 3.0, 2.0), self._settings.beat)
        while not run.stale:
            body, asked = run.heartbeat(), asyncio.get_running_loop().time()
            with suppress(httpx.HTTPError, ValueError, KeyError, TypeError):
                answer = await self._client.post(
                    self._url("api/gateway/heartbeat"), json=body, timeout=patience
                )
                try:
                    self._require_access(answer)
                except GatewayRefused:
                    run.answered.set()  # a run that waits must notice the end of its lease
                    await asyncio.sleep(self._settings.beat)
                    continue
                if answer.status_code == 409:
                    run.stale = True
                    run.answered.set()
                    return
                answer.raise_for_status()
                response = answer.json()
                run.lease_end = asked + float(response["lease"])
                run.apply_answer(
                    str(response["command"]),
                    held=bool(body["held"]),
                    phase=int(str(body["phase"])),
                    begun=bool(body["begun"]),
                )
            await asyncio.sleep(self._settings.beat)

    def record(self, end: JobEnd) -> None:
        """Record the end of a job in the journal, before it is reported."""
        self._journal.record_outcome(end.job, end.outcome, end.cause, end.line_at_most)

    async def finish(
        self, end: JobEnd, tries: int | None = None, *, recorded: bool = False
    ) -> None:
        """Record the end of a job in the journal, and report it until the server answers.

        Parameters
        ----------
        end
            The job, and how it ended.
        tries
            Greatest number of requests; None for no limit.  If no request is answered, the method
            returns, and the gateway reports the end again after its next start.
        recorded
            Whether ``record`` was called for the end.

        Raises
        ------
        GatewayRefused
            The server refuses the key of this gateway, which reports the end again after its next
            start.
        """
        job, epoch, outcome, cause = end.job, end.epoch, end.outcome, end.cause
        if not recorded:
            self.record(end)
        body = end.report()
        pause = FIRST_PAUSE
        while True:
            try:
                answer = await self._client.post(
                    self._url("api/gateway/finish"),
                    json=body,
                    headers=tracing.headers(),
                    timeout=5.0,
                )
                self._require_access(answer)
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


def _reason(answer: httpx.Response) -> str:
    """Return the text with which a server refuses a request, or else its status."""
    with suppress(ValueError):
        content = answer.json()
        if isinstance(content, dict) and isinstance(content.get("detail"), str):
            return str(content["detail"])[:500]
    return str(answer.status_code)
