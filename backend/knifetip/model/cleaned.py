"""Records of cleaning: the cleaned dieline, and the outcome of cleaning for every drawn edge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from knifetip.geometry.columns import F64, I32, U8, Bool, freeze
from knifetip.messages import Message, with_text
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import ImportOutcome


class CleaningReason(IntEnum):
    """The reason why cleaning kept, merged or dropped an edge."""

    AS_DRAWN = 0  #: kept unchanged
    MOVED = 1  #: kept; an end was moved to the end of another edge
    SHORTENED = 2  #: kept in part; the rest coincides with other edges
    LONGER = 3  #: kept; other edges were joined to it
    JOINED = 4  #: joined to a collinear edge, which became longer
    FITTED = 5  #: one of several chords replaced by a line or an arc
    TWICE = 6  #: coincides with other edges along its whole length
    SPECK = 7  #: dropped because it is too short to be machined
    NO_WORK = 8  #: not cleaned because it is ignored or not classified
    OFF_PANEL = 9  #: dropped, or kept in part; the rest is outside all panels
    NEAR = 10  #: nearly coincides with other edges along its whole length
    LOOP = 11  #: dropped because it belongs to a loop of short edges at a corner

    @property
    def message(self) -> Message:
        """Message that describes the reason, without the measured values of an edge."""
        return _MESSAGES[self]


_MESSAGES = {
    CleaningReason.AS_DRAWN: Message("cleaning.as-drawn"),
    CleaningReason.MOVED: Message("cleaning.moved"),
    CleaningReason.SHORTENED: Message("cleaning.shortened"),
    CleaningReason.LONGER: Message("cleaning.longer"),
    CleaningReason.JOINED: Message("cleaning.joined"),
    CleaningReason.FITTED: Message("cleaning.fitted"),
    CleaningReason.TWICE: Message("cleaning.twice"),
    CleaningReason.SPECK: Message("cleaning.speck"),
    CleaningReason.NO_WORK: Message("cleaning.as-drawn"),
    CleaningReason.OFF_PANEL: Message("cleaning.off-panel"),
    CleaningReason.NEAR: Message("cleaning.near"),
    CleaningReason.LOOP: Message("cleaning.loop"),
}


@dataclass(frozen=True, eq=False, slots=True)
class Stretches:
    """q stretches (parts of drawn edges), each with the row of the cleaned edge that covers it.

    The row is -1 if no cleaned edge covers the stretch.  The stretches are in the order of the
    edges in the drawing.  They cover the whole length of each drawn edge that is to be machined;
    edges that are ignored or not classified have no stretches.
    """

    row: I32  #: (q,) row in the drawn dieline
    begin: F64  #: (q,) start of the stretch, 0 … 1 of the edge's length
    end: F64  #: (q,) end of the stretch, 0 … 1 of the edge's length
    cleaned: I32  #: (q,) row of the cleaned edge that covers the stretch; -1 if dropped
    by_other_edge: Bool  #: (q,) whether the cleaned edge belongs to another drawn edge

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "row", freeze(self.row, np.int32, -1))
        rows = len(self.row)
        put(self, "begin", freeze(self.begin, np.float64, rows))
        put(self, "end", freeze(self.end, np.float64, rows))
        put(self, "cleaned", freeze(self.cleaned, np.int32, rows))
        put(self, "by_other_edge", freeze(self.by_other_edge, np.bool_, rows))

    def __len__(self) -> int:
        return len(self.row)

    def makers(self, row: int) -> I32:
        """Return the rows of the cleaned edges that cover a drawn edge, ascending."""
        return np.unique(self.cleaned[(self.row == row) & (self.cleaned >= 0)])


@dataclass(frozen=True, eq=False, slots=True)
class Cleaned:
    """The cleaned dieline, and the outcome of cleaning for each of n drawn edges.

    The cleaned dieline has m ≥ n edges.  Its first n rows correspond to the drawn edges; an edge
    that was merged or dropped keeps its row and has the line type *ignored*.  If a drawn edge was
    split, its first piece keeps the row of the drawn edge and the other pieces follow after the
    first n rows.
    ``dieline.source`` contains for each of the m edges the row of one drawn edge: the first one of
    which the cleaned edge contains a part, or the edge itself if it is not machined.

    The length of each drawn edge is the sum of its ``kept`` (machined), ``merged`` (covered by
    other edges) and ``dropped`` (too short to be machined, or outside all panels) lengths.  The
    total length to be machined is the sum of ``kept`` and ``added`` (length added by closing gaps
    and fitting curves) over all drawn edges, except those that are ignored or not classified.
    """

    dieline: Dieline
    cleaned_row: (
        I32  #: (n,) row of the cleaned edge that covers most of the drawn edge; -1 if dropped
    )
    outcome: U8  #: (n,) ImportOutcome
    reason: U8  #: (n,) CleaningReason
    kept: F64  #: (n,) length that is machined for the edge (mm)
    merged: F64  #: (n,) length covered by other edges, which are machined (mm)
    dropped: F64  #: (n,) length that is too short to be machined or outside all panels (mm)
    added: F64  #: (n,) length added by closing gaps and fitting curves (mm)
    moved: F64  #: (n,) maximum distance by which an end, or a part to another edge, was moved (mm)
    off: F64  #: (n,) maximum distance of the drawn edge from the cleaned edges that cover it (mm)
    stretches: Stretches

    @property
    def made_as(self) -> I32:
        """For each drawn edge the drawn edge that stands for it in ``dieline.source``, (n,).

        -1 for a drawn edge that was dropped.
        """
        row = self.cleaned_row
        source: I32 = np.where(row < 0, -1, self.dieline.source[np.maximum(row, 0)])
        return source.astype(np.int32)

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "cleaned_row", freeze(self.cleaned_row, np.int32, -1))
        rows = len(self.cleaned_row)
        for name in ("outcome", "reason"):
            put(self, name, freeze(getattr(self, name), np.uint8, rows))
        for name in ("kept", "merged", "dropped", "added", "moved", "off"):
            put(self, name, freeze(getattr(self, name), np.float64, rows))

    @property
    def changed(self) -> Bool:
        """Mask of the drawn edges that cleaning changed, shape (n,)."""
        return np.asarray(~np.isin(self.reason, (CleaningReason.AS_DRAWN, CleaningReason.NO_WORK)))

    @property
    def notes(self) -> tuple[Message, ...]:
        """Messages about folds that cleaning dropped outside all panels; may be empty."""
        rows = self.reason == CleaningReason.OFF_PANEL
        if not rows.any():
            return ()
        count, length = int(np.count_nonzero(rows)), float(self.dropped[rows].sum())
        return (Message("cleaning.folds-trimmed", count=count, length=length),)

    def replacement_row(self, row: int) -> int:
        """Return the row of the drawn edge that is machined in place of the drawn edge in ``row``.

        It is ``row`` itself if the drawn edge was kept, and -1 if it was dropped.
        """
        cleaned = self.cleaned_row[row]
        return -1 if cleaned < 0 else int(self.dieline.source[cleaned])

    def describe(self, row: int) -> Message:
        """Return a message with the outcome of cleaning for the drawn edge in row ``row``."""
        match CleaningReason(self.reason[row]):
            case CleaningReason.SPECK:
                return Message("cleaning.dropped-speck", length=self.dropped[row])
            case CleaningReason.LOOP:
                return Message("cleaning.loop")
            case CleaningReason.NO_WORK:
                return Message("cleaning.no-work")
            case CleaningReason.TWICE:
                return Message("cleaning.on-edge", edge=self.replacement_row(row))
            case CleaningReason.NEAR:
                return Message(
                    "cleaning.near-edge", edge=self.replacement_row(row), distance=self.moved[row]
                )
            case CleaningReason.JOINED:
                return Message("cleaning.joined-edge", edge=self.replacement_row(row))
            case CleaningReason.FITTED:
                return Message(
                    "cleaning.fitted-edge", edge=self.replacement_row(row), distance=self.off[row]
                )
        is_off_panel = self.reason[row] == CleaningReason.OFF_PANEL
        if is_off_panel and self.outcome[row] == ImportOutcome.DROPPED:
            return Message("cleaning.dropped-off-panel")
        changes = []
        if self.merged[row] > 0.0:
            changes.append(Message("cleaning.length-on-others", length=self.merged[row]))
        if self.reason[row] == CleaningReason.LONGER:
            changes.append(Message("cleaning.longer"))
        if self.moved[row] > 0.0:
            changes.append(Message("cleaning.end-moved", distance=self.moved[row]))
        if self.dropped[row] > 0.0:
            code = "cleaning.part-off-panel" if is_off_panel else "cleaning.part-dropped"
            changes.append(Message(code, length=self.dropped[row]))
        if not changes:
            return Message("cleaning.kept")
        return Message("cleaning.kept-changed", changes=changes)

    @property
    def lengths(self) -> dict[str, float]:
        """Total lengths (mm) by name, over the drawn edges to be machined.

        ``drawn``: length in the drawing; ``kept``, ``merged`` and ``dropped``: parts of ``drawn``
        that are machined, covered by other edges, or neither (too short, or outside all panels);
        ``added``: length added by closing gaps and fitting curves; ``worked``: machined length,
        ``kept`` + ``added``.
        ``no_work`` is the length of all other drawn edges, which are ignored or not classified.
        """
        at_work = self.reason != CleaningReason.NO_WORK
        kept, merged, dropped, added = (
            float(column[at_work].sum())
            for column in (self.kept, self.merged, self.dropped, self.added)
        )
        return {
            "drawn": kept + merged + dropped,
            "kept": kept,
            "merged": merged,
            "dropped": dropped,
            "added": added,
            "worked": kept + added,
            "no_work": float(self.kept[~at_work].sum()),
        }

    def as_json(self, handles: Sequence[str]) -> dict[str, object]:
        """Return the cleaning report as JSON data: lengths, counts, and one row per changed edge.

        Parameters
        ----------
        handles : (n,)
            For each drawn edge, the handle of its entity (the identifier in the file).
        """
        return {
            "lengths": self.lengths,
            "edges": {outcome.name.lower(): self.count(outcome) for outcome in ImportOutcome},
            "moved": float(self.moved.max(initial=0.0)),
            "off": float(self.off.max(initial=0.0)),
            "rows": [
                {
                    "row": row,
                    "handle": handles[row],
                    "outcome": ImportOutcome(self.outcome[row]).name.lower(),
                    "reason": CleaningReason(self.reason[row]).name.lower(),
                    "into": self.replacement_row(row),
                    "kept": float(self.kept[row]),
                    "merged": float(self.merged[row]),
                    "dropped": float(self.dropped[row]),
                    "added": float(self.added[row]),
                    "moved": float(self.moved[row]),
                    "off": float(self.off[row]),
                    **with_text(self.describe(row)),
                }
                for row in np.flatnonzero(self.changed).tolist()
            ],
        }

    def count(self, outcome: ImportOutcome) -> int:
        """Return the number of drawn edges with the outcome ``outcome``."""
        return int((self.outcome == outcome).sum())
