"""chosen_rows: the edges for which the user has chosen something, if their line types permit it."""

from __future__ import annotations

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import I64
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.edge_choice import LineTypeChoice


def chosen_rows(
    work: ChosenWork,
    choice: type[LineTypeChoice],
    dieline: Dieline,
    types: tuple[LineType, ...],
    code: str,
) -> I64:
    """Return the rows of the edges with a choice, ascending, (k,).

    Parameters
    ----------
    work, choice
        What is chosen for the edges, and the kind of choice in question.
    dieline
        The edges with their line types.
    types, code
        Line types that may have the choice, and the code of the error for others.

    Raises
    ------
    PlanError
        An edge of another line type has the choice.
    """
    if choice not in work:
        return np.zeros(0, np.int64)
    rows = np.flatnonzero(work[choice].chosen)
    others = rows[~np.isin(dieline.line_type[rows], types)]
    for edge in others[:1]:
        word = LineType(dieline.line_type[edge]).word
        raise PlanError(code, edge=edge, type=word, at_edges=others)
    return rows
