"""tuck_end: the sample of a reverse tuck-end carton with slit locks."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from knifetip.dxf.samples.contours import (
    CREASE,
    CUT,
    separate_lines,
    sheet_corners,
    shifted_paths,
    split_paths,
    thumb_notch,
)
from knifetip.dxf.samples.write import Layer
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.geometry.rounded_contour import closed_contour

_GLUE = 15.0  #: width of the glue flap
_TUCK = 16.0  #: height of a tuck flap
_SLIT = 6.0  #: length of a slit at each end of a tuck flap's crease
#: Distance between creases that fold one over the other.  The dust flaps fold before the lids.
_STEP = 0.5
_EASE = 0.8  #: distance of a lid's sides from the side panels, between which it slides in


def tuck_end_carton(
    length: float = 90.0, width: float = 45.0, depth: float = 130.0
) -> list[tuple[Layer, Paths]]:
    """Return the layers, with their paths, of a reverse tuck-end carton with slit locks.

    The carton is for folding boxboard up to 0.5 mm.  Its panels from the left: glue flap, front,
    side, back, side.  The upper lid is attached to the back panel and its tuck flap is inserted
    behind the front panel; the lower lid is attached to the front panel and is inserted behind the
    back panel.  The slits in each lid hold the shoulders of the dust flaps.

    Parameters
    ----------
    length : float, mm
        Width of the front and of the back panel, between creases.
    width : float, mm
        Width of the side panel between the front and the back panel, between creases.
    depth : float, mm
        Height of the carton, between the creases of the two lids.
    """
    return _TuckEndCarton(length, width, depth).layers()


class _TuckEndCarton:
    """A tuck-end carton; for the dimensions (mm) see ``tuck_end_carton``."""

    def __init__(self, length: float, width: float, depth: float) -> None:
        self._width = width
        self._depth = depth
        self._lid = width - _STEP
        # The last panel lies outside the glue flap's fold: narrower, so that its edge does not
        # project.
        #: x of the creases between the panels, and of the last edge
        self._x = _GLUE + np.cumsum([0.0, length, width, length, width - _STEP])
        # Dust flaps fold first, so they fold one step lower than the lids that lie on them.
        #: y of the creases of the lower and of the upper dust flaps
        self._low, self._high = _STEP, depth - _STEP

    def layers(self) -> list[tuple[Layer, Paths]]:
        """Return the layers with their paths; no coordinate is negative."""
        x, low, high = self._x, self._low, self._high
        creases = [(at, low, at, high) for at in x[:4]]
        slits = []
        for left, right, crease, direction in self._lids():
            creases += self._lid_creases(left, right, crease, direction)
            slits += self._lid_slits(left, right, crease, direction)
        creases += [(x[side], at, x[side + 1], at) for at in (low, high) for side in (1, 3)]
        lowest = np.array([0.0, self._lid + _TUCK])
        return [
            (CUT, shifted_paths(split_paths(self._outline()), lowest)),
            (CUT, shifted_paths(separate_lines(slits), lowest)),
            (CREASE, shifted_paths(separate_lines(creases), lowest)),
        ]

    def _lids(self) -> Iterator[tuple[float, float, float, float]]:
        """Yield left x, right x, y of the crease, and direction of the upper and the lower lid.

        The direction is +1 for the upper lid, which points upwards, and -1 for the lower lid.
        """
        yield self._x[2], self._x[3], self._depth, 1.0
        yield self._x[0], self._x[1], 0.0, -1.0

    def _outline(self) -> Paths:
        """Return the outline of the carton as one closed path."""
        x, low, high = self._x, self._low, self._high
        notch = thumb_notch(radius=10.0, depth=7.0, lead=3.0)
        slant = _GLUE * math.tan(math.radians(15.0))
        return closed_contour(
            [(0.0, low + slant, 0.0, 0.0)],
            self._lid_corners(x[0], x[1], 0.0, -1.0),
            self._dust_corners(x[2], x[1], low, -1.0)[::-1],
            sheet_corners(notch, ((x[2] + x[3]) / 2.0, low), (1.0, 0.0)),
            self._dust_corners(x[3], x[4], low, -1.0),
            self._dust_corners(x[4], x[3], high, 1.0),
            self._lid_corners(x[2], x[3], self._depth, 1.0)[::-1],
            self._dust_corners(x[1], x[2], high, 1.0)[::-1],
            sheet_corners(notch, ((x[0] + x[1]) / 2.0, high), (-1.0, 0.0)),
            [(x[0], high, 0.0, 0.0), (0.0, high - slant, 0.0, 0.0)],
        )

    def _lid_corners(self, left: float, right: float, crease: float, direction: float) -> F64:
        """Return the corners of a lid with its tuck flap, from left to right, shape (6, 4).

        The columns are x, y, radius of the fillet at the corner (mm), and bulge of the side after
        the corner.  The lid is between x = ``left`` and x = ``right``, and its crease is at
        y = ``crease``.  ``direction`` is +1 if the lid points upwards from its crease, -1 if it
        points downwards.
        """
        lid = self._lid
        return np.array(
            [
                (left, crease - direction * _STEP, 0.0, 0.0),
                (left + _EASE, crease + direction * lid, 0.0, 0.0),
                (left + _EASE + 0.5, crease + direction * (lid + _TUCK), 11.0, 0.0),
                (right - _EASE - 0.5, crease + direction * (lid + _TUCK), 11.0, 0.0),
                (right - _EASE, crease + direction * lid, 0.0, 0.0),
                (right, crease - direction * _STEP, 0.0, 0.0),
            ]
        )

    def _dust_corners(self, tucked: float, hinged: float, crease: float, direction: float) -> F64:
        """Return the corners of a dust flap, from x = ``tucked`` to x = ``hinged``, shape (6, 4).

        The columns are x, y, radius of the fillet at the corner (mm), and bulge of the side after
        the corner.

        ``tucked``: x of the side of the dust flap beside which the tuck flap of the lid is
        inserted.
        ``hinged``: x of the other side, which is next to the panel to which the lid is attached.
        ``crease``: y of the crease of the dust flap.
        ``direction``: +1 if the dust flap points upwards from its crease, -1 if it points
        downwards.
        """
        reach = (self._width + _TUCK) / 2.0
        shoulder = _SLIT + 2.0
        taper = reach * math.tan(math.radians(15.0))
        sign = math.copysign(1.0, hinged - tucked)
        return np.array(
            [
                (tucked, crease, 0.0, 0.0),
                (tucked, crease + direction * shoulder, 0.0, 0.0),
                (tucked + sign * 3.0, crease + direction * (shoulder + 3.0), 0.0, 0.0),
                (tucked + sign * 4.0, crease + direction * reach, 4.0, 0.0),
                (hinged - sign * taper, crease + direction * reach, 4.0, 0.0),
                (hinged, crease, 0.0, 0.0),
            ]
        )

    def _lid_creases(
        self, left: float, right: float, crease: float, direction: float
    ) -> list[tuple[float, float, float, float]]:
        """Return the creases of a lid and of its tuck flap: x, y of the start and of the end.

        For the parameters see ``_lid_corners``.
        """
        # The lid's sides lean, so its crease begins a little inside the panel.
        lean = _EASE * _STEP / (self._lid + _STEP)
        folds = crease + direction * self._lid
        return [
            (left + lean, crease, right - lean, crease),
            (left + _EASE + _SLIT, folds, right - _EASE - _SLIT, folds),
        ]

    def _lid_slits(
        self, left: float, right: float, crease: float, direction: float
    ) -> list[tuple[float, float, float, float]]:
        """Return the two slits beside the crease of a tuck flap: x, y of the start and of the end.

        For the parameters see ``_lid_corners``.
        """
        folds = crease + direction * self._lid
        return [
            (left + _EASE, folds, left + _EASE + _SLIT, folds),
            (right - _EASE - _SLIT, folds, right - _EASE, folds),
        ]
