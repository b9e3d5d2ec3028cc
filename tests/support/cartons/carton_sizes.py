"""Small, usual and large dimensions of each carton style, and boards of which it is made."""

from __future__ import annotations

from typing import Any, NamedTuple

from knifetip.cartons.parameters import CartonSize
from knifetip.cartons.registry import style_of

#: Length, width and depth (mm).
Dimensions = tuple[float, float, float]


class Sizes(NamedTuple):
    """Dimensions of a style, the usual ones in the middle, and its boards."""

    dimensions: tuple[Dimensions, Dimensions, Dimensions]
    boards: tuple[str, str, str]


_CORRUGATED = ("e-flute", "b-flute", "bc-flute")
_BOXBOARD = ("fbb-0.3", "fbb-0.6", "e-flute")

SIZES: dict[str, Sizes] = {
    "fefco-0200": Sizes(
        ((80.0, 60.0, 40.0), (300.0, 200.0, 150.0), (450.0, 280.0, 500.0)), _CORRUGATED
    ),
    "fefco-0201": Sizes(
        ((80.0, 60.0, 40.0), (300.0, 200.0, 150.0), (450.0, 280.0, 500.0)), _CORRUGATED
    ),
    "fefco-0203": Sizes(
        ((80.0, 60.0, 40.0), (300.0, 160.0, 120.0), (480.0, 250.0, 400.0)), _CORRUGATED
    ),
    "fefco-0215": Sizes(
        ((90.0, 70.0, 60.0), (160.0, 110.0, 180.0), (400.0, 300.0, 350.0)),
        ("fbb-0.6", "e-flute", "b-flute"),
    ),
    "fefco-0427": Sizes(
        ((100.0, 100.0, 42.0), (200.0, 150.0, 60.0), (500.0, 350.0, 120.0)), _CORRUGATED
    ),
    "fefco-0471": Sizes(
        ((100.0, 100.0, 42.0), (200.0, 150.0, 60.0), (400.0, 350.0, 120.0)), _CORRUGATED
    ),
    "ecma-a20.20": Sizes(
        ((30.0, 20.0, 45.0), (70.0, 40.0, 120.0), (250.0, 150.0, 400.0)), _BOXBOARD
    ),
    "ecma-a60.20": Sizes(
        ((45.0, 32.0, 50.0), (90.0, 60.0, 140.0), (250.0, 180.0, 400.0)), _BOXBOARD
    ),
    "rigid-box": Sizes(
        ((50.0, 45.0, 25.0), (180.0, 130.0, 50.0), (600.0, 400.0, 120.0)),
        ("greyboard-1.0", "greyboard-2.0", "greyboard-3.0"),
    ),
    "telescope-tray": Sizes(
        ((80.0, 70.0, 40.0), (300.0, 200.0, 80.0), (700.0, 500.0, 150.0)),
        ("fbb-0.6", "b-flute", "bc-flute"),
    ),
}


def sized(code: str, dimensions: Dimensions, **options: Any) -> CartonSize:
    """Return the parameters of a style: dimensions, and options that differ from the defaults."""
    length, width, depth = dimensions
    return style_of(code).parameters(length=length, width=width, depth=depth, **options)
