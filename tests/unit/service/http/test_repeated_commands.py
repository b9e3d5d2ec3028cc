"""A command that is repeated after a lost answer succeeds, and a wrong command is refused."""

from __future__ import annotations

import uuid
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def drawing(client: httpx.Client) -> str:
    return str(upload_drawing(client, square(side=91.0))["id"])


@pytest.fixture
def ready(client: httpx.Client, drawing: str) -> Iterator[str]:
    job = str(order_job(client, drawing)["id"])
    wait_for_state(client, job, "ready")
    yield job
    # A queued job would be the next one that a gateway of other tests claims.
    client.post(f"/api/v1/jobs/{job}/cancel")


def send(
    client: httpx.Client, job: str, command: str, key: str = "", body: Any = None
) -> httpx.Response:
    headers = {"Idempotency-Key": key} if key else {}
    return client.post(f"/api/v1/jobs/{job}/{command}", headers=headers, json=body)


def codes(client: httpx.Client, job: str) -> list[str]:
    events = client.get(f"/api/v1/jobs/{job}/events").json()
    return [event["message"]["code"] for event in events]


def test_release_and_cancel_without_a_key_are_repeated(client: httpx.Client, ready: str) -> None:
    for command, state in (("release", "queued"), ("cancel", "cancelled")):
        for _ in range(2):
            answer = send(client, ready, command)
            assert (answer.status_code, answer.json()["state"]) == (200, state)
    assert codes(client, ready).count("job.released") == 1
    assert codes(client, ready).count("job.cancelled") == 1
    # The caller requests that the job is made, and it will not be.
    assert send(client, ready, "release").status_code == 409


def test_a_command_with_its_key_is_carried_out_once(client: httpx.Client, ready: str) -> None:
    release, cancel = uuid.uuid4().hex, uuid.uuid4().hex
    assert send(client, ready, "release", release).json()["state"] == "queued"
    assert send(client, ready, "cancel", cancel).json()["state"] == "cancelled"
    # A late repetition of the release does not release the job again, and is not refused.
    late = send(client, ready, "release", release)
    assert (late.status_code, late.json()["state"]) == (200, "cancelled")
    assert send(client, ready, "cancel", cancel).status_code == 200
    assert codes(client, ready).count("job.released") == 1


def test_a_key_belongs_to_one_command(client: httpx.Client, ready: str, drawing: str) -> None:
    key = uuid.uuid4().hex
    assert send(client, ready, "release", key).status_code == 200
    other = order_job(client, drawing)["id"]
    for job, command, body in (
        (ready, "cancel", None),
        (other, "cancel", None),
        (ready, "release", {}),
    ):
        answer = send(client, job, command, key, body)
        assert answer.status_code == 422, (job, command, body)
        assert answer.json()["code"] == "request.key-reused"
    assert client.get(f"/api/v1/jobs/{ready}").json()["state"] == "queued"


def test_a_refused_command_does_not_use_its_key(client: httpx.Client, drawing: str) -> None:
    key = uuid.uuid4().hex
    job = order_job(client, drawing)["id"]
    client.post(f"/api/v1/jobs/{job}/cancel")
    assert send(client, job, "requeue", key).status_code == 409
    assert send(client, job, "requeue", key).status_code == 409
    assert send(client, job, "cancel", key).status_code == 200


@pytest.mark.parametrize(
    "command", ["confirm", "hold", "resume", "finish", "requeue", "scrap", "recompile"]
)
def test_another_command_for_a_cancelled_job_is_refused(
    client: httpx.Client, drawing: str, command: str
) -> None:
    job = order_job(client, drawing)["id"]
    client.post(f"/api/v1/jobs/{job}/cancel")
    assert send(client, job, command).status_code == 409
    assert send(client, job, command, uuid.uuid4().hex).status_code == 409
    assert send(client, "nothing", command, uuid.uuid4().hex).status_code == 404
