"""Offsets of random open and closed contours, compared with distances at many points."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.offset.offset_paths import offset_paths
from knifetip.offset.transition import Corner
from tests.support.contours import distance, random_contour


def free_centres(contour: Paths, radius: float, side: int) -> F64:
    """Return centres of discs that touch a contour and do not enter it, (n, 2) mm."""
    rows = np.repeat(np.arange(len(contour.bulge)), 15)
    share = np.tile(np.linspace(0.02, 0.98, 15), len(contour.bulge))
    whole = contour.start[rows], contour.end[rows], contour.bulge[rows]
    part = arc.sub_arc(*whole, share, np.minimum(share + 0.01, 1.0))
    ahead, _ = arc.tangents(*part)
    centre = part[0] + side * radius * left_normal(unit_vectors(ahead))
    free: F64 = centre[distance(centre, contour) > radius - 1e-9]
    return free


@pytest.mark.parametrize("is_open", [False, True], ids=["closed", "open"])
@pytest.mark.parametrize("seed", range(40))
def test_the_disc_touches_the_contour_wherever_it_fits(seed: int, is_open: bool) -> None:
    contour = random_contour(seed, is_open=is_open)
    radius = float(10.0 ** np.random.default_rng(seed).uniform(-0.7, 1.2))
    for side in (1, -1):
        free = free_centres(contour, radius, side)
        for corner in Corner:
            made = offset_paths(contour, radius, side, corner=corner)
            paths = made.paths
            if not is_open:
                assert paths.closed.all()
            points = arc.points_along(paths.start, paths.end, paths.bulge, 9)
            away = distance(points.reshape(-1, 2), contour).reshape(-1, 9)
            assert (away >= radius - 1e-8).all()
            touching = away if corner == Corner.B else away[~made.inserted]
            assert (touching <= radius + 1e-8).all()
            assert (distance(free, paths) < 1e-5).all()
