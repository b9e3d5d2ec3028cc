"""Convert the lines and arcs of one section of a CF2 file to segments, and place copies of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import chain
from typing import Final

import numpy as np

from knifetip.cf2.records import Section, parse_number
from knifetip.drawing_builder.columns import Style
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.curve import Segments, fit_many
from knifetip.geometry.tolerance import BULGE
from knifetip.messages import Message

#: Relative difference of the radii at the ends of an arc above which the report has a note.
_RADIUS_TOLERANCE: Final = 1e-3
#: Largest number of characters of a field in a message.
_MAX_SHOWN: Final = 20


@dataclass(frozen=True, eq=False, slots=True)
class SectionShape:
    """The segments of the lines and arcs of a CF2 section, in the coordinates of the section."""

    ends: F64  #: (n, 2, 2) start and end points of n segments
    bulge: F64  #: (n,) bulge of each segment
    row: I64  #: (n,) row of each segment in the section
    style: I64  #: (n,) index of the style of each segment
    dropped: dict[int, Message]  #: row -> reason why the record is dropped
    notes: dict[int, list[Message]]  #: row -> notes in the import report


class StyleNumbers:
    """The styles of a drawing, numbered in the order in which they are first used."""

    def __init__(self) -> None:
        self.styles: list[Style] = []
        self._numbers: dict[Style, int] = {}

    def number_records(self, layer: str, records: Sequence[Sequence[str]]) -> list[int]:
        """Return for each record the index into ``self.styles`` of the style of the record.

        New styles are added to this list.

        Parameters
        ----------
        layer
            Layer of all the records.
        records
            Fields of each record of a line or an arc.
        """
        cached: dict[tuple[str, str, str], int] = {}
        numbers = []
        for record in records:
            key = record[1], record[2], record[3]
            number = cached.get(key)
            if number is None:
                number = cached[key] = self._number(layer, *(text.strip() for text in key))
            numbers.append(number)
        return numbers

    def _number(self, layer: str, point: str, kind: str, aux: str) -> int:
        """Return the index of one style in ``self.styles``; the style is added if it is new.

        ``point``, ``kind``, ``aux``: fields of a record, as written: thickness of the steel rule in
        points, type of the line, and auxiliary type.
        """
        words = ["CF2", _normalise_number(kind)]
        if _normalise_number(aux) != "0":
            words += ["aux", _normalise_number(aux)]
        words.append(f"{_normalise_number(point)}pt")
        style = Style(layer, 7, -1, " ".join(words))
        number = self._numbers.setdefault(style, len(self.styles))
        if number == len(self.styles):
            self.styles.append(style)
        return number


def read_shape(section: Section, styles: StyleNumbers) -> SectionShape:
    """Return the segments of the lines and arcs of a section.

    The result also contains the reasons for dropped records, and notes for the import report.
    The styles of the records are added to ``styles``.
    """
    dropped: dict[int, Message] = {}
    notes: dict[int, list[Message]] = {}
    lines, line_row = _coordinates(section.line, section.line_row, slice(4, 8), dropped)
    arcs, arc_row = _coordinates(section.arc, section.arc_row, slice(4, 11), dropped)
    arcs, arc_row = _with_radius(arcs, arc_row, dropped)
    ends, bulge, arc = _split_arcs(arcs, arc_row, notes)
    row = np.concatenate([line_row, arc_row[arc]])
    style_of = np.zeros(len(section.kind), np.int64)
    style_of[section.line_row] = styles.number_records(section.name, section.line)
    style_of[section.arc_row] = styles.number_records(section.name, section.arc)
    for rows, records, first in (
        (section.line_row, section.line, 8),
        (section.arc_row, section.arc, 11),
    ):
        for one, record in zip(rows, records, strict=True):
            if len(record) > first and record[first].strip() not in ("0", ""):
                _note_bridges(record[first : first + 2], notes.setdefault(one, []))
    return SectionShape(
        np.concatenate([lines.reshape(-1, 2, 2), ends]),
        np.concatenate([np.zeros(len(lines)), bulge]),
        row,
        style_of[row],
        dropped,
        {one: texts for one, texts in notes.items() if texts},
    )


def place_shape(
    shape: SectionShape, linear: F64, shift: F64, tolerance: float
) -> tuple[F64, F64, F64, I64]:
    """Return a transformed copy of the segments of a section.

    Arcs become elliptic if the scale is not uniform; they are then approximated by circular arcs.

    Parameters
    ----------
    shape
        Segments of the section.
    linear, shift
        Matrix (2, 2) and translation (2,) from section coordinates to file units.
    tolerance
        Largest error of the approximation (file units).

    Returns
    -------
    ends : (n, 2, 2)
        Start and end points of the segments of the copy (file units).
    bulge : (n,)
        Bulges of the segments of the copy.
    error : (n,)
        Greatest distance of each segment from the elliptic arc that it approximates (file units); 0
        for an exact segment.
    origin : (n,)
        For each segment of the copy, the index in ``shape`` of the segment from which it was made.
    """
    u, v = linear[:, 0], linear[:, 1]
    uneven = abs(u @ v) + abs(u @ u - v @ v) > 1e-9 * (u @ u + v @ v)
    side = 1.0 if u[0] * v[1] - u[1] * v[0] > 0.0 else -1.0
    ends, bulge = shape.ends @ linear.T + shift, side * shape.bulge
    arcs = np.flatnonzero(np.abs(shape.bulge) >= BULGE)
    if not (uneven and arcs.size):
        return ends, bulge, np.zeros(len(bulge)), np.arange(len(bulge))
    straight = np.flatnonzero(np.abs(shape.bulge) < BULGE)
    (start, end, fitted, error), arc = _fit_ellipses(shape, arcs, linear, shift, tolerance)
    return (
        np.concatenate([ends[straight], np.stack([start, end], axis=1)]),
        np.concatenate([bulge[straight], fitted]),
        np.concatenate([np.zeros(len(straight)), error]),
        np.concatenate([straight, arcs[arc]]),
    )


def _normalise_number(text: str) -> str:
    """Return the number written in ``text`` in its shortest form, such as "1" for "1.0" and "01".

    A text that is not a number is returned unchanged, cut to 20 characters.  "0" is returned for an
    empty text.
    """
    try:
        return f"{float(text):g}"
    except ValueError:
        return text[:20] or "0"


def _note_bridges(fields: Sequence[str], notes: list[Message]) -> None:
    """Add a note to ``notes`` if the steel rule of a line or an arc has bridges (gaps).

    ``fields`` contains two fields of the record of the line or arc: number and width of the
    bridges.
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


def _coordinates(
    records: Sequence[Sequence[str]],
    rows: Sequence[int],
    fields: slice,
    dropped: dict[int, Message],
) -> tuple[F64, I64]:
    """Return the coordinates of the n valid records, (n, k), and the rows of these records, (n,).

    ``fields``: slice of the k fields of a record that are coordinates.
    ``dropped``: reasons for dropped records, by row.  A reason is added for each record with
    invalid coordinates.
    """
    wide = fields.stop - fields.start
    row = np.array(rows, np.int64)
    texts = list(chain.from_iterable(record[fields] for record in records))
    if "_" not in "".join(texts):
        with suppress(ValueError):
            return np.array(list(map(float, texts))).reshape(-1, wide), row
    values = np.full((len(records), wide), np.nan)
    for index, record in enumerate(records):
        try:
            values[index] = [parse_number(text) for text in record[fields]]
        except ValueError:
            shown = [text[:_MAX_SHOWN] for text in record[fields]]
            dropped[rows[index]] = Message("import.not-numbers", values=shown)
    good = np.array([one not in dropped for one in rows], bool)
    return values[good], row[good]


def _with_radius(arcs: F64, rows: I64, dropped: dict[int, Message]) -> tuple[F64, I64]:
    """Return the arcs whose centre is neither their start nor their end, and their rows.

    ``arcs`` (k, 7): start, end, centre and direction of each arc.
    ``rows`` (k,): row of each arc in its section.
    ``dropped``: reasons for dropped records, by row; a reason is added for each other arc.
    """
    start, end, centre = arcs[:, :2], arcs[:, 2:4], arcs[:, 4:6]
    without = (start == centre).all(axis=1) | (end == centre).all(axis=1)
    for row in rows[without].tolist():
        dropped[row] = Message("import.bad-radius", radius=0.0)
    return arcs[~without], rows[~without]


def _split_arcs(arcs: F64, rows: I64, notes: dict[int, list[Message]]) -> tuple[F64, F64, I64]:
    """Split each of k arcs into one or two segments of at most half a turn.

    A record of an arc contains start, end and centre.  If the centre is not equally far from start
    and end, the arc still joins start and end, and its sweep angle is the angle between them as
    seen from the centre.

    ``arcs`` (k, 7): start, end, centre and direction of each arc.
    ``rows`` (k,): row of each arc in its section.
    ``notes``: notes by row; a note is added for each arc with different radii at start and end.
    Returns ``ends`` (n, 2, 2): start and end points of the segments; ``bulge`` (n,): bulges of the
    segments; ``arc`` (n,): index in ``arcs`` of the arc of each segment.
    """
    start, end, centre, direction = arcs[:, :2], arcs[:, 2:4], arcs[:, 4:6], arcs[:, 6]
    with np.errstate(all="ignore"):
        from_centre, to_centre = start - centre, end - centre
        radius, end_radius = np.hypot(*from_centre.T), np.hypot(*to_centre.T)
        turn = np.arctan2(
            from_centre[:, 0] * to_centre[:, 1] - from_centre[:, 1] * to_centre[:, 0],
            (from_centre * to_centre).sum(axis=1),
        ) % (2.0 * np.pi)
        counter_clockwise = direction >= 0.0
        turn = np.where(counter_clockwise, turn, 2.0 * np.pi - turn)
        # Equal ends, within the precision of such files, mean a whole circle.
        full_circle = np.hypot(*(end - start).T) <= 1e-6 * np.maximum(radius, 1.0)
        turn = np.where(full_circle, 2.0 * np.pi, turn)
        two = turn > np.pi * (1.0 + 1e-9)
        bulge = np.where(counter_clockwise, 1.0, -1.0) * np.minimum(
            np.tan(turn / np.where(two, 8.0, 4.0)), 1.0
        )
        half = np.where(counter_clockwise, turn, -turn) / 2.0
        middle = np.stack(
            [
                np.cos(half) * from_centre[:, 0] - np.sin(half) * from_centre[:, 1],
                np.sin(half) * from_centre[:, 0] + np.cos(half) * from_centre[:, 1],
            ],
            axis=1,
        )
        middle = centre + middle * ((radius + end_radius) / 2.0 / radius)[:, None]
        off = np.abs(radius - end_radius) > _RADIUS_TOLERANCE * np.maximum(radius, end_radius)
    for one in np.flatnonzero(off).tolist():
        notes.setdefault(int(rows[one]), []).append(
            Message("import.uncentred-arc", first=radius[one], second=end_radius[one])
        )
    every = np.arange(len(arcs))
    ends = np.concatenate(
        [
            np.stack([start, np.where(two[:, None], middle, end)], axis=1),
            np.stack([middle, np.where(full_circle[:, None], start, end)], axis=1)[two],
        ]
    )
    arc = np.concatenate([every, every[two]])
    return ends, np.concatenate([bulge, bulge[two]]), arc


def _fit_ellipses(
    shape: SectionShape, arcs: I64, linear: F64, shift: F64, tolerance: float
) -> tuple[Segments, I64]:
    """Return lines and circular arcs that approximate elliptic arcs.

    The arcs of a section become elliptic if ``linear`` scales x and y differently.

    ``arcs``: indices in ``shape`` of the arcs that become elliptic.
    ``linear``, ``shift``: matrix (2, 2) and translation (2,) from section coordinates to file
    units.
    ``tolerance``: largest error of the approximation (file units).
    Returns segments: the n approximating segments (file units); ``arc`` (n,): index in ``arcs`` of
    the arc that each segment approximates.
    """
    start, end, bulge = shape.ends[arcs, 0], shape.ends[arcs, 1], shape.bulge[arcs]
    chord = end - start
    normal = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    centre = (start + end) / 2.0 + normal * ((1.0 - bulge**2) / (4.0 * bulge))[:, None]
    u = start - centre
    v = np.stack([-u[:, 1], u[:, 0]], axis=1)
    turn = 4.0 * np.arctan(bulge)

    def point(k: I64, s: F64) -> F64:
        t = (turn[k] * s)[:, None]
        result: F64 = (centre[k] + np.cos(t) * u[k] + np.sin(t) * v[k]) @ linear.T + shift
        return result

    def tangent(k: I64, s: F64) -> F64:
        t = (turn[k] * s)[:, None]
        sign = np.sign(turn[k])[:, None]
        result: F64 = sign * (np.cos(t) * v[k] - np.sin(t) * u[k]) @ linear.T
        return result

    fits = fit_many(point, tangent, len(arcs), tolerance)
    if fits.failed:
        raise next(iter(fits.failed.values()))
    return fits.segments, fits.curve
