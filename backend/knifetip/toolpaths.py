"""toolpaths: plan the work on cleaned edges and return the tool path.

::

    Cleaned → Operations → Toolpaths → Toolpath
          plan     compensate   sequence

``pipeline.compile`` writes and verifies the program of the tool path.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from knifetip.compensation.compensate import compensate
from knifetip.compensation.contour_starts import contour_starts
from knifetip.compensation.edge_feeds import with_edge_feeds
from knifetip.errors import PlanError
from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import LineType
from knifetip.model.job_options import JobOptions
from knifetip.model.machine import Machine
from knifetip.model.operation import Operation
from knifetip.model.stage import Progress, Stage
from knifetip.model.toolpath import Toolpath
from knifetip.planning.boundary import BoardOutline
from knifetip.planning.chosen_bridges import ChosenBridge
from knifetip.planning.chosen_starts import ChosenStart, apply_starts
from knifetip.planning.plan import check_corners, plan
from knifetip.planning.registration import measured_similarity
from knifetip.planning.sheet_outline import sheet_outline
from knifetip.sequencing.chosen_order import ChosenOrder
from knifetip.sequencing.contour_starts import choose_starts
from knifetip.sequencing.duration import duration
from knifetip.sequencing.sequence import sequence


@dataclass(frozen=True, eq=False, slots=True)
class CleanedChoices:
    """A user's choices for cleaned edges, at their position on the table."""

    starts: Sequence[ChosenStart]
    work: ChosenWork
    order: ChosenOrder | None
    bridges: Sequence[ChosenBridge]


def check_options(options: JobOptions, machine: Machine) -> None:
    """Raise ``PlanError`` if a machine cannot satisfy the user's options for a job."""
    check_corners(options.corners, machine)
    if options.lift == "least" and machine.turn_clearance == 0.0:
        raise PlanError("lift.not-stated", machine=machine.title)


def find_toolpath(
    cleaned: Cleaned,
    offset: tuple[float, float],
    machine: Machine,
    board: Board,
    options: JobOptions,
    chosen: CleanedChoices,
    progress: Progress,
) -> Toolpath:
    """Return the tool path for cleaned edges.

    The column ``source`` of the tool path contains for each move the index in the drawing of the
    edge that the move makes, or -1 if it makes none.

    ``offset``: shift (x, y) in mm that moves the drawing to its position on the machine's table.
    ``options``: the user's options for the job.
    ``chosen``: the user's choices for cleaned edges.
    ``progress``: called at the start of each stage with the completed fraction of the compile, 0 …
    1.
    Raises ``PlanError, CompensationError``: the drawing cannot be made on this machine, board and
    sheet.
    """
    safety = machine.turn_clearance if options.lift == "least" else 0.0
    shifted = replace(cleaned.dieline, ends=cleaned.dieline.ends + np.array(offset))
    progress(Stage.PLAN, 0.05)
    outlines: list[BoardOutline | None] = [None]
    if options.sheet is not None:
        similarity = measured_similarity(options)
        turn = 0.0 if similarity is None else similarity.turn
        sheet = sheet_outline(options.sheet, shifted, machine, turn)
        # Only grooves run out past the edges of a sheet.
        if (shifted.line_type == LineType.V_GROOVE).any():
            outlines.append(sheet)
    found = []
    for outline in outlines:
        operations = plan(
            shifted,
            machine,
            board,
            options.corners,
            outline,
            offset,
            chosen.work,
            chosen.bridges,
        )
        operations = apply_starts(operations, chosen.starts, together=chosen.order is not None)
        progress(Stage.COMPENSATE, 0.2)
        toolpaths = [
            with_edge_feeds(compensate(_with_starts(operation, machine)), chosen.work)
            for operation in operations
        ]
        progress(Stage.SEQUENCE, 0.4)
        edges = None if outline is None else outline.edges
        found.append(sequence(toolpaths, machine, edges, safety, chosen.order))
    # Leaving the sheet takes time, too: it does not pay for each drawing.
    toolpath = min(found, key=lambda one: duration(one, machine)) if len(found) > 1 else found[0]
    source = cleaned.dieline.source[np.maximum(toolpath.source, 0)]
    return replace(toolpath, source=np.where(toolpath.source < 0, -1, source))


def _with_starts(operation: Operation, machine: Machine) -> Operation:
    """Return an operation whose closed paths begin where the air moves between the paths are short.

    If its tool has no choice, the operation is returned unchanged.
    """
    starts = contour_starts(operation)
    if starts is None:
        return operation
    return replace(
        operation, begin=choose_starts(starts, machine.station(operation.station), machine)
    )
