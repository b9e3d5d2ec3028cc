"""ledger: every entity of a file as the page lists it, and where that stands which gave no line.

    Drawing -> rows of plain data: handle, kind, layer, fate, reason, length, box; text and place

An entity that became edges is found by them.  Words, hatches and the like become none, so the box
around them goes with them; of words what they say, and how large.
"""

from __future__ import annotations

from collections import defaultdict
from functools import lru_cache
from typing import Any

from knifetip.jobs.report import said
from knifetip.messages import Message
from knifetip.model.drawing import Drawing, Fate, Inscription

_FATES = {fate.value: fate.name.lower() for fate in Fate}
#: Kinds, layers and reasons come again and again.
_said = lru_cache(maxsize=4096)(said)
_as_json = lru_cache(maxsize=4096)(Message.as_json)


def listed(drawing: Drawing) -> list[dict[str, Any]]:
    """Return the ledger of a drawing, a row to an entity, in the order of the file."""
    ledger = drawing.ledger
    rows: list[dict[str, Any]] = [
        {
            "handle": said(handle),
            "kind": _said(kind),
            "layer": _said(layer),
            "fate": _FATES[fate],
            "reason": _as_json(reason),
            "length": round(length, 6),
        }
        for handle, kind, layer, fate, reason, length in zip(
            ledger.handle,
            ledger.kind,
            ledger.layer,
            ledger.fate.tolist(),
            ledger.reason,
            ledger.length.tolist(),
            strict=True,
        )
    ]
    for row, box in zip(
        ledger.location_boxes.rows.tolist(), ledger.location_boxes.box.tolist(), strict=True
    ):
        rows[row]["box"] = [round(side, 6) for side in box]
    for row, found in inscribed(drawing).items():
        rows[row] |= {"text": said(found.text), "place": [found.x, found.y, found.height]}
    return rows


def inscribed(drawing: Drawing) -> dict[int, Inscription]:
    """Return the words of a drawing by their row of the ledger.

    Words have no handle, but both lists are in the order of the file.  Of a kind and layer of
    which one list has more than the other, none is matched: a wrong place is worse than none.
    """
    ledger = drawing.ledger
    words: dict[tuple[str, str], list[Inscription]] = defaultdict(list)
    for one in drawing.inscriptions:
        words[one.kind, one.layer].append(one)
    rows: dict[tuple[str, str], list[int]] = defaultdict(list)
    for row, named in enumerate(zip(ledger.kind, ledger.layer, strict=True)):
        # What a block holds stands wherever the block is placed.
        if (
            named in words
            and "/" not in ledger.handle[row]
            and not (ledger.block and ledger.block[row])
            and ledger.reason[row].code != "import.paper-space"
        ):
            rows[named].append(row)
    return {
        row: one
        for named, ones in words.items()
        if len(rows[named]) == len(ones)
        for row, one in zip(rows[named], ones, strict=True)
    }
