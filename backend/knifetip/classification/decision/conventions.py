"""conventions: find the colour conventions of other companies that fit a drawing.

Red is a cut in one company and a crease in another.  The shape shows which convention a drawing
uses: outlines must be cuts, and lines between panels must be creases.  A convention does not fit if
it makes a part of an outline a crease or leaves the outline open.

A convention may know dashes only: "dashed lines are creases".  Where dashed lines have several
looks, it refers to the most frequent one; the others may be perforations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.classification.decision.profile_rules import (
    RuleMatches,
    StyleTable,
    fold_name,
    match_rules,
)
from knifetip.classification.decision.style_totals import StyleTotals
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules

#: Line types of fold lines.
FOLD_TYPES: Final = (LineType.CREASE, LineType.V_GROOVE, LineType.PERFORATION, LineType.COMBI)
#: Largest number of styles of a drawing for which conventions are tried.
_MOST_STYLES: Final = 2000
#: Least fraction of the outlines' length that a fitting convention cuts.
_MIN_CUT: Final = 0.97
#: Least fraction of the dividers, by length and by number, that a fitting convention creases.
_MIN_CREASED: Final = 0.6
#: Least fraction of the dividers' length in looks that one rule on dashes folds, for the main look.
_MAIN_LOOK: Final = 0.6


@dataclass(frozen=True, eq=False, slots=True)
class FittingConvention:
    """A colour convention that fits a drawing, and the line type that it gives to each style."""

    name: str
    line_type: U8  #: (c,) UNCLASSIFIED where it has no rule
    message: Message  #: why the convention fits


def find_fitting_conventions(
    styles: StyleTable, unmatched: Bool, totals: StyleTotals, conventions: Sequence[LineRules]
) -> list[FittingConvention]:
    """Return the colour conventions that fit the shape of a drawing, the best one first.

    Parameters
    ----------
    styles, totals
        The c styles of the drawing, and the total lengths of the edges of each style.
    unmatched : (c,)
        Mask of styles without a rule in the profile; conventions are compared with these styles
        only.
    conventions
        Colour conventions of companies, each with only the rules by which it differs from the
        others.
    """
    outline = np.where(unmatched, totals.length[:, Role.OUTLINE], 0.0)
    divider = np.where(unmatched, totals.length[:, Role.DIVIDER], 0.0)
    if not outline.any() or not divider.any() or len(styles) > _MOST_STYLES:
        return []
    found: list[tuple[float, FittingConvention]] = []
    for convention in conventions:
        matches = match_rules(styles, convention)
        line_type = _only_main_dashes(styles, matches, convention, divider)
        cut = line_type == LineType.CUT
        fold = np.isin(line_type, FOLD_TYPES)
        creased = float(divider[line_type == LineType.CREASE].sum() / divider.sum())
        closed = outline[cut].sum() / outline.sum()
        folds = divider[fold].sum() / divider.sum()
        contradicted = outline[~cut & (line_type != LineType.UNCLASSIFIED)].sum() / outline.sum()
        folded = int(totals.edges[fold & unmatched, Role.DIVIDER].sum())
        dividers = int(totals.edges[unmatched, Role.DIVIDER].sum())
        # A convention with creases must crease most dividers, not only perforate them.
        if closed < _MIN_CUT or contradicted > 0.0:
            continue
        if creased < _MIN_CREASED or folded < _MIN_CREASED * dividers:
            continue
        message = Message(
            "classification.convention", name=convention.name, folds=folded, lines=dividers
        )
        score = closed + folds + creased
        found.append((score, FittingConvention(convention.name, line_type, message)))
    found.sort(key=lambda scored: -scored[0])
    return [fit for _, fit in found]


def _only_main_dashes(
    styles: StyleTable, matches: RuleMatches, convention: LineRules, divider: F64
) -> U8:
    """Return the line types that a convention gives to c styles, (c,), without doubtful dashes.

    A rule on dash patterns alone folds dashed lines of any colour.  If one look of these lines has
    most of their dividers, the rule counts for this look only.  A look is a layer, colour and dash
    pattern.  If none has most, the layers may be parts of the carton, and a look is a colour and
    dash pattern.  If none of these has most, the rule counts for no dashed line.

    ``styles``, ``matches``: the styles of the drawing, and the rule of the convention that matches
    each of them.
    ``divider`` (c,): length of the dividers of each style.
    """
    line_type = matches.line_type
    by_dashes = np.array(
        [bool(rule.linetype) and not (rule.colour or rule.true_colour) for rule in convention.rules]
        # The last entry is that of styles without a rule.
        + [False]
    )
    folded = by_dashes[matches.rule] & np.isin(line_type, FOLD_TYPES)
    if np.count_nonzero(folded) < 2:
        return line_type
    colour = (styles.colour, styles.true_colour, _numbers(styles.linetype))
    main = np.zeros(len(styles), np.bool_)
    for columns in ((_numbers(styles.layer), *colour), colour):
        _, look = unique_rows(*columns)
        length = np.bincount(look, np.where(folded, divider, 0.0))
        main = (length >= _MAIN_LOOK * length.sum())[look]
        if main.any():
            break
    return np.where(folded & ~main, LineType.UNCLASSIFIED, line_type).astype(np.uint8)


def _numbers(names: Sequence[str]) -> I32:
    """Return for each of c names a number that is equal for equal names, (c,)."""
    number: dict[str, int] = {}
    return np.array([number.setdefault(fold_name(name), len(number)) for name in names], np.int32)
