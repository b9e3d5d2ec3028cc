"""The radius engine: the disc touches the part and never enters it.

Distances to the lines and arcs of the drawing are computed in this file.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from knifetip.compensation.centre_paths import centre_paths
from knifetip.compensation.compensate import compensate
from knifetip.compensation.leads import set_up_offset
from knifetip.compensation.radius import radius_toolpath
from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.path import Paths
from knifetip.model.dieline import LineType
from knifetip.model.machine import Station
from knifetip.model.operation import End, Operation
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from tests.support.contours import distance, random_contour
from tests.support.examples import examples
from tests.support.operations import ROUTER, contour
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges, rotation

ROUTED = replace(MACHINE, stations=(Station(4, "Router", ROUTER, 0.0, 0.0, 0.0, 0.0, 3),))
QUARTER = np.tan(np.pi / 8)
many = examples(300)


def open_cut(
    *points: tuple[float, float],
    side: int = 1,
    r: float = 3.0,
    depth: tuple[float, ...] = (2.3,),
    **changes: Any,
) -> Operation:
    xy = np.array(points, float)
    whole = contour(*points, side=side, r=r)
    count = len(xy) - 1
    return replace(
        whole, paths=Paths(xy[:-1], xy[1:], np.zeros(count), np.array([0, count])),
        depth=np.tile(depth, (count, 1)), start=np.array([End.FREE], np.uint8),
        finish=np.array([End.FREE], np.uint8),
        source=np.arange(count, dtype=np.int32), k_at=np.zeros(0), corner_at=np.zeros(0, np.uint8),
        endable=np.zeros(0, np.bool_),
        run_out=np.zeros((0, 2)), **changes,
    )  # fmt: skip


def sampled(
    path: Toolpath,
    motions: Sequence[Motion] = (Motion.LEAD_IN, Motion.FEED, Motion.LEAD_OUT),
    step: float = 0.5,
) -> F64:
    """Return points of the centre's path about every ``step`` mm, including the ends of moves, (n,
    2).

    Only moves with one of ``motions`` are sampled.
    """
    points = []
    for row in np.flatnonzero(np.isin(path.motion, motions)):
        a, b, bend = path.pose[row, :2], path.pose[row + 1, :2], path.bulge[row]
        count = 3 + int(np.hypot(*(b - a)) * (1 + bend * bend) / step)
        points.append(arc.points_along(a[None], b[None], np.array([bend]), count)[0])
    return np.concatenate(points)


def within(points: F64, polygon: F64) -> Bool:
    """Return whether each point is in a polygon, by the even-odd rule."""
    odd = np.zeros(len(points), bool)
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        crosses = (a[1] > points[:, 1]) != (b[1] > points[:, 1])
        if crosses.any():
            x = a[0] + (points[:, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1] or 1.0)
            odd ^= crosses & (points[:, 0] < x)
    return odd


stars = st.lists(st.floats(25.0, 90.0), min_size=3, max_size=9)
# An arc of less than 2° has too large a radius for nine places behind the point.
bends = st.lists(
    st.floats(-0.35, 0.35).map(lambda b: b if abs(b) > 0.01 else 0.0), min_size=9, max_size=9
)
corners = st.sampled_from(["B", "C", "D", "auto"])
cutters = st.floats(0.2, 8.0)


def star(radii: list[float], phase: float = 0.3) -> F64:
    angle = phase + np.arange(len(radii)) * 2 * np.pi / len(radii)
    xy: F64 = np.array(radii)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    return xy


@many
@given(radii=stars, corner=corners, r=cutters, outside=st.booleans())
def test_the_disc_touches_the_part_and_never_enters_it(
    radii: list[float], corner: str, r: float, outside: bool
) -> None:
    points = star(radii)
    operation = contour(*points, side=-1 if outside else 1, r=r, corner=corner)
    path = radius_toolpath(operation)
    way = sampled(path)
    away = distance(way, operation.paths)
    assert away.min() >= r - 1e-9
    assert distance(sampled(path, [Motion.FEED]), operation.paths).min() <= r + 1e-9
    assert not (within(way, points) == outside).any()


@many
@given(
    radii=stars, bulges=bends, corner=corners, r=st.floats(0.2, 4.0), side=st.sampled_from([1, -1])
)
def test_the_disc_never_enters_a_part_with_arcs(
    radii: list[float], bulges: list[float], corner: str, r: float, side: int
) -> None:
    points = star(radii)
    operation = contour(*points, bulge=bulges[: len(points)], side=side, r=r, corner=corner)
    # Curved edges of a star may cross; such a contour has no inside.
    flat = arc.points_along(
        *(operation.paths.start, operation.paths.end, operation.paths.bulge), 65
    )
    angle = np.unwrap(np.arctan2(flat[:, :-1, 1].ravel(), flat[:, :-1, 0].ravel()))
    assume((np.diff(angle) > 0.0).all())
    path = radius_toolpath(operation)
    away = distance(sampled(path), operation.paths)
    assert away.min() >= r - 1e-9
    assert distance(sampled(path, [Motion.FEED]), operation.paths).min() <= r + 1e-9


@many
@given(radii=stars, corner=corners, r=st.floats(0.2, 4.0), degrees=st.floats(-180.0, 180.0))
def test_turning_the_board_turns_the_path_of_the_centre(
    radii: list[float], corner: str, r: float, degrees: float
) -> None:
    turn = rotation(degrees)
    before = centre_paths(contour(*star(radii), r=r, corner=corner)).paths
    after = centre_paths(contour(*(star(radii) @ turn.T), r=r, corner=corner)).paths
    np.testing.assert_allclose(after.lengths, before.lengths, atol=1e-7)
    points = arc.points_along(after.start, after.end, after.bulge, 5).reshape(-1, 2)
    assert distance(points @ turn, before).max() < 1e-7


@many
@given(radii=stars, corner=st.sampled_from(["B", "C", "D"]), r=st.floats(0.2, 4.0),
       shift=st.integers(1, 8))  # fmt: skip
def test_direction_and_start_of_a_contour_do_not_change_the_path_of_the_centre(
    radii: list[float], corner: str, r: float, shift: int
) -> None:
    points = star(radii)
    there = centre_paths(contour(*points, r=r, corner=corner)).paths
    for other in (
        contour(*points[::-1], side=1, r=r, corner=corner),
        contour(*np.roll(points, shift, axis=0), r=r, corner=corner),
    ):
        paths = centre_paths(other).paths
        np.testing.assert_allclose(paths.lengths, there.lengths, atol=1e-7)
        places = arc.points_along(paths.start, paths.end, paths.bulge, 5).reshape(-1, 2)
        assert distance(places, there).max() < 1e-7


def test_a_radius_of_zero_returns_the_contour() -> None:
    points = star([50.0, 30.0, 60.0, 40.0])
    paths = centre_paths(contour(*points, r=0.0)).paths
    assert distance(points, paths).max() == 0.0
    assert distance(paths.start, contour(*points).paths).max() < 1e-12


def test_a_rectangle_from_outside_with_type_b_equals_the_path_computed_by_hand() -> None:
    # 100 × 50 counter-clockwise, r 3: the tool plunges at the middle of the first long side, 4.5 mm
    # off.
    path = compensate(contour((0, 0), (100, 0), (100, 50), (0, 50)))
    assert path.motion.tolist() == [
        Motion.PLUNGE, Motion.LEAD_IN, *[Motion.FEED] * 9, Motion.LEAD_OUT, Motion.LIFT,
    ]  # fmt: skip
    expected = [
        [50, -4.5], [50, -4.5], [50, -3], [100, -3], [103, 0], [103, 50], [100, 53], [0, 53],
        [-3, 50], [-3, 0], [0, -3], [50, -3], [50, -4.5], [50, -4.5],
    ]  # fmt: skip
    np.testing.assert_allclose(path.pose[:, :2], np.array(expected, float), atol=1e-12)
    np.testing.assert_allclose(path.pose[[0, 1, 7, 12, 13], 2], [4, -0.3, -0.3, -0.3, 4])
    np.testing.assert_allclose(path.bulge[3:10:2], [QUARTER] * 4)
    assert (path.pose[:, 3] == 0.0).all()
    assert path.source[2:11].tolist() == [0, 1, 1, 2, 2, 3, 3, 0, 0]


def test_a_hole_is_milled_from_inside_without_transitions() -> None:
    path = compensate(contour((0, 0), (100, 0), (100, 50), (0, 50), side=1))
    fed = path.motion == Motion.FEED
    np.testing.assert_allclose(
        path.pose[:-1][fed][:, :2], [[50, 3], [97, 3], [97, 47], [3, 47], [3, 3]], atol=1e-12
    )
    np.testing.assert_allclose(path.pose[1, :2], [50, 4.5])


def test_passes_follow_each_other_without_lifting() -> None:
    deep = np.tile([1.0, 2.3], (4, 1))
    path = compensate(contour((0, 0), (100, 0), (100, 50), (0, 50), depth=deep))
    plunges = np.flatnonzero(path.motion == Motion.PLUNGE)
    np.testing.assert_allclose(path.pose[plunges + 1][:, :3], [[50, -4.5, 1.0], [50, -4.5, -0.3]])
    assert np.count_nonzero(path.motion == Motion.LIFT) == 1
    assert np.count_nonzero(path.motion == Motion.RAPID) == 0


def test_a_slit_is_milled_on_its_centre_line_forth_and_back() -> None:
    path = compensate(open_cut((0, 0), (50, 0), side=0))
    np.testing.assert_allclose(path.pose[:, :2], [[0, 0], [0, 0], [50, 0], [50, 0]])
    path = compensate(open_cut((0, 0), (50, 0), (50, 20), side=0, depth=(1.0, 2.3)))
    assert path.motion.tolist() == [
        Motion.PLUNGE, Motion.FEED, Motion.FEED, Motion.PLUNGE, Motion.FEED, Motion.FEED,
        Motion.LIFT,
    ]  # fmt: skip
    np.testing.assert_allclose(path.pose[-2, :3], [0, 0, -0.3])
    assert path.source.tolist() == [0, 0, 1, 1, 1, 0, 0]


@pytest.mark.parametrize("side", [1, -1])
def test_an_open_cut_is_milled_beside_its_line_left_or_right(side: int) -> None:
    path = compensate(open_cut((0, 0), (50, 0), side=side))
    np.testing.assert_allclose(
        path.pose[:, :2] * [1, side],
        np.array([[0, 4.5], [0, 4.5], [0, 3], [50, 3], [50, 4.5], [50, 4.5]]),
        atol=1e-12,
    )


def test_all_passes_of_an_open_cut_with_a_side_have_the_same_direction() -> None:
    path = compensate(open_cut((0, 0), (50, 0), depth=(1.0, 2.3)))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed, 0], [0, 0])
    assert np.count_nonzero(path.motion == Motion.LIFT) == 2


@pytest.mark.parametrize("side", [1, -1])
def test_set_up_to_the_perpendicular_and_around_the_outside(side: int) -> None:
    start, ahead = np.array([[10.0, 0.0]]), np.array([[1.0, 0.0]])
    flip = np.array([1.0, side])
    # Type A, at a right angle from the tool's side, r 3 and a lead of 5.
    begin, arrived, bulge = set_up_offset(start, ahead, side, 3.0, 5.0, 90.0)
    np.testing.assert_allclose([begin[0] * flip, arrived[0] * flip], [[10, 5], [10, 3]], atol=1e-12)
    assert bulge[0] == 0.0
    # In line: from (5, 0) obliquely to (10, 3).
    begin, arrived, bulge = set_up_offset(start, ahead, side, 3.0, 5.0, 0.0)
    np.testing.assert_allclose([begin[0] * flip, arrived[0] * flip], [[5, 0], [10, 3]], atol=1e-12)
    # Type B, from the far side: parallel to the lead to (7, 0), then a quarter circle to (10, 3).
    begin, arrived, bulge = set_up_offset(start, ahead, side, 3.0, 5.0, -90.0)
    np.testing.assert_allclose([begin[0] * flip, arrived[0] * flip], [[7, -5], [7, 0]], atol=1e-12)
    assert bulge[0] == pytest.approx(-side * QUARTER)


def test_an_open_cut_is_set_up_and_cancelled_around_the_outside() -> None:
    around = replace(ROUTER, lead=5.0, approach=-90.0)
    path = compensate(open_cut((0, 0), (50, 0), tool=around))
    np.testing.assert_allclose(
        path.pose[1:-1, :2], [[-3, -5], [-3, 0], [0, 3], [50, 3], [53, 0], [53, -5]], atol=1e-12
    )
    np.testing.assert_allclose(path.bulge[1:-1], [0, -QUARTER, 0, -QUARTER, 0], atol=1e-12)


def test_a_closed_contour_is_set_up_around_its_sharpest_corner() -> None:
    # The corners turn by 90°, 90°, 45°, and by 135° at (100, 0).
    around = replace(ROUTER, lead=5.0, approach=-90.0)
    path = compensate(contour((0, 0), (0, 50), (50, 50), (100, 0), (50, 0), side=1, tool=around))
    row = int(np.flatnonzero(path.motion == Motion.FEED)[0])
    np.testing.assert_allclose(path.pose[row, :2], [100, -3], atol=1e-12)
    # From the far side of (100, 0), a quarter circle about it to the start.
    np.testing.assert_allclose(path.pose[row - 1, :2], [103, 0], atol=1e-12)
    np.testing.assert_allclose(path.pose[row - 2, :2], [103, 5], atol=1e-12)


@pytest.mark.parametrize("angle", [-20.0, -60.0, -90.0])
@pytest.mark.parametrize("seed", range(12))
def test_lead_ins_round_corners_do_not_enter_random_contours(seed: int, angle: float) -> None:
    paths = random_contour(seed)
    around = replace(ROUTER, radius=2.0, lead=5.0, approach=angle)
    for side in (1, -1):
        for corner in "BCD":
            path = compensate(
                contour(*paths.start, side=side, paths=paths, tool=around, corner=corner)
            )
            away = distance(sampled(path, step=0.05), paths)
            assert away.min() >= 2.0 - 0.001


def test_a_lead_in_that_would_meet_another_contour_is_shortened_or_omitted() -> None:
    # A slot 8 mm wide, r 3: the centre is 3 mm from either wall, so 2 mm remain between the paths.
    roomy = compensate(contour((0, 0), (60, 0), (60, 8), (0, 8), side=1))
    np.testing.assert_allclose(roomy.pose[1, :2], [30, 4.5])
    tight = compensate(contour((0, 0), (60, 0), (60, 7), (0, 7), side=1))
    np.testing.assert_allclose(tight.pose[1, :2], [30, 3.75])
    none = compensate(contour((0, 0), (60, 0), (60, 6.2), (0, 6.2), side=1))
    assert none.motion[:2].tolist() == [Motion.PLUNGE, Motion.FEED]
    np.testing.assert_allclose(none.pose[1, :2], [30, 3])


def test_the_area_that_the_cutter_cannot_reach_is_reported() -> None:
    # A fillet remains in each corner of a square hole, (1 − π/4) r² each.
    way = centre_paths(contour((0, 0), (50, 0), (50, 50), (0, 50), side=1))
    np.testing.assert_allclose(way.unreached, 4 * (1 - np.pi / 4) * 9.0, rtol=1e-9)
    assert centre_paths(contour((0, 0), (50, 0), (50, 50), (0, 50))).unreached.sum() < 1e-9


def test_a_contour_with_a_narrow_neck_gives_two_paths_or_is_refused() -> None:
    # Two squares of 30 × 30 joined by a neck of 4 mm, for a cutter of 6 mm.
    rooms = [
        (0, 0), (30, 0), (30, 13), (50, 13), (50, 0), (80, 0), (80, 30), (50, 30), (50, 17),
        (30, 17), (30, 30), (0, 30),
    ]  # fmt: skip
    operation = contour(*rooms, side=1)
    path = compensate(operation)
    assert path.track.max() == 1
    assert distance(sampled(path), operation.paths).min() >= 3.0 - 1e-9
    assert centre_paths(operation).unreached.sum() > 20 * 4
    with pytest.raises(CompensationError, match=r"does not fit beside edge .* would cut"):
        compensate(replace(operation, interference="refuse"))


def test_a_hole_too_small_for_the_cutter_is_left_out_or_refused() -> None:
    hole = contour((0, 0), (50, 0), (50, 5), (0, 5), side=1)
    assert len(compensate(hole)) == 0
    with pytest.raises(CompensationError, match=r"does not fit beside edge 0") as refused:
        compensate(replace(hole, interference="refuse"))
    assert "interference 'trim'" in refused.value.hint


def test_the_cutter_does_not_enter_a_neighbour_nearer_than_its_diameter() -> None:
    # Two blanks 4 mm apart and a cutter of 6 mm, which does not fit between them.
    line = dieline(
        (LineType.CUT, closed((0, 0), (50, 0), (50, 50), (0, 50))),
        (LineType.CUT, closed((54, 0), (104, 0), (104, 50), (54, 50))),
    )
    (operation,) = plan(line, ROUTED, BOARD)
    path = compensate(operation)
    assert distance(sampled(path), operation.paths).min() >= 3.0 - 1e-9
    assert centre_paths(operation).unreached.sum() > 4 * 48


def test_a_lead_not_longer_than_the_radius_is_refused() -> None:
    with pytest.raises(
        CompensationError,
        match="lead-in of the cutter is 3 mm long, but must be longer than the radius",
    ):
        compensate(contour((0, 0), (50, 0), (50, 50), tool=replace(ROUTER, lead=3.0)))


def test_a_laser_is_offset_by_half_its_kerf() -> None:
    path = compensate(
        contour((0, 0), (50, 0), (50, 50), (0, 50), tool=replace(ROUTER, radius=0.1, speed=0.0))
    )
    fed = sampled(path, [Motion.FEED])
    np.testing.assert_allclose([fed.min(), fed.max()], [-0.1, 50.1], atol=1e-12)


@pytest.mark.parametrize("corner", ["B", "C", "D"])
def test_deflection_is_compensated_with_every_corner_type(corner: str) -> None:
    # Deflected by δ, the disc must touch each side of the square: δx at sides along Y.
    operation = contour((0, 0), (80, 0), (80, 80), (0, 80), corner=corner, deflection=(0.08, 0.05))
    fed = sampled(compensate(operation), [Motion.FEED])
    np.testing.assert_allclose(
        [fed[:, 0].min(), fed[:, 0].max(), fed[:, 1].min(), fed[:, 1].max()],
        [-2.92, 82.92, -2.95, 82.95],
        atol=1e-9,
    )
    path = compensate(operation)
    row = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[row[1:], :2], path.pose[row[:-1] + 1, :2], atol=1e-9)


def test_a_planned_blank_with_a_hole_and_a_slit_is_milled() -> None:
    line = dieline(
        (LineType.CUT, closed((0, 0), (200, 0), (200, 100), (0, 100))),
        (LineType.CUT, closed((20, 20), (60, 20), (60, 60), (20, 60))),
        (LineType.CUT, edges(((100, 50), (150, 50)))),
    )
    slit, hole, blank = (compensate(operation) for operation in plan(line, ROUTED, BOARD))
    assert set(sampled(slit)[:, 1]) == {50.0}
    inner, outer = sampled(hole), sampled(blank)
    np.testing.assert_allclose([inner.min(), inner.max()], [23.0, 57.0])
    np.testing.assert_allclose([outer[:, 0].min(), outer[:, 0].max()], [-3.0, 203.0])


@pytest.mark.parametrize("corner", ["B", "C", "D"])
@pytest.mark.parametrize("passes", [1, 3])
def test_a_bridge_has_the_required_width_between_the_discs(corner: str, passes: int) -> None:
    square = contour(
        (0, 0), (0, 100), (100, 100), (100, 0), side=1, corner=corner,
        bridges=[[1, 30.0, 0.8], [3, 60.0, 0.8]],
        depth=np.tile(np.linspace(2.3 / passes, 2.3, passes), (4, 1)),
    )  # fmt: skip
    path = radius_toolpath(square)
    # There are no leads: the tool plunges on its path, once for each piece and pass.
    assert not np.isin(path.motion, (Motion.LEAD_IN, Motion.LEAD_OUT)).any()
    assert (path.motion == Motion.PLUNGE).sum() == 2 * passes
    points = sampled(path)
    # 30 along the upper side from (0, 100), and 60 along the lower one from (100, 0).
    for middle in ([30.0, 103.0], [40.0, -3.0]):
        apart = np.hypot(*(points - middle).T)
        assert apart.min() == pytest.approx(3.0 + 0.4, abs=1e-9)
    np.testing.assert_allclose(distance(points, square.paths).min(), 3.0)


def test_a_bridge_that_the_cutter_cannot_reach_is_refused() -> None:
    # A slot 4 mm wide and 40 mm deep, which a disc of 6 mm cannot enter.
    slotted = contour(
        (0, 0), (0, 100), (48, 100), (48, 60), (52, 60), (52, 100), (100, 100), (100, 0),
        side=1, bridges=[[1, 20.0, 0.8], [2, 35.0, 0.8]],
    )  # fmt: skip
    with pytest.raises(
        CompensationError,
        match=r"contour at edge 2, 35\.0 mm from the start of this edge in the direction "
        r"of milling, but the cutter does not reach",
    ):
        radius_toolpath(slotted)
