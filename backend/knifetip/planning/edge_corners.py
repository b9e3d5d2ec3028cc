"""edge_corners: give the corners of milled contours the types that the user has chosen for edges.

A corner has the type of the edge along which the tool arrives.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.geometry.path import segments_before
from knifetip.model.chosen_work import ChosenEdges, ChosenWork
from knifetip.model.corners import AS_OTHERS, TYPES
from knifetip.model.job_options import EdgeCorner
from knifetip.model.operation import Operation

#: Code of each word of a choice.
_CODES: Final = {"usual": AS_OTHERS, **{word: code for code, word in enumerate(TYPES)}}


def with_edge_corners(operation: Operation, work: ChosenWork) -> Operation:
    """Return the operation of a cutter with the corner types that are chosen for edges."""
    if EdgeCorner not in work or operation.side == 0:
        return operation
    chosen = work[EdgeCorner]
    arriving = operation.source[segments_before(operation.paths)]
    return replace(
        operation,
        corner_at=_types(chosen)[arriving],
        k_at=chosen.numbers("k", np.nan)[arriving],
    )


def _types(chosen: ChosenEdges) -> U8:
    """Return the code of the type that is chosen for each of n edges, (n,)."""
    codes = [_CODES[choice.type] for choice in chosen.choices if isinstance(choice, EdgeCorner)]
    result: U8 = np.array([*codes, AS_OTHERS], np.uint8)[chosen.index]
    return result
