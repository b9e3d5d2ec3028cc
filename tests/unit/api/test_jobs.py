from __future__ import annotations

import hashlib

import httpx
import pytest

import dxf_text as text
from knifetip.jobs.columns import unpacked
from serving import ordered, square, until, uploaded

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def ready(client: httpx.Client) -> dict:
    """A job that is ready."""
    job = ordered(client, uploaded(client, square())["id"])
    return until(client, job["id"], "ready")


def test_a_square_of_cuts_becomes_ready_with_a_verdict(client: httpx.Client, ready: dict):
    assert ready["verdict"]["accepted"] is True
    assert ready["verdict"]["deviation"] <= 0.01
    assert ready["seconds"] > 0.0
    assert (ready["stage"], ready["progress"], ready["line"]) == ("", 1.0, 0)
    events = client.get(f"/api/jobs/{ready['id']}/events").json()
    assert [event["state"] for event in events] == ["received", "compiling", "ready"]


def test_the_program_is_served_byte_for_byte_as_it_was_judged(client: httpx.Client, ready: dict):
    answer = client.get(f"/api/jobs/{ready['id']}/program")
    assert hashlib.sha256(answer.content).hexdigest() == ready["program_sha256"]
    assert answer.content.count(b"\n") == ready["lines"]
    assert answer.headers["content-disposition"] == 'attachment; filename="square-demo-table.nc"'
    assert answer.headers["etag"] == f'"{ready["program_sha256"]}"'


def test_the_toolpath_comes_as_columns_that_know_their_lines(client: httpx.Client, ready: dict):
    columns, meta = unpacked(client.get(f"/api/jobs/{ready['id']}/toolpath").content)
    rows = len(columns["bulge"])
    assert columns["pose"].shape == (rows + 1, 4)
    assert all(len(columns[name]) == rows for name in ("motion", "feed", "source", "tool", "line"))
    assert meta["placement"] == [20.0, 20.0]
    assert [station["number"] for station in meta["stations"]] == [1, 2, 3]
    # Each of the four edges is worked, and each row's line is a motion of the program.
    assert {0, 1, 2, 3} <= set(columns["source"].tolist())
    lines = client.get(f"/api/jobs/{ready['id']}/program").content.split(b"\n")
    assert all(b"G" in lines[line - 1] for line in columns["line"].tolist() if line > 0)
    assert (columns["line"] > 0).sum() >= 4


def test_the_verdict_has_a_row_for_every_edge(client: httpx.Client, ready: dict):
    verdict = client.get(f"/api/jobs/{ready['id']}/verdict").json()
    assert len(verdict["edge_deviation"]) == len(verdict["edge_uncut"]) == 4
    assert verdict["deviation"] == max(verdict["edge_deviation"])
    assert verdict["findings"] == []


def test_a_drawing_with_open_questions_is_409_with_the_questions(client: httpx.Client):
    mystery = text.line(10.0, 50.0, 90.0, 50.0, (8, "MYSTERY"), (62, 30))
    drawing = uploaded(client, square(units=None, extra=(mystery,)))["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute"})
    assert answer.status_code == 409
    assert answer.headers["content-type"] == "application/problem+json"
    kinds = [question["kind"] for question in answer.json()["questions"]]
    assert kinds == ["unit", "line-type"]
    assert [job for job in client.get("/api/jobs").json() if job["drawing"] == drawing] == []


def test_an_override_in_the_order_counts_for_the_job_alone(client: httpx.Client):
    mystery = text.line(10.0, 50.0, 90.0, 50.0, (8, "MYSTERY"), (62, 30))
    drawing = uploaded(client, square(extra=(mystery,)))["id"]
    job = ordered(client, drawing, overrides=[{"type": "crease", "layer": "MYSTERY"}])
    until(client, job["id"], "ready")
    assert len(client.get(f"/api/drawings/{drawing}").json()["questions"]) == 1


def test_a_drawing_larger_than_the_table_is_refused_with_its_measure(client: httpx.Client):
    drawing = uploaded(client, square(side=5000.0))["id"]
    job = until(client, ordered(client, drawing)["id"], "refused")
    assert "5000.0 × 5000.0 mm" in job["reason"]
    assert job["mend"] != ""
    for part in ("program", "toolpath", "verdict"):
        assert client.get(f"/api/jobs/{job['id']}/{part}").status_code == 409


def test_a_job_is_released_and_cancelled(client: httpx.Client):
    drawing = uploaded(client, square())["id"]
    job = ordered(client, drawing)["id"]
    until(client, job, "ready")
    assert client.post(f"/api/jobs/{job}/release").json()["state"] == "queued"
    assert client.post(f"/api/jobs/{job}/cancel").json()["state"] == "cancelled"
    again = client.post(f"/api/jobs/{job}/cancel")
    assert again.status_code == 409
    assert again.json()["type"] == "urn:knifetip:problem:wrong-state"


def test_jobs_are_listed_by_state_and_page_by_page(client: httpx.Client, ready: dict):
    drawing = uploaded(client, square())["id"]
    new = [ordered(client, drawing)["id"] for _ in range(3)]
    for id in new:
        until(client, id, "ready")
    first = client.get("/api/jobs", params={"state": "ready", "limit": 2})
    assert [job["id"] for job in first.json()] == new[:0:-1]
    path = first.headers["link"].split(">")[0].lstrip("<")
    rest = client.get(path).json()
    assert rest[0]["id"] == new[0]
    assert {job["state"] for job in rest} == {"ready"}
    nothing = client.get("/api/jobs", params={"state": ["running", "held"]})
    assert nothing.json() == []


def test_the_same_key_orders_once(client: httpx.Client):
    drawing = uploaded(client, square())["id"]

    def order(**more: object) -> httpx.Response:
        return client.post(
            "/api/jobs",
            json={"drawing": drawing, "board": "e-flute", **more},
            headers={"Idempotency-Key": "erp-1"},
        )

    first = order()
    assert order().json()["id"] == first.json()["id"]
    assert order(copies=2).status_code == 422
    mine = [job for job in client.get("/api/jobs").json() if job["drawing"] == drawing]
    assert len(mine) == 1


@pytest.mark.parametrize(
    ("field", "value", "words"),
    [
        ("machine", "no-such", "machine 'no-such'"),
        ("machine", "/etc/passwd.toml", "machine"),
        ("board", "../boards/e-flute", "board"),
        ("profile", "no-such", "profile 'no-such'"),
    ],
)
def test_what_is_not_in_the_library_is_named(
    client: httpx.Client, field: str, value: str, words: str
):
    drawing = uploaded(client, square())["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute", field: value})
    assert answer.status_code == 422
    assert words in answer.json()["detail"]
    assert answer.json()["mend"].startswith("There are ")
