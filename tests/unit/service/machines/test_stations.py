"""The station of a machine over REST: reports of the gateway, and operations of a person."""

from __future__ import annotations

import queue
import threading
import time
from contextlib import suppress
from typing import Any

import httpx
import pytest

from knifetip.contract.operations import EXPIRY
from knifetip.service.events.routes import Change, Stream
from tests.support.serving.server import LocalClient
from tests.unit.service.events.test_events import Heard, event_queue

pytestmark = pytest.mark.xdist_group("server")

MACHINE = "flat-cutter-hpgl"  # no other test of the API uses its gateway
JOG = {"operation": "jog", "axis": "X", "distance": 12.5, "feed": 600.0}
REPORT: dict[str, Any] = {
    "gateway": "gw",
    "machine": MACHINE,
    "connected": True,
    "state": "idle",
    "position": [1.0, 2.0, 20.0, 0.0],
    "outputs": [1],
    "operations": ["unlock", "home", "jog", "stop_jog"],
}
NOTICE: dict[str, Any] = {
    "code": "setting.difference",
    "arguments": {
        "setting": "$20",
        "found": "0",
        "expected": "1",
        "assignment": "$20=1",
        "reason": {"code": "setting.no-soft-limits", "arguments": {}},
    },
}


class Timer:
    """The timer of a server. It shows the same time until a test changes it."""

    def __init__(self, now: float) -> None:
        self.now = now

    def __call__(self) -> float:
        return self.now


@pytest.fixture(autouse=True)
def timer(client: LocalClient, monkeypatch: pytest.MonkeyPatch) -> Timer:
    """Let no operation expire because the computer is busy."""
    database = client.service.store.database
    timer = Timer(database.timer())
    monkeypatch.setattr(database, "timer", timer)
    return timer


def report(client: httpx.Client, **more: Any) -> dict[str, Any]:
    answer = client.post("/api/gateway/station", json={**REPORT, **more})
    assert answer.status_code == 200, answer.text
    reply: dict[str, Any] = answer.json()
    return reply


def ask(client: httpx.Client, **operation: Any) -> httpx.Response:
    return client.post(f"/api/machines/{MACHINE}/operations", json=operation)


def state_of(client: httpx.Client, id: str) -> dict[str, Any]:
    found: dict[str, Any] = client.get(f"/api/machines/{MACHINE}/operations/{id}").json()
    return found


def test_a_feed_override_reaches_the_gateway_with_its_value(client: httpx.Client) -> None:
    able = [*REPORT["operations"], "feed_override"]
    report(client, operations=able, override=90)
    assert client.get(f"/api/machines/{MACHINE}/station").json()["override"] == 90
    asked = ask(client, operation="feed_override", percent=80)
    assert asked.status_code == 202, asked.text
    (handed,) = report(client, operations=able, override=90)["operations"]
    assert (handed["operation"], handed["percent"]) == ("feed_override", 80)


def test_the_station_shows_the_report_of_the_gateway(client: httpx.Client) -> None:
    alarm = {"code": "controller.alarm-of-unknown-cause", "arguments": {"name": "grbl"}}
    report(client, state="alarm", alarm=alarm, notices=[NOTICE], outputs_known=False)
    station = client.get(f"/api/machines/{MACHINE}/station").json()
    assert station["seen_seconds_ago"] < 5.0
    assert station["alarm"]["hint"].startswith("Check the table")
    (notice,) = station["notices"]
    assert notice["text"].startswith("$20 is 0, expected 1: ")
    assert notice["hint"].startswith("Set $20=1 at the controller")
    assert station["obstacle"] is None
    del station["seen_seconds_ago"], station["alarm"], station["notices"], station["obstacle"]
    assert station == {
        "machine": MACHINE,
        "gateway": "gw",
        "connected": True,
        "state": "alarm",
        "position": [1.0, 2.0, 20.0, 0.0],
        "outputs": [1],
        "outputs_known": False,
        "override": None,
        "operations": ["unlock", "home", "jog", "stop_jog"],
        "spindle": None,
        "activity": None,
        "job": "",
    }
    assert report(client)["watched"]
    assert client.get(f"/api/machines/{MACHINE}/station").json()["outputs_known"]
    assert client.get("/api/machines/no-such/station").status_code == 404


def _append_report(replies: list[dict[str, Any]], client: httpx.Client) -> None:
    """Append the answer to the first of some reports that has an operation."""
    for _ in range(6):
        reply = report(client, wait=10.0)
        if reply["operations"]:
            replies.append(reply)
            return


def test_an_operation_reaches_the_gateway_at_once_and_its_result_the_person(
    client: httpx.Client,
) -> None:
    report(client)
    replies: list[dict[str, Any]] = []
    waiting = threading.Thread(target=_append_report, args=(replies, client))
    waiting.start()
    time.sleep(0.3)  # the report waits, or comes after the operation on a busy computer
    asked = ask(client, **JOG)
    assert asked.status_code == 202
    id = asked.json()["id"]
    waiting.join(60.0)
    (handed,) = replies[0]["operations"]
    assert {name: handed[name] for name in JOG} == JOG
    assert handed["id"] == id
    assert handed["age"] == 0.0
    assert state_of(client, id) == {"id": id, "state": "waiting", "message": None}
    report(client, results=[{"id": id, "state": "done"}])
    assert state_of(client, id)["state"] == "done"


def test_a_waiting_report_is_answered_when_a_person_looks_at_the_machine(
    client: httpx.Client,
) -> None:
    machine = "two-carriage-table"  # no other test looks at it
    assert not report(client, machine=machine)["watched"]
    replies: list[dict[str, Any]] = []
    waiting = threading.Thread(
        target=lambda: replies.append(report(client, machine=machine, wait=10.0))
    )
    waiting.start()
    time.sleep(0.3)
    client.get(f"/api/machines/{machine}/station").raise_for_status()
    waiting.join(60.0)
    assert replies[0]["watched"]
    assert replies[0]["waited"] < 10.0  # before the end of its wait
    assert replies[0]["operations"] == []


def test_a_late_operation_expires(client: httpx.Client, timer: Timer) -> None:
    report(client)
    id = ask(client, operation="unlock").json()["id"]
    timer.now += EXPIRY
    assert report(client)["operations"] == []
    expired = state_of(client, id)
    assert expired["state"] == "expired"
    assert expired["message"]["code"] == "operation.expired"


def test_an_operation_that_moves_needs_hands_clear(client: httpx.Client) -> None:
    machine = "router-table"  # no other test states anything there
    report(client, machine=machine)
    route = f"/api/machines/{machine}/operations"
    refused = client.post(route, json={"operation": "home"})
    assert (refused.status_code, refused.json()["code"]) == (409, "operation.hands-not-clear")
    stated = client.post(f"/api/machines/{machine}/hands-clear")
    assert stated.status_code == 200
    assert stated.json()["seconds"] == 60.0
    assert stated.json()["until"] > "2000"
    assert client.post(route, json={"operation": "home"}).status_code == 202
    assert client.post("/api/machines/no-such/hands-clear").status_code == 404


def test_a_statement_that_hands_are_clear_is_withdrawn(client: httpx.Client) -> None:
    machine = "sample-table"  # no other test states anything there
    report(client, machine=machine)
    statement, route = f"/api/machines/{machine}/hands-clear", f"/api/machines/{machine}/operations"
    assert client.post(statement).status_code == 200
    assert client.delete(statement).status_code == 204
    refused = client.post(route, json={"operation": "home"})
    assert (refused.status_code, refused.json()["code"]) == (409, "operation.hands-not-clear")
    # It is withdrawn, whoever has made it, also if there is none.
    assert client.delete(statement).status_code == 204
    assert client.delete("/api/machines/no-such/hands-clear").status_code == 404
    assert client.post(statement).status_code == 200
    assert client.post(route, json={"operation": "home"}).status_code == 202


def test_the_gateway_learns_which_jog_is_held(client: httpx.Client) -> None:
    report(client)
    id = ask(client, **JOG).json()["id"]
    renewed = client.post(f"/api/machines/{MACHINE}/operations/{id}/renew")
    assert renewed.status_code == 200
    held = report(client)["jog"]
    assert held["id"] == id
    assert 0.0 <= held["age"] < 30.0
    other = ask(client, operation="unlock").json()["id"]
    refused = client.post(f"/api/machines/{MACHINE}/operations/{other}/renew")
    assert (refused.status_code, refused.json()["code"]) == (409, "operation.jog-ended")


@pytest.mark.parametrize(
    "wrong",
    [
        {"operation": "jump"},
        {"operation": "jog", "axis": "X", "feed": 600.0},
        {"operation": "jog", "axis": "B", "distance": 1.0, "feed": 600.0},
        {"operation": "jog", "axis": "X", "distance": 1e9, "feed": 600.0},
        {"operation": "zero"},
        {"operation": "zero", "axes": "Q"},
        {"operation": "switch", "output": -1, "on": True},
        {"operation": "switch", "output": 1},
        {"operation": "spindle", "station": 1},
        {"operation": "spindle", "station": 0, "on": True},
        {"operation": "unlock", "force": True},
        {"operation": "dry_run", "share": 0.01},
        {"operation": "dry_run", "share": 1.5},
        {"operation": "feed_override"},
        {"operation": "feed_override", "percent": 201},
        {"operation": "feed_override", "percent": 55.5},
    ],
)
def test_a_wrong_operation_is_refused_with_a_hint(
    client: httpx.Client, wrong: dict[str, Any]
) -> None:
    report(client)
    answer = ask(client, **wrong)
    assert answer.status_code == 422
    assert answer.json()["hint"]
    assert report(client)["operations"] == []


def test_what_the_machine_cannot_do_now_is_refused(client: httpx.Client) -> None:
    report(client)
    unsupported = ask(client, operation="park")
    assert unsupported.status_code == 409
    assert unsupported.json()["code"] == "operation.unsupported"
    report(client, connected=False, state="")
    assert ask(client, **JOG).json()["code"] == "operation.no-controller"
    assert client.get(f"/api/machines/{MACHINE}/operations/none").status_code == 404


def test_a_page_of_another_site_asks_for_nothing(client: httpx.Client) -> None:
    report(client)
    foreign = client.post(
        f"/api/machines/{MACHINE}/operations",
        json=JOG,
        headers={"Origin": "http://evil.example"},
    )
    assert foreign.status_code == 403
    assert report(client)["operations"] == []


def jog_event(client: httpx.Client, heard: queue.Queue[Heard], timer: Timer) -> Heard:
    """Report a jog each second until its event arrives, and return the event."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        timer.now += 1.0
        report(client, state="jog", position=[5.0, 0.0, 20.0, 0.0])
        with suppress(queue.Empty):
            while (event := heard.get(timeout=0.5)).kind != "station":
                pass
            if event.data["state"] == "jog":
                return event
    raise AssertionError("no event reports the jog")


def test_an_error_in_the_stream_of_events_loses_no_change(
    client: httpx.Client, timer: Timer, monkeypatch: pytest.MonkeyPatch
) -> None:
    report(client, state="idle", position=[0.0, 0.0, 20.0, 0.0])
    failed = threading.Event()
    stations = Stream._stations

    def fail_once(stream: Stream) -> list[Change]:
        messages = stations(stream)
        if not failed.is_set() and any(
            '"state":"jog"' in (one.sent.raw_data or "") for one in messages
        ):
            failed.set()
            raise OSError("database is locked")
        return messages

    with event_queue(client) as heard:
        monkeypatch.setattr(Stream, "_stations", fail_once)
        assert jog_event(client, heard, timer).data["machine"] == MACHINE
        assert failed.is_set()


def test_each_change_of_a_station_is_an_event(client: httpx.Client, timer: Timer) -> None:
    report(client, state="idle", position=[0.0, 0.0, 20.0, 0.0])
    with event_queue(client) as heard:
        event = jog_event(client, heard, timer)
        assert event.number is None
        assert event.data["machine"] == MACHINE
        assert event.data["position"] == [5.0, 0.0, 20.0, 0.0]


def test_a_run_above_the_board_is_shown_and_needs_a_job_that_waits(client: httpx.Client) -> None:
    failed = {
        "kind": "dry_run",
        "job": "job-1",
        "state": "failed",
        "line": 12,
        "progress": 0.5,
        "seconds_left": None,
        "position": [1.0, 2.0, 20.0, 90.0],
        "station": 2,
        "message": {"code": "dry-run.no-work", "arguments": {}},
    }
    report(client, operations=["dry_run", "frame", "hold"], activity=failed)
    shown = client.get(f"/api/machines/{MACHINE}/station").json()["activity"]
    assert shown.pop("message")["text"].startswith(
        "The program of the job does not touch the board"
    )
    del failed["message"]
    assert shown == failed
    for name in ("dry_run", "frame"):
        answer = ask(client, operation=name, hands_clear=True)
        assert answer.status_code == 409
        assert answer.json()["code"] == "dry-run.no-job"
    report(client, state="unreported", operations=[])
    answer = ask(client, operation="dry_run").json()
    assert answer["code"] == "operation.unreported"
    assert "controls of the machine" in answer["hint"]
    report(client)
    assert client.get(f"/api/machines/{MACHINE}/station").json()["activity"] is None
