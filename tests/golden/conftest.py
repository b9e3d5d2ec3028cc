"""Golden files: what came out when somebody last looked.

``pytest tests/golden --accept`` writes them anew; the difference is then read like code.
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
    """Compare bytes with the golden file of this name, or write it under ``--accept``."""

    def compare(name: str, produced: bytes) -> None:
        # The option is unknown where the tests are started from above this folder.
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
