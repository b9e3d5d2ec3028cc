"""Find faults in the words, values and modes of the lines of a program, and at the program's end.

A line must obey the rules of both LinuxCNC and grblHAL.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.verification.columns import F64, Bool
from knifetip.verification.reading.rs274.blocks import Group, ProgramBlocks, latest_block
from knifetip.verification.reading.rs274.modal_state import ModalState
from knifetip.verification.tools import expected_spindle, expected_tool, extra_outputs, has_beam

#: Numbers that differ by less may be printed as one number (mm, s).
PRINT_ROUNDING: Final = 5e-5
#: Modes that the program must set before its first move, by modal group.
_REQUIRED_MODES: Final[Mapping[Group, Message]] = {
    Group.UNITS: Message("rs274.mode-g21"),
    Group.DISTANCE: Message("rs274.mode-g90"),
    Group.CENTRES: Message("rs274.mode-g91-1"),
    Group.PLANE: Message("rs274.mode-g17"),
    Group.RADIUS: Message("rs274.mode-g40"),
    Group.LENGTH: Message("rs274.mode-g49"),
    Group.FEED: Message("rs274.mode-g94"),
    Group.SYSTEM: Message("rs274.mode-g54"),
    Group.SHIFT: Message("rs274.mode-g92-1"),
}


def check_blocks(blocks: ProgramBlocks, state: ModalState, machine: Machine) -> None:
    """Add a fault to ``blocks`` for each wrong word, value or mode, and for a wrong end of the
    program.

    A block is a program line with words; ``state`` is the modal state of the controller after each
    block.
    """
    _check_words(blocks, state)
    settle = _settle_times(state, machine)
    _check_values(blocks, state, machine, settle)
    if machine.arcs == "chords":
        arcs = blocks.has_code(Group.MOTION, 20) | blocks.has_code(Group.MOTION, 30)
        blocks.fault(arcs, Message("rs274.arc-on-chord-machine", machine=machine.name))
    if not state.uses_tool_table:
        _check_rest(blocks)
    _check_modes(blocks, state, settle)
    _check_end(blocks, state)


def _check_words(blocks: ProgramBlocks, state: ModalState) -> None:
    """Add a fault for each block that lacks a required word or has incompatible words."""
    fault, has, has_code = blocks.fault, blocks.has, blocks.has_code
    moving = has_code(Group.MOTION)
    curved = has_code(Group.MOTION, 20) | has_code(Group.MOTION, 30)
    fault(blocks.moves_axis & ~moving, Message("rs274.axis-without-motion"))
    fault(moving & ~blocks.moves_axis, Message("rs274.motion-without-axis"))
    fault(
        curved & ~(blocks.axes[:, 0] & blocks.axes[:, 1] & has("I") & has("J")),
        Message("rs274.incomplete-arc"),
    )
    fault((has("I") | has("J")) & ~curved, Message("rs274.centre-without-arc"))
    other = has("T") | has("S") | has("P") | has("Q")
    for group in set(Group) - {Group.MOTION, Group.FEED}:
        other |= has_code(group)
    fault(moving & other, Message("rs274.moves-and-switches"))

    # G4 and G92.1 have one modal group.
    fault(has_code(Group.DWELL) & has_code(Group.SHIFT), Message("rs274.repeated-word"))
    timed, switched, bounded = has_code(Group.DWELL), has_code(Group.OUTPUT), has_code(Group.PATH)
    used = timed | switched | bounded
    twice = (timed & switched) | (timed & bounded) | (switched & bounded)
    fault((has("P") & ~used) | twice, Message("rs274.stray-p"))
    fault(used & ~has("P"), Message("rs274.missing-p"))
    fault(has("Q") & ~has_code(Group.PATH), Message("rs274.stray-q"))
    if not state.uses_tool_table:
        fault(bounded, Message("rs274.g64-unsupported"))


def _settle_times(state: ModalState, machine: Machine) -> F64:
    """Return the shortest permitted time (s) from the last switching of an output or the spindle to
    a move in each block, one entry per block.

    A block is a program line with words.  The time is the settling time of the machine or of the
    selected tool, whichever is longer.  If a laser beam was switched last, the time is instead the
    beam's piercing time if the beam is now on, and 0 if it is off.
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


def _check_values(blocks: ProgramBlocks, state: ModalState, machine: Machine, settle: F64) -> None:
    """Add faults for wrong values of dwells, feeds, speeds, outputs, stations and line numbers.

    ``settle`` is the shortest permitted time (s) from the last switching of an output or the
    spindle to a move in each block, one entry per block.  A dwell must last exactly this time or 0.
    """
    fault, has, has_code, number = blocks.fault_at, blocks.has, blocks.has_code, blocks.number
    timed = np.flatnonzero(has_code(Group.DWELL))
    dwell = number["P"][timed]
    # A dwell of 0 only ends blending; all others are for settling after switching.
    waits = (dwell == 0.0) | (np.abs(dwell - settle[timed]) <= PRINT_ROUNDING)
    fault(timed[~waits], Message("rs274.wrong-dwell", settle=machine.settle))
    blocks.fault(has("F") & ~(number["F"] > 0.0), Message("rs274.bad-feed"))
    outputs = [station.output for station in machine.stations if station.output >= 0]
    outputs += extra_outputs(machine)
    switched = np.flatnonzero(has_code(Group.OUTPUT))
    fault(
        switched[~np.isin(number["P"][switched], outputs)],
        Message("rs274.unknown-output", machine=machine.name),
    )
    _check_spindle(blocks, state, machine)
    known = [station.number for station in machine.stations]
    chosen = np.flatnonzero(has("T"))
    fault(
        chosen[~np.isin(number["T"][chosen], known)],
        Message("rs274.unknown-station", machine=machine.name),
    )
    changes = np.flatnonzero(has_code(Group.CHANGE))
    fault(changes[np.isnan(state.chosen[changes])], Message("rs274.change-without-station"))
    offsets = np.flatnonzero(has_code(Group.LENGTH, 430))
    fault(offsets[np.isnan(state.loaded[offsets])], Message("rs274.offset-without-station"))
    numbered = np.flatnonzero(has("N"))
    value = number["N"][numbered]
    fault(
        numbered[(value < 0.0) | (value != np.rint(value))],
        Message("rs274.bad-line-number"),
    )


def _check_spindle(blocks: ProgramBlocks, state: ModalState, machine: Machine) -> None:
    """Add faults for spindles that are switched on with a wrong direction or speed, and for moves
    with the spindle of another station.
    """
    fault, has, has_code = blocks.fault, blocks.has, blocks.has_code
    spindles = [expected_spindle(station) for station in machine.stations]
    # A spindle has its own speed; an oscillating knife has S1.
    codes = np.array([*(spindle.code for spindle in spindles), 3])[state.station]
    speeds = np.rint([*(spindle.speed for spindle in spindles), 1.0])[state.station]
    starts = has_code(Group.SPINDLE, 3) | has_code(Group.SPINDLE, 4)
    fault(has("S") & ~starts, Message("rs274.speed-without-m3"))
    # Without any S the speed is NaN, which differs from each number.
    fault(starts & (state.speed != speeds), Message("rs274.wrong-speed"))
    fault(starts & (blocks.group[Group.SPINDLE] != codes), Message("rs274.wrong-direction"))
    # The spindle of the station before has another direction and speed.
    started = latest_block(starts)
    other = state.oscillating & (state.station >= 0) & (state.station != state.station[started])
    moved = np.flatnonzero(other & has_code(Group.MOTION))
    # One fault for each start of a spindle, not one for each move.
    _, first = np.unique(started[moved], return_index=True)
    blocks.fault_at(moved[first], Message("rs274.spindle-of-other-station"))


def _check_rest(blocks: ProgramBlocks) -> None:
    """Add a fault for each block that switches an output while the head may still move.

    grblHAL switches outputs as soon as it reads M64 or M65, while moves that it has read before are
    still running.  A dwell (G4), also of 0 s, waits until they have ended.
    """
    moved = latest_block(blocks.has_code(Group.MOTION))
    rested = latest_block(blocks.has_code(Group.DWELL))
    blocks.fault(
        blocks.has_code(Group.OUTPUT) & (moved > rested), Message("rs274.switches-while-moving")
    )


def _check_modes(blocks: ProgramBlocks, state: ModalState, settle: F64) -> None:
    """Add faults for required modes that the program has not set before a move, for moves without a
    feed, and for moves that start before switched outputs have settled.

    ``settle`` is the shortest permitted time (s) from the last switching of an output or the
    spindle to a move in each block, one entry per block.
    """
    fault, has, has_code = blocks.fault, blocks.has, blocks.has_code
    moving = has_code(Group.MOTION)
    first_move = int(np.argmax(moving)) if moving.any() else blocks.count
    for group, mode in _REQUIRED_MODES.items():
        stated = has_code(group)[: first_move + 1]
        if first_move < blocks.count and not stated.any():
            fault(np.arange(blocks.count) == first_move, Message("rs274.moves-unstated", mode=mode))
    if state.uses_tool_table:
        unbound = np.isinf(state.blend) & moving
        if unbound.any():
            fault(
                np.arange(blocks.count) == int(np.argmax(unbound)),
                Message("rs274.unbounded-rounding"),
            )
    feeding = moving & ~has_code(Group.MOTION, 0)
    fault(feeding & state.inverse & ~has("F"), Message("rs274.timed-without-f"))
    fault(
        feeding & ~state.inverse & np.isnan(state.feed),
        Message("rs274.no-feed"),
    )
    unready: Bool = moving & (state.waited < settle - 1e-9)
    # One fault for each switching, not one for each move after it.
    unready[1:] &= ~(moving[:-1] & (state.waited[:-1] < settle[:-1] - 1e-9))
    fault(unready, Message("rs274.not-settled"))


def _check_end(blocks: ProgramBlocks, state: ModalState) -> None:
    """Add faults unless the program ends with M2 or M30, in the safe state and with nothing after
    the end.

    In the safe state all outputs and the spindle are off, and no tool offset is active.
    """
    fault, has_code = blocks.fault, blocks.has_code
    ends = has_code(Group.END)
    if not ends.any():
        blocks.faults.append((int(blocks.line[-1]) if blocks.count else 1, Message("rs274.no-end")))
        return
    end = int(np.argmax(ends))
    after = np.arange(blocks.count) > end
    fault(after, Message("rs274.after-end"))
    here = np.arange(blocks.count) == end
    fault(here & state.oscillating, Message("rs274.ends-oscillating"))
    fault(here & state.extra[end].any(), Message("rs274.ends-output-on"))
    fault(here & state.on[end].any(), Message("rs274.ends-lowered"))
    fault(here & (state.offset_of >= 0), Message("rs274.ends-with-offset"))
