"""classify: what is to be done along each edge, and what says so.

    Drawing, LineRules -> Dieline            rules first, then shape, then what they say together
    Dieline, overrides -> Dieline            what somebody said comes last
    Drawing, Dieline   -> list[Question]     what nobody has said yet

The profile's rules, the shape of the net, the words in layers' names and the colour conventions of
other houses are weighed in ``fusion``.  What is not sure stays unclassified and becomes a question;
nothing is cut by default.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from knifetip.classification import rules as matching
from knifetip.classification.apart import parting
from knifetip.classification.conventions import FOLDS, fitting
from knifetip.classification.evidence import Shape, shape
from knifetip.classification.fusion import Judge, Verdict
from knifetip.classification.mirror import contradicted
from knifetip.classification.role import Role
from knifetip.classification.rules import BY_LAYER, Matches, Styles
from knifetip.classification.tally import FLAGS, HOLDS, MIXED, TEXT, Tally
from knifetip.classification.words import CENTRE_LINE, DASHED, hint
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.geometry.cores import both
from knifetip.geometry.distinct import distinct
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, extents
from knifetip.model.profile import LineRules
from knifetip.model.question import Question

#: In a column of overrides: leave this edge as the profile has it.
KEEP = 255


def classify(drawing: Drawing, rules: LineRules, conventions: Sequence[LineRules] = ()) -> Dieline:
    """Return the dieline: every edge of the drawing with its line type, and why.

    Parameters
    ----------
    drawing
        n edges.
    rules
        The customer's profile.
    conventions
        Colours of other houses, to be tried where the profile says nothing.

    Returns
    -------
    Dieline
        n edges, row i that of the drawing.  ``rules`` holds the words of what decided, with only
        the pattern that matched: ``profile default: layer "FOLDS"``.  Confidence is 1 for a rule
        on layer and colour, 0.95 on a layer, 0.8 on colour or linetype, what the evidence is worth
        where no rule speaks, 0 for nothing at all.  An edge that is asked is unclassified; its
        confidence is that of the first of its rule's ``alternatives``, the best guess.
    """
    lengths, styles = both(lambda: drawing.lengths, lambda: matching.styles(drawing))
    matches = matching.match(styles, rules)
    seen = _evidence(drawing, styles, matches)
    tally = Tally.of(styles.of, len(styles), seen, lengths)
    fits = fitting(styles, matches.rule < 0, tally.length, tally.edges, conventions)
    judge = Judge.of(
        styles, rules, matches, tally.length, fits, tally.dashes, tally.pairs, tally.holds
    )
    cell = tally.cells(styles.of, seen)
    first, number = distinct(cell)
    verdicts = [_verdict(judge, key) for key in cell[first].tolist()]
    said = _Said()
    line_type = np.full(len(first), LineType.UNCLASSIFIED, np.uint8)
    word = np.zeros(len(first), np.int32)
    for row, verdict in enumerate(verdicts):
        others = verdict.others
        if verdict.asked and verdict.kind != LineType.UNCLASSIFIED:
            others = (verdict.kind, *others)
        elif not verdict.asked:
            line_type[row] = verdict.kind
        word[row] = said.number(verdict.reason, others)
    kinds, rule = line_type[number], word[number]
    sure = np.array([verdict.sure for verdict in verdicts])[number]
    meant = np.array([verdict.kind for verdict in verdicts], np.uint8)[number]
    hidden = np.flatnonzero((kinds == LineType.UNCLASSIFIED) & (seen.on >= 0))
    hidden = hidden[(matches.rule >= 0)[styles.of[hidden]] & np.isin(meant[hidden], FOLDS)]
    hidden = hidden[kinds[seen.on[hidden]] == LineType.CUT]
    for row in hidden.tolist():
        style = styles.of[row]
        named = Message("classification.rule", profile=rules.name, rule=matches.words[style])
        text = Message("classification.on-cut", rule=named)
        kinds[row], sure[row] = meant[row], matches.confidence[style]
        rule[row] = said.number(text, ())
    against, off = both(
        lambda: contradicted(drawing.ends, seen, kinds, lengths), lambda: parting(seen, kinds)
    )
    for row in np.flatnonzero(against | off).tolist():
        kind, before = LineType(int(kinds[row])), int(rule[row])
        if off[row]:
            why, other = Message("classification.cuts-panel-off"), LineType.CREASE
        elif kind == LineType.CUT:
            why, other = Message("classification.mirror-folded"), LineType.CREASE
        else:
            why, other = Message("classification.mirror-cut"), LineType.CUT
        kinds[row], sure[row] = LineType.UNCLASSIFIED, 0.5
        reason = Message("classification.contradicted", rule=said.texts[before], reason=why)
        rule[row] = said.number(reason, (kind, other))
    return Dieline(
        drawing.ends,
        drawing.bulge,
        kinds,
        np.arange(len(drawing), dtype=np.int32),
        rule,
        sure,
        tuple(said.texts),
        tuple(said.others),
    )


class _Said:
    """What decides edges, in words, each with what else the edge could be once."""

    def __init__(self) -> None:
        self.texts: list[Message] = []
        self.others: list[tuple[LineType, ...]] = []
        self._number: dict[tuple[Message, tuple[LineType, ...]], int] = {}

    def number(self, text: Message, others: tuple[LineType, ...]) -> int:
        """Return the number of a text with its alternatives."""
        number = self._number.setdefault((text, others), len(self.texts))
        if number == len(self.texts):
            self.texts.append(text)
            self.others.append(others)
        return number


def _evidence(drawing: Drawing, styles: Styles, matches: Matches) -> Shape:
    """Return what shape tells of the edges that are not said to be something beside the carton.

    What the profile ignores is left out.  So is what only its name calls a dimension or a note, if
    the outlines close without it.
    """
    aside = (matches.line_type == LineType.IGNORED) & (matches.confidence >= BY_LAYER)
    named = np.array(
        [
            rule < 0 and hint(layer).kind == LineType.IGNORED and not hint(layer).denied
            for rule, layer in zip(matches.rule.tolist(), styles.layer, strict=True)
        ],
        np.bool_,
    )
    folds = bool((matches.rule < 0).any())
    if named.any() and not (aside | named).all():
        rest = ~(aside | named)[styles.of]
        seen = _of(drawing, rest, folds)
        if np.isin((Role.OUTLINE, Role.DIVIDER), seen.role).all() and Role.OPEN not in seen.role:
            seen.role[named[styles.of]] = Role.NAMED
            seen.sure[named[styles.of]] = 1.0
            return seen
    return _of(drawing, ~aside[styles.of], folds)


def _of(drawing: Drawing, some: Bool, folds: bool) -> Shape:
    """Return what shape tells of some edges, and nothing of the rest."""
    rows = np.flatnonzero(some)
    ends, bulge = drawing.ends, drawing.bulge
    if len(rows) == len(drawing):
        return shape(ends, bulge, drawing.inscriptions, bool(drawing.unit), folds)
    seen = shape(ends[rows], bulge[rows], drawing.inscriptions, bool(drawing.unit), folds)
    return seen.among(len(drawing), rows, Role.UNKNOWN)


def _verdict(judge: Judge, cell: int) -> Verdict:
    key, flags = divmod(cell, FLAGS)
    style, role = divmod(key, len(Role))
    verdict = judge.verdict(style, Role(role), holds=bool(flags & HOLDS))
    if judge.matches.rule[style] >= 0:
        return verdict
    if flags & TEXT and verdict.kind == LineType.IGNORED:
        text = Message("classification.with-text", reason=verdict.reason)
        verdict = replace(verdict, sure=1.0 - 0.4 * (1.0 - verdict.sure), reason=text)
    if flags & MIXED:
        text = Message("classification.mixed", reason=verdict.reason)
        verdict = replace(verdict, sure=min(verdict.sure, 0.7), reason=text)
    return verdict


def overridden(dieline: Dieline, line_type: U8) -> Dieline:
    """Return the dieline with the line types that somebody gave, over those of the profile.

    Parameters
    ----------
    dieline
        n edges.
    line_type : (n,) uint8
        LineType, or ``KEEP`` (255) where the profile's answer stands.

    Raises
    ------
    ValueError
        The column has another length, or a number that is no line type.
    """
    given = np.asarray(line_type, np.uint8)
    if given.shape != (len(dieline),):
        raise ValueError(f"{given.shape} overrides for {len(dieline)} edges")
    said = given != KEEP
    known = np.isin(given, [kind.value for kind in LineType])
    if (wrong := said & ~known).any():
        raise ValueError(f"{given[wrong][0]} is not a line type")
    if not said.any():
        return dieline
    given_by_user = Message("classification.override")
    decided = dieline.rules
    if given_by_user not in decided:
        decided = (*decided, given_by_user)
    return replace(
        dieline,
        line_type=np.where(said, given, dieline.line_type),
        rule=np.where(said, decided.index(given_by_user), dieline.rule),
        confidence=np.where(said, 1.0, dieline.confidence),
        rules=decided,
    )


def questions(drawing: Drawing, dieline: Dieline) -> list[Question]:
    """Return one question for each layer, colour, linetype and role that is not decided.

    Parameters
    ----------
    drawing, dieline
        The same n edges.

    Returns
    -------
    list of Question
        In the order in which the drawing first has them.  ``edges`` are its rows; ``choices`` are
        the words of all line types, the most plausible first.
    """
    rows = np.flatnonzero(dieline.line_type == LineType.UNCLASSIFIED)
    if len(rows) == 0:
        return []
    columns = (drawing.layer, drawing.colour, drawing.true_colour, drawing.linetype, dieline.rule)
    first, combination = distinct(*(column[rows] for column in columns))
    count = np.bincount(combination)
    groups = np.split(rows[np.argsort(combination, kind="stable")], np.cumsum(count)[:-1])
    lengths = drawing.lengths
    whole = drawing.bounds
    return [
        _question(drawing, dieline, groups[number], lengths, whole) for number in range(len(first))
    ]


def _question(drawing: Drawing, dieline: Dieline, rows: I64, lengths: F64, whole: F64) -> Question:
    example = rows[0]
    layer = drawing.layers[drawing.layer[example]]
    linetype = drawing.linetypes[drawing.linetype[example]]
    colour = int(drawing.colour[example])
    true_colour = int(drawing.true_colour[example])
    box = extents(drawing.ends[rows], drawing.bulge[rows])
    width, height = box[2:] - box[:2]
    rule = int(dieline.rule[example])
    guesses = dieline.alternatives[rule]
    reason = dieline.rules[rule]
    guess = None
    if guesses:
        percent = round(100.0 * float(dieline.confidence[example]))
        guess = Message("question.guess", type=guesses[0].word, percent=percent, reason=reason)
    elif reason.code == "classification.no-rule-but-shape":
        guess = Message("question.shape", reason=reason.arguments["shape"])
    message = Message(
        "question.line-type",
        edges=len(rows),
        layer=_shown(layer),
        colour=str(colour) if true_colour < 0 else f"#{true_colour:06x}",
        linetype=_shown(linetype),
        length=lengths[rows].sum(),
        width=width,
        height=height,
        x=box[0],
        y=box[1],
        unit="mm" if drawing.unit else "",
        guess=guess,
    )
    reach = box[2:] - box[:2] >= 0.99 * (whole[2:] - whole[:2])
    straight = bool((drawing.bulge[rows] == 0).all())
    likely = dict.fromkeys((*guesses, *_likely(layer, linetype, bool(reach.all()), straight)))
    others = [kind for kind in LineType if kind not in (LineType.UNCLASSIFIED, *likely)]
    choices = tuple(kind.word for kind in (*likely, *others))
    return Question("line-type", message, choices, tuple(rows.tolist()), layer, colour)


def _shown(name: str) -> str:
    """Return a name as it may be printed: a file may hold anything, a terminal obeys some of it."""
    clean = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in name)
    return clean if len(clean) <= 80 else clean[:79] + "…"


def _likely(layer: str, linetype: str, reaches: bool, straight: bool) -> Sequence[LineType]:
    """Return plausible answers, best first, without repeats, where shape gives none.

    A name says more than a line style, and that more than the place: what spans the whole drawing
    is its outline, straight lines inside it are folds, arcs inside it are holes.
    """
    style = matching.folded(linetype)
    named = hint(layer).kind
    guesses = [] if named is None else [named]
    if any(part in style for part in CENTRE_LINE):
        guesses.append(LineType.IGNORED)
    elif any(part in style for part in DASHED):
        guesses.append(LineType.CREASE)
    guesses.append(LineType.CREASE if straight and not reaches else LineType.CUT)
    return tuple(dict.fromkeys(guesses))
