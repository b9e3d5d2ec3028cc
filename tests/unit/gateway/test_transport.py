"""Addresses of controllers are parsed, and an unreachable controller is reported."""

from __future__ import annotations

import asyncio
import socket
from importlib.metadata import EntryPoint, EntryPoints
from urllib.parse import SplitResult

import pytest
from websockets.asyncio.server import ServerConnection, serve
from websockets.typing import Subprotocol

from knifetip.errors import ControllerError
from knifetip.gateway import transport
from knifetip.gateway.transport import Opener, connect, find_opener
from knifetip.gateway.transports import serial, tcp, telnet, ws
from knifetip.gateway.transports.telnet import TelnetFilter


@pytest.mark.parametrize(
    "address", ["", "table", "table:", ":23", "http://x:1", "a:b", "a:99999", "tcp://[x"]
)
async def test_what_is_no_address_is_refused_with_an_example(address: str) -> None:
    with pytest.raises(ControllerError, match=r"127\.0\.0\.1:2323"):
        await connect(address)


async def test_an_unreachable_controller_is_a_controller_error() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        with pytest.raises(ControllerError, match=f"No controller responds at 127.0.0.1:{port}"):
            await connect(f"127.0.0.1:{port}")


@pytest.mark.parametrize("scheme", ["", "tcp://"])
async def test_bytes_go_there_and_come_back_until_the_other_side_leaves(scheme: str) -> None:
    async def echo(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(await reader.read(100))
        await writer.drain()
        writer.close()
        await writer.wait_closed()

    async with await asyncio.start_server(echo, "127.0.0.1", 0) as server:
        port = server.sockets[0].getsockname()[1]
        transport = await connect(f"{scheme}127.0.0.1:{port}")
        await transport.write(b"?")
        assert await transport.read() == b"?"
        assert await transport.read() == b""
        await transport.close()
        await transport.close()


# -- telnet


def test_options_of_telnet_are_refused_and_removed_wherever_a_chunk_ends() -> None:
    # WILL ECHO, DO SUPPRESS-GO-AHEAD, a subnegotiation, an escaped 255, NOP, CR NUL, WONT ECHO.
    sent = (
        b"\xff\xfb\x01ok\r\n\xff\xfd\x03<Idle\xff\xfa\x18\x01\xff\xff\xff\xf0>\xff\xff"
        b"\xff\xf1\r\0x\0\xff\xfc\x01"
    )
    for end in range(len(sent) + 1):
        read = TelnetFilter()
        pairs = [read.receive(sent[:end]), read.receive(sent[end:])]
        assert b"".join(data for data, _ in pairs) == b"ok\r\n<Idle>\xff\rx\0"
        assert b"".join(reply for _, reply in pairs) == b"\xff\xfe\x01\xff\xfc\x03"


async def test_a_telnet_connection_transfers_the_data_only() -> None:
    replies = asyncio.Queue[bytes]()

    async def controller(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"\xff\xfb\x01")
        replies.put_nowait(await reader.readexactly(3))
        writer.write(b"ok\r\n")
        replies.put_nowait(await reader.readexactly(3))
        writer.close()
        await writer.wait_closed()

    async with await asyncio.start_server(controller, "127.0.0.1", 0) as server:
        port = server.sockets[0].getsockname()[1]
        connection = await connect(f"telnet://127.0.0.1:{port}")
        assert await connection.read() == b"ok\r\n"
        await connection.write(b"?\xff")
        assert await connection.read() == b""
        await connection.close()
    assert replies.get_nowait() == b"\xff\xfe\x01"
    assert replies.get_nowait() == b"?\xff\xff"


# -- WebSocket


@pytest.mark.parametrize("subprotocols", [None, ["arduino"]])
async def test_frames_of_a_websocket_are_a_stream_of_bytes(subprotocols: list[str] | None) -> None:
    async def controller(socket: ServerConnection) -> None:
        await socket.send("text\r\n")
        await socket.send(b"")
        frame = await socket.recv()
        await socket.send(frame)
        await socket.close()

    names = [Subprotocol(name) for name in subprotocols] if subprotocols else None
    async with serve(controller, "127.0.0.1", 0, subprotocols=names) as server:
        port = next(iter(server.sockets)).getsockname()[1]
        connection = await connect(f"ws://127.0.0.1:{port}/")
        assert await connection.read() == b"text\r\n"
        await connection.write(b"\x18?\x90")
        assert await connection.read() == b"\x18?\x90"
        assert await connection.read() == b""
        with pytest.raises(ControllerError, match="connection"):
            await connection.write(b"?")
        await connection.close()


async def test_a_port_without_websocket_is_a_controller_error() -> None:
    async def silent(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.readline()
        writer.close()

    async with await asyncio.start_server(silent, "127.0.0.1", 0) as server:
        port = server.sockets[0].getsockname()[1]
        with pytest.raises(ControllerError, match="No controller responds at ws://"):
            await connect(f"ws://127.0.0.1:{port}/")


@pytest.mark.parametrize("address", ["telnet://", "ws://", "ws:///path", "tcp://host"])
async def test_an_address_without_host_or_port_is_refused(address: str) -> None:
    with pytest.raises(ControllerError, match="no host or no port"):
        await connect(address)


# -- transports of other packages


async def test_an_entry_point_adds_a_scheme(monkeypatch: pytest.MonkeyPatch) -> None:
    added = EntryPoint("loop", "tests.unit.gateway.test_transport:open_loop", transport.GROUP)
    monkeypatch.setattr(transport, "entry_points", EntryPoints([added]).select)
    assert "loop" in transport.schemes()
    opened = await connect("loop://here")
    assert opened.address == "loop://here"
    with pytest.raises(ControllerError) as raised:
        await connect("other://here")
    assert "loop" in raised.value.hint


class Loop:
    """A transport that returns what is written."""

    def __init__(self, address: str) -> None:
        self.address = address

    async def read(self) -> bytes:
        return b""

    async def write(self, data: bytes) -> None: ...

    async def close(self) -> None: ...


async def open_loop(url: SplitResult) -> Loop:
    return Loop(url.geturl())


def test_every_transport_of_this_package_is_an_opener() -> None:
    openers: list[Opener] = [
        serial.open_transport,
        tcp.open_transport,
        telnet.open_transport,
        ws.open_transport,
    ]
    assert [find_opener(scheme) for scheme in ("serial", "tcp", "telnet", "ws")] == openers
