"""holes: place parts in the holes of larger ones, before the engine places the rest.

The nesting engine takes outlines without holes.  Copies of small parts are therefore placed in the
holes of large parts before it begins; it then places each large part together with the parts in its
holes (ADR 169).  These turn with the large part, so a part is placed in a hole only if its own
permitted turns include all turns of the large part.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

import numpy as np
import shapely
from shapely import Polygon

from knifetip.layout.collisions import find_narrow_gaps, find_overlaps
from knifetip.layout.compose import placement_matrix
from knifetip.nesting.arrangement import Arrangement, FilledSheet, Place
from knifetip.nesting.inner_fit import lowest_position, simpler_around, simpler_inside
from knifetip.nesting.parts import Part
from knifetip.nesting.problem import Problem

#: Distance that is added to the gap, for rounding (mm).
_ADDED: Final = 0.01
#: Most copies in the holes of one part.
_MOST: Final = 200
#: Most turns that are tried for each part.
_TURNS: Final = 24
#: Share of the time of the search after which no more holes are filled, and the longest time (s).
_SHARE: Final = 0.2
_LONGEST: Final = 10.0
#: Largest difference of two turns that are the same (°).
_SAME: Final = 1e-6
#: Decimals of the places of copies (mm).
_DECIMALS: Final = 4


class _Guest(NamedTuple):
    """A copy in a hole of another part, which has its first turn and is not moved."""

    part: int  #: index into the parts
    turn: float  #: °
    shift: tuple[float, float]  #: after the turn (mm)


class _Filled(NamedTuple):
    """A part, and the copies of other parts that lie in its holes."""

    part: int  #: index into the parts
    guests: tuple[_Guest, ...]


@dataclass(frozen=True, eq=False, slots=True)
class FilledHoles:
    """A problem whose parts have other parts in their holes."""

    problem: Problem
    original: Sequence[Part]
    filled: tuple[_Filled, ...]  #: what each part of ``problem`` consists of

    def expand(self, arrangement: Arrangement) -> Arrangement:
        """Return the arrangement with the copies in holes as copies of their own parts."""
        return Arrangement(
            tuple(
                FilledSheet(
                    sheet.board,
                    tuple(place for one in sheet.places for place in self._places(one)),
                )
                for sheet in arrangement.sheets
            )
        )

    def count(self, arrangement: Arrangement) -> int:
        """Return the number of copies that lie in holes, in an arrangement of the problem."""
        return sum(
            len(self.filled[one.part].guests)
            for sheet in arrangement.sheets
            for one in sheet.places
        )

    def _places(self, place: Place) -> list[Place]:
        """Return the place of a copy, and those of the copies in its holes."""
        index, guests = self.filled[place.part]
        host = self.original[index]
        turned = place.turn - host.boxes[0][0]
        matrix = placement_matrix(turned, mirror=False)
        corner = np.array((place.x, place.y)) - host.box(place.turn).low
        places = [place._replace(part=index)]
        for guest in guests:
            part = self.original[guest.part]
            turn = _own_turn(part, guest.turn + turned)
            assert turn is not None, "guests have turns that fit all turns of the host"
            x, y = part.box(turn).low + np.array(guest.shift) @ matrix + corner
            places.append(
                Place(guest.part, turn, round(float(x), _DECIMALS), round(float(y), _DECIMALS))
            )
        return places


def fill_holes(problem: Problem, stopped: Callable[[], bool] = lambda: False) -> FilledHoles:
    """Return a problem in which many copies lie in holes of others, if the problem permits it.

    Parts with holes are filled in descending order of their size, and each hole with the largest
    copies that fit.  Copies that lie in holes may have holes of their own, which are filled, too.

    Parameters
    ----------
    problem
        The problem of which copies are placed in holes.
    stopped
        Called before each copy; returns True if no more copies shall be placed in holes.
    """
    parts = problem.parts
    end = time.monotonic() + min(_SHARE * problem.seconds, _LONGEST)

    def ends() -> bool:
        return not problem.in_holes or stopped() or time.monotonic() > end

    left = [part.quantity for part in parts]
    filled, quantities = [], []
    for index in _by_area(parts):
        count, left[index] = left[index], 0
        while count:
            guests = _fill(index, left, problem, ends)
            need = Counter(guest.part for guest in guests)
            alike = min([count, *(left[part] // number for part, number in need.items())])
            for part, number in need.items():
                left[part] -= alike * number
            count -= alike
            filled.append(_Filled(index, guests))
            quantities.append(alike)
    composed = [
        replace(_composed(one, parts), quantity=quantity)
        for one, quantity in zip(filled, quantities, strict=True)
    ]
    return FilledHoles(replace(problem, parts=composed), parts, tuple(filled))


def _by_area(parts: Sequence[Part]) -> list[int]:
    """Return the indices of the parts, largest first."""
    return sorted(range(len(parts)), key=lambda index: -parts[index].area.area)


def _fill(
    index: int, left: Sequence[int], problem: Problem, ends: Callable[[], bool]
) -> tuple[_Guest, ...]:
    """Return copies in the holes of a part.

    ``index``: index of the part.
    ``left``: number of copies of each part that have no place yet.
    ``ends``: called before each copy; returns True if no more copies are placed.
    """
    parts, host = problem.parts, problem.parts[index]
    left = [*left]
    guests: list[_Guest] = []
    waiting = [_moved(hole, host, host.boxes[0][0]) for hole in host.holes]
    candidates = [other for other in _by_area(parts) if left[other]]
    outlines = {other: simpler_around(parts[other].outline) for other in candidates}
    while waiting:
        hole = waiting.pop()
        free = simpler_inside(shapely.buffer(hole, -(problem.gap + _ADDED), join_style="mitre"))
        for other in candidates:
            part = parts[other]
            turns = _common_turns(host, part)
            while left[other] and part.area.area <= free.area and len(guests) < _MOST:
                guest = None if ends() else _lowest(other, outlines[other], part, turns, free)
                if guest is None:
                    break
                guests.append(guest)
                left[other] -= 1
                outline = _moved(outlines[other], part, guest.turn, guest.shift)
                taken = shapely.buffer(outline, problem.gap + _ADDED, join_style="mitre")
                free = shapely.difference(free, taken)
                waiting += [_moved(hole, part, guest.turn, guest.shift) for hole in part.holes]
    areas = _areas(_Filled(index, tuple(guests)), parts)
    if find_overlaps(areas) or find_narrow_gaps(areas, problem.gap):
        return ()
    return tuple(guests)


def _lowest(
    index: int, outline: Polygon, part: Part, turns: list[float], free: shapely.Geometry
) -> _Guest | None:
    """Return the lowest place of a part in a free area, None if there is none.

    Of several turns it is the one whose upper side is lowest, and then the one farthest left.
    Turns at which the part has no place in the area are removed from ``turns``.
    """
    best, least = None, (math.inf, math.inf)
    for turn in [*turns]:
        corners = shapely.get_coordinates(_moved(outline, part, turn).exterior)[:-1]
        shift = lowest_position(free, corners)
        if shift is None:
            turns.remove(turn)
            continue
        right, above = (corners.max(axis=0) + shift).tolist()
        if (above, right) < least:
            best, least = _Guest(index, turn, (float(shift[0]), float(shift[1]))), (above, right)
    return best


def _common_turns(host: Part, guest: Part) -> list[float]:
    """Return the turns at which a part may lie in a hole of another one at its first turn.

    Each turn of the other one then gives it one of its own turns.
    """
    first = host.boxes[0][0]
    return [
        turn
        for turn, _ in guest.boxes[:_TURNS]
        if all(_own_turn(guest, turn + other - first) is not None for other, _ in host.boxes)
    ]


def _own_turn(part: Part, turn: float) -> float | None:
    """Return the permitted turn of a part that equals another one but for whole turns, if any."""
    for own, _ in part.boxes:
        if abs((own - turn + 180.0) % 360.0 - 180.0) < _SAME:
            return own
    return None


def _moved(
    shape: shapely.Geometry, part: Part, turn: float, shift: tuple[float, float] = (0.0, 0.0)
) -> shapely.Geometry:
    """Return a shape of a drawing after the drawing was mirrored, turned and moved."""
    matrix = placement_matrix(turn, mirror=part.mirror)
    return shapely.transform(shape, lambda points: points @ matrix + shift)


def _areas(one: _Filled, parts: Sequence[Part]) -> list[shapely.Geometry]:
    """Return the board of a part at its first turn, and that of the copies in its holes."""
    host = parts[one.part]
    placed = [(parts[guest.part], guest.turn, guest.shift) for guest in one.guests]
    return [
        _moved(host.area, host, host.boxes[0][0]),
        *(_moved(part.area, part, turn, shift) for part, turn, shift in placed),
    ]


def _composed(one: _Filled, parts: Sequence[Part]) -> Part:
    """Return a part whose board is that of a part and of the copies in its holes."""
    host = parts[one.part]
    if not one.guests:
        return host
    back = placement_matrix(host.boxes[0][0], mirror=host.mirror).T
    area = shapely.union_all(_areas(one, parts))
    area = shapely.transform(area, lambda points: points @ back)
    return replace(host, area=area, holes=())
