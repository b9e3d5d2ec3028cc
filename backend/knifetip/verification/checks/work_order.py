"""Check that no tool cuts or creases a piece of board that earlier cuts have released.

The cuts divide the sheet into faces (see ``cut_faces``).  A piece of a cut is complete at the
program line that finishes it; until then the two faces beside it are connected.  A face is released
from the sheet at the last line at which a path of connected faces still leads from it to the
outside::

    free(face) = max over all paths from the face to the outside of
                 min over the pieces that the path crosses of complete(piece)

Joining the faces with a union-find in descending order of ``complete`` gives this line for all
faces.  A tip path in a face after that line is a finding.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, I64_1, I64_2, kernel
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import Knife
from knifetip.verification.checks.check_context import DEPTH_TOLERANCE, CheckContext
from knifetip.verification.checks.cut_faces import GAP_LENGTH, CutFaces, find_cut_faces
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.intervals import add_interval
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import cutter_paths
from knifetip.verification.expectation.edges import (
    TOUCH_DISTANCE,
    Edges,
    without_duplicates,
)
from knifetip.verification.expectation.outline import find_outlines
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool

#: Line types that no tool makes.
_NO_WORK: Final = (LineType.UNCLASSIFIED, LineType.IGNORED)


#: A shorter overlap with an edge is a crossing (mm).
_MIN_LENGTH: Final = 0.1


#: Beside a corner of 28° a cutter leaves this many radii of either edge untouched.
_CORNER_RATIO: Final = 4.0


#: Sampled positions on other tip paths, as fractions of their length.
_PROBES: Final = (0.1, 0.5, 0.9)


@dataclass(frozen=True, eq=False, slots=True)
class _WorkedSpans:
    """k stretches of cuts that the tools have cut, sorted by edge and by program line."""

    edge: I64  #: (k,)
    low: F64  #: (k,) mm along the edge
    high: F64  #: (k,)
    line: I64  #: (k,)
    through: Bool  #: (k,) the work goes through the board
    path: I64  #: (k,) row of the tip path
    reach: float  #: mm, the radius of the widest cutter, 0 for knives


def check_work_order(context: CheckContext, work: TipPaths) -> None:
    """Add a finding for each tip path on a piece of board that earlier cuts have released.

    ``work`` are all tip paths of the program, in the order of the program; findings are added to
    ``context``.
    """
    cuts, _, _ = without_duplicates(context.edges.with_types(LineType.CUT))
    if len(cuts) == 0 or len(work.z) == 0:
        return
    faces = find_cut_faces(cuts)
    spans = _worked_spans(context, work, cuts)
    complete = _completing_lines(
        faces.edge, faces.begin, faces.begin + faces.curve[:, 5],
        spans.edge, spans.low, spans.high,
        np.where(spans.through, spans.line, -1), len(cuts), spans.reach,
    )  # fmt: skip
    order = np.argsort(-complete, kind="stable")
    free = _freeing_lines(order, complete, faces.face, faces.count)
    _check_cuts(context, cuts, faces, spans, free)
    _check_other_edges(context, cuts, faces, work, spans, free)


def _check_cuts(
    context: CheckContext, cuts: Edges, faces: CutFaces, spans: _WorkedSpans, free: F64
) -> None:
    """Add a finding for each cut that is made on loose board.

    A long cut consists of several pieces, each beside its own faces of the sheet.  The board under
    a cut stretch counts as loose once all pieces on which the stretch lies are released.  Pieces
    shorter than ``GAP_LENGTH`` are ignored if the stretch also lies on a longer piece.

    Parameters
    ----------
    cuts, faces
        All cuts, and the faces into which they divide the sheet.
    spans
        Stretches of cuts that the tools have cut.
    free
        Program line that releases each face from the sheet, one per face.
    """
    pieces = np.flatnonzero(faces.edge >= 0)
    first = np.searchsorted(faces.edge[pieces], np.arange(len(cuts) + 1))
    face_lines = free[faces.face[pieces]].max(axis=1)
    begin = faces.begin[pieces]
    release_line = _held_until(
        spans.edge, spans.low, spans.high, first, begin, begin + faces.curve[pieces, 5], face_lines
    )
    late = spans.line > release_line
    if spans.reach == 0.0:
        # The overrun of a knife may lie on a cut that is already made.
        overrun = _longest_overrun(context)
        late &= _new_spans(spans.edge, spans.low, spans.high) | (spans.high - spans.low > overrun)
    late_rows = np.flatnonzero(late)
    for k in late_rows[np.unique(spans.edge[late_rows], return_index=True)[1]][:MAX_FINDINGS]:
        edge = int(spans.edge[k])
        place = point_at(
            cuts.curve[edge : edge + 1], np.array([0.5 * (spans.low[k] + spans.high[k])])
        )
        _add_finding(
            context, int(cuts.row[edge]), place[0], int(spans.line[k]), int(release_line[k])
        )


def _longest_overrun(context: CheckContext) -> float:
    """Return the greatest length by which a knife of the machine runs past the end of a cut (mm).

    A blade that is slanted by an angle cuts ahead of its tip by its depth times the tangent of the
    angle.
    """
    depth = context.board.caliper + context.machine.into_mat
    angles = [
        station.tool.blade_angle
        for station in context.machine.stations
        if isinstance(station.tool, Knife)
    ]
    longest = max((math.tan(math.radians(angle)) for angle in angles), default=0.0)
    return depth * longest + context.tolerance


def _check_other_edges(
    context: CheckContext,
    cuts: Edges,
    faces: CutFaces,
    work: TipPaths,
    spans: _WorkedSpans,
    free: F64,
) -> None:
    """Add a finding for each crease, groove, half-cut or perforation that is made on loose board.

    Parameters
    ----------
    cuts, faces
        All cuts, and the faces into which they divide the sheet.
    work
        All tip paths.
    spans
        Stretches of cuts that the tools have cut; their tip paths are skipped here.
    free
        Program line that releases each face from the sheet, one per face.
    """
    after_release = work.line > free.min()
    after_release[spans.path] = False
    rows = np.flatnonzero(after_release)
    kinds = (kind for kind in LineType if kind not in (LineType.CUT, *_NO_WORK))
    edges = context.edges.with_types(*kinds)
    near = find_overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], TOUCH_DISTANCE
    )
    # Drop crossings; a path without length is a pressed crease and stays.
    size = np.diff(near.along)[:, 0]
    long = np.flatnonzero(
        near.best & (size >= np.minimum(_MIN_LENGTH, work.curve[rows[near.curve], 5]))
    )
    path, along = rows[near.curve[long]], near.along[long]
    release_line = np.full(len(long), math.inf)
    place = np.zeros((len(long), 2))
    for fraction in _PROBES:
        points = point_at(work.curve[path], along @ (1.0 - fraction, fraction))
        overlaps = find_overlaps(
            line_curves(points, points),
            cuts.curve,
            np.zeros(len(cuts)),
            cuts.curve[:, 5],
            TOUCH_DISTANCE,
        )
        face_lines = free[faces.locate(points)]
        face_lines[overlaps.curve] = math.inf
        sooner = face_lines < release_line
        release_line[sooner], place[sooner] = face_lines[sooner], points[sooner]
    late = np.flatnonzero(work.line[path] > release_line)
    late = late[np.unique(path[late], return_index=True)[1]]
    for k in late[:MAX_FINDINGS]:
        row = int(edges.row[near.edge[long[k]]])
        _add_finding(context, row, place[k], int(work.line[path[k]]), int(release_line[k]))


def _add_finding(context: CheckContext, edge: int, place: F64, line: int, closed: int) -> None:
    context.findings.add(
        "order",
        Message("verify.loose-piece", x=place[0], y=place[1], line=closed),
        0.0,
        edge=edge,
        line=line,
    )


def _worked_spans(context: CheckContext, work: TipPaths, cuts: Edges) -> _WorkedSpans:
    """Return the stretches of the edges ``cuts`` that the tools have cut.

    ``work`` are all tip paths.  The path of a knife's tip lies on its cut; the path of a cutter's
    centre lies beside its cut.
    """
    size = cuts.curve[:, 5]
    knife = np.flatnonzero(work.operation == OperationKind.CUT)
    near = find_overlaps(
        work.curve[knife], cuts.curve, np.zeros(len(cuts)), size, context.tolerance
    )
    keep = near.best
    columns: list[tuple[I32 | I64, F64, F64, I64, Bool]] = [
        (near.edge[keep], near.place[keep].min(axis=1), near.place[keep].max(axis=1),
         knife[near.curve[keep]], np.ones(int(keep.sum()), np.bool_)),
    ]  # fmt: skip
    mill = work.operation == OperationKind.MILL
    bounds = find_outlines(cuts) if mill.any() else None
    widest = 0.0
    for index in np.unique(work.station[mill]):
        station = context.machine.stations[int(index)]
        assert bounds is not None
        tool = expected_tool(station.tool)
        assert tool.disc is not None
        deflection = next(
            (one for one in context.board.deflection if one.tool == station.name), None
        )
        reach = np.full(2, tool.disc.radius) - ((deflection.x, deflection.y) if deflection else 0.0)
        widest = max(widest, float(reach.max()))
        beside = cutter_paths(bounds, reach)
        rows = np.flatnonzero(mill & (work.station == index))
        length = beside.curve[:, 5]
        near = find_overlaps(
            work.curve[rows], beside.curve, np.zeros(len(length)), length, context.tolerance
        )
        low, high = beside.edge_intervals(near.edge, near.place)
        deep = context.board.caliper - work.z[rows[near.curve]]
        planned = tool.through_depth(context.board.caliper, context.machine.into_mat)
        is_through = deep >= planned - DEPTH_TOLERANCE
        columns.append((beside.edge[near.edge], low, high, rows[near.curve], is_through))
    edge, low, high, path, is_through = (np.concatenate(one) for one in zip(*columns, strict=True))
    # Drop paths that only cross a cut or touch its end.
    long = np.flatnonzero(high - low >= np.minimum(_MIN_LENGTH, 0.5 * size[edge]))
    long = long[np.lexsort((work.line[path[long]], edge[long]))]
    path = path[long].astype(np.int64)
    return _WorkedSpans(
        edge[long].astype(np.int64), low[long], high[long], work.line[path].astype(np.int64),
        is_through[long], path, widest,
    )  # fmt: skip


@kernel
def _completing_lines(
    owner: I64_1, begin: F64_1, end: F64_1, edge: I64_1, low: F64_1, high: F64_1,
    line: I64_1, count: int, reach: float,
) -> Any:  # fmt: skip
    """Return the program line that completes each of p pieces of cuts and links, (p,).

    A link is a straight line that closes a small gap between cuts.  A piece of a cut is complete
    when every length of it that remains uncut is too short to hold the part, such as a length
    beside an inner corner that the disc of a cutter cannot reach.  The line is infinite for a piece
    that is never completed, and -1 for a link.  If the machine has a cutter, the line is 0 for a
    piece that no tool touches: such a piece is out of the disc's reach and does not hold the part.

    Parameters
    ----------
    owner, begin, end : (p,)
        Index of the cut of each piece (-1 for a link), and the piece's start and end on it (mm).
    edge, low, high : (k,)
        Index of the cut of each of k stretches that tools have cut, sorted, and the stretch's start
        and end on it (mm).
    line : (k,)
        Program line of each stretch, -1 if the stretch is not cut through the board.
    count
        Number of cuts.
    reach : mm
        Radius of the widest cutter, 0 if there are only knives.
    """
    first = np.searchsorted(edge, np.arange(count + 1))
    complete = np.full(len(owner), 0.0 if reach > 0.0 else math.inf)
    for p in range(len(owner)):
        if owner[p] < 0:
            complete[p] = -1.0
            continue
        a, b = begin[p], end[p]
        permitted = _CORNER_RATIO * reach if reach > 0.0 else min(GAP_LENGTH, 0.5 * (b - a))
        covered = np.empty((first[owner[p] + 1] - first[owner[p]] + 1, 2))
        many = 0
        for k in range(first[owner[p]], first[owner[p] + 1]):
            left, right = max(low[k], a), min(high[k], b)
            if right <= left:
                continue
            complete[p] = math.inf
            if line[k] < 0:
                continue
            many, _ = add_interval(covered, many, left, right)
            uncovered, position = 0.0, a
            for j in range(many):
                uncovered = max(uncovered, covered[j, 0] - position)
                position = covered[j, 1]
            if max(uncovered, b - position) <= permitted:
                complete[p] = line[k]
                break
    return complete


@kernel
def _new_spans(edge: I64_1, low: F64_1, high: F64_1) -> Any:
    """Return the mask of the stretches of cuts that are not repetitions of earlier stretches, (k,).

    A stretch is no repetition if earlier stretches of its cut cover at most half of it.  ``edge``,
    ``low`` and ``high`` are the index of the cut of each of k stretches, and the stretch's start
    and end on it (mm), sorted by cut and then by program line.
    """
    fresh = np.zeros(len(edge), np.bool_)
    begin = 0
    while begin < len(edge):
        end = begin
        while end < len(edge) and edge[end] == edge[begin]:
            end += 1
        covered = np.empty((end - begin + 1, 2))
        many = 0
        for k in range(begin, end):
            many, gained = add_interval(covered, many, low[k], high[k])
            fresh[k] = gained >= 0.5 * (high[k] - low[k])
        begin = end
    return fresh


@kernel
def _held_until(
    edge: I64_1,
    low: F64_1,
    high: F64_1,
    first: I64_1,
    begin: F64_1,
    end: F64_1,
    release_line: F64_1,
) -> Any:
    """Return the program line at which the board under each of k stretches of cuts is released,
    (k,).

    A cut consists of pieces.  The board under a stretch is released once all pieces on which the
    stretch lies are released.  Pieces shorter than ``GAP_LENGTH`` are ignored if the stretch also
    lies on a longer piece.  The line is infinite for a stretch that lies on no piece.

    Parameters
    ----------
    edge, low, high : (k,)
        Index of the cut of each stretch, and the stretch's start and end on it (mm).
    first
        Index of the first piece of each cut, followed by the number of pieces.
    begin, end, release_line : (p,)
        Start and end of each of p pieces on its cut (mm), and the program line that releases it.
    """
    line = np.full(len(edge), -1.0)
    for k in range(len(edge)):
        for least in (GAP_LENGTH, 0.0):
            for p in range(first[edge[k]], first[edge[k] + 1]):
                shared = min(high[k], end[p]) - max(low[k], begin[p])
                if (
                    shared >= min(_MIN_LENGTH, 0.5 * (end[p] - begin[p]))
                    and end[p] - begin[p] > least
                ):
                    line[k] = max(line[k], release_line[p])
            if line[k] >= 0.0:
                break
        if line[k] < 0.0:
            line[k] = math.inf
    return line


@kernel
def _freeing_lines(order: I64_1, complete: F64_1, face: I64_2, count: int) -> Any:
    """Return the program line that releases each of ``count`` faces from the sheet, (count,).

    The line is infinite for a face that remains connected to face 0, the outside.  A link is a
    straight line that closes a small gap between cuts.

    Parameters
    ----------
    order : (p,)
        Indices of p pieces of cuts and links, in descending order of ``complete``.
    complete : (p,)
        Program line that completes each piece.
    face : (p, 2)
        Indices of the two faces beside each piece.
    count
        Number of faces.
    """
    free = np.full(count, math.inf)
    parent = np.arange(count)
    onward = np.arange(count)
    for p in order:
        if complete[p] <= 0.0:
            # The rest are links and pieces that no cutter reaches; they hold nothing.
            break
        a, b = face[p, 0], face[p, 1]
        while parent[a] != a:
            parent[a] = parent[parent[a]]
            a = parent[a]
        while parent[b] != b:
            parent[b] = parent[parent[b]]
            b = parent[b]
        if a == b:
            continue
        if b == 0:
            a, b = b, a
        if a == 0:
            # All faces of the set of b, a circular list, are released by this piece.
            each = b
            while True:
                free[each] = complete[p]
                each = onward[each]
                if each == b:
                    break
        onward[a], onward[b] = onward[b], onward[a]
        parent[b] = a
    return free
