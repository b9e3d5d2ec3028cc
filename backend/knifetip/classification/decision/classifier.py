"""classifier: decide the line type of edges from rules, shape features, names and colours.

Edges of one style in one role get the same decision.  A rule of the profile decides unless the
shape contradicts it: a crease cannot be the outline of a blank.  Without a rule, two independent
kinds of evidence must agree, or the shape must be certain.  A decision with a confidence below
``MIN_CONFIDENCE`` becomes a question that has the best guess as its first choice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.classification.decision.conventions import FOLD_TYPES, FittingConvention
from knifetip.classification.decision.profile_rules import (
    RuleMatches,
    StyleTable,
    display_name,
)
from knifetip.classification.decision.style_totals import StyleTotals
from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.classification.vocabulary import NameMeaning, is_dashed_linetype, name_meaning
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules

#: Decisions with less confidence become questions.
MIN_CONFIDENCE: Final = 0.8

#: Line types of lines between panels.
_DIVIDING: Final = (*FOLD_TYPES, LineType.HALF_CUT)
#: Roles that are so certain that they override rules.
_OVERRIDING_ROLES: Final = (Role.ARROW, Role.LEGEND)
#: A style is the main fold style if it has more than this fraction of the length of all dividers …
_MAIN_FOLD_FRACTION: Final = 0.6
#: … and if more than this fraction of the length of its own dividers must be folds.
_MUST_FOLD_FRACTION: Final = 0.5
#: Folds in other styles count if they are longer than this fraction of the main folds.
_OTHER_FOLDS: Final = 0.05
#: Line types that a closed line inside a panel may have, besides cut.
_CLOSED_IN_PANEL: Final = (LineType.PERFORATION, LineType.COMBI, LineType.HALF_CUT)
#: Confidence that edges in these roles are ignored.
_IGNORED_CONFIDENCE: Final[dict[Role, float]] = {
    Role.FRAME: 0.85,
    Role.ARROW: 0.95,
    Role.BLEED: 0.9,
    Role.LETTER: 0.85,
    Role.DEBRIS: 0.85,
    Role.NAMED: 0.9,
    Role.LEGEND: 0.95,
}
_LIKE_OUTLINE: Final = (Message("classification.like-outline"),)
_CUT_FIRST: Final = (LineType.CUT, LineType.IGNORED, LineType.CREASE)
#: Possible line types of each role, the likeliest first.
_POSSIBLE_TYPES: Final[dict[Role, tuple[LineType, ...]]] = {
    **dict.fromkeys(Role, _CUT_FIRST),
    Role.DIVIDER: (LineType.CREASE, LineType.CUT, LineType.PERFORATION, LineType.V_GROOVE),
    Role.SLIT: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    Role.FREE: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    **dict.fromkeys(HOLES, (LineType.CUT, LineType.HALF_CUT, LineType.IGNORED)),
    **dict.fromkeys(NOT_CARTON, (LineType.IGNORED, LineType.CUT)),
}


@dataclass(frozen=True, slots=True)
class Decision:
    """The line type decided for the edges of one style in one role, with confidence and reason.

    A style is a combination of layer, colour and dash pattern; a role is what an edge is in the
    shape of the drawing, such as outline or hole.
    """

    kind: LineType  #: the best guess
    confidence: float  #: 0 … 1
    reason: Message  #: the rule or the evidence
    others: tuple[LineType, ...] = ()  #: other possible line types, the likeliest first
    by_rule: bool = False  #: whether a rule decides and nothing contradicts it

    @property
    def needs_answer(self) -> bool:
        """Whether the user must decide: the confidence is too low or the line type is unknown."""
        unsure = self.confidence < MIN_CONFIDENCE and not self.by_rule
        return unsure or self.kind == LineType.UNCLASSIFIED


class _Guess:
    """The likeliest line type of some edges, with confidence, reasons and alternatives.

    Each kind of evidence, such as a layer name, may change the guess.
    """

    def __init__(self, kind: LineType, confidence: float) -> None:
        self.kind = kind
        self.confidence = confidence
        self.votes: list[Message] = []
        self.others: list[LineType] = []

    def strengthen(self, factor: float) -> None:
        """Raise the confidence: multiply 1 minus the confidence by ``factor``, which is below 1."""
        self.confidence = 1.0 - (1.0 - self.confidence) * factor

    def replace(self, kind: LineType, confidence: float) -> None:
        """Replace the line type of the guess by ``kind``, and its confidence by ``confidence``."""
        self.kind, self.confidence = kind, confidence

    def weaken(self, limit: float, *others: LineType) -> None:
        """Reduce the confidence to at most ``limit``, and add alternatives to the guess.

        The alternatives, ``others``, are line types that are also possible.
        """
        self.confidence = min(self.confidence, limit)
        self.others.extend(others)


@dataclass(frozen=True, eq=False, slots=True)
class Classifier:
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
    ) -> Classifier:
        """Return the classifier of a drawing.

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
            self._meaning(style)[0].kind is None
            and not is_dashed_linetype(self.styles.linetype[style].casefold())
            for style in range(len(self.styles))
        ]
        return (self.matches.rule < 0) & np.array(solid, np.bool_) & (self.dashed <= 0.5)

    def decide(self, style: int, role: Role, *, must_fold: bool = False) -> Decision:
        """Return the decision for the edges of a style that have a role.

        Parameters
        ----------
        style
            Index of the style, 0 … c - 1.
        role
            Role of the edges in the shape of the drawing.
        must_fold
            Whether a panel is attached by these edges alone.
        """
        if self.matches.rule[style] >= 0:
            return self._decide_by_rule(style, role)
        return self._decide_by_evidence(style, role, must_fold)

    # ── styles with a rule in the profile ────────────────────────────────────────────────────────

    def _decide_by_rule(self, style: int, role: Role) -> Decision:
        """Return the decision that follows from a style's profile rule and the role of its edges.

        If the shape contradicts the rule, the decision has a low confidence, or a different line
        type with the line type of the rule as an alternative.  ``style`` is the index of the style,
        and ``role`` the role of the edges in the drawing's shape.
        """
        kind = LineType(int(self.matches.line_type[style]))
        confidence = float(self.matches.confidence[style])
        rule = Message(
            "classification.rule", profile=self.profile.name, rule=self.matches.conditions[style]
        )
        if kind == LineType.UNCLASSIFIED:
            return Decision(kind, 0.0, rule)
        if self.swapped and kind != LineType.IGNORED:
            swapped = Message("classification.contradicted", rule=rule, reason=self.swapped)
            if role in (Role.OUTLINE, *HOLES, Role.DIVIDER):
                guess = _likeliest_type(role)
                others = tuple(one for one in (kind,) if one != guess)
                return Decision(guess, 0.6, swapped, others)
            return Decision(kind, 0.3, swapped)
        if not self.has_outline or role in (Role.UNKNOWN, Role.OPEN):
            return Decision(kind, confidence, rule, by_rule=True)
        if role in _OVERRIDING_ROLES and kind != LineType.IGNORED:
            reason = _contradiction_message(rule, role, None)
            return Decision(LineType.IGNORED, _IGNORED_CONFIDENCE[role], reason, (kind,))
        against, instead = self._contradiction(kind, confidence, style, role)
        if against:
            reason = _contradiction_message(rule, role, against)
            return Decision(kind, min(confidence, 0.5), reason, instead)
        return Decision(kind, confidence, rule, by_rule=True)

    def _contradiction(
        self, kind: LineType, confidence: float, style: int, role: Role
    ) -> tuple[Message | None, tuple[LineType, ...]]:
        """Return why the shape contradicts a profile rule, and the other possible line types.

        If nothing contradicts the rule, the message is None and the tuple of line types is empty.
        ``kind`` and ``confidence`` are the line type that the rule gives and the confidence in the
        rule; ``style`` and ``role`` are the style and the role of the edges.
        """
        weak = confidence < 0.9
        if kind == LineType.IGNORED:
            if role in (Role.OUTLINE, Role.DIVIDER):
                kinds = (_likeliest_type(role), LineType.CUT)
                return Message("classification.must-be-processed"), kinds
            return None, ()
        if role in (Role.STRAY, Role.DEBRIS):
            return Message("classification.closes-nothing"), (LineType.IGNORED,)
        if role in NOT_CARTON:
            return Message("classification.not-made"), (LineType.IGNORED,)
        if kind == LineType.CUT:
            if role == Role.DIVIDER and weak and self.only_divides[style]:
                return Message("classification.none-closes"), (LineType.CREASE,)
            return None, ()
        if role == Role.OUTLINE or (role == Role.MARK and weak):
            return Message("classification.board-ends"), (LineType.CUT,)
        if role in (*HOLES, Role.INNER) and kind not in _CLOSED_IN_PANEL:
            return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
        if role in (Role.FREE, Role.SLIT) and weak and kind == LineType.CREASE:
            return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
        return None, ()

    # ── styles without a rule ────────────────────────────────────────────────────────────────────

    def _decide_by_evidence(self, style: int, role: Role, must_fold: bool) -> Decision:
        """Return the decision that shape, conventions and names suggest for a style without a rule.

        ``style`` is the index of the style, ``role`` is the role of the edges in the drawing's
        shape, and ``must_fold`` is whether a panel is attached by these edges alone.
        """
        if role == Role.OPEN:
            shape = Message(
                "classification.no-rule-but-shape",
                profile=self.profile.name,
                shape=Message("classification.shape", parts=[role.message]),
            )
            return Decision(LineType.UNCLASSIFIED, 0.0, shape)
        if not self.has_outline or role == Role.UNKNOWN:
            reason = Message("classification.no-rule", profile=self.profile.name)
            return Decision(LineType.UNCLASSIFIED, 0.0, reason)
        kind, confidence, details = self._guess_by_shape(style, role, must_fold)
        guess = _Guess(kind, confidence)
        guess.votes.append(Message("classification.shape", parts=[role.message, *details]))
        guess.others.append(_likeliest_type(role))
        if role not in _IGNORED_CONFIDENCE:
            self._weigh_conventions(guess, style, role)
        self._weigh_names(guess, style, role)
        others = [kind for kind in dict.fromkeys(guess.others) if kind != guess.kind]
        for kind in _POSSIBLE_TYPES[role]:
            if kind != guess.kind and kind not in others:
                others.append(kind)
        reason = Message("classification.votes", votes=guess.votes)
        return Decision(guess.kind, guess.confidence, reason, tuple(others[:3]))

    def _weigh_conventions(self, guess: _Guess, style: int, role: Role) -> None:
        """Change a guess by the line types that colour conventions give to the colour of a style.

        Only the conventions that fit the drawing are used.  ``style`` and ``role`` are the style
        and the role of the edges that ``guess`` is about.
        """
        types = {LineType(int(fit.line_type[style])) for fit in self.conventions}
        types.discard(LineType.UNCLASSIFIED)
        if len(types) > 1:
            guess.weaken(0.75, *sorted(types))
        if len(types) != 1:
            return
        (kind,) = types
        fit = next(fit for fit in self.conventions if fit.line_type[style] == kind)
        if kind == guess.kind:
            # Solid lines are cuts in most conventions: weak evidence for holes and the like.
            common = kind in (LineType.CUT, LineType.CREASE)
            guess.strengthen(0.4 if common and role in (Role.OUTLINE, Role.DIVIDER) else 0.8)
            guess.votes.append(fit.message)
        elif role == Role.DIVIDER and guess.kind == LineType.CREASE and kind in _DIVIDING:
            guess.replace(kind, 0.65)
            guess.votes.append(fit.message)
        elif role in NOT_CARTON:
            guess.confidence *= 0.9
        else:
            guess.weaken(0.6, kind)

    def _weigh_names(self, guess: _Guess, style: int, role: Role) -> None:
        """Change a guess by the meaning of a style's layer name or dash pattern name.

        The name of the dash pattern is used only if the layer name has no meaning.  ``style`` and
        ``role`` are the style and the role of the edges that ``guess`` is about.
        """
        meaning, by_layer = self._meaning(style)
        if meaning.denied:
            if by_layer:
                guess.weaken(0.7)
                layer = display_name(self.styles.layer[style])
                guess.votes.append(Message("classification.layer-denies", layer=layer))
            return
        named = meaning.kind
        if named is None:
            return
        divides = role in (Role.DIVIDER, Role.SLIT, Role.FREE, *HOLES) and named in _DIVIDING
        ignores = named == LineType.IGNORED and role in (Role.FREE, Role.SLIT, Role.MARK, *HOLES)
        if named == guess.kind:
            guess.strengthen(0.25)
        elif role == Role.DIVIDER and named in _DIVIDING:
            guess.replace(named, 0.9)
        elif divides or ignores:
            guess.replace(named, 0.7)
        else:
            guess.weaken(0.5, named)
        if by_layer:
            guess.votes.append(Message("classification.layer-name", word=meaning.word))
        else:
            guess.votes.append(Message("classification.linetype-name", word=meaning.word))

    def _meaning(self, style: int) -> tuple[NameMeaning, bool]:
        """Return the meaning of a style's name, and whether that name is the layer name.

        The name is the layer name or, if the layer name suggests no line type and contains no
        negating word, the name of the dash pattern.  If neither name suggests a line type, the line
        type of the meaning is None.  ``style`` is the index of the style.
        """
        meaning = name_meaning(self.styles.layer[style])
        if meaning.kind is None and not meaning.denied:
            return name_meaning(self.styles.linetype[style]), False
        return meaning, True

    def _guess_by_shape(
        self, style: int, role: Role, must_fold: bool
    ) -> tuple[LineType, float, Sequence[Message]]:
        """Return the line type that shape alone suggests, its confidence, and the reasons.

        ``style`` and ``role`` are the style and the role of the edges; ``must_fold`` is whether a
        panel is attached by them alone.
        """
        own, total = self.length[style], self.total
        outlines = own[Role.OUTLINE] >= 0.3 * total[Role.OUTLINE]
        # Only one style has the folds of a drawing.
        folds_elsewhere = outlines and self.other_folds[style] > 1.4 * own[Role.DIVIDER]
        if role == Role.OUTLINE:
            # A style with dividers does not close the outline if another style closes most of it.
            minor = own[Role.OUTLINE] < 0.5 * total[Role.OUTLINE]
            if minor and own[Role.DIVIDER] > 0.25 * own[Role.OUTLINE]:
                return LineType.CUT, 0.5, [Message("classification.other-style-closes")]
            return LineType.CUT, 0.95, ()
        if role in HOLES:
            if outlines and self.other_folds[style]:
                return LineType.CUT, 0.9, _LIKE_OUTLINE
            if outlines and role == Role.SLOT:
                return LineType.CUT, 0.85, _LIKE_OUTLINE
            return LineType.CUT, 0.75 if outlines else 0.6, ()
        if role == Role.DIVIDER:
            if folds_elsewhere:
                return LineType.CUT, 0.85, [Message("classification.like-outline-not-folds")]
            return self._guess_divider(style, must_fold, bool(outlines))
        if role in (Role.SLIT, Role.FREE):
            if folds_elsewhere:
                return LineType.CUT, 0.85, _LIKE_OUTLINE
            if self.only_divides[style]:
                return LineType.CREASE, 0.6, ()
            return LineType.CUT, 0.6 if outlines else 0.4, ()
        if role in NOT_CARTON:
            nothing_else = sum(own[part] for part in NOT_CARTON) >= 0.95 * own.sum()
            if role == Role.BLEED and own[[Role.OUTLINE, *HOLES]].any():
                # A window round another part is drawn like the cuts, and a bleed line seldom is.
                return LineType.IGNORED, 0.6, ()
            if role == Role.TABLE:
                return LineType.IGNORED, 0.85 if nothing_else else 0.6, ()
            confidence = _IGNORED_CONFIDENCE.get(role, 0.65 if nothing_else else 0.5)
            return LineType.IGNORED, confidence, ()
        return LineType.CUT, 0.6 if outlines else 0.4, ()

    def _guess_divider(
        self, style: int, must_fold: bool, outlines: bool
    ) -> tuple[LineType, float, Sequence[Message]]:
        """Return the line type that shape suggests for dividers, its confidence, and the reasons.

        Dividers are the edges between two panels.  ``style`` is the style of the dividers, and
        ``must_fold`` is whether a panel is attached by them alone.  ``outlines`` is whether edges
        of this style make up at least 30 % of the length of all outlines.
        """
        own = self.length[style, Role.DIVIDER]
        if self.only_divides[style]:
            reasons = [Message("classification.as-its-style")]
            if self.main_folds[style]:
                reasons.append(Message("classification.panels-hang"))
                # With folds in two styles, either style may be perforated.
                two_styles = self.other_folds[style] > _OTHER_FOLDS * own
                return LineType.CREASE, 0.75 if two_styles else 0.9, reasons
            linetype = self.styles.linetype[style].casefold()
            dashed = is_dashed_linetype(linetype) or self.dashed[style] > 0.5
            if dashed:
                reasons.append(Message("classification.dashed"))
            if self.paired[style] > 0.1:
                reasons.append(Message("classification.paired"))
            return LineType.CREASE, 0.75 if dashed else 0.7, reasons
        if must_fold and not (outlines and self.other_folds[style]):
            return LineType.CREASE, 0.85, [Message("classification.panel-hangs")]
        return LineType.CREASE, 0.55, ()


def _likeliest_type(role: Role) -> LineType:
    """Return the likeliest line type of edges with the given role in the shape of a drawing."""
    return _POSSIBLE_TYPES[role][0]


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
    kind of entity or in the block.
    """
    number: dict[tuple[str, int, int, str], int] = {}
    return np.array(
        [
            number.setdefault(traits, len(number))
            for traits in zip(
                styles.layer,
                styles.colour.tolist(),
                styles.true_colour.tolist(),
                styles.linetype,
                strict=True,
            )
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


def _contradiction_message(rule: Message, role: Role, against: Message | None) -> Message:
    """Return the message that the role of edges contradicts a rule.

    ``rule`` is the clause that names the rule.  ``against`` is the clause that explains why the
    role contradicts it, or None.
    """
    reason = Message("classification.role-against", role=role.message, against=against)
    return Message("classification.contradicted", rule=rule, reason=reason)
