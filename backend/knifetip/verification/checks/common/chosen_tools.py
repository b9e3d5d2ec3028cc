"""Check that edges are made by the tools that the user has chosen for them.

The tool that follows the greatest length of an edge must be the chosen one, and no other tool for
the same work may follow the edge.  That the chosen tool follows it completely is checked with all
other edges.
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.job_options import EdgeTool
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import edge_stations, followed_edges
from knifetip.verification.columns import I64
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.expected_work import WORKED_TYPES
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool


def check_chosen_tools(context: CheckContext, paths: TipPaths) -> None:
    """Add a finding for each edge that is not made with the chosen tool.

    ``paths`` are the tip paths of all programs of the sheet, with all passes.
    """
    if EdgeTool not in context.chosen:
        return
    number = context.chosen[EdgeTool].numbers("station", 0.0).astype(np.int64)
    for operation, types in WORKED_TYPES.items():
        edges = context.edges.with_types(*types)
        makers = _stations_for(context, operation)
        # On a combi line, the choice of a wheel is none for the knife.
        edges = edges.select(np.flatnonzero(np.isin(number[edges.row], makers)))
        rows = np.flatnonzero(paths.operation == operation)
        if len(edges) and len(rows):
            _check_operation(context, paths, rows, edges, number[edges.row])


def _stations_for(context: CheckContext, operation: OperationKind) -> list[int]:
    """Return the numbers of the stations whose tools make an operation."""
    result = []
    for station in context.machine.stations:
        tool = expected_tool(station.tool)
        if operation in (tool.through_kind, tool.partial_kind):
            result.append(station.number)
    return result


def _check_operation(
    context: CheckContext, paths: TipPaths, rows: I64, edges: Edges, wanted: I64
) -> None:
    """Add a finding for each of m edges that has another tool than wanted in one operation.

    ``rows``: indices of the tip paths of the operation.
    ``wanted`` (m,): number of the station that is chosen for each edge.
    """
    numbers = np.array([station.number for station in context.machine.stations])
    owner = numbers[edge_stations(context, paths, rows, edges)]
    found = np.where(owner == wanted, 0, owner)
    mask = np.zeros(len(paths.z), np.bool_)
    mask[rows] = True
    for index in np.unique(paths.station[rows]).tolist():
        station = context.machine.stations[index]
        own = paths.select(mask & (paths.station == index))
        others = np.flatnonzero(wanted != station.number)
        followed = followed_edges(context, edges.select(others), station, own)
        found[others[followed.edge]] = station.number
    for edge in np.flatnonzero(found)[:MAX_FINDINGS]:
        row = int(edges.row[edge])
        message = Message(
            "verify.other-tool", edge=row, station=int(wanted[edge]), found=int(found[edge])
        )
        context.findings.add("tool", message, float(edges.curve[edge, 5]), edge=row)
