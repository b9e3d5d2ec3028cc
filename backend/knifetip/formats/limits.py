"""limits: sizes and times beyond which a file is refused."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from knifetip.errors import DrawingTooLarge

#: Largest coordinate that is accepted (mm; file units while the unit is unknown).
REACH: Final = 1e7


@dataclass(frozen=True, slots=True)
class Limits:
    """The most that one drawing may ask for; beyond it is DrawingTooLarge."""

    bytes: int = 64 * 2**20  #: of the file
    slow_bytes: int = 24 * 2**20  #: of a DXF that only ezdxf reads, in forty times its memory
    entities: int = 500_000  #: in the file, those of its blocks included
    expanded: int = 1_000_000  #: entities that the INSERTs stand for
    insert_depth: int = 16  #: blocks inside blocks
    segments: int = 1_000_000  #: lines and arcs of the drawing
    seconds: float = 120.0  #: for expanding and fitting

    def admit(self, size: int) -> None:
        """Raise DrawingTooLarge for a file that is too large to be examined.

        Raises
        ------
        DrawingTooLarge
        """
        if size > self.bytes:
            raise DrawingTooLarge("reading.too-large", size=size / 2**20, limit=self.bytes / 2**20)
