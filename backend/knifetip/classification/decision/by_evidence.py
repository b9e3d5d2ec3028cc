"""by_evidence: decide the line type of edges whose style has no rule in the profile.

Two independent kinds of evidence must agree (shape, colour conventions, names), or the shape must
be certain.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from knifetip.classification.decision.conventions import FOLD_TYPES
from knifetip.classification.decision.decision import Decision
from knifetip.classification.decision.profile_rules import display_name
from knifetip.classification.decision.role_types import (
    IGNORED_CONFIDENCE,
    POSSIBLE_TYPES,
    likeliest_type,
)
from knifetip.classification.decision.style_evidence import StyleEvidence
from knifetip.classification.shape.open_dividers import DividerKind
from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.vocabulary import is_dashed_linetype

#: Line types of lines between panels.
_DIVIDING: Final = (*FOLD_TYPES, LineType.HALF_CUT)
#: Line types that no other word means, unlike folds.
_PARTIAL: Final = (LineType.PERFORATION, LineType.HALF_CUT)
#: Folds in other styles count if they are longer than this fraction of the main folds.
_OTHER_FOLDS: Final = 0.05
#: With folds in another style that are longer than this multiple, dashes are hardly creases.
_MAIN_FOLDS: Final = 1.5
#: Message about a name, by whether it is that of a layer and whether it suggests the guess.
_NAMES: Final = {
    (True, True): "classification.layer-name",
    (True, False): "classification.layer-name-against",
    (False, True): "classification.linetype-name",
    (False, False): "classification.linetype-name-against",
}
#: Confidence of a guess that is the most likely line type, but would not contradict what earlier
#: drawings of the customer teach.
_LIKELY: Final = 0.74
#: Line type, confidence and reasons of dividers that their style does not distinguish.
_OPEN_DIVIDERS: Final[dict[DividerKind, tuple[LineType, float, Sequence[Message]]]] = {
    DividerKind.OTHER: (LineType.CREASE, _LIKELY, ()),
    DividerKind.CORNERS: (LineType.CUT, _LIKELY, (Message("classification.corners"),)),
    DividerKind.SLOT_SIDE: (LineType.CUT, _LIKELY, (Message("classification.slot-side"),)),
    DividerKind.FOLD_END: (LineType.CUT, _LIKELY, (Message("classification.fold-end"),)),
    DividerKind.PART_OF_SIDE: (LineType.CUT, _LIKELY, (Message("classification.part-of-side"),)),
    DividerKind.THROUGH: (LineType.CREASE, _LIKELY, (Message("classification.through"),)),
    DividerKind.RING_SLIT: (LineType.CUT, _LIKELY, (Message("classification.ring-slit"),)),
    DividerKind.RING_FOLD: (LineType.CREASE, _LIKELY, (Message("classification.ring-fold"),)),
    DividerKind.ALONG: (LineType.CREASE, 0.55, (Message("classification.along"),)),
    DividerKind.PERPENDICULAR: (LineType.CREASE, 0.55, (Message("classification.across"),)),
    DividerKind.OBLIQUE: (LineType.CREASE, 0.55, (Message("classification.oblique"),)),
    DividerKind.SHARED: (LineType.CUT, 0.6, (Message("classification.shared"),)),
}
_LIKE_OUTLINE: Final = (Message("classification.like-outline"),)


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


def decide_by_evidence(
    evidence: StyleEvidence,
    style: int,
    role: Role,
    must_fold: bool,
    divider: DividerKind = DividerKind.OTHER,
) -> Decision:
    """Return the decision that shape, conventions and names suggest for a style without a rule.

    ``style`` is the index of the style, ``role`` is the role of the edges in the drawing's
    shape, and ``must_fold`` is whether a panel is attached by these edges alone.  ``divider`` is
    what their ends show.
    """
    if role == Role.OPEN:
        shape = Message(
            "classification.no-rule-but-shape",
            profile=evidence.profile.name,
            shape=Message("classification.shape", parts=[role.message]),
        )
        return Decision(LineType.UNCLASSIFIED, 0.0, shape)
    if not evidence.has_outline or role == Role.UNKNOWN:
        reason = Message("classification.no-rule", profile=evidence.profile.name)
        return Decision(LineType.UNCLASSIFIED, 0.0, reason)
    kind, confidence, details = _guess_by_shape(evidence, style, role, must_fold, divider)
    guess = _Guess(kind, confidence)
    guess.votes.append(Message("classification.shape", parts=[role.message, *details]))
    guess.others.append(likeliest_type(role))
    if role not in IGNORED_CONFIDENCE:
        _weigh_conventions(evidence, guess, style, role)
    _weigh_names(evidence, guess, style, role, must_fold)
    others = [kind for kind in dict.fromkeys(guess.others) if kind != guess.kind]
    for kind in POSSIBLE_TYPES[role]:
        if kind != guess.kind and kind not in others:
            others.append(kind)
    reason = Message("classification.votes", votes=guess.votes)
    return Decision(guess.kind, guess.confidence, reason, tuple(others[:3]))


def _weigh_conventions(evidence: StyleEvidence, guess: _Guess, style: int, role: Role) -> None:
    """Change a guess by the line types that colour conventions give to the colour of a style.

    Only the conventions that fit the drawing are used.  ``style`` and ``role`` are the style
    and the role of the edges that ``guess`` is about.
    """
    types = {LineType(int(fit.line_type[style])) for fit in evidence.conventions}
    types.discard(LineType.UNCLASSIFIED)
    if len(types) > 1:
        guess.weaken(0.75, *sorted(types))
    if len(types) != 1:
        return
    (kind,) = types
    fit = next(fit for fit in evidence.conventions if fit.line_type[style] == kind)
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


def _weigh_names(
    evidence: StyleEvidence, guess: _Guess, style: int, role: Role, must_fold: bool
) -> None:
    """Change a guess by the meaning of a style's layer name or dash pattern name.

    The name of the dash pattern is used only if the layer name has no meaning.  ``style`` and
    ``role`` are the style and the role of the edges that ``guess`` is about, and ``must_fold`` is
    whether a panel is attached by them alone.
    """
    style_meaning, by_layer = evidence.style_meaning(style)
    if style_meaning.denied:
        if by_layer:
            guess.weaken(0.7)
            layer = display_name(evidence.styles.layer[style])
            guess.votes.append(Message("classification.layer-denies", layer=layer))
        return
    named = style_meaning.kind
    if named is None:
        return
    if not by_layer and named == LineType.IGNORED and evidence.only_divides[style]:
        # Many CAD programs draw bends with the line style of centre lines.
        return
    divides = role in (Role.DIVIDER, Role.SLIT, Role.FREE, *HOLES) and named in _DIVIDING
    ignores = named == LineType.IGNORED and role in (Role.FREE, Role.SLIT, Role.MARK, *HOLES)
    if named == guess.kind:
        guess.strengthen(0.25)
    elif role == Role.DIVIDER and named in _DIVIDING:
        # A word for cuts and a word for folds in one name need not mean a combined line type.
        guess.replace(named, 0.7 if named == LineType.COMBI and " " in style_meaning.word else 0.9)
    elif divides or ignores:
        guess.replace(named, 0.85 if named in _PARTIAL else 0.7)
    elif role == Role.DIVIDER and named == LineType.CUT and not must_fold:
        # A contour that is drawn twice divides narrow strips from the panels.
        guess.replace(named, 0.6)
    else:
        guess.weaken(0.5, named)
    guess.votes.append(Message(_NAMES[by_layer, named == guess.kind], word=style_meaning.word))


def _guess_by_shape(
    evidence: StyleEvidence, style: int, role: Role, must_fold: bool, divider: DividerKind
) -> tuple[LineType, float, Sequence[Message]]:
    """Return the line type that shape alone suggests, its confidence, and the reasons.

    ``style`` and ``role`` are the style and the role of the edges; ``must_fold`` is whether a
    panel is attached by them alone, and ``divider`` what their ends
    show.
    """
    own, total = evidence.length[style], evidence.total
    outlines = own[Role.OUTLINE] >= 0.3 * total[Role.OUTLINE]
    # Only one style has the folds of a drawing.
    folds_elsewhere = outlines and evidence.other_folds[style] > 1.4 * own[Role.DIVIDER]
    if role == Role.OUTLINE:
        if divider == DividerKind.OPEN_FLAP:
            return LineType.CUT, 0.6, [Message("classification.open-flap")]
        # A style with dividers does not close the outline if another style closes most of it.
        minor = own[Role.OUTLINE] < 0.5 * total[Role.OUTLINE]
        if minor and own[Role.DIVIDER] > 0.25 * own[Role.OUTLINE]:
            return LineType.CUT, 0.5, [Message("classification.other-style-closes")]
        return LineType.CUT, 0.95, ()
    if role in HOLES:
        if outlines and evidence.other_folds[style]:
            return LineType.CUT, 0.9, _LIKE_OUTLINE
        if outlines and role == Role.SLOT:
            return LineType.CUT, 0.85, _LIKE_OUTLINE
        return LineType.CUT, 0.75 if outlines else 0.6, ()
    if role == Role.DIVIDER:
        if folds_elsewhere:
            return LineType.CUT, 0.85, [Message("classification.like-outline-not-folds")]
        return _guess_divider(evidence, style, must_fold, divider)
    if role in (Role.SLIT, Role.FREE):
        if folds_elsewhere:
            return LineType.CUT, 0.85, _LIKE_OUTLINE
        if evidence.only_divides[style]:
            return LineType.CREASE, 0.6, ()
        likely = _LIKELY if role == Role.FREE else 0.6
        return LineType.CUT, likely if outlines else 0.4, ()
    if role in NOT_CARTON:
        nothing_else = sum(own[part] for part in NOT_CARTON) >= 0.95 * own.sum()
        if role == Role.BLEED and own[[Role.OUTLINE, *HOLES]].any():
            # A window round another part is drawn like the cuts, and a bleed line seldom is.
            return LineType.IGNORED, _LIKELY, ()
        if role in (Role.TABLE, Role.LABELLED):
            return LineType.IGNORED, 0.85 if nothing_else else 0.6, ()
        confidence = IGNORED_CONFIDENCE.get(role, 0.65 if nothing_else else 0.5)
        return LineType.IGNORED, confidence, ()
    return LineType.CUT, 0.6 if outlines else 0.4, ()


def _guess_divider(
    evidence: StyleEvidence, style: int, must_fold: bool, divider: DividerKind
) -> tuple[LineType, float, Sequence[Message]]:
    """Return the line type that shape suggests for dividers, its confidence, and the reasons.

    Dividers are the edges between two panels.  ``style`` is the style of the dividers, and
    ``must_fold`` is whether a panel is attached by them alone, and ``divider`` what their ends
    show.
    """
    own = evidence.length[style, Role.DIVIDER]
    if evidence.only_divides[style]:
        reasons = [Message("classification.as-its-style")]
        if evidence.by_width[style]:
            reasons.append(Message("classification.own-width"))
        # With folds in two styles, either style may be perforated or half cut.
        two_styles = evidence.other_folds[style] > _OTHER_FOLDS * own
        if evidence.main_folds[style]:
            reasons.append(Message("classification.panels-hang"))
            return LineType.CREASE, 0.75 if two_styles else 0.9, reasons
        linetype = evidence.styles.linetype[style].casefold()
        dashed = is_dashed_linetype(linetype) or evidence.dashed[style] > 0.5
        if dashed:
            reasons.append(Message("classification.dashed"))
        if evidence.paired[style] > 0.1:
            reasons.append(Message("classification.paired"))
        if not two_styles:
            reasons.append(Message("classification.only-fold-style"))
            return LineType.CREASE, 0.85, reasons
        likely = dashed and evidence.other_folds[style] <= _MAIN_FOLDS * own
        return LineType.CREASE, 0.75 if likely else 0.7, reasons
    # A perforation from fold to fold has the shape of a fold.
    if must_fold and not evidence.other_folds[style]:
        return LineType.CREASE, 0.85, [Message("classification.panel-hangs")]
    return _OPEN_DIVIDERS[divider]
