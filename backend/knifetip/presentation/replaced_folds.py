"""Warnings about folds that are not made, because a cut lies on the same line."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType

#: Line types that fold the board, in the order of the warnings.
_FOLDS: Final = (LineType.CREASE, LineType.V_GROOVE, LineType.HALF_CUT, LineType.PERFORATION)
#: Least length of an edge on cuts that is a warning (mm): folds may end a few mm inside slots.
_LEAST: Final = 10.0


def replaced_fold_warnings(dieline: Dieline, cleaned: Cleaned, lengths: F64) -> tuple[Message, ...]:
    """Return one warning for each line type of folds on whose edges cuts are made instead.

    Parameters
    ----------
    dieline
        The n edges of the drawing with their line types, before cleaning.
    cleaned
        The result of cleaning the dieline.
    lengths : (n,)
        Lengths of the edges (mm).
    """
    parts = cleaned.stretches
    rows = np.flatnonzero(parts.by_other_edge & (parts.cleaned >= 0))
    rows = rows[cleaned.dieline.line_type[parts.cleaned[rows]] == LineType.CUT]
    edge = parts.row[rows]
    on_cuts = np.bincount(
        edge, (parts.end - parts.begin)[rows] * lengths[edge], minlength=len(dieline)
    )
    is_replaced = on_cuts >= _LEAST
    return tuple(
        Message(
            "cleaning.folds-on-cuts",
            count=int(np.count_nonzero(of_type)),
            type=kind.word,
            length=float(on_cuts[of_type].sum()),
        )
        for kind in _FOLDS
        if (of_type := is_replaced & (dieline.line_type == kind)).any()
    )
