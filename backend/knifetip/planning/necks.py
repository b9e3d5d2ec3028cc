"""necks: order cuts so that no tool cuts a piece of board that hangs on necks only.

A neck is board at most ``NECK`` mm wide between a dangling end of a cut and another cut.  A
straight link across each neck encloses the pieces of board that hang on necks once the cuts round
them are made.  The cuts inside such a piece are made before the last cut round it.  A piece that is
not wider than ``MIN_WIDTH``, such as a strip between two slits, is not regarded as hanging.

Cuts that are connected with each other are one unit of work.  A unit may be made last if board that
is held lies beside any of its stretches; once it is regarded as not yet made, it holds the board
beside all of them.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import CONTOUR_GAP, JOIN
from knifetip.geometry.union_find import flatten, union
from knifetip.geometry.vertices import number_vertices
from knifetip.kernels import F64_2, I64_1, I64_2, kernel
from knifetip.planning.stretches import Stretches
from knifetip.topology.contour_gaps import closing_links
from knifetip.topology.noding import split_at_crossings
from knifetip.topology.planar_graph import connected_components
from knifetip.topology.subdivision import subdivide

#: Greatest width of a neck (mm).  The verifier's limit is 4 mm.
NECK: Final = 4.4
#: Least mean width of a piece of board that hangs on necks (mm): 2 area / perimeter, which is the
#: width of a long strip, and half the side of a square.  The verifier's limit is 12 mm.
MIN_WIDTH: Final = 3.0
#: Necks are sought in faces that extend at least this far along X and along Y (mm).  A smaller face
#: contains no piece with a mean width of 12 mm.
MIN_EXTENT: Final = 11.0


def layers_at_necks(
    ends: F64, bulge: F64, layer: I64, stretches: Stretches, closing: F64, tips: I64
) -> I64:
    """Return the layers of n cuts, (n,), changed where a piece of board hangs on necks.  Cuts
    inside such a piece get a higher layer than the last cut round it, so they are made first.

    Cuts of different layers remain in their order.  If there is no such piece, ``layer`` is
    returned.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points, and bulges, of the cuts.
    layer : (n,)
        Layers of the cuts from ``layers``.
    stretches
        Stretches of the cuts and of the links across gaps.
    closing : (k, 2, 2) mm
        Links across gaps of up to ``CONTOUR_GAP``.
    tips : (t,)
        Indices of the dangling ends of the cuts; cut i has the ends 2i and 2i + 1.
    """
    links = closing_links(ends, bulge, _tips_in_wide_faces(stretches, tips, len(ends)), NECK)
    links = links[np.hypot(*(links[:, 1] - links[:, 0]).T) > CONTOUR_GAP]
    if len(links) == 0:
        return layer
    links = np.concatenate([closing, links])
    length = np.hypot(*(links[:, 1] - links[:, 0]).T)
    own = stretches.row < len(ends)
    component = _components(stretches.ends[own], stretches.row[own], len(ends))
    pieces, bent, row = split_at_crossings(
        np.concatenate([ends, links]), np.concatenate([bulge, np.zeros(len(links))])
    )
    subdivision = subdivide(pieces, bent)
    face = subdivision.merged[subdivision.face] + 1
    is_link = row >= len(ends)
    link = row[is_link] - len(ends)
    while True:
        narrow = _face_widths(pieces, bent, face, int(face.max()) + 1) < MIN_WIDTH
        removed = _find_removable_links(face[is_link], narrow, link, length[link])
        if not removed.any():
            break
        beside = face[is_link][removed].T.copy()
        face = _merged_faces(beside[0], beside[1], len(narrow))[face]
    if (face[is_link, 0] == face[is_link, 1]).all():
        return layer
    key = component * (int(layer.max()) + 1) + layer
    unit = np.unique(key, return_inverse=True)[1].ravel()
    unit_layer = np.zeros(int(unit.max()) + 1, np.int64)
    unit_layer[unit] = layer
    result: I64 = _number_units(unit[row[~is_link]], face[~is_link], unit_layer)[unit]
    return result


def _tips_in_wide_faces(stretches: Stretches, tips: I64, count: int) -> I64:
    """Return those of the dangling ends ``tips`` whose cut borders a face that extends at least
    ``MIN_EXTENT`` along X and along Y, (s,).

    ``stretches`` are stretches of ``count`` cuts, and of links.
    """
    if len(tips) == 0:
        return tips
    face = stretches.face
    box = arc.bounding_boxes(stretches.ends[:, 0], stretches.ends[:, 1], stretches.bulge)
    wide = _are_wide(np.ascontiguousarray(face), box, int(face.max()) + 1)
    wide[0] = True
    own = stretches.row < count
    borders = np.zeros(count, np.bool_)
    borders[stretches.row[own & wide[face].any(axis=1)]] = True
    result: I64 = tips[borders[tips // 2]]
    return result


@kernel
def _are_wide(face: I64_2, box: F64_2, count: int) -> Any:
    """Return the mask of the faces that extend at least ``MIN_EXTENT`` along X and Y, (count,).

    ``face`` (m, 2) are the faces beside each of m stretches, and ``box`` (m, 4) mm the bounding
    boxes of the stretches.
    """
    extent = np.full((count, 4), -math.inf)
    for row in range(len(face)):
        for side in range(2):
            own = face[row, side]
            for axis in range(2):
                extent[own, axis] = max(extent[own, axis], -box[row, axis])
                extent[own, axis + 2] = max(extent[own, axis + 2], box[row, axis + 2])
    wide = np.empty(count, np.bool_)
    for own in range(count):
        wide[own] = (
            extent[own, 2] + extent[own, 0] >= MIN_EXTENT
            and extent[own, 3] + extent[own, 1] >= MIN_EXTENT
        )
    return wide


def _find_removable_links(face: I64, narrow: Bool, link: I64, length: F64) -> Bool:
    """Return the mask of the pieces of links to remove, (p,).  Each narrow face loses the longest
    link beside it.

    Several links may cross one neck.  Of the narrow faces between them each loses one link, so that
    at least one link remains across the neck.

    ``face`` (p, 2): faces beside each of p pieces of links.
    ``narrow`` (f,): mask of the faces that are narrower than ``MIN_WIDTH``.
    ``link``, ``length`` (p,) and (p,) mm: index of the link of each piece, and the length of that
    link.
    """
    divides = face[:, 0] != face[:, 1]
    piece = np.repeat(np.arange(len(face)), 2)
    beside = np.where(divides[:, None], face, 0).ravel()
    order = np.lexsort((link[piece], length[piece], beside))
    last = np.append(np.diff(beside[order]) != 0, True)[: len(order)]
    longest = np.full(len(narrow), -1, np.int64)
    longest[beside[order[last]]] = link[piece[order[last]]]
    lost = narrow[beside] & (link[piece] == longest[beside])
    result: Bool = lost.reshape(-1, 2).any(axis=1) & divides
    return result


def _number_units(unit: I64, face: I64, layer: I64) -> I64:
    """Return the new layer of each of u units of work, (u,).

    ``unit``, ``face`` (m,) and (m, 2): unit of each of m stretches, and the faces beside the
    stretch; 0 is the plane outside.
    ``layer`` (u,): layer of each unit.  Units of a higher layer get higher new layers.
    """
    result = np.full(len(layer), -1, np.int64)
    held = np.zeros(int(face.max()) + 1, np.bool_)
    held[0] = True
    by_layer = np.argsort(layer[unit], kind="stable")
    bounds = np.flatnonzero(np.diff(layer[unit][by_layer])) + 1
    number = 0
    for rows in np.split(by_layer, bounds):
        left = rows
        while len(left):
            ready = unit[left[held[face[left]].any(axis=1)]]
            # Nothing holds a piece that only links enclose: make all of its cuts together.
            result[ready if len(ready) else unit[left]] = number
            made = result[unit[left]] == number
            held[face[left[made]]] = True
            left = left[~made]
            number += 1
    return result


def _components(ends: F64, row: I64, count: int) -> I64:
    """Return the connected component of each of ``count`` cuts, (count,).

    ``ends`` and ``row`` are the ends of m stretches of cuts (m, 2, 2) mm, which meet only at their
    ends, and the index of the cut of each stretch (m,).
    """
    points = ends.reshape(-1, 2)
    vertex = number_vertices(points)
    position = np.empty((int(vertex.max()) + 1, 2))
    position[vertex] = points
    found, _ = connected_components(position, vertex[::2].copy(), vertex[1::2].copy())
    component = np.zeros(count, np.int64)
    component[row] = found
    return component


def _face_widths(ends: F64, bulge: F64, face: I64, count: int) -> F64:
    """Return the mean width of each face, (count,) mm: 2 area / perimeter; infinite for face 0.

    ``ends``, ``bulge`` (m, 2, 2) mm and (m,): start and end points, and bulges, of the stretches
    between the faces.
    ``face`` (m, 2): face on the left and on the right of each stretch; 0 is the plane outside.
    """
    start, end = ends[:, 0] - ends[0, 0], ends[:, 1] - ends[0, 0]
    sweep = arc.sweep(bulge)
    bent = np.abs(sweep) > 1e-6
    radius = np.where(bent, arc.radius(start, end, np.where(bent, bulge, 1.0)), 0.0)
    swept = 0.5 * (
        start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0] + radius**2 * (sweep - np.sin(sweep))
    )
    area, perimeter = np.zeros(count), np.zeros(count)
    np.add.at(area, face[:, 0], swept)
    np.subtract.at(area, face[:, 1], swept)
    size = np.where(face[:, 0] != face[:, 1], arc.length(start, end, bulge), 0.0)
    for side in range(2):
        np.add.at(perimeter, face[:, side], size)
    result = 2.0 * area / np.maximum(perimeter, JOIN)
    result[0] = np.inf
    return result


@kernel
def _merged_faces(face_a: I64_1, face_b: I64_1, count: int) -> Any:
    """Return the number of each of ``count`` faces after k pairs of faces were merged, (count,).
    Merged faces get the least of their numbers.  ``face_a`` and ``face_b``, (k,) each, are the
    pairs.
    """
    parent = np.arange(count)
    for k in range(len(face_a)):
        union(parent, face_a[k], face_b[k])
    flatten(parent)
    return parent
