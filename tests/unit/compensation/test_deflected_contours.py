"""Deflections of random open and closed contours, compared with brute force at many points."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.compensation.centre_paths import centre_paths
from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.model.operation import End
from tests.support.contours import depth_in_band, distance, random_contour
from tests.support.operations import contour


@pytest.mark.parametrize("is_open", [False, True], ids=["closed", "open"])
@pytest.mark.parametrize("seed", range(20))
def test_the_deflected_cutter_touches_the_contour_and_does_not_enter_it(
    seed: int, is_open: bool
) -> None:
    random = np.random.default_rng(seed)
    paths = random_contour(seed, is_open=is_open)
    radius = float(10.0 ** random.uniform(-0.2, 1.0))
    deflection = tuple((radius * random.uniform(0.0, 0.1, 2)).tolist())
    reach = radius - np.array(deflection)
    end = np.array([End.FREE if is_open else End.CLOSED], np.uint8)
    for side in (1, -1):
        for corner in "BCD":
            operation = contour(
                *paths.start, side=side, r=radius, paths=paths, corner=corner,
                deflection=deflection, start=end, finish=end,
            )  # fmt: skip
            made = centre_paths(operation).paths
            if len(made) == 0:
                continue
            points = arc.points_along(made.start, made.end, made.bulge, 5).reshape(-1, 2)
            assert depth_in_band(points, paths, side, reach).max() < 0.005
            if corner == "B":
                assert distance(points, paths).max() < reach.max() + 0.005


def test_bends_of_a_fine_ellipse_that_the_shift_reverses_are_dropped() -> None:
    # At each corner of type C the lines are shorter than the shift along them.
    angle = np.linspace(0.0, 2.0 * np.pi, 721)[:-1]
    ellipse = np.column_stack([80.0 * np.cos(angle), 50.0 * np.sin(angle)])
    operation = contour(*ellipse, r=3.0, corner="C", deflection=(0.08, 0.05))
    made = centre_paths(operation).paths
    assert made.closed.all()
    points = arc.points_along(made.start, made.end, made.bulge, 3).reshape(-1, 2)
    assert depth_in_band(points, operation.paths, -1, np.array([2.92, 2.95])).max() < 0.005
    assert distance(points, operation.paths).max() < 2.955


def test_equal_deflections_act_like_a_smaller_cutter() -> None:
    paths = random_contour(3)
    soft = centre_paths(contour(*paths.start, r=3.0, paths=paths, deflection=(0.1, 0.1))).paths
    small = centre_paths(contour(*paths.start, r=2.9, paths=paths)).paths
    np.testing.assert_allclose(soft.start, small.start, atol=1e-12)


def test_a_deflection_not_smaller_than_the_radius_is_refused() -> None:
    paths = random_contour(3)
    with pytest.raises(CompensationError, match=r"deflection of 0\.300 mm"):
        centre_paths(contour(*paths.start, r=0.3, paths=paths, deflection=(0.3, 0.1)))
