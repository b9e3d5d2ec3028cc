"""A shop on PostgreSQL whose processes are killed loses no job, and cuts none twice.

``python -m tests.failures`` is the long form, with hundreds of kills.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest

from knifetip.library import load
from tests.failures.campaign import Campaign
from tests.failures.clocks import Clocks
from tests.failures.shop import Shop
from tests.failures.violations import JobRecord, Violations, check_jobs
from tests.failures.watched_table import Run, WatchedTable
from tests.support.serving.postgresql import installed_binaries

pytestmark = pytest.mark.xdist_group("failures")

LINES = [b"(drawing ab12)", b"G0 Z20", b"G0 X30 Y30", b"G1 Z-1 F600", b"G1 X80", b"G0 Z20", b"M30"]


@pytest.mark.skipif(installed_binaries() is None, reason="PostgreSQL is not installed")
def test_killed_processes_lose_no_job_and_cut_none_twice() -> None:
    with Shop(tables=1, speed=20.0) as shop:
        faults = ["kill gateway", "kill database", "kill worker", "kill server"]
        found = Campaign(shop, seed=2).run(faults, pause=(0.5, 2.0), settle=120.0)
    assert found.jobs >= found.runs - found.again > 0
    assert not found.violations, found.violations.cases


def table() -> WatchedTable:
    return WatchedTable(load.machine("demo-table"), speed=1.0)


def execute(table: WatchedTable, lines: list[bytes]) -> None:
    """Send lines to a table, each when the one before has been accepted."""
    for line in lines:
        table.receive(line + b"\n")
        while table._pending:
            table.elapse(0.1)


def test_a_watched_table_keeps_its_programs_apart() -> None:
    one = table()
    execute(one, LINES)
    execute(one, LINES[:5])
    one.receive(b"\x18")
    execute(one, [b"$X", b"$C", *LINES, b"$C"])
    assert [run.lines for run in one.runs if run.has_cut] == [LINES, LINES[:5]]
    assert all(run.is_of("ab12ffff") for run in one.runs if run.has_cut)


def violations_of(state: str, runs: list[list[bytes]], *codes: str) -> set[str]:
    """Return the names of the violations by one job."""
    violations = Violations()
    record = JobRecord("j", state, Counter(codes), b"\n".join(LINES))
    done = [Run("ab12", lines) for lines in runs]
    check_jobs({"j": "ab12ffff"}, {"j": record}, done, violations)
    return {name for name, rows in violations.cases.items() if rows}


CONFIRMED, AGAIN = "job.confirmed-table", "job.requeued"


@pytest.mark.parametrize(
    ("violations", "state", "runs", "codes"),
    [
        ((), "done", [LINES], [CONFIRMED]),
        ((), "done", [LINES[:5], LINES], [CONFIRMED, AGAIN, CONFIRMED]),
        # The gateway moves to the first point and back: nothing was cut.
        ((), "done", [LINES[:3], LINES], [CONFIRMED]),
        (["stuck"], "interrupted", [LINES[:5]], [CONFIRMED]),
        (["not_executed"], "done", [LINES[:5]], [CONFIRMED]),
        (["not_executed"], "done", [], [CONFIRMED]),
        (["cut_twice"], "done", [LINES[:5], LINES], [CONFIRMED, CONFIRMED]),
        (["unconfirmed"], "done", [LINES], []),
        (["cut_twice", "unconfirmed"], "done", [LINES, LINES], [CONFIRMED]),
    ],
)
def test_each_violation_is_found(
    violations: list[str], state: str, runs: list[list[bytes]], codes: list[str]
) -> None:
    assert violations_of(state, runs, *codes) == set(violations)


def test_a_job_that_is_not_stored_is_lost_and_a_run_without_a_job_is_not_confirmed() -> None:
    violations = Violations()
    check_jobs({"j": "ab12ffff"}, {}, [Run("cd34", LINES)], violations)
    assert {name for name, rows in violations.cases.items() if rows} == {"lost", "unconfirmed"}


def test_a_stepped_clock_changes_the_time_of_day_and_no_duration(tmp_path: Path) -> None:
    clocks = Clocks(tmp_path)
    if not clocks.can_step:
        pytest.skip("there is no C compiler")
    environment = {**os.environ, **clocks.environment("one")}
    code = "import time; b = time.monotonic(); time.sleep(0.01); print(time.time(), b)"
    for step in (0.0, 3600.0, -3600.0):
        clocks.step("one", step)
        began = time.time(), time.monotonic()
        said = subprocess.run(
            [sys.executable, "-c", code], env=environment, check=True, capture_output=True
        )
        now, duration = map(float, said.stdout.split())
        assert began[0] <= now - step <= time.time()
        assert began[1] <= duration <= time.monotonic()
