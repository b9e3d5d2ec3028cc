"""Task of the worker processes that draws a carton."""

from __future__ import annotations

from typing import Any

from knifetip.cartons.registry import style_of
from knifetip.library.definition import Definition, board_of
from knifetip.model.stage import Progress, Stage


def draw_carton(
    progress: Progress, code: str, parameters: dict[str, Any], board: Definition
) -> bytes:
    """Return the DXF file of a carton.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    code
        Code of the style.
    parameters
        Dimensions and options of the style, which were validated.
    board
        The board.

    Raises
    ------
    ImpossibleCarton
        The style cannot have the dimensions.
    """
    from knifetip.cartons.file import carton_dxf  # ezdxf is slow to import

    progress(Stage.READ, 0.0)
    style = style_of(code)
    return carton_dxf(style.draw(style.parameters(**parameters), board_of(board)))
