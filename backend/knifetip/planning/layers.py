"""layers: which cuts are made before which, so that nothing is worked on what is already loose.

    cuts -> the layer of each: 0 last

A piece of board comes loose when cuts close all round it.  Seen backwards, from the finished sheet,
every cut that is taken back joins the faces on its two sides; a face that has so been joined to the
plane outside is held.  A cut may be the last of all if one of its sides is held already.  Such cuts
are layer 0; when they have been taken back more faces are held, and the cuts beside those are layer
1, and so on inwards.  Cuts of one layer may be made in any order, after those of all higher ones.

So holes come before their part, a part before the window it lies in, the line between two parts
before the outline of both, and open cuts before the contour they lie in.  A closed contour is one
piece of work, and so is an edge of none: it is of the layer of its innermost stretch.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.tolerance import CONTOUR_GAP
from knifetip.kernels import F64_1, I64_1, I64_2, OutI64_1, kernel
from knifetip.planning.gaps import links
from knifetip.planning.noding import noded_throughout
from knifetip.topology.subdivision import subdivide


def cut_layers(ends: F64, bulge: F64, contour: I64) -> I64:
    """Return the layer of each cut, (n,); those of higher layers are made first.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Cuts of any order and direction; contours may have gaps of up to ``CONTOUR_GAP``.
    contour : (n,)
        The closed contour that each cut belongs to, -1 for none.  The cuts of one are of one layer,
        unless contours hold each other so that only single edges can be put in order.

    Raises
    ------
    PlanError
        The cuts cross each other millions of times.
    """
    count = len(ends)
    if count == 0:
        return np.zeros(0, np.int64)
    closing = links(ends, bulge)
    pieces, bent, row = noded_throughout(
        np.concatenate([ends, closing]), np.concatenate([bulge, np.zeros(len(closing))])
    )
    found = subdivide(pieces, bent)
    # Face 0 is the plane outside.
    face = found.merged[found.face] + 1
    sides = face.ravel()
    by_face = np.argsort(sides, kind="stable")
    first = np.searchsorted(sides[by_face], np.arange(len(found.outer) + 2))
    size = arc.length(pieces[:, 0], pieces[:, 1], bent)
    alone = np.arange(count)
    work = np.unique(np.where(contour < 0, alone, count + contour), return_inverse=True)[1].ravel()
    owner = np.append(work, -1)[np.where(row < count, row, -1)]
    layer, ordered = _peeled(face, owner, size, by_face // 2, first, int(work.max()) + 1)
    if not ordered:
        work = alone
        owner = np.where(row < count, row, -1)
        layer, _ = _peeled(face, owner, size, by_face // 2, first, count)
    result: I64 = layer[work]
    return result


@kernel
def _peeled(
    face: I64_2, row: I64_1, size_of: F64_1, piece_of: I64_1, first: I64_1, count: int
) -> Any:
    """Return the layer of each of ``count`` pieces of work, and whether all could be put in order.

    Parameters
    ----------
    face : (m, 2)
        The faces on the sides of stretches; 0 is the plane outside.
    row : (m,)
        The work that each stretch is part of, -1 for links.
    size_of : (m,) mm
        How long each stretch is: one shorter than ``CONTOUR_GAP`` does not hold its edge.
    piece_of, first
        The stretches beside each face, and where each face's begin.
    """
    layer = np.full(count, -1, np.int64)
    waiting = np.zeros(count, np.int64)
    starts = np.zeros(count + 1, np.int64)
    for piece in range(len(row)):
        if row[piece] >= 0:
            waiting[row[piece]] += 1
            starts[row[piece] + 1] += 1
    for edge in range(count):
        starts[edge + 1] += starts[edge]
    pieces = np.empty(starts[count], np.int64)
    filled = starts[:-1].copy()
    for piece in range(len(row)):
        if row[piece] >= 0:
            pieces[filled[row[piece]]] = piece
            filled[row[piece]] += 1
    held = np.zeros(len(first) - 1, np.bool_)
    ready = np.zeros(len(row), np.bool_)
    reached = np.empty(len(held), np.int64)
    queue = np.empty(count, np.int64)
    begun = np.empty(len(row), np.int64)
    brief = np.empty(len(row), np.int64)
    started = tried = scraps = tried_brief = done = 0
    faces = 1
    held[0] = True
    reached[0] = 0
    looked = 0
    number = 0
    size = 0
    ordered = True
    while done < count:
        # What has come to be held makes the cuts beside it ready.
        while looked < faces:
            for place in range(first[reached[looked]], first[reached[looked] + 1]):
                piece = piece_of[place]
                edge = row[piece]
                if ready[piece] or edge < 0:
                    continue
                ready[piece] = True
                if size_of[piece] > CONTOUR_GAP:
                    begun[started] = edge
                    started += 1
                else:
                    brief[scraps] = edge
                    scraps += 1
                waiting[edge] -= 1
                if waiting[edge] == 0:
                    queue[size] = edge
                    size += 1
            looked += 1
        if size == done:
            ordered = False
            # Edges that hold each other: those with a stretch that is ready, or else all.
            for place in range(tried, started):
                size = _queued(begun[place], layer, waiting, queue, size)
            tried = started
            if size == done:
                for place in range(tried_brief, scraps):
                    size = _queued(brief[place], layer, waiting, queue, size)
                tried_brief = scraps
            if size == done:
                for edge in range(count):
                    size = _queued(edge, layer, waiting, queue, size)
        until = size
        for place in range(done, until):
            edge = queue[place]
            layer[edge] = number
            for k in range(starts[edge], starts[edge + 1]):
                for side in range(2):
                    name = face[pieces[k], side]
                    if not held[name]:
                        held[name] = True
                        reached[faces] = name
                        faces += 1
        done = until
        number += 1
    return layer, ordered


@kernel
def _queued(edge: int, layer: I64_1, waiting: OutI64_1, queue: OutI64_1, size: int) -> int:
    """Put an edge into the queue unless it was there, and return how long the queue is."""
    if layer[edge] >= 0 or waiting[edge] < 0:
        return size
    waiting[edge] = -1
    queue[size] = edge
    return size + 1
