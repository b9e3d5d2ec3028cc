"""Facts about programs and options without a form of their own, from the order to the answer."""

from __future__ import annotations

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")


def test_a_job_has_the_size_of_its_program_and_keeps_note_and_feeds(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    feeds = [{"edges": [1], "line_type": None, "factor": 0.5}]
    ordered = order_job(client, drawing, program_note="grain up", edge_feeds=feeds)
    assert ordered["program_bytes"] == 0
    job = wait_for_state(client, ordered["id"], "ready", "refused")
    program = client.get(f"/api/jobs/{job['id']}/program").content
    assert (job["state"], job["program_bytes"]) == ("ready", len(program))
    assert (job["program_note"], job["edge_feeds"]) == ("grain up", feeds)
    assert b"(grain up)" in program
    # The square of 100 mm, and what the knife cuts beyond its start.
    assert 400.0 <= job["worked_length"] < 405.0
    assert ordered["worked_length"] == 0.0
    # The clearance of demo-table is the height of travel between the cuts.
    assert job["verdict"]["lowest_travel"] > 0.0
    # A job that takes over the program has its facts, too.
    again = order_job(client, drawing, program_note="grain up", edge_feeds=feeds)
    same = wait_for_state(client, again["id"], "ready", "refused")
    assert (same["program_of"], same["program_bytes"]) == (job["id"], len(program))
    assert same["worked_length"] == job["worked_length"]


def test_a_note_has_a_greatest_length(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = {"drawing": drawing, "machine": "demo-table", "board": "e-flute"}
    refused = client.post("/api/jobs", json={**order, "program_note": "x" * 61})
    assert refused.status_code == 422
    assert "program_note" in refused.text
