"""figures: figures of stored drawings and tool paths.

The layers of a drawing are its line types, with names that the default profile reads back.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.geometry.similarity import Similarity
from knifetip.model.dieline import LineType
from knifetip.model.figure import Figure, FigureLayer
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.edges import EdgeTable
from knifetip.presentation.picture import COLOURS
from knifetip.verification.kinematics import tip_offset


class _Style(NamedTuple):
    """Appearance of a layer, see ``FigureLayer``."""

    name: str
    aci: int
    dashes: tuple[float, ...] = ()


_STYLES: Final = {
    LineType.CUT: _Style("CUT", 1),
    LineType.CREASE: _Style("CREASE", 5, (4.0, 1.5)),
    LineType.V_GROOVE: _Style("V-GROOVE", 3, (7.0, 1.2, 1.2, 1.2)),
    LineType.PERFORATION: _Style("PERFORATION", 30, (1.5, 1.0)),
    LineType.HALF_CUT: _Style("HALF-CUT", 6, (5.0, 1.0, 0.8, 1.0, 0.8, 1.0)),
    LineType.COMBI: _Style("COMBI", 40, (3.0, 1.0, 1.0, 1.0)),
    LineType.UNCLASSIFIED: _Style("UNCLASSIFIED", 8),
}
#: Greatest turn of the tool in one line or arc of its tip's path (degrees).
_TURN: Final = 5.0
#: Greatest turn of a tool that rests, whose tip makes one arc (degrees).
_MOST_TURN: Final = 330.0
_SAME: Final = 1e-6  # degrees


def drawing_figure(block: bytes, overrides: bytes = b"") -> Figure:
    """Return a stored drawing, with a layer for each of its line types; ignored edges are left out.

    Parameters
    ----------
    block
        The packed ``EdgeTable`` of the drawing.
    overrides
        Line types that a job has instead, see ``Interpretation.overrides``; they are left out if
        they belong to another number of edges.
    """
    table = EdgeTable.unpack(block)
    ends, bulge = table.columns["ends"], table.columns["bulge"]
    line_type = table.columns["line_type"]
    chosen = np.frombuffer(overrides, np.uint8)
    if len(chosen) == len(line_type):
        line_type = np.where(chosen == NO_OVERRIDE, line_type, chosen)
    layers = []
    for kind, style in _STYLES.items():
        rows = np.flatnonzero(line_type == kind)
        if len(rows):
            layers.append(_layer(style, COLOURS[kind], ends[rows], bulge[rows]))
    return Figure(tuple(layers), table.meta["unit"])


def path_figure(toolpath: bytes, drawing: bytes, machine: Machine) -> Figure:
    """Return a tool path on the table (mm), with the drawing at its place.

    The layers are LINE (the drawing), TIP (path of the tip in the board), HEAD (path of the head's
    axis meanwhile) and LIFT (moves in the air).  Where a tool turns on a line, the path of its tip
    consists of chords of at most 5°.

    Parameters
    ----------
    toolpath
        The packed tool path, see ``presentation.toolpath``.
    drawing
        The packed ``EdgeTable`` of the drawing.
    machine
        The machine with its tools.
    """
    columns, meta = unpack_columns(toolpath)
    pose, bulge, motion = columns["pose"], columns["bulge"], columns["motion"]
    ends = np.stack([pose[:-1, :2], pose[1:, :2]], axis=1)
    moves = np.any(ends[:, 0] != ends[:, 1], axis=1)
    air = np.isin(motion, (Motion.RAPID, Motion.LIFT, Motion.PLUNGE))
    tip_ends, tip_bulge = _tip_path(pose, bulge, columns["tool"], ~air, machine)
    drawn = drawing_figure(drawing)
    placement = np.array(meta["placement"])
    line_ends = np.concatenate([np.zeros((0, 2, 2)), *(one.ends for one in drawn.layers)])
    if (similarity := meta.get("similarity")) is not None:
        line_ends = Similarity(*similarity).apply(line_ends)
    line_bulge = np.concatenate([np.zeros(0), *(one.bulge for one in drawn.layers)])
    layers = (
        _layer(_Style("LINE", 8), "#8a919c", line_ends + placement, line_bulge),
        _layer(_Style("TIP", 1), "#d9534f", tip_ends, tip_bulge),
        _layer(_Style("HEAD", 5), "#3f8fd2", ends[~air & moves], bulge[~air & moves]),
        _layer(_Style("LIFT", 9, (2.0, 2.0)), "#b0b6bf", ends[air & moves], bulge[air & moves]),
    )
    return Figure(layers)


def _layer(style: _Style, colour: str, ends: F64, bulge: F64) -> FigureLayer:
    return FigureLayer(style.name, colour, style.aci, style.dashes, ends, bulge)


def _tip_path(
    pose: F64, bulge: F64, station: U8, chosen: Bool, machine: Machine
) -> tuple[F64, F64]:
    """Return ends and bulges of the path of the tip in the chosen moves, of ``chosen`` (n,).

    ``pose`` (n + 1, 4), ``bulge`` (n,) and ``station`` (n,) are columns of ``Toolpath``.
    """
    ends: list[F64] = [np.zeros((0, 2, 2))]
    bulges: list[F64] = [np.zeros(0)]
    for one in machine.stations:
        rows = np.flatnonzero(chosen & (station == one.number))
        start, end, bow = pose[rows], pose[rows + 1], bulge[rows]
        turn = end[:, 3] - start[:, 3]
        rests = np.all(start[:, :2] == end[:, :2], axis=1)
        # The tip of a tool that turns with its arc makes an arc of the same angle.
        follows = np.abs(turn - np.degrees(arc.sweep(bow))) < _SAME
        whole = follows | (np.abs(turn) < _SAME) | (rests & (np.abs(turn) < _MOST_TURN))
        steps = np.where(whole, 1, np.ceil(np.abs(turn) / _TURN)).astype(np.int64)
        row = np.repeat(np.arange(len(rows)), steps)
        step = np.arange(len(row)) - np.repeat(np.cumsum(steps) - steps, steps)
        sides = []
        for fraction in (step / steps[row], (step + 1) / steps[row]):
            head = arc.point_at(start[row, :2], end[row, :2], bow[row], fraction)
            heading = start[row, 3] + turn[row] * fraction
            sides.append(head + tip_offset(heading, one))
        pair = np.stack(sides, axis=1)
        curved = np.where(rests & whole, np.tan(np.radians(turn) / 4.0), bow * whole)[row]
        long = np.hypot(*(pair[:, 1] - pair[:, 0]).T) > 1e-9
        ends.append(pair[long])
        bulges.append(curved[long])
    return np.concatenate(ends), np.concatenate(bulges)
