"""chosen_depths: refuse passes and depths that tool, table or controller cannot make."""

from __future__ import annotations

import math

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import I32
from knifetip.languages.registry import find_language
from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import CreaseDepth, CutDepth
from knifetip.model.machine import Machine
from knifetip.model.tool import Cutter, DiscTool, Knife
from knifetip.planning.chosen_rows import chosen_rows
from knifetip.planning.setup import Setup


def check_depths(work: ChosenWork, dieline: Dieline, machine: Machine, board: Board) -> None:
    """Raise ``PlanError`` if a machine cannot make chosen passes or a chosen depth.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges, with the line types that follow from their depths.
    """
    if CutDepth not in work:
        return
    chosen = work[CutDepth]
    sets_depth = find_language(machine.dialect).sets_pose
    for number in range(len(chosen.choices)):
        rows = np.flatnonzero(chosen.index == number).astype(np.int32)
        for line_type in np.unique(dieline.line_type[rows]):
            own = rows[dieline.line_type[rows] == line_type]
            edge, kind = own[0], LineType(line_type)
            if kind not in (LineType.CUT, LineType.HALF_CUT):
                raise PlanError("depth.other-type", edge=edge, type=kind.word, at_edges=own)
            if not sets_depth:
                raise PlanError("depth.not-set", edge=edge, machine=machine.title, at_edges=own)
            station = machine.station_for(LineType.CUT, board.caliper)
            if station is None:
                continue
            for of_tool, setup in Setup(machine, board, station, work).tool_groups(own):
                _check_depth(own[of_tool], kind, setup)


def _check_depth(own: I32, kind: LineType, setup: Setup) -> None:
    """Raise ``PlanError`` if the tool of a setup cannot make edges as is chosen for them.

    ``own``: indices in the dieline of edges of one line type and one choice.
    """
    tool, number, edge = setup.station.tool, setup.station.number, own[0]
    chosen = setup.chosen[CutDepth]
    passes = int(chosen.numbers("passes", 0.0)[edge])
    depth = float(chosen.numbers("depth", math.nan)[edge])
    if math.isfinite(depth) and isinstance(tool, DiscTool):
        raise PlanError("depth.of-cutter", edge=edge, station=number, at_edges=own)
    if math.isfinite(depth) and depth > setup.through_depth:
        raise PlanError(
            "depth.too-deep", edge=edge, depth=depth, most=setup.through_depth, at_edges=own
        )
    if not isinstance(tool, Knife | Cutter):
        raise PlanError("depth.one-pass", edge=edge, station=number, at_edges=own)
    usual = setup.through_depth if kind == LineType.CUT else setup.board.half_cut_depth
    final = depth if math.isfinite(depth) else usual
    least = 1 if tool.step == 0.0 else math.ceil(final / tool.step - 1e-9)
    if 0 < passes < least:
        raise PlanError(
            "depth.too-few-passes",
            edge=edge,
            passes=passes,
            least=least,
            depth=final,
            step=tool.step,
            at_edges=own,
        )


def check_crease_depths(work: ChosenWork, dieline: Dieline, machine: Machine, board: Board) -> None:
    """Raise ``PlanError`` if a machine cannot make a depth that was chosen for a crease.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges with their line types.
    """
    pressed = LineType.CREASE, LineType.COMBI
    rows = chosen_rows(work, CreaseDepth, dieline, pressed, "crease-depth.other-type")
    if len(rows) == 0:
        return
    if not find_language(machine.dialect).sets_pose:
        raise PlanError("crease-depth.not-set", edge=rows[0], machine=machine.title, at_edges=rows)
    depth = work[CreaseDepth].numbers("depth", 0.0)
    deep = np.flatnonzero(depth >= board.caliper)
    for edge in deep[:1]:
        raise PlanError(
            "crease-depth.too-deep",
            edge=edge,
            depth=depth[edge],
            caliper=board.caliper,
            at_edges=deep,
        )
