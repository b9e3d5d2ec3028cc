"""The length of a pixel by the writer of the file, and pages that contradict themselves."""

from __future__ import annotations

import pytest
from numpy.testing import assert_allclose

from knifetip import pipeline
from knifetip.presentation.import_warnings import import_warnings
from knifetip.svg.read import read

NAMES = (
    'xmlns="http://www.w3.org/2000/svg" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
)
LINE = '<path d="M0 10H90" stroke="red" fill="none"/>'


def page(attributes: str, comment: str = "") -> bytes:
    return f"{comment}<svg {NAMES} {attributes}>{LINE}</svg>".encode()


@pytest.mark.parametrize(
    ("attributes", "comment", "unit", "length"),
    [
        ('width="900" height="90" inkscape:version="0.48.4 r9939"', "", "px-90", 25.4),
        ('width="900" height="90" inkscape:version="0.91 r13725"', "", "px-90", 25.4),
        ('inkscape:version="0.46"', "", "px-90", 25.4),
        ('width="45" viewBox="0 0 90 90" inkscape:version="0.48"', "", "px-90", 12.7),
        ('width="90mm" height="9mm" inkscape:version="0.48.4"', "", "mm", 25.4),
        ('width="90mm" height="9mm" inkscape:version="0.92.4"', "", "mm", 90 * 25.4 / 96),
        ('width="45mm" viewBox="0 0 90 90" inkscape:version="0.48"', "", "mm", 45.0),
        ('width="900" height="90" inkscape:version="0.92.4"', "", "px", 90 * 25.4 / 96),
        ('width="900" height="90" inkscape:version="1.3.2 (091e20e)"', "", "px", 90 * 25.4 / 96),
        ('viewBox="0 0 90 90"', "<!-- Generator: Adobe Illustrator 27.0.0 -->", "pt", 31.75),
        ('viewBox="0 0 90 90"', "<!-- for Cricut Design Space -->", "pt", 31.75),
    ],
)
def test_the_writer_defines_the_length_of_a_pixel(
    attributes: str, comment: str, unit: str, length: float
) -> None:
    drawing = read(page(attributes, comment))
    assert (drawing.unit, drawing.stated) == (unit, unit)
    assert_allclose(drawing.lengths, [length])
    assert pipeline.read(page(attributes, comment)).unit in (unit, "")


@pytest.mark.parametrize(
    ("attributes", "comment"),
    [
        ('width="900" height="90"', ""),
        ('width="900" height="90" inkscape:version="unknown"', ""),
        # Illustrator wrote points, and Inkscape saved them as pixels.
        ('width="900" inkscape:version="1.2"', "<!-- Generator: Adobe Illustrator 27 -->"),
    ],
)
def test_an_unknown_writer_states_no_unit(attributes: str, comment: str) -> None:
    assert read(page(attributes, comment)).stated == ""


def test_a_text_that_suits_two_units_does_not_decide_between_them() -> None:
    # In pixels of 1/90 in the panels measure 110 mm and the slot 88 mm, which are 110 mm in points.
    scale = 90.0 / 25.4
    sides = "".join(
        f'<path d="M{x * scale:.3f} {10 * scale:.3f}V{120 * scale:.3f}"/>'
        for x in (10, 60, 110, 160)
    )
    slot = f'<path d="M{20 * scale:.3f} {20 * scale:.3f}h{88 * scale:.3f}v{4 * scale:.3f}"/>'
    text = '<text x="9" y="9">b=110mm</text>'
    body = f'<g stroke="red" fill="none">{sides}{slot}{text}</g>'
    assert pipeline.read(f'<svg {NAMES} width="900" height="900">{body}</svg>'.encode()).unit == ""


def test_the_user_can_choose_old_pixels() -> None:
    assert_allclose(read(page('width="900"'), "px-90").lengths, [25.4])


def test_a_page_with_other_proportions_than_its_view_box_is_scaled_evenly_with_a_warning() -> None:
    drawing = read(page('width="180mm" height="90mm" viewBox="0 0 90 90"'))
    assert_allclose(drawing.lengths, [90.0])
    (warning,) = import_warnings(drawing)
    assert str(warning) == (
        'The size of the page (width="180mm" height="90mm") does not have the proportions of its '
        "viewBox (90 × 90): the width gives the scale 2, the height 1. The drawing is read at the "
        "scale 1, as browsers display it."
    )


@pytest.mark.parametrize(
    "attributes",
    [
        'width="90mm" height="90.1mm" viewBox="0 0 90 90"',
        'width="180mm" height="90mm" viewBox="0 0 90 90" preserveAspectRatio="none"',
        'width="180mm" viewBox="0 0 90 90"',
    ],
)
def test_a_page_that_fits_its_view_box_has_no_warning(attributes: str) -> None:
    assert import_warnings(read(page(attributes))) == []
