"""assemble: columns and the ledger put together, each line once and none without length.

    Sheet, Columns, Styles of the columns -> Drawing

The last step of every reader.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Final, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.geometry.distinct import distinct
from knifetip.geometry.tolerance import POINT
from knifetip.intake.columns import Columns, Style
from knifetip.intake.sheet import Sheet
from knifetip.model.drawing import Drawing, Fate, Inscription, Ledger
from knifetip.model.unit import Hint


class Known(NamedTuple):
    """What is known of a file's unit."""

    scale: float  #: millimetres to a file unit, 0 while it is unknown
    unit: str  #: empty while it is unknown
    evidence: str
    stated: str  #: the unit that the header states, empty if none
    hints: tuple[Hint, ...] = ()  #: what else the header says of it


#: Bulges that differ by less than this are the same turn.
_TURN: Final = 1e-9


def assemble(
    sheet: Sheet,
    found: Columns,
    styles: list[Style],
    inscriptions: Iterable[Inscription],
    known: Known,
) -> Drawing:
    """Return the drawing: without specks, each line once.

    Parameters
    ----------
    found
        n segments in file units.
    styles
        What ``found.style`` counts.
    inscriptions
        In file units.
    """
    scale = known.scale
    point = POINT / scale if scale else POINT / 1000.0
    length = arc.length(found.ends[:, 0], found.ends[:, 1], found.bulge)
    speck = ~(length >= point)
    layers, linetypes, attributes = _attributes(styles)
    # Styles that differ in nothing but the spelling of the layer are the same.
    _, alike = distinct(attributes[:, 1:])
    first = _survivors(found.ends, found.bulge, alike[found.style], speck, point)
    twice = first != np.arange(len(first))
    keep = ~(speck | twice)
    fate, reason = _fates(sheet, found, length, speck, twice, first)
    # Added up in the order of the file, as ``bincount`` does.
    kept_length: F64 = np.bincount(
        found.row[keep], length[keep], minlength=len(sheet.handle)
    ).astype(np.float64)
    size = scale or 1.0
    style = found.style[keep]
    return Drawing(
        # + 0: a zero has no sign.
        ends=found.ends[keep] * size + 0.0,
        bulge=found.bulge[keep] + 0.0,
        entity=found.row[keep],
        layer=attributes[style, 0],
        colour=attributes[style, 2],
        true_colour=attributes[style, 3],
        linetype=attributes[style, 4],
        layers=layers,
        linetypes=linetypes,
        ledger=Ledger(
            tuple(sheet.handle),
            tuple(sheet.kind),
            tuple(sheet.layer),
            fate,
            tuple(reason),
            kept_length * size,
        ),
        unit=known.unit,
        evidence=known.evidence,
        stated=known.stated,
        hints=known.hints,
        inscriptions=tuple(words.scaled(1.0, size) for words in inscriptions),
    )


def _attributes(styles: list[Style]) -> tuple[tuple[str, ...], tuple[str, ...], I64]:
    """Return layer names, linetype names, and (s, 5): layer, layer regardless of case, colour,
    true colour, linetype of each style."""
    layers: dict[str, int] = {}
    folded: dict[str, int] = {}
    linetypes: dict[str, int] = {}
    rows = np.zeros((len(styles), 5), dtype=np.int64)
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
    """Return for each segment the first one that is the same line, in either direction."""
    solid = np.flatnonzero(~speck)
    near = ends[solid].reshape(-1, 4)
    near /= point
    grid = np.round(near, out=near).astype(np.int64)
    del near
    turn = np.round(bulge[solid] / _TURN).astype(np.int64)
    # Both directions of a line are one: the lower end first.
    back = (grid[:, 0] > grid[:, 2]) | ((grid[:, 0] == grid[:, 2]) & (grid[:, 1] > grid[:, 3]))
    grid[back] = grid[back][:, [2, 3, 0, 1]]
    one, kind = distinct(grid, np.where(back, -turn, turn), alike[solid])
    first = np.arange(len(bulge))
    first[solid] = solid[one[kind]]
    return first


def _fates(
    sheet: Sheet, found: Columns, length: F64, speck: Bool, twice: Bool, first: I64
) -> tuple[U8, list[str]]:
    """Return fate and reason of each row of the ledger."""
    rows = len(sheet.handle)
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
    fate = np.full(rows, Fate.KEPT, np.uint8)
    reason = ["kept"] * rows
    told = {*sheet.dropped, *sheet.notes, *longest, *survivors}
    for row in told:
        notes = list(sheet.notes.get(row, ()))
        if row in sheet.dropped:
            fate[row] = Fate.DROPPED
            reason[row] = sheet.dropped[row]
            continue
        if total[row] and specks[row] == total[row]:
            fate[row] = Fate.DROPPED
            reason[row] = f"it has no length: {longest[row]:g}"
            continue
        if specks[row]:
            notes.append(f"{specks[row]} of {total[row]} pieces have no length")
        if doubles[row]:
            same = survivors[row]
            names = [
                "itself" if other == row else sheet.handle[other] for other, _ in same.most_common()
            ]
            listed = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if names[5:] else "")
            if doubles[row] + specks[row] == total[row]:
                fate[row] = Fate.MERGED
                reason[row] = f"it is drawn twice: the same as {listed}"
                continue
            notes.append(f"{doubles[row]} of {total[row]} pieces are drawn twice, with {listed}")
        if notes:
            reason[row] = "kept: " + "; ".join(notes)
    return fate, reason
