"""rule_proposals: propose profile rules that give the line types that a user chose by hand.

A line type that the user chooses for an edge is called an override.  A proposed rule gives one line
type.  It never matches an edge for which the user chose a different one, nor an edge without an
override that was classified as a different one.  It may match unclassified edges; the field
``changes`` of the proposal lists them.  A layer whose name has no meaning (``0``, ``Default``,
``Design``) is combined with a colour.  No rule is proposed if the edges of two overrides have the
same attributes, for example if the user made some red lines of a layer cuts and others creases.
"""

from __future__ import annotations

from itertools import combinations
from typing import Final

import numpy as np

from knifetip.classification.decision.profile_rules import (
    StyleTable,
    escape_pattern,
    fold_name,
    match_rules,
    tabulate_styles,
)
from knifetip.geometry.columns import I64, U8, Bool
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.profile import LineRule, LineRules, ProposedRule
from knifetip.vocabulary import is_meaningless

_TRAITS: Final = ("layer", "colour", "linetype", "entity", "block")
_PREFERRED: Final[tuple[tuple[str, ...], ...]] = (
    ("layer",),
    ("layer", "colour"),
    ("block",),
    ("layer", "linetype"),
    ("colour",),
    ("colour", "linetype"),
)
#: Combinations of traits that a rule may name, the most natural first.
_TRAIT_SETS: Final = (
    *_PREFERRED,
    *(
        traits
        for size in (1, 2, 3, 4, 5)
        for traits in combinations(_TRAITS, size)
        if traits not in _PREFERRED
    ),
)


def propose_rules(
    drawing: Drawing, dieline: Dieline, overrides: U8, profile: LineRules
) -> list[ProposedRule]:
    """Return rules that would give the line types that the user chose by hand.

    A line type that the user chose for an edge is called an override.  The rule that explains most
    overrides comes first.

    Parameters
    ----------
    drawing
        The drawing, with n edges.
    dieline
        The dieline of the drawing, with the same n edges.  The line types that it has at edges with
        an override are not used.
    overrides : (n,) uint8
        Line type that the user gave to each edge, or ``NO_OVERRIDE`` (255) for edges that the user
        left as they are.
    profile
        The profile that classified the drawing.  No rule is returned for overrides that are equal
        to the line type that the profile gives.

    Returns
    -------
    list of ProposedRule
        Rules to be inserted before the rules of the profile.

    Raises
    ------
    ValueError
        The length of ``overrides`` is not n.
    """
    user_type = np.asarray(overrides, np.uint8)
    overridden = user_type != NO_OVERRIDE
    if user_type.shape != (len(dieline),):
        raise ValueError(f"{user_type.shape} overrides for {len(dieline)} edges")
    styles = tabulate_styles(drawing)
    by_profile = match_rules(styles, profile).line_type[styles.row]
    wanted = np.where(overridden, user_type, dieline.line_type)
    unexplained = overridden & (by_profile != user_type) & (user_type != LineType.UNCLASSIFIED)
    undecided = ~overridden & (dieline.line_type == LineType.UNCLASSIFIED)
    proposed: list[ProposedRule] = []
    for value in np.unique(wanted[unexplained]).tolist():
        different = ~undecided & (wanted != value)
        excluded = np.bincount(styles.row[different], minlength=len(styles)) > 0
        same = unexplained & (wanted == value)
        remaining = np.bincount(styles.row[same], minlength=len(styles)) > 0
        while (found := _best_rule(styles, remaining, excluded, LineType(value))) is not None:
            rule, covered = found
            remaining &= ~covered
            rows = covered[styles.row]
            explains = np.flatnonzero(rows & overridden)
            changes = np.flatnonzero(rows & undecided)
            proposed.append(ProposedRule(rule, tuple(explains.tolist()), tuple(changes.tolist())))
    return sorted(proposed, key=lambda proposal: -len(proposal.explains))


def _best_rule(
    styles: StyleTable, remaining: Bool, excluded: Bool, kind: LineType
) -> tuple[LineRule, Bool] | None:
    """Return the best rule that gives a line type, and the mask of the styles that it covers, (c,).

    A rule that covers a style in ``excluded`` is not permitted.  The best permitted rule covers the
    largest number of styles in ``remaining``.  Of equally good rules, the one whose attributes come
    first in the constant ``_TRAIT_SETS`` is returned.  Returns None if no rule is permitted.

    ``styles``: the c styles of the drawing.
    ``remaining``, ``excluded`` (c,): masks of the styles that still need a rule and of the styles
    that the rule must not match.
    """
    best: tuple[int, LineRule, Bool] | None = None
    codes = {trait: _trait_codes(styles, trait) for trait in _TRAITS}
    for traits in _TRAIT_SETS:
        tried = set()
        for row in np.flatnonzero(remaining).tolist():
            by_layer = "layer" in traits and "colour" not in traits
            if by_layer and is_meaningless(styles.layer[row]):
                continue
            if "block" in traits and not styles.block[row]:
                continue
            key = tuple(int(codes[trait][row]) for trait in traits)
            if key in tried:
                continue
            tried.add(key)
            covered = np.ones(len(styles), np.bool_)
            for trait in traits:
                covered &= codes[trait] == codes[trait][row]
            if (covered & excluded).any():
                continue
            count = int((covered & remaining).sum())
            if best is None or count > best[0]:
                best = count, _rule_for(styles, row, traits, kind), covered
    return None if best is None else best[1:]


def _trait_codes(styles: StyleTable, trait: str) -> I64:
    """Return integers, (c,), that are equal for styles with the same value of an attribute.

    ``trait`` is the name of the attribute, a column of ``StyleTable`` such as ``layer``, and c is
    the number of styles.
    """
    if trait == "colour":
        values: list[object] = list(
            zip(styles.colour.tolist(), styles.true_colour.tolist(), strict=True)
        )
    else:
        values = [fold_name(name) for name in getattr(styles, trait)]
    number: dict[object, int] = {}
    return np.array([number.setdefault(value, len(number)) for value in values], np.int64)


def _rule_for(styles: StyleTable, row: int, traits: tuple[str, ...], kind: LineType) -> LineRule:
    """Return the rule that gives a line type to all edges with the attributes of one style.

    ``kind`` is the line type, and ``row`` the index of the style in ``styles``.  Only the
    attributes named in ``traits``, such as ``layer`` or ``colour``, are compared.
    """
    index, true = int(styles.colour[row]), int(styles.true_colour[row])
    coloured = "colour" in traits
    names = {
        trait: (escape_pattern(getattr(styles, trait)[row]),)
        for trait in traits
        if trait != "colour"
    }
    return LineRule(
        kind,
        colour=(index,) if coloured and index else (),
        true_colour=(true,) if coloured and not index else (),
        **names,
    )
