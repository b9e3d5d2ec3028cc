"""Hot folder: orders that are repeated, refused for one file, or made by two processes."""

from __future__ import annotations

import http.server
import json
import os
import shutil
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

import httpx
import pytest

from knifetip.cli.hot_folder.arrivals import Arrivals
from knifetip.cli.hot_folder.client import OrderClient, RetryLater
from knifetip.cli.hot_folder.orders import OrderFolder
from knifetip.cli.hot_folder.reservation import reserved
from knifetip.cli.watch import _look
from knifetip.errors import SettingsError
from knifetip.service.settings import Settings
from tests.support.command import Command
from tests.support.serving.server import LocalClient, run_server, square
from tests.unit.cli.test_watch import DEFAULTS, drop, jobs_of, result, run

pytestmark = pytest.mark.xdist_group("watch")

WATCH = ("--board", "e-flute", "--settle", 0, "--interval", 0.1, "--once")


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("watch")
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test")) as client:
        yield client


def watch(knifetip: Command, folder: Path, server: object, *more: object) -> tuple[int, str]:
    code, _, err = knifetip("watch", folder, "--server", str(server), *WATCH, *more)
    return code, err


def test_a_drawing_that_is_put_into_the_folder_again_is_ordered_again(
    shop: LocalClient, tmp_path: Path, knifetip: Command
) -> None:
    """A file manager keeps the time of a file that it copies: name, time and content are equal."""
    original, folder = tmp_path / "tray.dxf", tmp_path / "hot"
    original.write_bytes(square(side=41.0))
    os.utime(original, (1_700_000_000, 1_700_000_000))
    folder.mkdir()
    for name in ("tray.dxf", "tray-2.dxf"):
        drop(folder, "tray.dxf", b"", external_id="PO-weekly")
        shutil.copy2(original, folder / "tray.dxf")
        assert watch(knifetip, folder, shop.base_url)[0] == 0
        assert result(folder, "done", name)["state"] == "ready"
    assert len(jobs_of(shop, "PO-weekly")) == 2


def test_a_field_of_the_order_cannot_name_another_drawing(
    shop: LocalClient, tmp_path: Path, knifetip: Command
) -> None:
    drop(tmp_path, "tray.dxf", square(side=42.0), drawing="abc", external_id="PO-other")
    watch(knifetip, tmp_path, shop.base_url)
    assert "drawing" in result(tmp_path, "failed", "tray.dxf")["reason"]
    assert jobs_of(shop, "PO-other") == []


class Answers(http.server.BaseHTTPRequestHandler):
    """Handler that answers each request with ``answer``."""

    def answer(self) -> None:
        raise NotImplementedError

    def do_GET(self) -> None:  # name of http.server
        self.answer()

    def do_POST(self) -> None:  # name of http.server
        self.answer()

    def send(self, status: int, headers: dict[str, str], content: bytes) -> None:
        self.send_response(status)
        for name, value in {**headers, "Content-Length": str(len(content))}.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def read(self) -> bytes:
        return self.rfile.read(int(self.headers.get("content-length", 0)))

    def log_message(self, *_: object) -> None:
        pass


@contextmanager
def serve(handler: type[Answers]) -> Iterator[str]:
    """Run an HTTP server on loopback; yield its URL."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    server.daemon_threads = True
    thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}"
    finally:
        server.shutdown()
        server.server_close()


def proxy_with_limit(server: str, limit: int) -> AbstractContextManager[str]:
    """Run a proxy before a server that refuses larger requests with a page, as nginx does."""

    class Proxy(Answers):
        def answer(self) -> None:
            content = self.read()
            if len(content) > limit:
                self.send(413, {"Content-Type": "text/html"}, b"<h1>Too Large</h1>")
                return
            names = ("Content-Type", "Idempotency-Key", "X-Knifetip")
            headers = {name: self.headers[name] for name in names if name in self.headers}
            found = httpx.request(
                self.command, server + self.path, content=content, headers=headers, timeout=60.0
            )
            kept = ("content-type", "content-disposition")
            self.send(
                found.status_code,
                {name: found.headers[name] for name in kept if name in found.headers},
                found.content,
            )

    return serve(Proxy)


def page_server() -> AbstractContextManager[str]:
    """Run a server that answers each request with a page."""

    class Page(Answers):
        def answer(self) -> None:
            self.read()
            self.send(200, {"Content-Type": "text/html"}, b"<form>Sign in</form>")

    return serve(Page)


def test_a_file_that_a_proxy_refuses_does_not_block_the_others(
    shop: LocalClient, tmp_path: Path
) -> None:
    comment = b"999\n" + b"x" * 50_000 + b"\n"
    drop(tmp_path, "a-large.dxf", comment + square(), external_id="PO-large")
    drop(tmp_path, "b-small.dxf", square(side=43.0), external_id="PO-small")
    with proxy_with_limit(str(shop.base_url).rstrip("/"), 20_000) as proxy:
        client = OrderClient(proxy, {})
        orders = OrderFolder(tmp_path, DEFAULTS, client)
        arrivals = Arrivals(tmp_path, 0.0, lambda: 0.0)
        for _ in range(100_000):
            is_busy, pause = _look(arrivals, orders, 1.0, 1.0)
            if (tmp_path / "done" / "b-small.dxf").exists():
                break
        client.close()
    assert is_busy
    assert pause > 1.0
    assert result(tmp_path, "done", "b-small.dxf")["state"] == "ready"
    assert (tmp_path / "working" / "a-large.dxf").exists()


def test_one_process_watches_a_folder(shop: LocalClient, tmp_path: Path, knifetip: Command) -> None:
    drop(tmp_path, "tray.dxf", square(side=44.0), external_id="PO-two")
    (tmp_path / "working").mkdir()
    with reserved(tmp_path):
        code, err = watch(knifetip, tmp_path, shop.base_url)
        assert code
        assert "Another process" in err
        assert (tmp_path / "tray.dxf").exists()
        with pytest.raises(SettingsError), reserved(tmp_path):
            pass
    assert watch(knifetip, tmp_path, shop.base_url)[0] == 0
    assert len(jobs_of(shop, "PO-two")) == 1


def test_a_page_of_a_proxy_keeps_the_files(shop: LocalClient, tmp_path: Path) -> None:
    """A proxy on which a person must sign in answers with its own page, and status 200."""
    drop(tmp_path, "tray.dxf", square(side=45.0), external_id="PO-page")
    with page_server() as url:
        client = OrderClient(url, {})
        orders = OrderFolder(tmp_path, DEFAULTS, client)
        orders.take("tray.dxf")
        with pytest.raises(RetryLater):
            orders.advance("tray.dxf")
        client.close()
    client = OrderClient(str(shop.base_url), {})
    run(OrderFolder(tmp_path, DEFAULTS, client))
    client.close()
    assert len(jobs_of(shop, "PO-page")) == 1


def test_a_drawing_that_cannot_be_moved_keeps_its_fields(
    shop: LocalClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is renamed or locked at this moment: its fields must not become those of a later one."""
    client = OrderClient(str(shop.base_url), {})
    orders = OrderFolder(tmp_path, DEFAULTS, client)
    drop(tmp_path, "tray.dxf", square(side=46.0), external_id="PO-moved", copies=50)
    replace = os.replace

    def locked(source: Path, target: Path) -> None:
        if Path(source) == tmp_path / "tray.dxf":
            raise PermissionError(13, "The process cannot access the file")
        replace(source, target)

    monkeypatch.setattr(os, "replace", locked)
    assert not orders.take("tray.dxf")
    assert sorted(os.listdir(tmp_path / "working")) == []
    assert json.loads((tmp_path / "tray.dxf.json").read_text())["copies"] == 50
    monkeypatch.setattr(os, "replace", replace)
    run(orders, "tray.dxf")
    client.close()
    (job,) = jobs_of(shop, "PO-moved")
    assert job["copies"] == 50
