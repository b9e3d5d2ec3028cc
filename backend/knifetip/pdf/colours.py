"""colours: convert colours of a PDF to a true colour and the name of the spot colour.

For example, the colour space ``[/Separation /CutContour /DeviceCMYK {…}]`` and the tint 1 (full
ink) give ``Paint(0xFF00FF, "CutContour")``.

A spot colour is a separate ink.  Carton designers name the ink of a line after the operation on the
line, such as "CutContour".  The true colour of a spot colour is the colour in which programs
display it.

Source: ISO 32000-1, chapter 8.6.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from pypdf.generic import ArrayObject, NameObject

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR
from knifetip.pdf.document import PdfFile
from knifetip.pdf.tints import evaluate_tint


class Paint(NamedTuple):
    """The colour of a line or of a filled area of a PDF, with the name of its spot colour."""

    colour: int  #: 0xRRGGBB, or ``UNKNOWN_COLOUR``
    spot: str  #: name of the spot colour, empty for process colours
    drawn: bool = True  #: whether lines of this colour are visible


class ColourSpace(NamedTuple):
    """A colour space of a PDF: its kind, number of components and, for spot colours, inks."""

    kind: str  #: Gray, RGB, CMYK, Separation, DeviceN, or empty if unknown
    components: int
    inks: tuple[str, ...] = ()
    alternate: Any = None  #: the alternate space, in which a tint is displayed
    tint: Any = None  #: function from a tint to the alternate space


BLACK: Final = Paint(0, "")
PATTERN: Final = Paint(UNKNOWN_COLOUR, "")
GRAY: Final = ColourSpace("Gray", 1)
RGB: Final = ColourSpace("RGB", 3)
CMYK: Final = ColourSpace("CMYK", 4)
_UNKNOWN_SPACE: Final = ColourSpace("", 0)
_DEVICE: Final = {
    "/DeviceGray": GRAY,
    "/CalGray": GRAY,
    "/DeviceRGB": RGB,
    "/CalRGB": RGB,
    "/DeviceCMYK": CMYK,
}
_BY_COUNT: Final = {1: GRAY, 3: RGB, 4: CMYK}
#: Inks that are not the name of a line type.
_PROCESS: Final = frozenset(("Cyan", "Magenta", "Yellow", "Black", "All", "None"))
#: Deepest nesting of colour spaces; the standard allows three.
_MAX_DEPTH: Final = 4


def parse_colour_space(file: PdfFile, definition: object, depth: int = 0) -> ColourSpace:
    """Return the colour space that the PDF object ``definition`` defines.

    The attribute ``kind`` of the result is empty if the colour space is unknown or nested too
    deeply.  ``depth`` is the number of colour spaces that contain this colour space; it is 0 for a
    colour space that a page or form uses directly.
    """
    definition = file.resolve(definition)
    if isinstance(definition, NameObject):
        return _DEVICE.get(str(definition), _UNKNOWN_SPACE)
    if not isinstance(definition, ArrayObject) or not definition or depth == _MAX_DEPTH:
        return _UNKNOWN_SPACE
    kind, *rest = (file.resolve(one) for one in definition[:4])
    if kind == "/ICCBased" and rest:
        return _BY_COUNT.get(file.entry(rest[0], "/N"), _UNKNOWN_SPACE)
    if kind == "/Separation" and len(rest) == 3:
        return ColourSpace(
            "Separation", 1, (_ink(rest[0]),), parse_colour_space(file, rest[1], depth + 1), rest[2]
        )
    if kind == "/DeviceN" and len(rest) == 3 and isinstance(rest[0], ArrayObject):
        inks = tuple(_ink(file.resolve(ink)) for ink in rest[0][:32])
        alternate = parse_colour_space(file, rest[1], depth + 1)
        return ColourSpace("DeviceN", len(inks), inks, alternate, rest[2])
    return _DEVICE.get(str(kind), _UNKNOWN_SPACE)


def _ink(name: object) -> str:
    return str(name)[1:].strip() if isinstance(name, NameObject) else ""


def make_paint(file: PdfFile, space: ColourSpace, components: list[float]) -> Paint:
    """Return the colour that a colour space and its components define in a PDF.

    ``space`` is the colour space, ``components`` the value of each component.  The true colour of
    the result is ``UNKNOWN_COLOUR`` if it cannot be computed.
    """
    if space.kind not in ("Separation", "DeviceN"):
        return Paint(_to_rgb(space.kind, components), "")
    inks = dict(zip(space.inks, components, strict=False))
    if set(space.inks) == {"None"}:
        return Paint(UNKNOWN_COLOUR, "", drawn=False)
    names = [name for name, tint in inks.items() if tint > 0.0 and name not in _PROCESS]
    spot = names[0] if len(names) == 1 else ""
    colour = UNKNOWN_COLOUR
    if len(components) == 1 and len(space.inks) == 1:
        colour = _to_rgb(space.alternate.kind, evaluate_tint(file, space.tint, components[0]))
    return Paint(colour, spot)


def _to_rgb(kind: str, components: list[float]) -> int:
    """Return a device colour as 0xRRGGBB, without colour management.

    ``kind`` is Gray, RGB or CMYK, and ``components`` are the values of its components, 0…1.
    ``UNKNOWN_COLOUR`` is returned for other kinds and for invalid components.
    """
    parts = [min(max(part, 0.0), 1.0) for part in components]
    if not all(map(math.isfinite, components)):
        return UNKNOWN_COLOUR
    if kind == "Gray" and len(parts) == 1:
        parts = parts * 3
    elif kind == "CMYK" and len(parts) == 4:
        *inks, black = parts
        parts = [(1.0 - ink) * (1.0 - black) for ink in inks]
    elif kind != "RGB" or len(parts) != 3:
        return UNKNOWN_COLOUR
    red, green, blue = (round(part * 255.0) for part in parts)
    return red << 16 | green << 8 | blue
