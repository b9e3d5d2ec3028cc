"""trays: base or lid of a rigid box with V-grooves, and of a telescope tray with corner flaps.

The middle of the base is the origin.  A lid is a tray that fits over the base.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field

from knifetip.cartons import allowances
from knifetip.cartons.carton import Box, Carton, Point
from knifetip.cartons.draft import Draft
from knifetip.cartons.parameters import CartonSize, check_least, check_most
from knifetip.cartons.style import Style
from knifetip.cartons.tube import Corner
from knifetip.fields import LISTED
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.dieline import LineType

#: Walls of a tray, and the direction (x, y) in which each lies.
_WALLS: Final = (
    ("right", (1.0, 0.0)),
    ("back", (0.0, 1.0)),
    ("left", (-1.0, 0.0)),
    ("front", (0.0, -1.0)),
)


class TwoPieceTray(CartonSize):
    """Parameters of a base with a lid; the dimensions are those inside the base."""

    part: Annotated[Literal["base", "lid"], LISTED] = Field(
        default="base",
        title="Part",
        description="Part to draw: the base with the inner dimensions, or the lid that fits over "
        "this base",
    )
    cover: Annotated[float, Field(ge=0.1, le=1.0)] = Field(
        default=1.0,
        title="Covered part of the depth",
        description="Depth of the lid as a part of the outer depth of the base, 0.1 to 1",
    )


def draw_rigid_box(size: TwoPieceTray, board: Board) -> Carton:
    """Draw a base or a lid whose walls fold along V-grooves.

    A V-groove leaves a web at the outer face, in whose middle the fold lies.  The inner face of a
    wall is therefore t − web/2 away from its groove.  The short walls stand between the long ones.
    """
    t = board.caliper
    face = 0.5 * (t + board.groove_depth)
    length, width, depth = size.length, size.width, size.depth
    if size.part == "lid":
        # Around the walls of the base.
        more = 2.0 * (t + allowances.play(t))
        length, width, depth = length + more, width + more, size.cover * (depth + t)
    check_least("depth", depth, 4.0 * t + 4.0, board)
    check_least("width", size.width, 8.0 * t + 10.0, board)
    check_least("length", size.length, 8.0 * t + 10.0, board)
    half = 0.5 * length + face, 0.5 * width + face
    height = depth + face
    short = half[1] - face - 0.1
    corners: list[Corner] = [
        (half[0] + height, short),
        (half[0], short),
        half,
        (half[0], half[1] + height),
    ]
    draft = Draft("base", (-half[0], -half[1], half[0], half[1]))
    for name, toward in _WALLS:
        wide = short if toward[0] else half[0]
        _wall(draft, name, half, toward, (wide, height), LineType.V_GROOVE)
    return draft.finish(_four_quarters(corners))


def draw_telescope_tray(size: TwoPieceTray, board: Board) -> Carton:
    """Draw a base or a lid whose corner flaps are glued or stitched to the inside of the walls.

    The corner flaps hang on the long walls, and the short walls are outside them.
    """
    t = board.caliper
    length, width, depth = size.length, size.width, size.depth
    if size.part == "lid":
        play = 2.0 * allowances.play(t)
        # The base is two boards thick at either end of its length, and one at the other sides.
        length, width = length + 4.0 * t + play, width + 2.0 * t + play
        depth = size.cover * (depth + t)
    check_least("depth", depth, 4.0 * t + 8.0, board)
    check_least("width", size.width, 6.0 * t + 20.0, board)
    check_least("length", size.length, 6.0 * t + 20.0, board)
    check_most("width", size.width, size.length, board)
    half = 0.5 * length + 1.5 * t, 0.5 * width + 0.5 * t
    height, crease = depth + 0.5 * t, 0.5 * length + 0.5 * t
    flap = min(0.4 * width, 0.5 * width - t, 60.0)
    short = half[1] - max(0.5 * t, 0.5)
    low, taper = half[1] + 0.5 * t + allowances.play(t), min(2.0, 0.1 * height)
    top = half[1] + height
    corners: list[Corner] = [
        (half[0] + height, short),
        (half[0], short),
        half,
        (crease, half[1]),
        (crease, low),
        (crease + flap, low + taper),
        (crease + flap, top - taper),
        (crease, top),
    ]
    draft = Draft("base", (-half[0], -half[1], half[0], half[1]))
    for name, toward in _WALLS:
        wide = short if toward[0] else crease
        _wall(draft, name, half, toward, (wide, height), LineType.CREASE)
        if toward[1]:
            for side, end in ((-1.0, "left"), (1.0, "right")):
                x, far = side * crease, side * (crease + flap)
                y0, y1 = toward[1] * low, toward[1] * top
                draft.panel(f"{name}-{end}", (x, y0, far, y1), name, ((x, y0), (x, y1)))
    return draft.finish(_four_quarters(corners))


def _wall(
    draft: Draft,
    name: str,
    half: Point,
    toward: tuple[float, float],
    size: tuple[float, float],
    kind: LineType,
) -> None:
    """Add a wall: half of its width, and its height from the fold to its edge (mm)."""
    wide, height = size
    x, y = toward[0] * half[0], toward[1] * half[1]
    if toward[0]:
        box: Box = (x, -wide, x + toward[0] * height, wide)
        line = (x, -wide), (x, wide)
    else:
        box = (-wide, y, wide, y + toward[1] * height)
        line = (-wide, y), (wide, y)
    draft.panel(name, box, "base", line, kind=kind)


def _four_quarters(corners: list[Corner]) -> list[Corner]:
    """Return the corners of an outline that is symmetrical to both axes.

    ``corners`` (x, y) are those of the upper right quarter, counter-clockwise.
    """
    upper = [*corners, *((-x, y) for x, y in reversed(corners))]
    return [*upper, *((-x, -y) for x, y in upper)]


STYLES: Final = (
    Style(
        "rigid-box",
        Message("carton.rigid-box"),
        Message("carton.rigid-box.description"),
        TwoPieceTray,
        draw_rigid_box,
        TwoPieceTray(length=180.0, width=130.0, depth=50.0),
        "greyboard-2.0",
        ("greyboard", "solid board"),
    ),
    Style(
        "telescope-tray",
        Message("carton.telescope-tray"),
        Message("carton.telescope-tray.description"),
        TwoPieceTray,
        draw_telescope_tray,
        TwoPieceTray(length=300.0, width=200.0, depth=80.0),
        "b-flute",
        ("corrugated", "solid board", "folding boxboard"),
    ),
)
