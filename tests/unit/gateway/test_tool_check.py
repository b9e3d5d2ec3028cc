"""Tool checks on the simulated table: above a point, lowered almost to the board, and up again."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from typing import Any

import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.errors import ControllerError
from knifetip.gateway import tool_check
from knifetip.gateway.tool_check import CheckedPoint
from knifetip.library import load
from knifetip.model.machine import Zone
from tests.unit.gateway.test_claim import MACHINE
from tests.unit.gateway.test_dry_run import activity, waiting_job

#: The V-cutter, 60 mm beside the head, almost on board of 2 mm.
CHECK: dict[str, Any] = {
    "operation": "tool_check",
    "station": 3,
    "point": [200.0, 150.0],
    "height": 4.0,
}


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tool_check, "SHARE", 1.0)


async def test_the_station_moves_above_the_point_and_is_lowered_almost_to_the_board(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        assert (await office.result(office.ask(**CHECK)))["state"] == "done"
        done = await activity(office, "done", "failed")
        assert (done["state"], done["kind"], done["station"]) == ("done", "tool_check", 3)
        assert table.position == pytest.approx((140.0, 150.0, 4.0, 0.0))
        assert [number for number, on in table.outputs.items() if on] == [2]
        assert not table.oscillating
        # Across the table only with the tool up and the piston released.
        assert table.trace is not None
        moved = table.trace.samples()
        across = moved[(abs(moved[:, 1] - 140.0) > 0.1) | (abs(moved[:, 2] - 150.0) > 0.1)]
        assert across[:, 3].min() >= 20.0 - 1e-9
        assert [event.position[2] for event in table.switch_events if event.on] == [20.0]
        await office.report(state="idle", outputs=[2])
        assert (await office.result(office.ask(operation="lift")))["state"] == "done"
        assert table.position == pytest.approx((140.0, 150.0, 20.0, 0.0))
        assert not any(table.outputs.values())
        assert all(beat["waiting"] and beat["line"] == 0 for beat in office.beats)


def test_the_point_is_on_the_sheet_and_the_program_moves_the_axes() -> None:
    leaning = replace(MACHINE, squareness=89.0)
    check = Operation(OperationName.TOOL_CHECK, station=3, point=(200.0, 150.0), height=4.0)
    text = CheckedPoint.from_operation(check, leaning).program(leaning).text
    # Y = 150 / sin 89°, X = 200 - 150 cot 89°, and 60 mm of the station to the left.
    assert b"X137.3817 Y150.0228" in text


async def test_a_trial_correction_moves_all_axes(monkeypatch: pytest.MonkeyPatch) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        await office.result(office.ask(**CHECK))
        await activity(office, "done")
        again = office.ask(**CHECK | {"shift": [0.5, -0.25, 0.1, 2.0]})
        assert (await office.result(again))["state"] == "done"
        while table.position != pytest.approx((140.5, 149.75, 4.1, 2.0)):
            await asyncio.sleep(0.01)
        assert (await activity(office, "done", "failed"))["state"] == "done"


async def test_a_stop_while_z_is_lowered_lifts_the_tool(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tool_check, "LOWER_FEED", 60.0)
    async with waiting_job(monkeypatch, speed=3.0) as (office, table):
        await office.result(office.ask(**CHECK))
        while table.position[2] > 18.0:
            await asyncio.sleep(0.01)
        assert (await office.result(office.ask(operation="stop_jog")))["state"] == "done"
        assert (await activity(office, "stopped", "failed", "done"))["state"] == "stopped"
        assert table.position[2] == pytest.approx(20.0)
        assert not any(table.outputs.values())


async def test_a_tool_that_cannot_be_lowered_stays_up_with_the_reason(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        await office.result(office.ask(**CHECK | {"height": -15.0}))
        done = await activity(office, "done", "failed")
        assert (done["state"], done["message"]["code"]) == ("done", "tool-check.not-lowered")
        assert table.position == pytest.approx((140.0, 150.0, 20.0, 0.0))
        assert not any(table.outputs.values())


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"station": 9}, "operation.no-station"),
        ({"point": [-50.0, 0.0]}, "operation.beyond-travel"),
        ({"shift": [0.0, 0.0, 50.0, 0.0]}, "tool-check.large-shift"),
    ],
)
async def test_a_wrong_check_moves_nothing(
    monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any], code: str
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        refused = await office.result(office.ask(**CHECK | changes))
        assert refused["message"]["code"] == code
        assert table.position == (0.0, 0.0, 20.0, 0.0)


def test_a_point_in_a_keep_out_zone_is_refused() -> None:
    clamped = replace(MACHINE, zones=(Zone("clamp", 190.0, 140.0, 5.0, 5.0, 15.0),))
    check = Operation(OperationName.TOOL_CHECK, station=3, point=(200.0, 150.0), height=4.0)
    CheckedPoint.from_operation(check, MACHINE)
    with pytest.raises(ControllerError) as refused:
        CheckedPoint.from_operation(check, clamped)
    assert refused.value.message.code == "tool-check.in-zone"


async def test_a_laser_is_neither_lowered_nor_switched_on(monkeypatch: pytest.MonkeyPatch) -> None:
    laser = load.machine("laser-table")
    async with waiting_job(monkeypatch, machine=laser) as (office, table):
        await office.result(office.ask(**CHECK | {"station": 5}))
        done = await activity(office, "done", "failed")
        assert (done["state"], done["message"]["code"]) == ("done", "tool-check.not-lowered-beam")
        assert table.position == pytest.approx((200.0, 150.0, 20.0, 0.0))
        assert not any(event.on for event in table.switch_events)
