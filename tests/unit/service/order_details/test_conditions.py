"""Details of orders as conditions, in SQLite and PostgreSQL."""

from __future__ import annotations

import pytest

from knifetip.service.order_details.details import DetailsFilter
from knifetip.service.orders.store import JobFilter
from knifetip.service.store import Store
from tests.support.stored import add_job

NOTES = "FÜR Österreich: 100% Straße_7, ŁÓDŹ"


@pytest.mark.parametrize(
    ("text", "is_found"),
    [
        ("für", True),
        ("Für ö", True),
        ("ÖSTERREICH", True),
        ("straße", True),
        ("łódź", True),
        ("100%", True),
        ("e_7", True),
        ("fur", False),
        ("e-7", False),
        ("10%S", False),
    ],
)
def test_notes_are_found_in_upper_and_lower_case(store: Store, text: str, is_found: bool) -> None:
    job = add_job(store, details={"notes": NOTES})
    add_job(store)
    wanted = JobFilter(DetailsFilter(notes=text))
    found = [row.id for row in store.jobs.search(wanted=wanted)]
    assert found == ([job.id] if is_found else [])
