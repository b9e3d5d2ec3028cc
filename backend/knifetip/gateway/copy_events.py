"""Events in the span of a copy: tenths of its lines, holds, and where it ended (ADR 97)."""

from __future__ import annotations

from typing import Final

from knifetip.gateway.stream import Progress
from knifetip.tracing import Span

_PARTS: Final = 10


class CopyEvents:
    """Records the progress of a copy in its span.

    Parameters
    ----------
    span
        Span of the copy.
    """

    def __init__(self, span: Span) -> None:
        self._span = span
        self._part = 0
        self._held = False

    def update(self, progress: Progress) -> None:
        """Record an event if a progress report begins a new tenth, a hold or the end of a hold."""
        line = progress.executed
        held = progress.held
        if held != self._held:
            self._held = held
            self._span.event("held" if held else "resumed", line=line)
        part = _PARTS * line // max(progress.lines, 1)
        if part != self._part:
            self._part = part
            self._span.event("lines executed", line=line)
        self._span.set(line=line)
