"""Cleaning restores drawings that were damaged on purpose, and the lengths add up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st

from knifetip.cleaning.clean import clean
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, U8
from knifetip.geometry.tolerance import GAP, SAME
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import ImportOutcome
from tests.support.examples import examples
from tests.support.shapes import BY_HAND, rotation

WORK = [LineType.CUT, LineType.CREASE, LineType.V_GROOVE, LineType.PERFORATION, LineType.HALF_CUT]
UNDER = {LineType.CUT: LineType.CREASE, LineType.V_GROOVE: LineType.CREASE}


def drawn(ends: F64, bulge: F64, kind: U8) -> Dieline:
    n = len(bulge)
    rows = np.arange(n, dtype=np.int32)
    return Dieline(ends, bulge, kind, rows, np.zeros_like(rows), np.ones(n), (BY_HAND,))


def worked(line: Dieline) -> Dieline:
    """Return the dieline without its ignored edges."""
    rows = np.flatnonzero(~np.isin(line.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED)))
    return drawn(line.ends[rows], line.bulge[rows], line.line_type[rows])


def taken(line: Dieline, rows: list[int] | I64) -> Dieline:
    return drawn(line.ends[rows], line.bulge[rows], line.line_type[rows])


@st.composite
def dielines(draw: st.DrawFn) -> Dieline:
    """Draw edges between points of a rotated lattice of 10 mm, without overlaps."""
    count = draw(st.integers(1, 12))
    steps = [(1, 0), (0, 1), (1, 1), (1, -1)]
    edges = draw(
        st.lists(
            st.tuples(st.integers(0, 3), st.integers(0, 3), st.sampled_from(steps)),
            min_size=count,
            max_size=count,
            unique=True,
        )
    )
    kind = draw(st.lists(st.sampled_from(WORK), min_size=count, max_size=count))
    bulge = draw(
        st.lists(st.sampled_from([0.0, 0.0, 0.0, 0.3, -0.7]), min_size=count, max_size=count)
    )
    ends = np.array([((x, y), (x + dx, y + dy)) for x, y, (dx, dy) in edges], float) * 10.0
    turn = rotation(draw(st.sampled_from([0.0, 90.0, 13.3, 44.999, 178.9])))
    return drawn(ends @ turn.T, np.array(bulge), np.array(kind, np.uint8))


def assert_same_edges(one: Dieline, other: Dieline, within: float) -> None:
    """Assert that each edge of either dieline equals an edge of the other within a distance
    (mm).
    """
    one, other = worked(one), worked(other)
    assert len(one) == len(other)
    left = list(range(len(other)))
    for row in range(len(one)):
        same = [
            at
            for at in left
            if one.line_type[row] == other.line_type[at] and _apart(one, row, other, at) <= within
        ]
        assert same, (row, one.ends[row].tolist(), other.ends.tolist())
        left.remove(same[0])


def _apart(one: Dieline, row: int, other: Dieline, at: int) -> float:
    half = np.array([0.5])
    ends = other.ends[at]
    middles = [
        arc.point_at(line.ends[[i], 0], line.ends[[i], 1], line.bulge[[i]], half)[0]
        for line, i in ((one, row), (other, at))
    ]
    straight = np.hypot(*(one.ends[row] - ends).T).max()
    turned = np.hypot(*(one.ends[row] - ends[::-1]).T).max()
    return float(max(min(straight, turned), np.hypot(*(middles[0] - middles[1]))))


def assert_adds_up(line: Dieline, made: Cleaned) -> None:
    """Assert that the kept, merged and dropped lengths add up to the drawn length."""
    length = arc.length(line.ends[:, 0], line.ends[:, 1], line.bulge)
    np.testing.assert_allclose(made.kept + made.merged + made.dropped, length, atol=1e-6)
    after = worked(made.dieline)
    total = arc.length(after.ends[:, 0], after.ends[:, 1], after.bulge).sum()
    at_work = made.reason != CleaningReason.NO_WORK
    assert abs(made.kept[at_work].sum() + made.added.sum() - total) < 1e-6
    assert ((made.cleaned_row < 0) == (made.outcome == ImportOutcome.DROPPED)).all()
    assert (made.moved <= GAP + 1e-9).all()
    assert (made.off <= GAP + SAME).all()


def split(line: Dieline, row: int, fractions: list[float]) -> Dieline:
    """Return the dieline with one edge split at fractions of its length.

    The pieces are appended at the end, in reverse order.
    """
    places = np.array([0.0, *sorted(fractions), 1.0])
    n = len(places) - 1
    start, end, bulge = (
        np.repeat(x[[row]], n, axis=0) for x in (line.ends[:, 0], line.ends[:, 1], line.bulge)
    )
    a, b, bent = arc.sub_arc(start, end, bulge, places[:-1], places[1:])
    pieces = np.stack([a, b], axis=1)[::-1]
    keep = np.arange(len(line)) != row
    return drawn(
        np.concatenate([line.ends[keep], pieces]),
        np.concatenate([line.bulge[keep], bent[::-1]]),
        np.concatenate([line.line_type[keep], np.full(n, line.line_type[row])]),
    )


fractions = st.lists(
    st.sampled_from([0.1, 0.25, 1 / 3, 0.5, 0.61, 0.8]), min_size=1, max_size=3, unique=True
)


@examples(60)
@given(line=dielines(), data=st.data())
def test_edges_drawn_twice_split_and_reversed_are_restored(
    line: Dieline, data: st.DataObject
) -> None:
    expected = clean(line).dieline
    row = data.draw(st.integers(0, len(line) - 1))
    broken = line
    if data.draw(st.booleans()):
        broken = split(broken, row, data.draw(fractions))
    twice = data.draw(st.lists(st.integers(0, len(broken) - 1), max_size=6))
    kinds = broken.line_type[twice].copy()
    under = data.draw(st.booleans())
    if under:
        kinds = np.array([UNDER.get(LineType(kind), LineType(kind)) for kind in kinds], np.uint8)
    broken = drawn(
        np.concatenate([broken.ends, broken.ends[twice][:, ::-1]]),
        np.concatenate([broken.bulge, -broken.bulge[twice]]),
        np.concatenate([broken.line_type, kinds]),
    )
    order = data.draw(st.permutations(range(len(broken))))
    broken = taken(broken, list(order))
    made = clean(broken)
    assert_same_edges(made.dieline, expected, 1e-6)
    assert_adds_up(broken, made)


@examples(60)
@given(line=dielines(), data=st.data())
def test_gaps_are_closed_and_debris_is_dropped(line: Dieline, data: st.DataObject) -> None:
    line = taken(line, np.flatnonzero(line.bulge == 0.0))
    assume(len(line))
    expected = clean(line).dieline
    ends = line.ends.copy()
    row, side = data.draw(st.integers(0, len(line) - 1)), data.draw(st.integers(0, 1))
    ahead = ends[row, 1 - side] - ends[row, side]
    ends[row, side] += ahead / np.hypot(*ahead) * data.draw(st.sampled_from([0.003, 0.02, 0.045]))
    at = data.draw(st.integers(0, len(line) - 1))
    place = ends[at].mean(axis=0) + data.draw(st.sampled_from([(0, 0), (0.3, 2.0), (4.0, 0.01)]))
    speck = (place + np.array([[0.0, 0.0], [0.02, 0.03]]))[None]
    broken = drawn(
        np.concatenate([speck, ends]),
        np.zeros(len(line) + 1),
        np.concatenate([[LineType.CUT], line.line_type]),
    )
    made = clean(broken)
    assert_same_edges(made.dieline, expected, GAP)
    assert made.reason[0] == CleaningReason.SPECK
    assert_adds_up(broken, made)


@examples(60)
@given(line=dielines(), data=st.data())
def test_cleaning_is_idempotent(line: Dieline, data: st.DataObject) -> None:
    n = len(line)
    noise = data.draw(st.integers(0, 2**32 - 1))
    size = data.draw(st.sampled_from([0.0, 0.0008, 0.002, 0.004]))
    random = np.random.default_rng(noise)
    twice = random.integers(0, n, n // 2)
    ends = np.concatenate([line.ends, line.ends[twice] * 0.75 + line.ends[twice][:, ::-1] * 0.25])
    broken = drawn(
        ends + random.uniform(-size, size, ends.shape),
        np.concatenate([line.bulge, np.zeros(len(twice))]),
        np.concatenate([line.line_type, line.line_type[twice]]),
    )
    once = clean(broken)
    again = clean(once.dieline)
    np.testing.assert_array_equal(again.dieline.line_type, once.dieline.line_type)
    np.testing.assert_array_equal(again.dieline.ends, once.dieline.ends)
    np.testing.assert_array_equal(again.dieline.bulge, once.dieline.bulge)
    assert_adds_up(broken, once)


@examples(40)
@given(
    line=dielines(),
    row=st.integers(0, 11),
    at=fractions,
    degrees=st.sampled_from([0.0, 30.0, 90.0, 179.0, 211.7]),
    mirror=st.booleans(),
    back=st.booleans(),
)
def test_cleaning_does_not_depend_on_the_rotation_of_the_drawing(
    line: Dieline, row: int, at: list[float], degrees: float, mirror: bool, back: bool
) -> None:
    line = split(line, row % len(line), at)
    turn = rotation(degrees)
    if mirror:
        turn = turn @ np.diag([1.0, -1.0])
    ends, bulge = line.ends @ turn.T, line.bulge * (-1.0 if mirror else 1.0)
    other = drawn(ends[:, ::-1] if back else ends, -bulge if back else bulge, line.line_type)
    one = clean(line).dieline
    expected = replace(one, ends=one.ends @ turn.T, bulge=one.bulge * (-1.0 if mirror else 1.0))
    assert_same_edges(clean(other).dieline, expected, 1e-6)


def _union(line: Dieline) -> shapely.Geometry:
    points = arc.points_along(line.ends[:, 0], line.ends[:, 1], line.bulge, 65)
    return shapely.union_all([shapely.LineString(one) for one in points])


@examples(30)
@given(line=dielines(), data=st.data())
def test_the_union_of_edges_is_the_same_before_and_after(
    line: Dieline, data: st.DataObject
) -> None:
    line = split(line, data.draw(st.integers(0, len(line) - 1)), data.draw(fractions))
    slide = data.draw(st.sampled_from([0.1, 0.5, 0.9]))
    way = line.ends[:, 1] - line.ends[:, 0]
    straight = np.flatnonzero(line.bulge == 0.0)
    shifted = line.ends[straight] + slide * way[straight, None]
    broken = drawn(
        np.concatenate([line.ends, shifted]),
        np.concatenate([line.bulge, np.zeros(len(straight))]),
        np.concatenate([line.line_type, line.line_type[straight]]),
    )
    after = worked(clean(broken).dieline)
    before, now = _union(broken), _union(after)
    assert shapely.hausdorff_distance(before, now) < GAP
    # Without overlaps of different line types, the length equals the length of shapely's union.
    for kind in set(broken.line_type.tolist()):
        mine = worked(taken(broken, np.flatnonzero(broken.line_type == kind)))
        alone = worked(clean(mine).dieline)
        total = arc.length(alone.ends[:, 0], alone.ends[:, 1], alone.bulge).sum()
        flat = shapely.union_all([_union(mine)], grid_size=1e-6).length
        assert abs(total - flat) < 0.02 * len(mine) + 2e-3 * total
