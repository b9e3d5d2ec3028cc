"""layers: order cuts so that no tool cuts a piece of board that is already loose.

A piece of board comes loose when cuts enclose it.  The layers are found backwards, from the
finished sheet.  Removing a cut joins the faces on its two sides, and a face that is joined to the
plane outside is held.  Cuts with a held face on one side form layer 0, which is cut last.  Removing
them makes more faces held; cuts beside those faces form layer 1, and so on inwards.  Cuts of one
layer may be made in any order, after all cuts of higher layers.

In this order, a hole is cut before its part, and a part before the window in which it lies.  The
line between two parts is cut before their common outline, and an open cut before the contour in
which it lies.  A closed contour gets one layer, and so does a cut that belongs to no contour.  If
the pieces between crossings with other cuts have different layers, the highest of these counts.
``necks`` then divides the layers further.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import CONTOUR_GAP
from knifetip.kernels import F64_1, I64_1, I64_2, OutI64_1, kernel
from knifetip.planning.necks import layers_at_necks
from knifetip.planning.stretches import Stretches
from knifetip.topology.contour_gaps import closing_links, find_dangling_ends
from knifetip.topology.noding import split_at_crossings
from knifetip.topology.subdivision import Subdivision, subdivide


@dataclass(frozen=True, eq=False, slots=True)
class CutLayers:
    """The layers of n cuts, and the stretches into which the cuts are split where they meet."""

    number: I64  #: (n,) layer of each cut; the cuts of higher layers are made first
    stretches: Stretches


def cut_layers(
    ends: F64,
    bulge: F64,
    contour: I64,
    *,
    contours_whole: bool = False,
    uncrossed: Subdivision | None = None,
) -> CutLayers:
    """Return the layers of n cuts.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts, in any order and direction.  Contours may
        have gaps of up to ``CONTOUR_GAP``.
    contour : (n,)
        Number of the closed contour to which each cut belongs, -1 for none.  All cuts of a contour
        get the same layer, except in a cycle of contours that enclose each other.
    contours_whole
        What to do if contours enclose each other in a cycle, such as two parts that touch at two
        points with waste between them.  If False, each cut gets its own layer.  If True, each
        contour still gets one layer, and contours of a cycle get the layer in which the first of
        their cuts could be made.
    uncrossed
        The faces between the cuts, valid if the cuts meet only at their ends; None if they have not
        been found.

    Raises
    ------
    PlanError
        The bounding boxes of more than five million pairs of cuts overlap.
    """
    count = len(ends)
    if count == 0:
        none = np.zeros(0, np.int64)
        return CutLayers(none, Stretches(ends, bulge, none, none.reshape(0, 2)))
    tips = find_dangling_ends(ends, bulge)
    closing = closing_links(ends, bulge, tips, CONTOUR_GAP)
    if len(closing):
        pieces, bent, row = split_at_crossings(
            np.concatenate([ends, closing]), np.concatenate([bulge, np.zeros(len(closing))])
        )
    else:
        pieces, bent, row = split_at_crossings(ends, bulge)
    # Cuts are returned as they are if none is split.
    if uncrossed is None or pieces is not ends:
        uncrossed = subdivide(pieces, bent)
    subdivision = uncrossed
    # Face 0 is the plane outside.
    face = subdivision.merged[subdivision.face] + 1
    sides = face.ravel()
    by_face = np.argsort(sides, kind="stable")
    first = np.searchsorted(sides[by_face], np.arange(len(subdivision.outer) + 2))
    size = arc.length(pieces[:, 0], pieces[:, 1], bent)
    single_units = np.arange(count)
    work = np.unique(np.where(contour < 0, single_units, count + contour), return_inverse=True)[
        1
    ].ravel()
    owner = np.append(work, -1)[np.where(row < count, row, -1)]
    layer, ordered = _assign_layers(face, owner, size, by_face // 2, first, int(work.max()) + 1)
    if not ordered and not contours_whole:
        work = single_units
        owner = np.where(row < count, row, -1)
        layer, _ = _assign_layers(face, owner, size, by_face // 2, first, count)
    stretches = Stretches(pieces, bent, row, face)
    return CutLayers(layers_at_necks(ends, bulge, layer[work], stretches, closing, tips), stretches)


@kernel
def _assign_layers(
    face: I64_2, unit_of: I64_1, size_of: F64_1, piece_of: I64_1, first: I64_1, count: int
) -> Any:
    """Return the layer of each of ``count`` units of work, and whether the units could be ordered.

    A unit of work is a closed contour or a single edge; it consists of stretches between faces.
    The units cannot be ordered if they form a cycle, in which each unit would have to be cut before
    another unit of the cycle.

    ``face`` (m, 2): faces on the two sides of each of m stretches; 0 is the plane outside.
    ``unit_of`` (m,): unit of work to which each stretch belongs, -1 if the stretch only closes a
    gap.
    ``size_of`` (m,) mm: length of each stretch.  A cycle is broken at a stretch that is longer than
    ``CONTOUR_GAP``, if there is one.
    ``piece_of``, ``first``: stretches sorted by the faces beside them, and index in ``piece_of`` of
    each face's first stretch.
    """
    layer = np.full(count, -1, np.int64)
    waiting = np.zeros(count, np.int64)
    starts = np.zeros(count + 1, np.int64)
    for piece in range(len(unit_of)):
        if unit_of[piece] >= 0:
            waiting[unit_of[piece]] += 1
            starts[unit_of[piece] + 1] += 1
    for unit in range(count):
        starts[unit + 1] += starts[unit]
    pieces = np.empty(starts[count], np.int64)
    filled = starts[:-1].copy()
    for piece in range(len(unit_of)):
        if unit_of[piece] >= 0:
            pieces[filled[unit_of[piece]]] = piece
            filled[unit_of[piece]] += 1
    held = np.zeros(len(first) - 1, np.bool_)
    ready = np.zeros(len(unit_of), np.bool_)
    reached = np.empty(len(held), np.int64)
    queue = np.empty(count, np.int64)
    long_units = np.empty(len(unit_of), np.int64)
    short_units = np.empty(len(unit_of), np.int64)
    long_count = long_tried = short_count = short_tried = finished = 0
    faces = 1
    held[0] = True
    reached[0] = 0
    face_index = 0
    number = 0
    size = 0
    ordered = True
    while finished < count:
        # Stretches beside newly held faces become ready.
        while face_index < faces:
            for slot in range(first[reached[face_index]], first[reached[face_index] + 1]):
                piece = piece_of[slot]
                unit = unit_of[piece]
                if ready[piece] or unit < 0:
                    continue
                ready[piece] = True
                if size_of[piece] > CONTOUR_GAP:
                    long_units[long_count] = unit
                    long_count += 1
                else:
                    short_units[short_count] = unit
                    short_count += 1
                waiting[unit] -= 1
                if waiting[unit] == 0:
                    queue[size] = unit
                    size += 1
            face_index += 1
        if size == finished:
            ordered = False
            # A cycle: queue the units with a ready stretch or, if there are none, all units.
            for slot in range(long_tried, long_count):
                size = _enqueue(long_units[slot], layer, waiting, queue, size)
            long_tried = long_count
            if size == finished:
                for slot in range(short_tried, short_count):
                    size = _enqueue(short_units[slot], layer, waiting, queue, size)
                short_tried = short_count
            if size == finished:
                for unit in range(count):
                    size = _enqueue(unit, layer, waiting, queue, size)
        stop = size
        for slot in range(finished, stop):
            unit = queue[slot]
            layer[unit] = number
            for k in range(starts[unit], starts[unit + 1]):
                for side in range(2):
                    name = face[pieces[k], side]
                    if not held[name]:
                        held[name] = True
                        reached[faces] = name
                        faces += 1
        finished = stop
        number += 1
    return layer, ordered


@kernel
def _enqueue(unit: int, layer: I64_1, waiting: OutI64_1, queue: OutI64_1, size: int) -> int:
    """Append a unit of work, a contour or a single edge, to a queue; return the queue's new length.

    A unit that has a layer or was appended before is not appended again; then the length is
    unchanged.

    ``layer``: layer of each unit, -1 if it has none yet.
    ``waiting``: is set to -1 for each unit that this function appends, and is not negative for
    other units.
    ``queue``: indices of the queued units; only the first ``size`` entries are used.
    ``size``: length of the queue before the call.
    """
    if layer[unit] >= 0 or waiting[unit] < 0:
        return size
    waiting[unit] = -1
    queue[size] = unit
    return size + 1
