"""How many orders a second does a server store, beside two inserted rows behind FastAPI?

    python -m tests.benchmarks.orders [--orders 1000] [--clients 50] [--compiles 40]

Sends orders of one stored drawing by many clients at the same time, in SQLite and PostgreSQL, to
knifetip and before and after that to ``bare_orders``.  With PostgreSQL it then compiles orders of
different drawings with one worker and with two.
"""

from __future__ import annotations

import argparse
import asyncio
import tempfile
import time
from contextlib import ExitStack
from itertools import pairwise
from pathlib import Path

import httpx
from rich.console import Console
from rich.table import Table

from tests.benchmarks.service_process import (
    free_port,
    percentile,
    post_orders,
    run_knifetip,
    run_process,
    wait_until_ready,
)
from tests.support.serving.postgresql import create_database, installed_binaries, run_server
from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text

CHOICES = {"machine": "demo-table", "board": "e-flute"}


def measure_orders(database: str, bare_database: str, orders: int, clients: int) -> list[str]:
    """Return a row of the table: rates, ratio and percentiles for one kind of database."""
    port = free_port()
    with (
        run_process("tests.benchmarks.bare_orders", bare_database, port),
        run_knifetip(database) as url,
    ):
        bare = wait_until_ready(f"http://127.0.0.1:{port}")
        with httpx.Client(base_url=url, timeout=120.0, trust_env=False) as client:
            body = {**CHOICES, "drawing": upload_drawing(client, square(), unit="mm")["id"]}
        asyncio.run(post_orders(url, body, clients, clients))  # warm
        before = asyncio.run(post_orders(bare, body, orders, clients))[2]
        took, statuses, rate = asyncio.run(post_orders(url, body, orders, clients))
        after = asyncio.run(post_orders(bare, body, orders, clients))[2]
    peers = (before + after) / 2.0
    middle, last = percentile(took, 0.5), percentile(took, 0.99)
    answered = f"{statuses[201]} of {orders}"
    figures = [f"{rate:.0f}", f"{peers:.0f}", f"{peers / rate:.2f}", f"{middle:.0f}", f"{last:.0f}"]
    return [database.partition(":")[0].partition("+")[0], answered, *figures]


def nested(side: float) -> bytes:
    """Return a DXF file with 625 squares (side in mm); its compile takes longer than its order."""
    return dxf_text.dxf(
        *(
            dxf_text.line(x + x1, y + y1, x + x2, y + y2, (8, "CUT"))
            for x in range(0, 1000, 40)
            for y in range(0, 1000, 40)
            for (x1, y1), (x2, y2) in pairwise(
                ((0.0, 0.0), (side, 0.0), (side, side), (0.0, side), (0.0, 0.0))
            )
        ),
        units=4,
    )


def compile_rate(database: str, workers: int, count: int) -> float:
    """Return how many different drawings of 2,500 edges are compiled per second."""
    with ExitStack() as running:
        url = running.enter_context(run_knifetip(database))
        with httpx.Client(base_url=url, timeout=120.0, trust_env=False) as client:
            drawings = [
                upload_drawing(client, nested(20.0 + 0.01 * number), unit="mm")
                for number in range(count + workers)
            ]
            for number in range(workers):
                name = f"worker-{number}"
                running.enter_context(
                    run_process("knifetip.cli", "worker", "--database", database, "--name", name)
                )
            # Each worker compiles one job first, to load its code.
            _compile(client, [drawing["id"] for drawing in drawings[:workers]])
            began = time.monotonic()
            _compile(client, [drawing["id"] for drawing in drawings[workers:]])
            return count / (time.monotonic() - began)


def _compile(client: httpx.Client, drawings: list[str]) -> None:
    """Order jobs and wait until all are compiled; none may be refused."""
    jobs = [
        client.post("/api/jobs", json={**CHOICES, "drawing": drawing}).raise_for_status().json()
        for drawing in drawings
    ]
    waiting = "/api/jobs?state=received&state=compiling&limit=1"
    while client.get(waiting).raise_for_status().json():
        time.sleep(0.05)
    for job in jobs:
        found = client.get(f"/api/jobs/{job['id']}").raise_for_status().json()
        assert found["state"] == "ready", found
        assert not found["program_of"], "it was answered with the program of another job"


def main() -> None:
    """Measure and print tables."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--orders", type=int, default=1000)
    options.add_argument("--clients", type=int, default=50)
    options.add_argument("--compiles", type=int, default=40)
    given = options.parse_args()
    console = Console(width=110)
    table = Table("database", "201", "orders/s", "bare/s", "ratio", "p50 (ms)", "p99 (ms)")
    binaries = installed_binaries()
    with tempfile.TemporaryDirectory() as folder:
        shop, bare = (f"sqlite:///{Path(folder) / name}.sqlite" for name in ("shop", "bare"))
        table.add_row(*measure_orders(shop, bare, given.orders, given.clients))
    rates = []
    if binaries is not None:
        with run_server(binaries) as server:
            urls = [create_database(server, name) for name in ("shop", "bare", "one", "two")]
            table.add_row(*measure_orders(urls[0], urls[1], given.orders, given.clients))
            rates = [compile_rate(urls[1 + n], n, given.compiles) for n in (1, 2)]
    console.print(table)
    for number, rate in enumerate(rates, 1):
        console.print(f"{rate:.2f} jobs compiled per second by {number} worker(s)")


if __name__ == "__main__":
    main()
