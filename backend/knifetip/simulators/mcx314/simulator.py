"""simulator: a simulated board with an MCX314 that listens on a TCP port."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.model.machine import Machine
from knifetip.simulators.mcx314.board import Board
from knifetip.simulators.mcx314.board_link import LinkFaults
from knifetip.simulators.simulation_server import SimulationServer

#: Real time between two steps (s).
TICK = 0.002
#: Longest real time of one step, so that a high speed does not block the port (s).
STINT = 0.01
#: Longest real time of one step that counts as silence of the gateway (s).
LAG = 0.1


class BoardServer(SimulationServer):
    """Server of a simulated board on a TCP port, for one client at a time.

    Parameters
    ----------
    board
        The board.
    speed
        Simulated seconds per second of real time.
    """

    def __init__(self, board: Board, speed: float) -> None:
        super().__init__()
        self.board = board
        self._speed = speed

    def hang_up(self) -> None:
        """Break the connection to the client."""
        if self._client is not None:
            self._client.close()

    async def _simulate(self) -> None:
        clock = asyncio.get_running_loop()
        last = clock.time()
        while True:
            await asyncio.sleep(TICK)
            now = clock.time()
            # If the process was busy, so was the gateway in it.
            self.board.watch(min(now - last, LAG))
            self.board.advance(min(now - last, STINT) * self._speed)
            last = now

    async def _answer(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        # A new client takes over: the earlier one may be gone without having closed.
        self.hang_up()
        self._client = writer
        self.board.connect()
        while data := await reader.read(4096):
            writer.write(self.board.receive(data))
            if self.board.hangs_up:
                return
            with suppress(OSError):  # the next read reports the end of the connection
                await writer.drain()


async def serve(
    machine: Machine,
    host: str = "127.0.0.1",
    port: int = 0,
    *,
    speed: float = 1.0,
    faults: LinkFaults | None = None,
    sample: float = 0.0,
    homed: bool = True,
) -> BoardServer:
    """Start a simulated board on a TCP port, and return its server.

    The parameters are those of ``simulators.grbl.simulator.serve``, without ``window``.

    Parameters
    ----------
    homed
        Whether the axes are homed when the board is switched on.
    """
    server = BoardServer(Board(machine, faults=faults, sample=sample, homed=homed), speed)
    await server.start(host, port)
    return server
