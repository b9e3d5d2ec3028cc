"""customer_answers: collect what a drawing of a customer teaches, and use it in the next one.

A question is answered from earlier drawings only if two witnesses agree: two drawings of the
customer, or one drawing and the shape of the edges.  What was decided without a question is never
changed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.classification.decision.profile_rules import fold_name
from knifetip.classification.line_widths import distinguishing_widths
from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.geometry.columns import I64, U8
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message, printable
from knifetip.model.customer_answers import LearnedAnswer, Look, LookUse
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.vocabulary import is_meaningless

#: Confidence of a line type that earlier drawings give, and of one that they only suggest.
_CONFIDENCE: Final = 0.9
#: Least confidence with which the shape of edges counts as a witness, or contradicts the drawings.
_WITNESS, _CONTRADICTS = 0.5, 0.75
#: Number of drawings that a reason names.
_NAMED: Final = 3
#: Greatest number of looks that are remembered of one drawing.
_MOST_LOOKS: Final = 200


def collect_uses(drawing: Drawing, dieline: Dieline, overrides: U8) -> tuple[LookUse, ...]:
    """Return what a drawing teaches: the line types that its user gave to open edges.

    The line types of decided edges of the same looks are included, because they may contradict.
    The result is empty if the user answered no question.

    Parameters
    ----------
    drawing, dieline
        The drawing with n edges, and its dieline without the line types that the user gave.
    overrides : (n,) uint8
        Line type that the user gave to each edge, or ``NO_OVERRIDE``.
    """
    is_open = dieline.line_type == LineType.UNCLASSIFIED
    given = np.where(overrides != NO_OVERRIDE, overrides, dieline.line_type)
    known = given != LineType.UNCLASSIFIED
    looks, look = tabulate_looks(drawing)
    rows = np.flatnonzero(known)
    if len(rows) == 0:
        return ()
    rule = np.where(is_open, dieline.rule, -1)
    first, group = unique_rows(look[rows], rule[rows], given[rows])
    count = np.bincount(group)
    reasons = ["", *map(_reason_codes, dieline.rules)]
    edges: dict[tuple[int, str, int], int] = defaultdict(int)
    for at, row in enumerate(rows[first].tolist()):
        key = int(look[row]), reasons[int(rule[row]) + 1], int(given[row])
        edges[key] += int(count[at])
    return tuple(
        LookUse(looks[number], reason, LineType(kind), total)
        for (number, reason, kind), total in edges.items()
    )[:_MOST_LOOKS]


def answer_from_drawings(
    drawing: Drawing, dieline: Dieline, learned: Iterable[LearnedAnswer]
) -> Dieline:
    """Return a dieline in which learned answers decide open edges, or suggest their line types.

    An answer decides if it is sure or if it is also the best guess for the edges.  It neither
    decides nor suggests if the shape of the edges clearly means another line type.

    Parameters
    ----------
    drawing, dieline
        The drawing and its dieline, with the same n edges.
    learned
        The answers of the customer's earlier drawings.
    """
    by_key = {(one.look, one.reason): one for one in learned}
    open_rows = np.flatnonzero(dieline.line_type == LineType.UNCLASSIFIED)
    if not by_key or len(open_rows) == 0:
        return dieline
    looks, look = tabulate_looks(drawing)
    first, group = unique_rows(look[open_rows], dieline.rule[open_rows])
    line_type, rule = dieline.line_type.copy(), dieline.rule.copy()
    confidence = dieline.confidence.copy()
    rules, alternatives = list(dieline.rules), list(dieline.alternatives)
    for at, row in enumerate(open_rows[first].tolist()):
        number = int(dieline.rule[row])
        reason = _reason_codes(dieline.rules[number])
        key = looks[int(look[row])]
        answer = by_key.get((key, "")) or by_key.get((key, reason))
        if answer is None:
            continue
        guesses = dieline.alternatives[number]
        guess = guesses[0] if guesses else None
        trust = float(dieline.confidence[row])
        if guess not in (None, answer.line_type) and trust >= _CONTRADICTS:
            continue
        rows = open_rows[group == at]
        agrees = guess == answer.line_type and trust >= _WITNESS
        decides = answer.sure or (agrees and answer.reason == "")
        rule[rows], confidence[rows] = len(rules), _CONFIDENCE
        code = "classification.learned" if decides else "classification.learned-guess"
        rules.append(Message(code, drawings=answer.drawings[:_NAMED]))
        if decides:
            line_type[rows] = answer.line_type
            alternatives.append(())
        else:
            others = (kind for kind in guesses if kind != answer.line_type)
            alternatives.append((answer.line_type, *others))
    return replace(
        dieline,
        line_type=line_type,
        rule=rule,
        confidence=confidence,
        rules=tuple(rules),
        alternatives=tuple(alternatives),
    )


def learned_edges(
    drawing: Drawing, dieline: Dieline, learned: Iterable[LearnedAnswer]
) -> dict[LearnedAnswer, I64]:
    """Return the rows of the edges that have their line type from each learned answer.

    Of the answers for one look and line type, only the first is returned, with the edges of all.
    Answers that decided no edge are left out.
    """
    codes = np.array([rule.code == "classification.learned" for rule in dieline.rules], np.bool_)
    if not codes.any():
        return {}
    decided = np.flatnonzero((dieline.rule >= 0) & codes[dieline.rule])
    looks, look = tabulate_looks(drawing)
    first = {(one.look, one.line_type): one for one in reversed(tuple(learned))}
    found: dict[LearnedAnswer, I64] = {}
    pairs, group = unique_rows(look[decided], dieline.line_type[decided])
    for at, row in enumerate(decided[pairs].tolist()):
        key = looks[int(look[row])], LineType(int(dieline.line_type[row]))
        if key in first:
            found[first[key]] = decided[group == at]
    return found


def tabulate_looks(drawing: Drawing) -> tuple[list[Look], I64]:
    """Return the looks of a drawing, and the number of the look of each of its n edges, (n,)."""
    style = (drawing.layer, drawing.colour, drawing.true_colour, drawing.linetype)
    width_number = distinguishing_widths(drawing.line_width, *style[1:])
    width = np.where(width_number > 0, drawing.line_width, -1)
    first, row = unique_rows(*style, width)
    names = [drawing.layers[number] for number in drawing.layer[first]]
    attributes = (*style[1:], width)
    values = list(zip(*(column[first].tolist() for column in attributes), strict=True))
    series = find_numbered_layers(
        (name, value[:3]) for name, value in zip(names, values, strict=True)
    )
    number: dict[Look, int] = {}
    of_row = [
        number.setdefault(
            Look(
                "" if name in series or is_meaningless(name) else printable(fold_name(name)),
                colour,
                true_colour,
                printable(fold_name(drawing.linetypes[linetype])),
                line_width,
            ),
            len(number),
        )
        for name, (colour, true_colour, linetype, line_width) in zip(names, values, strict=True)
    ]
    return list(number), np.array(of_row, np.int64)[row]


def _reason_codes(reason: Message) -> str:
    """Return the codes of a message and of all messages in it, in order, joined by "/"."""
    codes = [reason.code]
    for value in reason.arguments.values():
        inner = value if isinstance(value, tuple) else (value,)
        codes += [_reason_codes(one) for one in inner if isinstance(one, Message)]
    return "/".join(codes)
