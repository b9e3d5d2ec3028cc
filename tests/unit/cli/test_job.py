"""knifetip job: what it asks of a server, what it prints, and how it fails."""

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
    "reason": "Waiting for the operator at Demo table: table clear, board e-flute.",
    "hint": "Confirm to start.",
}


class Office:
    """A server that answers every request with a job, and keeps what it was asked."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str, dict[str, Any] | None]] = []
        self.headers: list[dict[str, str]] = []
        self.answer: tuple[int, object] = (200, JOB)
        self.url = ""


@pytest.fixture
def office() -> Iterator[Office]:
    office = Office()

    class Handler(BaseHTTPRequestHandler):
        def _any(self) -> None:
            length = int(self.headers.get("Content-Length") or 0)
            raw = self.rfile.read(length)
            office.asked.append((self.command, self.path, json.loads(raw) if raw else None))
            office.headers.append(dict(self.headers))
            status, body = office.answer
            if self.command == "GET" and "?" in self.path and status == 200:
                body = [body]
            data = body if isinstance(body, bytes) else json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        do_GET = do_POST = _any  # noqa: N815

        def log_message(self, format: str, *args: object) -> None:
            pass

    server = HTTPServer(("127.0.0.1", 0), Handler)
    office.url = f"http://127.0.0.1:{server.server_port}"
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield office
    server.shutdown()
    server.server_close()
    thread.join()


def test_list_prints_what_each_job_waits_for(knifetip: Command, office: Office) -> None:
    code, out, _ = knifetip("job", "list", "--server", office.url, "--state", "queued")
    assert code == 0
    assert out.split()[:2] == ["abc", "queued"]
    assert "waits for confirmation" in out
    assert office.asked == [("GET", "/api/jobs?limit=50&state=queued", None)]


def test_show_prints_reason_hint_and_tools(knifetip: Command, office: Office) -> None:
    _, out, _ = knifetip("job", "show", "abc", "--server", office.url + "/")
    assert "table clear, board e-flute" in out
    assert "Confirm to start." in out
    assert "Oscillating knife (station 1)" in out
    _, out, _ = knifetip("job", "show", "abc", "--server", office.url, "--json")
    assert json.loads(out) == JOB


@pytest.mark.parametrize("command", ["confirm", "hold", "resume", "finish", "requeue"])
def test_a_command_is_sent_to_its_route(knifetip: Command, office: Office, command: str) -> None:
    code, out, _ = knifetip("job", command, "abc", "--server", office.url)
    assert code == 0
    assert "tray.dxf" in out
    body: dict[str, Any] | None = {} if command == "confirm" else None
    assert office.asked == [("POST", f"/api/jobs/abc/{command}", body)]
    assert office.headers[0]["X-Knifetip"] == "cli"
    assert "Authorization" not in office.headers[0]


def test_confirm_names_the_board_and_who(knifetip: Command, office: Office) -> None:
    knifetip("job", "confirm", "abc", "--server", office.url, "--board", "e-flute", "--by", "Kim")
    assert office.asked[0][2] == {"board": "e-flute", "by": "Kim"}


@pytest.mark.parametrize("how", ["option", "environment"])
def test_a_key_is_sent_as_a_bearer(
    knifetip: Command, office: Office, monkeypatch: pytest.MonkeyPatch, how: str
) -> None:
    monkeypatch.setenv("KNIFETIP_KEY", "secret" if how == "environment" else "another")
    more = ("--key", "secret") if how == "option" else ()
    knifetip("job", "show", "abc", "--server", office.url, *more)
    assert office.headers[0]["Authorization"] == "Bearer secret"


@pytest.mark.parametrize("command", ["cancel", "scrap"])
def test_cancel_and_scrap_ask_first(
    knifetip: Command, office: Office, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("n\n"))
    code, _, _ = knifetip("job", command, "abc", "--server", office.url)
    assert code == 1
    assert [method for method, _, _ in office.asked] == ["GET"] * (command == "cancel")
    monkeypatch.setattr("sys.stdin", io.StringIO(""))
    assert knifetip("job", command, "abc", "--server", office.url)[0] == 1
    assert "POST" not in [method for method, _, _ in office.asked]
    code, _, _ = knifetip("job", command, "abc", "--server", office.url, "--yes")
    assert code == 0
    assert office.asked[-1][:2] == ("POST", f"/api/jobs/abc/{command}")


def test_cancel_of_a_running_job_states_what_happens(
    knifetip: Command, office: Office, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("y\n"))
    office.answer = (200, {**JOB, "state": "running"})
    _, out, said = knifetip("job", "cancel", "abc", "--server", office.url)
    assert "holds, lifts the tool and releases its stations" in out + said
    assert office.asked[-1][:2] == ("POST", "/api/jobs/abc/cancel")


def test_a_refusal_is_printed_in_the_servers_words(knifetip: Command, office: Office) -> None:
    office.answer = (409, {"detail": "Job abc is done.", "hint": "Order it again."})
    code, out, said = knifetip("job", "confirm", "abc", "--server", office.url)
    assert (code, out) == (3, "")
    assert "Job abc is done." in said
    assert "Order it again." in said


@pytest.mark.parametrize("answer", [(502, b"<html>"), (500, [])])
def test_an_answer_that_is_no_problem_is_reported_with_its_status(
    knifetip: Command, office: Office, answer: tuple[int, object]
) -> None:
    office.answer = answer
    code, _, said = knifetip("job", "hold", "abc", "--server", office.url)
    assert code == 3
    assert f"answered {answer[0]}" in said


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "nonsense"])
def test_a_server_that_is_not_there_is_named(knifetip: Command, url: str) -> None:
    code, _, said = knifetip("job", "list", "--server", url)
    assert code == 3
    assert "Cannot reach" in said


def test_an_id_with_a_slash_stays_one_id(knifetip: Command, office: Office) -> None:
    knifetip("job", "show", "a/../b", "--server", office.url)
    assert office.asked[0][1] == "/api/jobs/a%2F..%2Fb"
