"""Orders of stored drawings do not wait for worker processes, and find the questions once."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import pytest

from knifetip.service.components import Service
from knifetip.service.drawings import answered_questions
from knifetip.service.drawings.answered_questions import AnsweredQuestions
from knifetip.service.limits.work_queue import WorkQueue
from knifetip.service.processes import tasks
from tests.support.serving.server import LocalClient, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")

BOARD = {"board": "e-flute"}


@pytest.fixture
def occupied(client: LocalClient, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Occupy the only thread and the only place of the queue for worker processes."""
    gate = threading.Event()
    work = WorkQueue(1, 1)
    timed = work._measure_time
    monkeypatch.setattr(work, "_measure_time", lambda call: (gate.wait(60.0), timed(call))[1])
    monkeypatch.setattr(client.service, "work", work)

    def upload(side: float) -> int:
        files = {"file": ("a.dxf", square(side=side))}
        return client.post("/api/drawings", files=files).status_code

    with ThreadPoolExecutor(2) as pool:
        uploads = [pool.submit(upload, side) for side in (31.0, 32.0)]
        while not (work.waiting and work._running.total()):
            assert not any(one.done() for one in uploads)
        yield
        gate.set()
        assert [one.result() for one in uploads] == [201, 201]
    work.close()


@pytest.fixture(scope="module")
def drawing(client: LocalClient) -> str:
    return str(upload_drawing(client, square(side=61.0))["id"])


def test_an_order_of_a_stored_drawing_needs_no_place_of_a_computing_request(
    client: LocalClient, drawing: str, occupied: None
) -> None:
    order = {**BOARD, "drawing": drawing}
    assert client.post("/api/jobs", json=order).status_code == 201
    made = client.post("/api/orders", json=order)
    assert (made.status_code, made.json()["job"]["drawing"]) == (201, drawing)
    # What needs a process is still refused, here the reading of the file for another profile.
    other = client.post("/api/jobs", json={**order, "profile": "german"})
    assert (other.status_code, other.json()["code"]) == (503, "server.busy"), other.text


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """Return the list of the computations of open questions."""
    made: list[object] = []
    run = Service.run

    def counted(self: Service, task: Callable[..., Any], *arguments: object) -> Any:
        if task is tasks.open_questions:
            made.append(task)
        return run(self, task, *arguments)

    monkeypatch.setattr(Service, "run", counted)
    return made


def test_many_equal_orders_find_their_questions_once(
    client: LocalClient, asked: list[object]
) -> None:
    new = upload_drawing(client, square(side=62.0))["id"]
    # A choice that the machine must permit is not known from the upload.
    order = {**BOARD, "drawing": new, "machine": "router-table", "corners": {"type": "B"}}
    with ThreadPoolExecutor(40) as pool:
        answers = list(pool.map(lambda _: client.post("/api/jobs", json=order), range(40)))
    assert [answer.status_code for answer in answers] == [201] * 40
    assert len({answer.json()["id"] for answer in answers}) == 40
    assert len(asked) == 1
    refused = client.post("/api/jobs", json={**order, "machine": "demo-table"})
    assert (refused.status_code, refused.json()["code"]) == (422, "corner.no-cutter")


def set_type(client: httpx.Client, drawing: str, type: str | None) -> None:
    patch = {"overrides": [{"layer": "CUT", "type": type}]}
    assert client.patch(f"/api/drawings/{drawing}/edges", json=patch).status_code == 200


def test_questions_are_found_again_for_another_drawing_or_machine(client: LocalClient) -> None:
    new = upload_drawing(client, square(side=63.0))["id"]
    order = {**BOARD, "drawing": new}
    assert client.post("/api/jobs", json=order).status_code == 201
    set_type(client, new, "v-groove")
    # The demo table has a V-cutter, the laser has not.
    assert client.post("/api/jobs", json=order).status_code == 201
    other = client.post("/api/jobs", json={**order, "machine": "laser-table"})
    assert (other.status_code, [one["kind"] for one in other.json()["questions"]]) == (
        409,
        ["tool"],
    )
    set_type(client, new, None)
    assert client.post("/api/jobs", json={**order, "machine": "laser-table"}).status_code == 201


def test_an_order_for_a_drawing_without_a_unit_is_a_question(client: httpx.Client) -> None:
    new = upload_drawing(client, square(side=64.0, units=None))["id"]
    for path in ("/api/jobs", "/api/orders"):
        answer = client.post(path, json={**BOARD, "drawing": new})
        assert (answer.status_code, bool(answer.json()["questions"])) == (409, True)


def test_only_the_last_answers_are_cached(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answered_questions, "_REMEMBERED", 2)
    answered = AnsweredQuestions()
    answered.add("a")
    answered.add("b")
    assert "a" in answered  # used last
    answered.add("c")
    assert [key in answered for key in "abc"] == [True, False, True]
