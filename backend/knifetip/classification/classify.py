"""classify: decide the line type of each edge of a drawing, with the reason.

The package ``decision`` combines the rules of the profile, the shape of the drawing, the words in
layer names, and the colour conventions of other companies.  An edge whose line type is not certain
remains unclassified, and the module ``questions`` makes a question of it.  No edge is cut by
default.  ``apply_overrides`` replaces the decisions by the line types that the user gives.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from knifetip.classification.decision.by_evidence import decide_by_evidence
from knifetip.classification.decision.by_rule import decide_by_rule
from knifetip.classification.decision.connectivity import find_separating_cuts
from knifetip.classification.decision.conventions import FOLD_TYPES, find_fitting_conventions
from knifetip.classification.decision.decision import Decision
from knifetip.classification.decision.open_corners import find_open_corner_folds
from knifetip.classification.decision.outline_parts import PART_OF_OUTLINE, find_outline_parts
from knifetip.classification.decision.profile_rules import (
    LAYER,
    RuleMatches,
    StyleTable,
    display_name,
    match_rules,
    tabulate_styles,
)
from knifetip.classification.decision.style_evidence import StyleEvidence, divide_by_line_width
from knifetip.classification.decision.style_totals import (
    BESIDE_GAP,
    DIVIDER_KINDS,
    FLAG_COUNT,
    MIXED_ROLES,
    MUST_FOLD,
    NEAR_TEXT,
    StyleTotals,
    lengths_without_covered,
)
from knifetip.classification.decision.symmetry import find_asymmetric_edges
from knifetip.classification.shape.features import ShapeFeatures, extract_shape_features
from knifetip.classification.shape.line_runs import join_runs
from knifetip.classification.shape.open_dividers import DividerKind
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.parallel import parallel_pair
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.profile import LineRules
from knifetip.vocabulary import name_meaning


def classify(drawing: Drawing, rules: LineRules, conventions: Sequence[LineRules] = ()) -> Dieline:
    """Return the dieline of a drawing: all edges with their line types and reasons.

    A line type is what a tool does along an edge, such as cut or crease.

    Parameters
    ----------
    drawing
        A drawing of n edges.
    rules
        The customer's profile: rules that give line types to styles.  A style is a combination of
        layer, colour and dash pattern, and its line width where this distinguishes edges.
    conventions
        Colour conventions of other companies, tried for styles without a rule in the profile.

    Returns
    -------
    Dieline
        The n edges in the order of the drawing.  Its field ``rules`` contains the reasons; the
        reason for a rule of the profile names only the patterns that matched, such as ``profile
        default: layer "FOLDS"``.  The confidence is 1 for a rule on layer and colour, 0.95 for a
        rule on a layer, and 0.8 for a rule on a colour or a dash pattern.  Without a rule it is the
        confidence of the evidence, or 0 if there is no evidence.  An edge that needs a question is
        unclassified.  The field ``alternatives`` lists the possible line types for each reason, the
        best guess first, and the confidence of an unclassified edge is that of its best guess.
    """
    lengths, styles = parallel_pair(
        lambda: drawing.lengths,
        lambda: divide_by_line_width(tabulate_styles(drawing), drawing.line_width),
    )
    matches = match_rules(styles, rules)
    features = _relevant_features(drawing, styles, matches)
    own_lengths = lengths_without_covered(styles.row, features, lengths)
    totals = StyleTotals.sum(styles.row, len(styles), features, own_lengths)
    fitting = find_fitting_conventions(styles, matches.rule < 0, totals, conventions)
    evidence = StyleEvidence.create(styles, rules, matches, totals, fitting)
    edges = _decide_edges(evidence, totals.decision_keys(styles.row, features))
    _restore_folds_on_cuts(edges, evidence, features)
    _restore_outline_parts(edges, evidence, features, lengths)
    _withdraw_contradicted(edges, drawing.ends, features, lengths)
    _withdraw_open_corner_folds(edges, evidence, features)
    return Dieline(
        drawing.ends,
        drawing.bulge,
        edges.line_type,
        np.arange(len(drawing), dtype=np.int32),
        edges.reason,
        edges.confidence,
        tuple(edges.reasons.messages),
        tuple(edges.reasons.alternatives),
        features.sides,
        features.part,
        drawing.fit_error,
    )


#: Greatest confidence that an edge is folded, and cut, if a line seems to be missing beside it.
_BESIDE_GAP: Final = 0.78
_BESIDE_GAP_CUT: Final = 0.6


class _Reasons:
    """The distinct reasons for decisions about line types, each with alternative line types."""

    def __init__(self) -> None:
        self.messages: list[Message] = []
        self.alternatives: list[tuple[LineType, ...]] = []
        self._index: dict[tuple[Message, tuple[LineType, ...]], int] = {}

    def row_of(self, message: Message, alternatives: tuple[LineType, ...]) -> int:
        """Return the index of a reason with the given message and alternative line types.

        The reason is added if it does not exist yet.
        """
        index = self._index.setdefault((message, alternatives), len(self.messages))
        if index == len(self.messages):
            self.messages.append(message)
            self.alternatives.append(alternatives)
        return index


@dataclass(frozen=True, eq=False, slots=True)
class _EdgeDecisions:
    """The decision about the line type of each of n edges, in one array per property.

    Later steps of the classification overwrite entries of the arrays.
    """

    line_type: U8  #: (n,) UNCLASSIFIED where the user must decide
    guess: U8  #: (n,) LineType of the best guess
    confidence: F64  #: (n,) confidence of the best guess, 0 … 1
    reason: I32  #: (n,) index into ``reasons``
    reasons: _Reasons


def _decide_edges(evidence: StyleEvidence, keys: I64) -> _EdgeDecisions:
    """Return the decisions about n edges.

    ``keys`` (n,) are the decision keys of the edges.  A decision key is an integer that combines
    the style of an edge, its role, and flags such as whether a text is near it; edges with equal
    keys get the same decision.  ``evidence`` is the evidence about all styles.
    """
    first, row = unique_rows(keys)
    decisions = [_decide(evidence, key) for key in keys[first].tolist()]
    kinds = np.array([decision.kind for decision in decisions], np.uint8)
    undecided = np.array([decision.needs_answer for decision in decisions], np.bool_)
    confidence = np.array([decision.confidence for decision in decisions])
    reasons = _Reasons()
    index = np.zeros(len(first), np.int32)
    for number, decision in enumerate(decisions):
        others = decision.others
        if decision.needs_answer and decision.kind != LineType.UNCLASSIFIED:
            others = (decision.kind, *others)
        index[number] = reasons.row_of(decision.reason, others)
    decided = np.where(undecided, LineType.UNCLASSIFIED, kinds).astype(np.uint8)
    return _EdgeDecisions(decided[row], kinds[row], confidence[row], index[row], reasons)


def _decide(evidence: StyleEvidence, key: int) -> Decision:
    """Return the decision for all edges with the decision key ``key``.

    A decision key is an integer from ``StyleTotals.decision_keys`` that combines the style of an
    edge, its role, and flags such as whether a text is near it.  ``evidence`` is the evidence
    about all styles.
    """
    style_roles_and_kind, flags = divmod(key, FLAG_COUNT)
    style_and_roles, kind = divmod(style_roles_and_kind, DIVIDER_KINDS)
    style_and_role, second = divmod(style_and_roles, len(Role))
    style, role = divmod(style_and_role, len(Role))
    if evidence.matches.rule[style] >= 0:
        decision = decide_by_rule(evidence, style, Role(role))
        mixed = bool(flags & MIXED_ROLES) and decision.kind == LineType.CREASE
        if evidence.swapped and mixed and decision.needs_answer:
            # A half-cut at the end of a fold may be drawn as a cut.
            text = Message("classification.mixed", reason=decision.reason)
            decision = replace(decision, confidence=min(decision.confidence, 0.6), reason=text)
        return decision
    must_fold, divider = bool(flags & MUST_FOLD), DividerKind(kind)
    decision = decide_by_evidence(evidence, style, Role(role), must_fold, divider)
    if flags & BESIDE_GAP and not evidence.only_divides[style]:
        text = Message("classification.beside-gap", reason=decision.reason)
        limit = _BESIDE_GAP if decision.kind == LineType.CREASE else _BESIDE_GAP_CUT
        decision = replace(decision, confidence=min(decision.confidence, limit), reason=text)
    # A text in or beside a closed shape may name a part.
    if flags & NEAR_TEXT and decision.kind == LineType.IGNORED and role != Role.LABELLED:
        text = Message("classification.with-text", reason=decision.reason)
        confidence = 1.0 - 0.4 * (1.0 - decision.confidence)
        decision = replace(decision, confidence=confidence, reason=text)
    if flags & MIXED_ROLES:
        rest = decide_by_evidence(evidence, style, Role(second), False)
        if rest.kind == decision.kind and not rest.needs_answer:
            return replace(decision, confidence=min(decision.confidence, rest.confidence))
        if rest.kind == decision.kind and decision.needs_answer:
            return decision
        text = Message("classification.mixed", reason=decision.reason)
        decision = replace(decision, confidence=min(decision.confidence, 0.7), reason=text)
    return decision


def _restore_folds_on_cuts(
    edges: _EdgeDecisions, evidence: StyleEvidence, features: ShapeFeatures
) -> None:
    """Give unclassified edges on a cut the fold type of their style.

    An edge is changed only if it is unclassified so far and coincides with a cut.  Its line type is
    the fold type that a profile rule states for it, or that all other edges of its style between
    panels have.  The user is not asked about such an edge, because cleaning merges it with the cut.
    Writes line types, confidences and reasons to ``edges``.  ``features`` are the shape features of
    the edges.
    """
    styles, matches = evidence.styles, evidence.matches
    on_edge = features.coincident
    rows = np.flatnonzero((edges.line_type == LineType.UNCLASSIFIED) & (on_edge >= 0))
    rows = rows[edges.line_type[on_edge[rows]] == LineType.CUT]
    ruled = (matches.rule >= 0)[styles.row[rows]]
    for row in rows[ruled & np.isin(edges.guess[rows], FOLD_TYPES)].tolist():
        style = styles.row[row]
        name, conditions = evidence.profile.name, matches.conditions[style]
        rule = Message("classification.rule", profile=name, rule=conditions)
        message = Message("classification.on-cut", rule=rule)
        edges.line_type[row] = edges.guess[row]
        edges.confidence[row] = matches.confidence[style]
        edges.reason[row] = edges.reasons.row_of(message, ())
    rows = rows[~ruled & (features.role[rows] == Role.OUTLINE)]
    for style in np.unique(styles.row[rows]).tolist() if evidence.swapped is None else ():
        folds = np.flatnonzero((styles.row == style) & (features.role == Role.DIVIDER))
        kinds = np.unique(edges.line_type[folds])
        if len(kinds) != 1 or kinds[0] not in FOLD_TYPES:
            continue
        own = rows[styles.row[rows] == style]
        votes = [Message("classification.as-its-style")]
        message = Message(
            "classification.on-cut", rule=Message("classification.shape", parts=votes)
        )
        edges.line_type[own] = kinds[0]
        edges.confidence[own] = edges.confidence[folds].min()
        edges.reason[own] = edges.reasons.row_of(message, ())


def _restore_outline_parts(
    edges: _EdgeDecisions, evidence: StyleEvidence, features: ShapeFeatures, lengths: F64
) -> None:
    """Give unclassified edges of a cut outline the other line type that their layers name.

    Writes line types, confidences and reasons to ``edges``.  ``evidence`` is the evidence about
    all styles; ``features`` and ``lengths`` (n,) are shape features and lengths of the n edges.
    """
    parts = find_outline_parts(evidence, features, edges.line_type, lengths)
    for row in np.flatnonzero(parts != LineType.UNCLASSIFIED).tolist():
        kind, style = LineType(int(parts[row])), evidence.styles.row[row]
        layer = display_name(evidence.styles.layer[style])
        message = Message("classification.part-of-outline", layer=layer, type=kind.word)
        edges.line_type[row], edges.confidence[row] = kind, PART_OF_OUTLINE
        edges.reason[row] = edges.reasons.row_of(message, ())


def _withdraw_contradicted(
    edges: _EdgeDecisions, ends: F64, features: ShapeFeatures, lengths: F64
) -> None:
    """Make edges unclassified if the shape of their blank contradicts their line types.

    This happens in two cases: an edge is cut while its mirror image is folded, or the reverse; or a
    cut would separate a panel from its blank.  Writes line types, confidences and reasons to
    ``edges``.  ``ends`` (n, 2, 2) and ``lengths`` (n,) are the ends and the lengths of the n edges,
    ``features`` their shape features.
    """
    asymmetric, separating = parallel_pair(
        lambda: find_asymmetric_edges(ends, features, edges.line_type, lengths),
        lambda: find_separating_cuts(features, edges.line_type),
    )
    for row in np.flatnonzero(asymmetric | separating).tolist():
        kind, before = LineType(int(edges.line_type[row])), int(edges.reason[row])
        if separating[row]:
            why, other = Message("classification.cuts-panel-off"), LineType.CREASE
        elif kind == LineType.CUT:
            why, other = Message("classification.mirror-folded"), LineType.CREASE
        else:
            why, other = Message("classification.mirror-cut"), LineType.CUT
        rule = edges.reasons.messages[before]
        message = Message("classification.contradicted", rule=rule, reason=why)
        edges.line_type[row], edges.confidence[row] = LineType.UNCLASSIFIED, 0.5
        edges.reason[row] = edges.reasons.row_of(message, (kind, other))


def _withdraw_open_corner_folds(
    edges: _EdgeDecisions, evidence: StyleEvidence, features: ShapeFeatures
) -> None:
    """Make creases of boxes without glue tabs unclassified if only shape or colour supports them.

    Such boxes are creased, or made of grooved board.  Creases by a profile rule or by the name of a
    layer remain, and so do dashed creases.  If at least half of the creases of a style belong to
    such boxes, all creases of the style become unclassified.

    Writes line types, confidences and reasons to ``edges``.  ``evidence`` is the evidence about
    all styles, and ``features`` are the shape features of the edges.
    """
    creased = edges.line_type == LineType.CREASE
    uncut = edges.line_type != LineType.CUT
    group = evidence.style_groups[evidence.styles.row]
    open_to_doubt = creased & evidence.only_shape_and_colour()[evidence.styles.row]
    for number in np.unique(group[open_to_doubt]).tolist():
        own = open_to_doubt & (group == number)
        without_tabs = find_open_corner_folds(features, own, uncut)
        if 2 * np.count_nonzero(without_tabs) < np.count_nonzero(own):
            continue
        # The other folds of the style have the same line type.
        for row in np.flatnonzero(own).tolist():
            before = edges.reasons.messages[int(edges.reason[row])]
            why = Message("classification.without-tabs")
            message = Message("classification.contradicted", rule=before, reason=why)
            alternatives = (LineType.CREASE, LineType.V_GROOVE)
            edges.line_type[row], edges.confidence[row] = LineType.UNCLASSIFIED, 0.6
            edges.reason[row] = edges.reasons.row_of(message, alternatives)


def _relevant_features(drawing: Drawing, styles: StyleTable, matches: RuleMatches) -> ShapeFeatures:
    """Return the shape features of all edges, computed from edges that may belong to the carton.

    Edges that a profile rule on their layer ignores do not contribute.  Edges whose layer has the
    name of an annotation do not contribute if the outlines are closed without them.  ``styles`` are
    the styles of the drawing, and ``matches`` is the profile rule that matches each of them.
    """
    ignored = (matches.line_type == LineType.IGNORED) & (matches.confidence >= LAYER)
    named = np.array(
        [
            rule < 0 and _is_named_annotation(layer)
            for rule, layer in zip(matches.rule.tolist(), styles.layer, strict=True)
        ],
        np.bool_,
    )
    with_folds = bool((matches.rule < 0).any())
    if named.any() and not (ignored | named).all():
        rest = ~(ignored | named)[styles.row]
        features = _features_of(drawing, styles, rest, with_folds)
        closes = np.isin((Role.OUTLINE, Role.DIVIDER), features.role).all()
        if closes and Role.OPEN not in features.role:
            features.role[named[styles.row]] = Role.NAMED
            features.role_fraction[named[styles.row]] = 1.0
            return features
    return _features_of(drawing, styles, ~ignored[styles.row], with_folds)


def _is_named_annotation(layer: str) -> bool:
    """Return whether a layer's name describes annotations, such as dimensions or notes."""
    meaning = name_meaning(layer)
    return meaning.kind == LineType.IGNORED and not meaning.denied


def _features_of(
    drawing: Drawing, styles: StyleTable, mask: Bool, with_folds: bool
) -> ShapeFeatures:
    """Return the shape features of all n edges, computed only from the edges in ``mask``, (n,).

    Lines that the file contains in many pieces are examined as whole lines.  The role of the edges
    outside the mask is UNKNOWN.  ``styles`` are the styles of the drawing, and ``with_folds`` is
    whether to find the edges that must be folds.
    """
    ends, bulge, style = drawing.ends, drawing.bulge, styles.row
    rows = None if mask.all() else np.flatnonzero(mask)
    if rows is not None:
        ends, bulge, style = ends[rows], bulge[rows], style[rows]
    texts, unit_known = drawing.annotations, bool(drawing.unit)
    runs = join_runs(ends, bulge, np.ascontiguousarray(style, np.int64))
    if runs is None:
        features = extract_shape_features(ends, bulge, texts, unit_known, with_folds)
    else:
        whole = extract_shape_features(runs.ends, runs.bulge, texts, unit_known, with_folds)
        features = whole.of_pieces(runs.row, runs.first)
    return features if rows is None else features.spread(len(drawing), rows, Role.UNKNOWN)


def apply_overrides(dieline: Dieline, line_type: U8) -> Dieline:
    """Return a dieline with the line types that the user gives in place of the decided ones.

    Parameters
    ----------
    dieline
        n edges.
    line_type : (n,) uint8
        Line type that the user gives to each edge, or ``NO_OVERRIDE`` (255) to keep the line type
        of the dieline.

    Raises
    ------
    ValueError
        The length of ``line_type`` is not n, or it contains a number that is no line type.
    """
    user_type = np.asarray(line_type, np.uint8)
    if user_type.shape != (len(dieline),):
        raise ValueError(f"{user_type.shape} overrides for {len(dieline)} edges")
    overridden = user_type != NO_OVERRIDE
    known = np.isin(user_type, [kind.value for kind in LineType])
    if (wrong := overridden & ~known).any():
        raise ValueError(f"{user_type[wrong][0]} is not a line type")
    if not overridden.any():
        return dieline
    override = Message("classification.override")
    rules = dieline.rules if override in dieline.rules else (*dieline.rules, override)
    return replace(
        dieline,
        line_type=np.where(overridden, user_type, dieline.line_type),
        rule=np.where(overridden, rules.index(override), dieline.rule),
        confidence=np.where(overridden, 1.0, dieline.confidence),
        rules=rules,
    )
