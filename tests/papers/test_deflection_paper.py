"""Radius paper, part 2, "compensation of the knife quantity": equations 6 to 12, and its misprint.

Slopes are those of the triangles 3-4-5 and 30-60-90, so all values can be checked by hand.
"""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.compensation.deflection import deflection_at, fit_deflection, programmed_centre
from knifetip.errors import CompensationError

STEEP = np.array([[3.0, 4.0]])  # f′ 3, g′ 4: sin a 0.8, cos a 0.6
THIRTY = np.array([[3.0**0.5, 1.0]])  # sin a 0.5, cos a 0.8660254


def test_6_where_the_contour_runs_along_y_the_tool_gives_way_in_x_alone() -> None:
    np.testing.assert_allclose(
        deflection_at(np.array([[0.0, 1.0]]), 1, 0.1, 0.05), [[-0.1, 0.0]], atol=1e-15
    )


def test_7_between_them_it_gives_way_by_sine_and_cosine() -> None:
    # 0.1 sin 30° = 0.05 and 0.05 cos 30° = 0.0433.
    np.testing.assert_allclose(
        deflection_at(THIRTY, 1, 0.1, 0.05), [[-0.05, 0.0433012702]], atol=1e-10
    )


def test_8_where_it_runs_along_x_the_tool_gives_way_in_y_alone() -> None:
    np.testing.assert_allclose(
        deflection_at(np.array([[1.0, 0.0]]), 1, 0.1, 0.05), [[0.0, 0.05]], atol=1e-15
    )


def test_9_any_curve_by_its_derivative_with_the_misprint_mended() -> None:
    # −0.1 · 4/5 and 0.05 · 3/5; the paper's printed ΔXmax cos a would give 0.06.
    np.testing.assert_allclose(deflection_at(STEEP, 1, 0.1, 0.05), [[-0.08, 0.03]], atol=1e-15)


def test_9_on_the_other_side_the_tool_is_pushed_the_other_way() -> None:
    np.testing.assert_allclose(deflection_at(STEEP, -1, 0.1, 0.05), [[0.08, -0.03]], atol=1e-15)


def test_10_one_measured_point_gives_the_largest_deflections() -> None:
    # ΔX₀ −0.02 at sin a₀ 0.5 is δx 0.04; ΔY₀ 0.0433 at cos a₀ 0.866 is δy 0.05.
    x, y = fit_deflection(THIRTY, np.array([[-0.02, 0.0433012702]]), 1)
    assert (x, y) == pytest.approx((0.04, 0.05), abs=1e-10)


def test_11_12_from_one_measured_point_to_every_other() -> None:
    # (12): ΔXe = ΔX₀ sin a / sin a₀ = −0.02 · 0.8 / 0.5, ΔYe = 0.0433 · 0.6 / 0.866.
    x, y = fit_deflection(THIRTY, np.array([[-0.02, 0.0433012702]]), 1)
    np.testing.assert_allclose(deflection_at(STEEP, 1, x, y), [[-0.032, 0.03]], atol=1e-10)


def test_12_is_singular_where_the_paper_divides_by_nothing() -> None:
    with pytest.raises(CompensationError, match="δx") as flat:
        fit_deflection(np.array([[1.0, 0.0]]), np.array([[0.0, 0.05]]), 1)
    assert "runs along Y" in flat.value.hint
    with pytest.raises(CompensationError, match="δy") as upright:
        fit_deflection(np.array([[0.0, 1.0]]), np.array([[-0.1, 0.0]]), 1)
    assert "runs along X" in upright.value.hint


def test_two_points_along_the_axes_serve_where_neither_would_alone() -> None:
    both = np.array([[1.0, 0.0], [0.0, 1.0]])
    assert fit_deflection(both, np.array([[0.0, 0.05], [-0.1, 0.0]]), 1) == pytest.approx(
        (0.1, 0.05)
    )


def test_least_squares_of_two_points_with_errors() -> None:
    # sin 0.6 and 0.8, ΔX −0.059 and −0.082: δx = 0.6 · 0.059 + 0.8 · 0.082 = 0.101 (Σ sin² = 1).
    # cos 0.8 and 0.6, ΔY 0.041 and 0.029: δy = 0.8 · 0.041 + 0.6 · 0.029 = 0.0502.
    tangents = np.array([[8.0, 6.0], [6.0, 8.0]])
    measured = np.array([[-0.059, 0.041], [-0.082, 0.029]])
    assert fit_deflection(tangents, measured, 1) == pytest.approx((0.101, 0.0502))
    assert fit_deflection(tangents, -measured, -1) == pytest.approx((0.101, 0.0502))


def test_5_and_11_together_aim_deeper_by_what_the_board_pushes_back() -> None:
    # n = (−0.8, 0.6): (10 − 0.8 · 2.9, 20 + 0.6 · 2.95); pushed by (−0.08, 0.03) it is at r = 3.
    point = np.array([[10.0, 20.0]])
    centre = programmed_centre(point, STEEP, 1, 3.0, 0.1, 0.05)
    np.testing.assert_allclose(centre, [[7.68, 21.77]], atol=1e-12)
    under_load = centre + np.array([-0.08, 0.03])
    np.testing.assert_allclose(under_load, [[10 - 0.8 * 3, 20 + 0.6 * 3]], atol=1e-12)
    np.testing.assert_allclose(
        programmed_centre(point, STEEP, -1, 3.0, 0.1, 0.05), [[12.32, 18.23]], atol=1e-12
    )
