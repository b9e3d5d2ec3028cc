"""fit: place given numbers of copies on one sheet with the engine."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from typing import Final

from knifetip.nesting.arrangement import Board, FilledSheet, is_free_of_collisions
from knifetip.nesting.engine import Strip, fill_strip
from knifetip.nesting.problem import Problem
from knifetip.nesting.shapes import place_of, shape_of

#: Least time of a try (s).
LEAST: Final = 0.5
#: Distance that is added to the gap, since the engine computes with 32-bit numbers (mm).
_ADDED: Final = 0.01
#: Part of its time after which a search gives up that has found nothing yet.
_PATIENCE: Final = 0.4


def fit_on_sheet(
    problem: Problem,
    board: Board,
    counts: Sequence[int],
    seconds: float,
    stopped: Callable[[], bool],
    *,
    is_sure: bool = False,
) -> Generator[FilledSheet]:
    """Yield sheets with all copies, each with a shorter strip than the one before.

    The search ends early if it finds nothing in the first part of its time, unless it is sure that
    all copies fit.

    Parameters
    ----------
    problem, board
        The parts and the gap between them, and the sheet.
    counts
        Number of copies of each part.
    seconds
        Time of the search.
    stopped
        Called several times per second; returns True to end the search.
    is_sure
        Whether all copies are known to fit on the sheet.
    """
    if not any(counts):
        return
    used = [index for index, count in enumerate(counts) if count]
    shapes = [shape_of(problem.parts[index], counts[index]) for index in used]
    width, height = board.size
    strip = Strip(height, problem.gap + _ADDED, shapes, seconds, problem.seed)
    begun = time.monotonic()
    is_found = False

    def ends() -> bool:
        patience = seconds if is_found or is_sure else max(LEAST, _PATIENCE * seconds)
        return stopped() or time.monotonic() - begun > patience

    with closing(fill_strip(strip, ends)) as fillings:
        for filling in fillings:
            if filling.length > width + _ADDED:
                continue
            places = tuple(
                place_of(one, used[one.shape], problem.parts[used[one.shape]], board)
                for one in filling.placed
            )
            sheet = FilledSheet(board, places)
            if is_free_of_collisions(sheet, problem.parts, problem.gap):
                is_found = True
                yield sheet
