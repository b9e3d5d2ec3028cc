"""Jobs on builds of grblHAL with other axes, and on grbl 1.1."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import aclosing, asynccontextmanager
from dataclasses import replace

import pytest

from knifetip.errors import ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import Progress, stream
from knifetip.library import load
from knifetip.simulators.grbl.firmware import Firmware
from knifetip.simulators.grbl.simulator import Server
from knifetip.simulators.grbl.table import Table

MACHINE = load.machine("demo-table")
SAFE = SafeState.from_machine(MACHINE)
PROGRAM = b"""G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G0 Z20.0000
M64 P0
M3 S1
G4 P0.15
G0 X100.0000 Y100.0000 C90.0000 (turn C)
G1 Z-0.3000 F6000.0
G1 Y300.0000 F24000.0
G93
G3 X80.0000 Y320.0000 I-20.0000 J0.0000 C180.0000 F300.0
G94
G0 Z20.0000
M65 P0
M5
M30
"""


@asynccontextmanager
async def table_with(firmware: Firmware) -> AsyncIterator[tuple[Table, str]]:
    server = Server(Table(MACHINE, speed=20.0, firmware=firmware))
    await server.start("127.0.0.1", 0)
    async with server:
        yield server.table, server.address


async def run(address: str, program: bytes, safe: SafeState | None = SAFE) -> list[Progress]:
    controller = await driver.dial(address, safe, silence=1.0, poll=0.02)
    try:
        course = stream(program, controller, limits=Limits.from_machine(MACHINE), interval=0.01)
        async with asyncio.timeout(120.0), aclosing(course) as steps:
            return [progress async for progress in steps]
    finally:
        await controller.close()


@pytest.mark.parametrize("axes", ["XYZC", "XYZA", "XYZABC", "XYZAB"])
async def test_a_program_with_c_runs_on_every_axis_letter(axes: str) -> None:
    async with table_with(Firmware(axes)) as (table, address):
        course = await run(address, PROGRAM)
        assert course[-1].executed == PROGRAM.count(b"\n")
        assert table.position == (80.0, 320.0, 20.0, 180.0)
        assert course[-1].position == table.position
        assert not any(table.outputs.values())


@pytest.mark.parametrize("letter", ["A", "B"])
@pytest.mark.parametrize("axes", ["XYZC", "XYZA", "XYZB", "XYZABC"])
async def test_a_program_with_another_letter_runs_where_it_is_unambiguous(
    axes: str, letter: str
) -> None:
    machine = replace(MACHINE, heading_letter=letter)
    program = PROGRAM.replace(b" C", b" " + letter.encode())
    async with table_with(Firmware(axes.replace("ABC", letter))) as (table, address):
        course = await run(address, program, SafeState.from_machine(machine))
        assert course[-1].executed == PROGRAM.count(b"\n")
        assert table.position == (80.0, 320.0, 20.0, 180.0)


async def test_a_stated_letter_is_not_guessed_among_several() -> None:
    safe = SafeState.from_machine(replace(MACHINE, heading_letter="B"))
    async with table_with(Firmware("XYZAC")) as (table, address):
        with pytest.raises(ControllerRejected, match="no axis that rotates the tool"):
            await run(address, PROGRAM.replace(b" C", b" B"), safe)
        assert table.position[3] == 0.0


async def test_a_cancelled_program_leaves_such_a_machine_safe() -> None:
    async with table_with(Firmware("XYZA")) as (table, address):
        controller = await driver.dial(address, SAFE, silence=1.0, poll=0.02)
        course = stream(PROGRAM, controller, limits=Limits.from_machine(MACHINE), interval=0.005)
        async with asyncio.timeout(120.0), aclosing(course) as steps:
            async for progress in steps:
                if progress.position[2] < 0.0:
                    break
        await controller.close()
        assert (table.state, table.position[2]) == ("Idle", 20.0)
        assert not any(table.outputs.values())


GRBL = Firmware("XYZ", outputs=0, grblhal=False)


async def test_grbl_1_1_is_refused_for_a_machine_with_outputs() -> None:
    async with table_with(GRBL) as (table, address):
        with pytest.raises(ControllerError, match="has 0 digital outputs, but the machine file"):
            await run(address, PROGRAM)
        assert table.position[:2] == (0.0, 0.0)


@pytest.mark.parametrize(
    ("program", "words"),
    [
        (PROGRAM.replace(b"M64 P0\n", b"").replace(b"M65 P0\n", b""), "no axis that rotates"),
        (b"G21 G90\nG0 Z20\nG0 X50\nM64 P0\nM30\n", "no digital output 0"),
    ],
)
async def test_grbl_1_1_refuses_c_and_outputs_before_anything_moves(
    program: bytes, words: str
) -> None:
    async with table_with(GRBL) as (table, address):
        with pytest.raises(ControllerRejected, match=words) as raised:
            await run(address, program, replace(SAFE, outputs=()))
        assert "Nothing has moved" in raised.value.text
        assert table.position[:2] == (0.0, 0.0)
        # The controller has left check mode.
        assert table.state == "Idle"


async def test_grbl_1_1_runs_a_program_without_c_and_outputs() -> None:
    program = b"G21 G90\nG0 Z20\nM4 S1\nG0 X50 Y10\nG1 Z-1 F600\nG1 X90 F6000\nG0 Z20\nM5\nM30\n"
    async with table_with(GRBL) as (table, address):
        course = await run(address, program, replace(SAFE, outputs=()))
        assert course[-1].executed == program.count(b"\n")
        assert table.position == (90.0, 10.0, 20.0, 0.0)
        assert not table.oscillating


async def test_a_controller_that_does_not_state_its_buffer_gets_one_line_at_a_time() -> None:
    async with table_with(Firmware(sizes=False)) as (table, address):
        controller = await driver.dial(address, SAFE, silence=1.0, poll=0.02)
        try:
            course = stream(
                PROGRAM, controller, limits=Limits.from_machine(MACHINE), interval=0.001
            )
            async with asyncio.timeout(120.0), aclosing(course) as steps:
                pending = [controller.sent - controller.acknowledged async for _ in steps]
        finally:
            await controller.close()
        assert max(pending) == 1
        assert controller.acknowledged == PROGRAM.count(b"\n")
        assert table.position == (80.0, 320.0, 20.0, 180.0)
