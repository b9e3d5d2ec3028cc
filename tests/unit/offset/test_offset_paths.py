"""Offsets, compared with paths computed by hand and with shapely, which flattens arcs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import CompensationError, GeometryError, ZeroLengthEdge
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.path import Paths, reverse_paths, select_paths
from knifetip.offset.clearance import DISTANCE_TOLERANCE
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from knifetip.offset.transition import Corner
from tests.support.examples import examples
from tests.support.shapes import paths as paths_of
from tests.support.shapes import rotation

SQUARE = [(0, 0), (100, 0), (100, 60), (0, 60)]
#: Two chambers of 40 × 60 with an opening of 10 between them.
DUMBBELL = [
    (0, 0), (40, 0), (40, 25), (60, 25), (60, 0), (100, 0),
    (100, 60), (60, 60), (60, 35), (40, 35), (40, 60), (0, 60),
]  # fmt: skip


def rings(
    *contours: Sequence[tuple[float, float]] | F64, bulge: Sequence[float] | None = None
) -> Paths:
    """Return closed paths through lists of corners."""
    corners = [np.array(contour, float) for contour in contours]
    start = np.concatenate(corners)
    end = np.concatenate([np.roll(contour, -1, axis=0) for contour in corners])
    first = np.concatenate([[0], np.cumsum([len(contour) for contour in corners])])
    return paths_of(start, end, np.zeros(len(start)) if bulge is None else bulge, first)


def strip(*corners: tuple[float, float], bulge: Sequence[float] | None = None) -> Paths:
    """Return one open path through some corners, with arcs where ``bulge`` is not zero."""
    xy = np.array(corners, float)
    bent = np.zeros(len(xy) - 1) if bulge is None else np.array(bulge, float)
    return paths_of(xy[:-1], xy[1:], bent, [0, len(bent)])


def stars(count: int, corners: int, seed: int, arcs: bool = False) -> Paths:
    """Return star-shaped contours with spikes and notches, many of them too narrow for a tool."""
    random = np.random.default_rng(seed)
    angle = 2.0 * np.pi * (np.arange(corners) + random.uniform(-0.4, 0.4, (count, corners)))
    angle /= corners
    away = random.uniform(10.0, 50.0, (count, corners))
    xy = np.stack([np.cos(angle) * away, np.sin(angle) * away], axis=-1)
    bulge = np.zeros((count, corners))
    if arcs:
        bulge = np.where(
            random.random(bulge.shape) < 0.5, random.uniform(-0.4, 0.4, bulge.shape), 0
        )
    return paths_of(
        xy.reshape(-1, 2),
        np.roll(xy, -1, axis=1).reshape(-1, 2),
        bulge.reshape(-1),
        np.arange(count + 1) * corners,
    )


def simple(paths: Paths) -> Paths:
    """Return the paths that do not cross themselves, not even slightly at a sharp corner."""
    good = []
    for low, high in zip(paths.first[:-1], paths.first[1:], strict=True):
        one, two = np.triu_indices(high - low, 1)
        start, end, bulge = paths.start[low:high], paths.end[low:high], paths.bulge[low:high]
        found = intersect_pairs(start[one], end[one], bulge[one], start[two], end[two], bulge[two])
        neighbours = (two - one == 1) | (two - one == high - low - 1)
        good.append((found.count == neighbours).all())
    return select_paths(paths, np.flatnonzero(good).astype(np.int32))[0]


def flattened(paths: Paths, pieces: int) -> list[F64]:
    """Return the corners of each path with its arcs as chords."""
    points = arc.points_along(paths.start, paths.end, paths.bulge, pieces + 1)
    return [
        np.concatenate([points[i, :-1] if paths.bulge[i] else points[i, :1] for i in range(*pair)])
        for pair in zip(paths.first[:-1], paths.first[1:], strict=True)
    ]


def areas(paths: Paths) -> F64:
    """Return the signed areas inside closed paths, arcs exactly."""
    sweep = arc.sweep(paths.bulge)
    radius = np.where(paths.bulge != 0.0, arc.radius(paths.start, paths.end, paths.bulge), 0.0)
    under = paths.start[:, 0] * paths.end[:, 1] - paths.start[:, 1] * paths.end[:, 0]
    under = under + radius**2 * (sweep - np.sin(sweep))
    return np.bincount(paths.path_of, 0.5 * under, minlength=len(paths)).astype(np.float64)


def made_area(made: OffsetPaths, count: int) -> F64:
    """Return the signed area inside all results of each input path."""
    return np.bincount(made.owner, areas(made.paths), minlength=count).astype(np.float64)


def clearance(made: OffsetPaths, paths: Paths, pieces: int = 16) -> float:
    """Return the least distance from points of the results to the path that they belong to."""
    least = np.inf
    points = arc.points_along(made.paths.start, made.paths.end, made.paths.bulge, pieces + 1)
    owner = made.owner[made.paths.path_of]
    for path in np.unique(owner):
        xy = points[owner == path].reshape(-1, 2)
        for i in range(paths.first[path], paths.first[path + 1]):
            a, b, bulge = paths.start[i], paths.end[i], paths.bulge[i]
            chord = b - a
            share = np.clip((xy - a) @ chord / (chord @ chord), 0.0, 1.0)
            away = np.hypot(*(xy - a - share[:, None] * chord).T)
            if bulge:
                one = (a[None], b[None], bulge[None])
                middle, radius = arc.centre(*one)[0], arc.radius(*one)[0]
                top = arc.point_at(*one, np.array([0.5]))[0] - middle
                ray = xy - middle
                size = np.maximum(np.hypot(*ray.T), 1e-12)
                inside = ray @ top / (size * radius) >= np.cos(2.0 * np.arctan(abs(bulge)))
                ends = np.minimum(np.hypot(*(xy - a).T), np.hypot(*(xy - b).T))
                away = np.where(inside, np.abs(size - radius), ends)
            least = min(least, away.min())
    return least


def region(paths: Paths) -> Any:
    """Return the area that closed paths enclose, as a shapely geometry without holes."""
    found = shapely.Polygon()
    for ring in flattened(paths, 64):
        found = found.symmetric_difference(shapely.Polygon(ring).buffer(0.0))
    return found


def tight(made: OffsetPaths) -> bool:
    """Return whether every result path is connected and has no tiny segments."""
    paths = made.paths
    chord = np.hypot(*(paths.end - paths.start).T)
    joined = np.ones(len(chord), bool)
    joined[:-1] = (paths.end[:-1] == paths.start[1:]).all(axis=1)
    joined[paths.first[1:] - 1] = True
    return bool(joined.all() and (chord >= 1e-6).all())


# Compared with paths computed by hand.


def test_inside_a_rectangle_the_path_is_a_smaller_rectangle() -> None:
    made = offset_paths(rings(SQUARE), 5.0, 1)
    np.testing.assert_allclose(made.paths.start, [[5, 5], [95, 5], [95, 55], [5, 55]])
    assert made.source.tolist() == [0, 1, 2, 3]
    assert not made.inserted.any()
    # A disc leaves r² (1 - π/4) in each corner.
    assert made.unreached[0] == pytest.approx(4.0 * 25.0 * (1.0 - np.pi / 4.0))


@pytest.mark.parametrize(
    ("kind", "length", "inserted"),
    [(Corner.B, 10.0 * np.pi, 4), (Corner.C, 40.0, 8), (Corner.D, 10.0 * np.pi / 2 + 20.0, 12)],
)
def test_outside_a_rectangle_each_type_has_its_own_transition(
    kind: Corner, length: float, inserted: int
) -> None:
    made = offset_paths(rings(SQUARE), 5.0, -1, corner=kind, k=0.5)
    assert made.paths.closed.all()
    assert made.paths.lengths[0] == pytest.approx(320.0 + length)
    assert made.inserted.sum() == inserted
    assert made.unreached[0] == 0.0
    # A transition has the segment after its corner as its source.
    assert made.source[made.inserted].tolist() == np.repeat(np.arange(4), inserted // 4).tolist()


def test_each_corner_may_have_its_own_type() -> None:
    made = offset_paths(rings(SQUARE), 5.0, -1, corner=[0, 1, 2, 0], k=0.5)
    assert np.bincount(made.source[made.inserted]).tolist() == [1, 2, 3, 1]


def test_the_offset_of_a_circle_is_a_circle() -> None:
    circle = rings([(10, 0), (-10, 0)], bulge=[1.0, 1.0])
    for side, radius in ((1, 7.0), (-1, 13.0)):
        made = offset_paths(circle, 3.0, side)
        np.testing.assert_allclose(
            arc.radius(made.paths.start, made.paths.end, made.paths.bulge), radius
        )
        np.testing.assert_array_equal(made.paths.bulge, [1.0, 1.0])


def test_a_circle_with_the_radius_of_the_tool_has_no_offset_inside() -> None:
    circle = rings([(10, 0), (-10, 0)], bulge=[1.0, 1.0])
    made = offset_paths(circle, 12.0, 1)
    assert len(made.paths) == 0
    assert made.unreached[0] == pytest.approx(100.0 * np.pi)


def test_smooth_joints_need_no_transition() -> None:
    # A slot of two lines and two half circles.
    slot = rings([(0, 0), (50, 0), (50, 20), (0, 20)], bulge=[0.0, 1.0, 0.0, 1.0])
    for side in (1, -1):
        made = offset_paths(slot, 4.0, side)
        assert made.source.tolist() == [0, 1, 2, 3]
        np.testing.assert_allclose(made.paths.bulge, [0, 1, 0, 1], atol=1e-12)
        assert made.unreached[0] == pytest.approx(0.0, abs=1e-9)


def test_an_opening_too_narrow_gives_two_paths() -> None:
    made = offset_paths(rings(DUMBBELL), 7.0, 1)
    assert made.owner.tolist() == [0, 0]
    assert made.paths.closed.all()
    shape = shapely.Polygon(DUMBBELL)
    assert areas(made.paths).sum() == pytest.approx(
        shape.buffer(-7.0, quad_segs=200).area, rel=1e-5
    )
    swept = shape.buffer(-7.0, quad_segs=200).buffer(7.0, quad_segs=200)
    assert made.unreached[0] == pytest.approx(shape.area - swept.area, abs=0.02)


def test_an_opening_wide_enough_gives_one_path() -> None:
    assert len(offset_paths(rings(DUMBBELL), 4.9, 1).paths) == 1
    assert len(offset_paths(rings(DUMBBELL), 5.1, 1).paths) == 2


def test_a_pocket_too_small_has_no_offset() -> None:
    made = offset_paths(rings(SQUARE), 30.5, 1)
    assert len(made.paths) == 0
    assert len(made.source) == 0
    assert made.unreached[0] == pytest.approx(6000.0)


def test_a_horseshoe_whose_mouth_is_too_narrow_gives_a_path_inside() -> None:
    shoe = rings(
        [
            (0, 0),
            (60, 0),
            (60, 60),
            (33, 60),
            (33, 50),
            (50, 50),
            (50, 10),
            (10, 10),
            (10, 50),
            (27, 50),
            (27, 60),
            (0, 60),
        ]
    )
    made = offset_paths(shoe, 5.0, -1)
    assert len(made.paths) == 2
    assert clearance(made, shoe) >= 5.0 - DISTANCE_TOLERANCE
    outer, inner = areas(made.paths)
    assert outer > 0.0 > inner
    # Inside, 40 × 40 less 5 on each side, and the corners of the mouth keep their distance.
    assert -inner == pytest.approx(900.0, abs=3.0)


def test_the_tool_keeps_clear_of_an_island() -> None:
    outline = rings(SQUARE, [(45, 25), (45, 35), (55, 35), (55, 25)])
    apart = offset_paths(outline, 5.0, 1, group=[0, 0])
    assert len(apart.paths) == 2
    assert apart.paths.lengths.sum() == pytest.approx(280.0 + 40.0 + 10.0 * np.pi)
    # The tool is too wide to pass above and below the island, so the left and the right remain.
    made = offset_paths(outline, 14.0, 1, group=[0, 0])
    assert len(made.paths) == 2
    want = shapely.Polygon(SQUARE, [[(45, 25), (45, 35), (55, 35), (55, 25)]])
    inside = want.buffer(-14.0, quad_segs=200)
    assert areas(made.paths).sum() == pytest.approx(inside.area, rel=1e-5)
    swept = inside.buffer(14.0, quad_segs=200)
    assert made.unreached.sum() == pytest.approx(want.area - swept.area, abs=0.1)
    # As groups of their own, they do not affect each other.
    assert offset_paths(outline, 14.0, 1).owner.tolist() == [0, 1]


@pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6, 1e-3, -1e-9, -1e-6, -1e-4])
@pytest.mark.parametrize("kind", [Corner.B, Corner.C, Corner.D])
def test_the_tool_keeps_clear_of_parts_that_touch_on_their_curves(gap: float, kind: Corner) -> None:
    # Two curved ends of one part touch two curved ends of the other; between them is a lens.
    rise = 6.0
    low = [(0, -60), (100, -60), (100, -rise), (50, -rise), (0, -rise)]
    high = [(0, rise + gap), (50, rise + gap), (100, rise + gap), (100, 60), (0, 60)]
    bent = rise / 25.0
    parts = rings(low, high, bulge=[0, 0, bent, bent, 0, bent, bent, 0, 0, 0])
    made = offset_paths(parts, 0.1, -1, corner=kind, group=[0, 0])
    for part in range(2):
        other = replace(made, owner=np.full_like(made.owner, part))
        assert clearance(other, parts, 101) >= 0.1 - DISTANCE_TOLERANCE
    outside, inside = sorted(areas(made.paths), key=abs, reverse=True)
    assert (outside > 0.0, inside > 0.0) == (True, False)


@pytest.mark.parametrize("kind", [Corner.B, Corner.C, Corner.D])
@pytest.mark.parametrize("overlap", [0.0, 1e-9, 1e-6])
def test_the_tool_keeps_clear_of_a_part_that_touches_with_a_corner(
    kind: Corner, overlap: float
) -> None:
    parts = rings(SQUARE, [(50, 60 - overlap), (70, 80), (50, 100), (30, 80)])
    made = offset_paths(parts, 2.0, -1, corner=kind, group=[0, 0])
    for part in range(2):
        other = replace(made, owner=np.full_like(made.owner, part))
        assert clearance(other, parts, 101) >= 2.0 - DISTANCE_TOLERANCE
    assert len(made.paths) == 1


def test_a_pocket_filled_by_an_island_has_no_offset() -> None:
    outline = rings(SQUARE, [(10, 10), (10, 50), (90, 50), (90, 10)])
    assert len(offset_paths(outline, 6.0, 1, group=[0, 0]).paths) == 0


# Open paths.


@pytest.mark.parametrize(("side", "y"), [(1, 3.0), (-1, -3.0)])
def test_the_offset_of_a_line_is_a_parallel_line(side: int, y: float) -> None:
    made = offset_paths(strip((0, 0), (10, 0)), 3.0, side)
    np.testing.assert_allclose(made.paths.start, [[0, y]], atol=1e-12)
    np.testing.assert_allclose(made.paths.end, [[10, y]], atol=1e-12)


def test_an_open_angle_is_shortened_inside_and_rounded_outside() -> None:
    angle = strip((0, 0), (20, 0), (20, 20))
    inside = offset_paths(angle, 3.0, 1)
    np.testing.assert_allclose(inside.paths.end, [[17, 3], [17, 20]])
    assert inside.unreached[0] == pytest.approx(9.0 * (1.0 - np.pi / 4.0))
    outside = offset_paths(angle, 3.0, -1)
    assert outside.inserted.tolist() == [False, True, False]
    assert outside.paths.lengths[0] == pytest.approx(40.0 + 1.5 * np.pi)


def test_an_open_path_keeps_clear_of_its_own_ends_and_back() -> None:
    # A hook that returns to 6 mm from its start.
    hook = strip((0, 0), (40, 0), (40, 30), (20, 30), (20, 6))
    for side in (1, -1):
        made = offset_paths(hook, 8.0, side)
        assert clearance(made, hook) >= 8.0 - DISTANCE_TOLERANCE
        assert tight(made)
        assert not made.paths.closed[0]
        # On its left, the hook encloses a pocket.
        assert len(made.paths) == (2 if side == 1 else 1)


# Compared with shapely.


@pytest.mark.parametrize(
    ("side", "radius"), [(1, 0.5), (1, 3.0), (1, 9.0), (-1, 0.5), (-1, 4.0), (-1, 30.0)]
)
def test_offsets_of_a_thousand_stars_enclose_the_areas_of_shapely(side: int, radius: float) -> None:
    paths = stars(1000, 17, seed=int(radius * 2) + side)
    made = offset_paths(paths, radius, side)
    shapes = shapely.polygons(paths.start.reshape(1000, 17, 2))
    want = shapely.buffer(shapes, -side * radius, quad_segs=90)
    have = made_area(made, 1000)
    # Chords of 1° lose r²·(1° - sin 1°)/2 to each degree.
    flat = 1e-4 * radius * (radius + shapely.length(want))
    assert (np.abs(have - shapely.area(want)) <= flat + 1e-6).all()
    back = shapely.area(shapely.buffer(want, side * radius, quad_segs=90))
    lost = side * (shapely.area(shapes) - back)
    assert (np.abs(made.unreached - lost) <= 2.0 * flat + 0.02).all()
    assert made.paths.closed.all()
    assert tight(made)
    ring = shapely.get_exterior_ring(shapes)
    points = arc.points_along(made.paths.start, made.paths.end, made.paths.bulge, 9)
    own = np.repeat(ring[made.owner[made.paths.path_of]], 9)
    assert shapely.distance(own, shapely.points(points.reshape(-1, 2))).min() >= radius - 1e-9
    # Arcs are not split: there are at most as many as corners, and no tiny ones.
    most = np.bincount(made.owner[made.paths.path_of], made.paths.bulge != 0.0, minlength=1000)
    assert most.max() <= 2 * 17


@pytest.mark.parametrize("seed", range(4))
def test_hausdorff_distance_to_shapely_is_the_error_of_its_chords(seed: int) -> None:
    paths = stars(60, 14, seed)
    for side, radius in ((1, 4.0), (-1, 8.0)):
        made = offset_paths(paths, radius, side)
        for path in range(60):
            corners = paths.start[path * 14 : path * 14 + 14]
            want = shapely.Polygon(corners).buffer(-side * radius, quad_segs=90)
            mine = np.flatnonzero(made.owner == path)
            lines = (
                [
                    shapely.LinearRing(ring)
                    for i, ring in enumerate(flattened(made.paths, 60))
                    if i in mine
                ]
                if len(mine)
                else []
            )
            if not lines:
                assert want.area < 1e-3
                continue
            off = shapely.hausdorff_distance(shapely.MultiLineString(lines), want.boundary)
            assert off < 2e-3 * radius


@examples(60)
@given(seed=st.integers(0, 10_000), radius=st.floats(0.2, 20.0), side=st.sampled_from([1, -1]))
def test_offsets_of_contours_with_arcs_enclose_the_areas_of_shapely(
    seed: int, radius: float, side: int
) -> None:
    paths = simple(stars(1, 12, seed, arcs=True))
    if len(paths) == 0:
        return
    shape = shapely.Polygon(flattened(paths, 64)[0])
    if not shape.is_valid:
        return
    # GEOS is wrong by millimetres on long concave runs of chords, unless all are short.
    shape = shape.segmentize(0.25)
    made = offset_paths(paths, radius, side)
    want = shape.buffer(-side * radius, quad_segs=64)
    slack = 3e-3 * (want.length + 1.0)
    assert made_area(made, 1)[0] == pytest.approx(want.area, abs=slack)
    lost = side * (shape.area - want.buffer(side * radius, quad_segs=64).area)
    assert made.unreached[0] == pytest.approx(lost, abs=2.0 * slack + 0.1)
    assert clearance(made, paths) >= radius - 1e-9
    assert made.paths.closed.all()
    assert tight(made)


@examples(40)
@given(seed=st.integers(0, 10_000), radius=st.floats(0.5, 12.0))
def test_pockets_with_islands_enclose_the_areas_of_shapely(seed: int, radius: float) -> None:
    random = np.random.default_rng(seed)
    outer = stars(1, 12, seed).start * 3.0
    holes = [
        stars(1, 5, seed + 1 + i).start[::-1] * 0.25 + random.uniform(-25, 25, 2) for i in range(3)
    ]
    shape = shapely.Polygon(outer)
    kept = []
    for hole in holes:
        if shape.contains(shapely.Polygon(hole)):
            shape = shape.difference(shapely.Polygon(hole))
            kept.append(hole)
    if shape.geom_type != "Polygon" or len(shape.interiors) != len(kept):
        return
    paths = rings(outer, *kept)
    made = offset_paths(paths, radius, 1, group=np.zeros(len(paths)))
    want = shape.buffer(-radius, quad_segs=90)
    assert areas(made.paths).sum() == pytest.approx(
        want.area, abs=1e-4 * radius * want.length + 1e-3
    )
    assert (
        region(made.paths).symmetric_difference(want).area < 0.01 * radius * (1 + want.length) * 0.1
    )
    lost = shape.area - want.buffer(radius, quad_segs=90).area
    assert made.unreached.sum() == pytest.approx(lost, abs=2e-4 * radius * want.length + 0.1)


# Properties of every engine.


def described(made: OffsetPaths) -> tuple[float, float, float, int, int]:
    """Return figures that do not change when the board is rotated."""
    size = np.bincount(made.owner, areas(made.paths), minlength=len(made.unreached))
    arcs = int((made.paths.bulge != 0.0).sum())
    return abs(size[0]), made.paths.lengths.sum(), made.unreached[0], arcs, len(made.paths)


def alike(
    one: tuple[float, float, float, float, float], other: tuple[float, float, float, float, float]
) -> None:
    assert one[:3] == pytest.approx(other[:3], rel=1e-6, abs=1e-5)
    assert one[3:] == other[3:]


@examples(150)
@given(
    seed=st.integers(0, 10_000),
    radius=st.floats(0.1, 15.0),
    side=st.sampled_from([1, -1]),
    kind=st.sampled_from(Corner),
    turn=st.floats(-180.0, 180.0),
    shift=st.integers(1, 10),
)
def test_rotation_mirroring_direction_and_start_do_not_change_the_offset(
    seed: int, radius: float, side: int, kind: Corner, turn: float, shift: int
) -> None:
    paths = simple(stars(1, 11, seed, arcs=True))
    if len(paths) == 0:
        return
    plain = described(offset_paths(paths, radius, side, corner=kind))
    spin = rotation(turn).T
    turned = Paths(paths.start @ spin, paths.end @ spin, paths.bulge, paths.first)
    alike(described(offset_paths(turned, radius, side, corner=kind)), plain)
    flip = np.array([-1.0, 1.0])
    mirrored = Paths(paths.start * flip, paths.end * flip, -paths.bulge, paths.first)
    alike(described(offset_paths(mirrored, radius, -side, corner=kind)), plain)
    back, _ = reverse_paths(paths, np.array([True]))
    alike(described(offset_paths(back, radius, -side, corner=kind)), plain)
    rows = np.roll(np.arange(11), shift)
    begun = Paths(paths.start[rows], paths.end[rows], paths.bulge[rows], paths.first)
    alike(described(offset_paths(begun, radius, side, corner=kind)), plain)


@examples(150)
@given(
    seed=st.integers(0, 10_000),
    radius=st.floats(0.1, 15.0),
    side=st.sampled_from([1, -1]),
    k=st.floats(0.0, 1.0),
)
def test_types_c_and_d_keep_the_distance_and_are_never_shorter_than_b(
    seed: int, radius: float, side: int, k: float
) -> None:
    paths = simple(stars(1, 13, seed, arcs=True))
    if len(paths) == 0:
        return
    for kind in (Corner.C, Corner.D):
        made = offset_paths(paths, radius, side, corner=kind, k=k)
        assert clearance(made, paths) >= radius - 1e-9
        assert made.paths.closed.all()
        assert tight(made)


def test_a_batch_gives_the_same_offsets_as_single_calls() -> None:
    paths = simple(stars(120, 12, 5, arcs=True))
    count = len(paths)
    assert count > 20
    radius = np.linspace(0.5, 9.0, count)
    side = np.where(np.arange(count) % 3, 1, -1)
    made = offset_paths(paths, radius, side)
    at = 0
    for path in range(count):
        rows = slice(12 * path, 12 * path + 12)
        alone = offset_paths(
            paths_of(paths.start[rows], paths.end[rows], paths.bulge[rows], [0, 12]),
            radius[path],
            side[path],
        )
        until = at + len(alone.source)
        np.testing.assert_array_equal(made.paths.start[at:until], alone.paths.start)
        np.testing.assert_array_equal(made.source[at:until], alone.source + 12 * path)
        assert made.unreached[path] == alone.unreached[0]
        at = until
    assert at == len(made.source)


def test_a_radius_of_zero_returns_the_paths() -> None:
    paths = stars(5, 9, 2, arcs=True)
    made = offset_paths(paths, 0.0, 1)
    np.testing.assert_array_equal(made.paths.start, paths.start)
    np.testing.assert_array_equal(made.paths.bulge, paths.bulge)
    np.testing.assert_array_equal(made.paths.first, paths.first)
    assert made.unreached.tolist() == [0.0] * 5


@pytest.mark.parametrize("radius", [1e-5, 1e-3, 1e3, 1e5])
def test_tiny_and_huge_tools(radius: float) -> None:
    made = offset_paths(rings(SQUARE), radius, -1)
    assert areas(made.paths)[0] == pytest.approx(6000.0 + 320.0 * radius + np.pi * radius**2)
    inside = offset_paths(rings(SQUARE), radius, 1)
    assert len(inside.paths) == (radius < 30.0)


def test_no_paths_give_none() -> None:
    nothing = paths_of(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), [0])
    made = offset_paths(nothing, 1.0, 1)
    assert len(made.paths) == 0
    assert len(made.unreached) == 0


def test_a_slit_is_offset_around_both_ends() -> None:
    # The slit is drawn forth and back; the tool goes around both ends.
    made = offset_paths(rings([(0, 0), (40, 0)]), 5.0, -1)
    assert areas(made.paths)[0] == pytest.approx(400.0 + 25.0 * np.pi)
    assert (made.paths.bulge != 0.0).sum() == 2


def test_twenty_thousand_segments_with_notches() -> None:
    paths = stars(1, 20_000, 3)
    ring = paths.start / np.hypot(*paths.start.T)[:, None] * 1000.0 + paths.start * 0.02
    made = offset_paths(rings(ring), 1.0, -1)
    want = shapely.Polygon(ring).buffer(1.0, quad_segs=90)
    assert made.paths.closed.all()
    assert areas(made.paths).sum() == pytest.approx(want.area, rel=1e-6)


# Errors.


def test_refuse_names_the_segments_and_the_depth() -> None:
    with pytest.raises(CompensationError, match="would cut") as caught:
        offset_paths(rings(SQUARE, DUMBBELL), 7.0, 1, interference="refuse")
    assert len(caught.value.edges) == 2
    assert set(caught.value.edges) <= set(range(4, 16))


def test_refuse_names_the_missing_radius_of_an_arc() -> None:
    circle = rings([(10, 0), (-10, 0)], bulge=[1.0, 1.0])
    with pytest.raises(CompensationError, match="cut 2 mm into"):
        offset_paths(circle, 12.0, 1, interference="refuse")


def test_refuse_accepts_contours_that_the_tool_fits() -> None:
    paths = rings(SQUARE, DUMBBELL)
    for side in (1, -1):
        assert len(offset_paths(paths, 4.0, side, interference="refuse").paths) == 2


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_coordinate_that_is_not_finite_is_refused(value: float) -> None:
    start = np.array(SQUARE, float)
    end = np.roll(start, -1, axis=0)
    start[2, 1] = value
    with pytest.raises(GeometryError, match="Segment 2 of the path has a coordinate"):
        offset_paths(paths_of(start, end, np.zeros(4), [0, 4]), 1.0, 1)


def test_a_segment_without_length_is_refused() -> None:
    with pytest.raises(ZeroLengthEdge, match="direction: edge 2\\."):
        offset_paths(rings([(0, 0), (10, 0), (10, 10), (10, 10), (0, 10)]), 1.0, 1)


@pytest.mark.parametrize(
    ("given_", "words"),
    [
        ({"distance": np.nan}, "distance"),
        ({"distance": -1.0}, "distance"),
        ({"side": 0}, "must be .1 .left. or -1"),
        ({"interference": "ignore"}, "'ignore'"),
        ({"corner": 7}, "type 7"),
        ({"corner": Corner.D, "k": np.nan}, "k = nan"),
    ],
)
def test_invalid_arguments_are_refused(given_: dict[str, Any], words: str) -> None:
    with pytest.raises((GeometryError, CompensationError), match=words):
        offset_paths(rings(SQUARE), **({"distance": 1.0, "side": 1} | given_))


def test_a_group_has_one_tool_on_one_side() -> None:
    with pytest.raises(GeometryError, match="Path 1 has a different"):
        offset_paths(rings(SQUARE, DUMBBELL), 1.0, [1, -1], group=[0, 0])
