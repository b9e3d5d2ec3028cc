"""All stages through REST: upload, order, and a job that the simulated table runs to its end."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from tests.support.serving.server import (
    Running,
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.support.truth.named import NAMED, SAMPLES, Named
from tests.support.writers import cf2_text, pdf_text, svg_text

pytestmark = pytest.mark.xdist_group("corridor")

MAILER = Named("generated__kyholdings__diecut_generator", "mailer_200x150x60_t3.svg", "e-flute")


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """Run a server with a simulated table at fifty times its speed; yield a client."""
    with Running(tmp_path_factory.mktemp("shop") / "shop.sqlite", speed=50.0) as client:
        yield client


def runs_to_its_end(shop: httpx.Client, named: Named, corpus: Path | None) -> None:
    asked = {"profile": named.profile} | ({"unit": named.unit} if named.unit else {})
    drawing = upload_drawing(shop, named.data(corpus), **asked)
    assert drawing["questions"] == []
    job = order_job(shop, drawing["id"], board=named.board, release=True)["id"]
    done = wait_for_state(shop, job, "done", confirm=True)
    assert done["verdict"]["accepted"]
    assert (done["line"], done["progress"]) == (done["lines"], 1.0)


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_a_sample_runs_to_its_end(shop: httpx.Client, named: Named) -> None:
    runs_to_its_end(shop, named, None)


@pytest.mark.corpus
@pytest.mark.parametrize("named", NAMED, ids=str)
def test_a_drawing_by_another_author_runs_to_its_end(
    shop: httpx.Client, named: Named, corpus: Path
) -> None:
    runs_to_its_end(shop, named, corpus)


@pytest.mark.corpus
def test_an_svg_by_another_author_runs_to_its_end(shop: httpx.Client, corpus: Path) -> None:
    runs_to_its_end(shop, MAILER, corpus)


@pytest.mark.parametrize(
    ("data", "unit"),
    [
        (svg_text.carton(), "mm"),
        (cf2_text.carton(), "mm"),
        (pdf_text.carton(), "pt"),
        (pdf_text.carton(layered=False, flate=True), "pt"),
    ],
    ids=["svg", "cf2", "pdf", "pdf-spots"],
)
def test_a_carton_in_another_format_runs_to_its_end(
    shop: httpx.Client, data: bytes, unit: str
) -> None:
    drawing = upload_drawing(shop, data)
    assert (drawing["unit"], drawing["questions"]) == (unit, [])
    rows = drawing["import_report"]["rows"]
    edges = shop.get(f"/api/drawings/{drawing['id']}/edges").json()["edges"]
    drawn = sum(edge["length"] for edge in edges)
    assert sum(row["length"] for row in rows) == pytest.approx(drawn, abs=1e-3)
    assert {edge["type"] for edge in edges} == {"cut", "crease"}
    assert shop.get(f"/api/drawings/{drawing['id']}/file").content == data
    job = order_job(shop, drawing["id"], release=True)["id"]
    done = wait_for_state(shop, job, "done", confirm=True)
    assert done["verdict"]["accepted"]
    assert (done["line"], done["progress"]) == (done["lines"], 1.0)


def test_three_copies_stop_for_a_new_sheet_between_them(shop: httpx.Client) -> None:
    drawing = upload_drawing(shop, square())["id"]
    job = order_job(shop, drawing, copies=3, release=True)["id"]
    for copy in (1, 2):
        while wait_for_state(shop, job, "held", "running", confirm=True)["copies_done"] < copy:
            time.sleep(0.02)
        waiting = wait_for_state(shop, job, "held")
        assert waiting["waiting_for"] == "sheet"
        text = f"Copy {copy} of 3 of the job is finished. The next copy needs a new sheet."
        assert waiting["reason"] == text
        assert (
            waiting["hint"] == "Put a new sheet of Corrugated, E-flute 1.6 mm on the table, "
            "then confirm the new sheet. The machine then starts the next copy."
        )
        refused = shop.post(f"/api/jobs/{job}/resume", json={"hands_clear": True})
        assert (refused.status_code, refused.json()["code"]) == (409, "job.needs-sheet")
        assert confirm_job(shop, job).status_code == 200
    done = wait_for_state(shop, job, "done", confirm=True)
    assert done["copies_done"] == 3
    reasons = [event["why"] for event in shop.get(f"/api/jobs/{job}/events").json()]
    assert (
        "Copy 1 of 3 of the job is finished. The next copy needs a new sheet of board." in reasons
    )
    assert (
        "Copy 2 of 3 of the job is finished. The next copy needs a new sheet of board." in reasons
    )


def test_hold_resume_and_cancel_reach_the_machine(shop: httpx.Client) -> None:
    drawing = upload_drawing(shop, square(side=1000.0))["id"]
    job = order_job(shop, drawing, copies=2, release=True)["id"]
    wait_for_state(shop, job, "held", confirm=True)
    shop.post(f"/api/jobs/{job}/cancel")
    cancelled = wait_for_state(shop, job, "cancelled")
    assert cancelled["copies_done"] == 1
    assert shop.get("/api/machines/demo-table").json()["job"] is None


def test_the_next_job_waits_for_the_operator_and_states_the_reason(shop: httpx.Client) -> None:
    drawing = upload_drawing(shop, square())["id"]
    first, second = (order_job(shop, drawing, release=True)["id"] for _ in range(2))
    wait_for_state(shop, first, "done", confirm=True)
    deadline = time.monotonic() + 60.0
    while (found := shop.get(f"/api/jobs/{second}").json())["waiting_for"] != "confirmation":
        assert time.monotonic() < deadline, found
        time.sleep(0.02)
    assert found["state"] == "queued"
    assert found["reason"] == (
        "The job waits until the operator of Demo table 1600 × 1200 "
        "confirms that the table is clear. Required: board 'Corrugated, E-flute 1.6 mm'. "
        "Tools: Oscillating knife (station 1)."
    )
    assert found["hint"] == "Check the table, then confirm the job to start it."
    assert found["tools"] == [{"station": 1, "name": "Oscillating knife", "kind": "knife"}]
    time.sleep(1.0)
    assert shop.get(f"/api/jobs/{second}").json()["state"] == "queued"
    assert shop.get("/api/machines/demo-table").json()["job"] is None
    assert confirm_job(shop, second, by="Kim").status_code == 200
    wait_for_state(shop, second, "done")
    events = shop.get(f"/api/jobs/{second}/events").json()
    rows = [(event["state"], event["who"], event["why"]) for event in events]
    assert (
        "queued",
        "operator Kim",
        "The operator confirmed that the table is clear and that the board on it is e-flute.",
    ) in rows


def test_a_job_that_waits_is_cancelled_at_once_and_the_next_one_is_offered(
    shop: httpx.Client,
) -> None:
    drawing = upload_drawing(shop, square())["id"]
    first, second = (order_job(shop, drawing, release=True)["id"] for _ in range(2))
    deadline = time.monotonic() + 60.0
    while shop.get(f"/api/jobs/{first}").json()["waiting_for"] != "confirmation":
        assert time.monotonic() < deadline
        time.sleep(0.02)
    assert shop.post(f"/api/jobs/{first}/cancel").json()["state"] == "cancelled"
    assert wait_for_state(shop, second, "done", confirm=True)["copies_done"] == 1
