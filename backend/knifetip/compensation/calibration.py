"""calibration: fit the deflection of a cutter in a board to a measured test cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.compensation import deflection


@dataclass(frozen=True, slots=True)
class Calibration:
    """Deflection of a cutter in a board along X and Y, fitted to a test cut.

    Also contains the largest difference between the test cut and the fit.
    """

    x: float  #: δx, deflection along X (mm)
    y: float  #: δy, deflection along Y (mm)
    residual: float  #: largest distance of a measured point from its prediction (mm)


def calibrate(
    azimuth: Sequence[float], measured: Sequence[tuple[float, float]], side: int = 1
) -> Calibration:
    """Return the deflection of a cutter, fitted to measured points of a contour that it has cut.

    Parameters
    ----------
    azimuth : (m,) degrees
        Direction of travel along the contour at each measured point; 0 is along +X.
    measured : (m,) pairs (ΔX, ΔY), mm
        Measured position of the cut contour at each point minus its position in the drawing.
    side
        +1 if the cutter ran on the left of the contour in the direction of travel, as in knifetip's
        programs; -1 if on the right.

    Raises
    ------
    CompensationError
        There are no points, a value is not finite, or the points do not determine the deflection or
        give it a wrong sign.  The hint states what to measure or to check.
    """
    angle = np.radians(np.array(azimuth, np.float64))
    tangent = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    displacement = np.array(measured, np.float64).reshape(-1, 2)
    x, y = deflection.fit_deflection(tangent, displacement, side)
    error = displacement - deflection.deflection_at(tangent, side, x, y)
    return Calibration(x, y, float(np.hypot(*error.T).max()))
