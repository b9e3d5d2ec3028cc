"""Findings: what the judge objects to, at most a thousand of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from knifetip.messages import Message
from knifetip.model.verdict import Finding

#: A program with more is wrong from end to end.
MAX_FINDINGS: Final = 1000


class Findings:
    """A list that remembers that something was found when it takes no more."""

    def __init__(self) -> None:
        self._kept: list[Finding] = []

    def add(
        self, kind: str, message: Message, measure: float, *, edge: int = -1, line: int = -1
    ) -> None:
        """Keep a finding, unless there are a thousand already."""
        if not self.full:
            self._kept.append(Finding(kind, message, float(measure), int(edge), int(line)))

    def program(self, faults: Iterable[tuple[int, Message]]) -> None:
        """Keep faults of lines of the program: (1-based line, what is wrong)."""
        for line, message in faults:
            self.add("program", message, 0.0, line=line)

    @property
    def full(self) -> bool:
        """Whether no more are kept."""
        return len(self._kept) >= MAX_FINDINGS

    def __len__(self) -> int:
        return len(self._kept)

    def sorted(self) -> tuple[Finding, ...]:
        """Return them in the order of the program, those about no line last."""
        return tuple(sorted(self._kept, key=lambda finding: (finding.line < 0, finding.line)))
