"""Assemble a Drawing from the segments, styles and report rows that a format reader returns.

Segments of zero length are dropped.  Of several equal segments, only the first is kept.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportRows
from knifetip.formats.limits import REACH
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import POINT
from knifetip.geometry.unique_rows import unique_rows
from knifetip.kernels import F64_1, F64_3, I64_1, Bool_1, OutI64_1, OutU64_1, kernel
from knifetip.messages import Message
from knifetip.model.drawing import (
    KEPT,
    Annotation,
    Drawing,
    ImportOutcome,
    ImportReport,
    LocationBoxes,
)
from knifetip.model.unit import UnitHint, factor
from knifetip.model.words import RepeatedValues


class KnownUnit(NamedTuple):
    """The unit of length of a file, its scale, and the evidence for the unit.

    If the unit is unknown, the unit is "" and the scale is 0.
    """

    scale: float  #: millimetres per file unit, 0 if unknown
    unit: str  #: empty if unknown
    evidence: Message
    stated: str  #: unit in the header, empty if none
    hints: tuple[UnitHint, ...] = ()  #: other evidence in the header

    @classmethod
    def choose(
        cls,
        given: str | None,
        stated: str,
        evidence: Message,
        hints: tuple[UnitHint, ...] = (),
    ) -> KnownUnit:
        """Return the unit that the user gives, or else the unit that the file states.

        Parameters
        ----------
        given
            The unit that the user gives; None or "" if the user gives no unit.
        stated
            The unit that the file states; "" if it states none.
        evidence
            Evidence for the unit that the file states, or the reason why it states none.
        hints
            Other evidence in the header.

        Raises
        ------
        NoSuchUnit
            ``given`` is not a unit.
        """
        unit = given or stated
        source = Message("unit.given") if given else evidence
        return cls(factor(unit) if unit else 0.0, unit, source, stated, hints)


#: Bulges that differ by less than this are equal.
_TURN: Final = 1e-9
#: Hash multipliers, one for each number of a segment's key.
_FACTORS: Final = (
    np.uint64(0x9E3779B97F4A7C15),
    np.uint64(0xC2B2AE3D27D4EB4F),
    np.uint64(0x165667B19E3779F9),
    np.uint64(0xD6E8FEB86659FD93),
    np.uint64(0xA0761D6478BD642F),
)


def assemble(
    sheet: ReportRows,
    segments: Columns,
    styles: list[Style],
    annotations: Iterable[Annotation],
    known_unit: KnownUnit,
) -> Drawing:
    """Return the drawing without duplicate segments and without segments of zero length.

    Parameters
    ----------
    sheet
        Rows of the import report for all entities.
    segments
        n segments in file units.
    styles
        Styles of the segments, to which ``segments.style`` refers.
    annotations
        Texts and dimensions in file units.
    known_unit
        Unit of length of the file.  If its scale is 0, which means that the unit is unknown, the
        drawing stays in file units.
    """
    scale = known_unit.scale
    point = POINT / scale if scale else POINT / 1000.0
    length = arc.length(segments.ends[:, 0], segments.ends[:, 1], segments.bulge)
    no_length = ~(length >= point)
    layers, linetypes, attributes = _attributes(styles)
    # Styles that differ only in line width, or in upper and lower case of the layer, are equal.
    _, style_number = unique_rows(attributes[:, 1:5])
    first = _survivors(
        segments.ends, segments.bulge, style_number[segments.style], no_length, point
    )
    twice = first != np.arange(len(first))
    outcome, reason = _outcomes(sheet, segments, length, no_length, twice, first)
    specks = segments.ends[no_length], segments.row[no_length]
    if no_length.any() or twice.any():
        keep = ~(no_length | twice)
        length = length[keep]
        segments = Columns(
            segments.ends[keep],
            segments.bulge[keep],
            segments.row[keep],
            segments.style[keep],
            segments.fit_error[keep],
        )
    # ``bincount`` adds in file order, so sums are reproducible.
    kept_length: F64 = np.bincount(segments.row, length, minlength=len(outcome)).astype(np.float64)
    size = scale or 1.0
    # Adding 0 turns -0 into 0.
    ends = segments.ends * size
    ends += 0.0
    return Drawing(
        ends=_make_read_only(ends),
        bulge=_make_read_only(segments.bulge + 0.0),
        fit_error=_make_read_only(segments.fit_error * size),
        entity=_make_read_only(segments.row),
        layer=_make_read_only(attributes[:, 0].take(segments.style)),
        colour=_make_read_only(attributes[:, 2].take(segments.style)),
        true_colour=_make_read_only(attributes[:, 3].take(segments.style)),
        linetype=_make_read_only(attributes[:, 4].take(segments.style)),
        line_width=_make_read_only(attributes[:, 5].take(segments.style)),
        layers=layers,
        linetypes=linetypes,
        import_report=ImportReport(
            _as_tuple(sheet.handle),
            _as_tuple(sheet.kind),
            _as_tuple(sheet.layer),
            outcome,
            reason,
            kept_length * size,
            location_boxes=_location_boxes(sheet, outcome, specks, size),
        ),
        unit=known_unit.unit,
        evidence=known_unit.evidence,
        stated=known_unit.stated,
        hints=known_unit.hints,
        annotations=tuple(words.scaled(1.0, size) for words in annotations),
    )


def _make_read_only(column: NDArray[Any]) -> NDArray[Any]:
    """Make the array ``column`` read-only in place, and return it.

    Records copy writable arrays; a read-only array is used without a copy.
    """
    column.flags.writeable = False
    return column


def _as_tuple(words: Sequence[str]) -> Sequence[str]:
    return tuple(words) if isinstance(words, list) else words


def _attributes(styles: list[Style]) -> tuple[tuple[str, ...], tuple[str, ...], I32]:
    """Return the layer names, the linetype names, and an array with one row per style, (s, 6).

    A linetype is a pattern of dashes.  The six columns of the array are:

    * index of the layer in the layer names;
    * number of the layer name, the same for names that differ only in upper and lower case;
    * colour index;
    * true colour;
    * index of the linetype in the linetype names;
    * line width.
    """
    layers: dict[str, int] = {}
    folded: dict[str, int] = {}
    linetypes: dict[str, int] = {}
    rows = np.zeros((len(styles), 6), np.int32)
    for number, style in enumerate(styles):
        rows[number] = (
            layers.setdefault(style.layer, len(layers)),
            folded.setdefault(style.layer.lower(), len(folded)),
            style.colour,
            style.true_colour,
            linetypes.setdefault(style.linetype, len(linetypes)),
            style.line_width,
        )
    return tuple(layers), tuple(linetypes), rows


def _survivors(ends: F64, bulge: F64, style_number: I64, no_length: Bool, point: float) -> I64:
    """Return for each of n segments the index of the first segment that is equal to it, (n,).

    The index is the segment's own if no segment before it is equal.  Segments with the same
    geometry are also equal if they have opposite directions.

    ``ends`` (n, 2, 2): ends of the segments (file units).
    ``bulge`` (n,): bulges of the segments.
    ``style_number`` (n,): number of the style of each segment; equal segments have the same number.
    ``no_length`` (n,): mask of segments without length, which are not compared with other segments.
    ``point``: size of the grid to which coordinates are rounded before they are compared (file
    units).
    """
    slots = np.zeros(1 << max(4, (2 * len(bulge)).bit_length()), np.uint64)
    first = np.arange(len(bulge))
    _find_survivors(ends, bulge, style_number, no_length, 1.0 / point, slots, first)
    return first


@kernel
def _find_survivors(
    ends: F64_3,
    bulge: F64_1,
    style_number: I64_1,
    no_length: Bool_1,
    points: float,
    slots: OutU64_1,
    first: OutI64_1,
) -> None:
    """Write the index of the first equal segment of each of n segments into ``first``.

    Segments with the same geometry are also equal if they have opposite directions.

    ``ends`` (n, 2, 2): ends of the segments (file units).
    ``bulge``, ``style_number`` (n,): bulge and number of the style of each segment; equal segments
    have the same number.
    ``no_length`` (n,): mask of segments that are not compared; their entries in ``first`` are not
    changed.
    ``points``: 1 divided by the size of the grid to which coordinates are rounded (1 / file unit).
    ``slots``: working array for a hash table, filled with zeros; its length is a power of two.  The
    function changes it.
    ``first`` (n,): on entry, entry i must be i.
    """
    mask, low = np.uint64(len(slots) - 1), np.uint64(0xFFFFFFFF)
    for row in range(len(bulge)):
        if no_length[row]:
            continue
        key_numbers = _segment_key(ends, bulge, row, points)
        key = np.uint64(style_number[row])
        for column in range(len(_FACTORS)):
            key += np.uint64(key_numbers[column]) * _FACTORS[column]
        key = (key ^ (key >> np.uint64(32))) * _FACTORS[0]
        slot = (key ^ (key >> np.uint64(29))) & mask
        # A slot holds the upper half of a segment's key, and its row plus one.
        while slots[slot] > 0:
            if (slots[slot] ^ key) <= low:
                other_row: Any = np.int64(slots[slot] & low) - 1
                if (
                    style_number[other_row] == style_number[row]
                    and _segment_key(ends, bulge, other_row, points) == key_numbers
                ):
                    first[row] = other_row
                    break
            slot = (slot + np.uint64(1)) & mask
        else:
            slots[slot] = (key & ~low) | np.uint64(row + 1)


@kernel
def _segment_key(ends: F64_3, bulge: F64_1, row: int, points: float) -> Any:
    """Return ends and bulge of the segment in row ``row`` as five integers.

    The integers do not depend on the direction of the segment.  Coordinates are multiplied by
    ``points`` and rounded.
    """
    ax, ay = np.rint(ends[row, 0, 0] * points), np.rint(ends[row, 0, 1] * points)
    bx, by = np.rint(ends[row, 1, 0] * points), np.rint(ends[row, 1, 1] * points)
    turn = np.rint(bulge[row] / _TURN)
    # The lower end first.
    if ax > bx or (ax == bx and ay > by):
        ax, ay, bx, by, turn = bx, by, ax, ay, -turn
    return np.int64(ax), np.int64(ay), np.int64(bx), np.int64(by), np.int64(turn)


def _outcomes(
    sheet: ReportRows, segments: Columns, length: F64, no_length: Bool, duplicate: Bool, first: I64
) -> tuple[U8, RepeatedValues[Message]]:
    """Return the outcome (kept, merged or dropped) and its reason for each entity, (m,) each.

    The reason of a kept entity contains the notes about changes that were made to it.

    ``sheet``: the import report, with one row for each of the m entities.
    ``segments``: n segments of the entities, with the report row of each segment.
    ``length`` (n,): length of each segment (file units).
    ``no_length``, ``duplicate`` (n,): mask of the segments without length, and mask of the segments
    that are equal to an earlier segment.
    ``first`` (n,): index of the first segment that is equal to each segment.
    """
    rows = len(sheet.handle)
    outcome = np.full(rows, ImportOutcome.KEPT, np.uint8)
    reason = np.zeros(rows, np.int32)
    reasons = {KEPT: 0}
    shared_item = np.full(rows, -1, np.int32)
    for number, same in enumerate(sheet.shared):
        shared_item[same.rows] = number
        reason[same.rows] = reasons.setdefault(
            same.dropped or _kept_message(same.notes), len(reasons)
        )
        if same.dropped:
            outcome[same.rows] = ImportOutcome.DROPPED
    total = np.bincount(segments.row, minlength=rows)
    short_count = np.bincount(segments.row[no_length], minlength=rows)
    doubles = np.bincount(segments.row[duplicate], minlength=rows)
    longest: dict[int, float] = {}
    for row, one in zip(segments.row[no_length].tolist(), length[no_length].tolist(), strict=True):
        longest[row] = max(longest.get(row, 0.0), one)
    survivors: dict[int, Counter[int]] = {}
    for row, survivor in zip(
        segments.row[duplicate].tolist(), segments.row[first[duplicate]].tolist(), strict=True
    ):
        survivors.setdefault(row, Counter())[survivor] += 1
    for row in {*sheet.dropped, *sheet.notes, *longest, *survivors}:
        notes: list[Message] = [
            *(sheet.shared[shared_item[row]].notes if shared_item[row] >= 0 else ())
        ]
        notes.extend(sheet.notes.get(row, ()))
        cause: Message | None = None
        if row in sheet.dropped:
            outcome[row], cause = ImportOutcome.DROPPED, sheet.dropped[row]
        elif total[row] and short_count[row] == total[row]:
            outcome[row], cause = (
                ImportOutcome.DROPPED,
                Message("import.no-length", length=longest[row]),
            )
        elif short_count[row]:
            notes.append(
                Message("import.pieces-no-length", pieces=short_count[row], all=total[row])
            )
        if doubles[row] and cause is None:
            handles, more = _duplicate_handles(row, survivors[row], sheet.handle)
            if doubles[row] + short_count[row] == total[row]:
                outcome[row], cause = ImportOutcome.MERGED, _drawn_twice(handles, more)
            else:
                notes.append(_pieces_drawn_twice(doubles[row], total[row], handles, more))
        reason[row] = reasons.setdefault(cause or _kept_message(notes), len(reasons))
    return outcome, RepeatedValues(tuple(reasons), reason)


def _location_boxes(
    sheet: ReportRows, outcome: U8, short_segments: tuple[F64, I32], size: float
) -> LocationBoxes:
    """Return the bounding boxes (mm) of dropped report rows whose location is known.

    ``sheet``: the m rows of the import report.
    ``outcome`` (m,): ImportOutcome of each report row.
    ``short_segments``: ends (s, 2, 2) in file units and report rows (s,) of s segments without
    length.
    ``size``: millimetres per file unit.
    """
    ends, row = short_segments
    segment_boxes = np.concatenate([ends.min(axis=1), ends.max(axis=1)], axis=1)
    rows = np.concatenate([row, *(one.rows for one in sheet.location_boxes)])
    box = np.concatenate([segment_boxes, *(one.box for one in sheet.location_boxes)])
    box = box * size
    located = (outcome[rows] == ImportOutcome.DROPPED) & (np.abs(box) <= REACH).all(axis=1)
    # One box per row is enough.
    rows, last = np.unique(rows[located][::-1], return_index=True)
    return LocationBoxes(rows, box[located][::-1][last])


def _kept_message(notes: Sequence[Message]) -> Message:
    return Message("import.kept-changed", notes=notes) if notes else KEPT


def _drawn_twice(same: list[str], further: int) -> Message:
    if further:
        return Message("import.drawn-twice-often", same=same, more=further)
    return Message("import.drawn-twice", same=same)


def _pieces_drawn_twice(pieces: int, total: int, same: list[str], further: int) -> Message:
    if further:
        return Message(
            "import.pieces-drawn-twice-often", pieces=pieces, all=total, same=same, more=further
        )
    return Message("import.pieces-drawn-twice", pieces=pieces, all=total, same=same)


def _duplicate_handles(
    row: int, equal_segments: Counter[int], handles: Sequence[str]
) -> tuple[list[str], int]:
    """Return up to 5 handles of entities whose segments an entity repeats, and how many more exist.

    Entities with the most repeated segments come first.

    ``row``: report row of the entity that repeats segments.  If it repeats its own segments, its
    handle is replaced by "itself".
    ``equal_segments``: report row of each entity whose segments are repeated, and the number of
    these segments.
    ``handles``: handle of the entity of each report row.
    """
    names = [
        "itself" if other_row == row else handles[other_row]
        for other_row, _ in equal_segments.most_common(6)
    ]
    return names[:5], max(len(equal_segments) - 5, 0)
