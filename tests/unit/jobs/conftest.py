"""A clock that a test sets, and a store in SQLite, then one in PostgreSQL."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from knifetip.jobs.store import Store
from tests.support.stored import Clock, migrated_store


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(migrated_url: str, clock: Clock) -> Iterator[Store]:
    with migrated_store(migrated_url, clock) as store:
        yield store
