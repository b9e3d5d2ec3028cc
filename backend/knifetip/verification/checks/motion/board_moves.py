"""Check the moves of a tool in the board, and the height of rapids above it."""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.checks.motion.board_move_kernels import (
    LOW_RAPID,
    RAPID_IN_BOARD,
    SLANTED,
    UNKNOWN,
    UNKNOWN_FAULT,
    WRONG_TURN,
    mark_board_moves,
    slants,
    turn_figures,
)
from knifetip.verification.checks.motion.move_columns import (
    MoveColumns,
    ToolColumns,
    move_columns,
    tool_columns,
)
from knifetip.verification.checks.motion.moves import station_number
from knifetip.verification.checks.motion.sheet import stays_beside_sheet
from knifetip.verification.columns import U8
from knifetip.verification.expectation.sheet_area import SheetArea
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.kinematics import LEVEL, TipPoses, beam_moves
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import has_beam


def check_board_moves(
    moves: Moves,
    tip: TipPoses,
    machine: Machine,
    board: Board,
    tolerance: float,
    sheet: SheetArea | None,
    findings: Findings,
) -> None:
    """Check the moves of a tool in the board, and the height of rapids above it.

    Adds a finding for each rapid in the board or nearer to it than the turn clearance of the
    machine, each plunge or lift that is slanted, and each turn of C in the board that is too large.
    A feed move from or to an unknown position gives a finding too.

    Parameters
    ----------
    tolerance : mm
        Greatest sideways deviation of the tip in a plunge or lift.
    sheet
        The sheet if it was cut to size; None if there may be board everywhere on the table.
    """
    if has_beam(machine):
        _check_beam(moves, tip, machine, findings)
    columns, tools = move_columns(moves, tip), tool_columns(machine, moves.resolution)
    needed = board.caliper + machine.turn_clearance
    marks = mark_board_moves(columns, tools, needed, board.caliper, tolerance)
    if sheet is not None:
        known = np.flatnonzero((marks & (LOW_RAPID | RAPID_IN_BOARD) > 0) & (marks & UNKNOWN == 0))
        beside = known[stays_beside_sheet(moves, known, machine, board, sheet)]
        marks[beside] = 0
    if not marks.any():
        return
    _report_rapids(moves, tip, machine, board, marks, sheet is not None, findings)
    for row in np.flatnonzero(marks & UNKNOWN_FAULT)[:MAX_FINDINGS]:
        findings.add("program", Message("verify.unknown-position"), 0.0, line=moves.line[row])
    _report_slants_and_turns(moves, machine, board, columns, tools, marks, findings)


def _report_rapids(
    moves: Moves,
    tip: TipPoses,
    machine: Machine,
    board: Board,
    marks: U8,
    has_sheet: bool,
    findings: Findings,
) -> None:
    """Add a finding for each rapid near the board or in the board.

    ``marks`` are those of the n moves (see ``mark_board_moves``), and ``has_sheet`` is whether the
    sheet was cut to size.
    """
    in_board = marks & RAPID_IN_BOARD > 0
    needed = board.caliper + machine.turn_clearance
    for row in np.flatnonzero((marks & LOW_RAPID > 0) & ~in_board)[:MAX_FINDINGS]:
        lowest = np.fmin(tip.start[row, 2], tip.end[row, 2])
        message = Message(
            "verify.rapid-too-low",
            station=station_number(moves, machine, row),
            height=lowest - board.caliper,
            needed=machine.turn_clearance,
        )
        findings.add("stray", message, needed - lowest, line=moves.line[row])
    code = "verify.rapid-near-sheet" if has_sheet else "verify.rapid-in-board"
    for row in np.flatnonzero(in_board)[:MAX_FINDINGS]:
        depth = board.caliper - np.fmin(tip.start[row, 2], tip.end[row, 2])
        message = Message(code, station=station_number(moves, machine, row), depth=depth)
        findings.add("stray", message, depth, line=moves.line[row])


def _check_beam(moves: Moves, tip: TipPoses, machine: Machine, findings: Findings) -> None:
    """Check that a laser beam is off in rapids, and that the head keeps its height while the beam
    is on; add findings.
    """
    beam_on = beam_moves(moves, machine) & tip.inside
    for row in np.flatnonzero(beam_on & (moves.code == 0))[:MAX_FINDINGS]:
        distance = float(np.hypot(*(tip.end[row, :2] - tip.start[row, :2])))
        message = Message("verify.beam-on-rapid", length=distance)
        findings.add("stray", message, distance, line=moves.line[row])
    drop = np.abs(tip.end[:, 2] - tip.start[:, 2])
    for row in np.flatnonzero(beam_on & (moves.code > 0) & (drop > LEVEL))[:MAX_FINDINGS]:
        message = Message("verify.beam-refocused", height=drop[row])
        findings.add("depth", message, drop[row], line=moves.line[row])


def _report_slants_and_turns(
    moves: Moves,
    machine: Machine,
    board: Board,
    columns: MoveColumns,
    tools: ToolColumns,
    marks: U8,
    findings: Findings,
) -> None:
    """Add a finding for each slanted plunge or lift, and for each wrong turn of C in the board.

    C must turn by the same angle as the direction of travel.  On a line or an arc, both turn at
    constant rates, so comparing their angles covers the entire move.  A comparison of the headings
    at the ends of the move would miss full turns.
    """
    rows = np.flatnonzero(marks & SLANTED)[:MAX_FINDINGS]
    for row, distance in zip(rows, slants(columns, tools, board.caliper, rows), strict=True):
        number = station_number(moves, machine, row)
        message = Message("verify.slanted", station=number, distance=distance)
        findings.add("deviation", message, distance, line=moves.line[row])
    rows = np.flatnonzero(marks & WRONG_TURN)[:MAX_FINDINGS]
    for row, (turn, path, limit, in_place) in zip(
        rows, turn_figures(columns, tools, rows), strict=True
    ):
        error = abs(turn - path)
        if in_place:
            message = Message("verify.turn-in-board", degrees=error, most=limit)
        else:
            message = Message("verify.turn-off-path", degrees=turn, path=path)
        findings.add("heading", message, error, line=moves.line[row])
