"""Check that a program works the inside of a piece of board before the cuts that release the piece.

The cuts divide the sheet into faces (see ``cut_faces``).  A piece of a cut is complete at the
program line that finishes it; until then the two faces beside it are connected.  A face is released
from the sheet at the last line at which a path of connected faces still leads from it to the
outside::

    free(face) = max over all paths from the face to the outside of
                 min over the pieces that the path crosses of complete(piece)

Joining the faces with a union-find in descending order of ``complete`` gives this line for all
faces.  A tip path in a face after that line is a finding.  The same calculation gives two more
lines.  With links across necks, and cuts that are complete up to their bridges, it gives the line
from which a piece hangs on necks and bridges only; a contour inside the piece must not be cut
later.  With the first cut of each border between two faces in place of ``complete``, it gives the
line that begins the outline of a face; no crease, groove, half-cut or perforation in the face may
follow.

The disc of a cutter also closes mouths that are narrower than the disc; ``milled_loops`` finds the
paths of discs that follow a closed path round them.
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
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.order.cut_faces import (
    GAP_LENGTH,
    CutFaces,
    faces_between,
    find_dangling_ends,
    gap_links,
)
from knifetip.verification.checks.order.milled_loops import loose_lines
from knifetip.verification.checks.order.neck_faces import (
    NECK_WIDTH,
    cut_components,
    find_neck_faces,
)
from knifetip.verification.checks.order.worked_spans import (
    MIN_LENGTH,
    WorkedSpans,
    completing_lines,
    find_worked_spans,
    first_lines,
    new_spans,
)
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.expectation.edges import (
    TOUCH_DISTANCE,
    Edges,
    without_duplicates,
)
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

#: Line types that no tool makes.
_NO_WORK: Final = (LineType.UNCLASSIFIED, LineType.IGNORED)


#: Sampled positions on other tip paths, as fractions of their length.
_PROBES: Final = (0.1, 0.5, 0.9)


#: A knife stops before a bridge, and starts after it, at most this far from its ends (mm).
_STOP_LENGTH: Final = 1.0


@dataclass(frozen=True, eq=False, slots=True)
class _Rule:
    """A program line for each face of the sheet, after which a face must not be worked."""

    faces: CutFaces
    line: F64  #: one per face, infinite if the face may always be worked
    code: str  #: code of the message about work after this line


def check_work_order(context: CheckContext, work: TipPaths) -> None:
    """Add a finding for each tip path on a piece of board that earlier cuts have released.

    ``work`` are all tip paths of the program, in the order of the program; findings are added to
    ``context``.
    """
    cuts, _, _ = without_duplicates(context.edges.with_types(LineType.CUT))
    if len(cuts) == 0 or len(work.z) == 0:
        return
    tips = find_dangling_ends(cuts)
    gaps = gap_links(cuts, tips, GAP_LENGTH)
    faces = faces_between(cuts, gaps)
    spans = find_worked_spans(context, work, cuts)
    rest = 0.0 if spans.reach > 0.0 else GAP_LENGTH
    complete = completing_lines(faces, spans, len(cuts), rest)
    loose = _Rule(faces, _release_lines(faces, complete), "verify.loose-piece")
    necks = find_neck_faces(cuts, faces, gaps, tips)
    widest = max([context.board.bridge_width, *(one.width for one in context.bridges)])
    bridge = widest + 2.0 * max(spans.reach, _STOP_LENGTH)
    complete = completing_lines(necks, spans, len(cuts), max(NECK_WIDTH, bridge))
    hanging = _Rule(necks, _release_lines(necks, complete), "verify.hanging-piece")
    begun = _release_lines(faces, first_lines(faces, spans, len(cuts)))
    reported = _check_cuts(context, cuts, loose, spans)
    reported = np.union1d(reported, _check_milled_loops(context, cuts, work, spans, reported))
    _check_contours(context, cuts, hanging, spans, reported)
    _check_other_edges(
        context, cuts, work, spans, (loose, hanging, _Rule(faces, begun, "verify.outline-begun"))
    )


def _release_lines(faces: CutFaces, complete: F64) -> F64:
    """Return the program line that releases each face from the sheet, one per face.

    ``complete`` is the program line that completes each piece of a cut and each link, (p,).
    """
    order = np.argsort(-complete, kind="stable")
    result: F64 = _freeing_lines(order, complete, faces.face, faces.count)
    return result


def _check_cuts(context: CheckContext, cuts: Edges, loose: _Rule, spans: WorkedSpans) -> I64:
    """Add a finding for each cut that is made on loose board; return the indices of these cuts.

    A long cut consists of several pieces, each beside its own faces of the sheet.  The board under
    a cut stretch counts as loose once all pieces on which the stretch lies are released.  Pieces
    shorter than ``GAP_LENGTH`` are ignored if the stretch also lies on a longer piece.

    ``loose``: the faces into which the cuts divide the sheet, and the line that releases each face.
    ``spans``: stretches of cuts that the tools have cut.
    """
    faces = loose.faces
    pieces = np.flatnonzero(faces.edge >= 0)
    first = np.searchsorted(faces.edge[pieces], np.arange(len(cuts) + 1))
    face_lines = np.maximum(*loose.line[faces.face[pieces].T])
    begin = faces.begin[pieces]
    release_line = _held_until(
        spans.edge, spans.low, spans.high, first, begin, begin + faces.curve[pieces, 5], face_lines
    )
    return _report_late_cuts(context, cuts, loose.code, spans, release_line)


def _check_milled_loops(
    context: CheckContext, cuts: Edges, work: TipPaths, spans: WorkedSpans, reported: I64
) -> I64:
    """Add a finding for each cut that is milled inside a closed path that an earlier line closes;
    return the indices of these cuts.

    ``work``: all tip paths.
    ``spans``: stretches of cuts that the tools have cut.
    ``reported``: indices of the cuts that get no further finding.
    """
    if spans.reach == 0.0:
        return reported
    lines, released = loose_lines(work, context.machine, context.board)
    place = np.searchsorted(lines, spans.line).clip(max=len(lines) - 1)
    unlimited = (lines[place] != spans.line) | np.isin(spans.edge, reported)
    limit = np.where(unlimited, math.inf, released[place])
    return _report_late_cuts(context, cuts, "verify.loose-piece", spans, limit)


def _check_contours(
    context: CheckContext, cuts: Edges, hanging: _Rule, spans: WorkedSpans, reported: I64
) -> None:
    """Add a finding for each contour or slit that is cut in a piece of board that hangs on necks.

    Cuts that are connected with each other count as one: they may be cut until the last of the
    pieces beside them hangs on necks only.

    ``hanging``: the faces into which the cuts and links across necks divide the sheet, and the line
    from which each face hangs on necks or bridges only.
    ``spans``: stretches of cuts that the tools have cut.
    ``reported``: indices of the cuts that get no further finding.
    """
    faces = hanging.faces
    component = cut_components(cuts, faces)
    pieces = np.flatnonzero(faces.edge >= 0)
    held_until = np.full(len(cuts), -math.inf)
    np.maximum.at(
        held_until,
        component[faces.edge[pieces]],
        np.maximum(*hanging.line[faces.face[pieces].T]),
    )
    limit = held_until[component]
    limit[reported] = math.inf
    _report_late_cuts(context, cuts, hanging.code, spans, limit[spans.edge])


def _report_late_cuts(
    context: CheckContext, cuts: Edges, code: str, spans: WorkedSpans, limit: F64
) -> I64:
    """Add a finding for the first stretch of each cut that is made after its limit; return the
    indices of these cuts.

    ``limit`` is the last program line at which each of the k stretches ``spans`` may be cut, (k,);
    ``code`` is the code of the message.
    """
    late = spans.line > limit
    if late.any():
        late &= ~_touches_again(context, spans)
    late_rows = np.flatnonzero(late)
    late_cuts, first = np.unique(spans.edge[late_rows], return_index=True)
    for k in late_rows[first][:MAX_FINDINGS]:
        edge = int(spans.edge[k])
        place = point_at(
            cuts.curve[edge : edge + 1], np.array([0.5 * (spans.low[k] + spans.high[k])])
        )
        _add_finding(
            context, code, int(cuts.row[edge]), place[0], (int(spans.line[k]), int(limit[k]))
        )
    return late_cuts


def _touches_again(context: CheckContext, spans: WorkedSpans) -> Bool:
    """Return the mask of the stretches on which a tool only touches a cut that is already made,
    (k,).

    The overrun of a knife may lie on such a cut.  A disc may touch one in passing, mostly on its
    way round a corner of another contour: the arc of the centre with the radius R stays within the
    tolerance t of a line over at most 4 √(R t).
    """
    size = spans.high - spans.low
    if spans.reach == 0.0:
        short = size <= _longest_overrun(context)
    else:
        short = size <= 4.0 * math.sqrt(spans.reach * context.tolerance)
        short &= size < 0.5 * spans.travel
    again: Bool = short & ~new_spans(spans.edge, spans.low, spans.high, spans.through)
    return again


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
    work: TipPaths,
    spans: WorkedSpans,
    rules: tuple[_Rule, ...],
) -> None:
    """Add a finding for each crease, groove, half-cut or perforation that is made too late.

    ``work``: all tip paths; those of routers and lasers are skipped here.
    ``spans``: stretches of cuts that the tools have cut; their tip paths are skipped, too.
    ``rules``: the program lines after which the faces must not be worked.  Of several rules that a
    path breaks the first one is reported.
    """
    checked = work.line > min(rule.line.min() for rule in rules)
    checked[spans.path] = False
    # A router or a laser makes cuts only; its leads may cross a crease.
    checked[work.operation == OperationKind.MILL] = False
    rows = np.flatnonzero(checked)
    if len(rows) == 0:
        return
    kinds = (kind for kind in LineType if kind not in (LineType.CUT, *_NO_WORK))
    edges = context.edges.with_types(*kinds)
    near = edges.find_overlaps(work.curve[rows], TOUCH_DISTANCE)
    # Drop crossings; a path without length is a pressed crease and stays.
    size = np.diff(near.along)[:, 0]
    long = np.flatnonzero(
        near.best & (size >= np.minimum(MIN_LENGTH, work.curve[rows[near.curve], 5]))
    )
    path, along = rows[near.curve[long]], near.along[long]
    line = work.line[path]
    probes = [
        point_at(work.curve[path], along @ (1.0 - fraction, fraction)) for fraction in _PROBES
    ]
    on_cut = [_touches(points, cuts) for points in probes]
    reported = np.zeros(len(work.line), np.bool_)
    for rule in rules:
        limit, place = np.full(len(path), math.inf), np.zeros((len(path), 2))
        for points, touching in zip(probes, on_cut, strict=True):
            face_lines = np.where(touching, math.inf, rule.line[rule.faces.locate(points)])
            sooner = face_lines < limit
            limit[sooner], place[sooner] = face_lines[sooner], points[sooner]
        late = np.flatnonzero((line > limit) & ~reported[path])
        late = late[np.unique(path[late], return_index=True)[1]]
        reported[path[late]] = True
        for k in late[:MAX_FINDINGS]:
            row = int(edges.row[near.edge[long[k]]])
            _add_finding(context, rule.code, row, place[k], (int(line[k]), int(limit[k])))


def _touches(points: F64, cuts: Edges) -> Bool:
    """Return the mask of the points, (m, 2) mm, that lie on a cut, (m,)."""
    result = np.zeros(len(points), np.bool_)
    result[cuts.touched_by_points(points, TOUCH_DISTANCE).curve] = True
    return result


def _add_finding(
    context: CheckContext, code: str, edge: int, place: F64, lines: tuple[int, int]
) -> None:
    """Add a finding about an edge that is worked at a point, (2,) mm, in the first program line of
    ``lines``, after the second one.
    """
    line, limit = lines
    own_limit = limit - context.lines_before
    message = Message("verify.released-before", x=place[0], y=place[1])
    if own_limit > 0:
        message = Message(code, x=place[0], y=place[1], line=own_limit)
    context.findings.add("order", message, 0.0, edge=edge, line=line)


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

    ``edge``, ``low``, ``high`` (k,): index of the cut of each stretch, and the stretch's start and
    end on it (mm).
    ``first``: index of the first piece of each cut, followed by the number of pieces.
    ``begin``, ``end``, ``release_line`` (p,): start and end of each of p pieces on its cut (mm),
    and the program line that releases it.
    """
    line = np.full(len(edge), -1.0)
    for k in range(len(edge)):
        for least in (GAP_LENGTH, 0.0):
            for p in range(first[edge[k]], first[edge[k] + 1]):
                shared = min(high[k], end[p]) - max(low[k], begin[p])
                if (
                    shared >= min(MIN_LENGTH, 0.5 * (end[p] - begin[p]))
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

    ``order`` (p,): indices of p pieces of cuts and links, in descending order of ``complete``.
    ``complete`` (p,): program line that completes each piece.
    ``face`` (p, 2): indices of the two faces beside each piece.
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
