"""embedded: server, compile worker, gateway and a simulated table in one process, on one file.

    serve("127.0.0.1", 8080, "sqlite:///knifetip.sqlite") -> runs until Ctrl-C or SIGTERM

Killed at any moment, it loses no job: what was queued is queued at the next start, what was being
compiled is compiled again, and what was on the table comes back as interrupted.
"""

from __future__ import annotations

import asyncio
import contextlib
import gc
import ipaddress
import logging
import socket
import threading
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from types import FrameType

import httpx
import sqlalchemy as sa
import uvicorn
from fastapi import FastAPI

from knifetip.api import keys
from knifetip.api.access import AccessRules, is_loopback
from knifetip.api.app import create_app
from knifetip.api.drawings import added
from knifetip.api.service import Service, Settings
from knifetip.errors import KnifetipError, StoreError
from knifetip.gateway import claim, simulator
from knifetip.jobs.process_pool import TaskCancelled
from knifetip.languages.registry import find_language
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
    key: str = "",
    key_file: Path | None = None,
    hosts: tuple[str, ...] = (),
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
    key
        Who is not on this machine must have it; without one nobody else is served.
    key_file
        File that holds the key, made with a random one if it does not exist.
    hosts
        Names, or NAME:PORT, under which the server may be asked besides its addresses.
    told
        Hears the server's URL as soon as it answers.

    Raises
    ------
    StoreError
        The database cannot be used, or the port is taken.
    SettingsError
        A key or a host is none, or the key's file cannot be used.
    """
    key = keys.chosen(key, key_file)
    with ExitStack() as open_sockets:
        sockets = _listening(host, port)
        for one in sockets:
            open_sockets.enter_context(one)
        addresses = [one.getsockname()[0] for one in sockets]
        rules = AccessRules(key, keys.checked_hosts(hosts), all(map(is_loopback, addresses)))
        settings = Settings(database=database, compiles=compiles, name="embedded", access=rules)
        taken = sockets[0].getsockname()[1]
        shown = f"[{host}]" if ":" in host else host
        lines = [f"knifetip is at http://{shown}:{taken}"]
        if not rules.loopback_only:
            lines.append(_how_to_open(taken, key, key_file))
        server = _Server(create_app(settings), lines, told, samples)
        if simulator:
            server.table = _Table(_local(host), taken, speed, _beside(database))
        server.run(sockets=sockets)
    if not server.started:
        raise StoreError("server.not-started", database=database)


def _listening(host: str, port: int) -> list[socket.socket]:
    """Return the sockets to listen on: the host's, and a loopback one where it is none."""
    first = _bound(host, port)
    address, taken = first.getsockname()[:2]
    if is_loopback(address) or ipaddress.ip_address(address).is_unspecified:
        return [first]
    # The page of this machine's own user, and the gateway beside the server, need no key there.
    try:
        return [first, _bound("::1" if ":" in address else "127.0.0.1", taken)]
    except StoreError:
        first.close()
        raise


def _bound(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listener = socket.socket(family)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
        listener.listen(128)
    except OSError as reason:
        listener.close()
        raise StoreError(
            "server.address-in-use", host=host, port=port, reason=reason.strerror or reason
        ) from reason
    return listener


def _local(host: str) -> str:
    """Return the loopback address at which a server that listens on ``host`` is reached."""
    if host.startswith("127."):
        return host
    return "[::1]" if ":" in host else "127.0.0.1"


def _how_to_open(port: int, key: str, key_file: Path | None) -> str:
    """Return what the start log of a server on the network says of its key."""
    if not key:
        return (
            "There is no key: only this machine is served, at its loopback address. Start with "
            "--key-file PATH or --key KEY to serve others."
        )
    if key_file is None:
        return f"Other machines need the key: open http://localhost:{port} and sign in."
    return f"Open http://localhost:{port}/?key={key}"


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
        dial = find_language(machine.dialect).load_driver()
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
                lambda safe, stop_motion: dial(address, safe, stop_motion=stop_motion),
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

    def __init__(
        self, app: FastAPI, lines: list[str], told: Callable[[str], None], samples: bool
    ) -> None:
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
        self.lines = lines
        self.told = told
        self.samples = samples
        self.table: _Table | None = None
        self._leaving = False

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, and say where; the samples follow."""
        await super().startup(sockets)
        if self.should_exit:
            return
        # The collector would look through all that was imported again and again, and for that
        # time (0.3 s of a core) no thread runs, not even one that answers a heartbeat.
        gc.collect()
        gc.freeze()
        if self.table is not None:
            self.table.start()
        if self.samples:
            threading.Thread(target=_add_samples, args=(self._service,), daemon=True).start()
        for line in self.lines:
            self.told(line)

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
        self._service.stop()
        time.sleep(0.25)
        self.should_exit = True


def _add_samples(service: Service) -> None:
    """Read the samples into a database in which nothing ever happened."""
    try:
        if service.store.events.last_id() == 0:
            # Drawn by ezdxf, which the server does without at every other start.
            from knifetip.dxf.samples import samples

            for name, content in samples().items():
                added(service, None, name, content, "", "default")
    except (KnifetipError, TaskCancelled) as reason:
        _log.warning("the samples could not be read: %s", reason)
