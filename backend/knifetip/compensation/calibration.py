"""calibration: the deflection of a cutter in a board, from a measured test cut.

azimuths, measured points -> Calibration
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.compensation import deflection


@dataclass(frozen=True, slots=True)
class Calibration:
    """The deflection of a cutter in a board."""

    x: float  #: δx (mm)
    y: float  #: δy (mm)
    residual: float  #: largest distance of a measured point from what δx and δy predict (mm)


def calibrate(
    azimuth: Sequence[float], measured: Sequence[tuple[float, float]], side: int = 1
) -> Calibration:
    """Return the deflection of a cutter, fitted to points on a contour that it has cut.

    Parameters
    ----------
    azimuth : (m,) degrees
        Direction of travel along the contour at each point, 0 along X.
    measured : (m,) of (ΔX, ΔY) in mm
        Position of the cut contour at each point, minus its position in the drawing.
    side
        +1 if the cutter ran on the left of travel, as in knifetip's programs; -1 on the right.

    Raises
    ------
    CompensationError
        The points do not determine the deflection; the hint names what else to measure.
    """
    angle = np.radians(np.array(azimuth, np.float64))
    tangent = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    moved = np.array(measured, np.float64).reshape(-1, 2)
    x, y = deflection.fit_deflection(tangent, moved, side)
    off = moved - deflection.deflection(tangent, side, x, y)
    return Calibration(x, y, float(np.hypot(*off.T).max()))
