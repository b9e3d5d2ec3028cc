"""A simulated table at the other end of a pseudo-terminal, as a controller on a serial port."""

from __future__ import annotations

import asyncio
import os
import tty
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

from knifetip.simulators.grbl.clock import Clock
from knifetip.simulators.grbl.table import BANNER, Table


@asynccontextmanager
async def serve_on_terminal(table: Table) -> AsyncIterator[str]:
    """Connect a simulated table to a new pseudo-terminal; yield the address of its serial port."""
    master, slave = os.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    loop = asyncio.get_running_loop()
    loop.add_reader(master, lambda: table.receive(os.read(master, 4096)))
    table.answer = lambda line: _write(master, line)
    table.answer(BANNER)
    running = asyncio.create_task(Clock(table).run())
    try:
        yield f"serial://{os.ttyname(slave)}"
    finally:
        loop.remove_reader(master)
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        os.close(master)
        os.close(slave)


def _write(master: int, line: str) -> None:
    # A controller on a serial line does not wait for a reader either.
    with suppress(BlockingIOError):
        os.write(master, line.encode() + b"\r\n")
