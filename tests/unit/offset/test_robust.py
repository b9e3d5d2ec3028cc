"""Offsets of imprecise drawings: rounded, nearly touching, crossing by micrometres."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from knifetip.offset.transition import Corner
from tests.support.examples import examples
from tests.support.shapes import paths as paths_of


def ring(corners: F64 | Sequence[tuple[float, float]]) -> Paths:
    xy = np.array(corners, float)
    return paths_of(xy, np.roll(xy, -1, axis=0), np.zeros(len(xy)), [0, len(xy)])


def points(made: OffsetPaths) -> NDArray[Any]:
    paths = made.paths
    along = arc.points_along(paths.start, paths.end, paths.bulge, 9)
    found: NDArray[Any] = shapely.points(along.reshape(-1, 2))
    return found


@examples(100)
@given(
    seed=st.integers(0, 10_000),
    jitter=st.sampled_from([1e-3, 1e-4, 1e-5, 1e-6]),
    radius=st.floats(0.3, 8.0),
    side=st.sampled_from([1, -1]),
)
def test_edges_split_and_rounded_give_the_same_offset(
    seed: int, jitter: float, radius: float, side: int
) -> None:
    random = np.random.default_rng(seed)
    angle = 2.0 * np.pi * (np.arange(9) + random.uniform(-0.3, 0.3, 9)) / 9
    corners = np.stack([np.cos(angle), np.sin(angle)], axis=1) * random.uniform(15, 50, (9, 1))
    share = np.arange(5)[None, :, None] / 5.0
    after = np.roll(corners, -1, axis=0)
    pieces = (corners[:, None] + share * (after - corners)[:, None]).reshape(-1, 2)
    pieces += random.uniform(-jitter, jitter, pieces.shape)
    made = offset_paths(ring(pieces), radius, side)
    want = shapely.Polygon(pieces).buffer(-side * radius, quad_segs=90)
    under = made.paths.start[:, 0] * made.paths.end[:, 1]
    under -= made.paths.start[:, 1] * made.paths.end[:, 0]
    sweep = arc.sweep(made.paths.bulge)
    bent = made.paths.bulge != 0.0
    size = np.where(bent, arc.radius(made.paths.start, made.paths.end, made.paths.bulge), 0.0)
    area = 0.5 * (under + size**2 * (sweep - np.sin(sweep))).sum()
    assert area == pytest.approx(want.area, abs=1e-4 * radius * (radius + want.length) + 1e-3)
    if len(made.paths):
        away = shapely.distance(shapely.LinearRing(pieces), points(made))
        assert away.min() >= radius - 1e-9


@pytest.mark.parametrize("over", [1e-4, 1e-5, 2e-6])
def test_walls_that_cross_by_micrometres_are_refused_with_their_position(over: float) -> None:
    # A notch in the upper edge whose walls cross halfway down.
    contour = [(0, 0), (100, 0), (100, 60), (50 + over, 60), (50 - over, 30), (50 + over, 30),
               (50 - over, 60), (0, 60)]  # fmt: skip
    with pytest.raises(CompensationError, match="touches itself at") as caught:
        offset_paths(ring(contour), 3.0, 1)
    assert caught.value.edges == (3, 5)
    x, y = map(float, re.findall(r"\((-?[\d.]+), (-?[\d.]+)\)", str(caught.value))[0])
    assert (x, y) == pytest.approx((50.0, 45.0), abs=1e-3)


@pytest.mark.parametrize("apart", [1e-4, 1e-5, 2e-6])
@pytest.mark.parametrize("side", [1, -1])
def test_a_slit_of_micrometres_is_offset_inside_and_ignored_outside(
    apart: float, side: int
) -> None:
    contour = [(0, 0), (100, 0), (100, 60), (50 + apart, 60), (50, 30), (50 - apart, 60), (0, 60)]
    made = offset_paths(ring(contour), 3.0, side)
    assert shapely.distance(shapely.LinearRing(contour), points(made)).min() >= 3.0 - 1e-9
    assert made.paths.closed.all()
    # Inside, the offset goes around the slit's end; outside, the slit has no effect.
    assert made.paths.lengths.sum() == pytest.approx(
        296.0 + 60.0 - 6.0 + 3.0 * np.pi - 6.0 if side == 1 else 320.0 + 6.0 * np.pi, abs=0.01
    )


@pytest.mark.parametrize("radius", [1.0, 4.0, 9.0])
def test_two_islands_of_a_pocket_may_touch_in_a_point(radius: float) -> None:
    outline = [(0, 0), (100, 0), (100, 60), (0, 60)]
    left = [(40, 20), (30, 30), (40, 40), (50, 30)]
    right = [(60, 20), (50, 30), (60, 40), (70, 30)]
    xy = np.concatenate([outline, left, right]).astype(float)
    ends = np.concatenate([np.roll(np.array(c, float), -1, axis=0) for c in (outline, left, right)])
    paths = paths_of(xy, ends, np.zeros(12), [0, 4, 8, 12])
    made = offset_paths(paths, radius, 1, group=[0, 0, 0])
    shape = shapely.Polygon(outline).difference(
        shapely.union(shapely.Polygon(left), shapely.Polygon(right))
    )
    assert shapely.distance(shape.boundary, points(made)).min() >= radius - 1e-9
    under = made.paths.start[:, 0] * made.paths.end[:, 1]
    under -= made.paths.start[:, 1] * made.paths.end[:, 0]
    sweep = arc.sweep(made.paths.bulge)
    bent = made.paths.bulge != 0.0
    size = np.where(bent, arc.radius(made.paths.start, made.paths.end, made.paths.bulge), 0.0)
    area = 0.5 * (under + size**2 * (sweep - np.sin(sweep))).sum()
    assert area == pytest.approx(shape.buffer(-radius, quad_segs=90).area, rel=1e-4)


@pytest.mark.parametrize("turn", [0.0, 0.3, 2.0, 4.5])
def test_two_parts_on_the_same_side_of_a_common_corner_have_one_offset(turn: float) -> None:
    """Two triangles meet at the origin, 22.6° apart; round the origin, both have the same arc.

    The outer sides are 11.662, 4 and 10.198 mm long.  Between the triangles the tool of 1 mm comes
    within 5.099 mm, which shortens the inner sides by 5 mm each.  The arcs turn by 118.07° at the
    origin and by 120.96° and 78.69° at the two other corners of each triangle.
    """
    upper = np.array([(0, 0), (10, 2), (10, 6)], float)
    lower = np.array([(0, 0), (10, -6), (10, -2)], float)
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    shapes = [shape @ rotation for shape in (upper, lower)]
    xy, ends = np.concatenate(shapes), np.concatenate([np.roll(one, -1, axis=0) for one in shapes])
    made = offset_paths(paths_of(xy, ends, np.zeros(6), [0, 3, 6]), 1.0, -1, group=[0, 0])
    assert made.paths.closed.tolist() == [True]
    straight = 2.0 * (11.6619 + 4.0 + 10.1980 - 5.0)
    turned = np.radians(118.07 + 2.0 * (120.96 + 78.69))
    assert made.paths.lengths.sum() == pytest.approx(straight + turned, abs=1e-3)
    outlines = shapely.MultiLineString([shapely.LinearRing(one) for one in shapes])
    assert shapely.distance(outlines, points(made)).min() >= 1.0 - 1e-9


@examples(100)
@given(
    seed=st.integers(0, 10_000),
    kind=st.sampled_from([Corner.C, Corner.D]),
    k=st.floats(0.0, 1.0),
    radius=st.floats(0.3, 12.0),
    side=st.sampled_from([1, -1]),
)
def test_open_paths_with_c_and_d_corners_keep_clear_and_start_square(
    seed: int, kind: Corner, k: float, radius: float, side: int
) -> None:
    random = np.random.default_rng(seed)
    xy = np.stack([np.arange(8) * 15.0, random.uniform(-20.0, 20.0, 8)], axis=1)
    made = offset_paths(
        paths_of(xy[:-1], xy[1:], np.zeros(7), [0, 7]), radius, side, corner=kind, k=k
    )
    assert not made.paths.closed.any()
    line = shapely.LineString(xy)
    assert shapely.distance(line, points(made)).min() >= radius - 1e-9
    # An end that is reached is perpendicular to the contour's end.
    for at, chord, mine in (
        (xy[0], xy[1] - xy[0], made.paths.start[0]),
        (xy[-1], xy[-1] - xy[-2], made.paths.end[-1]),
    ):
        normal = side * radius * np.array([-chord[1], chord[0]]) / np.hypot(*chord)
        square = at + normal
        if shapely.distance(line, shapely.Point(square)) >= radius - 1e-9:
            np.testing.assert_allclose(mine, square, atol=1e-6)


@examples(40)
@given(kind=st.sampled_from([Corner.C, Corner.D]), k=st.floats(0, 1), radius=st.floats(0.5, 12.0))
def test_offsets_of_islands_with_c_and_d_corners_are_inside_those_with_b(
    kind: Corner, k: float, radius: float
) -> None:
    outline = [(0, 0), (100, 0), (100, 60), (0, 60)]
    hole = [(40, 20), (30, 30), (60, 42), (70, 25)]
    xy = np.concatenate([outline, hole]).astype(float)
    ends = np.concatenate([np.roll(np.array(c, float), -1, axis=0) for c in (outline, hole)])
    paths = paths_of(xy, ends, np.zeros(8), [0, 4, 8])
    made = offset_paths(paths, radius, 1, corner=kind, k=k, group=[0, 0])
    shape = shapely.Polygon(outline, [hole])
    assert made.paths.closed.all()
    allowed = shape.buffer(-radius, quad_segs=200).buffer(1e-3 * radius)
    assert shapely.covers(allowed, points(made)).all()


def fish_tail(lean: float) -> Paths:
    """Return a contour with a cusp at the origin, behind a crossing of its two segments.

    An arc runs into the cusp at the angle ``lean`` (radians) below the line that leads out of it.
    """
    xy = np.array([(-50.0, 12.0), (0.0, 0.0), (-50.0, 0.0), (-80.0, 6.0)])
    chord = xy[1] - xy[0]
    half = lean - np.arctan2(chord[1], chord[0])
    return paths_of(xy, np.roll(xy, -1, axis=0), [np.tan(half / 2.0), 0.0, 0.0, 0.0], [0, 4])


@pytest.mark.parametrize("kind", list(Corner))
@pytest.mark.parametrize("side", [1, -1])
def test_a_cusp_behind_a_crossing_of_its_segments_is_offset(side: int, kind: Corner) -> None:
    contour = fish_tail(2.5e-4)
    made = offset_paths(contour, 3.0, side, corner=kind)
    line = shapely.LineString(
        arc.points_along(contour.start, contour.end, contour.bulge, 2000).reshape(-1, 2)
    )
    assert made.paths.closed.all()
    assert shapely.distance(line, points(made)).min() >= 3.0 - 1e-4
    assert set(made.source.tolist()) <= {0, 1, 2, 3}
    # Inside, the tool stays before the narrow end; outside, it goes round the cusp.
    reach = shapely.get_x(points(made)).max()
    assert reach < -20.0 if side == -1 else 2.9 < reach < 6.1


def test_a_wide_loop_at_a_cusp_is_refused_and_its_hint_helps() -> None:
    contour = fish_tail(0.02)
    with pytest.raises(CompensationError) as caught:
        offset_paths(contour, 3.0, 1)
    said = caught.value.message
    assert said.code == "offset.cusp"
    assert caught.value.edges == (0, 1)
    size = said.arguments["size"]
    # Trimmed at the crossing, as the hint proposes.
    along = np.linspace(0.0, 1.0, 200_001)
    there = arc.point_at(
        np.repeat(contour.start[:1], len(along), 0),
        np.repeat(contour.end[:1], len(along), 0),
        np.repeat(contour.bulge[:1], len(along)),
        along,
    )
    first = int(np.flatnonzero(there[:, 1] < 0.0)[0])
    assert size == pytest.approx(-there[first, 0], abs=0.01)
    xy = np.array([(-50.0, 12.0), there[first], (-50.0, 0.0), (-80.0, 6.0)])
    bulge = np.tan(np.arctan(contour.bulge[:1]) * along[first])
    trimmed = paths_of(xy, np.roll(xy, -1, axis=0), [*bulge, 0.0, 0.0, 0.0], [0, 4])
    assert len(offset_paths(trimmed, 3.0, 1).paths) == 1


@pytest.mark.parametrize("past", [0.0, 1e-9, 4.5e-7, 1e-5])
@pytest.mark.parametrize("shift", [-0.001, 0.0, 0.0013])
def test_a_round_slot_as_wide_as_the_tool(past: float, shift: float) -> None:
    top = 26.0 + past
    corners = [(0, 0), (100, 0), (100, 20), (60 + shift, 20), (60, top), (100, top), (100, 60)]
    xy = np.array([*corners, (0, 60)])
    bulge = np.array([0, 0, 0, -1.0, 0, 0, 0, 0])
    contour = paths_of(xy, np.roll(xy, -1, axis=0), bulge, [0, len(xy)])
    made = offset_paths(contour, 3.0, -1)
    along = points(made)
    part = shapely.Polygon(arc.points_along(contour.start, contour.end, bulge, 90).reshape(-1, 2))
    assert shapely.distance(part, along).min() > 3.0 - 2e-3
    assert shapely.get_x(along[abs(shapely.get_y(along) - 23.0) < 1e-4]).min() < 61.0


@pytest.mark.parametrize("turn", [3.5e-7, 4e-7, 4.5e-7, 1e-6, 1e-5])
@pytest.mark.parametrize("around", [0.0, 0.3, 1.0, 2.0])
def test_arcs_that_cross_twice_beside_a_flat_corner(turn: float, around: float) -> None:
    # The tool does not fit into the narrow notch, so the path is offset as a region.
    corners, bulge, heading = [np.zeros(2)], [], 0.0
    for radius in (1830.0, 610.0):
        swept = 9.0 / radius
        chord = 2.0 * radius * np.sin(0.5 * swept)
        along = heading - 0.5 * swept
        corners.append(corners[-1] + chord * np.array([np.cos(along), np.sin(along)]))
        bulge.append(-np.tan(0.25 * swept))
        heading += turn - swept
    xy = np.concatenate([corners, [(18, -60), (11, -60), (9, -30), (7, -60), (0, -60)]])
    cosine, sine = np.cos(around), np.sin(around)
    xy = xy @ np.array([[cosine, sine], [-sine, cosine]])
    contour = paths_of(xy, np.roll(xy, -1, axis=0), np.append(bulge, np.zeros(6)), [0, len(xy)])
    assert len(offset_paths(contour, 3.0, 1).paths) == 1


@pytest.mark.parametrize(("radius", "distance"), [(0.3, 0.1), (2.0, 0.1), (2.0, 1.0), (5.0, 3.0)])
def test_a_circle_of_two_arcs_with_a_slight_kink_keeps_its_offset(
    radius: float, distance: float
) -> None:
    ends = np.array([[[radius, 0.0], [-radius, 0.0]], [[-radius, 0.0], [radius, 0.0]]])
    for less in np.geomspace(1e-6, 0.1, 60):
        ring = Paths(ends[:, 0], ends[:, 1], np.full(2, 1.0 - less), np.array([0, 2], np.int32))
        made = offset_paths(ring, distance, 1).paths
        assert len(made) == 1, less
        middle = arc.point_at(ends[:, 0], ends[:, 1], ring.bulge, np.full(2, 0.5))
        moved = arc.point_at(made.start, made.end, made.bulge, np.full(len(made.bulge), 0.5))
        apart = np.hypot(*(middle[:, None] - moved).transpose(2, 0, 1)).min(axis=1)
        assert np.abs(apart - distance).max() < 1e-4
