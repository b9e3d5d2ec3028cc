"""expand: replace the calls in a CF2 by copies of the subroutines, and list all lines and arcs.

The function ``expand`` takes a ``Cf2File`` and returns an ``ExpandedFile``: the import report, the
lines and arcs, and the texts.  The copies are counted before they are made.  A bridge is a gap of
the steel rule in the die board, not a gap of the cut in the carton, so bridges appear only in the
import report.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from knifetip.cf2.records import Cf2File, Section
from knifetip.cf2.section_shape import SectionShape, StyleNumbers, place_shape, read_shape
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportWriter, too_far
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, I64
from knifetip.messages import Message
from knifetip.model.drawing import Annotation

_NAMES: Final = {"L": "L (line)", "A": "A (arc)", "T": "T (text)", "C": "C (call)"}


@dataclass(slots=True)
class ExpandedFile:
    """The lines, arcs and texts of a CF2 in file units, with all copies of its subroutines."""

    report: ReportWriter = field(default_factory=ReportWriter)
    styles: list[Style] = field(default_factory=list)
    annotations: list[Annotation] = field(default_factory=list)
    ends: list[F64] = field(default_factory=list)
    bulge: list[F64] = field(default_factory=list)
    fit_error: list[F64] = field(default_factory=list)
    row: list[I64] = field(default_factory=list)
    style: list[I64] = field(default_factory=list)

    def columns(self, reach: float) -> Columns:
        """Return the segments of all lines and arcs, in the order of the rows of the import report.

        Parameters
        ----------
        reach
            Largest permitted absolute value of a coordinate (file units).  A line or an arc that
            exceeds it is dropped, and the reason is added to the import report.
        """
        if not self.ends:
            none = np.zeros(0, np.int32)
            return Columns(np.zeros((0, 2, 2)), np.zeros(0), none, none)
        ends, bulge = np.concatenate(self.ends), np.concatenate(self.bulge)
        fit_error = np.concatenate(self.fit_error)
        row, style = np.concatenate(self.row), np.concatenate(self.style)
        order = np.argsort(row, kind="stable")
        ends, bulge, fit_error = ends[order], bulge[order], fit_error[order]
        row, style = row[order], style[order]
        farthest = np.abs(ends).max(axis=(1, 2))
        too_far_ = ~(farthest <= reach) | ~np.isfinite(bulge)
        for one in np.flatnonzero(too_far_).tolist():
            self.report.dropped[int(row[one])] = too_far(farthest[one], reach)
        # Both segments of an arc are dropped or kept together.
        keep = ~np.isin(row, row[too_far_]) if too_far_.any() else ~too_far_
        return Columns(
            ends[keep],
            bulge[keep],
            row[keep].astype(np.int32),
            style[keep].astype(np.int32),
            fit_error[keep],
        )


def expand(source: Cf2File, linear: F64, tolerance: float, limits: Limits) -> ExpandedFile:
    """Return the lines, arcs and texts of a CF2, with a copy of the subroutine for each call.

    Parameters
    ----------
    source
        The parsed file.
    linear : (2, 2)
        Matrix that is applied to the whole drawing.
    tolerance
        Largest error of the segments that approximate elliptic arcs (file units).  Arcs become
        elliptic if the scale of a call is not uniform.
    limits
        Limits of the depth of calls and of the numbers of records and segments.

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
    return expander.expanded


class _Expander:
    """Adds MAIN of one CF2 to the drawing, and a copy of a subroutine for each call."""

    def __init__(self, source: Cf2File, tolerance: float, limits: Limits) -> None:
        self._styles = StyleNumbers()
        self.expanded = ExpandedFile(styles=self._styles.styles)
        self._source = source
        self._tolerance = tolerance
        self._limits = limits
        self._shapes: dict[int, SectionShape] = {}
        self._used: set[str] = set()
        self._segments = 0
        self._check_size()

    def _check_size(self) -> None:
        """Raise DrawingTooLarge if the depth of calls or the number of records is too large.

        The number of records with all copies of subroutines is computed before any copy is made.
        """
        cached: dict[str, tuple[int, int]] = {}
        open_: set[str] = set()

        def size(section: Section, depth: int) -> tuple[int, int]:
            """Return the number of expanded records of a section, and its depth of nested calls.

            The number includes the records of the section itself and of all copies of subroutines
            that it calls directly or indirectly.  The second value is 0 for a section without
            calls.  The argument ``depth`` is the number of nested calls that contain the section.
            """
            total, deep = len(section.kind), 0
            for call in section.calls:
                name = call.name.upper()
                child = self._source.subs.get(name)
                if child is None or name in open_:
                    continue
                if depth >= self._limits.insert_depth:
                    raise self._too_deep()
                if name not in cached:
                    open_.add(name)
                    cached[name] = size(child, depth + 1)
                    open_.discard(name)
                records, levels = cached[name]
                total, deep = total + records, max(deep, levels + 1)
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
        self, section: Section, linear: F64, shift: F64, path: str, open_names: tuple[str, ...]
    ) -> None:
        """Add a copy of a section to the drawing, with copies of all subroutines that it calls.

        ``section``: MAIN or a subroutine.
        ``linear``, ``shift``: matrix (2, 2) and translation (2,) from section coordinates to file
        units.
        ``path``: handles in the import report of the nested calls that contain the copy, each
        followed by a slash; empty outside all calls.
        ``open_names``: names of the subroutines that contain this copy, and of ``section`` itself
        if it is a subroutine.  A call of one of them is recursive and is dropped.
        """
        shape = self._shapes.get(id(section))
        if shape is None:
            shape = self._shapes[id(section)] = read_shape(section, self._styles)
        report = self.expanded.report
        row_of = np.empty(len(section.kind), np.int64)
        reasons = {**section.dropped, **shape.dropped}
        first_record = 0
        for call in (*section.calls, None):
            last_record = len(section.kind) if call is None else call.row + 1
            first = len(report.handle)
            row_of[first_record:last_record] = np.arange(first, first + last_record - first_record)
            report.handle += [
                f"{path}#{entity}" for entity in section.entity[first_record:last_record]
            ]
            report.kind += [
                _NAMES.get(kind, kind) for kind in section.kind[first_record:last_record]
            ]
            report.layer += [section.name] * (last_record - first_record)
            first_record = last_record
            if call is None:
                break
            row = int(row_of[call.row])
            name = call.name.upper()
            child = self._source.subs.get(name)
            if child is None:
                report.dropped[row] = Message("import.missing-subroutine", name=call.name[:40])
                x, y = linear @ np.array(call.placement[:2]) + shift
                report.set_location(row, (x, y, x, y))
            elif name in open_names:
                report.dropped[row] = Message("import.subroutine-in-itself", name=call.name[:40])
            elif not all(math.isfinite(value) for value in call.placement):
                report.dropped[row] = Message("import.place-not-a-number")
            elif 0.0 in call.placement[3:]:
                self._used.add(name)
                x_scale, y_scale = call.placement[3:]
                report.dropped[row] = Message("import.no-scale", x=x_scale, y=y_scale)
            else:
                self._used.add(name)
                report.notes[row] = [Message("import.places-subroutine", name=call.name[:40])]
                inner = linear @ _linear(*call.placement[2:])
                moved = linear @ np.array(call.placement[:2]) + shift
                self.add_section(child, inner, moved, f"{report.handle[row]}/", (*open_names, name))
        for number, reason in reasons.items():
            report.dropped[int(row_of[number])] = reason
        for number, notes in shape.notes.items():
            report.notes[int(row_of[number])] = list(notes)
        self._add_shape(shape, linear, shift, row_of)
        size = math.sqrt(abs(float(np.linalg.det(linear))))
        for text in section.texts:
            x, y = linear @ np.array(text.placement[:2]) + shift
            report.set_location(int(row_of[text.row]), (x, y, x, y))
            if math.isfinite(x) and math.isfinite(y) and math.isfinite(text.placement[2]):
                self.expanded.annotations.append(
                    Annotation(
                        text.text,
                        float(x),
                        float(y),
                        abs(text.placement[2]) * size,
                        math.nan,
                        "TEXT",
                        section.name,
                    )
                )

    def report_unused(self) -> None:
        """Add a row to the import report for each subroutine that is never called."""
        for name, section in self._source.subs.items():
            if name not in self._used and section.kind:
                self.expanded.report.row(
                    section.name,
                    "SUB",
                    section.name,
                    Message(
                        "import.unused-subroutine",
                        name=section.name[:40],
                        records=len(section.kind),
                    ),
                )

    def _add_shape(self, shape: SectionShape, linear: F64, shift: F64, row_of: I64) -> None:
        """Add a transformed copy of the lines and arcs of a section to the drawing.

        ``linear``, ``shift``: matrix (2, 2) and translation (2,) from section coordinates to file
        units.
        ``row_of``: import report row of each record of the section.
        """
        if not len(shape.bulge):
            return
        ends, bulge, error, origin = place_shape(shape, linear, shift, self._tolerance)
        self.expanded.fit_error.append(error)
        self.expanded.ends.append(ends)
        self.expanded.bulge.append(bulge)
        self.expanded.row.append(row_of[shape.row[origin]])
        self.expanded.style.append(shape.style[origin])
        self._segments += len(bulge)
        if self._segments > self._limits.segments:
            raise DrawingTooLarge(
                "reading.too-many-segments", limit=self._limits.segments, format="CF2"
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
