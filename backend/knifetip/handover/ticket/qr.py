"""qr: draw a QR code in a PDF file as squares, which print sharply at every size."""

from __future__ import annotations

from typing import Final

import segno
from fpdf import FPDF

from knifetip.handover.pdf import Frame

_LONGEST: Final = 400  # bytes


def draw_qr(pdf: FPDF, text: str, frame: Frame) -> None:
    """Draw a QR code (ISO/IEC 18004) with its margin of 4 modules in a square frame.

    Nothing is drawn for a text of more than ``_LONGEST`` bytes, whose code cannot be scanned from
    paper.
    """
    if len(text.encode()) > _LONGEST:
        return
    code = segno.make_qr(text, error="m")
    rows = [bytes(row) for row in code.matrix_iter(border=4)]
    side = frame.width / len(rows)
    pdf.set_fill_color(0, 0, 0)
    for line, row in enumerate(rows):
        column = 0
        while column < len(row):
            run = column
            while run < len(row) and row[run]:
                run += 1
            if run > column:
                # Adjoining modules are one rectangle, without a gap between them.
                pdf.rect(
                    frame.x + column * side,
                    frame.y + line * side,
                    (run - column) * side,
                    side,
                    style="F",
                )
            column = max(run, column + 1)
