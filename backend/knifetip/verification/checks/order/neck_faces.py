"""Find the pieces of board that hang on necks only, after the cuts round them are made.

A neck is board at most ``NECK_WIDTH`` wide between a dangling end of a cut and another cut.  A
straight link across each neck divides the sheet further than ``cut_faces`` does.  A piece that is
not wider than ``MIN_WIDTH``, such as the waste between two parts, is not regarded as hanging.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.verification.checks.order.cut_faces import (
    GAP_LENGTH,
    CutFaces,
    faces_between,
    gap_links,
)
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    Edges,
    pairs_within,
)
from knifetip.verification.expectation.outline import lowest_connected, swept_areas

#: Greatest width of a neck (mm).
NECK_WIDTH: Final = 4.0


#: Least mean width of a piece of board that hangs on necks (mm).
MIN_WIDTH: Final = 12.0


def find_neck_faces(cuts: Edges, faces: CutFaces, gaps: F64, tips: I64) -> CutFaces:
    """Return the faces into which cuts and links across necks divide the sheet.

    Parameters
    ----------
    cuts
        All cuts.
    faces
        The faces of the cuts with links across gaps only.  They are returned if there are no necks.
    gaps : (k, 6)
        The links across gaps, as rows of six numbers (see ``curves.curve``).
    tips : (t,)
        Indices of the dangling ends of the cuts; cut i has the ends 2i and 2i + 1.
    """
    links = gap_links(cuts, tips[_borders_large_face(faces, len(cuts))[tips // 2]], NECK_WIDTH)
    links = links[links[:, 5] > GAP_LENGTH]
    if len(links) == 0:
        return faces
    links = np.concatenate([gaps, links])
    divided = faces_between(cuts, links)
    removed = _removed_links(cuts, divided, links)
    while len(removed):
        name = lowest_connected(divided.face[removed, 0], divided.face[removed, 1], divided.count)
        divided = replace(divided, face=name[divided.face])
        removed = _removed_links(cuts, divided, links)
    return divided


def _borders_large_face(faces: CutFaces, count: int) -> Bool:
    """Return the mask of the ``count`` cuts beside the outside or beside a face in which a piece
    with a mean width of ``MIN_WIDTH`` has room, (count,).

    The perimeter of a piece is at least twice the diagonal of its bounding box.  Therefore its mean
    width, 2 area / perimeter, is at most the area of the box over the diagonal.
    """
    curve = faces.curve
    start, end = point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])
    reach = np.where(curve[:, 0] == 0.0, 0.0, curve[:, 3])[:, None]
    middle = np.where(reach > 0.0, curve[:, 1:3], start)
    low = np.minimum(np.minimum(start, end), middle - reach)
    high = np.maximum(np.maximum(start, end), middle + reach)
    size = np.zeros((faces.count, 2))
    for axis in range(2):
        least, greatest = np.full(faces.count, np.inf), np.full(faces.count, -np.inf)
        for side in range(2):
            np.minimum.at(least, faces.face[:, side], low[:, axis])
            np.maximum.at(greatest, faces.face[:, side], high[:, axis])
        size[:, axis] = greatest - least
    large = size.prod(axis=1) >= MIN_WIDTH * np.hypot(*size.T)
    large[0] = True
    result = np.zeros(count, np.bool_)
    own = faces.edge >= 0
    left, right = faces.face.T
    result[faces.edge[own & (large[left] | large[right])]] = True
    return result


def _removed_links(cuts: Edges, faces: CutFaces, links: F64) -> I64:
    """Return the indices of the pieces of links that are removed because of a narrow face, (r,).

    A narrow face whose links connect at most two components of cuts lies within one neck; it keeps
    all links but the longest.  A narrow face between more components keeps none.

    ``cuts``, ``faces``: all cuts, and the faces into which they and the links divide the sheet.
    ``links`` (k, 6): the links, as rows of six numbers (see ``curves.curve``).
    """
    component = cut_components(cuts, faces)
    cut_pieces = np.flatnonzero(faces.edge >= 0)
    link_pieces = np.flatnonzero((faces.edge < 0) & (faces.face[:, 0] != faces.face[:, 1]))
    link_ends = _curve_ends(links)
    at, end = pairs_within(link_ends, _curve_ends(faces.curve[cut_pieces]), JOIN_DISTANCE)
    joined = np.full(len(link_ends), -1, np.int64)
    joined[at] = component[faces.edge[cut_pieces[end // 2]]]
    narrow = _mean_widths(faces) < MIN_WIDTH
    row = np.repeat(link_pieces, 2)
    beside = faces.face[link_pieces].ravel()
    row, beside = row[narrow[beside]], beside[narrow[beside]]
    number = -1 - faces.edge[row]
    longest = np.zeros(faces.count)
    np.maximum.at(longest, beside, links[number, 5])
    lowest, highest = np.full(faces.count, len(cuts)), np.full(faces.count, -1)
    for one in joined.reshape(-1, 2)[number].T:
        np.minimum.at(lowest, beside, one)
        np.maximum.at(highest, beside, one)
    crowded = np.zeros(faces.count, np.bool_)
    for one in joined.reshape(-1, 2)[number].T:
        crowded[beside[(one != lowest[beside]) & (one != highest[beside])]] = True
    # Of equally long links the one with the highest number is removed.
    candidate = np.where(links[number, 5] == longest[beside], number, -1)
    chosen = np.full(faces.count, -1)
    np.maximum.at(chosen, beside, candidate)
    return np.unique(row[crowded[beside] | (number == chosen[beside])])


def _curve_ends(curve: F64) -> F64:
    """Return the start and the end of each of n curves, (2n, 2) mm."""
    ends = [point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])]
    return np.stack(ends, axis=1).reshape(-1, 2)


def cut_components(cuts: Edges, faces: CutFaces) -> I64:
    """Return the number of the connected component of each of n cuts, (n,); links connect nothing.

    ``faces`` contains the pieces into which the cuts are split where they meet.
    """
    piece = np.flatnonzero(faces.edge >= 0)
    edge = faces.edge[piece]
    if len(faces.pieces) == len(piece) == len(faces.edge):
        # The faces were found from the same pairs of ends.
        a, b = faces.pieces.near_ends(JOIN_DISTANCE)
    else:
        ends = _curve_ends(faces.curve[piece])
        a, b = pairs_within(ends, ends, JOIN_DISTANCE)
    return lowest_connected(edge[a // 2], edge[b // 2], len(cuts))


def _mean_widths(faces: CutFaces) -> F64:
    """Return the mean width of each face, one per face (mm); infinite for face 0, the outside.

    The mean width is twice the area over the perimeter, both without the faces inside the face.
    """
    row, pieces = faces.unique, faces.pieces
    node = lowest_connected(*pieces.near_ends(JOIN_DISTANCE), 2 * len(pieces))
    swept = swept_areas(pieces, node)
    left, right = faces.face[row].T
    divides = left != right
    doubled, border = np.zeros(faces.count), np.zeros(faces.count)
    for side, sign in ((left, 1.0), (right, -1.0)):
        np.add.at(doubled, side[divides], sign * swept[divides])
        np.add.at(border, side[divides], pieces.curve[divides, 5])
    result: F64 = doubled / np.maximum(border, JOIN_DISTANCE)
    result[0] = np.inf
    return result
