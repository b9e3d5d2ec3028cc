"""page: how large an SVG is on paper.

    width, height, viewBox of the root -> Page: a matrix with y upwards, and the unit

Only a physical unit says how large: mm, cm, in, pt and pc.  A number alone, or one in px, does not:
browsers and Inkscape have 96 pixels to the inch, Illustrator 72, older Inkscape 90.

Source: Scalable Vector Graphics (SVG) 1.1, second edition, chapters 7.7 and 7.8.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from knifetip.geometry.affine import Matrix
from knifetip.messages import Message
from knifetip.model.unit import MILLIMETRES, UnitHint
from knifetip.svg.document import Node
from knifetip.svg.lengths import length
from knifetip.svg.transform import numbers

#: Units of paper: the unit that is taken, how many of it, and its millimetres.
_PHYSICAL: Final = {
    "mm": ("mm", 1.0, 1.0),
    "cm": ("cm", 1.0, 10.0),
    "in": ("in", 1.0, 25.4),
    "pt": ("pt", 1.0, MILLIMETRES["pt"]),
    "pc": ("pt", 12.0, MILLIMETRES["pt"]),
    "q": ("mm", 0.25, 1.0),
}
_PIXEL: Final = MILLIMETRES["px"]
#: The least, the middle and the most of the room that an even scale leaves.
_ALIGN: Final = {"min": 0.0, "mid": 0.5, "max": 1.0}


@dataclass(frozen=True, slots=True)
class Page:
    """What the root of an SVG says of its size."""

    matrix: Matrix  #: from the root's coordinates to file units, y upwards
    scale: float  #: millimetres to a file unit, 0 while it is unknown
    unit: str  #: empty while it is unknown
    evidence: Message
    stated: str  #: the unit that the file states
    hints: tuple[UnitHint, ...] = ()  #: what else it says of the unit


def page(root: Node, unit: str, given: float, illustrator: bool) -> Page:
    """Return the page of an SVG.

    Parameters
    ----------
    unit, given
        What the user says the unit is, and its millimetres; "" and 0 if nothing.  It stands for
        the unit of width and height where these have a physical one, and else for a unit of the
        drawing's own coordinates.
    illustrator
        Whether the file says that Adobe Illustrator wrote it.
    """
    box = view(root)
    wide, high = (_side(root, name) for name in ("width", "height"))
    physical = next((side for side in (wide, high) if side and side[1] in _PHYSICAL), None)
    if physical is None:
        top = box[1] + box[3] if box else high[0] if high else 0.0
        source = (
            Message("unit.given")
            if unit
            else Message("unit.in-file", statement=_unknown(root, illustrator))
        )
        hints = [UnitHint("pixels", "a size without a unit, as pages in pixels or points have it")]
        if illustrator:
            hints.append(UnitHint("points", "the name of Illustrator, which counts in points"))
        upright = (1.0, 0.0, 0.0, -1.0, 0.0, top)
        return Page(upright, given, unit, source, "", tuple(hints))
    stated, _, millimetres = _PHYSICAL[physical[1]]
    across, down = (_in_unit(side, millimetres) for side in (wide, high))
    evidence = " and ".join(
        f'{name} = "{root.attributes[name].strip()[:20]}"'
        for name, side in (("width", wide), ("height", high))
        if side
    )
    if box is None:
        # Without a viewBox the coordinates are pixels of CSS, on a sheet of that size.
        size = _PIXEL / millimetres
        matrix = (size, 0.0, 0.0, -size, 0.0, down or 0.0)
        evidence += ", no viewBox: a coordinate is 1/96 in"
    else:
        matrix = _flipped(fitted(box, across, down, root), box, across, down)
        evidence += f", viewBox {box[2]:g} × {box[3]:g}"
    source = Message("unit.given") if unit else Message("unit.in-file", statement=evidence)
    return Page(matrix, given or millimetres, unit or stated, source, stated)


def view(node: Node) -> tuple[float, float, float, float] | None:
    """Return the viewBox of an element, None where it has none that can be used."""
    try:
        x, y, width, height = numbers(node.attributes.get("viewBox", ""))
    except ValueError:
        return None
    return (x, y, width, height) if width > 0.0 and height > 0.0 else None


def fitted(
    box: tuple[float, float, float, float], across: float | None, down: float | None, node: Node
) -> Matrix:
    """Return what lays a viewBox into a window at (0, 0), as ``preserveAspectRatio`` says."""
    x, y, width, height = box
    x_scale = across / width if across else down / height if down else 1.0
    y_scale = down / height if down else x_scale
    words = node.attributes.get("preserveAspectRatio", "xMidYMid").split()
    align = words[0] if words else "xMidYMid"
    left = top = 0.0
    if align != "none":
        even = (max if "slice" in words else min)(x_scale, y_scale)
        left = (x_scale - even) * width * _ALIGN.get(align[1:4].lower(), 0.5)
        top = (y_scale - even) * height * _ALIGN.get(align[5:8].lower(), 0.5)
        x_scale = y_scale = even
    return x_scale, 0.0, 0.0, y_scale, left - x * x_scale, top - y * y_scale


def _flipped(
    matrix: Matrix,
    box: tuple[float, float, float, float],
    across: float | None,
    down: float | None,
) -> Matrix:
    """Return a matrix whose y counts upwards from the lower edge of the page."""
    a, _, _, d, e, f = matrix
    high = down or (across or 0.0) * box[3] / box[2]
    return a, 0.0, 0.0, -d, e, high - f


def _side(root: Node, name: str) -> tuple[float, str] | None:
    """Return a side of the page, None where it has no length of its own."""
    try:
        value, unit = length(root.attributes.get(name, ""))
    except ValueError:
        return None
    return (value, unit) if value > 0.0 and unit != "%" else None


def _in_unit(side: tuple[float, str] | None, millimetres: float) -> float | None:
    """Return a side of the page in the unit of so many millimetres; a bare number is pixels."""
    if side is None:
        return None
    value, unit = side
    if unit in _PHYSICAL:
        _, part, own = _PHYSICAL[unit]
        return value * part * (own / millimetres)
    return value * _PIXEL / millimetres


def _unknown(root: Node, illustrator: bool) -> str:
    written = [
        f'{name} = "{root.attributes[name].strip()[:20]}"'
        for name in ("width", "height")
        if name in root.attributes
    ]
    said = " and ".join(written) or "the SVG has no width and no height"
    wrote = "Illustrator wrote it: there" if illustrator else "in Illustrator"
    return (
        f"{said}: no unit of length; in a browser a coordinate is 1/96 in (0.2646 mm), {wrote} it "
        "is 1/72 in (0.3528 mm)"
    )
