"""A plugin of pytest that measures the CPU time of each test and lists the slowest ones.

``make slowest`` runs the tests of `make test` with it. CPU time includes the processes that a test
has started; what a server does for one test after the other is part of the test during which it
works. Unlike wall time, it hardly depends on what else the computer does.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

_COUNT = 30
_PAGE = Path(__file__).parents[2] / "backend" / "docs" / "slowest-tests.md"
_HEAD = """# The slowest tests

CPU time of the {count} slowest of {all} tests of `make test`, with fixtures that they are the first
to use. All tests together take {total:.0f} s. `make slowest` writes this page.

| CPU time (s) | test |
|-------------:|------|
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
                spent[report.nodeid] += float(str(dict(report.user_properties).get("cpu", 0.0)))
    slowest = sorted(spent, key=lambda name: -spent[name])[:_COUNT]
    rows = [f"| {spent[name]:.1f} | `{name.removeprefix('tests/')}` |\n" for name in slowest]
    head = _HEAD.format(count=len(rows), all=len(spent), total=sum(spent.values()))
    _PAGE.write_text(head + "".join(rows), encoding="utf-8")
