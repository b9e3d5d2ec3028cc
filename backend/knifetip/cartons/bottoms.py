"""bottoms: bottoms of a tube that lock: glued crash-lock bottoms, and snap-lock (1-2-3) bottoms.

In the closed bottom, p is the distance along the length, and w the distance from the panel on which
a flap hangs.
"""

from __future__ import annotations

from knifetip.cartons import allowances
from knifetip.cartons.carton import Point
from knifetip.cartons.draft import Draft
from knifetip.cartons.parameters import check_least
from knifetip.cartons.tube import PANELS, Flap, Tube
from knifetip.cartons.tuck import TuckCarton
from knifetip.model.board import Board


def crash_lock_bottom(tube: Tube, draft: Draft, size: TuckCarton, board: Board) -> list[Flap]:
    """Return the four flaps of a crash-lock bottom, and add them to a draft.

    The triangle of each small flap, beyond its diagonal crease, is glued to the large flap beside
    it.  While the carton is flat, the triangle is folded back; in the open carton it lies in the
    plane of its flap again, so the angle of the crease is 0.  The points of the diagonal have equal
    distances from both panels, which makes the folding possible.  Each large flap is longer on the
    side of its glued corner, and the two hook into each other in the middle.

    Raises
    ------
    ImpossibleCarton
        A dimension does not permit the bottom.
    """
    t = board.caliper
    gap = allowances.play(t) + t
    check_least("length", size.length, 30.0 + 4.0 * t, board)
    check_least("length", size.length, 0.8 * size.width, board)
    check_least("width", size.width, 20.0 + 4.0 * t, board)
    whole = size.width + t
    small = min(0.45 * whole, 0.45 * size.length)
    short, long = 0.5 * whole - 0.5 * t, 0.7 * whole
    flaps: list[Flap] = []
    for panel, name in enumerate(PANELS):
        a, b = tube.span(panel)

        def at(u: float, v: float) -> Point:
            return tube.point((u, v), top=False)

        if panel % 2 == 0:
            middle = 0.5 * (a + b)
            box = (*at(a + gap, 0.0), *at(b - gap, long))
            draft.panel(f"bottom-{name}", box, name, (at(a + gap, 0.0), at(b, 0.0)))
            hook = 0.15 * (b - a)
            flaps.append(
                [
                    (a + gap, 0.0),
                    (a + gap, 0.5 * short),
                    (a + gap + 0.08 * (b - a), short),
                    (middle, short),
                    (middle + 0.5 * hook, long, 0.2 * hook),
                    (b - 0.06 * (b - a) - gap, long, 0.2 * hook),
                    (b - gap, 0.6 * long),
                    (b, 0.0),
                ]
            )
            continue
        flap, tab = f"bottom-{name}", f"bottom-glue-{name}"
        box = (*at(a, 0.0), *at(b - gap, small))
        draft.panel(flap, box, name, (at(a, 0.0), at(b - gap, 0.0)))
        diagonal = at(a, 0.0), at(a + small, small)
        box = (*at(a, 0.0), *at(a + small, small))
        inside = at(a + gap + 0.25 * small, 0.75 * small)
        draft.panel(tab, box, flap, diagonal, angle=0.0, point=inside)
        flaps.append(
            [
                (a, 0.0),
                (a + gap, small),
                (a + small, small),
                (a + 0.6 * (b - a), small),
                (b - gap, 0.35 * small),
                (b - gap, 0.0),
            ]
        )
    return flaps


def snap_lock_bottom(tube: Tube, draft: Draft, size: TuckCarton, board: Board) -> list[Flap]:
    """Return the four flaps of a snap-lock bottom, and add them to a draft.

    The flap of the back folds first, then the two side flaps; the tongue of the front flap is
    pushed through the recess of the first flap, behind its edge in the middle.

    Raises
    ------
    ImpossibleCarton
        A dimension does not permit the bottom.
    """
    t = board.caliper
    play = allowances.play(t)
    inset = t + play
    check_least("length", size.length, 40.0 + 8.0 * inset, board)
    check_least("width", size.width, 30.0 + 8.0 * inset, board)
    check_least("length", size.length, 0.6 * size.width, board)
    whole, half = size.width + t, 0.2 * (size.length + t)
    edge, legs = 0.5 * whole - t, 0.7 * whole
    side = min(0.3 * size.length - play, 0.6 * whole)
    shoulder, tongue = 0.45 * whole, 0.7 * whole
    flaps: list[Flap] = []
    for panel, name in enumerate(PANELS):
        a, b = tube.span(panel)
        u, v, middle = a + inset, b - inset, 0.5 * (a + b)
        if name == "back":
            long, flap = legs, _recessed(u, v, middle, (half, edge, legs))
        elif name == "front":
            # The tongue is narrower than the recess by the play and the board.
            long, flap = tongue, _tongued(u, v, middle, (half - inset, shoulder, tongue))
        else:
            # The half at the front is the longer one.
            long, flap = side, _side_flap(u, v, side, rising=name == "left")
        start, end, far = (tube.point(one, top=False) for one in ((u, 0.0), (v, 0.0), (v, long)))
        draft.panel(f"bottom-{name}", (*start, *far), name, (start, end))
        flaps.append(flap)
    return flaps


def _recessed(u: float, v: float, middle: float, sizes: tuple[float, float, float]) -> Flap:
    """Return a flap with a recess in its edge: half its width, then where it begins and ends."""
    half, edge, end = sizes
    slope = 0.3 * (middle - half - u)
    return [
        (u, 0.0),
        (u, 0.5 * end),
        (u + slope, end),
        (middle - half, end),
        (middle - half, edge),
        (middle + half, edge),
        (middle + half, end),
        (v - slope, end),
        (v, 0.5 * end),
        (v, 0.0),
    ]


def _tongued(u: float, v: float, middle: float, sizes: tuple[float, float, float]) -> Flap:
    """Return a flap with a tongue: half its width, then where it begins and ends."""
    half, shoulder, end = sizes
    r = min(0.4 * half, 0.5 * (end - shoulder))
    slope = 0.3 * (middle - half - u)
    return [
        (u, 0.0),
        (u, 0.5 * shoulder),
        (u + slope, shoulder),
        (middle - half, shoulder),
        (middle - half, end, r),
        (middle + half, end, r),
        (middle + half, shoulder),
        (v - slope, shoulder),
        (v, 0.5 * shoulder),
        (v, 0.0),
    ]


def _side_flap(u: float, v: float, long: float, *, rising: bool) -> Flap:
    """Return a side flap whose longer half lies to the right (rising) or to the left."""
    wide = v - u
    flap = [(0.0, 0.0), (0.1 * wide, 0.4 * long), (0.45 * wide, long), (0.9 * wide, long)]
    flap += [(wide, 0.5 * long), (wide, 0.0)]
    if rising:
        return [(u + x, y) for x, y in flap]
    return [(v - x, y) for x, y in reversed(flap)]
