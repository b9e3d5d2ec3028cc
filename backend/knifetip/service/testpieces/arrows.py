"""Draw the dimensions of a test piece into its picture."""

from __future__ import annotations

import math
from typing import Final

from knifetip.testpieces.piece import Arrow, Piece

#: Legible on light and on dark backgrounds.
_COLOUR: Final = "#2f80ed"
#: Sizes in units of the picture, whose longer side has 1000.
_SIZE: Final = 1000.0
_TEXT, _HEAD = 34.0, 14.0


def with_arrows(picture: str, piece: Piece) -> str:
    """Return the picture of a test piece with an arrow and a letter for each measure.

    ``picture`` is that of ``presentation.picture.svg_edges`` for the lines of the piece.
    """
    points = piece.ends.reshape(-1, 2)
    low, high = points.min(axis=0), points.max(axis=0)
    scale = _SIZE / float((high - low).max())
    drawn = []
    for arrow in piece.arrows:
        (x0, y0), (x1, y1) = (
            ((x - low[0]) * scale, (high[1] - y) * scale) for x, y in (arrow.start, arrow.end)
        )
        drawn.append(_arrow(arrow, (float(x0), float(y0)), (float(x1), float(y1))))
    style = (
        f'stroke="{_COLOUR}" stroke-width="3" font-size="{_TEXT:g}" '
        'font-family="sans-serif" font-weight="600" text-anchor="middle"'
    )
    return picture.removesuffix("</svg>") + f"<g {style}>{''.join(drawn)}</g></svg>"


def _arrow(arrow: Arrow, start: tuple[float, float], end: tuple[float, float]) -> str:
    """Return a line with heads at both ends, and its letter beside it."""
    size = math.dist(start, end)
    ux, uy = (end[0] - start[0]) / size, (end[1] - start[1]) / size
    head = min(_HEAD, size / 3.0)
    steps = [f"M{start[0]:.1f} {start[1]:.1f}L{end[0]:.1f} {end[1]:.1f}"]
    for (x, y), way in ((start, 1.0), (end, -1.0)):
        for side in (-0.4, 0.4):
            back = x + head * way * (ux - side * uy), y + head * way * (uy + side * ux)
            steps.append(f"M{x:.1f} {y:.1f}L{back[0]:.1f} {back[1]:.1f}")
    # A third along, so that the letters of two diagonals do not meet.
    x = start[0] + size * ux / 3.0 + 0.7 * _TEXT * uy
    y = start[1] + size * uy / 3.0 - 0.7 * _TEXT * abs(ux) + 0.35 * _TEXT * abs(uy)
    text = f'<text x="{x:.1f}" y="{y:.1f}" fill="{_COLOUR}" stroke="none">{arrow.letter}</text>'
    return f'<path d="{"".join(steps)}"/>{text}'
