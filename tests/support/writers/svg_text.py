"""Write SVG files for tests."""

from __future__ import annotations

SVG = 'xmlns="http://www.w3.org/2000/svg"'
INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'


def svg(
    *elements: str, size: str = 'width="100mm" height="100mm"', box: str = "0 0 100 100"
) -> bytes:
    """Return an SVG file with some elements; by default 100 by 100 mm with black strokes.

    ``size`` holds the attributes of width and height, ``box`` the viewBox.
    """
    view = f' viewBox="{box}"' if box else ""
    head = f'<svg {SVG} xmlns:xlink="http://www.w3.org/1999/xlink" {INKSCAPE} {size}{view}'
    return (head + ' stroke="#000" fill="none">' + "".join(elements) + "</svg>").encode()


def carton() -> bytes:
    """Return a carton of four panels: black outline and holes, red dashed creases, two words."""
    folds = "".join(f'<line x1="{x}" y1="10" x2="{x}" y2="90"/>' for x in (60, 110, 160))
    return svg(
        "<style>.fold{stroke:#f00;stroke-dasharray:4 2}</style>",
        '<g inkscape:groupmode="layer" inkscape:label="CUT">',
        '<path d="M10 10H210V70A20 20 0 0 1 190 90H10Z"/>',
        '<circle cx="35" cy="50" r="8"/><ellipse cx="85" cy="50" rx="12" ry="6"/></g>',
        f'<g inkscape:groupmode="layer" inkscape:label="CREASE" class="fold">{folds}</g>',
        '<text x="20" y="98" font-size="4">A <tspan>carton</tspan></text>',
        size='width="220mm" height="100mm"',
        box="0 0 220 100",
    )
