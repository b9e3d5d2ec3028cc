"""Random sheets of contours inside contours; shapely determines which contour contains which."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon

from knifetip.geometry.columns import F64, I64
from knifetip.model.dieline import Dieline, LineType
from tests.support.shapes import dieline


@dataclass(frozen=True)
class Sheet:
    """A dieline of closed contours, and the pairs of contours of which one contains the other."""

    line: Dieline
    contour: I64  #: number of the contour of each edge, (n,)
    pairs: list[tuple[int, int]]


def sheet(seed: int, *, clearance: float, min_side: float, gap: float = 0.0) -> Sheet:
    """Return randomly nested contours, whose edges have random order and direction.

    Parameters
    ----------
    clearance : mm
        Distance between neighbouring contours, and between a contour and those inside it.
    min_side : mm
        Smallest width and height of a contour.
    gap : mm
        Largest gap at the corners and in the middle of edges.
    """
    chance = np.random.default_rng(seed)
    corners: list[F64] = []
    _fill(chance, 10.0, 10.0, 700.0, 500.0, clearance, min_side, corners, 0)
    groups = [_edges(one, chance, gap) for one in corners]
    order = chance.permutation(sum(len(one) for one in groups))
    ends = np.concatenate(groups)[order]
    back = chance.random(len(ends)) < 0.5
    ends[back] = ends[back][:, ::-1]
    contour = np.repeat(np.arange(len(groups)), [len(one) for one in groups])[order]
    shapes = [Polygon(one) for one in corners]
    pairs = [
        (inner, outer)
        for inner in range(len(shapes))
        for outer in range(len(shapes))
        if inner != outer and shapes[outer].contains(shapes[inner])
    ]
    return Sheet(dieline((LineType.CUT, ends)), contour, pairs)


def _fill(
    chance: np.random.Generator,
    x: float,
    y: float,
    width: float,
    height: float,
    clearance: float,
    min_side: float,
    corners: list[F64],
    depth: int,
) -> None:
    """Append the corners of random contours in a rectangle to ``corners``, recursively.

    The rectangle is split in two, or becomes a contour that is filled with further contours.
    """
    if width < min_side or height < min_side:
        return
    if chance.random() < 0.6 and max(width, height) > 2.5 * min_side + clearance:
        share = chance.uniform(0.35, 0.65)
        if width > height:
            left = width * share - clearance / 2.0
            _fill(chance, x, y, left, height, clearance, min_side, corners, depth)
            x, width = x + left + clearance, width - left - clearance
        else:
            low = height * share - clearance / 2.0
            _fill(chance, x, y, width, low, clearance, min_side, corners, depth)
            y, height = y + low + clearance, height - low - clearance
        _fill(chance, x, y, width, height, clearance, min_side, corners, depth)
        return
    slant = chance.uniform(0.0, 0.15) * min(width, height) if chance.random() < 0.5 else 0.0
    corners.append(
        np.array([(x + slant, y), (x + width, y), (x + width - slant, y + height), (x, y + height)])
    )
    if depth < 6:
        inset = clearance + slant
        _fill(
            chance, x + inset, y + clearance, width - 2.0 * inset, height - 2.0 * clearance,
            clearance, min_side, corners, depth + 1,
        )  # fmt: skip


def _edges(corners: F64, chance: np.random.Generator, gap: float) -> F64:
    edges = []
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        unit = (end - start) / math.hypot(*(end - start))
        size = chance.uniform(0.2, 1.0) * gap
        kind = chance.integers(0, 4) if gap > 0.0 else 0
        if kind == 1:
            start = start + size * unit
        elif kind == 2:
            end = end - size * unit
        elif kind == 3:
            middle = start + (end - start) * chance.uniform(0.3, 0.7)
            edges.append((start, middle - size / 2.0 * unit))
            start = middle + size / 2.0 * unit
        edges.append((start, end))
    return np.array(edges)
