"""rules: which rule of a profile decides, for whole columns of names and colours at once.

    layers, colours, linetypes, entity kinds + LineRules -> rule and pattern that matched first

Patterns are shell globs; names out of a drawing never are, so that a layer called ``[CUT]`` is
only ever itself.  Both are compared without regard to case, and in one Unicode form, since
``BIÇAK`` may be written with or without a combining mark.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import replace
from fnmatch import translate

import numpy as np

from knifetip.geometry.columns import I32
from knifetip.model.profile import LineRule

#: Confidence of a rule by the strongest thing that it names.
BY_LAYER_AND_COLOUR = 1.0
BY_LAYER = 0.95
BY_STYLE = 0.8
BY_NOTHING = 0.5


def folded(name: str) -> str:
    """Return the form in which names are compared."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name.strip()).casefold())


def matched(patterns: Sequence[str], names: Sequence[str]) -> I32:
    """Return the first pattern that each name matches.

    Parameters
    ----------
    patterns
        Shell globs, p of them.
    names
        m names as the drawing writes them.

    Returns
    -------
    (m,) int32
        Index into ``patterns``, -1 where none matches.  Without patterns everything matches: 0.
    """
    if not patterns:
        return np.zeros(len(names), np.int32)
    plain: dict[str, int] = {}
    globs: list[tuple[int, re.Pattern[str]]] = []
    for index, pattern in enumerate(map(folded, patterns)):
        if any(sign in pattern for sign in "*?["):
            globs.append((index, re.compile(translate(pattern))))
        else:
            plain.setdefault(pattern, index)

    def first(name: str) -> int:
        found = plain.get(name, len(patterns))
        for index, glob in globs:
            if index < found and glob.match(name):
                found = index
                break
        return found if found < len(patterns) else -1

    return np.array([first(folded(name)) for name in names], np.int32)


def confidence(rule: LineRule) -> float:
    """Return how far a rule can be trusted: a name and a colour together say most."""
    if rule.layer:
        return BY_LAYER_AND_COLOUR if rule.colour else BY_LAYER
    return BY_STYLE if rule.colour or rule.linetype else BY_NOTHING


def narrowed(rule: LineRule, layer: int, colour: int, linetype: int, entity: int) -> LineRule:
    """Return the rule with only what matched: its words are what the user is told.

    ``layer``, ``linetype`` and ``entity`` are indices of patterns, ``colour`` is the colour itself.
    """
    return replace(
        rule,
        layer=rule.layer[layer : layer + 1],
        colour=(colour,) if rule.colour else (),
        linetype=rule.linetype[linetype : linetype + 1],
        entity=rule.entity[entity : entity + 1],
    )
