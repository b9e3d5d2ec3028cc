"""Kinds of tools: the registry, and the behaviour of each tool."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import KINDS, CreaseWheel, Cutter, Knife, Tool, VCutter, kind_of

KNIFE = Knife(10.0, 3.0, 15.0, 24000.0, 6000.0, trail=1.5)
WHEEL = CreaseWheel(15.0, 0.7, 30000.0, 6000.0)
V_CUTTER = VCutter(6.0, 1.5, 45.0)
CUTTER = Cutter(3.0, 9000.0, 1500.0, speed=18000.4, spin_up=2.0, step=1.0)


def machine(*tools: Tool) -> Machine:
    """Return a machine with these tools in stations 1, 2, …."""
    stations = tuple(
        Station(number, str(number), tool, 0.0, 0.0, 0.0, 0.0, number)
        for number, tool in enumerate(tools, 1)
    )
    return replace(load.machine("demo-table"), stations=stations)


def number_for(table: Machine, line_type: LineType, caliper: float | None = None) -> int | None:
    """Return the number of the station that makes a line type, None if there is none."""
    station = table.station_for(line_type, caliper)
    return station.number if station else None


def test_each_row_of_the_registry_has_its_own_class_and_name() -> None:
    assert len({kind.name for kind in KINDS}) == len({kind.tool for kind in KINDS}) == len(KINDS)
    assert [kind_of(tool).name for tool in (KNIFE, WHEEL, V_CUTTER, CUTTER)] == [
        "knife",
        "crease-wheel",
        "v-cutter",
        "cutter",
    ]


def test_a_knife_is_preferred_to_a_router_for_cuts() -> None:
    both, router = machine(CUTTER, KNIFE), machine(WHEEL, CUTTER)
    assert number_for(both, LineType.CUT) == 2
    assert number_for(router, LineType.CUT) == 2
    assert (both.offset_cuts, router.offset_cuts, machine(WHEEL).offset_cuts) == (
        False,
        True,
        False,
    )
    assert number_for(router, LineType.PERFORATION) is None


@pytest.mark.parametrize(("caliper", "number"), [(0.4, 3), (0.7, 2), (0.9, 1), (9.0, 1)])
def test_the_narrowest_rim_that_is_as_wide_as_the_board_is_taken(
    caliper: float, number: int | None
) -> None:
    wheels = machine(*(replace(WHEEL, width=width) for width in (1.5, 0.7, 0.5)))
    assert number_for(wheels, LineType.CREASE, caliper) == number


def test_footprints_have_the_tips_and_the_widths_of_the_tools_drawings() -> None:
    assert (KNIFE.footprint.shape, KNIFE.footprint.behind) == ("line", 1.5)
    assert (WHEEL.footprint.radius, WHEEL.footprint.width) == (15.0, 0.7)
    groove = V_CUTTER.footprint
    assert (groove.left, groove.behind, groove.blade) == (6.0, 1.5, 3.0)
    assert groove.slope == pytest.approx(1.0)
    assert (CUTTER.footprint.shape, CUTTER.footprint.radius) == ("disc", 3.0)


def test_a_router_turns_at_its_speed_and_waits_until_it_does() -> None:
    assert (CUTTER.spindle, CUTTER.settle(0.15), KNIFE.settle(0.15)) == (18000, 2.0, 0.15)
    assert (KNIFE.spindle, replace(KNIFE, oscillating=True).spindle) == (0, 1)
    assert CUTTER.passes(2.5).tolist() == pytest.approx([2.5 / 3, 5 / 3, 2.5])


def test_dimensions_are_the_fields_of_the_record() -> None:
    assert V_CUTTER.dimensions == {
        "back": 6.0, "half_width": 1.5, "tilt": 45.0, "feed": 12000.0, "plunge": 3000.0,
    }  # fmt: skip
