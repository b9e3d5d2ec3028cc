"""Note the drawn lines that are not made because a line of another type lies on them.

A cut replaces a crease on its line without a word, since the crease would be cut away.  A V-groove
and a crease, a half-cut or a perforation on one line are two ways to fold there: the drawing means
one of them, and a person should know which one is made.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.expectation.edges import place_edges

#: Line types that make a fold, of which only one is made on a line.
_FOLDS: Final = (LineType.V_GROOVE, LineType.CREASE, LineType.HALF_CUT, LineType.PERFORATION)
#: Least length that is noted (mm).
_LEAST: Final = 0.5
#: Greatest number of notes.
_MOST: Final = 50


def note_replaced(drawn: Dieline, cleaned: Cleaned) -> list[Finding]:
    """Return a note for each drawn edge on which an edge of another fold type is made instead.

    ``drawn`` is the dieline before cleaning; ``cleaned`` is the dieline after cleaning, with the
    cleaned edge that each drawn stretch became.
    """
    parts = cleaned.stretches
    rows = np.flatnonzero(parts.by_other_edge & (parts.cleaned >= 0))
    before = drawn.line_type[parts.row[rows]]
    after = cleaned.dieline.line_type[parts.cleaned[rows]]
    rows = rows[(before != after) & np.isin(before, _FOLDS) & np.isin(after, _FOLDS)]
    if len(rows) == 0:
        return []
    edge = parts.row[rows].astype(np.int64)
    placed, size = place_edges(drawn, (0.0, 0.0)), np.zeros(len(drawn))
    size[placed.row] = placed.curve[:, 5]
    length = (parts.end - parts.begin)[rows] * size[edge]
    made = cleaned.dieline.line_type[parts.cleaned[rows]].astype(np.int64)
    pairs, index = np.unique(np.column_stack([edge, made]), axis=0, return_inverse=True)
    total = np.bincount(index.ravel(), length)
    return [
        Finding(
            "near",
            Message(
                "verify.replaced",
                type=LineType(drawn.line_type[row]).word,
                other=LineType(kind).word,
                length=float(total[number]),
            ),
            float(total[number]),
            int(row),
            severity=Severity.NOTE,
        )
        for number, (row, kind) in enumerate(pairs.tolist())
        if total[number] >= _LEAST
    ][:_MOST]
