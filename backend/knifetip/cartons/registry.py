"""registry: all carton styles by their codes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.cartons import folding_cartons, mailers, slotted, trays
from knifetip.cartons.style import Style
from knifetip.errors import LibraryError

_STYLES: Final = (*slotted.STYLES, *folding_cartons.STYLES, *mailers.STYLES, *trays.STYLES)

#: Every style by its code, in the order of lists.
STYLES: Final[Mapping[str, Style]] = {style.code: style for style in _STYLES}


def style_of(code: str) -> Style:
    """Return the style with a code; raise ``LibraryError`` if there is none."""
    try:
        return STYLES[code]
    except KeyError:
        raise LibraryError(
            "library.unknown", shelf="carton", name=code, known=sorted(STYLES)
        ) from None
