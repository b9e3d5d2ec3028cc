"""simulator: a simulated cutting table that listens on a TCP port like a grbl controller."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Protocol

from knifetip.gateway.simulation_server import SimulationServer
from knifetip.gateway.table import BANNER, Faults, Table, discard_answer
from knifetip.gateway.table_clock import Clock
from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine


class SimulatedController(Protocol):
    """Interface of a server of a simulated controller."""

    @property
    def address(self) -> str:
        """Address of the server as ``host:port``, for ``transport.connect``."""
        ...


class Server(SimulationServer):
    """Server of a simulated table on a TCP port, for one client at a time."""

    def __init__(self, table: Table) -> None:
        super().__init__()
        self.table = table

    async def _simulate(self) -> None:
        await Clock(self.table).run()

    async def _answer(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if self._client is not None:
            writer.write(b"[MSG:another sender is connected]\r\n")
            return
        self._client = writer
        self.table.answer = lambda line: writer.write(line.encode() + b"\r\n")
        self.table.hang_up = lambda: self._hang_up(writer)
        try:
            self.table.answer(BANNER)
            while data := await reader.read(4096):
                self.table.receive(data)
                with suppress(OSError):
                    await writer.drain()
        finally:
            self.table.answer = discard_answer  # the machine executes its buffer

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
