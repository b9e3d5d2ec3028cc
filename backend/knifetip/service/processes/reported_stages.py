"""The stages that a task in a worker process reports: their durations and their spans."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

from knifetip import tracing
from knifetip.model.stage import Stage


class ReportedStages:
    """Ends the stage before, and begins the next one, when a task reports it.

    Parameters
    ----------
    spans
        Holds the span of the present stage.
    observe
        Called with each stage that has ended, and its duration (s).
    """

    def __init__(self, spans: ExitStack, observe: Callable[[Stage, float], None]) -> None:
        self._spans = spans
        self._observe = observe
        self._last: Stage | None = None
        self._begun = 0.0

    def enter(self, stage: Stage) -> bool:
        """Begin a stage unless it is the present one; return whether it was begun."""
        if stage == self._last:
            return False
        now = time.monotonic()
        if self._last is not None:
            self._observe(self._last, now - self._begun)
        self._last, self._begun = stage, now
        self._spans.close()
        if stage is not Stage.DONE:
            self._spans.enter_context(tracing.span(stage.value))
        return True


@contextmanager
def reported_stages(
    observe: Callable[[Stage, float], None] = lambda _stage, _seconds: None,
) -> Iterator[ReportedStages]:
    """Return a context in which the stages of one task are recorded, in the thread of its caller.

    Parameters
    ----------
    observe
        Called with each stage that has ended, and its duration (s).
    """
    with ExitStack() as spans:
        yield ReportedStages(spans, observe)
