"""report: what became of all that was drawn, for what reason, and what speaks for the unit.

    Drawing, Dieline -> Report: fate and reason of every edge; groups whose lengths add up

Entities that are no lines, such as texts and dimensions, are the reader's to drop; edges that lie
on others, specks and the like are the cleaning's.  Both stand in one list, by reason.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.columns import F64, I32, U8
from knifetip.messages import Message
from knifetip.model.cleaned import Why
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, Fate

_KINDS = 6  # of entity that a group names
_NOTHING = 1e-9  # mm
#: Edges that are shown and not worked.
_UNWORKED = {
    LineType.IGNORED: Message("cleaning.ignored"),
    LineType.UNCLASSIFIED: Message("cleaning.unclassified"),
}


@dataclass(frozen=True, eq=False, slots=True)
class Report:
    """What became of n edges, and of what never was an edge."""

    fate: U8  #: (n,) Fate
    reason: I32  #: (n,) index into ``reasons``
    reasons: tuple[Message, ...]
    summary: dict[str, Any]  #: ``ReportOut``


def reported(drawing: Drawing, dieline: Dieline) -> Report:
    """Return what became of a drawing's edges and of its other entities."""
    from knifetip.cleaning.clean import clean

    lengths = drawing.lengths
    fate = np.full(len(drawing), Fate.KEPT, np.uint8)
    reason = np.full(len(drawing), Why.AS_DRAWN, np.int32)
    part: list[tuple[Fate, Why, F64]] = []
    # Specks and gaps are measured in millimetres: without a unit there are none yet.
    if drawing.unit:
        cleaned = clean(dieline)
        fate, reason = cleaned.fate, cleaned.why.astype(np.int32)
        # Of an edge that is kept, a part may lie on others: that part is told by itself.
        held = fate == Fate.KEPT
        part = [
            (Fate.MERGED, Why.SHORTENED, np.where(held, cleaned.merged, 0.0)),
            (Fate.DROPPED, Why.SPECK, np.where(held, cleaned.dropped, 0.0)),
        ]
    whole = lengths - sum(length for _, _, length in part)
    reasons = [why.message for why in Why]
    for line_type, words in _UNWORKED.items():
        reason[(dieline.line_type == line_type) & (fate == Fate.KEPT)] = len(reasons)
        reasons.append(words)
    kinds = np.array(drawing.ledger.kind, dtype=object)
    groups = _groups("edges", fate, reason, reasons, whole, kinds[drawing.entity])
    for kind, why, length in part:
        if (some := length > _NOTHING).any():
            groups += _groups(
                "edges",
                np.full(int(some.sum()), kind, np.uint8),
                np.full(int(some.sum()), why, np.int32),
                reasons,
                length[some],
                kinds[drawing.entity[some]],
            )
    ledger = drawing.ledger
    # The edges of an entity that was kept are told one by one.
    beside = np.flatnonzero(ledger.fate != Fate.KEPT)
    first: dict[str, Message] = {}
    numbers: dict[str, int] = {}
    codes = np.zeros(len(beside), np.int32)
    for at, row in enumerate(beside.tolist()):
        reason_of_row = ledger.reason[row]
        first.setdefault(reason_of_row.code, reason_of_row)
        codes[at] = numbers.setdefault(reason_of_row.code, len(numbers))
    others = _groups(
        "entities",
        ledger.fate[beside],
        codes,
        list(first.values()),
        ledger.length[beside],
        kinds[beside],
    )
    groups = _summed(groups) + others
    order = [Fate.DROPPED, Fate.MERGED, Fate.KEPT]
    groups.sort(key=lambda one: (order.index(one["fate"]), -one["length"], -one["count"]))
    summary = {
        "drawn": float(lengths.sum()) + sum(one["length"] for one in others),
        **{
            kind.name.lower(): sum(one["length"] for one in groups if one["fate"] == kind)
            for kind in Fate
        },
        "groups": [{**one, "fate": one["fate"].name.lower()} for one in groups],
    }
    return Report(fate, reason, tuple(reasons), summary)


def _groups(
    what: str,
    fate: U8,
    reason: I32,
    reasons: Sequence[Message],
    length: F64,
    kinds: NDArray[np.object_],
) -> list[dict[str, Any]]:
    """Return rows by outcome and code of the reason; the message is that of the first row."""
    numbers: dict[str, int] = {}
    same = np.array([numbers.setdefault(one.code, len(numbers)) for one in reasons], np.int32)
    examples = {numbers[one.code]: one for one in reversed(reasons)}
    pairs, group = np.unique(
        np.stack([fate.astype(np.int32), same[reason]], axis=1),
        axis=0,
        return_inverse=True,
    )
    group = group.reshape(-1)
    made = []
    for number, (outcome, example) in enumerate(pairs.tolist()):
        rows = group == number
        common = Counter(kinds[rows].tolist()).most_common(_KINDS)
        made.append(
            {
                "fate": Fate(outcome),
                "reason": examples[example].as_json(),
                "what": what,
                "kinds": [said(kind) for kind, _ in common],
                "count": int(rows.sum()),
                "length": float(length[rows].sum()),
            }
        )
    return made


def _summed(groups: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the groups with those of one fate and reason as one."""
    found: dict[tuple[Fate, str], dict[str, Any]] = {}
    for one in groups:
        known = found.setdefault((one["fate"], one["reason"]["code"]), one)
        if known is not one:
            known["count"] += one["count"]
            known["length"] += one["length"]
    return list(found.values())


def unit_of(drawing: Drawing) -> dict[str, Any]:
    """Return what speaks for each unit of a drawing, the strongest first, as plain data."""
    from knifetip.units.evidence import find_unit

    found = find_unit(drawing)
    return {
        "stated": drawing.stated,
        "ranking": list(found.ranking),
        "warnings": [said(text) for text in found.warnings],
        "evidence": [
            {"unit": one.unit, "text": said(one.text), "weight": float(one.weight)}
            for one in found.evidence
        ],
    }


def said(text: str) -> str:
    """Return text of a file as UTF-8 can say it: bytes that were no text become ``?``."""
    return text.encode("utf-8", "replace").decode("utf-8").replace("\0", "")
