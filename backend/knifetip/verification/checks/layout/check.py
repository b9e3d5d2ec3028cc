"""check: compare the edges on a sheet with the drawings that were placed on it.

The verifier computes the position of each edge from its own drawing, as complex numbers::

    z' = d · z + t,  d = exp(i · turn), where z is first replaced by -conj(z) in a mirror

``t`` moves the lower left corner of the box of the copy to its place.  The box contains an arc up
to the points at which it is parallel to an axis: the point centre + r · u, for a unit vector u
along an axis, is on the arc if it lies on the same side of the chord as the arc.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.layout import Position
from knifetip.model.verdict import Finding
from knifetip.verification.columns import F64

#: Greatest distance of an edge on the sheet from where it belongs (mm).
_TOLERANCE: Final = 1e-4
#: Greatest difference of two bulges.
_BULGE: Final = 1e-9
#: An edge with a smaller bulge is a straight line.
_STRAIGHT: Final = 1e-9

_Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False, slots=True)
class PlacedCopy:
    """One copy of a drawing, and where it belongs on the sheet."""

    drawn: Dieline  #: the edges of the drawing
    position: Position


def check_layout(sheet: Dieline, copies: Sequence[PlacedCopy]) -> list[Finding]:
    """Return faults of the edges on a sheet; none if they are those of all copies, each once.

    Parameters
    ----------
    sheet
        The edges on the sheet: those of each copy in the order of its drawing, without the ignored
        edges, and the copies in their order.
    copies
        The copies.
    """
    findings: list[Finding] = []
    first = 0
    for number, copy in enumerate(copies, start=1):
        drawn = copy.drawn
        wanted = np.flatnonzero(drawn.line_type != LineType.IGNORED)
        rows = slice(first, first + len(wanted))
        first += len(wanted)
        if len(sheet.bulge[rows]) < len(wanted):
            missing = Message("layout.edges-missing", copy=number)
            return [*findings, Finding("layout", missing, 0.0)]
        ends, bulge = _expected(drawn.ends[wanted], drawn.bulge[wanted], copy.position)
        apart = np.abs(_points(sheet.ends[rows]) - ends).max(axis=1, initial=0.0)
        wrong = apart > _TOLERANCE
        wrong |= np.abs(sheet.bulge[rows] - bulge) > _BULGE
        wrong |= sheet.line_type[rows] != drawn.line_type[wanted]
        for row in np.flatnonzero(wrong)[:1].tolist():
            message = Message("layout.edge-elsewhere", copy=number, distance=float(apart[row]))
            findings.append(Finding("layout", message, float(apart[row]), edge=rows.start + row))
    if len(sheet) > first:
        message = Message("layout.edges-added", count=len(sheet) - first)
        findings.append(Finding("layout", message, 0.0, edge=first))
    return findings


def _points(ends: F64) -> _Complex:
    """Return points (…, 2) mm as complex numbers."""
    result: _Complex = ends[..., 0] + 1j * ends[..., 1]
    return result


def _expected(ends: F64, bulge: F64, position: Position) -> tuple[_Complex, F64]:
    """Return the ends (n, 2) and bulges (n,) of n edges of a drawing at a position on the sheet."""
    points = _points(ends)
    if position.mirror:
        points, bulge = -points.conj(), -bulge
    points = points * np.exp(1j * np.radians(position.turn))
    if len(points) == 0:
        return points, bulge
    low = complex(-_reach(points, bulge, -1.0), -_reach(points, bulge, -1.0j))
    return points + (complex(*position.corner) - low), bulge


def _reach(points: _Complex, bulge: F64, direction: complex) -> float:
    """Return the greatest coordinate of n edges along a unit vector (mm)."""

    def along(point: Any) -> Any:
        return (point * np.conj(direction)).real

    result = along(points).max()
    arcs = np.abs(bulge) > _STRAIGHT
    start, end, bulge = points[arcs, 0], points[arcs, 1], bulge[arcs]
    chord = end - start
    centre = (start + end) / 2.0 + 1j * chord * (1.0 - bulge**2) / (4.0 * bulge)
    radius = np.abs(chord) * (1.0 + bulge**2) / (4.0 * np.abs(bulge))
    top = centre + radius * direction
    # An arc with a positive bulge lies to the right of its chord.
    on_arc = (np.conj(chord) * (top - start)).imag * bulge < 0.0
    return float(max(result, along(top[on_arc]).max(initial=-np.inf)))
