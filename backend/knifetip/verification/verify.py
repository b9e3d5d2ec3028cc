"""Verify that a program makes the drawn edges.

A reader converts the program's bytes to moves of the machine's joints, kinematics computes the
paths of the tool tip, and the checks compare the paths with each edge.  Verification shares no code
with the stages that make programs, so programs from any source can be verified.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.errors import ProgramError
from knifetip.languages.registry import find_language
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.chosen_work import NOTHING_CHOSEN, ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.job_options import CutDepth
from knifetip.model.machine import Machine
from knifetip.model.registration import Registration
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Samples, Verdict
from knifetip.verification.checks.common.chosen_passes import check_chosen_passes
from knifetip.verification.checks.common.chosen_tools import check_chosen_tools
from knifetip.verification.checks.common.context import CheckContext, MeasuredFigures
from knifetip.verification.checks.common.edge_feeds import (
    check_edge_feeds,
    least_parts,
    without_slowed,
)
from knifetip.verification.checks.crease.base import check_creasing_base
from knifetip.verification.checks.crease.rim import check_rims
from knifetip.verification.checks.edge_checks import check_edges
from knifetip.verification.checks.knife.passes import check_knife_passes, last_passes
from knifetip.verification.checks.lines.groove_flanks import check_groove_flanks
from knifetip.verification.checks.lines.near_lines import check_near_lines
from knifetip.verification.checks.milling.chosen_leads import check_chosen_leads
from knifetip.verification.checks.milling.unreached_areas import merge_unreached
from knifetip.verification.checks.motion import moves as motion_checks
from knifetip.verification.checks.motion.board_moves import check_board_moves
from knifetip.verification.checks.motion.carriages import check_carriages
from knifetip.verification.checks.motion.outputs import check_switching
from knifetip.verification.checks.motion.overlap import check_overlaps
from knifetip.verification.checks.motion.program_figures import measure_program
from knifetip.verification.checks.motion.zones import check_zones
from knifetip.verification.checks.order.chosen_order import check_chosen_order
from knifetip.verification.checks.order.chosen_starts import check_chosen_starts
from knifetip.verification.checks.order.repeated_work import check_repeated_work
from knifetip.verification.checks.order.work_order import check_work_order
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.expectation.chosen_bridges import ExpectedBridge
from knifetip.verification.expectation.chosen_order import ExpectedOrder
from knifetip.verification.expectation.chosen_starts import ExpectedStart
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.measured_marks import sheet_turn
from knifetip.verification.expectation.sheet_area import SheetArea, place_sheet
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.joined_work import join_work
from knifetip.verification.kinematics import TipPaths, TipPoses, tip_paths, tip_poses
from knifetip.verification.reading.moves import Moves, ProgramReader
from knifetip.verification.reading.sheet_moves import sheet_moves, with_sheet_resolution
from knifetip.verification.trailing_blade import (
    Swivels,
    check_park_headings,
    check_pushes,
    find_swivels,
    follow_blades,
    with_headings,
)

#: Greatest number of sampled deviations in a verdict.
MAX_SAMPLES: Final = 200_000

__all__ = ["JobDetails", "read_placement", "trace_program", "verify"]


class JobDetails(NamedTuple):
    """What a program depends on beside its drawing, machine, board and sheet."""

    #: programs that have done a part of the work on the same sheet, in the order of their
    #: execution.  Their completed work is not required again and must not be repeated.  The order
    #: of the work includes it, and the executed work that is made again
    earlier: Sequence[EarlierWork] = ()
    #: starts and directions of closed cuts that the user has chosen
    starts: Sequence[ExpectedStart] = ()
    chosen: ChosenWork = NOTHING_CHOSEN  #: what the user has chosen for edges of the dieline
    order: ExpectedOrder = ()  #: edges that must be begun in this order
    bridges: Sequence[ExpectedBridge] = ()  #: bridges that the user has placed
    #: marks by which the edges of the dieline lie on the table, if they were measured
    registration: Registration | None = None


_NO_DETAILS: Final = JobDetails()


def verify(
    text: bytes,
    dieline: Dieline,
    placement: tuple[float, float],
    machine: Machine,
    board: Board,
    *,
    sheet: Sheet | None = None,
    tolerance: float = 0.01,
    job: JobDetails = _NO_DETAILS,
) -> Verdict:
    """Return the verdict on a program: findings, figures for each edge, and the nominal time.

    Parameters
    ----------
    text : bytes
        The program, in the language of the machine's controller.
    dieline : Dieline
        Edges in the drawing's coordinates.
    placement : (x, y), mm
        Offset from the drawing's coordinates to the sheet's coordinates.
    machine, board
        Machine and board that the program is made for.
    sheet : Sheet, optional
        The sheet if it was cut to size; None if there may be board everywhere on the table.
    tolerance : float, mm
        Greatest distance of the tip from the drawing: its distance from the edge, plus the
        controller's rounding of corners (G64), plus the distance of the edge from the curve of the
        file.  The rounding of coarse coordinates is added; the verdict contains the sum.
    job : JobDetails, optional
        Earlier work on the same sheet, and what the user has chosen.

    Returns
    -------
    Verdict
        Accepted if all findings are notes.  Bytes that are not a program give faults too.

    Raises
    ------
    ProgramUnreadable
        The text is not of type bytes or is too large, or the machine's file lacks an entry that
        the reader needs.
    ProgramError
        The tolerance is not a positive, finite number.
    GeometryError
        A coordinate of the dieline or the placement is not finite.
    """
    if not (math.isfinite(tolerance) and tolerance > 0.0):
        raise ProgramError("verify.bad-tolerance", tolerance=tolerance)
    machine = machine.for_board(board)
    edges = place_edges(dieline, placement)
    figures = MeasuredFigures.zeros(len(dieline))
    findings, joined_findings = Findings(), Findings()
    area = None if sheet is None else place_sheet(sheet, edges, sheet_turn(job.registration))
    earlier, chosen = job.earlier, job.chosen
    split = CutDepth in chosen
    moves, tip, paths, swivels = _trace(text, machine, board, tolerance, findings, area, split)
    parts = least_parts(moves, tip, machine, chosen)
    motion_checks.check_feeds(without_slowed(moves, parts), tip, machine, findings)
    _check_placement(text, placement, machine, findings)
    _check_unclassified(dieline, findings)
    _check_caliper(machine, board, findings)
    _check_size(text, machine, findings)
    earlier_paths = [
        _trace(one.text, machine, board, math.inf, Findings(), split_at_caliper=split)[2]
        for one in earlier
    ]
    work = join_work(paths, earlier, earlier_paths)
    executed = join_work(paths, earlier, earlier_paths, with_repeated=True)
    tolerance += moves.resolution
    context = CheckContext(
        edges,
        machine,
        board,
        tolerance,
        figures,
        joined_findings,
        dieline.fit_error,
        moves.programmed,
        moves.resolution,
        moves.height_resolution,
        area,
        work.lines_before,
        chosen,
        swivels,
        job.bridges,
    )
    check_knife_passes(context, executed)
    check_edges(context, last_passes(context, work))
    check_rims(context, work.paths)
    check_creasing_base(context, work.paths)
    check_work_order(context, last_passes(context, executed))
    check_repeated_work(context, work)
    check_chosen_passes(context, work.paths)
    check_chosen_tools(context, work.paths)
    check_chosen_leads(context, work.paths)
    check_chosen_starts(context, job.starts, work.paths)
    check_chosen_order(context, job.order, work.paths)
    check_edge_feeds(context, paths, moves, parts)
    check_near_lines(context)
    check_groove_flanks(context)
    findings.extend(work.own_line(finding) for finding in joined_findings.sorted())
    found = findings.sorted()
    return Verdict(
        accepted=not any(finding.refuses for finding in found),
        tolerance=tolerance,
        **figures.columns(),
        samples=_samples(context),
        areas=merge_unreached(context.unreached, placement),
        findings=found,
        seconds=motion_checks.nominal_seconds(moves, machine),
        program=measure_program(moves, tip, machine, board),
    )


def _samples(context: CheckContext) -> Samples:
    """Return the deviations of tip paths from the edges, measured at points of the edges.

    If there are more than ``MAX_SAMPLES`` points, evenly spaced ones of them are returned.
    """
    columns = [np.concatenate(column) for column in zip(*context.samples, strict=True)]
    if not columns:
        return Samples()
    edge, place, deviation = columns
    order = order_in_groups(edge, place, place)[:: -(-len(edge) // MAX_SAMPLES) or 1]
    return Samples(edge[order], np.clip(place[order], 0.0, 1.0), deviation[order])


def trace_program(text: bytes, machine: Machine, board: Board) -> tuple[Moves, TipPoses, TipPaths]:
    """Return the moves of a program, the poses of the tip, and the paths of the tip in the board.

    The moves are those of the axes; poses and paths are on the sheet.  No joint turns a free blade:
    its heading is computed from the path.  Findings are discarded.  Raises ProgramUnreadable if the
    text cannot be read as a program.
    """
    return _trace(text, machine, board, math.inf, Findings())[:3]


def _trace(
    text: bytes,
    machine: Machine,
    board: Board,
    tolerance: float,
    findings: Findings,
    sheet: SheetArea | None = None,
    split_at_caliper: bool = False,
) -> tuple[Moves, TipPoses, TipPaths, Swivels]:
    """Return the moves of a program, the poses and paths of the tip, and the turns of free blades.

    The moves are those of the axes, with their limits, feeds and overlaps; all others are on the
    sheet.  ``split_at_caliper`` is as in ``tip_paths``.
    """
    axes, faults = _reader(machine).read(text, machine, board)
    findings.add_faults(faults)
    axes = with_sheet_resolution(axes, machine)
    moves, rows = sheet_moves(axes, machine)
    blade = follow_blades(moves, machine, board)
    turned = moves
    if blade is not None:
        # The tip depends on two rounded points: where it came to rest, and where its axis is.
        axes = replace(axes, resolution=2.0 * axes.resolution)
        moves = replace(moves, resolution=axes.resolution)
        turned = with_headings(moves, blade, machine)
        check_park_headings(moves, blade, machine, findings)
        check_pushes(moves, blade, findings)
    tip = tip_poses(turned, machine, board)
    joined = tip.joined(rows)
    usable = motion_checks.check_travel(axes, machine, findings)[rows]
    check_carriages(axes, machine, findings)
    check_zones(moves, machine, findings)
    motion_checks.check_outputs(axes, joined, machine, findings)
    check_switching(axes, machine, board, findings)
    check_board_moves(turned, tip, machine, board, tolerance + moves.resolution, sheet, findings)
    check_overlaps(axes, joined, machine, tolerance, findings)
    swivels = Swivels.none()
    if blade is not None:
        swivels = find_swivels(blade, tip.start, tip.end, moves.line)
    paths = tip_paths(turned, tip, usable, machine, board, blade, split_at_caliper=split_at_caliper)
    return axes, joined, paths, swivels


def read_placement(text: bytes, machine: Machine) -> tuple[float, float] | None:
    """Return the placement that the program's comments state, or None if they state none.

    The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
    """
    return _reader(machine).placement(text)


def _reader(machine: Machine) -> ProgramReader:
    reader: ProgramReader = find_language(machine.dialect).load_part("reader")
    return reader


def _check_placement(
    text: bytes, placement: tuple[float, float], machine: Machine, findings: Findings
) -> None:
    stated = read_placement(text, machine)
    if stated is None:
        return
    distance = math.hypot(stated[0] - placement[0], stated[1] - placement[1])
    if distance > 1e-3:
        findings.add(
            "program",
            Message(
                "verify.other-placement",
                x=stated[0],
                y=stated[1],
                job_x=placement[0],
                job_y=placement[1],
            ),
            distance,
        )


def _check_caliper(machine: Machine, board: Board, findings: Findings) -> None:
    excess = board.caliper - machine.max_caliper
    if machine.max_caliper > 0.0 and excess > 0.0:
        message = Message(
            "board.too-thick",
            caliper=board.caliper,
            machine=machine.title,
            limit=machine.max_caliper,
        )
        findings.add("program", message, excess)


def _check_size(text: bytes, machine: Machine, findings: Findings) -> None:
    excess = len(text) - machine.program_memory
    if machine.program_memory > 0 and excess > 0:
        message = Message(
            "verify.program-too-large",
            bytes=len(text),
            machine=machine.title,
            limit=machine.program_memory,
        )
        findings.add("program", message, excess)


def _check_unclassified(dieline: Dieline, findings: Findings) -> None:
    rows = np.flatnonzero(dieline.line_type == LineType.UNCLASSIFIED)
    for row in rows[:MAX_FINDINGS]:
        findings.add("uncut", Message("verify.unclassified"), 0.0, edge=row)
