"""Run the tests that failed last once more, one after the other (ADR 138).

``pytest --last-failed`` does not find tests of groups: pytest-xdist stores their ids with the name
of the group, ``test_x.py::test_y@server``.  Here the ids are passed without it, and each must be
found.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import pytest

_CACHE = Path(".pytest_cache/v/cache/lastfailed")


def failed_tests(cache: Path) -> list[str]:
    """Return the ids of the tests that failed last, without the names of their groups."""
    stored = json.loads(cache.read_text()) if cache.exists() else {}
    return [without_group(id) for id in stored]


def without_group(id: str) -> str:
    """Return the id of a test without the name of its group, which pytest-xdist adds."""
    return re.sub(r"@[\w-]+$", "", id)


if __name__ == "__main__":
    tests = failed_tests(_CACHE)
    if not tests:
        sys.exit("There is no list of failed tests.")
    sys.exit(pytest.main([*sys.argv[1:], "-v", "-n", "1", *tests]))
