"""arrangement: sheets with the places of parts, and how much board they use."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from knifetip.layout.collisions import (
    find_narrow_gaps,
    find_off_window,
    find_overlaps,
    place_blanks,
)
from knifetip.layout.compose import Copy
from knifetip.model.layout import Position
from knifetip.nesting.parts import Part


class Board(NamedTuple):
    """A kind of sheet, and the window in which blanks may lie."""

    width: float  #: mm
    height: float  #: mm
    window: tuple[float, float, float, float]  #: x min, y min, x max, y max (mm)
    limit: int | None  #: number of sheets; None if there is no limit

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the window (mm)."""
        left, below, right, above = self.window
        return right - left, above - below

    def is_like(self, other: Board) -> bool:
        """Return whether the sheets are equal, whatever their numbers."""
        return self._replace(limit=None) == other._replace(limit=None)


class Place(NamedTuple):
    """Place of a copy of a part on a sheet."""

    part: int  #: index into the parts
    turn: float  #: one of the permitted turns of the part (°)
    x: float  #: left side of the box of the copy (mm)
    y: float  #: lower side of the box of the copy (mm)


@dataclass(frozen=True, slots=True)
class FilledSheet:
    """A sheet with the places of the copies on it."""

    board: Board
    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Arrangement:
    """The sheets on which all copies of all parts lie."""

    sheets: tuple[FilledSheet, ...]

    def board_area(self, parts: Sequence[Part]) -> float:
        """Return the area of board that the arrangement takes (mm²).

        Sheets count whole, and the last one up to the right side of its last blank and the right
        margin: the rest of it is a left-over sheet.

        Parameters
        ----------
        parts
            The parts that are placed.
        """
        whole = sum(sheet.board.width * sheet.board.height for sheet in self.sheets[:-1])
        last = self.sheets[-1]
        margin = last.board.width - last.board.window[2]
        return whole + last.board.height * (_right_side(last, parts) + margin)

    def use(self, parts: Sequence[Part]) -> float:
        """Return the share of ``board_area`` that the blanks cover (%)."""
        area = sum(part.area.area * part.quantity for part in parts)
        return float(100.0 * area / self.board_area(parts))


def _right_side(sheet: FilledSheet, parts: Sequence[Part]) -> float:
    return max(one.x + parts[one.part].box(one.turn).width for one in sheet.places)


def is_free_of_collisions(sheet: FilledSheet, parts: Sequence[Part], gap: float) -> bool:
    """Return whether all blanks lie in the window of their sheet and keep the gap.

    It is computed as for layouts, independently of the nesting engine.

    Parameters
    ----------
    sheet
        The sheet.
    parts
        The parts that are placed.
    gap
        Least distance between two blanks (mm).
    """
    copies = [_copy(one, parts[one.part]) for one in sheet.places]
    if find_off_window(copies, sheet.board.window):
        return False
    areas = place_blanks(copies, [[part.area] for part in parts])
    return not find_overlaps(areas) and not find_narrow_gaps(areas, gap)


def _copy(place: Place, part: Part) -> Copy:
    box = part.box(place.turn)
    corner = np.array((place.x, place.y))
    return Copy(
        place.part,
        place.part,
        Position((place.x, place.y), place.turn, part.mirror),
        corner - box.low,
        np.array((place.x, place.y, place.x + box.width, place.y + box.height)),
    )
