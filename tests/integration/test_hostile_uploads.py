"""Malicious files and requests to a server in its own process.

It reports the reason quickly and with little memory, and continues to serve.
"""

from __future__ import annotations

import re
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx
import pytest

from tests.support.serving.server import Running, square, upload_drawing
from tests.support.writers import hostile, svg_text

pytestmark = pytest.mark.xdist_group("uploads")

_MEGABYTE = 1 << 20
#: Time limit on a busy machine; on an idle one no request takes more than 5.
_SECONDS = 60.0
#: Limit of additional memory: an upload of 64 MB is stored and passed on to a worker process.
_MORE_MEMORY = 512 * _MEGABYTE


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    database = tmp_path_factory.mktemp("server") / "shop.sqlite"
    running = Running(database, simulator=False)
    running.client.timeout = httpx.Timeout(2.0 * _SECONDS)
    with running:
        # Reading the first file compiles kernels, which is not measured here.
        for drawing in (svg_text.carton(), square()):
            upload_drawing(running.client, drawing)
        yield running
        assert running.process.poll() is None


def peak_memory(server: Running) -> int:
    """Return the peak memory of the server's process (bytes), 0 if the system does not report
    it.
    """
    status = Path(f"/proc/{server.process.pid}/status")
    if not status.exists():
        return 0
    return int(re.findall(r"VmHWM:\s+(\d+) kB", status.read_text())[0]) << 10


@contextmanager
def unharmed(server: Running) -> Iterator[None]:
    """Check that the code in the context takes little time and memory, and that the server works
    after it.
    """
    before, start = peak_memory(server), time.monotonic()
    yield
    assert time.monotonic() - start < _SECONDS
    assert peak_memory(server) - before < _MORE_MEMORY
    assert upload_drawing(server.client, square())["segments"] == 4


def check_problem(answer: httpx.Response, status: int, word: str) -> None:
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert word in problem["detail"]
    assert problem["hint"]
    assert len(answer.content) < 10_000
    assert "Traceback" not in answer.text


@pytest.mark.parametrize("name", hostile.REFUSED)
def test_a_hostile_file_is_refused(server: Running, name: str) -> None:
    status, word, made = hostile.REFUSED[name]
    with unharmed(server):
        answer = server.client.post("/api/drawings", files={"file": ("a.dxf", made())})
        check_problem(answer, status, word)
        assert "a.dxf" in answer.json()["detail"]


@pytest.mark.parametrize("name", hostile.READ)
def test_hostile_parts_of_a_file_are_omitted_and_reported(server: Running, name: str) -> None:
    word, edges, made = hostile.READ[name]
    with unharmed(server):
        drawing = upload_drawing(server.client, made(), unit="mm")
        assert drawing["segments"] == edges
        assert any(word in row["reason"]["text"] for row in drawing["import_report"]["rows"])
        assert max(map(abs, drawing["bounds"])) <= 1e7


def test_nothing_that_a_file_points_to_is_fetched(server: Running) -> None:
    with socket.create_server(("127.0.0.1", 0)) as elsewhere:
        elsewhere.settimeout(1.0)
        url = f"http://127.0.0.1:{elsewhere.getsockname()[1]}/"
        upload_drawing(server.client, hostile.external_references(url))
        refused = server.client.post(
            "/api/drawings", files={"file": ("a.svg", hostile.external_entity(url))}
        )
        check_problem(refused, 422, "is not loaded")
        with pytest.raises(TimeoutError):
            elsewhere.accept()


# ── Requests ──────────────────────────────────────────────────────────────────────────────────


_HEAD = b'--x\r\nContent-Disposition: form-data; name="file"; filename="a.dxf"\r\n\r\n'
_TAIL = b"\r\n--x--\r\n"
_FORM = "multipart/form-data; boundary=x"


@contextmanager
def connected(server: Running) -> Iterator[socket.socket]:
    url = server.client.base_url
    with socket.create_connection((url.host, url.port), timeout=_SECONDS) as connection:
        yield connection


def request(server: Running, *headers: str) -> bytes:
    host = f"Host: {server.client.base_url.netloc.decode()}"
    lines = (
        "POST /api/drawings HTTP/1.1", host, f"Content-Type: {_FORM}", "X-Knifetip: test", *headers
    )  # fmt: skip
    return "\r\n".join([*lines, "", ""]).encode()


def received_bytes(connection: socket.socket) -> bytes:
    """Return the bytes received until the server closes the connection or stops sending."""
    received = b""
    with suppress(ConnectionError, TimeoutError):
        while part := connection.recv(65536):
            received += part
    return received


def test_half_a_gigabyte_in_pieces_is_refused_after_the_first_64_megabytes(server: Running) -> None:
    piece = b"999\nnothing\n" * 87_381
    sent = 0
    with unharmed(server), connected(server) as connection:
        connection.sendall(request(server, "Transfer-Encoding: chunked"))
        with suppress(ConnectionError):
            for part in [_HEAD, *[piece] * 500, _TAIL]:
                connection.sendall(b"%x\r\n%b\r\n" % (len(part), part))
                sent += len(part)
        connection.settimeout(2.0)
        received = received_bytes(connection)
    # Bytes in the buffers of the connection count as sent.
    assert 64 * _MEGABYTE <= sent < 96 * _MEGABYTE
    # The response may be lost if the server closes the connection while the client sends.
    assert received == b"" or received.startswith(b"HTTP/1.1 413")


def test_an_announced_half_gigabyte_is_refused_before_it_is_sent(server: Running) -> None:
    with unharmed(server), connected(server) as connection:
        connection.sendall(request(server, f"Content-Length: {500 * _MEGABYTE}"))
        assert received_bytes(connection).startswith(b"HTTP/1.1 413")


def test_an_incomplete_request_is_discarded_when_its_connection_closes(
    server: Running,
) -> None:
    with unharmed(server), connected(server) as connection:
        connection.sendall(request(server, "Content-Length: 1000000") + _HEAD + square())
        connection.settimeout(0.5)
        assert received_bytes(connection) == b""


def test_bytes_beyond_the_announced_length_are_no_second_request(server: Running) -> None:
    whole = _HEAD + square() + _TAIL
    with unharmed(server), connected(server) as connection:
        connection.sendall(request(server, f"Content-Length: {len(whole) - 20}") + whole)
        connection.settimeout(2.0)
        received = received_bytes(connection)
    # The form has no end mark; the bytes after it are not HTTP.
    assert received.startswith(b"HTTP/1.1 4")
    assert received.count(b"HTTP/1.1 2") == 0


@pytest.mark.parametrize("length", ["-1", "1e3", "9" * 5000, "5, 6", ""])
def test_an_invalid_length_is_a_bad_request(server: Running, length: str) -> None:
    with unharmed(server), connected(server) as connection:
        connection.sendall(request(server, f"Content-Length: {length}") + _HEAD)
        connection.settimeout(2.0)
        assert received_bytes(connection).startswith(b"HTTP/1.1 4")


def test_fifty_clients_that_stop_sending_do_not_delay_others(server: Running) -> None:
    with unharmed(server):
        lines = [connected(server) for _ in range(50)]
        start = request(server, "Content-Length: 60000000") + _HEAD + b"0\n" * 1000
        for connection in lines:
            connection.__enter__().sendall(start)
        assert upload_drawing(server.client, square())["segments"] == 4
        for connection in lines:
            connection.__exit__(None, None, None)


FORMS = {
    "a field of a megabyte": _HEAD.replace(b'"file"', b'"' + b"f" * _MEGABYTE + b'"') + _TAIL,
    "a name of a megabyte": _HEAD.replace(b"a.dxf", b"a" * _MEGABYTE) + square() + _TAIL,
    "heads without end": b"--x\r\n" + b"X-A: b\r\n" * 100_000,
    "many fields": b'--x\r\nContent-Disposition: form-data; name="a"\r\n\r\n\r\n' * 20_000 + _TAIL,
    "many files": _HEAD.replace(b'"file"', b'"other"') + (b"\r\n" + _HEAD) * 5000 + _TAIL,
    "no file name": _HEAD.replace(b'; filename="a.dxf"', b"") + square() + _TAIL,
    "no file": _HEAD.replace(b'"file"', b'"other"') + square() + _TAIL,
    "a long unit": _HEAD + square() + b"\r\n" + _HEAD.replace(
        b'"file"; filename="a.dxf"', b'"unit"'
    ) + b"m" * _MEGABYTE + _TAIL,
    "an empty file": _HEAD + _TAIL,
    "no end": _HEAD + square(),
    "no beginning": square() + _TAIL,
}  # fmt: skip


@pytest.mark.parametrize("name", FORMS)
def test_a_hostile_form_is_a_problem(server: Running, name: str) -> None:
    with unharmed(server):
        answer = server.client.post(
            "/api/drawings", content=FORMS[name], headers={"Content-Type": _FORM}
        )
        assert 400 <= answer.status_code < 500, answer.text
        assert answer.headers["content-type"] == "application/problem+json"
        assert answer.json()["detail"]
        assert len(answer.content) < 10_000


@pytest.mark.parametrize("kind", ["", "text/plain", "multipart/form-data; boundary=", "a" * 5000])
def test_a_form_with_another_content_type_is_a_problem(server: Running, kind: str) -> None:
    with unharmed(server):
        answer = server.client.post(
            "/api/drawings", content=_HEAD + square() + _TAIL, headers={"Content-Type": kind}
        )
        assert 400 <= answer.status_code < 500, answer.text
        assert answer.headers["content-type"] == "application/problem+json"


def test_a_name_with_special_characters_is_kept_as_plain_text(server: Running) -> None:
    name = '../../<script>alert(1)</script>\u202e"%s.dxf'
    body = _HEAD.replace(b"a.dxf", name.encode().replace(b'"', b"%22")) + square() + _TAIL
    with unharmed(server):
        answer = server.client.post("/api/drawings", content=body, headers={"Content-Type": _FORM})
        assert answer.status_code == 201, answer.text
        assert answer.json()["name"].endswith("s.dxf")
        assert not set(answer.json()["name"]) & set("/\\\u202e")


def test_many_hostile_uploads_at_once_leave_a_working_server(server: Running) -> None:
    """Eight clients send files that expand without limit, while one client sends a carton."""
    bombs = [made for _, _, made in hostile.REFUSED.values() if made.__name__ != "<lambda>"]
    statuses: list[int] = []

    def send(made: hostile.Maker) -> None:
        answer = httpx.post(
            f"{server.client.base_url}/api/drawings",
            files={"file": ("a.dxf", made())},
            timeout=2.0 * _SECONDS,
            trust_env=False,
        )
        statuses.append(answer.status_code)

    with unharmed(server):
        senders = [threading.Thread(target=send, args=(made,)) for made in bombs]
        for sender in senders:
            sender.start()
        assert upload_drawing(server.client, svg_text.carton())["unit"] == "mm"
        for sender in senders:
            sender.join()
    assert len(statuses) == len(bombs) >= 6
    assert set(statuses) <= {413, 422}
