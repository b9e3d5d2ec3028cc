"""Task of the worker processes that writes the file of a test piece."""

from __future__ import annotations

from knifetip.model.stage import Progress, Stage
from knifetip.testpieces.piece import Piece


def write_piece(progress: Progress, piece: Piece) -> bytes:
    """Return the DXF file of a test piece.

    It is written in a worker process, because the fixed dates of ezdxf are a setting of the whole
    process.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    piece
        The test piece.
    """
    from knifetip.testpieces.file import piece_dxf  # ezdxf is slow to import

    progress(Stage.READ, 0.0)
    return piece_dxf(piece)
