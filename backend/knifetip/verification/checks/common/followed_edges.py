"""Find the edges that tip paths follow: on the edge, or for a cutter beside it."""

from __future__ import annotations

import math

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.model.machine import Station
from knifetip.model.tool import Knife
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import cutter_paths, disc_reach
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.outline import find_outlines
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import expected_tool


def followed_edges(
    context: CheckContext, edges: Edges, station: Station, own: TipPaths
) -> Overlaps:
    """Return the stretches in which tip paths of a station follow edges.

    A path that only crosses an edge, or runs on past the end of another one, does not follow it.
    """
    found = follow_edges(context, edges, station, own)
    size = np.diff(found.along)[:, 0]
    path_size = own.curve[found.curve, 5]
    follows = found.best & (size > _longest_overrun(context, station))
    follows &= size > 0.5 * np.minimum(path_size, edges.curve[found.edge, 5])
    follows &= np.abs(np.diff(found.place)[:, 0]) >= 0.5 * size
    return found.select(follows)


def _longest_overrun(context: CheckContext, station: Station) -> float:
    """Return the greatest length by which a knife runs on past the end of a cut (mm); 0 for a
    cutter.
    """
    if not isinstance(station.tool, Knife):
        return 0.0
    depth = context.board.caliper + context.machine.into_mat
    return depth * math.tan(math.radians(station.tool.blade_angle)) + context.tolerance


def follow_edges(context: CheckContext, edges: Edges, station: Station, own: TipPaths) -> Overlaps:
    """Return the overlaps of tip paths with edges, or with the paths of a cutter beside them.

    ``own`` are tip paths of the tool of a station.
    """
    if expected_tool(station.tool).disc is None:
        return edges.find_overlaps(own.curve, context.tolerance)
    bounds = find_outlines(context.edges.with_types(LineType.CUT))
    beside = cutter_paths(bounds, disc_reach(context.board, station))
    size = beside.curve[:, 5]
    found = find_overlaps(own.curve, beside.curve, np.zeros(len(size)), size, context.tolerance)
    low, high = beside.edge_intervals(found.edge, found.place)
    row = bounds.edges.row[beside.edge[found.edge]]
    index = np.full(int(context.edges.row.max(initial=0)) + 1, -1)
    index[edges.row] = np.arange(len(edges))
    known = index[row] >= 0
    place = np.column_stack([low, high])
    result = Overlaps(
        found.curve, index[row].astype(np.int32), found.along, place, found.distance, found.best
    )
    return result.select(known)


def edge_stations(context: CheckContext, work: TipPaths, rows: I64, edges: Edges) -> I64:
    """Return the index of the station that covers the greatest length of each of n edges, (n,).

    A station covers the part of an edge that tip paths of its tool follow.  An edge without tip
    paths gets the station of a cut that is connected with it, if a cutter makes it, else the first
    of the stations that have tip paths, or -1 if there are none.

    Parameters
    ----------
    work, rows
        Tip paths of the program, and the indices of the tip paths that are considered.
    edges
        The n edges.
    """
    stations = np.unique(work.station[rows])
    if len(stations) < 2:
        return np.full(len(edges), stations[0] if len(stations) else -1, np.int64)
    total = np.zeros((len(edges), len(stations)))
    mask = np.zeros(len(work.z), np.bool_)
    mask[rows] = True
    for column, index in enumerate(stations.tolist()):
        station = context.machine.stations[index]
        own = work.select(mask & (work.station == index))
        near = follow_edges(context, edges, station, own)
        # A wheel that presses one point covers no length; count it with a small one.
        size = np.abs(near.place[:, 1] - near.place[:, 0]) + 1e-6
        np.add.at(total[:, column], near.edge, size)
        if expected_tool(station.tool).disc is not None:
            total[:, column] += 1e-9 * _connected_length(context, edges, total[:, column])
    result: I64 = stations[total.argmax(axis=1)].astype(np.int64)
    return result


def _connected_length(context: CheckContext, edges: Edges, covered: F64) -> F64:
    """Return the sum of ``covered``, (n,) mm, over the cuts connected with each of n cuts, (n,)."""
    cuts = context.edges.with_types(LineType.CUT)
    component = np.zeros(int(context.edges.row.max(initial=0)) + 1, np.int64)
    component[cuts.row] = find_outlines(cuts).component
    own = component[edges.row]
    total: F64 = np.bincount(own, covered).astype(np.float64)
    return total[own]
