import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from knifetip.verification.columns import F64
from knifetip.verification.curves.curve import arc_curves, line_curves, point_at
from knifetip.verification.curves.intervals import Overlaps, uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from tests.support.examples import examples


def line(x1: float, y1: float, x2: float, y2: float) -> F64:
    return line_curves(np.array([[x1, y1]]), np.array([[x2, y2]]))


def arc(x: float, y: float, radius: float, first: float, sweep: float) -> F64:
    """Return an arc about (x, y) from an angle, by an angle (degrees)."""
    begin = math.radians(first)
    start = np.array([[x + radius * math.cos(begin), y + radius * math.sin(begin)]])
    return arc_curves(np.array([[x, y]]), start, np.array([math.radians(sweep)]))


def rows(curve: F64, edge: F64, limit: float = 0.01) -> Overlaps:
    return find_overlaps(curve, edge, np.zeros(len(edge)), edge[:, 5], limit)


def test_the_overlap_of_collinear_lines_lies_between_the_ends_of_both() -> None:
    found = rows(line(0, 0, 10, 0), line(4, 0.005, 20, 0.005))
    np.testing.assert_allclose(found.along, [[4.0, 10.0]])
    np.testing.assert_allclose(found.place, [[0.0, 6.0]])
    np.testing.assert_allclose(found.distance, [0.005])


def test_a_reversed_line_has_descending_positions() -> None:
    found = rows(line(10, 0, 0, 0), line(0, 0, 10, 0))
    np.testing.assert_allclose(found.place, [[10.0, 0.0]])


def test_a_line_beyond_the_limit_has_no_overlap() -> None:
    assert len(rows(line(0, 0, 10, 0), line(0, 0.0101, 10, 0.0101)).curve) == 0


def test_a_crossing_line_overlaps_only_within_the_limit() -> None:
    found = rows(line(5, -5, 5, 5), line(0, 0, 10, 0))
    np.testing.assert_allclose(found.along, [[4.99, 5.01]])
    np.testing.assert_allclose(found.place, [[5.0, 5.0]])


def test_an_arc_overlaps_the_reversed_arc() -> None:
    found = rows(arc(3, 4, 10, 350, 90), arc(3, 4, 10, 60, -90))
    # From 350° to 80°, and from 60° down to -30°: shared from 350° to 60°.
    np.testing.assert_allclose(found.along, [[0.0, 10 * math.radians(70)]], atol=1e-9)
    np.testing.assert_allclose(found.place, [[10 * math.radians(70), 0.0]], atol=1e-9)
    np.testing.assert_allclose(found.distance, [0.0], atol=1e-12)


def test_a_full_circle_overlaps_both_ends_of_an_arc_through_its_start() -> None:
    found = rows(arc(0, 0, 10, 0, 360), arc(0, 0, 10, -30, 60))
    pieces = sorted(found.along.tolist())
    np.testing.assert_allclose(
        pieces, [[0, 10 * math.radians(30)], [10 * math.radians(330), 10 * math.radians(360)]]
    )


def test_a_chord_overlaps_an_arc_only_within_the_limit() -> None:
    # The sagitta of a 2 mm chord at radius 10 is 0.0501: near the arc at its ends alone.
    half = math.asin(0.1)
    chord = line(-1, 10 * math.cos(half), 1, 10 * math.cos(half))
    found = rows(chord, arc(0, 0, 10, 100, -20))
    assert len(found.curve) == 2
    inner = math.sqrt((10 - 0.01) ** 2 - (10 * math.cos(half)) ** 2)
    np.testing.assert_allclose(
        sorted(found.along.tolist()), [[0.0, 1 - inner], [1 + inner, 2.0]], atol=1e-9
    )


def test_stretches_on_no_edge_are_uncovered() -> None:
    curve = line(0, 0, 10, 0)
    found = rows(curve, np.vstack([line(1, 0, 4, 0), line(3, 0, 6, 0)]))
    which, spans = uncovered_curves(found, curve)
    assert which.tolist() == [0, 0]
    np.testing.assert_allclose(spans, [[0, 1], [6, 10]])


def test_a_point_is_on_an_edge_or_uncovered() -> None:
    points = np.vstack([line(5, 0.004, 5, 0.004), line(5, 0.02, 5, 0.02)])
    found = rows(points, line(0, 0, 10, 0))
    np.testing.assert_allclose(found.place, [[5.0, 5.0]])
    assert uncovered_curves(found, points)[0].tolist() == [1]


def test_a_point_beyond_an_end_is_near_the_end_or_not_at_all() -> None:
    edge = line(0.0, 0.0, 10.0, 0.0)
    assert len(rows(line(10.03, 0.03, 10.03, 0.03), edge, 0.05).edge) == 1
    assert len(rows(line(10.04, 0.04, 10.04, 0.04), edge, 0.05).edge) == 0


def test_the_nearest_edge_and_its_duplicate_are_marked() -> None:
    edges = np.vstack([line(0, 0.004, 10, 0.004), line(0, 0, 10, 0), line(10, 0, 0, 0)])
    found = rows(line(0, 0, 10, 0), edges)
    assert sorted(found.edge[found.best].tolist()) == [1, 2]


def test_an_edge_with_an_empty_part_has_no_overlap() -> None:
    edge = line(0, 0, 10, 0)
    found = find_overlaps(line(0, 0, 10, 0), edge, np.array([4.0]), np.array([6.0]), 0.01)
    np.testing.assert_allclose(found.along, [[4.0, 6.0]])
    assert len(find_overlaps(edge, edge, np.array([0.0]), np.array([-1.0]), 0.01).curve) == 0


@examples(60)
@given(
    seed=st.integers(0, 10_000),
    kinds=st.tuples(st.booleans(), st.booleans()),
    limit=st.sampled_from([0.01, 0.3]),
)
def test_the_overlaps_equal_those_found_by_sampling(
    seed: int, kinds: tuple[bool, bool], limit: float
) -> None:
    chance = np.random.default_rng(seed)

    def some(bent: bool) -> F64:
        if bent:
            x, y = chance.uniform(-1, 1, 2)
            sweep = chance.uniform(10, 180) * chance.choice([-1, 1])
            return arc(x, y, chance.uniform(4, 6), chance.uniform(0, 360), sweep)
        return line(*chance.uniform(-6, 6, 4))

    curve, edge = some(kinds[0]), some(kinds[1])
    found = rows(curve, edge, limit)
    along = np.linspace(0.0, curve[0, 5], 4001)
    dense = point_at(np.repeat(edge, 20001, axis=0), np.linspace(0, edge[0, 5], 20001))
    points = point_at(np.repeat(curve, len(along), axis=0), along)
    shared = np.zeros(len(along), bool)
    for first, last in found.along:
        shared |= (along >= first - 1e-9) & (along <= last + 1e-9)
    for point, claimed in zip(points[::40], shared[::40], strict=True):
        off = np.hypot(*(dense - point).T).min()
        if claimed:
            # A stretch ends at the edge's ends square to it; nothing in it is farther off.
            assert off <= limit * 1.5 + 1e-3
        elif off < limit - 1e-3:
            ends = np.hypot(*(dense[[0, -1]] - point).T).min()
            assert ends <= limit + 1e-3
