"""Draw corner types B, C and D around one corner: `python -m tests.benchmarks.corner_picture`.

Writes the paths of ``offset.transition``, with true arcs, to backend/docs/corners.svg.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from knifetip.geometry import arc
from knifetip.offset.transition import Corner, transitions

RADIUS, SIDE, TURN = 30.0, 60.0, 120.0
COLOURS = {Corner.B: "#e8590c", Corner.C: "#1c7ed6", Corner.D: "#2b8a3e"}
WORDS = {
    Corner.B: "B: an arc about the corner",
    Corner.C: "C: straight lines",
    Corner.D: "D: line, arc, line; k = ½",
}


def svg_text() -> str:
    """Return the picture as SVG text."""
    turn = np.radians(TURN)
    before = np.array([[1.0, 0.0]])
    # A turn to the right, with the tool on the left.
    after = np.array([[np.cos(turn), -np.sin(turn)]])
    panels = []
    for column, corner in enumerate(Corner):
        way = transitions(corner, before, after, np.zeros((1, 2)), RADIUS, 1, 0.5)
        begin = way.start[0] - SIDE * before[0]
        end = way.end[-1] + SIDE * after[0]
        radii = arc.radius(way.start, way.end, way.bulge)
        path = f"M {begin[0]:.3f} {begin[1]:.3f} L {way.start[0][0]:.3f} {way.start[0][1]:.3f}"
        for (x, y), radius, bulge in zip(way.end, radii, way.bulge, strict=True):
            round_ = f"A {radius:.3f} {radius:.3f} 0 0 {int(bulge > 0)}" if bulge else "L"
            path += f" {round_} {x:.3f} {y:.3f}"
        path += f" L {end[0]:.3f} {end[1]:.3f}"
        length = arc.length(way.start, way.end, way.bulge).sum()
        part = f"M {-SIDE} 0 L 0 0 L {SIDE * after[0][0]:.3f} {SIDE * after[0][1]:.3f} Z"
        panels.append(
            f'<g transform="translate({90 + 170 * column} 75) scale(1 -1)">'
            f'<path d="{part}" fill="#e9ecef"/>'
            f'<path d="{path}" fill="none" stroke="{COLOURS[corner]}" stroke-width="1.6"/>'
            '<circle r="1.6" fill="#212529"/>'
            f'<g transform="scale(1 -1)" font-size="8" fill="#212529" text-anchor="middle">'
            f'<text y="84">{WORDS[corner]}</text>'
            f'<text y="95">{length:.1f} mm round the corner</text></g></g>'
        )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 540 185" '
        'font-family="sans-serif"><rect width="540" height="185" fill="#fff"/>'
        + "".join(panels)
        + "</svg>\n"
    )


if __name__ == "__main__":
    Path("backend/docs/corners.svg").write_text(svg_text())
