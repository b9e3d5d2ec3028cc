"""What the author of an SVG does not see is left out, and clipped objects are clipped."""

from __future__ import annotations

import pytest
from numpy.testing import assert_allclose

from knifetip.model.drawing import Drawing
from knifetip.presentation.import_warnings import import_warnings
from knifetip.svg.read import read
from tests.support.drawings import report_reasons
from tests.support.writers.svg_text import svg

CUT = '<path id="cut" stroke="red" fill="none" d="M0 50H100"/>'
SLIT = '<path id="slit" stroke="blue" fill="none" d="M20 20H60"/>'
WHITE_SLIT = SLIT.replace("blue", "white")
OPAQUE_SLIT = SLIT.replace("<path", '<path stroke-opacity="1"')


def drawn(*elements: str) -> Drawing:
    """Return the drawing of a line and other elements on a page of 100 by 100 mm."""
    return read(svg(CUT, *elements))


def reason(drawing: Drawing, handle: str = "slit") -> str:
    return dict(zip(drawing.import_report.handle, report_reasons(drawing), strict=True))[handle]


@pytest.mark.parametrize(
    ("element", "why"),
    [
        (f'<g opacity="0">{SLIT}</g>', "completely transparent"),
        (f'<g style="opacity:0"><g opacity="1">{SLIT}</g></g>', "completely transparent"),
        (f'<g opacity="0.1"><g opacity="0.1">{SLIT}</g></g>', "completely transparent"),
        (f"<style>#slit{{opacity:0%}}</style>{SLIT}", "completely transparent"),
        (f'<g stroke-opacity="0">{SLIT}</g>', "completely transparent"),
        (SLIT.replace("blue", "rgba(0,0,255,0)"), "neither a stroke nor a fill"),
        (SLIT.replace("blue", "white"), "in white on a white page"),
        (SLIT.replace("blue", "rgb(99%,99%,99%)"), "in white on a white page"),
        (f'<g stroke-width="0">{SLIT}</g>', "width of 0"),
        (f'<g transform="translate(200)">{SLIT}</g>', "outside the visible area of the page"),
        (f'<switch><g systemLanguage="de">{SLIT}</g><g/></switch>', "another language"),
        (f'<switch><g/><g systemLanguage="en">{SLIT}</g></switch>', "another language"),
        (f'<g systemLanguage="fr, de">{SLIT}</g>', "another language"),
    ],
)
def test_an_object_that_is_not_visible_is_left_out_with_a_warning(element: str, why: str) -> None:
    drawing = drawn(element)
    assert drawing.lengths.tolist() == [100.0]
    assert why in reason(drawing)
    if "neither" not in why:
        assert any(why in str(warning) for warning in import_warnings(drawing))


@pytest.mark.parametrize(
    "element",
    [
        f'<g opacity="0.2">{SLIT}</g>',
        f'<g opacity="x">{SLIT}</g>',
        SLIT.replace("blue", "#f0f0f0"),
        f'<g stroke-width="0.001">{SLIT}</g>',
        f'<rect width="90" height="90" fill="#333" stroke="none"/>{WHITE_SLIT}',
        f'<switch><g systemLanguage="en-GB">{SLIT}</g><g/></switch>',
        f'<switch><g systemLanguage="de"/><g>{SLIT}</g></switch>',
        f'<g stroke-opacity="0">{OPAQUE_SLIT}</g>',
    ],
)
def test_a_visible_object_is_kept(element: str) -> None:
    assert drawn(element).lengths.tolist() == [100.0, 40.0]


def test_a_white_drawing_is_kept() -> None:
    assert len(read(svg(SLIT.replace("blue", "white")))) == 1


def test_white_lines_on_a_dark_page_are_kept() -> None:
    data = svg(CUT, SLIT.replace("blue", "#fff")).replace(
        b"<svg", b'<svg style="background:#222"', 1
    )
    assert len(read(data)) == 2


def test_an_object_that_crosses_the_border_of_the_page_is_kept_with_a_warning() -> None:
    drawing = drawn(f'<g transform="translate(60)">{SLIT}</g>')
    assert drawing.lengths.tolist() == [100.0, 40.0]
    assert "a part of the object lies outside" in reason(drawing)
    assert [str(one) for one in import_warnings(drawing)] == [
        "1 object on layer 'slit' is imported with a change: a part of the object lies outside the "
        "visible area of the page."
    ]


def test_an_object_beside_the_page_that_continues_an_outline_is_kept() -> None:
    drawing = drawn('<path stroke="red" fill="none" d="M100 50H150"/><path d="M150 50V90"/>')
    assert sorted(drawing.lengths.tolist()) == [40.0, 50.0, 100.0]


def test_a_drawing_beside_the_page_is_kept_with_a_warning() -> None:
    drawing = read(svg(f'<g transform="translate(300)">{CUT}{SLIT}</g>'))
    assert drawing.lengths.tolist() == [100.0, 40.0]
    assert "the whole drawing lies outside" in str(import_warnings(drawing)[0])


def test_a_page_with_visible_overflow_shows_what_lies_beside_it() -> None:
    data = svg(CUT, f'<g transform="translate(300)">{SLIT}</g>')
    assert len(read(data.replace(b"<svg", b'<svg overflow="visible"', 1))) == 2


# ── Clip paths, masks and windows ────────────────────────────────────────────────────────────────


BOX = '<rect x="30" y="0" width="20" height="90" fill="white"/>'
NAMED_BOX = BOX.replace("<rect", '<rect id="b"')


@pytest.mark.parametrize(
    "element",
    [
        f'<clipPath id="c">{BOX}</clipPath><g clip-path="url(#c)">{SLIT}</g>',
        f"<clipPath id='c'>{BOX}</clipPath><g style=\"clip-path:url('#c')\">{SLIT}</g>",
        f'<clipPath id="c" transform="translate(10)"><use href="#b" x="-10"/></clipPath>'
        f"<defs><g>{NAMED_BOX}</g></defs>"
        f'<g clip-path="url(#c)">{SLIT}</g>',
        '<clipPath id="c"><path d="M30 0H50L50 40L30 40Z"/></clipPath>'
        f'<g transform="scale(1)" clip-path="url(#c)">{SLIT}</g>',
        f'<clipPath id="a"><path d="M0 0H50V90H0Z"/></clipPath>'
        '<clipPath id="c" clip-path="url(#a)"><path d="M30 0H90V90H30Z"/></clipPath>'
        f'<g clip-path="url(#c)">{SLIT}</g>',
        f'<mask id="m" maskUnits="userSpaceOnUse" width="100" height="100">{BOX}</mask>'
        f'<g mask="url(#m)">{SLIT}</g>',
        f'<mask id="m"><rect width="100" height="100"/>{BOX}</mask><g mask="url(#m)">{SLIT}</g>',
        f'<svg x="30" y="10" width="20" height="60" viewBox="30 10 20 60">{SLIT}</svg>',
        f'<symbol id="s" viewBox="30 10 20 60">{SLIT}</symbol>'
        '<use href="#s" x="30" y="10" width="20" height="60"/>',
    ],
)
def test_an_object_is_cut_where_its_visible_area_ends(element: str) -> None:
    drawing = drawn(element)
    assert_allclose(drawing.ends[1], [[30, 80], [50, 80]], atol=1e-9)
    (warning,) = import_warnings(drawing)
    assert "only the part of the object that is visible inside its clip path" in str(warning)


def test_an_object_outside_its_clip_path_is_left_out_with_a_warning() -> None:
    drawing = drawn(
        '<clipPath id="c"><circle cx="90" cy="90" r="5"/></clipPath>'
        f'<g clip-path="url(#c)">{SLIT}</g>',
    )
    assert drawing.lengths.tolist() == [100.0]
    (warning,) = import_warnings(drawing)
    assert "the object lies outside its clip path or mask" in str(warning)


def test_an_object_inside_its_clip_path_is_unchanged() -> None:
    drawing = drawn(
        f'<clipPath id="c"><rect x="20" y="10" width="40" height="20"/></clipPath>'
        f'<g clip-path="url(#c)">{SLIT}</g>'
    )
    assert reason(drawing) == "the object was imported unchanged"


@pytest.mark.parametrize(
    "element",
    [
        '<mask id="m"><rect width="50" height="90" fill="gray"/></mask>'
        f'<g mask="url(#m)">{SLIT}</g>',
        f'<clipPath id="c"><text>A</text></clipPath><g clip-path="url(#c)">{SLIT}</g>',
        f'<clipPath id="c" clipPathUnits="objectBoundingBox">{BOX}</clipPath>'
        f'<g clip-path="url(#c)">{SLIT}</g>',
        f'<g clip-path="circle(4px)">{SLIT}</g>',
        f'<clipPath id="c" clip-path="url(#c)"><path d="M0 0H99V90H0Z"/></clipPath>'
        f'<g clip-path="url(#c)">{SLIT}</g>',
        f'<clipPath id="c"><use id="u" href="#u"/></clipPath><g clip-path="url(#c)">{SLIT}</g>',
    ],
)
def test_an_object_with_an_unsupported_clip_is_kept_whole_with_a_warning(element: str) -> None:
    drawing = drawn(element)
    assert drawing.lengths.tolist() == [100.0, 40.0]
    (warning,) = import_warnings(drawing)
    assert "the file clips the object, but the complete object was imported" in str(warning)


@pytest.mark.parametrize("reference", ["none", "url(#nothing)", "url(#cut)"])
def test_a_clip_path_that_does_not_exist_is_ignored(reference: str) -> None:
    assert reason(drawn(f'<g clip-path="{reference}">{SLIT}</g>')).endswith("unchanged")


# ── Nothing is lost in silence ───────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("element", "why"),
    [
        ('<path d="M0 0H9V NaN H3Z"/>', "path data of the object is invalid at character 9"),
        ('<path d="M0 0H9L"/>', "path data of the object is incomplete"),
        ('<polygon points="40,60 80,60 80,80 40"/>', "the last point has no y coordinate"),
        ('<polyline points="40,60 80,60 80"/>', "the last point has no y coordinate"),
        ('<polyline points="40,60 80,6O 80,3"/>', "the points of the object cannot be read: 'O"),
        ('<line x1="34,5" y1="90" x2="71" y2="90"/>', "the value '34,5' is not a length"),
        ('<use href="#window"/>', "the id 'window', which does not exist"),
        ('<rect x="5" y="5" width="9" height="9" stroke="none" fill="red"/>', "a filled area"),
    ],
)
def test_an_object_that_cannot_be_read_is_left_out_whole_with_a_warning(
    element: str, why: str
) -> None:
    drawing = read(svg(CUT, f'<g stroke="red">{element}</g>'))
    assert drawing.lengths.tolist() == [100.0]
    (warning,) = import_warnings(drawing)
    assert why in str(warning)


def test_pictures_and_white_areas_are_left_out_without_a_warning() -> None:
    area = '<rect width="9" height="9" stroke="none" fill="white"/>'
    assert import_warnings(drawn('<image width="9" height="9" href="a.png"/>', area)) == []
