"""The type of the ``knifetip`` fixture."""

from __future__ import annotations

from typing import Protocol


class Command(Protocol):
    """A function that runs the ``knifetip`` command in this process."""

    def __call__(self, *words: object) -> tuple[int, str, str]:
        """Run ``knifetip`` with command line arguments; return exit code, stdout and stderr."""
        ...
