"""place: the sections of a CF2 where they are called, as columns of lines and arcs.

    Source, tolerance -> Placed: ReportWriter, Columns, inscriptions

What the calls stand for is counted before it is followed.  Bridges are kept in the ledger's words
and nowhere else: they are gaps of the rule in the die board, and not in the carton (decision 9).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Final

import numpy as np

from knifetip.cf2.records import Section, Source
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportWriter
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.curve import each
from knifetip.geometry.tolerance import BULGE
from knifetip.model.drawing import Inscription

#: Radii at both ends of an arc that differ by more than this share of them are worth a word.
_ROUND: Final = 1e-3
_NAMES: Final = {"L": "L (line)", "A": "A (arc)", "T": "T (text)", "C": "C (call)"}


@dataclass(slots=True)
class Placed:
    """What a file draws, in file units."""

    sheet: ReportWriter = field(default_factory=ReportWriter)
    styles: list[Style] = field(default_factory=list)
    inscriptions: list[Inscription] = field(default_factory=list)
    ends: list[F64] = field(default_factory=list)
    bulge: list[F64] = field(default_factory=list)
    row: list[I64] = field(default_factory=list)
    style: list[I64] = field(default_factory=list)

    def columns(self, reach: float) -> Columns:
        """Return the segments in the order of the ledger, without those beyond reach."""
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
            where = f"{far[one]:g}" if np.isfinite(far[one]) else "not a number"
            self.sheet.dropped[int(row[one])] = f"a coordinate is {where}; the limit is {reach:g}"
        # An arc of two rows goes or stays as one.
        keep = ~np.isin(row, row[beyond]) if beyond.any() else ~beyond
        return Columns(
            ends[keep], bulge[keep], row[keep].astype(np.int32), style[keep].astype(np.int32)
        )


@dataclass(frozen=True, eq=False, slots=True)
class _Shape:
    """The lines and arcs of a section, where it is drawn itself."""

    ends: F64  #: (n, 2, 2)
    bulge: F64  #: (n,)
    row: I64  #: (n,) of the section
    style: I64  #: (n,)
    dropped: dict[int, str]  #: row -> why it is left out
    notes: dict[int, list[str]]  #: row -> what is to be said of it


def placed(source: Source, linear: F64, tolerance: float, limits: Limits) -> Placed:
    """Return everything that a CF2 draws.

    Parameters
    ----------
    linear : (2, 2)
        What the whole sheet goes through.
    tolerance
        Of arcs that an uneven scale makes elliptic (file units).

    Raises
    ------
    DrawingTooLarge
        Calls are nested deeper, or stand for more records, than the limits allow.
    """
    walk = _Walk(source, tolerance, limits)
    start = linear, np.zeros(2)
    main = source.main
    if main is not None:
        walk.section(main, *start, "", ())
    if main is None or not main.kind:
        # Nothing says where the subroutines belong: each stands where it is drawn.
        for name, section in source.subs.items():
            walk.section(section, *start, "", (name,))
    else:
        walk.idle()
    return walk.found


class _Walk:
    def __init__(self, source: Source, tolerance: float, limits: Limits) -> None:
        self.found = Placed()
        self._source = source
        self._tolerance = tolerance
        self._limits = limits
        self._shapes: dict[int, _Shape] = {}
        self._numbers: dict[Style, int] = {}
        self._used: set[str] = set()
        self._segments = 0
        self._count()

    def _count(self) -> None:
        known: dict[str, tuple[int, int]] = {}
        open_: set[str] = set()

        def size(section: Section, depth: int) -> tuple[int, int]:
            """Return how many records a section stands for, and how deep its calls go."""
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

    def section(
        self, section: Section, linear: F64, shift: F64, path: str, above: tuple[str, ...]
    ) -> None:
        """Draw a section, and all that it calls."""
        shape = self._shapes.get(id(section))
        if shape is None:
            shape = self._shapes[id(section)] = self._drawn(section)
        sheet = self.found.sheet
        row_of = np.empty(len(section.kind), np.int64)
        told = {**section.dropped, **shape.dropped}
        at = 0
        for call in (*section.calls, None):
            until = len(section.kind) if call is None else call.row + 1
            first = len(sheet.handle)
            row_of[at:until] = np.arange(first, first + until - at)
            sheet.handle += [f"{path}#{entity}" for entity in section.entity[at:until]]
            sheet.kind += [_NAMES.get(kind, kind) for kind in section.kind[at:until]]
            sheet.layer += [section.name] * (until - at)
            at = until
            if call is None:
                break
            row = int(row_of[call.row])
            name = call.name.upper()
            child = self._source.subs.get(name)
            if child is None:
                sheet.dropped[row] = f"there is no subroutine {call.name[:40]}"
                x, y = linear @ np.array(call.place[:2]) + shift
                sheet.set_location(row, (x, y, x, y))
            elif name in above:
                sheet.dropped[row] = f"the subroutine {call.name[:40]} contains itself"
            elif not all(math.isfinite(value) for value in call.place):
                sheet.dropped[row] = "its place is not a number"
            else:
                self._used.add(name)
                sheet.notes[row] = [f"places the subroutine {call.name[:40]}"]
                inner = linear @ _linear(*call.place[2:])
                moved = linear @ np.array(call.place[:2]) + shift
                self.section(child, inner, moved, f"{sheet.handle[row]}/", (*above, name))
        for number, why in told.items():
            sheet.dropped[int(row_of[number])] = why
        for number, notes in shape.notes.items():
            sheet.notes[int(row_of[number])] = list(notes)
        self._place(shape, linear, shift, row_of)
        size = math.sqrt(abs(float(np.linalg.det(linear))))
        for words in section.words:
            x, y = linear @ np.array(words.place[:2]) + shift
            sheet.set_location(int(row_of[words.row]), (x, y, x, y))
            if math.isfinite(x) and math.isfinite(y) and math.isfinite(words.place[2]):
                self.found.inscriptions.append(
                    Inscription(
                        words.text,
                        float(x),
                        float(y),
                        abs(words.place[2]) * size,
                        math.nan,
                        "TEXT",
                        section.name,
                    )
                )

    def idle(self) -> None:
        """Say of the subroutines that nothing calls that they hold lines and draw none."""
        for name, section in self._source.subs.items():
            if name not in self._used and section.kind:
                self.found.sheet.row(
                    section.name,
                    "SUB",
                    section.name,
                    f"the subroutine {section.name[:40]} of {len(section.kind)} records: nothing "
                    "calls it",
                )

    def _place(self, shape: _Shape, linear: F64, shift: F64, row_of: I64) -> None:
        if not len(shape.bulge):
            return
        u, v = linear[:, 0], linear[:, 1]
        uneven = abs(u @ v) + abs(u @ u - v @ v) > 1e-9 * (u @ u + v @ v)
        side = 1.0 if u[0] * v[1] - u[1] * v[0] > 0.0 else -1.0
        ends, bulge, row, style = (
            shape.ends @ linear.T + shift,
            side * shape.bulge,
            *(
                shape.row,
                shape.style,
            ),
        )
        if uneven and (arcs := np.flatnonzero(np.abs(shape.bulge) >= BULGE)).size:
            straight = np.flatnonzero(np.abs(shape.bulge) < BULGE)
            start, end, curved, which = _ovals(shape, arcs, linear, shift, self._tolerance)
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

    def _drawn(self, section: Section) -> _Shape:
        dropped: dict[int, str] = {}
        notes: dict[int, list[str]] = {}
        lines, line_row = _numbers(section.line, section.line_row, slice(4, 8), dropped)
        arcs, arc_row = _numbers(section.arc, section.arc_row, slice(4, 11), dropped)
        ends, bulge, which = _round(arcs, arc_row, notes)
        row = np.concatenate([line_row, arc_row[which]])
        style_of = np.zeros(len(section.kind), np.int64)
        style_of[section.line_row] = self._styles(section.name, section.line)
        style_of[section.arc_row] = self._styles(section.name, section.arc)
        for rows, records, first in (
            (section.line_row, section.line, 8),
            (section.arc_row, section.arc, 11),
        ):
            for one, record in zip(rows, records, strict=True):
                if len(record) > first and record[first].strip() not in ("0", ""):
                    _bridged(record[first : first + 2], notes.setdefault(one, []))
        return _Shape(
            np.concatenate([lines.reshape(-1, 2, 2), ends]),
            np.concatenate([np.zeros(len(lines)), bulge]),
            row,
            style_of[row],
            dropped,
            {one: said for one, said in notes.items() if said},
        )

    def _styles(self, layer: str, records: Sequence[Sequence[str]]) -> list[int]:
        """Return which style each record has."""
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
        words = ["CF2", _whole(kind)]
        if _whole(aux) != "0":
            words += ["aux", _whole(aux)]
        words.append(f"{_whole(point)}pt")
        style = Style(layer, 7, -1, " ".join(words))
        number = self._numbers.setdefault(style, len(self.found.styles))
        if number == len(self.found.styles):
            self.found.styles.append(style)
        return number


def _whole(text: str) -> str:
    """Return a number of a type as it is best compared: 1 for 1.0 and 01."""
    try:
        return f"{float(text):g}"
    except ValueError:
        return text[:20] or "0"


def _bridged(fields: Sequence[str], notes: list[str]) -> None:
    """Note the bridges of a rule, in the words of the trade."""
    try:
        count = float(fields[0])
        width = float(fields[1]) if len(fields) > 1 else 0.0
    except ValueError:
        return
    if count >= 1.0 and math.isfinite(count) and math.isfinite(width):
        notes.append(f"{count:g} bridge{'s' * (count != 1.0)} of {width:g} in the die board")


def _linear(angle: float, x_scale: float, y_scale: float) -> F64:
    """Return what scales first and then turns, (2, 2)."""
    quarter, rest = divmod(angle % 360.0, 90.0)
    cosine, sine = (
        ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
        if rest == 0.0
        else (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    )
    return np.array([[cosine * x_scale, -sine * y_scale], [sine * x_scale, cosine * y_scale]])


def _numbers(
    records: Sequence[Sequence[str]], rows: Sequence[int], where: slice, dropped: dict[int, str]
) -> tuple[F64, I64]:
    """Return the coordinates of records (n, k) and their rows (n,), without unreadable ones."""
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
        except ValueError as reason:
            dropped[rows[at]] = f"it cannot be read: {str(reason)[:80]}"
    good = np.array([one not in dropped for one in rows], bool)
    return values[good], row[good]


def _round(arcs: F64, rows: I64, notes: dict[int, list[str]]) -> tuple[F64, F64, I64]:
    """Return arcs in rows of at most half a turn: ends (n, 2, 2), bulge (n,), which arc (n,).

    The ends are those of the record; where the centre is not in their middle, the arc is one
    through both ends that turns as far as seen from there.
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
        # Back at its start it is a whole circle, to the last place that such files print.
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
        off = np.abs(radius - other) > _ROUND * np.maximum(radius, other)
    for one in np.flatnonzero(off).tolist():
        notes.setdefault(int(rows[one]), []).append(
            f"its centre is {radius[one]:g} from one end and {other[one]:g} from the other"
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


def _ovals(
    shape: _Shape, arcs: I64, linear: F64, shift: F64, tolerance: float
) -> tuple[F64, F64, F64, I64]:
    """Fit arcs that an uneven scale makes elliptic; return start, end, bulge and which."""
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

    return each(point, tangent, len(arcs), tolerance)
