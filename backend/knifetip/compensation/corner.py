"""corner: the type of each convex corner of a cutter's path, and its duration.

    Operation[DiscTool] -> type (n,) and knob k (n,) of the corner at the start of each segment

Type B is an arc that stays in contact with the corner; C is two or three lines with a stop at each
bend; D is line, arc, line, without stop or contact.  "auto" selects the fastest type for each
corner on this machine, and B only if its contact is short enough not to burn the corner.

Source: radius compensation patent of Dalian Jiaotong University (B, C and D types); the times are
our derivation: trapezoidal, with a stop where the direction jumps and v² ≤ a r′ on an arc.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, U8
from knifetip.geometry.path import Paths
from knifetip.model.corners import AS_OTHERS, TYPES
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.offset.transition import Corner

#: Largest turn with two lines (extension); beyond it a third line is inserted (radians).
_SQUARE: Final = np.pi / 2.0
#: Smallest knob: below it a D corner is practically a B corner.
_LEAST: Final = 0.05
_AUTO: Final = TYPES.index("auto")
#: Smallest turn of a corner (radians).
_STRAIGHT: Final = 1e-9


def turns(paths: Paths, side: int) -> F64:
    """Return the turn φ at the start of each segment (radians), > 0 if convex for the tool.

    With u1 the tangent in and u2 out, φ = atan2(−σ u1 × u2, u1 · u2).  Where an open path begins
    there is no corner, and φ is 0.

    Parameters
    ----------
    side
        σ, +1 with the tool left of travel, −1 right.
    """
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    first, last = paths.first[:-1], paths.first[1:] - 1
    before = np.roll(arriving, 1, axis=0)
    before[first] = np.where(paths.closed[:, None], arriving[last], ahead[first])
    cross = before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0]
    angle: F64 = np.arctan2(-side * cross, (before * ahead).sum(axis=1))
    return angle


def extension(turn: F64, radius: float, k: F64) -> tuple[F64, F64]:
    """Return l and r′ of the D type (mm): a line of length l, an arc of radius r′, a line again.

    l = k r tan(φ/2) up to 90°, k (L_C − L_B) / (2 − φ cot(φ/2)) beyond; r′ = r − l cot(φ/2).

    Parameters
    ----------
    turn : (n,) radians, in (0, π]
    radius : mm
    k : (n,), in [0, 1]
    """
    b, c = arc_length(turn, radius), line_length(turn, radius)
    half = turn / 2.0
    cotangent = np.cos(half) / np.sin(half)
    wide = turn > _SQUARE
    gentle = k * radius * np.tan(np.where(wide, 0.0, half))
    sharp = k * (c - b) / np.where(wide, 2.0 - turn * cotangent, 1.0)
    straight: F64 = np.where(wide, sharp, gentle)
    return straight, radius - straight * cotangent


def arc_length(turn: F64, radius: float) -> F64:
    """Return L_B = r φ (mm)."""
    return radius * turn


def line_length(turn: F64, radius: float) -> F64:
    """Return L_C (mm): 2 r tan(φ/2) up to 90°, 2 r (1 + sin(φ/2) − cos(φ/2)) beyond."""
    half = turn / 2.0
    wide = turn > _SQUARE
    bend = 2.0 * radius * np.tan(np.where(wide, 0.0, half))
    chord = 2.0 * radius * (1.0 + np.sin(half) - np.cos(half))
    length: F64 = np.where(wide, chord, bend)
    return length


def lengths(turn: F64, radius: float, k: F64) -> F64:
    """Return the path lengths of types B, C and D (mm), (n, 3); arguments as ``extension``."""
    straight, bend = extension(turn, radius, k)
    return np.stack(
        [arc_length(turn, radius), line_length(turn, radius), 2.0 * straight + bend * turn], axis=1
    )


def contact_time(turn: F64, radius: float, feed: float, acceleration: float) -> F64:
    """Return the contact time of type B at each corner (s); C and D leave it at once."""
    duration: F64 = arc_length(turn, radius) / _round(
        np.full(len(turn), radius), feed, acceleration
    )
    return duration


def durations(turn: F64, radius: float, k: F64, feed: float, acceleration: float) -> F64:
    """Return the duration of each corner as type B, C and D (s), (n, 3).

    It counts the path from B₀ to E₀ and the time lost by slowing down before it and speeding up
    after it: (v − w)² / (2 a v) for each change between feed v and speed w.

    Parameters
    ----------
    turn : (n,) radians, in (0, π]
    radius : mm
    k : (n,), in [0, 1]
    feed : mm/s
    acceleration : mm/s²
        Along the path and across it; infinite to count lengths only.
    """
    way = lengths(turn, radius, k)
    straight, bend = extension(turn, radius, k)

    def changed(speed: F64) -> F64:
        lost: F64 = (feed - speed) ** 2 / (acceleration * feed)
        return lost

    on_b = _round(np.full(len(turn), radius), feed, acceleration)
    on_d = _round(bend, feed, acceleration)
    b = way[:, 0] / on_b + changed(on_b)
    d = 2.0 * straight / feed + bend * turn / on_d + changed(on_d)
    # Beyond 90° there are two bends with a stop at each.
    between = np.where(turn > _SQUARE, way[:, 1] - 2.0 * radius, 0.0)
    reached = between >= feed**2 / acceleration
    stopped = np.where(
        reached,
        between / feed + np.where(between > 0.0, feed / acceleration, 0.0),
        2.0 * np.sqrt(between / acceleration),
    )
    c = (way[:, 1] - between) / feed + changed(np.zeros(len(turn))) + stopped
    return np.stack([b, c, d], axis=1)


def _round(radius: F64, feed: float, acceleration: float) -> F64:
    """Return the speed on arcs (mm/s): v ≤ √(a r′)."""
    if acceleration == np.inf:
        return np.full(len(radius), feed)
    speed: F64 = np.minimum(feed, np.sqrt(acceleration * np.maximum(radius, 0.0)))
    return np.maximum(speed, 1e-9)


def corners(operation: Operation) -> tuple[U8, F64]:
    """Return the type and the knob of the corner at the start of each segment, both (n,).

    "auto" selects the type with the shortest duration, and B only if its contact is not longer than
    the cutter's ``dwell``.  Its knob is limited so that type D keeps the feed where possible:
    k ≤ 1 − v² / (a r), so that r′ ≥ v² / a up to 90°.

    Raises
    ------
    CompensationError
        The corner policy is none of B, C, D and auto, or a knob is outside 0 … 1.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    count = len(operation.paths.bulge)
    k = np.where(np.isnan(operation.k_at), operation.k, operation.k_at)
    within = (k >= 0.0) & (k <= 1.0)
    if not within.all():
        bad = int(np.argmin(within))
        raise CompensationError(
            "corner.bad-k",
            edge=operation.source[bad],
            k=f"{k[bad]:g}",
            source=[str(operation.source[bad])],
        )
    if operation.corner not in TYPES:
        raise CompensationError("corner.unknown-type", type=operation.corner)
    kind = np.where(
        operation.corner_at == AS_OTHERS, TYPES.index(operation.corner), operation.corner_at
    ).astype(np.uint8)
    auto = kind == _AUTO
    if not auto.any():
        return kind, k
    feed, acceleration = operation.feed / 60.0, operation.acceleration
    asked = k
    spare = feed**2 / (acceleration * cutter.radius)
    if 1.0 - spare > _LEAST:
        k = np.where(np.isnan(operation.k_at), np.minimum(k, 1.0 - spare), operation.k_at)
    chosen = np.full(count, Corner.B, np.uint8)
    turn = turns(operation.paths, operation.side)
    rows = np.flatnonzero(turn > _STRAIGHT)
    took = durations(turn[rows], cutter.radius, k[rows], feed, acceleration)
    if cutter.dwell > 0.0:
        burns = contact_time(turn[rows], cutter.radius, feed, acceleration) > cutter.dwell
        took[burns, Corner.B] = np.inf
    chosen[rows] = np.argmin(took, axis=1).astype(np.uint8)
    return np.where(auto, chosen, kind), np.where(auto, k, asked)
