"""Check that cuts are made in the passes that the user has chosen.

In n passes down to the depth D, pass number j has the depth D j / n.  Each tip path along the edge
must have one of these depths, and each pass must follow the edge as far as the last one does; that
the last one follows it completely is checked with all other edges.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.job_options import CutDepth
from knifetip.model.machine import Station
from knifetip.model.tool import Knife
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import followed_edges
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.intervals import Overlaps, uncovered_edges
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import expected_tool


@dataclass(frozen=True, eq=False, slots=True)
class _Passes:
    """m edges with a known number of passes."""

    edges: Edges
    count: I64  #: (m,) number of passes
    depth: F64  #: (m,) mm below the top face, of the last pass


def check_chosen_passes(context: CheckContext, paths: TipPaths) -> None:
    """Add a finding for each edge that is not cut in the chosen passes.

    Nothing is checked unless passes or depths are chosen.  Then each edge without a choice must be
    cut in one pass, if its tool needs no more.

    Parameters
    ----------
    paths
        The tip paths of all programs of the sheet, with all passes.
    """
    if CutDepth not in context.chosen:
        return
    for index in np.unique(paths.station):
        station = context.machine.stations[int(index)]
        tool = expected_tool(station.tool)
        if tool.beam is not None or not (tool.disc or isinstance(station.tool, Knife)):
            continue
        own = paths.select(paths.station == index)
        passes = _expected_passes(context, station)
        found = followed_edges(context, passes.edges, station, own)
        _compare(context, passes, found, context.board.caliper - own.z)


def _expected_passes(context: CheckContext, station: Station) -> _Passes:
    """Return the edges of a station's tool with a known number of passes.

    Edges are left out if nothing is chosen for them and the tool may need several passes.
    """
    is_knife = isinstance(station.tool, Knife)
    types = (LineType.CUT, LineType.HALF_CUT) if is_knife else (LineType.CUT,)
    edges = context.edges.with_types(*types)
    chosen = context.chosen[CutDepth]
    count = chosen.numbers("passes", 0.0)[edges.row].astype(np.int64)
    step = getattr(station.tool, "step", 0.0)
    count[(count == 0) & (step == 0.0)] = 1
    usual = np.where(
        edges.line_type == LineType.CUT,
        context.board.caliper + context.machine.into_mat,
        context.board.half_cut_depth,
    )
    depth = chosen.numbers("depth", np.nan)[edges.row]
    depth = np.where(np.isfinite(depth), depth, usual)
    known = np.flatnonzero(count > 0)
    return _Passes(edges.select(known), count[known], depth[known])


def _compare(context: CheckContext, passes: _Passes, found: Overlaps, deep: F64) -> None:
    """Add a finding for each edge that is not cut in its passes.

    ``found`` are the stretches of tip paths that follow the edges, and ``deep`` the depth of each
    tip path below the top face (mm).
    """
    edge, depth = found.edge.astype(np.int64), deep[found.curve]
    increment = passes.depth / passes.count
    number = np.round(depth / increment[edge]).astype(np.int64)
    wrong = np.abs(depth - number * increment[edge]) > context.depth_tolerance
    wrong |= (number < 1) | (number > passes.count[edge])
    bad = np.zeros(len(passes.edges), np.bool_)
    bad[edge[wrong]] = True
    size = passes.edges.curve[:, 5]
    low, high = found.place_range()

    def uncovered(mask: Bool) -> F64:
        row, begin, end = uncovered_edges(edge[mask], low[mask], high[mask], size)
        return np.bincount(row, end - begin, len(size)).astype(np.float64)

    last = uncovered(number == passes.count[edge])
    for one in range(1, int(passes.count.max(initial=0))):
        missing = uncovered(number == one) > last + 4.0 * context.tolerance
        bad |= missing & (passes.count > one)
    for row in np.flatnonzero(bad)[:MAX_FINDINGS]:
        seen = np.unique(np.round(depth[edge == row], 3)).tolist()
        message = Message(
            "verify.other-passes",
            edge=int(passes.edges.row[row]),
            passes=int(passes.count[row]),
            depth=float(passes.depth[row]),
            found=tuple(f"{one:g}" for one in seen),
        )
        context.findings.add("depth", message, 0.0, edge=int(passes.edges.row[row]))
