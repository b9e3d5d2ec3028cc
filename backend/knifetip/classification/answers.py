"""answers: decide what follows from the line types that the user gives to some edges.

A user who answers a question states what a colour and line style mean in the drawing.  Edges with
the same look that are still open get the same line type.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.classification.line_widths import distinguishing_widths
from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.classification.swapped_rules import swapped_answers
from knifetip.geometry.columns import I64, U8
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.vocabulary import is_meaningless

#: Reason for the line type of an edge that follows from answers.
FOLLOWS: Final = Message("classification.follows")
#: Confidence of a line type that follows from answers.
_CONFIDENCE: Final = 0.9


def follow_answers(drawing: Drawing, decided: Dieline, dieline: Dieline, overrides: U8) -> Dieline:
    """Return a dieline in which open edges have the line types that follow from the user's answers.

    An open edge follows if the user gave one line type to at least as many edges of its look as are
    open, and no edge of its look was decided otherwise.  If its shape suggests another line type,
    the user must have refused the same suggestion for an edge of this look.  Edges have one look if
    they have the same colour, line style and visible line width, and lie on one layer, on layers of
    a series, or on layers whose names have no meaning.  If the profile seems to swap cut and
    crease, the answer for the edges of one rule also decides those of the other.

    Parameters
    ----------
    drawing
        The drawing with n edges.
    decided
        Its dieline, before the user gave any line type.
    dieline
        Its dieline, with the line types that the user gave.
    overrides : (n,) uint8
        Line type that the user gave to each edge, or ``NO_OVERRIDE``.
    """
    is_open = dieline.line_type == LineType.UNCLASSIFIED
    answered = (overrides != NO_OVERRIDE) & ~is_open
    if not (is_open.any() and answered.any()):
        return dieline
    meant = swapped_answers(decided, overrides)
    by_swap = is_open & (meant != NO_OVERRIDE)
    look = _number_looks(drawing)
    count = int(look.max()) + 1
    open_edges = np.bincount(look[is_open], minlength=count)
    answers = np.bincount(look[answered], minlength=count)
    kind = np.zeros(count, np.uint8)
    kind[look[answered]] = overrides[answered]
    # One edge with another line type, given or decided, is enough to doubt.
    other = ~is_open & (dieline.line_type != kind[look])
    doubtful = np.bincount(look[other], minlength=count) > 0
    # An edge whose shape suggests another line type stays open, unless the user has refused this
    # suggestion for an edge of its look.
    guess = _suggested_types(decided)
    refused = np.zeros((count, len(LineType)), np.bool_)
    refused[look[answered], guess[answered]] = True
    agrees = (guess == LineType.UNCLASSIFIED) | (guess == kind[look]) | refused[look, guess]
    follows = is_open & agrees & ((answers >= open_edges) & ~doubtful)[look] | by_swap
    given = np.where(by_swap, meant, kind[look])
    if not follows.any():
        return dieline
    return replace(
        dieline,
        line_type=np.where(follows, given, dieline.line_type),
        rule=np.where(follows, len(dieline.rules), dieline.rule),
        confidence=np.where(follows, _CONFIDENCE, dieline.confidence),
        rules=(*dieline.rules, FOLLOWS),
        alternatives=(*dieline.alternatives, ()) if dieline.alternatives else (),
    )


def _suggested_types(dieline: Dieline) -> U8:
    """Return the line type that the drawing suggests for each open edge, (n,) uint8; 0 for none."""
    first = np.array([one[0] if one else 0 for one in dieline.alternatives] or [0], np.uint8)
    suggested: U8 = np.where(dieline.rule >= 0, first[np.maximum(dieline.rule, 0)], 0)
    return suggested


def _number_looks(drawing: Drawing) -> I64:
    """Return the number of the look of each of n edges, (n,).

    A look has one line width, unless the widths of its edges differ by chance.
    """
    attributes = (drawing.colour, drawing.true_colour, drawing.linetype)
    first, row = unique_rows(drawing.layer, *attributes)
    names = [drawing.layers[layer] for layer in drawing.layer[first]]
    looks = list(zip(*(column[first].tolist() for column in attributes), strict=True))
    series = find_numbered_layers(zip(names, looks, strict=True))
    number: dict[tuple[str, tuple[int, ...]], int] = {}
    of_row = [
        number.setdefault(
            ("" if is_meaningless(name) else series.get(name, name).casefold(), look), len(number)
        )
        for name, look in zip(names, looks, strict=True)
    ]
    look = np.array(of_row, np.int64)[row]
    width = distinguishing_widths(drawing.line_width, look)
    return unique_rows(look, width)[1] if width.any() else look
