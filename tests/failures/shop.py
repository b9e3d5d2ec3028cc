"""A shop of processes on one PostgreSQL: two servers, two workers and a gateway for each table."""

from __future__ import annotations

import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Final

import httpx

from knifetip.library import load
from knifetip.library.definition import Definition, Shelf
from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from tests.failures.clocks import Clocks
from tests.failures.network import Network, can_cut
from tests.failures.watched_table import TableThread
from tests.support.serving.postgresql import Cluster, create_database, installed_binaries

MACHINE: Final = "demo-table"
SERVERS: Final = ("server-0", "server-1")
WORKERS: Final = ("worker-0", "worker-1")


class Shop:
    """The processes of a shop; each can be killed, restarted, and have its clock stepped.

    Parameters
    ----------
    tables
        Number of tables with a gateway each.
    speed
        Speed of the simulated tables as a multiple of real ones.
    """

    def __init__(self, tables: int, speed: float) -> None:
        binaries = installed_binaries()
        assert binaries is not None, "PostgreSQL is not installed"
        self.folder = Path(tempfile.mkdtemp(prefix="knifetip-shop-"))
        self.folder.chmod(0o755)  # the user postgres reads its clock here
        self.clocks = Clocks(self.folder)
        self.cuts = can_cut()
        self.cluster = Cluster(binaries, self._environment("database"))
        self.key = secrets.token_urlsafe(24)
        (self.folder / "key").write_text(self.key)
        self.ports = {name: _free_port() for name in SERVERS}
        self.networks = [
            Network.make(number) if self.cuts else Network("") for number in range(tables)
        ]
        self.gateways = tuple(f"gateway-{number}" for number in range(tables))
        self.machines = tuple(_machine(number) for number in range(tables))
        model = load.machine(MACHINE)
        self.tables = [TableThread(model, net.controller, speed) for net in self.networks]
        self.processes: dict[str, subprocess.Popen[bytes]] = {}
        self.database = ""

    def __enter__(self) -> Shop:
        """Start the shop, and wait until it works."""
        self.cluster.start()
        self.database = create_database(self.cluster.url, "shop")
        store = Store(self.database)
        store.migrate()
        text = load.library_text(Shelf.MACHINES, MACHINE)
        for machine in self.machines[1:]:
            store.library.save(Definition(Shelf.MACHINES, machine, text=text), machine)
        (self.folder / "gateway_key").write_text(
            store.keys.add("gateways", [AccessScope.GATEWAY])[1]
        )
        store.close()
        for table in self.tables:
            table.open()
        for name in (*SERVERS, *WORKERS, *self.gateways):
            self.start(name)
        self.wait_until_ready()
        return self

    def __exit__(self, *_: object) -> None:
        """End everything."""
        for name in list(self.processes):
            self.kill(name)
        for table in self.tables:
            table.close()
        self.cluster.stop()
        self.cluster.delete()
        for network in self.networks:
            network.delete()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _environment(self, name: str) -> dict[str, str]:
        """Return the environment of a process whose clock can be stepped."""
        state = {"XDG_STATE_HOME": str(self.folder / "state"), "OMP_NUM_THREADS": "1"}
        return state | self.clocks.environment(name)

    def start(self, name: str) -> None:
        """Start a server, a worker or a gateway."""
        kind, _, number = name.partition("-")
        index = int(number)
        database = ["--database", self.database, "--name", name]
        inside: list[str] = []
        secret = "gateway_key" if kind == "gateway" else "key"
        key = ["--key-file", str(self.folder / secret)]
        if kind == "server":
            address = ["--host", "0.0.0.0", "--port", str(self.ports[name])]
            parts = ["--no-simulator", "--no-compiles", "--no-samples"]
            command = ["serve", *address, *database, *parts, *key]
        elif kind == "worker":
            command = ["worker", *database]
        else:
            network = self.networks[index]
            inside = network.inside
            port = self.ports[SERVERS[index % len(SERVERS)]]
            command = [
                *("gateway", "--server", f"http://{network.server}:{port}", "--name", name, *key),
                *("--machine", self.machines[index]),
                *("--controller", self.tables[index].address),
                *("--journal", str(self.folder / f"{name}.jsonl")),
            ]
        with (self.folder / f"{name}.log").open("ab") as log:
            self.processes[name] = subprocess.Popen(
                [*inside, sys.executable, "-m", "knifetip.cli", *command],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                env={**os.environ, **self._environment(name)},
                start_new_session=True,
            )

    def kill(self, name: str) -> None:
        """Kill a process and its children, as a power failure does."""
        process = self.processes.pop(name)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()

    def revive(self) -> None:
        """Start the processes that have ended by themselves, as a service manager does."""
        for name, process in list(self.processes.items()):
            if process.poll() is not None:
                self.start(name)

    def client(self, server: str) -> httpx.Client:
        """Return a client of one of the servers."""
        return httpx.Client(
            base_url=f"http://127.0.0.1:{self.ports[server]}",
            headers={"Authorization": f"Bearer {self.key}"},
            timeout=10.0,
            trust_env=False,
        )

    def wait_until_ready(self, seconds: float = 120.0) -> None:
        """Wait until both servers are ready."""
        end = time.monotonic() + seconds
        for server in SERVERS:
            with self.client(server) as client:
                while not _is_ready(client):
                    assert time.monotonic() < end, self.log(server)
                    self.revive()
                    time.sleep(0.1)

    def log(self, name: str) -> str:
        """Return the end of the log of a process."""
        return (self.folder / f"{name}.log").read_text(errors="replace")[-4000:]


def _is_ready(client: httpx.Client) -> bool:
    try:
        return client.get("/readyz").status_code == 200
    except httpx.HTTPError:
        return False


def _machine(number: int) -> str:
    return MACHINE if number == 0 else f"failing-table-{number}"


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])
