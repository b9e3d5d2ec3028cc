"""simulator: a simulated cutting table that listens on a TCP port like a grbl controller."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Protocol

from knifetip.gateway.table import BANNER, Faults, Table, discard_answer
from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine


class SimulatedController(Protocol):
    """Interface of a server of a simulated controller."""

    @property
    def address(self) -> str:
        """Address of the server as ``host:port``, for ``transport.connect``."""
        ...


class Server:
    """Server of a simulated table on a TCP port, for one client at a time."""

    def __init__(self, table: Table) -> None:
        self.table = table
        self.host = ""
        self.port = 0
        self._server: asyncio.Server | None = None
        self._running: asyncio.Task[None] | None = None
        self._writer: asyncio.StreamWriter | None = None
        self._clients: set[asyncio.Task[None]] = set()

    @property
    def address(self) -> str:
        """Address of the server as ``host:port``, for ``transport.connect``."""
        return f"{self.host}:{self.port}"

    async def start(self, host: str, port: int) -> None:
        """Open the TCP port, accept connections, and start the clock of the simulation."""
        self._server = await asyncio.start_server(self._serve_client, host, port)
        self.host, self.port = self._server.sockets[0].getsockname()[:2]
        self._running = asyncio.create_task(self.table.run(), name="simulated table")

    async def close(self) -> None:
        """Close the port and the connection, and stop the simulated table at its position."""
        tasks = [*self._clients]
        if self._running is not None:
            tasks.append(self._running)
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    async def __aenter__(self) -> Server:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def _serve_client(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        task = asyncio.current_task()
        assert task is not None
        self._clients.add(task)
        try:
            if self._writer is not None:
                writer.write(b"[MSG:another sender is connected]\r\n")
                return
            self._writer = writer
            self.table.answer = lambda line: writer.write(line.encode() + b"\r\n")
            self.table.hang_up = lambda: self._hang_up(writer)
            self.table.answer(BANNER)
            while data := await reader.read(4096):
                self.table.receive(data)
                with suppress(OSError):
                    await writer.drain()
        except (asyncio.CancelledError, OSError):
            pass  # the port closes or the client is gone: the machine executes its buffer
        finally:
            if self._writer is writer:
                self._writer = None
                self.table.answer = discard_answer
            self._clients.discard(task)
            writer.close()
            with suppress(OSError, asyncio.CancelledError):
                await writer.wait_closed()

    def _hang_up(self, writer: asyncio.StreamWriter) -> None:
        self.table.answer = discard_answer
        writer.close()


async def serve(
    machine: Machine,
    host: str = "127.0.0.1",
    port: int = 0,
    *,
    speed: float = 1.0,
    faults: Faults | None = None,
    window: int = 128,
    sample: float = 0.0,
) -> Server:
    """Start a simulated table on a TCP port, and return its server.

    Parameters
    ----------
    machine
        Machine that is simulated.
    host
        Address on which the server listens.
    port
        TCP port on which the server listens; 0 for any free port.
    speed
        Simulated seconds per second of real time.
    faults
        Faults to inject; None for none.
    window
        Size of the receive buffer (bytes).
    sample
        Simulated seconds between two records of the position of the axes (``Table.trace``); 0 to
        record no positions.
    """
    server = Server(Table(machine, speed=speed, faults=faults, window=window, sample=sample))
    await server.start(host, port)
    return server


def run(
    machine: Machine,
    host: str = "127.0.0.1",
    port: int = 2323,
    *,
    speed: float = 1.0,
    on_ready: Callable[[SimulatedController], None] | None = None,
) -> None:
    """Serve the simulated controller of a machine's language on a TCP port until interrupted.

    Parameters
    ----------
    machine
        Machine that is simulated.
    host
        Address on which the server listens.
    port
        TCP port on which the server listens; 0 for any free port.
    speed
        Simulated seconds per second of real time.
    on_ready
        Function that is called with the server when its port is open; None for no call.
    """

    async def serving() -> None:
        serve_language = find_language(machine.dialect).load_part("simulator")
        async with await serve_language(machine, host, port, speed=speed) as server:
            if on_ready is not None:
                on_ready(server)
            await asyncio.Event().wait()

    with suppress(KeyboardInterrupt):
        asyncio.run(serving())
