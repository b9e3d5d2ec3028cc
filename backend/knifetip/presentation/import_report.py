"""The import report of a drawing as rows of JSON data.

Each row has handle, kind, layer, outcome, reason and length of one entity.  The row of a text also
contains the text.  The row of an entity without edges also contains the bounding box of the entity,
if its location is known.
"""

from __future__ import annotations

import json
import zlib
from collections import defaultdict
from functools import lru_cache
from typing import Any, Final

from knifetip.messages import Message, printable, with_text
from knifetip.model.drawing import Annotation, Drawing, ImportOutcome

_OUTCOMES = {outcome.value: outcome.name.lower() for outcome in ImportOutcome}
#: Cached, because the texts of kinds, layers and reasons repeat.
_printable = lru_cache(maxsize=4096)(printable)
_as_json = lru_cache(maxsize=4096)(Message.as_json)
#: Fields that only some rows have.
_ABSENT: Final = {"text": "", "place": None, "box": None}


def outcome_counts(drawing: Drawing) -> dict[str, int]:
    """Return the number of entities by outcome: kept, merged and dropped."""
    outcomes = drawing.import_report.outcome
    return {word: int((outcomes == code).sum()) for code, word in _OUTCOMES.items()}


def import_report_rows(drawing: Drawing) -> list[dict[str, Any]]:
    """Return the import report as JSON data, one row per entity in the order of the file."""
    report = drawing.import_report
    rows: list[dict[str, Any]] = [
        {
            "handle": printable(handle),
            "kind": _printable(kind),
            "layer": _printable(layer),
            "outcome": _OUTCOMES[outcome],
            "reason": _as_json(reason),
            "length": round(length, 6),
        }
        for handle, kind, layer, outcome, reason, length in zip(
            report.handle,
            report.kind,
            report.layer,
            report.outcome.tolist(),
            report.reason,
            report.length.tolist(),
            strict=True,
        )
    ]
    boxes = report.location_boxes
    for row, box in zip(boxes.rows.tolist(), boxes.box.tolist(), strict=True):
        rows[row]["box"] = [round(coordinate, 6) for coordinate in box]
    for row, text in annotations_by_row(drawing).items():
        rows[row] |= {"text": printable(text.text), "place": [text.x, text.y, text.height]}
    return rows


def annotations_by_row(drawing: Drawing) -> dict[int, Annotation]:
    """Return the annotations of a drawing by their rows in the import report.

    Annotations have no handle, so they are matched with the report rows of the same kind and layer
    in the order of the file.  If the numbers of annotations and rows of a kind and layer differ,
    none of these annotations is matched, because a wrong location is worse than a missing one.
    """
    report = drawing.import_report
    annotations: dict[tuple[str, str], list[Annotation]] = defaultdict(list)
    for annotation in drawing.annotations:
        annotations[annotation.kind, annotation.layer].append(annotation)
    rows: dict[tuple[str, str], list[int]] = defaultdict(list)
    for row, group in enumerate(zip(report.kind, report.layer, strict=True)):
        # Entities of a block are located by the references to the block.
        if (
            group in annotations
            and "/" not in report.handle[row]
            and not (report.block and report.block[row])
            and report.reason[row].code != "import.paper-space-annotation"
        ):
            rows[group].append(row)
    return {
        row: annotation
        for group, members in annotations.items()
        if len(rows[group]) == len(members)
        for row, annotation in zip(rows[group], members, strict=True)
    }


def pack_rows(rows: list[dict[str, Any]]) -> bytes:
    """Return the rows of an import report as deflated JSON."""
    return zlib.compress(json.dumps(rows).encode(), 6)


def unpack_rows(content: bytes, limit: int | None = None) -> list[dict[str, Any]]:
    """Return all rows of a packed import report, or the first ``limit`` rows."""
    text = zlib.decompress(content).decode()
    rows: list[dict[str, Any]] = json.loads(text) if limit is None else _first_rows(text, limit)
    return rows


def with_defaults(row: dict[str, Any]) -> dict[str, Any]:
    """Return a row with the text of its reason, and with all fields that a row may have."""
    return {**_ABSENT, **row, "reason": _with_text(json.dumps(row["reason"]))}


@lru_cache(maxsize=4096)  # most rows have one of few reasons
def _with_text(reason: str) -> dict[str, Any]:
    return with_text(json.loads(reason))


def _first_rows(text: str, limit: int) -> list[dict[str, Any]]:
    """Return the first ``limit`` elements of a JSON list without parsing the other elements."""
    scan = json.JSONDecoder().raw_decode
    rows: list[dict[str, Any]] = []
    position = 1
    while len(rows) < limit:
        while position < len(text) and text[position] in " ,]":
            position += 1
        if position >= len(text):
            break
        row, position = scan(text, position)
        rows.append(row)
    return rows
