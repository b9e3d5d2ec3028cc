"""Tests of one rule for all pairs of two lists, of which `make test` runs a sample."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import pytest


def in_turn(rows: Iterable[str], columns: Sequence[Any]) -> list[Any]:
    """Return the parameters of a test of all pairs, most of which are marked as ``long``.

    `make test` runs each row with one column, in turn, so each row and each column.

    Parameters
    ----------
    rows
        Values of the first argument.
    columns
        Values of the second argument, of which there are no more than rows.
    """
    return [
        pytest.param(
            row, column, id=f"{row}-{j}", marks=() if j == i % len(columns) else pytest.mark.long
        )
        for i, row in enumerate(rows)
        for j, column in enumerate(columns)
    ]
