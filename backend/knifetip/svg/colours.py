"""colours: parse a CSS paint (the value of "stroke" or "fill") into a true colour.

For example, "#e02020" and "rgb(224, 32, 32)" give 0xE02020.
"""

from __future__ import annotations

from functools import lru_cache

import tinycss2
from tinycss2 import color4

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, VISIBLE


@lru_cache(maxsize=4096)
def parse_paint(text: str, current: int | None = 0) -> int | None:
    """Return the colour of a CSS paint: 0xRRGGBB, ``UNKNOWN_COLOUR``, or None for no paint.

    Parameters
    ----------
    text
        Value of "stroke" or "fill", for example "rgb(224, 32, 32)".
    current
        Colour that the keyword ``currentColor`` refers to, 0xRRGGBB; None for no paint.

    Raises
    ------
    ValueError
        The text is not a paint.  The caller must then use the inherited value of the property.
    """
    tokens = [
        token
        for token in tinycss2.parse_component_value_list(text, skip_comments=True)
        if token.type != "whitespace"
    ]
    if tokens and (tokens[0].type == "url" or getattr(tokens[0], "lower_name", "") == "url"):
        # A reference to a pattern or gradient may be followed by a fallback colour.
        tokens = tokens[1:]
        if not tokens:
            return UNKNOWN_COLOUR
    if not tokens:
        raise ValueError(f"{text[:30]!r} is not a colour")
    word = tokens[0].lower_value if tokens[0].type == "ident" else ""
    if word == "none":
        return None
    if word.startswith("context-"):
        return UNKNOWN_COLOUR
    # An ICC colour may follow the colour that replaces it.
    colour = color4.parse_color(tokens[0])
    if colour == "currentcolor":
        return current
    if colour is None:
        raise ValueError(f"{text[:30]!r} is not a colour")
    if colour.alpha < VISIBLE:
        return None
    try:
        shares = colour.to("srgb").coordinates
    except NotImplementedError:
        # A colour space that tinycss2 cannot convert.
        return UNKNOWN_COLOUR
    red, green, blue = (int(255.0 * min(max(share, 0.0), 1.0) + 0.5) for share in shares)
    return red << 16 | green << 8 | blue
