"""Fixtures of the tests of the gateway."""

from __future__ import annotations

import pytest

from knifetip.gateway import station
from tests.support.expiry import EXPIRY


@pytest.fixture(autouse=True)
def _operations_that_expire_late(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no operation expire because this computer is busy."""
    monkeypatch.setattr(station, "EXPIRY", EXPIRY)
