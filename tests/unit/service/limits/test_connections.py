"""Connections that send too slowly are closed, and idle ones are closed for gateways."""

from __future__ import annotations

import json
import select
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx
import pytest
import uvicorn

from knifetip.server import embedded
from knifetip.server.app import create_app
from knifetip.service.accounts import access
from knifetip.service.accounts.access_rules import AccessRules, find_access
from knifetip.service.limits.connections import ConnectionLimits, LimitedProtocol, limited_protocol
from knifetip.service.settings import Settings
from tests.support.serving.server import order_job, service_of, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")

#: A valid Host header on every port: the server is started with this name.
HEAD = b"Host: test.example\r\nUser-Agent: test\r\n"


@contextmanager
def server(folder: Path, limits: ConnectionLimits, page: Path = Path()) -> Iterator[httpx.Client]:
    app = create_app(
        Settings(
            database=f"sqlite:///{folder}/shop.sqlite",
            name="test",
            page=page,
        ),
        AccessRules(hosts=("test.example",), loopback_only=True),
    )
    config = uvicorn.Config(
        app, port=0, log_level="error", timeout_graceful_shutdown=1, http=limited_protocol(limits)
    )
    running = uvicorn.Server(config)
    thread = threading.Thread(target=running.run)
    thread.start()
    while not running.started and thread.is_alive():
        time.sleep(0.02)
    port = running.servers[0].sockets[0].getsockname()[1]
    try:
        with httpx.Client(
            base_url=f"http://127.0.0.1:{port}", timeout=60.0, trust_env=False
        ) as client:
            yield client
    finally:
        service_of(app).stopping.set()
        running.should_exit = True
        thread.join()


def connect(client: httpx.Client) -> socket.socket:
    connection = socket.create_connection(("127.0.0.1", client.base_url.port or 0), 20.0)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def until_closed(connection: socket.socket) -> bytes:
    """Return what the server sends until it closes the connection."""
    received = b""
    with suppress(ConnectionResetError):  # the server has closed before it read everything
        while block := connection.recv(65536):
            received += block
    return received


def wait_for_reset(connection: socket.socket) -> bool:
    """Wait until the server has reset a connection from which nothing is read."""
    watch = select.poll()
    watch.register(connection, 0)  # errors and resets are always reported
    return any(kind & (select.POLLERR | select.POLLHUP) for _, kind in watch.poll(20_000))


def drip(connection: socket.socket, content: bytes, pause: float) -> bytes:
    """Send a byte after each pause until the server closes; return what the server sent."""
    connection.settimeout(pause)
    for position in range(len(content)):
        try:
            connection.sendall(content[position : position + 1])
            received = connection.recv(65536)
        except TimeoutError:
            continue
        if received:
            connection.settimeout(20.0)
            return received + until_closed(connection)
        break
    raise AssertionError("the server closed without an answer, or took all bytes")


def test_a_connection_that_sends_no_head_is_answered_408_and_closed(tmp_path: Path) -> None:
    with server(tmp_path, ConnectionLimits(head=0.4)) as client:
        with connect(client) as silent:
            answer = until_closed(silent)
        assert answer.startswith(b"HTTP/1.1 408 ")
        body = json.loads(answer.partition(b"\r\n\r\n")[2])
        assert body["code"] == "limit.too-slow"
        # A further byte of a head does not prolong the time for the head.
        with connect(client) as slow:
            head = b"GET /healthz HTTP/1.1\r\n" + HEAD + b"X-Long: " + b"a" * 200
            assert drip(slow, head, 0.1).startswith(b"HTTP/1.1 408 ")


def test_an_idle_connection_is_kept_longer_than_by_pools_of_clients(tmp_path: Path) -> None:
    # httpx keeps a connection for 5 s, nginx for 60 s.  If the server closed it at the same moment,
    # the next request on it would fail without an answer.
    assert ConnectionLimits().idle > 60.0
    with server(tmp_path, ConnectionLimits(idle=0.4)) as client, connect(client) as connection:
        connection.settimeout(4.0)  # less than the 5 s of uvicorn
        connection.sendall(b"GET /healthz HTTP/1.1\r\n" + HEAD + b"\r\n")
        assert until_closed(connection).startswith(b"HTTP/1.1 200 ")


def test_a_second_head_on_a_connection_has_the_same_time(tmp_path: Path) -> None:
    with server(tmp_path, ConnectionLimits(head=2.0)) as client, connect(client) as connection:
        connection.sendall(b"GET /healthz HTTP/1.1\r\n" + HEAD + b"\r\n")
        first = connection.recv(65536)
        assert first.startswith(b"HTTP/1.1 200 ")
        connection.sendall(b"GET /healthz HT")
        rest = until_closed(connection)
        assert b"HTTP/1.1 408 " in rest


def test_a_body_that_stalls_is_answered_408_and_closed(tmp_path: Path) -> None:
    limits = ConnectionLimits(body=0.3, body_bytes=1000)
    with server(tmp_path, limits) as client, connect(client) as connection:
        connection.sendall(
            b"POST /api/jobs HTTP/1.1\r\n" + HEAD + b"Content-Type: application/json\r\n"
            b"Content-Length: 5000\r\n\r\n{"
        )
        answer = drip(connection, b" " * 200, 0.05)
        assert answer.startswith(b"HTTP/1.1 408 ")


def test_a_body_that_arrives_slowly_but_steadily_is_accepted(tmp_path: Path) -> None:
    # 900 bytes in at least 3.6 s; 100 of them must arrive within 3 s.
    limits = ConnectionLimits(body=3.0, body_bytes=100)
    body = b'{"drawing": "none", "board": "e-flute"}'.ljust(900)
    with server(tmp_path, limits) as client, connect(client) as connection:
        connection.sendall(
            b"POST /api/jobs HTTP/1.1\r\n" + HEAD + b"Content-Type: application/json\r\n"
            b"Connection: close\r\nContent-Length: 900\r\n\r\n"
        )
        for start in range(0, 900, 50):
            connection.sendall(body[start : start + 50])
            time.sleep(0.2)
        assert until_closed(connection).startswith(b"HTTP/1.1 404 ")


def test_a_client_that_reads_nothing_is_disconnected(tmp_path: Path) -> None:
    page = tmp_path / "page"
    (page / "assets").mkdir(parents=True)
    (page / "index.html").write_text("page")
    (page / "assets" / "large-1.bin").write_bytes(bytes(32 << 20))
    limits = ConnectionLimits(answer=0.3)
    with server(tmp_path, limits, page) as client, connect(client) as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.sendall(b"GET /assets/large-1.bin HTTP/1.1\r\n" + HEAD + b"\r\n")
        # Waits longer than the limit: the server must not, whatever the client does.
        assert wait_for_reset(connection)


def test_500_idle_connections_do_not_stop_the_heartbeats_of_a_gateway(tmp_path: Path) -> None:
    limits = ConnectionLimits(per_client=100, total=150)
    with server(tmp_path, limits) as client, ExitStack() as held:
        job = order_job(client, upload_drawing(client, square())["id"], release=True)["id"]
        claimed = client.post(
            "/api/gateway/claim", json={"gateway": "g", "machine": "demo-table", "wait": 50}
        )
        assert claimed.status_code == 200
        claim = claimed.json()
        assert claim["job"] == job
        idle = [held.enter_context(connect(client)) for _ in range(500)]
        beat = {"job": job, "epoch": claim["epoch"], "line": 1}
        for one in idle[::50]:
            one.sendall(b"GET /")
            assert client.post("/api/gateway/heartbeat", json=beat).status_code == 200
        # The server keeps 100 connections of this address at most.
        open_ones = 0
        for one in idle:
            one.setblocking(False)
            try:
                one.recv(1)
            except BlockingIOError:
                open_ones += 1
            except OSError:
                pass
        assert open_ones <= 100
        assert client.get(f"/api/jobs/{job}").json()["state"] == "running"


def test_waiting_gateways_of_one_address_are_not_counted(tmp_path: Path) -> None:
    limits = ConnectionLimits(per_client=4)
    with server(tmp_path, limits) as client, ExitStack() as held:
        claims = []
        for number in range(8):
            connection = held.enter_context(connect(client))
            body = json.dumps(
                {"gateway": f"g{number}", "machine": "demo-table", "wait": 30}
            ).encode()
            connection.sendall(
                b"POST /api/v1/gateway/claim HTTP/1.1\r\n"
                + HEAD
                + b"Content-Type: application/json\r\n"
                b"Content-Length: %d\r\n\r\n" % len(body) + body
            )
            claims.append(connection)
            assert client.get("/healthz").status_code == 200
        for connection in claims:
            connection.setblocking(False)
            with pytest.raises(BlockingIOError):
                connection.recv(1)


def test_refused_requests_to_routes_of_gateways_are_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judged = threading.Semaphore(0)

    def judge(*facts: Any) -> object:
        judged.release()
        return find_access(*facts)

    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 600.0)
    monkeypatch.setattr(access, "find_access", judge)
    limits = ConnectionLimits(head=60.0, per_client=2)
    with server(tmp_path, limits) as client, ExitStack() as held:
        client.close()
        while judged.acquire(blocking=False):
            pass  # requests of the start
        for _ in range(2):
            held.enter_context(connect(client)).sendall(
                b"GET /api/gateway/program/x HTTP/1.1\r\nAuthorization: Bearer wrong\r\n"
                + HEAD
                + b"\r\n"
            )
            # Until its request is received, a connection is idle and may be closed for another.
            assert judged.acquire(timeout=60.0)
        with connect(client) as further:
            answer = until_closed(further)
        assert answer.startswith(b"HTTP/1.1 503 ")


def test_a_connection_is_refused_while_all_others_are_busy(tmp_path: Path) -> None:
    limits = ConnectionLimits(per_client=2)
    with server(tmp_path, limits) as client, ExitStack() as held:
        client.close()
        for _ in range(2):
            listener = held.enter_context(connect(client))
            listener.sendall(b"GET /api/events HTTP/1.1\r\n" + HEAD + b"\r\n")
            received = b""
            while b"event: connected" not in received:
                block = listener.recv(65536)
                assert block, received
                received += block
        with connect(client) as refused:
            answer = until_closed(refused)
        assert answer.startswith(b"HTTP/1.1 503 ")
        assert b"Retry-After" in answer
        assert json.loads(answer.partition(b"\r\n\r\n")[2])["code"] == (
            "limit.too-many-connections"
        )


def test_the_service_limits_its_connections(tmp_path: Path) -> None:
    rules = AccessRules(loopback_only=True)
    app = create_app(Settings(database=f"sqlite:///{tmp_path}/shop.sqlite"), rules)
    limits = ConnectionLimits(head=3.0, per_client=7)
    config = embedded._Server(app, [], print, False, limits).config
    config.load()
    assert issubclass(config.http_protocol_class, LimitedProtocol)
    assert config.http_protocol_class.limits is limits
