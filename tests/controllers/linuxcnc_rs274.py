"""A second verifier, which reads programs with LinuxCNC's own interpreter rs274.

    program bytes  ->  rs274  ->  canonical moves  ->  path of each tool's tip  ->  Report

It shares no code with the product: moves are those that LinuxCNC interprets, tools are literals in
the tests, and distances are measured to the lines and arcs of the dieline.  rs274 prints positions
with 4 decimals and without the tool offset, whose linear part it reads as inches.  It has the axes
XYZABC only: the word V of a second carriage is written as B for it, which is moved in the same way.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from knifetip.model.dieline import LineType

F64 = NDArray[np.float64]
RS274 = shutil.which("rs274")
ABSENT = "LinuxCNC's interpreter rs274 is not installed (apt-get install linuxcnc-uspace)"

INI = """[RS274NGC]
[EMCIO]
TOOL_TABLE = tool.tbl
[TRAJ]
COORDINATES = X Y Z C
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
AXES = 4
[KINS]
KINEMATICS = trivkins coordinates=XYZC
JOINTS = 4
"""

TRAVERSE, LINE, ARC = 0, 1, 2
#: Largest distance of sampled arcs from their chords (mm).
BOW = 0.0002
#: rs274 prints numbers with 4 decimals.
UNIT = 1e-4

_KNIFE_THROUGH = (LineType.CUT, LineType.PERFORATION, LineType.COMBI)
_WORK = {
    "knife": (*_KNIFE_THROUGH, LineType.HALF_CUT),
    "wheel": (LineType.CREASE,),
    "v-cutter": (LineType.V_GROOVE,),
}


#: Directions of the spindle by the names of the canonical commands.
_DIRECTIONS = {
    "START_SPINDLE_CLOCKWISE": 1,
    "START_SPINDLE_COUNTERCLOCKWISE": -1,
    "STOP_SPINDLE_TURNING": 0,
}


@dataclass(frozen=True)
class TipTool:
    """The dimensions of a tool, stated by the test (mm and degrees)."""

    kind: str  #: "knife", "wheel" or "v-cutter"
    caliper: float  #: caliper of the board; a tip below this height is in the board
    datum: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    output: int = -1  #: number of the output of its piston, -1 for none
    oscillating: bool = False
    back: float = 0.0
    half_width: float = 0.0
    tilt: float = 0.0
    trail: float = 0.0
    overrun: float = 0.0  #: permitted distance of the tip past the end of an edge
    reach: float = 0.0  #: distance along an edge within which a tip makes the edge
    letters: str = "XYZC"  #: letters of the axes that move the tool, as rs274 has them


@dataclass(frozen=True)
class Moves:
    """Columns of n moves, as LinuxCNC interprets them."""

    kind: NDArray[np.int64]  #: (n,) TRAVERSE, LINE or ARC
    start: F64  #: (n, 4) X Y Z C
    end: F64  #: (n, 4)
    centre: F64  #: (n, 2), NaN for moves that are no arcs
    turns: NDArray[np.int64]  #: (n,) > 0 counter-clockwise
    station: NDArray[np.int64]  #: (n,) number of the selected tool
    offset: F64  #: (n, 3) active tool offset, X Y Z
    outputs: NDArray[np.int64]  #: (n,) one bit per digital output
    spindle: F64  #: (n,) speed of the spindle, negative for counter-clockwise, 0 for off
    feed: F64  #: (n,) mm or degrees per minute, as printed by rs274
    joints: F64  #: (n, 6) X Y Z A B C after each move, with the active tool offset

    @property
    def oscillates(self) -> NDArray[np.bool_]:
        """Whether the spindle is on, (n,)."""
        on: NDArray[np.bool_] = self.spindle != 0.0
        return on

    def __len__(self) -> int:
        return len(self.kind)


@dataclass(frozen=True)
class Reading:
    """The result of interpreting a program with rs274."""

    accepted: bool
    stderr: str
    moves: Moves


@dataclass
class Report:
    """The measurements of the second verifier (mm and degrees)."""

    accepted: bool
    stderr: str
    worst_deviation: float = np.inf  #: distance of the tip from the edges, except past their ends
    worst_gap: float = np.inf  #: distance of an edge from the tip's path, less the tool's reach
    worst_overrun: float = np.inf  #: distance of the tip past the end of an edge
    worst_heading: float = np.inf  #: angle between C and the tip's direction, less rounding
    worked: float = 0.0  #: length of the tip's path at working depth
    problems: list[str] = field(default_factory=list)


def read_program(program: bytes, tools: Mapping[int, TipTool] | None = None) -> Reading:
    """Return the result of rs274 for a program, with the datums of ``tools`` in its tool table."""
    assert RS274 is not None, ABSENT
    stations = tools or {}
    table = "".join(
        f"T{number} P{number}"
        + "".join(f" {word}{value}" for word, value in zip(tool.letters, tool.datum, strict=True))
        + "\n"
        for number, tool in stations.items()
    )
    program = re.sub(rb"[Vv](?=[ \t]*[-+.\d])", b"B", program)
    with tempfile.TemporaryDirectory() as folder:
        directory = Path(folder)
        (directory / "program.ngc").write_bytes(program)
        (directory / "rs274.ini").write_text(INI)
        (directory / "tool.tbl").write_text(table)
        (directory / "fresh.var").write_text("")
        completed = subprocess.run(
            [RS274, "-g", "-v", "fresh.var", "-t", "tool.tbl", "-i", "rs274.ini", "program.ngc"],
            cwd=directory,
            # rs274 writes a file in HOME, which must not be shared by two processes.
            env=os.environ | {"HOME": folder},
            capture_output=True,
            # It repeats comments byte by byte, in whatever encoding.
            encoding="ascii",
            errors="replace",
            timeout=120,
            check=False,
        )
    ended = "PROGRAM_END" in completed.stdout
    return Reading(
        completed.returncode == 0 and ended, completed.stderr, _moves(completed.stdout, stations)
    )


def _moves(canon: str, tools: Mapping[int, TipTool]) -> Moves:
    rows = []
    position = np.zeros(6)
    selected, station, offset, outputs, feed = 0, 0, np.zeros(6), 0, 0.0
    speed, direction = 0.0, 0
    for word, inside in re.findall(r"^\s*\d+ \S+\s+([A-Z_0-9]+)\((.*)\)$", canon, re.M):
        if word in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"):
            values = [float(value) for value in inside.split(",")]
            end, centre, turns = position.copy(), np.full(2, np.nan), 0
            if word == "ARC_FEED":
                end[:] = *values[:2], *values[5:9]
                centre, turns = np.array(values[2:4]), int(values[4])
            else:
                end[:] = values
            kind = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED").index(word)
            letters = tools[station].letters if station in tools else "XYZC"
            own = ["XYZABC".index(letter) for letter in letters]
            rows.append(
                (
                    kind,
                    position[own],
                    end[own],
                    centre,
                    turns,
                    station,
                    offset[own[:3]],
                    outputs,
                    speed * direction,
                    feed,
                    end + offset,
                )
            )
            position = end
        elif word == "USE_LENGTH_UNITS":
            assert inside == "CANON_UNITS_MM", "the program is not in mm"
        elif word == "SELECT_TOOL":
            selected = int(inside)
        elif word == "CHANGE_TOOL":
            # The argument is the index in the tool table, not the tool number.
            station = selected
        elif word == "USE_TOOL_LENGTH_OFFSET":
            linear, rotary = (np.array(part.split(), float) for part in inside.split(",")[:2])
            # The same joints have the new positions of the program.
            changed = np.concatenate([linear / 25.4, rotary])
            position = position + offset - changed
            offset = changed
        elif word == "SET_AUX_OUTPUT_BIT":
            outputs |= 1 << int(inside)
        elif word == "CLEAR_AUX_OUTPUT_BIT":
            outputs &= ~(1 << int(inside))
        elif word in _DIRECTIONS:
            direction = _DIRECTIONS[word]
        elif word == "SET_SPINDLE_SPEED":
            speed = float(inside.split(",")[1])
        elif word == "SET_FEED_RATE":
            feed = float(inside)
    columns = list(zip(*rows, strict=True)) or [[]] * 11
    n = len(rows)
    return Moves(
        kind=np.array(columns[0], np.int64),
        start=np.array(columns[1], float).reshape(n, 4),
        end=np.array(columns[2], float).reshape(n, 4),
        centre=np.array(columns[3], float).reshape(n, 2),
        turns=np.array(columns[4], np.int64),
        station=np.array(columns[5], np.int64),
        offset=np.array(columns[6], float).reshape(n, 3),
        outputs=np.array(columns[7], np.int64),
        spindle=np.array(columns[8], float),
        feed=np.array(columns[9], float),
        joints=np.array(columns[10], float).reshape(n, 6),
    )


@dataclass(frozen=True)
class TipPath:
    """The path of one station's tip in the board as m short pieces from ``start`` to ``end``."""

    start: F64  #: (m, 3) x y z of the tip; for a V-cutter projected along its blade to the depth
    end: F64  #: (m, 3)
    heading: F64  #: (m,) C in the middle of the piece
    move: NDArray[np.int64]  #: (m,) row in Moves
    bottom: NDArray[np.bool_]  #: (m,) whether the piece is at the depth of its engagement
    depth: F64  #: (m,) lowest z of its engagement


def tip_path(moves: Moves, station: int, tool: TipTool) -> TipPath:
    """Return the path of a station's tip while it is in the board, in program coordinates."""
    mine = (moves.station == station) & (moves.kind != TRAVERSE)
    low = np.minimum(moves.start[:, 2], moves.end[:, 2])
    inside = mine & (low < tool.caliper - UNIT / 2)
    # Moves between two moves outside the board are one engagement.
    engagement = np.cumsum(~inside)
    floor = np.full(engagement.max(initial=0) + 1, np.inf)
    np.minimum.at(floor, engagement[inside], low[inside])
    rows = np.flatnonzero(inside)
    depth = floor[engagement[rows]]

    start, end, centre = moves.start[rows], moves.end[rows], moves.centre[rows]
    curved = moves.kind[rows] == ARC
    first, last = start[:, :2] - centre, end[:, :2] - centre
    sweep = np.zeros(len(rows))
    turn = np.arctan2(*last.T[::-1]) - np.arctan2(*first.T[::-1])
    left = moves.turns[rows] > 0
    sweep[curved & left] = turn[curved & left] % (2 * np.pi)
    sweep[curved & ~left] = -(-turn[curved & ~left] % (2 * np.pi))
    radius = np.where(curved, np.hypot(*first.T), 0.0)
    length = np.where(curved, radius * np.abs(sweep), np.hypot(*(end - start)[:, :2].T))
    pieces = np.ceil(
        np.max(
            [
                np.ones(len(rows)),
                length / 5.0,
                np.abs(end[:, 3] - start[:, 3]) / 1.0,
                np.abs(sweep) * np.sqrt(radius / (8 * BOW)),
            ],
            axis=0,
        )
    ).astype(int)
    which = np.repeat(np.arange(len(rows)), pieces)
    ordinal = np.arange(len(which)) - np.repeat(np.cumsum(pieces) - pieces, pieces)

    def head(fraction: F64) -> F64:
        pose = start[which] + (end - start)[which] * fraction[:, None]
        angle = sweep[which] * fraction
        scale = 1 + (np.hypot(*last[which].T) / np.hypot(*first[which].T) - 1) * fraction
        turned = np.stack(
            [
                first[which, 0] * np.cos(angle) - first[which, 1] * np.sin(angle),
                first[which, 0] * np.sin(angle) + first[which, 1] * np.cos(angle),
            ],
            axis=1,
        )
        pose[:, :2] = np.where(
            curved[which, None], centre[which] + turned * scale[:, None], pose[:, :2]
        )
        return pose

    def tip(pose: F64) -> F64:
        c = np.radians(pose[:, 3])
        ahead = np.stack([np.cos(c), np.sin(c)], axis=1)
        right = np.stack([np.sin(c), -np.cos(c)], axis=1)
        position = pose[:, :3].copy()
        position[:, :2] -= tool.trail * ahead + tool.half_width * ahead + tool.back * right
        # The blade leans to the right of travel: project the tip along it to the depth.
        above = position[:, 2] - depth[which]
        position[:, :2] -= (above * np.tan(np.radians(tool.tilt)))[:, None] * right
        return position

    poses = head(ordinal / pieces[which]), head((ordinal + 1) / pieces[which])
    bottom = (np.abs(start[:, 2] - depth) < UNIT) & (np.abs(end[:, 2] - depth) < UNIT)
    return TipPath(
        start=tip(poses[0]),
        end=tip(poses[1]),
        heading=(poses[0][:, 3] + poses[1][:, 3]) / 2,
        move=rows[which],
        bottom=bottom[which],
        depth=depth[which],
    )


def verify_by_interpreter(
    program: bytes,
    ends: ArrayLike,
    bulge: ArrayLike,
    line_types: Sequence[int] | NDArray[np.uint8],
    placement: tuple[float, float],
    tools: Mapping[int, TipTool],
) -> Report:
    """Measure how far the tips of a program are from a dieline, with LinuxCNC's interpretation.

    Parameters
    ----------
    ends : (n, 2, 2), mm
        Start and end points of the dieline's edges in drawing coordinates.
    bulge : (n,)
    line_types : (n,) LineType
    placement : mm
        Sheet coordinates minus drawing coordinates.
    tools
        The tool of each station, by its number.
    """
    edges = np.asarray(ends, float).reshape(-1, 2, 2) + np.asarray(placement)
    bulges = np.asarray(bulge, float)
    types = np.asarray(line_types)
    reading = read_program(program, tools)
    report = Report(reading.accepted, reading.stderr)
    if not reading.accepted:
        return report
    report.worst_deviation = report.worst_gap = 0.0
    report.worst_overrun = report.worst_heading = 0.0
    moves = reading.moves
    report.problems += _motion_errors(moves, tools)
    worked: dict[LineType, list[F64]] = {kind: [] for kind in LineType}
    reach = dict.fromkeys(LineType, 0.0)
    for number, tool in tools.items():
        path = tip_path(moves, number, tool)
        for through in (True, False):
            here = (path.depth <= UNIT) == through
            if not here.any():
                continue
            kinds = _WORK[tool.kind]
            if tool.kind == "knife" and through:
                kinds = _KNIFE_THROUGH
            near = np.isin(types, kinds)
            points = np.concatenate([path.start[here, :2], path.end[here, :2]])
            off, over = _greatest_distances(points, edges[near], bulges[near], tool.overrun)
            report.worst_deviation = max(report.worst_deviation, off)
            report.worst_overrun = max(report.worst_overrun, over)
            # Moves above the bottom of the board do not cut through it.
            completed = [kind for kind in kinds if through or kind not in _KNIFE_THROUGH[:2]]
            bottom = here & path.bottom
            pieces = np.stack([path.start[bottom, :2], path.end[bottom, :2]], axis=1)
            for kind in completed:
                worked[kind].append(pieces)
                reach[kind] = tool.reach
            report.worked += float(np.hypot(*(pieces[:, 1] - pieces[:, 0]).T).sum())
        report.worst_heading = max(report.worst_heading, _heading(path, tool, moves))
    for kind, found in worked.items():
        mine = types == kind
        if kind in (LineType.IGNORED, LineType.UNCLASSIFIED) or not mine.any():
            continue
        pieces = np.concatenate(found) if found else np.zeros((0, 2, 2))
        report.worst_gap = max(
            report.worst_gap, _greatest_gap(edges[mine], bulges[mine], pieces, reach[kind])
        )
    return report


def _motion_errors(moves: Moves, tools: Mapping[int, TipTool]) -> list[str]:
    """Return texts about errors that need no drawing: rapids in the board, wrong outputs and
    offsets.
    """
    errors = []
    for number in np.unique(moves.station):
        mine = moves.station == number
        low = np.minimum(moves.start[:, 2], moves.end[:, 2])
        if number not in tools:
            if number != 0 or (moves.kind[mine] != TRAVERSE).any():
                errors.append(f"station {number} works, and is none of {list(tools)}")
            continue
        tool = tools[int(number)]
        inside = mine & (low < tool.caliper - UNIT / 2)
        if (inside & (moves.kind == TRAVERSE)).any():
            errors.append(f"station {number} makes a rapid in the board")
        if (np.abs(moves.offset - tool.datum[:3]) > 1e-4)[inside].any():
            errors.append(f"station {number} works without its datum")
        piston = 0 if tool.output < 0 else 1 << tool.output
        if (moves.outputs[inside] != piston).any():
            errors.append(f"station {number} works with other pistons than its own down")
        if (moves.oscillates[inside] != tool.oscillating).any():
            errors.append(f"station {number} works with the oscillation wrong")
    return errors


def _polylines(edges: F64, bulge: F64) -> tuple[F64, NDArray[np.int64]]:
    """Sample edges at distances of at most 0.5 mm.

    Returns
    -------
    points : (m, 2)
    edge : (m,)
        The row of the edge on which each point lies.
    """
    sweep = 4 * np.arctan(bulge)
    chord = edges[:, 1] - edges[:, 0]
    length = np.hypot(*chord.T) / np.sinc(sweep / (2 * np.pi))
    count = np.ceil(length / 0.5).astype(int).clip(2) + 1
    which = np.repeat(np.arange(len(edges)), count)
    fraction = (np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)) / (
        count[which] - 1
    )
    # Chord from the start of an arc to a point on it, by half of the angle between them.
    half = sweep[which] / 2
    scale = fraction * np.sinc(fraction * half / np.pi) / np.sinc(half / np.pi)
    angle = (fraction - 1) * half
    x, y = chord[which].T
    across = np.stack(
        [x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)], axis=1
    )
    return edges[which, 0] + across * scale[:, None], which


def _greatest_gap(edges: F64, bulge: F64, pieces: F64, reach: float) -> float:
    """Return the greatest distance of a point of the edges from the worked pieces, less ``reach``
    (mm).

    ``pieces`` is (k, 2, 2): start and end points of the tip's path; ``inf`` if there are none.
    """
    if len(pieces) == 0:
        return np.inf
    points, _ = _polylines(edges, bulge)
    tree = shapely.STRtree(shapely.linestrings(pieces))
    _, distance = tree.query_nearest(
        shapely.points(points), return_distance=True, all_matches=False
    )
    return max(0.0, float(distance.max()) - reach)


def _greatest_distances(points: F64, edges: F64, bulge: F64, overrun: float) -> tuple[float, float]:
    """Return how far points are at most beside the edges, and past the ends of edges (mm).

    Points up to ``overrun`` past an end are compared with the extension of the edge.
    """
    if len(edges) == 0:
        return np.inf, np.inf
    places, which = _polylines(edges, bulge)
    joined = which[1:] == which[:-1]
    lines = np.stack([places[:-1][joined], places[1:][joined]], axis=1)
    tree = shapely.STRtree(shapely.linestrings(lines))
    dots = shapely.points(points)
    point, piece = tree.query(dots, predicate="dwithin", distance=overrun + 0.05)
    edge = which[:-1][joined][piece]
    aside, past = distances_beside_and_past(points[point], edges[edge], bulge[edge])
    allowed = past <= overrun + UNIT
    off = np.full(len(points), np.inf)
    np.minimum.at(off, point[allowed], aside[allowed])
    unmatched = np.flatnonzero(~np.isfinite(off))
    if len(unmatched):
        _, distance = tree.query_nearest(dots[unmatched], return_distance=True, all_matches=False)
        off[unmatched] = distance
    over = np.full(len(points), np.inf)
    best = allowed & (aside <= off[point] + UNIT)
    np.minimum.at(over, point[best], past[best])
    over[~np.isfinite(over)] = 0.0
    return float(off.max()), float(over.max())


def distances_beside_and_past(points: F64, edges: F64, bulge: F64) -> tuple[F64, F64]:
    """Return how far each point is from the edge in the same row (mm).

    Returns
    -------
    beside, past : (n,)
        Distance perpendicular to the line or arc, and distance beyond its nearer end (at least 0).
    """
    start, end = edges[:, 0], edges[:, 1]
    chord = end - start
    sweep = 4 * np.arctan(bulge)
    curved = bulge != 0

    def turned(angle: F64) -> F64:
        x, y = (chord / np.hypot(*chord.T)[:, None]).T
        cos, sin = np.cos(angle), np.sin(angle)
        return np.stack([x * cos - y * sin, x * sin + y * cos], axis=1)

    past = np.full(len(points), -np.inf)
    beside = np.zeros(len(points))
    for corner, direction in ((start, -turned(-sweep / 2)), (end, turned(sweep / 2))):
        away = points - corner
        along = (away * direction).sum(axis=1)
        farther = along > past
        past = np.where(farther, along, past)
        across = np.abs(away[:, 0] * direction[:, 1] - away[:, 1] * direction[:, 0])
        beside = np.where(farther, across, beside)
    if curved.any():
        b = bulge[curved]
        normal = np.stack([-chord[curved, 1], chord[curved, 0]], axis=1)
        centre = (start + end)[curved] / 2 + normal * ((1 - b * b) / (4 * b))[:, None]
        radius = np.hypot(*(start[curved] - centre).T)
        arm = points[curved] - centre
        origin = start[curved] - centre
        turn = np.arctan2(
            origin[:, 0] * arm[:, 1] - origin[:, 1] * arm[:, 0], (origin * arm).sum(axis=1)
        )
        on = (np.sign(b) * turn) % (2 * np.pi) <= np.abs(sweep[curved])
        rows = np.flatnonzero(curved)[on]
        past[rows] = 0.0
        beside[rows] = np.abs(np.hypot(*arm.T) - radius)[on]
        # Beside the arc but not past an end: the distance to the nearer end.
        rest = np.flatnonzero(curved)[~on]
        inward = rest[past[rest] <= 0]
        nearest = np.minimum(
            np.hypot(*(points - start)[inward].T), np.hypot(*(points - end)[inward].T)
        )
        beside[inward] = nearest
    return beside, np.maximum(past, 0.0)


def _heading(path: TipPath, tool: TipTool, moves: Moves) -> float:
    """Return the greatest angle between C and the tip's direction at depth (degrees).

    Angles that can be caused by rounding to 4 decimals are subtracted.
    """
    travel = (path.end - path.start)[:, :2]
    whole = moves.end[path.move] - moves.start[path.move]
    size = np.hypot(*whole[:, :2].T)
    moving = path.bottom & (np.hypot(*travel.T) > 10 * UNIT) & (size > 0)
    if not moving.any():
        return 0.0
    period = 180.0 if tool.kind == "wheel" else 360.0
    azimuth = np.degrees(np.arctan2(travel[moving, 1], travel[moving, 0]))
    turn = (path.heading[moving] - azimuth + period / 2) % period - period / 2
    explained = np.degrees(2 * UNIT / size[moving])
    return float(np.maximum(np.abs(turn) - explained, 0.0).max())
