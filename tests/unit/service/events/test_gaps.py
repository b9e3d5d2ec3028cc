"""Events that appear after events with greater numbers."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
import sqlalchemy as sa

from knifetip.service.database.tables import Event
from knifetip.service.events.gaps import EventGaps
from knifetip.service.store import Store
from tests.support.stored import Clock, add_job, migrated_store


@pytest.fixture
def store(migrated_postgresql: str) -> Iterator[Store]:
    with migrated_store(migrated_postgresql) as store:
        yield store


def test_a_skipped_number_is_queried_until_it_appears_or_is_too_old() -> None:
    clock = Clock()
    gaps = EventGaps(clock)
    assert gaps.read(3, {4, 7}) == 7
    assert gaps.numbers == [5, 6]
    assert gaps.read(7, {6, 9}) == 9
    assert gaps.numbers == [5, 8]
    clock.now += 29.0
    assert gaps.read(9, ()) == 9
    assert gaps.numbers == [5, 8]
    clock.now += 1.0
    gaps.read(9, {10, 12})
    assert gaps.numbers == [11]


def test_an_event_that_is_committed_after_a_later_one_is_read(store: Store) -> None:
    add_job(store)
    gaps, last = EventGaps(), store.events.last_id()
    slow = {"kind": "job", "subject": "slow", "at": 0.0, "state": "received", "who": ""}
    with store.database.writing() as session:
        session.execute(sa.insert(Event).values(**slow))
        add_job(store)  # another transaction, which is committed first
        events = store.events.after(last, late=gaps.numbers)
        assert "slow" not in [event.subject for event in events]
        last = gaps.read(last, {event.id for event in events})
    assert [event.subject for event in store.events.after(last, late=gaps.numbers)] == ["slow"]
