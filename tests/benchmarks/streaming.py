"""Share of a controller's own line rate that the gateway reaches, beside a bare sender.

    python -m tests.benchmarks.streaming

The controller is a simulated table in a process of its own.  Its own rate is that of the same
program without a connection: the table then always has the next line.  Writes
backend/docs/streaming.md.
"""

from __future__ import annotations

import asyncio
import math
import multiprocessing
import os
import socket
import time
from contextlib import aclosing
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

from knifetip.gateway.grbl import driver
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import stream
from knifetip.library import load
from knifetip.simulators.grbl.firmware import Firmware
from knifetip.simulators.grbl.simulator import Server
from knifetip.simulators.grbl.table import Table

MACHINE = load.machine("demo-table")
PAGE = Path(__file__).parents[2] / "backend" / "docs" / "streaming.md"
#: Chords of a circle; each takes about a millisecond.
LINES = 3000
RADIUS = 100.0


@dataclass(frozen=True, slots=True)
class Case:
    """A controller: size of its receive buffer, whether it states the size, and its speed."""

    window: int
    states_size: bool
    speed: float

    @property
    def mode(self) -> str:
        """The way in which lines are sent to this controller."""
        return "character counting" if self.states_size else "send-response"

    def table(self) -> Table:
        """Return a simulated table for this case."""
        firmware = Firmware(sizes=self.states_size)
        return Table(MACHINE, speed=self.speed, window=self.window, firmware=firmware)


CASES = [
    Case(window, states_size, speed)
    for speed in (1.0, 1000.0)
    for window, states_size in ((128, True), (1024, True), (1024, False))
]


def program() -> bytes:
    """Return chords of a circle that the table cuts at a thousand lines per second."""
    rows = ["G21 G90 G94 G54", "G0 Z20", f"G0 X{200 + RADIUS:.4f} Y300.0000", "G1 Z5 F6000"]
    for row in range(1, LINES + 1):
        angle = math.tau * row / LINES
        x, y = 200 + RADIUS * math.cos(angle), 300 + RADIUS * math.sin(angle)
        rows.append(f"G1 X{x:.4f} Y{y:.4f} F12600")
    # The next sender starts at the same position.
    return "\n".join([*rows, "G0 Z20", "G0 X0 Y0", "M30", ""]).encode()


def own_seconds(case: Case, text: bytes) -> float:
    """Return the seconds that the table needs for a program if it always has the next line."""
    table = case.table()
    answers: list[str] = []
    table.answer = answers.append
    for sent, line in enumerate(text.splitlines(keepends=True)):
        while sent - len(answers) > 2:
            table.elapse(1e-3)
        table.receive(line)
    while table.busy:
        table.elapse(0.1)
    assert answers == ["ok"] * text.count(b"\n")
    return table.time / case.speed


def _serve(case: Case, pipe: Connection) -> None:
    async def serving() -> None:
        server = Server(case.table())
        await server.start("127.0.0.1", 0)
        async with server:
            pipe.send(server.port)
            await asyncio.Event().wait()

    asyncio.run(serving())


def bare_seconds(port: int, case: Case, text: bytes) -> float:
    """Return the seconds of a sender that only counts characters, or waits for each answer."""
    with socket.create_connection(("127.0.0.1", port)) as link:
        link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        time.sleep(0.2)
        link.recv(4096)
        start, rest, pending, used = time.perf_counter(), b"", list[int](), 0
        for line in [*text.splitlines(keepends=True), b"G4 P0\n"]:
            limit = case.window - 1 if case.states_size else len(line)
            while pending and used + len(line) > limit:
                *lines, rest = (rest + link.recv(4096)).split(b"\r\n")
                for _ in range(lines.count(b"ok")):
                    used -= pending.pop(0)
            link.sendall(line)
            pending.append(len(line))
            used += len(line)
        while pending:
            *lines, rest = (rest + link.recv(4096)).split(b"\r\n")
            del pending[: lines.count(b"ok")]
        return time.perf_counter() - start


async def gateway_seconds(port: int, text: bytes) -> tuple[float, float]:
    """Return elapsed and processor seconds in which the gateway streams a program.

    The check before the program is left out.
    """
    controller = await driver.dial(f"127.0.0.1:{port}")
    start, worked = time.perf_counter(), time.process_time()
    course = stream(text, controller, limits=Limits.from_machine(MACHINE), check=False)
    async with aclosing(course) as steps:
        last = [progress async for progress in steps][-1]
    seconds, worked = time.perf_counter() - start, time.process_time() - worked
    assert last.executed == text.count(b"\n")
    await controller.close()
    return seconds, worked


def measure(case: Case, text: bytes) -> str:
    """Return the row of the table for one controller."""
    lines = text.count(b"\n")
    here, there = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=_serve, args=(case, there))
    process.start()
    try:
        port = here.recv()
        gateway, worked = asyncio.run(gateway_seconds(port, text))
        bare = bare_seconds(port, case, text)
    finally:
        process.terminate()
        process.join()
    own_rate, share = "", ""
    if case.speed == 1.0:
        own = own_seconds(case, text)
        own_rate, share = f"{lines / own:,.0f}", f"{own / gateway:.0%}"
    return (
        f"| {case.speed:g} | {case.window} | {case.mode} | {own_rate} | {lines / bare:,.0f} | "
        f"{lines / gateway:,.0f} | {share} | {bare / gateway:.0%} | {1e6 * worked / lines:.0f} |"
    )


HEADER = f"""# How fast the gateway streams

`python -m tests.benchmarks.streaming` writes this page.  The controller is the simulated table, in
a process of its own, which executes {LINES:,} chords of a circle.  *Own rate* is the rate at which
the table executes them if it always has the next line.  The bare sender parses and checks nothing.

At speed 1 the table moves as a real one.  At speed 1,000 only the senders and the simulation take
time; that is faster than any connection: a serial line with 115,200 bits per second carries about
400 such lines per second.  The last column is the processor time of the gateway per line (µs); the
load changes it less than the rates.

| speed | buffer | mode | own rate (lines/s) | bare | gateway | of own | of bare | µs |
|---|---|---|---|---|---|---|---|---|
"""


def main() -> None:
    """Measure all cases and write the page."""
    text = program()
    rows = [measure(case, text) for case in CASES]
    computer = f"One run on {os.cpu_count()} shared cores with a load of {os.getloadavg()[0]:.1f}."
    PAGE.write_text(HEADER + "\n".join(rows) + f"\n\n{computer}\n")
    print(PAGE.read_text())


if __name__ == "__main__":
    main()
