"""Loops of short edges at corners of outlines, and what cleaning drops of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.checked_cleaning import clean_checked
from knifetip.cleaning.clean import Extent, clean
from knifetip.geometry.columns import F64
from knifetip.messages import render
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.shapes import closed, dieline, edges

CUT, CREASE = LineType.CUT, LineType.CREASE
Point = tuple[float, float]


def corner(size: float, far: Point = (0.0, 0.0)) -> F64:
    """Return a square of 50 mm whose corner at (50, 50) is a curl of a size, in six edges.

    The curl begins at the corner and ends ``far`` from it.
    """
    x, y = 50.0 + far[0], 50.0 + far[1]
    curl = [(50.0, 50.0), (50.0, 50.0 + size), (50.0 + size, 50.0 + size)]
    curl += [(50.0 + size, 50.0 - 0.1 * size), (50.0 + 0.2 * size, 50.0 - 0.1 * size), (x, y)]
    return closed((0.0, 0.0), (50.0, 0.0), *curl, (0.0, 50.0))


def loops(made: Cleaned) -> list[int]:
    """Return the rows of the edges that were dropped as loops."""
    found: list[int] = np.flatnonzero(made.reason == CleaningReason.LOOP).tolist()
    return found


def area(line: Dieline) -> float:
    """Return the area between the cuts of a dieline of straight edges that run round it (mm²)."""
    (x0, y0), (x1, y1) = line.ends[line.line_type == CUT].transpose(1, 2, 0)
    return abs(float((x0 * y1 - x1 * y0).sum())) / 2.0


@pytest.mark.parametrize("line_type", [CUT, CREASE])
@pytest.mark.parametrize("size", [0.06, 0.1, 0.2])
def test_a_curl_at_a_corner_is_dropped(size: float, line_type: LineType) -> None:
    drawn = dieline((line_type, corner(size)))
    made = clean(drawn)
    assert loops(made) == [2, 3, 4, 5, 6]
    assert made.dieline.ends[[1, 7]].tolist() == [[[50, 0], [50, 50]], [[50, 50], [0, 50]]]
    assert render(made.describe(2)) == (
        "the edge was dropped, because it belongs to a loop of at most 0.3 mm at a corner of an "
        "outline, which no tool can follow; the outline is complete without it"
    )
    assert check_cleaning(drawn, made) == []
    assert made.dropped.sum() == pytest.approx(made.dropped[2:7].sum())


@pytest.mark.parametrize(("apart", "is_dropped"), [(0.04, True), (0.06, False)])
def test_the_outline_may_leave_a_loop_beside_the_point_at_which_it_comes(
    apart: float, is_dropped: bool
) -> None:
    y = 50.0 + apart
    curl = closed((50, 50), (50, y), (50.1, 50.1), (50.1, 50))
    open_square = edges(((0, y), (0, 0)), ((0, 0), (50, 0)), ((50, 0), (50, 50)), ((50, y), (0, y)))
    drawn = dieline((CUT, np.concatenate([open_square, curl])))
    made = clean(drawn)
    assert loops(made) == ([4, 5, 6, 7] if is_dropped else [])
    assert check_cleaning(drawn, made) == []
    if is_dropped:
        assert made.moved.max() == pytest.approx(apart, abs=0.001)
        assert area(made.dieline) == pytest.approx(2500.0, abs=3.0)


@pytest.mark.parametrize(
    ("drawn", "why"),
    [
        (dieline((CUT, corner(0.3))), "the curl is larger than 0.3 mm across"),
        (dieline((CUT, corner(0.15, (0.03, 0.0)))), "the curl does not return to its start"),
        (
            dieline(
                (CUT, closed((0, 0), (50, 0), (50, 49.9), (49.97, 49.97), (49.9, 50), (0, 50)))
            ),
            "a corner that is rounded by chords is no loop",
        ),
        (
            dieline(
                (CUT, closed((0, 0), (50, 0), (50, 50), (0, 50))),
                (CUT, closed((20, 20), (20.2, 20), (20.1, 20.1))),
            ),
            "a hole of its own is no loop",
        ),
        (
            dieline(
                (CUT, edges(((0, 0), (20, 0)))), (CUT, closed((20, 0), (20.2, 0), (20.1, 0.1)))
            ),
            "the hole at the end of a slit is 0.2 mm wide",
        ),
        (
            dieline(
                (CREASE, edges(((0, 0), (20, 0)), ((20, 0), (20, 30)))),
                (CUT, closed((20, 0), (20.2, 0), (20.1, 0.1))),
            ),
            "creases lead to the hole, but no cut",
        ),
    ],
    ids=lambda value: value.replace(" ", "-") if isinstance(value, str) else "",
)
def test_other_short_edges_stay(drawn: Dieline, why: str) -> None:
    made = clean(drawn)
    assert loops(made) == [], why
    assert made.dropped.sum() == 0.0


def test_a_curl_at_the_end_of_a_cut_is_dropped_if_it_is_tiny() -> None:
    drawn = dieline(
        (CUT, edges(((0, 0), (20, 0)))), (CUT, closed((20, 0), (20.06, 0.03), (20.06, -0.03)))
    )
    made = clean(drawn)
    assert loops(made) == [1, 2, 3]
    assert made.dieline.ends[0].tolist() == [[0, 0], [20, 0]]
    assert check_cleaning(drawn, made) == []


def test_curls_of_a_hundred_corners_cost_no_other_edge() -> None:
    squares = [corner(0.1) + np.array([70.0 * (k % 10), 70.0 * (k // 10)]) for k in range(100)]
    drawn = dieline(*((CUT, square) for square in squares))
    made = clean_checked(drawn)
    assert made.faults == ()
    assert len(loops(made.cleaned)) == 500
    assert area(made.cleaned.dieline) == pytest.approx(250_000.0, rel=1e-6)


def test_the_verifier_refuses_to_lose_anything_else() -> None:
    """The check finds by itself what may be dropped as a loop."""
    drawn = dieline((CUT, corner(0.1)))
    made = clean(drawn)

    def faults(changed: Cleaned, line: Dieline = drawn) -> set[str]:
        return {one.message.code for one in check_cleaning(line, changed)}

    assert faults(made) == set()
    # One of the edges that meet at the corner is dropped, too.
    cleaned = made.stretches.cleaned.copy()
    cleaned[made.stretches.row == 7] = -1
    kinds = made.dieline.line_type.copy()
    kinds[7] = LineType.IGNORED
    lost = replace(
        made,
        stretches=replace(made.stretches, cleaned=cleaned),
        dieline=replace(made.dieline, line_type=kinds),
    )
    assert "verify.cleaning-dropped" in faults(lost)
    # The same loop, drawn three times as large.
    large = dieline((CUT, corner(0.33)))
    same = clean(drawn)
    stretched = replace(same, dieline=replace(same.dieline))
    assert "verify.cleaning-dropped" in faults(stretched, large)
    assert loops(clean(drawn, Extent.LOOPED)) == []
