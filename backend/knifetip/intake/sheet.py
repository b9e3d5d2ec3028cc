"""sheet: the ledger while it is being written."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field


@dataclass(slots=True)
class Sheet:
    """One row for every entity; what is said of few rows stands beside the columns."""

    handle: list[str] = field(default_factory=list)
    kind: list[str] = field(default_factory=list)
    layer: list[str] = field(default_factory=list)
    dropped: dict[int, str] = field(default_factory=dict)  #: row -> why it is left out
    notes: dict[int, list[str]] = field(default_factory=dict)  #: row -> what was done to it

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
