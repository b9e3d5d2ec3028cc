"""Curls at the corners of outlines show the unit of drawings for a laser."""

from __future__ import annotations

import numpy as np

from knifetip import pipeline
from knifetip.units.corner_loops import corner_loops
from tests.support.writers import dxf_text

#: Ten teeth of 10 × 10 mm; at each of the 40 corners a curl of four lines of 0.04 mm.
CURL = np.array([[0, 0], [0.04, 0], [0.04, 0.04], [0, 0.04], [0, 0]])
TEETH = [
    (20.0 * tooth + x, y)
    for tooth in range(10)
    for x, y in ((0.0, 0.0), (0.0, 10.0), (10.0, 10.0), (10.0, 0.0))
]
POINTS = np.concatenate([np.array(corner) + CURL for corner in TEETH])
ENDS = np.stack([POINTS[:-1], POINTS[1:]], axis=1)


def test_each_curl_between_two_lines_is_a_loop() -> None:
    """The first and the last curl have a line on one side only."""
    around = corner_loops(ENDS, np.zeros(len(ENDS)), 190.0)
    np.testing.assert_allclose(around, np.full(38, 0.16), atol=1e-9)


def test_squares_of_their_own_are_no_curls() -> None:
    squares = np.concatenate(
        [np.stack([CURL[:-1], CURL[1:]], axis=1) + 5.0 * number for number in range(40)]
    )
    assert len(corner_loops(squares, np.zeros(160), 195.0)) == 0


def test_a_small_drawing_with_curls_that_states_mm_is_in_mm() -> None:
    """190 mm are short for a carton, but curls of 1.6 mm are wide for a laser."""
    lines = [dxf_text.line(*end.ravel().tolist()) for end in ENDS]
    data = dxf_text.dxf(*lines, units=4)
    assert pipeline.read(data).unit == "mm"
