"""Bench: what every comparison has to hand: the edges, the machine, the board, and where to write.

Edges, Machine, Board, tolerance -> EdgeFigures (the verdict's columns) and Findings
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.verdict import Unreached
from knifetip.verification.columns import F64, I32
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.findings import Findings

#: A tool pressed deeper or less deep than planned by more than this is at a wrong depth (mm).
DEPTH_TOLERANCE: Final = 0.005
#: Work farther than this from every edge is not a badly placed edge but a stray (mm).
NEAR_EDGE: Final = 2.0
#: Below this nothing can be asked of a printed number (mm).
MIN_SLACK: Final = 5e-4
#: How far the last printed digit of both ends of a move can turn it, times its length (mm).
PRINT_TURN: Final = 1.5e-4


@dataclass(frozen=True, eq=False, slots=True)
class EdgeFigures:
    """The columns of the verdict, one row to an edge of the dieline (mm)."""

    deviation: F64
    overcut: F64
    uncut: F64
    setback: F64
    width: F64
    web: F64
    flank: F64
    unreached: F64
    bottom_uncut: F64
    top_overcut: F64

    def copied(self, source: I32, target: I32) -> None:
        """Give edges, by their rows in the dieline, the figures of others."""
        for column in (getattr(self, name) for name in self.__slots__):
            column[target] = column[source]

    @classmethod
    def zeros(cls, count: int) -> EdgeFigures:
        """Return figures for edges that nobody has worked."""
        return cls(*(np.zeros(count) for _ in range(10)))


@dataclass(frozen=True, eq=False, slots=True)
class CheckContext:
    """What every comparison needs to hand."""

    edges: Edges  #: all edges on the sheet
    machine: Machine
    board: Board
    tolerance: float  #: mm, the rounding of printed points included
    figures: EdgeFigures
    found: Findings
    programmed: str = "XYZC"  #: the axes that the program moves
    resolution: float = 0.0  #: how far rounding alone moves a printed point (mm)
    #: rows of the dieline, places (share of the edge) and how far left of it the work is (mm)
    samples: list[tuple[I32, F64, F64]] = field(default_factory=list)
    unreached: list[Unreached] = field(default_factory=list)  #: of every cutter, on the sheet
