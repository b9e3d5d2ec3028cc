"""folding: which lines must be folds, because a panel hangs on them.

    PlanarGraph, Faces, roles -> which edges hold a panel

A blank is cut out in one piece: where one straight line is all that joins a panel to the others it
cannot be a cut.  Where panels meet in a ring round a corner one of the lines is a slit, and a slit
begins at the rim: a straight line between two such corners is none.

This says nothing of several equal blanks with nothing between them, nor of what is framed by bends:
a tab, a slot, a window.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, Final

import numpy as np

from knifetip.classification.role import HOLES, Role
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.kernels import I64_1, I64_2, kernel
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: Two lines are one straight line if their directions differ by less (radians).
_STRAIGHT: Final = math.radians(1.0)
#: Panels of one size differ by less than this share.
_ALIKE: Final = 0.003
#: Fewer panels than this are a board, a cover or a card rather than a carton.
_PANELS: Final = 6
#: Their middles lie so near to each other, as a share of the largest panel's size.
_NEAR: Final = 0.01
#: More than this share of the panels again, beyond the first that are, are further blanks.
_AGAIN: Final = 0.4
#: With more than this they are a row, if the first of it are a carton; side by side the panels of
#: a square one are alike too.
_ROW: Final = 0.55
#: A carton has no more panels of one size than this; a living hinge has, and so has a sheet.
_SAME: Final = 16
#: So much of what divides the panels of a carton is straight from face to face.
_PLAIN: Final = 0.6
#: So many panels and parts are looked at.
_MOST: Final = 64
_SHEETS: Final = 200


def holding(graph: PlanarGraph, sides: Faces, role: U8, length: F64, count: int) -> Bool:
    """Return which of n edges hold a panel, (n,).

    Parameters
    ----------
    role, length : (p,)
        Of each piece of the graph.
    """
    held = np.zeros(count, np.bool_)
    divides = np.flatnonzero(role == Role.DIVIDER)
    if len(divides) == 0:
        return held
    faces = len(sides.area)
    rim = np.zeros(faces, np.bool_)
    edge_of_blank = role == Role.OUTLINE
    rim[sides.left[edge_of_blank]] = rim[sides.right[edge_of_blank]] = True
    degree, bent = _corners(graph, len(graph.vertex))
    on_rim = np.zeros(len(graph.vertex), np.bool_)
    for side in (graph.start, graph.end):
        on_rim[side[edge_of_blank | np.isin(role, HOLES)]] = True
    framed = np.zeros(faces, np.bool_)
    for side in (sides.left, sides.right):
        for at in (graph.start, graph.end):
            framed[side[divides][(degree[at] == 2)[divides] & bent[at][divides]]] = True
    framed &= ~rim
    panel = ~framed & (sides.area > 0.0)
    left, right = sides.left[divides], sides.right[divides]
    sound = panel[left] & panel[right]
    pair, number = _paired(left, right)
    straight = _one_line(graph, divides, number, len(pair))
    bridge = _bridges(pair, faces) & straight
    free = straight & _between_corners(graph, divides, number, len(pair), on_rim, degree)
    chosen = (bridge | free)[number] & _longest(graph, divides, number, length, count)
    alone = _single_blanks(graph, sides, length, rim, panel)
    parts, part = len(sides.outer_face), graph.component[divides]
    lines = np.bincount(part, length[divides], parts)
    # Maps and floor plans divide faces too, by whatever line there is.
    plain = np.bincount(part, length[divides] * straight[number], parts) >= _PLAIN * lines
    panels = np.bincount(sides.component[panel], minlength=parts)
    carton = alone & plain & (panels >= _PANELS)
    holds = sound & chosen & carton[part]
    rows = graph.edge[divides]
    real = rows >= 0
    whole = np.bincount(rows[real], length[divides][real], count)
    share = np.bincount(rows[real & holds], length[divides][real & holds], count)
    return (share > 0.9 * whole) & (whole > 0.0)


def _corners(graph: PlanarGraph, places: int) -> tuple[I64, Bool]:
    """Return how many lines meet at each place, and whether two that meet make a bend, (q,)."""
    own = np.flatnonzero(graph.same == np.arange(len(graph.same)))
    ends = np.concatenate([graph.start[own], graph.end[own]])
    degree = np.bincount(ends, minlength=places)
    run = graph.vertex[graph.end[own]] - graph.vertex[graph.start[own]]
    # Twice the angle is the same whichever way a line is drawn.
    angle = np.arctan2(run[:, 1], run[:, 0]) * 2.0
    turn = 4.0 * np.arctan(graph.bulge[own])
    angles = np.concatenate([angle - turn, angle + turn])
    x = np.bincount(ends, np.cos(angles), places)
    y = np.bincount(ends, np.sin(angles), places)
    straight = np.hypot(x, y) >= degree * math.cos(_STRAIGHT)
    return degree, ~straight


def _paired(left: Any, right: Any) -> tuple[I64, I64]:
    """Return the pairs of faces that lines divide, (k, 2), and the pair of each line, (d,)."""
    low, high = np.minimum(left, right).astype(np.int64), np.maximum(left, right).astype(np.int64)
    key = low * (int(high.max()) + 1) + high
    known, number = np.unique(key, return_inverse=True)
    return np.column_stack(np.divmod(known, int(high.max()) + 1)), number


def _one_line(graph: PlanarGraph, rows: I64, number: I64, pairs: int) -> Bool:
    """Return whether all lines between two faces are pieces of one straight line, (k,)."""
    start, end = graph.vertex[graph.start[rows]], graph.vertex[graph.end[rows]]
    run = np.hypot(*(end - start).T)
    first = np.searchsorted(np.sort(number), np.arange(pairs))
    # Along the longest piece the line has two ends, and through those it runs: a dash is too short
    # to say in which direction all of them lie.
    lead = np.lexsort((-run, number))[first]
    points = np.concatenate([start, end])
    twice = np.concatenate([number, number])
    way = (end - start)[lead][twice]
    along = (points * way).sum(axis=1)
    order = np.lexsort((along, twice))
    low = points[order[2 * first]][number]
    high = points[order[np.append(2 * first[1:], len(order)) - 1]][number]
    way = (high - low) / np.maximum(np.hypot(*(high - low).T), 1e-12)[:, None]
    off = np.abs(graph.bulge[rows]) > 1e-6
    for point in (start, end):
        away = point - low
        aside = np.abs(away[:, 0] * way[:, 1] - away[:, 1] * way[:, 0])
        off |= aside > math.sin(_STRAIGHT) * np.maximum(run, 10.0)
    result: Bool = np.bincount(number[off], minlength=pairs) == 0
    return result


def _between_corners(
    graph: PlanarGraph, rows: I64, number: I64, pairs: int, on_rim: Bool, degree: I64
) -> Bool:
    """Return whether what divides two faces begins and ends at corners off the rim, (k,)."""
    places = len(graph.vertex)
    key = np.concatenate([number * places + graph.start[rows], number * places + graph.end[rows]])
    known, count = np.unique(key, return_counts=True)
    tip, pair = (known % places)[count == 1], (known // places)[count == 1]
    loose = on_rim[tip] | (degree[tip] < 3)
    result: Bool = (np.bincount(pair, minlength=pairs) == 2) & (
        np.bincount(pair[loose], minlength=pairs) == 0
    )
    return result


def _longest(graph: PlanarGraph, rows: I64, number: I64, length: F64, count: int) -> Bool:
    """Return which lines are the longest edges between their faces, or the dashes of a row, (d,).

    Short edges at the ends of a fold may be the slits that lock it.
    """
    edge = graph.edge[rows]
    whole = np.bincount(edge[edge >= 0], length[rows][edge >= 0], count)
    own = np.where(edge >= 0, whole[edge], 0.0)
    most = np.zeros(int(number.max()) + 1)
    np.maximum.at(most, number, own)
    dashed = (edge >= 0) & graph.dashed[edge]
    in_dashes = np.bincount(number[dashed], minlength=len(most)) > 0
    result: Bool = np.where(in_dashes[number], dashed, own >= 0.99 * most[number])
    return result


def _single_blanks(graph: PlanarGraph, sides: Faces, length: F64, rim: Bool, panel: Bool) -> Bool:
    """Return which parts are not several equal blanks, (c,).

    Equal blanks lie beside each other, or head to tail: every panel at the rim has an image under
    one shift, or under half a turn that leaves none where it was.  A carton has a glue flap that
    has none, or a base that is its own.
    """
    faces = len(sides.area)
    owner = sides.component
    # What is drawn twice counts once.
    own = np.flatnonzero(graph.same == np.arange(len(graph.same)))
    start, end, length = graph.vertex[graph.start[own]], graph.vertex[graph.end[own]], length[own]
    middle = 0.5 * (start + end)
    centre = np.zeros((faces, 2))
    box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (faces, 1))
    weight = np.zeros(faces)
    for side in (sides.left[own], sides.right[own]):
        weight += np.bincount(side, length, faces)
        for axis in range(2):
            centre[:, axis] += np.bincount(side, length * middle[:, axis], faces)
        for at in (start, end):
            np.minimum.at(box[:, :2], side, at)
            np.maximum.at(box[:, 2:], side, at)
    centre /= np.maximum(weight, 1e-12)[:, None]
    chosen = np.flatnonzero(panel)
    single = np.zeros(len(sides.outer_face), np.bool_)
    order = chosen[np.argsort(owner[chosen], kind="stable")]
    bounds = np.flatnonzero(np.diff(owner[order], prepend=-1, append=-1))
    for first, last in list(pairwise(bounds.tolist()))[:_SHEETS]:
        mine = order[first:last]
        again = _repeated(sides.area[mine], centre[mine], box[mine], rim[mine])
        single[owner[mine[0]]] = not again
    return single


def _repeated(area: F64, centre: F64, box: F64, rim: Bool) -> bool:
    """Return whether panels are the same panels again, shifted or turned by half a turn."""
    if len(area) > _MOST:
        return True
    alike = np.abs(area[:, None] - area) <= _ALIKE * np.maximum(area[:, None], area)
    if alike.sum(axis=0).max() > _SAME:
        return True
    largest = int(area.argmax())
    near = _NEAR * math.sqrt(float(area.max()))
    turned = centre[:, None] + centre
    shift = centre - centre[:, None]
    for other in np.flatnonzero(alike[largest]).tolist():
        if other == largest:
            continue
        by = centre[other] - centre[largest]
        there = alike & (np.abs(shift - by) <= near).all(axis=2)
        image, again = there.any(axis=0), there.any(axis=1)
        if (image | again)[rim].all():
            return True
        # Glue flaps look different where the next blank begins; the rest does not.  The front and
        # the back of a single carton are alike too, but its glue flap stands over them.
        if image.mean() > _ROW and int((again & ~image).sum()) >= _PANELS:
            return True
        if image.mean() > _AGAIN and not image.all():
            axis = int(np.abs(by).argmax())
            low, high = box[~image, axis].min(), box[~image, axis + 2].max()
            if high - low <= 1.002 * abs(by[axis]):
                return True
        about = centre[other] + centre[largest]
        there = alike & (np.abs(turned - about) <= near).all(axis=2)
        if there.any(axis=0)[rim].all() and not there.diagonal().any():
            return True
    return False


def _bridges(pair: I64, faces: int) -> Bool:
    """Return which pairs of faces are joined by nothing else, (k,)."""
    ends = np.concatenate([pair[:, 0], pair[:, 1]])
    order = np.argsort(ends, kind="stable")
    first = np.searchsorted(ends[order], np.arange(faces + 1))
    bridge: Bool = _bridged(pair, first, order % len(pair), faces)
    return bridge


@kernel
def _bridged(pair: I64_2, first: I64_1, listed: I64_1, faces: int) -> Any:
    """Walk the faces depth first; a pair is a bridge where nothing beyond it leads back."""
    bridge = np.zeros(len(pair), np.bool_)
    entered = np.full(faces, -1, np.int64)
    lowest = np.zeros(faces, np.int64)
    by = np.full(faces, -1, np.int64)
    at = first[:-1].copy()
    stack = np.empty(faces, np.int64)
    time = 0
    for root in range(faces):
        if entered[root] >= 0 or first[root] == first[root + 1]:
            continue
        depth = 0
        stack[0] = root
        entered[root] = lowest[root] = time
        time += 1
        while depth >= 0:
            face = stack[depth]
            if at[face] < first[face + 1]:
                k = listed[at[face]]
                at[face] += 1
                if k == by[face]:
                    continue
                other = pair[k, 1] if pair[k, 0] == face else pair[k, 0]
                if entered[other] >= 0:
                    lowest[face] = min(lowest[face], entered[other])
                    continue
                by[other] = k
                entered[other] = lowest[other] = time
                time += 1
                depth += 1
                stack[depth] = other
                continue
            depth -= 1
            if depth >= 0:
                over = stack[depth]
                lowest[over] = min(lowest[over], lowest[face])
                if lowest[face] > entered[over]:
                    bridge[by[face]] = True
    return bridge
