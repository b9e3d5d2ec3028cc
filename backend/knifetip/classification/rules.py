"""rules: which rule of a profile decides, for whole columns of names and colours at once.

    Drawing            -> Styles     its combinations of layer, colour, linetype, entity and block
    Styles, LineRules  -> Matches    the rule that each combination meets first

A drawing of 100,000 edges has a few dozen combinations: the rules look at those, and the edges take
what their combination got.

Patterns are shell globs; names out of a drawing never are, so that a layer called ``[CUT]`` is
only ever itself.  Both are compared without regard to case, and in one Unicode form, since
``BIÇAK`` may be written with or without a combining mark.
"""

from __future__ import annotations

import glob
import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fnmatch import translate
from functools import lru_cache

import numpy as np

from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.geometry.distinct import distinct
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.words import numbered

#: Confidence of a rule by the strongest thing that it names.
BY_LAYER_AND_COLOUR = 1.0
BY_LAYER = 0.95
BY_STYLE = 0.8
BY_NOTHING = 0.5

#: True colours that are colours of AutoCAD's index.  Any other has no index: a rule that says
#: "colour 1" does not mean an edge that looks orange, whatever index was written beside it.
_INDEX_OF = {
    0xFF0000: 1,
    0xFFFF00: 2,
    0x00FF00: 3,
    0x00FFFF: 4,
    0x0000FF: 5,
    0xFF00FF: 6,
    0xFFFFFF: 7,
    0x000000: 7,
}
#: The other way round, for a rule that names a true colour; 7 is black on paper.
_TRUE_OF = {index: colour for colour, index in _INDEX_OF.items()}


@dataclass(frozen=True, eq=False, slots=True)
class Styles:
    """The c combinations of a drawing's n edges, in the order in which they first occur."""

    of: I64  #: (n,) which combination each edge has
    layer: tuple[str, ...]  #: (c,)
    colour: I32  #: (c,) colour index that rules compare; 0 for a true colour that has none
    written: I32  #: (c,) colour index as the file has it
    true_colour: I32  #: (c,) 0xRRGGBB that rules compare; -1 for an index that has none
    linetype: tuple[str, ...]  #: (c,)
    entity: tuple[str, ...]  #: (c,)
    block: tuple[str, ...]  #: (c,) "" outside blocks

    def __len__(self) -> int:
        return len(self.layer)

    def shown_colour(self, style: int) -> str:
        """Return a colour as people write it: ``colour 3``, ``colour #ff8000``."""
        if self.colour[style]:
            return f"colour {self.colour[style]}"
        return f"colour #{self.true_colour[style]:06x}"


def styles(drawing: Drawing) -> Styles:
    """Return the combinations of layer, colour, linetype, kind of entity and block."""
    kinds, kind = numbered(drawing.ledger.kind)
    blocks, block = numbered(drawing.ledger.block or ("",))
    of_entity = np.zeros(len(drawing.ledger), np.int32)
    of_entity[:] = kind if len(blocks) == 1 else kind * len(blocks) + block
    # One number for all but the colours.
    place = (drawing.layer.astype(np.int64) * len(drawing.linetypes)) + drawing.linetype
    place = place * (len(kinds) * len(blocks)) + of_entity[drawing.entity]
    first, of = distinct(place, drawing.colour, drawing.true_colour)
    true = drawing.true_colour[first]
    written = drawing.colour[first]
    index = np.array([_INDEX_OF.get(value, 0) for value in true.tolist()], np.int32)
    known = np.array([_TRUE_OF.get(value, -1) for value in written.tolist()], np.int32)
    entity = drawing.entity[first]
    return Styles(
        of,
        tuple(drawing.layers[row] for row in drawing.layer[first]),
        np.where(true < 0, written, index).astype(np.int32),
        written,
        np.where(true < 0, known, true).astype(np.int32),
        tuple(drawing.linetypes[row] for row in drawing.linetype[first]),
        tuple(drawing.ledger.kind[row] for row in entity),
        tuple(drawing.ledger.block[row] if drawing.ledger.block else "" for row in entity),
    )


@dataclass(frozen=True, eq=False, slots=True)
class Matches:
    """What a profile says of c combinations."""

    line_type: U8  #: (c,) LineType; UNCLASSIFIED where no rule matches, or one leaves it open
    rule: I32  #: (c,) which rule, -1 for none
    confidence: F64  #: (c,)
    words: tuple[str, ...]  #: (c,) the rule with only what matched, "" for none


def rule_of_each_edge(drawing: Drawing, rules: LineRules) -> I32:
    """Return the index of the profile's rule that each edge matches, (n,): -1 for none."""
    combinations = styles(drawing)
    return match(combinations, rules).rule[combinations.of]


def match(styles: Styles, rules: LineRules) -> Matches:
    """Return the first rule that each combination meets."""
    count = len(styles)
    line_type = np.full(count, LineType.UNCLASSIFIED, np.uint8)
    decided = np.full(count, -1, np.int32)
    trust = np.zeros(count)
    words = [""] * count
    open_ = np.ones(count, bool)
    for number, rule in enumerate(rules.rules):
        by_layer = matched(rule.layer, styles.layer)
        by_linetype = matched(rule.linetype, styles.linetype)
        by_entity = matched(rule.entity, styles.entity)
        by_block = matched(rule.block, styles.block)
        hit = open_ & (by_layer >= 0) & (by_linetype >= 0) & (by_entity >= 0) & (by_block >= 0)
        index = np.isin(styles.colour, rule.colour)
        true = np.isin(styles.true_colour, rule.true_colour)
        if rule.colour or rule.true_colour:
            hit &= index | true
        for row in np.flatnonzero(hit):
            told = narrowed(
                rule,
                int(by_layer[row]),
                int(styles.colour[row]) if index[row] else 0,
                int(by_linetype[row]),
                int(by_entity[row]),
                int(styles.true_colour[row]) if true[row] and not index[row] else -1,
                int(by_block[row]),
            )
            words[row] = told.words
        line_type[hit] = rule.line_type
        decided[hit] = number
        trust[hit] = 0.0 if rule.line_type == LineType.UNCLASSIFIED else confidence(rule)
        open_ &= ~hit
    return Matches(line_type, decided, trust, tuple(words))


@lru_cache(maxsize=1 << 16)
def folded(name: str) -> str:
    """Return the form in which names are compared."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name.strip()).casefold())


def literal(name: str) -> str:
    """Return the pattern that this name alone matches."""
    return glob.escape(name)


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
        for index, pattern in globs:
            if index < found and pattern.match(name):
                found = index
                break
        return found if found < len(patterns) else -1

    known = {name: first(folded(name)) for name in set(names)}
    return np.array([known[name] for name in names], np.int32)


def confidence(rule: LineRule) -> float:
    """Return how far a rule can be trusted: a name and a colour together say most."""
    coloured = bool(rule.colour or rule.true_colour)
    if rule.layer or rule.block:
        return BY_LAYER_AND_COLOUR if coloured else BY_LAYER
    return BY_STYLE if coloured or rule.linetype else BY_NOTHING


def narrowed(
    rule: LineRule,
    layer: int,
    colour: int,
    linetype: int,
    entity: int,
    true_colour: int = -1,
    block: int = 0,
) -> LineRule:
    """Return the rule with only what matched: its words are what the user is told.

    ``layer``, ``linetype``, ``entity`` and ``block`` are indices of patterns; ``colour`` is the
    index that matched, 0 for none, ``true_colour`` the true colour, -1 for none.
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
