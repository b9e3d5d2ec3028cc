"""The work queue is bounded, and does not delay reports of gateways."""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.errors import ServerBusy
from knifetip.service.database.acting import ActingPrincipal, acting_as, acting_principal
from knifetip.service.limits import work_queue as queue
from knifetip.service.limits.work_queue import Client, RequestIdentity, WorkQueue
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import TaskCancelled
from tests.support.serving.crew_tasks import GatedReading
from tests.support.serving.server import (
    LocalClient,
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")


async def test_calls_are_made_in_order_with_limited_concurrency() -> None:
    work = WorkQueue(2, 10)
    inside, most, order = 0, 0, []
    lock = threading.Lock()

    def call(number: int) -> int:
        nonlocal inside, most
        with lock:
            inside += 1
            most = max(most, inside)
            order.append(number)
        time.sleep(0.01)
        with lock:
            inside -= 1
        return number

    found = await asyncio.gather(*[work.run(partial(call, n)) for n in range(12)])
    assert found == list(range(12))
    assert order == list(range(12))
    assert most == 2
    work.close()


async def test_a_waiting_call_runs_in_the_context_of_its_own_request() -> None:
    work = WorkQueue(1, 10)
    gate = threading.Event()

    def call() -> str:
        gate.wait(10.0)
        return acting_principal()

    async def request(user: str) -> str:
        with acting_as(ActingPrincipal("user", user, user, "create_job")):
            return await work.run(call)

    waiting = [asyncio.create_task(request(user)) for user in ("anna", "ben", "carla")]
    async with asyncio.timeout(120.0):
        while work.waiting < 2:
            await asyncio.sleep(0.001)
    gate.set()
    assert await asyncio.gather(*waiting) == ["user:anna", "user:ben", "user:carla"]
    work.close()


async def test_a_call_beyond_the_limit_is_refused_with_a_time_to_retry() -> None:
    work = WorkQueue(1, 2)
    gate = threading.Event()
    made: list[int] = []

    def call(number: int) -> None:
        gate.wait(10.0)
        made.append(number)

    waiting = [asyncio.create_task(work.run(partial(call, n))) for n in range(3)]
    await asyncio.sleep(0.05)
    with pytest.raises(ServerBusy) as refused:
        await work.run(lambda: call(99))
    assert refused.value.message.arguments["waiting"] == 2
    assert 1 <= refused.value.seconds <= 60
    gate.set()
    await asyncio.gather(*waiting)
    assert made == [0, 1, 2]
    # Calls are accepted again, also after one that failed.
    with pytest.raises(ZeroDivisionError):
        await work.run(lambda: 1 // 0)
    for _ in range(3):
        await work.run(lambda: call(7))
    work.close()


async def test_the_time_to_retry_follows_the_duration_of_calls() -> None:
    work = WorkQueue(1, 1)
    for _ in range(20):
        await work.run(lambda: time.sleep(0.001))
    assert work._seconds < 0.1
    gate = threading.Event()
    waiting = [asyncio.create_task(work.run(lambda: gate.wait(10.0))) for _ in range(2)]
    await asyncio.sleep(0.05)
    with pytest.raises(ServerBusy) as refused:
        await work.run(gate.set)
    assert refused.value.seconds == 1
    gate.set()
    await asyncio.gather(*waiting)
    work.close()


async def test_one_client_does_not_hold_all_threads_or_places() -> None:
    work = WorkQueue(4, 8, per_client=3)
    made: list[str] = []
    gates: list[threading.Event] = []  # the call that began first is the first

    def call(name: str) -> None:
        gate = threading.Event()
        gates.append(gate)
        made.append(name)
        gate.wait(10.0)

    def ask(name: str) -> asyncio.Task[None]:
        return asyncio.create_task(work.run(partial(call, name), Client(name)))

    async def begun(count: int) -> list[str]:
        async with asyncio.timeout(120.0):
            while len(made) < count:
                await asyncio.sleep(0.001)
        return made

    # Three of nine calls are executed, and six wait: two places remain for other clients.
    many = [ask("many") for _ in range(9)]
    assert await begun(3) == ["many"] * 3
    with pytest.raises(ServerBusy):
        await ask("many")
    few = [ask("few") for _ in range(2)]
    assert await begun(4) == [*["many"] * 3, "few"]
    # When the second client has nothing left, three calls are executed at the same time, not four.
    for ended, executed in enumerate([4, 4, 4, 4, 3, 3, 3, 3, 2, 1, 0]):
        gates[ended].set()
        await begun(ended + 1 + executed)
    await asyncio.gather(*many, *few)
    # The second client waits for one call, although the first one sent six requests before it.
    assert made == [*["many"] * 3, "few", "few", *["many"] * 6]
    work.close()


async def test_a_waiting_call_is_dropped_when_its_client_has_gone() -> None:
    work = WorkQueue(1, 8)
    gate, left, made = threading.Event(), asyncio.Event(), []

    async def has_left() -> bool:
        return left.is_set()

    first = asyncio.create_task(work.run(lambda: gate.wait(10.0)))
    dropped = asyncio.create_task(work.run(lambda: made.append(1), Client("gone", has_left)))
    last = asyncio.create_task(work.run(lambda: made.append(2), Client("stays")))
    await asyncio.sleep(0.05)
    left.set()
    with pytest.raises(TaskCancelled):
        await dropped
    gate.set()
    await asyncio.gather(first, last)
    assert made == [2]
    work.close()


def identity(key: str | None, content: str = "") -> RequestIdentity:
    return RequestIdentity.from_content("upload", key, content.encode())


async def test_a_request_repeated_a_hundred_times_is_one_call_and_needs_one_place() -> None:
    work = WorkQueue(1, 2)
    gate, made = threading.Event(), []

    def call() -> str:
        made.append(1)
        gate.wait(10.0)
        return "drawing"

    def ask(key: str | None) -> asyncio.Task[str]:
        return asyncio.create_task(work.run(call, Client("erp"), identity(key)))

    running = [ask("a") for _ in range(100)]
    waiting = [ask("b") for _ in range(100)]
    await asyncio.sleep(0)
    assert work.waiting == 1
    gate.set()
    assert set(await asyncio.gather(*running, *waiting)) == {"drawing"}
    assert len(made) == 2
    # What has ended is not repeated here: its result is stored under its key.
    assert await ask("a") == "drawing"
    assert len(made) == 3
    work.close()


async def test_requests_of_the_same_content_without_key_are_one_if_the_first_client_has_gone() -> (
    None
):
    work = WorkQueue(1, 8)
    gate, left, made = threading.Event(), asyncio.Event(), []

    async def has_left() -> bool:
        return left.is_set()

    def call(number: int) -> int:
        gate.wait(10.0)
        made.append(number)
        return number

    def ask(number: int, *client: Any) -> asyncio.Task[int]:
        work_call = partial(call, number)
        return asyncio.create_task(work.run(work_call, Client("erp", *client), identity(None)))

    first = ask(1, has_left)
    second = ask(2)  # another client that is still there: a drawing of its own
    await asyncio.sleep(0)
    left.set()
    repetition = ask(3)
    other = asyncio.create_task(work.run(partial(call, 4), Client("erp"), identity(None, "x")))
    await asyncio.sleep(0)
    gate.set()
    found = [await one for one in (first, second, repetition, other)]
    assert found == [1, 2, 1, 4]
    assert made == [1, 2, 4]
    work.close()


async def test_a_waiting_call_with_a_key_keeps_its_place_for_the_repetition() -> None:
    work = WorkQueue(1, 8)
    gate, made = threading.Event(), []

    async def has_gone() -> bool:
        return True

    first = asyncio.create_task(work.run(lambda: gate.wait(10.0)))
    await asyncio.sleep(0)
    kept = asyncio.create_task(
        work.run(lambda: made.append(1), Client("erp", has_gone), identity("key"))
    )
    dropped = asyncio.create_task(
        work.run(lambda: made.append(2), Client("erp", has_gone), identity(None))
    )
    with pytest.raises(TaskCancelled):
        await dropped
    assert work.waiting == 1
    gate.set()
    await asyncio.gather(first, kept)
    assert made == [1]
    work.close()


async def test_a_repetition_survives_the_end_of_the_first_request() -> None:
    work = WorkQueue(1, 8)
    gate = threading.Event()

    def call() -> str:
        gate.wait(10.0)
        raise ServerBusy(1, 1)

    first = asyncio.create_task(work.run(call, Client("erp"), identity("key")))
    await asyncio.sleep(0)
    second = asyncio.create_task(work.run(call, Client("erp"), identity("key")))
    await asyncio.sleep(0)
    first.cancel()
    with pytest.raises(asyncio.CancelledError):
        await first
    gate.set()
    with pytest.raises(ServerBusy):
        await second
    work.close()


def _begun(file: Path) -> list[str]:
    return file.read_text().split() if file.exists() else []


@pytest.mark.parametrize("headers", [{"Idempotency-Key": "patient"}, {}], ids=["key", "no key"])
def test_a_repeated_upload_gets_the_drawing_of_the_upload_that_its_client_gave_up(
    client: LocalClient,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    headers: dict[str, str],
) -> None:
    gate, begun = tmp_path / "gate", tmp_path / "begun"
    content = square(side=61.0 + len(headers))

    def upload(timeout: float) -> httpx.Response:
        files = {"file": ("slow.dxf", content)}
        return client.post("/api/drawings", files=files, headers=headers, timeout=timeout)

    upload_drawing(client, square(side=63.0))
    spawned = client.service.pool.processes_started
    before = _latest_drawings(client)
    monkeypatch.setattr(tasks, "read", GatedReading(str(gate), str(begun)))
    for _ in range(8):
        with pytest.raises(httpx.ReadTimeout):
            upload(0.3)
    (reading,) = _begun(begun)
    while _clients_waiting(client):
        time.sleep(0.01)
    with ThreadPoolExecutor(1) as pool:
        patient = pool.submit(upload, 60.0)
        while not _clients_waiting(client) and not patient.done():
            time.sleep(0.01)
        gate.touch()
        answer = patient.result()
    assert answer.status_code == 201
    assert answer.headers["Location"] == f"/api/drawings/{answer.json()['id']}"
    assert answer.headers["ETag"]
    assert _latest_drawings(client) - before == {answer.json()["id"]}
    assert _begun(begun) == [reading]
    assert client.service.pool.processes_started == spawned
    if headers:
        # The result is also there for a repetition that comes later.
        assert upload(60.0).json()["id"] == answer.json()["id"]
        assert _begun(begun) == [reading]


def _clients_waiting(client: LocalClient) -> int:
    repeatable = list(client.service.work._repeatable.values())
    return sum(len(ticket.present) for tickets in repeatable for ticket in tickets)


@contextmanager
def held(client: httpx.Client, count: int) -> Iterator[list[httpx.Response]]:
    """Block the only thread of a queue and send ``count`` more uploads; yield their responses."""
    answers: list[httpx.Response] = []
    with ThreadPoolExecutor(count) as pool:
        sent = [
            pool.submit(client.post, "/api/drawings", files={"file": (f"{n}.dxf", square())})
            for n in range(count)
        ]
        yield answers
        answers += [one.result() for one in sent]


def _latest_drawings(client: LocalClient) -> set[str]:
    """Return the ids of the latest 200 drawings, more than a test here uploads."""
    return {drawing["id"] for drawing in client.get("/api/drawings?limit=200").json()}


def test_a_full_queue_refuses_uploads_and_accepts_heartbeats(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate = threading.Event()
    gate.set()
    timed = WorkQueue._measure_time

    def slow(self: WorkQueue, call: Callable[[], Any]) -> Any:
        gate.wait(30.0)
        return timed(self, call)

    monkeypatch.setattr(queue.WorkQueue, "_measure_time", slow)
    monkeypatch.setattr(client.service, "work", WorkQueue(1, 3))
    job = order_job(client, upload_drawing(client, square())["id"], release=True)
    wait_for_state(client, job["id"], "queued")
    claim = {"gateway": "g", "machine": "demo-table", "wait": 20.0}
    epoch = client.post("/api/gateway/claim", json=claim).json()["epoch"]
    assert confirm_job(client, job["id"]).status_code == 200
    before = _latest_drawings(client)
    gate.clear()
    # More calls than threads in the common pool, which would all wait.
    with held(client, 60) as answers:
        deadline = time.monotonic() + 60.0
        busy = None
        while time.monotonic() < deadline:
            busy = client.post("/api/drawings", files={"file": ("late.dxf", square())})
            if busy.status_code == 503:
                break
        assert busy is not None
        assert busy.status_code == 503
        assert busy.headers["content-type"] == "application/problem+json"
        assert int(busy.headers["retry-after"]) >= 1
        assert busy.json()["type"] == "urn:knifetip:problem:server-busy"
        beat = {"job": job["id"], "epoch": epoch, "line": 1}
        assert client.post("/api/gateway/heartbeat", json=beat).json()["command"] == "continue"
        assert client.get("/healthz").status_code == 200
        assert client.get("/readyz").status_code == 200
        assert client.get(f"/api/jobs/{job['id']}").status_code == 200
        gate.set()
    statuses = [answer.status_code for answer in answers]
    assert set(statuses) == {201, 503}
    # Refused uploads are not stored.
    stored = {answer.json()["id"] for answer in answers if answer.status_code == 201}
    assert _latest_drawings(client) - before == stored
    done = {"job": job["id"], "epoch": epoch, "outcome": "done"}
    assert client.post("/api/gateway/finish", json=done).status_code == 200


def test_gateways_have_threads_of_their_own(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = order_job(client, upload_drawing(client, square())["id"], release=True)
    wait_for_state(client, job["id"], "queued")
    gate = threading.Event()
    monkeypatch.setattr(client.service.store.drawings, "recent", lambda *_: gate.wait(100.0) and [])
    with ThreadPoolExecutor(50) as pool:
        # All threads of the common pool wait, as for a slow database.
        stuck = [pool.submit(client.get, "/api/drawings", timeout=120.0) for _ in range(50)]
        time.sleep(0.5)
        try:
            own = httpx.Client(base_url=client.base_url, timeout=25.0, trust_env=False)
            with own, ThreadPoolExecutor(8) as gateways:
                ask = {"gateway": "idle", "machine": "router-table", "wait": 3.0}
                idle = [gateways.submit(own.post, "/api/gateway/claim", json=ask) for _ in range(8)]
                claim = {"gateway": "g", "machine": "demo-table", "wait": 20.0}
                epoch = own.post("/api/gateway/claim", json=claim).json()["epoch"]
                program = own.get(f"/api/gateway/program/{job['id']}")
                assert program.status_code == 200
                beat = {"job": job["id"], "epoch": epoch, "line": 1}
                for _ in range(3):
                    assert own.post("/api/gateway/heartbeat", json=beat).status_code == 200
                assert own.get("/readyz").status_code == 200
                assert own.get("/healthz").status_code == 200
                done = {"job": job["id"], "epoch": epoch, "outcome": "done"}
                assert own.post("/api/gateway/finish", json=done).status_code == 200
                assert {one.result().status_code for one in idle} == {204}
            assert not any(one.done() for one in stuck)
        finally:
            gate.set()
        assert {one.result().status_code for one in stuck} == {200}
