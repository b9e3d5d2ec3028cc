"""Findings: what the judge objects to, in the user's words, at most a thousand of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from knifetip.model.verdict import Finding

#: A program with more is wrong from end to end: nobody reads on.
MOST: Final = 1000


class Findings:
    """A list that remembers that something was found when it takes no more."""

    def __init__(self) -> None:
        self._kept: list[Finding] = []

    def add(self, kind: str, text: str, measure: float, *, edge: int = -1, line: int = -1) -> None:
        """Keep a finding, unless there are a thousand already."""
        if not self.full:
            self._kept.append(Finding(kind, text, float(measure), int(edge), int(line)))

    def program(self, faults: Iterable[tuple[int, str]]) -> None:
        """Keep what is wrong with lines of the text: (line, words)."""
        for line, text in faults:
            self.add("program", f"Line {line}: {text}", 0.0, line=line)

    @property
    def full(self) -> bool:
        """Whether no more are kept."""
        return len(self._kept) >= MOST

    def __len__(self) -> int:
        return len(self._kept)

    def sorted(self) -> tuple[Finding, ...]:
        """Return them in the order of the program, those about no line last."""
        return tuple(sorted(self._kept, key=lambda finding: (finding.line < 0, finding.line)))
