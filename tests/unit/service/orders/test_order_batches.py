"""Each order of a batch has a result, whatever fails, on SQLite and PostgreSQL."""

from __future__ import annotations

import logging
import sqlite3
from collections.abc import Callable, Iterator
from typing import Any, cast

import pytest
import sqlalchemy as sa

from knifetip.errors import ContentLost, WrongState
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.components import Service
from knifetip.service.database.tables import Job
from knifetip.service.limits.work_queue import WorkQueue
from knifetip.service.orders import batches as order_batches
from knifetip.service.orders import sent_orders
from knifetip.service.orders.batches import execute_orders
from knifetip.service.orders.creation import place_order
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.orders_with_files import OrderIn, OrderResult
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, TaskFailed
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.stored import add_drawing, migrated_store


@pytest.fixture
def store(migrated_url: str) -> Iterator[Store]:
    with migrated_store(migrated_url) as store:
        yield store


class _Answered:
    """All questions about drawings are answered."""

    def __contains__(self, _key: object) -> bool:
        return True


@pytest.fixture
def service(store: Store) -> Service:
    """Return a server for orders of stored drawings."""
    pool, answered = cast(ProcessPool, None), cast(Any, _Answered())
    return Service(
        Settings(), AccessRules(), store, pool, WorkQueue(1), WorkQueue(1), WarmUp(), answered
    )


def driver_error(text: str, code: int = 0) -> sa.exc.OperationalError:
    reason = sqlite3.OperationalError(text)
    reason.sqlite_errorcode = code
    return sa.exc.OperationalError("INSERT", {}, reason)


def full() -> Exception:
    return driver_error("database or disk is full", sqlite3.SQLITE_FULL)


def locked() -> Exception:
    return driver_error("database is locked", sqlite3.SQLITE_BUSY)


#: What may be raised, the code in the result of its order, and whether the others are tried.
FAULTS: dict[str, tuple[Callable[[], Exception], str, bool]] = {
    "data": (
        lambda: sa.exc.DataError("INSERT", {}, ValueError("0x00")),
        "request.not-storable",
        True,
    ),
    "row": (
        lambda: sa.exc.IntegrityError("INSERT", {}, ValueError("unique")),
        "server.database-silent",
        True,
    ),
    "refused": (lambda: WrongState("drawing.changing", drawing="d"), "drawing.changing", True),
    "crashed": (lambda: TaskFailed("ZeroDivisionError"), "job.compile-crashed", True),
    "unexpected": (lambda: ZeroDivisionError("by zero"), "server.internal-error", True),
    "full": (full, "limit.disk-full", False),
    "full system": (lambda: OSError(28, "No space left"), "limit.disk-full", False),
    "locked": (locked, "server.database-silent", False),
    "no connection": (
        lambda: sa.exc.TimeoutError("no connection"),
        "server.database-silent",
        False,
    ),
    "content": (
        lambda: ContentLost("content.missing", owner="d", address="5e" * 32),
        "content.missing",
        False,
    ),
    "stopping": (TaskCancelled, "server.stopping", False),
}
#: Codes of failures whose cause only the log contains.
LOGGED = ("server.internal-error", "server.database-silent", "limit.disk-full")


def orders_of(store: Store) -> list[OrderIn]:
    drawing = add_drawing(store).id
    fields = {"drawing": drawing, "machine": "demo-table", "board": "e-flute"}
    return [OrderIn.model_validate({**fields, "external_id": f"B{n}"}) for n in range(4)]


def codes(results: list[OrderResult]) -> list[str]:
    return ["" if one.problem is None else one.problem.code for one in results]


def created(results: list[OrderResult]) -> dict[str, str]:
    """Return the external id of each job in the results, by its id."""
    return {one.job_id: f"B{one.index}" for one in results if one.job_id is not None}


def stored(store: Store) -> dict[str, str]:
    """Return the external id of each stored job, by its id."""
    with store.database.reading() as session:
        return {
            row.id: row.external_id for row in session.execute(sa.select(Job.id, Job.external_id))
        }


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("place", range(4))
def test_an_order_that_fails_has_its_own_result(
    service: Service,
    store: Store,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    fault: str,
    place: int,
) -> None:
    error, code, others = FAULTS[fault]
    orders = orders_of(store)

    def failing(service: Service, order: Any, key: Any) -> Job:
        if order.external_id == f"B{place}":
            raise error()
        return place_order(service, order, key)

    monkeypatch.setattr(sent_orders, "place_order", failing)
    with caplog.at_level(logging.ERROR):
        results = execute_orders(service, orders, "key")
    after = "" if others else "request.order-not-tried"
    expected = [code if n == place else after if n > place else "" for n in range(4)]
    assert codes(results) == expected
    assert [one.index for one in results] == [0, 1, 2, 3]
    # The results contain exactly what is stored.
    first = created(results)
    assert first == stored(store)
    assert [one.job is None for one in results] == [word != "" for word in expected]
    # The drawing of the failed order is named; those that were not tried have none.
    assert [one.drawing is None for one in results] == [n > place and not others for n in range(4)]
    assert len(caplog.records) == (code in LOGGED)
    # A repetition orders what is missing, and nothing twice.
    monkeypatch.setattr(sent_orders, "place_order", place_order)
    again = execute_orders(service, orders, "key")
    assert codes(again) == ["", "", "", ""]
    assert created(again) == stored(store)
    assert len(stored(store)) == 4
    assert first.items() <= created(again).items()


@pytest.mark.parametrize("place", range(4))
def test_a_job_that_cannot_be_described_is_in_the_result(
    service: Service, store: Store, monkeypatch: pytest.MonkeyPatch, place: int
) -> None:
    orders = orders_of(store)

    def failing(store: Store, job: Job) -> Any:
        if job.external_id == f"B{place}":
            raise locked()
        return job_out(store, job)

    monkeypatch.setattr(order_batches, "job_out", failing)
    results = execute_orders(service, orders, None)
    assert created(results) == stored(store)
    assert len(created(results)) == place + 1
    assert results[place].job is None
    not_tried = ["request.order-not-tried"] * (3 - place)
    assert codes(results)[place:] == ["server.database-silent", *not_tried]


def test_the_result_of_an_order_that_was_not_tried_has_the_reason(
    service: Service, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object) -> Any:
        raise full()

    monkeypatch.setattr(sent_orders, "place_order", failing)
    last = execute_orders(service, orders_of(store), None)[-1]
    assert last.problem is not None
    assert last.problem.text == (
        "This order was not processed, because an order before it failed. The disk of the server "
        "is full, so nothing was stored."
    )


def test_a_text_that_the_database_refuses_fails_its_order_only(
    service: Service, store: Store
) -> None:
    """PostgreSQL stores no zero character; SQLite stores it."""
    orders = orders_of(store)
    orders[1] = orders[1].model_copy(update={"external_id": "a\0"})
    results = execute_orders(service, orders, None)
    refused = "request.not-storable" if store.database.url.startswith("postgresql") else ""
    assert codes(results) == ["", refused, "", ""]
