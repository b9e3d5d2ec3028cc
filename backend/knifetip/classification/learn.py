"""learn: the smallest rules that would have given what somebody corrected by hand.

    Drawing, Dieline, overrides, LineRules -> list[ProposedRule]

A rule is proposed only where it contradicts nothing: no edge that was left as it is with another
line type, and no other correction, may meet it.  Edges that nobody has decided yet may; it says how
many.  A layer whose name means nothing (``0``, ``Default``, ``Design``) is named together with
a colour.  What attributes cannot tell apart, as when some of the red lines of one layer are cuts
and others creases, teaches nothing.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from knifetip.classification import rules as matching
from knifetip.classification.rules import Styles
from knifetip.classification.words import meaningless
from knifetip.geometry.columns import I64, U8, Bool
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.profile import LineRule, LineRules, ProposedRule

_KEEP = 255
_TRAITS = ("layer", "colour", "linetype", "entity", "block")
#: Which traits a rule names, in the order in which people would say them.
_SHAPES: tuple[tuple[str, ...], ...] = (
    ("layer",),
    ("layer", "colour"),
    ("block",),
    ("layer", "linetype"),
    ("colour",),
    ("colour", "linetype"),
    *(
        chosen
        for size in (1, 2, 3, 4, 5)
        for chosen in combinations(_TRAITS, size)
        if chosen not in (("layer",), ("layer", "colour"), ("block",), ("layer", "linetype"))
        and chosen not in (("colour",), ("colour", "linetype"))
    ),
)


def learned(
    drawing: Drawing, dieline: Dieline, overrides: U8, profile: LineRules
) -> list[ProposedRule]:
    """Return rules that explain somebody's corrections, those that explain most first.

    Parameters
    ----------
    drawing, dieline
        The same n edges, as they were classified; with or without the overrides on top.
    overrides : (n,) uint8
        LineType, or 255 where the edge was left as it is.
    profile
        What the drawing was classified by.  What it says already is not proposed.

    Returns
    -------
    list of ProposedRule
        To be put before the profile's own rules.
    """
    given = np.asarray(overrides, np.uint8)
    said = given != _KEEP
    if given.shape != (len(dieline),):
        raise ValueError(f"{given.shape} overrides for {len(dieline)} edges")
    styles = matching.styles(drawing)
    known = matching.match(styles, profile)
    wanted = np.where(said, given, dieline.line_type)
    # What the profile alone gives these edges need not be learned.
    news = said & (known.line_type[styles.of] != given) & (given != LineType.UNCLASSIFIED)
    open_ = ~said & (dieline.line_type == LineType.UNCLASSIFIED)
    proposed: list[ProposedRule] = []
    for value in np.unique(wanted[news]).tolist():
        against = ~open_ & (wanted != value)
        spoilt = np.bincount(styles.of[against], minlength=len(styles)) > 0
        left = np.bincount(styles.of[news & (wanted == value)], minlength=len(styles)) > 0
        while (found := _best(styles, left, spoilt, LineType(value))) is not None:
            rule, covered = found
            left &= ~covered
            rows = covered[styles.of]
            explains = np.flatnonzero(rows & said)
            changes = np.flatnonzero(rows & open_)
            proposed.append(ProposedRule(rule, tuple(explains.tolist()), tuple(changes.tolist())))
    return sorted(proposed, key=lambda one: -len(one.explains))


def _best(styles: Styles, left: Bool, spoilt: Bool, kind: LineType) -> tuple[LineRule, Bool] | None:
    """Return the rule that explains most of what is left, the first of those as good."""
    best: tuple[int, LineRule, Bool] | None = None
    codes = {name: _codes(styles, name) for name in _TRAITS}
    for shape in _SHAPES:
        tried = set()
        for row in np.flatnonzero(left).tolist():
            if "layer" in shape and "colour" not in shape and meaningless(styles.layer[row]):
                continue
            if "block" in shape and not styles.block[row]:
                continue
            key = tuple(int(codes[name][row]) for name in shape)
            if key in tried:
                continue
            tried.add(key)
            covered = np.ones(len(styles), np.bool_)
            for name in shape:
                covered &= codes[name] == codes[name][row]
            if (covered & spoilt).any():
                continue
            count = int((covered & left).sum())
            if best is None or count > best[0]:
                best = count, _rule(styles, row, shape, kind), covered
    return None if best is None else best[1:]


def _codes(styles: Styles, name: str) -> I64:
    """Return a number for each style that is the same where the trait is, (c,)."""
    if name == "colour":
        traits: list[object] = list(
            zip(styles.colour.tolist(), styles.true_colour.tolist(), strict=True)
        )
    else:
        traits = [matching.folded(one) for one in getattr(styles, name)]
    number: dict[object, int] = {}
    return np.array([number.setdefault(trait, len(number)) for trait in traits], np.int64)


def _rule(styles: Styles, row: int, shape: tuple[str, ...], kind: LineType) -> LineRule:
    index, true = int(styles.colour[row]), int(styles.true_colour[row])
    coloured = "colour" in shape
    names = {
        name: (matching.literal(getattr(styles, name)[row]),) for name in shape if name != "colour"
    }
    return LineRule(
        kind,
        colour=(index,) if coloured and index else (),
        true_colour=(true,) if coloured and not index else (),
        **names,
    )
