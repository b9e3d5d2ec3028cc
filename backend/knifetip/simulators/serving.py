"""Serve the simulated controller of a machine's language until it is interrupted."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Protocol

from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine


class SimulatedController(Protocol):
    """Interface of a server of a simulated controller."""

    @property
    def address(self) -> str:
        """Address of the server as ``host:port``, for ``transport.connect``."""
        ...


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
