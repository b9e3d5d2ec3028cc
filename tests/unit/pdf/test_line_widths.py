"""Line widths of the paths of a PDF."""

from __future__ import annotations

import pytest

from knifetip.pdf.read import read
from tests.support.writers.pdf_text import pdf, stream

LINE = "0 0 m 99 0 l S"


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        # One point is 0.3528 mm.
        (LINE, 35),
        (f"2 w {LINE}", 71),
        (f"0.25 w {LINE}", 9),
        (f"0 w {LINE}", 0),
        (f"2 0 0 2 0 0 cm 0.5 w {LINE}", 35),
        (f"0.5 w 2 0 0 2 0 0 cm {LINE}", 35),
        (f"0 3 -3 0 0 0 cm {LINE}", 106),
        (f"1 0 0 4 0 0 cm {LINE}", 71),
        (f"3 w q 1 w Q {LINE}", 106),
        (f"-3 w {LINE}", 35),
        (f"w {LINE}", 35),
        (f"(3) w {LINE}", 35),
        (f"/Wide gs {LINE}", 141),
        (f"/Wide gs 1 w {LINE}", 35),
        (f"/Plain gs {LINE}", 35),
        ("2 w 0 0 m 99 0 l 99 99 l b", 71),
        ("2 w 0 0 m 99 0 l 99 99 l f", -1),
    ],
)
def test_a_line_has_the_width_of_its_graphics_state(content: str, expected: int) -> None:
    states = "/ExtGState <</Wide <</LW 4>> /Plain <</CA 1>>>>"
    assert set(read(pdf(content, resources=states)).line_width.tolist()) == {expected}


def test_a_form_draws_with_the_width_of_the_page_unless_it_sets_its_own() -> None:
    box = "/Subtype /Form /BBox [0 0 999 999]"
    drawing = read(
        pdf(
            "2 w /A Do /B Do 0 30 m 99 30 l S",
            resources="/XObject <</A 6 0 R /B 7 0 R>>",
            more=[
                stream(b"0 10 m 99 10 l S", box),
                stream(b"4 w 0 20 m 99 20 l S", f"{box} /Matrix [0.5 0 0 0.5 0 0]"),
            ],
        )
    )
    assert drawing.line_width.tolist() == [71, 71, 71]


def test_widths_have_the_unit_that_the_user_gives_for_a_point() -> None:
    assert read(pdf(f"0.5 w {LINE}"), "mm").line_width.tolist() == [50]
    assert read(pdf(f"0.5 w {LINE}", page="/UserUnit 2")).line_width.tolist() == [35]


def test_paths_of_several_widths_keep_their_styles() -> None:
    content = "1 0 0 RG 2 w 0 0 m 99 0 l S 1 w 0 9 m 99 9 l S 0 0 1 RG 0 19 m 99 19 l S"
    drawing = read(pdf(content))
    assert drawing.line_width.tolist() == [71, 35, 35]
    assert drawing.true_colour.tolist() == [0xFF0000, 0xFF0000, 0x0000FF]
