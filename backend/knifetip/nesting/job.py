"""job: the problem of a ``NestingJob``, and the layouts of an arrangement."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from knifetip.errors import PlanError
from knifetip.model.layout import Layout, PlacedDrawing
from knifetip.model.nesting import NestingJob
from knifetip.nesting.arrangement import Arrangement, Board
from knifetip.nesting.parts import Part
from knifetip.nesting.problem import Problem


def problem_of(job: NestingJob, parts: Sequence[Part]) -> Problem:
    """Return what is to be searched; left-over sheets are used first, smallest first.

    Parameters
    ----------
    job
        The sheets and the parts.
    parts
        The shapes of the parts, in the order of ``job.parts``.

    Raises
    ------
    PlanError
        The margins leave no room on the sheet.
    """
    counts: Counter[tuple[float, float]] = Counter()
    for one in job.left_overs:
        counts[one.width, one.height] += one.count
    small = sorted(counts, key=lambda size: size[0] * size[1])
    boards = [_board(*size, job, counts[size]) for size in small]
    whole = _board(job.sheet.width, job.sheet.height, job, None)
    if min(whole.size) <= 0.0:
        raise PlanError("nesting.no-room", width=job.sheet.width, height=job.sheet.height)
    usable = [board for board in boards if min(board.size) > 0.0]
    return Problem(parts, [*usable, whole], job.gap, job.seconds, job.seed, job.in_holes)


def _board(width: float, height: float, job: NestingJob, count: int | None) -> Board:
    margins = job.margins
    window = (margins.left, margins.below, width - margins.right, height - margins.above)
    return Board(width, height, window, count)


def layouts_of(arrangement: Arrangement, job: NestingJob, revisions: Sequence[int]) -> list[Layout]:
    """Return the layout of each sheet.

    Parameters
    ----------
    arrangement
        The places of all copies.
    job
        The job whose parts are placed.
    revisions
        Revision of the drawing of each part; 0 for none.
    """
    return [
        Layout(
            sheet=job.sheet.model_copy(
                update={"width": sheet.board.width, "height": sheet.board.height}
            ),
            placed=tuple(
                PlacedDrawing(
                    drawing=job.parts[place.part].drawing,
                    revision=revisions[place.part] or None,
                    x=place.x,
                    y=place.y,
                    turn=place.turn,
                    mirror=job.parts[place.part].mirror,
                )
                for place in sheet.places
            ),
        )
        for sheet in arrangement.sheets
    ]
