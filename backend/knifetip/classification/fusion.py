"""fusion: what each edge is, from what the profile, its shape, its name and its colour say of it.

    Styles, Matches, Shape, Fits -> Verdicts

Edges of one style in one role share a verdict.  The profile's rule stands unless shape contradicts
it: a crease cannot close the outline of a blank.  Where no rule speaks, two witnesses must agree,
or shape must be beyond doubt, before anything is decided.  What is less sure than ``SURE`` is
asked, with the best guess first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.classification.conventions import FOLDS, Fit
from knifetip.classification.role import ASIDE, HOLES, Role
from knifetip.classification.rules import Matches, Styles
from knifetip.classification.words import DASHED, hint
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules

#: Less sure than this is asked.
SURE = 0.8

#: Line types that divide panels.
_DIVIDING = (*FOLDS, LineType.HALF_CUT)
#: Of these it is so certain that no rule stands against it.
_CERTAINLY = (Role.ARROW, Role.LEGEND)
#: A style with more than this share of all dividing lines has the creases, where panels hang on
#: more than this share of them.
_MAIN, _HANG = 0.6, 0.5
#: Of these a closed line in a panel makes sense.
_ROUND = (LineType.PERFORATION, LineType.COMBI, LineType.HALF_CUT)
#: What certainly is no part of a carton is ignored with this confidence.
_SURELY: dict[Role, float] = {
    Role.FRAME: 0.85,
    Role.ARROW: 0.95,
    Role.BLEED: 0.9,
    Role.LETTER: 0.85,
    Role.SPECK: 0.85,
    Role.NAMED: 0.9,
    Role.LEGEND: 0.95,
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """What edges of one style in one role are."""

    kind: LineType  #: the best guess
    sure: float  #: 0 … 1
    reason: Message  #: the rule, or the evidence
    others: tuple[LineType, ...] = ()  #: what else it could be
    stands: bool = False  #: a rule says so, and nothing contradicts it

    @property
    def asked(self) -> bool:
        """Whether somebody must say."""
        unsure = self.sure < SURE and not self.stands
        return unsure or self.kind == LineType.UNCLASSIFIED


@dataclass(frozen=True, eq=False, slots=True)
class Judge:
    """What a verdict goes by: all of it about the c styles of one drawing."""

    styles: Styles
    profile: LineRules
    matches: Matches
    fits: Sequence[Fit]
    length: F64  #: (c, roles) of all edges that share layer, colour and linetype with the style
    total: F64  #: (roles,)
    folding: F64  #: (c,) how long the dividing lines are of styles with nothing but such lines
    folds_only: Bool  #: (c,) it divides panels and closes next to nothing
    dashes: F64  #: (c,) share of the length of its dividing lines that is in rows of dashes
    pairs: F64  #: (c,) share that has a parallel line close beside it
    folding_main: Bool  #: (c,) it has most of all dividing lines, and panels hang on most of them
    shaped: bool  #: there are blanks whose outline closes
    swapped: Message | None  #: why cut and crease seem to have changed places, None where not

    @classmethod
    def of(
        cls,
        styles: Styles,
        profile: LineRules,
        matches: Matches,
        length: F64,
        fits: Sequence[Fit],
        dashes: F64,
        pairs: F64,
        holds: F64,
    ) -> Judge:
        """Weigh the whole drawing before its edges.

        Parameters
        ----------
        length : (c, roles)
            Of each style alone.
        dashes, pairs, holds : (c,)
            Length of its dividing lines in rows of dashes, of those with a line beside them, and of
            those on which a panel hangs.
        """
        alike = _grouped(styles)
        together = np.zeros((int(alike.max(initial=-1)) + 1, length.shape[1]))
        np.add.at(together, alike, length)
        made = together.sum(axis=1) - together[:, list(ASIDE)].sum(axis=1)
        closing = together[:, [Role.OUTLINE, *HOLES, Role.MARK]].sum(axis=1)
        folds = (together[:, Role.DIVIDER] >= 0.85 * made) & (closing <= 0.02 * made) & (made > 0.0)
        divides = np.where(folds, together[:, Role.DIVIDER], 0.0)
        return cls(
            styles,
            profile,
            matches,
            fits,
            together[alike],
            length.sum(axis=0),
            (divides.sum() - divides)[alike],
            folds[alike],
            _share(dashes, alike, together),
            _share(pairs, alike, together),
            (_share(holds, alike, together) > _HANG)
            & (together[:, Role.DIVIDER] > _MAIN * length[:, Role.DIVIDER].sum())[alike],
            bool(length[:, Role.OUTLINE].any()),
            _swapped(matches, length, fits),
        )

    def verdict(self, style: int, role: Role, *, holds: bool = False) -> Verdict:
        """Return what edges of a style in a role are.

        Parameters
        ----------
        holds
            Whether a panel hangs on them, so that they must be folds.
        """
        if self.matches.rule[style] >= 0:
            return self._ruled(style, role)
        return self._unruled(style, role, holds)

    # ── a rule of the profile speaks ─────────────────────────────────────────────────────────────

    def _ruled(self, style: int, role: Role) -> Verdict:
        kind = LineType(int(self.matches.line_type[style]))
        trust = float(self.matches.confidence[style])
        rule = Message(
            "classification.rule", profile=self.profile.name, rule=self.matches.words[style]
        )
        if kind == LineType.UNCLASSIFIED:
            return Verdict(kind, 0.0, rule)
        if self.swapped and kind != LineType.IGNORED:
            swapped = Message("classification.contradicted", rule=rule, reason=self.swapped)
            if role in (Role.OUTLINE, *HOLES, Role.DIVIDER):
                guess = self._by_shape(role)
                others = tuple(one for one in (kind,) if one != guess)
                return Verdict(guess, 0.6, swapped, others)
            return Verdict(kind, 0.3, swapped)
        if not self.shaped or role in (Role.UNKNOWN, Role.OPEN):
            return Verdict(kind, trust, rule, stands=True)
        if role in _CERTAINLY and kind != LineType.IGNORED:
            others = (kind,)
            reason = _contradicted(rule, role, None)
            return Verdict(LineType.IGNORED, _SURELY[role], reason, others)
        against, instead = self._contradiction(kind, trust, style, role)
        if against:
            sure = min(trust, 0.5)
            return Verdict(kind, sure, _contradicted(rule, role, against), instead)
        return Verdict(kind, trust, rule, stands=True)

    def _contradiction(
        self, kind: LineType, trust: float, style: int, role: Role
    ) -> tuple[Message | None, tuple[LineType, ...]]:
        """Return how shape contradicts a rule, None if it does not, and what else it could be."""
        weak = trust < 0.9
        if kind == LineType.IGNORED:
            if role in (Role.OUTLINE, Role.DIVIDER):
                return Message("classification.not-made"), (self._by_shape(role), LineType.CUT)
            return None, ()
        if role in (Role.STRAY, Role.SPECK):
            return Message("classification.closes-nothing"), (LineType.IGNORED,)
        if role in ASIDE:
            return Message("classification.not-made"), (LineType.IGNORED,)
        if kind == LineType.CUT:
            if role == Role.DIVIDER and weak and self.folds_only[style]:
                return Message("classification.none-closes"), (LineType.CREASE,)
            return None, ()
        if role == Role.OUTLINE or (role == Role.MARK and weak):
            return Message("classification.board-ends"), (LineType.CUT,)
        if role in (*HOLES, Role.INNER) and kind not in _ROUND:
            return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
        if role in (Role.FREE, Role.SLIT) and weak and kind == LineType.CREASE:
            return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
        return None, ()

    # ── no rule does ─────────────────────────────────────────────────────────────────────────────

    def _unruled(self, style: int, role: Role, holds: bool) -> Verdict:
        told = hint(self.styles.layer[style])
        named = None if told.denied else told.kind
        place = "layer"
        if told.kind is None and not told.denied:
            told, place = hint(self.styles.linetype[style]), "linetype"
            named = None if told.denied else told.kind
        none = Message("classification.no-rule", profile=self.profile.name)
        if role == Role.OPEN:
            shape = Message(
                "classification.no-rule-but-shape",
                profile=self.profile.name,
                shape=Message("classification.shape", parts=[role.message]),
            )
            return Verdict(LineType.UNCLASSIFIED, 0.0, shape)
        if not self.shaped or role == Role.UNKNOWN:
            return Verdict(LineType.UNCLASSIFIED, 0.0, none)
        guess, sure, details = self._shape_says(style, role, holds)
        votes = [Message("classification.shape", parts=[role.message, *details])]
        others = [self._by_shape(role)]
        # What the house's colours say of this style, where all that fit agree.
        said = {LineType(int(fit.line_type[style])) for fit in self.fits}
        said.discard(LineType.UNCLASSIFIED)
        if role in _SURELY:
            # Whatever its colour means on a carton.
            said = set()
        if len(said) == 1:
            (colour,) = said
            fit = next(fit for fit in self.fits if fit.line_type[style] == colour)
            if colour == guess:
                # Solid is a cut in most houses: of a hole in a style of its own that says little.
                plain = colour in (LineType.CUT, LineType.CREASE)
                worth = 0.4 if plain and role in (Role.OUTLINE, Role.DIVIDER) else 0.8
                sure = 1.0 - (1.0 - sure) * worth
                votes.append(fit.message)
            elif role == Role.DIVIDER and guess == LineType.CREASE and colour in _DIVIDING:
                guess, sure = colour, 0.65
                votes.append(fit.message)
            elif role in ASIDE:
                sure *= 0.9
            else:
                sure = min(sure, 0.6)
                others.append(colour)
        elif said:
            sure = min(sure, 0.75)
            others.extend(sorted(said))
        if told.denied and place == "layer":
            sure = min(sure, 0.7)
            layer = _shown(self.styles.layer[style])
            votes.append(Message("classification.layer-denies", layer=layer))
        elif named is not None:
            alike = named == guess
            fold = role in (Role.DIVIDER, Role.SLIT, Role.FREE, *HOLES) and named in _DIVIDING
            if alike:
                sure = 1.0 - (1.0 - sure) * 0.25
            elif role == Role.DIVIDER and named in _DIVIDING:
                guess, sure = named, 0.9
            elif fold or (
                named == LineType.IGNORED and role in (Role.FREE, Role.SLIT, Role.MARK, *HOLES)
            ):
                guess, sure = named, 0.7
            else:
                sure = min(sure, 0.5)
                others.append(named)
            if place == "layer":
                votes.append(Message("classification.layer-name", word=told.word))
            else:
                votes.append(Message("classification.linetype-name", word=told.word))
        others = [kind for kind in dict.fromkeys(others) if kind != guess]
        for kind in _COULD[role]:
            if kind != guess and kind not in others:
                others.append(kind)
        reason = Message("classification.votes", votes=votes)
        return Verdict(guess, sure, reason, tuple(others[:3]))

    def _shape_says(
        self, style: int, role: Role, holds: bool
    ) -> tuple[LineType, float, Sequence[Message]]:
        """Return what shape alone makes of edges, how sure that is, and what it goes by."""
        own = self.length[style]
        every = self.total
        carries = own[Role.OUTLINE] >= 0.3 * every[Role.OUTLINE]
        # Another style that only divides panels: then this one does not.
        apart = carries and self.folding[style] > 1.4 * own[Role.DIVIDER]
        aside = sum(own[part] for part in ASIDE) >= 0.95 * own.sum()
        if role == Role.OUTLINE:
            # Where another style closes most of the outline, one that divides panels does not.
            little = own[Role.OUTLINE] < 0.5 * every[Role.OUTLINE]
            if little and own[Role.DIVIDER] > 0.25 * own[Role.OUTLINE]:
                return LineType.CUT, 0.5, [Message("classification.other-style-closes")]
            return LineType.CUT, 0.95, ()
        if role in HOLES:
            if carries and self.folding[style]:
                return LineType.CUT, 0.9, _LIKE_OUTLINE
            if carries and role == Role.SLOT:
                return LineType.CUT, 0.85, _LIKE_OUTLINE
            return LineType.CUT, 0.75 if carries else 0.6, ()
        if role == Role.DIVIDER:
            if apart:
                return LineType.CUT, 0.85, [Message("classification.like-outline-not-folds")]
            if self.folds_only[style]:
                why = [Message("classification.as-its-style")]
                if self.folding_main[style]:
                    return LineType.CREASE, 0.9, [*why, Message("classification.panels-hang")]
                linetype = self.styles.linetype[style].casefold()
                dashed = any(part in linetype for part in DASHED) or self.dashes[style] > 0.5
                if dashed:
                    why.append(Message("classification.dashed"))
                if self.pairs[style] > 0.1:
                    why.append(Message("classification.paired"))
                return LineType.CREASE, 0.75 if dashed else 0.7, why
            if holds and not (carries and self.folding[style]):
                return LineType.CREASE, 0.85, [Message("classification.panel-hangs")]
            return LineType.CREASE, 0.55, ()
        if role in (Role.SLIT, Role.FREE):
            if apart:
                return LineType.CUT, 0.85, _LIKE_OUTLINE
            if self.folds_only[style]:
                return LineType.CREASE, 0.6, ()
            return LineType.CUT, 0.6 if carries else 0.4, ()
        if role in ASIDE:
            if role == Role.TABLE:
                return LineType.IGNORED, 0.85 if aside else 0.6, ()
            return LineType.IGNORED, _SURELY.get(role, 0.65 if aside else 0.5), ()
        return LineType.CUT, 0.6 if carries else 0.4, ()

    @staticmethod
    def _by_shape(role: Role) -> LineType:
        return _COULD[role][0]


_LIKE_OUTLINE = (Message("classification.like-outline"),)
_CUT_FIRST = (LineType.CUT, LineType.IGNORED, LineType.CREASE)
_COULD: dict[Role, tuple[LineType, ...]] = {
    **dict.fromkeys(Role, _CUT_FIRST),
    Role.DIVIDER: (LineType.CREASE, LineType.CUT, LineType.PERFORATION, LineType.V_GROOVE),
    Role.SLIT: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    Role.FREE: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    **dict.fromkeys(HOLES, (LineType.CUT, LineType.HALF_CUT, LineType.IGNORED)),
    **dict.fromkeys(ASIDE, (LineType.IGNORED, LineType.CUT)),
}


def _share(part: F64, alike: I64, together: F64) -> F64:
    """Return what share of the dividing lines of like styles a part of them is, (c,)."""
    whole = np.maximum(together[:, Role.DIVIDER], 1e-12)
    share: F64 = (np.bincount(alike, part, len(together)) / whole)[alike]
    return share


def _grouped(styles: Styles) -> I64:
    """Return which styles share layer, colour and linetype, (c,)."""
    key: dict[tuple[str, int, int, str], int] = {}
    return np.array(
        [
            key.setdefault(one, len(key))
            for one in zip(
                styles.layer,
                styles.colour.tolist(),
                styles.true_colour.tolist(),
                styles.linetype,
                strict=True,
            )
        ],
        np.int64,
    )


def _swapped(matches: Matches, length: F64, fits: Sequence[Fit]) -> Message | None:
    """Return why cut and crease seem to have changed places, None where they do not."""
    folds = np.isin(matches.line_type, (LineType.CREASE, LineType.V_GROOVE, LineType.COMBI))
    cuts = matches.line_type == LineType.CUT
    outline, divider = length[:, Role.OUTLINE], length[:, Role.DIVIDER]
    whole = outline.sum()
    if not whole or outline[folds].sum() < 0.5 * whole or outline[cuts].sum() > 0.2 * whole:
        return None
    both = divider[cuts].sum() > 0.0
    reason = Message("classification.swapped-both" if both else "classification.swapped")
    if not fits:
        return reason
    return Message("classification.swapped-like", reason=reason, convention=fits[0].message)


def _contradicted(rule: Message, role: Role, against: Message | None) -> Message:
    reason = Message("classification.role-against", role=role.message, against=against)
    return Message("classification.contradicted", rule=rule, reason=reason)


def _shown(name: str) -> str:
    clean = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in name)
    return clean if len(clean) <= 80 else clean[:79] + "…"
