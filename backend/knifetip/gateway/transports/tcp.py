"""tcp: a transport over a TCP connection, ``tcp://HOST:PORT``."""

from __future__ import annotations

import asyncio
import re
import socket
from contextlib import suppress
from ipaddress import ip_address
from urllib.parse import SplitResult

from knifetip.errors import ConnectionLost, ControllerError, NoSuchController

#: Most bytes that one ``read`` returns.
CHUNK = 4096
#: Bytes that the operating system holds until the controller accepts them.
SEND_BUFFER = 1 << 14
#: Longest time until a connection is open (s).
PATIENCE = 5.0
#: A part of the name of a host; letters of other alphabets are permitted.
_LABEL = re.compile(r"(?!-)[\w-]{1,63}(?<!-)")
_LONGEST_NAME = 253


class Tcp:
    """An open TCP connection."""

    def __init__(
        self, address: str, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self.address = address
        self._reader = reader
        self._writer = writer

    async def read(self) -> bytes:
        """Wait for bytes and return them; return ``b""`` if the connection is closed."""
        try:
            return await self._reader.read(CHUNK)
        except OSError:
            return b""

    async def write(self, data: bytes) -> None:
        """Send bytes; return when the operating system has accepted them.

        If the call is cancelled, the bytes are still sent.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        try:
            self._writer.write(data)
            await self._writer.drain()
        except OSError as error:
            raise ConnectionLost(
                "controller.connection-failed", address=self.address, reason=error
            ) from error

    async def close(self) -> None:
        """Close the connection; bytes that the operating system has not accepted are dropped."""
        if self._writer.transport.get_write_buffer_size():
            self._writer.transport.abort()
        self._writer.close()
        with suppress(OSError):
            await self._writer.wait_closed()


def host_and_port(url: SplitResult, default: int = 0) -> tuple[str, int]:
    """Return host and port of a URL.

    Parameters
    ----------
    url
        The address of a controller.
    default
        Port of a URL without port; 0 if the URL must contain one.

    Raises
    ------
    NoSuchController
        The URL has no valid host or no port.
    """
    try:
        host, port = url.hostname, url.port or default
    except ValueError:
        host, port = None, 0
    if not host or not port:
        raise NoSuchController("controller.no-host-and-port", address=url.geturl())
    if not is_host(host):
        raise NoSuchController("controller.bad-host", address=url.geturl(), host=host)
    return host, port


def is_host(text: str) -> bool:
    """Return whether a text can be an IP address or the name of a host, which may be unknown."""
    with suppress(ValueError):
        ip_address(text)
        return True
    labels = text.removesuffix(".").split(".")
    # A name does not end with a number, so that 192.168.1.300 is a wrong IP address.
    return (
        len(text) <= _LONGEST_NAME
        and all(_LABEL.fullmatch(label) for label in labels)
        and not labels[-1].isdecimal()
    )


async def connect_socket(host: str, port: int) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    """Return reader and writer of a new TCP connection.

    Raises
    ------
    ControllerError
        There is no answer within ``PATIENCE`` seconds.
    """
    try:
        async with asyncio.timeout(PATIENCE):
            return await asyncio.open_connection(host, port)
    except (OSError, TimeoutError, UnicodeError) as error:  # UnicodeError: of a name
        raise unreachable(f"{host}:{port}", error) from error


def unreachable(address: str, error: Exception) -> ControllerError:
    """Return the error for a controller to which no connection can be opened."""
    return ConnectionLost("controller.unreachable", address=address, reason=error or "timed out")


async def open_transport(url: SplitResult) -> Tcp:
    """Return an open connection to ``tcp://HOST:PORT``.

    Raises
    ------
    NoSuchController
        The URL has no valid host or no port.
    ControllerError
        There is no answer.
    """
    host, port = host_and_port(url)
    reader, writer = await connect_socket(host, port)
    # A write waits for the operating system, which holds little: a device that accepts no bytes
    # must be noticed.
    writer.transport.set_write_buffer_limits(0)
    writer.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER)
    return Tcp(f"{host}:{port}", reader, writer)
