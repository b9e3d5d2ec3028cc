"""Digit mutation: change one digit of a program and determine the effect on the tool's tip.

    mutants(text) -> (position, mutant)        effect(text, position, mutant) -> kind of change

The effect is determined by an interpreter that reads only the G-code of these programs and shares
no code with the verifier.  It compares the path of the tip in the board before and after the
change as a set of points (x, y, z), so a point that moves along its own line has no effect.
``count_refusals`` counts how many changes of each kind a verifier refuses.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel, Knife, VCutter

#: A change that displaces the working tip by more than this must be refused (mm).
TOLERANCE = 0.01
#: A digit changes the ends of two moves; so many moves before and after are compared.
NEIGHBOURS = 3

_WORD = re.compile(r"([A-Z])(-?\d*\.?\d+)")
_COMMENT = re.compile(rb"\([^)\n]*\)|;[^\n]*")

#: (n, 4): x, y, z of the tip on the sheet (mm) and heading (degrees) of n poses.
Poses = F64


@dataclass(frozen=True)
class Move:
    """A program line that moves the tool, with the path of the tip as chords within 0.0002 mm."""

    line: int
    rapid: bool
    station: int  #: index in the machine's stations, -1 for none
    poses: Poses


def mutants(text: bytes, count: int, seed: int) -> Iterator[tuple[int, bytes]]:
    """Yield positions in the text, each with the text in which the digit there is changed.

    ``count`` positions and their new digits are chosen at random by the seed.
    """
    chance = np.random.default_rng(seed)
    digits = np.flatnonzero((line_bytes := np.frombuffer(text, np.uint8)) - 48 < 10)
    for position in chance.choice(digits, count, replace=count > len(digits)):
        mutant = bytearray(text)
        mutant[position] = 48 + (line_bytes[position] - 48 + chance.integers(1, 10)) % 10
        yield int(position), bytes(mutant)


def effect(text: bytes, position: int, mutant: bytes, machine: Machine, board: Board) -> str:
    """Return the kind of effect that a change at a position of the program has.

    ``moved``: the working tip moves by more than 0.01 mm, another station works, or a rapid enters
    the board.  Otherwise it depends on the changed word: ``comment``; ``feed``; ``output``
    (stations, pistons, oscillation, dwells); ``rounding`` (G64); ``code`` (other G words); ``line``
    (the program is no longer valid); ``smaller`` (a coordinate that moves the working tip by at
    most 0.01 mm); ``air`` (a coordinate that does not move the working tip); ``idle`` (an output is
    switched, but all outputs are the same at every move).
    """
    if any(found.start() <= position < found.end() for found in _COMMENT.finditer(text)):
        return "comment"
    before, after = tip_moves(text, machine), tip_moves(mutant, machine)
    if before is None or after is None:
        return "line"
    displacement = _displacement(before, after, machine, board)
    # Changes of one digit are often 0.01 exactly, which must not count because of rounding.
    if displacement > TOLERANCE + 1e-6:
        return "moved"
    start = text.rfind(b"\n", 0, position) + 1
    line = text[start : text.find(b"\n", position)].decode()
    letter = max(
        (found for found in _WORD.finditer(line) if found.start() <= position - start),
        key=lambda found: found.start(),
    )[1]
    if letter in "XYZCIJ":
        return "smaller" if displacement > 0.0 else "air"
    if letter == "F":
        return "feed"
    if "G64" in line:
        return "rounding"
    if re.match(r"M6[45]\b", line) and outputs_at_moves(text) == outputs_at_moves(mutant):
        return "idle"
    return "output" if letter in "MTSP" else "code"


def outputs_at_moves(text: bytes) -> list[dict[float, bool]]:
    """Return the states (number: on) of all switched outputs at each move and at the end."""
    outputs: dict[float, bool] = {}
    result = []
    for line_bytes in _COMMENT.sub(b"", text).decode("ascii").splitlines():
        words = {letter: float(number) for letter, number in _WORD.findall(line_bytes)}
        if words.get("M") in (64.0, 65.0):
            outputs[words.get("P", -1.0)] = words["M"] == 64.0
        elif words.keys() & set("XYZC"):
            result.append(dict(outputs))
    return [*result, outputs]


def count_refusals(
    text: bytes,
    machine: Machine,
    board: Board,
    refused: Callable[[bytes], bool],
    *,
    count: int,
    seed: int,
) -> tuple[Counter[str], Counter[str], list[tuple[str, int, bytes]]]:
    """Verify ``count`` mutants of a program and count the refused ones.

    Returns
    -------
    total, caught : Counter
        Number of mutants and of refused mutants, by kind of effect.
    missed : list of (kind, position, mutant)
        Mutants that were accepted.
    """
    total: Counter[str] = Counter()
    caught: Counter[str] = Counter()
    missed = []
    for position, mutant in mutants(text, count, seed):
        kind = effect(text, position, mutant, machine, board)
        total[kind] += 1
        if refused(mutant):
            caught[kind] += 1
        else:
            missed.append((kind, position, mutant))
    return total, caught, missed


def changed_line(text: bytes, position: int, mutant: bytes) -> str:
    """Return the changed program line before and after the change, for the message of a failure."""
    row = text.count(b"\n", 0, position)
    return f"line {row + 1}: {text.splitlines()[row]!r} -> {mutant.splitlines()[row]!r}"


def tip_moves(text: bytes, machine: Machine) -> list[Move] | None:
    """Return the moves of the tip in a program, None if the program is not valid."""
    by_number = {station.number: index for index, station in enumerate(machine.stations)}
    by_output = {station.output: index for index, station in enumerate(machine.stations)}
    tabled = re.search(rb"\bM6\b", text) is not None
    joints = np.full(4, np.nan)
    offset = np.zeros(4)
    scale, relative = 1.0, False
    called, station = -1, -1
    moves = []
    for row, line_bytes in enumerate(_COMMENT.sub(b"", text).decode("ascii").splitlines(), 1):
        words = [(letter, float(number)) for letter, number in _WORD.findall(line_bytes)]
        codes = {number for letter, number in words if letter == "G"}
        values = {letter: number for letter, number in words if letter != "G"}
        if "T" in values:
            called = by_number.get(int(values["T"]), -1)
            if called < 0:
                return None
        if values.get("M") == 6.0:
            station = called
        if not tabled and values.get("M") in (64.0, 65.0):
            switched = by_output.get(int(values.get("P", -1.0)), -1)
            if switched < 0:
                return None
            if values["M"] == 64.0:
                station = switched
            elif station == switched:
                station = -1
        if 43.0 in codes:
            offset = _datum(machine, station)
        if 49.0 in codes:
            offset = np.zeros(4)
        scale = 25.4 if 20.0 in codes else 1.0 if 21.0 in codes else scale
        relative = relative or 91.0 in codes
        axes = [letter for letter in "XYZC" if letter in values]
        code = next((number for number in (0.0, 1.0, 2.0, 3.0) if number in codes), None)
        if code is None or not axes:
            if axes:
                return None
            continue
        target = joints.copy()
        for column, letter in enumerate("XYZC"):
            if letter in values:
                size = values[letter] * (scale if letter != "C" else 1.0)
                target[column] = size + (joints[column] if relative else offset[column])
        if code >= 2.0 and (np.isnan(joints).any() or not {"I", "J"} <= values.keys()):
            return None
        centre = joints[:2] + scale * np.array([values.get("I", 0.0), values.get("J", 0.0)])
        poses = _joint_poses(joints, target, centre, code)
        moves.append(Move(row, code == 0.0, station, _tip_poses(poses, machine, station)))
        joints = target
    return moves


def _datum(machine: Machine, station: int) -> F64:
    mounted = machine.stations[station]
    return np.array([mounted.x, mounted.y, mounted.z, mounted.c]) if station >= 0 else np.zeros(4)


def _joint_poses(start: F64, end: F64, centre: F64, code: float) -> Poses:
    if code < 2.0:
        # A tool that turns by more than 180° passes through all headings in between.
        turn = abs(end[3] - start[3])
        pieces = 2 if not turn > 180.0 else 2 + int(turn / 10.0)
        straight: Poses = start + (end - start) * np.linspace(0.0, 1.0, pieces)[:, None]
        return straight
    (ax, ay), (bx, by) = start[:2] - centre, end[:2] - centre
    first, last = math.atan2(ay, ax), math.atan2(by, bx)
    sweep = (last - first) % (2.0 * math.pi)
    if code == 2.0:
        sweep -= 2.0 * math.pi
    if math.hypot(*(end - start)[:2]) < 1e-9:
        sweep = 2.0 * math.pi if code == 3.0 else -2.0 * math.pi
    # If the radii at the ends differ, the radius is interpolated, as in LinuxCNC.
    radius, other = math.hypot(ax, ay), math.hypot(bx, by)
    pieces = 2 + int(abs(sweep) * math.sqrt(max(radius, other) / 1.6e-3))
    fraction = np.linspace(0.0, 1.0, pieces)[:, None]
    angle, size = first + sweep * fraction, radius + (other - radius) * fraction
    poses: Poses = start + (end - start) * fraction
    poses[:, :2] = centre + size * np.hstack([np.cos(angle), np.sin(angle)])
    return poses


def _tip_poses(joints: Poses, machine: Machine, station: int) -> Poses:
    poses: Poses = joints - _datum(machine, station)
    if station >= 0:
        tool = machine.stations[station].tool
        cos, sin = np.cos(np.radians(poses[:, 3])), np.sin(np.radians(poses[:, 3]))
        if isinstance(tool, VCutter):
            poses[:, 0] -= tool.back * sin + tool.half_width * cos
            poses[:, 1] -= -tool.back * cos + tool.half_width * sin
        elif isinstance(tool, Knife):
            poses[:, 0] -= tool.trail * cos
            poses[:, 1] -= tool.trail * sin
    return poses


def poses_in_board(move: Move, caliper: float) -> Poses:
    """Return the poses of a move below the top of the board, (n, 4), which may be (0, 4)."""
    poses = move.poses
    if move.station < 0 or not (poses[:, 2] < caliper - 1e-6).any():
        return poses[:0]
    if len(poses) == 2 and (poses[:, 2] >= caliper - 1e-6).any():
        high, low = (poses[0], poses[1]) if poses[0, 2] > poses[1, 2] else (poses[1], poses[0])
        entry = low + (high - low) * (caliper - low[2]) / (high[2] - low[2])
        return np.stack([entry, low])
    return poses


def _displacement(before: list[Move], after: list[Move], machine: Machine, board: Board) -> float:
    """Return how far the working tip is displaced, including the swing of the blade (mm).

    ``inf`` if the number of moves differs, another station works, or a rapid enters the board.
    """
    if len(before) != len(after):
        return math.inf
    caliper = board.caliper
    old = [poses_in_board(move, caliper) for move in before]
    new = [poses_in_board(move, caliper) for move in after]
    farthest = 0.0
    for index, (one, other) in enumerate(zip(before, after, strict=True)):
        same = one.station == other.station and one.rapid == other.rapid
        if same and np.array_equal(one.poses, other.poses, equal_nan=True):
            continue
        if len(new[index]) and (other.rapid or one.station != other.station):
            return math.inf
        farthest = max(
            farthest,
            _distance_to_paths(new, old, index),
            _distance_to_paths(old, new, index),
            _blade_swing(one, other, machine, caliper)
            if len(old[index]) and len(new[index])
            else 0.0,
        )
    return farthest


def _nearby_paths(paths: list[Poses], index: int) -> list[Poses]:
    """Return the paths of a move and of its neighbours up to the next lift out of the board."""
    first, last = index, index
    while first > max(0, index - NEIGHBOURS) and len(paths[first - 1]):
        first -= 1
    while last + 1 < min(len(paths), index + NEIGHBOURS + 1) and len(paths[last + 1]):
        last += 1
    return [poses for poses in paths[first : last + 1] if len(poses)]


def _distance_to_paths(moved: list[Poses], paths: list[Poses], index: int) -> float:
    """Return the greatest distance of the path ``moved[index]`` from other paths (mm).

    The others are those near the same index in ``paths``, and straight ones with which the path is
    in line: a tool that enters the board within such a path, in its direction, changes nothing.
    """
    path = moved[index]
    in_line = _in_line(path, paths)
    distance = _greatest_distance(path, _nearby_paths(paths, index) + in_line)
    if len(path) == 2 and (path[0, :2] == path[1, :2]).all():
        lowest = path[path[:, 2].argmin()][None]
        distance = min(distance, _greatest_distance(lowest, in_line))
    return distance


def _in_line(path: Poses, paths: list[Poses]) -> list[Poses]:
    """Return the straight paths that have the line, the depth and the heading of a path."""
    depth = path[:, 2].min(initial=np.inf)
    return [
        one
        for one in paths
        if len(one) == 2
        and len(path) == 2
        and (np.abs(one[:, 2] - depth) < 1e-6).all()
        and (np.abs((one[:, 3] - path[0, 3] + 180.0) % 360.0 - 180.0) < 1e-6).all()
        and _distance_to_line(path, one) < 1e-6
    ]


def _distance_to_line(path: Poses, line: Poses) -> float:
    """Return the greatest distance of points from the infinite line through two points (mm)."""
    along = line[1, :2] - line[0, :2]
    size = math.hypot(*along)
    if size == 0.0:
        return math.inf
    across = np.array([-along[1], along[0]]) / size
    return float(np.abs((path[:, :2] - line[0, :2]) @ across).max())


def _greatest_distance(poses: Poses, others: list[Poses]) -> float:
    """Return the greatest distance of the points of a path from the other paths (mm)."""
    if len(poses) == 0:
        return 0.0
    if not others:
        return math.inf
    fraction = np.linspace(0.0, 1.0, 65 if len(poses) == 2 else 3)[:-1]
    steps = (
        poses[:-1, None, :3] + np.diff(poses[:, :3], axis=0)[:, None] * fraction[:, None]
    ).reshape(-1, 3)
    points = np.vstack([steps, poses[-1, :3]])
    nearest = np.full(len(points), np.inf)
    for other in others:
        start, step = other[:-1, :3], np.diff(other[:, :3], axis=0)
        size = np.maximum((step**2).sum(axis=1), 1e-18)
        for rows in np.array_split(np.arange(len(start)), len(start) // 500 + 1):
            to = points[:, None] - start[rows]
            along = np.clip((to * step[rows]).sum(axis=2) / size[rows], 0.0, 1.0)
            apart = np.linalg.norm(to - along[..., None] * step[rows], axis=2)
            nearest = np.minimum(nearest, apart.min(axis=1))
    return float(nearest.max())


def _blade_swing(one: Move, other: Move, machine: Machine, caliper: float) -> float:
    """Return how far the far end of the blade moves because headings differ at the ends of a move
    (mm).
    """
    tool = machine.stations[one.station].tool
    turn = 360.0
    if isinstance(tool, Knife):
        reach = tool.blade_width
    elif isinstance(tool, VCutter):
        reach = 2.0 * tool.half_width
    else:
        assert isinstance(tool, CreaseWheel)
        turn = 180.0
        depth = caliper - one.poses[:, 2].min()
        reach = math.sqrt(max(depth * (2.0 * tool.radius - depth), 0.0))
    off = other.poses[[0, -1], 3] - one.poses[[0, -1], 3]
    off = np.abs((off + turn / 2.0) % turn - turn / 2.0).max()
    return float(2.0 * reach * math.sin(math.radians(off) / 2.0))
