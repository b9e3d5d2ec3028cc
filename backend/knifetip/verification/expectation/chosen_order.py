"""The order in which the user wants edges to be made, as rows of the edges that are made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from knifetip.model.cleaned import Cleaned
from knifetip.verification.columns import I64


class ExpectedPlace(NamedTuple):
    """One edge of a chosen order."""

    row: int  #: row of the edge that makes most of the chosen one, for findings; -1 for none
    rows: I64  #: (k,) rows of all edges that make the chosen one


#: The chosen edges in the order in which they must be begun.
ExpectedOrder: TypeAlias = Sequence[ExpectedPlace]


def expected_order(edges: Sequence[int], cleaned: Cleaned) -> ExpectedOrder:
    """Return what a chosen order requires of a program.

    Parameters
    ----------
    edges
        Rows of edges in the drawing, in the chosen order; of an edge that is named twice the first
        place counts.
    cleaned
        The edges that are made for those of the drawing.
    """
    parts = cleaned.stretches
    making: dict[int, set[int]] = {row: set() for row in edges}
    named = np.flatnonzero(np.isin(parts.row, list(making)) & (parts.cleaned >= 0))
    for row, made in zip(parts.row[named].tolist(), parts.cleaned[named].tolist(), strict=True):
        making[row].add(made)
    return [
        ExpectedPlace(int(cleaned.cleaned_row[row]), np.array(sorted(made), np.int64))
        for row, made in making.items()
        if made
    ]
