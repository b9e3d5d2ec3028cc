"""A job over a serial port: a simulated table behind a pseudo-terminal."""

from __future__ import annotations

import asyncio
import errno
import os
from collections.abc import AsyncIterator
from contextlib import aclosing, asynccontextmanager
from pathlib import Path

import pytest
import serial

from knifetip.errors import ControllerError
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.grbl import driver
from knifetip.gateway.grbl.driver import Grbl
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import stream
from knifetip.gateway.transport import connect
from knifetip.library import load
from knifetip.simulators.grbl.table import Table
from tests.support.pty_table import serve_on_terminal

pytestmark = pytest.mark.skipif(os.name != "posix", reason="Windows has no pseudo-terminals")

MACHINE = load.machine("demo-table")
PROGRAM = (
    "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20.0000\nM64 P0\nM3 S1\nG4 P0.15\n"
    + "".join(
        f"G0 X100.0000 Y{100 + 10 * row}.0000 C0.0000\nG1 Z-0.3000 F6000.0\n"
        f"G1 X400.0000 F24000.0\nG0 Z20.0000\n"
        for row in range(12)
    )
    + "M65 P0\nM5\nM30\n"
).encode()
LINES = PROGRAM.count(b"\n")


@asynccontextmanager
async def connected(speed: float = 20.0) -> AsyncIterator[tuple[Table, Grbl]]:
    table = Table(MACHINE, speed=speed)
    async with serve_on_terminal(table) as address:
        controller = await driver.dial(
            address, SafeState.from_machine(MACHINE), silence=1.0, poll=0.02
        )
        try:
            yield table, controller
        finally:
            await controller.close()


def assert_safe(table: Table) -> None:
    assert table.state == "Idle"
    assert table.position[2] == 20.0
    assert not any(table.outputs.values())
    assert not table.oscillating
    assert table.lost == 0


async def test_a_job_is_held_resumed_and_runs_to_its_end() -> None:
    async with connected() as (table, controller):
        held = False
        course = stream(PROGRAM, controller, limits=Limits.from_machine(MACHINE), interval=0.01)
        async with asyncio.timeout(120.0), aclosing(course) as steps:
            async for progress in steps:
                if progress.executed > LINES // 2 and not held:
                    held = True
                    await controller.hold()
                    while not (await controller.status()).still:
                        await asyncio.sleep(0.01)
                    where = table.position
                    await asyncio.sleep(0.1)
                    assert table.position == where
                    assert (await controller.status()).state is State.HOLD
                    await controller.resume()
        assert held
        assert progress.executed == LINES
        assert_safe(table)


async def test_a_cancelled_job_leaves_the_machine_safe() -> None:
    async with connected(speed=2.0) as (table, controller):
        course = stream(PROGRAM, controller, limits=Limits.from_machine(MACHINE), interval=0.01)
        async with asyncio.timeout(120.0), aclosing(course) as steps:
            async for progress in steps:
                if progress.output == 0 and progress.position[2] < 0.0:
                    break
        assert_safe(table)


async def test_an_open_port_is_locked_and_free_again_afterwards() -> None:
    table = Table(MACHINE)
    async with serve_on_terminal(table) as address:
        first = await connect(address)
        with pytest.raises(ControllerError, match="Another program uses the serial port /dev/"):
            await connect(address)
        await first.close()
        second = await connect(f"{address}?baud=250000")
        await second.write(b"?")
        assert (await second.read()).startswith(b"<Idle")
        await second.close()
        await second.close()
        assert await second.read() == b""
        with pytest.raises(ControllerError, match="connection"):
            await second.write(b"?")


async def test_an_unplugged_port_ends_the_connection() -> None:
    async with serve_on_terminal(Table(MACHINE)) as address:
        port = await connect(address)
    while await asyncio.wait_for(port.read(), 5.0):
        pass
    await port.close()


async def test_a_missing_port_is_reported() -> None:
    with pytest.raises(ControllerError, match="no serial port /dev/ttyNONE") as raised:
        await connect("serial:///dev/ttyNONE")
    assert "Plug in" in raised.value.hint


@pytest.mark.parametrize("code", [errno.EACCES, errno.EPERM])
async def test_a_port_without_permission_names_the_group(
    monkeypatch: pytest.MonkeyPatch, code: int
) -> None:
    def refuse(port: serial.Serial) -> None:
        raise serial.SerialException(code, f"could not open port {port.port}")

    monkeypatch.setattr(serial.Serial, "open", refuse)
    with pytest.raises(ControllerError, match="may not open the serial port /dev/ttyS7") as raised:
        await connect("serial:///dev/ttyS7")
    assert "dialout" in raised.value.hint


async def test_a_file_that_is_no_port_is_reported(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(ControllerError, match="cannot be opened"):
        await connect(f"serial://{tmp_path / 'file'}")


@pytest.mark.parametrize(
    "address", ["serial://", "serial:///dev/ttyUSB0?baud=fast", "serial://COM3?parity=odd"]
)
async def test_what_is_no_serial_address_is_refused(address: str) -> None:
    with pytest.raises(ControllerError, match="not the address of a serial port") as raised:
        await connect(address)
    assert "serial:///dev/ttyUSB0" in raised.value.hint
