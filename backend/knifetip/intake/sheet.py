"""sheet: the ledger while it is being written."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.model.drawing import Standing


class Alike(NamedTuple):
    """Rows of which the same is said."""

    rows: I64
    dropped: str  #: why they are left out, empty for those that are drawn
    notes: Sequence[str] = ()  #: what was done to them


@dataclass(slots=True)
class Written:
    """One row for every entity; what is said of some rows stands beside the columns.

    A row that is ``alike`` others may have notes of its own, which follow.
    """

    handle: Sequence[str] = field(default_factory=list)
    kind: Sequence[str] = field(default_factory=list)
    layer: Sequence[str] = field(default_factory=list)
    dropped: dict[int, str] = field(default_factory=dict)  #: row -> why it is left out
    notes: dict[int, list[str]] = field(default_factory=dict)  #: row -> what was done to it
    alike: list[Alike] = field(default_factory=list)  #: no row is in two of them
    standing: list[Standing] = field(default_factory=list)  #: in file units, NaN where unknown


@dataclass(slots=True)
class Sheet(Written):
    """A ledger that is written row by row."""

    handle: list[str] = field(default_factory=list)
    kind: list[str] = field(default_factory=list)
    layer: list[str] = field(default_factory=list)

    def row(
        self, handle: str, kind: str, layer: str, dropped: str = "", notes: Iterable[str] = ()
    ) -> int:
        """Add a row to the ledger and return its number."""
        self.handle.append(handle)
        self.kind.append(kind)
        self.layer.append(layer)
        number = len(self.handle) - 1
        if dropped:
            self.dropped[number] = dropped
        if said := list(notes):
            self.notes[number] = said
        return number

    def stands(self, row: int, box: Sequence[float] | F64) -> None:
        """Say where a row stands of which no line is made: x min, y min, x max, y max."""
        self.standing.append(Standing(np.array([row], np.int32), np.array([box], np.float64)))
