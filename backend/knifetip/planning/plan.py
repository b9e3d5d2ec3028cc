"""plan: find the operations that make a dieline, in working order.

Creases and V-grooves come first, while the board is uncut and lies firmly.  Half-cuts and
perforations follow.  The cuts come last, layer by layer from the innermost: edges inside a contour
are cut before the contour itself.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import Final

import numpy as np

from knifetip.errors import NoToolForLineType, PlanError
from knifetip.geometry.columns import I32
from knifetip.model.board import Board
from knifetip.model.chosen_work import NOTHING_CHOSEN, ChosenWork
from knifetip.model.corners import Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.operation import Operation
from knifetip.model.tool import Planner
from knifetip.planning.blade_operations import plan_blade_cuts, plan_half_cuts, plan_perforations
from knifetip.planning.boundary import BoardOutline
from knifetip.planning.chosen_bridges import ChosenBridge, check_made
from knifetip.planning.crease_operations import plan_creases
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.dashes import distinct_edges
from knifetip.planning.groove_operations import plan_grooves
from knifetip.planning.milling import apply_choices, plan_milling
from knifetip.planning.setup import Setup

#: Planners that need the edges of all tools at once; the others are called for each tool.
_WITH_ALL_EDGES: Final = (Planner.CREASES, Planner.BLADE_CUTS, Planner.OFFSET_CUTS)


def check_corners(corners: Corners | None, machine: Machine) -> None:
    """Raise ``PlanError`` if the user chose corner types and the machine has no milling cutter."""
    if corners is not None and not machine.offset_cuts:
        raise PlanError("corner.no-cutter", machine=machine.title)


def plan(
    dieline: Dieline,
    machine: Machine,
    board: Board,
    corners: Corners | None = None,
    sheet: BoardOutline | None = None,
    placement: tuple[float, float] = (0.0, 0.0),
    chosen: ChosenWork = NOTHING_CHOSEN,
    bridges: Sequence[ChosenBridge] = (),
) -> list[Operation]:
    """Return the operations that make a dieline, in working order.

    Parameters
    ----------
    dieline
        Edges in sheet coordinates.  Ignored and unclassified edges are skipped.
    machine, board
        Machine that makes the dieline, and the board on its table.
    corners
        How a milling cutter goes round corners; None for the type of corner that is fastest on this
        machine.
    sheet
        Outline of the sheet if it was cut to size (``sheet_outline``), else None.
    placement : mm
        Position of the origin of the drawing on the sheet, for the chosen corners.
    chosen
        What the user has chosen for edges of the dieline.
    bridges
        Bridges that the user has placed.

    Raises
    ------
    PlanError
        A corner choice is near no corner, the machine has no milling cutter for corner choices,
        the head does not travel above the board, or the machine takes no board so thick.
    NoToolForLineType
        No station of the machine makes one of the line types.
    FlankOutside
        A V-groove runs so close to a cut or to the board's edge that its flank would leave the
        board.
    NoRoomForBridges
        A contour has no room for the bridges that the board requires.
    """
    check_corners(corners, machine)
    if board.caliper + machine.clearance > machine.travel_z:
        raise PlanError(
            "board.above-travel",
            caliper=board.caliper,
            machine=machine.title,
            travel=machine.travel_z,
            clearance=machine.clearance,
        )
    if 0.0 < machine.max_caliper < board.caliper:
        raise PlanError(
            "board.too-thick",
            caliper=board.caliper,
            machine=machine.title,
            limit=machine.max_caliper,
        )
    machine = machine.for_board(board)
    line_type = dieline.line_type
    cuts = np.flatnonzero(line_type == LineType.CUT).astype(np.int32)
    cuts = cuts[distinct_edges(dieline.ends[cuts], dieline.bulge[cuts])]
    sides = cut_sides(dieline.ends[cuts], dieline.bulge[cuts])

    @cache
    def outlines() -> tuple[BoardOutline, BoardOutline]:
        return BoardOutline.from_contours(dieline.ends[cuts], dieline.bulge[cuts], sides)

    def rows_of(*types: LineType) -> I32:
        return np.flatnonzero(np.isin(line_type, types)).astype(np.int32)

    work = (
        (LineType.CREASE, rows_of(LineType.CREASE, LineType.COMBI)),
        (LineType.V_GROOVE, rows_of(LineType.V_GROOVE)),
        (LineType.HALF_CUT, rows_of(LineType.HALF_CUT)),
        (LineType.PERFORATION, rows_of(LineType.PERFORATION, LineType.COMBI)),
        (LineType.CUT, cuts),
    )
    planners: Mapping[Planner, Callable[..., Operation | list[Operation]]] = {
        Planner.CREASES: plan_creases,
        Planner.GROOVES: lambda *job: plan_grooves(outlines()[0], sheet, *job),
        Planner.HALF_CUTS: lambda *job: plan_half_cuts(outlines()[1], *job),
        Planner.PERFORATIONS: plan_perforations,
        Planner.BLADE_CUTS: partial(plan_blade_cuts, sides),
        Planner.OFFSET_CUTS: partial(plan_milling, corners or Corners()),
    }
    operations: list[Operation] = []
    for kind, rows in work:
        if len(rows):
            station = machine.station_for(kind, board.caliper)
            if station is None:
                raise NoToolForLineType(
                    "tool.missing",
                    count=len(rows),
                    type=kind.word,
                    machine=machine.title,
                    at_edges=rows,
                )
            setup = Setup(machine, board, station, chosen, bridges)
            planner = station.planner(kind)
            groups = [(rows, setup)]
            if planner not in _WITH_ALL_EDGES:
                groups = [(rows[own], one) for own, one in setup.tool_groups(rows)]
            for own_rows, own_setup in groups:
                planned = planners[planner](dieline, own_rows, own_setup)
                operations += planned if isinstance(planned, list) else [planned]
    check_made(bridges, operations)
    return operations if corners is None else apply_choices(operations, corners, placement)
