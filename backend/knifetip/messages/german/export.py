"""export: German texts of the messages of ``catalogue.export``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "export.too-large": Text(
        "{count:,} Linien und Bögen sind zu viele für eine Datei im Format {format}; höchstens "
        "{limit:,} werden geschrieben",
        "svg wählen, das die meisten zulässt.",
    ),
}
