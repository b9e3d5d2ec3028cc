"""Operations of a person at the machine, on the simulated table."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected, OperationExpired
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.grbl import driver
from knifetip.gateway.linuxcnc.driver import Linuxcnc
from knifetip.gateway.operations import Operable, jog_piece, perform
from knifetip.library import load
from knifetip.messages import hint
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import Table
from tests.unit.gateway.test_grbl import Wire, opened

MACHINE = load.machine("demo-table")
SAFE = SafeState.from_machine(MACHINE)


def on_time() -> bool:
    return False


@asynccontextmanager
async def machine(speed: float = 50.0) -> AsyncIterator[tuple[Table, driver.Grbl]]:
    async with await simulator.serve(MACHINE, speed=speed) as server, asyncio.timeout(120.0):
        controller = await driver.dial(server.address, SAFE, silence=0.5, poll=0.02)
        try:
            yield server.table, controller
        finally:
            await controller.close()


async def ask(controller: driver.Grbl, name: OperationName, **arguments: Any) -> None:
    operation = Operation(name, **arguments)
    await perform(operation, controller, MACHINE, on_time)


async def until_idle(controller: driver.Grbl) -> None:
    while (await controller.status()).state is not State.IDLE:
        await asyncio.sleep(0.01)


async def lock(table: Table, controller: driver.Grbl) -> None:
    """Trip a limit switch, and wait until the controller has reported the alarm."""
    table.trip_limit()
    while controller.fault is None:
        await asyncio.sleep(0.01)


@pytest.mark.parametrize("kind", [driver.Grbl, Linuxcnc])
def test_the_controllers_have_all_members_of_the_interface(kind: type) -> None:
    """The gateway asks with isinstance; a missing member would disable the whole station."""
    members = {name for name in dir(Operable) if not name.startswith("_")}
    assert members >= {"connected", "alarm", "last_status", "switched_on", "operations", "unlock"}
    assert members <= set(dir(kind))


async def test_a_jog_moves_one_axis_by_its_distance() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="X", distance=120.5, feed=30000.0)
        await until_idle(controller)
        await ask(controller, OperationName.JOG, axis="C", distance=-90.0, feed=30000.0)
        await until_idle(controller)
        assert table.position == pytest.approx((120.5, 0.0, 20.0, -90.0))


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"axis": "X", "distance": 1700.1, "feed": 600.0}, "operation.beyond-travel"),
        ({"axis": "X", "distance": -100.1, "feed": 600.0}, "operation.beyond-travel"),
        ({"axis": "X", "distance": 1.0, "feed": 0.0}, "operation.bad-feed"),
        ({"axis": "X", "distance": 1.0, "feed": 90_001.0}, "operation.bad-feed"),
        ({"axis": "A", "distance": 1.0, "feed": 600.0}, "operation.unknown-axis"),
        ({"axis": "", "distance": 1.0, "feed": 600.0}, "operation.unknown-axis"),
    ],
)
async def test_a_jog_beyond_the_travel_or_too_fast_is_refused(
    arguments: dict[str, object], code: str
) -> None:
    async with machine() as (table, controller):
        with pytest.raises(ControllerError) as refused:
            await ask(controller, OperationName.JOG, **arguments)
        assert refused.value.message.code == code
        assert table.position == (0.0, 0.0, 20.0, 0.0)
        assert not table.busy


async def test_only_z_jogs_while_the_tool_is_down() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="Z", distance=-18.0, feed=6000.0)
        await until_idle(controller)
        for name, arguments in (
            (OperationName.JOG, {"axis": "Y", "distance": 5.0, "feed": 600.0}),
            (OperationName.JOG, {"axis": "C", "distance": 5.0, "feed": 600.0}),
            (OperationName.SWITCH, {"output": 0, "on": True}),
        ):
            with pytest.raises(ControllerError) as refused:
                await ask(controller, name, **arguments)
            assert refused.value.message.code == "operation.not-lifted"
        assert table.position == pytest.approx((0.0, 0.0, 2.0, 0.0))
        await ask(controller, OperationName.JOG, axis="Z", distance=18.0, feed=6000.0)
        await until_idle(controller)
        assert table.position[2] == pytest.approx(20.0)


async def test_a_running_jog_can_be_stopped_and_permits_nothing_else() -> None:
    async with machine(speed=1.0) as (table, controller):
        await ask(controller, OperationName.JOG, axis="X", distance=1000.0, feed=6000.0)
        for name in (OperationName.PARK, OperationName.ZERO, OperationName.JOG):
            with pytest.raises(ControllerError) as refused:
                await ask(controller, name, axis="X", axes="X", distance=1.0, feed=600.0)
            assert refused.value.message.code == "operation.not-at-rest"
        await ask(controller, OperationName.STOP_JOG)
        await until_idle(controller)
        assert 0.0 < table.position[0] < 500.0


async def test_zero_moves_the_work_zero_and_the_limits_with_it() -> None:
    async with machine() as (table, controller):
        await controller.jog("X", 300.0, 30000.0)
        await until_idle(controller)
        await ask(controller, OperationName.ZERO, axes="XY")
        assert (await controller.status()).position == pytest.approx((0.0, 0.0, 20.0, 0.0))
        # The controller itself refuses what is beyond its travel, which is 1700 - 300 now.
        with pytest.raises(ControllerRejected):
            await controller.jog("X", 1450.0, 6000.0)
        assert table.position == pytest.approx((0.0, 0.0, 20.0, 0.0))


async def test_park_lifts_first_and_switches_the_outputs_off() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="X", distance=200.0, feed=30000.0)
        await until_idle(controller)
        await ask(controller, OperationName.SWITCH, output=1, on=True)
        assert table.switch_events[-1].on
        assert sorted(controller.switched_on) == [1]
        await ask(controller, OperationName.JOG, axis="Z", distance=-15.0, feed=6000.0)
        await until_idle(controller)
        await ask(controller, OperationName.PARK)
        assert not table.outputs[1]
        assert sorted(controller.switched_on) == []
        await until_idle(controller)
        assert table.position == pytest.approx((0.0, 0.0, 20.0, 0.0))


async def test_an_output_that_the_machine_does_not_have_is_refused() -> None:
    async with machine() as (table, controller):
        with pytest.raises(ControllerError) as refused:
            await ask(controller, OperationName.SWITCH, output=7, on=True)
        assert refused.value.message.code == "operation.unknown-output"
        assert 7 not in table.outputs


#: They are refused at rest.
_OF_OBSTACLES = {OperationName.UNLOCK, OperationName.RELEASE}


@pytest.mark.parametrize("name", sorted({*OperationName} - _OF_OBSTACLES))
async def test_a_late_operation_is_dropped(name: OperationName) -> None:
    async with machine() as (table, controller):
        late = Operation(name, "X", 10.0, 600.0, "X", 0, True)
        with pytest.raises(OperationExpired):
            await perform(late, controller, MACHINE, lambda: True)
        assert not table.busy
        assert table.position == (0.0, 0.0, 20.0, 0.0)
        assert not table.outputs[0]


async def test_unlock_after_a_limit_switch_moves_nothing() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="Z", distance=-15.0, feed=6000.0)
        await until_idle(controller)
        table.outputs[1] = True
        await lock(table, controller)
        alarm = controller.alarm
        assert alarm is not None
        assert alarm.code == "controller.in-alarm"
        assert "limit switch" in str(alarm)
        assert "Home the machine" in hint(alarm)
        with pytest.raises(ControllerAlarm):
            await controller.status()
        await ask(controller, OperationName.UNLOCK)
        assert (await controller.status()).state is State.IDLE
        assert table.position[2] == pytest.approx(5.0)
        assert not table.outputs[1]


async def test_home_clears_an_alarm_and_ends_at_the_machine_zero() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="X", distance=250.0, feed=30000.0)
        await until_idle(controller)
        await lock(table, controller)
        await ask(controller, OperationName.HOME)
        assert (await controller.status()).state is State.IDLE
        assert table.position == (0.0, 0.0, 20.0, 0.0)


class _HomingWire(Wire):
    """A controller that answers nothing while it homes, and locks itself if it is reset then."""

    async def write(self, data: bytes) -> None:
        if data == b"$H\n":
            self.mute = True
            self.lines.append("$H")
            return
        if data == b"\x18" and self.mute:
            self.mute, self.state = False, "Alarm"
            self.say("ALARM:6")
        await super().write(data)


async def test_homing_is_stopped_although_the_controller_reports_nothing() -> None:
    wire = _HomingWire()
    async with opened(wire) as controller, asyncio.timeout(120.0):
        homing = asyncio.create_task(controller.home())
        while "$H" not in wire.lines:
            await asyncio.sleep(0.01)
        await ask(controller, OperationName.STOP_JOG)
        assert wire.realtime == b"\x18\x18"
        with pytest.raises(ControllerError):
            await homing
        while controller.alarm is None:
            await asyncio.sleep(0.01)
        assert controller.alarm.arguments["code"] == 6


async def test_nothing_is_lifted_beyond_the_switch_that_homing_has_found() -> None:
    async with machine() as (table, controller):
        await ask(controller, OperationName.JOG, axis="Z", distance=15.0, feed=3000.0)
        await until_idle(controller)
        # The work coordinates have their zero at the top of the travel, not on the mat.
        await controller.zero("Z")
        await controller.switch(1, on=True)
        await controller.home()
        assert (await controller.status()).position[2] < 0.0
        assert not any(table.outputs.values())


async def test_a_refused_output_does_not_refuse_what_follows() -> None:
    # grblHAL repeats the error for every line until an empty one or a command.
    async with machine() as (table, controller):
        with pytest.raises(ControllerError, match="M64 P60"):
            await controller.switch(60, on=True)
        await controller.switch(1, on=True)
        assert table.outputs[1]
        await controller.zero("X")


async def test_a_controller_in_alarm_is_returned_and_can_be_unlocked() -> None:
    async with await simulator.serve(MACHINE, speed=50.0) as server:
        server.table.trip_limit()
        controller = await driver.dial(server.address, SAFE, silence=0.5)
        assert isinstance(controller.fault, ControllerAlarm)
        assert controller.alarm is not None
        assert controller.alarm.code == "controller.alarm-of-unknown-cause"
        await ask(controller, OperationName.UNLOCK)
        assert (await controller.status()).state is State.IDLE
        with pytest.raises(ControllerError) as refused:
            await ask(controller, OperationName.UNLOCK)
        assert refused.value.message.code == "operation.not-locked"
        # The options of the controller were read, too.
        assert controller.capacity == 15
        await controller.close()


@pytest.mark.parametrize(
    ("distance", "feed", "seconds", "piece"),
    [
        (1000.0, 6000.0, 0.5, 50.0),
        (-1000.0, 6000.0, 0.5, -50.0),
        (30.0, 6000.0, 0.5, 30.0),
        (-30.0, 6000.0, math.inf, -30.0),
        (1.0, 0.5, 0.5, 0.01),
    ],
)
def test_a_piece_of_a_jog_is_what_the_machine_travels_in_a_time(
    distance: float, feed: float, seconds: float, piece: float
) -> None:
    assert jog_piece(distance, feed, seconds) == piece
