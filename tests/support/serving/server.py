"""Run the real application on a real port for tests, in a thread or in a process."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from tempfile import gettempdir
from typing import Any

import httpx
import pytest
import uvicorn
from fastapi import FastAPI

from knifetip.server.app import create_app
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.components import Service
from knifetip.service.database.url import sqlite_file
from knifetip.service.processes.pool import ProcessPool
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.settings import Settings
from tests.support.serving.worker_reuse import ReusingPool
from tests.support.stored import write_tables
from tests.support.writers import dxf_text as text

ENDS = {"done", "refused", "interrupted", "scrapped", "cancelled"}


class LocalClient(httpx.Client):
    """An HTTP client of a server that runs in this process."""

    app: FastAPI

    @property
    def service(self) -> Service:
        """The database, queues and pools of the server."""
        return service_of(self.app)


class _Prepared(WarmUp):
    """A warm-up without work: `make test` has compiled all kernels.

    The real one starts a worker process (1 s of CPU time), which most tests do not need.
    """

    def start(self, pool: ProcessPool) -> None:
        pass


@contextmanager
def run_server(settings: Settings, rules: AccessRules | None = None) -> Iterator[LocalClient]:
    """Run a server in a thread, without looking for kernels; yield a client connected to it.

    A database in a new file has its tables when the server starts.
    """
    file = sqlite_file(settings.url)
    if file is not None and not file.exists():
        write_tables(file)
    app = create_app(settings, rules)
    server = uvicorn.Server(
        uvicorn.Config(app, port=0, log_level="error", timeout_graceful_shutdown=1)
    )
    thread = threading.Thread(target=server.run)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("knifetip.server.app.WarmUp", _Prepared)
        patch.setattr("knifetip.server.app.ProcessPool", ReusingPool)
        thread.start()
        while not server.started and thread.is_alive():
            time.sleep(0.02)
    port = server.servers[0].sockets[0].getsockname()[1]
    client = LocalClient(base_url=f"http://127.0.0.1:{port}", timeout=60.0, trust_env=False)
    client.app = app
    try:
        yield client
    finally:
        client.close()
        client.service.stopping.set()
        server.should_exit = True
        thread.join()


def service_of(app: object) -> Service:
    assert isinstance(app, FastAPI)
    service: Service = app.state.service
    return service


def square(
    layer: str = "CUT", side: float = 100.0, units: object = 4, extra: tuple[str, ...] = ()
) -> bytes:
    """Return a DXF file with a square of four lines.

    Parameters
    ----------
    side
        Length of the sides in units of the file.
    units
        $INSUNITS of the header, None to omit it.
    extra
        Further entities as DXF text.
    """
    corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side), (0.0, 0.0)]
    sides = [text.line(*start, *end, (8, layer)) for start, end in pairwise(corners)]
    return text.dxf(*sides, *extra, units=units)


def upload_drawing(client: httpx.Client, content: bytes, **fields: str) -> dict[str, Any]:
    """Upload a drawing with further form fields; return the JSON of the response."""
    answer = client.post("/api/drawings", files={"file": ("square.dxf", content)}, data=fields)
    assert answer.status_code == 201, answer.text
    body: dict[str, Any] = answer.json()
    return body


def order_job(client: httpx.Client, drawing: str, **fields: object) -> dict[str, Any]:
    """Order a job for a drawing's id with further JSON fields; return the JSON of the response."""
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute", **fields})
    assert answer.status_code == 201, answer.text
    body: dict[str, Any] = answer.json()
    return body


def confirm_job(client: httpx.Client, job: str, **fields: object) -> httpx.Response:
    """Confirm a job with all its checks and further JSON fields; return the response."""
    asked = client.get(f"/api/jobs/{job}/confirmation").json()
    checked = [check["id"] for check in asked["checks"]]
    return client.post(f"/api/jobs/{job}/confirm", json={"checked": checked, **fields})


def wait_for_state(
    client: httpx.Client, job: str, *states: str, seconds: float = 150.0, confirm: bool = False
) -> dict[str, Any]:
    """Wait until a job is in one of some states; return the JSON of the job.

    ``confirm`` confirms the sheet on the table, like an operator, as soon as the job waits for it.
    """
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        status: dict[str, Any] = client.get(f"/api/jobs/{job}").json()
        if status["state"] in states:
            return status
        assert status["state"] not in ENDS, status
        if confirm and status["waiting_for"] == "confirmation":
            confirm_job(client, job)
        time.sleep(0.02)
    raise AssertionError(f"job {job} is not {' or '.join(states)} after {seconds} s: {status}")


def process_environment() -> dict[str, str]:
    """Return the environment of a process of knifetip.

    The processes of all tests share compiled bytecode, even if this environment disables it.
    """
    environment = {**os.environ, "PYTHONPYCACHEPREFIX": f"{gettempdir()}/knifetip-bytecode"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    return environment


class Running:
    """A server (``serve``) in a process of its own, which can be killed.

    A database in a new file has its tables when the server starts.
    """

    def __init__(self, database: Path, **more: object) -> None:
        if not database.exists():
            write_tables(database)
        options = {"samples": False, **more}
        # Imports take less time without garbage collection, as in the command.
        code = (
            "import gc\ngc.disable()\n"
            "from knifetip.server.embedded import serve\n"
            "from knifetip.service.settings import Settings\n"
            "gc.enable()\n"
            f"serve(Settings(port=0, database='sqlite:///{database}', **{options!r}))"
        )
        self.process = subprocess.Popen(
            [sys.executable, "-c", code],
            stdout=subprocess.PIPE,
            text=True,
            env=process_environment(),
        )
        assert self.process.stdout is not None
        first = self.process.stdout.readline()
        assert "http://" in first, first
        url = first.split()[-1]
        self.client = httpx.Client(base_url=url, timeout=60.0, trust_env=False)

    def kill(self) -> None:
        """Kill the process immediately (SIGKILL), like a power failure."""
        self._end(signal.SIGKILL)

    def stop(self) -> int:
        """Stop the process like Ctrl-C (SIGINT); return its exit code."""
        return self._end(signal.SIGINT)

    def _end(self, signal_number: signal.Signals) -> int:
        self.client.close()
        if self.process.poll() is None:
            self.process.send_signal(signal_number)
        code = self.process.wait(120.0)
        assert self.process.stdout is not None
        self.process.stdout.close()
        return code

    def __enter__(self) -> httpx.Client:
        return self.client

    def __exit__(self, *_: object) -> None:
        self.stop()
