"""following_edges: list the edges that the answer about swapped rules decides besides its own."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from knifetip.classification.decision.profile_rules import display_name
from knifetip.classification.swapped_rules import find_dependent, swapped_types
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.question import FollowingEdges


def list_following_edges(
    drawing: Drawing, dieline: Dieline, names: Sequence[str], asked: int, questions: int
) -> tuple[FollowingEdges, ...]:
    """Return the edges that the answer about an edge of swapped rules decides, one for each style.

    Parameters
    ----------
    drawing, dieline
        The drawing and its dieline, with the same n edges.
    names
        Name of each layer of the drawing, or of the series of layers that it belongs to.
    asked
        Row of an edge that a question about the folding rule asks about.
    questions
        Number of the questions about the folding rule.
    """
    rows = np.flatnonzero(find_dependent(dieline))
    guess, own = swapped_types(dieline)
    number = {name: at for at, name in enumerate(dict.fromkeys(names))}
    layer = np.array([number[name] for name in names], np.int32)[drawing.layer]
    style = (layer, drawing.colour, drawing.true_colour, drawing.linetype, dieline.rule)
    first, group = unique_rows(*(column[rows] for column in style))
    following = []
    for at, example in enumerate(rows[first].tolist()):
        edges = rows[group == at]
        line_types = {
            LineType(int(types[asked])).word: LineType(int(types[example])).word
            for types in (guess, own)
        }
        (answer, kind), (other_answer, other_kind) = line_types.items()
        colour, true_colour = int(drawing.colour[example]), int(drawing.true_colour[example])
        message = Message(
            "question.follows",
            edges=len(edges),
            layer=display_name(names[drawing.layer[example]]),
            colour=str(colour) if true_colour < 0 else f"#{true_colour:06x}",
            linetype=display_name(drawing.linetypes[drawing.linetype[example]]),
            questions=questions,
            answer=answer,
            type=kind,
            other_answer=other_answer,
            other_type=other_kind,
        )
        following.append(
            FollowingEdges(
                message, tuple(edges.tolist()), names[drawing.layer[example]], colour, line_types
            )
        )
    return tuple(following)
