"""Collect the findings of one verification, at most a thousand."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from knifetip.messages import Message
from knifetip.model.verdict import Finding

#: Greatest number of findings that are kept.
MAX_FINDINGS: Final = 1000


class Findings:
    """A list of findings with a limit; further findings are dropped."""

    def __init__(self) -> None:
        self._kept: list[Finding] = []

    def add(
        self, kind: str, message: Message, measure: float, *, edge: int = -1, line: int = -1
    ) -> None:
        """Append a finding, unless the list is full."""
        if not self.full:
            self._kept.append(Finding(kind, message, float(measure), int(edge), int(line)))

    def program(self, faults: Iterable[tuple[int, Message]]) -> None:
        """Append faults of lines of the program: (1-based line, message)."""
        for line, message in faults:
            self.add("program", message, 0.0, line=line)

    @property
    def full(self) -> bool:
        """True if further findings are dropped."""
        return len(self._kept) >= MAX_FINDINGS

    def __len__(self) -> int:
        return len(self._kept)

    def sorted(self) -> tuple[Finding, ...]:
        """Return the findings in order of lines; findings without a line come last."""
        return tuple(sorted(self._kept, key=lambda finding: (finding.line < 0, finding.line)))
