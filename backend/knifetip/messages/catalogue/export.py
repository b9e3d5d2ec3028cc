"""export: messages about drawings and tool paths that are written for other programs."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "export.too-large": entry(
        "{count:,} lines and arcs are too many for a file in the format {format}; at most "
        "{limit:,} are written",
        "Choose svg, which takes the most.",
        count="count",
        limit="count",
        format="text",
    ),
}
