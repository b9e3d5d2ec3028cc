"""questions: create questions that ask the user for the line types of unclassified edges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np

from knifetip.classification.decision.profile_rules import display_name, fold_name
from knifetip.classification.following_edges import list_following_edges
from knifetip.classification.line_widths import distinguishing_widths
from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.classification.swapped_rules import find_deciding, find_dependent
from knifetip.geometry.columns import F64, I64
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing, extents
from knifetip.model.question import Question
from knifetip.vocabulary import is_centre_linetype, is_dashed_linetype, name_meaning

#: Least confidence of a guess that is called the most likely line type.
_LIKELY: Final = 0.74
#: Most questions that ask about layers separately.
_MOST: Final = 200


def list_questions(drawing: Drawing, dieline: Dieline) -> list[Question]:
    """Return one question for all edges that have the same style and are unclassified for the
    same reason.  Layers whose names only count are asked about together.  Edges whose line widths
    look different are asked about separately, unless their widths differ by chance.  If there would
    be more than 200 questions, all layers are asked about together; if there would still be more,
    all edges that are unclassified for the same reason are.
    If a profile seems to swap cut and crease, only the edges of the folding rule are asked about:
    the answer decides those of the other rule, which the question lists as ``follows``.

    Parameters
    ----------
    drawing, dieline
        The drawing and its dieline, with the same n edges.

    Returns
    -------
    list of Question
        Questions in the order of their first edges.  The field ``edges`` of a question contains the
        indices of the edges that it asks about, and ``choices`` the names of all line types, the
        likeliest first.
    """
    is_open = dieline.line_type == LineType.UNCLASSIFIED
    if not is_open.any():
        return []
    rows = np.flatnonzero(is_open & ~find_dependent(dieline))
    series = _series_of_layers(drawing)
    names = [series.get(layer, layer) for layer in drawing.layers]
    number = {name: at for at, name in enumerate(dict.fromkeys(names))}
    layer = np.array([number[name] for name in names], np.int32)[drawing.layer]
    style = (layer, drawing.colour, drawing.true_colour, drawing.linetype)
    width = distinguishing_widths(drawing.line_width, *style)
    columns = (*style, width, dieline.rule)
    first, group = unique_rows(*(column[rows] for column in columns))
    if len(first) > _MOST:
        asked = list(dict.fromkeys(names[one] for one in drawing.layer[rows].tolist()))
        names = [f"{asked[0]} … {asked[-1]}"] * len(names)
        first, group = unique_rows(*(column[rows] for column in columns[1:]))
    is_mixed = len(first) > _MOST
    if is_mixed:
        first, group = unique_rows(dieline.rule[rows])
    count = np.bincount(group)
    groups = np.split(rows[np.argsort(group, kind="stable")], np.cumsum(count)[:-1])
    lengths, bounds = drawing.lengths, drawing.bounds
    by_width = (width[rows][first] > 0) & (not is_mixed)
    asked = [
        _question(drawing, dieline, names, groups[at], lengths, bounds, bool(by_width[at]))
        for at in range(len(first))
    ]
    return _with_following_edges(drawing, dieline, names, asked)


def _with_following_edges(
    drawing: Drawing, dieline: Dieline, names: Sequence[str], questions: list[Question]
) -> list[Question]:
    """Return the questions; those about a swapped folding rule list the edges that they decide."""
    is_deciding = find_deciding(dieline)
    count = sum(bool(is_deciding[question.edges[0]]) for question in questions)
    return [
        replace(
            question,
            follows=list_following_edges(drawing, dieline, names, question.edges[0], count),
        )
        if is_deciding[question.edges[0]]
        else question
        for question in questions
    ]


def _series_of_layers(drawing: Drawing) -> dict[str, str]:
    """Return the name of the series of each layer of a drawing whose name only counts."""
    looks = (drawing.colour, drawing.true_colour, drawing.linetype)
    first, _ = unique_rows(drawing.layer, *looks)
    return find_numbered_layers(
        zip(
            (drawing.layers[row] for row in drawing.layer[first]),
            zip(*(column[first].tolist() for column in looks), strict=True),
            strict=True,
        )
    )


def _question(
    drawing: Drawing,
    dieline: Dieline,
    names: Sequence[str],
    rows: I64,
    lengths: F64,
    bounds: F64,
    by_width: bool,
) -> Question:
    """Return the question that asks the user for the line type of some unclassified edges.

    These edges have one style, and one reason why they are unclassified.

    ``drawing``, ``dieline``: the drawing and its dieline, with the same n edges.
    ``names``: name of each layer of the drawing, or of the series of layers that it belongs to.
    ``rows`` (k,): indices of the unclassified edges.
    ``lengths`` (n,): length of each edge of the drawing.
    ``bounds`` (4,): bounding box of the drawing: x min, y min, x max, y max.
    ``by_width``: whether other edges differ from these only in their line width, which the question
    names.
    """
    example = rows[0]
    layer = names[drawing.layer[example]]
    linetype = drawing.linetypes[drawing.linetype[example]]
    colour = int(drawing.colour[example])
    true_colour = int(drawing.true_colour[example])
    same_colour, same_linetype = (
        all((column[rows] == column[example]).all() for column in columns)
        for columns in ((drawing.colour, drawing.true_colour), (drawing.linetype,))
    )
    box = extents(drawing.ends[rows], drawing.bulge[rows])
    width, height = box[2:] - box[:2]
    arguments: dict[str, Any] = {
        "edges": len(rows),
        "layer": display_name(layer),
        "colour": (str(colour) if true_colour < 0 else f"#{true_colour:06x}")
        + ("" if same_colour else " …"),
        "linetype": display_name(linetype) + ("" if same_linetype else " …"),
        "length": lengths[rows].sum(),
        "width": width,
        "height": height,
        "x": box[0],
        "y": box[1],
        "unit": "mm" if drawing.unit else "",
        "guess": _guess_message(dieline, int(example)),
    }
    if by_width:
        lines = _line_width_message(int(drawing.line_width[example]), bool(drawing.unit))
        message = Message("question.line-type-by-width", lines=lines, **arguments)
    else:
        message = Message("question.line-type", **arguments)
    spans_drawing = bool((box[2:] - box[:2] >= 0.99 * (bounds[2:] - bounds[:2])).all())
    straight = bool((drawing.bulge[rows] == 0).all())
    guesses = dieline.alternatives[int(dieline.rule[example])]
    likely = dict.fromkeys((*guesses, *_likely_types(layer, linetype, spans_drawing, straight)))
    others = [kind for kind in LineType if kind not in (LineType.UNCLASSIFIED, *likely)]
    choices = tuple(kind.word for kind in (*likely, *others))
    return Question("line-type", message, choices, tuple(rows.tolist()), layer, colour)


def _line_width_message(line_width: int, unit_known: bool) -> Message:
    """Return the message that describes lines by their width, as in ``Drawing.line_width``.

    ``unit_known`` is whether the unit of the drawing is known.
    """
    if line_width == NO_LINE_WIDTH:
        return Message("question.default-width")
    if line_width == 0:
        return Message("question.thinnest-lines")
    code = "question.line-width" if unit_known else "question.line-width-without-unit"
    return Message(code, width=line_width / 100.0)


def _guess_message(dieline: Dieline, row: int) -> Message | None:
    """Return the message with the best guess for the unclassified edge ``row``.

    Below the confidence ``_LIKELY`` it gives only the evidence in the drawing; it is None if there
    is no evidence.
    """
    rule = int(dieline.rule[row])
    guesses, reason = dieline.alternatives[rule], dieline.rules[rule]
    confidence = float(dieline.confidence[row])
    if guesses and confidence >= _LIKELY:
        percent = round(100.0 * confidence)
        return Message("question.guess", type=guesses[0].word, percent=percent, reason=reason)
    if guesses:
        return Message("question.shape", reason=reason)
    if reason.code == "classification.no-rule-but-shape":
        return Message("question.shape", reason=reason.arguments["shape"])
    return None


def _likely_types(
    layer: str, linetype: str, spans_drawing: bool, straight: bool
) -> Sequence[LineType]:
    """Return the line types that edges of one style may have, the likeliest first.

    The name of the layer is the best evidence, then the name of the dash pattern, then the extent:
    edges that span the drawing are its outline, straight lines inside it are folds, and arcs inside
    it are holes.

    ``linetype``: name of the dash pattern of the edges, such as "DASHED".
    ``spans_drawing``: whether the edges together are about as wide and high as the drawing.
    ``straight``: whether all the edges are straight lines.
    """
    folded_linetype = fold_name(linetype)
    named = name_meaning(layer).kind
    guesses = [] if named is None else [named]
    if is_centre_linetype(folded_linetype):
        guesses.append(LineType.IGNORED)
    elif is_dashed_linetype(folded_linetype):
        guesses.append(LineType.CREASE)
    guesses.append(LineType.CREASE if straight and not spans_drawing else LineType.CUT)
    return tuple(dict.fromkeys(guesses))
