"""Limits of file size, number of entities and reading time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from knifetip.errors import DrawingTooLarge

#: Largest coordinate that is accepted (mm; file units while the unit is unknown).
REACH: Final = 1e7


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of the size and the reading time of a drawing.

    A reader raises DrawingTooLarge if a limit is exceeded.
    """

    bytes: int = 64 * 2**20  #: size of the file
    slow_bytes: int = 24 * 2**20  #: size of a DXF that needs ezdxf, which uses 40 times the memory
    entities: int = 500_000  #: entities in the file, including those in blocks
    expanded: int = 1_000_000  #: entities after block references are expanded
    insert_depth: int = 16  #: depth of nested blocks
    operators: int = 4_000_000  #: drawing commands of a PDF page, with all copies of its forms
    segments: int = 1_000_000  #: lines and arcs of the drawing
    seconds: float = 120.0  #: time for expanding blocks and fitting curves (s)

    def admit(self, size: int) -> None:
        """Raise DrawingTooLarge if ``size``, the size of a file in bytes, exceeds the limit."""
        if size > self.bytes:
            raise DrawingTooLarge("reading.too-large", size=size / 2**20, limit=self.bytes / 2**20)
