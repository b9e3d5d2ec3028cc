"""hpgl: write HPGL programs for plotters and flat cutters.

A program consists of these instructions, one on each line::

    IN;  PA;               initialise; absolute coordinates
    PU;  SP1; FS30; VS40;  raise the tool; select a tool, its force and its speed
    PU800,800;             move with the tool up (plotter units)
    PD;  PD1200,800;       lower the tool; move with the tool down
    PU;  SP0;              end: raise the tool, select none

HPGL has neither depths nor headings.  Each kind of operation of a station is a pen with its own
force, and the device turns the tool along the path.  Arcs become chords.  Every point is rounded to
whole plotter units independently, so that rounding errors do not accumulate.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth
from knifetip.geometry.chords import chord_counts, split_moves
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import ANGLE
from knifetip.languages.hpgl.plotter import CM_PER_SECOND, Device, Pen, PenWork, Plotter
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.tool import Engine, Knife, kind_of
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.check import describe_row, edges_of_rows
from knifetip.post.digits import Characters, digit_columns
from knifetip.post.trailing_points import round_points

#: Fraction of the tolerance by which chords may deviate from their arc.
CHORD_FRACTION: Final = 0.5
#: Largest difference of heights that count as equal (mm).
HEIGHT_TOLERANCE: Final = 1e-6
#: Greatest length of a comment (characters).
MAX_COMMENT: Final = 66
#: Number of lines that are formatted together; it bounds the memory.
BATCH: Final = 1 << 15

#: Kinds of instructions: none, move with the tool up, move with the tool down, lower the tool, lift
#: it.
_NONE, _TRAVEL, _WORK, _DOWN, _UP = range(5)
_MNEMONICS: Final = np.frombuffer(b"\0\0PUPDPDPU", np.uint8).reshape(5, 2)


@dataclass(frozen=True, eq=False, slots=True)
class _PlotterMoves:
    """n straight moves of a plotter between n + 1 points, with the pen, the speed and the kind of
    instruction of each move.
    """

    point: I64  #: (n + 1, 2) plotter units
    kind: U8  #: (n,) kind of instruction of each move
    speed: I64  #: (n,) speed of moves with the tool down (cm/s), 0 for other moves
    pen: I64  #: (n,) index into the plotter's pens
    row: I32  #: (n,) row of each move in the Toolpath


def emit(
    toolpath: Toolpath, machine: Machine, *, tolerance: float, notes: Sequence[str]
) -> Program:
    """Return the HPGL program of a toolpath.

    Parameters
    ----------
    tolerance : float, mm
        Greatest deviation of the tip from the path.  Chords may deviate from their arcs by half of
        it; the rounding of points to plotter units comes in addition.
    notes
        Comments at the top, for devices that support the CO instruction.

    Raises
    ------
    ProgramError
        A move needs a depth, a heading or a speed that HPGL cannot express, or the machine has no
        pen for a kind of operation.
    """
    plotter = machine.controller
    if not isinstance(plotter, Plotter):
        raise ProgramError("hpgl.no-device", machine=machine.title)
    _check_motions(toolpath)
    moves = _plotter_moves(toolpath, machine, plotter, tolerance)
    texts, sources = [], []

    def append_lines(lines: Sequence[str]) -> None:
        texts.append("".join(f"{line}\n" for line in lines).encode("ascii"))
        sources.append(np.full(len(lines), -1, np.int32))

    comments = [_format_comment(note) for note in notes] if plotter.device.comments else []
    append_lines(["IN;", *comments, "PA;"])
    changes = np.flatnonzero(np.diff(moves.pen)) + 1
    for rows in np.split(np.arange(len(moves.pen)), changes):
        append_lines(_select_pen(plotter.pens[moves.pen[rows[0]]], moves.speed[rows], plotter))
        with_speed = _speed_changes(moves.speed[rows])
        # After a tool change the first position is written even if the head is there already.
        moves.kind[rows[0]] = _TRAVEL
        for at in range(0, len(rows), BATCH):
            batch = slice(at, at + BATCH)
            text, source = _format_moves(moves, rows[batch], with_speed[batch])
            texts.append(text)
            sources.append(source)
    append_lines(["PU;", "SP0;"])
    return Program(b"".join(texts), machine.dialect, np.concatenate(sources))


def _format_comment(note: str) -> str:
    """Return a CO (comment) instruction that contains a note.

    Characters that would end the instruction are replaced by spaces.
    """
    clean = " ".join(re.sub(r"[^ -~]|[\";]", " ", note).split())[:MAX_COMMENT].rstrip()
    return f'CO"{clean}";'


def _select_pen(pen: Pen, speed: I64, plotter: Plotter) -> list[str]:
    """Return the program lines that select a pen, its force, and the speed of its first moves.

    ``speed`` is the speed of each of the n moves that the pen makes, (n,) cm/s; it is 0 for moves
    with the tool up.
    """
    force = [f"FS{pen.force};"] if plotter.device.force else []
    working = speed[speed > 0]
    first = [f"VS{working[0]};"] if len(working) else []
    return ["PU;", f"SP{pen.number};", *force, *first]


def _speed_changes(speed: I64) -> Bool:
    """Return the mask of moves before which the speed must be set, (n,).

    These are moves with the tool down whose speed differs from the speed of the previous move with
    the tool down.  ``speed`` is the speed of each of n moves, (n,) cm/s, 0 with the tool up.
    """
    working = np.flatnonzero(speed)
    result = np.zeros(len(speed), np.bool_)
    result[working[1:]] = np.diff(speed[working]) != 0
    return result


def _check_motions(toolpath: Toolpath) -> None:
    """Raise ``ProgramError`` for the first row of a toolpath that HPGL cannot express.

    HPGL cannot express a station that does not begin with a rapid, a slanted plunge or lift, a
    change of depth within a cut, a swivel that also travels, or a lift directly after a plunge.
    """
    motion, change = toolpath.motion, np.diff(toolpath.pose, axis=0)
    beside = np.hypot(change[:, 0], change[:, 1]) > HEIGHT_TOLERANCE
    upright = np.isin(motion, (Motion.PLUNGE, Motion.LIFT))
    works = ~upright & (motion != Motion.RAPID)
    begins = np.ones(len(motion), np.bool_)
    begins[1:] = toolpath.tool[1:] != toolpath.tool[:-1]
    lone = np.zeros(len(motion), np.bool_)
    lone[:-1] = (motion[:-1] == Motion.PLUNGE) & (motion[1:] == Motion.LIFT)
    refused = (
        (
            begins & (motion != Motion.RAPID),
            "hpgl.no-approach",
        ),
        (upright & beside, "hpgl.slanted-plunge"),
        (works & (np.abs(change[:, 2]) > HEIGHT_TOLERANCE), "hpgl.depth-change"),
        (
            (motion == Motion.SWIVEL) & beside,
            "hpgl.swivel",
        ),
        (
            lone,
            "hpgl.press",
        ),
    )
    for is_refused, code in refused:
        if is_refused.any():
            raise ProgramError(
                code,
                place=describe_row(toolpath, int(np.argmax(is_refused))),
                at_edges=edges_of_rows(toolpath, is_refused),
            )


def _plotter_moves(
    toolpath: Toolpath, machine: Machine, plotter: Plotter, tolerance: float
) -> _PlotterMoves:
    """Return the moves of a toolpath in plotter units, with arcs replaced by chords.

    The chords deviate from their arcs by at most half of ``tolerance`` (mm).
    """
    device = plotter.device
    pieces = _chord_counts(toolpath, machine, device, tolerance)
    point, kind, row = _plotter_points(toolpath, machine, device, pieces)
    works = kind == _WORK
    speed = np.zeros(len(row), np.int64)
    if device.speed:
        wanted_speed = toolpath.feed[row] / CM_PER_SECOND
        speed[works] = np.rint(wanted_speed[works]).astype(np.int64)
        is_wrong = works & (np.abs(wanted_speed - speed) > 1e-6)
        is_wrong |= works & ((speed < device.speed[0]) | (speed > device.speed[1]))
        if is_wrong.any():
            at = int(row[np.argmax(is_wrong)])
            raise ProgramError(
                "hpgl.bad-feed",
                place=describe_row(toolpath, at),
                feed=toolpath.feed[at],
                device=device.title,
                slowest=round(device.speed[0] * CM_PER_SECOND),
                fastest=round(device.speed[1] * CM_PER_SECOND),
                step=CM_PER_SECOND,
                at_edges=edges_of_rows(toolpath, row[is_wrong]),
            )
    pen = _pens_of_rows(toolpath, machine, plotter)[row]
    return _PlotterMoves(point, kind, speed, pen, row.astype(np.int32))


def _plotter_points(
    toolpath: Toolpath, machine: Machine, device: Device, pieces: I64
) -> tuple[I64, U8, I64]:
    """Return the points of a toolpath in plotter units, with arcs replaced by chords.

    ``pieces`` is the number of chords of each of n moves, (n,).

    Returns ``point`` (m + 1, 2) plotter units: points before the first of m straight moves and
    after each move; ``kind, row`` (m,): kind of instruction of each move, and row of each move in
    the toolpath.
    """
    pose, row = split_moves(toolpath.pose[:, [0, 1, 3]], toolpath.bulge, pieces)
    motion = toolpath.motion[row]
    planned = (pose[:, :2] - device.zero) * device.units
    heading = _axis_headings(pose[:, 2], machine)
    point = round_points(planned, heading, motion, toolpath.tool[row], machine, float(device.units))
    moved: Bool = (point[1:] != point[:-1]).any(axis=1)
    kind = (np.where(motion == Motion.RAPID, _TRAVEL, _WORK) * moved).astype(np.uint8)
    kind[motion == Motion.PLUNGE] = _DOWN
    kind[motion == Motion.LIFT] = _UP
    # A pass shorter than a plotter unit may round to a point; the tool is not lowered for it.
    shown = np.flatnonzero(kind != _NONE)
    still = np.flatnonzero((kind[shown[:-1]] == _DOWN) & (kind[shown[1:]] == _UP))
    kind[shown[still]] = kind[shown[still + 1]] = _NONE
    return point, kind, row


def _axis_headings(heading: F64, machine: Machine) -> F64:
    """Return headings on the sheet as directions in coordinates of the axes, (n,) degrees.

    Points are chosen so that the path of the axes turns a free blade to its heading.
    """
    if machine.is_square:
        return heading
    angle = np.radians(heading)
    x, y = machine.to_axes(np.cos(angle), np.sin(angle))
    result: F64 = np.degrees(np.arctan2(y, x))
    return result


def _chord_counts(toolpath: Toolpath, machine: Machine, device: Device, tolerance: float) -> I64:
    """Return the number of chords for each of n moves, (n,); it is 1 for a straight move.

    The chords deviate from their arcs by at most half of ``tolerance`` (mm).  Where two chords
    meet, the device turns the tool in the board; a free blade turns by itself.  The chords of an
    arc are halved until the tool turns by no more than its swivel angle and the error of the
    directions, which the rounding of points to plotter units causes.
    """
    start, end = toolpath.pose[:-1, :2], toolpath.pose[1:, :2]
    pieces = chord_counts(start, end, toolpath.bulge, CHORD_FRACTION * tolerance)
    is_arc = toolpath.bulge != 0.0
    most = arc.length(start, end, toolpath.bulge) * device.units
    swivel = np.full(256, ANGLE)
    for station in machine.stations:
        if isinstance(station.tool, Knife):
            swivel[station.number] = station.tool.lift_angle
    while True:
        point, kind, row = _plotter_points(toolpath, machine, device, pieces)
        # Where only the depth changes, the tool stays down and turns as at any other joint.
        shown = np.flatnonzero((kind != _NONE) & (kind != _DOWN))
        row, step = row[shown], np.diff(point, axis=0)[shown]
        unsure = np.degrees(math.sqrt(2.0) / np.maximum(np.hypot(*step.T), 1.0))
        turn = np.abs((np.diff(azimuth(step.astype(np.float64))) + 180.0) % 360.0 - 180.0)
        limit = swivel[toolpath.tool[row[1:]]] + unsure[1:] + unsure[:-1]
        works = kind[shown] == _WORK
        sharp = works[1:] & works[:-1] & (turn > limit)
        halved = np.zeros(len(pieces), np.bool_)
        halved[row[1:][sharp]] = halved[row[:-1][sharp]] = True
        halved &= is_arc & (pieces < most)
        if not halved.any():
            return pieces
        pieces[halved] *= 2


def _pens_of_rows(toolpath: Toolpath, machine: Machine, plotter: Plotter) -> I64:
    """Return the pen of every row of a toolpath, (n,) indices into the pens of the plotter.

    The rows of a pass in the board have the pen for the kind of operation of the pass.  The rapids
    before a pass have the same pen, so that the tool is changed before the head travels there.
    """
    rapid = toolpath.motion == Motion.RAPID
    new = np.concatenate([[False], rapid[1:] & ~rapid[:-1]])
    new |= np.concatenate([[False], toolpath.tool[1:] != toolpath.tool[:-1]])
    pass_number = np.cumsum(new)
    plunge = np.flatnonzero(toolpath.motion == Motion.PLUNGE)
    if len(plunge) == 0:
        raise ProgramError("hpgl.never-down")
    is_through = np.abs(toolpath.pose[plunge + 1, 2] + machine.into_mat) <= HEIGHT_TOLERANCE
    key = toolpath.tool[plunge].astype(np.int64) * 2 + is_through
    distinct_keys, key_index = np.unique(key, return_inverse=True)
    pens = np.array([_find_pen(int(one), machine, plotter) for one in distinct_keys])[key_index]
    # Rapids at the end of a station have no pass after them: they keep the last pen.
    at = np.searchsorted(pass_number[plunge], np.arange(pass_number[-1] + 1), side="right") - 1
    first = np.searchsorted(pass_number[plunge], np.arange(pass_number[-1] + 1))
    own = np.where(first <= at, first, np.maximum(at, 0))
    result: I64 = pens[own][pass_number]
    return result


def _find_pen(key: int, machine: Machine, plotter: Plotter) -> int:
    """Return the index of the pen for a station and a kind of operation.

    ``key`` is twice the number of the station, plus 1 for through cuts.

    Raises ``ProgramError``: the plotter has no such pen.
    """
    station = machine.station(key // 2)
    work = PenWork.CUT if key % 2 else PenWork.HALF_CUT
    if kind_of(station.tool).engine is Engine.CREASE:
        work = PenWork.CREASE
    for index, pen in enumerate(plotter.pens):
        if pen.station == station.number and pen.work is work:
            return index
    raise ProgramError("hpgl.no-pen", machine=machine.title, work=work, station=station.number)


def _format_moves(moves: _PlotterMoves, rows: I64, with_speed: Bool) -> tuple[bytes, I32]:
    """Return the program lines of selected moves, and the toolpath row of each program line.

    Program lines that set the speed have row -1.

    ``rows``: indices of the selected moves in ``moves``.
    ``with_speed``: mask of the selected moves: True if a separate program line must set the speed
    before the move.
    """
    shown = moves.kind[rows] != _NONE
    rows, with_speed = rows[shown], with_speed[shown]
    kind, speed = moves.kind[rows], moves.speed[rows]
    located = (kind == _TRAVEL) | (kind == _WORK)
    point = moves.point[rows + 1] * located[:, None]
    blocks = [
        _text_columns(b"VS", with_speed),
        digit_columns(speed * with_speed, 0, brief=True) * with_speed[:, None],
        _text_columns(b";\n", with_speed),
        _MNEMONICS[kind],
        digit_columns(point[:, 0], 0, brief=True) * located[:, None],
        _text_columns(b",", located),
        digit_columns(point[:, 1], 0, brief=True) * located[:, None],
        _text_columns(b";\n", np.ones(len(rows), np.bool_)),
    ]
    characters = np.hstack(blocks)
    text: bytes = characters[characters != 0].tobytes()
    return text, np.insert(moves.row[rows], np.flatnonzero(with_speed), np.int32(-1))


def _text_columns(text: bytes, has_text: Bool) -> Characters:
    """Return a matrix of characters, (n, k) bytes, that contains a text in selected rows.

    The selected rows, in the mask ``has_text``, (n,), contain the k bytes of ``text``.  All other
    rows contain zero bytes.
    """
    result: Characters = np.frombuffer(text, np.uint8) * has_text[:, None]
    return result
