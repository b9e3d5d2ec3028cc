"""Convert paths of SVG and PDF files to columns of lines and arcs.

A circular arc that is rotated, mirrored or evenly scaled remains an arc.  All other arcs and all
Bézier curves are approximated by arcs, many curves at a time.

The tolerance of the approximation is ``tolerance.CURVE`` (mm).  If the unit is unknown, it is 1 /
250,000 of the diagonal of the drawing; this is at most 0.01 mm in every unit in which the drawing
is smaller than 2.5 m.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.drawing_builder.columns import Columns
from knifetip.drawing_builder.report import ReportWriter, curves_fitted, too_far
from knifetip.errors import DrawingTooLarge, GeometryError
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.curve import EvaluateEach, fit_many
from knifetip.geometry.tolerance import CURVE
from knifetip.messages import Message

LINE: Final = 0
CUBIC: Final = 1
ARC: Final = 2

_SHARE: Final = 1.0 / 250_000.0
#: Fraction of the tolerance within which an arc counts as circular and a curve as straight.
_ALIKE: Final = 0.01
#: Curves that are fitted between two checks of the time limit.
_BLOCK: Final = 4096


@dataclass(frozen=True, eq=False, slots=True)
class Table:
    """n segments of several paths, in the order of the file and in coordinates of their paths."""

    kind: U8  #: (n,) LINE, CUBIC or ARC
    #: (n, 8) x and y of both ends; then for a CUBIC x and y of both inner control points; for an
    #: ARC both radii, the angle of the first radius (degrees), and 1 for a sweep above 180° plus 2
    #: for a sweep in the direction of increasing angles
    numbers: F64
    path: I64  #: (n,) path of each segment


@dataclass(frozen=True, eq=False, slots=True)
class Paths:
    """Report row, style and matrix of each of p paths."""

    row: I32  #: (p,) row in the import report
    style: I32  #: (p,) index of the style
    matrix: F64  #: (p, 6) a … f of the matrix from path coordinates to file units


def columns(
    sheet: ReportWriter, table: Table, paths: Paths, scale: float, limits: Limits, what: str
) -> Columns:
    """Return all segments of the paths of a file as lines and arcs in file units.

    The reasons for paths that are dropped are written to ``sheet``.

    Parameters
    ----------
    sheet
        Import report of the file.
    table, paths
        Segments of the paths, and report row, style and matrix of each path.
    scale
        Millimetres per file unit, 0 if unknown.
    limits
        Limits of the number of segments and of the time.
    what
        Name of the format in error messages: "SVG" or "PDF".

    Raises
    ------
    DrawingTooLarge
        The number of segments or the time exceeds its limit.
    """
    rows, matrix = paths.row, paths.matrix
    with np.errstate(all="ignore"):
        far = _farthest(table, matrix, len(rows))
        reach = REACH / (scale or 1.0)
        for path in np.flatnonzero(~(far <= reach)).tolist():
            sheet.dropped[int(rows[path])] = too_far(far[path], reach)
        good = (far <= reach)[table.path]
        table = Table(table.kind[good], table.numbers[good], table.path[good])
        placed = _Placed(table, matrix[table.path])
        tolerance = CURVE / scale if scale else _relative(placed.start, placed.end)
        ends, bulge, of, curved = _segments(placed, tolerance, limits, what)
    path_of = table.path[of]
    if placed.failed:
        lost = np.zeros(len(rows), bool)
        for segment, why in placed.failed.items():
            lost[table.path[segment]] = True
            sheet.dropped[int(rows[table.path[segment]])] = why
        kept = ~lost[path_of]
        ends, bulge, of, path_of = ends[kept], bulge[kept], of[kept], path_of[kept]
    fitted = np.bincount(path_of[curved[of]], minlength=len(rows))
    for one in np.flatnonzero(fitted).tolist():
        sheet.notes.setdefault(int(rows[one]), []).append(
            curves_fitted(int(fitted[one]), tolerance, relative=not scale)
        )
    return Columns(ends, bulge, rows[path_of], paths.style[path_of])


def too_many(limits: Limits, what: str) -> DrawingTooLarge:
    """Return the error for a file with more segments than the limit; ``what`` is its format."""
    return DrawingTooLarge("reading.too-many-segments", format=what, limit=limits.segments)


def boxes(table: Table, matrix: F64) -> F64:
    """Return the bounding box of each of p paths, (p, 4): x min, y min, x max, y max (file units).

    It contains ends and control points; it is NaN for a path without segments.

    Parameters
    ----------
    matrix : (p, 6)
        Matrix from the coordinates of each path to file units.
    """
    by, numbers = matrix[table.path], table.numbers
    low = np.full((len(by), 2), np.inf)
    high = -low
    for k in range(4):
        at = _linear(by, numbers[:, 2 * k : 2 * k + 2]) + by[:, 4:]
        drawn = (table.kind == CUBIC)[:, None] | (k < 2)
        low = np.where(drawn, np.minimum(low, at), low)
        high = np.where(drawn, np.maximum(high, at), high)
    box = np.full((len(matrix), 4), np.nan)
    if len(by):
        first = np.flatnonzero(np.diff(table.path, prepend=-1))
        box[table.path[first], :2] = np.minimum.reduceat(low, first)
        box[table.path[first], 2:] = np.maximum.reduceat(high, first)
    return box


def _farthest(table: Table, matrix: F64, paths: int) -> F64:
    """Return for each of p paths an upper bound of its absolute coordinates, (p,) (file units).

    It is NaN or infinite if a coordinate of the path is.

    Parameters
    ----------
    matrix : (p, 6)
        Matrix from the coordinates of each path to file units.
    paths
        Number p of paths.
    """
    far = np.zeros(paths)
    if not len(table.kind):
        return far
    by = matrix[table.path]
    numbers = table.numbers
    cubic, round_ = table.kind == CUBIC, table.kind == ARC
    reach = np.zeros(len(by))
    for x, drawn in ((0, True), (2, True), (4, cubic), (6, cubic)):
        at = np.abs(_linear(by, numbers[:, x : x + 2]) + by[:, 4:]).max(axis=1)
        reach = np.maximum(reach, np.where(drawn, at, 0.0))
    # On a unit circle, the points of a small arc are at most its chord away from the ends of the
    # arc, and the points of a large arc at most the diameter.  The radii scale this distance; radii
    # that are too small for the chord are increased until the chord is a diameter.
    size = np.abs(by[:, :4]).sum(axis=1)
    half = np.hypot(*_half_chord(numbers))
    large = numbers[:, 7] % 2.0 == 1.0
    wide = 2.0 * np.where(large, np.maximum(half, 1.0), half) * numbers[:, 4:6].max(axis=1)
    reach = reach + np.where(round_, 2.0 * size * wide, 0.0)
    first = np.flatnonzero(np.diff(table.path, prepend=-1))
    far[table.path[first]] = np.maximum.reduceat(reach, first)
    return far


def _relative(start: F64, end: F64) -> float:
    """Return the fitting tolerance for a drawing whose unit is unknown (file units).

    Parameters
    ----------
    start, end : (n, 2)
        Ends of the segments of the drawing, whose extent determines the tolerance.
    """
    if not len(start):
        return CURVE
    both = np.concatenate([start, end])
    size = float(np.hypot(*(both.max(axis=0) - both.min(axis=0))))
    return min(CURVE, size * _SHARE) if size > 0.0 else CURVE


def _linear(by: F64, vectors: F64) -> F64:
    """Return n vectors multiplied by the linear parts of n matrices, (n, 2).

    Parameters
    ----------
    by : (n, 6)
        Matrices, each as a … f of SVG.
    vectors : (n, 2)
    """
    x, y = vectors[:, 0], vectors[:, 1]
    return np.stack([by[:, 0] * x + by[:, 2] * y, by[:, 1] * x + by[:, 3] * y], axis=1)


class _Placed:
    """The segments of a Table in file units: ends, control points of curves, axes of arcs."""

    def __init__(self, table: Table, by: F64) -> None:
        numbers = table.numbers
        self.failed: dict[int, Message] = {}  #: reason by segment that cannot be fitted
        self.kind = table.kind.copy()
        self.start = _linear(by, numbers[:, :2]) + by[:, 4:]
        self.end = _linear(by, numbers[:, 2:4]) + by[:, 4:]
        self.cubic = np.flatnonzero(self.kind == CUBIC)
        handles = by[self.cubic], numbers[self.cubic]
        self.control = np.stack(
            [
                self.start[self.cubic],
                _linear(handles[0], handles[1][:, 4:6]) + handles[0][:, 4:],
                _linear(handles[0], handles[1][:, 6:]) + handles[0][:, 4:],
                self.end[self.cubic],
            ],
            axis=1,
        )
        # SVG omits an arc between equal points; as a line without length it is dropped and
        # reported.
        same = (numbers[:, 0] == numbers[:, 2]) & (numbers[:, 1] == numbers[:, 3])
        self.kind[(self.kind == ARC) & same] = LINE
        self.arc = np.flatnonzero(self.kind == ARC)
        centre, u, v, self.first, self.turn = _centred(numbers[self.arc])
        through = by[self.arc]
        self.centre = _linear(through, centre) + through[:, 4:]
        self.u = _linear(through, u)
        self.v = _linear(through, v)


def _half_chord(numbers: F64) -> tuple[F64, F64]:
    """Return half the chord of n elliptic arcs along the first and the second axis, (n,) each.

    The unit of each value is the radius along that axis.

    Parameters
    ----------
    numbers : (n, 8)
        Rows of ``Table.numbers`` that are arcs.
    """
    angle = np.radians(numbers[:, 6])
    cosine, sine = np.cos(angle), np.sin(angle)
    half = (numbers[:, :2] - numbers[:, 2:4]) / 2.0
    return (
        (cosine * half[:, 0] + sine * half[:, 1]) / numbers[:, 4],
        (cosine * half[:, 1] - sine * half[:, 0]) / numbers[:, 5],
    )


def _centred(numbers: F64) -> tuple[F64, F64, F64, F64, F64]:
    """Return centre, semi-axes u and v, first angle and sweep of n elliptic arcs.

    A point of an arc is centre + u cos t + v sin t, for t from the first angle to first angle +
    sweep (radians).  Centre, u and v have shape (n, 2), the angles shape (n,).

    Source: SVG 1.1, appendix F.6.5 and F.6.6.

    Parameters
    ----------
    numbers : (n, 8)
        Rows of ``Table.numbers`` that are arcs.
    """
    angle = np.radians(numbers[:, 6])
    cosine, sine = np.cos(angle), np.sin(angle)
    rx, ry = numbers[:, 4], numbers[:, 5]
    large = numbers[:, 7] % 2.0 == 1.0
    rising = numbers[:, 7] >= 2.0
    middle = (numbers[:, :2] + numbers[:, 2:4]) / 2.0
    x, y = _half_chord(numbers)
    chord = x * x + y * y
    # Radii that are too small are increased until the arc reaches both ends.
    grown = np.sqrt(np.maximum(chord, 1.0))
    x, y, rx, ry = x / grown, y / grown, rx * grown, ry * grown
    chord = np.where(chord > 1.0, 1.0, chord)
    off = np.sqrt(np.maximum(1.0 / chord - 1.0, 0.0)) * np.where(large == rising, -1.0, 1.0)
    centre_x, centre_y = off * y, -off * x
    first = np.arctan2(y - centre_y, x - centre_x)
    # From the chord: the difference of two angles would lose the sweep of a short arc.
    turn = 2.0 * np.arcsin(np.sqrt(chord))
    turn = np.where(large, 2.0 * np.pi - turn, turn) * np.where(rising, 1.0, -1.0)
    u = np.stack([rx * cosine, rx * sine], axis=1)
    v = np.stack([-ry * sine, ry * cosine], axis=1)
    return middle + centre_x[:, None] * u + centre_y[:, None] * v, u, v, first, turn


def _segments(
    placed: _Placed, tolerance: float, limits: Limits, what: str
) -> tuple[F64, F64, I64, Bool]:
    """Return the segments of a drawing as n lines and arcs, in the order of the file.

    Parameters
    ----------
    placed
        m segments of the paths of the file.
    tolerance
        Maximum distance between a curve and its arcs (file units).
    what
        Name of the format in error messages.

    Returns
    -------
    ends : (n, 2, 2)
    bulge : (n,)
    of : (n,)
        Row in the Table of each line or arc.
    curved : (m,)
        Mask of the rows of the Table that were approximated by arcs.
    """
    curved = np.zeros(len(placed.kind), bool)
    straight = np.flatnonzero(placed.kind == LINE)
    parts = [_lines(placed, straight)]

    chord = placed.control[:, 3] - placed.control[:, 0]
    is_line = _are_straight(placed.control, chord, _ALIKE * tolerance)
    parts.append(_lines(placed, placed.cubic[is_line]))
    bent = np.flatnonzero(~is_line)
    curved[placed.cubic[bent]] = True

    size_u, size_v = (np.hypot(*vectors.T) for vectors in (placed.u, placed.v))
    across = np.abs((placed.u * placed.v).sum(axis=1))
    larger = np.maximum(size_u, size_v)
    off = np.maximum(np.abs(size_u - size_v), across / np.where(larger > 0.0, larger, 1.0))
    circle = off <= _ALIKE * tolerance
    parts.append(_circular(placed, np.flatnonzero(circle)))
    oval = np.flatnonzero(~circle)
    curved[placed.arc[oval]] = True

    until = time.monotonic() + limits.seconds
    total = sum(len(part[1]) for part in parts)
    for which, numbers, point, tangent in (
        (bent, placed.cubic, *_bezier(placed.control)),
        (oval, placed.arc, *_elliptic(placed)),
    ):
        for low in range(0, len(which), _BLOCK):
            if time.monotonic() > until:
                raise DrawingTooLarge("reading.too-slow", format=what, seconds=limits.seconds)
            part = _fitted(placed, which[low : low + _BLOCK], numbers, point, tangent, tolerance)
            total += len(part[1])
            if total > limits.segments:
                raise too_many(limits, what)
            parts.append(part)
    if total > limits.segments:
        raise too_many(limits, what)
    ends, bulge, of = (np.concatenate(column) for column in zip(*parts, strict=True))
    order = np.argsort(of, kind="stable")
    return ends[order], bulge[order], of[order], curved


def _lines(placed: _Placed, rows: I64) -> tuple[F64, F64, I64]:
    ends = np.stack([placed.start[rows], placed.end[rows]], axis=1)
    return ends, np.zeros(len(rows)), rows


def _are_straight(control: F64, chord: F64, tolerance: float) -> Bool:
    """Return the mask of the Bézier curves that are straight, (n,).

    All control points of a straight curve are within ``tolerance`` of its chord.

    Parameters
    ----------
    control : (n, 4, 2)
        Control points of each curve.
    chord : (n, 2)
        Vector from the start to the end of each curve.
    """
    size = np.hypot(chord[:, 0], chord[:, 1])
    ahead = chord / np.where(size > 0.0, size, 1.0)[:, None]
    straight: Bool = size > 0.0
    for handle in (1, 2):
        away = control[:, handle] - control[:, 0]
        beside = np.abs(ahead[:, 0] * away[:, 1] - ahead[:, 1] * away[:, 0])
        along = (ahead * away).sum(axis=1)
        straight &= (beside <= tolerance) & (along >= -tolerance) & (along <= size + tolerance)
    # Curves without length count as straight, and ``assemble`` drops them.
    return straight | (np.abs(control - control[:, :1]) <= 0.0).all(axis=(1, 2))


def _circular(placed: _Placed, which: I64) -> tuple[F64, F64, I64]:
    """Return circular arcs as arcs of at most 180°: ends, bulge and Table row of each of these.

    Parameters
    ----------
    which
        Indices of the circular arcs in ``placed.arc``.
    """
    rows = placed.arc[which]
    u, v, first, turn = placed.u[which], placed.v[which], placed.first[which], placed.turn[which]
    side = np.sign((u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) * turn)
    two = np.abs(turn) > np.pi * (1.0 + 1e-9)
    bulge = side * np.minimum(np.tan(np.abs(turn) / np.where(two, 8.0, 4.0)), 1.0)
    half = first + turn / 2.0
    middle = placed.centre[which] + np.cos(half)[:, None] * u + np.sin(half)[:, None] * v
    start, end = placed.start[rows], placed.end[rows]
    ends = np.concatenate(
        [
            np.stack([start, np.where(two[:, None], middle, end)], axis=1),
            np.stack([middle, end], axis=1)[two],
        ]
    )
    return ends, np.concatenate([bulge, bulge[two]]), np.concatenate([rows, rows[two]])


def _bezier(control: F64) -> tuple[EvaluateEach, EvaluateEach]:
    """Return two functions that evaluate cubic Bézier curves: point and derivative.

    Both take indices of curves (k,) and parameters 0 … 1 (k,), and return an array (k, 2).

    Parameters
    ----------
    control : (n, 4, 2)
        Control points of n curves.
    """
    step = np.diff(control, axis=1)
    # The tangent at the start points to the first control point that differs from the start.
    leaving = control[:, 1:] - control[:, :1]
    first = np.argmax((leaving != 0.0).any(axis=2), axis=1)
    leaving = leaving[np.arange(len(control)), first]

    def point(k: I64, s: F64) -> F64:
        p, t, r = control[k], s[:, None], 1.0 - s[:, None]
        return r * r * r * p[:, 0] + 3.0 * r * t * (r * p[:, 1] + t * p[:, 2]) + t * t * t * p[:, 3]

    def tangent(k: I64, s: F64) -> F64:
        d, t, r = step[k], s[:, None], 1.0 - s[:, None]
        along = r * r * d[:, 0] + 2.0 * r * t * d[:, 1] + t * t * d[:, 2]
        return np.where(t > 0.0, along, leaving[k])

    return point, tangent


def _elliptic(placed: _Placed) -> tuple[EvaluateEach, EvaluateEach]:
    """Return two functions that evaluate elliptic arcs: point and derivative.

    Both take indices into ``placed.arc`` (k,) and parameters 0 … 1 (k,) and return an array (k, 2).
    """

    def point(k: I64, s: F64) -> F64:
        t = placed.first[k] + s * placed.turn[k]
        return (
            placed.centre[k] + np.cos(t)[:, None] * placed.u[k] + np.sin(t)[:, None] * placed.v[k]
        )

    def tangent(k: I64, s: F64) -> F64:
        t = placed.first[k] + s * placed.turn[k]
        way = np.sign(placed.turn[k])[:, None]
        return way * (np.cos(t)[:, None] * placed.v[k] - np.sin(t)[:, None] * placed.u[k])

    return point, tangent


def _fitted(
    placed: _Placed,
    which: I64,
    numbers: I64,
    point: EvaluateEach,
    tangent: EvaluateEach,
    tolerance: float,
) -> tuple[F64, F64, I64]:
    """Fit arcs to curves; return ends, bulge and Table row of each fitted arc.

    If several curves cannot be fitted together, each half of them is fitted separately.  The error
    of a single curve is written to ``placed.failed``.

    Parameters
    ----------
    which
        Indices of the curves, which are arguments of ``point`` and ``tangent``.
    numbers
        Table row of the curve with each index.
    point, tangent
        Functions from indices of curves and parameters 0 … 1 to points and derivatives.
    tolerance
        Maximum distance between a curve and its arcs (file units).
    """
    try:
        start, end, bulge, of = fit_many(
            lambda k, s: point(which[k], s),
            lambda k, s: tangent(which[k], s),
            len(which),
            tolerance,
        )
    except GeometryError as reason:
        if len(which) == 1:
            placed.failed[int(numbers[which[0]])] = reason.message
            return np.zeros((0, 2, 2)), np.zeros(0), np.zeros(0, np.int64)
        middle = len(which) // 2
        halves = [
            _fitted(placed, half, numbers, point, tangent, tolerance)
            for half in (which[:middle], which[middle:])
        ]
        ends, bulge, of = (np.concatenate(column) for column in zip(*halves, strict=True))
        return ends, bulge, of
    rows = numbers[which[of]]
    # Exact ends, so that the next segment begins where this one ends.
    first = np.flatnonzero(np.diff(of, prepend=-1))
    last = np.flatnonzero(np.diff(of, append=len(which)))
    start[first], end[last] = placed.start[rows[first]], placed.end[rows[last]]
    return np.stack([start, end], axis=1), bulge, rows
