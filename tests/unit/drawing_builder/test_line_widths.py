"""Line widths of paths in the unit of a drawing."""

from __future__ import annotations

import numpy as np
from numpy.testing import assert_allclose

from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.line_widths import add_line_widths, enlargements, hundredths

CUT, FOLD = Style("CUT", 1, -1, "Continuous"), Style("FOLD", 5, -1, "dashed")


def test_widths_are_rounded_to_hundredths() -> None:
    widths = np.array([0.5, 0.176, 0.0, 0.004, -1.0, np.nan, np.inf, 1e9])
    assert hundredths(widths).tolist() == [50, 18, 0, 0, -1, -1, 1_000_000, 1_000_000]


def test_a_matrix_enlarges_a_width_by_the_mean_of_both_scales() -> None:
    matrix = [(2, 0, 0, 2, 5, 5), (0, 3, -3, 0, 0, 0), (1, 0, 0, 4, 0, 0), (0, 0, 0, 0, 9, 9)]
    assert_allclose(enlargements(np.array(matrix, float)), [2.0, 3.0, 2.0, 0.0])
    assert enlargements(np.zeros((0, 6))).tolist() == []


def test_styles_are_divided_by_width_and_keep_their_order() -> None:
    style, widths = np.array([1, 0, 1, 0], np.int32), np.array([0.5, 0.2, 0.18, 0.204])
    styles, number = add_line_widths([CUT, FOLD], style, widths)
    assert number.tolist() == [0, 1, 2, 1]
    assert styles == [
        FOLD._replace(line_width=50),
        CUT._replace(line_width=20),
        FOLD._replace(line_width=18),
    ]


def test_no_path_gives_no_style() -> None:
    styles, number = add_line_widths([CUT], np.zeros(0, np.int32), np.zeros(0))
    assert (styles, len(number)) == ([], 0)
