"""Task of the worker processes about nestings: the shapes of the drawings that are placed."""

from __future__ import annotations

from collections.abc import Sequence

from knifetip.model.nesting import NestingPart
from knifetip.model.stage import Progress, Stage
from knifetip.nesting.parts import Part, make_part
from knifetip.presentation.edges import restore_drawing


def prepare_parts(
    progress: Progress,
    edges: Sequence[bytes],
    wanted: Sequence[tuple[int, NestingPart]],
    keep_grain: bool,
) -> list[Part]:
    """Return the parts of a nesting.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    edges
        Packed edges of each drawing.
    wanted
        Index of the drawing of each part, and the part.
    keep_grain
        Whether parts keep the direction of the grain unless they state another step of turns.
    """
    from knifetip import pipeline
    from knifetip.layout.blanks import find_blanks

    sources = []
    for number, block in enumerate(edges):
        progress(Stage.CLEAN, number / len(edges))
        _, dieline = restore_drawing(block)
        sources.append((dieline, find_blanks(pipeline.clean(dieline).dieline)))
    return [
        make_part(
            *sources[index],
            part.turns(keep_grain=keep_grain),
            mirror=part.mirror,
            quantity=part.quantity,
        )
        for index, part in wanted
    ]
