"""An ERP orders a carton: upload, order, wait, fetch the program, or show what is wrong.

    make client && pip install build/client/knifetip_client-*.whl
    python erp_example.py http://knifetip:8080 tray.dxf --number PO-4711 \\
        --due 2030-01-02T12:00:00+01:00

Exits with 0 if the program was fetched, with 1 if the drawing or the job was refused.  The same
command may be repeated after any failure: it orders once.
"""

from __future__ import annotations

import argparse
import datetime
import hashlib
import os
import sys
import time
from pathlib import Path

from knifetip_client import AuthenticatedClient
from knifetip_client.api.drawings import upload_drawing
from knifetip_client.api.jobs import get_job, get_program, order_job
from knifetip_client.models import BodyUploadDrawing, JobIn, JobOut, JobOutState, Problem
from knifetip_client.types import File

WAITING = (JobOutState.RECEIVED, JobOutState.COMPILING)
REFUSED = (JobOutState.REFUSED, JobOutState.CANCELLED)


def show(problem: Problem) -> int:
    """Print what the server refused, for the person who made the drawing."""
    print(f"refused: {problem.detail} {problem.hint}")
    for question in problem.questions or []:
        print(f"question: {question.text} ({', '.join(question.choices)})")
    return 1


def wait(client: AuthenticatedClient, job: JobOut, seconds: float) -> JobOut:
    """Return the job when its program is made; webhooks replace polling: see receive-webhooks."""
    end = time.monotonic() + seconds
    while job.state in WAITING and time.monotonic() < end:
        time.sleep(0.5)
        answer = get_job.sync(job.id, client=client)
        if isinstance(answer, JobOut):
            job = answer
    return job


def main() -> int:
    """Order the drawing of the command line; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("server")
    parser.add_argument("drawing", type=Path)
    parser.add_argument("--number", required=True, help="number of the order")
    parser.add_argument("--due", type=datetime.datetime.fromisoformat, default=None)
    parser.add_argument("--board", default="e-flute")
    parser.add_argument("--machine", default="demo-table")
    parser.add_argument("--out", type=Path, default=Path())
    wanted = parser.parse_args()
    # A key with the scope designer.
    client = AuthenticatedClient(wanted.server, os.environ.get("KNIFETIP_KEY", ""), timeout=60.0)
    if not client.token:
        client.prefix, client.auth_header_name = "", "X-Knifetip"

    content = wanted.drawing.read_bytes()
    # From what is ordered, so that the same command orders once.
    key = f"{wanted.number}-{hashlib.sha256(content).hexdigest()[:16]}"
    drawing = upload_drawing.sync(
        client=client,
        body=BodyUploadDrawing(file=File(wanted.drawing.open("rb"), wanted.drawing.name)),
        idempotency_key=key,
    )
    if isinstance(drawing, Problem):
        return show(drawing)
    job = order_job.sync(
        client=client,
        body=JobIn(
            drawing=drawing.id,
            revision=drawing.revision,
            machine=wanted.machine,
            board=wanted.board,
            external_id=wanted.number,
            due=wanted.due,
        ),
        idempotency_key=key,
    )
    if isinstance(job, Problem):
        return show(job)
    job = wait(client, job, 600.0)
    if job.state in REFUSED:
        print(f"refused: {job.reason} {job.hint}")
        return 1
    # The bytes as they are: a decoded text could differ.
    program = get_program.sync_detailed(job.id, client=client)
    if program.status_code != 200:
        return show(program.parsed)
    path = wanted.out / f"{wanted.number}.program"
    path.write_bytes(program.content)
    print(f"{job.state.value}: job {job.id} of order {job.external_id}, program {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
