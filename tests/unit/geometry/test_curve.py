"""Fitted curves, measured by dense sampling that shares no code with the fit."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.errors import GeometryError
from knifetip.geometry import arc, biarcs, curve
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.ellipse import Ellipse, fit_ellipses
from knifetip.geometry.spline import Spline, Splines, fit_splines
from knifetip.geometry.tolerance import CURVE
from tests.support.examples import examples

#: Largest distance of the chords between sampled points from an arc (mm).
SAGITTA = 1e-5


def sample_points(segments: curve.Segments) -> F64:
    """Return points along the segments, whose chords deviate by at most SAGITTA."""
    walk = []
    for start, end, bulge in zip(*segments[:3], strict=True):
        one = (start[None], end[None], np.array([bulge]))
        size = arc.radius(*one)[0]
        turn = 4.0 * np.arctan(abs(bulge))
        steps = 2 if bulge == 0.0 else int(np.ceil(turn * np.sqrt(size / (8.0 * SAGITTA)))) + 2
        shares = np.linspace(0.0, 1.0, steps)
        many = (np.repeat(one[0], steps, 0), np.repeat(one[1], steps, 0), np.repeat(bulge, steps))
        walk.append(arc.point_at(*many, shares))
    return np.concatenate(walk)


def deviation(segments: curve.Segments, points: F64) -> float:
    """Return the largest distance from the segments of points on the true curve (mm)."""
    walk = sample_points(segments)
    pieces = shapely.STRtree(shapely.linestrings(np.stack([walk[:-1], walk[1:]], axis=1)))
    places = shapely.points(points)
    _, far = pieces.query_nearest(places, return_distance=True, all_matches=False)
    assert len(far) == len(points)
    return float(far.max())


def is_connected(segments: curve.Segments) -> bool:
    start, end, _, _ = segments
    return np.array_equal(start[1:], end[:-1])


def corners(segments: curve.Segments) -> F64:
    """Return the angle between each segment's end and the next segment's start (degrees)."""
    before = arc.tangents(*segments[:3])[1][:-1]
    after = arc.tangents(*segments[:3])[0][1:]
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn: F64 = np.degrees(np.abs(np.arctan2(cross, (before * after).sum(axis=1))))
    return turn


def fit_ellipse(
    centre: Sequence[float],
    major: Sequence[float],
    ratio: float,
    first: float = 0.0,
    last: float = 2.0 * np.pi,
    tolerance: float = CURVE,
) -> curve.Segments:
    """Fit arcs to an elliptic arc; return the segments.

    ``major`` is one half axis as a vector, ``ratio`` the length of the other half axis relative to
    it; ``first`` and ``last`` are the parameters of the ends (radians).
    """
    u = np.array(major, np.float64)
    v = np.array([-u[1], u[0]]) * ratio
    return Ellipse(np.array(centre, np.float64), u, v, first, last).to_segments(tolerance)


def on_ellipse(
    major: float, minor: float, first: float = 0.0, last: float = 2.0 * np.pi, count: int = 1500
) -> F64:
    t = np.linspace(first, last, count)
    return np.stack([major * np.cos(t), minor * np.sin(t)], axis=1)


@pytest.mark.parametrize(
    ("major", "minor", "tolerance", "most"),
    [(50.0, 25.0, 0.01, 48), (100.0, 50.0, 0.01, 60), (100.0, 1.0, 0.01, 80), (50, 25, 0.1, 24)],
)
def test_ellipse_stays_within_tolerance_with_few_arcs(
    major: float, minor: float, tolerance: float, most: int
) -> None:
    fit = fit_ellipse((0.0, 0.0), (major, 0.0), minor / major, tolerance=tolerance)
    assert deviation(fit, on_ellipse(major, minor)) <= tolerance
    assert len(fit[2]) <= most
    assert is_connected(fit)
    assert_array_equal(fit[0][0], fit[1][-1])
    assert corners(fit).max() < 1e-5


def test_points_of_the_fit_are_as_near_to_the_ellipse_as_its_points_to_the_fit() -> None:
    fit = fit_ellipse((0.0, 0.0), (50.0, 0.0), 0.5)
    t = np.linspace(0.0, 2.0 * np.pi, 40_000)
    true = np.stack([50.0 * np.cos(t), 25.0 * np.sin(t)], axis=1)
    walk = sample_points(fit)[::20]
    far = max(float(np.hypot(*(true - place).T).min()) for place in walk)
    assert far <= 0.0105


@pytest.mark.parametrize("tolerance", [0.1, 0.01, 0.001])
@pytest.mark.parametrize("ratio", [0.98, 0.68, 0.1])
def test_the_stated_error_of_a_fit_is_its_largest_distance_from_the_curve(
    ratio: float, tolerance: float
) -> None:
    fit = fit_ellipse((0.0, 0.0), (100.0, 0.0), ratio, tolerance=tolerance)
    true = deviation(fit, on_ellipse(100.0, 100.0 * ratio, count=20_000))
    assert true - SAGITTA <= fit[3].max() <= min(1.04 * true + SAGITTA, tolerance)
    # Each segment has the error of its own piece of the curve.
    assert len(np.unique(fit[3].round(9))) > 1


def test_circle_is_two_exact_half_turns() -> None:
    start, end, bulge, error = fit_ellipse((5.0, 6.0), (10.0, 0.0), 1.0)
    assert_allclose(start, [[15.0, 6.0], [-5.0, 6.0]], atol=1e-14)
    assert_allclose(end, [[-5.0, 6.0], [15.0, 6.0]], atol=1e-14)
    assert_allclose(bulge, [1.0, 1.0])
    assert_array_equal(error, [0.0, 0.0])


def test_clockwise_circle_has_negative_bulges() -> None:
    assert_allclose(fit_ellipse((0.0, 0.0), (10.0, 0.0), -1.0)[2], [-1.0, -1.0])


def test_nearly_round_ellipse_takes_at_most_16_arcs() -> None:
    fit = fit_ellipse((0.0, 0.0), (100.0, 0.0), 0.999)
    assert len(fit[2]) <= 16
    assert deviation(fit, on_ellipse(100.0, 99.9)) <= 0.01


def test_elliptic_arc_starts_and_ends_exactly_at_its_parameters() -> None:
    start, end, bulge, _ = fit_ellipse((1.0, 2.0), (0.0, 40.0), 0.25, 0.3, 4.0)

    def at(t: float) -> list[float]:
        return [1.0 - 10.0 * np.sin(t), 2.0 + 40.0 * np.cos(t)]

    assert_allclose(start[0], at(0.3), atol=1e-13)
    assert_allclose(end[-1], at(4.0), atol=1e-13)
    assert (np.abs(bulge) <= 1.0).all()


def test_conjugate_radii_need_not_be_perpendicular() -> None:
    # A circle of radius 10 sheared by x += y: u = (10, 0), v = (10, 10).
    shape = Ellipse(np.zeros(2), np.array([10.0, 0.0]), np.array([10.0, 10.0]), 0.0, 6.0)
    t = np.linspace(0.0, 6.0, 1500)
    true = np.stack([10.0 * np.cos(t) + 10.0 * np.sin(t), 10.0 * np.sin(t)], axis=1)
    assert deviation(shape.to_segments(0.01), true) <= 0.01


def test_an_ellipse_without_width_is_a_line_in_both_directions() -> None:
    start, end, bulge, _ = fit_ellipse((0.0, 0.0), (10.0, 0.0), 0.0)
    assert_array_equal(bulge, np.zeros(len(bulge)))
    assert arc.length(start, end, bulge).sum() == pytest.approx(40.0)


@examples(20)
@given(
    major=st.floats(0.5, 900.0),
    ratio=st.floats(0.02, 1.0),
    first=st.floats(-6.0, 6.0),
    turn=st.floats(0.05, 6.28),
)
def test_any_elliptic_arc_stays_within_a_hundredth(
    major: float, ratio: float, first: float, turn: float
) -> None:
    fit = fit_ellipse((0.0, 0.0), (major, 0.0), ratio, first, first + turn)
    true = on_ellipse(major, major * ratio, first, first + turn, 400)
    assert deviation(fit, true) <= 0.01 + SAGITTA
    assert is_connected(fit)
    assert_allclose(fit[0][0], true[0], atol=1e-10)
    assert_allclose(fit[1][-1], true[-1], atol=1e-10)


def bezier(*control: tuple[float, float]) -> Spline:
    return Spline(np.array(control, dtype=float), np.ones(4), np.array([0.0] * 4 + [1.0] * 4), 3)


def bernstein(
    control: Sequence[tuple[float, float]],
    count: int = 1500,
) -> F64:
    t = np.linspace(0.0, 1.0, count)[:, None]
    a, b, c, d = np.array(control, dtype=float)
    point: F64 = (1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t * t * (1 - t) * c + t**3 * d
    return point


@pytest.mark.parametrize(
    "control",
    [
        ((0, 0), (0, 50), (100, 50), (100, 0)),
        ((0, 0), (100, 80), (0, 80), (100, 0)),  # an S with an inflection
        ((0, 0), (130, 80), (-30, 80), (100, 0)),  # a loop
        ((0, 0), (100, 80), (0, 80.0), (100, 0.0001)),
        ((0, 0), (0, 0), (100, 0), (100, 100)),  # no tangent at its start
        ((0, 0), (100, 100), (0, 100), (100, 0)),  # a cusp
    ],
)
def test_cubic_stays_within_tolerance(
    control: tuple[tuple[int, int], tuple[int, int], tuple[int, float], tuple[int, float]],
) -> None:
    fit = bezier(*control).to_segments(0.01)
    assert deviation(fit, bernstein(control)) <= 0.01
    assert is_connected(fit)
    assert_array_equal(fit[0][0], control[0])
    assert_allclose(fit[1][-1], control[3], atol=1e-13)
    assert len(fit[2]) < 120


def test_straight_cubic_is_one_line() -> None:
    start, end, bulge, _ = bezier((0, 0), (10, 10), (20, 20), (30, 30)).to_segments()
    assert_allclose(np.hstack([start, end]), [[0.0, 0.0, 30.0, 30.0]], atol=1e-12)
    assert_array_equal(bulge, [0.0])


def test_rational_quadratic_draws_a_true_quarter_circle() -> None:
    # Weights 1, cos 45°, 1 over a right angle: a circle of radius 10.
    control = np.array([[10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
    weights = np.array([1.0, np.sqrt(0.5), 1.0])
    spline = Spline(control, weights, np.array([0.0, 0, 0, 1, 1, 1]), 2)
    points = Splines([spline]).point(np.zeros(50, np.int64), np.linspace(0.0, 1.0, 50))
    assert_allclose(np.hypot(*points.T), 10.0)
    start, end, bulge, _ = spline.to_segments()
    assert_allclose(arc.length(start, end, bulge).sum(), 5.0 * np.pi, rtol=1e-9)
    assert len(bulge) <= 2


def test_a_corner_of_a_spline_is_kept() -> None:
    # Degree 2 with a double knot in the middle: two straight parts that meet at (10, 0).
    control = np.array([[0.0, 0], [5, 0], [10, 0], [10, 5], [10, 10]])
    knots = np.array([0.0, 0, 0, 1, 1, 2, 2, 2])
    start, end, bulge, _ = Spline(control, np.ones(5), knots, 2).to_segments()
    assert_allclose(end[0], [10.0, 0.0], atol=1e-12)
    assert_allclose(np.hstack([start, end]), [[0, 0, 10, 0], [10, 0, 10, 10]], atol=1e-12)
    assert_array_equal(bulge, [0.0, 0.0])


def test_a_corner_between_curves_needs_no_additional_arcs() -> None:
    # Two cubics that meet at (100, 0): falling into the corner, and rising out of it.
    first = [(0, 0), (0, 50), (100, 50), (100, 0)]
    second = [(100, 0), (100, 50), (200, 50), (200, 0)]
    knots = np.array([0.0] * 4 + [1.0] * 3 + [2.0] * 4)
    control = np.array(first + second[1:], dtype=float)
    both = Spline(control, np.ones(7), knots, 3).to_segments()
    apart = [bezier(*leg).to_segments() for leg in (first, second)]
    assert len(both[2]) == len(apart[0][2]) + len(apart[1][2])
    assert deviation(both, np.concatenate([bernstein(first, 400), bernstein(second, 400)])) <= 0.01
    assert corners(both).max() == pytest.approx(180.0, abs=1e-3)


def test_an_unclamped_spline_is_defined_between_its_inner_knots() -> None:
    # A uniform quadratic: at the ends of its domain it is midway between control points.
    control = np.array([[0.0, 0], [10, 0], [10, 10], [0, 10]])
    spline = Spline(control, np.ones(4), np.arange(7.0), 2)
    assert_array_equal(Splines([spline]).breaks[0], [2.0, 3.0, 4.0])
    start, end, _, _ = spline.to_segments()
    assert_allclose(start[0], [5.0, 0.0])
    assert_allclose(end[-1], [5.0, 10.0])


def test_tangent_is_the_derivative_of_the_point() -> None:
    # Two splines of different degree, one with a corner, evaluated together.
    knots = np.array([0.0, 0, 0, 1, 1, 2, 2, 2])
    control = np.array([[0.0, 0], [5, 3], [10, 0], [10, 5], [14, 10]])
    splines = Splines(
        [
            Spline(control, np.ones(5), knots, 2),
            bezier((0, 0), (10, 30), (40, 20), (50, 0)),
        ]
    )
    t = np.concatenate([np.linspace(0.05, 1.95, 20), np.linspace(0.05, 0.95, 20)])
    number = np.repeat([0, 1], 20)
    step = 1e-6
    slope = splines.point(number, t + step) - splines.point(number, t - step)
    assert_allclose(splines.tangent(number, t), slope / (2.0 * step), rtol=1e-6)


def test_curves_that_are_approximated_together_are_those_approximated_alone() -> None:
    rng = np.random.default_rng(5)
    ellipses = [
        Ellipse(centre, u, v, 0.3, 0.3 + turn)
        for (centre, u, v), turn in zip(
            rng.uniform(-50, 50, (300, 3, 2)),
            rng.choice([0.5, 2.0, 2.0 * np.pi], 300).tolist(),
            strict=True,
        )
    ]
    ellipses[7] = Ellipse(np.zeros(2), np.array([3.0, 0.0]), np.array([0.0, 3.0]), 0.0, 4.0)
    ellipses[8] = Ellipse(np.zeros(2), np.array([3.0, 0.0]), np.array([6.0, 0.0]), 0.0, 4.0)
    splines = []
    for degree in rng.choice([1, 2, 3, 5], 300):
        count = degree + rng.integers(1, 6)
        knots = np.sort(rng.integers(0, 9, count + degree + 1)).astype(np.float64)
        knots[-degree - 1 :] += 1.0
        control = rng.uniform(-50, 50, (count, 2))
        splines.append(Spline(control, rng.uniform(0.5, 2.0, count), knots, int(degree)))
    together = fit_ellipses(ellipses, 0.01, 10**6) + fit_splines(splines, 0.01, 10**6)
    alone: list[Ellipse | Spline] = [*ellipses, *splines]
    failed = 0
    for found, one in zip(together, alone, strict=True):
        if isinstance(found, GeometryError):
            # Repeated knots may make gaps in a spline.
            failed += 1
            with pytest.raises(GeometryError, match=found.text[:20]):
                one.to_segments(0.01)
        else:
            for column, expected in zip(found, one.to_segments(0.01), strict=True):
                assert_array_equal(column, expected)
    assert failed < 50


def test_a_curve_that_cannot_be_approximated_is_the_only_one_lost() -> None:
    whole = Ellipse(np.zeros(2), np.array([3.0, 0.0]), np.array([0.0, 2.0]), 0.0, 4.0)
    endless = Ellipse(np.array([np.inf, 0.0]), whole.u, whole.v, 0.0, 4.0)
    found = fit_ellipses([whole, endless, whole], 0.01, 10**6)
    assert [isinstance(one, GeometryError) for one in found] == [False, True, False]
    with pytest.raises(GeometryError):
        fit_ellipses([whole] * 3, 0.01, 5)


@pytest.mark.parametrize(
    ("control", "knots", "degree"),
    [
        ([[0.0, 0], [1, 1]], [0.0, 0, 0, 1, 1, 1], 2),
        ([[0.0, 0], [1, np.nan], [2, 0]], [0.0, 0, 0, 1, 1, 1], 2),
        ([[0.0, 0], [1, 1], [2, 0]], [0.0, 0, 1, 0, 1, 1], 2),
        ([[0.0, 0], [1, 1], [2, 0]], [0.0, 0, 0, 0, 0, 0], 2),
    ],
)
def test_damaged_spline_is_refused(
    control: list[list[float]], knots: list[float], degree: int
) -> None:
    with pytest.raises(GeometryError):
        Spline(np.array(control), np.ones(len(control)), np.array(knots), degree)


@pytest.mark.parametrize("size", [(np.nan, 0.0), (np.inf, 0.0)], ids=["not a number", "endless"])
def test_ellipse_without_a_size_is_refused(size: tuple[float, float]) -> None:
    with pytest.raises(GeometryError):
        fit_ellipse((0.0, 0.0), size, 0.5)


def test_a_curve_that_needs_too_many_pieces_is_refused_quickly() -> None:
    def noise(_: I64, t: F64) -> F64:
        return np.stack([t, np.sin(1e9 * t * t) * 50.0], axis=1)

    found = curve.fit_many(noise, lambda _, t: np.ones((len(t), 2)), 1)
    assert isinstance(found.failed[0], GeometryError)


Cubics = Callable[[I64, F64], F64]


def cubics(control: F64) -> tuple[Cubics, Cubics]:
    """Return two functions for n cubic Bézier curves with control points (n, 4, 2).

    The first gives points and the second derivatives, for numbers of curves and their parameters.
    """

    def point(k: I64, s: F64) -> F64:
        p, t, r = control[k], s[:, None], 1.0 - s[:, None]
        return r**3 * p[:, 0] + 3 * r * r * t * p[:, 1] + 3 * r * t * t * p[:, 2] + t**3 * p[:, 3]

    def tangent(k: I64, s: F64) -> F64:
        d, t, r = np.diff(control[k], axis=1), s[:, None], 1.0 - s[:, None]
        return r * r * d[:, 0] + 2 * r * t * d[:, 1] + t * t * d[:, 2]

    return point, tangent


def test_many_curves_are_fitted_independently() -> None:
    control = np.random.default_rng(4).uniform(-50.0, 50.0, (300, 4, 2))
    point, tangent = cubics(control)
    (start, end, bulge, error), which, failed = curve.fit_many(point, tangent, len(control), 0.01)
    assert not failed
    assert np.unique(which).tolist() == list(range(300))
    for k in range(300):
        own = which == k
        a, b, turn = start[own], end[own], bulge[own]
        assert a[0].tolist() == control[k, 0].tolist()
        assert b[-1].tolist() == control[k, 3].tolist()
        assert (a[1:] == b[:-1]).all()
        true = point(np.full(40, k), np.linspace(0.0, 1.0, 40))
        off = np.full(40, np.inf)
        for first, last, one in zip(a, b, turn, strict=True):
            ends = np.broadcast_to(first, (40, 2)), np.broadcast_to(last, (40, 2))
            share = arc.nearest_fraction(*ends, np.full(40, one), true)
            near = arc.point_at(*ends, np.full(40, one), share)
            off = np.minimum(off, np.hypot(*(near - true).T))
        assert off.max() <= 0.0101
        assert error[own].max() >= off.max() - 1e-9


def test_a_curve_without_length_among_others_has_no_segment() -> None:
    control = np.array(
        [[[0, 0], [1, 2], [3, 2], [4, 0]], [[5, 5]] * 4, [[9, 0]] * 2 + [[9, 9]] * 2]
    )
    point, tangent = cubics(control.astype(float))
    (_, _, bulge, _), which, _ = curve.fit_many(point, tangent, 3, 0.01)
    assert set(which.tolist()) == {0, 2}
    assert (bulge[which == 2] == 0.0).all()


def test_no_curves_are_no_segments() -> None:
    point, tangent = cubics(np.zeros((0, 4, 2)))
    segments, which, _ = curve.fit_many(point, tangent, 0)
    assert [len(column) for column in (*segments, which)] == [0] * 5


def test_a_curve_that_is_not_finite_does_not_hinder_the_others() -> None:
    control = np.random.default_rng(5).uniform(-50.0, 50.0, (3, 4, 2))
    control[1, 2, 0] = np.nan
    point, tangent = cubics(control)
    _, which, failed = curve.fit_many(point, tangent, 3, 0.01)
    assert np.unique(which).tolist() == [0, 2]
    assert {number: reason.message.code for number, reason in failed.items()} == {
        1: "curve.not-finite"
    }


def test_the_pieces_of_all_curves_are_counted_before_the_first_is_fitted() -> None:
    control = np.random.default_rng(6).uniform(-50.0, 50.0, (100, 4, 2))
    point, tangent = cubics(control)
    evaluated = 0

    def counted(k: I64, s: F64) -> F64:
        nonlocal evaluated
        evaluated += len(k)
        return point(k, s)

    with pytest.raises(GeometryError) as refusal:
        curve.fit_many(counted, tangent, len(control), 0.01, 50)
    assert refusal.value.message.code == "curve.too-many-pieces"
    assert refusal.value.message.arguments["limit"] == 50
    # 32 cells of each curve are examined to count its pieces; no piece is measured.
    assert evaluated == 100 * 33


def test_the_pieces_of_a_spline_are_counted_before_it_is_fitted() -> None:
    count = curve.MAX_PIECES // 40
    control = np.random.default_rng(7).uniform(-1e6, 1e6, (count, 2))
    spline = Spline(control, np.ones(count), np.arange(count + 4.0), 3)
    splines = Splines([spline])
    breaks, number = splines.breaks
    evaluated = 0

    def counted(k: I64, t: F64) -> F64:
        nonlocal evaluated
        evaluated += len(t)
        return splines.point(k, t)

    spans = biarcs.Pieces(breaks[:-1], breaks[1:], number[1:])
    found = curve.fit_spans(counted, splines.tangent, spans, 1, 0.01, 10 * curve.MAX_PIECES)
    assert found.failed[0].message.code == "curve.too-many-pieces"
    assert evaluated == 33 * (count - 3)
