"""knifetip serve, worker, gateway and simulator: run the service or one of its parts."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
from collections.abc import Coroutine
from contextlib import closing, suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from knifetip import tracing
from knifetip.cli.access_key import KeyOptions
from knifetip.cli.options import expand
from knifetip.cli.terminal import print_message, print_stderr
from knifetip.errors import StaleVersion, StoreError
from knifetip.library import load
from knifetip.messages import Message
from knifetip.service.settings import (
    DatabaseSettings,
    ProcessSettings,
    Settings,
    WorkerSettings,
)

if TYPE_CHECKING:
    from knifetip.gateway.controller import Controller, Driver, SafeState

Host = Annotated[
    str, typer.Option(help="IP address or host name to listen on; 0.0.0.0 for all networks.")
]
MachineName = Annotated[str, typer.Option("--machine", help="Name of a machine of the library.")]
Speed = Annotated[
    float,
    typer.Option(
        min=0.01, max=100_000.0, help="Speed of the simulated machine as a multiple of real time."
    ),
]

#: Exit code of a process that SIGTERM has ended.
_TERMINATED = 143

#: How often a worker is looked after, and the time without a sweep after which it is stuck (s).
_LOOK, _STUCK = 10.0, 300.0

Migrate = Annotated[
    bool,
    typer.Option(
        "--migrate",
        help="Migrate the tables of an older PostgreSQL database; those of an SQLite database are "
        "always migrated. No other server may be running.",
    ),
]


def serve(migrate: Migrate = False, *, settings: Settings) -> None:
    """Run the server with its page, a compile worker and a simulated machine.

    All parts run until Ctrl-C.
    """
    from knifetip.server import embedded  # imported here: takes a second

    settings.configure_log()
    _prepare(settings, migrate)
    with tracing.exporting("knifetip-server"):
        embedded.serve(settings, print_stderr)


def _prepare(storage: DatabaseSettings, migrate: bool) -> None:
    """Make the tables of a database ready, and print what was migrated."""
    from knifetip.cli.database import describe_migration
    from knifetip.service.store import Store

    with closing(Store(storage.url)) as store:
        done = store.prepare(migrate=migrate)
    if done is not None and done.before:
        print_message(describe_migration(done))


def worker(migrate: Migrate = False, *, settings: WorkerSettings) -> None:
    """Run a compile worker for a database until Ctrl-C."""
    from knifetip.metrics_server import serve_metrics
    from knifetip.service.compiling.service import CompileService
    from knifetip.service.monitoring.metrics import CompileMetrics, add_worker
    from knifetip.service.processes.pool import ProcessPool
    from knifetip.service.processes.tasks import import_stages
    from knifetip.service.store import Store

    settings.configure_log()
    _prepare(settings, migrate)
    store = Store(settings.url, objects=settings.store)
    metrics = CompileMetrics()
    service = CompileService(
        store,
        ProcessPool(settings.processes, prepare=import_stages, spare=1),
        settings.name,
        True,
        settings.processes,
        gateways=False,
        observe=metrics.observe_stage,
        observe_compile=metrics.compiles.observe,
    )
    add_worker(metrics, service)
    scraped = serve_metrics(settings.metrics_address, metrics.registry)
    stop_requested = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda _number, _frame: stop_requested.set())
    with tracing.exporting("knifetip-worker"):
        service.start()
        print_message(Message("output.worker", database=settings.shown))
        while not stop_requested.wait(_LOOK):
            silent = service.seconds_since_sweep or 0.0
            if silent > _STUCK:
                print_message(Message("output.worker-stuck", seconds=silent))
                os._exit(1)  # its threads would not end
        service.stop()
    scraped.close()
    store.close()


def gateway(
    server: Annotated[
        str, typer.Option(help="URL of the knifetip server.")
    ] = "http://127.0.0.1:8080",
    machine: Annotated[
        str,
        typer.Option(
            help="Name of a machine of the library or of the server, or path of its TOML file."
        ),
    ] = "demo-table",
    controller: Annotated[
        str,
        typer.Option(
            help="Address of the controller: HOST:PORT, tcp://HOST:PORT, telnet://HOST, "
            "ws://HOST:PORT/PATH, a serial port as serial:///dev/ttyUSB0 or serial://COM3, or a "
            "folder from which the machine takes its programs as file:///FOLDER."
        ),
    ] = "127.0.0.1:2323",
    name: Annotated[
        str, typer.Option(help="Name of this gateway, which the server shows.")
    ] = "gateway",
    journal: Annotated[
        Path | None,
        typer.Option(
            help="File that records the program lines sent and executed, so that the gateway can "
            "report them after a power failure. Default: a file for this machine and server in "
            "~/.local/state/knifetip."
        ),
    ] = None,
    *,
    access: KeyOptions,
    process: ProcessSettings,
) -> None:
    """Fetch the jobs of a machine from the server and send them to its controller.

    Ctrl-C or SIGTERM stops the machine, then the gateway.  An address at which there can be no
    controller ends it at once; a controller that is switched off is waited for.
    """
    process.configure_log()
    from knifetip.cli.served_machine import reload_machine, start_machine
    from knifetip.gateway import claim
    from knifetip.gateway.hot_folder import find_driver
    from knifetip.gateway.job_server import GatewaySettings
    from knifetip.gateway.journal import default_path
    from knifetip.gateway.metrics import RunMetrics
    from knifetip.logs import hide
    from knifetip.metrics_server import serve_metrics

    headers = access.headers
    hide(headers.get("Authorization", "").removeprefix("Bearer "))
    record = journal or default_path(machine, server)
    kept = record.with_name(f"{record.name}.machine.json")
    served = start_machine(machine, server, headers, kept)
    metrics = RunMetrics(served.name)
    serve_metrics(process.metrics_address, metrics.registry)  # until the process ends
    with tracing.exporting("knifetip-gateway"):
        while True:
            dial = find_driver(served, controller)
            address = {"controller": controller, "server": server}
            print_message(Message("output.gateway", title=served.title, **address))
            settings = GatewaySettings(
                server, served, name, headers=headers, journal=record, observe=metrics.observe
            )
            connect = partial(_connect, dial, controller)
            try:
                _run_until_terminated(claim.run_gateway(settings, connect))
            except StaleVersion as changed:
                # No job is on the machine: the next one is made for the newest version.
                print_message(changed.message)
                served = reload_machine(machine, server, headers, kept)


def _connect(
    dial: Driver, address: str, safe: SafeState, stop_motion: bool
) -> Coroutine[Any, Any, Controller]:
    return dial(address, safe, stop_motion=stop_motion)


def _run_until_terminated(work: Coroutine[Any, Any, None]) -> None:
    """Run a coroutine until it ends; SIGTERM cancels it, as Ctrl-C does."""

    async def run() -> None:
        task = asyncio.create_task(work)
        with suppress(NotImplementedError):  # on Windows
            asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, task.cancel)
        await task

    try:
        asyncio.run(run())
    except asyncio.CancelledError:
        raise typer.Exit(_TERMINATED) from None


def simulator(
    host: Host = "127.0.0.1",
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="TCP port to listen on; 0 chooses a free port.")
    ] = 2323,
    machine: MachineName = "demo-table",
    speed: Speed = 1.0,
) -> None:
    """Run a simulated controller, to try programs without a machine."""
    from knifetip.simulators import serving

    try:
        serving.run(
            load.machine(machine),
            host,
            port,
            speed=speed,
            on_ready=lambda server: print_message(
                Message("output.listening", address=server.address)
            ),
        )
    except OSError as reason:
        raise StoreError(
            "server.address-in-use", host=host, port=port, reason=reason.strerror or reason
        ) from reason


def register(app: typer.Typer) -> None:
    """Add ``serve``, ``worker``, ``gateway`` and ``simulator`` to a Typer application."""
    for command in (serve, worker, gateway, simulator):
        app.command()(expand(command))
