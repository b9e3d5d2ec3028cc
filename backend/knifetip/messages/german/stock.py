"""stock: German texts of the messages of ``catalogue.stock``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "stock.too-many": Text(
        "im Vorrat sind schon {limit} Größen von Bogen",
        "Größen löschen, die aufgebraucht sind.",
    ),
    "stock.unknown": Text(
        "im Vorrat gibt es keine Bogen {id}",
        "GET /api/stock-sheets nennt sie; vielleicht sind sie aufgebraucht.",
    ),
}
