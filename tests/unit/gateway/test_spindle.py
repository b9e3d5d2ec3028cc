"""Spindles of stations at the gateway: switched by hand, and always off in the safe state."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from typing import Any

import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.errors import ControllerError, ControllerRejected
from knifetip.gateway import station
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.gateway.interpreter import Interpreter
from knifetip.gateway.operations import perform
from knifetip.library import load
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import Table
from tests.unit.gateway.test_operations import on_time, until_idle
from tests.unit.gateway.test_station import JOG, shop

DEMO = load.machine("demo-table")
KNIFE = replace(DEMO.stations[0], spindle="M4", spindle_speed=12000.0)
MACHINE = replace(DEMO, stations=(KNIFE, *DEMO.stations[1:]))


@asynccontextmanager
async def machine() -> AsyncIterator[tuple[Table, driver.Grbl]]:
    async with await simulator.serve(MACHINE, speed=50.0) as server, asyncio.timeout(120.0):
        controller = await driver.dial(
            server.address, SafeState.from_machine(MACHINE), silence=0.5, poll=0.02
        )
        try:
            yield server.table, controller
        finally:
            await controller.close()


async def spin(controller: driver.Grbl, on: bool, number: int = 1) -> None:
    operation = Operation(OperationName.SPINDLE, station=number, on=on)
    await perform(operation, controller, MACHINE, on_time)


async def until_still(table: Table) -> None:
    while table.oscillating:
        await asyncio.sleep(0.01)


async def test_a_spindle_is_switched_by_hand_in_the_direction_of_its_station() -> None:
    async with machine() as (table, controller):
        await spin(controller, on=True)
        assert (table.oscillating, table.reversed, controller.spinning) == (True, True, 1)
        await spin(controller, on=False)
        assert (table.oscillating, controller.spinning) == (False, 0)


@pytest.mark.parametrize("number", [2, 9])
async def test_a_station_without_a_spindle_is_refused(number: int) -> None:
    async with machine() as (table, controller):
        with pytest.raises(ControllerError) as refused:
            await spin(controller, on=True, number=number)
        assert refused.value.message.code == "operation.no-spindle"
        assert not table.oscillating


async def test_no_spindle_starts_by_hand_while_the_tool_is_down() -> None:
    async with machine() as (table, controller):
        down = Operation(OperationName.JOG, axis="Z", distance=-18.0, feed=6000.0)
        await perform(down, controller, MACHINE, on_time)
        await until_idle(controller)
        with pytest.raises(ControllerError) as refused:
            await spin(controller, on=True)
        assert refused.value.message.code == "operation.not-lifted"
        assert not table.oscillating


@pytest.mark.parametrize("way", ["stop", "park", "takeover"])
async def test_the_safe_state_stops_the_spindle(way: str) -> None:
    async with machine() as (table, controller):
        await spin(controller, on=True)
        if way == "takeover":
            await controller.open()
        elif way == "stop":
            await controller.stop()
        else:
            await perform(Operation(OperationName.PARK), controller, MACHINE, on_time)
        assert not table.oscillating
        assert way == "takeover" or controller.spinning == 0


async def test_a_spindle_stops_when_the_server_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(station, "EXPIRY", 0.4)
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        asked = office.ask(operation="spindle", station=1, on=True)
        assert (await office.result(asked))["state"] == "done"
        await office.report(spindle=1)
        assert table.oscillating
        office.silent = True
        await until_still(table)
        office.silent = False
        await office.report(spindle=None)
        jog = await office.result(office.ask(**JOG))
        assert jog["state"] == "done"


def test_a_build_with_one_direction_refuses_m4_before_anything_moves() -> None:
    one_way = Capabilities.read(["[VER:1.1h.20190830:]", "[OPT:VD,15,128]"], 3)
    assert one_way.obstacle(b"M4 S100") is not None
    assert one_way.obstacle(b"M3 S100") is None
    assert one_way.obstacle(b"G0 X1 (M4)") is None
    both = Capabilities.read(["[VER:1.1h.20190830:]", "[OPT:VNMSL,15,128]"], 3)
    assert both.obstacle(b"M4 S100") is None


async def test_a_program_with_m4_is_rejected_by_such_a_build(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with machine() as (table, controller):
        one_way = replace(controller._capabilities, reverses=False)
        monkeypatch.setattr(controller, "_capabilities", one_way)
        with pytest.raises(ControllerRejected) as refused:
            await controller.check([b"G21", b"M4 S12000", b"M5"])
        arguments: Any = refused.value.message.arguments
        assert (arguments["line"], arguments["obstacle"].code) == (2, "grbl.no-reverse")
        assert not table.oscillating


@pytest.mark.parametrize(
    ("line", "expected"),
    [(b"M3 S1", (True, False)), (b"M4 S1", (True, True)), (b"M5", (False, False))],
)
def test_the_interpreter_reads_both_directions(line: bytes, expected: tuple[bool, bool]) -> None:
    block = Interpreter().read(line)
    assert (block.oscillation, block.reverse) == expected
