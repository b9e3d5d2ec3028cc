"""Does a step of the queue take longer after a million jobs than in an empty database?

    python -m tests.benchmarks.history [--jobs 1000000] [--rounds 200] [--database postgresql]

Fills one database with ended jobs, their events and runs, and leaves another empty.  Then each
round does every step in both, one after the other.  Prints the 50th and 99th percentile of each
step in ms, the greatest ratio first, and with PostgreSQL the statements whose plan reads a whole
table.
"""

from __future__ import annotations

import argparse
import re
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

import sqlalchemy as sa
from rich.console import Console
from rich.table import Table

from knifetip.contract.job import State
from knifetip.library import load
from knifetip.model.interpretation import Interpretation
from knifetip.model.stage import Stage
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.history.store import HistoryFilter
from knifetip.service.machines.waiting import waiting_of
from knifetip.service.orders.store import JobOrder
from knifetip.service.store import Store
from tests.support.history import complete_job, fill
from tests.support.job_states import (
    RESULT,
    confirm,
    drawing,
)
from tests.support.serving.postgresql import create_database, installed_binaries, run_server

_ORDER = JobOrder("demo-table", "e-flute", Interpretation("mm"), release=True)
_ACTIVE = ("compiling", "running", "held")

Times = dict[str, list[float]]


def run_round(store: Store, times: Times) -> None:
    """Do every step of the queue once and record its duration (s)."""

    @contextmanager
    def step(name: str) -> Iterator[None]:
        began = time.perf_counter()
        yield
        times[name].append(time.perf_counter() - began)

    made = drawing(store)
    with step("submit"):
        job = store.jobs.add(made, _ORDER)
    with step("take for a compile"):
        taken = store.compiles.begin("worker")
    assert taken is not None
    with step("progress of a compile"):
        store.compiles.report_progress(taken.id, taken.epoch, Stage.PLAN, 0.5)
    with step("store a result"):
        store.compiles.save_result(job.id, taken.epoch, RESULT)
    with step("list of the queue"):
        describe(store, store.jobs.search((State.QUEUED.value,), limit=100))
    with step("claim"):
        claimed = store.gateways.claim("demo-table", "gateway", manual=True)
    assert claimed is not None
    if claimed.state == State.QUEUED:
        with step("confirm"):
            confirm(store, claimed.id)
    with step("heartbeat"):
        store.gateways.heartbeat(claimed.id, claimed.epoch, GatewayReport(line=5))
    with step("sweep of leases"):
        store.leases.run()
    with step("finish"):
        store.gateways.finish(claimed.id, claimed.epoch, "done")
    with step("claim without a job"):
        store.gateways.claim("demo-table", "gateway", manual=False)
    with step("newest 100 jobs"):
        describe(store, store.jobs.search(limit=100))
    with step("100 done jobs"):
        store.jobs.search((State.DONE.value,), limit=100)
    with step("active jobs"):
        store.jobs.search(_ACTIVE, limit=500)
    with step("page of the history"):
        page = store.history.search(HistoryFilter(), None, 100)
    with step("page of the history of a machine"):
        store.history.search(HistoryFilter(machine="demo-table"), None, 100)
    with step("second page of the history"):
        store.history.search(HistoryFilter(), (page[-1].ended, page[-1].serial), 100)
    now = datetime.now(UTC)
    zone = ZoneInfo("Europe/Berlin")
    with step("statistics of ten minutes"):
        since = (now - timedelta(minutes=10)).timestamp()
        store.statistics.sums(since, now.timestamp(), "day", zone)
    with step("events after the last 50"):
        store.events.after(max(store.events.last_id() - 50, 0))
    with step("events of a job"):
        store.events.of_job(job.id)
    with step("use of tools"):
        store.tools.uses(load.machine("demo-table"))
    with step("earlier shortfalls"):
        store.jobs.last_with_exceptions(store.jobs.get(job.id))
    with step("state of queues"):
        store.machines.queues({"demo-table", "table-1"}, 6.0)


def describe(store: Store, rows: list[Job]) -> None:
    """Query what a list of jobs states beside its rows."""
    waiting_of(store, rows)
    store.jobs.remaining_copies(rows)


def whole_tables(store: Store, work: Callable[[], object] | None = None) -> list[str]:
    """Return the statements whose plans read a whole large table (PostgreSQL).

    Parameters
    ----------
    store
        The store.
    work
        Executes the statements; None for those of a round.
    """
    seen: dict[str, Any] = {}
    engine = store.database._engine  # only the engine has the statements

    def keep(_connection: object, _cursor: object, statement: str, values: Any, *_: object) -> None:
        if re.match(r"\s*(SELECT|UPDATE|DELETE)", statement):
            seen.setdefault(statement, values)

    sa.event.listen(engine, "before_cursor_execute", keep)
    if work is None:
        run_round(store, defaultdict(list))
    else:
        work()
    sa.event.remove(engine, "before_cursor_execute", keep)
    found = []
    with engine.connect() as connection:
        for statement, values in seen.items():
            plan = connection.exec_driver_sql(f"EXPLAIN {statement}", values)
            text = "\n".join(row[0] for row in plan)
            scans = re.findall(r"Seq Scan on (\w+)", text)
            if {"job", "event", "machine_run", "run_length", "drawing"}.intersection(scans):
                found.append(f"{' '.join(statement.split())}\n{text}")
    return found


def percentile(times: list[float], share: float) -> float:
    """Return a percentile in ms."""
    return 1000.0 * sorted(times)[min(int(share * len(times)), len(times) - 1)]


def measure(empty: str, full: str, jobs: int, rounds: int) -> None:
    """Fill one of two databases, measure both in turn, and print a table."""
    console = Console(width=120)
    stores = [Store(url) for url in (empty, full)]
    for store in stores:
        store.migrate()
    began = time.monotonic()
    fill(stores[1], jobs)
    complete_job(stores[0])
    console.print(f"{jobs:,} jobs in {time.monotonic() - began:.0f} s", highlight=False)
    times: list[Times] = [defaultdict(list), defaultdict(list)]
    for number in range(rounds + 5):
        if number == 5:  # connections and caches are warm
            for one in times:
                one.clear()
        for store, one in zip(stores, times, strict=True):
            run_round(store, one)
    table = Table("step (ms)", "empty p50", "p99", f"{jobs:,} p50", "p99", "p50 ratio", "p99 ratio")
    rows = []
    for name in times[0]:
        cells = [percentile(one[name], share) for one in times for share in (0.5, 0.99)]
        rows.append((name, cells, cells[2] / cells[0], cells[3] / cells[1]))
    for name, cells, middle, last in sorted(rows, key=lambda row: -row[2]):
        table.add_row(name, *(f"{cell:.2f}" for cell in cells), f"{middle:.2f}", f"{last:.2f}")
    console.print(table)
    began = time.monotonic()
    end = time.time() + 60.0
    sums = stores[1].statistics.sums(0.0, end, "month", ZoneInfo("Europe/Berlin"))
    console.print(f"statistics of all: {len(sums)} rows in {time.monotonic() - began:.1f} s")
    if full.startswith("postgresql"):
        for found in whole_tables(stores[1]):
            console.print(f"reads a whole table: {found}", highlight=False)
    for store in stores:
        store.close()


def main() -> None:
    """Measure in SQLite and PostgreSQL."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--jobs", type=int, default=1_000_000)
    options.add_argument("--rounds", type=int, default=200)
    options.add_argument("--database", choices=["sqlite", "postgresql"], default="postgresql")
    given = options.parse_args()
    if given.database == "sqlite":
        with tempfile.TemporaryDirectory() as folder:
            paths = [f"sqlite:///{Path(folder) / name}.sqlite" for name in ("empty", "full")]
            measure(paths[0], paths[1], given.jobs, given.rounds)
        return
    binaries = installed_binaries()
    assert binaries is not None, "PostgreSQL is not installed"
    with run_server(binaries) as server:
        urls = [create_database(server, name) for name in ("empty", "full")]
        measure(urls[0], urls[1], given.jobs, given.rounds)


if __name__ == "__main__":
    main()
