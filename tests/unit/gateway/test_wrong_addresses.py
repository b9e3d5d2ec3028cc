"""An address at which there can be no controller ends the gateway; a silent one is tried again."""

from __future__ import annotations

import asyncio
import http.server
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Coroutine, Iterator
from typing import Any

import httpx
import pytest

from knifetip.errors import ControllerError, NoSuchController
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import Controller, SafeState
from knifetip.gateway.grbl import driver as grbl
from knifetip.gateway.hot_folder import dial as open_folder
from knifetip.gateway.hpgl import driver as hpgl
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.linuxcnc import driver as linuxcnc
from knifetip.gateway.transport import connect
from knifetip.library import load

MACHINE = load.machine("demo-table")
SAFE = SafeState.from_machine(MACHINE)


class RefuseAll(http.server.BaseHTTPRequestHandler):
    """A web server without any page."""

    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        """Refuse a request that it understands."""
        self.send_error(404)

    def log_message(self, format: str, *values: object) -> None:
        """Write nothing to the terminal."""


class Modern(RefuseAll):
    """A web server that states its version also to a client that it does not understand."""

    default_request_version = "HTTP/1.1"


@pytest.fixture(params=[RefuseAll, Modern])
def web_server(request: pytest.FixtureRequest) -> Iterator[str]:
    """Yield HOST:PORT of a web server."""
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), request.param) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"127.0.0.1:{server.server_address[1]}"
        server.shutdown()
        thread.join()


@pytest.mark.parametrize(
    "address",
    [
        "foo://table:1",
        "table",
        "tcp://the table:23",
        "tcp://table..shop:23",
        "tcp://-table:23",
        "tcp://192.168.1.300:23",
        "telnet://t@ble,1",
        f"tcp://{'a' * 64}:23",
        "ws://a b:80/",
        "serial://",
        "serial:///dev/ttyUSB0?speed=1",
    ],
)
async def test_a_text_that_cannot_be_an_address_is_detected(address: str) -> None:
    with pytest.raises(NoSuchController) as wrong:
        await connect(address)
    assert wrong.value.hint


@pytest.mark.parametrize("host", ["127.0.0.1", "[::1]", "localhost", "table-7.invalid", "täble"])
async def test_a_host_that_is_off_or_unknown_is_no_wrong_address(host: str) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with pytest.raises(ControllerError) as absent:
        await connect(f"tcp://{host}:{port}")
    assert not isinstance(absent.value, NoSuchController)


@pytest.mark.parametrize(
    "dial",
    [
        lambda: linuxcnc.dial("http://table:5007", SAFE),
        lambda: linuxcnc.dial("linuxcnc://ta ble:5007", SAFE),
        lambda: hpgl.dial("serial:///dev/ttyS9?flow=none", SAFE),
        lambda: open_folder("file://elsewhere/jobs", stem="a", suffix=".ngc"),
    ],
    ids=["linuxcnc scheme", "linuxcnc host", "hpgl", "folder"],
)
async def test_each_driver_reports_a_wrong_address(
    dial: Callable[[], Coroutine[Any, Any, Controller]],
) -> None:
    with pytest.raises(NoSuchController):
        await dial()


async def test_a_web_server_is_not_taken_for_a_silent_linuxcnc(web_server: str) -> None:
    with pytest.raises(NoSuchController, match="web server answers"):
        await linuxcnc.dial(web_server, SAFE)


@pytest.mark.parametrize("scheme", ["tcp", "telnet"])
async def test_a_web_server_is_not_taken_for_a_silent_grbl(web_server: str, scheme: str) -> None:
    with pytest.raises(NoSuchController, match="web server answers"):
        await grbl.dial(f"{scheme}://{web_server}", SAFE, silence=0.3)


async def test_a_web_server_without_web_socket_is_reported(web_server: str) -> None:
    with pytest.raises(NoSuchController):
        await connect(f"ws://{web_server}/")


# -- the gateway ----------------------------------------------------------------------------------


async def run(connect: Callable[[SafeState, bool], Coroutine[Any, Any, Controller]]) -> None:
    async with httpx.AsyncClient(
        transport=httpx.MockTransport(lambda request: httpx.Response(204))
    ) as client:
        settings = GatewaySettings("http://office", MACHINE, "table-7", wait=0.0)
        await run_gateway(settings, connect, client=client)


async def test_a_wrong_address_ends_the_gateway() -> None:
    async def connect(safe: SafeState, stop_motion: bool) -> Controller:
        raise NoSuchController("controller.web-server", address="table:80")

    async with asyncio.timeout(60.0):
        with pytest.raises(NoSuchController):
            await run(connect)


async def test_a_controller_that_was_reached_is_waited_for_whatever_answers_now() -> None:
    calls = 0
    tried = asyncio.Event()

    class Failing:
        """A controller whose connection is lost at once."""

        name = "grbl at table:23"
        fault = ControllerError("controller.closed", name=name)

        async def close(self) -> None:
            pass

    async def connect(safe: SafeState, stop_motion: bool) -> Any:
        nonlocal calls
        calls += 1
        if calls == 1:
            return Failing()
        if calls == 3:
            tried.set()
        raise NoSuchController("controller.web-server", address="table:80")

    running = asyncio.create_task(run(connect))
    async with asyncio.timeout(120.0):
        await asyncio.wait(
            [running, asyncio.create_task(tried.wait())], return_when=asyncio.FIRST_COMPLETED
        )
    assert tried.is_set()
    assert not running.done()
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)


def test_the_command_ends_with_an_error() -> None:
    command = [sys.executable, "-m", "knifetip.cli", "gateway", "--controller", "foo://table:1"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60.0, check=False)
    assert ended.returncode == 3
    assert "foo://table:1" in ended.stderr
    assert "serial" in ended.stderr
    assert "Traceback" not in ended.stderr
