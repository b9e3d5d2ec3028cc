"""Tasks of the worker processes that fold a drawing, as gzip data."""

from __future__ import annotations

from knifetip.errors import UnitUnknown
from knifetip.folding.records import FoldOptions, FoldTree
from knifetip.model.board import Board
from knifetip.model.stage import Progress, Stage
from knifetip.presentation.edges import restore_drawing
from knifetip.service.folding.models import FoldingOut
from knifetip.service.http.compression import pack


def folding(
    progress: Progress, edges: bytes, board: Board, options: FoldOptions, fraction: float
) -> bytes:
    """Return the JSON of a folded drawing (schema ``FoldingOut``).

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    edges
        Field ``edges`` of the ``Reading`` of the drawing.
    board, options
        The board, and how it is folded.
    fraction
        Share of its angle by which each fold has turned, 0 … 1.

    Raises
    ------
    UnitUnknown
        The drawing has no unit.
    DrawingTooLarge
        There are too many edges or panels.
    PlanError
        An angle is given for a fold that does not exist.
    """
    from knifetip.folding.findings import find_faults
    from knifetip.presentation.folding import folding_json

    tree = _tree(progress, edges, board, options)
    fields = folding_json(tree, find_faults(tree), fraction)
    return pack([FoldingOut.model_validate(fields).model_dump_json().encode()])


def glb(
    progress: Progress, edges: bytes, board: Board, options: FoldOptions, fraction: float
) -> bytes:
    """Return a folded drawing as a GLB file; parameters and errors as for ``folding``."""
    from knifetip.folding.gltf import write_glb

    tree = _tree(progress, edges, board, options)
    return pack([write_glb(tree, fraction, outside_up=options.side_up == "outside")])


def _tree(progress: Progress, edges: bytes, board: Board, options: FoldOptions) -> FoldTree:
    from knifetip import pipeline
    from knifetip.folding.fold import fold_tree

    progress(Stage.CLEAN, 0.0)
    drawing, dieline = restore_drawing(edges)
    if not drawing.unit:
        raise UnitUnknown("drawing.unit-for-cleaning")
    return fold_tree(pipeline.clean(dieline).dieline, board, options)
