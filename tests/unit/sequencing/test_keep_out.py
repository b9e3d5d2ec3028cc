"""Rapids around and over keep-out zones, and work in them."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.compensation.compensate import compensate
from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Zone
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from knifetip.post.emit import process
from knifetip.sequencing.duration import duration
from knifetip.sequencing.keep_out import _poses_around_zones, avoid_zones
from knifetip.sequencing.sequence import sequence
from knifetip.verification.verify import verify
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

#: Two parts with 100 mm of waste between them.
PARTS = dieline(
    (
        LineType.CUT,
        np.concatenate(
            [
                closed((0, 0), (100, 0), (100, 100), (0, 100)),
                closed((200, 0), (300, 0), (300, 100), (200, 100)),
            ]
        ),
    )
)


def with_zones(*zones: Zone, envelope: float = 0.0) -> Machine:
    stations = tuple(replace(station, envelope=envelope) for station in MACHINE.stations)
    return replace(MACHINE, zones=zones, stations=stations)


def sequenced(machine: Machine, drawn: Dieline = PARTS) -> Toolpath:
    return sequence([compensate(each) for each in plan(drawn, machine, BOARD)], machine)


def accepted(path: Toolpath, machine: Machine, drawn: Dieline = PARTS) -> bool:
    text = process(path, machine, tolerance=0.01).text
    return verify(text, drawn, (0.0, 0.0), machine, BOARD).accepted


def rapids(path: Toolpath) -> F64:
    """Return start and end of each rapid, (n, 2, 4)."""
    rows = np.flatnonzero(path.motion == Motion.RAPID)
    return np.stack([path.pose[rows], path.pose[rows + 1]], axis=1)


def least_distance(path: Toolpath, zone: Zone) -> float:
    """Return the least distance from the zone of an axis that is below the zone's top."""
    low, high = np.array([zone.x, zone.y]), np.array([zone.x + zone.width, zone.y + zone.height])
    least = math.inf
    for start, end in zip(path.pose[:-1], path.pose[1:], strict=True):
        points = start + (end - start) * np.linspace(0.0, 1.0, 400)[:, None]
        below = points[points[:, 2] < zone.top]
        gap = np.maximum(np.maximum(low - below[:, :2], below[:, :2] - high), 0.0)
        least = min(least, float(np.hypot(*gap.T).min(initial=math.inf)))
    return least


WALL = Zone("wall", 140.0, -300.0, 20.0, 600.0, 12.0)
PIN = Zone("pin", 145.0, -5.0, 10.0, 10.0, 17.0)


def test_without_a_zone_in_the_way_nothing_changes() -> None:
    plain = sequenced(MACHINE)
    aside = sequenced(with_zones(Zone("clamp", 140.0, 300.0, 20.0, 20.0, 12.0)))
    np.testing.assert_array_equal(plain.pose, aside.pose)
    assert avoid_zones(plain, MACHINE) is plain


def test_a_rapid_rises_over_a_long_zone_by_the_clearance() -> None:
    machine = with_zones(WALL, envelope=15.0)
    path = sequenced(machine)
    assert least_distance(sequenced(MACHINE), WALL) == 0.0
    assert least_distance(path, WALL) >= 15.0
    assert 14.0 in rapids(path)[:, :, 2]
    assert accepted(path, machine)
    assert not accepted(sequenced(MACHINE), machine)


def test_a_rapid_moves_around_a_small_zone_at_its_height_if_that_is_faster() -> None:
    machine = with_zones(PIN, envelope=10.0)
    path = sequenced(machine)
    assert least_distance(sequenced(MACHINE), PIN) == 0.0
    assert least_distance(path, PIN) >= 10.0
    # No rapid between the parts leaves the height of the turns.
    assert 19.0 not in rapids(path)[:, :, 2]
    assert len(path) > len(sequenced(MACHINE))
    # LinuxCNC almost stops at each corner of the way round while C turns.
    assert duration(path, machine) < duration(sequenced(MACHINE), MACHINE) + 0.5
    assert accepted(path, machine)


def test_c_turns_evenly_around_a_zone() -> None:
    path = sequenced(with_zones(PIN, envelope=10.0))
    changes = np.abs(np.diff(path.pose[:, 3]))
    assert changes.max() <= np.abs(np.diff(sequenced(MACHINE).pose[:, 3])).max() + 1e-9


@pytest.mark.parametrize(
    ("zone", "envelope"),
    [
        (Zone("clamp", 30.0, -7.5, 20.0, 5.0, 12.0), 0.0),
        (Zone("clamp", 30.0, -30.0, 20.0, 5.0, 12.0), 25.5),
        (Zone("clamp", 20.0, 40.0, 20.0, 5.0, 12.0), 20.5),
    ],
)
def test_work_that_touches_a_zone_is_refused_with_its_place(zone: Zone, envelope: float) -> None:
    with pytest.raises(PlanError, match=r"Knife \(station 1\) would touch the keep-out zone clamp"):
        sequenced(with_zones(zone, envelope=envelope))


def test_the_error_of_work_in_a_zone_names_place_edge_and_reach() -> None:
    zone = Zone("stop", 290.0, 96.0, 5.0, 5.0, 9.0)
    with pytest.raises(PlanError) as caught:
        sequenced(with_zones(zone))
    assert "at X 292.5, Y 100.0 mm: the tool with its holder needs 3.0 mm" in caught.value.text
    assert caught.value.text.endswith("The move belongs to edge 6.")
    assert "Move the clamp or stop" in caught.value.hint


def test_an_arc_is_work_in_a_zone_along_its_way_and_not_along_its_chord() -> None:
    drawn = dieline((LineType.CUT, edges(((0, 0), (100, 0)), ((100, 0), (0, 0)))), bulge={0: 1.0})
    beside = Zone("pin", 49.0, -40.0, 2.0, 2.0, 9.0)
    assert len(sequenced(with_zones(beside), drawn))
    with pytest.raises(PlanError, match="keep-out zone pin"):
        sequenced(with_zones(replace(beside, y=-55.0)), drawn)


def test_all_random_zones_are_avoided_or_refused() -> None:
    random = np.random.default_rng(7)
    avoided = 0
    for _ in range(60):
        zones = tuple(
            Zone(f"zone {n}", x, y, width, height, top)
            for n, (x, y, width, height, top) in enumerate(
                random.uniform((100, -60, 2, 2, 3), (190, 60, 30, 30, 17), (3, 5)).tolist()
            )
        )
        machine = with_zones(*zones, envelope=random.uniform(0.0, 12.0))
        try:
            path = sequenced(machine)
        except PlanError:
            assert not accepted(sequenced(MACHINE), machine)
            continue
        reach = machine.stations[0].reach
        assert min(least_distance(path, zone) for zone in zones) >= reach - 1e-6
        assert accepted(path, machine)
        changed = len(path) > len(sequenced(MACHINE))
        avoided += changed
        assert accepted(sequenced(MACHINE), machine) is not changed
    assert avoided > 5


@pytest.mark.parametrize(("degrees", "is_left"), [(90.0, True), (89.0, False), (91.0, True)])
def test_a_way_round_a_zone_is_within_the_travel_of_leaning_axes(
    degrees: float, is_left: bool
) -> None:
    station = MACHINE.stations[0]
    zone = Zone("clamp", 150.0, 900.0, 450.0, 100.0, 15.0)
    # Left of the zone, the knife is 8 mm within the travel of X, and at 89° 16 mm beyond it.
    low = zone.x - station.reach - 10.0
    machine = replace(MACHINE, squareness=degrees, zones=(zone,), x=replace(MACHINE.x, low=low))
    start, end = np.array([[300.0, 800.0, 5.0, 0.0], [300.0, 1100.0, 5.0, 0.0]])
    way = _poses_around_zones(start, end, station, machine)
    assert way is not None
    assert (way[:, 0].max() <= 300.0) == is_left
