"""The command line: what it prints, what it writes, and how it exits."""

from __future__ import annotations

import json
import sys

import pytest

from knifetip.cli import main
from knifetip.dxf.samples import samples


@pytest.fixture
def folder(tmp_path):
    for name, data in samples().items():
        (tmp_path / name).write_bytes(data)
    return tmp_path


@pytest.fixture
def knifetip(monkeypatch, capfd):
    """Run the command; returns exit code, stdout, stderr."""

    def run(*words):
        monkeypatch.setattr(sys, "argv", ["knifetip", *map(str, words)])
        with pytest.raises(SystemExit) as left:
            main()
        out, err = capfd.readouterr()
        return left.value.code, out, err

    return run


RIGID = ("--machine", "demo-table", "--board", "greyboard-2.0")


def test_classify_says_of_every_edge_what_it_is_and_why(knifetip, folder):
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
    assert {row["fate"] for row in data["ledger"]} == {"kept"}


def test_read_lists_every_entity(knifetip, folder):
    code, out, _ = knifetip("read", folder / "tuck-end-carton.dxf", "--json")
    assert code == 0
    assert len(json.loads(out)["ledger"]) > 5


def test_program_writes_what_verify_accepts(knifetip, folder):
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
    code, judged, _ = knifetip("verify", out, "--drawing", drawing, *RIGID, "--json")
    assert code == 0
    assert json.loads(judged)["deviation"] < 0.01


def test_the_same_input_gives_the_same_bytes(knifetip, folder):
    for name in ("a.nc", "b.nc"):
        knifetip("program", folder / "tuck-end-carton.dxf", "--machine", "demo-table",
                 "--board", "fbb-0.4", "-o", folder / name)  # fmt: skip
    assert (folder / "a.nc").read_bytes() == (folder / "b.nc").read_bytes() != b""


def test_a_changed_program_is_refused_with_exit_code_1(knifetip, folder):
    drawing, out = folder / "rigid-box-blank.dxf", folder / "p.ngc"
    knifetip("program", drawing, *RIGID, "--dialect", "linuxcnc", "-o", out)
    text = out.read_text()
    line = next(line for line in text.splitlines() if line.startswith("G1 Y"))
    changed = line.replace("Y1", "Y2", 1) if "Y1" in line else line.replace("Y", "Y1", 1)
    out.write_text(text.replace(line, changed))
    code, _, err = knifetip("verify", out, "--drawing", drawing, *RIGID)
    assert code == 1
    assert "refused" in err


def test_open_questions_are_printed_and_exit_with_2(knifetip, folder):
    drawing, out = folder / "rigid-box-blank.dxf", folder / "p.nc"
    code, _, err = knifetip("program", drawing, *RIGID, "--layer", "CUT=unclassified", "-o", out)
    assert code == 2
    assert "24 edges on layer" in err
    assert not out.exists()


def test_a_layer_may_be_given_a_line_type(knifetip, folder):
    code, out, _ = knifetip(
        "classify", folder / "rigid-box-blank.dxf", "--layer", "cut=half-cut", "--json"
    )
    assert code == 0
    assert sum(edge["type"] == "half-cut" for edge in json.loads(out)["edges"]) == 24


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("read", "nowhere.dxf"), "nowhere.dxf"),
        (("program", "{}", *RIGID, "--machine", "none", "-o", "x"), "no machine 'none'"),
        (("program", "{}", *RIGID, "--board", "none", "-o", "x"), "no board 'none'"),
        (("classify", "{}", "--profile", "none"), "no profile 'none'"),
        (("classify", "{}", "--layer", "nothing=cut"), "no layer 'nothing'"),
        (("classify", "{}", "--layer", "CUT=sawn"), "'sawn' is not a line type"),
        (("classify", "{}", "--layer", "CUT"), "is not NAME=TYPE"),
        (("machine", "none"), "no machine 'none'"),
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_said_with_exit_code_3(knifetip, folder, words, said):
    drawing = folder / "rigid-box-blank.dxf"
    code, _, err = knifetip(*(word.format(drawing) for word in words))
    assert code == 3
    assert said in err
    assert "Traceback" not in err


def test_a_picture_is_no_drawing(knifetip, tmp_path):
    (tmp_path / "a.dxf").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(200))
    code, _, err = knifetip("read", tmp_path / "a.dxf")
    assert code == 3
    assert "PNG" in err


def test_machine_states_the_tools_as_the_engines_use_them(knifetip):
    code, out, _ = knifetip("machine", "demo-table", "--json")
    stations = {row["number"]: row for row in json.loads(out)["stations"]}
    assert code == 0
    assert stations[3]["tool"]["back"] == 6.0
    assert stations[3]["tool"]["half_width"] == 1.5
    assert stations[3]["tool"]["length"] == pytest.approx(6.0 * 2**0.5)
    assert stations[2]["datum"] == {"x": 60.0, "y": 0.0, "z": -1.5, "c": 0.0}


def test_the_tool_table_is_linuxcncs(knifetip):
    code, out, _ = knifetip("machine", "demo-table", "--tool-table")
    assert code == 0
    assert out.splitlines()[1].startswith("T2 P2 X60")


def test_samples_are_written(knifetip, tmp_path):
    code, _, _ = knifetip("samples", tmp_path / "new")
    assert code == 0
    assert len(list((tmp_path / "new").glob("*.dxf"))) == 3
