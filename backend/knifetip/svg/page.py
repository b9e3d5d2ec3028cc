"""page: find the physical size of an SVG.

``read_page`` returns the unit, and a matrix with y upwards, from the attributes ``width``,
``height`` and ``viewBox`` of the root element.

The physical units mm, cm, in, pt, pc and Q define the size.  Numbers without a unit and numbers in
px do so only if the program that wrote the file is known: browsers and Inkscape use 96 pixels per
inch, Illustrator 72, and older versions of Inkscape 90.

Source: Scalable Vector Graphics (SVG) 1.1, second edition, chapters 7.7 and 7.8.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from knifetip.drawing_builder.clip import UNBOUNDED, Box
from knifetip.geometry.affine import Matrix
from knifetip.messages import Message
from knifetip.model.unit import MILLIMETRES, UnitHint
from knifetip.svg.document import Node
from knifetip.svg.lengths import parse_length
from knifetip.svg.transform import parse_numbers

#: For each physical unit: the unit of the drawing, its number in one physical unit, and its mm.
_PHYSICAL: Final = {
    "mm": ("mm", 1.0, 1.0),
    "cm": ("cm", 1.0, 10.0),
    "in": ("in", 1.0, 25.4),
    "pt": ("pt", 1.0, MILLIMETRES["pt"]),
    "pc": ("pt", 12.0, MILLIMETRES["pt"]),
    "q": ("mm", 0.25, 1.0),
}
#: Scales of width and height that differ by less are equal.
_SAME_ASPECT: Final = 0.005
#: Fraction of the free space before the content, by the words of ``preserveAspectRatio``.
_ALIGN: Final = {"min": 0.0, "mid": 0.5, "max": 1.0}


@dataclass(frozen=True, slots=True)
class Page:
    """The unit of an SVG page, and the matrix from its coordinates to file units."""

    matrix: Matrix  #: from the root's coordinates to file units, y upwards
    scale: float  #: millimetres in one file unit, 0 if unknown
    unit: str  #: empty if unknown
    evidence: Message
    stated_unit: str  #: the unit that the file states
    hints: tuple[UnitHint, ...] = ()  #: other settings that depend on the unit
    visible: Box = UNBOUNDED  #: visible area (file units)
    warnings: tuple[Message, ...] = ()  #: contradictions about the size of the page
    pixel: float = 1.0  #: file units in one pixel of the displayed page


def read_page(root: Node, unit: str, millimetres_per_unit: float, pixel: str) -> Page:
    """Return the unit of an SVG and the matrix of its page, from the root element.

    Parameters
    ----------
    root
        Root element of the SVG.
    unit
        The unit that the user gives, "" if the user gives none.  If the size of the page is known,
        its unit is replaced and the number is kept: "90mm" is read as 90 inches if ``unit`` is
        "in".  Otherwise one unit of the coordinates in the file has the length ``unit``.
    millimetres_per_unit
        Number of millimetres in ``unit``, 0 if the user gives no unit.
    pixel
        The unit in which the program that wrote the file writes pixels, such as "pt" or "px-90";
        empty if it is not known.
    """
    box = view_box(root)
    wide, high = (_side_length(root, name) for name in ("width", "height"))
    physical = next((side for side in (wide, high) if side and side[1] in _PHYSICAL), None)
    names = [name for name, side in (("width", wide), ("height", high)) if side]
    written = _written_size(root, names)
    if physical is None and not pixel:
        return _unscaled_page(root, unit, millimetres_per_unit)
    if physical is not None:
        file_unit, _, millimetres = _PHYSICAL[physical[1]]
    else:
        file_unit, millimetres = pixel, MILLIMETRES[pixel]
    pixel_length = MILLIMETRES[pixel or "px"]
    width, height = (_side_in_unit(side, millimetres, pixel_length) for side in (wide, high))
    if box is None:
        size = pixel_length / millimetres
        matrix = (size, 0.0, 0.0, -size, 0.0, height or 0.0)
        visible = _page_box(width, height)
        evidence = Message("unit.svg-size-in-pixels", size=written, pixel=pixel or "px")
    else:
        matrix = _flipped_matrix(view_box_matrix(box, width, height, root), box, width, height)
        visible = _page_box(
            width or (height * box[2] / box[3] if height else box[2]),
            height or (width * box[3] / box[2] if width else box[3]),
        )
        evidence = Message("unit.svg-size", size=written, width=box[2], height=box[3])
    if physical is None:
        evidence = Message("unit.svg-writer", pixel=pixel)
    source = Message("unit.given") if unit else evidence
    return Page(
        matrix,
        millimetres_per_unit or millimetres,
        unit or file_unit,
        source,
        file_unit,
        visible=visible,
        warnings=_aspect_warnings(root, box, width, height, written),
        pixel=pixel_length / millimetres,
    )


def _unscaled_page(root: Node, unit: str, millimetres_per_unit: float) -> Page:
    """Return a page of unknown size, in units of the coordinates of the file.

    The parameters are those of ``read_page``.
    """
    box = view_box(root)
    width, height = (
        None if side is None else side[0]
        for side in (_side_length(root, name) for name in ("width", "height"))
    )
    top = box[1] + box[3] if box else height or 0.0
    visible = _page_box(width, height)
    pixel = 1.0
    if box is not None:
        x_scale, _, _, y_scale, left, above = view_box_matrix(box, width, height, root)
        visible = (
            -left / x_scale,
            top - ((height or y_scale * box[3]) - above) / y_scale,
            ((width or x_scale * box[2]) - left) / x_scale,
            top + above / y_scale,
        )
        pixel = 1.0 / x_scale
    return Page(
        (1.0, 0.0, 0.0, -1.0, 0.0, top),
        millimetres_per_unit,
        unit,
        Message("unit.given") if unit else _unknown_unit(root),
        "",
        (UnitHint("pixels", Message("unit.page-in-pixels")),),
        visible,
        pixel=pixel,
    )


def _page_box(width: float | None, height: float | None) -> Box:
    """Return the visible area of a page; it is not limited where a side is not known."""
    return (
        0.0 if width else -math.inf,
        0.0 if height else -math.inf,
        width or math.inf,
        height or math.inf,
    )


def _aspect_warnings(
    root: Node,
    box: tuple[float, float, float, float] | None,
    width: float | None,
    height: float | None,
    written: list[str],
) -> tuple[Message, ...]:
    """Return a warning if width and height of the page scale the viewBox differently.

    ``root``, ``box``: root element of the SVG, and its viewBox.
    ``width``, ``height``: size of the page (file units).
    ``written``: size of the page as in the file.
    """
    if box is None or not width or not height:
        return ()
    across, down = width / box[2], height / box[3]
    if abs(across / down - 1.0) <= _SAME_ASPECT:
        return ()
    used, _, _, used_down, *_ = view_box_matrix(box, width, height, root)
    if used != used_down:
        # preserveAspectRatio="none" asks for two scales.
        return ()
    return (
        Message(
            "import.aspect-ratio",
            size=written,
            width=box[2],
            height=box[3],
            across=across,
            down=down,
            used=used,
        ),
    )


def view_box(node: Node) -> tuple[float, float, float, float] | None:
    """Return x, y, width and height of the viewBox of an element: the visible area of its content.

    None is returned if the element has no viewBox or an invalid one.
    """
    try:
        x, y, width, height = parse_numbers(node.attributes.get("viewBox", ""))
    except ValueError:
        return None
    return (x, y, width, height) if width > 0.0 and height > 0.0 else None


def view_box_matrix(
    box: tuple[float, float, float, float],
    window_width: float | None,
    window_height: float | None,
    node: Node,
) -> Matrix:
    """Return the matrix that fits a viewBox into a rectangle with its upper left corner at (0, 0).

    The rectangle is the page, or the window of an ``svg`` or ``symbol`` element inside it.  The
    matrix maps the coordinates of the viewBox to the coordinates of the rectangle.

    Parameters
    ----------
    box
        x, y, width and height of the viewBox.
    window_width, window_height
        Width and height of the rectangle; None if the file does not state them.  If one is None,
        the other gives the scale of both axes; if both are None, the scale is 1.
    node
        The element whose attribute ``preserveAspectRatio`` is used.
    """
    x, y, width, height = box
    x_scale = (
        window_width / width if window_width else window_height / height if window_height else 1.0
    )
    y_scale = window_height / height if window_height else x_scale
    words = node.attributes.get("preserveAspectRatio", "xMidYMid").split()
    align = words[0] if words else "xMidYMid"
    left = top = 0.0
    if align != "none":
        even = (max if "slice" in words else min)(x_scale, y_scale)
        left = (x_scale - even) * width * _ALIGN.get(align[1:4].lower(), 0.5)
        top = (y_scale - even) * height * _ALIGN.get(align[5:8].lower(), 0.5)
        x_scale = y_scale = even
    return x_scale, 0.0, 0.0, y_scale, left - x * x_scale, top - y * y_scale


def _flipped_matrix(
    matrix: Matrix,
    box: tuple[float, float, float, float],
    page_width: float | None,
    page_height: float | None,
) -> Matrix:
    """Return the matrix of a page with y upwards and y = 0 at the lower edge of the page.

    ``matrix``: matrix of the page with y downwards and y = 0 at the upper edge.
    ``box``: x, y, width and height of the viewBox.
    ``page_width``, ``page_height``: width and height of the page (file units); None if the file
    does not state them.
    """
    a, _, _, d, e, f = matrix
    high = page_height or (page_width or 0.0) * box[3] / box[2]
    return a, 0.0, 0.0, -d, e, high - f


def _side_length(root: Node, name: str) -> tuple[float, str] | None:
    """Return number and unit of the attribute ``name``, "width" or "height", of the root element.

    The unit is empty if the attribute has no unit.  None is returned if the attribute is missing,
    invalid, not positive or a percentage.
    """
    try:
        value, unit = parse_length(root.attributes.get(name, ""))
    except ValueError:
        return None
    return (value, unit) if value > 0.0 and unit != "%" else None


def _side_in_unit(
    side: tuple[float, str] | None, millimetres: float, pixel_length: float
) -> float | None:
    """Return the length of a side of the page in a unit that is ``millimetres`` mm long.

    ``side`` is the number and the unit of the side; a number without a unit is in pixels, which are
    ``pixel_length`` mm long.  None is returned if ``side`` is None.
    """
    if side is None:
        return None
    value, unit = side
    if unit in _PHYSICAL:
        _, part, own = _PHYSICAL[unit]
        return value * part * (own / millimetres)
    return value * pixel_length / millimetres


def _unknown_unit(root: Node) -> Message:
    """Return the message that explains why the unit of a page is unknown."""
    written = _written_size(root, [name for name in ("width", "height") if name in root.attributes])
    pixel = Message("unit.svg-pixel")
    if not written:
        return Message("unit.svg-no-size", pixel=pixel)
    return Message("unit.svg-no-unit", size=written, pixel=pixel)


def _written_size(root: Node, names: Sequence[str]) -> list[str]:
    """Return attributes of the root element as text, as in the file: for example 'width="90mm"'.

    ``names`` are the names of the attributes; an attribute that is missing is left out.
    """
    return [f'{name}="{root.attributes[name].strip()[:20]}"' for name in names]
