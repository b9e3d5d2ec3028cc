"""Cases of tests that run in two databases: `make test` runs each of them in one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import pytest

DATABASES = ("sqlite", "postgresql")


def leave_half_to_long_runs(items: Sequence[pytest.Item]) -> None:
    """Mark each case of a test as ``long`` in one of its two databases, in turn.

    Tests without other parameters keep both databases. So each statement of a test runs in both,
    and each case in one of them.
    """
    cases: dict[tuple[str, str], dict[str, int]] = defaultdict(dict)
    found: list[tuple[pytest.Function, dict[str, int], str, str]] = []
    for item in items:
        if isinstance(item, pytest.Function) and (database := _database(item)):
            known = cases[item.nodeid.partition("[")[0], item.originalname]
            case = item.callspec.id.replace(database, "", 1)
            known.setdefault(case, len(known))
            found.append((item, known, case, database))
    for item, known, case, database in found:
        if len(known) > 1 and known[case] % 2 != DATABASES.index(database):
            item.add_marker(pytest.mark.long)


def _database(item: pytest.Function) -> str:
    """Return the database of a test with a parameter for it, or an empty text."""
    parameters = item.callspec.params.values() if hasattr(item, "callspec") else ()
    return next((one for one in parameters if isinstance(one, str) and one in DATABASES), "")
