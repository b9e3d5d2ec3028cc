"""Compute the modal state of the controller after each line of a program.

Each mode or value is an array with one entry per program line that has words.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, I32_2, I64_1, OutBool_2, kernel
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.reading.rs274.blocks import Group, ProgramBlocks
from knifetip.verification.tools import carriage_columns, extra_outputs

_FEED: Final = int(Group.FEED)
_LENGTH: Final = int(Group.LENGTH)
_PATH: Final = int(Group.PATH)
_DWELL: Final = int(Group.DWELL)
_SPINDLE: Final = int(Group.SPINDLE)
_CHANGE: Final = int(Group.CHANGE)
_OUTPUT: Final = int(Group.OUTPUT)


class ModalState:
    """The modal state of the controller after each block (program line with words): one array for
    each mode or value, with one entry per block.
    """

    def __init__(self, blocks: ProgramBlocks, machine: Machine) -> None:
        number, stations, extra = blocks.number, machine.stations, extra_outputs(machine)
        self.uses_tool_table = bool(blocks.has_code(Group.CHANGE).any() or blocks.has("T").any())
        fixed = [index for index, station in enumerate(stations) if station.output < 0]
        outputs = _Outputs(
            np.array([station.number for station in stations], np.float64),
            np.array([station.output for station in stations], np.float64),
            np.array(extra, np.float64),
            fixed[0] if len(fixed) == 1 else -1,
        )
        #: (count, stations) the output of the station is on
        self.on: Bool = np.zeros((blocks.count, len(stations)), np.bool_)
        self.extra: Bool = np.zeros((blocks.count, len(extra)), np.bool_)
        #: (count, stations + extra outputs + 1) the state of the output or the spindle is known: an
        #: earlier job may have left it on
        self.stated: Bool = np.ones((blocks.count, len(stations) + len(extra) + 1), np.bool_)
        self.lowers, self.station, self.chosen, self.loaded = _follow_outputs(
            blocks.group, number["P"], number["T"], outputs, self.uses_tool_table,
            self.on, self.extra, self.stated,
        )  # fmt: skip
        modes = _follow_modes(
            _Words(blocks.group, *(number[letter] for letter in "FPQS")),
            self.station,
            self.uses_tool_table,
        )
        self.oscillating: Bool = modes.oscillating
        self.stated[:, -1] = modes.spindle_stated
        self.speed: F64 = modes.speed
        #: (count,) index of the station whose tool offset is active, -1 for none
        self.offset_of: I64 = modes.offset_of
        self.inverse: Bool = modes.inverse
        self.feed: F64 = modes.feed
        self.blend: F64 = modes.blend
        self.waited: F64 = modes.waited
        self.by_spindle: Bool = modes.by_spindle
        timed = blocks.has_code(Group.DWELL)
        self.dwell = float(np.where(timed, np.nan_to_num(number["P"]), 0.0).sum())
        #: offset of each station's tool on the axes of the machine; the last row is for no offset
        self.datum: F64 = np.zeros((len(stations) + 1, len(machine.axes)))
        columns = carriage_columns(machine)
        for index, station in enumerate(stations):
            datum = (station.x, station.y, station.z, station.c)
            self.datum[index, columns[index]] = datum[: columns.shape[1]]


class _Outputs(NamedTuple):
    """Stations and outputs of a machine."""

    station: F64_1  #: (s,) number of each station
    output: F64_1  #: (s,) number of the output that lowers each station, -1 for none
    extra: F64_1  #: (e,) numbers of the outputs of ``tools.extra_outputs``
    fixed: int  #: index of the only station without an output, -1 for none


@kernel
def _follow_outputs(
    group: I32_2,
    p: F64_1,
    t: F64_1,
    outputs: _Outputs,
    uses_tool_table: bool,
    on: OutBool_2,
    extra: OutBool_2,
    stated: OutBool_2,
) -> Any:
    """Follow the outputs and the selected station through the blocks of a program.

    ``group`` (groups, count): code of the word of each modal group in each block, -1 for none.
    ``p``, ``t`` (count,): numbers of the P and T words, NaN for none.
    ``outputs``: stations and outputs of the machine.
    ``uses_tool_table``: whether tool changes select the stations; if not, the output that was
    switched on last does.
    ``on``, ``extra``, ``stated``: get the states of the outputs after each block; ``ModalState``
    describes them.
    Returns four arrays with one entry per block: index of the station that the block lowers, index
    of the selected station, number of the station of the last T word, and number of the station
    that the last tool change selected.  An index is -1 and a number NaN for none.
    """
    count, stations = len(p), len(outputs.station)
    lowers, selected = np.full(count, -1, np.int32), np.empty(count, np.int64)
    chosen, loaded = np.empty(count), np.empty(count)
    raised_at = np.full(stations, -1, np.int64)
    by_output = by_table = -1
    last_t = last_loaded = np.nan
    for block in range(count):
        if block > 0:
            on[block] = on[block - 1]
            extra[block] = extra[block - 1]
            stated[block] = stated[block - 1]
        else:
            for place in range(stations + len(outputs.extra)):
                stated[0, place] = place < stations and outputs.output[place] < 0.0
        if not math.isnan(t[block]):
            last_t = t[block]
        if group[_CHANGE, block] >= 0:
            last_loaded = last_t
            by_table = -1
            for index in range(stations):
                if outputs.station[index] == last_loaded:
                    by_table = index
        if group[_OUTPUT, block] >= 0:
            rises = group[_OUTPUT, block] == 64
            for place in range(len(outputs.extra)):
                if p[block] == outputs.extra[place]:
                    extra[block, place] = rises
                    stated[block, stations + place] = True
            by_output, latest = -1, -1
            for index in range(stations):
                if outputs.output[index] >= 0.0 and p[block] == outputs.output[index]:
                    on[block, index] = rises
                    stated[block, index] = True
                    if rises:
                        raised_at[index] = block
                        lowers[block] = index
                if on[block, index] and raised_at[index] > latest:
                    by_output, latest = index, raised_at[index]
        chosen[block], loaded[block] = last_t, last_loaded
        if uses_tool_table:
            selected[block] = by_table
        else:
            selected[block] = by_output if by_output >= 0 else outputs.fixed
    return lowers, selected, chosen, loaded


class _Words(NamedTuple):
    """The words of the blocks of a program that set modes."""

    group: I32_2  #: (groups, count) code of the word of each modal group, -1 for none
    f: F64_1  #: (count,) numbers of the F, P, Q and S words, NaN for none
    p: F64_1
    q: F64_1
    s: F64_1


class _Modes(NamedTuple):
    """Modes and values in force after each block, (count,) each."""

    oscillating: Bool  #: the spindle is on
    spindle_stated: Bool  #: the program has switched the spindle
    speed: F64  #: S, NaN for none
    offset_of: I64  #: index of the station whose tool offset is active, -1 for none
    inverse: Bool  #: G93
    feed: F64  #: F, NaN for none
    blend: F64  #: mm, larger of P and Q of G64; inf without a limit
    waited: F64  #: s of dwell since the last switching, inf before the first
    by_spindle: Bool  #: the last switching was of the spindle


@kernel
def _follow_modes(words: _Words, station: I64_1, uses_tool_table: bool) -> Any:
    """Return the ``_Modes`` after each block of a program.

    ``station`` is the index of the selected station in each block, (count,), and
    ``uses_tool_table`` whether tool changes select the stations.
    """
    group = words.group
    count = len(station)
    oscillating, spindle_stated = np.empty(count, np.bool_), np.empty(count, np.bool_)
    speed, offset_of = np.empty(count), np.empty(count, np.int64)
    inverse, feed = np.empty(count, np.bool_), np.empty(count)
    blend, waited, by_spindle = np.empty(count), np.empty(count), np.empty(count, np.bool_)
    turns, switched_spindle = False, False
    last_speed, held_feed = np.nan, np.nan
    bound = np.inf if uses_tool_table else 0.0
    offset, timed, fresh = -1, False, False
    spent, spent_before, switched = 0.0, 0.0, False
    spindle_at, output_at = -1, -1
    for block in range(count):
        if group[_SPINDLE, block] >= 0:
            turns, switched_spindle = group[_SPINDLE, block] != 5, True
            spindle_at = block
        if not math.isnan(words.s[block]):
            last_speed = words.s[block]
        if group[_LENGTH, block] >= 0:
            with_table = uses_tool_table and group[_LENGTH, block] == 430
            offset = station[block] if with_table else -1
        has_feed = not math.isnan(words.f[block])
        if group[_FEED, block] >= 0:
            timed = group[_FEED, block] == 930
            # LinuxCNC clears the feed at each G93 and G94, also if the mode stays: F must follow.
            fresh = False
        if has_feed:
            held_feed, fresh = words.f[block], True
        if group[_PATH, block] >= 0:
            # For LinuxCNC P0, or G64 without P, means no limit.
            bound = np.inf
            if words.p[block] > 0.0:
                bound = words.p[block]
                if words.q[block] > bound:
                    bound = words.q[block]
        if group[_DWELL, block] >= 0 and not math.isnan(words.p[block]):
            spent += words.p[block]
        if group[_OUTPUT, block] >= 0:
            output_at = block
        if spindle_at == block or output_at == block:
            spent_before, switched = spent, True
        oscillating[block], spindle_stated[block] = turns, switched_spindle
        speed[block], offset_of[block], inverse[block] = last_speed, offset, timed
        in_force = fresh and (has_feed or not timed) and held_feed > 0.0
        feed[block] = held_feed if in_force else np.nan
        blend[block] = bound
        waited[block] = spent - spent_before if switched else np.inf
        by_spindle[block] = spindle_at > output_at
    return _Modes(
        oscillating, spindle_stated, speed, offset_of, inverse, feed, blend, waited, by_spindle
    )
