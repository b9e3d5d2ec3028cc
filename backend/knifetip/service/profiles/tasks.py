"""Tasks that preview the effect of a profile on a drawing, and that propose rules.

Rules are proposed from the line types that the user has set by hand.
"""

from __future__ import annotations

import glob
from typing import Any

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.library import custom_profiles
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.stage import Progress, Stage
from knifetip.service.processes.readings import read_drawing

#: Greatest number of proposed rules; each is applied to the whole drawing.
_MAX_PROPOSALS = 12


def preview(
    progress: Progress, content: bytes, interpretation: Interpretation, text: str
) -> dict[str, Any]:
    """Return the effect that another classification profile would have on a drawing.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    content
        File of the drawing.
    interpretation
        Present interpretation of the drawing, with its profile and overrides (line types that the
        user has set).
    text
        TOML text of the other profile.

    Returns
    -------
    dict
        The entry ``rules`` is a list with one dict for each rule of the other profile: the JSON
        data of the rule, ``inherited`` (whether the rule comes from a profile that the other
        profile extends), ``edges`` (number of edges that the rule matches) and ``length`` (total
        length of these edges, mm).

        The entry ``open`` is the number of edges that no rule matches.

        The entry ``changes`` lists the edges that would get another line type, with one dict for
        each pair of line types: ``before`` and ``after`` (names of the line types) and ``edges``
        (rows of the edges).
    """
    from knifetip import pipeline
    from knifetip.classification.decision.profile_rules import matching_rules

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit, interpretation.edits)
    progress(Stage.CLASSIFY, 0.6)
    other = custom_profiles.parse_text("preview", text)
    before = pipeline.interpret(drawing, interpretation)
    after = pipeline.apply_answers(drawing, pipeline.classify(drawing, other), interpretation)
    rule_of_edge = matching_rules(drawing, other)
    lengths = drawing.lengths
    decided = rule_of_edge >= 0
    edges = np.bincount(rule_of_edge[decided], minlength=len(other.rules))
    length = np.bincount(
        rule_of_edge[decided], weights=lengths[decided], minlength=len(other.rules)
    )
    inherited = custom_profiles.inherited_rules(custom_profiles.parse_fields(text), other)
    return {
        "rules": [
            {
                **rule_json(rule),
                "inherited": inherited[number],
                "edges": int(edges[number]),
                "length": float(length[number]),
            }
            for number, rule in enumerate(other.rules)
        ],
        "open": int((~decided).sum()),
        "changes": _changes(before.line_type, after.line_type),
    }


def learn(
    progress: Progress, content: bytes, interpretation: Interpretation
) -> list[dict[str, Any]]:
    """Return proposed rules that give edges the line types which the user has set by hand.

    A proposed rule should match no edge with a different line type.  Edges for which there is no
    such rule get rules by layer and colour.  A rule may also change edges whose line type the user
    did not set.  The result lists these edges: if the user set ten red edges of a layer to crease,
    an eleventh red edge may have been overlooked.  A rule that changes as many decided edges as it
    explains is not proposed, nor one that changes more edges than it explains, decided or not.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    content
        File of the drawing.
    interpretation
        Interpretation of the drawing; its overrides are the line types that the user has set.

    Returns
    -------
    list of dict
        One dict for each proposed rule.  ``rule`` is the rule as JSON data.  ``explains`` lists the
        rows of the edges to which the rule gives the line type that the user has set.  ``changes``
        lists the other edges that the rule would change, with one dict for each pair of line types:
        ``before`` and ``after`` (names of the line types) and ``edges`` (rows of the edges).
        ``sure`` is True if the rule changes only edges that have no line type yet; these rules come
        first.
    """
    from knifetip import pipeline
    from knifetip.classification.decision.profile_rules import matching_rules
    from knifetip.classification.rule_proposals import propose_rules

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit, interpretation.edits)
    profile = pipeline.rules_of(interpretation)
    overrides = np.frombuffer(interpretation.overrides, np.uint8)
    progress(Stage.CLASSIFY, 0.6)
    before = pipeline.interpret(drawing, interpretation)
    without_overrides = pipeline.classify(drawing, profile)
    # A rule by linetype alone is too general: it would match half of any other drawing.
    proposals = [
        one
        for one in propose_rules(drawing, without_overrides, overrides, profile)
        if one.rule.layer or one.rule.block or one.rule.colour or one.rule.true_colour
    ]
    explained = {row for one in proposals for row in one.explains}
    unexplained = np.flatnonzero(
        (overrides != NO_OVERRIDE) & (without_overrides.line_type != overrides)
    )
    attribute_rules = _by_attributes(
        drawing, overrides, [row for row in unexplained.tolist() if row not in explained]
    )
    proposed = []
    for rule in [*(one.rule for one in proposals), *attribute_rules][:_MAX_PROPOSALS]:
        longer = LineRules(profile.name, profile.title, (rule, *profile.rules))
        after = pipeline.apply_answers(drawing, pipeline.classify(drawing, longer), interpretation)
        matched = matching_rules(drawing, LineRules("", "", (rule,))) == 0
        changes = _changes(before.line_type, after.line_type)
        explains = np.flatnonzero(matched & (overrides == rule.line_type)).tolist()
        settled = [one for one in changes if one["before"] != "unclassified"]
        if sum(len(one["edges"]) for one in settled) >= len(explains):
            continue
        if sum(len(one["edges"]) for one in changes) > len(explains):
            continue
        proposed.append(
            {
                "rule": rule_json(rule),
                "explains": explains,
                "sure": not settled,
                "changes": changes,
            }
        )
    return sorted(proposed, key=lambda one: not one["sure"])


def _by_attributes(drawing: Drawing, overrides: U8, rows: list[int]) -> list[LineRule]:
    """Return rules that give edges with the same layer and colour the line type set by the user.

    There is one rule for each pair of layer and colour, if the user gave all considered edges of
    the pair the same line type.

    ``drawing``: the drawing with n edges.
    ``overrides`` (n,): for each edge the line type that the user has set, or ``NO_OVERRIDE``.
    ``rows``: rows of the edges to consider; the user has set a line type for each of them.
    """
    line_types: dict[tuple[str, int, int], set[int]] = {}
    for row in rows:
        key = (
            drawing.layers[drawing.layer[row]],
            int(drawing.colour[row]),
            int(drawing.true_colour[row]),
        )
        line_types.setdefault(key, set()).add(int(overrides[row]))
    return [
        LineRule(
            LineType(kinds.pop()),
            layer=(glob.escape(layer),),
            colour=(index,) if true < 0 else (),
            true_colour=(true,) if true >= 0 else (),
        )
        for (layer, index, true), kinds in line_types.items()
        if len(kinds) == 1 and 0 not in kinds
    ]


def rule_json(rule: LineRule) -> dict[str, Any]:
    """Return the line type and the conditions of a rule as JSON data.

    ``type`` is the name of the line type.  ``layer``, ``colour``, ``linetype`` (dash pattern in the
    drawing file), ``entity`` and ``block`` list the values that the rule requires.  ``conditions``
    is a message that describes these requirements.
    """
    colours: list[int | str] = [*rule.colour, *(f"#{colour:06x}" for colour in rule.true_colour)]
    return {
        "type": rule.line_type.word,
        "layer": list(rule.layer),
        "colour": colours,
        "linetype": list(rule.linetype),
        "entity": list(rule.entity),
        "block": list(rule.block),
        "conditions": rule.conditions.as_json(),
    }


def _changes(before: U8, after: U8) -> list[dict[str, Any]]:
    """Return the edges whose line type changes, grouped by their line types before and after.

    ``before``, ``after`` (n,): line types of the n edges before and after a change of the profile.
    Returns list of dict: ``before`` and ``after``: names of the line types; ``edges``: rows of the
    edges.
    """
    rows = np.flatnonzero(before != after)
    pairs, pair = np.unique(
        np.stack([before[rows], after[rows]], axis=1), axis=0, return_inverse=True
    )
    return [
        {
            "before": LineType(int(was)).word,
            "after": LineType(int(becomes)).word,
            "edges": rows[pair.reshape(-1) == number].tolist(),
        }
        for number, (was, becomes) in enumerate(pairs)
    ]
