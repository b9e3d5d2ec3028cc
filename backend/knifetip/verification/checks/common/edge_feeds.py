"""Check the feed along edges for which the user has chosen a part of the tool's feed.

A move may have the feed of the tool, or a chosen part of it: ``least_parts``.
``motion.moves`` checks the moves that fit no part.  Along an edge, the tool must not be faster than
chosen there.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.messages import Message
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import LineType
from knifetip.model.job_options import EdgeFeed
from knifetip.model.machine import Machine
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import followed_edges
from knifetip.verification.checks.motion.feed_kernels import feed_faults
from knifetip.verification.checks.motion.move_columns import move_columns, tool_columns
from knifetip.verification.columns import F64
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths, TipPoses
from knifetip.verification.reading.moves import Moves

_TYPES = (LineType.CUT, LineType.HALF_CUT, LineType.PERFORATION)


def least_parts(moves: Moves, tip: TipPoses, machine: Machine, chosen: ChosenWork) -> F64:
    """Return the least chosen part of the tool's feed that each move may have, (n,).

    It is 1 for a move that fits no chosen part, and for all moves if nothing is chosen.
    """
    parts = np.ones(len(moves.line))
    if EdgeFeed not in chosen:
        return parts
    columns, tools = move_columns(moves, tip), tool_columns(machine, moves.resolution)
    given = set(chosen[EdgeFeed].numbers("factor", 1.0).tolist())
    for part in sorted(given - {1.0}, reverse=True):
        slow = tools._replace(feed=part * tools.feed)
        faults = feed_faults(
            columns, slow, moves.uses_tool_table, moves.shortest / 60.0, moves.resolution
        )
        parts[faults == 0] = part
    return parts


def without_slowed(moves: Moves, parts: F64) -> Moves:
    """Return the moves without the feeds that fit chosen parts, which need no other check."""
    if not (parts < 1.0).any():
        return moves
    return replace(moves, feed=np.where(parts < 1.0, np.nan, moves.feed))


def check_edge_feeds(context: CheckContext, paths: TipPaths, moves: Moves, parts: F64) -> None:
    """Add a finding for each tip path along an edge that is faster than chosen for the edge.

    Parameters
    ----------
    paths
        The tip paths of the program itself.
    moves, parts
        The moves of the program, and the parts of the tool's feed that they have, (n,).
    """
    if EdgeFeed not in context.chosen:
        return
    wanted = context.chosen[EdgeFeed].numbers("factor", 1.0)
    edges = context.edges.with_types(*_TYPES)
    edges = edges.select(np.flatnonzero(wanted[edges.row] < 1.0))
    part_of_line = np.zeros(int(moves.line.max(initial=0)) + 1)
    np.maximum.at(part_of_line, moves.line, parts)
    for index in np.unique(paths.station):
        station = context.machine.stations[int(index)]
        own = paths.select(paths.station == index)
        found = followed_edges(context, edges, station, own)
        part = part_of_line[own.line[found.curve]]
        limit = wanted[edges.row[found.edge]]
        for row in np.flatnonzero(part > limit)[:MAX_FINDINGS]:
            message = Message(
                "verify.wrong-feed",
                station=station.number,
                feed=part[row] * station.tool.feed,
                planned=limit[row] * station.tool.feed,
            )
            measure = (part[row] - limit[row]) * station.tool.feed
            line = int(own.line[found.curve[row]]) + context.lines_before
            edge = int(edges.row[found.edge[row]])
            context.findings.add("feed", message, measure, edge=edge, line=line)
