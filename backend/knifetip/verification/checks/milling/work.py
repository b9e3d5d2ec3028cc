"""The work of one cutter: its cuts, and the paths of its centre."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.expectation.edge_pieces import split_at_junctions
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.outline import CutOutlines, find_outlines
from knifetip.verification.tools import Disc


@dataclass(frozen=True, eq=False, slots=True)
class MilledPaths:
    """n paths of the cutter's centre in the board: lines and arcs, with the height, track, program
    line and permitted corner rounding of each path.
    """

    curve: F64
    z: F64
    track: I64
    line: I32
    blend: F64

    def select(self, rows: I64 | Bool) -> MilledPaths:
        """Return the selected paths; ``rows`` are their indices or their mask."""
        return MilledPaths(
            self.curve[rows], self.z[rows], self.track[rows], self.line[rows], self.blend[rows]
        )


class MilledCuts(NamedTuple):
    """All n cuts that cutters make, and those of one of the cutters."""

    edges: Edges
    owned: Bool  #: (n,) mask of the cuts that the cutter must make


class MillingWork:
    """The paths of one cutter's centre, the cuts that the cutter must make, and those of others.

    Parameters
    ----------
    context
        Inputs and results of the verification.
    cuts
        The cuts; they are divided where the ends of others lie on them.
    centres
        Paths of the cutter's centre.
    tool
        The disc that the cutter removes.
    reach : (2,) mm
        Half-axes of the disc along X and Y in the board.
    slack : mm
        Length up to which an error gives no finding.
    """

    def __init__(
        self,
        context: CheckContext,
        cuts: MilledCuts,
        centres: MilledPaths,
        tool: Disc,
        reach: F64,
        slack: float,
    ) -> None:
        self.context, self.centres, self.tool = context, centres, tool
        self.reach, self.slack, self.tolerance = reach, slack, context.tolerance
        # One part of an edge may be the outline, and another part a slit between two flaps.
        self.edges, owner, self.begin = split_at_junctions(cuts.edges)
        self.size_of_edge = cuts.edges.curve[owner, 5]
        #: mask of the edges that the cutter must make
        self.owned: Bool = cuts.owned[owner]
        self.bounds: CutOutlines = find_outlines(self.edges)
        self.size = self.edges.curve[:, 5]
        self.rounds = np.where(np.isfinite(centres.blend), centres.blend, 0.0)

    @property
    def disc_is_round(self) -> bool:
        """Whether the disc reaches equally far along X and Y."""
        return bool(self.reach[0] == self.reach[1])

    def add_finding(
        self, kind: str, edge: int, message: Message, measure: float, row: int = -1
    ) -> None:
        """Add a finding about an edge and the path in row ``row`` of ``centres``; -1 for none."""
        edge_row = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.centres.line[row]) if row >= 0 else -1
        self.context.findings.add(kind, message, measure, edge=edge_row, line=line)
