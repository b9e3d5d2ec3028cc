"""Paths: many chains of lines and arcs in one set of columns.

Path p has the segments ``first[p] … first[p + 1] - 1``.  Each segment has both its ends, so that
the chains need no separators: a chain is joined where one segment's end is the next one's start.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, Bool, frozen
from knifetip.geometry.tolerance import POINT


@dataclass(frozen=True, eq=False, slots=True)
class Paths:
    """Chains of lines and arcs."""

    start: F64  #: (n, 2) mm, where each segment begins
    end: F64  #: (n, 2) mm, where it ends
    bulge: F64  #: (n,) tan(sweep / 4): 0 a line, > 0 an arc to the left
    first: I32  #: (p + 1,) the first segment of each path, and n

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "start", frozen(self.start, np.float64, -1, 2))
        put(self, "end", frozen(self.end, np.float64, len(self.start), 2))
        put(self, "bulge", frozen(self.bulge, np.float64, len(self.start)))
        put(self, "first", frozen(self.first, np.int32, -1))
        if len(self.first) == 0 or self.first[-1] != len(self.start):
            raise ValueError("first must end with the number of segments")

    def __len__(self) -> int:
        return len(self.first) - 1

    @property
    def path_of(self) -> I32:
        """(n,) The path that each segment belongs to."""
        return np.repeat(np.arange(len(self), dtype=np.int32), np.diff(self.first))

    @property
    def lengths(self) -> F64:
        """(p,) Length along each path (mm)."""
        along = arc.length(self.start, self.end, self.bulge)
        return np.bincount(self.path_of, along, minlength=len(self)).astype(np.float64)

    @property
    def closed(self) -> Bool:
        """(p,) Whether each path ends where it began."""
        gap = self.start[self.first[:-1]] - self.end[self.first[1:] - 1]
        result: Bool = np.hypot(gap[:, 0], gap[:, 1]) < POINT
        return result


def chained(xy: F64, bulge: F64) -> Paths:
    """Return one path through the vertices, (n + 1, 2), with bulges (n,)."""
    return Paths(xy[:-1], xy[1:], bulge, np.array([0, len(bulge)]))
