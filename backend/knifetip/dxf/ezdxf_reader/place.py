"""place: convert placed shapes to arrays of lines and arcs in file order.

A placement that rotates, mirrors or scales equally in x and y keeps arcs circular.  Unequal scales
make an arc elliptical.  Ellipses and splines are approximated by arcs, once for all placements that
differ only by a translation.

The tolerance of the approximation is ``tolerance.CURVE`` mm.  While the unit of the drawing is
unknown, the tolerance is 1 / 250,000 of the diagonal of the drawing, and at most
``tolerance.CURVE`` file units.  If the diagonal is at most 0.87 m, this fraction is at most
0.0035 mm.
"""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportWriter, curves_fitted, too_far
from knifetip.dxf.ezdxf_reader.block_expansion import ON_SHEET, PlacedShape
from knifetip.dxf.ezdxf_reader.entities import Lines, Shape
from knifetip.dxf.shapes import map_points
from knifetip.errors import DrawingTooLarge, GeometryError
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.curve import Fit, Segments, fitted
from knifetip.geometry.ellipse import Ellipse, fit_ellipses
from knifetip.geometry.spline import Spline, fit_splines
from knifetip.geometry.tolerance import BULGE, CURVE
from knifetip.geometry.unique_rows import unique_rows

_RELATIVE_TOLERANCE: Final = 1.0 / 250_000.0
#: Number of shapes whose curves are approximated together, to limit the memory.
_SHAPES_AT_ONCE: Final = 4096


def columns(
    sheet: ReportWriter,
    shapes: list[PlacedShape],
    scale: float,
    limits: Limits,
    other_ends: F64 | None = None,
) -> Columns:
    """Return all placements of all shapes as lines and arcs (segments), in file order.

    A shape that cannot be placed is left out and marked as dropped in the import report.

    Parameters
    ----------
    sheet
        The import report; reasons for dropping shapes, and notes, are added to it.
    shapes
        The shapes with their placements.
    scale
        Millimetres per file unit, 0 while the unit is unknown.
    other_ends : (m, 2, 2), optional
        Ends of other segments of the drawing (file units), which count towards the limit of
        segments and the size of the drawing.

    Returns
    -------
    Columns
        The column ``style`` contains indices into ``shapes``.

    Raises
    ------
    DrawingTooLarge
        There are more segments, or the conversion takes longer, than the limits allow.
    """
    deadline = time.monotonic() + limits.seconds
    reach = REACH / (scale or 1.0)
    shape_boxes = [_bounds(placed) for placed in shapes]
    parts: dict[int, tuple[F64, F64, F64]] = {}
    curved: list[int] = []
    total = 0 if other_ends is None else len(other_ends)
    boxes = [] if other_ends is None or not len(other_ends) else [_box(other_ends)]
    for number, (placed, (low, high)) in enumerate(zip(shapes, shape_boxes, strict=True)):
        farthest = float(np.abs([low, high]).max())
        if not farthest <= reach:
            sheet.dropped[placed.row] = too_far(farthest, reach)
            continue
        if isinstance(placed.shape, Lines):
            total += len(placed.linear) * len(placed.shape.bulge)
            refuse_beyond(total, limits)
        if (exact := _transform_exactly(placed)) is None:
            curved.append(number)
            boxes.append((low, high))
        else:
            parts[number] = (*exact, np.zeros(len(exact[1])))
            boxes.append(_box(exact[0]))
    tolerance = CURVE / scale if scale else _relative_tolerance(boxes)
    for begin in range(0, len(curved), _SHAPES_AT_ONCE):
        some = curved[begin : begin + _SHAPES_AT_ONCE]
        refuse_after(deadline, limits)
        copies = _approximate([shapes[number] for number in some], tolerance, limits)
        for number, found in zip(some, copies, strict=True):
            placed = shapes[number]
            if isinstance(found, GeometryError):
                sheet.dropped[placed.row] = found.message
                continue
            ends, bulge, error = found
            sheet.notes.setdefault(placed.row, []).append(
                curves_fitted(len(bulge), tolerance, relative=not scale)
            )
            if not isinstance(placed.shape, Lines):
                total += len(bulge)
                refuse_beyond(total, limits)
            parts[number] = ends, bulge, error
    count = np.zeros(len(shapes), dtype=np.int64)
    for number, (_, bulge, _) in parts.items():
        count[number] = len(bulge)
    shape_of = np.repeat(np.arange(len(count), dtype=np.int32), count)
    rows_of = np.array([placed.row for placed in shapes], dtype=np.int32)
    if not parts:
        return Columns(np.zeros((0, 2, 2)), np.zeros(0), shape_of, shape_of)
    ends, bulge, error = (
        np.concatenate(column)
        for column in zip(*(parts[number] for number in sorted(parts)), strict=True)
    )
    return Columns(ends, bulge, rows_of[shape_of], shape_of, error)


def renumber_styles(segments: Columns, styles: list[Style]) -> tuple[Columns, list[Style]]:
    """Return the segments with new style numbers, and the list of the styles that they use.

    The column ``style`` of ``segments`` contains indices into ``styles``, which may contain unused
    and equal styles.  In the returned segments the column contains indices into the returned list,
    in which each used style occurs once.
    """
    first, number = unique_rows(segments.style)
    used = [styles[style] for style in segments.style[first].tolist()]
    return replace(segments, style=number.astype(np.int32)), used


def refuse_after(deadline: float, limits: Limits) -> None:
    """Raise DrawingTooLarge if ``time.monotonic()`` is later than ``deadline`` (seconds)."""
    if time.monotonic() > deadline:
        raise DrawingTooLarge("reading.too-slow", seconds=limits.seconds, format="drawing")


def refuse_beyond(total: int, limits: Limits) -> None:
    """Raise DrawingTooLarge if the number of segments ``total`` is more than the limits allow."""
    if total > limits.segments:
        raise DrawingTooLarge("reading.too-many-segments", limit=limits.segments, format="drawing")


def _box(ends: F64) -> tuple[F64, F64]:
    return ends.min(axis=(0, 1)), ends.max(axis=(0, 1))


def _relative_tolerance(boxes: list[tuple[F64, F64]]) -> float:
    """Return the tolerance for approximating curves in a drawing of unknown unit, in file units.

    It is a fixed fraction of the diagonal of the drawing, and at most ``tolerance.CURVE``.
    ``boxes`` contains the lower and the upper corner of the bounding box of each shape.
    """
    if not boxes:
        return CURVE
    low = np.min([box[0] for box in boxes], axis=0)
    high = np.max([box[1] for box in boxes], axis=0)
    size = float(np.hypot(*(high - low)))
    return min(CURVE, size * _RELATIVE_TOLERANCE) if size > 0.0 else CURVE


def _bounds(placed: PlacedShape) -> tuple[F64, F64]:
    """Return the lower and the upper corner, (2,) each, of a box that contains a placed shape.

    The box contains all placements of the shape.
    """
    shape = placed.shape
    if isinstance(shape, Lines) and not shape.bulge.any():
        low, high = shape.ends.min(axis=(0, 1)), shape.ends.max(axis=(0, 1))
    elif isinstance(shape, Lines):
        boxes = arc.bounding_boxes(shape.ends[:, 0], shape.ends[:, 1], shape.bulge)
        low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    elif isinstance(shape, Ellipse):
        half = np.abs(shape.u) + np.abs(shape.v)
        low, high = shape.centre - half, shape.centre + half
    else:
        low, high = shape.control.min(axis=0), shape.control.max(axis=0)
    if placed.linear is ON_SHEET:
        return low, high
    middle, half = (low + high) / 2.0, (high - low) / 2.0
    centre = (placed.linear @ middle) + placed.shift
    extent = np.abs(placed.linear) @ half
    return (centre - extent).min(axis=0), (centre + extent).max(axis=0)


def _transform_exactly(placed: PlacedShape) -> tuple[F64, F64] | None:
    """Return the segments of all placements of a shape, if its arcs remain circular.

    The result is None if a placement makes an arc of the shape elliptical, or if the shape is an
    ellipse or a spline.

    Returns ``ends`` (n, 2, 2): start and end point of each of the n segments of all placements
    together (file units); ``bulge`` (n,): bulge of each segment.
    """
    shape, linear, shift = placed.shape, placed.linear, placed.shift
    if not isinstance(shape, Lines):
        return None
    if linear is ON_SHEET:
        return shape.ends, shape.bulge
    straight = bool((np.abs(shape.bulge) < BULGE).all())
    even = np.hypot(
        linear[:, 0, 0] * linear[:, 0, 1] + linear[:, 1, 0] * linear[:, 1, 1],
        (linear[:, :, 0] ** 2).sum(axis=1) - (linear[:, :, 1] ** 2).sum(axis=1),
    ) <= 1e-9 * (linear**2).sum(axis=(1, 2))
    if not (straight or even.all()):
        return None
    side = np.sign(linear[:, 0, 0] * linear[:, 1, 1] - linear[:, 0, 1] * linear[:, 1, 0])
    ends = map_points(linear[:, None, None], shift[:, None, None], shape.ends[None])
    return ends.reshape(-1, 2, 2), (side[:, None] * shape.bulge).reshape(-1)


def _approximate(
    shapes: list[PlacedShape], tolerance: float, limits: Limits
) -> list[tuple[F64, F64, F64] | GeometryError]:
    """Return the lines and arcs that approximate all copies of each shape, or why there are none.

    ``tolerance`` is the largest permitted distance of a line or arc from the placed shape (file
    units).  The curves of all shapes are approximated together.

    Returns ``ends`` (n, 2, 2): start and end point of each line or arc of a shape (file units);
    ``bulge`` (n,): bulge of each line or arc; 0 for a line; ``error`` (n,): greatest distance of
    each line or arc from the placed shape (file units).
    Raises ``DrawingTooLarge``: the curves need more lines and arcs than the limits allow.
    """
    curves = _Curves()
    plans: list[tuple[list[_Path], I64]] = []
    for placed in shapes:
        linear = placed.linear.reshape(-1, 4)
        if len(linear) == 1:
            different, kind = linear, np.zeros(1, np.int64)
        else:
            different, kind = np.unique(linear, axis=0, return_inverse=True)
        paths = [curves.add(placed.shape, one.reshape(2, 2)) for one in different]
        plans.append((paths, kind.reshape(-1)))
    curves.fit(tolerance, limits)
    return [
        _copies([curves.segments(one) for one in paths], kind, placed.shift)
        for placed, (paths, kind) in zip(shapes, plans, strict=True)
    ]


def _copies(fits: list[Fit], kind: I64, shift: F64) -> tuple[F64, F64, F64] | GeometryError:
    """Return ends, bulges and errors of the copies of a shape, or why there are none.

    ``fits``: the shape after each of its different linear maps.
    ``kind`` (k,): index into ``fits`` of the linear map of each copy.
    ``shift`` (k, 2): translation of each copy.
    """
    if failed := next((fit for fit in fits if isinstance(fit, GeometryError)), None):
        return failed
    found = [fitted(fit) for fit in fits]
    ends = [
        np.stack(found[number][:2], axis=1) + move
        for number, move in zip(kind.tolist(), shift, strict=True)
    ]
    bulge, error = (
        np.concatenate([found[number][column] for number in kind.tolist()]) for column in (2, 3)
    )
    return np.concatenate(ends), bulge, error


class _Piece(NamedTuple):
    """A curve of a shape: an ellipse, a spline or a line."""

    ellipse: int = -1  #: number of the ellipse, -1 if the curve is none
    spline: int = -1  #: number of the spline, -1 if the curve is none
    ends: F64 | None = None  #: (2, 2) exact ends of a line or of an arc that becomes an ellipse


#: The curves of one shape, in their order, or the reason why it cannot be placed.
_Path: TypeAlias = list[_Piece] | GeometryError


class _Curves:
    """Collects the curves of transformed shapes, and approximates them together."""

    def __init__(self) -> None:
        self._ellipses: list[Ellipse] = []
        self._splines: list[Spline] = []
        self._ellipse_fits: list[Fit] = []
        self._spline_fits: list[Fit] = []

    def add(self, shape: Shape, linear: F64) -> _Path:
        """Add a shape after the linear map ``linear``, (2, 2), and return its curves."""
        if isinstance(shape, Ellipse):
            centre, u, v = (linear @ one for one in (shape.centre, shape.u, shape.v))
            self._ellipses.append(Ellipse(centre, u, v, shape.first, shape.last))
            return [_Piece(ellipse=len(self._ellipses) - 1)]
        if isinstance(shape, Spline):
            try:
                moved_spline = Spline(
                    shape.control @ linear.T, shape.weights, shape.knots, shape.degree
                )
            except GeometryError as error:
                return error
            self._splines.append(moved_spline)
            return [_Piece(spline=len(self._splines) - 1)]
        path = []
        middle = arc.centre(shape.ends[:, 0], shape.ends[:, 1], shape.bulge)
        for (start, end), bulge, centre in zip(shape.ends, shape.bulge, middle, strict=True):
            # Exact ends, so that the next segment begins where this one ends.
            ends = np.array([linear @ start, linear @ end])
            if abs(bulge) < BULGE:
                path.append(_Piece(ends=ends))
                continue
            u = start - centre
            v = np.array([-u[1], u[0]]) * np.sign(bulge)
            turn = 4.0 * float(np.arctan(abs(bulge)))
            self._ellipses.append(Ellipse(linear @ centre, linear @ u, linear @ v, 0.0, turn))
            path.append(_Piece(ellipse=len(self._ellipses) - 1, ends=ends))
        return path

    def fit(self, tolerance: float, limits: Limits) -> None:
        """Approximate all curves within ``tolerance`` (file units).

        Raises ``DrawingTooLarge``: the curves need more lines and arcs than the limits allow.
        """
        try:
            self._ellipse_fits = fit_ellipses(self._ellipses, tolerance, limits.segments)
            self._spline_fits = fit_splines(self._splines, tolerance, limits.segments)
        except GeometryError:
            refuse_beyond(limits.segments + 1, limits)

    def segments(self, path: _Path) -> Fit:
        """Return the lines and arcs of a shape, or the reason why there are none."""
        if isinstance(path, GeometryError):
            return path
        pieces: list[Segments] = []
        for one in path:
            if one.spline >= 0:
                return self._spline_fits[one.spline]
            if one.ellipse >= 0:
                found = self._ellipse_fits[one.ellipse]
                if isinstance(found, GeometryError):
                    return found
                if one.ends is not None:
                    found[0][0], found[1][-1] = one.ends
                pieces.append(found)
            elif one.ends is not None:
                exact = np.zeros(1)
                pieces.append((one.ends[:1], one.ends[1:], exact, exact))
        if len(pieces) == 1:
            return pieces[0]
        start, end, bulges, error = (np.concatenate(column) for column in zip(*pieces, strict=True))
        return start, end, bulges, error
