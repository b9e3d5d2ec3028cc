"""Routes that list the tracks of a job and continue its work."""

from __future__ import annotations

import itertools
from typing import Any

import httpx
import pytest

from tests.support.serving.server import (
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def interrupted(client: httpx.Client) -> dict[str, Any]:
    """Return a job that its gateway has interrupted in the middle of its first track."""
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, release=True)["id"]
    wait_for_state(client, job, "queued")
    claim = client.post(
        "/api/gateway/claim", json={"gateway": "g", "machine": "demo-table", "wait": 0.0}
    ).json()
    assert claim["job"] == job
    confirm_job(client, job)
    beat = {"job": job, "epoch": claim["epoch"], "line": 0, "waiting": True}
    assert client.post("/api/gateway/heartbeat", json=beat).json()["command"] == "start"
    first = client.get(f"/api/jobs/{job}/tracks").json()[0]
    end = {
        "job": job,
        "epoch": claim["epoch"],
        "outcome": "interrupted",
        "line": first["first_line"] + 1,
        "line_at_most": first["first_line"] + 1,
    }
    row: dict[str, Any] = client.post("/api/gateway/finish", json=end).json()
    assert (row["state"], row["actions"][0]) == ("interrupted", "rest")
    return row


def test_the_hint_begins_with_the_tracks_that_are_left(
    client: httpx.Client, interrupted: dict[str, Any]
) -> None:
    path = f"/api/jobs/{interrupted['id']}"
    tracks = client.get(f"{path}/tracks").json()
    count = len(tracks)
    left = f"{count} track left" if count == 1 else f"{count} tracks left"
    for row in (interrupted, client.get(path).json()):
        assert row["hint"] == row["message"]["hint"]
        assert row["hint"].startswith(f"Continue this sheet, {left}. ")
        assert "queue the job again" in row["hint"]


def test_the_tracks_have_lines_edges_and_states(
    client: httpx.Client, interrupted: dict[str, Any]
) -> None:
    rows = client.get(f"/api/jobs/{interrupted['id']}/tracks").json()
    assert [row["number"] for row in rows] == list(range(1, len(rows) + 1))
    assert {row["stage"] for row in rows} == {1}
    assert rows[0]["state"] == "begun"
    assert {row["state"] for row in rows[1:]} <= {"uncut"}
    assert sorted(edge for row in rows for edge in row["edges"]) == [0, 1, 2, 3]
    for row, following in itertools.pairwise(rows):
        assert row["first_line"] <= row["last_line"] < following["first_line"]


@pytest.mark.parametrize(
    "body",
    [
        {"from_track": 1, "from_line": 9},
        {"whole": True, "station": 1},
        {"copies": 2},
        {"remaining": True, "from_track": 1},
        {"remaining": True, "whole": True},
        {"from_track": 99},
        {"made": [1], "from_track": 2},
        {"made": [1], "whole": True},
        {"made": [0]},
        {"station": 9},
    ],
)
def test_a_choice_that_means_nothing_is_refused(
    client: httpx.Client, interrupted: dict[str, Any], body: dict[str, Any]
) -> None:
    answer = client.post(f"/api/jobs/{interrupted['id']}/rest", json=body)
    assert answer.status_code == 422
    assert answer.json()["detail"]


def test_the_rest_is_compiled_queued_and_frees_the_table(
    client: httpx.Client, interrupted: dict[str, Any]
) -> None:
    key = {"Idempotency-Key": "rest of the square"}
    parent = interrupted["id"]
    answer = client.post(f"/api/jobs/{parent}/rest", json={"release": True}, headers=key)
    assert answer.status_code == 201
    job = answer.json()
    assert answer.headers["Location"] == f"/api/jobs/{job['id']}"
    assert (job["resumes"], job["is_rest"], job["board"]) == (parent, True, interrupted["board"])
    again = client.post(f"/api/jobs/{parent}/rest", json={"release": True}, headers=key)
    assert again.json()["id"] == job["id"]
    queued = wait_for_state(client, job["id"], "queued")
    assert queued["verdict"]["accepted"]
    assert client.get(f"/api/jobs/{parent}").json()["state"] == "continued"
    text = client.get(f"/api/jobs/{job['id']}/program").text
    assert f"continues job {parent}" in text
    other = client.post(f"/api/jobs/{parent}/rest", json={})
    assert (other.status_code, other.json()["code"]) == (409, "rest.continued-already")
    copy = client.post(f"/api/jobs/{parent}/rest", json={"whole": True, "copies": 2}).json()
    assert (copy["resumes"], copy["is_rest"], copy["copies"]) == (parent, False, 2)
    whole = wait_for_state(client, copy["id"], "ready")
    assert whole["program_sha256"] == interrupted["program_sha256"]
    for id in (job["id"], copy["id"]):
        assert client.post(f"/api/jobs/{id}/cancel").status_code == 200


def begun(client: httpx.Client, **end: Any) -> dict[str, Any]:
    """Return a job that its gateway has begun and interrupted; ``end`` is a part of its report."""
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, release=True)["id"]
    wait_for_state(client, job, "queued")
    claim = client.post(
        "/api/gateway/claim", json={"gateway": "g", "machine": "demo-table", "wait": 0.0}
    ).json()
    confirm_job(client, job)
    beat = {"job": job, "epoch": claim["epoch"], "line": 0, "waiting": True}
    assert client.post("/api/gateway/heartbeat", json=beat).json()["command"] == "start"
    report = {"job": job, "epoch": claim["epoch"], "outcome": "interrupted", **end}
    row: dict[str, Any] = client.post("/api/gateway/finish", json=report).json()
    return row


def test_a_sheet_whose_tracks_are_not_known_needs_a_statement(client: httpx.Client) -> None:
    row = begun(client, line=1)
    parent, lines = row["id"], row["lines"]
    assert row["stopped_at"]["line_at_most"] == lines
    assert not row["stopped_at"]["certain"]
    tracks = client.get(f"/api/jobs/{parent}/tracks").json()
    assert {track["state"] for track in tracks} == {"unknown"}
    for statement in ({}, {"made": True}, {"made": True, "from_track": 1}, {"from_track": 1}):
        answer = client.post(f"/api/jobs/{parent}/rest", json={"release": True, **statement})
        assert (answer.status_code, answer.json()["code"]) == (422, "rest.statement-needed")
        assert answer.json()["arguments"]["tracks"] == len(tracks)
    wrong = client.post(f"/api/jobs/{parent}/rest", json={"made": [len(tracks) + 1]})
    assert (wrong.status_code, wrong.json()["code"]) == (422, "rest.no-such-track")
    nothing_left = {"made": [track["number"] for track in tracks]}
    answer = client.post(f"/api/jobs/{parent}/rest", json=nothing_left)
    assert (answer.status_code, answer.json()["code"]) == (422, "rest.no-tracks")
    rest = client.post(f"/api/jobs/{parent}/rest", json={"made": []}).json()
    ready = wait_for_state(client, rest["id"], "ready")
    assert ready["verdict"]["accepted"]
    assert client.post(f"/api/jobs/{rest['id']}/cancel").status_code == 200
    assert client.post(f"/api/jobs/{parent}/scrap").status_code == 200


def test_the_remaining_copies_are_ordered_by_one_call(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, release=True, copies=3)["id"]
    wait_for_state(client, job, "queued")
    claim = client.post(
        "/api/gateway/claim", json={"gateway": "g", "machine": "demo-table", "wait": 0.0}
    ).json()
    confirm_job(client, job)
    beat = {"job": job, "epoch": claim["epoch"], "line": 0, "waiting": True}
    assert client.post("/api/gateway/heartbeat", json=beat).json()["command"] == "start"
    end = {"job": job, "epoch": claim["epoch"], "outcome": "interrupted", "line": 20}
    end["line_at_most"] = 20
    client.post("/api/gateway/finish", json={**end, "copies_done": 1})
    body = {"remaining": True, "release": True}
    refused = client.post(f"/api/jobs/{job}/rest", json=body)
    assert (refused.status_code, refused.json()["code"]) == (409, "rest.sheet-first")
    assert client.post(f"/api/jobs/{job}/scrap").json()["remaining_copies"] == 2
    answer = client.post(f"/api/jobs/{job}/rest", json=body)
    assert answer.status_code == 201
    copies = answer.json()
    assert (copies["resumes"], copies["is_rest"], copies["copies"]) == (job, False, 2)
    assert client.get(f"/api/jobs/{job}").json()["remaining_copies"] == 0
    none = client.post(f"/api/jobs/{job}/rest", json=body)
    assert (none.status_code, none.json()["code"]) == (409, "rest.no-copies")
    wait_for_state(client, copies["id"], "queued")
    client.post(f"/api/jobs/{copies['id']}/cancel")
    assert client.get(f"/api/jobs/{job}").json()["remaining_copies"] == 2
