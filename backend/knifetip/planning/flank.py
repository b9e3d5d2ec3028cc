"""Flank: whether both flanks of a V-groove stay on the board.

At depth h the flanks meet the top face h tan θ beside the line.  A cut inside the strip between
them would lose its edge: the flank runs through it by h tan θ less its distance from the line.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE, GAP, POINT
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.near import near

#: The chords that stand for an arc stay within this of it (mm).
_CHORD: Final = 0.5 * POINT


@dataclass(frozen=True, eq=False, slots=True)
class _Beside:
    """k chords of cuts near grooves, from ``low`` to ``high`` of each chord inside the strip."""

    path: I64  #: (k,) the groove
    cut: I64  #: (k,) row of the dieline
    along: F64  #: (k, 2) mm from the groove's start, at both ends of the chord
    aside: F64  #: (k, 2) mm to the left of it
    low: F64  #: (k,) share of the chord
    high: F64  #: (k,)

    def taken(self, rows: I64 | Bool) -> _Beside:
        """Return some of the chords."""
        return _Beside(*(getattr(self, name)[rows] for name in self.__slots__))

    def clipped(self, column: F64, least: F64 | float, most: F64 | float) -> _Beside:
        """Return what of the chords has the values of a column, (k, 2), between two limits.

        Nothing is between limits that are the wrong way round.
        """
        first, step = column[:, 0], column[:, 1] - column[:, 0]
        level = np.abs(step) < 1e-12
        safe = np.where(level, 1.0, step)
        one, other = (least - first) / safe, (most - first) / safe
        inside = (first >= least) & (first <= most)
        low = np.where(level, np.where(inside, 0.0, 2.0), np.minimum(one, other))
        high = np.where(level, 1.0, np.maximum(one, other))
        low, high = np.maximum(self.low, low), np.minimum(self.high, high)
        rows = np.flatnonzero((low <= high) & (least <= most))
        cut = self.taken(rows)
        return _Beside(cut.path, cut.cut, cut.along, cut.aside, low[rows], high[rows])

    def at_ends(self, column: F64) -> F64:
        """Return a column, (k, 2), where the chords enter and leave the strip, (k, 2)."""
        share = np.stack([self.low, self.high], axis=1)
        result: F64 = column[:, :1] + (column[:, 1:] - column[:, :1]) * share
        return result


def check_flanks(paths: Paths, source: I32, reach: float, out: F64, dieline: Dieline) -> None:
    """Refuse grooves with a cut so near beside them that a flank runs through its edge.

    Where a groove ends on a cut or runs out over one, its flanks cross it.  At such an end twice
    their reach is left out, and as much as the groove runs out where that is more.  A cut that
    lies across the groove and stays between its flanks loses nothing.

    Parameters
    ----------
    paths, source
        The grooves, each straight, and the edge of each of their segments.
    reach : mm
        Of a flank beside the line.
    out : (p, 2) mm
        By which each groove runs out past its start and its end.

    Raises
    ------
    FlankOutside
        Names the groove and the cut, and by how much the flank runs through it.
    """
    begin, finish = paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]
    length = np.hypot(*(finish - begin).T)
    beside = _beside(begin, finish, reach, dieline)
    # Where a groove runs out over the edge, its other flank left the board as far before it.
    inset = np.maximum(2.0 * reach, out * 1.001 + GAP) * _meets(beside, length, reach, out)
    strip = beside.clipped(beside.aside, POINT - reach, reach - POINT)
    path = strip.path
    strip = strip.clipped(strip.along, inset[path, 0], (length - inset[:, 1])[path])
    strip = strip.taken(~_across(strip, reach))
    if len(strip.path) == 0:
        return
    aside = strip.at_ends(strip.aside)
    nearest = np.where(aside[:, 0] * aside[:, 1] <= 0.0, 0.0, np.abs(aside).min(axis=1))
    worst = int(np.argmin(nearest))
    groove, cut = int(source[paths.first[strip.path[worst]]]), int(strip.cut[worst])
    place = strip.at_ends(strip.along)[worst].mean()
    through = math.ceil(100.0 * (reach - nearest[worst]) - 1e-6) / 100.0
    raise FlankOutside(
        "groove.through-cut-at-it" if nearest[worst] <= GAP else "groove.through-cut",
        groove=groove,
        width=2.0 * reach,
        through=through,
        cut=cut,
        distance=nearest[worst],
        place=place,
        source=[str(groove), str(cut)],
    )


def _beside(begin: F64, finish: F64, reach: float, dieline: Dieline) -> _Beside:
    """Return the chords of the cuts near straight grooves, as seen along each of them."""
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cuts], dieline.bulge[cuts]
    ahead = unit(finish - begin)
    # As far beyond the ends as a cut may lie and still be what the groove ends on.
    first, last = begin - 2.0 * reach * ahead, finish + 2.0 * reach * ahead
    boxes = np.hstack([np.minimum(first, last), np.maximum(first, last)])
    path, cut = near(boxes, arc.bounds(ends[:, 0], ends[:, 1], bulge), reach)

    whole = ends[cut, 0], ends[cut, 1], bulge[cut]
    bent = np.abs(bulge[cut]) >= BULGE
    radius = np.where(bent, arc.radius(*whole), 1.0)
    widest = 2.0 * np.arccos(np.clip(1.0 - _CHORD / radius, 0.0, 1.0))
    pieces = np.where(bent, np.ceil(np.abs(arc.sweep(bulge[cut])) / widest), 1.0).astype(np.int64)
    pair = np.repeat(np.arange(len(cut)), pieces)
    piece = np.arange(len(pair)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    whole = whole[0][pair], whole[1][pair], whole[2][pair]
    sides = []
    for share in (piece / pieces[pair], (piece + 1) / pieces[pair]):
        off = arc.point_at(*whole, share) - begin[path[pair]]
        direction = ahead[path[pair]]
        sides.append(((off * direction).sum(axis=1), (off * left(direction)).sum(axis=1)))
    along, aside = (np.stack(column, axis=1) for column in zip(*sides, strict=True))
    count = len(pair)
    return _Beside(path[pair], cuts[cut[pair]], along, aside, np.zeros(count), np.ones(count))


def _meets(beside: _Beside, length: F64, reach: float, out: F64) -> Bool:
    """Return which ends of the grooves, (p, 2), lie on a cut, just before one or just past one."""
    result = np.zeros((len(length), 2), np.bool_)
    on = beside.clipped(beside.aside, -GAP, GAP)
    past = 2.0 * reach
    inside = np.maximum(past, out * 1.001 + GAP)
    begins = on.clipped(on.along, -past, inside[on.path, 0])
    result[begins.path, 0] = True
    ends = on.clipped(on.along, (length - inside[:, 1])[on.path], (length + past)[on.path])
    result[ends.path, 1] = True
    return result


def _across(strip: _Beside, reach: float) -> Bool:
    """Return which chords are of a cut that crosses the line steeply and reaches neither flank."""
    if len(strip.path) == 0:
        return np.zeros(0, np.bool_)
    pair, group = np.unique(np.stack([strip.path, strip.cut], axis=1), axis=0, return_inverse=True)
    group = group.reshape(-1)
    low, high = np.full((len(pair), 2), np.inf), np.full((len(pair), 2), -np.inf)
    for column, values in enumerate((strip.along, strip.aside)):
        ends = strip.at_ends(values)
        np.minimum.at(low[:, column], group, ends.min(axis=1))
        np.maximum.at(high[:, column], group, ends.max(axis=1))
    crosses = (low[:, 1] <= 0.0) & (high[:, 1] >= 0.0)
    steep = high[:, 0] - low[:, 0] <= high[:, 1] - low[:, 1]
    between = np.maximum(-low[:, 1], high[:, 1]) < reach - 2.0 * POINT
    result: Bool = (crosses & steep & between)[group]
    return result
