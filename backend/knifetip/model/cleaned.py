"""Cleaned: a dieline put in order, and what became of every edge that was drawn."""

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
    """Reason for the outcome of cleaning an edge."""

    AS_DRAWN = 0  #: kept, bit for bit
    MOVED = 1  #: kept, an end brought to another one
    SHORTENED = 2  #: kept in part: the rest lies on other edges
    LONGER = 3  #: kept, and others have become one edge with it
    JOINED = 4  #: it has become one edge with another that it goes on in
    FITTED = 5  #: it is a part of a flattened curve that has become a line or an arc
    TWICE = 6  #: it lies on other edges along its whole length
    SPECK = 7  #: it is too short to be worked
    NO_WORK = 8  #: it is ignored or not classified, and left as it is

    @property
    def message(self) -> Message:
        """The reason without positions and measures."""
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
}


@dataclass(frozen=True, eq=False, slots=True)
class Stretches:
    """q parts of drawn edges, which cover all that is to be worked, in the order of the drawing."""

    row: I32  #: (q,) row in the drawn dieline
    begin: F64  #: (q,) where the part begins, 0 … 1 of the drawn edge's length
    end: F64  #: (q,) where it ends
    cleaned: I32  #: (q,) row in the cleaned dieline that does its work, -1 where it was dropped
    given: Bool  #: (q,) whether it lies on another edge, and so is not worked once more

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "row", freeze(self.row, np.int32, -1))
        rows = len(self.row)
        put(self, "begin", freeze(self.begin, np.float64, rows))
        put(self, "end", freeze(self.end, np.float64, rows))
        put(self, "cleaned", freeze(self.cleaned, np.int32, rows))
        put(self, "given", freeze(self.given, np.bool_, rows))

    def __len__(self) -> int:
        return len(self.row)


@dataclass(frozen=True, eq=False, slots=True)
class Cleaned:
    """What n drawn edges became: m ≥ n edges.

    The first n rows of ``dieline`` are those of the drawing.  An edge that has become a part of
    another one, or was dropped, stands there as it was drawn and is ignored; what an edge was
    parted into beyond one piece follows at the end.  ``dieline.source`` says for each of the m
    rows which row of the drawing to show for it.

    Lengths add up: ``kept + merged + dropped`` is what was drawn, edge by edge; the length of the
    cleaned edges that are worked is the sum of ``kept`` and of ``added``.
    """

    dieline: Dieline
    of: I32  #: (n,) cleaned row that does most of the edge's work, -1 where it was dropped
    outcome: U8  #: (n,) ImportOutcome
    reason: U8  #: (n,) CleaningReason
    kept: F64  #: (n,) length that is worked for this edge (mm)
    merged: F64  #: (n,) length that lies on other edges, which are worked (mm)
    dropped: F64  #: (n,) length of specks (mm)
    added: F64  #: (n,) length that closing gaps and fitting curves added to it; < 0: took (mm)
    moved: F64  #: (n,) the farthest that an end was moved (mm)
    off: F64  #: (n,) the farthest that the drawn edge is from the edge that does its work (mm)
    stretches: Stretches

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "of", freeze(self.of, np.int32, -1))
        rows = len(self.of)
        for name in ("outcome", "reason"):
            put(self, name, freeze(getattr(self, name), np.uint8, rows))
        for name in ("kept", "merged", "dropped", "added", "moved", "off"):
            put(self, name, freeze(getattr(self, name), np.float64, rows))

    @property
    def changed(self) -> Bool:
        """(n,) Whether the edge is worked otherwise than as it was drawn."""
        return np.asarray(~np.isin(self.reason, (CleaningReason.AS_DRAWN, CleaningReason.NO_WORK)))

    def into(self, row: int) -> int:
        """Return the row of the drawing that stands for the edge's work, -1 where there is none."""
        cleaned = self.of[row]
        return -1 if cleaned < 0 else int(self.dieline.source[cleaned])

    def describe(self, row: int) -> Message:
        """Return what became of a drawn edge."""
        match CleaningReason(self.reason[row]):
            case CleaningReason.SPECK:
                return Message("cleaning.dropped-speck", length=self.dropped[row])
            case CleaningReason.NO_WORK:
                return Message("cleaning.no-work")
            case CleaningReason.TWICE:
                return Message("cleaning.on-edge", edge=self.into(row))
            case CleaningReason.JOINED:
                return Message("cleaning.joined-edge", edge=self.into(row))
            case CleaningReason.FITTED:
                return Message("cleaning.fitted-edge", edge=self.into(row), distance=self.off[row])
        changes = []
        if self.merged[row] > 0.0:
            changes.append(Message("cleaning.length-on-others", length=self.merged[row]))
        if self.reason[row] == CleaningReason.LONGER:
            changes.append(Message("cleaning.longer"))
        if self.moved[row] > 0.0:
            changes.append(Message("cleaning.end-moved", distance=self.moved[row]))
        if self.dropped[row] > 0.0:
            changes.append(Message("cleaning.part-dropped", length=self.dropped[row]))
        if not changes:
            return Message("cleaning.kept")
        return Message("cleaning.kept-changed", changes=changes)

    @property
    def lengths(self) -> dict[str, float]:
        """Lengths over all (mm): ``drawn`` is the sum of ``kept``, ``merged`` and ``dropped``;
        ``worked`` that of ``kept`` and ``added``; ``no_work`` is ignored or not classified."""
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
        """Return the cleaning report as JSON data: lengths, counts, one row per changed edge."""
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
                    "into": self.into(row),
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
        """Return how many edges have this outcome."""
        return int((self.outcome == outcome).sum())
