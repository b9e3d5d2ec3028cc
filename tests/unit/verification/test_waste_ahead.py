"""Ends of cuts ahead of which waste lies."""

from __future__ import annotations

import pytest

from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.waste_ahead import waste_ahead
from tests.support.programs.handwritten import CUT, dieline

SQUARE = ((0, 0, 100, 0), (100, 0, 100, 100), (100, 100, 0, 100), (0, 100, 0, 0))


def finish_at_waste(x0: float, y0: float, x1: float, y1: float) -> bool:
    """Return whether waste lies ahead of the finish of a line beside a square part."""
    drawn = dieline(*((CUT, *side, 0.0) for side in SQUARE), (CUT, x0, y0, x1, y1, 0.0))
    cuts = place_edges(drawn, (0.0, 0.0))
    return bool(waste_ahead(cuts.select(cuts.row[4:].astype("int64")), cuts)[1])


def test_waste_lies_ahead_of_a_slit_that_ends_on_the_outline() -> None:
    assert finish_at_waste(50, 50, 50, 100)
    assert not finish_at_waste(50, 150, 50, 100)


@pytest.mark.parametrize("before_corner", [0.035, 0.0499, 0.051, 1.0])
def test_no_waste_lies_ahead_of_a_cut_along_the_outline(before_corner: float) -> None:
    # The next side of the outline is farther from the end than lines that touch.
    assert not finish_at_waste(60, 100.04, before_corner, 100.04)
