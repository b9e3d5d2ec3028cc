"""A thousand gateways with running jobs, in an empty database and after a million jobs.

    python -m tests.benchmarks.fleet [--jobs 1000000] [--gateways 1000] [--period 8] [--seconds 60]

Runs a server on PostgreSQL for an empty and for a full database in turn, twice each.  Every gateway
sends a heartbeat in each period, without a table; beside them orders are sent, and claimed by one
more gateway.  Prints the durations of heartbeats, orders and claims.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import re
import time
from collections import defaultdict
from typing import Any
from urllib.parse import urlsplit

import httpx
import sqlalchemy as sa
from rich.console import Console
from rich.table import Table

from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.store import Store
from tests.benchmarks.service_process import percentile, run_knifetip
from tests.support.history import complete_job, fill
from tests.support.job_states import RESULT, confirm, execute, queued
from tests.support.serving.postgresql import create_database, installed_binaries, run_server
from tests.support.serving.server import square

Times = dict[str, list[float]]


def run_gateways(store: Store, count: int) -> list[dict[str, Any]]:
    """Run a job on each of so many machines; return the bodies of their heartbeats."""
    bodies = []
    for number in range(count):
        machine = f"fleet-{number}"
        queued(store, machine=machine)
        job = store.gateways.claim(machine, "gateway", manual=False)
        assert job is not None
        bodies.append({"job": job.id, "epoch": job.epoch, "line": 1})
    return bodies


def settle(store: Store) -> None:
    """Do now what the database would else do in the background, during a measurement."""
    engine = sa.create_engine(store.database.url, isolation_level="AUTOCOMMIT")
    with engine.connect() as connection:
        for statement in ("VACUUM ANALYZE", "CHECKPOINT"):
            connection.execute(sa.text(statement))
    engine.dispose()


async def post(client: httpx.AsyncClient, path: str, body: Any, times: list[float]) -> Any:
    """Send a request and record its duration; return the JSON of the answer."""
    began = time.perf_counter()
    answer = await client.post(path, json=body, timeout=60.0)
    times.append(time.perf_counter() - began)
    assert answer.status_code in (200, 201), answer.text[:300]
    return answer.json()


async def beat(url: str, body: dict[str, Any], phase: float, period: float, times: Times) -> None:
    """Send heartbeats of one gateway, the first one after ``phase`` seconds.

    A thousand clients of httpx would take more of the processors than the server.
    """
    host, port = urlsplit(url).hostname, urlsplit(url).port
    content = json.dumps(body).encode()
    head = (
        f"POST /api/gateway/heartbeat HTTP/1.1\r\nHost: {host}:{port}\r\n"
        "X-Knifetip: fleet\r\nContent-Type: application/json\r\n"
        f"Content-Length: {len(content)}\r\n\r\n"
    )
    due = time.monotonic() + phase
    await asyncio.sleep(phase)
    reader, writer = await asyncio.open_connection(host, port)
    try:
        while True:
            await asyncio.sleep(max(due - time.monotonic(), 0.0))
            began = time.perf_counter()
            writer.write(head.encode() + content)
            answered = await reader.readuntil(b"\r\n\r\n")
            length = re.search(rb"(?i)content-length: *([0-9]+)", answered)
            answer = await reader.readexactly(int(length[1]) if length else 0)
            times["heartbeat"].append(time.perf_counter() - began)
            assert json.loads(answer).get("command") == "continue", answer[:300]
            due += period
    finally:
        writer.close()


async def work(
    store: Store, client: httpx.AsyncClient, order: Any, seconds: float, times: Times
) -> None:
    """Order, claim and finish one job after another for some time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        made = await post(client, "/api/jobs", order, times["order"])
        # The compile is not measured: its result is stored at once.
        taken = await asyncio.to_thread(store.compiles.begin, "worker")
        assert taken is not None
        await asyncio.to_thread(store.compiles.save_result, taken.id, taken.epoch, RESULT)
        ask = {"gateway": "g", "machine": order["machine"], "wait": 10.0}
        job = await post(client, "/api/gateway/claim", ask, times["claim"])
        assert job["job"] == made["id"], (job, made)
        await asyncio.to_thread(confirm, store, job["job"])
        started = GatewayReport(line=0, waiting=True)
        await asyncio.to_thread(store.gateways.heartbeat, job["job"], job["epoch"], started)
        await asyncio.to_thread(store.gateways.finish, job["job"], job["epoch"], "done")


async def load(
    store: Store, url: str, bodies: list[dict[str, Any]], period: float, seconds: float
) -> Times:
    """Run gateways and orders for some time; return the durations by request (s)."""
    times: Times = defaultdict(list)
    async with httpx.AsyncClient(base_url=url, trust_env=False, timeout=60.0) as erp:
        files = {"file": ("a.dxf", square())}
        sent = await erp.post("/api/drawings", files=files, data={"unit": "mm"})
        order: dict[str, Any] = {
            "drawing": sent.json()["id"],
            "machine": "demo-table",
            "board": "e-flute",
        }
        running = [
            asyncio.create_task(beat(url, body, period * number / len(bodies), period, times))
            for number, body in enumerate(bodies)
        ]
        order |= {"drawing": sent.json()["id"], "release": True}
        running.append(asyncio.create_task(work(store, erp, order, seconds, times)))
        # Heartbeats end only by a failure.
        done, _ = await asyncio.wait(running, return_when="FIRST_COMPLETED")
        for task in running:
            task.cancel()
        await asyncio.gather(*running, return_exceptions=True)
        for task in done:
            task.result()
    return times


def measure(urls: list[str], given: argparse.Namespace) -> None:
    """Fill one of two databases, load both in turn, and print a table."""
    console = Console(width=110)
    stores = [Store(url) for url in urls]
    for store in stores:
        store.migrate()
    began = time.monotonic()
    complete_job(stores[0])
    fill(stores[1], given.jobs)
    bodies = [run_gateways(store, given.gateways) for store in stores]
    for store in stores:
        settle(store)
    console.print(f"{given.jobs:,} jobs in {time.monotonic() - began:.0f} s", highlight=False)
    times: list[Times] = [defaultdict(list), defaultdict(list)]
    for _ in range(2):
        for store, url, own, found in zip(stores, urls, bodies, times, strict=True):
            # No heartbeats were sent while the other database was measured; a starting server would
            # take these jobs for interrupted ones.
            lease = "UPDATE job SET lease = extract(epoch FROM clock_timestamp()) + 120"
            execute(store, f"{lease} WHERE state = 'running'")
            with run_knifetip(url) as server:
                took = asyncio.run(load(store, server, own, given.period, given.seconds))
            for name, values in took.items():
                found[name] += values
    title = f"{given.gateways} gateways, a heartbeat in {given.period} s"
    full = f"{given.jobs:,}"
    table = Table("ms", "empty n", "p50", "p99", f"{full} n", "p50", "p99", title=title)
    for name in times[0]:
        cells = []
        for found in times:
            figures = (percentile(found[name], share) for share in (0.5, 0.99))
            cells += [f"{len(found[name])}", *(f"{figure:.1f}" for figure in figures)]
        table.add_row(name, *cells)
    console.print(table)
    for store in stores:
        store.close()


def main() -> None:
    """Measure on a PostgreSQL server of its own."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--jobs", type=int, default=1_000_000)
    options.add_argument("--gateways", type=int, default=1000)
    options.add_argument("--period", type=float, default=8.0)
    options.add_argument("--seconds", type=float, default=60.0)
    given = options.parse_args()
    binaries = installed_binaries()
    assert binaries is not None, "PostgreSQL is not installed"
    with run_server(binaries) as server:
        measure([create_database(server, name) for name in ("empty", "full")], given)


if __name__ == "__main__":
    main()
