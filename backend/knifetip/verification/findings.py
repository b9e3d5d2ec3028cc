"""The list that collects the findings of one verification."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from knifetip.messages import Message
from knifetip.model.verdict import Finding, Severity

#: Greatest number of findings of one severity that are kept.
MAX_FINDINGS: Final = 1000


class Findings:
    """A list of at most ``MAX_FINDINGS`` findings of each severity; later ones are dropped.

    Each severity is counted separately, so that a note never displaces a fault.
    """

    def __init__(self) -> None:
        self._kept: dict[Severity, list[Finding]] = {severity: [] for severity in Severity}

    def add(
        self,
        kind: str,
        message: Message,
        measure: float,
        *,
        edge: int = -1,
        line: int = -1,
        severity: Severity = Severity.FAULT,
    ) -> None:
        """Append a finding, unless ``MAX_FINDINGS`` of its severity are kept.

        Parameters
        ----------
        kind
            Kind of the finding, such as "uncut" or "depth".
        measure
            Measured value (mm; degrees for a heading).
        edge
            Index of the edge that the finding concerns, -1 for none.
        line
            1-based program line, -1 if the finding concerns no line.
        severity
            Whether the finding is a fault, a shortfall or a note.
        """
        self.extend([Finding(kind, message, float(measure), int(edge), int(line), severity)])

    def extend(self, findings: Iterable[Finding]) -> None:
        """Append findings, each unless ``MAX_FINDINGS`` of its severity are kept."""
        for finding in findings:
            kept = self._kept[finding.severity]
            if len(kept) < MAX_FINDINGS:
                kept.append(finding)

    def add_faults(self, faults: Iterable[tuple[int, Message]]) -> None:
        """Append a finding of kind "program" for each fault of a program, until the list contains
        ``MAX_FINDINGS`` faults.

        A fault is a 1-based program line and a message.
        """
        for line, message in faults:
            self.add("program", message, 0.0, line=line)

    @property
    def full(self) -> bool:
        """Return whether the list contains ``MAX_FINDINGS`` faults, so that later ones are
        dropped.
        """
        return len(self._kept[Severity.FAULT]) >= MAX_FINDINGS

    def __len__(self) -> int:
        return sum(len(kept) for kept in self._kept.values())

    def sorted(self) -> tuple[Finding, ...]:
        """Return the faults, then the shortfalls, then the notes; each sorted by program line, with
        findings without a program line last.
        """
        return tuple(
            finding
            for kept in self._kept.values()
            for finding in sorted(kept, key=lambda finding: (finding.line < 0, finding.line))
        )
