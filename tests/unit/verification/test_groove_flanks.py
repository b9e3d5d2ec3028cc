"""Cuts beside V-grooves that a flank damages."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip.model.dieline import LineType
from knifetip.verification.checks.groove.flanks import DamagedCuts, damaged_cuts
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import BOARD, CUT, MACHINE, PLACEMENT, dieline

GROOVE = LineType.V_GROOVE
#: 1.3 mm deep at 45°.
REACH = 1.3


def damaged_beside_groove(
    *edges: tuple[LineType, float, float, float, float, float], out: float = 0.0
) -> DamagedCuts:
    """Return the cuts that a flank damages beside a groove from (0, 0) to (100, 0), or other
    grooves.

    ``out`` is the run-out of the grooves at both ends (mm).
    """
    grooves = [edge for edge in edges if edge[0] == GROOVE] or [(GROOVE, 0, 0, 100, 0, 0.0)]
    drawn = place_edges(dieline(*grooves, *(e for e in edges if e[0] != GROOVE)), (0.0, 0.0))
    spare = np.full((len(grooves), 2), out)
    return damaged_cuts(drawn.with_types(GROOVE), drawn.with_types(CUT), REACH, spare)


@pytest.mark.parametrize("aside", [0.1, 0.5, 1.0, 1.25, -0.1, -1.25])
def test_a_parallel_cut_inside_the_strip_is_found_on_either_side(aside: float) -> None:
    # Drawn backwards, and longer than the groove.
    found = damaged_beside_groove((CUT, 120, aside, -20, aside, 0.0))
    assert found.nearest == pytest.approx([abs(aside)])


@pytest.mark.parametrize("aside", [1.31, -1.31, 5.0])
def test_a_parallel_cut_outside_the_strip_is_not_found(aside: float) -> None:
    assert len(damaged_beside_groove((CUT, 120, aside, -20, aside, 0.0)).cut) == 0


def test_the_place_is_where_the_cut_is_nearest() -> None:
    found = damaged_beside_groove((CUT, 40, 1.2, 60, 0.6, 0.0))
    assert found.nearest == pytest.approx([0.6])
    assert found.place == pytest.approx([60.0])


@pytest.mark.parametrize(("top", "through"), [(1.29, 0.01), (0.3, 1.0), (1.31, None)])
def test_an_arc_counts_by_its_nearest_point(top: float, through: float | None) -> None:
    # A semicircle of r 20 whose lowest point is at (50, top).
    found = damaged_beside_groove((CUT, 30, 20 + top, 70, 20 + top, 1.0))
    if through is None:
        assert len(found.cut) == 0
    else:
        assert REACH - found.nearest == pytest.approx([through], abs=2e-3)
        assert found.place == pytest.approx([50.0], abs=0.5)


def test_a_round_groove_has_a_round_strip() -> None:
    # r 100 round (0, 100), a quarter; a cut along a circle of r 99 and one of r 98.
    quarter = math.tan(math.radians(90.0) / 4.0)
    groove = (GROOVE, 0, 0, 100, 100, quarter)
    # The middle of the groove, where a cut of the same centre is 1 mm nearer to it.
    for radius, near in ((99.0, [1.0]), (98.0, [])):
        a, b = (
            (radius * math.sin(math.radians(s)), 100 - radius * math.cos(math.radians(s)))
            for s in (30.0, 60.0)
        )
        cut = (CUT, *a, *b, math.tan(math.radians(30.0) / 4.0))
        assert damaged_beside_groove(groove, cut).nearest == pytest.approx(near, abs=2e-3)


@pytest.mark.parametrize(
    "cut",
    [
        (CUT, 100, -20, 100, 20, 0.0),  # ends on it
        (CUT, 102, -20, 102, 20, 0.0),  # ends before it
        (CUT, 98, -20, 98, 20, 0.0),  # runs out over it
        (CUT, 100, 0, 160, 0, 0.0),  # continues the groove as a cut
        (CUT, 90, -20, 110, 20, 0.0),  # oblique
        (CUT, 90, 20, 110, -20, 0.0),
        (CUT, 50, -20, 50, 20, 0.0),  # lies across
        (CUT, 49.8, -0.5, 50.2, 0.5, 0.0),
        (CUT, 20, 10, 80, 10, 0.0),  # far beside the groove
        (CUT, 110, 0.5, 160, 0.5, 0.0),  # beside the extension of the groove
    ],
)
def test_a_cut_that_a_groove_ends_on_or_crosses_is_not_damaged(
    cut: tuple[LineType, float, float, float, float, float],
) -> None:
    assert len(damaged_beside_groove(cut).cut) == 0


def test_at_a_flat_angle_only_the_run_out_is_left_out() -> None:
    # An edge at 10° through the end: the flanks leave it 1.3 / tan 10° = 7.37 mm before.
    flat = (CUT, 100 - 50, -50 * math.tan(math.radians(10.0)), 100 + 9, 1.587, 0.0)
    assert len(damaged_beside_groove(flat).cut) == 1
    assert len(damaged_beside_groove(flat, out=REACH / math.tan(math.radians(10.0))).cut) == 0


def test_a_cut_beside_a_groove_is_found_although_another_ends_it() -> None:
    found = damaged_beside_groove((CUT, 100, -20, 100, 20, 0.0), (CUT, 60, 0.5, 90, 0.5, 0.0))
    assert found.cut.tolist() == [1]


def test_a_short_groove_beside_a_cut_is_found_although_it_is_shorter_than_its_ends() -> None:
    found = damaged_beside_groove((GROOVE, 10, 0, 14, 0, 0.0), (CUT, 0, 0.5, 100, 0.5, 0.0))
    assert found.nearest == pytest.approx([0.5])


def test_each_pair_of_groove_and_cut_is_reported_once() -> None:
    found = damaged_beside_groove(
        (GROOVE, 0, 0, 100, 0, 0.0),
        (GROOVE, 0, 50, 100, 50, 0.0),
        (CUT, 10, 0.5, 20, 0.5, 0.2),
        (CUT, 10, 50.5, 90, 49.9, 0.0),
    )
    assert list(zip(found.groove.tolist(), found.cut.tolist(), strict=True)) == [(0, 0), (1, 1)]


def test_the_finding_has_both_edges_and_the_measure() -> None:
    drawn = dieline((GROOVE, 20, 30, 60, 30, 0.0), (CUT, 10, 30.5, 70, 30.5, 0.0))
    found = verify(b"M2\n", drawn, PLACEMENT, MACHINE, BOARD).findings
    (finding,) = [finding for finding in found if "flank" in finding.text]
    assert finding.edge == 0
    assert finding.measure == pytest.approx(0.8)
    assert finding.text.startswith(
        "Edge 0: A flank of the V-groove reaches 0.800 mm sideways past the cut at edge 1"
    )
