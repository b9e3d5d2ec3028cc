"""A plugin of pytest that measures the CPU time of each test and lists the slowest ones.

``make slowest`` runs the tests of `make test` with it, ``make slowest ROOM=tests/browser`` those of
a folder. The times are kept in ``build/cpu-time.json``, so folders can be measured one by one.

CPU time includes the processes that a test has started; what a server does for one test after the
other is part of the test during which it works. Unlike wall time, it hardly depends on what else
the computer does.
"""

from __future__ import annotations

import json
import os
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from tests.failed import without_group

_ROOT = Path(__file__).parents[2]
_COUNT = 30
_PAGE = _ROOT / "backend" / "docs" / "slowest-tests.md"
_MEASURED = _ROOT / "build" / "cpu-time.json"
_HEAD = """# The slowest tests

CPU time of the {count} slowest of {all} measured tests of `make test`, with the fixtures that
they are the first to use. `make slowest` measures all tests one after the other and writes this
page; `make slowest ROOM=tests/browser` measures those of one folder anew, and keeps the times of
the others.

| CPU time (s) | test |
|-------------:|------|
"""
_ROOMS = """
They take {total:.0f} s together, without the collection of the tests:

| CPU time (s) | tests | folder |
|-------------:|------:|--------|
"""


def cpu_time() -> float:
    """Return the CPU time of this process and of all its descendants (s)."""
    times = os.times()
    total = times.user + times.system + times.children_user + times.children_system
    waiting = _children(os.getpid())
    while waiting:
        process = waiting.pop()
        try:
            fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        # Its own time, and that of its children which have ended.
        total += sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
        waiting += _children(process)
    return total


def _children(process: int | str) -> list[str]:
    found: list[str] = []
    for file in Path(f"/proc/{process}/task").glob("*/children"):
        try:
            found += file.read_text().split()
        except OSError:  # the thread has ended
            continue
    return found


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    item.stash[_BEGIN] = cpu_time()
    return (yield)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """Add the CPU time since the last report to the report of a setup, call or teardown."""
    now = cpu_time()
    # Processes of Chromium that end without their parent's attention take their time with them.
    item.user_properties[:] = [("cpu", max(0.0, now - item.stash[_BEGIN]))]
    item.stash[_BEGIN] = now
    return (yield)


_BEGIN = pytest.StashKey[float]()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    spent: dict[str, float] = defaultdict(float)
    for reports in terminalreporter.stats.values():
        for report in reports:
            if isinstance(report, pytest.TestReport):
                spent[without_group(report.nodeid)] += float(
                    str(dict(report.user_properties).get("cpu", 0.0))
                )
    measured = _with_earlier(spent)
    _MEASURED.parent.mkdir(exist_ok=True)
    _MEASURED.write_text(json.dumps(measured, indent=0, sort_keys=True), encoding="utf-8")
    _PAGE.write_text(slowest_page(measured), encoding="utf-8")


def _with_earlier(spent: Mapping[str, float]) -> dict[str, float]:
    """Return the times of this run and, for the files that it did not run, of earlier ones."""
    files = {_file(name) for name in spent}
    earlier: dict[str, float] = json.loads(_MEASURED.read_text()) if _MEASURED.exists() else {}
    kept = {
        name: time
        for name, time in earlier.items()
        if _file(name) not in files and (_ROOT / _file(name)).exists()
    }
    return kept | dict(spent)


def slowest_page(measured: Mapping[str, float]) -> str:
    """Return the page with the slowest tests and the time of each folder.

    Parameters
    ----------
    measured
        CPU time of each test by its id (s).
    """
    slowest = sorted(measured, key=lambda name: -measured[name])[:_COUNT]
    page = _HEAD.format(count=len(slowest), all=f"{len(measured):,}")
    for name in slowest:
        page += f"| {measured[name]:.1f} | `{name.removeprefix('tests/')}` |\n"
    rooms: dict[str, list[float]] = defaultdict(list)
    for name, time in measured.items():
        parts = _file(name).split("/")[1:-1]
        rooms["/".join(parts[:2])].append(time)
    page += _ROOMS.format(total=sum(measured.values()))
    for room in sorted(rooms, key=lambda room: -sum(rooms[room])):
        page += f"| {sum(rooms[room]):.0f} | {len(rooms[room]):,} | `{room}` |\n"
    return page


def _file(name: str) -> str:
    return name.partition("::")[0]
