"""last_cuts: choose which of the cuts round a piece of board come last.

Several tracks may release a piece of board together, such as the stretches of an outline between
nicks, or lines that cross each other.  Until the last of them begins, board holds the piece in at
least two places.  So the last one should be short: a track that is more than ``LONG`` times as long
as the shortest track round a piece comes before that shortest track.

A track that goes round a piece may lie between this piece and others, which earlier cuts have
separated from the sheet.  It should end where the sheet itself lies beside it: elsewhere the cutter
would divide two pieces of which the sheet holds neither.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.union_find import find, union
from knifetip.kernels import I64_1, I64_2, kernel
from knifetip.planning.stretches import Stretches

#: A track that is more than this many times as long as the shortest track round a piece does not
#: release the piece.
LONG: Final = 1.5


def track_levels(layer: I64, stretches: Stretches, track: I64, length: F64) -> I64:
    """Return the level of each of t tracks, (t,).  Within a layer, tracks of lower levels are made
    first.

    Parameters
    ----------
    layer : (n,)
        Layer of each cut; the cuts of higher layers are made first.
    stretches
        Stretches of the n cuts and of links.
    track : (n,)
        Track that makes each cut, -1 for a cut that this function disregards.
    length : (t,) mm
        Length of each track.
    """
    level = np.zeros(len(length), np.int64)
    own = np.flatnonzero(stretches.row < len(layer))
    row = stretches.row[own]
    order = np.argsort(layer[row], kind="stable")
    own, row = own[order], row[order]
    piece, count = _released_pieces(layer[row], stretches.face[own])
    beside = np.repeat(track[row], 2)
    known = (piece.ravel() >= 0) & (beside >= 0)
    piece, beside = piece.ravel()[known], beside[known]
    least = np.full(count, np.inf)
    np.minimum.at(least, piece, length[beside])
    long = length[beside] > LONG * least[piece]
    if not long.any():
        return level
    is_shortest = length[beside] == least[piece]
    shortest = np.full(count, -1, np.int64)
    np.maximum.at(shortest, piece[is_shortest], beside[is_shortest])
    before, after = beside[long], shortest[piece[long]]
    # Each track is longer than the tracks that it precedes, so this ends.
    while (level[after] <= level[before]).any():
        np.maximum.at(level, after, level[before] + 1)
    return level


def releasing_cuts(rank: I64, stretches: Stretches) -> Bool:
    """Return the mask of the cuts that release a piece of board, (n,).  When such a cut is made, a
    piece of board lies on one side along its whole length, and board that the sheet holds lies on
    the other side.

    Parameters
    ----------
    rank : (n,)
        Place of each cut in the order of the cuts; the cuts of higher ranks are made first.
    stretches
        Stretches of the n cuts and of links.
    """
    own = np.flatnonzero(stretches.row < len(rank))
    row = stretches.row[own]
    order = np.argsort(rank[row], kind="stable")
    own, row = own[order], row[order]
    piece, _ = _released_pieces(rank[row], stretches.face[own])
    result = np.ones(len(rank), np.bool_)
    result[row[(piece >= 0).sum(axis=1) != 1]] = False
    return result


@kernel
def _released_pieces(layer: I64_1, face: I64_2) -> Any:
    """Return the pieces that each of m stretches of cuts releases, (m, 2), and their number.

    While the cuts of a layer are made, those of lower layers are still uncut and connect the faces
    on their two sides.  The pieces are the sets of connected faces that are not connected with the
    plane outside.  The entry is -1 where a stretch borders no such piece, or the same piece on both
    sides.

    ``layer`` (m,): layer of each stretch, ascending.
    ``face`` (m, 2): faces on the two sides of each stretch; 0 is the plane outside.
    """
    faces = 0
    for k in range(len(face)):
        faces = max(faces, face[k, 0] + 1, face[k, 1] + 1)
    parent = np.arange(faces)
    number, seen = np.empty(faces, np.int64), np.full(faces, -1)
    piece = np.full(face.shape, -1)
    count = begin = 0
    while begin < len(layer):
        end = begin
        while end < len(layer) and layer[end] == layer[begin]:
            roots = find(parent, face[end, 0]), find(parent, face[end, 1])
            for side in range(2):
                root = roots[side]
                if root == 0 or roots[0] == roots[1]:
                    continue
                if seen[root] != layer[begin]:
                    seen[root], number[root] = layer[begin], count
                    count += 1
                piece[end, side] = number[root]
            end += 1
        for k in range(begin, end):
            union(parent, face[k, 0], face[k, 1])
        begin = end
    return piece, count
