"""Clip paths, white lines, other pages and encrypted files."""

from __future__ import annotations

import io

import pytest
from numpy.testing import assert_allclose
from pypdf import PdfReader, PdfWriter

from knifetip import pipeline
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.model.drawing import Drawing
from knifetip.pdf.chosen_page import choose_page
from knifetip.pdf.read import read, read_each_page
from knifetip.presentation.drawing import drawing_json
from knifetip.presentation.import_warnings import import_warnings
from tests.support.writers.pdf_text import MM, carton, pages, pdf, stream

CUT = "1 0 0 RG 0 50 m 100 50 l S "


def lengths(drawing: Drawing) -> list[float]:
    return [round(float(one) * MM, 6) for one in drawing.lengths]


def warnings(drawing: Drawing) -> str:
    return " ".join(str(one) for one in import_warnings(drawing))


@pytest.mark.parametrize("rule", ["W", "W*"])
@pytest.mark.parametrize(
    "shape", ["30 0 20 90 re", "30 0 m 50 0 l 50 90 l 30 90 l h", "30 90 20 -90 re"]
)
def test_a_line_is_cut_at_a_rectangular_clip_path(shape: str, rule: str) -> None:
    drawing = read(pdf(CUT, f"q {shape} {rule} n 20 20 m 60 20 l S Q 20 30 m 60 30 l S"))
    assert lengths(drawing) == [100.0, 20.0, 40.0]
    assert_allclose(drawing.ends[1] * MM, [[30, 20], [50, 20]])
    assert "only the part of the object that is visible inside its clip path" in warnings(drawing)


def test_a_line_is_cut_at_a_polygon_and_at_its_hole() -> None:
    ring = "0 0 90 90 re 30 10 20 60 re W* n"
    assert lengths(read(pdf(f"q {ring} 10 20 m 95 20 l S Q"))) == [20.0, 40.0]
    triangle = "0 0 m 40 0 l 0 40 l h W n"
    assert lengths(read(pdf(f"q {triangle} 0 20 m 60 20 l S Q"))) == [20.0]


def test_nested_clip_paths_and_the_box_of_a_form_are_intersected() -> None:
    form = stream(b"0 20 m 90 20 l S", "/Type /XObject /Subtype /Form /BBox [20 0 70 90]")
    drawing = read(
        pdf(CUT, "q 10 0 30 90 re W n /F Do Q", resources="/XObject <</F 6 0 R>>", more=[form])
    )
    assert lengths(drawing) == [100.0, 20.0]


def test_a_line_outside_its_clip_path_is_left_out_with_a_warning() -> None:
    drawing = read(pdf(CUT, "70 70 9 9 re W n 0 0 m 50 0 l S"))
    assert lengths(drawing) == [100.0]
    assert "outside its clip path or mask" in warnings(drawing)


def test_a_clip_path_of_the_page_keeps_lines_that_cross_its_border() -> None:
    drawing = read(pdf("0 0 100 100 re W n -5 50 m 50 50 l S", size=(100.0, 100.0)))
    assert lengths(drawing) == [55.0]
    assert "a part of the object lies outside the visible area" in warnings(drawing)


@pytest.mark.parametrize("white", ["1 G", "1 1 1 RG", "0 0 0 0 K", "0.99 G"])
def test_white_lines_are_left_out_with_a_warning(white: str) -> None:
    drawing = read(pdf(CUT, f"{white} 0 0 m 50 0 l S"))
    assert lengths(drawing) == [100.0]
    assert "in white on a white page" in warnings(drawing)


def test_white_lines_on_a_dark_area_are_kept() -> None:
    assert lengths(read(pdf("0 g 0 0 90 90 re f", CUT, "1 G 5 5 m 50 5 l S"))) == [100.0, 45.0]


def test_a_spot_colour_that_is_displayed_in_white_is_kept() -> None:
    space = (
        "/White [/Separation /CutContour /DeviceCMYK "
        "<</FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] /C1 [0 0 0 0] /N 1>>]"
    )
    drawing = read(pdf(CUT, "/White CS 1 SCN 0 0 m 50 0 l S", spaces=space))
    assert lengths(drawing) == [100.0, 50.0]


def test_a_masked_line_is_kept_whole_with_a_warning() -> None:
    masks = "/ExtGState <</M <</SMask <</S /Alpha>>>> /N <</SMask /None>>>>"
    drawing = read(pdf(CUT, "/M gs 0 0 m 50 0 l S /N gs 0 9 m 40 9 l S", resources=masks))
    assert lengths(drawing) == [100.0, 50.0, 40.0]
    assert warnings(drawing).startswith("1 object on layer '0' is imported with a change: the file")


def test_a_group_with_opacity_0_is_left_out_with_a_warning() -> None:
    form = stream(
        b"/B gs 0 20 m 50 20 l S", "/Type /XObject /Subtype /Form /Group <</S /Transparency>>"
    )
    resources = "/XObject <</F 6 0 R>> /ExtGState <</A <</ca 0>> /B <</ca 1 /CA 1>>>>"
    drawing = read(pdf(CUT, "q /A gs /F Do Q /F Do", resources=resources, more=[form]))
    assert lengths(drawing) == [100.0, 50.0]
    assert "completely transparent" in warnings(drawing)


def test_a_curve_is_not_cut_by_a_clip_path_of_the_same_shape() -> None:
    curve = "0 0 m 0 800 650 1400 1400 1400 c 1400 0 l h"
    drawing = read(pdf(f"{curve} W n {curve} S", size=(1400.0, 1401.0)))
    assert import_warnings(drawing) == []


def test_the_warning_about_other_pages_names_the_page_with_the_most_lines() -> None:
    line = b"0 0 m 9 0 l S "
    assert warnings(read(pages(line, line, 3 * b"5 5 9 9 re S ", b""))) == (
        "The file has 3 other pages besides page 1, and only page 1 is read. Page 3 "
        "has the most lines of the other pages (12)."
    )


def test_the_chosen_page_is_read() -> None:
    data = pages(b"0 0 m 9 0 l S", b"0 0 m 0 20 l S 0 20 m 9 20 l S", b"")
    assert len(read(data)) == 1
    second = choose_page(choose_page(data, 1), 2)
    assert second.startswith(data)
    drawing = read(second)
    assert len(drawing) == 2
    assert warnings(drawing).startswith("The file has 2 other pages besides page 2, ")
    with pytest.raises(NotADrawing, match="The PDF has 3 pages, but no page 4"):
        read(choose_page(data, 4))
    with pytest.raises(NotADrawing, match="contains no drawing"):
        read(choose_page(data, 3))


def test_each_page_is_read_although_others_are_damaged() -> None:
    data = pages(b"0 0 m 9 0 l S", b"(never closed", b"", b"0 0 m 5 5 l S 1 1 m 2 1 l S")
    first, second, third, fourth = read_each_page(choose_page(data, 4), 9)
    assert not isinstance(first, KnifetipError)
    assert not isinstance(fourth, KnifetipError)
    assert (len(first), len(fourth)) == (1, 2)
    assert isinstance(second, NotADrawing)
    assert isinstance(third, NotADrawing)
    assert len(read_each_page(data, 2)) == 2


@pytest.mark.parametrize("other", [b"(never closed", b""])
def test_a_damaged_or_blank_other_page_does_not_prevent_reading(other: bytes) -> None:
    assert warnings(read(pages(b"0 0 m 9 0 l S", other))) == (
        "The file has 2 pages, but only page 1 is read."
    )


def test_a_pdf_has_no_warning_that_another_unit_is_likelier() -> None:
    # Whole numbers of points look like whole millimetres.
    grid = " ".join(f"{x} 10 m {x} 210 l S 10 {x} m 310 {x} l S" for x in range(10, 310, 50))
    data = pdf(grid, size=(400.0, 400.0))
    codes = [one["code"] for one in drawing_json(pipeline.read(data))["warnings"]]
    assert "unit.read-against-evidence" not in codes


@pytest.mark.parametrize("algorithm", ["RC4-40", "RC4-128", "AES-128", "AES-256-R5", "AES-256"])
def test_an_encrypted_file_with_an_empty_password_is_read(algorithm: str) -> None:
    plain = read(carton(layered=True))
    again = read(encrypted(algorithm, ""))
    assert_allclose(again.ends, plain.ends)
    assert again.layers == plain.layers


def test_an_encrypted_file_with_a_password_is_refused() -> None:
    with pytest.raises(NotADrawing) as caught:
        read(encrypted("AES-256", "secret"))
    assert caught.value.message.code == "pdf.encrypted"


def encrypted(algorithm: str, password: str) -> bytes:
    writer = PdfWriter(clone_from=PdfReader(io.BytesIO(carton(layered=True))))
    writer.encrypt(password, "owner", algorithm=algorithm)
    out = io.BytesIO()
    writer.write(out)
    return out.getvalue()
