"""A small carton with every line type that a knife and a creasing tool make, including arcs."""

from __future__ import annotations

from tests.support.writers import dxf_text as text

WIDTH, HEIGHT, CORNER = 200.0, 120.0, 8.0


def mixed_carton() -> bytes:
    """Return the carton as the bytes of a DXF file."""
    w, h, r = WIDTH, HEIGHT, CORNER
    cut, crease = (8, "CUT"), (8, "CREASE")
    return text.dxf(
        text.line(r, 0, w - r, 0, cut),
        _arc(w - r, r, r, 270, 0, cut),
        text.line(w, r, w, h - r, cut),
        _arc(w - r, h - r, r, 0, 90, cut),
        text.line(w - r, h, r, h, cut),
        _arc(r, h - r, r, 90, 180, cut),
        text.line(0, h - r, 0, r, cut),
        _arc(r, r, r, 180, 270, cut),
        text.entity("CIRCLE", cut, (10, 30), (20, 90), (40, 7.3)),
        # Coordinates that are not multiples of a plotter unit.
        text.line(50.013, 0, 50.013, h, crease),
        text.line(100, 0, 130, h, crease),
        _arc(200, 120, 70, 190, 260, crease),
        text.line(60, 20, 90, 77.7, (8, "HALF-CUT")),
        text.line(10, 20, 45, 61.3, (8, "PERF")),
    )


def _arc(
    x: float, y: float, radius: float, begin: float, end: float, layer: tuple[int, str]
) -> str:
    return text.entity("ARC", layer, (10, x), (20, y), (40, radius), (50, begin), (51, end))
