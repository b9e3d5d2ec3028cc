"""Golden files: reviewed outputs that later outputs must equal.

``pytest tests/golden --accept`` overwrites the files; review the difference like code.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable
from pathlib import Path

import pytest

HERE = Path(__file__).parent


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--accept", action="store_true", help="write the golden files anew instead of comparing"
    )


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, bytes], None]:
    """Return a function that compares bytes with a golden file, or overwrites it with
    ``--accept``.
    """

    def compare(name: str, produced: bytes) -> None:
        # The option is unknown if the tests are started from a parent folder.
        if request.config.getoption("--accept", default=False):
            (HERE / name).write_bytes(produced)
            return
        accepted = (HERE / name).read_bytes()
        difference = difflib.unified_diff(
            accepted.decode().splitlines(), produced.decode().splitlines(), name, "now", "", "", 1
        )
        if accepted != produced:
            pytest.fail("\n".join(difference) or f"{name}: only line ends differ", pytrace=False)

    return compare
