"""Corner types: turn angles, durations under the machine's limits, and the choice of auto."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.corner import (
    contact_time,
    corner_durations,
    corner_lengths,
    select_corner_types,
    turn_angles,
)
from knifetip.errors import CompensationError
from knifetip.geometry.path import Paths, path_through
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Cutter
from knifetip.offset.transition import Corner

ROUTER = Cutter(radius=2.0, feed=12000.0, plunge=3000.0, speed=18000.0)
HALF = np.array([0.5])
# A counter-clockwise square; its edges begin at the corners (0, 0), (50, 0) …
SQUARE = path_through(np.array([[0, 0], [50, 0], [50, 50], [0, 50], [0, 0]], float), np.zeros(4))


def operation(paths: Paths = SQUARE, **changes: Any) -> Operation:
    count = len(paths.bulge)
    plain = Operation(
        paths=paths, line_type=LineType.CUT, tool=ROUTER, station=4,
        depth=np.full((count, 1), 2.3), caliper=2.0, clearance=2.0, feed=12000.0, plunge=3000.0,
        swivel=0.0, end_clearance=0.0, overcut=0.0, short_crease="press",
        start=np.full(len(paths), End.CLOSED), finish=np.full(len(paths), End.CLOSED),
        source=np.arange(count, dtype=np.int32), side=-1, acceleration=8000.0,
    )  # fmt: skip
    return replace(plain, **changes)


def test_corners_of_a_square_are_convex_from_outside_and_concave_from_inside() -> None:
    np.testing.assert_allclose(np.degrees(turn_angles(SQUARE, -1)), 90.0)
    np.testing.assert_allclose(np.degrees(turn_angles(SQUARE, 1)), -90.0)


def test_an_open_path_has_no_corner_at_its_start() -> None:
    path = path_through(np.array([[0, 0], [10, 0], [10, 10], [20, 20]], float), np.zeros(3))
    np.testing.assert_allclose(np.degrees(turn_angles(path, -1)), [0, 90, -45], atol=1e-9)


def test_the_turn_at_an_arc_is_measured_to_its_tangent() -> None:
    # East, then a quarter to the left from (10, 0) to (20, 10): no corner; then north again.
    path = path_through(np.array([[0, 0], [10, 0], [20, 10], [20, 20]], float),
                   np.array([0.0, np.tan(np.pi / 8), 0.0]))  # fmt: skip
    np.testing.assert_allclose(turn_angles(path, -1), 0.0, atol=1e-12)


def test_durations_at_a_right_angle_equal_those_computed_by_hand() -> None:
    # v 200 mm/s, a 8,000 mm/s², r 2 mm. B: √(8000 · 2) = 126.49 mm/s round 3.1416 mm is 24.84 ms,
    # slower by 73.51 twice: 73.51² / (8000 · 200) = 3.38 ms. C: 4 mm is 20 ms, a stop 25 ms.
    # D: 2 mm straight 10 ms, 1.5708 mm at √(8000 · 1) = 89.44 is 17.56 ms, and 110.56² / 1.6e6
    # = 7.64 ms.
    took = corner_durations(np.radians([90.0]), 2.0, HALF, 200.0, 8000.0)[0]
    np.testing.assert_allclose(1000 * took, [24.84 + 3.38, 45.0, 10.0 + 17.56 + 7.64], atol=0.01)


def test_the_head_stops_at_both_bends_of_a_c_corner_beyond_90_degrees() -> None:
    # φ 180°, r 2: 4 mm at full feed 20 ms, one stop 25 ms, and 4 mm from stop to stop, which is
    # short of v² / a = 5 mm: 2 √(4 / 8000) = 44.72 ms.
    took = corner_durations(np.radians([180.0]), 2.0, HALF, 200.0, 8000.0)[0]
    assert 1000 * took[1] == pytest.approx(20.0 + 25.0 + 44.72, abs=0.01)
    # At r 5 those 10 mm reach the feed: 50 ms and 25 ms for the change of speed.
    took = corner_durations(np.radians([180.0]), 5.0, HALF, 200.0, 8000.0)[0]
    assert 1000 * took[1] == pytest.approx(50.0 + 25.0 + 75.0, abs=0.01)


def test_durations_without_limits_are_lengths_divided_by_the_feed() -> None:
    turn = np.radians([30.0, 90.0, 150.0])
    k = np.full(3, 0.5)
    np.testing.assert_allclose(
        corner_durations(turn, 3.0, k, 100.0, np.inf),
        corner_lengths(turn, 3.0, k) / 100.0,
        rtol=1e-12,
    )


def test_contact_time_of_type_b_is_the_time_of_its_arc() -> None:
    # 3.1416 mm at 126.49 mm/s; at 50 mm/s the feed itself is the limit.
    np.testing.assert_allclose(
        contact_time(np.radians([90.0]), 2.0, 200.0, 8000.0), 0.02484, atol=1e-5
    )
    np.testing.assert_allclose(
        contact_time(np.radians([90.0]), 2.0, 50.0, 8000.0), 0.06283, atol=1e-5
    )


@given(degrees=st.floats(1.0, 180.0), k=st.floats(0.05, 0.95), radius=st.floats(0.05, 20.0),
       feed=st.floats(5.0, 1000.0), acceleration=st.floats(500.0, 20000.0))  # fmt: skip
def test_type_b_is_at_most_a_thousandth_slower_than_type_d(
    degrees: float, k: float, radius: float, feed: float, acceleration: float
) -> None:
    b, _, d = corner_durations(np.radians([degrees]), radius, np.array([k]), feed, acceleration)[0]
    # Above 115° and on slow machines, type D may be faster by less than that.
    assert b <= d * 1.001


@pytest.mark.parametrize("word", ["B", "C", "D"])
def test_a_named_type_is_used_at_every_corner(word: str) -> None:
    chosen, k = select_corner_types(operation(corner=word, k=0.3))
    assert set(chosen.tolist()) == {Corner[word]}
    assert set(k.tolist()) == {0.3}


def test_auto_selects_the_fastest_type_that_does_not_burn_the_corner() -> None:
    # B touches the right angle for 24.84 ms.
    chosen, _ = select_corner_types(operation(corner="auto"))
    assert set(chosen.tolist()) == {Corner.B}
    chosen, _ = select_corner_types(operation(corner="auto", tool=replace(ROUTER, dwell=0.0249)))
    assert set(chosen.tolist()) == {Corner.B}
    chosen, _ = select_corner_types(operation(corner="auto", tool=replace(ROUTER, dwell=0.0248)))
    assert set(chosen.tolist()) == {Corner.D}


def test_auto_selects_a_type_for_each_corner() -> None:
    # 150° at (60, 0) touches for 5.24 mm, 30° at (0, 0) for 1.05 mm, at 126.49 mm/s.
    slope = np.tan(np.radians(30.0)) * 60.0
    path = path_through(np.array([[0, 0], [60, 0], [0, slope], [0, 0]], float), np.zeros(3))
    found = np.degrees(turn_angles(path, -1))
    np.testing.assert_allclose(found, [90.0, 150.0, 120.0])
    chosen, _ = select_corner_types(
        operation(path, corner="auto", tool=replace(ROUTER, dwell=0.030))
    )
    assert chosen.tolist() == [Corner.B, Corner.D, Corner.D]


def test_auto_limits_k_so_that_type_d_keeps_the_feed() -> None:
    # v² / (a r) = 100² / (8000 · 2) = 0.625, so k 0.375 leaves r′ = 1.25 and √(8000 · 1.25) = 100.
    _, k = select_corner_types(operation(corner="auto", feed=6000.0))
    np.testing.assert_allclose(k, 0.375)
    _, k = select_corner_types(operation(corner="auto", feed=6000.0, k=0.2))
    np.testing.assert_allclose(k, 0.2)
    # At 200 mm/s no arc with a radius up to r keeps the feed.
    _, k = select_corner_types(operation(corner="auto"))
    np.testing.assert_allclose(k, 0.5)


def test_each_corner_may_have_its_own_k() -> None:
    _, k = select_corner_types(operation(corner="D", k_at=[np.nan, 0.2, np.nan, 0.9]))
    np.testing.assert_array_equal(k, [0.5, 0.2, 0.5, 0.9])


def test_an_invalid_type_or_k_is_refused_with_its_edge() -> None:
    with pytest.raises(CompensationError, match=r"corner type 'E'.* does not exist"):
        select_corner_types(operation(corner="E"))
    with pytest.raises(CompensationError, match=r"edge 2 is 1\.5"):
        select_corner_types(operation(corner="D", k_at=[0.5, 0.5, 1.5, 0.5]))
    with pytest.raises(CompensationError, match="is nan"):
        select_corner_types(operation(corner="D", k=np.nan))


def test_one_corner_may_have_another_type() -> None:
    kind, _ = select_corner_types(
        operation(corner="D", corner_at=np.array([255, 0, 1, 3], np.uint8))
    )
    assert list(kind[:3]) == [Corner.D, Corner.B, Corner.C]
    # Type 3 is auto: the corner gets the type that it has if all corners are auto.
    assert kind[3] == select_corner_types(operation(corner="auto"))[0][3]


def test_a_corner_set_to_d_keeps_its_k_beside_auto_corners() -> None:
    types = np.array([2, 255, 255, 255], np.uint8)
    # At 50 mm/s auto limits k to 1 - 50² / (8000 · 2) = 0.844.
    _, k = select_corner_types(operation(corner="auto", k=0.9, corner_at=types, feed=3000.0))
    np.testing.assert_allclose(k, [0.9, 0.84375, 0.84375, 0.84375])
