"""Knife: the blade on the line, its lead made good at the ends, its turns made in the air.

    Operation[Knife] -> Toolpath, one track along every path

A blade whose leading edge slants by α has cut the top face further than the bottom, where its tip
is: by T tan α over a thickness T.  So a closed path runs over its start by that, an end that meets
another cut likewise, and an end inside a panel, or at a bridge, stops early, where the *top* face
ends.  Round a blank it may come from the waste and go back into it along a quarter of a circle.

A drag knife trails its axis by e: the head stands at tip + e u and swings round the tip at corners.

Source: our derivation; Yang, Du, Shu & Qian, section 5, suggest the like for other tools.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.compensation.tracks import Strokes, headings
from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left
from knifetip.geometry.columns import F64, I32, U8
from knifetip.geometry.path import Paths, point_along, taken, trimmed
from knifetip.model.operation import End, Operation
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion, Toolpath

#: Bulge of a quarter turn to the left: tan(90° / 4).
QUARTER = math.tan(math.pi / 8.0)


def knife(operation: Operation) -> Toolpath:
    """Return the toolpath that cuts along every path.

    Corners sharper than the knife's ``swivel`` angle are turned in the air; at gentler ones the
    blade turns in the board.

    Raises
    ------
    EdgeTooShort
        A cut that ends inside a panel is shorter than the lead of the blade.
    """
    blade = operation.tool
    assert isinstance(blade, Knife)
    paths, rows, motion = _with_ends(operation, blade)
    source = operation.source[rows]
    c_start, c_end = headings(paths)
    z = operation.caliper - operation.depth[rows, 0]
    begins = np.zeros(len(rows), np.bool_)
    begins[paths.first[:-1]] = True
    turned = c_start - np.roll(c_end, 1)
    down = begins | (np.abs(turned) > blade.swivel)
    return Strokes.flat(
        start=np.column_stack([_head(paths.start, c_start, blade), z, c_start]),
        end=np.column_stack([_head(paths.end, c_end, blade), z, c_end]),
        bulge=paths.bulge,
        down=down,
        up=np.roll(down, -1),
        track=paths.path_of,
        source=source,
        height=operation.caliper + operation.clearance,
        # The head of a drag knife swings round its tip; without a trail it only turns.
        swing=np.where(down, 0.0, np.tan(np.radians(turned) / 4.0)) * (blade.trail > 0.0),
        motion=motion,
    ).laid(operation)


def _head(tip: F64, c: F64, blade: Knife) -> F64:
    """Return where the head stands for a tip (n, 2) mm and a heading (n,) degrees."""
    ahead = np.column_stack([np.cos(np.radians(c)), np.sin(np.radians(c))])
    head: F64 = tip + blade.trail * ahead
    return head


def _with_ends(operation: Operation, blade: Knife) -> tuple[Paths, I32, U8]:
    """Return the paths cut back or run over at their ends, and each new segment's old one and kind.

    The kind is the Motion: LEAD_IN, FEED or LEAD_OUT.
    """
    paths, finish = operation.paths, operation.finish
    last = paths.first[1:] - 1
    depth = operation.depth[last, 0]
    lead = blade.lead(1.0) * depth
    overrun = blade.lead(1.0) * np.minimum(depth, operation.caliper)
    length = paths.lengths
    free = (finish == End.FREE) | (finish == End.BRIDGE)
    short = np.flatnonzero(free & (length <= lead))
    if len(short):
        listed = operation.source[last[short]]
        raise EdgeTooShort(
            "cut.too-short",
            edge=listed[0],
            length=length[short[0]],
            lead=lead[short[0]],
            source=[str(row) for row in listed[:10]],
        )
    cut, rows = trimmed(paths, np.zeros(len(paths)), np.where(free, lead, 0.0))
    again, more = _openings(paths, np.where(finish == End.CLOSED, overrun, 0.0))
    beyond, far = _beyond(paths, np.where(finish == End.MEETS, overrun, 0.0))
    closed = (finish == End.CLOSED) & (operation.side != 0)
    leads = _led(paths, np.where(closed, blade.lead_in, 0.0), overrun, operation.side, True)
    exits = _led(paths, np.where(closed, blade.lead_out, 0.0), overrun, operation.side, False)
    parts = [
        (*leads, Motion.LEAD_IN),
        (cut, rows, Motion.FEED),
        (again, more, Motion.FEED),
        (beyond, far, Motion.FEED),
        (*exits, Motion.LEAD_OUT),
    ]
    owner = np.concatenate([part.path_of for part, _, _ in parts])
    order = np.argsort(owner, kind="stable")
    count = np.bincount(owner, minlength=len(paths))
    joined = Paths(
        np.concatenate([part.start for part, _, _ in parts])[order],
        np.concatenate([part.end for part, _, _ in parts])[order],
        np.concatenate([part.bulge for part, _, _ in parts])[order],
        np.concatenate([[0], np.cumsum(count)]),
    )
    motion = np.repeat(
        np.array([kind for _, _, kind in parts], np.uint8), [len(part[1]) for part in parts]
    )
    return joined, np.concatenate([part[1] for part in parts])[order], motion[order]


def _openings(paths: Paths, size: F64) -> tuple[Paths, I32]:
    """Return the first ``size`` mm of every path: what a closed one runs over again."""
    return trimmed(paths, np.zeros(len(paths)), np.maximum(paths.lengths - size, 0.0))


def _beyond(paths: Paths, size: F64) -> tuple[Paths, I32]:
    """Return straight pieces of ``size`` mm that go on from the ends of the paths."""
    last = (paths.first[1:] - 1)[size > 0.0]
    _, ahead = arc.tangents(paths.start[last], paths.end[last], paths.bulge[last])
    ahead /= np.hypot(*ahead.T)[:, None]
    end = paths.end[last] + ahead * size[size > 0.0, None]
    first = np.concatenate([[0], np.cumsum(size > 0.0)])
    return Paths(paths.end[last], end, np.zeros(len(last)), first), last.astype(np.int32)


def _led(paths: Paths, size: F64, overrun: F64, side: int, into: bool) -> tuple[Paths, I32]:
    """Return the quarters of a circle that lead onto closed paths, or off them.

    Parameters
    ----------
    size : (p,) mm
        Along each quarter; 0 for none.
    overrun : (p,) mm
        By which the paths run over their start, to where the blade leaves them.
    side
        On which the waste is: +1 left of travel, -1 right.
    """
    which = np.flatnonzero(size > 0.0).astype(np.int32)
    some, kept = taken(paths, which)
    first = np.concatenate([[0], np.cumsum(size > 0.0)])
    if len(which) == 0:
        return Paths(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), first), kept
    at = np.zeros(len(which)) if into else overrun[which]
    place, heading, row = point_along(some, at)
    ahead = np.column_stack([np.cos(np.radians(heading)), np.sin(np.radians(heading))])
    radius = (size[which] * 2.0 / np.pi)[:, None]
    far = place + radius * (side * left(ahead) - ahead if into else side * left(ahead) + ahead)
    start, end = (far, place) if into else (place, far)
    return Paths(start, end, np.full(len(which), side * QUARTER), first), kept[row]
