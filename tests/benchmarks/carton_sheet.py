"""Draw the carton styles with their examples side by side: the picture of docs/cartons.md.

    python -m tests.benchmarks.carton_sheet

Writes backend/docs/cartons.svg: cuts red, creases blue, V-grooves green.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Final
from xml.sax.saxutils import escape

from knifetip.cartons.carton import Carton
from knifetip.cartons.registry import STYLES
from knifetip.library import load
from knifetip.model.dieline import LineType

SHEET: Final = Path("backend/docs/cartons.svg")
_COLOURS: Final = {
    LineType.CUT: "#d9534f",
    LineType.CREASE: "#3f8fd2",
    LineType.V_GROOVE: "#2fa36b",
}
#: Width and height of a cell with a style, and its margin (px).
_WIDTH, _HEIGHT, _MARGIN = 300.0, 230.0, 14.0
_COLUMNS: Final = 3


def svg_text() -> str:
    """Return the picture."""
    rows = math.ceil(len(STYLES) / _COLUMNS)
    width, height = _COLUMNS * _WIDTH, rows * _HEIGHT
    cells = []
    for number, style in enumerate(STYLES.values()):
        x, y = number % _COLUMNS * _WIDTH, number // _COLUMNS * _HEIGHT
        carton = style.draw(style.example, load.board(style.board, files=False))
        size = style.example
        sides = f"{size.length:g} × {size.width:g} × {size.depth:g}, {style.board}"
        cells.append(
            f'<text x="{x + _MARGIN:g}" y="{y + 22:g}" font-weight="bold">{escape(style.code)}'
            f'</text><text x="{x + _MARGIN:g}" y="{y + 38:g}" fill="#667">{escape(sides)}</text>'
        )
        cells += _lines(carton, (x + _MARGIN, y + 48.0))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
        f'font-family="sans-serif" font-size="12" fill="none">\n'
        f'<rect width="{width:g}" height="{height:g}" fill="#fff"/>\n<g fill="#223">\n'
        + "\n".join(cells)
        + "\n</g>\n</svg>\n"
    )


def _lines(carton: Carton, corner: tuple[float, float]) -> list[str]:
    """Return the lines of a carton in a cell, whose drawing begins at ``corner`` (px)."""
    edges = carton.edges()
    low, high = edges.ends.min(axis=(0, 1)), edges.ends.max(axis=(0, 1))
    room = _WIDTH - 2.0 * _MARGIN, _HEIGHT - 48.0 - _MARGIN
    scale = min(room[0] / (high[0] - low[0]), room[1] / (high[1] - low[1]))
    drawn = []
    for kind, colour in _COLOURS.items():
        steps = []
        for row in (edges.line_type == kind).nonzero()[0].tolist():
            (x0, y0), (x1, y1) = (
                (corner[0] + (x - low[0]) * scale, corner[1] + (high[1] - y) * scale)
                for x, y in edges.ends[row].tolist()
            )
            bulge = float(edges.bulge[row])
            if bulge:
                r = math.dist((x0, y0), (x1, y1)) * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
                step = f"A{r:.1f} {r:.1f} 0 0 {int(bulge < 0.0)} {x1:.1f} {y1:.1f}"
            else:
                step = f"L{x1:.1f} {y1:.1f}"
            steps.append(f"M{x0:.1f} {y0:.1f}{step}")
        if steps:
            drawn.append(f'<path d="{"".join(steps)}" stroke="{colour}" fill="none"/>')
    return drawn


if __name__ == "__main__":
    SHEET.write_text(svg_text())
