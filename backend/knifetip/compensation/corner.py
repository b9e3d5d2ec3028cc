"""corner: choose the type of each convex corner of a cutter's path.

In type B the cutter moves on an arc around the corner and touches it all the time.  Type C consists
of two or three lines, with a stop at each bend.  Type D is a line, an arc and a line; the cutter
does not stop, and leaves the corner at once.  The parameter k of type D goes from 0 (equal to B) to
1 (equal to C).  The policy "auto" selects the fastest type for each corner on the machine, but
type B only if the contact is short enough not to burn the corner.

Type C or D is used at a corner only if every segment of every contour is at least the radius of the
cutter away from the path of the cutter's centre round the corner, and if this path meets no other
part of the offset.  At other corners the offset engine uses type B.

Source: radius compensation patent of Dalian Jiaotong University (B, C and D types).  The durations
are our derivation.  They assume trapezoidal speed profiles with a stop at each jump of direction,
and on an arc of radius r′ a speed of at most √(a r′), with a the acceleration of the machine.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import CompensationError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, U8
from knifetip.geometry.path import Paths
from knifetip.messages import Message
from knifetip.model.corners import AS_OTHERS, TYPES
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.offset.transition import Corner

#: Largest turn for which type C has two lines; beyond it a third line is inserted (radians).
_RIGHT_ANGLE: Final = np.pi / 2.0
#: Smallest useful k: a D corner with a smaller k is practically a B corner.
_MIN_K: Final = 0.05
_AUTO: Final = TYPES.index("auto")
#: Smallest turn that counts as a corner (radians).
_MIN_TURN: Final = 1e-9
#: Number of positions that a message lists.
_LISTED: Final = 10


def turn_angles(paths: Paths, side: int) -> F64:
    """Return the turn φ at the start of each segment, (n,) radians.

    φ > 0 if the path turns away from the tool, so that the tool passes outside the corner.  With u1
    the tangent of the segment before and u2 the tangent of the segment after the corner,
    φ = atan2(−σ u1 × u2, u1 · u2).  The segment before the first segment of a closed path is its
    last one.  At the start of an open path φ is 0.

    Parameters
    ----------
    paths
        Contours with n segments in total.
    side
        σ, +1 if the tool is left of travel, −1 if right.
    """
    ahead, arriving = arc.tangents(paths.start, paths.end, paths.bulge)
    first, last = paths.first[:-1], paths.first[1:] - 1
    before = np.roll(arriving, 1, axis=0)
    before[first] = np.where(paths.closed[:, None], arriving[last], ahead[first])
    cross = before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0]
    angle: F64 = np.arctan2(-side * cross, (before * ahead).sum(axis=1))
    return angle


def d_type_shape(turn: F64, radius: float, k: F64) -> tuple[F64, F64]:
    """Return the dimensions of n corners of type D: a line, an arc and a line round the corner.

    The dimensions are the length l of each of the two lines and the radius r′ of the arc, (n,) mm
    each.  For turns φ ≤ 90°, l = k r tan(φ/2); for greater turns,
    l = k (L_C − L_B) / (2 − φ cot(φ/2)), with L_B = ``b_type_length`` and L_C = ``c_type_length``.
    In both cases r′ = r − l cot(φ/2).

    Parameters
    ----------
    turn : (n,) radians, in (0, π]
        Turn φ of each corner.
    radius : mm
        Radius r of the cutter.
    k : (n,), in [0, 1]
        Shape of type D: 0 gives only an arc around the corner (type B), 1 only lines (type C).
    """
    b, c = b_type_length(turn, radius), c_type_length(turn, radius)
    half = turn / 2.0
    cotangent = np.cos(half) / np.sin(half)
    wide = turn > _RIGHT_ANGLE
    gentle = k * radius * np.tan(np.where(wide, 0.0, half))
    sharp = k * (c - b) / np.where(wide, 2.0 - turn * cotangent, 1.0)
    straight: F64 = np.where(wide, sharp, gentle)
    return straight, radius - straight * cotangent


def b_type_length(turn: F64, radius: float) -> F64:
    """Return the path length L_B = r φ of n corners of type B, (n,) mm.

    In type B the centre of the cutter moves around the corner on an arc with the radius r of the
    cutter.  ``turn`` (n,) is the angle φ of each corner in radians, and ``radius`` is r in mm.
    """
    return radius * turn


def c_type_length(turn: F64, radius: float) -> F64:
    """Return the path length L_C of n corners of type C, (n,) mm.

    In type C the centre of the cutter moves around the corner on two or three lines.
    L_C = 2 r tan(φ/2) for turns φ ≤ 90°, and 2 r (1 + sin(φ/2) − cos(φ/2)) for greater turns.
    ``turn`` (n,) is the angle φ of each corner in radians, and ``radius`` is the radius r of the
    cutter in mm.
    """
    half = turn / 2.0
    wide = turn > _RIGHT_ANGLE
    bend = 2.0 * radius * np.tan(np.where(wide, 0.0, half))
    chord = 2.0 * radius * (1.0 + np.sin(half) - np.cos(half))
    length: F64 = np.where(wide, chord, bend)
    return length


def corner_lengths(turn: F64, radius: float, k: F64) -> F64:
    """Return the length of a cutter's path round each of n corners, in three types, (n, 3) mm.

    The columns are type B (an arc), C (lines) and D (a line, an arc and a line).

    Parameters
    ----------
    turn : (n,) radians, in (0, π]
        Turn of each corner.
    radius : mm
        Radius of the cutter.
    k : (n,), in [0, 1]
        Shape of type D: 0 gives a B corner, 1 a C corner.
    """
    straight, bend = d_type_shape(turn, radius, k)
    return np.stack(
        [b_type_length(turn, radius), c_type_length(turn, radius), 2.0 * straight + bend * turn],
        axis=1,
    )


def contact_time(turn: F64, radius: float, feed: float, acceleration: float) -> F64:
    """Return the time for which a cutter touches each corner in type B, (n,) s.

    In type B the cutter moves around the corner on an arc and touches it all the time; in the other
    types it leaves the corner at once.

    Parameters
    ----------
    turn : (n,) radians
        Turn of each corner.
    radius : mm
        Radius of the cutter.
    feed : mm/s
        Speed of the cutter's centre before and after the corner.
    acceleration : mm/s²
        Largest acceleration across the path, which limits the speed on the arc.
    """
    duration: F64 = b_type_length(turn, radius) / _arc_speed(
        np.full(len(turn), radius), feed, acceleration
    )
    return duration


def corner_durations(turn: F64, radius: float, k: F64, feed: float, acceleration: float) -> F64:
    """Return the time that a cutter needs for each of n corners, in three types, (n, 3) s.

    The columns are type B (an arc), C (lines with a stop at each bend) and D (a line, an arc and a
    line).  The time includes the path around the corner and the time lost by slowing down before it
    and speeding up after it: (v − w)² / (2 a v) for each change between the feed v and a speed w,
    with a the acceleration.

    Parameters
    ----------
    turn : (n,) radians, in (0, π]
        Turn of each corner.
    radius : mm
        Radius of the cutter.
    k : (n,), in [0, 1]
        Shape of type D: 0 gives a B corner, 1 a C corner.
    feed : mm/s
        Speed of the cutter's centre before and after the corner.
    acceleration : mm/s²
        Largest acceleration along the path and across it.  If it is infinite, no time is lost, and
        the durations are the path lengths divided by the feed.
    """
    length = corner_lengths(turn, radius, k)
    straight, bend = d_type_shape(turn, radius, k)

    def time_lost(speed: F64) -> F64:
        """Return the time (s) lost by slowing down from the feed to ``speed`` and back to the feed.

        ``speed`` is in mm/s, one for each corner.
        """
        lost: F64 = (feed - speed) ** 2 / (acceleration * feed)
        return lost

    speed_b = _arc_speed(np.full(len(turn), radius), feed, acceleration)
    speed_d = _arc_speed(bend, feed, acceleration)
    b = length[:, 0] / speed_b + time_lost(speed_b)
    d = 2.0 * straight / feed + bend * turn / speed_d + time_lost(speed_d)
    # Beyond 90° type C has two bends with a stop at each.
    between = np.where(turn > _RIGHT_ANGLE, length[:, 1] - 2.0 * radius, 0.0)
    reached = between >= feed**2 / acceleration
    stopped = np.where(
        reached,
        between / feed + np.where(between > 0.0, feed / acceleration, 0.0),
        2.0 * np.sqrt(between / acceleration),
    )
    c = (length[:, 1] - between) / feed + time_lost(np.zeros(len(turn))) + stopped
    return np.stack([b, c, d], axis=1)


def _arc_speed(radius: F64, feed: float, acceleration: float) -> F64:
    """Return the speed on arcs, (n,) mm/s: the feed, or less if the acceleration requires it.

    On an arc of radius r′ (mm) the acceleration a (mm/s²) permits √(a r′).
    """
    if acceleration == np.inf:
        return np.full(len(radius), feed)
    speed: F64 = np.minimum(feed, np.sqrt(acceleration * np.maximum(radius, 0.0)))
    return np.maximum(speed, 1e-9)


def select_corner_types(operation: Operation) -> tuple[U8, F64]:
    """Return the type and the parameter k of the corner at the start of each segment, both (n,).

    Type B is an arc, C consists of lines with a stop at each bend, and D of a line, an arc and a
    line; k from 0 to 1 sets the shape of type D between B and C.  The operation sets a type and a k
    for all corners, and may set others for single corners.  For the type "auto", the function
    selects the type with the shortest duration.  It selects B only if the cutter touches the corner
    for at most the cutter's ``dwell`` (s), or if the path does not turn away from the tool.

    For "auto" corners, the k of the operation is reduced to at most 1 − v² / (a r), with feed v,
    acceleration a and cutter radius r.  In turns of up to 90° the arc of type D then has a radius
    of at least v² / a, so that the cutter need not slow down.  k is not reduced if this limit is
    0.05 or less, or if k is set for the single corner.

    Raises
    ------
    CompensationError
        The corner type of the operation is none of B, C, D and auto, or a k is outside 0 … 1.
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
            at_edges=operation.source[~within],
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
    requested_k = k
    loss = feed**2 / (acceleration * cutter.radius)
    if 1.0 - loss > _MIN_K:
        k = np.where(np.isnan(operation.k_at), np.minimum(k, 1.0 - loss), operation.k_at)
    chosen = np.full(count, Corner.B, np.uint8)
    turn = turn_angles(operation.paths, operation.side)
    rows = np.flatnonzero(turn > _MIN_TURN)
    duration = corner_durations(turn[rows], cutter.radius, k[rows], feed, acceleration)
    if cutter.dwell > 0.0:
        too_long = contact_time(turn[rows], cutter.radius, feed, acceleration) > cutter.dwell
        duration[too_long, Corner.B] = np.inf
    chosen[rows] = np.argmin(duration, axis=1).astype(np.uint8)
    return np.where(auto, chosen, kind), np.where(auto, k, requested_k)


def replaced_corner_notes(operation: Operation, kind: U8, replaced: I32) -> tuple[Message, ...]:
    """Return a message for each corner type, C and D, that type B replaces at some corners.

    The message contains the number of these corners, and the positions of the first ones.

    Parameters
    ----------
    operation
        The operation with the corners, each at the start of one of its n segments.
    kind : (n,)
        Type of each corner before the replacement, from ``select_corner_types``.
    replaced : (m,)
        Segments with type B at their starts instead of ``kind``.
    """
    notes = []
    for other in (Corner.C, Corner.D):
        position = operation.paths.start[replaced[kind[replaced] == other]]
        if len(position):
            notes.append(
                Message(
                    "corner.replaced",
                    count=len(position),
                    type=other.name,
                    places=list_places(position),
                )
            )
    return tuple(notes)


def list_places(position: F64) -> list[str]:
    """Return the first positions of a message that concerns many, as texts.

    ``position`` (m, 2) are points on the sheet (mm).
    """
    return [f"({x:.2f}, {y:.2f})" for x, y in position[:_LISTED]]
