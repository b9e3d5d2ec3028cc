"""History, statistics and the use of tools over REST."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from knifetip.contract.job import ENDED
from tests.support.serving.server import (
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")

MACHINE = "demo-table"
TOOLS = f"/api/machines/{MACHINE}/tools"


@pytest.fixture(scope="module")
def cancelled(client: httpx.Client) -> list[str]:
    """Return the ids of three cancelled jobs for a drawing, the first ordered first."""
    drawing = upload_drawing(client, square())["id"]
    jobs = [order_job(client, drawing)["id"] for _ in range(3)]
    for id in jobs:
        wait_for_state(client, id, "ready")
        client.post(f"/api/jobs/{id}/cancel").raise_for_status()
    return jobs


def claimed(client: httpx.Client, copies: int) -> dict[str, Any]:
    """Return the claim of a job that waits for its confirmation; all other jobs are cancelled."""
    for entry in client.get(f"/api/machines/{MACHINE}/queue").json()["entries"]:
        client.post(f"/api/jobs/{entry['job']['id']}/cancel")
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, copies=copies, release=True)
    wait_for_state(client, job["id"], "queued")
    claim: dict[str, Any] = client.post(
        "/api/gateway/claim", json={"gateway": "history", "machine": MACHINE}
    ).json()
    assert claim["job"] == job["id"]
    return claim


def finished(client: httpx.Client, copies: int) -> dict[str, Any]:
    """Return a job that a gateway has finished."""
    claim = claimed(client, copies)
    confirm_job(client, claim["job"]).raise_for_status()
    end = {"job": claim["job"], "epoch": claim["epoch"], "outcome": "done", "line": claim["lines"]}
    client.post("/api/gateway/finish", json=end).raise_for_status()
    return wait_for_state(client, claim["job"], "done")


@pytest.fixture(scope="module")
def done(client: httpx.Client) -> dict[str, Any]:
    """Return a job with two copies that a gateway has finished."""
    return finished(client, 2)


def test_a_job_has_the_times_of_its_run(
    client: httpx.Client, done: dict[str, Any], cancelled: list[str]
) -> None:
    assert done["created"] < done["started"] <= done["ended"]
    # One that no machine has begun has no start.
    assert client.get(f"/api/jobs/{cancelled[0]}").json()["started"] is None


def test_history_has_pages_and_filters(client: httpx.Client, cancelled: list[str]) -> None:
    asked: dict[str, Any] = {
        "state": "cancelled",
        "drawing": "SQUARE",
        "machine": MACHINE,
        "limit": 2,
    }
    first = client.get("/api/history", params=asked)
    assert [job["id"] for job in first.json()] == cancelled[:0:-1]
    assert first.json()[0]["ended"]
    second = client.get(first.links["next"]["url"])
    assert second.json()[0]["id"] == cancelled[0]
    since = first.json()[0]["ended"]
    found = client.get("/api/history", params={**asked, "since": since}).json()
    assert [job["id"] for job in found] == cancelled[2:]


@pytest.mark.parametrize("state", ENDED)
def test_history_has_every_state_in_which_a_job_ends(client: httpx.Client, state: str) -> None:
    found = client.get("/api/history", params={"state": state})
    assert found.status_code == 200
    assert {job["state"] for job in found.json()} <= {state}


@pytest.mark.parametrize(
    "query", ["cursor=1", "cursor=x-1", "limit=0", "state=queued", "since=nan", "colour=red"]
)
def test_a_query_that_history_does_not_have_is_refused(client: httpx.Client, query: str) -> None:
    assert client.get(f"/api/history?{query}").status_code == 422


def test_statistics_count_the_copies_and_their_lengths(
    client: httpx.Client, done: dict[str, Any]
) -> None:
    asked = {"machine": MACHINE, "since": done["ended"], "zone": "Europe/Berlin", "step": "day"}
    (sums,) = client.get("/api/statistics", params=asked).json()
    assert (sums["jobs"], sums["copies"], sums["sheets"]) == (1, 2, {"e-flute": 2})
    # Two squares of 100 mm.
    assert sums["lengths"]["cut"] == pytest.approx(0.8, abs=0.005)
    assert sums["interrupted_share"] == 0.0


@pytest.mark.parametrize("zone", ["Nowhere", "../etc/passwd", ""])
def test_an_unknown_time_zone_is_refused(client: httpx.Client, zone: str) -> None:
    answer = client.get("/api/statistics", params={"zone": zone})
    assert (answer.status_code, answer.json()["code"]) == (422, "request.unknown-zone")


def test_a_tool_has_a_life_and_a_change(client: httpx.Client, done: dict[str, Any]) -> None:
    (station,) = (tool["station"] for tool in done["tools"])
    life = {"life": 0.1, "by": "Mia"}
    tools = client.put(f"{TOOLS}/{station}/life", json=life).json()
    used = {tool["station"]: tool for tool in tools}[station]
    assert used["used"] >= 0.8
    assert (used["warning"], used["message"]["code"]) == ("over", "tool-life.over")
    tools = client.post(f"{TOOLS}/{station}/changed", json={"by": "Mia"}).json()
    changed = {tool["station"]: tool for tool in tools}[station]
    assert (changed["used"], changed["warning"], changed["changed_by"]) == (0, "", "operator Mia")
    assert client.get(TOOLS).json() == tools
    events = client.get(f"{TOOLS}/events").json()
    assert [event["kind"] for event in events[:2]] == ["changed", "life"]
    assert events[0]["length"] == pytest.approx(used["used"])
    client.put(f"{TOOLS}/{station}/life", json={"life": 0.0}).raise_for_status()


@pytest.fixture
def worn(client: httpx.Client) -> Iterator[dict[str, Any]]:
    """Return a job that waits for its confirmation, with the one station whose tool is worn."""
    (station,) = (tool["station"] for tool in finished(client, 1)["tools"])
    claim = claimed(client, 1)
    client.put(f"{TOOLS}/{station}/life", json={"life": 0.1}).raise_for_status()
    yield {"id": claim["job"], "station": station}
    client.put(f"{TOOLS}/{station}/life", json={"life": 0.0}).raise_for_status()
    client.post(f"/api/jobs/{claim['job']}/cancel").raise_for_status()


def test_a_worn_tool_needs_a_new_tool_or_a_reason(
    client: httpx.Client, worn: dict[str, Any]
) -> None:
    for body in ({}, {"worn_reason": "  "}):
        refused = confirm_job(client, worn["id"], **body)
        assert (refused.status_code, refused.json()["code"]) == (409, "job.worn-tools")
    assert client.get(f"/api/jobs/{worn['id']}").json()["waiting_for"] == "confirmation"
    kept = confirm_job(client, worn["id"], worn_reason="one more sheet", by="Mia")
    assert kept.status_code == 200
    events = client.get(f"/api/jobs/{worn['id']}/events").json()
    assert "one more sheet" in events[-2]["why"]


def test_a_new_tool_is_stated_with_the_confirmation(
    client: httpx.Client, worn: dict[str, Any]
) -> None:
    answer = confirm_job(client, worn["id"], changed=[worn["station"]], by="Mia")
    assert answer.status_code == 200
    tools = {tool["station"]: tool for tool in client.get(TOOLS).json()}
    assert tools[worn["station"]]["used"] == 0.0
    assert tools[worn["station"]]["changed_by"] == "operator Mia"


@pytest.mark.parametrize(("path", "status"), [("tools/99/changed", 404), ("tools/x/changed", 422)])
def test_a_station_must_exist(client: httpx.Client, path: str, status: int) -> None:
    assert client.post(f"/api/machines/{MACHINE}/{path}").status_code == status
