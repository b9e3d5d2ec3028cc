"""What a run does to the board: where each tip touches it, and what is dangerous about the run."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.machine import Carriage, Machine, Station
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Laser, Tool, VCutter
from tests.attack.controller import Motion, Run, Switching, sample

#: The length of a blade that a turn of 1° displaces by 0.01 mm (mm).
BLADE: Final = 0.01 / math.sin(math.radians(1.0))
#: Greatest deviation that the attack permits (mm).
TOLERANCE: Final = 0.01


@dataclass(frozen=True, eq=False)
class Contact:
    """The path of one tip in the board during one move."""

    line: int
    station: int
    track: int  #: contacts that no lift separates have the same track
    points: F64  #: (m, 5): x, y, z of the tip, and the far end of its blade relative to it (mm)


@dataclass(eq=False)
class Effect:
    """The contacts of a run with the board, in order, and its dangers."""

    contacts: list[Contact] = field(default_factory=list)
    dangers: list[str] = field(default_factory=list)
    #: corners that the controller rounds by more than the tolerance: what, which station, and
    #: where the tip is
    rounded: list[tuple[str, int, F64]] = field(default_factory=list)


def effect(run: Run, machine: Machine, board: Board, *, tooled: bool) -> Effect:
    """Return what a run does to a board on the machine."""
    result = Effect()
    if not run.ended:
        result.dangers.append("the program does not end")
    if run.left:
        result.dangers.append(f"left on or unknown: {run.left}")
    for switching in run.switchings:
        if fault := _switching_danger(switching, machine, board):
            result.dangers.append(f"line {switching.line}: {fault}")
    track, was_inside = 0, -2
    depths = []
    for motion in run.motions:
        if fault := _state_danger(motion, machine):
            result.dangers.append(f"line {motion.line}: {fault}")
        poses = _tip_poses(motion, machine)
        within = _within(motion, poses, machine, board)
        depths.append(len(within) > 0)
        if not len(within):
            was_inside = -2
            continue
        entered = motion.code > 0 and poses[0, 2] >= board.caliper - 1e-6
        beam = isinstance(machine.stations[motion.station].tool, Laser)
        track += was_inside != motion.station or (entered and not beam)
        was_inside = motion.station
        for fault in _board_dangers(motion, machine):
            result.dangers.append(f"line {motion.line}: {fault}")
        points = _with_blade(within, machine.stations[motion.station].tool)
        result.contacts.append(Contact(motion.line, motion.station, track, points))
    if tooled:
        result.dangers += _overlaps(run.motions, depths, machine)
        result.rounded += _rounded(run.motions, depths, machine)
    return result


def _tip_poses(motion: Motion, machine: Machine) -> F64:
    """Return the poses of the tip during a move, (m, 4): x, y, z in mm and heading in degrees."""
    poses = sample(motion)
    if motion.station < 0:
        return poses
    held = machine.stations[motion.station]
    poses = poses - (held.x, held.y, held.z, held.c)
    radians = np.radians(poses[:, 3])
    ahead = np.stack([np.cos(radians), np.sin(radians)], axis=1)
    right = np.stack([np.sin(radians), -np.cos(radians)], axis=1)
    if isinstance(held.tool, VCutter):
        poses[:, :2] -= held.tool.back * right + held.tool.half_width * ahead
    elif isinstance(held.tool, Knife) and held.tool.trail:
        poses[:, :2] -= held.tool.trail * ahead
    return poses


def _within(motion: Motion, poses: F64, machine: Machine, board: Board) -> F64:
    """Return the part of a path of the tip that is in the board, (m, 4), which may be empty."""
    if motion.station < 0:
        lowest = machine.travel_z + min(held.z for held in machine.stations)
        return poses if poses[:, 2].min() < lowest - 1.0 else poses[:0]
    if isinstance(machine.stations[motion.station].tool, Laser):
        return poses if motion.spindle > 0.0 else poses[:0]
    if not (poses[:, 2] < board.caliper - 1e-6).any():
        return poses[:0]
    high, low = poses[0, 2], poses[-1, 2]
    if max(high, low) > board.caliper and abs(high - low) > 1e-9 and motion.code < 2:
        # Only the part below the top face.
        fraction = (board.caliper - high) / (low - high)
        entry = poses[0] + (poses[-1] - poses[0]) * fraction
        return np.stack([entry, poses[-1]] if low < high else [poses[0], entry])
    return poses


def _with_blade(poses: F64, tool: Tool) -> F64:
    turns = 2.0 if isinstance(tool, CreaseWheel) else 1.0
    reach = 0.0 if isinstance(tool, Cutter | Laser) else BLADE / turns
    radians = np.radians(turns * poses[:, 3])
    blade = reach * np.stack([np.cos(radians), np.sin(radians)], axis=1)
    points: F64 = np.hstack([poses[:, :3], blade])
    return points


def _state_danger(motion: Motion, machine: Machine) -> str:
    """Return what is dangerous about the state in which a move runs, "" if nothing is."""
    before, after = motion.axes_start, motion.axes_end
    changed = {letter for letter in after if before[letter] != after[letter]} - {
        letter for letter in after if math.isnan(before[letter]) and math.isnan(after[letter])
    }
    lifts = motion.code == 0 and changed <= _travel_heights(machine).keys()
    lifts &= all(
        after[letter] >= height - 1e-3 for letter, height in _travel_heights(machine).items()
    )
    modes = {one for one in motion.unknown if "output" not in one and one != "spindle"}
    if modes:
        return f"moves while {sorted(modes)} are not stated"
    if motion.unknown and not lifts:
        return f"moves while {sorted(motion.unknown)} are unknown"
    if any(math.isnan(before[letter]) for letter in _travel_heights(machine)) and not lifts:
        return "moves from an unknown height"
    if motion.code > 0 and any(math.isnan(value) for value in (*motion.start, *motion.end)):
        return "feeds from an unknown position"
    pistons = {held.output for held in machine.stations if held.output >= 0}
    if len(motion.outputs & pistons) > 1:
        return f"outputs {sorted(motion.outputs)} are lowered together"
    letters = _carriage(motion, machine).letters
    if motion.code > 0 and (others := changed - set(letters)):
        return f"feeds the axes {sorted(others)} of another carriage"
    poses = sample(motion)
    ranges = {letter: np.array([before[letter], after[letter]]) for letter in after}
    ranges |= {letter: poses[:, column] for column, letter in enumerate(letters)}
    for letter, values in ranges.items():
        axis, known = machine.axes[letter], values[~np.isnan(values)]
        if len(known) and not (known.min() > axis.low - 1e-3 and known.max() < axis.high + 1e-3):
            return f"axis {letter} leaves its travel"
    return _collision(motion, poses, machine)


def _travel_heights(machine: Machine) -> dict[str, float]:
    """Return the position of each Z axis at which all its stations are at travel height (mm)."""
    heights: dict[str, float] = {}
    for held in machine.stations:
        letter = machine.carriage_of(held).letters[2]
        high = min(machine.travel_z + held.z, machine.axes[letter].high)
        heights[letter] = max(heights.get(letter, -math.inf), high)
    return heights


def _carriage(motion: Motion, machine: Machine) -> Carriage:
    held = machine.stations[motion.station] if motion.station >= 0 else machine.stations[0]
    return machine.carriage_of(held) if motion.station >= 0 else machine.carriages[0]


def _collision(motion: Motion, poses: F64, machine: Machine) -> str:
    """Return which heads or zones a move brings too close, "" if none."""
    if machine.gantry and not math.isnan(poses[0, 1]):
        own = _carriage(motion, machine)
        for other in machine.carriages:
            if other.letters == own.letters:
                continue
            letter = other.letters[1]
            rival = np.linspace(motion.axes_start[letter], motion.axes_end[letter], len(poses))
            apart = np.abs(poses[:, 1] - rival)
            if apart.min() < machine.gantry.min_distance - 1e-3:
                return f"heads only {apart.min():.2f} mm apart"
    if motion.station < 0:
        return ""
    tips = _tip_poses(motion, machine)[:, :3]
    steps = np.linspace(0.0, 1.0, 50)[:, None]
    fine = np.vstack([a + (b - a) * steps for a, b in pairwise(tips)])
    for zone in machine.zones:
        over = (fine[:, 0] > zone.x) & (fine[:, 0] < zone.x + zone.width)
        over &= (fine[:, 1] > zone.y) & (fine[:, 1] < zone.y + zone.height)
        if (fine[over, 2] < zone.top).any():
            return f"a tip enters the zone {zone.name}"
    return ""


def _board_dangers(motion: Motion, machine: Machine) -> list[str]:
    """Return what is dangerous about a move in the board."""
    if motion.station < 0:
        return ["a tool is in the board and no station is selected"]
    held = machine.stations[motion.station]
    tool = held.tool
    faults = []
    if motion.code == 0:
        faults.append("a rapid in the board")
    needed = {held.output, getattr(tool, "air", -1)} - {-1}
    pistons = {other.output for other in machine.stations}
    if not needed <= motion.outputs or motion.outputs & pistons != needed & pistons:
        faults.append(f"in the board with outputs {sorted(motion.outputs)}")
    spindle = _spindle(tool)
    if motion.spindle != spindle:
        faults.append(f"in the board with the spindle at {motion.spindle:g}, not {spindle:g}")
    least = _settle(tool, machine)
    if motion.waited < least - 1e-3:
        faults.append(f"in the board {motion.waited:g} s after switching, not {least:g}")
    if motion.code > 0 and not math.isnan(motion.seconds):
        faults += _feed_danger(motion, held, machine)
    return faults


def _spindle(tool: Tool) -> float:
    if isinstance(tool, Cutter):
        return float(tool.speed)
    if isinstance(tool, Laser):
        return float(tool.power)
    return 1.0 if isinstance(tool, Knife) and tool.oscillating else 0.0


def _settle(tool: Tool, machine: Machine) -> float:
    if isinstance(tool, Laser):
        return float(tool.pierce)
    if isinstance(tool, Cutter):
        return max(float(tool.spin_up), machine.settle)
    return machine.settle


def _slowing(tool: Tool, motion: Motion) -> float:
    """Return the part of its feed with which a tool moves along an arc."""
    if not isinstance(tool, Knife) or tool.free or not tool.slow_radius:
        return 1.0
    radius = math.dist(motion.start[:2], motion.centre)
    return min(1.0, radius / tool.slow_radius)


def _feed_danger(motion: Motion, held: Station, machine: Machine) -> list[str]:
    path = np.diff(sample(motion)[:, :3], axis=0)
    length = float(np.sqrt((path**2).sum(axis=1)).sum())
    if length < 0.05:
        return []
    level = abs(motion.end[2] - motion.start[2]) < 1e-6
    own = (held.tool.feed if level else held.tool.plunge) / 60.0
    if level and motion.code > 1:
        own *= _slowing(held.tool, motion)
    turn = abs(motion.end[3] - motion.start[3])
    velocity = machine.carriage_of(held).axes[3].velocity
    least = max(length / own, turn / velocity)
    tip = np.diff(_tip_poses(motion, machine)[[0, -1], :2], axis=0)
    if np.hypot(*tip[0]) < 1e-3 and level and turn:
        least = turn / velocity  # the head moves round the tip
    late = motion.seconds - least
    if level and motion.code == 1 and isinstance(held.tool, Knife) and held.tool.slow_radius:
        late = min(late, 0.0)  # chords of a tight curve are slow, too
    if abs(late) > 0.01 * least + 1e-3:
        return [f"{length / motion.seconds * 60:.0f} mm/min in the board"]
    return []


def _switching_danger(switching: Switching, machine: Machine, board: Board) -> str:
    pistons = {held.output: held for held in machine.stations if held.output >= 0}
    if switching.moving and switching.output >= 0:
        return f"output {switching.output} switches while the head moves"
    beam = any(isinstance(held.tool, Laser) for held in machine.stations)
    if switching.output < 0 and beam:
        return ""
    others = [
        held
        for output, held in pistons.items()
        if output in switching.lowered or f"output {output}" in switching.unknown
    ]
    others += [held for held in [pistons.get(switching.output)] if held]
    tip = min(
        (
            switching.heights[machine.carriage_of(held).letters[2]] - held.z
            for held in others or machine.stations
        ),
        default=math.nan,
    )
    if not tip >= board.caliper + machine.clearance - 1e-3:
        return f"switches with a tip at {tip:g} mm"
    if switching.on and switching.output in pistons:
        rivals = {one for one in pistons if one in switching.lowered and one != switching.output}
        rivals |= {
            one
            for one in pistons
            if f"output {one}" in switching.unknown and one != switching.output
        }
        if rivals:
            return f"lowers a second station beside {sorted(rivals)}"
    return ""


def _rounded(
    motions: list[Motion], inside: list[bool], machine: Machine
) -> list[tuple[str, int, F64]]:
    """Return the corners in the board that LinuxCNC rounds beyond the tolerance.

    Each is (what happens, station, place of the tip).
    """
    return [
        (
            f"line {other.line}: the corner is rounded by {other.blending:g} mm",
            other.station,
            _tip_poses(other, machine)[0],
        )
        for (one, other), within in zip(pairwise(motions), inside[1:], strict=True)
        if within and min(one.blending, other.blending) > TOLERANCE
    ]


def _overlaps(motions: list[Motion], inside: list[bool], machine: Machine) -> list[str]:
    """Return the pairs of moves that LinuxCNC overlaps so that the tip or its heading is wrong.

    The joints blend for as long as the slowest needs to change its speed (ADR 8).
    """
    faults = []
    for k, (one, other) in enumerate(pairwise(motions)):
        if other.stops_before or not one.code or not other.code or not (inside[k] or inside[k + 1]):
            continue
        (length, turn, speed), (length_b, turn_b, speed_b) = (
            _travel(each) for each in (one, other)
        )
        if (length < 1e-9) != (length_b < 1e-9) and abs(turn if length < 1e-9 else turn_b) > 0.5:
            faults.append(f"line {other.line}: a turn in place overlaps a move")
            continue
        if length < 1e-9 or length_b < 1e-9:
            continue
        change = abs(math.radians(turn / length - turn_b / length_b))
        fast = max(speed, speed_b)
        x, y, _, c = (axis.acceleration for axis in _carriage(other, machine).axes)
        time = max(fast / min(x, y), fast * change / math.radians(c))
        if change * (fast * time) ** 2 / 2.0 > 2.0 * TOLERANCE:
            faults.append(f"line {other.line}: overlaps the move before without a stop")
    return faults


def _travel(motion: Motion) -> tuple[float, float, float]:
    """Return the length of a move (mm), its turn of C (degrees) and its speed (mm/s)."""
    path = np.diff(sample(motion)[:, :3], axis=0)
    length = float(np.sqrt((path**2).sum(axis=1)).sum())
    turn = motion.end[3] - motion.start[3]
    return length, turn, length / motion.seconds if motion.seconds > 0.0 else 0.0
