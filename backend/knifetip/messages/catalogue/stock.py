"""stock: messages about sheets in stock."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "stock.too-many": entry(
        "the stock has {limit} sizes of sheets already",
        "Delete sizes that are used up.",
        limit="count",
    ),
    "stock.unknown": entry(
        "there are no sheets {id} in stock",
        "GET /api/stock-sheets lists them; they may have been used up.",
        id="text",
    ),
}
