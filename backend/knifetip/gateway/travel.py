"""travel: find the first move of a program that leaves the travel of its controller.

LinuxCNC compares a move with the limits only when it has read as far as this move, with the tool
in the board, and of an arc it compares only the end.  The whole program is therefore compared
before it starts.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterable
from dataclasses import dataclass

from knifetip.gateway.interpreter import Block
from knifetip.gateway.motion import Move, Pose
from knifetip.gateway.program_blocks import TURN

#: Excess that does not count (mm or degrees): programs and reports are rounded.
ROUNDING = 1e-3
_QUARTER = math.pi / 2.0


@dataclass(frozen=True, slots=True)
class Travel:
    """Lowest and highest positions of X, Y, Z and C in coordinates of the machine.

    ``offset`` is added to coordinates of programs to get coordinates of the machine.  All values
    are in mm and degrees; an axis without limits has infinite ones.
    """

    low: Pose
    high: Pose
    offset: Pose


@dataclass(frozen=True, slots=True)
class Excess:
    """The first move of a program that leaves the travel."""

    line: int  #: number of its program line, from 1
    axis: int  #: index of the axis: 0 to 3 for X, Y, Z and C
    position: float  #: farthest position, in coordinates of the machine (mm or degrees)
    limit: float  #: limit that it exceeds


async def find_excess(blocks: Iterable[Block | None], travel: Travel) -> Excess | None:
    """Return the first move of a program that leaves the travel; None if there is none.

    Yields to the event loop after every ``TURN`` lines.

    Parameters
    ----------
    blocks
        The effect of each program line, None for a line that is refused.
    travel
        Travel of the controller.
    """
    for line, block in enumerate(blocks, 1):
        if block is not None and block.move is not None and not block.in_machine_coordinates:
            low, high = reach(block.move)
            for axis, offset in enumerate(travel.offset):
                for position, limit, sign in (
                    (low[axis] + offset, travel.low[axis], -1.0),
                    (high[axis] + offset, travel.high[axis], 1.0),
                ):
                    if sign * (position - limit) > ROUNDING:
                        return Excess(line, axis, position, limit)
        if line % TURN == 0:
            await asyncio.sleep(0)
    return None


def reach(move: Move) -> tuple[Pose, Pose]:
    """Return the lowest and the highest position of each axis along a move."""
    poses = [move.start, move.end]
    if move.centre is not None:
        poses += [move.at(fraction) for fraction in _quadrants(move, move.centre)]
    columns = list(zip(*poses, strict=True))
    x, y, z, c = ((min(column), max(column)) for column in columns)
    return (x[0], y[0], z[0], c[0]), (x[1], y[1], z[1], c[1])


def _quadrants(move: Move, centre: tuple[float, float]) -> list[float]:
    """Return the fractions of an arc at which it is farthest left, right, above or below."""
    begin = math.atan2(move.start[1] - centre[1], move.start[0] - centre[0])
    low, high = sorted((begin, begin + move.sweep))
    steps = range(math.ceil(low / _QUARTER), math.floor(high / _QUARTER) + 1)
    return [(step * _QUARTER - begin) / move.sweep for step in steps]
