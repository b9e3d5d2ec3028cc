"""colours: what is drawn with, as a true colour and the name of its ink.

    [/Separation /CutContour /DeviceCMYK {…}] and tint 1 -> Paint(0xFF00FF, "CutContour")

A spot colour is an ink of its own, and carton makers name theirs after what is done along the line.
Its true colour is that of its tint on the screen.

Source: ISO 32000-1, chapter 8.6.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from pypdf.generic import ArrayObject, NameObject

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR
from knifetip.pdf.document import File
from knifetip.pdf.tints import shown


class Paint(NamedTuple):
    """What a line or an area is drawn with."""

    colour: int  #: 0xRRGGBB, or ``UNKNOWN_COLOUR``
    spot: str  #: name of the ink, empty where it is mixed from those of every printer
    drawn: bool = True  #: whether it leaves a mark


class Space(NamedTuple):
    """A colour space."""

    kind: str  #: Gray, RGB, CMYK, Separation, DeviceN, or empty for one that is not told
    components: int
    inks: tuple[str, ...] = ()
    under: Any = None  #: Space that a tint is shown in
    tint: Any = None  #: function from a tint to it


BLACK: Final = Paint(0, "")
PATTERN: Final = Paint(UNKNOWN_COLOUR, "")
GRAY: Final = Space("Gray", 1)
RGB: Final = Space("RGB", 3)
CMYK: Final = Space("CMYK", 4)
_UNTOLD: Final = Space("", 0)
_DEVICE: Final = {
    "/DeviceGray": GRAY,
    "/CalGray": GRAY,
    "/DeviceRGB": RGB,
    "/CalRGB": RGB,
    "/DeviceCMYK": CMYK,
}
_BY_COUNT: Final = {1: GRAY, 3: RGB, 4: CMYK}
#: Inks that say nothing of a line.
_PROCESS: Final = frozenset(("Cyan", "Magenta", "Yellow", "Black", "All", "None"))
#: Spaces inside spaces; the standard has at most three.
_DEEPEST: Final = 4


def space(file: File, given: object, deep: int = 0) -> Space:
    """Return the colour space that an object describes."""
    given = file.seen(given)
    if isinstance(given, NameObject):
        return _DEVICE.get(str(given), _UNTOLD)
    if not isinstance(given, ArrayObject) or not given or deep == _DEEPEST:
        return _UNTOLD
    kind, *rest = (file.seen(one) for one in given[:4])
    if kind == "/ICCBased" and rest:
        return _BY_COUNT.get(file.entry(rest[0], "/N"), _UNTOLD)
    if kind == "/Separation" and len(rest) == 3:
        return Space("Separation", 1, (_ink(rest[0]),), space(file, rest[1], deep + 1), rest[2])
    if kind == "/DeviceN" and len(rest) == 3 and isinstance(rest[0], ArrayObject):
        inks = tuple(_ink(file.seen(ink)) for ink in rest[0][:32])
        under = space(file, rest[1], deep + 1)
        return Space("DeviceN", len(inks), inks, under, rest[2])
    return _DEVICE.get(str(kind), _UNTOLD)


def _ink(name: object) -> str:
    return str(name)[1:].strip() if isinstance(name, NameObject) else ""


def paint(file: File, where: Space, given: list[float]) -> Paint:
    """Return what so much of each component of a space draws."""
    if where.kind not in ("Separation", "DeviceN"):
        return Paint(_mixed(where.kind, given), "")
    inks = dict(zip(where.inks, given, strict=False))
    if set(where.inks) == {"None"}:
        return Paint(UNKNOWN_COLOUR, "", drawn=False)
    names = [name for name, tint in inks.items() if tint > 0.0 and name not in _PROCESS]
    spot = names[0] if len(names) == 1 else ""
    colour = UNKNOWN_COLOUR
    if len(given) == 1 and len(where.inks) == 1:
        colour = _mixed(where.under.kind, shown(file, where.tint, given[0]))
    return Paint(colour, spot)


def _mixed(kind: str, given: list[float]) -> int:
    """Return the components of a device's space as 0xRRGGBB, without colour management."""
    parts = [min(max(part, 0.0), 1.0) for part in given]
    if not all(map(math.isfinite, given)):
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
