"""slotted: slotted cases FEFCO 0200, 0201 and 0203.

The outer flaps hang on the long panels, the inner flaps on the short ones.
"""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from knifetip.cartons import allowances
from knifetip.cartons.carton import Carton
from knifetip.cartons.parameters import CartonSize, check_least, check_most
from knifetip.cartons.style import Style
from knifetip.cartons.tube import PANELS, Flap, Tube
from knifetip.messages import Message
from knifetip.model.board import Board

_MATERIALS: Final = ("corrugated", "solid board")


class SlottedCase(CartonSize):
    """Parameters of a slotted case."""

    joint: Annotated[float, Field(ge=15.0, le=60.0)] = Field(
        default=35.0, title="Glue flap", description="Width of the glue flap (mm)"
    )


class MeetingCase(SlottedCase):
    """Parameters of a case whose outer flaps meet."""

    gap: Annotated[float, Field(ge=0.0, le=20.0)] = Field(
        default=0.0,
        title="Gap of the flaps",
        description="Distance between the outer flaps when the case is closed (mm)",
    )


class _Flaps:
    """Lengths of the flaps of a case, from crease to edge (mm)."""

    def __init__(self, outer: float, inner: float) -> None:
        self.outer, self.inner = outer, inner


def draw_0200(size: MeetingCase, board: Board) -> Carton:
    """Draw a case that is open at the top."""
    t = board.caliper
    height = size.depth + allowances.between_folds(t)
    return _draw(size, board, height, _meeting(size, t), open_top=True)


def draw_0201(size: MeetingCase, board: Board) -> Carton:
    """Draw a case whose outer flaps meet in the middle."""
    t = board.caliper
    return _draw(size, board, size.depth + allowances.slotted_depth(t), _meeting(size, t))


def draw_0203(size: SlottedCase, board: Board) -> Carton:
    """Draw a case whose outer flaps overlap fully; the inner flaps meet at most."""
    t = board.caliper
    outer = size.width + allowances.between_folds(t) - allowances.play(t)
    inner = min(outer, 0.5 * (size.length + t))
    height = size.depth + allowances.overlapped_depth(t)
    return _draw(size, board, height, _Flaps(outer, inner))


def _meeting(size: MeetingCase, t: float) -> _Flaps:
    """Return the flaps of a case whose outer flaps meet; the inner flaps have the same length."""
    half = 0.5 * (size.width + t - size.gap)
    return _Flaps(half, half)


def _draw(
    size: SlottedCase, board: Board, height: float, flaps: _Flaps, *, open_top: bool = False
) -> Carton:
    t = board.caliper
    slot = allowances.slot_width(t)
    check_least("width", size.width, size.joint + 2.0 * slot, board)
    check_most("width", size.width, size.length, board)
    check_least("depth", size.depth, 3.0 * slot + 10.0, board)
    tube = Tube.from_size(size.length, size.width, height, size.joint, t)
    draft = tube.draft()
    ends: list[list[Flap]] = []
    for place in ("bottom", "top"):
        row: list[Flap] = []
        for panel, name in enumerate(PANELS):
            if place == "top" and open_top:
                row.append(tube.no_flap(panel))
                continue
            # Inner flaps are those of the short panels.
            long = flaps.inner if panel % 2 else flaps.outer
            a, b = tube.span(panel)
            # The last panel ends at the joint, beside the crease of the glue flap.
            a, b = a + 0.5 * slot, b - 0.5 * slot
            row.append([(a, 0.0), (a, long), (b, long), (b, 0.0)])
            start, end = (tube.point((u, 0.0), top=place == "top") for u in (a, b))
            far = tube.point((b, long), top=place == "top")
            draft.panel(f"{place}-{name}", (*start, *far), name, (start, end))
        ends.append(row)
    return draft.finish(tube.outline(ends[1], ends[0]))


STYLES: Final = (
    Style(
        "fefco-0200",
        Message("carton.fefco-0200"),
        Message("carton.fefco-0200.description"),
        MeetingCase,
        draw_0200,
        MeetingCase(length=300.0, width=200.0, depth=150.0),
        "b-flute",
        _MATERIALS,
    ),
    Style(
        "fefco-0201",
        Message("carton.fefco-0201"),
        Message("carton.fefco-0201.description"),
        MeetingCase,
        draw_0201,
        MeetingCase(length=300.0, width=200.0, depth=150.0),
        "b-flute",
        _MATERIALS,
    ),
    Style(
        "fefco-0203",
        Message("carton.fefco-0203"),
        Message("carton.fefco-0203.description"),
        SlottedCase,
        draw_0203,
        SlottedCase(length=300.0, width=160.0, depth=120.0),
        "b-flute",
        _MATERIALS,
    ),
)
