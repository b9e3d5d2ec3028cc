"""The server's process is killed, as by a power failure, and no data are lost."""

from __future__ import annotations

import random
import time
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
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("kill")

#: 10,000 slits of 8.5 mm: their compilation takes long enough to be killed in the middle.
SLITS = text.dxf(
    *(
        text.line(i * 12.0, j * 11.0, i * 12.0 + 8.0, j * 11.0 + 3.0, (8, "CUT"))
        for i in range(100)
        for j in range(100)
    )
)


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "shop.sqlite"


def course(client: httpx.Client, job: str) -> list[str]:
    return [event["state"] for event in client.get(f"/api/jobs/{job}/events").json()]


def test_killed_while_it_compiles_it_compiles_again(database: Path) -> None:
    first = Running(database, processes=1, simulator=False)
    drawing = upload_drawing(first.client, SLITS, unit="mm")["id"]
    job = order_job(first.client, drawing)["id"]
    wait_for_state(first.client, job, "compiling")
    first.kill()
    with Running(database, processes=1, simulator=False) as client:
        found = wait_for_state(client, job, "ready")
        assert found["verdict"]["accepted"]
        assert found["lines"] > 10_000
        states = course(client, job)
        # The kill interrupted the compilation: it started twice and ended once.
        assert states.count("compiling") == 2
        assert states.count("ready") == 1


@pytest.mark.long
def test_killed_while_it_is_queued_it_is_queued_and_then_runs_to_its_end(database: Path) -> None:
    first = Running(database, processes=1, simulator=False)
    job = order_job(first.client, upload_drawing(first.client, square())["id"], release=True)["id"]
    sha256 = wait_for_state(first.client, job, "queued")["program_sha256"]
    first.kill()
    with Running(database, processes=1, speed=200.0) as client:
        assert wait_for_state(client, job, "done", confirm=True)["program_sha256"] == sha256
        # Queued once, claimed, checked and confirmed: neither compiled nor queued again.
        assert course(client, job)[-6:] == ["queued"] * 4 + ["running", "done"]
        assert course(client, job).count("queued") == 4


def test_killed_while_it_runs_it_comes_back_as_interrupted(database: Path) -> None:
    first = Running(database, processes=1, speed=0.2)
    drawing = upload_drawing(first.client, square())["id"]
    job = order_job(first.client, drawing, release=True)["id"]
    wait_for_state(first.client, job, "running", confirm=True)
    while not (line := first.client.get(f"/api/jobs/{job}").json()["line"]):
        time.sleep(0.02)
    first.kill()
    with Running(database, processes=1, speed=200.0) as client:
        found = wait_for_state(client, job, "interrupted")
        assert found["line"] >= line > 0
        assert f" line {found['line']} of {found['lines']} or later" in found["reason"]
        assert not found["stopped_at"]["certain"]
        # No other job gets the table before the operator has decided about this one.
        other = order_job(client, drawing, release=True)["id"]
        wait_for_state(client, other, "queued")
        time.sleep(1.0)
        assert client.get(f"/api/jobs/{other}").json()["state"] == "queued"
        client.post(f"/api/jobs/{job}/requeue")
        wait_for_state(client, job, "done", confirm=True)
        wait_for_state(client, other, "done", confirm=True)
        assert course(client, job).count("interrupted") == 1


@pytest.mark.long
def test_a_gateway_that_never_comes_back_leaves_an_interrupted_job(database: Path) -> None:
    first = Running(database, processes=1, speed=0.2)
    job = order_job(first.client, upload_drawing(first.client, square())["id"], release=True)["id"]
    wait_for_state(first.client, job, "running", confirm=True)
    # Until then it is not begun, and would return to the queue.
    while first.client.get(f"/api/jobs/{job}").json()["line"] == 0:
        time.sleep(0.05)
    first.kill()
    with Running(database, processes=1, simulator=False) as client:
        found = wait_for_state(client, job, "interrupted", seconds=40.0)
        assert "stopped responding" in found["reason"]


@pytest.mark.long
def test_killed_at_any_moment_it_loses_no_job(database: Path) -> None:
    random.seed(20)
    jobs: list[str] = []
    server = Running(database, processes=1, speed=2.0)
    drawing = upload_drawing(server.client, square())["id"]
    for _ in range(2):
        jobs += [order_job(server.client, drawing, release=True)["id"] for _ in range(3)]
        while states_attended(server.client, jobs)[jobs[-3]] not in ("running", "done"):
            time.sleep(0.05)
        time.sleep(random.uniform(0.0, 0.6))
        server.kill()
        server = Running(database, processes=1, speed=200.0)
    try:
        while set(states_attended(server.client, jobs).values()) != {"done"}:
            time.sleep(0.05)
        listed = server.client.get("/api/jobs").json()
        assert sorted(job["id"] for job in listed) == sorted(jobs)
    finally:
        server.stop()


def states_attended(client: httpx.Client, jobs: list[str]) -> dict[str, str]:
    """Act as the operator (queue interrupted jobs again, confirm); return the state of each job."""
    states = {}
    for job in jobs:
        found = client.get(f"/api/jobs/{job}").json()
        states[job] = found["state"]
        assert found["state"] not in ("refused", "cancelled", "scrapped")
        if found["state"] == "interrupted":
            client.post(f"/api/jobs/{job}/requeue")
        if found["waiting_for"] == "confirmation":
            confirm_job(client, job)
    return states


def test_a_regular_stop_of_the_server_stops_its_machine(database: Path) -> None:
    first = Running(database, processes=1, speed=0.2)
    job = order_job(first.client, upload_drawing(first.client, square())["id"], release=True)["id"]
    wait_for_state(first.client, job, "running", confirm=True)
    while first.client.get(f"/api/jobs/{job}").json()["line"] == 0:
        time.sleep(0.05)
    began = time.monotonic()
    assert first.stop() == 0
    assert time.monotonic() - began < 60.0
    with Running(database, processes=1, simulator=False) as client:
        found = client.get(f"/api/jobs/{job}").json()
        assert found["state"] == "interrupted"
        assert "sends jobs to the machine) was stopped" in found["reason"]


@pytest.mark.long
def test_a_claim_that_waited_during_a_power_failure_is_confirmed_again(database: Path) -> None:
    first = Running(database, processes=1, speed=200.0)
    job = order_job(first.client, upload_drawing(first.client, square())["id"], release=True)["id"]
    while first.client.get(f"/api/jobs/{job}").json()["waiting_for"] != "confirmation":
        time.sleep(0.02)
    first.kill()
    with Running(database, processes=1, speed=200.0) as client:
        deadline = time.monotonic() + 60.0
        while course(client, job).count("queued") < 3:
            assert time.monotonic() < deadline, course(client, job)
            time.sleep(0.05)
        assert client.get(f"/api/jobs/{job}").json()["state"] == "queued"
        wait_for_state(client, job, "done", confirm=True)
        assert "interrupted" not in course(client, job)
