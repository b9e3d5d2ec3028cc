"""The list of drawings with their newest jobs: conditions, order, pages, and limits of keys."""

from __future__ import annotations

import uuid
from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")


class Listed:
    """Drawings of one test, which have a customer that no other drawing has."""

    def __init__(self, client: httpx.Client) -> None:
        self.client = client
        self.customer = f"customer {uuid.uuid4().hex}"

    def upload(self, side: float, **details: Any) -> str:
        id = str(upload_drawing(self.client, square(side=side))["id"])
        part = {"customer": self.customer, **details}
        self.client.patch(f"/api/v1/drawings/{id}", json=part).raise_for_status()
        return id

    def rows(self, **wanted: Any) -> list[dict[str, Any]]:
        params = {"search": self.customer, **wanted}
        answer = self.client.get("/api/v1/orders", params=params)
        assert answer.status_code == 200, answer.text
        found: list[dict[str, Any]] = answer.json()
        return found

    def ids(self, **wanted: Any) -> list[str]:
        return [row["drawing"]["id"] for row in self.rows(**wanted)]


@pytest.fixture
def listed(client: httpx.Client) -> Listed:
    return Listed(client)


def test_a_row_has_the_newest_job_of_its_drawing(listed: Listed) -> None:
    without, with_jobs = listed.upload(41.0), listed.upload(42.0)
    jobs = [order_job(listed.client, with_jobs, machine="demo-table")["id"] for _ in range(2)]
    rows = {row["drawing"]["id"]: row for row in listed.rows()}
    assert rows[without]["job"] is None
    assert rows[with_jobs]["job"]["id"] == jobs[-1]
    assert listed.ids(state="none") == [without]
    assert listed.ids(machine="demo-table") == [with_jobs]
    assert listed.ids(machine="router") == []
    state = rows[with_jobs]["job"]["state"]
    states = {"received", "compiling", "ready", "refused"}
    assert state in states
    assert listed.ids(state=sorted(states)) == [with_jobs]
    assert listed.ids(state="done") == []


def test_the_same_file_is_told_by_its_hash(listed: Listed) -> None:
    first, second, other = listed.upload(43.0), listed.upload(43.0), listed.upload(44.0)
    files = {row["drawing"]["id"]: row["file"] for row in listed.rows()}
    assert files[first] == files[second] != files[other]


def test_the_list_is_searched_sorted_and_paged(listed: Listed) -> None:
    soon = listed.upload(45.0, due="2031-01-01T00:00:00Z", external_id=f"B {listed.customer}")
    later = listed.upload(46.0, due="2032-01-01T00:00:00Z")
    never = listed.upload(47.0)
    assert listed.ids() == [never, later, soon]
    assert listed.ids(sort="due") == [soon, later, never]
    assert listed.ids(search=f"b {listed.customer}".upper()) == [soon]
    assert listed.ids(search=f"{listed.customer}%") == []
    params: dict[str, Any] = {"search": listed.customer, "sort": "due", "limit": 2}
    first = listed.client.get("/api/v1/orders", params=params)
    assert [row["drawing"]["id"] for row in first.json()] == [soon, later]
    second = listed.client.get(first.links["next"]["url"])
    assert [row["drawing"]["id"] for row in second.json()] == [never]
    assert "next" not in second.links


def test_the_list_is_sorted_by_the_newest_job_and_reversed(listed: Listed) -> None:
    without = listed.upload(48.0, due="2031-01-01T00:00:00Z")
    table, router = listed.upload(49.0), listed.upload(50.0)
    order_job(listed.client, table, machine="demo-table")
    job = order_job(listed.client, router, machine="router-table")["id"]
    assert listed.ids(sort="machine") == [table, router, without]
    # A row without a value is the last one in either direction.
    assert listed.ids(sort="machine", reverse=True) == [router, table, without]
    assert listed.ids(reverse=True) == [without, table, router]
    assert listed.ids(sort="board")[-1] == without
    assert listed.ids(sort="time")[-1] == without
    listed.client.post(f"/api/v1/jobs/{job}/cancel", json={}).raise_for_status()
    assert listed.ids(sort="state") == [table, router, without]
    assert listed.ids(sort="state", reverse=True) == [router, table, without]


def test_the_list_is_sorted_by_the_details_of_the_job_where_it_has_its_own(listed: Listed) -> None:
    first, second = listed.upload(51.0), listed.upload(52.0)
    details = {"due": "2033-01-01T00:00:00Z", "customer": f"A {listed.customer}"}
    listed.client.patch(
        f"/api/v1/drawings/{first}", json={"due": "2032-01-01T00:00:00Z"}
    ).raise_for_status()
    listed.client.patch(
        f"/api/v1/drawings/{second}", json={"due": "2031-01-01T00:00:00Z"}
    ).raise_for_status()
    assert listed.ids(sort="due") == [second, first]
    order_job(listed.client, second, machine="demo-table", **details)
    assert listed.ids(sort="due") == [first, second]
    assert listed.ids(sort="customer") == [second, first]


def test_an_unknown_order_is_refused(client: httpx.Client) -> None:
    assert client.get("/api/v1/orders", params={"sort": "size"}).status_code == 422
