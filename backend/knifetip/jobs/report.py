"""report: what became of all that was drawn, for what reason, and what speaks for the unit.

    Drawing, Dieline -> Report: outcome and reason of every edge; groups whose lengths add up

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
from knifetip.model.cleaned import CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome

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

    outcome: U8  #: (n,) ImportOutcome
    reason: I32  #: (n,) index into ``reasons``
    reasons: tuple[Message, ...]
    summary: dict[str, Any]  #: ``ReportOut``


def reported(drawing: Drawing, dieline: Dieline) -> Report:
    """Return what became of a drawing's edges and of its other entities."""
    from knifetip.cleaning.clean import clean

    lengths = drawing.lengths
    outcome = np.full(len(drawing), ImportOutcome.KEPT, np.uint8)
    reason = np.full(len(drawing), CleaningReason.AS_DRAWN, np.int32)
    part: list[tuple[ImportOutcome, CleaningReason, F64]] = []
    # Specks and gaps are measured in millimetres: without a unit there are none yet.
    if drawing.unit:
        cleaned = clean(dieline)
        outcome, reason = cleaned.outcome, cleaned.reason.astype(np.int32)
        # Of an edge that is kept, a part may lie on others: that part is told by itself.
        held = outcome == ImportOutcome.KEPT
        part = [
            (ImportOutcome.MERGED, CleaningReason.SHORTENED, np.where(held, cleaned.merged, 0.0)),
            (ImportOutcome.DROPPED, CleaningReason.SPECK, np.where(held, cleaned.dropped, 0.0)),
        ]
    whole = lengths - sum(length for _, _, length in part)
    reasons = [code.message for code in CleaningReason]
    for line_type, words in _UNWORKED.items():
        reason[(dieline.line_type == line_type) & (outcome == ImportOutcome.KEPT)] = len(reasons)
        reasons.append(words)
    kinds = np.array(drawing.import_report.kind, dtype=object)
    groups = _groups("edges", outcome, reason, reasons, whole, kinds[drawing.entity])
    for kind, code, length in part:
        if (some := length > _NOTHING).any():
            groups += _groups(
                "edges",
                np.full(int(some.sum()), kind, np.uint8),
                np.full(int(some.sum()), code, np.int32),
                reasons,
                length[some],
                kinds[drawing.entity[some]],
            )
    import_report = drawing.import_report
    # The edges of an entity that was kept are told one by one.
    beside = np.flatnonzero(import_report.outcome != ImportOutcome.KEPT)
    first: dict[str, Message] = {}
    numbers: dict[str, int] = {}
    codes = np.zeros(len(beside), np.int32)
    for at, row in enumerate(beside.tolist()):
        reason_of_row = import_report.reason[row]
        first.setdefault(reason_of_row.code, reason_of_row)
        codes[at] = numbers.setdefault(reason_of_row.code, len(numbers))
    others = _groups(
        "entities",
        import_report.outcome[beside],
        codes,
        list(first.values()),
        import_report.length[beside],
        kinds[beside],
    )
    groups = _summed(groups) + others
    order = [ImportOutcome.DROPPED, ImportOutcome.MERGED, ImportOutcome.KEPT]
    groups.sort(key=lambda one: (order.index(one["outcome"]), -one["length"], -one["count"]))
    summary = {
        "drawn": float(lengths.sum()) + sum(one["length"] for one in others),
        **{
            kind.name.lower(): sum(one["length"] for one in groups if one["outcome"] == kind)
            for kind in ImportOutcome
        },
        "groups": [{**one, "outcome": one["outcome"].name.lower()} for one in groups],
    }
    return Report(outcome, reason, tuple(reasons), summary)


def _groups(
    what: str,
    outcome: U8,
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
        np.stack([outcome.astype(np.int32), same[reason]], axis=1),
        axis=0,
        return_inverse=True,
    )
    group = group.reshape(-1)
    made = []
    for number, (code, example) in enumerate(pairs.tolist()):
        rows = group == number
        common = Counter(kinds[rows].tolist()).most_common(_KINDS)
        made.append(
            {
                "outcome": ImportOutcome(code),
                "reason": examples[example].as_json(),
                "what": what,
                "kinds": [said(kind) for kind, _ in common],
                "count": int(rows.sum()),
                "length": float(length[rows].sum()),
            }
        )
    return made


def _summed(groups: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the groups with those of one outcome and reason as one."""
    found: dict[tuple[ImportOutcome, str], dict[str, Any]] = {}
    for one in groups:
        known = found.setdefault((one["outcome"], one["reason"]["code"]), one)
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
