"""Shapes for tests: dielines from edges, and tools and boards with simple dimensions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.messages.message import Message
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Axis, Machine, Station
from knifetip.model.tool import CreaseWheel, Knife, Tool, VCutter
from knifetip.model.toolpath import Motion, Toolpath

#: Reason for the line types of dielines that are written by hand.
BY_HAND = Message("classification.override")

KNIFE = Knife(
    blade_angle=45.0,
    blade_width=3.0,
    swivel=15.0,
    feed=24000.0,
    plunge=6000.0,
    oscillating=True,
)
WHEEL = CreaseWheel(radius=15.0, width=0.7, feed=30000.0, plunge=6000.0)
CUTTER = VCutter(back=4.0, half_width=1.5, tilt=45.0, feed=12000.0, plunge=3000.0)

BOARD = Board(
    name="test",
    title="Test board",
    material="greyboard",
    caliper=2.0,
    grain=90.0,
    crease_along=0.4,
    crease_across=0.6,
    end_clearance=0.2,
    groove_depth=1.0,
    groove_overcut=3.0,
    half_cut_depth=0.8,
    perforation=(3.0, 2.0),
    short_crease="press",
)

_AXIS = Axis(-500.0, 2000.0, 1500.0, 8000.0)
MACHINE = Machine(
    name="test",
    title="Test table",
    width=1600.0,
    height=1200.0,
    x=_AXIS,
    y=_AXIS,
    z=Axis(-10.0, 60.0, 500.0, 5000.0),
    c=Axis(-1080.0, 1080.0, 3600.0, 36000.0),
    stations=(
        Station(1, "Knife", KNIFE, 0.0, 0.0, 0.0, 0.0, 0),
        Station(2, "Wheel", WHEEL, 60.0, 0.0, -1.5, 0.0, 1),
        Station(3, "V-cutter", CUTTER, -60.0, 0.0, 0.0, 0.0, 2),
    ),
    dialect="linuxcnc",
    origin=(0.0, 0.0),
    travel_z=20.0,
    clearance=2.0,
    into_mat=0.3,
    settle=0.15,
)


def closed(*points: tuple[float, float]) -> F64:
    """Return the edges of a closed polygon with n corners, (n, 2, 2)."""
    corners = np.array(points, float)
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)


def edges(*ends: tuple[tuple[float, float], tuple[float, float]]) -> F64:
    """Return n separate edges, each from one point to another, as an array (n, 2, 2)."""
    return np.array(ends, float).reshape(-1, 2, 2)


def dieline(*groups: tuple[LineType, F64], bulge: dict[int, float] | None = None) -> Dieline:
    """Return a dieline of groups of edges, each group with one line type.

    ``bulge`` maps the row of an edge to its bulge; all other edges are straight.
    """
    ends = np.concatenate([group for _, group in groups])
    kinds = np.concatenate([np.full(len(group), kind) for kind, group in groups])
    bent = np.zeros(len(ends))
    for row, value in (bulge or {}).items():
        bent[row] = value
    rows = np.arange(len(ends), dtype=np.int32)
    return Dieline(ends, bent, kinds, rows, np.zeros_like(rows), np.ones(len(ends)), (BY_HAND,))


def paths(start: ArrayLike, end: ArrayLike, bulge: ArrayLike, first: ArrayLike) -> Paths:
    """Return ``Paths`` with these columns, converted to their array types."""
    return Paths(
        np.asarray(start, np.float64),
        np.asarray(end, np.float64),
        np.asarray(bulge, np.float64),
        np.asarray(first, np.int32),
    )


def toolpath(
    pose: ArrayLike,
    moves: Sequence[tuple[Motion, float, int]],
    *,
    bulge: ArrayLike | None = None,
    source: ArrayLike | None = None,
    track: ArrayLike | None = None,
) -> Toolpath:
    """Return a toolpath of n moves, each (motion, feed, station), through n + 1 poses.

    Parameters
    ----------
    pose : (n + 1, 4)
        x, y, z and c of the head before and after each move.
    bulge, source, track : (n,), optional
        By default straight moves, the numbers of the moves, and a single track.
    """
    count = len(moves)
    return Toolpath(
        np.asarray(pose, np.float64).reshape(-1, 4),
        np.zeros(count) if bulge is None else np.asarray(bulge, np.float64),
        np.array([move[0] for move in moves], np.uint8),
        np.array([move[1] for move in moves], np.float64),
        np.arange(count, dtype=np.int32) if source is None else np.asarray(source, np.int32),
        np.array([move[2] for move in moves], np.uint8),
        np.zeros(count, np.int32) if track is None else np.asarray(track, np.int32),
    )


def with_dimensions(tool: Tool, **dimensions: Any) -> Tool:
    """Return a copy of a tool with some dimensions replaced."""
    made: Tool = replace(cast(Any, tool), **dimensions)
    return made


def rotation(degrees: float) -> F64:
    """Return the matrix (2, 2) that rotates column vectors counter-clockwise."""
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[cos, -sin], [sin, cos]])
