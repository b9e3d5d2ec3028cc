"""Assemble a Drawing from the segments, styles and report rows of a reader.

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
from knifetip.model.unit import UnitHint
from knifetip.model.words import Repeated


class KnownUnit(NamedTuple):
    """The unit of a file, if known, and the statements of the file header about the unit."""

    scale: float  #: millimetres per file unit, 0 if unknown
    unit: str  #: empty if unknown
    evidence: Message
    stated: str  #: unit in the header, empty if none
    hints: tuple[UnitHint, ...] = ()  #: other evidence in the header


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
    found: Columns,
    styles: list[Style],
    annotations: Iterable[Annotation],
    known: KnownUnit,
) -> Drawing:
    """Return the drawing without duplicate segments and without segments of zero length.

    Parameters
    ----------
    sheet
        Report rows of all entities.
    found
        n segments in file units.
    styles
        Styles of the segments, to which ``found.style`` refers.
    annotations
        Texts and dimensions in file units.
    known
        The unit of the file.
    """
    scale = known.scale
    point = POINT / scale if scale else POINT / 1000.0
    length = arc.length(found.ends[:, 0], found.ends[:, 1], found.bulge)
    speck = ~(length >= point)
    layers, linetypes, attributes = _attributes(styles)
    # Styles that differ only in upper and lower case of the layer are equal.
    _, alike = unique_rows(attributes[:, 1:])
    first = _survivors(found.ends, found.bulge, alike[found.style], speck, point)
    twice = first != np.arange(len(first))
    outcome, reason = _outcomes(sheet, found, length, speck, twice, first)
    specks = found.ends[speck], found.row[speck]
    if speck.any() or twice.any():
        keep = ~(speck | twice)
        length = length[keep]
        found = Columns(found.ends[keep], found.bulge[keep], found.row[keep], found.style[keep])
    # ``bincount`` adds in file order, so sums are reproducible.
    kept_length: F64 = np.bincount(found.row, length, minlength=len(outcome)).astype(np.float64)
    size = scale or 1.0
    # Adding 0 turns -0 into 0.
    ends = found.ends * size
    ends += 0.0
    return Drawing(
        ends=_owned(ends),
        bulge=_owned(found.bulge + 0.0),
        entity=_owned(found.row),
        layer=_owned(attributes[:, 0].take(found.style)),
        colour=_owned(attributes[:, 2].take(found.style)),
        true_colour=_owned(attributes[:, 3].take(found.style)),
        linetype=_owned(attributes[:, 4].take(found.style)),
        layers=layers,
        linetypes=linetypes,
        import_report=ImportReport(
            _sealed(sheet.handle),
            _sealed(sheet.kind),
            _sealed(sheet.layer),
            outcome,
            reason,
            kept_length * size,
            location_boxes=_location_boxes(sheet, outcome, specks, size),
        ),
        unit=known.unit,
        evidence=known.evidence,
        stated=known.stated,
        hints=known.hints,
        annotations=tuple(words.scaled(1.0, size) for words in annotations),
    )


def _owned(column: NDArray[Any]) -> NDArray[Any]:
    """Return a column after making it read-only, so that the record need not copy it."""
    column.flags.writeable = False
    return column


def _sealed(words: Sequence[str]) -> Sequence[str]:
    return tuple(words) if isinstance(words, list) else words


def _attributes(styles: list[Style]) -> tuple[tuple[str, ...], tuple[str, ...], I32]:
    """Return the layer names, the linetype names, and the attributes of s styles as numbers (s, 5).

    The columns are: index of the layer, index of the layer regardless of case, colour, true colour,
    and index of the linetype.
    """
    layers: dict[str, int] = {}
    folded: dict[str, int] = {}
    linetypes: dict[str, int] = {}
    rows = np.zeros((len(styles), 5), np.int32)
    for number, style in enumerate(styles):
        rows[number] = (
            layers.setdefault(style.layer, len(layers)),
            folded.setdefault(style.layer.lower(), len(folded)),
            style.colour,
            style.true_colour,
            linetypes.setdefault(style.linetype, len(linetypes)),
        )
    return tuple(layers), tuple(linetypes), rows


def _survivors(ends: F64, bulge: F64, alike: I64, speck: Bool, point: float) -> I64:
    """Return for each of n segments the row of the first segment that is equal to it, (n,).

    A segment with exchanged ends is equal, too.

    Parameters
    ----------
    ends : (n, 2, 2)
    bulge : (n,)
        Segments in file units.
    alike : (n,)
        Number of the style; equal segments have the same number.
    speck : (n,)
        Mask of segments without length, for which their own row is returned.
    point
        Distance within which ends are rounded together (file units).
    """
    slots = np.zeros(1 << max(4, (2 * len(bulge)).bit_length()), np.uint64)
    first = np.arange(len(bulge))
    _find_survivors(ends, bulge, alike, speck, 1.0 / point, slots, first)
    return first


@kernel
def _find_survivors(
    ends: F64_3,
    bulge: F64_1,
    alike: I64_1,
    speck: Bool_1,
    points: float,
    slots: OutU64_1,
    first: OutI64_1,
) -> None:
    """Write the row of the first equal segment for each of n segments to ``first``.

    Parameters
    ----------
    ends, bulge, alike, speck
        See ``_survivors``.
    points
        Reciprocal of the distance to which ends are rounded.
    slots
        Empty hash table (zeros); its length is a power of two.
    first : (n,)
        Must contain the own row of each segment.
    """
    mask, low = np.uint64(len(slots) - 1), np.uint64(0xFFFFFFFF)
    for row in range(len(bulge)):
        if speck[row]:
            continue
        place = _place(ends, bulge, row, points)
        key = np.uint64(alike[row])
        for column in range(len(_FACTORS)):
            key += np.uint64(place[column]) * _FACTORS[column]
        key = (key ^ (key >> np.uint64(32))) * _FACTORS[0]
        slot = (key ^ (key >> np.uint64(29))) & mask
        # A slot holds the upper half of a segment's key, and its row plus one.
        while slots[slot] > 0:
            if (slots[slot] ^ key) <= low:
                other: Any = np.int64(slots[slot] & low) - 1
                if alike[other] == alike[row] and _place(ends, bulge, other, points) == place:
                    first[row] = other
                    break
            slot = (slot + np.uint64(1)) & mask
        else:
            slots[slot] = (key & ~low) | np.uint64(row + 1)


@kernel
def _place(ends: F64_3, bulge: F64_1, row: int, points: float) -> Any:
    """Return ends and bulge of the segment in ``row`` as integers, the same for both directions.

    Coordinates are multiplied by ``points`` and rounded.
    """
    ax, ay = np.rint(ends[row, 0, 0] * points), np.rint(ends[row, 0, 1] * points)
    bx, by = np.rint(ends[row, 1, 0] * points), np.rint(ends[row, 1, 1] * points)
    turn = np.rint(bulge[row] / _TURN)
    # The lower end first.
    if ax > bx or (ax == bx and ay > by):
        ax, ay, bx, by, turn = bx, by, ax, ay, -turn
    return np.int64(ax), np.int64(ay), np.int64(bx), np.int64(by), np.int64(turn)


def _outcomes(
    sheet: ReportRows, found: Columns, length: F64, speck: Bool, twice: Bool, first: I64
) -> tuple[U8, Repeated[Message]]:
    """Return the outcome and the reason for each of m rows of the import report, (m,) each.

    Parameters
    ----------
    found
        n segments of the file, with the report row of each segment.
    length, speck, twice, first : (n,)
        Length of each segment, masks of the segments without length and of the duplicates, and row
        of the first equal segment.
    """
    rows = len(sheet.handle)
    outcome = np.full(rows, ImportOutcome.KEPT, np.uint8)
    reason = np.zeros(rows, np.int32)
    reasons = {KEPT: 0}
    alike = np.full(rows, -1, np.int32)
    for number, same in enumerate(sheet.shared):
        alike[same.rows] = number
        reason[same.rows] = reasons.setdefault(same.dropped or _kept(same.notes), len(reasons))
        if same.dropped:
            outcome[same.rows] = ImportOutcome.DROPPED
    total = np.bincount(found.row, minlength=rows)
    specks = np.bincount(found.row[speck], minlength=rows)
    doubles = np.bincount(found.row[twice], minlength=rows)
    longest: dict[int, float] = {}
    for row, one in zip(found.row[speck].tolist(), length[speck].tolist(), strict=True):
        longest[row] = max(longest.get(row, 0.0), one)
    survivors: dict[int, Counter[int]] = {}
    for row, survivor in zip(
        found.row[twice].tolist(), found.row[first[twice]].tolist(), strict=True
    ):
        survivors.setdefault(row, Counter())[survivor] += 1
    for row in {*sheet.dropped, *sheet.notes, *longest, *survivors}:
        notes: list[Message] = [*(sheet.shared[alike[row]].notes if alike[row] >= 0 else ())]
        notes.extend(sheet.notes.get(row, ()))
        cause: Message | None = None
        if row in sheet.dropped:
            outcome[row], cause = ImportOutcome.DROPPED, sheet.dropped[row]
        elif total[row] and specks[row] == total[row]:
            outcome[row], cause = (
                ImportOutcome.DROPPED,
                Message("import.no-length", length=longest[row]),
            )
        elif specks[row]:
            notes.append(Message("import.pieces-no-length", pieces=specks[row], all=total[row]))
        if doubles[row] and cause is None:
            handles, more = _named(row, survivors[row], sheet.handle)
            if doubles[row] + specks[row] == total[row]:
                outcome[row], cause = ImportOutcome.MERGED, _drawn_twice(handles, more)
            else:
                notes.append(_pieces_drawn_twice(doubles[row], total[row], handles, more))
        reason[row] = reasons.setdefault(cause or _kept(notes), len(reasons))
    return outcome, Repeated(tuple(reasons), reason)


def _location_boxes(
    sheet: ReportRows, outcome: U8, specks: tuple[F64, I32], size: float
) -> LocationBoxes:
    """Return the bounding boxes of dropped report rows whose location is known.

    Parameters
    ----------
    outcome : (m,)
        ImportOutcome of each report row.
    specks
        Ends (s, 2, 2) and report rows (s,) of s segments without length.
    size
        Millimetres per file unit.
    """
    ends, row = specks
    around = np.concatenate([ends.min(axis=1), ends.max(axis=1)], axis=1)
    rows = np.concatenate([row, *(one.rows for one in sheet.location_boxes)])
    box = np.concatenate([around, *(one.box for one in sheet.location_boxes)])
    box = box * size
    seen = (outcome[rows] == ImportOutcome.DROPPED) & (np.abs(box) <= REACH).all(axis=1)
    # One box per row is enough.
    rows, last = np.unique(rows[seen][::-1], return_index=True)
    return LocationBoxes(rows, box[seen][::-1][last])


def _kept(notes: Sequence[Message]) -> Message:
    return Message("import.kept-changed", notes=notes) if notes else KEPT


def _drawn_twice(same: list[str], more: int) -> Message:
    if more:
        return Message("import.drawn-twice-often", same=same, more=more)
    return Message("import.drawn-twice", same=same)


def _pieces_drawn_twice(pieces: int, total: int, same: list[str], more: int) -> Message:
    if more:
        return Message(
            "import.pieces-drawn-twice-often", pieces=pieces, all=total, same=same, more=more
        )
    return Message("import.pieces-drawn-twice", pieces=pieces, all=total, same=same)


def _named(row: int, others: Counter[int], handles: Sequence[str]) -> tuple[list[str], int]:
    """Return up to 5 handles of entities with equal segments, and the number of further entities.

    Entities with the most equal segments come first.

    Parameters
    ----------
    row
        Report row of the entity whose duplicate segments were dropped, named "itself".
    others
        Number of equal segments by report row of the entity that has them.
    handles
        Handle of the entity of each report row.
    """
    names = ["itself" if other == row else handles[other] for other, _ in others.most_common(6)]
    return names[:5], max(len(others) - 5, 0)
