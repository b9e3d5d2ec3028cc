"""Check that the cutter enters contours along the chosen lead-ins.

A cutter of radius r with a lead-in of length L at the angle φ to the contour moves straight from
the waste to its path beside the contour: by √(L² + r² − 2 L r sin φ) for φ ≥ 0.  For φ < 0 it moves
by L and then round a corner; where no corner has room, it comes perpendicular to the contour, by
L − r.  A lead-in without room is half as long, or left out.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.job_options import ContourLead
from knifetip.model.machine import Station
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import follow_edges
from knifetip.verification.columns import F64, I32
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import expected_tool


def check_chosen_leads(context: CheckContext, paths: TipPaths) -> None:
    """Add a finding for each contour that is entered on another lead-in than the chosen one.

    ``paths`` are the tip paths of all programs of the sheet, with all passes.
    """
    if ContourLead not in context.chosen:
        return
    for index in np.unique(paths.station).tolist():
        station = context.machine.stations[index]
        if expected_tool(station.tool).disc is not None:
            _check_station(context, station, paths.select(paths.station == index))


def longest_chosen_lead(context: CheckContext) -> float:
    """Return the greatest length that is chosen for a lead-in (mm); 0 if there is none."""
    if ContourLead not in context.chosen:
        return 0.0
    return float(context.chosen[ContourLead].numbers("length", 0.0).max(initial=0.0))


def _check_station(context: CheckContext, station: Station, own: TipPaths) -> None:
    """Add a finding for each track of a cutter with another lead-in than the chosen one.

    ``own`` are the paths of the cutter's centre.
    """
    chosen = context.chosen[ContourLead]
    edges = context.edges.with_types(LineType.CUT)
    near = follow_edges(context, edges, station, own)
    size = np.diff(near.along)[:, 0]
    along = near.best & (size > 0.5 * own.curve[near.curve, 5])
    path, edge = near.curve[along], edges.row[near.edge[along]]
    is_chosen = chosen.index[edge] >= 0
    track, first_edge = np.unique(own.track[path[is_chosen]], return_index=True)
    start_of, start = np.unique(own.track, return_index=True)
    first = start[np.searchsorted(start_of, track)]
    # A track that begins beside the contour has no lead-in.
    entered = ~np.isin(first, path)
    first, row = first[entered], edge[is_chosen][first_edge[entered]]
    limit = context.tolerance + 2.0 * context.resolution
    lengths = _possible_lengths(context, station, row)
    found = own.curve[first, 5]
    wrong = np.abs(lengths - found).min(axis=0, initial=math.inf) > limit
    for k in np.flatnonzero(wrong)[:MAX_FINDINGS]:
        message = Message(
            "verify.other-lead",
            edge=int(row[k]),
            length=float(lengths[0, k]),
            found=float(found[k]),
        )
        line = int(own.line[first[k]]) + context.lines_before
        context.findings.add("order", message, float(found[k]), edge=int(row[k]), line=line)


def _possible_lengths(context: CheckContext, station: Station, row: I32) -> F64:
    """Return the possible lengths of the straight moves to m contours, (4, m) mm, the full one
    first.

    ``row`` (m,): row in the dieline of an edge of each contour, for which a lead-in is chosen.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    chosen, r = context.chosen[ContourLead], disc.radius
    length = chosen.numbers("length", disc.entry_length)[row]
    angle = np.radians(chosen.numbers("approach", getattr(station.tool, "approach", 90.0))[row])
    straight = np.sqrt(length**2 + r**2 - 2.0 * length * r * np.sin(np.maximum(angle, 0.0)))
    full = np.where(angle < 0.0, length, straight)
    other = np.where(angle < 0.0, length - r, full)
    result: F64 = np.stack([full, 0.5 * full, other, 0.5 * other])
    return result
