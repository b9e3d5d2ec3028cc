"""fold: fold a cleaned drawing in one step."""

from __future__ import annotations

from knifetip.errors import PlanError
from knifetip.folding.panels import find_panels
from knifetip.folding.records import FoldOptions, FoldTree
from knifetip.folding.tree import build_tree
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline


def fold_tree(dieline: Dieline, board: Board, options: FoldOptions) -> FoldTree:
    """Return the fold tree of a cleaned dieline.

    Raises
    ------
    DrawingTooLarge
        There are too many edges or panels.
    PlanError
        An angle is given for a fold that does not exist.
    """
    sheet = find_panels(dieline)
    for number in options.angles:
        if not 0 <= number < len(sheet.hinges):
            raise PlanError("folding.no-such-fold", fold=number + 1, count=len(sheet.hinges))
    return build_tree(sheet, board, options)
