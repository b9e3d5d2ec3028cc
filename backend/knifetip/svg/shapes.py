"""shapes: convert basic shapes to path data, so that all shapes of an SVG can be read as paths.

For example, ``<rect width="90" height="45"/>`` becomes the closed path with the corners (0, 0),
(90, 0), (90, 45) and (0, 45).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from knifetip.formats.invalid_content import InvalidContent
from knifetip.messages import Message
from knifetip.svg.document import Node
from knifetip.svg.lengths import to_pixels


class Undrawable(Exception):
    """Raised for an SVG element that gives no edge; ``svg.expand`` catches it.

    The message of the exception becomes the reason in the element's row of the import report.
    """

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message


#: The lengths that percentages refer to: width and height of the window, and its diagonal / √2.
Window = tuple[float, float, float]


def shape_path_data(node: Node, window: Window) -> str:
    """Return the path data of a shape: an element whose tag is a key of ``SHAPES``.

    ``window`` contains the lengths to which percentages in the attributes of the element refer.

    Raises
    ------
    Undrawable
        The element has no size, or an attribute is missing or invalid.
    """
    return SHAPES[node.tag](node, window)


def frame_path_data(node: Node, window: Window) -> str:
    """Return the path data of the diagonal of the rectangle of an element such as an image.

    The rectangle is given by the attributes x, y, width and height of the element, which has no
    path.  The import report shows it as the location of the element.  ``window`` contains the
    lengths to which percentages in these attributes refer.
    """
    wide, high = _size(node, "width", window[0]), _size(node, "height", window[1])
    return f"{point_path_data(node, window)}l{wide!r} {high!r}"


def point_path_data(node: Node, window: Window) -> str:
    """Return path data of a line of zero length at the position (x, y) of an element.

    The import report shows this position as the location of a ``use`` element that cannot be
    copied.  ``window`` contains the lengths to which percentages in the attributes x and y refer.
    """
    return f"M{_size(node, 'x', window[0])!r} {_size(node, 'y', window[1])!r}l0 0"


def _size(node: Node, name: str, full_length: float, default: float = 0.0) -> float:
    text = node.attributes.get(name)
    if text is None:
        return default
    try:
        return to_pixels(text, full_length)
    except InvalidContent as invalid:
        raise Undrawable(Message("import.bad-size", name=name, reason=invalid.message)) from None


def _path(node: Node, _window: Window) -> str:
    text = node.attributes.get("d", "")
    if not text.strip() or text.strip() == "none":
        raise Undrawable(Message("import.empty-path"))
    return text


def _line(node: Node, window: Window) -> str:
    x1, x2 = (_size(node, name, window[0]) for name in ("x1", "x2"))
    y1, y2 = (_size(node, name, window[1]) for name in ("y1", "y2"))
    return f"M{x1!r} {y1!r}L{x2!r} {y2!r}"


def _polyline(node: Node, _window: Window) -> str:
    points = node.attributes.get("points", "")
    if not points.strip():
        raise Undrawable(Message("import.no-points"))
    if points.lstrip(" \t\r\n,")[:1].isalpha():
        raise Undrawable(Message("import.bad-points", points=points.strip()[:30]))
    return "M" + points


def _polygon(node: Node, window: Window) -> str:
    return _polyline(node, window) + "Z"


def _rect(node: Node, window: Window) -> str:
    x, y = _size(node, "x", window[0]), _size(node, "y", window[1])
    wide, high = _size(node, "width", window[0]), _size(node, "height", window[1])
    if not (wide > 0.0 and high > 0.0):
        raise Undrawable(Message("import.no-size", width=wide, height=high))
    attributes = node.attributes
    rx, ry = (
        None if attributes.get(name, "auto") == "auto" else _size(node, name, full_length)
        for name, full_length in (("rx", window[0]), ("ry", window[1]))
    )
    rx_ = min(max((rx if rx is not None else ry) or 0.0, 0.0), wide / 2.0)
    down = min(max((ry if ry is not None else rx) or 0.0, 0.0), high / 2.0)
    right, low = x + wide, y + high
    if not (rx_ > 0.0 and down > 0.0):
        return f"M{x!r} {y!r}H{right!r}V{low!r}H{x!r}Z"
    bend = f"A{rx_!r} {down!r} 0 0 1 "
    return (
        f"M{x + rx_!r} {y!r}H{right - rx_!r}{bend}{right!r} {y + down!r}V{low - down!r}"
        f"{bend}{right - rx_!r} {low!r}H{x + rx_!r}{bend}{x!r} {low - down!r}"
        f"V{y + down!r}{bend}{x + rx_!r} {y!r}"
    )


def _circle(node: Node, window: Window) -> str:
    radius = _size(node, "r", window[2])
    return _round(node, window, radius, radius)


def _ellipse(node: Node, window: Window) -> str:
    attributes = node.attributes
    rx, ry = (
        None if attributes.get(name, "auto") == "auto" else _size(node, name, full_length)
        for name, full_length in (("rx", window[0]), ("ry", window[1]))
    )
    rx_ = rx if rx is not None else ry
    down = ry if ry is not None else rx
    return _round(node, window, rx_ or 0.0, down or 0.0)


def _round(node: Node, window: Window, radius_x: float, radius_y: float) -> str:
    if not (radius_x > 0.0 and radius_y > 0.0):
        raise Undrawable(Message("import.bad-radius", radius=min(radius_x, radius_y)))
    x, y = _size(node, "cx", window[0]), _size(node, "cy", window[1])
    half = f"A{radius_x!r} {radius_y!r} 0 0 1 "
    return f"M{x + radius_x!r} {y!r}{half}{x - radius_x!r} {y!r}{half}{x + radius_x!r} {y!r}"


#: Elements that give lines, and the function that returns their path data.
SHAPES: Final[dict[str, Callable[[Node, Window], str]]] = {
    "path": _path,
    "line": _line,
    "polyline": _polyline,
    "polygon": _polygon,
    "rect": _rect,
    "circle": _circle,
    "ellipse": _ellipse,
}
