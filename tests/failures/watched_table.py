"""A simulated table that records which program lines it executed, and for which drawing."""

from __future__ import annotations

import asyncio
import re
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from knifetip.model.machine import Machine
from knifetip.simulators.grbl.simulator import Server
from knifetip.simulators.grbl.table import BANNER, Table

#: Heads at this height or above touch no board (mm).
LIFTED = 5.0
_DRAWING = re.compile(rb"\(drawing ([0-9a-f]+)\)")
_CUT = re.compile(rb"^(?:N\d+ *)?G0*[123]\b|Z-")


@dataclass
class Run:
    """The lines of one program that a table has accepted, in order, since its last reset."""

    drawing: str = ""  #: beginning of the SHA-256 of the drawing; "" if no line named it
    lines: list[bytes] = field(default_factory=list)

    @property
    def has_cut(self) -> bool:
        """Whether one of the lines moves a tool in the board."""
        return any(_CUT.search(line) for line in self.lines)

    def is_of(self, sha256: str) -> bool:
        """Return whether this is the program for the drawing with a SHA-256."""
        return bool(self.drawing) and sha256.startswith(self.drawing)


class WatchedTable(Table):
    """A simulated table whose accepted lines are recorded at its connection."""

    def __init__(self, machine: Machine, speed: float) -> None:
        self.runs: list[Run] = []
        self._partial = b""
        self._pending: deque[bytes] = deque()
        self._checks = False
        self._client: Callable[[str], None] = lambda _line: None
        super().__init__(machine, speed=speed)

    @property
    def answer(self) -> Callable[[str], None]:
        """Function that is called with each line for the client."""
        return self._answered

    @answer.setter
    def answer(self, client: Callable[[str], None]) -> None:
        self._client = client

    def receive(self, data: bytes) -> None:
        """Record the lines in received bytes, and process them."""
        for byte in data:
            if byte == 0x18:
                self._pending.clear()
                self._partial, self._checks = b"", False
                self.runs.append(Run())
            elif byte == 0x0A:
                if line := self._partial.strip():
                    self._pending.append(line)
                self._partial = b""
            elif byte not in b"?!~" and byte < 0x80:
                self._partial += bytes([byte])
            super().receive(bytes([byte]))

    def _answered(self, answer: str) -> None:
        if (answer == "ok" or answer.startswith("error")) and self._pending:
            line = self._pending.popleft()
            if answer == "ok":
                self._accepted(line)
        elif answer == BANNER:
            self._checks = False
        self._client(answer)

    def _accepted(self, line: bytes) -> None:
        if line == b"$C":
            self._checks = not self._checks
            self.runs.append(Run())
        elif not line.startswith(b"$") and not self._checks:
            if not self.runs or self.runs[-1].lines[-1:] in ([b"M30"], [b"M2"]):
                self.runs.append(Run())
            run = self.runs[-1]
            run.lines.append(line)
            if found := _DRAWING.search(line):
                run.drawing = found[1].decode()


class TableThread(threading.Thread):
    """A watched table that listens on a TCP port, on a thread of its own."""

    def __init__(self, machine: Machine, host: str, speed: float) -> None:
        super().__init__(daemon=True, name="watched table")
        self._host = host
        self.table = WatchedTable(machine, speed)
        self.address = ""
        self._listens = threading.Event()
        self._loop = asyncio.new_event_loop()
        self._end = asyncio.Event()

    def run(self) -> None:
        """Simulate the table until ``close`` is called."""
        self._loop.run_until_complete(self._serve())
        self._loop.close()

    async def _serve(self) -> None:
        async with Server(self.table) as server:
            await server.start(self._host, 0)
            self.address = server.address
            self._listens.set()
            await self._end.wait()

    def open(self) -> None:
        """Start the table and wait until it listens."""
        self.start()
        assert self._listens.wait(20.0)

    def close(self) -> None:
        """End the simulation."""
        self._loop.call_soon_threadsafe(self._end.set)
        self.join(10.0)

    @property
    def is_safe(self) -> bool:
        """Whether all heads are up and all outputs are off."""
        return self.table.position[2] >= LIFTED and not any(self.table.outputs.values())

    def wait_until_safe(self, seconds: float) -> bool:
        """Wait until the table is safe; return whether it is."""
        end = time.monotonic() + seconds
        while not self.is_safe and time.monotonic() < end:
            time.sleep(0.05)
        return self.is_safe
