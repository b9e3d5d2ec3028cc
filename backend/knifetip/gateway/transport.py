"""transport: byte connections to controllers.

An address is ``tcp://192.168.1.20:23`` or ``192.168.1.20:23``.  A transport does not interpret the
bytes.  Other kinds of connection can be added as classes with the members of ``Transport``; the
function ``connect`` selects the class by the scheme of the address, such as ``tcp``.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress
from typing import Protocol
from urllib.parse import urlsplit

from knifetip.errors import ControllerError

#: Most bytes that one ``read`` returns.
CHUNK = 4096


class Transport(Protocol):
    """An open connection to a controller."""

    @property
    def address(self) -> str:
        """Address of the controller, as the operator entered it."""
        ...

    async def read(self) -> bytes:
        """Wait for bytes and return them; return ``b""`` if the connection is closed."""
        ...

    async def write(self, data: bytes) -> None:
        """Send bytes; return when the operating system has accepted them."""
        ...

    async def close(self) -> None:
        """Close the connection; has no effect if it is closed already."""
        ...


class Tcp:
    """A transport over a TCP connection."""

    def __init__(
        self, address: str, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self.address = address
        self._reader = reader
        self._writer = writer

    @classmethod
    async def open(cls, host: str, port: int, *, timeout: float = 5.0) -> Tcp:
        """Return an open TCP connection to a host and port.

        Raises
        ------
        ControllerError
            There is no answer within ``timeout`` seconds.
        """
        address = f"{host}:{port}"
        try:
            async with asyncio.timeout(timeout):
                reader, writer = await asyncio.open_connection(host, port)
        except (OSError, TimeoutError) as error:
            raise ControllerError(
                "controller.unreachable", address=address, reason=error or "timed out"
            ) from error
        return cls(address, reader, writer)

    async def read(self) -> bytes:
        """Wait for bytes and return them; return ``b""`` if the connection is closed."""
        try:
            return await self._reader.read(CHUNK)
        except OSError:
            return b""

    async def write(self, data: bytes) -> None:
        """Send bytes; return when the operating system has accepted them.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        try:
            self._writer.write(data)
            await self._writer.drain()
        except OSError as error:
            raise ControllerError(
                "controller.connection-failed", address=self.address, reason=error
            ) from error

    async def close(self) -> None:
        """Close the connection."""
        self._writer.close()
        with suppress(OSError):
            await self._writer.wait_closed()


async def connect(address: str) -> Transport:
    """Return an open connection to the controller at an address.

    Raises
    ------
    ControllerError
        The address is invalid, or there is no answer.
    """
    parts = urlsplit(address if "//" in address else f"//{address}", scheme="tcp")
    try:
        host, port = parts.hostname, parts.port
    except ValueError:
        host = port = None
    if parts.scheme != "tcp" or not host or not port:
        raise ControllerError("controller.bad-address", address=address)
    return await Tcp.open(host, port)
