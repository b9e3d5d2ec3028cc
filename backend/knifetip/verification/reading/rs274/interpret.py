"""Convert the words of an RS274/NGC program to moves, each with the controller's modal state.

Only the words of RS274/NGC that both LinuxCNC and grblHAL accept and that a sample-maker's program
needs are interpreted.  All other words are faults.

Source: Kramer, Proctor & Messina, "The NIST RS274NGC interpreter", section 3 (modal groups, order
of execution); grbl's own rules where they are stricter.
"""

from __future__ import annotations

import math
from operator import itemgetter
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_2, I64_1, kernel
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I64, U8, Bool
from knifetip.verification.reading.moves import Moves, Switches
from knifetip.verification.reading.rs274.block_faults import PRINT_ROUNDING, check_blocks
from knifetip.verification.reading.rs274.blocks import Group, ProgramBlocks
from knifetip.verification.reading.rs274.modal_state import ModalState
from knifetip.verification.reading.rs274.parse import ProgramWords
from knifetip.verification.tools import carriage_columns

#: Greatest difference between the radii at both ends of an arc (mm).
ARC_TOLERANCE: Final = 0.002


def interpret(words: ProgramWords, machine: Machine) -> tuple[Moves, list[tuple[int, Message]]]:
    """Return the moves of a program, and its faults (1-based line, message) in ascending order.

    Raises
    ------
    ProgramUnreadable
        The program has more than two million lines with words.
    """
    faults: list[tuple[int, Message]] = list(words.faults)
    blocks = ProgramBlocks(words, "".join(machine.axes), faults)
    state = ModalState(blocks, machine)
    check_blocks(blocks, state, machine)
    return _make_moves(blocks, state, machine), sorted(faults, key=itemgetter(0))


def _make_moves(blocks: ProgramBlocks, state: ModalState, machine: Machine) -> Moves:
    ended = np.cumsum(blocks.has_code(Group.END)) > 0
    rows = np.flatnonzero(blocks.has_code(Group.MOTION) & blocks.moves_axis & ~ended)
    axes_start, axes_end = _trace_joints(blocks.position, state.offset_of, state.datum, rows)
    if machine.gantry:
        own = carriage_columns(machine)[state.station[rows]]
        start, end = (np.take_along_axis(axes, own, axis=1) for axes in (axes_start, axes_end))
        _check_carriages(blocks, rows, own)
    else:
        start, end = _with_heading(axes_start), _with_heading(axes_end)
    code = (blocks.group[Group.MOTION][rows] // 10).astype(np.uint8)
    centre, sweep = _make_arcs(blocks, rows, code, start, end)
    return Moves(
        line=blocks.line[rows],
        code=code,
        start=start,
        end=end,
        axes_start=axes_start,
        axes_end=axes_end,
        centre=centre,
        sweep=sweep,
        feed=state.feed[rows],
        inverse=state.inverse[rows],
        station=state.station[rows].astype(np.int32),
        lowered=state.on[rows],
        extra=state.extra[rows],
        oscillating=state.oscillating[rows],
        stated=state.stated[rows],
        blend=state.blend[rows],
        rested=_find_rests(blocks, rows),
        waited=state.waited[rows],
        uses_tool_table=state.uses_tool_table,
        dwell=state.dwell,
        switches=_switching_lines(blocks, state, rows),
        programmed="XYZC" if axes_start.shape[1] > len("XYZ") else "XYZ",
    )


def _with_heading(axes: F64) -> F64:
    """Return positions of n joints with a fourth column: C, which is 0 if there is no such axis."""
    return axes if axes.shape[1] > len("XYZ") else np.pad(axes, ((0, 0), (0, 1)))


@kernel
def _trace_joints(position: F64_2, offset_of: I64_1, datum: F64_2, moving: I64_1) -> Any:
    """Return the positions of the joints before and after each of n moves, (n, axes) each.

    An axis without a word keeps its position, which is NaN before its first word.

    ``position`` (blocks, axes): programmed position of each axis in each block, NaN if it has no
    word of the axis.
    ``offset_of`` (blocks,): row in ``datum`` of the tool offset of each block; -1 for the last row.
    ``datum`` (stations + 1, axes): tool offsets.
    ``moving`` (n,): indices of the blocks that contain moves, ascending.
    """
    axes = position.shape[1]
    start, end = np.empty((len(moving), axes)), np.empty((len(moving), axes))
    known = np.full(axes, np.nan)
    for move in range(len(moving)):
        block = moving[move]
        for axis in range(axes):
            start[move, axis] = known[axis]
            joint = position[block, axis] + datum[offset_of[block], axis]
            if not math.isnan(joint):
                known[axis] = joint
            end[move, axis] = known[axis]
    return start, end


def _check_carriages(blocks: ProgramBlocks, moving: I64, own: I64) -> None:
    """Add a fault for each feed line that moves another carriage than that of its station, and for
    each arc of a carriage other than the first.

    ``moving`` (n,): indices of the blocks that contain moves.
    ``own`` (n, 4): columns of the axes of the carriage of the selected station, for each of these
    moves.
    """
    feeding = ~blocks.has_code(Group.MOTION, 0)[moving]
    foreign = blocks.axes[moving]
    np.put_along_axis(foreign, own, np.bool_(False), axis=1)
    curved = blocks.has_code(Group.MOTION, 20) | blocks.has_code(Group.MOTION, 30)
    # X and Y are the first two columns.
    wrong_plane = curved[moving] & (own[:, 1] != 1)
    for mask, message in (
        (feeding & foreign.any(axis=1) & ~wrong_plane, Message("rs274.moves-other-carriage")),
        (wrong_plane, Message("rs274.arc-of-other-carriage")),
    ):
        wrong = np.zeros(blocks.count, np.bool_)
        wrong[moving[mask]] = True
        blocks.fault(wrong, message)


def _find_rests(blocks: ProgramBlocks, moving: I64) -> Bool:
    """Return the mask of the n moves before which the head comes to rest, (n,).

    A dwell, a tool change, and the switching of an output or the spindle end the moves before them.
    ``moving`` are the indices of the blocks that contain moves, ascending, (n,).
    """
    groups = (Group.DWELL, Group.CHANGE, Group.OUTPUT, Group.SPINDLE)
    ends = np.cumsum(np.logical_or.reduce([blocks.has_code(group) for group in groups]))
    result = np.ones(len(moving), np.bool_)
    result[1:] = np.diff(ends[moving]) > 0
    return result


def _switching_lines(blocks: ProgramBlocks, state: ModalState, moving: I64) -> Switches:
    """Return the program lines that switch an output or the spindle, or select a station.

    ``moving`` are the indices of the blocks that contain moves, ascending.
    """
    spindle, change = blocks.has_code(Group.SPINDLE), blocks.has_code(Group.CHANGE)
    output = blocks.has_code(Group.OUTPUT)
    rows = np.flatnonzero(output | spindle | change)
    return Switches(
        line=blocks.line[rows],
        move=np.searchsorted(moving, rows) - 1,
        lowers=state.lowers[rows],
        beside=state.on[rows] | ~state.stated[rows, : state.on.shape[1]],
        # What the program has stated once remains stated.
        at_end=state.stated[-1] if blocks.count else np.zeros(state.stated.shape[1], np.bool_),
        spindle=(spindle & ~output & ~change)[rows],
    )


def _make_arcs(blocks: ProgramBlocks, rows: I64, code: U8, start: F64, end: F64) -> tuple[F64, F64]:
    """Return the centres of the arcs among n moves, (n, 2) mm, and their signed sweeps, (n,)
    radians.

    A sweep is positive for an anticlockwise arc.  A line has centre NaN and sweep 0.  An invalid
    arc also has centre NaN and sweep 0, and gives a fault.

    ``rows`` (n,): indices of the blocks of the moves.
    ``code`` (n,): number of the G word of each move: 0 or 1 for a line, 2 or 3 for an arc.
    ``start``, ``end`` (n, 4): positions of the joints X, Y, Z (mm) and C (degrees) at the start and
    the end of each move.
    """
    centre, sweep = np.full((len(rows), 2), np.nan), np.zeros(len(rows))
    arc = np.flatnonzero(code >= 2)
    if len(arc) == 0:
        return centre, sweep
    from_start = np.stack([blocks.number["I"][rows[arc]], blocks.number["J"][rows[arc]]], axis=1)
    begin, stop, left = start[arc, :2], end[arc, :2], code[arc] == 3
    middle = begin + from_start
    out, back = begin - middle, stop - middle
    radius, other = np.hypot(*out.T), np.hypot(*back.T)
    good = (np.abs(radius - other) <= ARC_TOLERANCE) & (radius > PRINT_ROUNDING)
    wrong = np.zeros(blocks.count, np.bool_)
    wrong[rows[arc[~good]]] = True
    blocks.fault(wrong, Message("rs274.bad-arc", limit=ARC_TOLERANCE))
    with np.errstate(invalid="ignore"):
        angle = np.arctan2(back[:, 1], back[:, 0]) - np.arctan2(out[:, 1], out[:, 0])
    ahead = np.where(left, angle, -angle) % (2.0 * np.pi)
    # Equal printed ends mean a full circle, for LinuxCNC and for grbl.
    same = np.hypot(*(stop - begin).T) < PRINT_ROUNDING
    ahead = np.where(same, 2.0 * np.pi, ahead)
    centre[arc[good]] = middle[good]
    sweep[arc[good]] = np.where(left, ahead, -ahead)[good]
    return centre, sweep
