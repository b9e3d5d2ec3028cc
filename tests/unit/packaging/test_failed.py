"""The list of failed tests that `make failed` runs once more."""

from __future__ import annotations

import json
from pathlib import Path

from tests.failed import failed_tests


def test_tests_are_named_without_their_groups(tmp_path: Path) -> None:
    cache = tmp_path / "lastfailed"
    assert failed_tests(cache) == []
    cache.write_text(json.dumps({"a.py::test_b[x@y-1]@server": True, "a.py::test_c": True}))
    assert failed_tests(cache) == ["a.py::test_b[x@y-1]", "a.py::test_c"]
