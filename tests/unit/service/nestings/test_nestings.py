"""/api/nestings: searches for the places of drawings, which are watched, stopped and deleted."""

from __future__ import annotations

import time
from itertools import pairwise
from typing import Any

import httpx
import pytest
import shapely

from knifetip.errors import NotFound
from knifetip.service.nestings.store import LEASE, NestingState, NestingStore
from knifetip.service.store import Store
from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")

SHEET = {"width": 500.0, "height": 300.0}


@pytest.fixture
def drawing(client: httpx.Client) -> str:
    """A square of 100 mm."""
    id: str = upload_drawing(client, square())["id"]
    return id


def begin(client: httpx.Client, drawing: str, quantity: int = 6, **others: Any) -> httpx.Response:
    parts = [{"drawing": drawing, "quantity": quantity}]
    body = {"sheet": SHEET, "parts": parts, "gap": 5.0, "seconds": 1.0, **others}
    return client.post("/api/nestings", json=body)


def wait(client: httpx.Client, address: str, *states: str) -> dict[str, Any]:
    while True:
        found: dict[str, Any] = client.get(address).json()
        if found["state"] in states:
            return found
        time.sleep(0.05)


def test_the_sheets_of_a_nesting_become_layouts_that_are_ordered(
    client: httpx.Client, drawing: str
) -> None:
    answer = begin(client, drawing, 12, margins={"left": 20.0})
    assert answer.status_code == 202, answer.text
    found = wait(client, answer.headers["Location"], "done")
    assert (found["count"], found["limit"], found["message"]) == (12, 1.0, None)
    assert found["use"] >= found["rectangles_use"] > 50.0
    assert sum(len(sheet["placed"]) for sheet in found["sheets"]) == 12
    for number, sheet in enumerate(found["sheets"]):
        boxes = [shapely.box(p["x"], p["y"], p["x"] + 100, p["y"] + 100) for p in sheet["placed"]]
        assert all(box.bounds[0] >= 19.95 for box in boxes)
        assert all(a.distance(b) >= 4.99 for a in boxes for b in boxes if a is not b)
        use = sheet.pop("use")
        stored = client.post("/api/layouts", json={"name": f"sheet {number}", **sheet}).json()
        assert (stored["overlaps"], stored["off_sheet"]) == ([], [])
        assert stored["use"] == pytest.approx(use, abs=0.01)
    wait_for_state(client, order_job(client, stored["id"])["id"], "ready")


def test_blanks_in_holes_are_counted_and_cut_before_the_hole(client: httpx.Client) -> None:
    outline = text.rectangle(200, 150, (8, "CUT"))
    corners = [(20, 20), (180, 20), (180, 130), (20, 130), (20, 20)]
    hole = "".join(text.line(*a, *b, (8, "CUT")) for a, b in pairwise(corners))
    frame = upload_drawing(client, text.dxf(outline, hole, units=4))["id"]
    small = upload_drawing(client, text.dxf(text.rectangle(40, 30, (8, "CUT")), units=4))["id"]
    parts = [{"drawing": frame, "quantity": 1}, {"drawing": small, "quantity": 3}]
    found = wait(client, begin(client, "", parts=parts).headers["Location"], "done")
    assert (found["count"], found["in_holes"]) == (4, 3)
    (sheet,) = found["sheets"]
    del sheet["use"]
    stored = client.post("/api/layouts", json={"name": "frame", **sheet}).json()
    assert (stored["overlaps"], stored["off_sheet"]) == ([], [])
    job = wait_for_state(client, order_job(client, stored["id"])["id"], "ready")
    tracks = client.get(f"/api/jobs/{job['id']}/tracks").json()
    # The small blanks, then the hole, then the outline of the frame.
    assert [len(track["edges"]) for track in tracks] == [4] * 5
    assert [track["stage"] for track in tracks] == [1, 1, 1, 2, 3]
    without = wait(
        client, begin(client, "", parts=parts, in_holes=False).headers["Location"], "done"
    )
    assert without["in_holes"] == 0


def test_a_stopped_nesting_keeps_its_best_arrangement(client: httpx.Client, drawing: str) -> None:
    address = begin(client, drawing, seconds=600.0).headers["Location"]
    while not client.get(address).json()["sheets"]:
        time.sleep(0.05)
    assert client.post(f"{address}/stop").status_code == 202
    found = wait(client, address, "stopped")
    assert len(found["sheets"][0]["placed"]) == 6
    assert client.delete(address).status_code == 204
    assert client.get(address).status_code == 404
    assert client.post(f"{address}/stop").json()["code"] == "nesting.unknown"


def test_a_deleted_nesting_makes_room_for_the_next(client: httpx.Client, drawing: str) -> None:
    addresses = [begin(client, drawing, seconds=600.0).headers["Location"] for _ in range(2)]
    busy = begin(client, drawing)
    assert (busy.status_code, busy.json()["code"]) == (503, "server.busy")
    for address in addresses:
        assert client.delete(address).status_code == 204
    while (answer := begin(client, drawing)).status_code == 503:
        time.sleep(0.05)
    wait(client, answer.headers["Location"], "done")


@pytest.mark.parametrize(
    ("change", "status", "code"),
    [
        ({"sheet": {"width": 90.0, "height": 90.0}}, 422, "nesting.too-large"),
        ({"margins": {"left": 250.0, "right": 250.0}}, 422, "nesting.no-room"),
        ({"parts": [{"drawing": "none"}]}, 404, "drawing.unknown"),
        ({"parts": []}, 422, None),
        ({"gap": -1.0}, 422, None),
        ({"seconds": 601.0}, 422, None),
    ],
)
def test_a_nesting_that_cannot_succeed_is_refused(
    client: httpx.Client, drawing: str, change: dict[str, Any], status: int, code: str | None
) -> None:
    refused = begin(client, drawing, **change)
    assert refused.status_code == status, refused.text
    assert code in (None, refused.json()["code"])


@pytest.mark.parametrize("quantity", [0, 2001])
def test_the_number_of_copies_is_limited(client: httpx.Client, drawing: str, quantity: int) -> None:
    assert begin(client, drawing, quantity).status_code == 422


def test_a_layout_is_no_part_of_a_nesting(client: httpx.Client, drawing: str) -> None:
    placed = [{"drawing": drawing, "x": 0.0, "y": 0.0}]
    layout = client.post("/api/layouts", json={"name": "a", "sheet": SHEET, "placed": placed})
    refused = begin(client, layout.json()["id"])
    assert (refused.status_code, refused.json()["code"]) == (409, "layout.of-layout")


class _Clock:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> _Clock:
    return _Clock()


@pytest.fixture
def nestings(clock: _Clock, tmp_path: Any) -> Any:
    store = Store(f"sqlite:///{tmp_path}/store.sqlite", clock)
    store.migrate()
    yield store.nestings
    store.close()


def test_a_nesting_is_interrupted_when_its_server_is_gone(
    nestings: NestingStore, clock: _Clock
) -> None:
    row = nestings.add({"seconds": 600.0})
    best = {"use": 50.0}
    assert nestings.renew(row.id, best)
    clock.now += LEASE - 0.1
    assert nestings.get(row.id).state == NestingState.RUNNING
    clock.now += 0.2
    found = nestings.get(row.id)
    assert (found.state, found.result) == (NestingState.INTERRUPTED, best)


def test_a_nesting_goes_on_until_it_is_stopped_or_deleted(nestings: NestingStore) -> None:
    first, second = nestings.add({}), nestings.add({})
    assert nestings.renew(first.id)
    nestings.request_stop(first.id)
    assert not nestings.renew(first.id)
    nestings.end(first.id, NestingState.STOPPED)
    nestings.end(first.id, NestingState.DONE)
    assert nestings.get(first.id).state == NestingState.STOPPED
    nestings.delete(second.id)
    assert not nestings.renew(second.id)
    with pytest.raises(NotFound):
        nestings.get(second.id)
