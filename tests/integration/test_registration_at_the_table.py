"""A job on a printed sheet at the simulated table: measured, compiled for the sheet, and run."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from knifetip.library import load
from knifetip.presentation.columns import unpack_columns
from tests.support.serving.server import (
    Running,
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("corridor")

MARKS = [[0.0, 0.0], [200.0, 0.0], [0.0, 200.0]]
TURN, SHIFT = math.radians(2.0), (60.0, 45.0)


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """Run a server with a simulated table at fifty times its speed; yield a client."""
    with Running(tmp_path_factory.mktemp("shop") / "shop.sqlite", speed=50.0) as client:
        yield client


def lie(x: float, y: float) -> list[float]:
    """Where a point of the drawing lies on the table."""
    cos, sin = math.cos(TURN), math.sin(TURN)
    return [SHIFT[0] + cos * x - sin * y, SHIFT[1] + sin * x + cos * y]


def wait_at_table(shop: httpx.Client, id: str) -> dict[str, Any]:
    """Wait until a job waits for its operator at the table."""
    deadline = time.monotonic() + 150.0
    while time.monotonic() < deadline:
        job: dict[str, Any] = shop.get(f"/api/jobs/{id}").json()
        if job["waiting_for"] == "confirmation":
            return job
        assert job["state"] not in ("refused", "cancelled"), job
        time.sleep(0.02)
    raise AssertionError(job)


def checks(shop: httpx.Client, id: str) -> dict[str, str]:
    asked = shop.get(f"/api/jobs/{id}/confirmation").json()
    return {check["id"]: check["text"] for check in asked["checks"]}


def ordered(shop: httpx.Client, **others: Any) -> str:
    drawing = upload_drawing(shop, square(side=200.0))["id"]
    fields = {"registration": {"marks": MARKS}, "release": True, **others}
    return str(order_job(shop, drawing, **fields)["id"])


def test_a_printed_sheet_is_measured_compiled_and_run(shop: httpx.Client) -> None:
    id = ordered(shop)
    # Without a measurement, the person states that the sheet lies at the stops.
    wait_at_table(shop, id)
    assert "at the stops" in checks(shop, id)["sheet-at-stops"]
    url = f"/api/jobs/{id}/registration"
    marks = shop.get(url).json()
    assert [mark["expected"] for mark in marks["marks"]] == [[20, 20], [220, 20], [20, 220]]
    assert (marks["turn"], marks["refusal"]) == (None, None)
    # The knife of station 1 was moved above the marks, so that the head was beside them.
    station = load.machine("demo-table").stations[0]
    seen = [[x + station.x, y + station.y] for x, y in (lie(*mark) for mark in MARKS)]
    body = {"positions": seen, "station": station.number, "by": "Ada"}
    fit = shop.post(f"{url}/fit", json=body).json()
    assert fit["turn"] == pytest.approx(2.0, abs=1e-4)
    assert fit["scale"] == pytest.approx(1.0, abs=1e-6)
    assert fit["shift"] == pytest.approx(SHIFT, abs=1e-3)
    assert fit["largest_error"] < 1e-3
    # A confirmation of the sheet at the stops does not start the job for the measured sheet.
    stops = {"checked": list(checks(shop, id))}
    # Another job waits behind it, and does not take the table while this one is compiled.
    other = ordered(shop, registration=None)
    wait_for_state(shop, other, "queued")
    answer = shop.post(url, json=body)
    assert answer.status_code == 200, answer.text
    assert answer.json()["state"] == "received"
    wait_at_table(shop, id)
    assert shop.get(f"/api/jobs/{other}").json()["waiting_for"] == "turn"
    assert shop.post(f"/api/jobs/{id}/confirm", json=stops).status_code == 422
    text = checks(shop, id)["sheet-measured"]
    assert "not moved" in text
    assert "turn 2.000°" in text
    assert b"turn 2.0000 scale 1.000000" in shop.get(f"/api/jobs/{id}/program").content
    _, meta = unpack_columns(shop.get(f"/api/jobs/{id}/toolpath").content)
    assert meta["similarity"][1] == pytest.approx(math.sin(TURN), abs=1e-6)
    done = wait_for_state(shop, id, "done", confirm=True)
    assert done["verdict"]["accepted"]
    events = shop.get(f"/api/jobs/{id}/events").json()
    assert any("marks measured: 3" in event["why"] for event in events)
    assert shop.get(f"/api/jobs/{id}/ticket.pdf").status_code == 200
    wait_for_state(shop, other, "done", confirm=True)


def test_a_job_is_only_measured_at_its_machine_and_with_all_marks(shop: httpx.Client) -> None:
    id = ordered(shop, release=False)
    wait_for_state(shop, id, "ready")
    places = [lie(*mark) for mark in MARKS]

    def refused(positions: list[list[float]], **others: Any) -> tuple[int, str]:
        body = {"positions": positions, **others}
        answer = shop.post(f"/api/jobs/{id}/registration", json=body)
        return answer.status_code, answer.json()["code"]

    assert refused(places) == (409, "registration.not-waiting")
    assert refused(places[:2]) == (422, "registration.count")
    assert refused(places, station=99) == (404, "registration.no-station")
    assert refused([[x, y + (4.0 if x < 55 else 0.0)] for x, y in places]) == (
        422,
        "registration.error",
    )
    # The fit is shown, with its errors, although it cannot be used.
    wrong = [[2.0 * x, 2.0 * y] for x, y in places]
    fit = shop.post(f"/api/jobs/{id}/registration/fit", json={"positions": wrong}).json()
    assert fit["scale"] == pytest.approx(2.0)
    assert fit["refusal"]["code"] == "registration.scale"
    plain = ordered(shop, registration=None, release=False)
    assert shop.get(f"/api/jobs/{plain}/registration").json()["code"] == "registration.no-marks"


def test_a_measurement_is_forgotten_with_the_next_compile(shop: httpx.Client) -> None:
    id = ordered(shop)
    wait_at_table(shop, id)
    url = f"/api/jobs/{id}/registration"
    shop.post(url, json={"positions": [lie(*mark) for mark in MARKS]}).raise_for_status()
    wait_at_table(shop, id)
    assert "sheet-measured" in checks(shop, id)
    moved = shop.post(f"/api/jobs/{id}/transfer", json={"machine": "router-table"})
    assert moved.status_code == 409
    shop.post(f"/api/jobs/{id}/recompile").raise_for_status()
    wait_at_table(shop, id)
    assert "sheet-at-stops" in checks(shop, id)
    # An operator can also forget it: the sheet was laid at the stops.
    shop.post(url, json={"positions": [lie(*mark) for mark in MARKS]}).raise_for_status()
    wait_at_table(shop, id)
    shop.post(url, json={"positions": []}).raise_for_status()
    wait_at_table(shop, id)
    assert "sheet-at-stops" in checks(shop, id)
    assert confirm_job(shop, id).status_code == 200
    wait_for_state(shop, id, "done", confirm=True)


@pytest.mark.parametrize(
    ("registration", "copies", "code"),
    [
        ({"marks": MARKS, "measured": MARKS}, 1, "registration.measured-in-order"),
        ({"marks": MARKS}, 2, "registration.one-copy"),
        ({"marks": [[0, 0], [5, 0]]}, 1, "field.close-marks"),
        ({"marks": [[0, 0]]}, 1, "field.too-few"),
    ],
)
def test_impossible_orders_are_refused(
    shop: httpx.Client, registration: dict[str, Any], copies: int, code: str
) -> None:
    drawing = upload_drawing(shop, square(side=200.0))["id"]
    order = {"drawing": drawing, "board": "e-flute", "copies": copies}
    answer = shop.post("/api/jobs", json={**order, "registration": registration})
    assert answer.status_code == 422
    assert code in answer.text
