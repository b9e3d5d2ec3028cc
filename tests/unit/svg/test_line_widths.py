"""Line widths of SVG elements."""

from __future__ import annotations

import pytest

from knifetip.svg.read import read
from tests.support.writers.svg_text import svg

#: Three user units in the default document are 3 mm.
MM_PER_PIXEL = 25.4 / 96.0


def width(element: str, **page: str) -> int:
    """Return the line width of the first edge (1/100 mm; of a user unit without a unit)."""
    return int(read(svg(element, **page)).line_width[0])


@pytest.mark.parametrize(
    ("look", "expected"),
    [
        ("", 100),
        ('stroke-width="0.5"', 50),
        ('style="stroke-width:.18"', 18),
        ('stroke-width="3" style="stroke-width:.18"', 18),
        # Units are those of CSS: 0.5 mm are 1.89 pixels, and a pixel is a user unit.
        ('stroke-width="0.5mm"', 189),
        ('stroke-width="1px"', 100),
        ('stroke-width="0.75pt"', 100),
        # Of the diagonal of the window, divided by the root of 2.
        ('stroke-width="2%"', 200),
        ('stroke-width="0.5" transform="scale(2)"', 100),
        ('stroke-width="0.5" transform="rotate(30) scale(-2)"', 100),
        ('stroke-width="0.5" transform="scale(1 4)"', 100),
        ('stroke-width="2" transform="scale(3)" vector-effect="non-scaling-stroke"', 53),
        ('style="stroke-width:2;vector-effect:non-scaling-stroke"', 53),
        ('stroke-width="broken"', 100),
        ('stroke-width="-1"', 100),
        ('stroke-width="1e-9"', 0),
        ('stroke-width="1e300"', 1_000_000),
    ],
)
def test_a_line_has_the_width_of_its_stroke(look: str, expected: int) -> None:
    assert width(f'<path d="M0 0H9" {look}/>') == expected


def test_groups_style_sheets_and_copies_hand_their_width_down() -> None:
    line = '<path d="M0 0H9"/>'
    assert width(f'<g stroke-width=".3"><g transform="scale(2)">{line}</g></g>') == 60
    assert width(f"<style>path{{stroke-width:.7}}</style>{line}") == 70
    assert width(f'<style>.a{{stroke-width:.7}}</style><g class="a">{line}</g>') == 70
    copied = '<defs><path id="a" d="M0 0H9"/></defs><use href="#a" stroke-width=".4"/>'
    assert width(copied) == 40
    assert width(f'<g vector-effect="non-scaling-stroke" stroke-width="2">{line}</g>') == 200
    assert width(f'<g stroke-width="1%"><svg width="50" height="50">{line}</svg></g>') == 50


def test_widths_have_the_unit_of_the_page() -> None:
    line = '<path d="M0 0H9" stroke-width="0.5"/>'
    assert width(line, size='width="200mm" height="200mm"') == 100
    assert width(line, size='width="1in" height="1in"', box="0 0 254 254") == 5
    assert width(line, size='width="96px" height="96px"', box="") == 50
    assert read(svg(line, size="", box="0 0 9 9"), "in").line_width.tolist() == [1270]


def test_a_stroke_that_does_not_scale_is_as_wide_on_every_page() -> None:
    line = '<path d="M0 0H9" stroke-width="4" vector-effect="non-scaling-stroke"/>'
    expected = round(400 * MM_PER_PIXEL)
    assert width(line) == width(line, size='width="900mm" height="900mm"') == expected
    # A page of 400 pixels shows 100 user units of unknown length.
    assert width(line, size='width="400" height="400"') == 100


def test_an_area_without_a_stroke_has_no_line_width() -> None:
    area = '<path d="M0 0H9V9Z" fill="#000" stroke="none" stroke-width="3"/>'
    assert read(svg(area)).line_width.tolist() == [-1, -1, -1]


def test_paths_of_one_colour_and_several_widths_share_their_layer() -> None:
    lines = (f'<path d="M0 {y}H9" stroke-width="{w}"/>' for y, w in ((0, 0.5), (1, 0.2), (2, 0.5)))
    drawing = read(svg(*lines))
    assert drawing.line_width.tolist() == [50, 20, 50]
    assert len(set(drawing.layer.tolist())) == len(drawing.linetypes) == 1
