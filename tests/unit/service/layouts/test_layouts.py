"""/api/layouts: sheets with placed drawings, and jobs that make them."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

SHEET = {"width": 500.0, "height": 300.0}


def add(client: httpx.Client, *placed: dict[str, Any], **others: Any) -> httpx.Response:
    body = {"name": "sheet 1", "sheet": SHEET, "placed": list(placed), **others}
    return client.post("/api/layouts", json=body)


def layout(client: httpx.Client, *placed: dict[str, Any], **others: Any) -> dict[str, Any]:
    answer = add(client, *placed, **others)
    assert answer.status_code == 201, answer.text
    body: dict[str, Any] = answer.json()
    return body


@pytest.fixture
def drawing(client: httpx.Client) -> str:
    """A square of 100 mm."""
    id: str = upload_drawing(client, square())["id"]
    return id


def test_a_layout_has_a_box_for_each_copy_and_pins_the_revision(
    client: httpx.Client, drawing: str
) -> None:
    placed = {"drawing": drawing, "x": 20.0, "y": 30.0, "columns": 2, "gap_x": 10.0}
    stored = layout(client, placed, external_id="A-17")
    assert [copy["box"] for copy in stored["copies"]] == [
        [20.0, 30.0, 120.0, 130.0],
        [130.0, 30.0, 230.0, 130.0],
    ]
    assert (stored["area"], stored["use"]) == (20000.0, pytest.approx(100.0 * 2.0 / 15.0, abs=0.01))
    assert (stored["overlaps"], stored["off_sheet"]) == ([], [])
    assert stored["placed"][0]["revision"] == 1
    assert client.get(f"/api/layouts/{stored['id']}").json() == stored
    listed = client.get("/api/layouts", params={"external_id": "A-17"}).json()
    assert [(one["id"], one["count"]) for one in listed] == [(stored["id"], 2)]
    sheet = client.get(f"/api/drawings/{stored['id']}").json()
    assert sheet["segments"] == 8
    uploaded = client.get("/api/drawings", params={"limit": 500}).json()
    assert stored["id"] not in {one["id"] for one in uploaded}


def test_an_order_of_a_layout_makes_all_copies_at_their_places(
    client: httpx.Client, drawing: str
) -> None:
    stored = layout(
        client,
        {"drawing": drawing, "x": 20.0, "y": 40.0},
        {"drawing": drawing, "x": 200.0, "y": 40.0, "turn": 90.0, "mirror": True},
    )
    job = wait_for_state(client, order_job(client, stored["id"])["id"], "ready")
    assert job["sheet"] == {"width": 500.0, "height": 300.0, "margin": 20.0, "margin_below": 40.0}
    other = {"drawing": stored["id"], "machine": "demo-table", "board": "fbb-0.4"}
    refused = client.post("/api/jobs", json={**other, "sheet": {"width": 400.0, "height": 300.0}})
    assert (refused.status_code, refused.json()["code"]) == (409, "layout.sheet-fixed")


@pytest.mark.parametrize(
    ("placed", "code"),
    [
        ([{"x": 0.0, "y": 0.0}, {"x": 90.0, "y": 0.0}], "layout.overlap"),
        ([{"x": 410.0, "y": 0.0}], "layout.off-sheet"),
    ],
)
def test_no_program_is_made_for_copies_that_overlap_or_leave_the_sheet(
    client: httpx.Client, drawing: str, placed: list[dict[str, Any]], code: str
) -> None:
    stored = layout(client, *({"drawing": drawing, **one} for one in placed))
    assert stored["overlaps" if code == "layout.overlap" else "off_sheet"]
    job = wait_for_state(client, order_job(client, stored["id"])["id"], "refused")
    assert job["message"]["code"] == code


def test_a_new_revision_replaces_what_is_placed(client: httpx.Client, drawing: str) -> None:
    stored = layout(client, {"drawing": drawing, "x": 0.0, "y": 0.0})
    address = f"/api/layouts/{stored['id']}"
    body = {"sheet": SHEET, "placed": [{"drawing": drawing, "x": 7.0, "y": 0.0, "rows": 2}]}
    changed = client.put(address, json=body, headers={"If-Match": '"1"'})
    assert changed.status_code == 200, changed.text
    assert (changed.json()["revision"], changed.json()["count"]) == (2, 2)
    assert changed.headers["ETag"] == '"2"'
    assert client.put(address, json=body, headers={"If-Match": '"1"'}).status_code == 412
    assert client.delete(address).status_code == 204
    assert client.get(address).status_code == 404


def test_a_layout_does_not_change_with_its_drawing(client: httpx.Client, drawing: str) -> None:
    placed = {"drawing": drawing, "x": 0.0, "y": 0.0}
    stored = layout(client, placed)
    patch = {"overrides": [{"type": "crease", "edges": [0]}]}
    assert client.patch(f"/api/drawings/{drawing}/edges", json=patch).status_code == 200
    wait_for_state(client, order_job(client, stored["id"])["id"], "ready")
    stale = add(client, {**placed, "revision": 1})
    assert (stale.status_code, stale.json()["code"]) == (412, "layout.drawing-changed")
    assert layout(client, placed)["placed"][0]["revision"] == 2


def test_the_lines_of_a_layout_are_changed_in_its_drawings(
    client: httpx.Client, drawing: str
) -> None:
    id = layout(client, {"drawing": drawing, "x": 0.0, "y": 0.0})["id"]
    patch = {"overrides": [{"type": "crease", "edges": [0]}]}
    for refused in (
        client.patch(f"/api/drawings/{id}/edges", json=patch),
        client.patch(f"/api/drawings/{id}", json={"unit": "in"}),
        client.post(f"/api/drawings/{id}/pages/2"),
    ):
        assert (refused.status_code, refused.json()["code"]) == (409, "layout.read-only")
    assert add(client, {"drawing": id, "x": 0.0, "y": 0.0}).json()["code"] == "layout.of-layout"
    assert client.get(f"/api/layouts/{drawing}").status_code == 404
    file = client.get(f"/api/drawings/{id}/file")
    assert file.headers["content-type"] == "application/zip"


@pytest.mark.parametrize(
    ("change", "status"),
    [
        ({"placed": []}, 422),
        ({"placed": [{"drawing": "none", "x": 0.0, "y": 0.0}]}, 404),
        ({"sheet": {"width": -1.0, "height": 5.0}}, 422),
        ({"name": ""}, 422),
    ],
)
def test_a_wrong_layout_is_refused_with_a_hint(
    client: httpx.Client, drawing: str, change: dict[str, Any], status: int
) -> None:
    answer = add(client, {"drawing": drawing, "x": 0.0, "y": 0.0}, **change)
    assert answer.status_code == status


def test_a_sheet_has_a_limit_of_copies(client: httpx.Client, drawing: str) -> None:
    many = {"drawing": drawing, "x": 0.0, "y": 0.0, "columns": 200, "rows": 11}
    answer = add(client, many)
    assert answer.status_code == 422
    assert "2200 copies" in answer.json()["detail"]


def test_the_same_request_stores_one_layout(client: httpx.Client, drawing: str) -> None:
    body = {"name": "a", "sheet": SHEET, "placed": [{"drawing": drawing, "x": 0.0, "y": 0.0}]}
    ids = {
        client.post("/api/layouts", json=body, headers={"Idempotency-Key": "layout-7"}).json()["id"]
        for _ in range(2)
    }
    assert len(ids) == 1


def test_work_lists_a_layout_and_says_what_it_is(client: httpx.Client, drawing: str) -> None:
    stored = layout(client, {"drawing": drawing, "x": 0, "y": 0}, external_id="A-19")
    rows = client.get("/api/orders", params={"search": "A-19"}).json()
    assert [(row["drawing"]["id"], row["drawing"]["is_layout"]) for row in rows] == [
        (stored["id"], True)
    ]
    assert client.get(f"/api/drawings/{stored['id']}").json()["is_layout"]
    assert not client.get(f"/api/drawings/{drawing}").json()["is_layout"]


def test_an_order_may_contain_its_layout(client: httpx.Client, drawing: str) -> None:
    placed = [{"drawing": drawing, "x": 20.0, "y": 40.0, "columns": 2}]
    order = {
        "board": "fbb-0.4",
        "layout": {"sheet": SHEET, "placed": placed},
        "external_id": "A-18",
    }
    headers = {"Idempotency-Key": "order of a layout"}
    first = client.post("/api/orders", json=order, headers=headers)
    assert first.status_code == 201, first.text
    again = client.post("/api/orders", json=order, headers=headers)
    assert again.json()["job"]["id"] == first.json()["job"]["id"]
    job = wait_for_state(client, first.json()["job"]["id"], "ready")
    assert job["sheet"] == {"width": 500.0, "height": 300.0, "margin": 20.0, "margin_below": 40.0}
    (listed,) = client.get("/api/layouts", params={"external_id": "A-18"}).json()
    assert (listed["id"], listed["name"], listed["count"]) == (job["drawing"], "A-18", 2)
    both = client.post("/api/orders", json={**order, "drawing": drawing})
    assert (both.status_code, both.json()["code"]) == (422, "request.one-drawing")
    (result,) = client.post("/api/orders/batch", json={"orders": [order]}).json()
    assert (result["status"], result["job"]["drawing_name"]) == (201, "A-18")
