"""Convert the words of an RS274/NGC program to moves, each with the controller's modal state.

The language is the subset of RS274/NGC that LinuxCNC and grblHAL share, limited to the words that a
sample-maker's program needs.  All other words are faults.

Source: Kramer, Proctor & Messina, "The NIST RS274NGC interpreter", section 3 (modal groups, order
of execution); grbl's own rules where they are stricter.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import itemgetter
from typing import Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I32, I64, U8, Bool
from knifetip.verification.reading.moves import Moves, Switches
from knifetip.verification.reading.rs274.parse import ProgramWords
from knifetip.verification.tools import expected_tool, extra_outputs, has_beam

#: Greatest number of lines with words.
MAX_BLOCKS: Final = 2_000_000
#: Greatest difference between the radii at both ends of an arc (mm).
ARC_TOLERANCE: Final = 0.002
#: Numbers that differ by less may be printed as one number (mm).
PRINT_ROUNDING: Final = 5e-5

_MOTION, _DWELL, _PLANE, _UNITS, _DISTANCE, _CENTRES, _FEED, _RADIUS, _LENGTH, _SYSTEM, _PATH = (
    range(11)
)
_END, _SPINDLE, _CHANGE, _OUTPUT = range(11, 15)
#: Number of a G word times ten -> modal group.
_G: Final = {
    0: _MOTION,
    10: _MOTION,
    20: _MOTION,
    30: _MOTION,
    40: _DWELL,
    170: _PLANE,
    210: _UNITS,
    900: _DISTANCE,
    911: _CENTRES,
    930: _FEED,
    940: _FEED,
    400: _RADIUS,
    430: _LENGTH,
    490: _LENGTH,
    540: _SYSTEM,
    640: _PATH,
}
_M: Final = {
    2: _END,
    30: _END,
    3: _SPINDLE,
    5: _SPINDLE,
    6: _CHANGE,
    64: _OUTPUT,
    65: _OUTPUT,
}
#: Modes that the program must set before its first move, by modal group.
_STATED: Final[Mapping[int, Message]] = {
    _UNITS: Message("rs274.mode-g21"),
    _DISTANCE: Message("rs274.mode-g90"),
    _CENTRES: Message("rs274.mode-g91-1"),
    _PLANE: Message("rs274.mode-g17"),
    _RADIUS: Message("rs274.mode-g40"),
    _LENGTH: Message("rs274.mode-g49"),
    _FEED: Message("rs274.mode-g94"),
    _SYSTEM: Message("rs274.mode-g54"),
}
_LETTERS: Final = "CFIJNPQSTXYZ"
_AXES: Final = "XYZC"


def interpret(words: ProgramWords, machine: Machine) -> tuple[Moves, list[tuple[int, Message]]]:
    """Return the moves of a program, and its faults (1-based line, message) in ascending order.

    Raises
    ------
    ProgramUnreadable
        The program has more than two million lines with words.
    """
    faults: list[tuple[int, Message]] = list(words.faults)
    blocks = _Blocks(words, faults)
    state = _ModalState(blocks, machine)
    _check_blocks(blocks, state, machine)
    return _make_moves(blocks, state), sorted(faults, key=itemgetter(0))


class _Blocks:
    """The words of a program in columns: one row, called a block, for each program line with
    words.
    """

    def __init__(self, words: ProgramWords, faults: list[tuple[int, Message]]) -> None:
        self.faults = faults
        new = np.ones(len(words.line), np.bool_)
        new[1:] = words.line[1:] != words.line[:-1]
        block = np.cumsum(new) - 1
        self.line: I32 = words.line[new]
        count = len(self.line)
        if count > MAX_BLOCKS:
            raise ProgramUnreadable("program.too-many-lines", lines=count, limit=MAX_BLOCKS)
        self.count = count
        groups = np.full((15, count), -1, np.int32)
        numbers = {letter: np.full(count, np.nan) for letter in _LETTERS}
        kind = np.zeros(len(words.line), np.int64)
        for letter, known in (("G", _G), ("M", _M)):
            rows = np.flatnonzero(words.letter == ord(letter))
            scaled = words.value[rows] * (10.0 if letter == "G" else 1.0)
            codes = np.rint(scaled).astype(np.int64)
            table = np.full(1000, -1, np.int64)
            table[list(known)] = list(known.values())
            group = table[np.clip(codes, 0, 999)]
            group[(codes < 0) | (codes > 999) | (np.abs(codes - scaled) > 1e-9)] = -1
            for row in rows[group < 0][:1000]:
                word = f"{letter}{words.value[row]:g}"
                self._fault(block[row], Message("rs274.unknown-word", word=word))
            known_rows = rows[group >= 0]
            # If a line has two words of a group, use the first; the second is a fault below.
            groups[group[group >= 0][::-1], block[known_rows][::-1]] = codes[group >= 0][::-1]
            kind[rows] = np.where(group >= 0, 100 + group, -1)
        for letter, column in numbers.items():
            rows = np.flatnonzero(words.letter == ord(letter))
            column[block[rows][::-1]] = words.value[rows][::-1]
            kind[rows] = 200 + ord(letter)
        for row in np.flatnonzero(kind == 0)[:1000]:
            letter = chr(words.letter[row])
            self._fault(block[row], Message("rs274.unknown-letter", letter=letter))
        words_used = np.flatnonzero(kind >= 100)
        key = np.sort(block[words_used] * 1000 + kind[words_used])
        for twice in np.unique(key[1:][key[1:] == key[:-1]] // 1000)[:1000]:
            self._fault(twice, Message("rs274.repeated-word"))
        self.group = groups
        self.number = numbers
        if len(words_used):
            self.axes: Bool = ~np.isnan(np.stack([numbers[letter] for letter in _AXES], axis=1))
        else:
            self.axes = np.zeros((count, 4), np.bool_)

    def _fault(self, block: int, message: Message) -> None:
        self.faults.append((int(self.line[block]), message))

    def fault(self, where: Bool, message: Message) -> None:
        """Add a fault with this message for each block of the mask ``where``, at most a
        thousand.
        """
        for block in np.flatnonzero(where)[:1000]:
            self._fault(block, message)

    def has(self, letter: str) -> Bool:
        """Return the mask of the blocks that contain a word with this letter, shape (count,)."""
        result: Bool = ~np.isnan(self.number[letter])
        return result

    def has_code(self, group: int, code: int | None = None) -> Bool:
        """Return the mask of the blocks with a G or M word of a modal group, shape (count,).

        With ``code``, only blocks with the word of that code are in the mask.  The code of a G word
        is ten times its number; the code of an M word is its number.
        """
        column = self.group[group]
        result: Bool = column >= 0 if code is None else column == code
        return result


def _latest_block(where: Bool) -> I64:
    """Return, for each block, the index of the last block of the mask ``where`` up to it, (count,).

    The block itself counts; the index is -1 if there is none.
    """
    rows: I64 = np.maximum.accumulate(np.where(where, np.arange(len(where)), -1))
    return rows


def _value_in_force(values: F64, where: Bool, before: float = np.nan) -> F64:
    """Return the value in force at each block, (count,).

    It is the value in ``values`` of the last block of the mask ``where`` up to and including that
    block, or ``before`` if there is none yet.
    """
    rows = _latest_block(where)
    if len(rows) == 0:
        return np.zeros(0)
    result: F64 = np.where(rows >= 0, values[rows], before)
    return result


class _ModalState:
    """The modal state of the controller after each block of a program, in columns."""

    def __init__(self, blocks: _Blocks, machine: Machine) -> None:
        count = blocks.count
        stations = machine.stations
        number = blocks.number
        self.uses_tool_table = bool(blocks.has_code(_CHANGE).any() or blocks.has("T").any())
        self.chosen = _value_in_force(number["T"], blocks.has("T"))
        change = blocks.has_code(_CHANGE)
        self.loaded = _value_in_force(self.chosen, change)
        self.on = np.zeros((count, len(stations)), np.bool_)
        # An output is unknown until a line switches it: an earlier job may have left it on.
        extra = extra_outputs(machine)
        self.stated = np.ones((count, len(stations) + len(extra) + 1), np.bool_)
        self.extra = np.zeros((count, len(extra)), np.bool_)
        for place, output in enumerate(extra):
            mine = blocks.has_code(_OUTPUT) & (number["P"] == output)
            held = _value_in_force(blocks.has_code(_OUTPUT, 64).astype(np.float64), mine)
            self.extra[:, place] = held > 0.5
            self.stated[:, len(stations) + place] = ~np.isnan(held)
        self.lowers = np.full(count, -1, np.int32)
        switched = blocks.has_code(_OUTPUT) | blocks.has_code(_SPINDLE)
        latest = np.full(count, -1, np.int64)
        by_piston = np.full(count, -1, np.int64)
        by_table = np.full(count, -1, np.int64)
        for index, station in enumerate(stations):
            mine = blocks.has_code(_OUTPUT) & (number["P"] == station.output)
            if station.output >= 0:
                rises = blocks.has_code(_OUTPUT, 64)
                held = _value_in_force(rises.astype(np.float64), mine)
                self.on[:, index] = held > 0.5
                self.stated[:, index] = ~np.isnan(held)
                self.lowers[mine & rises] = index
                risen = _latest_block(mine & rises)
                newer = self.on[:, index] & (risen > latest)
                by_piston[newer] = index
                latest[newer] = risen[newer]
            by_table[self.loaded == station.number] = index
        if not self.uses_tool_table:
            fixed = [index for index, station in enumerate(stations) if station.output < 0]
            if len(fixed) == 1:
                by_piston[by_piston < 0] = fixed[0]
        self.station = by_table if self.uses_tool_table else by_piston
        turning = _value_in_force(
            blocks.has_code(_SPINDLE, 3).astype(np.float64), blocks.has_code(_SPINDLE)
        )
        self.oscillating: Bool = turning > 0.5
        self.stated[:, -1] = ~np.isnan(turning)
        self.speed = _value_in_force(number["S"], blocks.has("S"))

        length = blocks.has_code(_LENGTH)
        with_table = blocks.has_code(_LENGTH, 430)
        self.offset_of = _value_in_force(
            np.where(with_table, by_table, -1).astype(np.float64), length, -1.0
        )
        datum = np.array([(s.x, s.y, s.z, s.c) for s in stations]).reshape(-1, 4)
        self.offset = np.vstack([datum, np.zeros((1, 4))])[self.offset_of.astype(np.int64)]

        mode = blocks.has_code(_FEED)
        self.inverse: Bool = (
            _value_in_force((blocks.group[_FEED] == 930).astype(np.float64), mode, 0.0) > 0.5
        )
        changed = np.zeros(count, np.bool_)
        changed[1:] = self.inverse[1:] != self.inverse[:-1]
        has_feed = blocks.has("F")
        stated = _latest_block(has_feed)
        # grbl clears the feed when the feed mode changes, so F must follow.
        fresh = (stated >= 0) & (stated >= _latest_block(changed))
        fresh &= ~self.inverse | has_feed
        held = _value_in_force(number["F"], has_feed)
        self.feed = np.where(fresh & (held > 0.0), held, np.nan)

        blending = blocks.has_code(_PATH)
        bound = np.fmax(number["P"], number["Q"])
        # For LinuxCNC P0, or G64 without P, means no limit.
        bound = np.where(blending & (number["P"] > 0.0), bound, np.inf)
        self.blend = _value_in_force(bound, blending, np.inf if self.uses_tool_table else 0.0)

        dwell = np.where(blocks.has_code(_DWELL), np.nan_to_num(number["P"]), 0.0)
        spent = np.cumsum(dwell)
        last = _latest_block(switched)
        self.waited = np.where(last >= 0, spent - spent[last], np.inf) if count else np.zeros(0)
        #: (count,) the last switching was of the spindle
        self.by_spindle: Bool = _latest_block(blocks.has_code(_SPINDLE)) > _latest_block(
            blocks.has_code(_OUTPUT)
        )
        self.dwell = float(dwell.sum())


def _check_blocks(blocks: _Blocks, state: _ModalState, machine: Machine) -> None:
    """Add the faults in the words, values and modes of all blocks, and at the program's end."""
    _check_words(blocks, state)
    settle = _settle_times(state, machine)
    _check_values(blocks, state, machine, settle)
    _check_modes(blocks, state, settle)
    _check_end(blocks, state)


def _check_words(blocks: _Blocks, state: _ModalState) -> None:
    """Add a fault for each block that lacks a required word or has incompatible words."""
    fault, has, has_code = blocks.fault, blocks.has, blocks.has_code
    moving = has_code(_MOTION)
    any_axis: Bool = np.logical_or.reduce(blocks.axes, axis=1)
    curved = has_code(_MOTION, 20) | has_code(_MOTION, 30)
    fault(any_axis & ~moving, Message("rs274.axis-without-motion"))
    fault(moving & ~any_axis, Message("rs274.motion-without-axis"))
    fault(
        curved & ~(blocks.axes[:, 0] & blocks.axes[:, 1] & has("I") & has("J")),
        Message("rs274.incomplete-arc"),
    )
    fault((has("I") | has("J")) & ~curved, Message("rs274.centre-without-arc"))
    other = has("T") | has("S") | has("P") | has("Q")
    for group in (_DWELL, _LENGTH, _SYSTEM, _PATH, _END, _SPINDLE, _CHANGE, _OUTPUT):
        other |= has_code(group)
    for group in (_PLANE, _UNITS, _DISTANCE, _CENTRES, _RADIUS):
        other |= has_code(group)
    fault(moving & other, Message("rs274.moves-and-switches"))

    timed, switched, bounded = has_code(_DWELL), has_code(_OUTPUT), has_code(_PATH)
    used = timed | switched | bounded
    twice = (timed & switched) | (timed & bounded) | (switched & bounded)
    fault((has("P") & ~used) | twice, Message("rs274.stray-p"))
    fault(used & ~has("P"), Message("rs274.missing-p"))
    fault(has("Q") & ~has_code(_PATH), Message("rs274.stray-q"))
    if not state.uses_tool_table:
        fault(bounded, Message("rs274.g64-unsupported"))


def _settle_times(state: _ModalState, machine: Machine) -> F64:
    """Return the dwell (s) that is required before each block after outputs were switched,
    (count,).

    It is the settling time of the machine or of the selected tool, whichever is longer.  A beam
    needs its piercing time after it is switched on, and none after it is switched off.
    """
    tools = [expected_tool(held.tool) for held in machine.stations]
    settle = np.maximum([*(tool.min_dwell for tool in tools), 0.0], machine.settle)[state.station]
    # A beam need not settle; it dwells until it has pierced the board.
    unused = 0.0 if has_beam(machine) else -1.0
    pierce = np.array([*(tool.beam.pierce if tool.beam else -1.0 for tool in tools), unused])
    switched_beam = state.by_spindle & (pierce[state.station] >= 0.0)
    result: F64 = np.where(
        switched_beam, np.where(state.oscillating, pierce[state.station], 0.0), settle
    )
    return result


def _check_values(blocks: _Blocks, state: _ModalState, machine: Machine, settle: F64) -> None:
    """Add faults for wrong values of dwells, feeds, speeds, outputs, stations and line numbers.

    ``settle`` is the dwell that is required between the last switching and each block (s),
    (count,).
    """
    fault, has, has_code, number = blocks.fault, blocks.has, blocks.has_code, blocks.number
    timed = has_code(_DWELL)
    # A dwell of 0 only ends blending; all others are for settling after switching.
    waits = (number["P"] == 0.0) | (np.abs(number["P"] - settle) <= PRINT_ROUNDING)
    fault(timed & ~waits, Message("rs274.wrong-dwell", settle=machine.settle))
    fault(has("F") & ~(number["F"] > 0.0), Message("rs274.bad-feed"))
    outputs = [station.output for station in machine.stations if station.output >= 0]
    outputs += extra_outputs(machine)
    fault(
        has_code(_OUTPUT) & ~np.isin(number["P"], outputs),
        Message("rs274.unknown-output", machine=machine.name),
    )
    # A spindle has its own speed; an oscillating knife has S1.
    turns = np.array([*(expected_tool(held.tool).speed for held in machine.stations), 1.0])
    fault(has("S") & ~has_code(_SPINDLE, 3), Message("rs274.speed-without-m3"))
    fault(
        has_code(_SPINDLE, 3) & (state.speed != np.rint(turns[state.station])),
        Message("rs274.wrong-speed"),
    )
    known = [station.number for station in machine.stations]
    fault(
        has("T") & ~np.isin(number["T"], known),
        Message("rs274.unknown-station", machine=machine.name),
    )
    fault(has_code(_CHANGE) & np.isnan(state.chosen), Message("rs274.change-without-station"))
    fault(
        has_code(_LENGTH, 430) & np.isnan(state.loaded),
        Message("rs274.offset-without-station"),
    )
    fault(
        has("N") & ((number["N"] < 0.0) | (number["N"] != np.rint(number["N"]))),
        Message("rs274.bad-line-number"),
    )


def _check_modes(blocks: _Blocks, state: _ModalState, settle: F64) -> None:
    """Add a fault for each move before the modes that it needs are set, or before outputs have
    settled.

    ``settle`` is the dwell that is required between the last switching and each block (s),
    (count,).
    """
    fault, has, has_code = blocks.fault, blocks.has, blocks.has_code
    moving = has_code(_MOTION)
    first_move = int(np.argmax(moving)) if moving.any() else blocks.count
    for group, mode in _STATED.items():
        stated = has_code(group)
        stated[first_move + 1 :] = False
        if first_move < blocks.count and not stated.any():
            fault(np.arange(blocks.count) == first_move, Message("rs274.moves-unstated", mode=mode))
    if state.uses_tool_table:
        unbound = np.isinf(state.blend) & moving & ~has_code(_MOTION, 0)
        if unbound.any():
            fault(
                np.arange(blocks.count) == int(np.argmax(unbound)),
                Message("rs274.unbounded-rounding"),
            )
    feeding = moving & ~has_code(_MOTION, 0)
    fault(feeding & state.inverse & ~has("F"), Message("rs274.timed-without-f"))
    fault(
        feeding & ~state.inverse & np.isnan(state.feed),
        Message("rs274.no-feed"),
    )
    unready: Bool = moving & (state.waited < settle - 1e-9)
    # One fault for each switching, not one for each move after it.
    unready[1:] &= ~(moving[:-1] & (state.waited[:-1] < settle[:-1] - 1e-9))
    fault(unready, Message("rs274.not-settled"))


def _check_end(blocks: _Blocks, state: _ModalState) -> None:
    """Check that the program ends with M2 or M30, in the safe state and with nothing after it."""
    fault, has_code = blocks.fault, blocks.has_code
    ends = has_code(_END)
    if not ends.any():
        blocks.faults.append((int(blocks.line[-1]) if blocks.count else 1, Message("rs274.no-end")))
        return
    end = int(np.argmax(ends))
    after = np.arange(blocks.count) > end
    fault(after, Message("rs274.after-end"))
    here = np.arange(blocks.count) == end
    fault(here & state.oscillating, Message("rs274.ends-oscillating"))
    fault(here & state.extra.any(axis=1), Message("rs274.ends-output-on"))
    fault(here & state.on.any(axis=1), Message("rs274.ends-lowered"))
    fault(here & (state.offset_of >= 0), Message("rs274.ends-with-offset"))


def _switching_lines(blocks: _Blocks, state: _ModalState, moving: I64) -> Switches:
    """Return the program lines that switch an output or the spindle, or select a station.

    ``moving`` holds the indices of the blocks that contain moves, ascending.
    """
    rows = np.flatnonzero(
        blocks.has_code(_OUTPUT) | blocks.has_code(_SPINDLE) | blocks.has_code(_CHANGE)
    )
    return Switches(
        line=blocks.line[rows],
        move=np.searchsorted(moving, rows) - 1,
        lowers=state.lowers[rows],
        beside=state.on[rows] | ~state.stated[rows, : state.on.shape[1]],
        at_end=np.logical_or.reduce(state.stated, axis=0),
        spindle=(blocks.has_code(_SPINDLE) & ~blocks.has_code(_OUTPUT) & ~blocks.has_code(_CHANGE))[
            rows
        ],
    )


def _make_moves(blocks: _Blocks, state: _ModalState) -> Moves:
    ended = np.cumsum(blocks.has_code(_END)) > 0
    any_axis: Bool = np.logical_or.reduce(blocks.axes, axis=1)
    rows = np.flatnonzero(blocks.has_code(_MOTION) & any_axis & ~ended)
    stated = np.stack([blocks.number[letter][rows] for letter in _AXES], axis=1)
    joints = stated + state.offset[rows]
    end = np.stack(
        [_value_in_force(joints[:, axis], ~np.isnan(joints[:, axis])) for axis in range(4)], axis=1
    ).reshape(-1, 4)
    start = np.vstack([np.full((min(1, len(rows)), 4), np.nan), end[:-1]])
    code = (blocks.group[_MOTION][rows] // 10).astype(np.uint8)
    centre, sweep = _make_arcs(blocks, rows, code, start, end)
    return Moves(
        line=blocks.line[rows],
        code=code,
        start=start,
        end=end,
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
        waited=state.waited[rows],
        uses_tool_table=state.uses_tool_table,
        dwell=state.dwell,
        switches=_switching_lines(blocks, state, rows),
    )


def _make_arcs(blocks: _Blocks, rows: I64, code: U8, start: F64, end: F64) -> tuple[F64, F64]:
    """Return the centres of the arcs among n moves, (n, 2) mm, and their signed sweeps, (n,)
    radians.

    A line has centre NaN and sweep 0.  An invalid arc also has centre NaN and sweep 0, and gives a
    fault.

    Parameters
    ----------
    rows : (n,)
        Indices of the blocks of the moves.
    code : (n,)
        Number of the G word of each move.
    start, end : (n, 4)
        Joint positions at the start and the end of each move.
    """
    curved = code >= 2
    from_start = np.stack([blocks.number["I"][rows], blocks.number["J"][rows]], axis=1)
    centre = np.where(curved[:, None], start[:, :2] + from_start, np.nan)
    out, back = start[:, :2] - centre, end[:, :2] - centre
    radius, other = np.hypot(*out.T), np.hypot(*back.T)
    good = curved & (np.abs(radius - other) <= ARC_TOLERANCE) & (radius > PRINT_ROUNDING)
    wrong = np.zeros(blocks.count, np.bool_)
    wrong[rows[curved & ~good]] = True
    blocks.fault(wrong, Message("rs274.bad-arc", limit=ARC_TOLERANCE))
    with np.errstate(invalid="ignore"):
        angle = np.arctan2(back[:, 1], back[:, 0]) - np.arctan2(out[:, 1], out[:, 0])
    ahead = np.where(code == 3, angle, -angle) % (2.0 * np.pi)
    # Equal printed ends mean a full circle, for LinuxCNC and for grbl.
    same = np.hypot(*(end - start)[:, :2].T) < PRINT_ROUNDING
    ahead = np.where(same, 2.0 * np.pi, ahead)
    sweep = np.where(good, np.where(code == 3, ahead, -ahead), 0.0)
    return np.where(good[:, None], centre, np.nan), sweep
