"""The list that collects the findings of one verification, at most a thousand."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from knifetip.messages import Message
from knifetip.model.verdict import Finding

#: Greatest number of findings that are kept.
MAX_FINDINGS: Final = 1000


class Findings:
    """A list of at most ``MAX_FINDINGS`` findings; later findings are dropped."""

    def __init__(self) -> None:
        self._kept: list[Finding] = []

    def add(
        self, kind: str, message: Message, measure: float, *, edge: int = -1, line: int = -1
    ) -> None:
        """Append a finding, unless the list is full.

        Parameters
        ----------
        kind, message
            Kind of the finding, such as "depth", and its text.
        measure
            Size of the fault, in the unit of the kind of finding, such as mm or degrees.
        edge
            Row of the edge in the dieline, -1 if the finding concerns no edge.
        line
            1-based program line, -1 if the finding concerns no line.
        """
        if not self.full:
            self._kept.append(Finding(kind, message, float(measure), int(edge), int(line)))

    def add_faults(self, faults: Iterable[tuple[int, Message]]) -> None:
        """Append a finding of kind "program" for each fault of a program, until the list is full.

        A fault is a 1-based program line and a message.
        """
        for line, message in faults:
            self.add("program", message, 0.0, line=line)

    @property
    def full(self) -> bool:
        """Return whether the list contains ``MAX_FINDINGS`` findings, so that later ones are
        dropped.
        """
        return len(self._kept) >= MAX_FINDINGS

    def __len__(self) -> int:
        return len(self._kept)

    def sorted(self) -> tuple[Finding, ...]:
        """Return the findings sorted by program line; findings without a program line come last."""
        return tuple(sorted(self._kept, key=lambda finding: (finding.line < 0, finding.line)))
