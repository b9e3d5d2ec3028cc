"""The texts of an SVG as annotations of the drawing."""

from __future__ import annotations

import math

from knifetip.formats.invalid_content import InvalidContent
from knifetip.geometry.affine import Matrix
from knifetip.model.drawing import Annotation
from knifetip.svg.document import Node
from knifetip.svg.lengths import to_pixels
from knifetip.svg.shapes import Window
from knifetip.svg.style import Appearance, Cascade


def text_annotation(
    node: Node, layer: str, matrix: Matrix, window: Window, appearance: Appearance, cascade: Cascade
) -> Annotation | None:
    """Return a text element as an annotation in file units.

    A coordinate without a valid attribute x or y is 0.  The result is None if the text is empty, or
    if its position or height is not finite.

    Parameters
    ----------
    node, layer
        The ``text`` element, and the name of its layer.
    matrix
        Matrix from the coordinates of the element to file units.
    window
        Lengths to which percentages in the element refer.
    appearance
        Appearance of the element, with its font size.
    cascade
        Used if ``node`` has no attribute x but a child has: position and height of the text are
        then taken from the first such child, and ``cascade`` computes the font size of this child.
    """
    text = " ".join(text_content(node).split())
    first = next((one for one in (node, *node.children) if "x" in one.attributes), node)
    try:
        x, y = (
            to_pixels(_first_length(first.attributes.get(name, "0")), full_length)
            for name, full_length in (("x", window[0]), ("y", window[1]))
        )
    except InvalidContent:
        x = y = 0.0
    a, b, c, d, e, f = matrix
    if first is not node:
        appearance = cascade.appearance(first, appearance)
    position = a * x + c * y + e, b * x + d * y + f
    height = appearance.font_size * math.sqrt(abs(a * d - b * c))
    if not text or not all(math.isfinite(value) for value in (*position, height)):
        return None
    return Annotation(text, *position, height, math.nan, node.tag, layer)


def text_content(node: Node) -> str:
    """Return the text of an element and of all its descendants."""
    parts = []
    stack = [node]
    while stack:
        one = stack.pop()
        parts.append(one.text)
        stack += reversed(one.children)
    return "".join(parts)


def _first_length(text: str) -> str:
    """Return the first position in the attribute ``x`` or ``y`` of a text element, "0" if none.

    ``text`` is the value of the attribute, which may contain one position per character.
    """
    parts = text.replace(",", " ").split()
    return parts[0] if parts else "0"
