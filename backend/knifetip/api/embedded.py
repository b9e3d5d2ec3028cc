"""embedded: server, compile worker, gateway and a simulated table in one process, on one file.

    serve("127.0.0.1", 8080, "sqlite:///knifetip.sqlite") -> runs until Ctrl-C or SIGTERM

Killed at any moment, it loses no job: what was queued is queued at the next start, what was being
compiled is compiled again, and what was on the table comes back as interrupted.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import socket
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType

import httpx
import sqlalchemy as sa
import uvicorn
from fastapi import FastAPI

from knifetip.api.app import create_app
from knifetip.api.drawings import added
from knifetip.api.service import Service, Settings
from knifetip.errors import KnifetipError, StoreError
from knifetip.gateway import claim, grbl, simulator
from knifetip.jobs.crew import Withdrawn
from knifetip.library import load

MACHINE = "demo-table"
_GRACE = 5.0  # seconds for the machine to stop and to say so
_log = logging.getLogger("knifetip.api")


def _said(words: str) -> None:
    print(words, flush=True)


def serve(
    host: str = "127.0.0.1",
    port: int = 8080,
    database: str = "sqlite:///knifetip.sqlite",
    *,
    samples: bool = True,
    simulator: bool = True,
    speed: float = 1.0,
    compiles: bool = True,
    told: Callable[[str], None] = _said,
) -> None:
    """Serve until SIGINT or SIGTERM.

    Parameters
    ----------
    port
        0 takes a free one.
    samples
        Read the sample drawings into a new database.
    simulator
        Put a simulated table beside the server, and a gateway between them.
    speed
        Seconds of the simulated table to one of the clock.
    compiles
        False where the compile workers are other processes.
    told
        Hears the server's URL as soon as it answers.

    Raises
    ------
    StoreError
        The database cannot be used, or the port is taken.
    """
    settings = Settings(database=database, compiles=compiles, name="embedded")
    app = create_app(settings)
    with _listening(host, port) as door:
        shown = f"[{host}]" if ":" in host else host
        server = _Server(app, f"http://{shown}:{door.getsockname()[1]}", told, samples)
        if simulator:
            journal = _beside(database)
            server.table = _Table(_local(host), door.getsockname()[1], speed, journal)
        server.run(sockets=[door])
    if not server.started:
        raise StoreError(
            f"The server did not start on {database}.", "The lines above say what was in the way."
        )


def _listening(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    door = socket.socket(family)
    door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        door.bind((host, port))
        door.listen(128)
    except OSError as reason:
        door.close()
        raise StoreError(
            f"{host}:{port} cannot be listened on: {reason.strerror or reason}.",
            "Stop what uses it, or take another with --port.",
        ) from reason
    return door


def _local(host: str) -> str:
    """Return where a process on this machine reaches a server that listens on ``host``."""
    match host:
        case "0.0.0.0" | "":
            return "127.0.0.1"
        case "::":
            return "[::1]"
        case _:
            return f"[{host}]" if ":" in host else host


def _beside(database: str) -> Path | None:
    """Return the gateway's journal: beside the database file, if there is one."""
    url = sa.make_url(database)
    if url.get_backend_name() != "sqlite" or not url.database:
        return None
    return Path(url.database + ".gateway.jsonl")


class _Table(threading.Thread):
    """The simulated table and its gateway, on an event loop of their own.

    The table computes where it is many times a second; the server must answer meanwhile.
    """

    def __init__(self, host: str, port: int, speed: float, journal: Path | None) -> None:
        super().__init__(name="simulated table", daemon=True)
        self._api = f"http://{host}:{port}"
        self._speed = speed
        self._journal = journal
        self._loop: asyncio.AbstractEventLoop | None = None
        self._work: asyncio.Task[None] | None = None

    def run(self) -> None:
        """Be the table until told to leave."""
        with contextlib.suppress(asyncio.CancelledError):
            asyncio.run(self._serve())

    async def _serve(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._work = asyncio.current_task()
        machine = load.machine(MACHINE)
        # A proxy for the world outside must not come between two parts of one process.
        async with (
            httpx.AsyncClient(trust_env=False) as client,
            await simulator.serve(machine, speed=self._speed) as table,
        ):
            address = table.address
            await claim.work(
                self._api,
                machine,
                "embedded",
                lambda safe, stop_motion: grbl.dial(address, safe, stop_motion=stop_motion),
                client=client,
                journal=self._journal,
            )

    def leave(self) -> None:
        """Stop the machine, say so to the server, and go."""
        if self._loop is not None and self._work is not None and self.is_alive():
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._work.cancel)
            self.join(_GRACE)


class _Server(uvicorn.Server):
    """Uvicorn, which on the way out lets the table finish its sentence first."""

    def __init__(self, app: FastAPI, url: str, told: Callable[[str], None], samples: bool) -> None:
        super().__init__(
            uvicorn.Config(
                app,
                log_level="warning",
                access_log=False,
                timeout_graceful_shutdown=2,
                # Heads of the browser's requests only: bodies have their own limit.
                h11_max_incomplete_event_size=65536,
            )
        )
        self.app = app
        self.url = url
        self.told = told
        self.samples = samples
        self.table: _Table | None = None
        self._leaving = False

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, and say where; the samples follow."""
        await super().startup(sockets)
        if self.should_exit:
            return
        if self.table is not None:
            self.table.start()
        if self.samples:
            threading.Thread(target=_add_samples, args=(self._service,), daemon=True).start()
        self.told(f"knifetip is at {self.url}")

    @property
    def _service(self) -> Service:
        service: Service = self.app.state.service
        return service

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Leave in order at the first signal, and at once at the second."""
        if self._leaving or not self.started:
            super().handle_exit(sig, frame)
            return
        self._leaving = True
        threading.Thread(target=self._leave, daemon=True).start()

    def _leave(self) -> None:
        if self.table is not None:
            self.table.leave()
        # Streams of events and long polls end now: uvicorn waits for their connections.
        self._service.stopping.set()
        time.sleep(0.25)
        self.should_exit = True


def _add_samples(service: Service) -> None:
    """Read the samples into a database in which nothing ever happened."""
    try:
        if service.store.last_event() == 0:
            # Drawn by ezdxf, which the server does without at every other start.
            from knifetip.dxf.samples import samples

            for name, content in samples().items():
                added(service, None, name, content, "", "default")
    except (KnifetipError, Withdrawn) as reason:
        _log.warning("the samples could not be read: %s", reason)
