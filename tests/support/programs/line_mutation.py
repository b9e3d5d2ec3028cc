"""Line mutation: change whole lines or words of a program, and measure the effect on the product.

    mutants(text) -> (kind, row, mutant)
    displacement(text, mutant) -> how far cuts and creases move (mm)
    hazard(text) -> what is dangerous on a machine in an unknown state

The interpreter is that of ``digit_mutation``.  Here the paths of the tip in the board are compared
as sets in any order, with the heading as two additional coordinates, so lines may be added and
removed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel, Cutter, Knife, VCutter
from tests.support.programs.digit_mutation import Move, poses_in_board, tip_moves

_WORD = re.compile(r"([A-Z])(-?\d*\.?\d+)")
_COMMENT = re.compile(rb"\([^)\n]*\)|;[^\n]*")


def mutants(text: bytes) -> Iterator[tuple[str, int, bytes]]:
    """Yield every line mutation of a program: its kind, its first row, and the changed text."""
    lines = text.decode("ascii").splitlines()

    def replaced(row: int, *new: str, count: int = 1) -> bytes:
        return ("\n".join([*lines[:row], *new, *lines[row + count :]]) + "\n").encode()

    for row, line in enumerate(lines):
        if not line or line.startswith(("(", ";", "%")):
            continue
        yield "line dropped", row, replaced(row)
        yield "line repeated", row, replaced(row, line, line)
        if row + 1 < len(lines) and lines[row + 1] != line:
            yield "lines swapped", row, replaced(row, lines[row + 1], line, count=2)
        for kind, new in _words(line):
            if new != line:
                yield kind, row, replaced(row, new)
    switches = [
        (row, other)
        for row, line in enumerate(lines)
        for other in range(row + 1, min(row + 12, len(lines)))
        if line.startswith("M65") and lines[other].startswith("M64")
    ]
    for row, other in switches:
        swapped = [lines[other], *lines[row + 1 : other], lines[row]]
        yield (
            "lifted after the next is lowered",
            row,
            replaced(row, *swapped, count=other - row + 1),
        )


def _words(line: str) -> Iterator[tuple[str, str]]:
    """Yield the kind and the result of every change to a single word of a line."""
    words = _WORD.findall(line)

    def changed(letter: str, number: str, new: str) -> str:
        return line.replace(letter + number, new, 1)

    for letter, number in words:
        value = float(number)
        if letter == "G" and value in (2.0, 3.0):
            yield "G2 for G3", changed("G", number, f"G{5 - int(value)}")
        elif letter == "G" and value == 1.0:
            yield "rapid for feed", re.sub(r" F[\d.]+", "", changed("G", number, "G0"))
        elif letter == "G" and value > 3.0:
            yield "modal word dropped", changed("G", number, "").strip()
            if value == 21.0:
                yield "inches for millimetres", changed("G", number, "G20")
            if value == 90.0:
                yield "relative for absolute", changed("G", number, "G91")
        elif letter in "IJ":
            yield f"sign of {letter}", changed(letter, number, f"{letter}{-value:.4f}")
        elif letter == "C":
            yield "C turned by 180", changed("C", number, f"C{value + 180.0:.4f}")
            yield "C turned by 90", changed("C", number, f"C{value - 90.0:.4f}")
            yield "C turned by 360", changed("C", number, f"C{value + 360.0:.4f}")
            yield "C turned by -360", changed("C", number, f"C{value - 360.0:.4f}")
            yield "C turned by 2", changed("C", number, f"C{value + 2.0:.4f}")
        elif letter == "Z":
            yield "Z in inches", changed("Z", number, f"Z{value / 25.4:.4f}")
            yield "Z deeper by 0.05", changed("Z", number, f"Z{value - 0.05:.4f}")
            yield "Z higher by 0.05", changed("Z", number, f"Z{value + 0.05:.4f}")
        elif letter in "XY":
            yield "coordinate off by 0.02", changed(letter, number, f"{letter}{value + 0.02:.4f}")
            yield "sign of a coordinate", changed(letter, number, f"{letter}{-value:.4f}")
        elif letter == "F":
            yield "feed zero", changed("F", number, "F0")
            yield "feed doubled", changed("F", number, f"F{2.0 * value:g}")
        elif letter == "T":
            yield "another station", changed("T", number, f"T{int(value) % 4 + 1}")
        elif letter == "M" and value in (64.0, 65.0):
            yield "M64 for M65", changed("M", number, f"M{129 - int(value)}")
        elif letter == "S":
            yield "speed halved", changed("S", number, f"S{value / 2.0:g}")


def hazard(text: bytes, machine: Machine) -> str:
    """Return what is dangerous if a program runs after a cancelled job, "" if nothing is.

    The cancelled job may have left any output on, the spindle running and a tool in the board.
    """
    by_number = {station.number: station for station in machine.stations}
    unknown = {float(station.output) for station in machine.stations if station.output >= 0}
    unknown.add(math.inf)  # the spindle
    lowered: set[float] = set()
    low = machine.travel_z + min(station.z for station in machine.stations)
    high = machine.travel_z + max(station.z for station in machine.stations)
    joint, datum, called = -math.inf, 0.0, 0.0
    for number, raw in enumerate(_COMMENT.sub(b"", text).decode("ascii").splitlines(), 1):
        words = dict(_WORD.findall(raw))
        code, called = float(words.get("M", -1)), float(words.get("T", called))
        output = float(words.get("P", -1)) if code in (64.0, 65.0) else math.inf
        if "G43" in raw:
            datum = by_number[int(called)].z
        if "G49" in raw:
            datum = 0.0
        if code in (3.0, 5.0, 64.0, 65.0):
            if joint < low - 1e-3:
                return f"line {number} while axis Z is at {joint:g}"
            unknown.discard(output)
            lowered.discard(output)
            if code == 64.0 and (lowered | unknown) - {math.inf}:
                return f"line {number} lowers a second station"
            if code in (3.0, 64.0):
                lowered.add(output)
        if words.keys() & set("XYZC"):
            joint = float(words["Z"]) + datum if "Z" in words else joint
            sideways = bool(words.keys() & set("XYC"))
            if unknown and (sideways or joint < high - 1e-3):
                return f"line {number} moves while {sorted(unknown)} are unknown"
        if code in (2.0, 30.0):
            break
    left = unknown | lowered
    return f"ends with {sorted(left)} on or unknown" if left else ""


def displacement(
    text: bytes, mutant: bytes, machine: Machine, board: Board, dieline: Dieline
) -> float:
    """Return how far a mutation displaces what the tools make in the board (mm).

    ``inf`` if a rapid is in the board or the mutant is not valid.  Every point of the old path
    below the top of the board is compared with the nearest point of the new path with the same
    station, and vice versa; depth and heading are coordinates of the points.  For a router, only
    the distance of its path from the parts is compared.
    """
    before, after = tip_moves(text, machine), tip_moves(mutant, machine)
    if before is None or after is None:
        return math.inf
    old = _paths_in_board(before, machine, board)
    new = _paths_in_board(after, machine, board)
    if new is None or old is None:
        return math.inf
    mills = [
        1e3 * k for k, mounted in enumerate(machine.stations) if isinstance(mounted.tool, Cutter)
    ]
    farthest = 0.0
    if mills:
        milled_old, milled_new = (
            [path for path in paths if path[0, 0] in mills] for paths in (old, new)
        )
        old, new = ([path for path in paths if path[0, 0] not in mills] for paths in (old, new))
        tool = machine.stations[int(mills[0] / 1e3)].tool
        assert isinstance(tool, Cutter)
        farthest = _router_displacement(
            milled_old, milled_new, tool.radius, -machine.into_mat, dieline
        )
    return max(farthest, _greatest_distance(new, old), _greatest_distance(old, new))


def _router_displacement(
    before: list[F64], after: list[F64], radius: float, low: float, dieline: Dieline
) -> float:
    """Return how much nearer a router's path comes to the parts, or how much farther it stays (mm).

    ``before`` and ``after`` are its paths of the two programs.  Moves through the whole board,
    below ``low``, are compared at the edges, nearer and farther; moves at any depth are also
    compared at points inside the parts, nearer only.
    """
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    rings = [
        chords(dieline.ends[row, 0], dieline.ends[row, 1], float(dieline.bulge[row]))
        for row in cuts
    ]
    edge = np.vstack(rings)
    x, y = (np.arange(a, b, 2.0) for a, b in zip(edge.min(axis=0), edge.max(axis=0), strict=True))
    grid = np.stack(np.meshgrid(x + 0.7, y + 0.3), axis=-1).reshape(-1, 2)
    crossings = np.zeros(len(grid), np.int64)
    for ring in rings:
        for (ax, ay), (bx, by) in pairwise(ring):
            if ay != by:
                fraction = (grid[:, 1] - ay) / (by - ay)
                crossings += ((ay > grid[:, 1]) != (by > grid[:, 1])) & (
                    ax + fraction * (bx - ax) > grid[:, 0]
                )
    places = np.vstack([edge, grid[crossings % 2 == 1]])
    through = [
        [path for path in paths if path[:, 3].max() <= low + 0.005] for paths in (before, after)
    ]
    deep = [np.minimum(_path_distance(edge, paths), radius + 0.5) for paths in through]
    shallow = [_path_distance(places, paths) for paths in (before, after)]
    nearer = np.where(shallow[1] < radius + 0.05, shallow[0] - shallow[1], 0.0)
    return max(float(np.abs(deep[1] - deep[0]).max()), float(nearer.max()))


def _path_distance(points: F64, paths: list[F64]) -> F64:
    """Return the distance of each point to the nearest path, (n,) mm; at most 1000."""
    nearest = np.full(len(points), 1e3)
    if not paths:
        return nearest
    start = np.vstack([path[:-1, 1:3] for path in paths])
    step = np.vstack([np.diff(path[:, 1:3], axis=0) for path in paths])
    size = np.maximum((step**2).sum(axis=1), 1e-18)
    for rows in np.array_split(np.arange(len(start)), len(start) // 50 + 1):
        x, y = (points[:, None] - start[rows]).transpose(2, 0, 1)
        along = np.clip((x * step[rows, 0] + y * step[rows, 1]) / size[rows], 0.0, 1.0)
        x, y = x - along * step[rows, 0], y - along * step[rows, 1]
        nearest = np.minimum(nearest, (x * x + y * y).min(axis=1) ** 0.5)
    return nearest


def chords(start: F64, end: F64, bulge: float) -> F64:
    """Return points along an edge about every half millimetre, on arcs every 5°, (n, 2)."""
    size = float(np.hypot(*(end - start)))
    count = max(int(2.0 * size), int(math.degrees(4.0 * abs(math.atan(bulge))) / 5.0))
    fraction = np.linspace(0.0, 1.0, 2 + count)[:, None]
    path: F64 = start + (end - start) * fraction
    if bulge == 0.0:
        return path
    left = np.array([start[1] - end[1], end[0] - start[0]])
    centre = (start + end) / 2.0 + left * (1.0 - bulge**2) / (4.0 * bulge)
    out = start - centre
    angle = 4.0 * math.atan(bulge) * fraction
    turned = np.hstack([-out[1] * np.sin(angle), out[0] * np.sin(angle)])
    bent: F64 = centre + out * np.cos(angle) + turned
    return bent


def _paths_in_board(moves: list[Move], machine: Machine, board: Board) -> list[F64] | None:
    """Return the paths in the board, or None if a rapid is in it or a coordinate is unknown.

    Each path is (k, 6): station, x, y, z, and the two coordinates of the blade's far end, relative
    to the tip.
    """
    result = []
    for move in moves:
        path = poses_in_board(move, board.caliper)
        if not len(path):
            continue
        if move.rapid or np.isnan(path).any():
            return None
        tool = machine.stations[move.station].tool
        reach, turns = 0.0, 1.0
        if isinstance(tool, Knife):
            reach = tool.blade_width
        elif isinstance(tool, VCutter):
            reach = 2.0 * tool.half_width
        elif isinstance(tool, CreaseWheel):
            # A wheel is symmetrical under 180°: half the contact length at twice the angle.
            depth = board.caliper - path[:, 2].min()
            reach, turns = 0.5 * math.sqrt(max(depth * (2.0 * tool.radius - depth), 0.0)), 2.0
        else:
            assert isinstance(tool, Cutter)
        angle = np.radians(turns * path[:, 3])
        far = reach * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        station = np.full((len(path), 1), 1e3 * move.station)
        result.append(np.hstack([station, path[:, :3], far]))
    return result


def _greatest_distance(paths: list[F64], others: list[F64]) -> float:
    """Return the greatest distance of the points of some paths from all other paths (mm).

    Points directly above a deeper point of another path have the distance 0.
    """
    known = {other.tobytes() for other in others}
    own = [path for path in paths if path.tobytes() not in known]
    if not own:
        return 0.0
    if not others:
        return math.inf
    start = np.vstack([other[:-1] for other in others])
    step = np.vstack([np.diff(other, axis=0) for other in others])
    flat = np.array([1.0, 1.0, 1.0, 0.0, 1.0, 1.0])
    size = ((step * flat) ** 2).sum(axis=1)
    # A vertical move acts at its lowest point.
    upright = size < 1e-18
    start[upright] += np.where(step[upright, 3:4] < 0.0, step[upright], 0.0)
    step[upright], size[upright] = 0.0, 1.0
    low, high = np.minimum(start, start + step) - 1.0, np.maximum(start, start + step) + 1.0
    farthest = 0.0
    for path in own:
        pieces = [a + (b - a) * np.linspace(0.0, 1.0, 9)[:, None] for a, b in pairwise(path)]
        points = np.vstack(pieces) if len(pieces) < 9 else path
        inside = (high >= points.min(axis=0)) & (low <= points.max(axis=0))
        near = np.flatnonzero((inside | (flat == 0.0)).all(axis=1))
        if not len(near):
            return math.inf
        to = points[:, None] - start[near]
        along = np.clip((to * flat * step[near]).sum(axis=2) / size[near], 0.0, 1.0)
        to -= along[..., None] * step[near]
        to[..., 3] = np.minimum(to[..., 3], 0.0)
        farthest = max(farthest, float(np.linalg.norm(to, axis=2).min(axis=1).max()))
    return farthest
