"""Reader of HPGL programs for plotters and flat cutters.

The reader accepts the instructions that such a program needs: IN, PA, PU, PD, SP, VS, FS and
comments (CO).  All other instructions are faults.  HPGL moves X and Y; the device sets the depth of
each pen and turns the tool along the path.  Heights therefore only distinguish tool up and tool
down, and headings are the directions of the path.  At a corner the device must not turn the tool in
the board by more than the tool's swivel angle; the reader checks that.

Source: Hewlett-Packard's interfacing manuals (syntax, pen state, absolute coordinates after IN).
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from operator import itemgetter
from typing import Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.languages.hpgl.plotter import Device, Pen, PenWork, Plotter
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I32, I64, U8, Bool
from knifetip.verification.reading.moves import Moves, Switches
from knifetip.verification.tools import expected_spindle, expected_tool

#: Greatest size of a program: bytes and moves.
MAX_BYTES: Final = 64 << 20
MAX_MOVES: Final = 2_000_000
#: Greatest number of digits in a number.
MAX_DIGITS: Final = 9
_MAX_FAULTS: Final = 1000
_KNOWN: Final = ("IN", "PA", "PU", "PD", "SP", "VS", "FS")
_IN, _PA, _PU, _PD, _SP, _VS, _FS = range(7)
_COMMENT: Final = re.compile(rb'CO\s*"[^"\n]*"')
_PLACEMENT: Final = re.compile(rb'CO"placement X(-?\d+\.\d+) Y(-?\d+\.\d+)"')

_Faults = list[tuple[int, Message]]


@dataclass(frozen=True, eq=False, slots=True)
class _Instructions:
    """The k instructions of an HPGL program, with their numeric arguments."""

    code: I64  #: (k,) index into ``_KNOWN``
    line: I64  #: (k,) 1-based
    first: I64  #: (k + 1,) index of the first number of each instruction
    number: I64  #: all numbers
    ended: bool  #: a terminator follows the last instruction


@dataclass(frozen=True, eq=False, slots=True)
class _Track:
    """n moves of an HPGL device: each moves a pen along X and Y, or lowers or lifts it."""

    line: I64  #: (n,) 1-based
    x: I64  #: (n + 1,) plotter units, before the first move and after each
    y: I64  #: (n + 1,) plotter units
    known: Bool  #: (n + 1,) an instruction has set the position
    down: Bool  #: (n,) the tool is down after the move
    upright: Bool  #: (n,) the move lowers or lifts the tool
    pen: I64  #: (n,) pen number selected by SP, 0 for none
    speed: I64  #: (n,) VS in force, -1 for none
    force: I64  #: (n,) FS in force since the pen was selected, -1 for none


class HpglReader:
    """Reader of HPGL programs for the device (plotter or flat cutter) in the machine's file."""

    def placement(self, text: bytes) -> tuple[float, float] | None:
        """Return the placement that the program's comments state, or None if they state none.

        The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
        """
        match = _PLACEMENT.search(text)
        return (float(match[1]), float(match[2])) if match else None

    def read(self, text: bytes, machine: Machine, board: Board) -> tuple[Moves, _Faults]:
        """Return the moves of a program, and its faults (1-based line, message) in ascending order.

        Raises
        ------
        ProgramUnreadable
            The machine's file describes no device, or the text is too large or has too many moves.
        """
        plotter = machine.controller
        if not isinstance(plotter, Plotter):
            raise ProgramUnreadable("hpgl.no-device", machine=machine.title)
        if len(text) > MAX_BYTES:
            raise ProgramUnreadable("program.too-large", bytes=len(text), limit=MAX_BYTES)
        faults: _Faults = []
        instructions = _parse_instructions(text, plotter.device, faults)
        track = _make_track(instructions, faults)
        _check_state(instructions, track, plotter, faults)
        moves = _make_moves(track, plotter, machine, board, faults)
        return moves, sorted(faults, key=itemgetter(0))


READER: Final = HpglReader()


def _add_faults(faults: _Faults, lines: I64, message: Message) -> None:
    """Append one fault with this message for each of ``lines``, 1-based program lines.

    Faults after the first ``_MAX_FAULTS`` lines are left out.
    """
    faults.extend((int(line), message) for line in lines[:_MAX_FAULTS])


def _parse_instructions(text: bytes, device: Device, faults: _Faults) -> _Instructions:
    """Return the instructions of a program.

    Appends faults to ``faults`` for bytes that are part of no instruction.
    """
    if device.comments:
        text = _COMMENT.sub(lambda match: b" " * len(match[0]), bytes(text))
    raw = np.frombuffer(text, np.uint8)
    line_of = np.concatenate([[0], np.cumsum(raw == 10)])[: len(raw)] + 1
    letter = (raw >= 65) & (raw <= 90)
    digit = (raw >= 48) & (raw <= 57)
    sign = (raw == 43) | (raw == 45)
    stop = (raw == 59) | (raw == 10) | (raw == 13)
    other = ~(letter | digit | sign | stop | np.isin(raw, (32, 44)))
    for at in np.flatnonzero(other)[:_MAX_FAULTS]:
        byte = f"{int(raw[at]):#04x}"
        faults.append((int(line_of[at]), Message("hpgl.bad-byte", byte=byte)))

    shown = np.flatnonzero(raw != 32)
    commas = np.flatnonzero(raw[shown] == 44)
    before, after = np.append(digit[shown], False), np.append((digit | sign)[shown], False)
    lone_commas = commas[~(before[commas - 1] & after[commas + 1])]
    _add_faults(faults, line_of[shown[lone_commas]], Message("hpgl.bad-byte", byte="0x2c"))

    at = np.flatnonzero(letter)
    if len(at) % 2 or (at[1::2] != at[0::2] + 1).any():
        lone = at[: len(at) // 2 * 2].reshape(-1, 2)
        wrong = np.flatnonzero(lone[:, 1] != lone[:, 0] + 1)
        place = int(lone[wrong[0], 0]) if len(wrong) else int(at[-1])
        faults.append((int(line_of[place]), Message("hpgl.lone-letter")))
        at = at[: 2 * int(wrong[0])] if len(wrong) else at[:-1]
    begin = at[0::2]
    pair = raw[begin].astype(np.int64) * 256 + raw[begin + 1]
    table = np.array([ord(name[0]) * 256 + ord(name[1]) for name in _KNOWN])
    code = np.full(len(begin), -1)
    for index, mnemonic in enumerate(table):
        code[pair == mnemonic] = index
    for k in np.flatnonzero(code < 0)[:_MAX_FAULTS]:
        name = bytes(raw[begin[k] : begin[k] + 2]).decode("ascii")
        faults.append((int(line_of[begin[k]]), Message("hpgl.unknown-instruction", name=name)))

    head = sign | digit
    head[1:] &= sign[1:] | ~(sign | digit)[:-1]
    value, head_at, bad = _parse_numbers(raw, digit, head)
    _add_faults(faults, line_of[bad], Message("hpgl.bad-number"))
    owner = np.searchsorted(begin, head_at, side="right") - 1
    # A number after a terminator belongs to no instruction.
    stops = np.concatenate([[0], np.cumsum(stop)])
    loose = owner < 0
    if len(begin):
        loose |= stops[head_at] > stops[begin[np.maximum(owner, 0)]]
    _add_faults(faults, line_of[head_at[loose]], Message("hpgl.loose-number"))
    value, owner = value[~loose], owner[~loose]
    keep = code >= 0
    mine = keep[owner] if len(owner) else np.zeros(0, np.bool_)
    value, owner = value[mine], (np.cumsum(keep) - 1)[owner[mine]]
    code, line = code[keep], line_of[begin[keep]]
    first = np.searchsorted(owner, np.arange(len(code) + 1))
    ended = len(at) == 0 or bool((raw[at[-1] :] == 59).any())
    return _Instructions(code, line, first, value, ended)


def _parse_numbers(raw: U8, digit: Bool, head: Bool) -> tuple[I64, I64, I64]:
    """Return the k integers in the n bytes of a program.

    ``raw`` (n,): the bytes.
    ``digit``, ``head`` (n,): mask of the bytes that are digits, and mask of the first bytes of
    numbers (a sign or a digit).
    Returns the integers (k,), the positions of their first bytes (k,), and the position of the
    first byte of each number that has no digits or too many.
    """
    head_at = np.flatnonzero(head)
    if len(head_at) == 0:
        return np.zeros(0, np.int64), head_at, head_at
    digit_at = np.flatnonzero(digit)
    number_of = np.searchsorted(head_at, digit_at, side="right") - 1
    count = np.bincount(number_of, minlength=len(head_at))
    last = np.zeros(len(head_at), np.int64)
    last[number_of] = digit_at
    power = np.minimum(last[number_of] - digit_at, MAX_DIGITS)
    value = np.bincount(
        number_of, (raw[digit_at].astype(np.float64) - 48.0) * 10.0**power, minlength=len(head_at)
    )
    bad = head_at[(count == 0) | (count > MAX_DIGITS)]
    value[count > MAX_DIGITS] = 0.0
    signed = np.where(raw[head_at] == 45, -value, value)
    return np.rint(signed).astype(np.int64), head_at, bad


def _value_in_force(values: I64, is_set: Bool, initial: int) -> I64:
    """Return the value in force after each of k instructions, (k,).

    The value is set by the instruction itself, or by the last earlier instruction that sets it.

    ``values`` (k,): value of each instruction, if the instruction sets it.
    ``is_set`` (k,): mask of the instructions that set the value.
    ``initial``: value before the first instruction that sets it.
    """
    if len(is_set) == 0:
        return np.zeros(0, np.int64)
    rows = np.maximum.accumulate(np.where(is_set, np.arange(len(is_set)), -1))
    result: I64 = np.where(rows >= 0, values[rows], initial)
    return result


def _make_track(instructions: _Instructions, faults: _Faults) -> _Track:
    """Convert instructions to moves.

    Appends a fault to ``faults`` for each instruction with a wrong number of arguments.
    """
    code, count = instructions.code, np.diff(instructions.first)
    single = np.zeros(len(code), np.int64)
    has = count > 0
    single[has] = instructions.number[instructions.first[:-1][has]]
    point = np.isin(code, (_PA, _PU, _PD))
    odd = point & (count % 2 == 1)
    _add_faults(faults, instructions.line[odd], Message("hpgl.x-without-y"))
    selects = np.isin(code, (_SP, _VS, _FS))
    _add_faults(faults, instructions.line[selects & (count != 1)], Message("hpgl.needs-one-number"))
    _add_faults(faults, instructions.line[(code == _IN) & has], Message("hpgl.needs-no-number"))

    lifts = np.isin(code, (_IN, _PU))
    down = _value_in_force((code == _PD).astype(np.int64), lifts | (code == _PD), 0) > 0
    was_down = np.concatenate([[False], down[:-1]])
    initial = code == _IN
    pen = _value_in_force(np.where(initial, 0, single), (code == _SP) | initial, 0)
    speed = _value_in_force(np.where(initial, -1, single), (code == _VS) | initial, -1)
    force = _value_in_force(np.where(code == _FS, single, -1), np.isin(code, (_FS, _SP, _IN)), -1)

    turned = (down != was_down) & ~initial
    made_before = turned + np.where(point, count // 2, 0)
    total = int(made_before.sum())
    if total > MAX_MOVES:
        raise ProgramUnreadable("program.too-many-moves", moves=total, limit=MAX_MOVES)
    owner = np.repeat(np.arange(len(code)), made_before)
    ordinal = np.arange(total) - np.repeat(np.cumsum(made_before) - made_before, made_before)
    upright = turned[owner] & (ordinal == 0)
    at = instructions.first[owner] + 2 * (ordinal - turned[owner])
    x, y = np.zeros(total + 1, np.int64), np.zeros(total + 1, np.int64)
    states = np.concatenate([[False], ~upright])
    along = np.flatnonzero(~upright)
    x[along + 1], y[along + 1] = instructions.number[at[along]], instructions.number[at[along] + 1]
    last_set = np.maximum.accumulate(np.where(states, np.arange(total + 1), 0))
    return _Track(
        line=instructions.line[owner],
        x=x[last_set],
        y=y[last_set],
        known=last_set > 0,
        down=down[owner],
        upright=upright,
        pen=pen[owner],
        speed=speed[owner],
        force=force[owner],
    )


def _check_state(
    instructions: _Instructions, track: _Track, plotter: Plotter, faults: _Faults
) -> None:
    """Append a fault to ``faults`` for each instruction that the plotter would not accept in its
    state.

    Such faults are a missing IN or PA, an unknown pen, a value or position out of range, a pen,
    speed or force that is set while the tool is down, and a program that ends with the pen down or
    selected.
    """
    code, device = instructions.code, plotter.device
    if len(code) == 0:
        faults.append((1, Message("hpgl.no-instruction")))
        return
    if code[0] != _IN:
        faults.append((int(instructions.line[0]), Message("hpgl.not-initialised")))
    _add_faults(faults, instructions.line[1:][code[1:] == _IN], Message("hpgl.initialised-again"))
    first = np.flatnonzero(np.isin(code, (_PU, _PD)) & (np.diff(instructions.first) > 0))
    if len(first) and not (code[: first[0]] == _PA).any():
        faults.append((int(instructions.line[first[0]]), Message("hpgl.moves-before-pa")))
    down = _value_in_force((code == _PD).astype(np.int64), np.isin(code, (_IN, _PU, _PD)), 0) > 0
    _add_faults(faults, instructions.line[(code == _SP) & down], Message("hpgl.selects-while-down"))
    sets = np.isin(code, (_VS, _FS)) & down
    _add_faults(faults, instructions.line[sets], Message("hpgl.sets-while-down"))
    number = np.zeros(len(code), np.int64)
    has = np.diff(instructions.first) > 0
    number[has] = instructions.number[instructions.first[:-1][has]]
    pen_numbers = [0, *(pen.number for pen in plotter.pens)]
    _add_faults(
        faults,
        instructions.line[(code == _SP) & ~np.isin(number, pen_numbers)],
        Message("hpgl.unknown-pen"),
    )
    for mnemonic, limits, absent, beyond in (
        (_VS, device.speed, "hpgl.no-speed-setting", "hpgl.speed-out-of-range"),
        (_FS, device.force, "hpgl.no-force-setting", "hpgl.force-out-of-range"),
    ):
        rows = code == mnemonic
        if limits is None:
            _add_faults(faults, instructions.line[rows], Message(absent))
        else:
            outside_limits = rows & ((number < limits[0]) | (number > limits[1]))
            _add_faults(
                faults,
                instructions.line[outside_limits],
                Message(beyond, low=limits[0], high=limits[1]),
            )
    last = int(instructions.line[-1])
    if not instructions.ended:
        faults.append((last, Message("hpgl.no-terminator")))
    if down[-1]:
        faults.append((last, Message("hpgl.ends-down")))
    chosen = np.flatnonzero(code == _SP)
    if len(chosen) == 0 or number[chosen[-1]] != 0:
        faults.append((last, Message("hpgl.ends-with-pen")))
    x0, y0, x1, y1 = device.area
    outside = (track.x < x0) | (track.x > x1) | (track.y < y0) | (track.y > y1)
    outside &= track.known
    _add_faults(faults, track.line[outside[1:] & ~track.upright], Message("hpgl.outside-area"))


def _make_moves(
    track: _Track, plotter: Plotter, machine: Machine, board: Board, faults: _Faults
) -> Moves:
    device, count = plotter.device, len(track.line)
    stations = machine.stations
    index = {station.number: row for row, station in enumerate(stations)}
    station = np.full(count, -1, np.int32)
    depth = np.full(count, machine.travel_z)
    oscillating = np.zeros(count, np.bool_)
    feed, plunge = np.full(count, np.nan), np.full(count, np.nan)
    working = track.down & ~track.upright
    for pen in plotter.pens:
        is_pen = track.pen == pen.number
        held = stations[index[pen.station]]
        tool = held.tool
        station[is_pen] = index[pen.station]
        depth[is_pen] = _pen_height(pen, machine, board)
        oscillating[is_pen] = expected_spindle(held).needed
        plunge[is_pen], feed[is_pen] = tool.plunge, tool.feed
        if device.force is not None:
            is_wrong = is_pen & track.down & track.upright & (track.force != pen.force)
            message = Message("hpgl.wrong-force", pen=pen.number, force=pen.force)
            _add_faults(faults, track.line[is_wrong], message)
    if device.speed is not None:
        feed = np.where(track.speed > 0, track.speed * 600.0, np.nan)
        unset = working & (track.speed <= 0)
        _add_faults(faults, track.line[unset][:1], Message("hpgl.no-speed"))
    unselected = track.down & track.upright & (station < 0)
    _add_faults(faults, track.line[unselected], Message("hpgl.no-pen-selected"))

    xy = np.column_stack([track.x, track.y]) / device.units + device.zero
    xy[~track.known] = np.nan
    z = np.where(track.down, depth, machine.travel_z)
    before = np.concatenate([[machine.travel_z], z])[:-1]
    heading = _headings(track, working)
    _check_corners(track, heading, working, station, machine, faults)
    start = np.column_stack([xy[:-1], before, heading])
    end = np.column_stack([xy[1:], z, heading])
    rapid = ~track.down & ~track.upright
    return Moves(
        line=track.line.astype(np.int32),
        code=np.where(rapid, 0, 1).astype(np.uint8),
        start=start,
        end=end,
        centre=np.full((count, 2), np.nan),
        sweep=np.zeros(count),
        feed=np.where(track.upright, plunge, feed),
        inverse=np.zeros(count, np.bool_),
        station=station,
        lowered=np.zeros((count, len(stations)), np.bool_),
        oscillating=oscillating & track.down,
        extra=np.zeros((count, 0), np.bool_),
        # The device switches its tools itself; after IN they are up and off.
        stated=np.ones((count, len(stations) + 1), np.bool_),
        blend=np.zeros(count),
        rested=np.ones(count, np.bool_),
        waited=np.full(count, np.inf),
        uses_tool_table=False,
        dwell=0.0,
        switches=Switches(
            line=np.zeros(0, np.int32),
            move=np.zeros(0, np.int64),
            lowers=np.zeros(0, np.int32),
            beside=np.zeros((0, len(stations)), np.bool_),
            at_end=np.ones(len(stations) + 1, np.bool_),
            spindle=np.zeros(0, np.bool_),
        ),
        # A machine that reads HPGL has one carriage.
        axes_start=np.ascontiguousarray(start[:, : len(machine.axes)]),
        axes_end=np.ascontiguousarray(end[:, : len(machine.axes)]),
        programmed="XY",
        resolution=math.hypot(0.5, 0.5) / device.units,
    )


def _pen_height(pen: Pen, machine: Machine, board: Board) -> float:
    """Return the height of the tip of a lowered pen's tool above the table (mm)."""
    if pen.work is PenWork.CUT:
        return -machine.into_mat
    if pen.work is PenWork.HALF_CUT:
        return board.caliper - board.half_cut_depth
    return board.caliper - board.crease_along


def _headings(track: _Track, working: Bool) -> F64:
    """Return the heading of the tool in each of n moves, (n,) degrees.

    Working moves run along X and Y with the tool down, and have the direction of their paths;
    ``working`` is their mask, (n,).  A lift has the direction of the last working move before it.
    Every other move has the direction of the next working move, or of the last one if none follows.
    Without any working move, all headings are 0.
    """
    if not working.any():
        return np.zeros(len(working))
    own = np.degrees(np.arctan2(np.diff(track.y), np.diff(track.x)))
    rows = np.flatnonzero(working)
    after = np.minimum(np.searchsorted(rows, np.arange(len(working))), len(rows) - 1)
    before = np.maximum(np.searchsorted(rows, np.arange(len(working)), side="right") - 1, 0)
    lifts = track.upright & ~track.down
    result: F64 = own[np.where(lifts, rows[before], rows[after])]
    return result


def _check_corners(
    track: _Track,
    heading: F64,
    working: Bool,
    station: I32,
    machine: Machine,
    faults: _Faults,
) -> None:
    """Append a fault for each corner at which the tool turns in the board by more than its swivel
    angle.

    The ends of moves are rounded to plotter units, so the direction of a short move is uncertain;
    the limit is widened by this uncertainty.  Also appends a fault for each plunge without a move
    before the lift.

    ``heading``, ``working``, ``station`` (n,): heading of each move (degrees), mask of the moves
    with the tool down, and index of the station.
    """
    swivel = np.array(
        [*(expected_tool(mounted.tool).swivel for mounted in machine.stations), 360.0]
    )
    length = np.hypot(np.diff(track.x), np.diff(track.y))
    unsure = np.degrees(math.sqrt(2.0) / np.maximum(length, 1.0))
    turn = np.abs((np.diff(heading) + 180.0) % 360.0 - 180.0)
    limit = swivel[station[1:]] + unsure[1:] + unsure[:-1]
    bad = working[1:] & working[:-1] & (turn > limit)
    for row in np.flatnonzero(bad)[:_MAX_FAULTS]:
        faults.append(
            (
                int(track.line[row + 1]),
                Message("hpgl.turn-in-board", degrees=turn[row], most=limit[row]),
            )
        )
    lowers, lifts = track.upright & track.down, track.upright & ~track.down
    still = lowers & np.append(lifts, False)[1:]
    _add_faults(faults, track.line[still], Message("hpgl.plunge-without-move"))
