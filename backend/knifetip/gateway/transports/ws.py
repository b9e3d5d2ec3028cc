"""ws: a transport over a WebSocket, ``ws://HOST:PORT/PATH``, as grblHAL and FluidNC offer."""

from __future__ import annotations

from urllib.parse import SplitResult

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidURI, WebSocketException
from websockets.typing import Subprotocol

from knifetip.errors import ControllerError
from knifetip.gateway.transports.tcp import PATIENCE, unreachable

#: Subprotocol with which grblHAL answers in binary frames.
BINARY = Subprotocol("arduino")


class WebSocket:
    """An open WebSocket, whose frames are one stream of bytes."""

    def __init__(self, address: str, socket: ClientConnection) -> None:
        self.address = address
        self._socket = socket

    async def read(self) -> bytes:
        """Wait for a frame and return its bytes; return ``b""`` if the connection is closed."""
        try:
            while True:
                frame = await self._socket.recv()
                if frame:
                    return frame if isinstance(frame, bytes) else frame.encode()
        except ConnectionClosed:
            return b""

    async def write(self, data: bytes) -> None:
        """Send bytes as one binary frame.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        try:
            await self._socket.send(data)
        except ConnectionClosed as error:
            raise ControllerError(
                "controller.connection-failed", address=self.address, reason=error
            ) from error

    async def close(self) -> None:
        """Close the connection."""
        await self._socket.close()


async def open_transport(url: SplitResult) -> WebSocket:
    """Return an open connection to ``ws://HOST:PORT/PATH``; without a port, port 80 is used.

    Raises
    ------
    ControllerError
        The URL has no host, or no WebSocket answers there.
    """
    address = url.geturl()
    try:
        socket = await connect(
            address,
            subprotocols=[BINARY],
            compression=None,
            proxy=None,
            open_timeout=PATIENCE,
            close_timeout=1.0,
            # Status reports show that the connection works.
            ping_interval=None,
        )
    except InvalidURI as error:
        raise ControllerError("controller.no-host-and-port", address=address) from error
    except (OSError, TimeoutError, WebSocketException) as error:
        raise unreachable(address, error) from error
    return WebSocket(address, socket)
