"""Outcome of every edge of a drawing after import and cleaning, and a summary by reason.

Import drops entities that are not drawing lines, such as texts and dimensions.  Cleaning merges or
drops edges, for example duplicates and very short edges.  The summary contains both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.columns import F64, I32, U8
from knifetip.messages import Message, printable
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.presentation.replaced_folds import replaced_fold_warnings

#: Maximum number of entity kinds in a group of the summary.
_MAX_KINDS: Final = 6
#: Lengths up to this value count as zero (mm).
_ZERO_LENGTH: Final = 1e-9
#: Reasons for edges that are kept in the drawing and not machined.
_NOT_MACHINED: Final = {
    LineType.IGNORED: Message("cleaning.ignored"),
    LineType.UNCLASSIFIED: Message("cleaning.unclassified"),
}
#: Order of the groups in the summary.
_ORDER: Final = (ImportOutcome.DROPPED, ImportOutcome.MERGED, ImportOutcome.KEPT)


@dataclass(frozen=True, eq=False, slots=True)
class EdgeOutcomes:
    """Outcome (kept, merged or dropped) and reason of each of n edges, and a summary by reason.

    The summary also contains entities of the file without edges, such as texts.
    """

    outcome: U8  #: (n,) ImportOutcome of each edge
    reason: I32  #: (n,) index into ``reasons`` for each edge
    reasons: tuple[Message, ...]
    summary: dict[str, Any]  #: JSON data of the schema ``ReportOut``
    warnings: tuple[Message, ...] = ()  #: about edges that are not made as their line type


def edge_outcomes(drawing: Drawing, dieline: Dieline, cleaned: Cleaned | None) -> EdgeOutcomes:
    """Return the outcome of every edge of a drawing, with a summary by reason.

    Parameters
    ----------
    dieline
        The edges of the drawing with their line types.
    cleaned
        Result of cleaning the dieline.  If it is None, the dieline was not cleaned, and all edges
        are kept.
    """
    lengths = drawing.lengths
    outcome = np.full(len(drawing), ImportOutcome.KEPT, np.uint8)
    reason = np.full(len(drawing), CleaningReason.AS_DRAWN, np.int32)
    parts: list[tuple[ImportOutcome, CleaningReason, F64]] = []
    warnings: tuple[Message, ...] = ()
    if cleaned is not None:
        warnings = replaced_fold_warnings(dieline, cleaned, lengths)
        outcome, reason = cleaned.outcome, cleaned.reason.astype(np.int32)
        # Parts of kept edges may be merged or dropped; they are counted separately.
        is_kept = outcome == ImportOutcome.KEPT
        is_off_panel = reason == CleaningReason.OFF_PANEL
        parts = [
            (
                ImportOutcome.MERGED,
                CleaningReason.SHORTENED,
                np.where(is_kept, cleaned.merged, 0.0),
            ),
            (
                ImportOutcome.DROPPED,
                CleaningReason.SPECK,
                np.where(is_kept & ~is_off_panel, cleaned.dropped, 0.0),
            ),
            (
                ImportOutcome.DROPPED,
                CleaningReason.OFF_PANEL,
                np.where(is_kept & is_off_panel, cleaned.dropped, 0.0),
            ),
        ]
    reasons = [code.message for code in CleaningReason]
    for line_type, message in _NOT_MACHINED.items():
        reason[(dieline.line_type == line_type) & (outcome == ImportOutcome.KEPT)] = len(reasons)
        reasons.append(message)
    kinds = np.array(drawing.import_report.kind, dtype=object)[drawing.entity]
    remaining = lengths - sum(length for _, _, length in parts)
    groups = _groups("edges", outcome, reason, reasons, remaining, kinds)
    for part_outcome, code, length in parts:
        if (rows := np.flatnonzero(length > _ZERO_LENGTH)).size:
            groups += _groups(
                "edges",
                np.full(len(rows), part_outcome, np.uint8),
                np.full(len(rows), code, np.int32),
                reasons,
                length[rows],
                kinds[rows],
            )
    entities = _entity_groups(drawing)
    summary = _summary(_merge_groups(groups) + entities)
    summary["drawn"] = float(lengths.sum()) + sum(group["length"] for group in entities)
    return EdgeOutcomes(outcome, reason, tuple(reasons), summary, warnings)


def _entity_groups(drawing: Drawing) -> list[dict[str, Any]]:
    """Return the entities that import merged or dropped, grouped by outcome and reason.

    A group is JSON data of the schema ``ReportGroup``, with number and total length of the
    entities.
    """
    report = drawing.import_report
    rows = np.flatnonzero(report.outcome != ImportOutcome.KEPT)
    examples: dict[str, Message] = {}
    numbers: dict[str, int] = {}
    reason = np.zeros(len(rows), np.int32)
    for position, row in enumerate(rows.tolist()):
        message = report.reason[row]
        examples.setdefault(message.code, message)
        reason[position] = numbers.setdefault(message.code, len(numbers))
    kinds = np.array(report.kind, dtype=object)[rows]
    reasons = list(examples.values())
    return _groups("entities", report.outcome[rows], reason, reasons, report.length[rows], kinds)


def _groups(
    row_kind: str,
    outcome: U8,
    reason: I32,
    reasons: Sequence[Message],
    length: F64,
    kinds: NDArray[np.object_],
) -> list[dict[str, Any]]:
    """Return edges or entities in groups, one for each pair of outcome and reason that occurs.

    A group is JSON data of the schema ``ReportGroup``, with number and total length of its edges or
    entities.  Reasons with the same code count as equal.

    ``row_kind``: "edges" if the n rows of the arrays are edges, "entities" if they are entities.
    ``outcome``, ``reason``, ``length``, ``kinds`` (n,): for each row the ImportOutcome, the index
    into ``reasons``, the length (mm) and the kind of the entity, such as LINE.
    ``reasons``: messages to which ``reason`` refers.
    """
    numbers: dict[str, int] = {}
    code = np.array([numbers.setdefault(one.code, len(numbers)) for one in reasons], np.int32)
    examples = {numbers[one.code]: one for one in reversed(reasons)}
    pairs, group = np.unique(
        np.stack([outcome.astype(np.int32), code[reason]], axis=1), axis=0, return_inverse=True
    )
    group = group.reshape(-1)
    groups = []
    for number, (word, example) in enumerate(pairs.tolist()):
        rows = group == number
        common = Counter(kinds[rows].tolist()).most_common(_MAX_KINDS)
        groups.append(
            {
                "outcome": ImportOutcome(word),
                "reason": examples[example].as_json(),
                "what": row_kind,
                "kinds": [printable(kind) for kind, _ in common],
                "count": int(rows.sum()),
                "length": float(length[rows].sum()),
            }
        )
    return groups


def _merge_groups(groups: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Merge groups that have the same outcome and reason, and return all groups.

    The number and the length of a merged group are the sums of the numbers and lengths of its
    parts.
    """
    merged: dict[tuple[ImportOutcome, str], dict[str, Any]] = {}
    for group in groups:
        first = merged.setdefault((group["outcome"], group["reason"]["code"]), group)
        if first is not group:
            first["count"] += group["count"]
            first["length"] += group["length"]
    return list(merged.values())


def _summary(groups: list[dict[str, Any]]) -> dict[str, Any]:
    """Return all groups of edges and entities, and the total length (mm) of each outcome, as JSON.

    Groups of dropped edges or entities come first, then merged, then kept; groups with the same
    outcome are in the order of decreasing length.
    """
    groups = sorted(
        groups,
        key=lambda group: (_ORDER.index(group["outcome"]), -group["length"], -group["count"]),
    )
    totals = {
        outcome.name.lower(): sum(
            group["length"] for group in groups if group["outcome"] == outcome
        )
        for outcome in ImportOutcome
    }
    return {
        **totals,
        "groups": [{**group, "outcome": group["outcome"].name.lower()} for group in groups],
    }
