"""telnet: a transport over a telnet connection, ``telnet://HOST`` or ``telnet://HOST:PORT``.

Every option that the controller offers or requests is refused, and the commands of the protocol are
removed from the received bytes (RFC 854, RFC 855).
"""

from __future__ import annotations

import asyncio
from urllib.parse import SplitResult

from knifetip.gateway.transports.tcp import Tcp, connect_socket, host_and_port

#: Port of telnet.
PORT = 23

_IAC, _DONT, _DO, _WONT, _WILL, _SB, _SE = 255, 254, 253, 252, 251, 250, 240
_REFUSALS = {_WILL: _DONT, _DO: _WONT}


class TelnetFilter:
    """Separates the data of a telnet connection from its commands.

    A command may be divided among several received chunks.
    """

    def __init__(self) -> None:
        self._command = b""  # incomplete command: IAC, and the byte after it
        self._subnegotiation = False
        self._return = False  # the last byte of data was a carriage return

    def receive(self, chunk: bytes) -> tuple[bytes, bytes]:
        """Return the data in a received chunk, and the bytes to send in reply to its commands."""
        data, reply = bytearray(), bytearray()
        for byte in chunk:
            if self._command:
                reply += self._continue_command(byte, data)
            elif byte == _IAC:
                self._command = bytes([byte])
            elif not self._subnegotiation:
                # A carriage return without line feed is sent as CR NUL.
                if byte or not self._return:
                    data.append(byte)
                self._return = byte == 0x0D
        return bytes(data), bytes(reply)

    def _continue_command(self, byte: int, data: bytearray) -> bytes:
        """Process a byte of a command; return the reply to a complete command."""
        command, self._command = self._command, b""
        if len(command) == 2:
            refusal = _REFUSALS.get(command[1])
            return bytes([_IAC, refusal, byte]) if refusal else b""
        if byte == _IAC:
            if not self._subnegotiation:
                data.append(byte)
        elif byte in (_SB, _SE):
            self._subnegotiation = byte == _SB
        elif byte in (_WILL, _WONT, _DO, _DONT):
            self._command = bytes([_IAC, byte])
        return b""


class Telnet(Tcp):
    """An open telnet connection, which transfers only the data."""

    def __init__(
        self, address: str, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        super().__init__(address, reader, writer)
        self._filter = TelnetFilter()

    async def read(self) -> bytes:
        """Wait for data and return them; return ``b""`` if the connection is closed."""
        while chunk := await super().read():
            data, reply = self._filter.receive(chunk)
            if reply:
                await super().write(reply)
            if data:
                return data
        return b""

    async def write(self, data: bytes) -> None:
        """Send data; return when the operating system has accepted them.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        await super().write(data.replace(b"\xff", b"\xff\xff"))


async def open_transport(url: SplitResult) -> Telnet:
    """Return an open connection to ``telnet://HOST:PORT``; without a port, port 23 is used.

    Raises
    ------
    NoSuchController
        The URL has no valid host.
    ControllerError
        There is no answer.
    """
    host, port = host_and_port(url, PORT)
    return Telnet(f"telnet://{host}:{port}", *await connect_socket(host, port))
