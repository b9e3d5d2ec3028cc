"""Jobs for the demo table with toolpaths computed by hand, without the engines."""

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


class ToolpathBuilder:
    """Builds a toolpath move by move, from the machine's zero at travel height."""

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
    ) -> ToolpathBuilder:
        pairs = zip((x, y, z, c), self.poses[-1], strict=True)
        x, y, z, c = (old if new is None else new for new, old in pairs)
        self.poses.append((x, y, z, c))
        self.rows.append((station, motion, bulge, 0.0 if motion == Motion.RAPID else feed))
        return self

    def toolpath(self) -> Toolpath:
        rows = [(motion, feed, station) for station, motion, _, feed in self.rows]
        return toolpath(self.poses, rows, bulge=[row[2] for row in self.rows])

    def program(self) -> bytes:
        return process(self.toolpath(), TABLE, "linuxcnc", notes=["placement X20 Y20"]).text


def add_cuts(builder: ToolpathBuilder) -> ToolpathBuilder:
    """Add the cuts of a 100 × 60 blank at (120, 70) with two round corners of radius 10."""
    builder.to(1, Motion.RAPID, 120, 70, 20, 0).to(1, Motion.RAPID, z=4)
    builder.to(1, Motion.PLUNGE, z=-0.3)
    builder.to(1, Motion.FEED, 210, 70).to(1, Motion.FEED, 220, 80, c=90, bulge=QUARTER)
    builder.to(1, Motion.FEED, 220, 120).to(1, Motion.FEED, 210, 130, c=180, bulge=QUARTER)
    builder.to(1, Motion.FEED, 120, 130)
    builder.to(1, Motion.SWIVEL, c=270, feed=72000.0)
    builder.to(1, Motion.FEED, 120, 70).to(1, Motion.LIFT, z=4)
    return builder.to(1, Motion.RAPID, z=20)


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


def add_creases(builder: ToolpathBuilder) -> ToolpathBuilder:
    """Add two creases across the blank, set back by 3.9 mm, the second one downwards."""
    builder.to(2, Motion.RAPID, 150, 73.9, 20, 90).to(2, Motion.RAPID, z=4)
    builder.to(2, Motion.PLUNGE, z=1.6).to(2, Motion.FEED, y=126.1).to(2, Motion.LIFT, z=20)
    # A wheel works in both directions: C may stay at 90 on the way back.
    builder.to(2, Motion.RAPID, 160, 126.1).to(2, Motion.PLUNGE, z=1.6)
    return builder.to(2, Motion.FEED, y=73.9).to(2, Motion.LIFT, z=20)


CREASES = ([((130, 50), (130, 110)), ((140, 110), (140, 50))], [0, 0], [LineType.CREASE] * 2)


def add_groove(builder: ToolpathBuilder) -> ToolpathBuilder:
    """Add a groove 1.2 deep from (200, 90) to (200, 110), due north: C = 90, then 270.

    On the first pass the head is 6 mm east and 1.5 mm north of the tip, on the second pass 6 mm
    west and 1.5 mm south.  From 2 mm above the board down to z = 0.8 it moves 3.2 mm sideways
    (45°).
    """
    builder.to(3, Motion.RAPID, 209.2, 91.5, 20, 90).to(3, Motion.RAPID, z=4)
    builder.to(3, Motion.PLUNGE, 206, z=0.8).to(3, Motion.FEED, y=111.5)
    builder.to(3, Motion.LIFT, 209.2, z=4).to(3, Motion.RAPID, z=20)
    builder.to(3, Motion.RAPID, 190.8, 108.5, c=270).to(3, Motion.RAPID, z=4)
    builder.to(3, Motion.PLUNGE, 194, z=0.8).to(3, Motion.FEED, y=88.5)
    return builder.to(3, Motion.LIFT, 190.8, z=4).to(3, Motion.RAPID, z=20)


GROOVE = ([((180, 70), (180, 90))], [0], [LineType.V_GROOVE])

JOBS = {
    "knife": (add_cuts, BLANK),
    "wheel": (add_creases, CREASES),
    "v-cutter": (add_groove, GROOVE),
}


#: Ends, bulges and line types of edges.
Edges = tuple[
    Sequence[tuple[tuple[float, float], tuple[float, float]]], Sequence[float], Sequence[LineType]
]


def concatenate_edges(*parts: Edges) -> Edges:
    """Return the edges of several parts as one list of ends, bulges and line types."""
    return (
        [row for part in parts for row in part[0]],
        [row for part in parts for row in part[1]],
        [row for part in parts for row in part[2]],
    )
