"""gateway: what the process beside a table says and asks: claim, program, heartbeat, finish."""

from __future__ import annotations

import time

from fastapi import APIRouter, Request, Response
from fastapi.responses import PlainTextResponse

from knifetip.api.jobs import job_out
from knifetip.api.schemas.gateway import Claim, ClaimIn, FinishIn, HeartbeatIn, HeartbeatOut
from knifetip.api.schemas.jobs import JobOut
from knifetip.api.service import Here, bytes_answer, on_shelf
from knifetip.api.wake import woken_by
from knifetip.errors import MachineBusy, WrongState
from knifetip.jobs.gateway_store import GatewayReport
from knifetip.jobs.job import ON_TABLE, State
from knifetip.jobs.tables import Job
from knifetip.jobs.transitions import LEASE
from knifetip.library import load

router = APIRouter(prefix="/gateway", tags=["gateway"])

_LOOK = 1.0  # seconds between two looks at the queue, for what other servers changed
_SEEN = 2.0  # seconds between two notes that a gateway is there


@router.post("/claim", response_model=Claim, responses={204: {"description": "Nothing to do"}})
async def claim(here: Here, request: Request, wanted: ClaimIn) -> Claim | Response:
    """Wait for the next job of a machine and take it; 204 when there is none in that time.

    With ``confirm`` the job stays queued until the operator has confirmed it.
    """
    on_shelf("machines", wanted.machine)
    until = time.monotonic() + wanted.wait
    noted = -_SEEN
    with woken_by(here.store.changes) as changed:
        while not here.stopping.is_set():
            if time.monotonic() - noted >= _SEEN:
                noted = time.monotonic()
                await here.threads.claims(
                    here.store.gateways.record_contact, wanted.machine, wanted.gateway
                )
            # A gateway that has hung up would never start the job that it is given.
            if await request.is_disconnected():
                break
            job = await here.threads.claims(_next, here, wanted)
            if job is not None:
                return Claim(
                    job=job.id,
                    epoch=job.epoch,
                    lease=LEASE,
                    program=f"/api/gateway/program/{job.id}",
                    sha256=job.program_sha256,
                    lines=job.lines,
                    copies=job.copies - job.copies_done,
                    confirm=job.state == State.QUEUED,
                )
            left = until - time.monotonic()
            if left <= 0:
                break
            await changed.wait(min(_LOOK, left))
    return Response(status_code=204)


def _next(here: Here, wanted: ClaimIn) -> Job | None:
    try:
        manual = load.machine(wanted.machine, files=False).feed == "manual"
        return here.store.gateways.claim(wanted.machine, wanted.gateway, manual=manual)
    except MachineBusy:
        return None


@router.get("/program/{id}", response_class=PlainTextResponse)
async def get_gateway_program(here: Here, request: Request, id: str) -> Response:
    """Return the program of a job that a gateway has claimed."""
    job = await here.threads.claims(here.store.jobs.get, id)
    if job.state not in ON_TABLE and not job.confirmation:
        raise WrongState("job.not-running", job=id, state=job.state)
    text = await here.threads.claims(here.store.jobs.column, id, "program")
    return bytes_answer(request, text, job.program_sha256, "text/plain; charset=utf-8")


@router.post("/heartbeat")
async def heartbeat(here: Here, said: HeartbeatIn) -> HeartbeatOut:
    """Report what the machine did and get the next command; renews the lease."""
    command = await here.threads.reports(
        here.store.gateways.heartbeat,
        said.job,
        said.epoch,
        GatewayReport(
            line=said.line,
            copies_done=said.copies_done,
            held=said.held,
            waiting=said.waiting,
            position=said.position,
            seconds_left=said.seconds_left,
        ),
    )
    return HeartbeatOut.model_validate({"command": command, "lease": LEASE})


@router.post("/finish")
async def finish(here: Here, said: FinishIn) -> JobOut:
    """Report how a job ended; the last owner's late report corrects an interrupted job."""
    return await here.threads.reports(_finished, here, said)


def _finished(here: Here, said: FinishIn) -> JobOut:
    row = here.store.gateways.finish(
        said.job,
        said.epoch,
        said.outcome,
        said.why,
        line=said.line,
        copies_done=said.copies_done,
    )
    return job_out(here.store, row)
