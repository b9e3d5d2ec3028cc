"""The embedded service: server, compile worker, gateway and simulated machine in one process.

Killing the process loses no job.  After a restart queued jobs are still queued, jobs that were
being compiled are compiled again, and the job that the machine was executing has the state
``interrupted``.
"""

from __future__ import annotations

import asyncio
import contextlib
import gc
import ipaddress
import logging
import secrets
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

from knifetip import logs
from knifetip.errors import KnifetipError, StoreError
from knifetip.gateway import claim
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.journal import default_path
from knifetip.languages.registry import find_language
from knifetip.library import load
from knifetip.metrics_server import serve_metrics
from knifetip.server.app import create_app
from knifetip.server.machine_reservation import reserved_machine
from knifetip.service.accounts import server_key as keys
from knifetip.service.accounts.access_rules import AccessRules, is_loopback
from knifetip.service.components import Service
from knifetip.service.database.url import hide_password
from knifetip.service.drawings.requests import Upload, store_upload
from knifetip.service.limits.connections import ConnectionLimits, limited_protocol, raise_file_limit
from knifetip.service.processes.pool import TaskCancelled
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from knifetip.simulators.grbl import simulator

MACHINE = "demo-table"
_FILES = 256  # open files besides connections
_GRACE = 5.0  # seconds for the machine to stop and report it
_log = logging.getLogger("knifetip.api")


def _print_line(line: str) -> None:
    print(line, flush=True)


def serve(settings: Settings, announce: Callable[[str], None] = _print_line) -> None:
    """Run the embedded service until SIGINT or SIGTERM.

    The embedded service is the server with a compile worker, a gateway and a simulated machine.

    Parameters
    ----------
    settings
        Settings of the server.
    announce
        Called with the URL of the server when the server is ready.

    Raises
    ------
    StoreError
        The database cannot be used, the port is in use, or another server has the machine of the
        embedded gateway.
    SettingsError
        The key or a host is malformed, or the key file cannot be used.
    """
    key = keys.load_key(settings.key, settings.key_file)
    host, database = settings.host, settings.url
    refused = ""
    if not (key or is_loopback(host) or _has_admin(database)):
        refused, host = host, "::1" if ":" in host else "127.0.0.1"
    logs.hide(key)
    with ExitStack() as open_sockets:
        journal = _journal_path(database)
        sockets = _listen(host, settings.port)
        for one in sockets:
            open_sockets.enter_context(one)
        addresses = [one.getsockname()[0] for one in sockets]
        rules = AccessRules(
            key=key,
            gateway_key=secrets.token_urlsafe(32),
            hosts=keys.check_hosts(settings.allow_host),
            loopback_only=all(map(is_loopback, addresses)),
        )
        taken = sockets[0].getsockname()[1]
        if settings.simulator:
            open_sockets.enter_context(reserved_machine(journal, MACHINE, taken))
        shown = f"[{host}]" if ":" in host else host
        lines = [f"knifetip is at http://{shown}:{taken}"]
        if refused:
            lines.append(
                f"ERROR: not listening on {refused}, because everybody there could start the "
                "machine. Create an administrator (knifetip user add NAME --role admin) or give "
                "--key-file PATH, then start the server again."
            )
        if key:
            lines.append(_how_to_open(taken, settings.key_file))
        elif rules.loopback_only and not refused and not _has_admin(database):
            lines.append(
                "No administrator exists yet: every program on this computer may do everything. "
                "Create one with: knifetip user add NAME --role admin"
            )
        limits = ConnectionLimits(
            per_client=settings.max_connections, total=settings.all_connections
        )
        raise_file_limit(limits.total + _FILES)
        app = create_app(settings, rules)
        open_sockets.enter_context(
            serve_metrics(settings.metrics_address, app.state.metrics.registry)
        )
        server = _Server(app, lines, announce, settings.samples, limits)
        if settings.simulator:
            server.table = _SimulatedMachine(
                _local(host), taken, settings.speed, journal, rules.gateway_key
            )
        server.run(sockets=sockets)
    if not server.started:
        raise StoreError("server.not-started", database=hide_password(database))


def _listen(host: str, port: int) -> list[socket.socket]:
    """Return the sockets on which the server listens: one for ``host``, and one for loopback.

    There is only one socket if ``host`` is a loopback address or a wildcard address.  If
    ``port`` is 0, a free port is used.
    """
    first = _bind(host, port)
    address, taken = first.getsockname()[:2]
    if is_loopback(address) or ipaddress.ip_address(address).is_unspecified:
        return [first]
    # The user of this computer and the embedded gateway need no key on loopback.
    try:
        return [first, _bind("::1" if ":" in address else "127.0.0.1", taken)]
    except StoreError:
        first.close()
        raise


def _bind(host: str, port: int) -> socket.socket:
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
    """Return the loopback address at which a server that listens on ``host`` can be reached."""
    if host.startswith("127."):
        return host
    return "[::1]" if ":" in host else "127.0.0.1"


def _has_admin(database: str) -> bool:
    """Return whether a database has an administrator; the tables are made ready first."""
    store = Store(database)
    try:
        store.prepare()
        return store.users.has_admin()
    finally:
        store.close()


def _how_to_open(port: int, key_file: Path | None) -> str:
    """Return the line of the start log that explains how other computers get access.

    ``key_file``: file that contains the key of the server; None if the key is not in a file.
    """
    key = "key" if key_file is None else f"key in {key_file}"
    return f"Other computers need the {key}: open http://localhost:{port} and sign in."


def _journal_path(database: str) -> Path:
    """Return the path of the embedded gateway's journal.

    In the journal the gateway records the progress and the end of each job.  It lies beside the
    file of a SQLite database; otherwise at the default path of a gateway.
    """
    url = sa.make_url(database)
    if url.get_backend_name() == "sqlite" and url.database:
        return Path(url.database + ".gateway.jsonl")
    return default_path(MACHINE, f"{url.host} {url.port or ''} {url.database}")


class _SimulatedMachine(threading.Thread):
    """Thread with its own event loop for the simulated machine and the gateway of the machine.

    The machine updates its position many times a second.  It has its own thread so that these
    updates do not delay the server.
    """

    def __init__(self, host: str, port: int, speed: float, journal: Path, key: str) -> None:
        super().__init__(name="simulated table", daemon=True)
        self._api = f"http://{host}:{port}"
        self._speed = speed
        self._journal = journal
        self._headers = {"Authorization": f"Bearer {key}"}
        self._loop: asyncio.AbstractEventLoop | None = None
        self._work: asyncio.Task[None] | None = None

    def run(self) -> None:
        """Run the simulated machine and its gateway until ``leave`` is called."""
        with contextlib.suppress(asyncio.CancelledError):
            asyncio.run(self._serve())

    async def _serve(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._work = asyncio.current_task()
        machine = load.machine(MACHINE)
        dial = find_language(machine.dialect).load_driver(machine)
        # Requests within this process must not go through a configured proxy.
        async with (
            httpx.AsyncClient(trust_env=False) as client,
            await simulator.serve(machine, speed=self._speed) as table,
        ):
            address = table.address
            await claim.run_gateway(
                GatewaySettings(
                    self._api, machine, "embedded", headers=self._headers, journal=self._journal
                ),
                lambda safe, stop_motion: dial(address, safe, stop_motion=stop_motion),
                client=client,
            )

    def leave(self) -> None:
        """Stop the machine, report the stop to the server, and end the thread."""
        if self._loop is not None and self._work is not None and self.is_alive():
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._work.cancel)
            self.join(_GRACE)


class _Server(uvicorn.Server):
    """Uvicorn server that stops the simulated machine before it shuts down."""

    def __init__(
        self,
        app: FastAPI,
        lines: list[str],
        announce: Callable[[str], None],
        samples: bool,
        limits: ConnectionLimits,
    ) -> None:
        super().__init__(
            uvicorn.Config(
                app,
                http=limited_protocol(limits),
                # The loggers of uvicorn are written by the handler of the process, like all others.
                log_config=None,
                log_level="warning",
                access_log=False,
                timeout_graceful_shutdown=2,
                # Limits request heads only; bodies have their own limit.
                h11_max_incomplete_event_size=65536,
            )
        )
        self.app = app
        self.lines = lines
        self.announce = announce
        self.samples = samples
        self.table: _SimulatedMachine | None = None
        self._leaving = False
        self._exit = asyncio.Event()
        self._loop: asyncio.AbstractEventLoop | None = None

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start the server, announce its URL, and add the sample drawings in the background."""
        await super().startup(sockets)
        if self.should_exit:
            return
        # Exclude imported objects from garbage collection: scanning them takes 0.3 s, during which
        # no thread runs, not even one that answers a heartbeat.
        gc.collect()
        gc.freeze()
        if self.table is not None:
            self.table.start()
        if self.samples:
            threading.Thread(target=_add_samples, args=(self._service,), daemon=True).start()
        for line in self.lines:
            self.announce(line)

    async def main_loop(self) -> None:
        """Run the main loop of the server until the server must exit.

        The loop runs once a second, to update the Date header of responses.  It replaces the loop
        of uvicorn, which runs ten times a second and so uses more processor time while the server
        is idle.
        """
        self._loop = asyncio.get_running_loop()
        while not await self.on_tick(0):
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(1.0):
                    await self._exit.wait()

    @property
    def _service(self) -> Service:
        service: Service = self.app.state.service
        return service

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Stop the machine and then the server; at a second signal, stop the server at once."""
        if self._leaving or not self.started:
            super().handle_exit(sig, frame)
            self._end_main_loop()
            return
        self._leaving = True
        threading.Thread(target=self._leave, daemon=True).start()

    def _leave(self) -> None:
        if self.table is not None:
            self.table.leave()
        # Ends event streams and long polls, for whose connections uvicorn would wait.
        self._service.stop()
        time.sleep(0.25)
        self.should_exit = True
        self._end_main_loop()

    def _end_main_loop(self) -> None:
        """Wake the main loop so that it ends without delay; may be called from any thread."""
        if self._loop is not None:
            with contextlib.suppress(RuntimeError):  # the loop is closed
                self._loop.call_soon_threadsafe(self._exit.set)


def _add_samples(service: Service) -> None:
    """Add the sample drawings if the database is new.

    A database is new if no change of a job or drawing is recorded in it.
    """
    try:
        if service.store.events.last_id() == 0:
            # Imports ezdxf, which is not needed otherwise.
            from knifetip.dxf.samples import samples

            for name, content in samples().items():
                store_upload(service, Upload(name, content))
    except (KnifetipError, TaskCancelled) as reason:
        _log.warning("the samples could not be read: %s", reason)
