"""archive: a layout and the edges of its drawings in one file, from which the sheet is composed.

The file is a ZIP file with ``layout.json`` and, for each drawing, its stored edges.  It contains
all that a compile needs, so that a layout does not change with its drawings.
"""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from knifetip.model.layout import Layout

_LAYOUT: Final = "layout.json"
#: The same for each file, so that equal layouts are equal files.
_TIME: Final = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class LayoutArchive:
    """A layout with the edges of its drawings."""

    layout: Layout
    edges: tuple[bytes, ...]  #: packed edges of each drawing, each drawing once
    source_of: tuple[int, ...]  #: index into ``edges`` for each entry of ``layout.placed``

    @classmethod
    def from_layout(cls, layout: Layout, edges: Sequence[tuple[str, bytes]]) -> LayoutArchive:
        """Return the archive of a layout.

        Parameters
        ----------
        layout
            The layout.
        edges
            Id and packed edges of each drawing that the layout contains.
        """
        index = {id: number for number, (id, _) in enumerate(edges)}
        return cls(
            layout,
            tuple(block for _, block in edges),
            tuple(index[placed.drawing] for placed in layout.placed),
        )

    def pack(self) -> bytes:
        """Return the archive as a file."""
        stream = io.BytesIO()
        facts = {"layout": self.layout.model_dump(mode="json"), "source_of": self.source_of}
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr(zipfile.ZipInfo(_LAYOUT, _TIME), json.dumps(facts))
            for number, block in enumerate(self.edges):
                file.writestr(zipfile.ZipInfo(f"{number}.edges", _TIME), block)
        return stream.getvalue()

    @classmethod
    def unpack(cls, content: bytes) -> LayoutArchive:
        """Return the archive that ``pack`` wrote to a file."""
        with zipfile.ZipFile(io.BytesIO(content)) as file:
            facts = json.loads(file.read(_LAYOUT))
            count = len(file.namelist()) - 1
            return cls(
                Layout.model_validate(facts["layout"]),
                tuple(file.read(f"{number}.edges") for number in range(count)),
                tuple(facts["source_of"]),
            )
