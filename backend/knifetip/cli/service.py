"""knifetip serve, worker, gateway and simulator: run the service or one of its parts."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
from collections.abc import Coroutine
from contextlib import closing, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from knifetip import tracing
from knifetip.cli.access_key import KeyOptions
from knifetip.cli.database_options import DatabaseOptions, StoreOptions
from knifetip.cli.log_options import LogOptions
from knifetip.cli.metrics_options import MetricsOptions
from knifetip.cli.oidc_options import OidcOptions
from knifetip.cli.options import expand
from knifetip.cli.terminal import print_stderr
from knifetip.errors import StaleVersion, StoreError
from knifetip.library import load

if TYPE_CHECKING:
    from knifetip.gateway.controller import Controller, Driver, SafeState

Host = Annotated[
    str, typer.Option(help="IP address or host name to listen on; 0.0.0.0 for all networks.")
]
Name = Annotated[
    str,
    typer.Option(
        envvar="KNIFETIP_NAME",
        help="Name of this process among those of the database; give the same name after a "
        "restart. Default: the name of the computer and a stored random suffix.",
    ),
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

#: All clients together may have so many times as many connections and listeners as one.
_CLIENTS = 8

Migrate = Annotated[
    bool,
    typer.Option(
        "--migrate",
        help="Migrate the tables of an older PostgreSQL database; those of an SQLite database are "
        "always migrated. No other server may be running.",
    ),
]


@dataclass(frozen=True, slots=True)
class PartOptions:
    """Options of the command ``knifetip serve`` that select optional tasks of the server process.

    The options state whether the process compiles jobs, whether it runs a simulated machine and at
    which speed, whether it adds the sample drawings to a new database, and when it deletes jobs.
    """

    speed: Speed = 1.0
    samples: Annotated[bool, typer.Option(help="Add the sample drawings to a new database.")] = True
    simulator: Annotated[
        bool, typer.Option(help="Also run a simulated machine with its gateway.")
    ] = True
    compiles: Annotated[
        bool,
        typer.Option(
            help="Compile jobs in this process. With --no-compiles, the command `knifetip worker` "
            "must run in another process."
        ),
    ] = True
    keep_history: Annotated[
        int,
        typer.Option(
            "--keep-jobs",
            "--keep-history",
            min=0,
            max=100_000,
            envvar=["KNIFETIP_KEEP_JOBS", "KNIFETIP_KEEP_HISTORY"],
            help="Days after which ended jobs are deleted; events, statistics and the use of tools "
            "remain. 0 keeps all jobs.",
        ),
    ] = 0
    keep_drawings: Annotated[
        int,
        typer.Option(
            min=0,
            max=100_000,
            envvar="KNIFETIP_KEEP_DRAWINGS",
            help="Days after their upload after which drawings without jobs are deleted. 0 keeps "
            "all drawings.",
        ),
    ] = 0
    archive: Annotated[
        Path | None,
        typer.Option(
            envvar="KNIFETIP_ARCHIVE",
            help="Folder in which a zip file of each job and each drawing is written before it is "
            "deleted.",
        ),
    ] = None
    webhook_private: Annotated[
        bool,
        typer.Option(
            envvar="KNIFETIP_WEBHOOK_PRIVATE",
            help="Permit webhooks to loopback and private addresses, where the ERP system of a "
            "shop usually is.",
        ),
    ] = True


@dataclass(frozen=True, slots=True)
class AccessOptions:
    """Options of the command ``knifetip serve`` for requests from other computers.

    The options state the key that such requests must send, and the permitted Host headers.
    """

    key: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_KEY",
            help="Access key that requests from other computers must send. Default: no key; the "
            "server then accepts only requests from this computer.",
        ),
    ] = ""
    key_file: Annotated[
        Path | None,
        typer.Option(
            envvar="KNIFETIP_KEY_FILE",
            help="File that contains the access key. If the file does not "
            "exist, the server creates "
            "it with a random key.",
        ),
    ] = None
    allow_host: Annotated[
        list[str] | None,
        typer.Option(
            envvar="KNIFETIP_ALLOW_HOST",
            help="NAME or NAME:PORT that the Host header may contain besides the server's "
            "addresses; may be repeated.",
        ),
    ] = None


@dataclass(frozen=True, slots=True)
class LimitOptions:
    """Options of the command ``knifetip serve`` for the limits of clients.

    A client is a user, an API key, or an address that sends requests without either.
    """

    max_rate: Annotated[
        int,
        typer.Option(
            min=0,
            max=100_000,
            envvar="KNIFETIP_MAX_RATE",
            help="Requests of a client in a second on average; 0 for no limit. Requests of "
            "gateways are not limited.",
        ),
    ] = 200
    max_burst: Annotated[
        int,
        typer.Option(
            min=1,
            max=1_000_000,
            envvar="KNIFETIP_MAX_BURST",
            help="Requests that a client may send at once after a pause.",
        ),
    ] = 2000
    max_listeners: Annotated[
        int,
        typer.Option(
            min=1,
            max=100_000,
            envvar="KNIFETIP_MAX_LISTENERS",
            help="Open pages and other streams of events of a client; all clients together may "
            "have eight times as many.",
        ),
    ] = 64
    max_connections: Annotated[
        int,
        typer.Option(
            min=1,
            max=100_000,
            envvar="KNIFETIP_MAX_CONNECTIONS",
            help="Connections of an address; all addresses together may have eight times as many. "
            "Behind a proxy, all clients have its address.",
        ),
    ] = 256
    max_upload: Annotated[
        int,
        typer.Option(
            min=1,
            max=1024,
            envvar="KNIFETIP_MAX_UPLOAD",
            help="Largest drawing that can be uploaded (MB).",
        ),
    ] = 64
    min_free: Annotated[
        int,
        typer.Option(
            min=0,
            max=1_000_000,
            envvar="KNIFETIP_MIN_FREE",
            help="Space that is kept free on the disk for running jobs (MB): with less, uploads "
            "and orders are refused, and /readyz reports it.",
        ),
    ] = 256


def serve(
    host: Host = "127.0.0.1",
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="TCP port to listen on; 0 chooses a free port.")
    ] = 8080,
    migrate: Migrate = False,
    name: Name = "",
    *,
    storage: DatabaseOptions,
    contents: StoreOptions,
    parts: PartOptions,
    access: AccessOptions,
    oidc: OidcOptions,
    limits: LimitOptions,
    scraping: MetricsOptions,
    log: LogOptions,
) -> None:
    """Run the server with its page, a compile worker and a simulated machine.

    All parts run until Ctrl-C.
    """
    from knifetip.api import embedded  # imported here: takes a second
    from knifetip.api.client_limits import ClientLimits
    from knifetip.api.connections import ConnectionLimits

    log.apply()
    _prepare(storage, migrate)
    with tracing.exporting("knifetip-server"):
        embedded.serve(
            host,
            port,
            storage.url,
            embedded.Parts(
                parts.samples,
                parts.simulator,
                parts.speed,
                parts.compiles,
                parts.keep_history,
                parts.webhook_private,
                parts.keep_drawings,
                parts.archive,
            ),
            embedded.Access(
                access.key, access.key_file, tuple(access.allow_host or ()), oidc.settings()
            ),
            print_stderr,
            name,
            embedded.ServerLimits(
                ConnectionLimits(
                    per_client=limits.max_connections, total=_CLIENTS * limits.max_connections
                ),
                ClientLimits(
                    limits.max_rate,
                    limits.max_burst,
                    limits.max_listeners,
                    _CLIENTS * limits.max_listeners,
                ),
                limits.max_upload << 20,
                limits.min_free << 20,
            ),
            contents.store,
            scraping.metrics_address,
        )


def _prepare(storage: DatabaseOptions, migrate: bool) -> None:
    """Make the tables of a database ready, and print what was migrated."""
    from knifetip.cli.database import describe_migration
    from knifetip.jobs.store import Store

    with closing(Store(storage.url)) as store:
        done = store.prepare(migrate=migrate)
    if done is not None and done.before:
        print_stderr(describe_migration(done))


def worker(
    name: Name = "",
    processes: Annotated[
        int, typer.Option(min=1, max=64, help="Number of jobs to compile at the same time.")
    ] = 1,
    migrate: Migrate = False,
    *,
    storage: DatabaseOptions,
    contents: StoreOptions,
    scraping: MetricsOptions,
    log: LogOptions,
) -> None:
    """Run a compile worker for a database until Ctrl-C."""
    from knifetip.jobs.compile_service import CompileService
    from knifetip.jobs.metrics import CompileMetrics, add_worker
    from knifetip.jobs.process_pool import ProcessPool
    from knifetip.jobs.store import Store
    from knifetip.jobs.tasks import import_stages
    from knifetip.metrics_server import serve_metrics

    log.apply()
    _prepare(storage, migrate)
    store = Store(storage.url, objects=contents.store)
    metrics = CompileMetrics()
    service = CompileService(
        store,
        ProcessPool(processes, prepare=import_stages, spare=1),
        name,
        True,
        processes,
        gateways=False,
        observe=metrics.observe_stage,
        observe_compile=metrics.compiles.observe,
    )
    add_worker(metrics, service)
    scraped = serve_metrics(scraping.metrics_address, metrics.registry)
    stop_requested = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda _number, _frame: stop_requested.set())
    with tracing.exporting("knifetip-worker"):
        service.start()
        print_stderr(f"compile worker for {storage.shown}")
        while not stop_requested.wait(_LOOK):
            silent = service.seconds_since_sweep or 0.0
            if silent > _STUCK:
                print_stderr(
                    f"ERROR: this worker is stuck: no sweep for {silent:.0f} s. It ends with an "
                    "error, so that systemd or the container engine starts it again."
                )
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
    scraping: MetricsOptions,
    log: LogOptions,
) -> None:
    """Fetch the jobs of a machine from the server and send them to its controller.

    Ctrl-C or SIGTERM stops the machine, then the gateway.  An address at which there can be no
    controller ends it at once; a controller that is switched off is waited for.
    """
    log.apply()
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
    table = start_machine(machine, server, headers, kept)
    metrics = RunMetrics(table.name)
    serve_metrics(scraping.metrics_address, metrics.registry)  # until the process ends
    with tracing.exporting("knifetip-gateway"):
        while True:
            dial = find_driver(table, controller)
            print_stderr(f"{table.title}: controller {controller}, server {server}")
            settings = GatewaySettings(
                server, table, name, headers=headers, journal=record, observe=metrics.observe
            )
            connect = partial(_connect, dial, controller)
            try:
                _run_until_terminated(claim.run_gateway(settings, connect))
            except StaleVersion as changed:
                # No job is on the machine: the next one is made for the newest version.
                print_stderr(str(changed))
                table = reload_machine(machine, server, headers, kept)


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
    from knifetip.gateway import simulator as table

    try:
        table.run(
            load.machine(machine),
            host,
            port,
            speed=speed,
            on_ready=lambda server: print_stderr(f"listening on {server.address}"),
        )
    except OSError as reason:
        raise StoreError(
            "server.address-in-use", host=host, port=port, reason=reason.strerror or reason
        ) from reason


def register(app: typer.Typer) -> None:
    """Add ``serve``, ``worker``, ``gateway`` and ``simulator`` to a Typer application."""
    for command in (serve, worker, gateway, simulator):
        app.command()(expand(command))
