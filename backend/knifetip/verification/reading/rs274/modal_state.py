"""Compute the modal state of the controller after each line of a program.

Each mode or value is an array with one entry per program line that has words.
"""

from __future__ import annotations

import numpy as np

from knifetip.model.machine import Machine
from knifetip.verification.columns import Bool
from knifetip.verification.reading.rs274.blocks import (
    Group,
    ProgramBlocks,
    latest_block,
    value_in_force,
)
from knifetip.verification.tools import carriage_columns, extra_outputs


class ModalState:
    """The modal state of the controller after each block (program line with words): one array for
    each mode or value, with one entry per block.
    """

    def __init__(self, blocks: ProgramBlocks, machine: Machine) -> None:
        count = blocks.count
        stations = machine.stations
        number = blocks.number
        self.uses_tool_table = bool(blocks.has_code(Group.CHANGE).any() or blocks.has("T").any())
        self.chosen = value_in_force(number["T"], blocks.has("T"))
        change = blocks.has_code(Group.CHANGE)
        self.loaded = value_in_force(self.chosen, change)
        self.on = np.zeros((count, len(stations)), np.bool_)
        # An output is unknown until a line switches it: an earlier job may have left it on.
        extra = extra_outputs(machine)
        self.stated = np.ones((count, len(stations) + len(extra) + 1), np.bool_)
        self.extra = np.zeros((count, len(extra)), np.bool_)
        for place, output in enumerate(extra):
            mine = blocks.has_code(Group.OUTPUT) & (number["P"] == output)
            held = value_in_force(blocks.has_code(Group.OUTPUT, 64).astype(np.float64), mine)
            self.extra[:, place] = held > 0.5
            self.stated[:, len(stations) + place] = ~np.isnan(held)
        self.lowers = np.full(count, -1, np.int32)
        switched = blocks.has_code(Group.OUTPUT) | blocks.has_code(Group.SPINDLE)
        latest = np.full(count, -1, np.int64)
        by_piston = np.full(count, -1, np.int64)
        by_table = np.full(count, -1, np.int64)
        for index, station in enumerate(stations):
            mine = blocks.has_code(Group.OUTPUT) & (number["P"] == station.output)
            if station.output >= 0:
                rises = blocks.has_code(Group.OUTPUT, 64)
                held = value_in_force(rises.astype(np.float64), mine)
                self.on[:, index] = held > 0.5
                self.stated[:, index] = ~np.isnan(held)
                self.lowers[mine & rises] = index
                risen = latest_block(mine & rises)
                newer = self.on[:, index] & (risen > latest)
                by_piston[newer] = index
                latest[newer] = risen[newer]
            by_table[self.loaded == station.number] = index
        if not self.uses_tool_table:
            fixed = [index for index, station in enumerate(stations) if station.output < 0]
            if len(fixed) == 1:
                by_piston[by_piston < 0] = fixed[0]
        self.station = by_table if self.uses_tool_table else by_piston
        turning = value_in_force(
            blocks.has_code(Group.SPINDLE, 3).astype(np.float64), blocks.has_code(Group.SPINDLE)
        )
        self.oscillating: Bool = turning > 0.5
        self.stated[:, -1] = ~np.isnan(turning)
        self.speed = value_in_force(number["S"], blocks.has("S"))

        length = blocks.has_code(Group.LENGTH)
        with_table = blocks.has_code(Group.LENGTH, 430)
        self.offset_of = value_in_force(
            np.where(with_table, by_table, -1).astype(np.float64), length, -1.0
        )
        # The last row is for blocks without an offset.
        datum = np.zeros((len(stations) + 1, len(machine.axes)))
        columns = carriage_columns(machine)
        for index, station in enumerate(stations):
            datum[index, columns[index]] = station.x, station.y, station.z, station.c
        self.offset = datum[self.offset_of.astype(np.int64)]

        mode = blocks.has_code(Group.FEED)
        self.inverse: Bool = (
            value_in_force((blocks.group[Group.FEED] == 930).astype(np.float64), mode, 0.0) > 0.5
        )
        has_feed = blocks.has("F")
        stated = latest_block(has_feed)
        # LinuxCNC clears the feed at each G93 and G94, also if the mode stays, so F must follow.
        fresh = (stated >= 0) & (stated >= latest_block(mode))
        fresh &= ~self.inverse | has_feed
        held = value_in_force(number["F"], has_feed)
        self.feed = np.where(fresh & (held > 0.0), held, np.nan)

        blending = blocks.has_code(Group.PATH)
        bound = np.fmax(number["P"], number["Q"])
        # For LinuxCNC P0, or G64 without P, means no limit.
        bound = np.where(blending & (number["P"] > 0.0), bound, np.inf)
        self.blend = value_in_force(bound, blending, np.inf if self.uses_tool_table else 0.0)

        dwell = np.where(blocks.has_code(Group.DWELL), np.nan_to_num(number["P"]), 0.0)
        spent = np.cumsum(dwell)
        last = latest_block(switched)
        self.waited = np.where(last >= 0, spent - spent[last], np.inf) if count else np.zeros(0)
        #: (count,) the last switching was of the spindle
        self.by_spindle: Bool = latest_block(blocks.has_code(Group.SPINDLE)) > latest_block(
            blocks.has_code(Group.OUTPUT)
        )
        self.dwell = float(dwell.sum())
