"""simulation_server: serves a simulated machine on a TCP port while its simulated time passes."""

from __future__ import annotations

import asyncio
from abc import ABC, abstractmethod
from contextlib import suppress
from typing import Self


class SimulationServer(ABC):
    """Server of a simulated machine on a TCP port.

    A subclass states how simulated time passes (``_simulate``) and how the machine answers a client
    (``_answer``).
    """

    def __init__(self) -> None:
        self.host = ""
        self.port = 0
        self._server: asyncio.Server | None = None
        self._running: asyncio.Task[None] | None = None
        self._client: asyncio.StreamWriter | None = None  # the client that uses the machine
        self._clients: set[asyncio.Task[None]] = set()

    @property
    def address(self) -> str:
        """Address of the server as ``host:port``, for ``transport.connect``."""
        return f"{self.host}:{self.port}"

    async def start(self, host: str, port: int) -> None:
        """Open the TCP port, accept connections, and start the clock of the simulation."""
        self._server = await asyncio.start_server(self._serve, host, port)
        self.host, self.port = self._server.sockets[0].getsockname()[:2]
        self._running = asyncio.create_task(self._simulate(), name="simulated machine")

    async def close(self) -> None:
        """Close the port and the connection, and stop the simulation."""
        tasks = [*self._clients]
        if self._running is not None:
            tasks.append(self._running)
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        task = asyncio.current_task()
        assert task is not None
        self._clients.add(task)
        try:
            await self._answer(reader, writer)
        except (asyncio.CancelledError, OSError):
            pass  # the port closes or the client is gone
        finally:
            if self._client is writer:
                self._client = None
            self._clients.discard(task)
            writer.close()
            # The client may have reset the connection, and ``close`` cancels the task.
            with suppress(OSError, asyncio.CancelledError):
                await writer.wait_closed()

    @abstractmethod
    async def _simulate(self) -> None:
        """Advance the simulated time until cancelled."""

    @abstractmethod
    async def _answer(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Answer a client until either side closes the connection.

        The method sets ``_client`` if the client may use the machine.
        """
