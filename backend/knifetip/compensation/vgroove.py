"""vgroove: keep the tip of a V-cutter on the groove's centre line.

The blade is tilted, so its tip is off the axis of the head.  Two passes, forth and back with the
head turned by half a turn between them, make two slanted cuts that meet and remove a V of board.  A
groove that ends at the board's edge continues until its whole width has left the board
(``Operation.run_out``).

Source: Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker", sections 3, 4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from knifetip.compensation.tracks import Strokes
from knifetip.errors import CurvedGroove, EdgeTooShort, GrooveTooDeep
from knifetip.geometry.azimuth import azimuth, right_normal, turn_angle, unit_vectors
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import BULGE
from knifetip.kernels import F64_1, F64_2, I32_1, kernel
from knifetip.model.operation import End, Operation
from knifetip.model.tool import VCutter
from knifetip.model.toolpath import Motion, Toolpath


def head_offset(start: F64, end: F64, cutter: VCutter) -> F64:
    """Return the position of the head relative to the tip in the first pass, (n, 2) mm.

    With β the azimuth from start to end::

        Δx =  d sin β + r cos β
        Δy = -d cos β + r sin β

    that is, d to the right of travel and r ahead.  In the second pass the position is -Δ.

    Parameters
    ----------
    start, end : (n, 2) float64, mm
        Ends of each edge, in the order of travel.
    cutter : VCutter
        Its ``back`` is d, the distance of tip and head axis across the cutting edge; its
        ``half_width`` is r, their distance along the cutting edge.

    Raises
    ------
    ZeroLengthEdge
        An edge shorter than ``tolerance.POINT`` has no azimuth.

    Notes
    -----
    Source: Yang, Du, Shu & Qian, "Study on tool compensation of NC carton samplemaker", eqs 4.2 a
    and b.  With A and B the ends of an edge, points 1 to 4 of the paper's figure 3 are A + Δ,
    B + Δ, B - Δ, A - Δ.  In the paper's text r is half the width, in its listing the width (hence
    ``0.5*r``); here it is half the width.

    Examples
    --------
    >>> head_offset(np.array([[0.0, 0.0]]), np.array([[100.0, 0.0]]), VCutter(4.0, 1.5, 45.0))
    array([[ 1.5, -4. ]])
    """
    ahead = unit_vectors(end - start)
    offset: F64 = cutter.back * right_normal(ahead) + cutter.half_width * ahead
    return offset


def sideways_move(start: F64, end: F64, cutter: VCutter, rise: F64) -> F64:
    """Return the sideways movement of the head while the tip rises, (n, 2) mm.

    The tip moves along the tilted blade, so the head moves by Δz tan θ to the right of travel when
    it lifts and to the left when it plunges.  Source: the "oblique angle" of the three-axis
    interpolation in section 3 of Yang, Du, Shu & Qian, "Study on tool compensation of NC carton
    samplemaker".

    Parameters
    ----------
    start, end : (n, 2) mm
        Ends of each edge, in the order of travel.
    cutter
        V-cutter with tilt θ.
    rise : (n,) mm
        Δz, the height by which the tip rises.
    """
    offset: F64 = cutter.slope * rise[:, None] * right_normal(unit_vectors(end - start))
    return offset


@dataclass(frozen=True, slots=True)
class GrooveSection:
    """Cross-section of a V-groove: included angle, width and remaining thickness of the board."""

    included: float  #: angle between the flanks, which is the largest fold angle (degrees)
    width: float  #: width at the top face of the board (mm)
    web: float  #: thickness of the board left below the groove (mm)


def groove_section(depth: float, caliper: float, cutter: VCutter) -> GrooveSection:
    """Return the cross-section of a groove of ``depth`` mm in a board of ``caliper`` mm.

    With θ the tilt of the cutter, h the depth and T the caliper: included angle 2θ,
    width W = 2 h tan θ, web T - h (our derivation).

    Examples
    --------
    >>> groove_section(1.3, 2.0, VCutter(6.0, 1.5, 45.0))
    GrooveSection(included=90.0, width=2.6, web=0.7)
    """
    width = 2.0 * depth * cutter.slope
    return GrooveSection(2.0 * cutter.tilt, round(width, 9), round(caliper - depth, 9))


def vgroove_toolpath(operation: Operation) -> Toolpath:
    """Return the toolpath that cuts V-grooves: two passes along every path at each depth.

    A groove of one segment that is shorter than the blade is wide is left out; the verifier reports
    it as a shortfall.

    Raises
    ------
    CurvedGroove
        A path contains an arc, which a straight blade cannot follow.
    EdgeTooShort
        Grooves that continue each other are together shorter than the blade is wide.
    GrooveTooDeep
        The depth of a groove is not less than the thickness of the board, or the blade would
        overrun an end inside a panel by more than the board allows.
    """
    cutter = operation.tool
    assert isinstance(cutter, VCutter)
    short = operation.paths.lengths < 2.0 * cutter.half_width
    short &= np.diff(operation.paths.first) == 1
    if short.any():
        operation = operation.with_paths(np.flatnonzero(~short).astype(np.int32))
    _check_paths(operation, cutter)
    start, end = _extend_run_outs(operation)
    offset = head_offset(start, end, cutter)
    sideways = sideways_move(start, end, cutter, np.ones(len(start)))
    heading = azimuth(end - start)
    first, owner = operation.paths.first, operation.paths.path_of
    # Segments of one groove may differ by hundredths of a degree, also across 0°.
    along = heading[first[:-1]][owner]
    heading = along + turn_angle(along, heading)
    segments = _Segments(start, end, offset, sideways, heading, operation.depth, operation.source)
    columns = _write_passes(first, segments, operation.caliper, operation.clearance)
    begin, finish, above_begin, above_finish, down, up, track, source = columns
    zeros = np.zeros(len(track))
    return Strokes(
        start=begin,
        end=finish,
        bulge=zeros,
        above_start=above_begin,
        above_end=above_finish,
        down=down,
        up=up,
        track=track,
        source=source,
        swing=zeros,
        motion=np.full(len(track), Motion.FEED, np.uint8),
    ).to_toolpath(operation)


def _extend_run_outs(operation: Operation) -> tuple[F64, F64]:
    """Return the position of the tip at the start and at the end of each segment, (n, 2) mm each.

    Segments that end at the board's edge are extended by the run-out of the operation.
    """
    paths, out = operation.paths, operation.run_out
    start, end = paths.start, paths.end
    for column, rows in ((0, paths.first[:-1]), (1, paths.first[1:] - 1)):
        some = out[:, column] > 0.0
        at, size = rows[some], out[some, column, None]
        ahead = unit_vectors(paths.end[at] - paths.start[at])
        if column == 0:
            start = start.copy()
            start[at] -= size * ahead
        else:
            end = end.copy()
            end[at] += size * ahead
    return start, end


class _Segments(NamedTuple):
    """n segments of V-grooves, which the cutter follows in k double passes."""

    start: F64_2  #: (n, 2) mm, position of the tip at the start of each segment
    end: F64_2  #: (n, 2) mm, position of the tip at its end
    offset: F64_2  #: (n, 2) mm, position of the head relative to the tip in the first pass
    sideways: F64_2  #: (n, 2) sideways movement of the head per mm by which the tip rises
    heading: F64_1  #: (n,) degrees, heading C of the head in the first pass
    depth: F64_2  #: (n, k) mm, depth in each double pass
    source: I32_1  #: (n,) edge of each segment


@kernel
def _write_passes(first: I32_1, segments: _Segments, caliper: float, clearance: float) -> Any:
    """Return the columns of the strokes of V-grooves, one stroke per segment and pass.

    The strokes are ordered by path, then by depth; at each depth the first pass is followed by the
    second pass, in which the head runs back.  The head turns by half a turn between the two passes
    and back again, so C does not accumulate.

    ``first``: index of the first segment of each path, and at the end the number n of segments.
    ``caliper``, ``clearance`` mm: thickness of the board, and height of the tip above the board in
    air moves.
    Returns ``start, end, above_start, above_end`` (m, 4) each: poses of the head at both ends of
    each of m = 2 n k strokes, in the board and above it; ``down, up, track, source`` (m,) each:
    whether the tool plunges before each stroke, whether it is lifted after the stroke, and the
    track and the edge of the stroke.
    """
    start, end, offset, sideways, heading, depth, source = segments
    passes = depth.shape[1]
    rows = 2 * passes * len(source)
    begin = np.empty((rows, 4))
    finish = np.empty((rows, 4))
    above_begin = np.empty((rows, 4))
    above_finish = np.empty((rows, 4))
    down = np.zeros(rows, np.bool_)
    up = np.zeros(rows, np.bool_)
    track = np.empty(rows, np.int32)
    edge = np.empty(rows, np.int32)
    top = caliper + clearance
    row = 0
    for path in range(len(first) - 1):
        size = first[path + 1] - first[path]
        for stroke in range(2 * passes):
            down[row] = True
            up[row + size - 1] = True
            for place in range(size):
                back = stroke % 2 == 1
                i = first[path + 1] - 1 - place if back else first[path] + place
                side = -1.0 if back else 1.0
                deep = depth[i, stroke // 2]
                for axis in range(2):
                    near = end[i, axis] if back else start[i, axis]
                    far = start[i, axis] if back else end[i, axis]
                    out = side * offset[i, axis]
                    lifted = out + side * sideways[i, axis] * (deep + clearance)
                    begin[row, axis] = near + out
                    finish[row, axis] = far + out
                    above_begin[row, axis] = near + lifted
                    above_finish[row, axis] = far + lifted
                begin[row, 2] = finish[row, 2] = caliper - deep
                above_begin[row, 2] = above_finish[row, 2] = top
                c = heading[i] + (180.0 if back else 0.0)
                begin[row, 3] = finish[row, 3] = above_begin[row, 3] = above_finish[row, 3] = c
                track[row] = path
                edge[row] = source[i]
                row += 1
    return begin, finish, above_begin, above_finish, down, up, track, edge


def _check_paths(operation: Operation, cutter: VCutter) -> None:
    """Raise an error if a path of a V-groove operation cannot be cut.

    Raises ``CurvedGroove``: a path contains an arc.
    Raises ``EdgeTooShort``: a path is shorter than the blade is wide.
    Raises ``GrooveTooDeep``: the depth of a groove is not less than the thickness of the board, or
    a path has an end inside a panel and the blade is wider than the overrun that the board allows
    there.
    """
    paths = operation.paths
    curved = np.flatnonzero(np.abs(paths.bulge) >= BULGE)
    if len(curved):
        rows = operation.source[curved]
        raise CurvedGroove("groove.curved", count=len(curved), edge=rows[0], at_edges=rows)
    blade = 2.0 * cutter.half_width
    length = paths.lengths
    short = np.flatnonzero(length < blade)
    if len(short):
        rows = operation.source[paths.first[short]]
        raise EdgeTooShort(
            "groove.too-short",
            edge=rows[0],
            length=length[short[0]],
            blade=blade,
            at_edges=rows,
        )
    deep = np.flatnonzero((operation.depth >= operation.caliper).any(axis=1))
    if len(deep):
        rows = operation.source[deep]
        raise GrooveTooDeep(
            "groove.too-deep",
            edge=rows[0],
            depth=operation.depth[deep[0]].max(),
            caliper=operation.caliper,
            at_edges=rows,
        )
    # Beyond an end on the board's edge the blade may overrun freely.
    inside = np.flatnonzero((operation.start == End.FREE) | (operation.finish == End.FREE))
    if blade > operation.overcut and len(inside):
        raise GrooveTooDeep(
            "groove.overcut",
            overrun=blade,
            allowed=operation.overcut,
            at_edges=operation.source[paths.first[inside]],
        )
