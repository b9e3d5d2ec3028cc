"""The server behind nginx, with the configuration of the how-to page: a real proxy with TLS."""

from __future__ import annotations

import os
import re
import shutil
import socket
import ssl
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import pytest

from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from tests.conftest import ROOT
from tests.support.serving.commands import running, served
from tests.support.serving.server import square

NGINX = shutil.which("nginx") or shutil.which("nginx", path="/usr/sbin:/usr/local/sbin")
OPENSSL = shutil.which("openssl")
PASSWORD = "four words of text"
HOST = "knifetip.example"
PAGE = ROOT / "backend" / "docs" / "howto" / "run-a-shop.md"
CLIENT = "127.0.0.5"  #: address from which the tests send requests, other than that of the proxy

pytestmark = [
    pytest.mark.skipif(NGINX is None or OPENSSL is None, reason="needs nginx and openssl"),
    pytest.mark.xdist_group("proxy"),
]


def printed_configuration() -> str:
    """Return the ``server`` block of the how-to page."""
    (block,) = re.findall(r"^```nginx\n(.*?)^```", PAGE.read_text("utf-8"), re.M | re.S)
    return str(block)


def configuration(folder: Path, port: int, server: str) -> str:
    """Return a configuration of nginx with the printed block, for a port and files of its own."""
    block = printed_configuration()
    for printed, ours in (
        ("listen 443 ssl", f"listen 127.0.0.1:{port} ssl"),
        ("/etc/ssl/knifetip.pem", f"{folder}/knifetip.pem"),
        ("/etc/ssl/knifetip.key", f"{folder}/knifetip.key"),
        ("http://127.0.0.1:8080", server),
    ):
        assert printed in block
        block = block.replace(printed, ours)
    files = "".join(
        f"{kind}_temp_path {folder}/{kind};\n"
        for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    )
    # Its worker would otherwise be a user who may not enter the folder.
    user = "user root;\n" if os.geteuid() == 0 else ""
    return (
        f"{user}daemon off;\npid {folder}/pid;\nerror_log stderr;\nworker_processes 1;\n"
        f"events {{}}\nhttp {{\naccess_log off;\n{files}{block}}}\n"
    )


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@contextmanager
def proxy(folder: Path, server: str) -> Iterator[int]:
    """Run nginx in front of a server; yield its port."""
    assert NGINX is not None
    assert OPENSSL is not None
    names = ("-subj", f"/CN={HOST}", "-addext", f"subjectAltName=DNS:{HOST},IP:127.0.0.1")
    files = ("-keyout", folder / "knifetip.key", "-out", folder / "knifetip.pem")
    subprocess.run(
        [OPENSSL, "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", *names, *files],
        check=True,
        capture_output=True,
    )
    port = free_port()
    file = folder / "nginx.conf"
    file.write_text(configuration(folder, port, server))
    process = subprocess.Popen([NGINX, "-c", str(file), "-e", "stderr"], stderr=subprocess.DEVNULL)
    try:
        deadline = time.monotonic() + 120.0
        while True:
            try:
                socket.create_connection(("127.0.0.1", port), 1.0).close()
                break
            except OSError:
                assert process.poll() is None, "nginx has ended"
                assert time.monotonic() < deadline
                time.sleep(0.05)
        yield port
    finally:
        process.terminate()
        process.wait(30.0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("proxy")


@pytest.fixture(scope="module")
def port(folder: Path) -> Iterator[int]:
    """Port of nginx, behind which is a server with an administrator."""
    store = Store(f"sqlite:///{folder}/a.sqlite")
    store.migrate()
    store.users.add("anna", PASSWORD, AccessScope.ADMIN)
    (folder / "gateway_key").write_text(store.keys.add("table", [AccessScope.GATEWAY])[1])
    store.close()
    words = ("--allow-host", HOST)
    with served(f"sqlite:///{folder}/a.sqlite", *words) as (_, url), proxy(folder, url) as port:
        yield port


@pytest.fixture
def page(folder: Path, port: int) -> Iterator[httpx.Client]:
    """A client that sends what the page in a browser sends, from another address."""
    trusted = ssl.create_default_context(cafile=folder / "knifetip.pem")
    headers = {"Host": HOST, "Origin": f"https://{HOST}", "X-Knifetip": "test"}
    with httpx.Client(
        base_url=f"https://127.0.0.1:{port}",
        headers=headers,
        transport=httpx.HTTPTransport(verify=trusted, local_address=CLIENT),
        timeout=60.0,
    ) as client:
        yield client


def sign_in(page: httpx.Client) -> str:
    """Sign in, and let the client send the cookie; return the header that sets it."""
    answer = page.post("/api/v1/session", json={"name": "anna", "password": PASSWORD})
    assert answer.status_code == 200, answer.text
    cookie = answer.headers["set-cookie"]
    # The client takes the cookie for one of 127.0.0.1, and not of the host in its header.
    page.headers["Cookie"] = cookie.partition(";")[0]
    return cookie


def test_a_user_signs_in_and_works_through_the_proxy(page: httpx.Client) -> None:
    assert page.get("/api/v1/jobs").status_code == 401
    cookie = sign_in(page)
    assert "Secure" in cookie
    assert "HttpOnly" in cookie
    lines = tuple(f"999\n{'x' * 200}\n" for _ in range(60_000))
    large = {"file": ("large.dxf", square(extra=lines))}
    answer = page.post("/api/v1/drawings", files=large)
    assert answer.status_code == 201, answer.text
    assert page.get("/api/v1/drawings").json()[0]["name"] == "large.dxf"


def test_the_audit_log_has_the_address_of_the_client(page: httpx.Client) -> None:
    sign_in(page)
    page.post("/api/v1/drawings", files={"file": ("a.dxf", square())}).raise_for_status()
    peers = {entry["peer"] for entry in page.get("/api/v1/audit").json()}
    assert peers == {CLIENT}


def test_what_another_site_sends_is_refused(page: httpx.Client) -> None:
    sign_in(page)
    for origin in ("https://evil.example", f"http://{HOST}"):
        answer = page.post(
            "/api/v1/drawings", files={"file": ("a.dxf", square())}, headers={"Origin": origin}
        )
        assert answer.status_code == 403, origin
    assert page.get("/api/v1/jobs", headers={"Host": "evil.example"}).status_code == 421


def test_events_arrive_at_once(page: httpx.Client) -> None:
    sign_in(page)
    with page.stream("GET", "/api/v1/events") as stream:
        assert stream.status_code == 200
        lines = stream.iter_lines()
        next(lines)
        sent = time.monotonic()
        page.post("/api/v1/drawings", files={"file": ("event.dxf", square())}).raise_for_status()
        for line in lines:
            if "drawing" in line:
                break
        assert time.monotonic() - sent < 60.0


def test_a_gateway_connects_through_the_proxy(
    folder: Path, port: int, page: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SSL_CERT_FILE", str(folder / "knifetip.pem"))
    monkeypatch.setenv("NO_PROXY", "*")
    sign_in(page)
    with running("simulator", "--port", 0) as table:
        address = table.said(r"127\.0\.0\.1:\d+")
        words = ("--server", f"https://127.0.0.1:{port}", "--key-file", folder / "gateway_key")
        with running("gateway", *words, "--controller", address, "--journal", folder / "j"):
            deadline = time.monotonic() + 120.0
            while not page.get("/api/v1/machines/demo-table/station").json()["connected"]:
                assert time.monotonic() < deadline
                time.sleep(0.1)
