"""Addresses of controllers are parsed, and an unreachable controller is reported."""

from __future__ import annotations

import asyncio
import socket

import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.transport import connect


@pytest.mark.parametrize("address", ["", "table", "table:", ":23", "http://x:1", "a:b", "a:99999"])
async def test_what_is_no_address_is_refused_with_an_example(address: str) -> None:
    with pytest.raises(ControllerError, match=r"127\.0\.0\.1:2323"):
        await connect(address)


async def test_nobody_there_is_a_controller_error() -> None:
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
