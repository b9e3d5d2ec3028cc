"""The format of a file is detected by its content."""

from __future__ import annotations

import gzip
import io
import zipfile

import pytest

from knifetip.errors import NotADrawing
from knifetip.formats import format_of
from knifetip.pipeline import read
from tests.support.writers import cf2_text, hpgl_text, lightburn_text, pdf_text, svg_text
from tests.support.writers.dxf_text import dxf, line


def zipped(*names: str) -> bytes:
    """Return a ZIP archive with files of these names."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as written:
        for name in names:
            # Without the time, so that the names of tests are always the same.
            written.writestr(zipfile.ZipInfo(name), b"<a/>" * 2000)
    return archive.getvalue()


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
        (b"999\nArtiosCAD 22.03\n" + DXF, "dxf"),
        (b"AutoCAD Binary DXF\r\n\x1a\x00\xe7\x03ArtiosCAD\x00", "dxf"),
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
        (b"%!PS-Adobe-3.0\n", "eps"),
        (b"%!PS-Adobe-3.0 EPSF-3.0\n", "eps"),
        (b"%!PS-Adobe-3.0\n%%Creator: Adobe Illustrator(R) 8\n", "eps"),
        (b"\xc5\xd0\xd3\xc6\x1e\x00\x00\x00", "eps"),
        (b"AC1009", "dwg"),
        (b"AC1032", "dwg"),
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
        (b"RIFF\x00\x20\x00\x00CDRDvrsn", "a CorelDRAW drawing"),
        (b"RIFF\x00\x20\x00\x00WEBPVP8 ", "a picture or a video"),
        (b"\x1bE\x1b&l0O\x1b*t300R", "a file for a printer"),
        (b"\x1b%-12345X@PJL ENTER LANGUAGE=POSTSCRIPT\r\n", "a file for a printer"),
        (b"\x01\x02ARD\x00\x00\x07", "a binary file"),
        (b"ArtiosCAD\x00\x01\x00\xff", "an ArtiosCAD design"),
        (b"\x07\x00\x00Esko ArtiosCAD 22.03", "an ArtiosCAD design"),
        (b"DDES2\r\nN\r\n*\r\nLINE 0 0 1 0 100 0.028 0 0\r\n", "a DDES file"),
        (b"DDES 3\nUM\n", "a DDES file"),
        (b"RIFF\x00\x20\x00\x00CMX1disp", "a CorelDRAW drawing"),
        (zipped("content/riffData.cdr", "metadata/metadata.xml"), "a CorelDRAW drawing"),
        (zipped("[Content_Types].xml", "FixedDocumentSequence.fdseq"), "an XPS document"),
        (zipped("[Content_Types].xml", "dwf/documents/1/x"), "a DWF drawing"),
        (zipped("3D/3dmodel.model"), "a 3MF model"),
        (zipped("[Content_Types].xml", "word/document.xml"), "an Office document"),
        (zipped("carton.dxf"), "a ZIP archive"),
        (b"(DWF V06.00)PK", "a DWF drawing"),
        (b"\x01\x00\x00\x00" + bytes(36) + b" EMF\x00", "a Windows metafile"),
        (b"\xd7\xcd\xc6\x9a\x00\x00", "a Windows metafile"),
        (b"\x00\xffKA\x0a\x00", "an Affinity document"),
        (b"\x06\x06\xed\xf5\xd8\x1dF\xe5\xbd1", "an InDesign document"),
        (b"8BPS\x00\x01", "a Photoshop picture"),
        (b"3D Geometry File Format       70", "a Rhino model"),
        (b"\xff\xfe\xff\x0e" + "SketchUp Model".encode("utf-16-le"), "a SketchUp model"),
        (b"silhouette05\x00", "a project of Silhouette Studio"),
        (b"START RECORD".ljust(72) + b"S      1\r\n", "an IGES file"),
        (b";:H A L0 ECN U0,0 D100,0 ", "a plotter file in the language DM/PL"),
        (b"%\nO1234\n(carton)\nN10 G21 G90\n", "a program for a machine"),
        (b"; header\nG90\nG0 X0\n", "a program for a machine"),
        (b"\x89PNG\r\n", "a PNG picture"),
        (b"PK\x03\x04", "a ZIP archive"),
        (b"AC1006", "a DWG drawing"),
        (b"AC1.40", "an old DWG drawing"),
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
        (b"AC1006", "In AutoCAD or another CAD program, choose File > Save As"),
        (b"RIFF\x00\x20\x00\x00CDR9", "In CorelDRAW, choose File > Export"),
        (b"\x1bE\x1b&l0O", "export the drawing as DXF, PDF or SVG instead of printing it"),
        (b"ISO-10303-21;", "make a flat drawing"),
        (b"DDES2\n", "In ArtiosCAD, choose File > Outputs, and CFF2 or DXF as the type"),
        (b"\x00\xffKA", "In Affinity, choose File > Export"),
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
