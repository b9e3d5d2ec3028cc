"""profile_rules: match the rules of a profile against the styles of a drawing.

A style is a combination of layer, colour, dash pattern, kind of entity and block.  A drawing of
100,000 edges has a few dozen styles.  Rules are matched against the styles, and each edge gets the
result of its style.

Patterns are shell globs.  Names in a drawing are literal: a layer called ``[CUT]`` matches only the
same name.  Comparison ignores case and uses one Unicode form, since ``BIÇAK`` may be written with
or without a combining mark.
"""

from __future__ import annotations

import glob
import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fnmatch import translate
from functools import lru_cache
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.words import number_words

#: Confidence of a rule, by the most specific of its conditions.
LAYER_AND_COLOUR: Final = 1.0
LAYER: Final = 0.95
COLOUR_OR_LINETYPE: Final = 0.8
ENTITY_OR_NONE: Final = 0.5

#: AutoCAD colour indices of true colours.  Other true colours have no index: a rule for "colour 1"
#: does not match an orange edge, whatever index the file gives besides.
_INDEX_BY_TRUE_COLOUR: Final = {
    0xFF0000: 1,
    0xFFFF00: 2,
    0x00FF00: 3,
    0x00FFFF: 4,
    0x0000FF: 5,
    0xFF00FF: 6,
    0xFFFFFF: 7,
    0x000000: 7,
}
#: True colours of AutoCAD colour indices; index 7 is black, as on paper.
_TRUE_COLOUR_BY_INDEX: Final = {index: true for true, index in _INDEX_BY_TRUE_COLOUR.items()}
#: The longest name that a message shows.
_MOST_SHOWN: Final = 80


@dataclass(frozen=True, eq=False, slots=True)
class StyleTable:
    """The c styles of a drawing, in the order of their first edges, and the style of each edge."""

    row: I64  #: (n,) style of each edge, as an index into the other columns
    layer: tuple[str, ...]  #: (c,) name of the layer
    colour: I32  #: (c,) colour index for rules; 0 for a true colour without an index
    true_colour: I32  #: (c,) 0xRRGGBB for rules; -1 for an index without a true colour
    linetype: tuple[str, ...]  #: (c,) name of the linetype
    entity: tuple[str, ...]  #: (c,) kind of entity, such as LINE
    block: tuple[str, ...]  #: (c,) name of the block, "" outside blocks
    #: (c,) number of the line width among styles that are equal otherwise, 0 if it has no meaning
    width: I32

    def __len__(self) -> int:
        return len(self.layer)


def tabulate_styles(drawing: Drawing) -> StyleTable:
    """Return the table of the different styles of a drawing, and the style of each edge.

    A style combines layer, colour, dash pattern, kind of entity and block.  Its line width is added
    by ``divide_by_line_width``; rules have no condition on it.
    """
    report = drawing.import_report
    kinds, kind = number_words(report.kind)
    blocks, block = number_words(report.block or ("",))
    entity_key = np.zeros(len(report), np.int32)
    entity_key[:] = kind if len(blocks) == 1 else kind * len(blocks) + block
    # All attributes except the colours are combined in one number.
    key = (drawing.layer.astype(np.int64) * len(drawing.linetypes)) + drawing.linetype
    key = key * (len(kinds) * len(blocks)) + entity_key[drawing.entity]
    first, style = unique_rows(key, drawing.colour, drawing.true_colour)
    true_colour, colour = drawing.true_colour[first], drawing.colour[first]
    index = [_INDEX_BY_TRUE_COLOUR.get(value, 0) for value in true_colour.tolist()]
    true = [_TRUE_COLOUR_BY_INDEX.get(value, -1) for value in colour.tolist()]
    entity = drawing.entity[first]
    return StyleTable(
        style,
        tuple(drawing.layers[row] for row in drawing.layer[first]),
        np.where(true_colour < 0, colour, np.array(index, np.int32)).astype(np.int32),
        np.where(true_colour < 0, np.array(true, np.int32), true_colour).astype(np.int32),
        tuple(drawing.linetypes[row] for row in drawing.linetype[first]),
        tuple(report.kind[row] for row in entity),
        tuple(report.block[row] if report.block else "" for row in entity),
        np.zeros(len(first), np.int32),
    )


@dataclass(frozen=True, eq=False, slots=True)
class RuleMatches:
    """For each of c styles, the first rule of a profile that matches it, if any."""

    line_type: U8  #: (c,) LineType; UNCLASSIFIED if no rule matches, or if the rule sets it
    rule: I32  #: (c,) index of the rule, -1 for none
    confidence: F64  #: (c,) confidence of the rule, 0 … 1
    #: (c,) the conditions of the rule with only the patterns that matched; None without a rule
    conditions: tuple[Message | None, ...]


def matching_rules(drawing: Drawing, rules: LineRules) -> I32:
    """Return the index of the first rule of a profile that matches each edge of a drawing, (n,).

    The index is -1 for an edge that no rule matches.  ``rules`` is the profile.
    """
    styles = tabulate_styles(drawing)
    return match_rules(styles, rules).rule[styles.row]


def match_rules(styles: StyleTable, rules: LineRules) -> RuleMatches:
    """Return for each style the first rule that matches it, and its patterns that matched.

    ``styles`` are the styles of a drawing, and ``rules`` is the profile.
    """
    count = len(styles)
    line_type = np.full(count, LineType.UNCLASSIFIED, np.uint8)
    matched_rule = np.full(count, -1, np.int32)
    confidence = np.zeros(count)
    conditions: list[Message | None] = [None] * count
    undecided = np.ones(count, bool)
    for number, rule in enumerate(rules.rules):
        layer = first_match(rule.layer, styles.layer)
        linetype = first_match(rule.linetype, styles.linetype)
        entity = first_match(rule.entity, styles.entity)
        block = first_match(rule.block, styles.block)
        hit = undecided & (layer >= 0) & (linetype >= 0) & (entity >= 0) & (block >= 0)
        if not hit.any():
            continue
        index = np.isin(styles.colour, rule.colour)
        true = np.isin(styles.true_colour, rule.true_colour)
        if rule.colour or rule.true_colour:
            hit &= index | true
        for row in np.flatnonzero(hit):
            narrow = narrow_rule(
                rule,
                int(layer[row]),
                int(styles.colour[row]) if index[row] else 0,
                int(linetype[row]),
                int(entity[row]),
                int(styles.true_colour[row]) if true[row] and not index[row] else -1,
                int(block[row]),
            )
            conditions[row] = narrow.conditions
        line_type[hit] = rule.line_type
        matched_rule[hit] = number
        decides = rule.line_type != LineType.UNCLASSIFIED
        confidence[hit] = rule_confidence(rule) if decides else 0.0
        undecided &= ~hit
    return RuleMatches(line_type, matched_rule, confidence, tuple(conditions))


@lru_cache(maxsize=1 << 17)
def fold_name(name: str) -> str:
    """Return a name in the form in which names are compared.

    The form is Unicode NFC, case folded, without spaces at the ends.
    """
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name.strip()).casefold())


def escape_pattern(name: str) -> str:
    """Return the shell glob that matches only the given name."""
    return glob.escape(name)


def display_name(name: str) -> str:
    """Return a name that is safe to print: no control characters, at most 80 characters."""
    clean = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in name)
    return clean if len(clean) <= _MOST_SHOWN else clean[: _MOST_SHOWN - 1] + "…"


def first_match(patterns: Sequence[str], names: Sequence[str]) -> I32:
    """Return the index of the first pattern that matches each name.

    Parameters
    ----------
    patterns
        p shell globs.
    names
        m names as the drawing writes them.

    Returns
    -------
    (m,) int32
        Index into ``patterns``, or -1 for a name that no pattern matches.  If ``patterns`` is
        empty, all entries are 0, because a rule without patterns matches every name.
    """
    if not patterns:
        return np.zeros(len(names), np.int32)
    literal, globs = _compile_patterns(tuple(patterns))

    def first(name: str) -> int:
        found = literal.get(name, len(patterns))
        for index, pattern in globs:
            if index < found and pattern.match(name):
                found = index
                break
        return found if found < len(patterns) else -1

    by_name = {name: first(fold_name(name)) for name in set(names)}
    return np.array([by_name[name] for name in names], np.int32)


@lru_cache(maxsize=1 << 12)
def _compile_patterns(
    patterns: tuple[str, ...],
) -> tuple[dict[str, int], list[tuple[int, re.Pattern[str]]]]:
    """Return the indices of the patterns without wildcards by name, and the index and the compiled
    form of each other one; callers must not change them.
    """
    literal: dict[str, int] = {}
    globs: list[tuple[int, re.Pattern[str]]] = []
    for index, pattern in enumerate(map(fold_name, patterns)):
        if any(sign in pattern for sign in "*?["):
            globs.append((index, re.compile(translate(pattern))))
        else:
            literal.setdefault(pattern, index)
    return literal, globs


def rule_confidence(rule: LineRule) -> float:
    """Return the confidence of a rule, which depends on the attributes for which it has patterns.

    The confidence is 1 for a rule with layer (or block) and colour, 0.95 for layer or block without
    colour, 0.8 for colour or dash pattern without layer and block, and 0.5 for all other rules.
    """
    coloured = bool(rule.colour or rule.true_colour)
    if rule.layer or rule.block:
        return LAYER_AND_COLOUR if coloured else LAYER
    return COLOUR_OR_LINETYPE if coloured or rule.linetype else ENTITY_OR_NONE


def narrow_rule(
    rule: LineRule,
    layer: int,
    colour: int,
    linetype: int,
    entity: int,
    true_colour: int = -1,
    block: int = 0,
) -> LineRule:
    """Return a rule with only the patterns that matched a style, to be shown in messages.

    Parameters
    ----------
    rule
        Rule of a profile, perhaps with several patterns for each attribute.
    layer, linetype, entity, block
        For each of these attributes, the index of the pattern that matched, among the rule's
        patterns for this attribute.  Has no effect if the rule has none.
    colour
        Colour index that matched, 0 if no colour index did.
    true_colour
        True colour (0xRRGGBB) that matched, -1 if no true colour did.
    """
    return replace(
        rule,
        layer=rule.layer[layer : layer + 1],
        colour=(colour,) if rule.colour and colour else (),
        true_colour=(true_colour,) if rule.true_colour and true_colour >= 0 else (),
        linetype=rule.linetype[linetype : linetype + 1],
        entity=rule.entity[entity : entity + 1],
        block=rule.block[block : block + 1],
    )
