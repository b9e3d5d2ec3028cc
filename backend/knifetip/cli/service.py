"""knifetip serve, worker, gateway and simulator: the service, whole or in its parts."""

from __future__ import annotations

import asyncio
import signal
import threading
from pathlib import Path
from typing import Annotated

import typer

from knifetip.cli.terminal import print_stderr
from knifetip.errors import StoreError
from knifetip.library import load

Database = Annotated[str, typer.Option(help="SQLite or PostgreSQL, as an SQLAlchemy URL.")]
Host = Annotated[str, typer.Option(help="Address to listen on.")]
MachineName = Annotated[str, typer.Option("--machine", help="Machine of the library.")]
Speed = Annotated[
    float, typer.Option(min=0.01, max=100_000.0, help="How much faster than life the table moves.")
]

DATABASE = "sqlite:///knifetip.sqlite"


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""

    @app.command()
    def serve(
        host: Host = "127.0.0.1",
        port: Annotated[int, typer.Option(min=0, max=65535)] = 8080,
        database: Database = DATABASE,
        speed: Speed = 1.0,
        samples: Annotated[bool, typer.Option(help="Load the samples into a new database.")] = True,
        simulator: Annotated[
            bool, typer.Option(help="Put a gateway and a simulated table beside the server.")
        ] = True,
        compiles: Annotated[
            bool, typer.Option(help="Compile in this process; else in `knifetip worker`.")
        ] = True,
        key: Annotated[
            str,
            typer.Option(
                envvar="KNIFETIP_KEY", help="Key that requests from other machines must have."
            ),
        ] = "",
        key_file: Annotated[
            Path | None,
            typer.Option(
                envvar="KNIFETIP_KEY_FILE",
                help="File of the key; made with a random key if it does not exist.",
            ),
        ] = None,
        allow_host: Annotated[
            list[str] | None,
            typer.Option(
                envvar="KNIFETIP_ALLOW_HOST",
                help="NAME or NAME:PORT by which requests may name this server besides its "
                "addresses; may be repeated.",
            ),
        ] = None,
    ) -> None:
        """Serve the page and the API, with everything embedded, until Ctrl-C."""
        from knifetip.api import embedded  # a second of imports that the other commands spare

        embedded.serve(
            host,
            port,
            database,
            samples=samples,
            simulator=simulator,
            speed=speed,
            compiles=compiles,
            key=key,
            key_file=key_file,
            hosts=tuple(allow_host or ()),
            told=print_stderr,
        )

    @app.command()
    def worker(
        database: Database = DATABASE,
        name: Annotated[str, typer.Option(help="Stable over restarts; else the host's.")] = "",
        processes: Annotated[int, typer.Option(min=1, max=64)] = 1,
    ) -> None:
        """Compile the jobs of a database until Ctrl-C."""
        from knifetip.jobs.compile_service import CompileService
        from knifetip.jobs.process_pool import ProcessPool
        from knifetip.jobs.store import Store

        store = Store(database)
        store.migrate()
        service = CompileService(
            store, ProcessPool(processes), name, True, processes, gateways=False
        )
        stopping = threading.Event()
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda _number, _frame: stopping.set())
        service.start()
        print_stderr(f"compiling for {database}")
        stopping.wait()
        service.stop()
        store.close()

    @app.command()
    def gateway(
        server: Annotated[str, typer.Option(help="URL of the server.")] = "http://127.0.0.1:8080",
        machine: MachineName = "demo-table",
        controller: Annotated[
            str, typer.Option(help="HOST:PORT of the controller.")
        ] = "127.0.0.1:2323",
        name: Annotated[str, typer.Option(help="The name under which it is seen.")] = "gateway",
        journal: Annotated[
            Path | None, typer.Option(help="File of what was sent and executed.")
        ] = None,
        key: Annotated[
            str, typer.Option(envvar="KNIFETIP_KEY", help="Key for the server, where it asks one.")
        ] = "",
    ) -> None:
        """Claim the jobs of a machine and stream them to its controller."""
        from knifetip.gateway import claim
        from knifetip.languages.registry import find_language

        table = load.machine(machine)
        dial = find_language(table.dialect).dial()
        print_stderr(f"{table.title}: {controller}, work from {server}")
        headers = {"Authorization": f"Bearer {key}"} if key else {}
        asyncio.run(
            claim.work(
                server,
                table,
                name,
                lambda safe, stop_motion: dial(controller, safe, stop_motion=stop_motion),
                headers=headers,
                journal=journal,
            )
        )

    @app.command()
    def simulator(
        host: Host = "127.0.0.1",
        port: Annotated[int, typer.Option(min=0, max=65535)] = 2323,
        machine: MachineName = "demo-table",
        speed: Speed = 1.0,
    ) -> None:
        """Be a table: listen where a controller would, and move as it would."""
        from knifetip.gateway import simulator as table

        try:
            table.run(
                load.machine(machine),
                host,
                port,
                speed=speed,
                ready=lambda server: print_stderr(f"listening on {server.address}"),
            )
        except OSError as reason:
            raise StoreError(
                "server.address-in-use", host=host, port=port, reason=reason.strerror or reason
            ) from reason
