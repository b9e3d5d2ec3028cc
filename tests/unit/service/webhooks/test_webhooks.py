"""Webhooks from a real server to a real endpoint."""

from __future__ import annotations

import json
import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from standardwebhooks import WebhookVerificationError

from knifetip.service.settings import Settings
from knifetip.service.webhooks import sender as webhook_sender
from knifetip.service.webhooks.queue import PAUSE_AFTER
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.support.serving.webhook_receiver import Call, Receiver, run_receiver

pytestmark = pytest.mark.xdist_group("webhooks")


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("webhooks")
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test")) as client:
        yield client


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    with run_receiver() as found:
        yield found


@pytest.fixture(autouse=True)
def _no_webhooks(shop: LocalClient) -> Iterator[None]:
    yield
    for one in shop.get("/api/webhooks").json():
        shop.delete(f"/api/webhooks/{one['id']}")


def add(client: httpx.Client, url: str, **fields: object) -> dict[str, Any]:
    answer = client.post("/api/webhooks", json={"url": url, **fields})
    assert answer.status_code == 201, answer.text
    added: dict[str, Any] = answer.json()
    return added


def deliveries(client: httpx.Client, webhook: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.get(f"/api/webhooks/{webhook}/deliveries").json()
    return found


def test_a_job_is_reported_signed_and_in_order(shop: LocalClient, receiver: Receiver) -> None:
    added = add(shop, receiver.url)
    job = order_job(shop, upload_drawing(shop, square())["id"])["id"]
    wait_for_state(shop, job, "ready")
    receiver.wait(lambda _: "job.ready" in receiver.types(job))
    types = receiver.types(job)
    assert [one for one in types if one != "job.updated"] == [
        "job.received",
        "job.compiling",
        "job.ready",
    ]
    calls = list(receiver.calls)
    assert calls[0].payload["type"] == "drawing.read"
    for call in calls:
        call.verify(added["secret"])
        assert call.path == "/hooks?shop=1"
        assert call.headers["content-type"] == "application/json"
        assert call.headers["host"] in receiver.url
    assert len({call.id for call in calls}) == len(calls)
    ready = next(call for call in calls if call.payload["type"] == "job.ready")
    assert ready.payload["data"]["job"]["state"] == "ready"
    assert ready.payload["data"]["job"]["program_sha256"]
    with pytest.raises(WebhookVerificationError):
        Call("", ready.headers, ready.body + b" ").verify(added["secret"])


def test_the_secret_is_shown_once(shop: LocalClient, receiver: Receiver) -> None:
    added = add(shop, receiver.url, event_types=["job.done"])
    assert added["secret"].startswith("whsec_")
    for answer in (
        shop.get("/api/webhooks"),
        shop.get(f"/api/webhooks/{added['id']}"),
        shop.patch(f"/api/webhooks/{added['id']}", json={"description": "ERP"}),
    ):
        assert "whsec_" not in answer.text
    rotated = shop.post(f"/api/webhooks/{added['id']}/rotate-secret").json()
    assert rotated["secret"] != added["secret"]
    shop.post(f"/api/webhooks/{added['id']}/test")
    (call,) = receiver.wait(lambda calls: len(calls) == 1)
    call.verify(added["secret"])
    call.verify(rotated["secret"])


def test_a_test_event_and_a_replay(shop: LocalClient, receiver: Receiver) -> None:
    webhook = add(shop, receiver.url, event_types=["job.done"])["id"]
    answer = shop.post(f"/api/webhooks/{webhook}/test")
    assert answer.status_code == 202
    receiver.wait(lambda calls: len(calls) == 1)
    wait_until_delivered(shop, webhook)
    delivery = answer.json()["id"]
    answer = shop.post(f"/api/webhooks/{webhook}/deliveries/{delivery}/replay")
    assert answer.status_code == 202
    first, second = receiver.wait(lambda calls: len(calls) == 2)
    assert first.id == second.id == delivery
    assert first.payload["type"] == "webhook.test"
    wait_until_delivered(shop, webhook)
    (found,) = deliveries(shop, webhook)
    assert [attempt["status"] for attempt in found["attempts"]] == [204, 204]
    assert shop.get("/api/webhooks").json()[0]["last_delivery"]["id"] == delivery


def test_the_text_of_a_delivery_and_the_answer_are_shown(
    shop: LocalClient, receiver: Receiver
) -> None:
    receiver.answer = lambda _call: (200, {"Content-Type": "text/html"})
    receiver.body = b"thank you \x1b[31m<script>alert(1)</script>\xe2\x80\xae" + b"y" * 1000
    webhook = add(shop, receiver.url, event_types=["job.done"])["id"]
    delivery = shop.post(f"/api/webhooks/{webhook}/test").json()["id"]
    wait_until_delivered(shop, webhook)
    found = shop.get(f"/api/webhooks/{webhook}/deliveries/{delivery}").json()
    (call,) = receiver.calls
    assert found["payload"].encode() == call.body
    assert call.headers["accept-encoding"] == "identity"
    (attempt,) = found["attempts"]
    assert (attempt["status"], attempt["fault"]) == (200, "")
    assert attempt["answer"].startswith("thank you  [31m<script>alert(1)</script> y")
    assert len(attempt["answer"]) <= 200
    other = add(shop, receiver.url, event_types=["job.done"])["id"]
    answer = shop.get(f"/api/webhooks/{other}/deliveries/{delivery}")
    assert (answer.status_code, answer.json()["code"]) == (404, "webhook.unknown-delivery")


def test_a_test_waits_for_nothing_else(shop: LocalClient, receiver: Receiver) -> None:
    """A person corrects the receiver and wants to know at once whether that helped."""
    receiver.answer = lambda _call: (503, {})
    webhook = add(shop, receiver.url, event_types=["drawing.read"])["id"]
    upload_drawing(shop, square(side=61.0))
    receiver.wait(lambda calls: len(calls) == 1)
    wait_for_attempt(shop, webhook)
    for _ in range(2):
        test = shop.post(f"/api/webhooks/{webhook}/test").json()
        assert test["next_attempt"] >= test["created"]
        # misc: mypy infers no type of a lambda with a default.
        receiver.wait(lambda calls, id=test["id"]: calls[-1].id == id, seconds=4.0)  # type: ignore[misc]
        wait_for_attempt(shop, webhook)


def test_after_a_rotation_both_secrets_sign_for_a_time(
    shop: LocalClient, receiver: Receiver
) -> None:
    added = add(shop, receiver.url, event_types=["job.done"])
    path = f"/api/webhooks/{added['id']}"
    assert added["previous_secret_until"] is None
    rotated = shop.post(f"{path}/rotate-secret", json={"overlap_hours": 2}).json()
    assert rotated["previous_secret_until"] == shop.get(path).json()["previous_secret_until"]
    assert rotated["previous_secret_until"] > added["created"]
    # A leaked secret ends at once.
    last = shop.post(f"{path}/rotate-secret", json={"overlap_hours": 0}).json()
    assert last["previous_secret_until"] is None
    shop.post(f"{path}/test")
    (call,) = receiver.wait(lambda calls: len(calls) == 1)
    call.verify(last["secret"])
    assert len(call.headers["webhook-signature"].split()) == 1
    for secret in (added["secret"], rotated["secret"]):
        with pytest.raises(WebhookVerificationError):
            call.verify(secret)


def wait_until_delivered(client: LocalClient, webhook: str) -> None:
    event = threading.Event()
    for _ in range(500):
        if all(one["state"] == "delivered" for one in deliveries(client, webhook)):
            return
        event.wait(0.02)
    raise AssertionError(deliveries(client, webhook))


def wait_for_attempt(client: LocalClient, webhook: str) -> dict[str, Any]:
    event = threading.Event()
    for _ in range(1500):
        found = deliveries(client, webhook)
        if found and found[0]["attempts"]:
            return found[0]
        event.wait(0.02)
    raise AssertionError(deliveries(client, webhook))


def test_a_redirect_is_not_followed(shop: LocalClient, receiver: Receiver) -> None:
    with run_receiver() as inside:
        receiver.answer = lambda _call: (307, {"Location": inside.url})
        webhook = add(shop, receiver.url, event_types=["job.done"])["id"]
        shop.post(f"/api/webhooks/{webhook}/test")
        found = wait_for_attempt(shop, webhook)
        assert (found["state"], found["attempts"][0]["status"]) == ("pending", 307)
        assert inside.calls == []


def test_gone_switches_it_off(shop: LocalClient, receiver: Receiver) -> None:
    receiver.answer = lambda _call: (410, {})
    webhook = add(shop, receiver.url)["id"]
    shop.post(f"/api/webhooks/{webhook}/test")
    assert wait_for_attempt(shop, webhook)["state"] == "dead"
    assert not shop.get(f"/api/webhooks/{webhook}").json()["active"]
    answer = shop.post(f"/api/webhooks/{webhook}/test")
    assert (answer.status_code, answer.json()["code"]) == (409, "webhook.inactive")


def test_an_endpoint_that_is_down_gets_everything_later(
    shop: LocalClient, receiver: Receiver
) -> None:
    receiver.answer = lambda _call: (503, {})
    webhook = add(shop, receiver.url, event_types=["drawing.read"])["id"]
    drawings = [upload_drawing(shop, square(side=50.0 + i))["id"] for i in range(3)]
    receiver.wait(lambda calls: len({call.id for call in calls}) == 3)
    receiver.wait(lambda calls: len(calls) >= PAUSE_AFTER)
    # Once it answers, all are sent again.
    receiver.answer = lambda _call: (204, {})
    wait_until_delivered(shop, webhook)
    state = shop.get(f"/api/webhooks/{webhook}").json()
    assert (state["failures"], state["paused_until"]) == (0, None)
    subjects = {call.payload["data"]["drawing"]["id"] for call in receiver.calls}
    assert subjects == set(drawings)


def test_one_job_that_is_refused_does_not_hold_back_the_others(
    shop: LocalClient, receiver: Receiver
) -> None:
    refused = upload_drawing(shop, square(side=40.0))["id"]
    receiver.answer = lambda call: (500 if refused in json.dumps(call.payload) else 204, {})
    add(shop, receiver.url, event_types=["drawing.changed"])
    others = [upload_drawing(shop, square(side=50.0 + i))["id"] for i in range(3)]
    for drawing in (refused, *others):
        assert shop.patch(f"/api/drawings/{drawing}", json={"unit": "mm"}).status_code == 200
    # The one that is refused was sent first, and is tried again when all the others have arrived.
    arrived = [call.payload["data"]["drawing"]["id"] for call in receiver.wait(_has_repeated)]
    assert set(arrived) == {refused, *others}


def _has_repeated(calls: list[Call]) -> bool:
    return len({call.id for call in calls}) == 4 and len(calls) >= 5


def test_an_endless_answer_ends(
    shop: LocalClient, monkeypatch: pytest.MonkeyPatch, receiver: Receiver
) -> None:
    monkeypatch.setattr(webhook_sender, "TIME_LIMIT", 1.0)
    stop = threading.Event()
    with socket.create_server(("127.0.0.1", 0)) as server:

        def drip() -> None:
            connection, _ = server.accept()
            with connection:
                connection.sendall(b"HTTP/1.1 200 OK\r\n")
                while not stop.wait(0.05):
                    try:
                        connection.sendall(b"X: y\r\n")
                    except OSError:
                        return

        thread = threading.Thread(target=drip)
        thread.start()
        webhook = add(shop, f"http://127.0.0.1:{server.getsockname()[1]}/")["id"]
        slow = add(shop, receiver.url)["id"]
        shop.post(f"/api/webhooks/{webhook}/test")
        shop.post(f"/api/webhooks/{slow}/test")
        # A slow endpoint does not delay another one.
        receiver.wait(lambda calls: len(calls) == 1, seconds=10.0)
        found = wait_for_attempt(shop, webhook)
        stop.set()
        thread.join()
    assert found["attempts"][0]["status"] == 0
    assert "no complete answer" in found["attempts"][0]["fault"]


def test_a_hostile_answer_is_shown_harmlessly(shop: LocalClient) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:

        def answer() -> None:
            connection, _ = server.accept()
            with connection:
                connection.recv(65536)
                body = b"\x1b[31m<script>\r\n\x00" + b"x" * 100_000
                connection.sendall(b"HTTP/1.1 500 No\r\nContent-Length: 9999999\r\n\r\n" + body)
                connection.recv(1)

        thread = threading.Thread(target=answer)
        thread.start()
        webhook = add(shop, f"http://127.0.0.1:{server.getsockname()[1]}/")["id"]
        shop.post(f"/api/webhooks/{webhook}/test")
        found = wait_for_attempt(shop, webhook)
        thread.join()
    fault = found["attempts"][0]["fault"]
    assert len(fault) <= 200
    assert "\x1b" not in fault
    assert "\x00" not in fault


@pytest.mark.parametrize(
    ("method", "path", "body", "status"),
    [
        ("POST", "/api/webhooks", {"url": "ftp://erp.example/"}, 422),
        ("POST", "/api/webhooks", {"url": "http://169.254.169.254/"}, 422),
        ("POST", "/api/webhooks", {"url": "http://a.example/", "event_types": ["job.no"]}, 422),
        ("POST", "/api/webhooks", {"url": "http://a.example/", "secret": "mine"}, 422),
        ("GET", "/api/webhooks/none", None, 404),
        ("PATCH", "/api/webhooks/none", {"active": False}, 404),
        ("DELETE", "/api/webhooks/none", None, 404),
        ("POST", "/api/webhooks/none/test", None, 404),
        ("POST", "/api/webhooks/none/replay", None, 404),
        ("POST", "/api/webhooks/none/rotate-secret", None, 404),
        ("GET", "/api/webhooks/none/deliveries", None, 404),
        ("GET", "/api/webhooks/none/deliveries/none", None, 404),
    ],
)
def test_refused_requests(
    shop: LocalClient, method: str, path: str, body: object, status: int
) -> None:
    answer = shop.request(method, path, json=body)
    assert answer.status_code == status, answer.text
    assert answer.json()["hint"]


def test_private_addresses_can_be_refused(tmp_path: Path, receiver: Receiver) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/a.sqlite", webhook_private=False)
    with run_server(settings) as client:
        answer = client.post("/api/webhooks", json={"url": receiver.url})
        assert answer.json()["code"] == "webhook.forbidden-address"
        port = receiver.url.split(":")[2]
        webhook = add(client, f"http://localhost:{port}")["id"]
        client.post(f"/api/webhooks/{webhook}/test")
        found = wait_for_attempt(client, webhook)
        assert "not permitted" in found["attempts"][0]["fault"]
        assert receiver.calls == []
