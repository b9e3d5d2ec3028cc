"""classify: what is to be done along each edge, and which rule of the profile says so.

    Drawing, LineRules -> Dieline            the first rule that matches decides
    Dieline, overrides -> Dieline            what somebody said comes last
    Drawing, Dieline   -> list[Question]     what nobody has said yet

A drawing of 100,000 edges has a few dozen combinations of layer, colour, linetype and kind of
entity: the rules look at those, and the edges take what their combination got.  What no rule
matches stays unclassified and becomes a question; nothing is cut by default.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from knifetip.classification import rules as matching
from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, extents
from knifetip.model.profile import LineRules
from knifetip.model.question import Question

#: In a column of overrides: leave this edge as the profile has it.
KEEP = 255

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

#: Parts of layer names that make an answer plausible.  They only order the choices of a question.
_HINTS: tuple[tuple[LineType, tuple[str, ...]], ...] = (
    (
        LineType.IGNORED,
        ("dim", "text", "note", "label", "info", "mark", "frame", "title", "grav", "etch", "axis"),
    ),
    (LineType.HALF_CUT, ("half", "kiss", "partial")),
    (LineType.COMBI, ("comb", "perfo-r")),
    (LineType.PERFORATION, ("perf",)),
    (LineType.V_GROOVE, ("groove", "v-cut", "vcut", "v_cut", "v-nut")),
    (LineType.CREASE, ("creas", "fold", "score", "bend", "ril", "rain", "pilyaj", "hinge", "falt")),
    (LineType.CUT, ("cut", "outline", "contour", "kontur", "knife", "schnitt", "stanz", "outer")),
)
_BROKEN = ("dash", "hidden", "dot", "strich")
_AXES = ("center", "centre", "phantom", "mitte")


def _coded(*columns: I32) -> tuple[I64, I64, I64]:
    """Return the first row of each distinct combination, each row's combination, and the counts."""
    code = np.zeros(len(columns[0]), np.int64)
    for column in columns:
        # Numbered anew after each column, so that the product never outgrows 64 bits.
        values, number = np.unique(column, return_inverse=True)
        _, code = np.unique(code * len(values) + number, return_inverse=True)
    _, first, combination, count = np.unique(
        code, return_index=True, return_inverse=True, return_counts=True
    )
    return first, combination, count


def _indices(drawing: Drawing) -> I32:
    """Return the colour index that rules compare, (n,): 0 for a true colour that has none."""
    true = drawing.true_colour
    values, number = np.unique(true, return_inverse=True)
    index = np.array([_INDEX_OF.get(value, 0) for value in values.tolist()], np.int32)
    return np.where(true < 0, drawing.colour, index[number])


def _kinds(drawing: Drawing) -> tuple[list[str], I32]:
    """Return the kinds of entity and, for each edge, which it came from, (n,)."""
    number: dict[str, int] = {}
    codes = [number.setdefault(kind, len(number)) for kind in drawing.ledger.kind]
    return list(number), np.array(codes, np.int32)[drawing.entity]


def classify(drawing: Drawing, rules: LineRules) -> Dieline:
    """Return the dieline: every edge of the drawing with the line type of the first rule it meets.

    Parameters
    ----------
    drawing
        n edges.
    rules
        The customer's profile.

    Returns
    -------
    Dieline
        n edges, row i that of the drawing.  ``rules`` holds the words of each rule that decided,
        with only the pattern that matched: ``profile default: layer "FOLDS"``.  Confidence is 1
        for a rule on layer and colour, 0.95 on a layer, 0.8 on colour or linetype, 0 for none.
    """
    index = _indices(drawing)
    kinds, kind = _kinds(drawing)
    first, combination, _ = _coded(drawing.layer, index, drawing.linetype, kind)
    layer, colour = drawing.layer[first], index[first]
    linetype, entity = drawing.linetype[first], kind[first]

    words: dict[str, int] = {f"no rule of profile {rules.name}": 0}
    line_type = np.full(len(first), LineType.UNCLASSIFIED, np.uint8)
    word = np.zeros(len(first), np.int32)
    trust = np.zeros(len(first))
    open_ = np.ones(len(first), bool)
    for rule in rules.rules:
        by_layer = matching.matched(rule.layer, drawing.layers)[layer]
        by_linetype = matching.matched(rule.linetype, drawing.linetypes)[linetype]
        by_entity = matching.matched(rule.entity, kinds)[entity]
        hit = open_ & (by_layer >= 0) & (by_linetype >= 0) & (by_entity >= 0)
        if rule.colour:
            hit &= np.isin(colour, rule.colour)
        for row in np.flatnonzero(hit):
            told = matching.narrowed(
                rule, by_layer[row], int(colour[row]), by_linetype[row], by_entity[row]
            )
            text = f"profile {rules.name}: {told.words}"
            word[row] = words.setdefault(text, len(words))
        line_type[hit] = rule.line_type
        trust[hit] = 0.0 if rule.line_type == LineType.UNCLASSIFIED else matching.confidence(rule)
        open_ &= ~hit
    return Dieline(
        drawing.ends,
        drawing.bulge,
        line_type[combination],
        np.arange(len(drawing), dtype=np.int32),
        word[combination],
        trust[combination],
        tuple(words),
    )


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
    words = dieline.rules if "override" in dieline.rules else (*dieline.rules, "override")
    return replace(
        dieline,
        line_type=np.where(said, given, dieline.line_type),
        rule=np.where(said, words.index("override"), dieline.rule),
        confidence=np.where(said, 1.0, dieline.confidence),
        rules=words,
    )


def questions(drawing: Drawing, dieline: Dieline) -> list[Question]:
    """Return one question for each layer, colour and linetype that nobody has classified.

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
    columns = (drawing.layer, drawing.colour, drawing.true_colour, drawing.linetype)
    first, combination, count = _coded(*(column[rows] for column in columns))
    groups = np.split(rows[np.argsort(combination, kind="stable")], np.cumsum(count)[:-1])
    lengths = drawing.lengths
    whole = drawing.bounds
    return [_question(drawing, groups[number], lengths, whole) for number in np.argsort(first)]


def _question(drawing: Drawing, rows: I64, lengths: F64, whole: F64) -> Question:
    example = rows[0]
    layer = drawing.layers[drawing.layer[example]]
    linetype = drawing.linetypes[drawing.linetype[example]]
    colour = int(drawing.colour[example])
    true_colour = int(drawing.true_colour[example])
    box = extents(drawing.ends[rows], drawing.bulge[rows])
    width, height = box[2:] - box[:2]
    unit = "mm" if drawing.unit else "units of the file"
    seen = f"colour {colour}" if true_colour < 0 else f"colour #{true_colour:06x}"
    text = (
        f'{len(rows):,} edge{"s" * (len(rows) != 1)} on layer "{_shown(layer)}", {seen}, linetype '
        f"{_shown(linetype)}, {lengths[rows].sum():,.1f} {unit} long in all, in a box of "
        f"{width:,.1f} × {height:,.1f} {unit} at ({box[0]:,.1f}, {box[1]:,.1f}): "
        f"what {'are they' if len(rows) != 1 else 'is it'}?"
    )
    reach = box[2:] - box[:2] >= 0.99 * (whole[2:] - whole[:2])
    likely = _likely(layer, linetype, bool(reach.all()), bool((drawing.bulge[rows] == 0).all()))
    others = [kind for kind in LineType if kind not in (LineType.UNCLASSIFIED, *likely)]
    choices = tuple(kind.word for kind in (*likely, *others))
    return Question("line-type", text, choices, tuple(rows.tolist()), layer, colour)


def _shown(name: str) -> str:
    """Return a name as it may be printed: a file may hold anything, a terminal obeys some of it."""
    clean = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in name)
    return clean if len(clean) <= 80 else clean[:79] + "…"


def _likely(layer: str, linetype: str, reaches: bool, straight: bool) -> Sequence[LineType]:
    """Return plausible answers, best first, without repeats.

    A name says more than a line style, and that more than the shape: what spans the whole drawing
    is its outline, straight lines inside it are folds, arcs inside it are holes.
    """
    name, style = matching.folded(layer), matching.folded(linetype)
    guesses = [kind for kind, parts in _HINTS if any(part in name for part in parts)]
    if any(part in style for part in _AXES):
        guesses.append(LineType.IGNORED)
    elif any(part in style for part in _BROKEN):
        guesses.append(LineType.CREASE)
    guesses.append(LineType.CREASE if straight and not reaches else LineType.CUT)
    return tuple(dict.fromkeys(guesses))
