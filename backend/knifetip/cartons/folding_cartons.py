"""folding_cartons: tuck-end cartons ECMA A20.20, A60.20 with a crash-lock bottom, and FEFCO 0215.

ECMA's group A has cartons with a glued joint.  The first two digits are the closure of the bottom
and the next two that of the top: 20 is a tuck lid, 60 a glued bottom that locks when the carton is
opened.  A20.20.01 has both lids on one panel (straight tuck), A20.20.03 on opposite panels (reverse
tuck).
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field

from knifetip.cartons import allowances
from knifetip.cartons.bottoms import crash_lock_bottom, snap_lock_bottom
from knifetip.cartons.carton import Carton
from knifetip.cartons.parameters import check_least
from knifetip.cartons.style import Style
from knifetip.cartons.tube import Tube
from knifetip.cartons.tuck import TuckCarton, TuckEnd
from knifetip.fields import LISTED
from knifetip.messages import Message
from knifetip.model.board import Board


class TuckEndCarton(TuckCarton):
    """Parameters of a carton with a tuck lid at both ends."""

    lids: Annotated[Literal["reverse", "straight"], LISTED] = Field(
        default="reverse",
        title="Lids",
        description="Whether the lids hang on opposite panels (reverse) or on one (straight)",
    )


class CorrugatedTuckCarton(TuckCarton):
    """Parameters of a tuck carton in corrugated board, with a wider glue flap."""

    joint: Annotated[float, Field(ge=8.0, le=60.0)] = Field(
        default=25.0, title="Glue flap", description="Width of the glue flap (mm)"
    )
    tuck: Annotated[float, Field(ge=6.0, le=80.0)] = Field(
        default=25.0, title="Tuck flap", description="Length of the tuck flap of the lid (mm)"
    )


def draw_a20_20(size: TuckEndCarton, board: Board) -> Carton:
    """Draw a carton with a tuck lid at both ends."""
    t = board.caliper
    # Two tuck flaps lie one above the other on the same panel.
    check_least("depth", size.depth, 2.0 * size.tuck + 4.0, board)
    tube = Tube.from_size(
        size.length, size.width, size.depth + allowances.between_folds(t), size.joint, t
    )
    end, draft = TuckEnd.from_size(tube, size, board), tube.draft()
    top = end.flaps(draft, 0, top=True)
    bottom = end.flaps(draft, 2 if size.lids == "reverse" else 0, top=False)
    return draft.finish(tube.outline(top, bottom))


def draw_a60_20(size: TuckCarton, board: Board) -> Carton:
    """Draw a carton with a tuck lid and a glued crash-lock bottom."""
    tube = _with_bottom(size, board)
    end, draft = TuckEnd.from_size(tube, size, board), tube.draft()
    top = end.flaps(draft, 0, top=True)
    return draft.finish(tube.outline(top, crash_lock_bottom(tube, draft, size, board)))


def draw_0215(size: CorrugatedTuckCarton, board: Board) -> Carton:
    """Draw a carton with a tuck lid and a snap-lock (1-2-3) bottom."""
    tube = _with_bottom(size, board)
    end, draft = TuckEnd.from_size(tube, size, board), tube.draft()
    top = end.flaps(draft, 0, top=True)
    return draft.finish(tube.outline(top, snap_lock_bottom(tube, draft, size, board)))


def _with_bottom(size: TuckCarton, board: Board) -> Tube:
    """Return a tube whose bottom has two layers, that is t/2 more than one between two folds."""
    t = board.caliper
    height = size.depth + allowances.between_folds(t) + 0.5 * t
    return Tube.from_size(size.length, size.width, height, size.joint, t)


STYLES: Final = (
    Style(
        "fefco-0215",
        Message("carton.fefco-0215"),
        Message("carton.fefco-0215.description"),
        CorrugatedTuckCarton,
        draw_0215,
        CorrugatedTuckCarton(length=160.0, width=110.0, depth=180.0),
        "e-flute",
        ("corrugated", "solid board", "folding boxboard"),
    ),
    Style(
        "ecma-a20.20",
        Message("carton.ecma-a20.20"),
        Message("carton.ecma-a20.20.description"),
        TuckEndCarton,
        draw_a20_20,
        TuckEndCarton(length=70.0, width=40.0, depth=120.0),
        "fbb-0.4",
        ("folding boxboard", "corrugated"),
    ),
    Style(
        "ecma-a60.20",
        Message("carton.ecma-a60.20"),
        Message("carton.ecma-a60.20.description"),
        TuckCarton,
        draw_a60_20,
        TuckCarton(length=90.0, width=60.0, depth=140.0),
        "fbb-0.5",
        ("folding boxboard", "corrugated"),
    ),
)
