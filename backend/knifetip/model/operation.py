"""Records of an operation: paths with one line type that one tool machines."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from enum import IntEnum

import numpy as np

from knifetip.geometry.columns import F64, I32, U8, Bool, freeze
from knifetip.geometry.path import Paths, select_paths
from knifetip.model.corners import AS_OTHERS
from knifetip.model.dieline import LineType
from knifetip.model.tool import Tool


class End(IntEnum):
    """Condition at an end of a path: for example free, or in contact with another cut.

    The condition determines whether the tool may cut beyond the end.
    """

    FREE = 0  #: no other path; the tool must not cut beyond the end
    CONTINUED = 1  #: another path of the same tool that continues in the same direction
    MEETS = 2  #: another cut, with waste behind it; the tool may cut beyond the end
    CLOSED = 3  #: the other end of the same path
    BRIDGE = 4  #: a bridge that holds the part; the tool must not cut it
    JUNCTION = 5  #: another cut, with a panel behind it; the tip must stop on that cut


#: No path at all.
NO_PATHS = Paths(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), np.zeros(1, np.int64))


@dataclass(frozen=True, eq=False, slots=True)
class Operation:
    """p paths, with n segments in total, that one tool machines, with feeds and depths.

    All paths have the same line type.  All coordinates are in the coordinate system of the sheet.
    """

    paths: Paths  #: p paths of n segments, which the tip must follow
    line_type: LineType
    tool: Tool
    station: int  #: number of the station in the T word
    #: (n, passes) depth of each pass below the top face of the board (mm); a knife makes only the
    #: first of these passes, and the next ones are operations of their own; a cutter makes those
    #: that are not NaN
    depth: F64
    caliper: float  #: thickness of the board (mm)
    clearance: float  #: height of the tip above the board where plunging begins (mm)
    feed: float  #: mm/min
    plunge: float  #: mm/min
    swivel: float  #: rotation of C while the tool is in the board (degrees/min)
    end_clearance: float  #: setback of a crease at a free end (mm)
    overcut: float  #: maximum overcut of the blade at the ends of a V-groove (mm)
    short_crease: str  #: "press" or "refuse"
    start: U8  #: (p,) End at the start of each path
    finish: U8  #: (p,) End at the end of each path
    source: I32  #: (n,) row of the edge in the dieline
    #: (p, 2) length beyond start and end, past the edge of the board (mm); default 0
    run_out: F64 = field(default_factory=lambda: np.zeros((0, 2)))
    #: (p, 2) depth of a crease exactly at the start and the end of each path (mm); (0, 2) for
    #: other line types
    end_depth: F64 = field(default_factory=lambda: np.zeros((0, 2)))
    turn_limits: tuple[float, float] = (-math.inf, math.inf)  #: limits of the heading C (degrees)
    side: int = 0  #: side of the tool: +1 left of travel, -1 right, 0 on the line
    corner: str = "B"  #: type of convex corners: B, C, D or auto
    k: float = 0.5  #: parameter of type D
    #: (n,) parameter of type D at the start of each segment; NaN for ``k``; default NaN
    k_at: F64 = field(default_factory=lambda: np.zeros(0))
    #: (n,) corner type at the start of each segment: index into ``corners.TYPES``, or ``AS_OTHERS``
    corner_at: U8 = field(default_factory=lambda: np.zeros(0, np.uint8))
    acceleration: float = math.inf  #: lower one of the X and Y axes (mm/s²), for corner type auto
    interference: str = "trim"  #: "trim": leave unreachable areas uncut; or "refuse" the job
    deflection: tuple[float, float] = (0.0, 0.0)  #: δx, δy of a cutter under load (mm)
    #: (k, 3) segment, position of the middle along it (mm), and width (mm) of each bridge
    bridges: F64 = field(default_factory=lambda: np.zeros((0, 3)))
    #: contours of other operations that the leads of a cutter must not enter; default none
    obstacles: Paths = NO_PATHS
    #: (p,) segment with which a closed path should begin (``ContourStarts``); (0,) for any
    begin: I32 = field(default_factory=lambda: np.zeros(0, np.int32))
    #: (p,) segment with which a closed path must begin, at its start for a knife and in its middle
    #: for a cutter; -1 where the user has chosen no start; (0,) if there is none, see ``starts``
    fixed: I32 = field(default_factory=lambda: np.zeros(0, np.int32))
    one_way: bool = False  #: the paths must be cut from their start to their end
    #: (n,) whether a cutter may begin and end a closed path in each segment; default all
    endable: Bool = field(default_factory=lambda: np.zeros(0, np.bool_))

    def __post_init__(self) -> None:
        put, count = object.__setattr__, len(self.paths.bulge)
        corner_parameters = self.k_at if len(self.k_at) else np.full(count, np.nan)
        corner_types = self.corner_at if len(self.corner_at) else np.full(count, AS_OTHERS)
        endable = self.endable if len(self.endable) else np.ones(count, np.bool_)
        run_out = self.run_out if len(self.run_out) else np.zeros((len(self.paths), 2))
        put(self, "depth", freeze(self.depth, np.float64, count, -1))
        put(self, "end_depth", freeze(self.end_depth, np.float64, -1, 2))
        put(self, "start", freeze(self.start, np.uint8, len(self.paths)))
        put(self, "finish", freeze(self.finish, np.uint8, len(self.paths)))
        put(self, "k_at", freeze(corner_parameters, np.float64, count))
        put(self, "corner_at", freeze(corner_types, np.uint8, count))
        put(self, "run_out", freeze(run_out, np.float64, len(self.paths), 2))
        put(self, "bridges", freeze(self.bridges, np.float64, -1, 3))
        put(self, "source", freeze(self.source, np.int32, count))
        put(self, "begin", freeze(self.begin, np.int32, -1))
        put(self, "fixed", freeze(self.fixed, np.int32, -1))
        put(self, "endable", freeze(endable, np.bool_, count))

    @property
    def starts(self) -> I32:
        """Segment with which each closed path must begin, (p,); -1 for the planner's choice."""
        if len(self.fixed):
            return self.fixed
        return np.full(len(self.paths), -1, np.int32)

    def with_paths(self, kept: I32) -> Operation:
        """Return the operation with selected paths only; ``kept`` are their indices, ascending.

        The operation must not have bridges.
        """
        paths, rows = select_paths(self.paths, kept)
        begin = self.begin
        if len(begin):
            begin = np.searchsorted(rows, begin[kept]).astype(np.int32)
        fixed = self.fixed
        if len(fixed):
            fixed = np.where(fixed < 0, -1, np.searchsorted(rows, fixed))[kept]
        return replace(
            self,
            paths=paths,
            depth=self.depth[rows],
            start=self.start[kept],
            finish=self.finish[kept],
            source=self.source[rows],
            run_out=self.run_out[kept],
            end_depth=self.end_depth[kept] if len(self.end_depth) else self.end_depth,
            k_at=self.k_at[rows],
            corner_at=self.corner_at[rows],
            begin=begin,
            fixed=fixed,
            endable=self.endable[rows],
        )
