"""Record of the points at which a tool may start the paths of an operation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64, I32, freeze


@dataclass(frozen=True, eq=False, slots=True)
class ContourStarts:
    """The possible starts of p paths, k in total, at least one for each path.

    A closed path may have several possible starts, an open path has one.
    """

    first: I32  #: (p + 1,) first start of each path; the last entry is k
    segment: I32  #: (k,) segment of the operation with which the path begins
    entry: F64  #: (k, 3) x, y (mm) and c (degrees) where the tool enters the board
    leave: F64  #: (k, 3) x, y (mm) and c (degrees) where the tool leaves the board

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "first", freeze(self.first, np.int32, -1))
        put(self, "segment", freeze(self.segment, np.int32, int(self.first[-1])))
        put(self, "entry", freeze(self.entry, np.float64, len(self.segment), 3))
        put(self, "leave", freeze(self.leave, np.float64, len(self.segment), 3))
