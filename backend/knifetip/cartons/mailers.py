"""mailers: boxes with rolled side walls and a tuck lid, FEFCO 0427 and 0471.

The length is the side at which the lid folds.  A side wall consists of an outer wall, a rim that is
2 t wide, and an inner wall; the ears of front and back lie between the walls.  The lid closes
between the walls, flush with the rim.  The middle of the base is the origin of x, and the fold of
the front that of y.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Final

from pydantic import Field

from knifetip.cartons import allowances
from knifetip.cartons.carton import Carton
from knifetip.cartons.draft import Draft
from knifetip.cartons.parameters import CartonSize, check_least, check_most
from knifetip.cartons.style import Style
from knifetip.cartons.tube import Corner
from knifetip.messages import Message
from knifetip.model.board import Board

#: Greatest length of ears and of flaps of the lid (mm).
_MOST_EAR: Final = 90.0


class Mailer(CartonSize):
    """Parameters of a mailer."""

    tuck: Annotated[float, Field(ge=10.0, le=200.0)] = Field(
        default=30.0, title="Tuck flap", description="Length of the tuck flap of the lid (mm)"
    )


@dataclass(frozen=True, slots=True)
class _Plan:
    """Distances between the creases of a mailer (mm); x is measured from the middle."""

    t: float
    inside: float  #: half of the inner length
    width: float  #: inner width
    floor: float  #: thickness of a floor on the base; 0 without one
    depth: float  #: inner depth
    tuck: float

    @property
    def play(self) -> float:
        return allowances.play(self.t)

    @property
    def base(self) -> float:
        """Half of the base: outer wall, ear and inner wall are beyond the inner length."""
        return self.inside + 2.5 * self.t

    @property
    def ear(self) -> float:
        """x of the crease of the ears, which lie between the walls."""
        return self.inside + 1.5 * self.t

    @property
    def back(self) -> float:
        """y of the fold of the back."""
        return self.width + self.t

    @property
    def hinge(self) -> float:
        """y of the fold of the lid, flush with the rim."""
        return self.back + self.depth + self.floor + self.t

    @property
    def front(self) -> float:
        """Height of the front, from its fold to its edge, flush with the rim."""
        return self.depth + self.floor + 1.5 * self.t

    @property
    def lid(self) -> float:
        """Half of the lid, which lies between the inner walls, as its flaps do."""
        return self.inside - 0.5 * self.t - self.play

    @property
    def ridge(self) -> float:
        """y of the fold of the tuck flap, which lies on the inside of the front."""
        return self.hinge + self.width - self.play

    @property
    def rim(self) -> tuple[float, float]:
        """x of the two folds of a rim."""
        outer = self.base + self.depth + self.floor + self.t
        return outer, outer + 2.0 * self.t


def draw_0427(size: Mailer, board: Board) -> Carton:
    """Draw a mailer whose inner walls are held by a tab in a slot of the base."""
    plan = _plan(size, board, floor=0.0)
    draft = _draft(plan)
    t, play = plan.t, plan.play
    # The inner wall ends above the base; its tab goes through it.
    end = plan.rim[1] + plan.depth + 0.5 * t - 0.5
    reach, middle = t + 0.5, 0.5 * plan.back
    half = min(max(size.width / 6.0, 6.0), 40.0)
    inner = 0.5 * t + play
    _inner_walls(draft, plan, end)
    slot = allowances.lock_slot(t)
    centre, room = plan.inside + 0.5 * t, half + 0.5
    for side in (-1.0, 1.0):
        x = side * centre
        draft.hole((x - 0.5 * slot, middle - room, x + 0.5 * slot, middle + room))
    tip = min(0.3 * reach, 1.0)
    tail: list[Corner] = [
        (end, inner + 1.0),
        (end, middle - half),
        (end + reach, middle - half + tip),
        (end + reach, middle + half - tip),
        (end, middle + half),
        (end, plan.back - inner - 1.0),
    ]
    return draft.finish(_outline(plan, tail))


def draw_0471(size: Mailer, board: Board) -> Carton:
    """Draw a mailer whose inner walls end in floor flaps that meet on the base."""
    plan = _plan(size, board, floor=board.caliper)
    draft = _draft(plan)
    t = plan.t
    # The wall ends at the middle of the floor, and the floor flap half of the play before the
    # middle of the box.
    end = plan.rim[1] + plan.depth + t
    tip = end + plan.inside + 0.5 * t - 0.5 * plan.play
    inner = 0.5 * t + plan.play
    _inner_walls(draft, plan, end)
    for side, name in ((-1.0, "left"), (1.0, "right")):
        low, high = inner, plan.back - inner
        line = (side * end, low), (side * end, high)
        # The walls are rolled inwards, and the floor is folded back towards the middle.
        box = (side * end, low, side * tip, high)
        draft.panel(f"floor-{name}", box, f"inner-{name}", line, angle=-90.0)
    tail: list[Corner] = [
        (end, inner),
        (tip, inner + 1.0),
        (tip, plan.back - inner - 1.0),
        (end, plan.back - inner),
    ]
    return draft.finish(_outline(plan, tail))


def _plan(size: Mailer, board: Board, floor: float) -> _Plan:
    """Return the distances of the creases; raise ``ImpossibleCarton`` for a wrong dimension."""
    t = board.caliper
    check_least("depth", size.depth, 12.0 + 4.0 * t, board)
    check_least("width", size.width, max(40.0, 20.0 + 10.0 * t), board)
    check_least("length", size.length, max(40.0, 20.0 + 10.0 * t), board)
    # The lid folds over the whole depth only if its flaps find room.
    check_most("depth", size.depth, 1.5 * size.width, board)
    check_most("tuck", size.tuck, size.depth - 1.0, board)
    return _Plan(t, 0.5 * size.length, size.width, floor, size.depth, size.tuck)


def _draft(plan: _Plan) -> Draft:
    """Return the draft of a mailer without its inner walls."""
    t, ear = plan.t, plan.ear
    draft = Draft("base", (-plan.base, 0.0, plan.base, plan.back))
    draft.panel("front", (-ear, -plan.front, ear, 0.0), "base", ((-ear, 0.0), (ear, 0.0)))
    draft.panel(
        "back", (-ear, plan.back, ear, plan.hinge), "base", ((-ear, plan.back), (ear, plan.back))
    )
    half, low, high = plan.lid, plan.hinge, plan.ridge
    draft.panel("lid", (-half, low, half, high), "back", ((-half, low), (half, low)))
    draft.panel("tuck", (-half, high, half, high + plan.tuck), "lid", ((-half, high), (half, high)))
    front, back, lid = _ear_spans(plan)
    long, flap = _ear_length(plan), _lid_flap(plan)
    gap = 0.5 * t
    for side, name in ((-1.0, "left"), (1.0, "right")):
        for base, (a, b), at, reach in (
            ("front", front, ear, long),
            ("back", back, ear, long),
            ("lid", lid, half, flap),
        ):
            x, far = side * at, side * (at + reach)
            draft.panel(f"{base}-{name}", (x, a, far, b), base, ((x, a), (x, b)))
        x, far = side * plan.base, side * plan.rim[0]
        low, high = gap, plan.back - gap
        draft.panel(f"outer-{name}", (x, low, far, high), "base", ((x, low), (x, high)))
    return draft


def _inner_walls(draft: Draft, plan: _Plan, end: float) -> None:
    """Add the rims and the inner walls, which end at ``end`` (x, mm)."""
    gap, inner = 0.5 * plan.t, 0.5 * plan.t + plan.play
    for side, name in ((-1.0, "left"), (1.0, "right")):
        first, second = (side * x for x in plan.rim)
        low, high = gap, plan.back - gap
        box = (first, low, second, high)
        draft.panel(f"rim-{name}", box, f"outer-{name}", ((first, low), (first, high)))
        low, high = inner, plan.back - inner
        box = (second, low, side * end, high)
        draft.panel(f"inner-{name}", box, f"rim-{name}", ((second, low), (second, high)))


def _ear_spans(plan: _Plan) -> tuple[tuple[float, float], ...]:
    """Return the spans of the creases of ears along y: of the front, of the back, of the lid."""
    t = plan.t
    above, below = 0.5 * t + 0.5, plan.floor + 0.5 * t + plan.play
    # Under the rim, and above the base.
    front = (-plan.front + t + above, -below)
    back = (plan.back + below, plan.hinge - above)
    gap = t + plan.play
    return front, back, (plan.hinge + gap, plan.ridge - gap)


def _ear_length(plan: _Plan) -> float:
    """Return the length of the ears, which do not meet."""
    return min(0.5 * plan.width - plan.play - plan.t, max(0.4 * plan.width, 15.0), _MOST_EAR)


def _lid_flap(plan: _Plan) -> float:
    """Return the length of the side flaps of the lid, which end above the base."""
    return min(0.8 * plan.depth, _MOST_EAR)


def _outline(plan: _Plan, tail: list[Corner]) -> list[Corner]:
    """Return the corners of the outline; ``tail`` is the end of the right inner wall."""
    t, ear, base = plan.t, plan.ear, plan.base
    front, back, lid = _ear_spans(plan)
    long, flap, half = _ear_length(plan), _lid_flap(plan), plan.lid
    gap, inner = 0.5 * t, 0.5 * t + plan.play
    outer, rim = plan.rim
    r = min(0.3 * long, 8.0)
    end = plan.ridge + plan.tuck
    right: list[Corner] = [
        (ear, -plan.front),
        *_ear(ear, front, long, r),
        (ear, 0.0),
        (base, 0.0),
        (base, gap),
        (outer, gap),
        (rim, inner),
        *tail,
        (rim, plan.back - inner),
        (outer, plan.back - gap),
        (base, plan.back - gap),
        (base, plan.back),
        (ear, plan.back),
        *_ear(ear, back, long, r),
        (ear, plan.hinge),
        (half, plan.hinge),
        *_ear(half, lid, flap, min(0.3 * flap, 8.0)),
        (half, plan.ridge),
        (half - plan.play - t, plan.ridge + t),
        (half - plan.play - t, end, min(0.5 * plan.tuck, 12.0, 0.3 * half)),
    ]
    left = [(-corner[0], *corner[1:]) for corner in reversed(right)]
    return [*right, *left]


def _ear(x: float, span: tuple[float, float], long: float, r: float) -> list[Corner]:
    """Return the corners of an ear, from its lower end to its upper end."""
    low, high = span
    taper = min(2.0, 0.1 * (high - low))
    r = min(r, 0.3 * (high - low))
    return [(x, low), (x + long, low + taper, r), (x + long, high - taper, r), (x, high)]


_CORRUGATED: Final = ("corrugated", "solid board")
STYLES: Final = (
    Style(
        "fefco-0427",
        Message("carton.fefco-0427"),
        Message("carton.fefco-0427.description"),
        Mailer,
        draw_0427,
        Mailer(length=200.0, width=150.0, depth=60.0),
        "e-flute",
        _CORRUGATED,
    ),
    Style(
        "fefco-0471",
        Message("carton.fefco-0471"),
        Message("carton.fefco-0471.description"),
        Mailer,
        draw_0471,
        Mailer(length=200.0, width=150.0, depth=60.0),
        "e-flute",
        _CORRUGATED,
    ),
)
