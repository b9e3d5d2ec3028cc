"""style_evidence: gather the evidence about the styles of a drawing.

The evidence are the rules of the profile, shape features, names and colours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.classification.decision.conventions import FittingConvention
from knifetip.classification.decision.profile_rules import RuleMatches, StyleTable
from knifetip.classification.decision.style_totals import StyleTotals
from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.classification.vocabulary import NameMeaning, is_dashed_linetype, name_meaning
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules

#: A style is the main fold style if it has more than this fraction of the length of all dividers …
_MAIN_FOLD_FRACTION: Final = 0.6
#: … and if more than this fraction of the length of its own dividers must be folds.
_MUST_FOLD_FRACTION: Final = 0.5


@dataclass(frozen=True, eq=False, slots=True)
class StyleEvidence:
    """The evidence about the c styles of one drawing, from which the line types are decided."""

    styles: StyleTable
    profile: LineRules
    matches: RuleMatches
    conventions: Sequence[FittingConvention]
    style_groups: I64  #: (c,) group of styles with equal layer, colour and dash pattern
    length: F64  #: (c, roles) of all edges that share layer, colour and linetype with the style
    total: F64  #: (roles,) length of all edges
    other_folds: F64  #: (c,) length of dividers in other styles that have nearly only dividers
    only_divides: Bool  #: (c,) whether nearly all edges of the style are dividers
    dashed: F64  #: (c,) fraction of the dividers' length that is in rows of dashes
    paired: F64  #: (c,) fraction of the dividers' length with a parallel line beside it
    main_folds: Bool  #: (c,) whether it is the main fold style
    has_outline: bool  #: whether the drawing has blanks with a closed outline
    swapped: Message | None  #: why the profile seems to swap cut and crease; None if it does not

    @classmethod
    def create(
        cls,
        styles: StyleTable,
        profile: LineRules,
        matches: RuleMatches,
        totals: StyleTotals,
        conventions: Sequence[FittingConvention],
    ) -> StyleEvidence:
        """Return the evidence about the styles of a drawing.

        Parameters
        ----------
        styles
            The c styles of the drawing.
        profile
            The customer's profile.
        matches
            The profile rule that matches each style, if any.
        totals
            Total lengths of the edges of each style.
        conventions
            Colour conventions that fit the drawing.
        """
        group = _group_styles(styles)
        length = totals.length
        grouped = np.zeros((int(group.max(initial=-1)) + 1, length.shape[1]))
        np.add.at(grouped, group, length)
        carton = grouped.sum(axis=1) - grouped[:, list(NOT_CARTON)].sum(axis=1)
        closing = grouped[:, [Role.OUTLINE, *HOLES, Role.MARK]].sum(axis=1)
        only_divides = (
            (grouped[:, Role.DIVIDER] >= 0.85 * carton)
            & (closing <= 0.02 * carton)
            & (carton > 0.0)
        )
        folds = np.where(only_divides, grouped[:, Role.DIVIDER], 0.0)
        must_fold = _divider_fraction(totals.must_fold, group, grouped) > _MUST_FOLD_FRACTION
        main = grouped[:, Role.DIVIDER] > _MAIN_FOLD_FRACTION * length[:, Role.DIVIDER].sum()
        return cls(
            styles,
            profile,
            matches,
            conventions,
            group,
            grouped[group],
            length.sum(axis=0),
            (folds.sum() - folds)[group],
            only_divides[group],
            _divider_fraction(totals.dashed, group, grouped),
            _divider_fraction(totals.paired, group, grouped),
            must_fold & main[group],
            bool(length[:, Role.OUTLINE].any()),
            _swap_reason(matches, length, conventions),
        )

    def only_shape_and_colour(self) -> Bool:
        """Return the mask of the styles for which only shape and colour are evidence, (c,).

        They have no profile rule, no name that suggests a line type, and no dashes.
        """
        solid = [
            self.meaning(style)[0].kind is None
            and not is_dashed_linetype(self.styles.linetype[style].casefold())
            for style in range(len(self.styles))
        ]
        return (self.matches.rule < 0) & np.array(solid, np.bool_) & (self.dashed <= 0.5)

    def meaning(self, style: int) -> tuple[NameMeaning, bool]:
        """Return the meaning of a style's name, and whether that name is the layer name.

        The name is the layer name or, if the layer name suggests no line type and contains no
        negating word, the name of the dash pattern.  If neither name suggests a line type, the line
        type of the meaning is None.  ``style`` is the index of the style.
        """
        meaning = name_meaning(self.styles.layer[style])
        if meaning.kind is None and not meaning.denied:
            return name_meaning(self.styles.linetype[style]), False
        return meaning, True


def _divider_fraction(part: F64, group: I64, grouped: F64) -> F64:
    """Return the fraction of divider length that has some property, by groups of styles, (c,).

    Dividers are the edges between two panels.  Styles with equal layer, colour and dash pattern
    form a group.  The fraction, 0 … 1, is computed for each group, and the result contains for each
    of c styles the fraction of its group.

    Parameters
    ----------
    part : (c,)
        Total length of the dividers of each style that have the property, for example are dashed.
    group : (c,)
        Index of the group of each style.
    grouped : (groups, roles)
        Total length of the edges of each group, by role.
    """
    total = np.maximum(grouped[:, Role.DIVIDER], 1e-12)
    fraction: F64 = (np.bincount(group, part, len(grouped)) / total)[group]
    return fraction


def _group_styles(styles: StyleTable) -> I64:
    """Return the index of the group of each of c styles, (c,).

    Styles with equal layer, colour and dash pattern are in one group, even if they differ in the
    kind of entity or in the block.  Layers whose names only count are equal.
    """
    looks = list(
        zip(styles.colour.tolist(), styles.true_colour.tolist(), styles.linetype, strict=True)
    )
    series = find_numbered_layers(zip(styles.layer, looks, strict=True))
    number: dict[tuple[str, tuple[int, int, str]], int] = {}
    return np.array(
        [
            number.setdefault((series.get(layer, layer), look), len(number))
            for layer, look in zip(styles.layer, looks, strict=True)
        ],
        np.int64,
    )


def _swap_reason(
    matches: RuleMatches, length: F64, conventions: Sequence[FittingConvention]
) -> Message | None:
    """Return the message why the profile seems to swap cut and crease, or None if it does not.

    Parameters
    ----------
    matches
        The profile rule that matches each of c styles.
    length : (c, roles)
        Length of the edges of each style in each role.
    conventions
        Colour conventions that fit the drawing; the message names the first one.
    """
    folds = np.isin(matches.line_type, (LineType.CREASE, LineType.V_GROOVE, LineType.COMBI))
    cuts = matches.line_type == LineType.CUT
    outline, divider = length[:, Role.OUTLINE], length[:, Role.DIVIDER]
    whole = outline.sum()
    if not whole or outline[folds].sum() < 0.5 * whole or outline[cuts].sum() > 0.2 * whole:
        return None
    both = divider[cuts].sum() > 0.0
    reason = Message("classification.swapped-both" if both else "classification.swapped")
    if not conventions:
        return reason
    return Message("classification.swapped-like", reason=reason, convention=conventions[0].message)
