"""rounded_contour: closed contours through corners, with fillets at the corners."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.path import Paths, path_through


def closed_contour(*parts: ArrayLike) -> Paths:
    """Return one closed path through the corners in ``parts``, with fillets at the corners.

    Parameters
    ----------
    *parts : (k, 4)
        Arrays of successive corners: x, y, radius of the fillet at the corner (mm), 0 for none, and
        bulge of the side that follows the corner.  The two sides at a fillet must be straight.
    """
    corners = np.concatenate([np.asarray(part, np.float64) for part in parts])
    repeated = np.hypot(*(corners[:, :2] - np.roll(corners[:, :2], 1, axis=0)).T) < 1e-9
    corners = corners[~repeated]
    at, radius, bulge = corners[:, :2], corners[:, 2], corners[:, 3]
    incoming = unit_vectors(at - np.roll(at, 1, axis=0))
    away = np.roll(incoming, -1, axis=0)
    turn = np.arctan2(
        incoming[:, 0] * away[:, 1] - incoming[:, 1] * away[:, 0], (incoming * away).sum(axis=1)
    )
    back = (radius * np.tan(np.abs(turn) / 2.0))[:, None]
    round_ = radius > 0
    vertices = np.stack([at - back * incoming, at + back * away], axis=1)
    bulges = np.stack([np.where(round_, np.tan(turn / 4.0), bulge), bulge], axis=1)
    kept = np.stack([np.ones_like(round_), round_], axis=1)
    xy = vertices[kept]
    return path_through(np.vstack([xy, xy[:1]]), bulges[kept])
