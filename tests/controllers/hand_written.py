"""Jobs for the demo table, worked by hand, not by the engines: every number can be checked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.library.load import machine
from knifetip.model.dieline import LineType
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.emit import process
from tests.controllers.linuxcnc_rs274 import TipTool
from tests.support.shapes import toolpath

TABLE = machine("demo-table")
CALIPER = 2.0
QUARTER = np.tan(np.pi / 8)

#: The demo table's tools as literals; the V-cutter's tip is 6 mm left of the head, 1.5 behind it.
KNIFE = TipTool("knife", CALIPER, output=0, oscillating=True)
WHEEL = TipTool("wheel", CALIPER, datum=(60.0, 0.0, -1.5, 0.0), output=1, reach=4.0)
V_CUTTER = TipTool(
    "v-cutter", CALIPER, datum=(-60.0, 0.0, 0.0, 0.0), output=2, back=6.0, half_width=1.5, tilt=45.0
)
TOOLS = {1: KNIFE, 2: WHEEL, 3: V_CUTTER}


class Hand:
    """Writes a toolpath move by move, from the machine's zero at the height for rapids."""

    def __init__(self) -> None:
        self.poses: list[tuple[float, float, float, float]] = [(0.0, 0.0, 20.0, 0.0)]
        self.rows: list[tuple[int, Motion, float, float]] = []

    def to(
        self,
        station: int,
        motion: Motion,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        c: float | None = None,
        bulge: float = 0.0,
        feed: float = 12000.0,
    ) -> Hand:
        asked = zip((x, y, z, c), self.poses[-1], strict=True)
        x, y, z, c = (old if new is None else new for new, old in asked)
        self.poses.append((x, y, z, c))
        self.rows.append((station, motion, bulge, 0.0 if motion == Motion.RAPID else feed))
        return self

    def toolpath(self) -> Toolpath:
        rows = [(motion, feed, station) for station, motion, _, feed in self.rows]
        return toolpath(self.poses, rows, bulge=[row[2] for row in self.rows])

    def program(self) -> bytes:
        return process(self.toolpath(), TABLE, "linuxcnc", notes=["placement X20 Y20"]).text


def knife(hand: Hand) -> Hand:
    """A 100 × 60 blank from (120, 70) with two round corners of r 10 and two sharp ones."""
    hand.to(1, Motion.RAPID, 120, 70, 20, 0).to(1, Motion.RAPID, z=4)
    hand.to(1, Motion.PLUNGE, z=-0.3)
    hand.to(1, Motion.FEED, 210, 70).to(1, Motion.FEED, 220, 80, c=90, bulge=QUARTER)
    hand.to(1, Motion.FEED, 220, 120).to(1, Motion.FEED, 210, 130, c=180, bulge=QUARTER)
    hand.to(1, Motion.FEED, 120, 130)
    hand.to(1, Motion.SWIVEL, c=270, feed=72000.0)
    hand.to(1, Motion.FEED, 120, 70).to(1, Motion.LIFT, z=4)
    return hand.to(1, Motion.RAPID, z=20)


BLANK = (
    [
        ((100, 50), (190, 50)),
        ((190, 50), (200, 60)),
        ((200, 60), (200, 100)),
        ((200, 100), (190, 110)),
        ((190, 110), (100, 110)),
        ((100, 110), (100, 50)),
    ],
    [0, QUARTER, 0, QUARTER, 0, 0],
    [LineType.CUT] * 6,
)


def wheel(hand: Hand) -> Hand:
    """Two creases across the blank, set back by 3.9 mm, the second one downwards."""
    hand.to(2, Motion.RAPID, 150, 73.9, 20, 90).to(2, Motion.RAPID, z=4)
    hand.to(2, Motion.PLUNGE, z=1.6).to(2, Motion.FEED, y=126.1).to(2, Motion.LIFT, z=20)
    # The same from both sides: C may stay at 90 on the way back.
    hand.to(2, Motion.RAPID, 160, 126.1).to(2, Motion.PLUNGE, z=1.6)
    return hand.to(2, Motion.FEED, y=73.9).to(2, Motion.LIFT, z=20)


CREASES = ([((130, 50), (130, 110)), ((140, 110), (140, 50))], [0, 0], [LineType.CREASE] * 2)


def groove(hand: Hand) -> Hand:
    """A groove 1.2 deep from (200, 90) to (200, 110), due north: C = 90, then 270.

    Right of north is east: the head stands 6 east and 1.5 north of the tip, then 6 west and 1.5
    south. From 2 mm above the board down to z = 0.8 it comes 3.2 sideways, at 45 degrees.
    """
    hand.to(3, Motion.RAPID, 209.2, 91.5, 20, 90).to(3, Motion.RAPID, z=4)
    hand.to(3, Motion.PLUNGE, 206, z=0.8).to(3, Motion.FEED, y=111.5)
    hand.to(3, Motion.LIFT, 209.2, z=4).to(3, Motion.RAPID, z=20)
    hand.to(3, Motion.RAPID, 190.8, 108.5, c=270).to(3, Motion.RAPID, z=4)
    hand.to(3, Motion.PLUNGE, 194, z=0.8).to(3, Motion.FEED, y=88.5)
    return hand.to(3, Motion.LIFT, 190.8, z=4).to(3, Motion.RAPID, z=20)


GROOVE = ([((180, 70), (180, 90))], [0], [LineType.V_GROOVE])

JOBS = {
    "knife": (knife, BLANK),
    "wheel": (wheel, CREASES),
    "v-cutter": (groove, GROOVE),
}


#: Ends, bulges and line types of edges.
Edges = tuple[
    Sequence[tuple[tuple[float, float], tuple[float, float]]], Sequence[float], Sequence[LineType]
]


def together(*parts: Edges) -> Edges:
    """Return the edges of several parts in one list."""
    return (
        [row for part in parts for row in part[0]],
        [row for part in parts for row in part[1]],
        [row for part in parts for row in part[2]],
    )
