"""Runs above the board, tool checks and spindles by hand on a complete LinuxCNC."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.contract.station_report import ActivityState
from knifetip.gateway.controller import SafeState
from knifetip.gateway.dry_program import (
    check_dry_program,
    dry_height,
    dry_program,
    frame_program,
    station_starts,
)
from knifetip.gateway.dry_run import DryProgram, DryRun
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.linuxcnc.driver import dial
from knifetip.gateway.operations import perform
from knifetip.gateway.tool_check import CheckedPoint, ToolCheck
from tests.controllers.linuxcnc_machine import Machine, Supply, missing_requirement
from tests.controllers.quick_router import BOARD, TABLE
from tests.controllers.test_linuxcnc_gateway import PROGRAM

SKIP_REASON = missing_requirement()
pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]

SAFE = SafeState.from_machine(TABLE)
HEIGHT = dry_height(TABLE)


@pytest.fixture(scope="module")
def supply() -> Iterator[Supply]:
    with Supply(TABLE) as supply:
        yield supply


@pytest.fixture
def machine(supply: Supply) -> Iterator[Machine]:
    with supply.machine() as machine:
        yield machine


def always() -> bool:
    return True


def never_late() -> bool:
    return False


async def until(run: DryRun, *states: ActivityState) -> None:
    while run.activity.state not in states:
        await asyncio.sleep(0.02)


async def test_a_dry_run_follows_the_program_above_the_board_and_is_held_and_resumed(
    machine: Machine,
) -> None:
    controller = await dial(machine.address, SAFE)
    start = (await controller.status()).position
    dry = dry_program(PROGRAM, TABLE, 1.0)
    check_dry_program(dry, PROGRAM, TABLE, start, tool_offsets(TABLE))
    program = DryProgram(dry, station_starts(PROGRAM, TABLE))
    run = DryRun("dry_run", "job", program, TABLE, always)
    mark = machine.mark()
    running = asyncio.create_task(run.run(controller))
    while run.activity.line < 12:
        await asyncio.sleep(0.01)
    await run.hold()
    await until(run, ActivityState.HELD)
    assert await asyncio.to_thread(machine.comes_to_rest)
    await run.resume()
    await running
    await controller.close()
    assert (run.activity.state, run.activity.message) == (ActivityState.DONE, None)
    seen = machine.samples(mark)[:, :4]
    assert seen[:, 2].min() >= HEIGHT - 1e-4
    # The blank from 100 to 220 with its leads, and the crease wheel 60 mm beside the head.
    assert np.ptp(seen[:, 0]) > 120.0
    assert np.ptp(seen[:, 1]) > 80.0
    assert machine.lowered() == []
    assert not machine.spins()


async def test_a_dry_run_is_stopped_at_rest_and_a_frame_goes_round(machine: Machine) -> None:
    controller = await dial(machine.address, SAFE)
    program = DryProgram(dry_program(PROGRAM, TABLE, 0.2))
    run = DryRun("dry_run", "job", program, TABLE, always)
    running = asyncio.create_task(run.run(controller))
    while run.activity.line < 12:
        await asyncio.sleep(0.01)
    await run.stop()
    await running
    assert run.activity.state is ActivityState.STOPPED
    assert await asyncio.to_thread(machine.comes_to_rest)
    station = TABLE.stations[0]
    box = (100.0, 100.0, 220.0, 180.0)
    frame = DryRun(
        "frame", "job", DryProgram(frame_program(box, station, TABLE, 1.0)), TABLE, always
    )
    mark = machine.mark()
    await frame.run(controller)
    await controller.close()
    assert frame.activity.state is ActivityState.DONE
    seen = machine.samples(mark)[:, :3]
    assert seen[:, 2].min() >= HEIGHT - 1e-4
    assert seen[:, 0].max() == pytest.approx(220.0 + station.x, abs=0.01)
    assert seen[:, 1].max() == pytest.approx(180.0 + station.y, abs=0.01)


async def test_a_tool_is_lowered_above_its_point_and_lifted(machine: Machine) -> None:
    controller = await dial(machine.address, SAFE)
    station = TABLE.stations[0]
    height = BOARD.caliper + TABLE.clearance
    check = Operation(
        OperationName.TOOL_CHECK, station=station.number, point=(150.0, 120.0), height=height
    )
    run = ToolCheck("job", CheckedPoint.from_operation(check, TABLE), TABLE, always)
    await run.run(controller)
    assert (run.activity.state, run.activity.message) == (ActivityState.DONE, None)
    expected = [150.0 + station.x, 120.0 + station.y, height + station.z]
    np.testing.assert_allclose(machine.position()[:3], expected, atol=0.02)
    assert machine.lowered() == [station.output]
    await perform(Operation(OperationName.LIFT), controller, TABLE, never_late)
    assert machine.position()[2] >= TABLE.travel_z - 1e-3
    assert machine.lowered() == []
    await controller.close()


@pytest.mark.parametrize(("word", "sign"), [("M3", 1.0), ("M4", -1.0)])
async def test_a_spindle_turns_in_the_direction_of_its_station(
    machine: Machine, word: str, sign: float
) -> None:
    router = next(one for one in TABLE.stations if one.speed)
    turned = replace(router, spindle=word, spindle_speed=9000.0)
    table = replace(TABLE, stations=(turned,))
    controller = await dial(machine.address, SAFE)
    on = Operation(OperationName.SPINDLE, station=router.number, on=True)
    await perform(on, controller, table, never_late)
    assert machine.spins()
    speed = float(machine.pins("spindle.0.speed-out")["spindle.0.speed-out"])
    assert speed == pytest.approx(sign * 9000.0)
    await controller.stop()
    assert not machine.spins()
    await controller.close()
