"""pages: the pages of a file as JSON data, with which a user chooses one of them."""

from __future__ import annotations

from typing import Any

from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing
from knifetip.presentation.picture import svg_outline


def page_json(number: int, page: Drawing | KnifetipError) -> dict[str, Any]:
    """Return the fields of the schema ``PageOut`` of a page.

    Parameters
    ----------
    number
        Number of the page in the file, from 1.
    page
        The drawing on the page, or the reason why there is none.
    """
    if isinstance(page, KnifetipError):
        fields = {"edges": 0, "width": 0.0, "height": 0.0, "picture": ""}
        return {"page": number, **fields, "problem": page.message.as_json()}
    low_x, low_y, high_x, high_y = page.bounds.tolist() if len(page) else (0.0,) * 4
    return {
        "page": number,
        "edges": len(page),
        "width": high_x - low_x,
        "height": high_y - low_y,
        "picture": svg_outline(page),
        "problem": None,
    }
