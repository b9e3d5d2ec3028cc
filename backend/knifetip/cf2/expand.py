"""expand: replace the calls in a CF2 by copies of the subroutines, and list all lines and arcs.

    Cf2File, tolerance -> ExpandedFile: ReportWriter, Columns, annotations

The copies are counted before they are made.  A bridge is a gap of the steel rule in the die board,
not a gap of the cut in the carton, so bridges appear only in the import report (decision 9).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Final

import numpy as np

from knifetip.cf2.records import Cf2File, Section
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportWriter, too_far
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.curve import fit_many
from knifetip.geometry.tolerance import BULGE
from knifetip.messages import Message
from knifetip.model.drawing import Annotation

#: Relative difference of the radii at the ends of an arc above which the report has a note.
_RADIUS_TOLERANCE: Final = 1e-3
#: Largest number of characters of a field in a message.
_SHOWN: Final = 20
_NAMES: Final = {"L": "L (line)", "A": "A (arc)", "T": "T (text)", "C": "C (call)"}


@dataclass(slots=True)
class ExpandedFile:
    """The lines, arcs and texts of a CF2 with all copies of subroutines, in file units."""

    report: ReportWriter = field(default_factory=ReportWriter)
    styles: list[Style] = field(default_factory=list)
    annotations: list[Annotation] = field(default_factory=list)
    ends: list[F64] = field(default_factory=list)
    bulge: list[F64] = field(default_factory=list)
    row: list[I64] = field(default_factory=list)
    style: list[I64] = field(default_factory=list)

    def columns(self, reach: float) -> Columns:
        """Return the segments of all lines and arcs, in the order of the rows of the import report.

        Parameters
        ----------
        reach
            Largest permitted absolute value of a coordinate (file units).  Lines and arcs that
            exceed it are dropped, and the reason is added to the import report.
        """
        if not self.ends:
            none = np.zeros(0, np.int32)
            return Columns(np.zeros((0, 2, 2)), np.zeros(0), none, none)
        ends, bulge = np.concatenate(self.ends), np.concatenate(self.bulge)
        row, style = np.concatenate(self.row), np.concatenate(self.style)
        order = np.argsort(row, kind="stable")
        ends, bulge, row, style = ends[order], bulge[order], row[order], style[order]
        far = np.abs(ends).max(axis=(1, 2))
        beyond = ~(far <= reach) | ~np.isfinite(bulge)
        for one in np.flatnonzero(beyond).tolist():
            self.report.dropped[int(row[one])] = too_far(far[one], reach)
        # Both segments of an arc are dropped or kept together.
        keep = ~np.isin(row, row[beyond]) if beyond.any() else ~beyond
        return Columns(
            ends[keep], bulge[keep], row[keep].astype(np.int32), style[keep].astype(np.int32)
        )


@dataclass(frozen=True, eq=False, slots=True)
class _Shape:
    """The segments of the lines and arcs of a CF2 section, in the coordinates of the section."""

    ends: F64  #: (n, 2, 2) start and end points of n segments
    bulge: F64  #: (n,) bulge of each segment
    row: I64  #: (n,) row of each segment in the section
    style: I64  #: (n,) index of the style of each segment
    dropped: dict[int, Message]  #: row -> reason why the record is dropped
    notes: dict[int, list[Message]]  #: row -> notes in the import report


def expand(source: Cf2File, linear: F64, tolerance: float, limits: Limits) -> ExpandedFile:
    """Return the lines, arcs and texts of a CF2, with a copy of the subroutine for each call.

    Parameters
    ----------
    linear : (2, 2)
        Matrix that is applied to the whole drawing.
    tolerance
        Largest error of the segments that approximate elliptic arcs (file units).  Arcs become
        elliptic if the scale of a call is not uniform.

    Raises
    ------
    DrawingTooLarge
        The depth of calls, or the number of expanded records or segments, exceeds the limits.
    """
    expander = _Expander(source, tolerance, limits)
    start = linear, np.zeros(2)
    main = source.main
    if main is not None:
        expander.add_section(main, *start, "", ())
    if main is None or not main.kind:
        # Without calls each subroutine is drawn once, in its own coordinates.
        for name, section in source.subs.items():
            expander.add_section(section, *start, "", (name,))
    else:
        expander.report_unused()
    return expander.found


class _Expander:
    """Copies the sections of one CF2 to the positions at which they are called."""

    def __init__(self, source: Cf2File, tolerance: float, limits: Limits) -> None:
        self.found = ExpandedFile()
        self._source = source
        self._tolerance = tolerance
        self._limits = limits
        self._shapes: dict[int, _Shape] = {}
        self._numbers: dict[Style, int] = {}
        self._used: set[str] = set()
        self._segments = 0
        self._check_size()

    def _check_size(self) -> None:
        """Raise DrawingTooLarge if the depth of calls or the number of copies exceeds the limits.

        The number is computed before any copy is made.
        """
        known: dict[str, tuple[int, int]] = {}
        open_: set[str] = set()

        def size(section: Section, depth: int) -> tuple[int, int]:
            """Return the number of records of a section and of all subroutine copies in it.

            The second value is the number of levels of nested calls in the section.  ``depth`` is
            the number of nested calls that contain the section.
            """
            total, deep = len(section.kind), 0
            for call in section.calls:
                name = call.name.upper()
                child = self._source.subs.get(name)
                if child is None or name in open_:
                    continue
                if depth >= self._limits.insert_depth:
                    raise self._too_deep()
                if name not in known:
                    open_.add(name)
                    known[name] = size(child, depth + 1)
                    open_.discard(name)
                records, below = known[name]
                total, deep = total + records, max(deep, below + 1)
                if depth + deep > self._limits.insert_depth:
                    raise self._too_deep()
                if total > self._limits.expanded:
                    raise DrawingTooLarge(
                        "reading.expands-too-far", limit=self._limits.expanded, format="CF2"
                    )
            return total, deep

        sections = [self._source.main] if self._source.main else list(self._source.subs.values())
        for section in sections:
            size(section, 0)

    def _too_deep(self) -> DrawingTooLarge:
        return DrawingTooLarge(
            "reading.nested-too-deep", limit=self._limits.insert_depth, format="CF2"
        )

    def add_section(
        self, section: Section, linear: F64, shift: F64, path: str, above: tuple[str, ...]
    ) -> None:
        """Add a copy of a section to the drawing, with copies of all subroutines that it calls.

        Parameters
        ----------
        section
            MAIN or a subroutine.
        linear, shift
            Matrix (2, 2) and translation (2,) from section coordinates to file units.
        path
            Handles in the import report of the nested calls that contain the copy, each followed by
            a slash; empty outside all calls.
        above
            Names of the subroutines that contain this copy; a call of one of them is dropped.
        """
        shape = self._shapes.get(id(section))
        if shape is None:
            shape = self._shapes[id(section)] = self._shape_of(section)
        report = self.found.report
        row_of = np.empty(len(section.kind), np.int64)
        dropped = {**section.dropped, **shape.dropped}
        at = 0
        for call in (*section.calls, None):
            until = len(section.kind) if call is None else call.row + 1
            first = len(report.handle)
            row_of[at:until] = np.arange(first, first + until - at)
            report.handle += [f"{path}#{entity}" for entity in section.entity[at:until]]
            report.kind += [_NAMES.get(kind, kind) for kind in section.kind[at:until]]
            report.layer += [section.name] * (until - at)
            at = until
            if call is None:
                break
            row = int(row_of[call.row])
            name = call.name.upper()
            child = self._source.subs.get(name)
            if child is None:
                report.dropped[row] = Message("import.missing-subroutine", name=call.name[:40])
                x, y = linear @ np.array(call.place[:2]) + shift
                report.set_location(row, (x, y, x, y))
            elif name in above:
                report.dropped[row] = Message("import.subroutine-in-itself", name=call.name[:40])
            elif not all(math.isfinite(value) for value in call.place):
                report.dropped[row] = Message("import.place-not-a-number")
            else:
                self._used.add(name)
                report.notes[row] = [Message("import.places-subroutine", name=call.name[:40])]
                inner = linear @ _linear(*call.place[2:])
                moved = linear @ np.array(call.place[:2]) + shift
                self.add_section(child, inner, moved, f"{report.handle[row]}/", (*above, name))
        for number, why in dropped.items():
            report.dropped[int(row_of[number])] = why
        for number, notes in shape.notes.items():
            report.notes[int(row_of[number])] = list(notes)
        self._add_shape(shape, linear, shift, row_of)
        size = math.sqrt(abs(float(np.linalg.det(linear))))
        for text in section.texts:
            x, y = linear @ np.array(text.place[:2]) + shift
            report.set_location(int(row_of[text.row]), (x, y, x, y))
            if math.isfinite(x) and math.isfinite(y) and math.isfinite(text.place[2]):
                self.found.annotations.append(
                    Annotation(
                        text.text,
                        float(x),
                        float(y),
                        abs(text.place[2]) * size,
                        math.nan,
                        "TEXT",
                        section.name,
                    )
                )

    def report_unused(self) -> None:
        """Add a row to the import report for each subroutine that is never called."""
        for name, section in self._source.subs.items():
            if name not in self._used and section.kind:
                self.found.report.row(
                    section.name,
                    "SUB",
                    section.name,
                    Message(
                        "import.unused-subroutine",
                        name=section.name[:40],
                        records=len(section.kind),
                    ),
                )

    def _add_shape(self, shape: _Shape, linear: F64, shift: F64, row_of: I64) -> None:
        """Add a transformed copy of the lines and arcs of a section to the drawing.

        Parameters
        ----------
        shape
            Lines and arcs of the section.
        linear, shift
            Matrix (2, 2) and translation (2,) from section coordinates to file units.
        row_of
            Import report row of each record of the section.
        """
        if not len(shape.bulge):
            return
        u, v = linear[:, 0], linear[:, 1]
        uneven = abs(u @ v) + abs(u @ u - v @ v) > 1e-9 * (u @ u + v @ v)
        side = 1.0 if u[0] * v[1] - u[1] * v[0] > 0.0 else -1.0
        ends, bulge = shape.ends @ linear.T + shift, side * shape.bulge
        row, style = shape.row, shape.style
        if uneven and (arcs := np.flatnonzero(np.abs(shape.bulge) >= BULGE)).size:
            straight = np.flatnonzero(np.abs(shape.bulge) < BULGE)
            start, end, curved, which = _fit_ellipses(shape, arcs, linear, shift, self._tolerance)
            ends = np.concatenate([ends[straight], np.stack([start, end], axis=1)])
            bulge = np.concatenate([bulge[straight], curved])
            row = np.concatenate([row[straight], row[arcs[which]]])
            style = np.concatenate([style[straight], style[arcs[which]]])
        self.found.ends.append(ends)
        self.found.bulge.append(bulge)
        self.found.row.append(row_of[row])
        self.found.style.append(style)
        self._segments += len(bulge)
        if self._segments > self._limits.segments:
            raise DrawingTooLarge(
                "reading.too-many-segments", limit=self._limits.segments, format="CF2"
            )

    def _shape_of(self, section: Section) -> _Shape:
        """Return the segments of a section's lines and arcs.

        The result also contains the reasons for dropped records, and notes for the import report.
        """
        dropped: dict[int, Message] = {}
        notes: dict[int, list[Message]] = {}
        lines, line_row = _coordinates(section.line, section.line_row, slice(4, 8), dropped)
        arcs, arc_row = _coordinates(section.arc, section.arc_row, slice(4, 11), dropped)
        ends, bulge, which = _split_arcs(arcs, arc_row, notes)
        row = np.concatenate([line_row, arc_row[which]])
        style_of = np.zeros(len(section.kind), np.int64)
        style_of[section.line_row] = self._style_numbers(section.name, section.line)
        style_of[section.arc_row] = self._style_numbers(section.name, section.arc)
        for rows, records, first in (
            (section.line_row, section.line, 8),
            (section.arc_row, section.arc, 11),
        ):
            for one, record in zip(rows, records, strict=True):
                if len(record) > first and record[first].strip() not in ("0", ""):
                    _note_bridges(record[first : first + 2], notes.setdefault(one, []))
        return _Shape(
            np.concatenate([lines.reshape(-1, 2, 2), ends]),
            np.concatenate([np.zeros(len(lines)), bulge]),
            row,
            style_of[row],
            dropped,
            {one: texts for one, texts in notes.items() if texts},
        )

    def _style_numbers(self, layer: str, records: Sequence[Sequence[str]]) -> list[int]:
        """Return the index, in the drawing's list of styles, of the style of each record.

        Parameters
        ----------
        layer
            Layer of all the records.
        records
            Fields of each record of a line or an arc.
        """
        known: dict[tuple[str, str, str], int] = {}
        found = []
        for record in records:
            key = record[1], record[2], record[3]
            number = known.get(key)
            if number is None:
                number = known[key] = self._style(layer, *(text.strip() for text in key))
            found.append(number)
        return found

    def _style(self, layer: str, point: str, kind: str, aux: str) -> int:
        """Return the index of a style in the drawing's list of styles; add the style if it is new.

        Parameters
        ----------
        layer
            Layer of the style.
        point, kind, aux
            Thickness of the steel rule, type and auxiliary type, as written in a record.
        """
        words = ["CF2", _normalise_number(kind)]
        if _normalise_number(aux) != "0":
            words += ["aux", _normalise_number(aux)]
        words.append(f"{_normalise_number(point)}pt")
        style = Style(layer, 7, -1, " ".join(words))
        number = self._numbers.setdefault(style, len(self.found.styles))
        if number == len(self.found.styles):
            self.found.styles.append(style)
        return number


def _normalise_number(text: str) -> str:
    """Return the shortest form of a number: "1" for "1.0" and "01".

    A text that is not a number is returned unchanged, cut to 20 characters.
    """
    try:
        return f"{float(text):g}"
    except ValueError:
        return text[:20] or "0"


def _note_bridges(fields: Sequence[str], notes: list[Message]) -> None:
    """Add a note to ``notes`` if a record states that its steel rule has bridges in the die board.

    ``fields`` are the fields of the record for the number of bridges and for their width.
    """
    try:
        count = float(fields[0])
        width = float(fields[1]) if len(fields) > 1 else 0.0
    except ValueError:
        return
    if count >= 1.0 and math.isfinite(count) and math.isfinite(width):
        notes.append(
            Message("import.bridge", width=width)
            if count == 1.0
            else Message("import.bridges", bridges=count, width=width)
        )


def _linear(angle: float, x_scale: float, y_scale: float) -> F64:
    """Return the (2, 2) matrix that first scales x and y and then rotates by ``angle`` degrees."""
    quarter, rest = divmod(angle % 360.0, 90.0)
    cosine, sine = (
        ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
        if rest == 0.0
        else (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    )
    return np.array([[cosine * x_scale, -sine * y_scale], [sine * x_scale, cosine * y_scale]])


def _coordinates(
    records: Sequence[Sequence[str]], rows: Sequence[int], where: slice, dropped: dict[int, Message]
) -> tuple[F64, I64]:
    """Return the coordinates of the n valid records, (n, k), and the rows of these records, (n,).

    Parameters
    ----------
    records
        Fields of each record.
    rows
        Row of each record in its section.
    where
        Slice of the k fields of a record that are coordinates.
    dropped
        Reasons for dropped records, by row; the reason for each record with invalid coordinates is
        added.
    """
    wide = where.stop - where.start
    row = np.array(rows, np.int64)
    try:
        flat = list(map(float, chain.from_iterable(record[where] for record in records)))
        return np.array(flat).reshape(-1, wide), row
    except ValueError:
        pass
    values = np.full((len(records), wide), np.nan)
    for at, record in enumerate(records):
        try:
            values[at] = [float(text) for text in record[where]]
        except ValueError:
            shown = [text[:_SHOWN] for text in record[where]]
            dropped[rows[at]] = Message("import.not-numbers", values=shown)
    good = np.array([one not in dropped for one in rows], bool)
    return values[good], row[good]


def _split_arcs(arcs: F64, rows: I64, notes: dict[int, list[Message]]) -> tuple[F64, F64, I64]:
    """Split each of k arcs into one or two segments of at most half a turn.

    A record of an arc states start, end and centre.  If the stated centre is not equally far from
    start and end, the centre is not used: the arc still joins start and end, and its sweep angle is
    the angle between them as seen from the stated centre.

    Parameters
    ----------
    arcs : (k, 7)
        Start, end, centre and direction of each arc.
    rows : (k,)
        Row of each arc in its section.
    notes
        Notes by row; a note is added for each arc with a different radius at start and end.

    Returns
    -------
    ends : (n, 2, 2)
        Start and end points of the segments.
    bulge : (n,)
        Bulges of the segments.
    which : (n,)
        Index in ``arcs`` of the arc of each segment.
    """
    start, end, centre, direction = arcs[:, :2], arcs[:, 2:4], arcs[:, 4:6], arcs[:, 6]
    with np.errstate(all="ignore"):
        out, back = start - centre, end - centre
        radius, other = np.hypot(*out.T), np.hypot(*back.T)
        turn = np.arctan2(
            out[:, 0] * back[:, 1] - out[:, 1] * back[:, 0], (out * back).sum(axis=1)
        ) % (2.0 * np.pi)
        left = direction >= 0.0
        turn = np.where(left, turn, 2.0 * np.pi - turn)
        # Equal ends, within the precision of such files, mean a whole circle.
        whole = np.hypot(*(end - start).T) <= 1e-6 * np.maximum(radius, 1.0)
        turn = np.where(whole, 2.0 * np.pi, turn)
        two = turn > np.pi * (1.0 + 1e-9)
        bulge = np.where(left, 1.0, -1.0) * np.minimum(np.tan(turn / np.where(two, 8.0, 4.0)), 1.0)
        half = np.where(left, turn, -turn) / 2.0
        middle = np.stack(
            [
                np.cos(half) * out[:, 0] - np.sin(half) * out[:, 1],
                np.sin(half) * out[:, 0] + np.cos(half) * out[:, 1],
            ],
            axis=1,
        )
        middle = centre + middle * ((radius + other) / 2.0 / radius)[:, None]
        off = np.abs(radius - other) > _RADIUS_TOLERANCE * np.maximum(radius, other)
    for one in np.flatnonzero(off).tolist():
        notes.setdefault(int(rows[one]), []).append(
            Message("import.uncentred-arc", first=radius[one], second=other[one])
        )
    every = np.arange(len(arcs))
    ends = np.concatenate(
        [
            np.stack([start, np.where(two[:, None], middle, end)], axis=1),
            np.stack([middle, np.where(whole[:, None], start, end)], axis=1)[two],
        ]
    )
    which = np.concatenate([every, every[two]])
    return ends, np.concatenate([bulge, bulge[two]]), which


def _fit_ellipses(
    shape: _Shape, arcs: I64, linear: F64, shift: F64, tolerance: float
) -> tuple[F64, F64, F64, I64]:
    """Approximate the elliptic arcs that a non-uniform scale causes by lines and circular arcs.

    Parameters
    ----------
    shape
        Segments of a section.
    arcs
        Indices in ``shape`` of the arcs that become elliptic.
    linear, shift
        Matrix (2, 2) and translation (2,) from section coordinates to file units.
    tolerance
        Largest error of the approximation (file units).

    Returns
    -------
    start, end : (n, 2)
        Start and end points of the approximating segments (file units).
    bulge : (n,)
        Bulges of the approximating segments.
    which : (n,)
        Index in ``arcs`` of the arc that each segment approximates.
    """
    start, end, bulge = shape.ends[arcs, 0], shape.ends[arcs, 1], shape.bulge[arcs]
    chord = end - start
    left = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    centre = (start + end) / 2.0 + left * ((1.0 - bulge**2) / (4.0 * bulge))[:, None]
    u = start - centre
    v = np.stack([-u[:, 1], u[:, 0]], axis=1)
    turn = 4.0 * np.arctan(bulge)

    def point(k: I64, s: F64) -> F64:
        t = (turn[k] * s)[:, None]
        result: F64 = (centre[k] + np.cos(t) * u[k] + np.sin(t) * v[k]) @ linear.T + shift
        return result

    def tangent(k: I64, s: F64) -> F64:
        t = (turn[k] * s)[:, None]
        way = np.sign(turn[k])[:, None]
        result: F64 = way * (np.cos(t) * v[k] - np.sin(t) * u[k]) @ linear.T
        return result

    return fit_many(point, tangent, len(arcs), tolerance)
