"""Curves that are drawn as chords become arcs, within the tolerance and with their error."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st

from knifetip.cleaning import merge_collinear
from knifetip.cleaning.clean import clean
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import CURVE, FIT
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.examples import examples
from tests.support.shapes import dieline, rotation

CUT, CREASE = LineType.CUT, LineType.CREASE


def on_circle(radius: float, degrees: F64, centre: tuple[float, float] = (0.0, 0.0)) -> F64:
    turn = np.radians(degrees)
    return np.array(centre) + radius * np.column_stack([np.cos(turn), np.sin(turn)])


def chords(points: F64, *, close: bool = False) -> F64:
    """Return the chords between points, (n, 2, 2) mm."""
    if close:
        points = np.concatenate([points, points[:1]])
    return np.stack([points[:-1], points[1:]], axis=1)


def cut(points: F64, *, close: bool = False) -> Dieline:
    return dieline((CUT, chords(points, close=close)))


def worked(made: Cleaned) -> I64:
    """Return the rows of the edges that are machined."""
    return np.flatnonzero(made.dieline.line_type != LineType.IGNORED)


def radii(made: Cleaned) -> F64:
    line, rows = made.dieline, worked(made)
    return arc.radius(line.ends[rows, 0], line.ends[rows, 1], line.bulge[rows])


def outline(line: Dieline, rows: I64, points: int = 200) -> shapely.Geometry:
    curves = arc.points_along(line.ends[rows, 0], line.ends[rows, 1], line.bulge[rows], points)
    return shapely.union_all([shapely.LineString(one) for one in curves])


def corners(made: Cleaned) -> F64:
    """Return the turns between machined edges that follow each other (degrees)."""
    line, rows = made.dieline, worked(made)
    ahead, last = arc.tangents(line.ends[rows, 0], line.ends[rows, 1], line.bulge[rows])
    way = [np.degrees(np.arctan2(*vectors.T[::-1])) for vectors in (ahead, last)]
    turn: F64 = (way[0][1:] - way[1][:-1] + 180.0) % 360.0 - 180.0
    return turn


def test_360_chords_of_a_circle_become_two_half_circles() -> None:
    made = clean(cut(on_circle(30, np.arange(360.0), (110, 80)), close=True))
    assert len(worked(made)) == 2
    np.testing.assert_allclose(radii(made), 30.0, atol=1e-9)
    np.testing.assert_allclose(made.dieline.bulge[worked(made)], 1.0)
    # The chords lie inside the circle by r (1 - cos 0.5°).
    sagitta = 30.0 * (1.0 - math.cos(math.radians(0.5)))
    assert sagitta == pytest.approx(0.001142, abs=1e-6)
    np.testing.assert_allclose(made.dieline.fit_error[worked(made)], sagitta, atol=1e-9)
    assert made.off.max() == pytest.approx(sagitta, abs=1e-9)
    assert {CleaningReason(code).name for code in made.reason} == {"LONGER", "FITTED"}


def test_a_circle_of_an_odd_number_of_chords_becomes_three_arcs() -> None:
    made = clean(cut(on_circle(30, np.arange(361.0) * 360.0 / 361.0), close=True))
    assert len(worked(made)) == 3
    np.testing.assert_allclose(radii(made), 30.0, atol=1e-9)


def test_a_circle_whose_chords_are_a_little_too_long_is_drawn_through_their_middle() -> None:
    sagitta = 100.0 * (1.0 - math.cos(math.radians(0.5)))
    assert CURVE < sagitta < 2.0 * CURVE
    made = clean(cut(on_circle(100, np.arange(360.0)), close=True))
    assert len(worked(made)) == 2
    np.testing.assert_allclose(radii(made), 100.0 - sagitta / 2.0, atol=1e-9)
    np.testing.assert_allclose(made.dieline.fit_error[worked(made)], sagitta / 2.0, atol=1e-9)


@pytest.mark.parametrize(
    ("sides", "radius"), [(6, 2.0), (8, 5.0), (12, 20.0), (24, 10.0), (36, 10.0), (90, 30.0)]
)
def test_a_polygon_whose_sides_leave_the_circle_stays(sides: int, radius: float) -> None:
    assert radius * (1.0 - math.cos(math.pi / sides)) > 2.0 * FIT
    line = cut(on_circle(radius, np.arange(sides) * 360.0 / sides), close=True)
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends, line.ends)
    assert not made.changed.any()


@pytest.mark.parametrize("sides", [4, 5, 6, 8])
def test_the_corners_of_a_small_polygon_stay(sides: int) -> None:
    line = cut(on_circle(0.2, np.arange(sides) * 360.0 / sides), close=True)
    assert len(worked(clean(line))) == sides


def rounded(radius: float, count: int) -> F64:
    """Return the vertices of a panel of 200 × 140 mm with rounded corners."""
    centres = ((200 - radius, 140 - radius), (radius, 140 - radius), (radius, radius))
    turn = np.linspace(0.0, 90.0, count + 1)
    parts = [
        on_circle(radius, turn + 90.0 * k, centre)
        for k, centre in enumerate((*centres, (200 - radius, radius)))
    ]
    return np.concatenate(parts)


@pytest.mark.parametrize("degrees", [0.0, 13.3, 90.0, 211.7])
@pytest.mark.parametrize("back", [False, True])
def test_rounded_corners_become_one_arc_each_and_the_sides_stay(degrees: float, back: bool) -> None:
    points = rounded(10.0, 45) @ rotation(degrees).T
    line = cut(points[::-1] if back else points, close=True)
    made = clean(line)
    rows = worked(made)
    assert len(rows) == 8
    bent = made.dieline.bulge[rows] != 0.0
    assert bent.sum() == 4
    np.testing.assert_allclose(radii(made)[bent], 10.0, atol=1e-9)
    # The ends of the sides are where they were drawn.
    sides = made.dieline.ends[rows[~bent]]
    lengths = np.hypot(*(sides[:, 1] - sides[:, 0]).T)
    np.testing.assert_allclose(np.sort(lengths), [120, 120, 180, 180], atol=1e-9)
    assert check_cleaning(line, made) == []


def test_two_curves_that_meet_at_a_corner_keep_the_corner() -> None:
    one = on_circle(30.0, np.linspace(180.0, 90.0, 91), (30.0, 0.0))
    other = on_circle(30.0, np.linspace(90.0, 0.0, 91), (30.0, 0.0))
    # Without the corner they are one half circle.
    assert len(worked(clean(cut(np.concatenate([one, other[1:]]))))) == 1
    turned = (other - other[0]) @ rotation(40.0).T + one[-1]
    made = clean(cut(np.concatenate([one, turned[1:]])))
    assert len(worked(made)) == 2
    np.testing.assert_allclose(corners(made), 40.0, atol=1e-6)
    np.testing.assert_array_equal(made.dieline.ends[worked(made)[0], 1], one[-1])


def test_an_s_of_chords_becomes_two_arcs_that_meet_where_it_bends_back() -> None:
    one = on_circle(20.0, np.linspace(180.0, 60.0, 121))
    other = on_circle(20.0, np.linspace(240.0, 360.0, 121), (20.0, 20.0 * math.sqrt(3.0)))
    made = clean(cut(np.concatenate([one, other[1:]])))
    assert len(worked(made)) == 2
    np.testing.assert_allclose(np.abs(corners(made)), 0.0, atol=1e-6)
    assert np.prod(np.sign(made.dieline.bulge[worked(made)])) == -1.0


@pytest.mark.parametrize("digits", [12, 3])
def test_chords_of_an_ellipse_become_few_arcs_without_corners(digits: int) -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 721)[:-1]
    points = np.column_stack([60.0 * np.cos(turn), 30.0 * np.sin(turn)]).round(digits)
    line = cut(points, close=True)
    made = clean(line)
    assert len(worked(made)) <= 36
    assert np.abs(corners(made)).max() < 0.5
    far = shapely.hausdorff_distance(
        outline(made.dieline, worked(made)), outline(line, np.arange(720), 2)
    )
    assert far <= made.dieline.fit_error.max() + 2e-4
    assert made.dieline.fit_error.max() <= CURVE
    assert check_cleaning(line, made) == []


def test_no_chord_is_left_at_the_end_of_a_curve() -> None:
    # The longest arc from the start leaves one to three chords, whatever the number of chords.
    turn = np.linspace(0.0, 1.5, 301)
    spiral = (5.0 + 30.0 * turn)[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    for count in range(200, 300, 7):
        made = clean(cut(spiral[:count]))
        assert (made.dieline.bulge[worked(made)] != 0.0).all(), count


def test_a_curve_is_divided_where_a_third_edge_ends() -> None:
    points = on_circle(30.0, np.linspace(0.0, 90.0, 91))
    line = dieline((CUT, chords(points)), (CREASE, np.array([[points[40], (0.0, 0.0)]])))
    made = clean(line)
    rows = worked(made)
    assert len(rows) == 3
    np.testing.assert_array_equal(made.dieline.ends[rows[0], 1], points[40])


def test_chords_of_two_line_types_are_two_arcs() -> None:
    points = on_circle(30.0, np.linspace(0.0, 90.0, 91))
    made = clean(dieline((CUT, chords(points[:46])), (CREASE, chords(points[45:]))))
    assert sorted(made.dieline.line_type[worked(made)]) == [CUT, CREASE]


def test_the_error_of_the_file_and_of_the_fit_are_added_and_limited() -> None:
    points = on_circle(30.0, np.linspace(0.0, 90.0, 91))
    sagitta = 30.0 * (1.0 - math.cos(math.radians(0.5)))
    line = cut(points)
    near = clean(replace(line, fit_error=np.full(90, 0.002)))
    assert len(worked(near)) == 1
    assert near.dieline.fit_error[worked(near)] == pytest.approx([0.002 + sagitta], abs=1e-9)
    far = clean(replace(line, fit_error=np.full(90, 0.0075)))
    assert len(worked(far)) == 90


@pytest.mark.parametrize(
    ("radius", "count"),
    [(3.7, 500), (7.0, 360), (9.2, 120), (30.0, 360), (80.0, 720), (100.0, 360)],
)
def test_a_circle_of_vertices_rounded_to_hundredths_is_a_circle(radius: float, count: int) -> None:
    points = on_circle(radius, np.arange(count) * 360.0 / count, (150.1234, 150.4567)).round(2)
    line = cut(points, close=True)
    made = clean(line)
    assert len(worked(made)) in (2, 3)
    np.testing.assert_allclose(radii(made), radius, atol=0.004)
    assert CURVE < made.dieline.fit_error.max() <= FIT
    assert check_cleaning(line, made) == []


@pytest.mark.parametrize("radius", [3.0, 7.0, 30.0])
def test_rounded_corners_with_vertices_in_hundredths_become_few_arcs(radius: float) -> None:
    line = cut((rounded(radius, 90) + 0.1234).round(2), close=True)
    made = clean(line)
    curves = made.dieline.bulge[worked(made)] != 0.0
    assert np.count_nonzero(curves) <= 12
    assert np.count_nonzero(~curves) == 4
    assert made.dieline.fit_error.max() <= FIT
    assert check_cleaning(line, made) == []


def test_exact_chords_are_replaced_within_the_smaller_tolerance() -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 721)[:-1]
    made = clean(cut(np.column_stack([60.0 * np.cos(turn), 30.0 * np.sin(turn)]), close=True))
    assert made.dieline.fit_error.max() <= CURVE


def test_small_steps_of_a_curve_with_rounded_vertices_are_fitted() -> None:
    # Chords of 0.04 … 0.06 mm, around the gap tolerance of 0.05 mm, with vertices of 4 digits.
    steps = np.cumsum(0.1 + 0.02 * np.sin(np.arange(600)))
    points = np.round(on_circle(25.0, steps[:600] * 1.2), 4)
    made = clean(cut(points))
    assert len(worked(made)) == 1
    assert radii(made) == pytest.approx([25.0], abs=0.01)


@examples(40)
@given(
    seed=st.integers(0, 2**32 - 1),
    step=st.sampled_from([0.1, 0.5, 2.0]),
    bend=st.sampled_from([0.5, 2.0, 8.0]),
    noise=st.sampled_from([0.0, 0.0005, 0.003]),
)
def test_no_point_of_a_random_curve_moves_by_more_than_stated(
    seed: int, step: float, bend: float, noise: float
) -> None:
    random = np.random.default_rng(seed)
    turn = np.cumsum(np.repeat(random.uniform(-bend, bend, 12), random.integers(2, 40, 12)))
    size = step * random.uniform(0.7, 1.3, len(turn))
    way = size[:, None] * np.column_stack([np.cos(np.radians(turn)), np.sin(np.radians(turn))])
    points = np.cumsum(np.concatenate([[[0.0, 0.0]], way]), axis=0)
    points += random.uniform(-noise, noise, points.shape)
    assume(shapely.LineString(points).is_simple)
    line = cut(points)
    made = clean(line)
    assert check_cleaning(line, made) == []
    assert made.dieline.fit_error.max() <= FIT + 1e-9
    if not (made.moved.any() or made.merged.any() or made.dropped.any()):
        way = outline(made.dieline, worked(made))
        middles = 0.5 * (points[1:] + points[:-1])
        far = shapely.distance(shapely.points(np.concatenate([points, middles])), way)
        # The outline is measured on chords, too.
        assert far.max() <= made.dieline.fit_error.max() + 2e-3
    again = clean(made.dieline)
    np.testing.assert_array_equal(again.dieline.ends, made.dieline.ends)


@pytest.mark.parametrize("step", [0.02, 0.3])
@pytest.mark.parametrize("degrees", [2.0, 10.0, 25.0])
def test_the_chord_beside_an_acute_corner_stays(step: float, degrees: float) -> None:
    # A straight side returns as a curve that bends away from it: an arc that bulges by the
    # tolerance would cross the side.
    sagitta = 8.0 * 0.0030 / step
    turn = np.radians(degrees) + np.arange(12) * min(sagitta, 0.3)
    curve = np.cumsum(step * np.column_stack([np.cos(turn), np.sin(turn)]), axis=0)
    points = np.concatenate([[[30.0, 0.0], [0.0, 0.0]], curve])
    made = clean(cut(points))
    np.testing.assert_array_equal(made.dieline.ends[1], [[0.0, 0.0], curve[0]])
    ways = arc.points_along(
        made.dieline.ends[:, 0], made.dieline.ends[:, 1], made.dieline.bulge, 65
    )
    side, *rest = [shapely.LineString(way) for way in ways[made.dieline.line_type == CUT]]
    assert all(not side.crosses(one) for one in rest[1:])


def random_run(seed: int) -> Dieline:
    """Return rows of similar edges, with turns and lengths on both sides of all limits."""
    random = np.random.default_rng(seed)
    turn, size, bulge = np.zeros(0), np.zeros(0), np.zeros(0)
    for _ in range(random.integers(1, 4)):
        count = int(random.integers(1, 7))
        # Arcs with a bulge of 0.2 continue each other where their chords turn by 45.24°.
        turns = [0.0, 0.5, 15.0, 19.9, 20.1, 30.0, math.degrees(4.0 * math.atan(0.2)), 90.0, 179.9]
        turn = np.append(turn, np.full(count, random.choice(turns)) * random.choice([-1.0, 1.0]))
        size = np.append(size, np.full(count, random.choice([0.03, 0.049, 0.051, 0.14, 3.0, 40.0])))
        bulge = np.append(bulge, np.full(count, random.choice([0.0, 0.0, 0.0, 0.2, -0.2])))
    heading = np.radians(np.cumsum(turn))
    steps = size[:, None] * np.column_stack([np.cos(heading), np.sin(heading)])
    ends = chords(np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)]))
    backwards = random.random(len(ends)) < 0.5
    return replace(
        dieline((CUT, ends)),
        ends=np.where(backwards[:, None, None], ends[:, ::-1], ends),
        bulge=np.where(backwards, -bulge, bulge),
    )


def test_runs_with_corners_only_are_not_searched_and_stay_as_the_search_leaves_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    lines = [random_run(seed) for seed in range(400)]
    fast = [clean(line) for line in lines]
    left_out = 0
    quick = merge_collinear._in_changeable_runs

    def search_all(*arguments: Any) -> Bool:
        nonlocal left_out
        changeable = quick(*arguments)
        left_out += int(np.count_nonzero(~changeable))
        return np.ones_like(changeable)

    monkeypatch.setattr(merge_collinear, "_in_changeable_runs", search_all)
    for line, made in zip(lines, fast, strict=True):
        slow = clean(line)
        np.testing.assert_array_equal(made.dieline.ends, slow.dieline.ends)
        np.testing.assert_array_equal(made.dieline.bulge, slow.dieline.bulge)
        np.testing.assert_array_equal(made.reason, slow.reason)
    assert left_out > 300
