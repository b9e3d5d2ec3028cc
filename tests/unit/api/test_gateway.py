from __future__ import annotations

import time
from collections.abc import Iterator

import httpx
import pytest

from serving import ordered, square, until, uploaded

pytestmark = pytest.mark.xdist_group("server")

MACHINE = "demo-table"


def claim(client: httpx.Client, gateway: str = "g", wait: float = 0.0) -> httpx.Response:
    return client.post(
        "/api/gateway/claim", json={"gateway": gateway, "machine": MACHINE, "wait": wait}
    )


def beat(client: httpx.Client, job: dict, line: int, **more: object) -> httpx.Response:
    said = {"job": job["job"], "epoch": job["epoch"], "line": line, **more}
    return client.post("/api/gateway/heartbeat", json=said)


def finish(client: httpx.Client, job: dict, outcome: str = "done") -> httpx.Response:
    said = {"job": job["job"], "epoch": job["epoch"], "outcome": outcome}
    return client.post("/api/gateway/finish", json=said)


@pytest.fixture
def queued(client: httpx.Client) -> dict:
    drawing = uploaded(client, square())["id"]
    return until(client, ordered(client, drawing, release=True)["id"], "queued")


@pytest.fixture
def claimed(client: httpx.Client, queued: dict) -> Iterator[dict]:
    job = claim(client).json()
    assert job["job"] == queued["id"]
    yield job
    if client.get(f"/api/jobs/{job['job']}").json()["state"] in ("running", "held"):
        finish(client, job)


def test_a_claim_with_nothing_to_do_waits_and_answers_204(client: httpx.Client):
    began = time.monotonic()
    assert claim(client, wait=0.5).status_code == 204
    assert 0.4 < time.monotonic() - began < 15.0
    machine = client.get(f"/api/machines/{MACHINE}").json()
    assert (machine["gateway"], machine["job"]) == ("connected", None)


def test_a_claim_brings_the_program_that_was_verified(client: httpx.Client, claimed: dict):
    job = client.get(f"/api/jobs/{claimed['job']}").json()
    assert job["state"] == "running"
    assert (claimed["sha256"], claimed["lines"]) == (job["program_sha256"], job["lines"])
    program = client.get(claimed["program"])
    assert program.content == client.get(f"/api/jobs/{claimed['job']}/program").content
    assert client.get(f"/api/machines/{MACHINE}").json()["job"] == claimed["job"]


def test_a_second_gateway_gets_nothing_while_the_table_is_taken(
    client: httpx.Client, claimed: dict
):
    drawing = uploaded(client, square())["id"]
    other = until(client, ordered(client, drawing, release=True)["id"], "queued")
    assert claim(client, "another").status_code == 204
    finish(client, claimed, "interrupted")
    assert claim(client, "another").status_code == 204
    client.post(f"/api/jobs/{claimed['job']}/scrap")
    got = claim(client, "another")
    assert got.json()["job"] == other["id"]
    finish(client, got.json())


def test_heartbeats_move_the_job_and_bring_the_operators_wishes(
    client: httpx.Client, claimed: dict
):
    id, lines = claimed["job"], claimed["lines"]
    assert beat(client, claimed, 5, position=[1.0, 2.0, 3.0, 4.0], seconds_left=7.5).json() == {
        "command": "continue",
        "lease": 10.0,
    }
    job = client.get(f"/api/jobs/{id}").json()
    assert (job["line"], job["position"], job["seconds_left"]) == (5, [1.0, 2.0, 3.0, 4.0], 7.5)
    assert job["progress"] == pytest.approx(5 / lines)
    assert client.post(f"/api/jobs/{id}/hold").json()["wish"] == "hold"
    assert beat(client, claimed, 6).json()["command"] == "hold"
    beat(client, claimed, 6, held=True)
    assert client.get(f"/api/jobs/{id}").json()["state"] == "held"
    client.post(f"/api/jobs/{id}/resume")
    assert beat(client, claimed, 6, held=True).json()["command"] == "resume"
    beat(client, claimed, 7)
    assert client.get(f"/api/jobs/{id}").json()["state"] == "running"
    client.post(f"/api/jobs/{id}/cancel")
    assert beat(client, claimed, 8).json()["command"] == "cancel"
    assert finish(client, claimed, "cancelled").json()["state"] == "cancelled"


@pytest.mark.parametrize(
    "said",
    ['"position": [0, 0, NaN, 0]', '"position": [Infinity, 0, 0, 0]', '"seconds_left": NaN'],
)
def test_a_heartbeat_with_what_is_no_number_is_refused(
    client: httpx.Client, claimed: dict, said: str
):
    body = f'{{"job": "{claimed["job"]}", "epoch": {claimed["epoch"]}, "line": 1, {said}}}'
    answer = client.post(
        "/api/gateway/heartbeat", content=body, headers={"Content-Type": "application/json"}
    )
    assert answer.status_code == 422
    assert client.get(f"/api/jobs/{claimed['job']}").json()["line"] == 0


def test_a_stale_epoch_is_refused(client: httpx.Client, claimed: dict):
    old = {**claimed, "epoch": claimed["epoch"] - 1}
    for answer in (beat(client, old, 1), finish(client, old)):
        assert answer.status_code == 409
        assert answer.json()["type"] == "urn:knifetip:problem:stale-epoch"
    finish(client, claimed)
    assert beat(client, claimed, 9).status_code == 409


def test_an_interrupted_job_runs_again_when_the_operator_says_so(
    client: httpx.Client, claimed: dict
):
    assert finish(client, claimed, "interrupted").json()["state"] == "interrupted"
    client.post(f"/api/jobs/{claimed['job']}/requeue")
    again = claim(client).json()
    assert again["job"] == claimed["job"]
    assert again["epoch"] > claimed["epoch"]
    assert finish(client, again).json()["state"] == "done"


def test_a_program_is_given_out_only_while_its_job_is_on_a_table(
    client: httpx.Client, queued: dict
):
    answer = client.get(f"/api/gateway/program/{queued['id']}")
    assert answer.status_code == 409
    assert "is queued" in answer.json()["detail"]
    client.post(f"/api/jobs/{queued['id']}/cancel")
