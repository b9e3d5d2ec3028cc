"""Tasks of the worker processes about layouts: compose the drawing of a sheet, and check it."""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.errors import PlanError
from knifetip.layout.archive import LayoutArchive
from knifetip.layout.compose import ComposedSheet, Source, compose
from knifetip.model.dieline import Dieline
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.stage import Progress, Stage
from knifetip.presentation.drawing import classified_json
from knifetip.presentation.edges import EdgeTable, restore_drawing
from knifetip.presentation.import_report import import_report_rows, pack_rows
from knifetip.presentation.layout import layout_json
from knifetip.presentation.outcomes import edge_outcomes
from knifetip.service.processes.readings import Reading


def compose_sheet(progress: Progress, content: bytes) -> Reading:
    """Compose the drawing of a sheet; return it in the form in which a drawing is stored.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    content
        The file of a ``LayoutArchive``.

    Raises
    ------
    DrawingTooLarge
        All copies on the sheet have too many edges.
    """
    from knifetip import pipeline
    from knifetip.layout.collisions import find_off_sheet, find_overlaps, place_blanks

    progress(Stage.READ, 0.0)
    archive = LayoutArchive.unpack(content)
    sources, sheet = _compose(archive)
    progress(Stage.CLASSIFY, 0.3)
    areas = place_blanks(sheet.copies, [_blanks(source.dieline) for source in sources])
    overlaps, off = find_overlaps(areas), find_off_sheet(sheet.copies, archive.layout.sheet)
    drawing, dieline = sheet.drawing, sheet.dieline
    outcomes = edge_outcomes(drawing, dieline, pipeline.clean(dieline))
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    questions = pipeline.questions(drawing, dieline)
    progress(Stage.STORE, 0.9)
    return Reading(
        {
            **classified_json(drawing, dieline, outcomes, questions, overrides),
            "learned": [],
            "layout": layout_json(archive.layout, sheet.copies, areas, overlaps, off),
        },
        EdgeTable.from_drawing(drawing, dieline, outcomes).pack(),
        pack_rows(import_report_rows(drawing)),
        overrides.tobytes(),
        [],
    )


def check_sheet(content: bytes, dieline: Dieline) -> None:
    """Check the edges of a sheet, from which a program is to be compiled.

    The verifier compares them with the drawings that were placed on the sheet.

    Parameters
    ----------
    content
        The file of a ``LayoutArchive``.
    dieline
        The edges of the sheet.

    Raises
    ------
    PlanError
        An edge is missing, is not where the layout places it, or belongs to no drawing; two copies
        overlap, or a copy extends over the edge of the sheet.
    """
    from knifetip.layout.collisions import find_off_sheet, find_overlaps, place_blanks
    from knifetip.verification.checks.layout.check import PlacedCopy, check_layout

    archive = LayoutArchive.unpack(content)
    sources, sheet = _compose(archive)
    copies = [PlacedCopy(sources[copy.source].dieline, copy.position) for copy in sheet.copies]
    for finding in check_layout(dieline, copies):
        raise PlanError(finding.message)
    for off in find_off_sheet(sheet.copies, archive.layout.sheet):
        raise PlanError("layout.off-sheet", copy=off.copy + 1, distance=off.distance)
    areas = place_blanks(sheet.copies, [_blanks(source.dieline) for source in sources])
    for pair in find_overlaps(areas):
        raise PlanError("layout.overlap", copy=pair.copy + 1, other=pair.other + 1, area=pair.area)


def _compose(archive: LayoutArchive) -> tuple[list[Source], ComposedSheet]:
    sources = [Source(*restore_drawing(block)) for block in archive.edges]
    return sources, compose(archive.layout, sources, archive.source_of)


def _blanks(dieline: Dieline) -> Any:
    from knifetip import pipeline
    from knifetip.layout.blanks import find_blanks

    return find_blanks(pipeline.clean(dieline).dieline)
