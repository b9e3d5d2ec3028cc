"""expand: replace the calls in a CF2 by copies of the subroutines, and list all lines and arcs.

    Cf2File, tolerance -> ExpandedFile: ReportWriter, Columns, annotations

The copies are counted before they are made.  A bridge is a gap of the steel rule in the die board,
not a gap of the cut in the carton, so bridges appear only in the import report (decision 9).
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
        self._styles = StyleNumbers()
        self.found = ExpandedFile(styles=self._styles.styles)
        self._source = source
        self._tolerance = tolerance
        self._limits = limits
        self._shapes: dict[int, SectionShape] = {}
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
            shape = self._shapes[id(section)] = read_shape(section, self._styles)
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

    def _add_shape(self, shape: SectionShape, linear: F64, shift: F64, row_of: I64) -> None:
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
        ends, bulge, origin = place_shape(shape, linear, shift, self._tolerance)
        self.found.ends.append(ends)
        self.found.bulge.append(bulge)
        self.found.row.append(row_of[shape.row[origin]])
        self.found.style.append(shape.style[origin])
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
