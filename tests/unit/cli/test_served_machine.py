"""Where a gateway finds its machine: in the library, in a file, or on the server."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from knifetip.cli import served_machine
from knifetip.cli.served_machine import (
    ServerSilent,
    find_machine,
    reload_machine,
    start_machine,
)
from knifetip.errors import GatewayRefused, JobError, LibraryError
from knifetip.library import load
from knifetip.library.definition import Shelf, parse_toml

TOML = load.library_text("machines", "demo-table")


def fields(**changed: Any) -> dict[str, Any]:
    """Return the fields of a machine, as the server sends them."""
    return parse_toml(Shelf.MACHINES, "own", TOML) | changed


class Office(NamedTuple):
    """A server with one answer for all requests, and the requests that it has received."""

    url: str
    requests: list[tuple[str, dict[str, str]]]
    answer: dict[str, Any]


@pytest.fixture
def office() -> Iterator[Office]:
    requests: list[tuple[str, dict[str, str]]] = []
    answer: dict[str, Any] = {"status": 200, "body": b"{}"}

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            requests.append((self.path, {name.lower(): one for name, one in self.headers.items()}))
            self.send_response(answer["status"])
            self.send_header("Content-Length", str(len(answer["body"])))
            self.end_headers()
            self.wfile.write(answer["body"])

        def do_POST(self) -> None:
            self.rfile.read(int(self.headers["Content-Length"]))
            self.do_GET()

        def log_message(self, format: str, *args: object) -> None:
            """Write nothing to the output of the test."""

    server = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    try:
        yield Office(f"http://127.0.0.1:{server.server_port}", requests, answer)
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


def definition(office: Office, **changed: Any) -> None:
    """Let the server answer with the definition of a machine."""
    content = {"name": "own", "version": 7, "fields": fields(), **changed}
    office.answer["body"] = json.dumps(content).encode()


def test_a_machine_of_the_library_needs_no_server() -> None:
    machine = find_machine("demo-table", "http://127.0.0.1:9", {})
    assert (machine.name, machine.version) == ("demo-table", 0)


def test_a_file_needs_no_server(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(TOML.replace("Demo table 1600 × 1200", "Mine"))
    assert find_machine(str(file), "http://127.0.0.1:9", {}).title == "Mine"


def test_a_machine_of_the_server_has_the_version_for_which_jobs_are_claimed(office: Office) -> None:
    definition(office, fields=fields(title="Own table", width=1234.0))
    machine = find_machine("own", office.url + "/", {"Authorization": "Bearer secret"})
    assert (machine.name, machine.title, machine.width) == ("own", "Own table", 1234.0)
    assert machine.version == 7
    ((path, headers),) = office.requests
    assert path == "/api/v1/machines/own/definition"
    assert headers["authorization"] == "Bearer secret"
    assert headers["x-knifetip"] == "gateway"


def test_a_name_is_part_of_the_path_and_nothing_else(office: Office) -> None:
    definition(office)
    find_machine("../jobs?x=1#y", office.url, {})
    assert office.requests[0][0] == "/api/v1/machines/..%2Fjobs%3Fx%3D1%23y/definition"


def test_the_refusal_of_the_server_is_shown(office: Office) -> None:
    problem = {
        "detail": "There is no machine 'own'.",
        "code": "library.unknown",
        "arguments": {"shelf": "machine", "name": "own", "known": ["demo-table"]},
    }
    office.answer.update(status=404, body=json.dumps(problem).encode())
    with pytest.raises(JobError) as refused:
        find_machine("own", office.url, {})
    assert "own" in str(refused.value)
    assert refused.value.message.code != "server.answered"


@pytest.mark.parametrize(
    ("status", "body"),
    [
        (502, b"<html>bad gateway</html>"),
        (500, b'"a text"'),
        (200, b"[]"),
        (200, b"{}"),
        (200, b'{"version": 3}'),
    ],
)
def test_an_answer_of_something_else_is_an_error_with_its_address(
    office: Office, status: int, body: bytes
) -> None:
    office.answer.update(status=status, body=body)
    with pytest.raises(JobError) as failed:
        find_machine("own", office.url, {})
    assert failed.value.message.code == "server.answered"
    assert office.url in str(failed.value)


def test_a_definition_without_fields_is_refused_by_the_library(office: Office) -> None:
    office.answer.update(body=b'{"fields": null, "version": 1}')
    with pytest.raises(LibraryError, match="own"):
        find_machine("own", office.url, {})


def test_a_definition_that_this_version_cannot_read_names_its_field(office: Office) -> None:
    definition(office, fields=fields(into_mat=-1.0))
    with pytest.raises(LibraryError, match="into_mat"):
        find_machine("own", office.url, {})


@pytest.mark.parametrize("url", ["http://127.0.0.1:{port}", "no scheme", "http://[", "ftp://x"])
def test_a_server_that_cannot_be_reached_is_named(url: str) -> None:
    with socket.socket() as door:
        door.bind(("127.0.0.1", 0))  # bound, but not listening
        address = url.format(port=door.getsockname()[1])
        with pytest.raises(JobError) as failed:
            find_machine("own", address, {})
    assert failed.value.message.code == "server.unreachable"
    assert address in str(failed.value)


def test_a_silent_server_does_not_keep_a_gateway_from_its_machine(
    office: Office, tmp_path: Path
) -> None:
    kept = tmp_path / "state" / "own.machine.json"
    with pytest.raises(ServerSilent):
        start_machine("own", "http://127.0.0.1:9", {}, kept)
    definition(office, fields=fields(title="Own table"))
    assert start_machine("own", office.url, {}, kept).title == "Own table"
    again = start_machine("own", "http://127.0.0.1:9", {}, kept)
    assert (again.title, again.version) == ("Own table", 7)
    # The server runs, and its database does not.
    problem = {"detail": "The database does not respond.", "code": "server.database-silent"}
    office.answer.update(status=503, body=json.dumps({**problem, "arguments": {}}).encode())
    assert start_machine("own", office.url, {}, kept).version == 7


def test_a_refused_gateway_may_bring_its_machine_to_safety_and_loads_nothing_else(
    office: Office, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(served_machine, "_PAUSE", 0.0)
    kept = tmp_path / "own.machine.json"
    definition(office)
    start_machine("own", office.url, {}, kept)
    office.answer.update(status=401, body=json.dumps({"detail": "The key was revoked."}).encode())
    assert start_machine("own", office.url, {}, kept).version == 7
    with pytest.raises(GatewayRefused, match="The key was revoked"):
        start_machine("own", office.url, {}, tmp_path / "none.json")
    with pytest.raises(GatewayRefused):
        reload_machine("own", office.url, {}, kept)


def test_a_kept_definition_is_not_used_for_another_machine_or_a_deleted_one(
    office: Office, tmp_path: Path
) -> None:
    kept = tmp_path / "own.machine.json"
    definition(office)
    start_machine("own", office.url, {}, kept)
    with pytest.raises(ServerSilent):
        start_machine("other", "http://127.0.0.1:9", {}, kept)
    deleted = {"detail": "There is no machine.", "code": "library.unknown"}
    arguments = {"shelf": "machine", "name": "own", "known": []}
    office.answer.update(status=404, body=json.dumps({**deleted, "arguments": arguments}).encode())
    with pytest.raises(JobError) as refused:
        start_machine("own", office.url, {}, kept)
    assert not isinstance(refused.value, ServerSilent)
    kept.write_text("{")
    with pytest.raises(ServerSilent):
        start_machine("own", "http://127.0.0.1:9", {}, kept)


def test_a_refused_gateway_ends_with_a_code_of_its_own_and_a_hint(
    office: Office, tmp_path: Path
) -> None:
    office.answer.update(status=403, body=json.dumps({"detail": "No scope gateway."}).encode())
    command = [sys.executable, "-m", "knifetip.cli", "gateway", "--server", office.url]
    command += ["--machine", "demo-table", "--controller", "127.0.0.1:9"]
    command += ["--journal", str(tmp_path / "journal")]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60.0, check=False)
    assert ended.returncode == 4, ended.stderr
    assert "No scope gateway." in ended.stderr
    assert "knifetip key create NAME --scope gateway" in ended.stderr
    assert "Traceback" not in ended.stderr
