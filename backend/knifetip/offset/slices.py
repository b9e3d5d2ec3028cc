"""slices: split the raw rows of a region at their intersections, and connect the valid pieces.

Source: our derivation.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from knifetip.geometry.intersect import TOUCH, intersect_rows, point_at_parameter
from knifetip.geometry.spatial_index.box_tree import BoxTree, next_overlap, start_query
from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.kernels import (
    F64_2,
    I64_1,
    OutF64_2,
    OutI64_2,
    inline_kernel,
    kernel,
)
from knifetip.offset.records import JoinedPieces, RawRows, ResultChains, Segment
from knifetip.offset.self_contact import cannot_meet

#: Length of the shortest piece (mm); a shorter one is an intersection that rounding has split.
MIN_PIECE: Final = 1e-7


@kernel
def _follows(rows: F64_2, i: int, j: int) -> bool:
    """Return whether the segment in row i ends at the start of the segment in row j.

    ``rows`` (n, 5) are segments: x0, y0, x1, y1, bulge.
    """
    dx = abs(rows[i, 2] - rows[j, 0])
    dy = abs(rows[i, 3] - rows[j, 1])
    return bool(dx <= TOUCH and dy <= TOUCH)


@inline_kernel
def _segment(rows: F64_2, i: int) -> Segment:
    """Return the segment in row i of ``rows``, (n, 5): x0, y0, x1, y1, bulge."""
    return Segment(rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3], rows[i, 4])


@kernel
def find_cuts(
    raw: RawRows,
    count: int,
    real: int,
    tree: BoxTree,
    stack: OutI64_2,
    crossings: OutF64_2,
) -> tuple[Any, Any, int]:
    """Return the points at which segments are split: their intersections with other segments.

    Parameters
    ----------
    raw, count
        The segments, and their number.
    real
        Number of rows that are split; the rows after them are not split, but split other rows.
    tree
        Tree of the bounding boxes of all rows.
    stack, crossings
        Scratch arrays.

    Returns
    -------
    cut_row : (n,)
        Row of each split point.
    cut_point : (n, 3)
        Parameter of each split point on its row (0 … 1), and its x and y (mm).
    cut_count
        Number of split points; the arrays may be longer.
    """
    rows, _, follow = raw
    cut_row = np.empty(2 * count + 16, np.int64)
    cut_point = np.empty((len(cut_row), 3))
    cut_count = 0
    for i in range(real):
        box = (
            tree.boxes[i, 0] - TOUCH,
            tree.boxes[i, 1] - TOUCH,
            tree.boxes[i, 2] + TOUCH,
            tree.boxes[i, 3] + TOUCH,
        )
        depth = start_query(tree, stack)
        while True:
            j, depth = next_overlap(tree.boxes, tree.level, stack, depth, box, i)
            if j < 0:
                break
            if (follow[i] == j and _follows(rows, i, j)) or (
                j < real and follow[j] == i and _follows(rows, j, i)
            ):
                # Neighbours that continue each other have only their joint in common.
                continue
            if cannot_meet(_segment(rows, i), _segment(rows, j)):
                continue
            hits = intersect_rows(rows, i, rows, j, TOUCH, crossings)
            if cut_count + 2 * hits > len(cut_row):
                cut_row = np.concatenate((cut_row, np.empty_like(cut_row)))
                cut_point = np.concatenate((cut_point, np.empty_like(cut_point)))
            for h in range(hits):
                for side in range(2 if j < real else 1):
                    cut_row[cut_count] = j if side else i
                    cut_point[cut_count, 0] = crossings[h, 2 + side]
                    cut_point[cut_count, 1] = crossings[h, 0]
                    cut_point[cut_count, 2] = crossings[h, 1]
                    cut_count += 1
    return cut_row, cut_point, cut_count


@kernel
def split_rows(
    rows: F64_2, real: int, cut_row: I64_1, cut_point: F64_2, cuts: int
) -> tuple[Any, Any, Any, Any, int]:
    """Return the pieces of the first ``real`` rows, split at given points.

    Parameters
    ----------
    rows : (m, 5)
        Segments: x0, y0, x1, y1, bulge.
    real
        Number of rows to split.
    cut_row : (n,)
        Row of each split point.
    cut_point : (n, 3)
        Parameter of each split point on its row (0 … 1), and its x and y (mm).
    cuts
        Number of split points; the arrays may be longer.

    Returns
    -------
    piece : (q, 6)
        x0, y0, x1 and y1 of each piece, and the parameters of its two ends on the row (0 … 1).
    owner : (q,)
        Row of each piece.
    opening : (real,)
        First piece of each row.
    touched : (real, 2)
        Whether each row is split exactly at its start, and exactly at its end.
    piece_count
        Number of pieces; the arrays may be longer.
    """
    touched = np.zeros((real, 2), np.bool_)
    bound = np.zeros(real + 1, np.int64)
    for c in range(cuts):
        bound[cut_row[c] + 1] += 1
    for i in range(real):
        bound[i + 1] += bound[i]
    order = np.empty(cuts, np.int64)
    filled = bound[:-1].copy()
    for c in range(cuts):
        i = cut_row[c]
        position = filled[i]
        filled[i] += 1
        # Insertion sort: a row has few splits.
        while position > bound[i] and cut_point[order[position - 1], 0] > cut_point[c, 0]:
            order[position] = order[position - 1]
            position -= 1
        order[position] = c
    piece = np.empty((real + cuts, 6))
    owner = np.empty(real + cuts, np.int64)
    piece_count = 0
    for i in range(real):
        dx = rows[i, 2] - rows[i, 0]
        dy = rows[i, 3] - rows[i, 1]
        b = abs(rows[i, 4])
        length = math.sqrt(dx * dx + dy * dy)
        if b >= BULGE:
            length = length * (1.0 + b * b) * math.atan(b) / b
        min_step = MIN_PIECE / length
        bound_first = piece_count
        x, y, parameter = rows[i, 0], rows[i, 1], 0.0
        for o in range(bound[i], bound[i + 1]):
            c = order[o]
            if cut_point[c, 0] - parameter < min_step or 1.0 - cut_point[c, 0] < min_step:
                touched[i, 0] |= cut_point[c, 0] < 2.0 * min_step
                touched[i, 1] |= 1.0 - cut_point[c, 0] < 2.0 * min_step
                continue
            piece[piece_count, 0] = x
            piece[piece_count, 1] = y
            x = cut_point[c, 1]
            y = cut_point[c, 2]
            piece[piece_count, 2] = x
            piece[piece_count, 3] = y
            piece[piece_count, 4] = parameter
            parameter = cut_point[c, 0]
            piece[piece_count, 5] = parameter
            owner[piece_count] = i
            piece_count += 1
        piece[piece_count, 0] = x
        piece[piece_count, 1] = y
        piece[piece_count, 2] = rows[i, 2]
        piece[piece_count, 3] = rows[i, 3]
        piece[piece_count, 4] = parameter
        piece[piece_count, 5] = 1.0
        owner[piece_count] = i
        piece_count += 1
        filled[i] = bound_first
    return piece, owner, filled, touched, piece_count


@kernel
def follow_pieces(pieces: JoinedPieces, follow: I64_1) -> None:
    """Write the successor and the predecessor of each valid piece to ``pieces``.

    The successor of a piece is normally the next piece of the same row or, after the last piece of
    a row, the first piece of the row that follows.  This piece must be valid and start at the end
    of its predecessor, within a small tolerance.  Otherwise the successor is the valid piece that
    has no predecessor and whose start is nearest to this end, within the same tolerance.  If there
    is no such piece, the successor is -1.

    Parameters
    ----------
    pieces
        The pieces; their columns of successors and predecessors are written.
    follow
        Successor of each row, -1 for none.
    """
    piece, owner, opening, _, good, after, prior = pieces
    count = len(good)
    near = 10.0 * MIN_PIECE
    for q in range(count):
        after[q] = -1
        prior[q] = -1
    for q in range(count):
        if not good[q]:
            continue
        if q + 1 < count and owner[q + 1] == owner[q]:
            n = q + 1
        elif follow[owner[q]] >= 0:
            n = opening[follow[owner[q]]]
        else:
            continue
        if (
            good[n]
            and abs(piece[n, 0] - piece[q, 2]) <= near
            and abs(piece[n, 1] - piece[q, 3]) <= near
        ):
            after[q] = n
            prior[n] = q
    loose = 0
    for q in range(count):
        if good[q] and prior[q] < 0:
            loose += 1
    if loose == 0:
        return
    begins = np.empty(loose, np.int64)
    start_x = np.empty(loose)
    loose = 0
    for q in range(count):
        if good[q] and prior[q] < 0:
            begins[loose] = q
            start_x[loose] = piece[q, 0]
            loose += 1
    order = np.argsort(start_x)
    start_x = start_x[order]
    for q in range(count):
        if not good[q] or after[q] >= 0:
            continue
        best = near
        chosen = -1
        place = np.searchsorted(start_x, piece[q, 2] - near)
        while place < loose and start_x[place] <= piece[q, 2] + near:
            n = begins[order[place]]
            if prior[n] < 0:
                away = math.hypot(piece[n, 0] - piece[q, 2], piece[n, 1] - piece[q, 3])
                if away <= best:
                    best = away
                    chosen = n
            place += 1
        if chosen >= 0:
            after[q] = chosen
            prior[chosen] = q


@kernel
def drop_copies(rows: F64_2, pieces: JoinedPieces) -> bool:
    """Mark valid pieces that lie on other valid pieces as invalid; return whether there are any.

    Where two contours meet at a corner, the tool goes round both corners on one arc.  Of two equal
    pieces with the same direction, the first one remains.

    Parameters
    ----------
    rows : (m, 5)
        The segments of which the pieces are parts: x0, y0, x1, y1, bulge.
    pieces
        The pieces; copies are marked in place.
    """
    piece, owner, good = pieces.piece, pieces.owner, pieces.good
    near = 10.0 * MIN_PIECE
    valid = np.flatnonzero(good)
    order = valid[np.argsort(piece[valid, 0], kind="mergesort")]
    found = False
    for place in range(len(order)):
        q = order[place]
        if not good[q]:
            continue
        for later in range(place + 1, len(order)):
            n = order[later]
            if piece[n, 0] - piece[q, 0] > near:
                break
            apart = 0.0
            for c in range(4):
                apart = max(apart, abs(piece[n, c] - piece[q, c]))
            if not good[n] or apart > near:
                continue
            x, y = point_at_parameter(rows, owner[q], 0.5 * (piece[q, 4] + piece[q, 5]))
            to_x, to_y = point_at_parameter(rows, owner[n], 0.5 * (piece[n, 4] + piece[n, 5]))
            if math.hypot(to_x - x, to_y - y) <= near:
                good[n] = False
                found = True
    return found


@kernel
def link_chains(raw: RawRows, pieces: JoinedPieces, out: ResultChains) -> int:
    """Connect valid pieces into chains, write the chains to ``out`` and return how many there are.

    Parameters
    ----------
    raw
        The rows of which the pieces are parts.
    pieces
        The pieces, with their successors and predecessors.
    out
        Receives the segments of the chains, chain after chain.
    """
    rows, info, _ = raw
    piece, owner, _, _, good, after, prior = pieces
    count = len(good)
    line, tag, first, ring = out
    done = 0
    chains = 0
    used = np.zeros(count, np.bool_)
    for round_ in range(2):
        for begin in range(count):
            if not good[begin] or used[begin] or (round_ == 0 and prior[begin] >= 0):
                continue
            first[chains] = done
            q = begin
            last = -1
            while q >= 0 and not used[q]:
                used[q] = True
                i = owner[q]
                if last >= 0 and owner[last] == i and q == last + 1:
                    # The row was split here without effect: extend the last row.
                    line[done - 1, 2] = piece[q, 2]
                    line[done - 1, 3] = piece[q, 3]
                    line[done - 1, 4] += piece[q, 5] - piece[q, 4]
                else:
                    for c in range(4):
                        line[done, c] = piece[q, c]
                    line[done, 4] = piece[q, 5] - piece[q, 4]
                    tag[done, 0] = info[i, 0]
                    tag[done, 1] = info[i, 1]
                    tag[done, 2] = info[i, 3]
                    tag[done, 3] = i
                    done += 1
                last = q
                q = after[q]
            closed = q == begin
            low = first[chains]
            if (
                closed
                and done - low > 1
                and tag[low, 3] == tag[done - 1, 3]
                and piece[begin, 4] > 0.0
                and begin == last + 1
            ):
                line[low, 0] = line[done - 1, 0]
                line[low, 1] = line[done - 1, 1]
                line[low, 4] += line[done - 1, 4]
                done -= 1
            done = _finish_chain(rows, line, tag, low, done, closed)
            if done > low:
                ring[chains] = closed
                chains += 1
    first[chains] = done
    return chains


@kernel
def _finish_chain(
    rows: F64_2, line: OutF64_2, tag: OutI64_2, low: int, high: int, closed: bool
) -> int:
    """Set the bulges of a chain's segments, remove tiny segments, and close rounding gaps.

    The function changes ``line`` and ``tag``; the remaining segments are moved to the first rows of
    the chain.

    ``rows`` (m, 5): the raw rows of which the segments are parts: x0, y0, x1, y1, bulge.
    ``line`` (r, 5): segments of all chains: x0, y0, x1, y1, and in the last column the length of
    the segment as a fraction of its raw row.  The function replaces this fraction by the bulge.
    ``tag`` (r, 4): for each segment its contour segment, whether it belongs to a transition, its
    path, and its raw row.
    ``low``, ``high``: the chain has the segments low … high - 1.
    ``closed``: whether the chain is closed.
    Returns index after the last remaining segment of the chain; ``low`` if no segments remain.
    """
    done = low
    for r in range(low, high):
        b = rows[tag[r, 3], 4]
        if line[r, 4] < 1.0 - 1e-15 and b != 0.0:
            b = math.tan(math.atan(b) * line[r, 4])
        if abs(b) < 1.0 and math.hypot(line[r, 2] - line[r, 0], line[r, 3] - line[r, 1]) < POINT:
            continue
        for c in range(4):
            line[done, c] = line[r, c]
            tag[done, c] = tag[r, c]
        line[done, 4] = b
        if done > low:
            line[done, 0] = line[done - 1, 2]
            line[done, 1] = line[done - 1, 3]
        done += 1
    if done > low and closed:
        if done - low == 1:
            return low
        line[low, 0] = line[done - 1, 2]
        line[low, 1] = line[done - 1, 3]
    return done
