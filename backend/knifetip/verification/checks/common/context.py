"""The record of inputs and results that all checks use, and the tolerances of the checks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.edge_figures import EdgeFigures
from knifetip.model.job_options import CutDepth
from knifetip.model.machine import Machine
from knifetip.model.verdict import UnreachedAreas
from knifetip.verification.checks.common.stretch_figures import record_greatest
from knifetip.verification.columns import F64, I32
from knifetip.verification.expectation.chosen_bridges import ExpectedBridge
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.sheet_area import SheetArea
from knifetip.verification.findings import Findings
from knifetip.verification.trailing_blade import Swivels

#: A depth that differs from the planned depth by more than this is wrong (mm): one unit of the last
#: digit of a program.
DEPTH_TOLERANCE: Final = 1e-4
#: The same for a crease along a curve, whose planned depth changes with its direction (mm).
CURVED_DEPTH_TOLERANCE: Final = 0.005
#: A tip path farther than this from every edge is stray; a nearer one is a deviation (mm).
NEAR_EDGE: Final = 2.0
#: Smallest tolerance for a length that is computed from printed numbers (mm).
MIN_SLACK: Final = 5e-4
#: Rounding both ends of a move to the last digit turns it by up to this / length (mm).
PRINT_TURN: Final = 1.5e-4


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class MeasuredFigures(EdgeFigures):
    """The figures of the edges of the dieline while the checks measure them."""

    def record_deviation(self, rows: I32, distance: F64, blend: F64, fit_error: F64) -> F64:
        """Record the three parts of the deviation of k stretches of edges; return the sums, (k,).

        An infinite ``blend``, which is a fault of the program, is recorded as 0.

        Parameters
        ----------
        rows : (k,)
            Row in the dieline of the edge of each stretch.
        distance : (k,) mm
            Greatest distance of the tip path from the edge.
        blend : (k,) mm
            Distance by which the controller may round the tip path.
        fit_error : (k,) mm
            Distance of the edge from the curve of the file.
        """
        blend = np.where(np.isfinite(blend), blend, 0.0)
        total: F64 = distance + blend + fit_error
        record_greatest(rows, total, self.deviation)
        record_greatest(rows, distance, self.path_deviation)
        record_greatest(rows, blend, self.blending)
        record_greatest(rows, fit_error, self.fit_error)
        return total

    def copy_rows(self, source: I32, target: I32) -> None:
        """Copy the figures of k edges to k other edges, in place.

        ``source`` and ``target`` are the row indices of these edges in the dieline, (k,) each.
        """
        for column in self.columns().values():
            column[target] = column[source]


@dataclass(frozen=True, eq=False, slots=True)
class CheckContext:
    """Inputs and results of all checks of one program.

    The inputs are the edges, the machine, the board and the tolerance.  The checks add their
    findings and the measured figures of the edges to this record.
    """

    edges: Edges  #: all edges on the sheet
    machine: Machine
    board: Board
    tolerance: float  #: mm, including the rounding of printed points
    figures: MeasuredFigures
    findings: Findings
    fit_error: F64  #: (n,) mm, distance of each edge of the dieline from the curve of the file
    programmed: str = "XYZC"  #: the axes that the program moves
    resolution: float = 0.0  #: greatest shift of a printed point by rounding (mm)
    height_resolution: float = 0.0  #: greatest shift of a printed height by rounding (mm)
    sheet: SheetArea | None = None  #: the sheet if it was cut to size
    #: program lines of earlier programs for the same sheet, which have the lowest numbers
    lines_before: int = 0
    #: what the user has chosen for the edges of the dieline
    chosen: ChosenWork = field(default_factory=dict)
    #: places at which free blades turn about their tips
    swivels: Swivels = field(default_factory=Swivels.none)
    bridges: Sequence[ExpectedBridge] = ()  #: bridges that the user has placed
    #: rows of the dieline, positions (fraction of the edge), distances to the left of it (mm)
    samples: list[tuple[I32, F64, F64]] = field(default_factory=list)
    unreached: list[UnreachedAreas] = field(
        default_factory=list
    )  #: areas of each cutter, in sheet coordinates

    @property
    def has_passes(self) -> bool:
        """Whether the user has chosen several passes for an edge."""
        if CutDepth not in self.chosen:
            return False
        return bool((self.chosen[CutDepth].numbers("passes", 0.0) > 1.0).any())

    @property
    def depth_tolerance(self) -> float:
        """Greatest error of a depth (mm), including the rounding of printed heights."""
        return DEPTH_TOLERANCE + self.height_resolution
