"""Chords: a curved groove as straight ones, where the board allows it.

    arcs of V-grooves -> their chords

A straight blade leaves an arc twice: in the middle of a chord by the sagitta R (1 - cos φ/2), and
past its end, where the blade's edge of width 2r runs on straight: there by
√((R cos φ/2)² + (R sin φ/2 + 2r)²) - R.  Neither may be more than the board's ``groove_curve``,
which is the most that either flank stands off its true place.

Source: our derivation.
"""

from __future__ import annotations

import numpy as np

from knifetip.errors import CurvedGroove
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.tolerance import BULGE
from knifetip.model.tool import VCutter


def widest(radius: F64, cutter: VCutter, error: float) -> F64:
    """Return the widest angle (radians) of a chord that keeps within ``error`` mm of its arc.

    Zero or less where the blade is too wide for the radius, (n,) mm.
    """
    blade = 2.0 * cutter.half_width
    middle = 2.0 * np.arccos(np.clip(1.0 - error / radius, -1.0, 1.0))
    if blade == 0.0:
        return middle
    # The second term of the module's text, solved for sin φ/2.
    past = (2.0 * radius * error + error**2 - blade**2) / (2.0 * blade * radius)
    return np.minimum(middle, 2.0 * np.arcsin(np.clip(past, -1.0, 1.0)))


def chorded(
    ends: F64, bulge: F64, rows: I32, cutter: VCutter, error: float
) -> tuple[F64, F64, I32, float]:
    """Return grooves with their arcs cut into chords, their rows, and the sharpest joint (degrees).

    Parameters
    ----------
    ends, bulge, rows : (n, 2, 2) mm, (n,) and (n,)
    error : mm
        The most that the groove may leave its arc.

    Raises
    ------
    CurvedGroove
        An arc is too tight for the blade.
    """
    bent = np.abs(bulge) >= BULGE
    start, end = ends[:, 0], ends[:, 1]
    sweep = np.abs(arc.sweep(bulge))
    radius = np.where(bent, arc.radius(start, end, bulge), 1.0)
    angle = np.where(bent, widest(radius, cutter, error), 1.0)
    count = np.where(bent, np.ceil(sweep / np.maximum(angle, 1e-9) - 1e-9), 1.0)
    chord = 2.0 * radius * np.sin(sweep / count / 2.0)
    tight = np.flatnonzero(bent & ((angle <= 1e-6) | (chord < 2.0 * cutter.half_width)))
    if len(tight):
        row = tight[0]
        raise CurvedGroove(
            "groove.tight-bend",
            edge=rows[row],
            radius=radius[row],
            blade=2.0 * cutter.half_width,
            error=error,
            source=[str(rows[bad]) for bad in tight[:10]],
        )
    many = count.astype(np.int64)
    owner = np.repeat(np.arange(len(rows)), many)
    place = np.arange(len(owner)) - np.repeat(np.cumsum(many) - many, many)
    whole = start[owner], end[owner], bulge[owner]
    low = arc.point_at(*whole, place / many[owner])
    high = arc.point_at(*whole, (place + 1) / many[owner])
    straight = ~bent[owner]
    low[straight], high[straight] = start[owner[straight]], end[owner[straight]]
    sharpest = float(np.degrees(np.where(bent, sweep / count, 0.0).max(initial=0.0)))
    return np.stack([low, high], axis=1), np.zeros(len(owner)), rows[owner], sharpest
