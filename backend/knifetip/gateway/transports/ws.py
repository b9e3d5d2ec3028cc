"""ws: a transport over a WebSocket, ``ws://HOST:PORT/PATH``, as grblHAL and FluidNC offer."""

from __future__ import annotations

from urllib.parse import SplitResult

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidStatus, InvalidURI, WebSocketException
from websockets.typing import Subprotocol

from knifetip.errors import ConnectionLost, NoSuchController
from knifetip.gateway.transports.tcp import PATIENCE, is_host, unreachable

#: Subprotocol with which grblHAL answers in binary frames.
BINARY = Subprotocol("arduino")
#: HTTP statuses with which a controller refuses a WebSocket for a time.
_TEMPORARY = (408, 425, 429, *range(500, 600))


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
            raise ConnectionLost(
                "controller.connection-failed", address=self.address, reason=error
            ) from error

    async def close(self) -> None:
        """Close the connection."""
        await self._socket.close()


async def open_transport(url: SplitResult) -> WebSocket:
    """Return an open connection to ``ws://HOST:PORT/PATH``; without a port, port 80 is used.

    Raises
    ------
    NoSuchController
        The URL has no valid host, or a web server without this WebSocket answers there.
    ControllerError
        There is no answer.
    """
    address = url.geturl()
    if url.hostname and not is_host(url.hostname):
        raise NoSuchController("controller.bad-host", address=address, host=url.hostname)
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
        raise NoSuchController("controller.no-host-and-port", address=address) from error
    except InvalidStatus as error:
        if error.response.status_code in _TEMPORARY:
            raise unreachable(address, error) from error
        raise NoSuchController("controller.web-server", address=address) from error
    except (OSError, TimeoutError, WebSocketException) as error:
        raise unreachable(address, error) from error
    return WebSocket(address, socket)
