"""Which tests a process of pytest-xdist runs, and in which order.

``--dist loadgroup`` hands out each test that has no group by itself. For 13,000 tests that takes a
minute of CPU time, and each process prepares the fixtures of each module. Here the tests of a
module stay together. The order is that in which all processes end at nearly the same time: first
what waits for machines and browsers, last short modules.
"""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

from xdist.scheduler import LoadGroupScheduling

#: The groups that take longest, mostly waiting.
LONGEST = ("linuxcnc", "browser", "drawings", "accounts")
#: Unit tests with databases, servers and processes, and those that wait for a silent machine.
_LONG = tuple(f"tests/unit/{folder}/" for folder in ("service", "gateway", "cli", "packaging"))


class ModuleScheduling(LoadGroupScheduling):
    """Let one process run the tests of a group, or of a module, one after the other."""

    workqueue: OrderedDict[str, dict[str, bool]]

    def _split_scope(self, nodeid: str) -> str:
        """Return the group of a test, or its module if it has no group."""
        group: str = super()._split_scope(nodeid)
        return group.partition("::")[0]

    def _assign_work_unit(self, node: Any) -> None:
        """Give a process the next group or module."""
        if not any(self.assigned_work.values()):
            # Those of the same rank are ordered by their number of tests.
            self.workqueue = OrderedDict(
                sorted(self.workqueue.items(), key=lambda unit: rank(unit[0]))
            )
        super()._assign_work_unit(node)


def rank(name: str) -> int:
    """Return the place of a group or module in the order; those of one place may run in any."""
    if name in LONGEST:
        return LONGEST.index(name)
    if not name.endswith(".py"):
        return len(LONGEST)
    is_short = name.startswith("tests/unit/") and not name.startswith(_LONG)
    return len(LONGEST) + (2 if is_short else 1)
