"""search: fill sheets one after the other with as many blanks as possible.

Sparrow places given shapes in a strip of given height that is as short as possible.  Shapes fit on
a sheet if their strip is not longer than the sheet.  All parts that are left are tried first.  If
they do not fit, the copies are sorted by area, and the greatest number of them that fits is found
by bisection, between what columns of boxes achieve and what the area permits.  Then smaller parts
are added.  The last sheet is made as short as possible.  Columns of boxes are kept where the engine
finds nothing better, so that there is a complete arrangement at every time (ADR 150).  Parts in
holes of others are placed before, and are placed with these (ADR 169).
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from typing import Final

from knifetip.errors import PlanError
from knifetip.nesting.arrangement import Arrangement, Board, FilledSheet
from knifetip.nesting.columns import arrange_in_columns, fits
from knifetip.nesting.counts import (
    by_area,
    counts_of,
    is_prefix,
    most_within,
    placed_counts,
    without,
)
from knifetip.nesting.fit import LEAST, fit_on_sheet
from knifetip.nesting.holes import FilledHoles, fill_holes
from knifetip.nesting.problem import Problem, check_sizes

#: Most sheets of an arrangement.
MOST_SHEETS: Final = 100
#: Part of the time of a sheet for one try to fit shapes on it.
_TRY: Final = 0.2
#: Part of the board that nested blanks cover, to estimate the number of sheets.
_COVERED: Final = 0.8


@dataclass(frozen=True, slots=True)
class Found:
    """The best arrangement so far."""

    arrangement: Arrangement
    use: float  #: share of the board that the blanks cover (%)
    columns_use: float  #: the same of boxes in columns (%)
    seconds: float  #: since the search began
    in_holes: int  #: number of copies that lie in holes of others


def nest(
    problem: Problem,
    report: Callable[[Found], None],
    stopped: Callable[[], bool] = lambda: False,
) -> Found:
    """Return the best arrangement that is found before the time is over.

    Parameters
    ----------
    problem
        The parts and the sheets.
    report
        Called with each better arrangement; first, within moments, with boxes in columns.
    stopped
        Called several times per second; returns True to end the search and keep the best.

    Raises
    ------
    PlanError
        A part fits on no sheet, or more than ``MOST_SHEETS`` sheets are needed.
    """
    check_sizes(problem)
    begun = time.monotonic()
    filled = fill_holes(problem, stopped)
    search = _Search(filled.problem, report, stopped, begun, filled)
    return search.run()


@dataclass(slots=True)
class _Search:
    problem: Problem
    report: Callable[[Found], None]
    stopped: Callable[[], bool]
    begun: float
    holes: FilledHoles
    best: Found | None = None
    filled: list[FilledSheet] = field(default_factory=list)

    def run(self) -> Found:
        remaining = [part.quantity for part in self.problem.parts]
        if not self._offer(None, remaining) or self.best is None:
            raise PlanError("nesting.too-many-sheets", limit=MOST_SHEETS)
        while any(remaining) and not self._ends():
            sheet = self._next_sheet(remaining)
            if sheet is None:
                break
            remaining = without(remaining, sheet)
            self._offer(sheet, remaining)
            self.filled.append(sheet)
        return self.best

    def _next_sheet(self, remaining: Sequence[int]) -> FilledSheet | None:
        """Return the next sheet: of the first kind on which a part fits."""
        for board in self._boards_left():
            sheet = self._again(board, remaining)
            if sheet is None:
                sheet = self._fill(board, remaining, self._share(board, remaining))
            if sheet is not None:
                return sheet
        return None

    def _again(self, board: Board, remaining: Sequence[int]) -> FilledSheet | None:
        """Return the sheet before once more, if there are enough copies left for it."""
        if not self.filled or not self.filled[-1].board.is_like(board):
            return None
        again = FilledSheet(board, self.filled[-1].places)
        return again if min(without(remaining, again)) >= 0 else None

    def _ends(self) -> bool:
        return self.stopped() or self._left() <= 0.0

    def _left(self) -> float:
        return self.begun + self.problem.seconds - time.monotonic()

    def _boards_left(self) -> list[Board]:
        """Return the kinds of sheets that are left for the parts that are left."""
        left = []
        for board in self.problem.boards:
            used = sum(sheet.board.is_like(board) for sheet in self.filled)
            if board.limit is None:
                left.append(board)
            elif used < board.limit:
                left.append(board._replace(limit=board.limit - used))
        return left

    def _share(self, board: Board, remaining: Sequence[int]) -> float:
        """Return the time for the next sheet (s)."""
        width, height = board.size
        area = self._area(remaining)
        return self._left() / max(1, math.ceil(area / (_COVERED * width * height)))

    def _area(self, counts: Sequence[int]) -> float:
        return sum(
            float(part.area.area) * count
            for part, count in zip(self.problem.parts, counts, strict=True)
        )

    def _offer(self, sheet: FilledSheet | None, remaining: Sequence[int]) -> bool:
        """Keep an arrangement if it is the best.

        It has the filled sheets, ``sheet``, and columns for the rest.  Returns whether it is
        complete.
        """
        parts = self.problem.parts
        sheets = [*self.filled, *([] if sheet is None else [sheet])]
        if any(remaining):
            before, self.filled = self.filled, sheets
            rest = arrange_in_columns(parts, remaining, self._boards_left(), self.problem.gap)
            self.filled = before
            if rest is None or len(sheets) + len(rest.sheets) > MOST_SHEETS:
                return False
            sheets += rest.sheets
        arrangement = Arrangement(tuple(sheets))
        use = arrangement.use(parts)
        if self.best is None or use > self.best.use + 1e-9:
            columns_use = use if self.best is None else self.best.columns_use
            seconds = time.monotonic() - self.begun
            in_holes = self.holes.count(arrangement)
            self.best = Found(self.holes.expand(arrangement), use, columns_use, seconds, in_holes)
            self.report(self.best)
        return True

    def _fill(self, board: Board, remaining: Sequence[int], seconds: float) -> FilledSheet | None:
        """Return a sheet with as many of the parts that are left as the time permits to find."""
        end = time.monotonic() + seconds
        fitting = [
            count if any(fits(box.width, box.height, board) for _, box in part.boxes) else 0
            for part, count in zip(self.problem.parts, remaining, strict=True)
        ]
        if not any(fitting):
            return None
        best = self._columns(board, fitting)
        order = by_area(self.problem.parts, fitting)
        width, height = board.size
        if self._area(fitting) <= width * height:
            is_sure = best is not None and len(best.places) == len(order)
            whole = self._shorten(board, fitting, seconds, remaining, is_sure=is_sure)
            if whole is not None or is_sure:
                return whole or best
        low, high = 0, most_within(order, self.problem.parts, width * height)
        if best is not None and is_prefix(best, order):
            low = len(best.places)
        while low < high and time.monotonic() < end and not self._ends():
            middle = (low + high + 1) // 2
            counts = counts_of(order[:middle], len(fitting))
            found = self._try(board, counts, _TRY * seconds, remaining)
            if found is None:
                high = middle - 1
            else:
                low, best = middle, self._larger(found, best)
        return self._add_smaller(board, best, fitting, end, remaining)

    def _add_smaller(
        self,
        board: Board,
        best: FilledSheet | None,
        fitting: Sequence[int],
        end: float,
        remaining: Sequence[int],
    ) -> FilledSheet | None:
        """Return a sheet to which parts were added, each kind with as many copies as fit."""
        if best is None:
            return None
        width, height = board.size
        for index in sorted(range(len(fitting)), key=lambda i: -self.problem.parts[i].area.area):
            on_sheet = placed_counts(best, len(fitting))
            area = self.problem.parts[index].area.area
            free = width * height - self._area(on_sheet)
            more = min(fitting[index] - on_sheet[index], int(free / area))
            while more > 0 and time.monotonic() < end and not self._ends():
                counts = [*on_sheet]
                counts[index] += more
                seconds = _TRY * (end - time.monotonic())
                found = self._try(board, counts, seconds, remaining)
                if found is not None:
                    best = found
                    break
                more //= 2
        return best

    def _larger(self, one: FilledSheet, other: FilledSheet | None) -> FilledSheet:
        """Return the sheet with more area of blanks on it."""
        if other is None:
            return one
        count = len(self.problem.parts)
        first, second = (self._area(placed_counts(sheet, count)) for sheet in (one, other))
        return one if first >= second else other

    def _columns(self, board: Board, counts: Sequence[int]) -> FilledSheet | None:
        """Return the first sheet of boxes in columns."""
        some = arrange_in_columns(
            self.problem.parts, counts, [board._replace(limit=None)], self.problem.gap
        )
        if some is None or not some.sheets:
            return None
        return FilledSheet(board, some.sheets[0].places)

    def _shorten(
        self,
        board: Board,
        counts: Sequence[int],
        seconds: float,
        remaining: Sequence[int],
        *,
        is_sure: bool,
    ) -> FilledSheet | None:
        """Return a sheet with given numbers of copies whose strip is short, None if none is found.

        ``is_sure``: whether the copies are known to fit.
        """
        fitting = fit_on_sheet(
            self.problem, board, counts, self._at_most(seconds), self.stopped, is_sure=is_sure
        )
        best = None
        with closing(fitting) as found:
            for best in found:
                self._offer(best, without(remaining, best))
        return best

    def _try(
        self, board: Board, counts: Sequence[int], seconds: float, remaining: Sequence[int]
    ) -> FilledSheet | None:
        """Return a sheet with given numbers of copies, None if none is found in time."""
        seconds = self._at_most(seconds)
        with closing(fit_on_sheet(self.problem, board, counts, seconds, self.stopped)) as found:
            sheet = next(found, None)
        if sheet is not None:
            self._offer(sheet, without(remaining, sheet))
        return sheet

    def _at_most(self, seconds: float) -> float:
        """Return the time of a search: at least ``LEAST``, at most what is left (s)."""
        return max(min(max(seconds, LEAST), self._left()), 0.0)
