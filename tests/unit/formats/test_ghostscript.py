"""PostScript, EPS and old Illustrator files are converted by Ghostscript, if it is installed."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from knifetip import pipeline
from knifetip.errors import DrawingTooLarge, NotADrawing, ReadError
from knifetip.formats import choose_page, cpu_limit, open_file, read_each_page
from knifetip.formats.conversion import GHOSTSCRIPT
from knifetip.library import load
from knifetip.model.drawing import Drawing
from knifetip.presentation.import_warnings import import_warnings
from tests.support.converters import needs_ghostscript
from tests.support.writers import eps_text, pdf_text
from tests.support.writers.eps_text import (
    MM,
    eps,
    illustrator,
    layer,
    pages,
    with_preview,
)

pytestmark = needs_ghostscript


def lines_of(drawing: Drawing) -> list[list[float]]:
    """Return the ends of the edges in points, from the lower left corner of a page."""
    ends: list[list[float]] = (drawing.ends.reshape(-1, 4) * MM).round(3).tolist()
    return ends


def lines_in_box(drawing: Drawing) -> list[list[float]]:
    """Return the ends of the edges in points, from that of the bounding box.

    The visible area begins one point to the left of and below the box.
    """
    return [[number - 1.0 for number in ends] for ends in lines_of(drawing)]


def refusal(data: bytes) -> ReadError:
    """Return the error with which a file is refused."""
    with pytest.raises(ReadError) as caught:
        pipeline.read(data)
    return caught.value


@pytest.mark.parametrize(
    "data",
    [
        eps_text.carton(),
        with_preview(eps_text.carton()),
        eps_text.carton().replace(b" EPSF-3.0", b"\n%%Creator: Adobe Illustrator(R) 8.0"),
    ],
    ids=["eps", "eps-with-preview", "illustrator"],
)
def test_the_carton_is_the_same_as_in_pdf(data: bytes) -> None:
    drawing, same = pipeline.read(data), pipeline.read(pdf_text.carton(layered=False))
    assert (drawing.unit, drawing.evidence.code) == ("pt", "unit.pdf")
    assert set(drawing.layers) == {"CutContour", "Crease"}
    assert set(drawing.linetypes) == set(same.linetypes)
    # Layers and ellipses are curves in one and arcs in the other, so lengths are compared.
    rules = load.profile("default")
    for kind in range(8):
        mine, theirs = (
            one.lengths[pipeline.classify(one, rules).line_type == kind].sum()
            for one in (drawing, same)
        )
        assert_allclose(mine, theirs, atol=0.01)
    assert_allclose(np.ptp(drawing.bounds.reshape(2, 2), axis=0), [200.0, 80.0], atol=0.002)


def test_the_report_names_ghostscript_and_its_version() -> None:
    report = pipeline.read(eps_text.carton()).import_report
    program = GHOSTSCRIPT.find()
    assert program is not None
    assert report.kind[-1] == "file"
    assert report.reason[-1].arguments["program"] == f"Ghostscript {program.version}"


def test_the_same_file_always_gives_the_same_pdf() -> None:
    first, second = (open_file(eps_text.carton()).data for _ in range(2))
    assert first == second
    assert b"/CreationDate" not in first


def test_line_widths_and_colours_are_kept_also_of_the_thinnest_lines() -> None:
    drawing = pipeline.read(
        eps(
            "1 setlinewidth 10 10 moveto 90 10 lineto stroke",
            "0 setlinewidth 10 20 moveto 90 20 lineto stroke",
            "1 0 0 setrgbcolor 2 setlinewidth 10 30 moveto 90 30 lineto stroke",
            "0 1 1 0 setcmykcolor 10 40 moveto 90 40 lineto stroke",
        )
    )
    assert drawing.line_width.tolist() == [35, 0, 71, 71]
    assert drawing.true_colour[2] == 0xFF0000
    assert drawing.true_colour[0] != drawing.true_colour[2]


def test_what_lies_outside_the_bounding_box_is_told_and_not_lost_in_silence() -> None:
    drawing = pipeline.read(
        eps(
            "10 10 moveto 90 10 lineto stroke",
            "-50 20 moveto -20 20 lineto stroke",
            "400 20 moveto 500 20 lineto stroke",
            "80 50 moveto 120 50 lineto stroke",
            box="0 0 100 100",
        )
    )
    assert len(drawing) == 2
    assert [warning.arguments["objects"] for warning in import_warnings(drawing)] == [2, 1]


@pytest.mark.parametrize("box", ["0 0 0 0", "(atend)"])
def test_without_a_bounding_box_all_is_read(box: str) -> None:
    drawing = pipeline.read(
        eps(
            "-50 20 moveto -20 20 lineto stroke 2000 20 moveto 2400 20 lineto stroke",
            box=box,
        )
    )
    assert_allclose(drawing.lengths * MM, [30.0, 400.0], atol=0.02)
    assert import_warnings(drawing) == []


def test_a_page_of_postscript_is_chosen() -> None:
    data = pages(
        "0 0 moveto 90 0 lineto stroke",
        "0 0 moveto 0 20 lineto stroke 0 20 moveto 9 20 lineto stroke",
    )
    assert [len(page) for page in read_each_page(data, 9) if isinstance(page, Drawing)] == [1, 2]
    assert lines_of(pipeline.read(data)) == [[0.0, 0.0, 90.0, 0.0]]
    second = pipeline.read(choose_page(choose_page(data, 1), 2))
    assert lines_of(second) == [[0.0, 0.0, 0.0, 20.0], [0.0, 20.0, 9.0, 20.0]]
    assert refusal(choose_page(data, 3)).message.code == "conversion.result-unreadable"


def test_layers_of_illustrator_without_its_procedure_sets_are_read() -> None:
    drawing = pipeline.read(
        illustrator(
            layer("Die", "0 0 0 1 K 0.8 w", "10 10 m 190 10 L 190 90 L 10 90 L s"),
            layer("Fold", "1 0 0 0 K [4 2] 0 d", "100 10 m 100 90 l S"),
            layer("Old", "[] 0 d 50 10 m 50 90 l S", visible=False),
        )
    )
    assert [drawing.layers[number] for number in drawing.layer] == ["Die"] * 4 + ["Fold"]
    assert_allclose(drawing.lengths * MM, [180.0, 80.0, 180.0, 80.0, 80.0], atol=0.001)
    dashed = [drawing.linetypes[number] != "Continuous" for number in drawing.linetype]
    assert dashed == [False] * 4 + [True]
    assert drawing.line_width[0] == 28
    (hidden,) = import_warnings(drawing)
    assert hidden.arguments["layer"] == "Old"


#: A procedure set as Illustrator writes it: its operators of layers only remove their operands.
PROCEDURE_SET = b"""\
%%BeginResource: procset Adobe_Illustrator_AI5 1.3 0
userdict /Adobe_Illustrator_AI5 91 dict dup begin put
/bd { bind def } bind def
/initialize { Adobe_Illustrator_AI5 begin } bd
/terminate { end } bd
/m { moveto } bd /l { lineto } bd /L /lineto load def
/S { stroke } bd /s { closepath stroke } bd
/K { setcmykcolor } bd /w { setlinewidth } bd /d { setdash } bd
/kept null def
/Lb { 10 { pop } repeat /kept save store } bd
/Ln /pop load def
/LB { kept restore } bd
end
%%EndResource
"""


def test_layers_of_illustrator_with_its_procedure_sets_are_read() -> None:
    data = illustrator(
        layer("Die", "0 0 0 1 K 0.8 w", "10 10 m 190 10 L 190 90 L 10 90 L s"),
        layer("Fold", "1 0 0 0 K", "100 10 m 100 90 l S"),
        layer("Old", "50 10 m 50 90 l S", visible=False),
    )
    used = data.replace(b"Adobe_packedarray /init", b"Adobe_Illustrator_AI5 /init")
    assert used != data
    drawing = pipeline.read(used.replace(b"%%EndComments\n", b"%%EndComments\n" + PROCEDURE_SET))
    assert [drawing.layers[number] for number in drawing.layer] == ["Die"] * 4 + ["Fold"]
    assert_allclose(drawing.lengths * MM, [180.0, 80.0, 180.0, 80.0, 80.0], atol=0.001)
    (hidden,) = import_warnings(drawing)
    assert hidden.arguments["layer"] == "Old"


def test_operators_of_illustrator() -> None:
    drawing = pipeline.read(
        illustrator(
            # Colours of lines are not those of areas.
            "1 0 0 XA 0 1 0 Xa",
            "10 10 m 20 10 l S",
            "0 1 0 0 (CutContour) 0 X 10 20 m 20 20 l S",
            "0 0 1 (Fold) 0 1 XX 10 30 m 20 30 l S",
            # A path that is neither drawn nor filled, a guide, and a text.
            "10 40 m 20 40 l N 10 50 m 20 50 l (N) *",
            "0 To 1 0 0 1 10 10 0 Tp (60 60 m 70 60 l S) Tx TO",
            "u *u 10 70 m 20 70 l S *U U",
            "q 0 0 m 15 0 l 15 99 l 0 99 l h W n 10 80 m 20 80 l S Q",
            "10 90 m 30 90 l S",
        )
    )
    assert lines_in_box(drawing)[:3] == [
        [10.0, 10.0, 20.0, 10.0],
        [10.0, 20.0, 20.0, 20.0],
        [10.0, 30.0, 20.0, 30.0],
    ]
    assert [row[1] for row in lines_in_box(drawing)] == [10.0, 20.0, 30.0, 70.0, 80.0, 90.0]
    assert lines_in_box(drawing)[4] == [10.0, 80.0, 15.0, 80.0]
    assert {drawing.layers[number] for number in drawing.layer[1:3]} == {"CutContour", "Fold"}
    assert drawing.true_colour[0] == 0xFF0000


@pytest.mark.parametrize("curve", ["80 20 90 90 c", "80 20 90 90 C"])
def test_curves_of_illustrator_are_those_of_postscript(curve: str) -> None:
    same = pipeline.read(eps(f"10 10 moveto 10 60 {curve[:-1]} curveto stroke"))
    drawing = pipeline.read(illustrator(f"10 10 m 10 60 {curve} S"))
    assert_allclose(drawing.ends, same.ends, atol=1e-9)
    first = pipeline.read(illustrator("10 10 m 40 80 90 90 v S"))
    assert_allclose(
        first.ends, pipeline.read(eps("10 10 moveto 10 10 40 80 90 90 curveto stroke")).ends
    )
    last = pipeline.read(illustrator("10 10 m 40 80 90 90 y S"))
    assert_allclose(
        last.ends, pipeline.read(eps("10 10 moveto 40 80 90 90 90 90 curveto stroke")).ends
    )


def test_an_illustrator_file_with_its_own_operators_is_executed_with_them() -> None:
    own = "userdict begin /m { exch moveto } def /l { exch lineto } def end"
    drawing = pipeline.read(illustrator(own, "10 20 m 10 90 l S"))
    assert lines_in_box(drawing) == [[20.0, 10.0, 90.0, 10.0]]


def test_operators_of_illustrator_are_no_operators_of_other_files() -> None:
    assert refusal(eps("10 10 m 90 10 l S")).message.arguments["reason"] == "undefined: m"


def test_an_unknown_operator_of_illustrator_is_refused() -> None:
    error = refusal(illustrator("10 10 m 90 10 l S", "0 0 1 Bg"))
    assert error.message.arguments["reason"] == "undefined: Bg"


@pytest.mark.parametrize("program", ["10 10 moveto nonsense", "(a) 1 add", "stroke ]"])
def test_an_error_has_its_position_in_the_file(program: str) -> None:
    error = refusal(eps(program))
    assert error.message.code == "conversion.failed-at"
    data = eps(program)
    # Ghostscript stops after the word that is wrong.
    end = data.index(program.encode()) + len(program)
    assert error.message.arguments["position"] == pytest.approx(end, abs=1)
    assert "Ghostscript" in error.text
    assert "choose File > Save As > PDF" in error.hint


def test_a_file_without_its_end_is_refused() -> None:
    whole = eps(*(f"10 {y} moveto 90 {y} lineto stroke" for y in range(200)))
    two = pages(*("10 10 moveto 90 10 lineto stroke\n" * 40 for _ in range(2)))
    for data in (whole[:3000], with_preview(whole)[:3000], two[: len(two) - 100]):
        assert refusal(data).message.code == "reading.truncated"
    # An end mark is not required.
    assert len(pipeline.read(whole.removesuffix(b"%%EOF\n"))) == 200


def test_a_blank_page_is_refused() -> None:
    error = refusal(eps())
    assert error.message.code == "conversion.result-unreadable"
    assert "Save As > PDF" in error.hint


@pytest.mark.parametrize(
    "program",
    [
        "(/etc/passwd) (r) file 1000 string readstring pop =",
        "(%os%/etc/passwd) (r) file pop",
        "(/etc/passwd) run",
        "({outside}) (r) file 100 string readstring pop =",
        "({outside}) (w) file (changed) writestring",
        "({outside}) (a) file (changed) writestring",
        "({outside}) deletefile",
        "({outside}) ({outside}2) renamefile",
        "({folder}/new) (w) file closefile",
        "(%pipe%touch {folder}/new) (w) file closefile",
        "(%pipe%id) (r) file 100 string readline pop =",
        "<< /OutputFile ({folder}/new) >> setpagedevice",
        "<< /OutputFile (%pipe%touch {folder}/new) >> setpagedevice",
        "(/proc/self/environ) (r) file pop",
        "currentsystemparams pop << /PermitFileReading [(*)] >> setuserparams "
        "({outside}) (r) file pop",
        "({folder}/*) {{ (/outside) search {{ stop }} if pop }} 1000 string filenameforall",
    ],
)
def test_a_program_cannot_reach_files_outside_its_folder(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, program: str
) -> None:
    outside = tmp_path / "outside"
    outside.write_text("secret", encoding="utf-8")
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    text = program.format(outside=outside, folder=tmp_path)
    data = eps("10 10 moveto 90 10 lineto stroke", text)
    if "filenameforall" in program:
        # It finds only the files of its own folder, so the rest of the file is executed.
        assert len(pipeline.read(data)) == 1
    else:
        error = refusal(data)
        assert error.message.code.startswith("conversion.failed")
        assert "secret" not in error.text
    assert outside.read_text(encoding="utf-8") == "secret"
    assert {path.name for path in tmp_path.iterdir()} == {"outside", "temporary"}
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize(
    ("program", "seconds", "codes"),
    [
        ("{} loop", 0.7, {"conversion.too-slow"}),
        # The limit of memory is reached before that of time, also on a slow computer.
        ("{ 10000000 string } loop", 60.0, {"conversion.too-much-memory"}),
        (
            "/s 65535 string def { s print } loop",
            0.7,
            {"conversion.too-large", "conversion.too-slow"},
        ),
        (
            "{ null (w) .tempfile exch pop 1000 { dup 65535 string writestring } repeat closefile }"
            " loop",
            3.0,
            # A version without this operator reports an error.
            {"conversion.too-large", "conversion.failed-at"},
        ),
        ("/f { f f } def f", 3.0, {"conversion.failed-at", "conversion.failed"}),
        ("{ showpage } loop", 0.7, {"conversion.too-slow", "conversion.too-large"}),
    ],
)
def test_a_hostile_program_is_refused_within_the_limits(
    program: str, seconds: float, codes: set[str]
) -> None:
    with cpu_limit.limit_cpu(seconds), pytest.raises((NotADrawing, DrawingTooLarge)) as caught:
        pipeline.read(eps(program))
    assert caught.value.message.code in codes
