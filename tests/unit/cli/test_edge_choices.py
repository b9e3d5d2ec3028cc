"""The options ``--contour-starts`` and ``--cut-depths`` of knifetip program and verify."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from knifetip.cli.edge_choices import parse_edge_choices
from knifetip.errors import PlanError
from knifetip.model.job_options import ContourStart, CutDepth
from tests.support.command import Command
from tests.support.writers import dxf_text as text

TARGET = ("--machine", "demo-table", "--board", "greyboard-2.0")


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Write a blank of 300 × 200 mm: edges 0 to 3."""
    path = tmp_path / "blank.dxf"
    path.write_bytes(text.dxf(text.rectangle(300, 200, (8, "CUT")), units=4))
    return path


def test_a_program_and_its_proof_have_the_same_choices(knifetip: Command, drawing: Path) -> None:
    out, report = drawing.with_suffix(".ngc"), drawing.with_suffix(".json")
    words = ("--contour-starts", "0:at=0.5,direction=reverse", "--cut-depths", "cut:passes=2")
    code, _, err = knifetip("program", drawing, *TARGET, "-o", out, "--report", report, *words)
    assert code == 0, err
    data = json.loads(report.read_text())
    assert data["contour_starts"] == [{"edges": [0], "at": 0.5, "direction": "reverse"}]
    assert data["cut_depths"] == [{"edges": [], "line_type": "cut", "passes": 2, "depth": None}]
    verify = ("verify", out, "--drawing", drawing, *TARGET)
    assert knifetip(*verify, *words)[0] == 0
    code, _, err = knifetip(*verify, "--contour-starts", "0:at=0.4", *words[2:])
    assert code == 1
    assert "must begin at X 120.000 mm, Y 0.000 mm on this edge" in err
    assert knifetip(*verify, *words[:2], "--cut-depths", "cut:passes=3")[0] == 1


def test_a_tool_is_chosen_and_proven(knifetip: Command, drawing: Path) -> None:
    out, report = drawing.with_suffix(".ngc"), drawing.with_suffix(".json")
    target = ("--machine", "fine-router-table", "--board", "greyboard-3.0")
    words = ("--edge-tools", "cut:station=6")
    code, _, err = knifetip("program", drawing, *target, "-o", out, "--report", report, *words)
    assert code == 0, err
    data = json.loads(report.read_text())
    assert data["edge_tools"] == [{"edges": [], "line_type": "cut", "station": 6}]
    verify = ("verify", out, "--drawing", drawing, *target)
    assert knifetip(*verify, *words)[0] == 0
    code, _, err = knifetip(*verify, "--edge-tools", "0:station=5")
    assert code == 1
    assert "must be made by the tool of station 5, but the program makes it with that of" in err


def test_edges_and_line_types_are_parsed() -> None:
    found = parse_edge_choices(CutDepth, "--cut-depths", ["3,4:passes=2,depth=1.5", "cut:depth=1"])
    assert found == (
        CutDepth(edges=(3, 4), passes=2, depth=1.5),
        CutDepth(line_type="cut", depth=1.0),
    )
    assert parse_edge_choices(CutDepth, "--cut-depths", None) == ()
    assert parse_edge_choices(ContourStart, "--contour-starts", ["7:at=0"]) == (
        ContourStart(edges=(7,), at=0.0),
    )


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ("3", "edge-choice.bad-syntax"),
        ("3:at", "edge-choice.bad-syntax"),
        ("cut:at=0.5", "edge-choice.bad-syntax"),
        ("3:at=2", "command.bad-option"),
        ("3:side=left", "command.bad-option"),
        ("-1:at=0.5", "command.bad-option"),
    ],
)
def test_other_values_are_refused(value: str, code: str) -> None:
    with pytest.raises(PlanError) as caught:
        parse_edge_choices(ContourStart, "--contour-starts", [value])
    assert caught.value.message.code == code


def test_an_order_of_edges_is_a_list_of_numbers(knifetip: Command, drawing: Path) -> None:
    out, report = drawing.with_suffix(".ngc"), drawing.with_suffix(".json")
    words = ("-o", out, "--report", report, "--work-order")
    assert knifetip("program", drawing, *TARGET, *words, "0, 2")[0] == 0
    assert json.loads(report.read_text())["work_order"] == [0, 2]
    for order, message in (("2,0", "in one track"), ("0,,2", "is not an order of edges")):
        code, _, err = knifetip("program", drawing, *TARGET, *words, order)
        assert code != 0
        assert message in err
