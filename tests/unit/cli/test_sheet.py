"""The option ``--sheet`` of knifetip program and verify."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import pytest

from tests.support.command import Command
from tests.support.writers import dxf_text as text

RIGID = ("--machine", "demo-table", "--board", "greyboard-2.0")


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Write a blank of 300 × 200 mm with five V-grooves from edge to edge."""
    outline = text.rectangle(300, 200, (8, "CUT"))
    grooves = [text.line(0, y, 300, y, (8, "V-GROOVE")) for y in range(30, 180, 30)]
    path = tmp_path / "grooved.dxf"
    path.write_bytes(text.dxf(outline, *grooves, units=4))
    return path


@pytest.mark.parametrize("sheet", ["outline", "300x200", "300x200:0"])
def test_a_sheet_cut_to_size_saves_time_and_is_stated(
    knifetip: Command, drawing: Path, sheet: str
) -> None:
    seconds, programs = [], []
    for name, words in (("plain", ()), ("cut", ("--sheet", sheet))):
        out, report = drawing.with_name(f"{name}.ngc"), drawing.with_name(f"{name}.json")
        code, _, err = knifetip("program", drawing, *RIGID, "-o", out, "--report", report, *words)
        assert code == 0, err
        data = json.loads(report.read_text())
        seconds.append(data["seconds"])
        programs.append(out.read_text())
    assert seconds[1] < seconds[0]
    size = None if sheet == "outline" else (300.0, 200.0)
    assert data["sheet"] == {
        "width": size and size[0],
        "height": size and size[1],
        "margin": 0.0,
        "margin_below": None,
    }
    assert "sheet" not in programs[0]
    assert "(sheet " in programs[1]
    # The program is safe on this sheet only.
    cut = drawing.with_name("cut.ngc")
    verify = ("verify", cut, "--drawing", drawing, *RIGID)
    assert knifetip(*verify, "--sheet", sheet)[0] == 0
    assert knifetip(*verify)[0] == 1


@pytest.mark.parametrize(
    ("sheet", "expected"),
    [
        ("abc", "'abc' is not a size of a sheet"),
        ("0x200", "'0x200' is not a size of a sheet"),
        ("300x200:-1", "'300x200:-1' is not a size of a sheet"),
        ("300x9000", "would lie from X 20.0"),
        ("290x200", "The sheet of 290.0 × 200.0 mm is too small"),
    ],
)
def test_an_impossible_sheet_is_refused_with_exit_code_3(
    knifetip: Command, drawing: Path, sheet: str, expected: str
) -> None:
    out = drawing.with_name("p.ngc")
    code, _, err = knifetip("program", drawing, *RIGID, "-o", out, "--sheet", sheet)
    assert code == 3
    assert expected in err
    assert not out.exists()


def test_the_zones_of_a_machine_are_shown_and_work_in_them_is_refused(
    knifetip: Command, drawing: Path
) -> None:
    machine = drawing.with_name("mine.toml")
    shipped = (resources.files("knifetip") / "library/machines/demo-table.toml").read_text("utf-8")
    zone = '[[zone]]\nname = "Stop"\nx = 5.0\ny = 100.0\nwidth = 10.0\nheight = 10.0\ntop = 9.0\n'
    machine.write_text(f"{shipped}\n{zone}")
    _, out, _ = knifetip("machine", machine)
    assert "keep-out zone Stop: X 5 to 15, Y 100 to 110, 9 mm high" in out
    _, out, _ = knifetip("machine", machine, "--json")
    assert json.loads(out)["zones"][0]["top"] == 9.0
    words = ("--machine", machine, "--board", "greyboard-2.0", "-o", drawing.with_name("p.ngc"))
    code, _, err = knifetip("program", drawing, *words)
    assert code == 3
    assert "would touch the keep-out zone Stop at X" in err
    assert "Move the clamp or stop away" in err


def test_the_least_lift_is_lower_and_needs_a_stated_turn_clearance(
    knifetip: Command, drawing: Path
) -> None:
    seconds = []
    for name in ("clearance", "least"):
        report = drawing.with_name(f"{name}.json")
        out = drawing.with_name(f"{name}.ngc")
        words = ("program", drawing, *RIGID, "-o", out, "--report", report, "--lift", name)
        code, _, err = knifetip(*words)
        assert code == 0, err
        data = json.loads(report.read_text())
        assert data["lift"] == name
        seconds.append(data["seconds"])
    assert seconds[1] < 0.99 * seconds[0]
    machine = drawing.with_name("mine.toml")
    shipped = (resources.files("knifetip") / "library/machines/demo-table.toml").read_text("utf-8")
    machine.write_text(shipped.replace("turn_clearance = 0.5", ""))
    least = ("--machine", machine, "--board", "greyboard-2.0", "--lift", "least")
    code, _, err = knifetip("program", drawing, *least, "-o", drawing.with_name("p.ngc"))
    assert code == 3
    assert "does not state to which height (turn_clearance)" in err
