"""problem: what is to be placed, and on which sheets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from knifetip.errors import PlanError
from knifetip.nesting.arrangement import Board
from knifetip.nesting.columns import fits
from knifetip.nesting.parts import Part


@dataclass(frozen=True, slots=True)
class Problem:
    """Parts that are to be placed, on sheets that are used in the order of ``boards``."""

    parts: Sequence[Part]
    boards: Sequence[Board]
    gap: float  #: least distance between two blanks (mm)
    seconds: float  #: time of the search
    seed: int = 0
    in_holes: bool = True  #: whether parts are placed in holes of others


def check_sizes(problem: Problem) -> None:
    """Raise ``PlanError`` if a part fits on no sheet."""
    for number, part in enumerate(problem.parts):
        boxes = [box for _, box in part.boxes]
        if not any(fits(box.width, box.height, b) for box in boxes for b in problem.boards):
            box = min(boxes, key=lambda one: max(one.width, one.height))
            raise PlanError(
                "nesting.too-large", part=number + 1, width=box.width, height=box.height
            )
