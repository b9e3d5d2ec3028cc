"""profiling: what a profile would say of a drawing before anybody keeps it.

preview   drawing, its profile, another -> which rule takes which edges, and what would change
learn     drawing, its profile, corrections -> rules that explain them, and what each would change
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.jobs.crew import Progress
from knifetip.jobs.tasks import drawing_of, rules_of
from knifetip.library import own
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRule, LineRules


def preview(
    progress: Progress,
    content: bytes,
    unit: str,
    profile: str,
    rules: str,
    overrides: bytes,
    text: str,
) -> dict[str, Any]:
    """Return what the profile in ``text`` would do to a drawing that has another.

    Returns
    -------
    dict
        ``rules``: for each, its words, whether it is inherited, and how many edges it takes;
        ``open``: how many no rule takes; ``changes``: edges that would become something else.
    """
    from knifetip import pipeline

    progress("read", 0.0)
    drawing = drawing_of(content, unit)
    given = np.frombuffer(overrides, np.uint8)
    progress("classify", 0.6)
    other = own.parsed("preview", text)
    before = pipeline.dieline(drawing, rules_of(profile, rules), given)
    after = pipeline.dieline(drawing, other, given)
    taken = pipeline.taken(drawing, other)
    lengths = drawing.lengths
    decided = taken >= 0
    edges = np.bincount(taken[decided], minlength=len(other.rules))
    length = np.bincount(taken[decided], weights=lengths[decided], minlength=len(other.rules))
    inherited = _inherited(text, other)
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
    progress: Progress, content: bytes, unit: str, profile: str, rules: str, overrides: bytes
) -> list[dict[str, Any]]:
    """Return rules that would have said what somebody corrected, the smallest first.

    Returns
    -------
    list of dict
        ``rule``, ``words``; ``explains``: corrected edges that it covers; ``changes``: what else
        it would change, as in ``preview``.
    """
    from knifetip import pipeline

    progress("read", 0.0)
    drawing = drawing_of(content, unit)
    mine = rules_of(profile, rules)
    given = np.frombuffer(overrides, np.uint8)
    progress("classify", 0.6)
    before = pipeline.dieline(drawing, mine, given)
    proposed = []
    for one in pipeline.learned(drawing, mine, given):
        longer = LineRules(mine.name, mine.title, (one.rule, *mine.rules))
        after = pipeline.dieline(drawing, longer, given)
        proposed.append(
            {
                "rule": plain(one.rule),
                "explains": list(one.explains),
                "changes": _changes(before.line_type, after.line_type),
            }
        )
    return proposed


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


def _inherited(text: str, rules: LineRules) -> list[bool]:
    fields = own.parts(text)
    mine = len(fields["rule"])
    others = len(rules.rules) - mine
    if fields.get("overrules", False):
        return [False] * mine + [True] * others
    return [True] * others + [False] * mine


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
