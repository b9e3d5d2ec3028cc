"""arc_to_chords: replace the arcs of V-grooves by chords that a straight blade can cut.

A chord of angle φ deviates from an arc of radius R at two points.  In its middle the deviation is
the sagitta R (1 - cos φ/2).  Beyond its end, where a blade of width 2r continues straight, it is
√((R cos φ/2)² + (R sin φ/2 + 2r)²) - R.  The board's ``groove_curve`` limits both deviations.

Both formulas were derived for knifetip.
"""

from __future__ import annotations

import numpy as np

from knifetip.errors import CurvedGroove
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.tolerance import BULGE
from knifetip.model.tool import VCutter


def widest_chord_angle(radius: F64, cutter: VCutter, error: float) -> F64:
    """Return the greatest angle that a chord of each arc may span, (n,) radians.

    A V-groove that is cut along such a chord deviates from its arc by at most ``error`` mm.  The
    angle is zero or negative if the blade of ``cutter`` is too wide for the arc.  ``radius`` is the
    radius of each of the n arcs, (n,) mm.
    """
    blade = 2.0 * cutter.half_width
    middle = 2.0 * np.arccos(np.clip(1.0 - error / radius, -1.0, 1.0))
    if blade == 0.0:
        return middle
    # The deviation beyond the end (see the module), solved for sin φ/2.
    past = (2.0 * radius * error + error**2 - blade**2) / (2.0 * blade * radius)
    return np.minimum(middle, 2.0 * np.arcsin(np.clip(past, -1.0, 1.0)))


def arcs_to_chords(
    ends: F64, bulge: F64, rows: I32, cutter: VCutter, error: float
) -> tuple[F64, F64, I32, float]:
    """Replace each arc among the grooves by chords of equal length.

    Parameters
    ----------
    ends, bulge, rows : (n, 2, 2) mm, (n,) and (n,)
        Start and end points, and bulges, of the grooves, and their rows in the dieline.
    cutter
        The tool, whose blade continues straight beyond the end of each chord.
    error : mm
        Greatest permitted deviation from an arc; 0 permits no chords.

    Returns
    -------
    ends, bulge, rows : (m, 2, 2) mm, (m,) and (m,)
        Straight grooves, and the row in the dieline of each.
    joint : degrees
        Greatest angle between two neighbouring chords.

    Raises
    ------
    CurvedGroove
        An arc is too tight for the blade, or no chords are permitted.
    """
    bent = np.abs(bulge) >= BULGE
    if error <= 0.0 and bent.any():
        curved = rows[bent]
        raise CurvedGroove("groove.curved", count=len(curved), edge=curved[0], at_edges=curved)
    start, end = ends[:, 0], ends[:, 1]
    sweep = np.abs(arc.sweep(bulge))
    radius = np.where(bent, arc.radius(start, end, bulge), 1.0)
    angle = np.where(bent, widest_chord_angle(radius, cutter, error), 1.0)
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
            at_edges=rows[tight],
        )
    many = count.astype(np.int64)
    owner = np.repeat(np.arange(len(rows)), many)
    ordinal = np.arange(len(owner)) - np.repeat(np.cumsum(many) - many, many)
    arcs = start[owner], end[owner], bulge[owner]
    low = arc.point_at(*arcs, ordinal / many[owner])
    high = arc.point_at(*arcs, (ordinal + 1) / many[owner])
    straight = ~bent[owner]
    low[straight], high[straight] = start[owner[straight]], end[owner[straight]]
    sharpest = float(np.degrees(np.where(bent, sweep / count, 0.0).max(initial=0.0)))
    return np.stack([low, high], axis=1), np.zeros(len(owner)), rows[owner], sharpest
