"""simulator: a simulated cutting table that listens on a TCP port like a grbl controller."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.model.machine import Machine
from knifetip.simulators.grbl.clock import Clock
from knifetip.simulators.grbl.table import BANNER, Faults, Table, discard_answer
from knifetip.simulators.simulation_server import SimulationServer


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
