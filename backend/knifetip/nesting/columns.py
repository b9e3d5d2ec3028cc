"""columns: place the boxes of parts in columns, first fit by decreasing width.

This is what a person does with rectangles.  It is the first arrangement of a search, and the one
with which board use is compared.  Boxes of columns without a gap have common sides.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

from knifetip.nesting.arrangement import Arrangement, Board, FilledSheet, Place
from knifetip.nesting.parts import Part

#: Length that is no overrun (mm): sums of sizes are not exact.
_ROUNDING: Final = 1e-6


class _Sized(NamedTuple):
    part: int
    turn: float
    width: float
    height: float


@dataclass(slots=True)
class _Column:
    x: float
    width: float
    y: float  #: where the next box begins


@dataclass(slots=True)
class _Sheet:
    """A sheet that is being filled."""

    board: Board
    columns: list[_Column]
    places: list[Place]

    def add(self, one: _Sized, gap: float) -> bool:
        """Place a box, and return whether there was room for it."""
        left, below, right, above = self.board.window
        for column in self.columns:
            if one.width <= column.width + _ROUNDING and column.y + one.height <= above + _ROUNDING:
                self._put(one, column, gap)
                return True
        x = self.columns[-1].x + self.columns[-1].width + gap if self.columns else left
        if x + one.width > right + _ROUNDING or below + one.height > above + _ROUNDING:
            return False
        self.columns.append(_Column(x, one.width, below))
        self._put(one, self.columns[-1], gap)
        return True

    def _put(self, one: _Sized, column: _Column, gap: float) -> None:
        self.places.append(Place(one.part, one.turn, column.x, column.y))
        column.y += one.height + gap


def arrange_in_columns(
    parts: Sequence[Part], counts: Sequence[int], boards: Sequence[Board], gap: float
) -> Arrangement | None:
    """Return the parts in columns; None if a part fits on no sheet, or no sheets are left.

    Parameters
    ----------
    parts
        The parts.
    counts
        Number of copies of each part.
    boards
        The kinds of sheets, in the order in which they are used.
    gap
        Distance between two boxes (mm).
    """
    found = []
    for narrow in (True, False):
        sized = [_turned(index, part, boards, narrow=narrow) for index, part in enumerate(parts)]
        boxes = [
            one for one, count in zip(sized, counts, strict=True) if one is not None
            for _ in range(count)
        ]  # fmt: skip
        if len(boxes) < sum(counts):
            return None
        boxes.sort(key=lambda one: (-one.width, -one.height, one.part))
        arrangement = _fill(boxes, boards, gap)
        if arrangement is not None:
            found.append(arrangement)
    return min(found, key=lambda one: one.board_area(parts), default=None)


def _turned(index: int, part: Part, boards: Sequence[Board], *, narrow: bool) -> _Sized | None:
    """Return the box of a part at the turn at which it is narrowest or lowest, if it fits."""
    fitting = [
        _Sized(index, turn, box.width, box.height)
        for turn, box in part.boxes
        if any(fits(box.width, box.height, board) for board in boards)
    ]
    size = (lambda one: one.width) if narrow else (lambda one: one.height)
    return min(fitting, key=size, default=None)


def fits(width: float, height: float, board: Board) -> bool:
    """Return whether a box (mm) fits in the window of a sheet."""
    return width <= board.size[0] + _ROUNDING and height <= board.size[1] + _ROUNDING


def _fill(boxes: list[_Sized], boards: Sequence[Board], gap: float) -> Arrangement | None:
    sheets: list[FilledSheet] = []
    for board in boards:
        used = 0
        while boxes and (board.limit is None or used < board.limit):
            sheet = _Sheet(board, [], [])
            boxes = [one for one in boxes if not sheet.add(one, gap)]
            if not sheet.places:
                break
            sheets.append(FilledSheet(board, tuple(sheet.places)))
            used += 1
    return None if boxes else Arrangement(tuple(sheets))
