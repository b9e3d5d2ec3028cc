"""knifetip job: requests to a server, printed output and reported failures."""

from __future__ import annotations

import io
import json
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import Any

import pytest

from tests.support.command import Command

JOB = {
    "id": "abc",
    "state": "queued",
    "drawing_name": "tray.dxf",
    "machine": "demo-table",
    "board": "e-flute",
    "tools": [{"station": 1, "name": "Oscillating knife", "kind": "knife"}],
    "line": 0,
    "lines": 231,
    "copies": 1,
    "copies_done": 0,
    "waiting_for": "confirmation",
    "message": {
        "code": "waiting.for-start",
        "arguments": {
            "machine": "Demo table",
            "board": "E-flute 1.6 mm",
            "details": [],
        },
        "text": "not used",
        "hint": "not used",
    },
    "actions": ["confirm", "cancel"],
}


class FakeServer:
    """A server that answers every request with a job and records the requests."""

    def __init__(self) -> None:
        self.requests: list[tuple[str, str, dict[str, Any] | None]] = []
        self.headers: list[dict[str, str]] = []
        self.answer: tuple[int, object] = (200, JOB)
        self.url = ""


@pytest.fixture
def fake_server() -> Iterator[FakeServer]:
    fake_server = FakeServer()

    class Handler(BaseHTTPRequestHandler):
        def _any(self) -> None:
            length = int(self.headers.get("Content-Length") or 0)
            raw = self.rfile.read(length)
            fake_server.requests.append((self.command, self.path, json.loads(raw) if raw else None))
            fake_server.headers.append(dict(self.headers))
            status, body = fake_server.answer
            if self.command == "GET" and "?" in self.path and status == 200:
                body = [body]
            data = body if isinstance(body, bytes) else json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        do_GET = do_POST = _any  # noqa: N815  # names that http.server calls

        def log_message(self, format: str, *args: object) -> None:
            pass

    server = HTTPServer(("127.0.0.1", 0), Handler)
    fake_server.url = f"http://127.0.0.1:{server.server_port}"
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield fake_server
    server.shutdown()
    server.server_close()
    thread.join()


def test_list_prints_the_field_waiting_for_of_each_job(
    knifetip: Command, fake_server: FakeServer
) -> None:
    code, out, _ = knifetip("job", "list", "--server", fake_server.url, "--state", "queued")
    assert code == 0
    assert out.split()[:2] == ["abc", "queued"]
    assert "waits for confirmation" in out
    assert "[confirm, cancel]" in out
    assert fake_server.requests == [("GET", "/api/v1/jobs?limit=50&state=queued", None)]


def test_show_prints_reason_hint_and_tools(knifetip: Command, fake_server: FakeServer) -> None:
    _, out, _ = knifetip("job", "show", "abc", "--server", fake_server.url + "/")
    assert "table is clear. Required: board 'E-flute 1.6 mm'" in out
    assert "Check the table, then confirm the job to start it." in out
    assert "actions: confirm, cancel" in out
    assert "Oscillating knife (station 1)" in out
    _, out, _ = knifetip("job", "show", "abc", "--server", fake_server.url, "--json")
    assert json.loads(out) == JOB


@pytest.mark.parametrize("command", ["hold", "end", "finish", "requeue"])
def test_a_command_is_sent_to_its_route(
    knifetip: Command, fake_server: FakeServer, command: str
) -> None:
    code, out, _ = knifetip("job", command, "abc", "--server", fake_server.url)
    assert code == 0
    assert "tray.dxf" in out
    assert fake_server.requests == [("POST", f"/api/v1/jobs/abc/{command}", None)]
    assert fake_server.headers[0]["X-Knifetip"] == "cli"
    assert "Authorization" not in fake_server.headers[0]


def test_resume_states_that_hands_are_clear(
    knifetip: Command, fake_server: FakeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO(""))
    code, _, err = knifetip("job", "resume", "abc", "--server", fake_server.url)
    assert code != 0  # nobody answers the question
    assert "Are all hands clear of the machine?" in err
    assert fake_server.requests == []
    command = ("job", "resume", "abc", "--server", fake_server.url, "--hands-clear")
    assert knifetip(*command)[0] == 0
    assert fake_server.requests == [("POST", "/api/v1/jobs/abc/resume", {"hands_clear": True})]


CHECKS = [
    {"id": "board", "text": "The board on the table is E-flute."},
    {"id": "hands-clear", "text": "Hands and people are clear of the machine."},
]


class Terminal(io.StringIO):
    """Standard input of a person at a terminal."""

    def isatty(self) -> bool:
        return True


def test_confirm_sends_what_was_checked_and_the_name_of_the_operator(
    knifetip: Command, fake_server: FakeServer
) -> None:
    options = ("--checked", "board,hands-clear", "--changed", "2", "--by", "Kim")
    code, _, _ = knifetip("job", "confirm", "abc", "--server", fake_server.url, *options)
    assert code == 0
    body = {"checked": ["board", "hands-clear"], "changed": [2], "by": "Kim"}
    assert fake_server.requests == [("POST", "/api/v1/jobs/abc/confirm", body)]


def test_confirm_does_not_know_a_word_for_all_checks(
    knifetip: Command, fake_server: FakeServer
) -> None:
    knifetip("job", "confirm", "abc", "--server", fake_server.url, "--checked", "all")
    assert fake_server.requests[0][2] == {"checked": ["all"]}


def test_confirm_without_a_terminal_prints_the_checks_and_sends_nothing(
    knifetip: Command, fake_server: FakeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("y\ny\n"))
    fake_server.answer = (200, {**JOB, "checks": CHECKS})
    code, _, err = knifetip("job", "confirm", "abc", "--server", fake_server.url)
    assert code == 2
    assert "The board on the table is E-flute." in err
    assert "knifetip job confirm abc --checked board,hands-clear" in err
    assert [method for method, _, _ in fake_server.requests] == ["GET"]


@pytest.mark.parametrize(("answers", "sent"), [("y\ny\n", True), ("y\nn\n", False)])
def test_confirm_asks_each_check_at_a_terminal(
    knifetip: Command,
    fake_server: FakeServer,
    monkeypatch: pytest.MonkeyPatch,
    answers: str,
    sent: bool,
) -> None:
    monkeypatch.setattr("sys.stdin", Terminal(answers))
    fake_server.answer = (200, {**JOB, "checks": CHECKS})
    code, out, err = knifetip("job", "confirm", "abc", "--server", fake_server.url)
    assert "2 of 2: Hands and people are clear of the machine." in out + err
    assert code == (0 if sent else 1)
    bodies = [body for method, _, body in fake_server.requests if method == "POST"]
    assert bodies == ([{"checked": ["board", "hands-clear"]}] if sent else [])


@pytest.mark.parametrize("how", ["option", "environment"])
def test_a_key_is_sent_as_a_bearer(
    knifetip: Command, fake_server: FakeServer, monkeypatch: pytest.MonkeyPatch, how: str
) -> None:
    monkeypatch.setenv("KNIFETIP_KEY", "secret" if how == "environment" else "another")
    more = ("--key", "secret") if how == "option" else ()
    knifetip("job", "show", "abc", "--server", fake_server.url, *more)
    assert fake_server.headers[0]["Authorization"] == "Bearer secret"


@pytest.mark.parametrize("command", ["cancel", "scrap"])
def test_cancel_and_scrap_ask_for_confirmation(
    knifetip: Command, fake_server: FakeServer, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("n\n"))
    code, _, _ = knifetip("job", command, "abc", "--server", fake_server.url)
    assert code == 1
    assert [method for method, _, _ in fake_server.requests] == ["GET"] * (command == "cancel")
    monkeypatch.setattr("sys.stdin", io.StringIO(""))
    assert knifetip("job", command, "abc", "--server", fake_server.url)[0] == 1
    assert "POST" not in [method for method, _, _ in fake_server.requests]
    code, _, _ = knifetip("job", command, "abc", "--server", fake_server.url, "--yes")
    assert code == 0
    assert fake_server.requests[-1][:2] == ("POST", f"/api/v1/jobs/abc/{command}")


def test_cancel_of_a_running_job_warns_about_the_board(
    knifetip: Command, fake_server: FakeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("y\n"))
    fake_server.answer = (200, {**JOB, "state": "running"})
    _, out, err = knifetip("job", "cancel", "abc", "--server", fake_server.url)
    assert "holds, lifts the tool and releases its stations" in out + err
    assert fake_server.requests[-1][:2] == ("POST", "/api/v1/jobs/abc/cancel")


def test_the_message_of_a_refusing_server_is_printed(
    knifetip: Command, fake_server: FakeServer
) -> None:
    fake_server.answer = (409, {"detail": "Job abc is done.", "hint": "Order the job again."})
    options = ("--server", fake_server.url, "--checked", "board")
    code, out, err = knifetip("job", "confirm", "abc", *options)
    assert (code, out) == (3, "")
    assert "Job abc is done." in err
    assert "Order the job again." in err


@pytest.mark.parametrize("answer", [(502, b"<html>"), (500, [])])
def test_an_error_without_a_message_is_reported_with_its_status(
    knifetip: Command, fake_server: FakeServer, answer: tuple[int, object]
) -> None:
    fake_server.answer = answer
    code, _, err = knifetip("job", "hold", "abc", "--server", fake_server.url)
    assert code == 3
    assert f"HTTP status {answer[0]}" in err


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "nonsense"])
def test_an_unreachable_server_is_named(knifetip: Command, url: str) -> None:
    code, _, err = knifetip("job", "list", "--server", url)
    assert code == 3
    assert "cannot be reached" in err


def test_a_slash_in_a_job_id_is_escaped(knifetip: Command, fake_server: FakeServer) -> None:
    knifetip("job", "show", "a/../b", "--server", fake_server.url)
    assert fake_server.requests[0][1] == "/api/v1/jobs/a%2F..%2Fb"
