"""The queue of a machine over REST: its order, estimates, and changes of waiting jobs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")

MACHINE = "demo-table"


@pytest.fixture(scope="module")
def drawing(client: httpx.Client) -> str:
    return str(upload_drawing(client, square())["id"])


@pytest.fixture
def three(client: httpx.Client, drawing: str) -> Iterator[list[str]]:
    """Return the ids of three jobs in the queue of the demo table; they are cancelled afterwards.

    Jobs of other tests that are in the queue are cancelled before.
    """
    for entry in queue(client)["entries"]:
        client.post(f"/api/jobs/{entry['job']['id']}/cancel")
    jobs = [order_job(client, drawing, release=True)["id"] for _ in range(3)]
    for id in jobs:
        wait_for_state(client, id, "queued")
    yield [entry["job"]["id"] for entry in queue(client)["entries"]]
    for id in jobs:
        client.post(f"/api/jobs/{id}/cancel")


def queue(client: httpx.Client, machine: str = MACHINE) -> dict[str, Any]:
    answer = client.get(f"/api/machines/{machine}/queue")
    assert answer.status_code == 200
    body: dict[str, Any] = answer.json()
    return body


def ids(client: httpx.Client) -> list[str]:
    return [entry["job"]["id"] for entry in queue(client)["entries"]]


def test_entries_have_places_pictures_and_estimates(client: httpx.Client, three: list[str]) -> None:
    client.patch(f"/api/jobs/{three[0]}", json={"copies": 3}).raise_for_status()
    first, second, third = queue(client)["entries"]
    one = first["job"]["seconds"]
    assert [entry["place"] for entry in (first, second, third)] == [1, 2, 3]
    assert (first["seconds"], first["starts_in"]) == (pytest.approx(3.0 * one), 0.0)
    assert second["starts_in"] == pytest.approx(3.0 * one)
    assert third["starts_in"] == pytest.approx(4.0 * one)
    picture = client.get(first["picture"])
    assert picture.headers["content-type"] == "image/svg+xml"
    assert picture.text.count("M") == 4
    assert "nan" not in picture.text


@pytest.mark.parametrize("value", [0, 1, "yes", "false"])
def test_a_hold_is_a_boolean_and_nothing_that_resembles_one(
    client: httpx.Client, three: list[str], value: object
) -> None:
    answer = client.patch(f"/api/jobs/{three[0]}", json={"on_hold": value})
    assert answer.status_code == 422
    assert "on_hold" in answer.json()["text"]


def test_a_job_on_hold_has_no_start_time_and_delays_no_other(
    client: httpx.Client, three: list[str]
) -> None:
    answer = client.patch(f"/api/jobs/{three[0]}", json={"on_hold": True, "by": "Mia"})
    assert answer.status_code == 200, answer.text
    assert (answer.json()["on_hold"], answer.json()["waiting_for"]) == (True, "hold")
    first, second, _third = queue(client)["entries"]
    assert (first["starts_in"], second["starts_in"]) == (None, 0.0)
    event = client.get(f"/api/jobs/{three[0]}/events").json()[-1]
    assert (event["message"]["code"], event["who"]) == ("queue.put-on-hold", "operator Mia")


def test_a_move_needs_the_present_order(client: httpx.Client, three: list[str]) -> None:
    a, b, c = three
    tag = client.get(f"/api/machines/{MACHINE}/queue").headers["etag"]
    move = {"previous": "", "next": a, "by": "Mia"}
    answer = client.post(f"/api/jobs/{c}/move", json=move, headers={"If-Match": tag})
    assert answer.status_code == 200
    assert ids(client) == [c, a, b]
    late = client.post(
        f"/api/jobs/{b}/move", json={"previous": "", "next": c}, headers={"If-Match": tag}
    )
    assert (late.status_code, late.json()["code"]) == (412, "queue.changed")
    late = client.post(f"/api/jobs/{c}/move", json={"previous": a, "next": ""})
    assert (late.status_code, late.json()["code"]) == (412, "queue.changed")
    assert ids(client) == [c, a, b]
    again = client.get(f"/api/machines/{MACHINE}/queue").headers["etag"]
    weak = {"If-Match": f"W/{again}"}
    back = client.post(f"/api/jobs/{c}/move", json={"previous": b, "next": ""}, headers=weak)
    assert (back.status_code, ids(client)) == (200, [a, b, c])
    anyway = {"If-Match": "*"}
    first = client.post(f"/api/jobs/{c}/move", json={"previous": "", "next": a}, headers=anyway)
    assert (first.status_code, ids(client)) == (200, [c, a, b])


def test_a_priority_comes_before_a_place(client: httpx.Client, three: list[str]) -> None:
    a, b, c = three
    assert client.patch(f"/api/jobs/{c}", json={"priority": 20}).json()["priority"] == 20
    assert ids(client) == [c, a, b]


@pytest.mark.parametrize(
    "body", [{}, {"by": "Mia"}, {"previous": None, "next": None}, {"previous": "x" * 50}]
)
def test_a_move_without_a_neighbour_is_refused(
    client: httpx.Client, three: list[str], body: dict[str, Any]
) -> None:
    assert client.post(f"/api/jobs/{three[0]}/move", json=body).status_code == 422


def test_a_job_moves_to_another_machine_with_a_new_program(
    client: httpx.Client, three: list[str]
) -> None:
    before = client.get(f"/api/jobs/{three[0]}").json()
    move = {"machine": "router-table", "by": "Mia"}
    moved = client.post(f"/api/jobs/{three[0]}/transfer", json=move, timeout=120.0)
    assert moved.status_code == 200
    assert (moved.json()["machine"], moved.json()["state"]) == ("router-table", "queued")
    assert moved.json()["program_sha256"] != before["program_sha256"]
    assert [tool["kind"] for tool in moved.json()["tools"]] == ["cutter"]
    assert ids(client) == three[1:]
    again = client.post(f"/api/jobs/{three[0]}/transfer", json=move)
    assert again.json()["program_sha256"] == moved.json()["program_sha256"]


def test_a_job_that_does_not_fit_stays_at_its_place(client: httpx.Client) -> None:
    groove = text.line(10.0, 50.0, 70.0, 50.0, (8, "GROOVE"), (62, 30))
    drawing = upload_drawing(client, square(extra=(groove,)))["id"]
    job = order_job(
        client,
        drawing,
        board="greyboard-3.0",
        release=True,
        overrides=[{"type": "v-groove", "layer": "GROOVE"}],
    )
    wait_for_state(client, job["id"], "queued")
    before = ids(client)
    answer = client.post(f"/api/jobs/{job['id']}/transfer", json={"machine": "laser-table"})
    assert (answer.status_code, answer.json()["code"]) == (422, "queue.does-not-fit")
    assert "v-groove" in answer.json()["detail"]
    assert ids(client) == before
    client.post(f"/api/jobs/{job['id']}/cancel")


def test_an_unknown_machine_has_no_queue(client: httpx.Client) -> None:
    assert client.get("/api/machines/nothing/queue").status_code == 404
