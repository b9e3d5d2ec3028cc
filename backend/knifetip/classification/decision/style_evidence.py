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
from knifetip.classification.line_widths import distinguishing_widths
from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules
from knifetip.vocabulary import NameMeaning, is_dashed_linetype, name_meaning

#: A style is the main fold style if it has more than this fraction of the length of all dividers …
_MAIN_FOLD_FRACTION: Final = 0.6
#: … and if more than this fraction of the length of its own dividers must be folds.
_MUST_FOLD_FRACTION: Final = 0.5
#: A line width with at most this fraction of the length of its look's outlines closes none.
_STRAY_OUTLINE_FRACTION: Final = 0.02


@dataclass(frozen=True, eq=False, slots=True)
class StyleEvidence:
    """The evidence about the c styles of one drawing, from which the line types are decided."""

    styles: StyleTable
    profile: LineRules
    matches: RuleMatches
    conventions: Sequence[FittingConvention]
    #: (c,) group of styles with equal layer, colour, dash pattern and, where it matters, line width
    style_groups: I64
    by_width: Bool  #: (c,) whether other styles differ from it only in their line width
    length: F64  #: (c, roles) of all edges in the group of the style
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
        length = totals.length
        look = _group_styles(styles)
        group = _divide_groups(look, styles.width, length)
        by_width = np.bincount(look)[look] != np.bincount(group)[group]
        grouped = _sum_groups(group, length)
        only_divides = _only_divides(grouped)
        folds = np.where(only_divides, grouped[:, Role.DIVIDER], 0.0)
        must_fold = _divider_fraction(totals.must_fold, group, grouped) > _MUST_FOLD_FRACTION
        main = grouped[:, Role.DIVIDER] > _MAIN_FOLD_FRACTION * length[:, Role.DIVIDER].sum()
        return cls(
            styles,
            profile,
            matches,
            conventions,
            group,
            by_width,
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
            self.style_meaning(style)[0].kind is None
            and not is_dashed_linetype(self.styles.linetype[style].casefold())
            for style in range(len(self.styles))
        ]
        return (self.matches.rule < 0) & np.array(solid, np.bool_) & (self.dashed <= 0.5)

    def style_meaning(self, style: int) -> tuple[NameMeaning, bool]:
        """Return the meaning of a style's name, and whether that name is the layer name.

        The name is the layer name or, if the layer name suggests no line type and contains no
        negating word, the name of the dash pattern.  If neither name suggests a line type, the line
        type of the meaning is None.  ``style`` is the index of the style.
        """
        style_meaning = name_meaning(self.styles.layer[style])
        if style_meaning.kind is None and not style_meaning.denied:
            return name_meaning(self.styles.linetype[style]), False
        return style_meaning, True


def divide_by_line_width(styles: StyleTable, line_width: I32) -> StyleTable:
    """Return the styles of a drawing, divided where their line widths distinguish edges.

    Parameters
    ----------
    styles
        The c styles of a drawing with n edges, without line widths.
    line_width : (n,)
        Line width of each edge, as in ``Drawing``.
    """
    if len(line_width) == 0 or (line_width == line_width[0]).all():
        return styles
    width = distinguishing_widths(line_width, _group_styles(styles)[styles.row])
    if not width.any():
        return styles
    first, row = unique_rows(styles.row, width)
    style = styles.row[first]

    def names(column: Sequence[str]) -> tuple[str, ...]:
        return tuple(column[one] for one in style.tolist())

    return StyleTable(
        row,
        names(styles.layer),
        styles.colour[style],
        styles.true_colour[style],
        names(styles.linetype),
        names(styles.entity),
        names(styles.block),
        width[first],
    )


def _sum_groups(group: I64, length: F64) -> F64:
    """Return the sums of lengths (c, roles) over the groups of c styles, (groups, roles)."""
    grouped = np.zeros((int(group.max(initial=-1)) + 1, length.shape[1]))
    np.add.at(grouped, group, length)
    return grouped


def _carton_length(grouped: F64) -> F64:
    """Return the length of the edges of each group that may belong to a carton, (groups,)."""
    carton: F64 = grouped.sum(axis=1) - grouped[:, list(NOT_CARTON)].sum(axis=1)
    return carton


def _only_divides(grouped: F64) -> Bool:
    """Return the mask of the groups whose edges are nearly all dividers, (groups,).

    ``grouped`` (groups, roles) is the length of the edges of each group, by role.
    """
    carton = _carton_length(grouped)
    closing = grouped[:, [Role.OUTLINE, *HOLES, Role.MARK]].sum(axis=1)
    mask: Bool = (
        (grouped[:, Role.DIVIDER] >= 0.85 * carton) & (closing <= 0.02 * carton) & (carton > 0.0)
    )
    return mask


def _divide_groups(look: I64, width: I32, length: F64) -> I64:
    """Return the groups of c styles, (c,), divided by line width where it distinguishes folds.

    A look is divided if most of its dividers have a width whose lines only divide panels, and the
    lines of another width do not.  It is also divided if it is the only look of all cartons and has
    two widths, neither of which only divides panels, and one of which closes all outlines.
    Otherwise the widths have no known meaning: the cuts of a colour have two widths, or one line
    was drawn thinner by chance.

    ``look`` (c,): number of the layer, colour and dash pattern of each style.
    ``width`` (c,): number of the line width of each style within its look, 0 if it has no meaning.
    ``length`` (c, roles): length of the edges of each style, by role.
    """
    if not width.any():
        return look
    first, part = unique_rows(look, width)
    grouped = _sum_groups(part, length)
    look_of, is_carton = look[first], _carton_length(grouped) > 0.0
    folds = _only_divides(grouped)
    looks = int(look.max()) + 1
    with_folds, with_others, with_carton = (
        np.bincount(look_of[mask], minlength=looks) > 0
        for mask in (folds, is_carton & ~folds, is_carton)
    )
    divider = grouped[:, Role.DIVIDER]
    dividers = np.bincount(look_of, divider)
    own_dividers = np.bincount(look_of, np.where(folds, divider, 0.0))
    told = with_folds & with_others & (own_dividers > _MAIN_FOLD_FRACTION * dividers)
    outline = grouped[:, Role.OUTLINE]
    stray = _STRAY_OUTLINE_FRACTION * np.bincount(look_of, outline)
    closing = np.bincount(look_of[outline > stray[look_of]], minlength=looks)
    is_alone = (np.count_nonzero(with_carton) == 1) & (np.bincount(look_of) == 2) & with_carton
    divided = told | (is_alone & (closing == 1) & ~with_folds)
    _, group = unique_rows(look, np.where(divided[look], width, 0))
    return group


def _divider_fraction(part: F64, group: I64, grouped: F64) -> F64:
    """Return the fraction of divider length that has some property, by groups of styles, (c,).

    Dividers are the edges between two panels.  Styles with equal layer, colour, dash pattern and
    line width form a group.  The fraction, 0 … 1, is computed for each group, and the result
    contains for each of c styles the fraction of its group.

    ``part`` (c,): total length of the dividers of each style that have the property, for example
    are dashed.
    ``group`` (c,): index of the group of each style.
    ``grouped`` (groups, roles): total length of the edges of each group, by role.
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

    ``matches``: the profile rule that matches each of c styles.
    ``length`` (c, roles): length of the edges of each style in each role.
    ``conventions``: colour conventions that fit the drawing; the message names the first one.
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
