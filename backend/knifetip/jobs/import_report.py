"""The import report as rows of JSON data, with locations and texts.

    Drawing -> rows: handle, kind, layer, outcome, reason, length, box; text and place

Entities with edges are located by their edges.  Texts, hatches and other entities without edges
have a bounding box; texts also have their content and height.
"""

from __future__ import annotations

from collections import defaultdict
from functools import lru_cache
from typing import Any

from knifetip.jobs.report import said
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, Drawing, ImportOutcome

_OUTCOMES = {outcome.value: outcome.name.lower() for outcome in ImportOutcome}
#: Cached, since kinds, layers and reasons repeat.
_said = lru_cache(maxsize=4096)(said)
_as_json = lru_cache(maxsize=4096)(Message.as_json)


def listed(drawing: Drawing) -> list[dict[str, Any]]:
    """Return the import report of a drawing, one row per entity in file order."""
    import_report = drawing.import_report
    rows: list[dict[str, Any]] = [
        {
            "handle": said(handle),
            "kind": _said(kind),
            "layer": _said(layer),
            "outcome": _OUTCOMES[outcome],
            "reason": _as_json(reason),
            "length": round(length, 6),
        }
        for handle, kind, layer, outcome, reason, length in zip(
            import_report.handle,
            import_report.kind,
            import_report.layer,
            import_report.outcome.tolist(),
            import_report.reason,
            import_report.length.tolist(),
            strict=True,
        )
    ]
    for row, box in zip(
        import_report.location_boxes.rows.tolist(),
        import_report.location_boxes.box.tolist(),
        strict=True,
    ):
        rows[row]["box"] = [round(side, 6) for side in box]
    for row, found in inscribed(drawing).items():
        rows[row] |= {"text": said(found.text), "place": [found.x, found.y, found.height]}
    return rows


def inscribed(drawing: Drawing) -> dict[int, Annotation]:
    """Return the texts of a drawing by their row of the import report.

    Texts have no handle, so they are matched by file order within each kind and layer.  If the two
    counts differ, none of that kind and layer is matched: a wrong location is worse than none.
    """
    import_report = drawing.import_report
    words: dict[tuple[str, str], list[Annotation]] = defaultdict(list)
    for one in drawing.annotations:
        words[one.kind, one.layer].append(one)
    rows: dict[tuple[str, str], list[int]] = defaultdict(list)
    for row, named in enumerate(zip(import_report.kind, import_report.layer, strict=True)):
        # Entities of a block have the locations of its references.
        if (
            named in words
            and "/" not in import_report.handle[row]
            and not (import_report.block and import_report.block[row])
            and import_report.reason[row].code != "import.paper-space"
        ):
            rows[named].append(row)
    return {
        row: one
        for named, ones in words.items()
        if len(rows[named]) == len(ones)
        for row, one in zip(rows[named], ones, strict=True)
    }
