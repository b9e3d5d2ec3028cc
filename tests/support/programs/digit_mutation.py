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
FELT = 0.01
#: A digit changes the ends of two moves; so many moves before and after are compared.
NEIGHBOURS = 3

_WORD = re.compile(r"([A-Z])(-?\d*\.?\d+)")
_COMMENT = re.compile(rb"\([^)\n]*\)|;[^\n]*")

#: (n, 4): x, y, z of the tip on the sheet (mm) and heading (degrees) of n poses.
Way = F64


@dataclass(frozen=True)
class Move:
    """A program line that moves the tool, with the path of the tip as chords within 0.0002 mm."""

    line: int
    rapid: bool
    station: int  #: index in the machine's stations, -1 for none
    way: Way


def mutants(text: bytes, count: int, seed: int) -> Iterator[tuple[int, bytes]]:
    """Yield positions in the text, each with the text in which the digit there is changed.

    ``count`` positions and their new digits are chosen at random by the seed.
    """
    chance = np.random.default_rng(seed)
    digits = np.flatnonzero((raw := np.frombuffer(text, np.uint8)) - 48 < 10)
    for place in chance.choice(digits, count, replace=count > len(digits)):
        mutant = bytearray(text)
        mutant[place] = 48 + (raw[place] - 48 + chance.integers(1, 10)) % 10
        yield int(place), bytes(mutant)


def effect(text: bytes, place: int, mutant: bytes, machine: Machine, board: Board) -> str:
    """Return the kind of effect that a change at a position of the program has.

    ``moved``: the working tip moves by more than 0.01 mm, another station works, or a rapid enters
    the board.  Otherwise it depends on the changed word: ``comment``; ``feed``; ``output``
    (stations, pistons, oscillation, dwells); ``rounding`` (G64); ``code`` (other G words); ``line``
    (the program is no longer valid); ``smaller`` (a coordinate that moves the working tip by at
    most 0.01 mm); ``air`` (a coordinate that does not move the working tip); ``idle`` (an output is
    switched, but all outputs are the same at every move).
    """
    if any(found.start() <= place < found.end() for found in _COMMENT.finditer(text)):
        return "comment"
    before, after = followed(text, machine), followed(mutant, machine)
    if before is None or after is None:
        return "line"
    felt = _felt(before, after, machine, board)
    # Changes of one digit are often 0.01 exactly, which must not count because of rounding.
    if felt > FELT + 1e-6:
        return "moved"
    start = text.rfind(b"\n", 0, place) + 1
    line = text[start : text.find(b"\n", place)].decode()
    letter = max(
        (found for found in _WORD.finditer(line) if found.start() <= place - start),
        key=lambda found: found.start(),
    )[1]
    if letter in "XYZCIJ":
        return "smaller" if felt > 0.0 else "air"
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
    for raw in _COMMENT.sub(b"", text).decode("ascii").splitlines():
        words = {letter: float(number) for letter, number in _WORD.findall(raw)}
        if words.get("M") in (64.0, 65.0):
            outputs[words.get("P", -1.0)] = words["M"] == 64.0
        elif words.keys() & set("XYZC"):
            result.append(dict(outputs))
    return [*result, outputs]


def shares(
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
    everything: Counter[str] = Counter()
    caught: Counter[str] = Counter()
    missed = []
    for place, mutant in mutants(text, count, seed):
        kind = effect(text, place, mutant, machine, board)
        everything[kind] += 1
        if refused(mutant):
            caught[kind] += 1
        else:
            missed.append((kind, place, mutant))
    return everything, caught, missed


def told(text: bytes, place: int, mutant: bytes) -> str:
    """Return the changed program line before and after the change, for the message of a failure."""
    row = text.count(b"\n", 0, place)
    return f"line {row + 1}: {text.splitlines()[row]!r} -> {mutant.splitlines()[row]!r}"


def followed(text: bytes, machine: Machine) -> list[Move] | None:
    """Return the moves of the tip in a program, None if the program is not valid."""
    by_number = {station.number: index for index, station in enumerate(machine.stations)}
    by_output = {station.output: index for index, station in enumerate(machine.stations)}
    tabled = re.search(rb"\bM6\b", text) is not None
    joints = np.full(4, np.nan)
    offset = np.zeros(4)
    scale, relative = 1.0, False
    called, station = -1, -1
    moves = []
    for row, raw in enumerate(_COMMENT.sub(b"", text).decode("ascii").splitlines(), 1):
        words = [(letter, float(number)) for letter, number in _WORD.findall(raw)]
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
        way = _way(joints, target, centre, code)
        moves.append(Move(row, code == 0.0, station, _tip(way, machine, station)))
        joints = target
    return moves


def _datum(machine: Machine, station: int) -> F64:
    held = machine.stations[station]
    return np.array([held.x, held.y, held.z, held.c]) if station >= 0 else np.zeros(4)


def _way(start: F64, end: F64, centre: F64, code: float) -> Way:
    if code < 2.0:
        # A tool that turns by more than 180° passes through all headings in between.
        turn = abs(end[3] - start[3])
        pieces = 2 if not turn > 180.0 else 2 + int(turn / 10.0)
        straight: Way = start + (end - start) * np.linspace(0.0, 1.0, pieces)[:, None]
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
    share = np.linspace(0.0, 1.0, pieces)[:, None]
    angle, size = first + sweep * share, radius + (other - radius) * share
    way: Way = start + (end - start) * share
    way[:, :2] = centre + size * np.hstack([np.cos(angle), np.sin(angle)])
    return way


def _tip(way: Way, machine: Machine, station: int) -> Way:
    tip: Way = way - _datum(machine, station)
    if station >= 0:
        tool = machine.stations[station].tool
        cos, sin = np.cos(np.radians(tip[:, 3])), np.sin(np.radians(tip[:, 3]))
        if isinstance(tool, VCutter):
            tip[:, 0] -= tool.back * sin + tool.half_width * cos
            tip[:, 1] -= -tool.back * cos + tool.half_width * sin
        elif isinstance(tool, Knife):
            tip[:, 0] -= tool.trail * cos
            tip[:, 1] -= tool.trail * sin
    return tip


def sunk(move: Move, caliper: float) -> Way:
    """Return the part of the path of a move that is below the top of the board, (n, 4), or (0,
    4).
    """
    way = move.way
    if move.station < 0 or not (way[:, 2] < caliper - 1e-6).any():
        return way[:0]
    if len(way) == 2 and (way[:, 2] >= caliper - 1e-6).any():
        high, low = (way[0], way[1]) if way[0, 2] > way[1, 2] else (way[1], way[0])
        entry = low + (high - low) * (caliper - low[2]) / (high[2] - low[2])
        return np.stack([entry, low])
    return way


def _felt(before: list[Move], after: list[Move], machine: Machine, board: Board) -> float:
    """Return how far the working tip is displaced, including the swing of the blade (mm).

    ``inf`` if the number of moves differs, another station works, or a rapid enters the board.
    """
    if len(before) != len(after):
        return math.inf
    caliper = board.caliper
    old = [sunk(move, caliper) for move in before]
    new = [sunk(move, caliper) for move in after]
    farthest = 0.0
    for index, (one, other) in enumerate(zip(before, after, strict=True)):
        same = one.station == other.station and one.rapid == other.rapid
        if same and np.array_equal(one.way, other.way, equal_nan=True):
            continue
        if len(new[index]) and (other.rapid or one.station != other.station):
            return math.inf
        farthest = max(
            farthest,
            _beyond(new[index], _stay(old, index)),
            _beyond(old[index], _stay(new, index)),
            _swing(one, other, machine, caliper) if len(old[index]) and len(new[index]) else 0.0,
        )
    return farthest


def _stay(ways: list[Way], index: int) -> list[Way]:
    """Return the paths of a move and of its neighbours up to the next lift out of the board."""
    first, last = index, index
    while first > max(0, index - NEIGHBOURS) and len(ways[first - 1]):
        first -= 1
    while last + 1 < min(len(ways), index + NEIGHBOURS + 1) and len(ways[last + 1]):
        last += 1
    return [way for way in ways[first : last + 1] if len(way)]


def _beyond(way: Way, others: list[Way]) -> float:
    """Return the greatest distance of the points of a path from the other paths (mm)."""
    if len(way) == 0:
        return 0.0
    if not others:
        return math.inf
    share = np.linspace(0.0, 1.0, 65 if len(way) == 2 else 3)[:-1]
    steps = (way[:-1, None, :3] + np.diff(way[:, :3], axis=0)[:, None] * share[:, None]).reshape(
        -1, 3
    )
    points = np.vstack([steps, way[-1, :3]])
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


def _swing(one: Move, other: Move, machine: Machine, caliper: float) -> float:
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
        depth = caliper - one.way[:, 2].min()
        reach = math.sqrt(max(depth * (2.0 * tool.radius - depth), 0.0))
    off = other.way[[0, -1], 3] - one.way[[0, -1], 3]
    off = np.abs((off + turn / 2.0) % turn - turn / 2.0).max()
    return float(2.0 * reach * math.sin(math.radians(off) / 2.0))
