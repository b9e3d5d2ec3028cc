"""The type of the ``knifetip`` fixture."""

from __future__ import annotations

from typing import Protocol


class Command(Protocol):
    """Runs the command line in this process."""

    def __call__(self, *words: object) -> tuple[int, str, str]:
        """Return exit code, stdout and stderr of ``knifetip WORDS…``."""
        ...
