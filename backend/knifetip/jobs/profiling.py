"""profiling: what a profile would say of a drawing before anybody keeps it.

preview   drawing, its profile, another -> which rule takes which edges, and what would change
learn     drawing, its profile, corrections -> rules that explain them, and what each would change
"""

from __future__ import annotations

import glob
from typing import Any

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.jobs.readings import read_drawing
from knifetip.library import custom_profiles
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.stage import Progress, Stage

#: Rules that are proposed at once: each is tried on the whole drawing.
_MOST = 12


def preview(
    progress: Progress, content: bytes, interpretation: Interpretation, text: str
) -> dict[str, Any]:
    """Return what the profile in ``text`` would do to a drawing that has another.

    Returns
    -------
    dict
        ``rules``: for each, its words, whether it is inherited, and how many edges it takes;
        ``open``: how many no rule takes; ``changes``: edges that would become something else.
    """
    from knifetip import pipeline
    from knifetip.classification.decision.profile_rules import matching_rules

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit)
    given = np.frombuffer(interpretation.overrides, np.uint8)
    progress(Stage.CLASSIFY, 0.6)
    other = custom_profiles.parse_text("preview", text)
    before = pipeline.interpret(drawing, interpretation)
    after = pipeline.classify(drawing, other, given)
    taken = matching_rules(drawing, other)
    lengths = drawing.lengths
    decided = taken >= 0
    edges = np.bincount(taken[decided], minlength=len(other.rules))
    length = np.bincount(taken[decided], weights=lengths[decided], minlength=len(other.rules))
    inherited = custom_profiles.inherited_rules(custom_profiles.parse_fields(text), other)
    return {
        "rules": [
            {
                **plain(rule),
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
    """Return rules that would have said what somebody corrected, the surest first.

    Those come first that contradict nothing.  For corrections that none of them explains follows
    what attributes say all the same, with what it would change: ten red lines of a layer were made
    creases, and the eleventh may have been forgotten.

    Returns
    -------
    list of dict
        ``rule``; ``explains``: corrected edges that it covers; ``sure``: whether it changes
        nothing that was decided; ``changes``: what else it would change, as in ``preview``.
    """
    from knifetip import pipeline
    from knifetip.classification.decision.profile_rules import matching_rules
    from knifetip.classification.rule_proposals import propose_rules

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit)
    mine = pipeline.rules_of(interpretation)
    given = np.frombuffer(interpretation.overrides, np.uint8)
    progress(Stage.CLASSIFY, 0.6)
    before = pipeline.interpret(drawing, interpretation)
    alone = pipeline.classify(drawing, mine)
    # A kind of line alone is no habit of a customer: it would take half of any other drawing.
    sure = [
        one
        for one in propose_rules(drawing, alone, given, mine)
        if one.rule.layer or one.rule.block or one.rule.colour or one.rule.true_colour
    ]
    explained = {row for one in sure for row in one.explains}
    left = np.flatnonzero((given != NO_OVERRIDE) & (alone.line_type != given))
    rest = _by_attributes(drawing, given, [row for row in left.tolist() if row not in explained])
    proposed = []
    for rule in [*(one.rule for one in sure), *rest][:_MOST]:
        longer = LineRules(mine.name, mine.title, (rule, *mine.rules))
        after = pipeline.classify(drawing, longer, given)
        met = matching_rules(drawing, LineRules("", "", (rule,))) == 0
        changes = _changes(before.line_type, after.line_type)
        proposed.append(
            {
                "rule": plain(rule),
                "explains": np.flatnonzero(met & (given == rule.line_type)).tolist(),
                "sure": all(one["before"] == "unclassified" for one in changes),
                "changes": changes,
            }
        )
    return sorted(proposed, key=lambda one: not one["sure"])


def _by_attributes(drawing: Drawing, given: U8, rows: list[int]) -> list[LineRule]:
    """Return a rule of layer and colour for each such pair that all went the same way."""
    wanted: dict[tuple[str, int, int], set[int]] = {}
    for row in rows:
        key = (
            drawing.layers[drawing.layer[row]],
            int(drawing.colour[row]),
            int(drawing.true_colour[row]),
        )
        wanted.setdefault(key, set()).add(int(given[row]))
    return [
        LineRule(
            LineType(kinds.pop()),
            layer=(glob.escape(layer),),
            colour=(index,) if true < 0 else (),
            true_colour=(true,) if true >= 0 else (),
        )
        for (layer, index, true), kinds in wanted.items()
        if len(kinds) == 1 and 0 not in kinds
    ]


def plain(rule: LineRule) -> dict[str, Any]:
    """Return a rule as plain data, the way a profile's TOML has it, with its words."""
    colours: list[int | str] = [*rule.colour, *(f"#{colour:06x}" for colour in rule.true_colour)]
    return {
        "type": rule.line_type.word,
        "layer": list(rule.layer),
        "colour": colours,
        "linetype": list(rule.linetype),
        "entity": list(rule.entity),
        "block": list(rule.block),
        "words": rule.words,
    }


def _changes(before: U8, after: U8) -> list[dict[str, Any]]:
    """Return the edges of which two classifications differ, by what they were and would be."""
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
