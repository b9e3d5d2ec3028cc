"""Verdict: does the program cut what was drawn?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64, frozen


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong, with its place and measure."""

    #: deviation, overcut, uncut, stray, depth, heading, feed, travel or program
    kind: str
    text: str  #: in the user's words
    measure: float  #: mm, or degrees for a heading
    edge: int = -1  #: row in Dieline, -1 where it is about none
    line: int = -1  #: 1-based line of the program, -1 where it is about none


@dataclass(frozen=True, eq=False, slots=True)
class Verdict:
    """The judge's answer, edge by edge."""

    accepted: bool
    tolerance: float  #: mm
    deviation: F64  #: (n,) the farthest that the tip is from the edge while working it (mm)
    overcut: F64  #: (n,) how far the tool works past the edge's ends (mm)
    uncut: F64  #: (n,) length of the edge that is not worked and was not planned so (mm)
    setback: F64  #: (n,) length not worked as planned: crease ends, slanted blades (mm)
    findings: tuple[Finding, ...]
    seconds: float  #: nominal machine time of the program: lengths over feeds

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "deviation", frozen(self.deviation, np.float64, -1))
        for name in ("overcut", "uncut", "setback"):
            put(self, name, frozen(getattr(self, name), np.float64, len(self.deviation)))
