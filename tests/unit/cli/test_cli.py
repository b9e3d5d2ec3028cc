"""Commands on drawings and programs: output, written files and exit codes."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.library import load
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from tests.support.command import Command
from tests.support.writers import dxf_text as text
from tests.support.writers import pdf_text


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, data in samples().items():
        (tmp_path / name).write_bytes(data)
    return tmp_path


RIGID = ("--machine", "demo-table", "--board", "greyboard-2.0")


def test_classify_lists_line_type_and_rule_of_every_edge(knifetip: Command, folder: Path) -> None:
    code, out, _ = knifetip("classify", folder / "rigid-box-blank.dxf", "--json")
    data = json.loads(out)
    assert code == 0
    assert data["drawing"]["unit"] == "mm"
    assert data["drawing"]["size"] == pytest.approx([320.0, 250.0])
    assert data["questions"] == []
    kinds = [edge["type"] for edge in data["edges"]]
    assert (kinds.count("cut"), kinds.count("v-groove")) == (24, 4)
    groove = next(edge for edge in data["edges"] if edge["type"] == "v-groove")
    assert {"handle", "layer", "type", "rule", "confidence", "length"} <= set(groove)
    assert "V-GROOVE" in groove["rule"]
    assert {row["outcome"] for row in data["drawing"]["import_report"]["rows"]} == {"kept"}


@pytest.mark.parametrize("options", [(), ("--json",)])
def test_classify_exits_with_2_while_a_question_is_open(
    knifetip: Command, tmp_path: Path, options: tuple[str, ...]
) -> None:
    shape = [text.line(0, 0, 100, 0, (8, "?")), text.line(100, 0, 100, 80, (8, "?"))]
    (tmp_path / "open.dxf").write_bytes(text.dxf(*shape, units=4))
    code, out, _ = knifetip("classify", tmp_path / "open.dxf", *options)
    assert (code, out != "") == (2, True)
    code, _, err = knifetip("classify", tmp_path / "open.dxf", "--layer", "?=cut", *options)
    assert (code, err) == (0, "")


def test_classify_prints_edges_that_cleaning_refuses(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawing = tmp_path / "overlaps.dxf"
    overlaps = [text.line(0, 0, 100, 0, (8, "CUT")), text.line(50, 0, 150, 0, (8, "CUT"))]
    drawing.write_bytes(text.dxf(*overlaps, units=4))
    for name in ("_STRETCHES", "_TO_AN_EDGE"):
        monkeypatch.setattr(f"knifetip.cleaning.remove_overlaps.{name}", 0)
    assert knifetip("clean", drawing)[0] == 3
    code, out, err = knifetip("classify", drawing, "--json")
    assert (code, "not cleaned" in err) == (0, True)
    data = json.loads(out)
    assert [(edge["type"], edge["outcome"]) for edge in data["edges"]] == [("cut", "kept")] * 2
    report = data["drawing"]["report"]
    assert (report["kept"], report["merged"], report["dropped"]) == (200.0, 0.0, 0.0)


def test_classify_cleans_only_for_json(
    knifetip: Command, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cleaned: list[Dieline] = []

    def clean(dieline: Dieline) -> Cleaned:
        cleaned.append(dieline)
        return pipeline_clean(dieline)

    pipeline_clean = pipeline.clean
    monkeypatch.setattr(pipeline, "clean", clean)
    assert knifetip("classify", folder / "rigid-box-blank.dxf")[0] == 0
    assert len(cleaned) == 0
    assert knifetip("classify", folder / "rigid-box-blank.dxf", "--json")[0] == 0
    assert len(cleaned) == 1


def test_read_reports_every_entity(knifetip: Command, folder: Path) -> None:
    code, out, _ = knifetip("read", folder / "tuck-end-carton.dxf", "--json")
    assert code == 0
    assert len(json.loads(out)["drawing"]["import_report"]["rows"]) > 5


def test_read_groups_entities_by_outcome_and_lists_dropped_ones_first(
    knifetip: Command, tmp_path: Path
) -> None:
    lines = [text.line(0, 10 * n, 50, 10 * n, (8, "CUT")) for n in range(50)]
    notes = [
        text.entity("TEXT", (8, f"NOTE {n}"), (10, 0), (20, 0), (40, 3), (1, "x"))
        for n in range(60)
    ]
    (tmp_path / "many.dxf").write_bytes(text.dxf(*lines, *notes, units=4))
    code, out, _ = knifetip("read", tmp_path / "many.dxf")
    rows = [line.split() for line in out.splitlines()]
    dropped = [line for line in rows if line[0] == "dropped"]
    assert code == 0
    assert dropped[0][1:4] == ["1", "×", "TEXT"]
    # 60 layers with one text each and one group of 50 lines make 61 rows; 40 are printed.
    assert len(dropped) == 40
    assert "… and 21 more: --json lists them all" in out


def test_classify_prints_rule_and_confidence_of_each_line_type(
    knifetip: Command, folder: Path
) -> None:
    code, out, _ = knifetip("classify", folder / "rigid-box-blank.dxf")
    lines = [line.strip() for line in out.splitlines()]
    groove = next(n for n, line in enumerate(lines) if line.startswith("v-groove"))
    assert code == 0
    assert lines[groove + 1].startswith("4 × 95 %")
    assert "V-GROOVE" in lines[groove + 1]


def test_read_prints_the_size_and_the_evidence_for_the_unit(
    knifetip: Command, folder: Path
) -> None:
    code, out, _ = knifetip("read", folder / "rigid-box-blank.dxf")
    head, *rest = out.splitlines()
    assert code == 0
    assert "320.00 × 250.00 mm" in head
    assert any(line.split()[0] == "mm" and "the file states the unit mm" in line for line in rest)


def test_read_prints_the_size_in_millimetres_for_every_unit(
    knifetip: Command, tmp_path: Path
) -> None:
    (tmp_path / "carton.pdf").write_bytes(pdf_text.carton())
    code, out, _ = knifetip("read", tmp_path / "carton.pdf")
    assert code == 0
    assert out.splitlines()[0] == (
        "carton.pdf: 200.00 × 80.00 mm, 111 segments; the PDF states its "
        "coordinates in points (1/72 inch)"
    )


def test_read_warns_if_the_header_states_an_unlikely_unit(knifetip: Command, folder: Path) -> None:
    plain = (folder / "tuck-end-carton.dxf").read_bytes()
    start = plain.index(b"$INSUNITS")
    wrong = plain[:start] + plain[start:].replace(b" 4\n", b" 6\n", 1).replace(
        b"\n4\n", b"\n6\n", 1
    )
    (folder / "wrong.dxf").write_bytes(wrong)
    code, out, _ = knifetip("read", folder / "wrong.dxf", "--json")
    drawing = json.loads(out)["drawing"]
    assert code == 0
    assert drawing["unit_finding"]["stated"] == "m"
    assert drawing["unit"] != "m"
    assert drawing["unit_finding"]["ranking"][0] == "mm"
    if drawing["unit"]:
        assert drawing["warnings"][0].startswith("The file states the unit metres")


def test_verify_accepts_the_program_that_program_writes(knifetip: Command, folder: Path) -> None:
    drawing, out, report = folder / "rigid-box-blank.dxf", folder / "p.ngc", folder / "r.json"
    code, _, err = knifetip(
        "program", drawing, *RIGID, "--dialect", "linuxcnc", "-o", out, "--report", report
    )
    assert code == 0
    assert "accepted" in err
    written = json.loads(report.read_text())
    assert written["placement"] == [20.0, 20.0]
    assert written["verdict"]["accepted"] is True
    assert written["program"]["dialect"] == "linuxcnc"
    code, verdict, _ = knifetip("verify", out, "--drawing", drawing, *RIGID, "--json")
    assert code == 0
    assert json.loads(verdict)["deviation"] < 0.01


def test_verify_takes_the_placement_of_a_program_without_comments_from_an_option(
    knifetip: Command, folder: Path
) -> None:
    drawing, out = folder / "tuck-end-carton.dxf", folder / "p.plt"
    cutter = ("--machine", "flat-cutter-hpgl", "--board", "fbb-0.4")
    code, _, err = knifetip("program", drawing, *cutter, "-o", out)
    assert (code, "accepted" in err) == (0, True)
    code, _, err = knifetip("verify", out, "--drawing", drawing, *cutter)
    assert (code, "with --placement X,Y" in err) == (3, True)
    for placement, expected in (("20,20", 0), ("20.1, 20", 1), ("20", 2)):
        options = ("--placement", placement)
        assert knifetip("verify", out, "--drawing", drawing, *cutter, *options)[0] == expected


def test_programs_of_the_same_input_are_equal_byte_for_byte(
    knifetip: Command, folder: Path
) -> None:
    for name in ("a.nc", "b.nc"):
        knifetip("program", folder / "tuck-end-carton.dxf", "--machine", "demo-table",
                 "--board", "fbb-0.4", "-o", folder / name)  # fmt: skip
    assert (folder / "a.nc").read_bytes() == (folder / "b.nc").read_bytes() != b""


def test_verify_refuses_a_changed_program_with_exit_code_1(knifetip: Command, folder: Path) -> None:
    drawing, out = folder / "rigid-box-blank.dxf", folder / "p.ngc"
    knifetip("program", drawing, *RIGID, "--dialect", "linuxcnc", "-o", out)
    text = out.read_text()
    line = next(line for line in text.splitlines() if line.startswith("G1 Y"))
    changed = line.replace("Y1", "Y2", 1) if "Y1" in line else line.replace("Y", "Y1", 1)
    out.write_text(text.replace(line, changed))
    code, _, err = knifetip("verify", out, "--drawing", drawing, *RIGID)
    assert code == 1
    assert "refused" in err


def test_program_prints_open_questions_and_exits_with_2(knifetip: Command, folder: Path) -> None:
    drawing, out = folder / "rigid-box-blank.dxf", folder / "p.nc"
    code, _, err = knifetip("program", drawing, *RIGID, "--layer", "CUT=unclassified", "-o", out)
    assert code == 2
    assert "24 edges on layer" in err
    assert not out.exists()


def test_the_layer_option_sets_the_line_type_of_a_layer(knifetip: Command, folder: Path) -> None:
    code, out, _ = knifetip(
        "classify", folder / "rigid-box-blank.dxf", "--layer", "cut=half-cut", "--json"
    )
    assert code == 0
    assert sum(edge["type"] == "half-cut" for edge in json.loads(out)["edges"]) == 24


def test_an_edge_gets_the_line_type_of_its_option(knifetip: Command, folder: Path) -> None:
    drawing = folder / "rigid-box-blank.dxf"
    options = ("--layer", "cut=half-cut", "--edge", "0,2=ignored", "--json")
    code, out, err = knifetip("classify", drawing, *options)
    assert code == 0, err
    types = [edge["type"] for edge in json.loads(out)["edges"]]
    assert [types[0], types[2]] == ["ignored", "ignored"]
    assert "half-cut" in types


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("read", "nowhere.dxf"), "nowhere.dxf"),
        (("program", "{}", *RIGID, "--machine", "none", "-o", "x"), "machine 'none' does not"),
        (("program", "{}", *RIGID, "--board", "none", "-o", "x"), "board 'none' does not"),
        (("classify", "{}", "--profile", "none"), "The profile 'none' does not exist"),
        (("classify", "{}", "--layer", "nothing=cut"), "no layer 'nothing'"),
        (("classify", "{}", "--layer", "CUT=sawn"), "The line type in the option"),
        (("classify", "{}", "--layer", "CUT"), "does not have the form NAME=TYPE"),
        (("classify", "{}", "--edge", "1"), "does not have the form EDGE=TYPE"),
        (("classify", "{}", "--edge", "one=cut"), "does not have the form EDGE=TYPE"),
        (("classify", "{}", "--edge", "1=sawn"), "The line type in the option"),
        (("classify", "{}", "--edge", "99999=cut"), "Edge 99999 does not exist"),
        (("machine", "none"), "machine 'none' does not"),
    ],
)  # fmt: skip
def test_unusable_input_is_reported_with_exit_code_3(
    knifetip: Command, folder: Path, words: tuple[str, ...], expected: str
) -> None:
    drawing = folder / "rigid-box-blank.dxf"
    code, _, err = knifetip(*(word.format(drawing) for word in words))
    assert code == 3
    assert expected in err
    assert "Traceback" not in err


def test_read_refuses_a_png_image(knifetip: Command, tmp_path: Path) -> None:
    (tmp_path / "a.dxf").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(200))
    code, _, err = knifetip("read", tmp_path / "a.dxf")
    assert code == 3
    assert "PNG" in err


def test_machine_shows_given_and_derived_tool_dimensions(knifetip: Command) -> None:
    code, out, _ = knifetip("machine", "demo-table", "--json")
    machine = json.loads(out)
    stations = {row["number"]: row for row in machine["stations"]}
    assert code == 0
    assert machine["feed"] == "manual"
    assert stations[3]["tool"]["back"] == 6.0
    assert stations[3]["tool"]["half_width"] == 1.5
    assert stations[3]["tool"]["length"] == pytest.approx(6.0 * 2**0.5)
    assert stations[2]["datum"] == {"x": 60.0, "y": 0.0, "z": -1.5, "c": 0.0}


def test_machine_shows_the_carriages_and_the_letters_of_their_axes(knifetip: Command) -> None:
    code, out, _ = knifetip("machine", "two-carriage-table")
    assert code == 0
    assert "carriages at least 200 mm apart" in out
    assert "carriage 2: axes X V Z A, parks at V1420, stations 2, 3" in out
    code, out, _ = knifetip("machine", "two-carriage-table", "--tool-table")
    assert "T3 P3 X-45.0000 V5.0000 Z0.0000 A90.0000 " in out
    code, out, _ = knifetip("machine", "demo-table", "--json")
    machine = json.loads(out)
    assert machine["carriages"] == [{"number": 1, "letters": "XYZC", "park": 0.0}]
    assert (machine["min_distance"], machine["stations"][0]["carriage"]) == (None, 1)


def test_a_gateway_refuses_a_machine_with_several_carriages(
    knifetip: Command, tmp_path: Path
) -> None:
    text = (resources.files("knifetip") / "library/machines/two-carriage-table.toml").read_text()
    mine = tmp_path / "mine.toml"
    mine.write_text(text.replace('"linuxcnc"', '"grblhal"'), "utf-8")
    for command in ("gateway", "simulator"):
        code, _, err = knifetip(command, "--machine", mine)
        assert code != 0
        assert "has 2 carriages" in err
        assert "Download the program" in err


def test_machine_prints_a_tool_table_for_linuxcnc(knifetip: Command) -> None:
    code, out, _ = knifetip("machine", "demo-table", "--tool-table")
    assert code == 0
    assert out.splitlines()[1].startswith("T2 P2 X60")


def test_samples_writes_three_dxf_files(knifetip: Command, tmp_path: Path) -> None:
    code, _, _ = knifetip("samples", tmp_path / "new")
    assert code == 0
    assert len(list((tmp_path / "new").glob("*.dxf"))) == 3


ROUTED = ("--machine", "router-table", "--board", "greyboard-3.0")


def test_corner_options_change_the_program_and_appear_in_the_report(
    knifetip: Command, folder: Path
) -> None:
    drawing, out, report = folder / "rigid-box-blank.dxf", folder / "p.ngc", folder / "r.json"
    code, _, err = knifetip(
        "program", drawing, *ROUTED, "-o", out, "--report", report, "--corner", "D", "--k", "0.4",
        "--corner-at", "50,0=C", "--corner-at", "270,0=D:0.3",
    )  # fmt: skip
    assert code == 0, err
    data = json.loads(report.read_text())
    assert data["corners"] == {
        "type": "D",
        "k": 0.4,
        "interference": "trim",
        "at": [
            {"x": 50.0, "y": 0.0, "type": "C", "k": None},
            {"x": 270.0, "y": 0.0, "type": "D", "k": 0.3},
        ],
    }
    plain = folder / "q.ngc"
    knifetip("program", drawing, *ROUTED, "-o", plain)
    assert out.read_bytes() != plain.read_bytes()


def test_the_report_contains_the_figures_of_the_verdict(knifetip: Command, folder: Path) -> None:
    drawing, out, report = folder / "rigid-box-blank.dxf", folder / "p.ngc", folder / "r.json"
    code, _, err = knifetip("program", drawing, *ROUTED, "-o", out, "--report", report)
    assert code == 0, err
    data = json.loads(report.read_text())
    verdict = data["verdict"]
    # Eight corners that turn the cutter by 45°: r² (tan 22.5° - π/8) = 0.1936 mm² each.
    assert [area["area"] for area in verdict["areas"]] == pytest.approx([0.1936] * 8, rel=0.01)
    assert verdict["unreached"] == pytest.approx(8 * 0.1936, rel=0.01)
    assert len(verdict["areas"][0]["outline"]) == 3
    assert verdict["areas"][0].keys() == {"area", "x", "y", "outline"}
    assert "does not reach 1.55 mm² in 8 places" in err
    grooved = [edge for edge in verdict["edges"] if edge["width"] > 0.0]
    assert len(grooved) == 4
    # 2 mm deep at 45° in 3 mm.
    assert grooved[0]["width"] == pytest.approx(2.0 * GROOVE, abs=1e-3)
    assert grooved[0]["web"] == pytest.approx(3.0 - GROOVE, abs=1e-3)
    assert {"flank", "unreached", "bottom_uncut", "top_overcut"} <= set(grooved[0])
    assert len(data["samples"]["edge"]) == len(data["samples"]["deviation"]) > 0
    assert data["seconds"] < data["seconds_retracted"]
    saved = 1.0 - data["seconds"] / data["seconds_retracted"]
    shown = f"{100.0 * saved:.0f} % less than the {data['seconds_retracted']:.1f} s"
    assert f"{shown} with a full lift" in err


#: Depth of a groove in the board of these tests (mm).
GROOVE = load.board("greyboard-3.0").groove_depth


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (
            ("--corner-at", "3,3=C"),
            "No corner of a milled contour lies within 0.5 mm of X 3 mm, Y 3 mm",
        ),
        (("--corner-at", "50,0"), "does not have the form X,Y=TYPE"),
        (("--corner-at", "nan,0=C"), "does not have the form X,Y=TYPE"),
        (
            ("--corner-at", "50,0=E"),
            "--corner-at 50,0=E cannot be used: type is 'E', but must be 'B', 'C', 'D' or 'auto'",
        ),
        (
            ("--corner-at", "50,0=D:1"),
            "--corner-at 50,0=D:1 cannot be used: k is 1.0, but must be less than 1",
        ),
        (("--k", "nan"), "--corner cannot be used: k is nan, but must be a number"),
        (("--k", "1.5"), "--corner cannot be used: k is 1.5, but must be less than 1"),
    ],
)
def test_invalid_corner_options_are_reported_with_exit_code_3(
    knifetip: Command, folder: Path, words: tuple[str, str], expected: str
) -> None:
    drawing = folder / "rigid-box-blank.dxf"
    code, _, err = knifetip("program", drawing, *ROUTED, "-o", folder / "p.ngc", *words)
    assert code == 3
    assert expected in err
    assert not (folder / "p.ngc").exists()


def test_corner_options_are_refused_for_a_machine_without_a_cutter(
    knifetip: Command, folder: Path
) -> None:
    drawing = folder / "rigid-box-blank.dxf"
    code, _, err = knifetip("program", drawing, *RIGID, "-o", folder / "p.ngc", "--corner", "D")
    assert code == 3
    assert "has no rotating cutter" in err


def test_calibrate_prints_the_deflection_and_writes_a_usable_board_file(
    knifetip: Command, folder: Path
) -> None:
    points, board = folder / "points.csv", folder / "mine.toml"
    # 45°: ΔX = -δx sin 45°, ΔY = δy cos 45°.
    points.write_text("azimuth,dx,dy\n45,-0.056569,0.035355\n")
    code, out, err = knifetip("calibrate", points, *ROUTED, "--store", board)
    assert (code, out) == (0, "[deflection.Router]\nx = 0.0800\ny = 0.0500\n"), err
    stored = ("--machine", "router-table", "--board", board)
    drawing = folder / "rigid-box-blank.dxf"
    given, rest = folder / "given.ngc", folder / "rest.ngc"
    assert knifetip("program", drawing, *stored, "-o", given)[0] == 0
    assert knifetip("program", drawing, *ROUTED, "-o", rest)[0] == 0
    assert given.read_bytes() != rest.read_bytes()


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ("azimuth,dx,dy\n0,0,0.05\n", "Measure one more point where the contour runs along Y"),
        ("azimuth,dx,dy\n", "0 measured points"),
        ("azimuth,dx\n0,0.05\n", "has no value for dy"),
        ("azimuth,dx,dy\n0,near,0.05\n", "Line 2 of"),
        ("azimuth,dx,dy\n45,nan,0.05\n", "must be a finite number"),
    ],
)
def test_calibrate_refuses_missing_or_invalid_points(
    knifetip: Command, folder: Path, content: str, expected: str
) -> None:
    points = folder / "points.csv"
    points.write_text(content)
    code, out, err = knifetip("calibrate", points, *ROUTED)
    assert (code, out) == (3, "")
    assert expected in err
