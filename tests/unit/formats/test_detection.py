"""The format of a file is detected by its content."""

from __future__ import annotations

import gzip

import pytest

from knifetip.errors import NotADrawing
from knifetip.formats import format_of
from knifetip.pipeline import read
from tests.support.writers import cf2_text, hpgl_text, lightburn_text, pdf_text, svg_text
from tests.support.writers.dxf_text import dxf, line

SVG = svg_text.carton()
CF2 = cf2_text.carton()
PDF = pdf_text.carton()
PLT = hpgl_text.carton()
LBRN = lightburn_text.carton()
DXF = dxf(line(0, 0, 1, 1))


@pytest.mark.parametrize(
    ("data", "kind"),
    [
        (DXF, "dxf"),
        (b"\xef\xbb\xbf\r\n" + DXF, "dxf"),
        (DXF.decode().encode("utf-16"), "dxf"),
        (b"AutoCAD Binary DXF\r\n\x1a\x00", "dxf"),
        (b"999\nwritten by hand\n" + DXF, "dxf"),
        (CF2, "cf2"),
        (CF2.lower(), "cf2"),
        (CF2.decode().encode("utf-16"), "cf2"),
        (b"V2\nORDER\nEND\n", "cf2"),
        (b"\n MAIN,x\nUM\n", "cf2"),
        (b"L,2,1,0,0.5,1,2,3,0,0", "cf2"),
        (SVG, "svg"),
        (b'<?xml version="1.0"?><!-- <html> --><!DOCTYPE svg [<!ENTITY a "b">]>\n' + SVG, "svg"),
        (b"<s:svg xmlns:s='http://www.w3.org/2000/svg'/>", "svg"),
        (SVG.decode().encode("utf-16"), "svg"),
        (gzip.compress(SVG, mtime=0), "svg"),
        (PDF, "pdf"),
        (b"%PDF-1.5 of Illustrator", "pdf"),
        (LBRN, "lightburn"),
        (b"\xef\xbb\xbf<LightBurnProject/>", "lightburn"),
        (PLT, "plt"),
        (b"\r\n" + PLT.lower(), "plt"),
        (b"\x1b%-1BBP;IN;", "plt"),
        (b"\x1b.(;.I81;;17:.N;19:IN;SP1;", "plt"),
        (b"\x1bE\x1b&l0O\x1b%0BIN;", "plt"),
        (b"\x1b%-12345X@PJL ENTER LANGUAGE=HPGL2\r\nIN;", "plt"),
        (b"PU100,200;PD300,200;", "plt"),
        (b"SP1 PU100,200 PD300,200", "plt"),
        (b'CO"carton";IN;', "plt"),
        (b"Dear Sir or Madam", "dxf"),
        ("0\nSECTION\n2\nHEADER\n".encode("utf-16-le"), "dxf"),
        (b"AutoCAD Binary DXF\r\n\x1a\x00\x00\x00SECTION\x00", "dxf"),
    ],
)
def test_a_file_goes_to_its_reader(data: bytes, kind: str) -> None:
    assert format_of(data).name == kind


@pytest.mark.parametrize(
    ("data", "what"),
    [
        (b"", "is empty"),
        (b"%!PS-Adobe-3.0\n", "a PostScript file"),
        (b"%!PS-Adobe-3.0 EPSF-3.0\n", "an EPS file"),
        (b"%!PS-Adobe-3.0\n%%Creator: Adobe Illustrator(R) 8\n", "an old Illustrator file"),
        (b"RIFF\x00\x20\x00\x00CDRDvrsn", "a CorelDRAW drawing"),
        (b"RIFF\x00\x20\x00\x00WEBPVP8 ", "a picture or a video"),
        (b"\x1bE\x1b&l0O\x1b*t300R", "a file for a printer"),
        (b"\x1b%-12345X@PJL ENTER LANGUAGE=POSTSCRIPT\r\n", "a file for a printer"),
        (b"\x01\x02ARD\x00\x00\x07", "a binary file"),
        (b"\x89PNG\r\n", "a PNG picture"),
        (b"PK\x03\x04", "a ZIP archive"),
        (b"AC1032", "a DWG drawing"),
        (b"<!DOCTYPE html><html>", "an HTML page"),
        (b"<?xml version='1.0'?><kml/>", "an XML file of the type 'kml'"),
        (gzip.compress(DXF, mtime=0), "a gzip archive"),
        (b"\x1f\x8b", "a gzip archive"),
    ],
)
def test_another_format_is_refused_with_its_name_and_a_hint(data: bytes, what: str) -> None:
    with pytest.raises(NotADrawing) as caught:
        format_of(data)
    assert what in caught.value.text
    assert "DXF" in caught.value.hint
    assert "CF2, SVG, PDF, HPGL or LightBurn" in caught.value.hint


@pytest.mark.parametrize(
    ("data", "how"),
    [
        (b"AC1032", "In AutoCAD or another CAD program, choose File > Save As"),
        (b"RIFF\x00\x20\x00\x00CDR9", "In CorelDRAW, choose File > Export"),
        (b"\x1bE\x1b&l0O", "export the drawing as DXF, PDF or SVG instead of printing it"),
        (b"ISO-10303-21;", "make a flat drawing"),
        (b"\x89PNG\r\n", "A picture has no lines"),
    ],
)
def test_the_hint_names_the_program_and_what_to_export(data: bytes, how: str) -> None:
    with pytest.raises(NotADrawing) as caught:
        format_of(data)
    assert how in caught.value.hint


@pytest.mark.parametrize(
    "text", ["INSERT\n", "PART 12\n", "0\nSECTION\n", "INVOICE 7;\n", "SPEED 3\n", "PAGE 2;\n"]
)
def test_text_is_no_plotter_file(text: str) -> None:
    assert format_of(text.encode()).name == "dxf"


@pytest.mark.parametrize("data", [DXF, CF2, SVG, gzip.compress(SVG, mtime=0), PDF, PLT, LBRN])
def test_the_pipeline_reads_all_formats(data: bytes) -> None:
    assert len(read(data)) > 0


@pytest.mark.parametrize("data", [CF2, SVG, PDF, PLT, LBRN])
def test_the_unit_of_the_user_overrides_that_of_the_file(data: bytes) -> None:
    assert (read(data, "in").unit, read(data, "in").evidence.code) == ("in", "unit.given")
