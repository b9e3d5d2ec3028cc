"""The verifier's depth of a crease by its direction to the grain: 0.6 along, 0.8 across."""

import math

import numpy as np
import pytest

from knifetip.verification.expectation.crease_depth import depth_range, depth_towards
from knifetip.verification.expectation.edges import place_edges
from tests.support.programs.handwritten import BOARD, CREASE, dieline

#: Quarter of a circle with its left turn from the direction X (across) to Y (along the grain).
QUARTER = math.tan(math.radians(90.0) / 4.0)


def range_of(
    start: tuple[float, float],
    end: tuple[float, float],
    bulge: float = 0.0,
    part: tuple[float, float] = (0.0, 1.0),
) -> tuple[float, float]:
    curve = place_edges(dieline((CREASE, *start, *end, bulge)), (0.0, 0.0)).curve
    low, high = depth_range(curve, curve[:, 5:] * np.array([part]), BOARD)
    return float(low[0]), float(high[0])


def test_a_crease_along_the_grain_is_shallower_than_one_across_it() -> None:
    # At 45° half way between: sin² 45° = 1/2.
    directions = np.array([90.0, 270.0, 0.0, -180.0, 45.0, 120.0])
    np.testing.assert_allclose(
        depth_towards(directions, BOARD), [0.6, 0.6, 0.8, 0.8, 0.7, 0.65], atol=1e-12
    )


def test_a_line_has_one_depth() -> None:
    assert range_of((0, 0), (30, 30)) == pytest.approx((0.7, 0.7))
    assert range_of((0, 0), (0, -30)) == pytest.approx((0.6, 0.6))


@pytest.mark.parametrize(
    ("part", "depths"),
    [
        ((0.0, 1.0), (0.6, 0.8)),
        ((1.0, 0.0), (0.6, 0.8)),
        ((0.0, 0.5), (0.7, 0.8)),
        ((1.0 / 3.0, 2.0 / 3.0), (0.65, 0.75)),
    ],
    ids=["all", "reversed", "first half", "middle"],
)
def test_the_depth_along_an_arc_follows_its_tangent(
    part: tuple[float, float], depths: tuple[float, float]
) -> None:
    assert range_of((0, 0), (50, 50), QUARTER, part) == pytest.approx(depths)


def test_an_arc_reaches_its_extreme_depth_where_it_runs_along_or_across_the_grain() -> None:
    # Between tangents of 45° and 135° the depth is 0.7 at both ends and 0.6 in the middle.
    assert range_of((0, 0), (0, 50), QUARTER) == pytest.approx((0.6, 0.7))
    # A half circle with equal depths at both ends and in the middle of each half.
    assert range_of((0, 0), (50, 0), 1.0) == pytest.approx((0.6, 0.8))
    assert range_of((0, 0), (50, 0), -1.0) == pytest.approx((0.6, 0.8))
