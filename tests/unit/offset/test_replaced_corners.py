"""Corners of type C and D whose transition meets something become type B."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, U8
from knifetip.geometry.path import Paths
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from knifetip.offset.transition import Corner, transitions
from tests.support.examples import examples
from tests.support.shapes import paths as paths_of


def rings(*contours: Sequence[tuple[float, float]] | F64) -> Paths:
    """Return closed paths of lines through lists of corners."""
    xy = [np.array(contour, float) for contour in contours]
    first = np.concatenate([[0], np.cumsum([len(corners) for corners in xy])])
    ends = np.concatenate([np.roll(corners, -1, axis=0) for corners in xy])
    return paths_of(np.concatenate(xy), ends, np.zeros(len(ends)), first)


def comb(random: np.random.Generator) -> F64:
    """Return the corners of a comb with teeth and slots of random widths and depths, (n, 2) mm."""
    count = int(random.integers(4, 18))
    x = np.concatenate([[0.0], np.cumsum(random.uniform(2.0, 12.0, count))])
    y = np.where(np.arange(count) % 2, 0.0, random.uniform(2.0, 40.0, count))
    lean = random.uniform(-0.9, 0.9, 2 * count)
    top = [(x[(i + 1) // 2] + lean[i], y[i // 2]) for i in range(2 * count)]
    return np.array([*top, (x[-1] + 1.0, -30.0), (-1.0, -30.0)])


def whole_transitions(made: OffsetPaths, paths: Paths, radius: float, side: int, k: float) -> U8:
    """Return for each segment the type of the complete transition at its start in an offset, (n,).

    The type is 255 if there is no transition, or if a part of the transition is missing.
    """
    found = np.full(len(paths.bulge), 255, np.uint8)
    _, leaving = arc.tangents(paths.start, paths.end, paths.bulge)
    ahead, _ = arc.tangents(paths.start, paths.end, paths.bulge)
    before: I32 = np.arange(len(found), dtype=np.int32) - 1
    before[paths.first[:-1]] = paths.first[1:] - 1
    for segment in np.unique(made.source[made.inserted]):
        rows = np.flatnonzero(made.inserted & (made.source == segment))
        for kind in Corner:
            whole = transitions(
                kind,
                leaving[before[segment]][None],
                ahead[segment][None],
                paths.start[segment][None],
                radius,
                side,
                k,
            )
            if len(whole.bulge) != len(rows):
                continue
            middle = [
                arc.point_at(
                    way.start[some], way.end[some], way.bulge[some], np.full(len(rows), 0.5)
                )
                for way, some in ((whole, np.arange(len(rows))), (made.paths, rows))
            ]
            away = np.hypot(*(middle[0][:, None] - middle[1][None]).T).min(axis=0)
            if away.max() < 1e-6:
                found[segment] = kind
                break
    return found


def facing_squares(gap: float) -> Paths:
    """Return two squares whose corners 0 and 4 face each other across a gap (mm)."""
    corners = np.array([(0, 0), (-20, 20), (-40, 0), (-20, -20)], float)
    return rings(corners, np.array([gap, 0.0]) - corners)


@pytest.mark.parametrize(
    ("kind", "reach"),
    [(Corner.C, 5.0 * np.sqrt(2.0)), (Corner.D, 2.5 * np.sqrt(2.0) + 2.5)],
)
def test_two_transitions_that_cross_become_type_b(kind: Corner, reach: float) -> None:
    for gap, replaced in ((2.0 * reach + 0.01, []), (2.0 * reach - 0.01, [0, 4]), (10.01, [0, 4])):
        paths = facing_squares(gap)
        made = offset_paths(paths, 5.0, -1, corner=kind, group=[0, 0])
        assert made.replaced.tolist() == replaced
        assert len(made.paths) == 2
        assert made.paths.closed.all()
        found = whole_transitions(made, paths, 5.0, -1, 0.5)
        want = np.full(8, kind)
        want[replaced] = Corner.B
        assert (found == want).all()


@pytest.mark.parametrize("kind", [Corner.C, Corner.D])
def test_a_corner_that_the_tool_does_not_reach_is_not_reported(kind: Corner) -> None:
    made = offset_paths(facing_squares(2.0), 5.0, -1, corner=kind, group=[0, 0])
    assert made.replaced.tolist() == []
    assert made.paths.closed.all()


@pytest.mark.parametrize("kind", [Corner.C, Corner.D])
def test_a_transition_near_another_contour_becomes_type_b(kind: Corner) -> None:
    # Type B passes the wall with 0.1 mm to spare, types C and D do not.
    corners = [(0, 0), (-20, 20), (-40, 0), (-20, -20)]
    wall = [(10.1, -60), (20, -60), (20, 60), (10.1, 60)]
    made = offset_paths(rings(corners, wall), 5.0, -1, corner=kind, k=0.9, group=[0, 0])
    assert made.replaced.tolist() == [0]
    alone = offset_paths(rings(corners), 5.0, -1, corner=kind, k=0.9)
    assert alone.replaced.tolist() == []


def test_the_requested_types_are_not_changed_in_place() -> None:
    kinds = np.full(8, Corner.C, np.uint8)
    offset_paths(facing_squares(11.0), 5.0, -1, corner=kinds, k=np.full(8, 0.5), group=[0, 0])
    assert (kinds == Corner.C).all()


def test_a_refused_offset_is_checked_as_type_b() -> None:
    made = offset_paths(
        facing_squares(11.0), 5.0, -1, corner=Corner.C, group=[0, 0], interference="refuse"
    )
    assert made.replaced.tolist() == [0, 4]


@examples(200)
@given(
    seed=st.integers(0, 100_000),
    kind=st.sampled_from([Corner.C, Corner.D]),
    k=st.floats(0.02, 0.98),
    radius=st.floats(0.2, 8.0),
    side=st.sampled_from([1, -1]),
)
def test_transitions_in_combs_are_whole_or_become_type_b(
    seed: int, kind: Corner, k: float, radius: float, side: int
) -> None:
    corners = comb(np.random.default_rng(seed))
    shape = shapely.Polygon(corners)
    if not shape.is_valid:
        return
    paths = rings(corners)
    made = offset_paths(paths, radius, side, corner=kind, k=k)
    plain = offset_paths(paths, radius, side)
    assert made.paths.closed.all()
    # The cutter touches whatever it touches with type B, apart from the vertices of corners.
    assert len(made.paths) == len(plain.paths)
    np.testing.assert_allclose(made.unreached, plain.unreached, atol=1e-5)
    lines = [rows.source[~rows.inserted] for rows in (made, plain)]
    np.testing.assert_array_equal(np.unique(lines[0]), np.unique(lines[1]))
    length = [
        arc.length(rows.paths.start, rows.paths.end, rows.paths.bulge)[~rows.inserted].sum()
        for rows in (made, plain)
    ]
    assert length[0] == pytest.approx(length[1], abs=1e-5)
    if len(made.paths):
        along = arc.points_along(made.paths.start, made.paths.end, made.paths.bulge, 9)
        away = shapely.distance(shapely.points(along.reshape(-1, 2)), shape.exterior)
        assert away.min() >= radius - 1e-9
    # No transition of type C or D is cut short.
    found = whole_transitions(made, paths, radius, side, k)
    kept = np.setdiff1d(np.unique(made.source[made.inserted]), made.replaced)
    assert (found[kept] == kind).all()


def test_a_transition_that_begins_beyond_a_contour_becomes_type_b() -> None:
    # A needle of waste, with an arc at its tip that is too small for the cutter.  The cutter goes
    # left of it and does not fit into the needle.  The transition at the end of this arc crosses no
    # other part of the offset: it leaves the needle through its far side.
    corners = [(33, -33), (10.4, -15.9), (10.3, -17.0), (-13.4, -43.9), (-60, -20), (60, 60)]
    start = np.array(corners, float)
    bulge = np.array([-0.5, 0.14, 0.0, 0.0, 0.0, 0.0])
    paths = paths_of(start, np.roll(start, -1, axis=0), bulge, [0, len(start)])
    plain = offset_paths(paths, 10.6, 1)
    made = offset_paths(paths, 10.6, 1, corner=Corner.C)
    assert len(made.paths) == len(plain.paths) == 1
    assert made.unreached == pytest.approx(plain.unreached)
