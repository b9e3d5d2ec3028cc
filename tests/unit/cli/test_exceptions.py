"""The option ``--accept`` of knifetip program and verify."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from knifetip.cli.program import faulty_edges
from knifetip.messages import Message
from knifetip.model.edge_figures import EdgeFigures
from knifetip.model.verdict import Finding, Severity, Verdict
from tests.support.command import Command
from tests.support.writers import dxf_text as text

ROUTER = ("--machine", "router-table", "--board", "greyboard-3.0")
WHY = ("--reason", "the tab is 8 mm wide", "--by", "Ada")


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Write a blank of 300 × 200 mm with one slit, which the router mills 6 mm wide."""
    outline = text.rectangle(300, 200, (8, "CUT"))
    path = tmp_path / "slit.dxf"
    path.write_bytes(text.dxf(outline, text.line(100, 100, 200, 100, (8, "CUT")), units=4))
    return path


def test_the_program_is_written_when_its_shortfall_is_accepted(
    knifetip: Command, drawing: Path
) -> None:
    out, report = drawing.with_suffix(".ngc"), drawing.with_suffix(".json")
    compile = ("program", drawing, *ROUTER, "-o", out, "--report", report)
    code, _, err = knifetip(*compile)
    assert code == 1
    assert not out.exists()
    assert 'To accept: --accept 4:verify.wide-slit --reason "..."' in err
    code, _, err = knifetip(*compile, "--accept", "4:verify.wide-slit", *WHY)
    assert code == 0, err
    assert "accepted by Ada: the tab is 8 mm wide" in err
    verdict = json.loads(report.read_text())["verdict"]
    (kept,) = [one["acceptance"] for one in verdict["findings"] if one["kind"] == "kerf"]
    assert (kept["by"], kept["reason"]) == ("Ada", "the tab is 8 mm wide")
    verify = ("verify", out, "--drawing", drawing, *ROUTER)
    assert knifetip(*verify)[0] == 1
    assert knifetip(*verify, "--accept", "4:verify.wide-slit", *WHY)[0] == 0


@pytest.mark.parametrize(
    ("words", "code", "expected"),
    [
        (("--accept", "4:verify.wide-slit"), 2, "Give the reason why"),
        (("--accept", "wide-slit", *WHY), 2, "not of the form EDGE:CODE"),
        (("--accept", "9:verify.wide-slit", *WHY), 3, "no finding verify.wide-slit at edge 9"),
    ],
)
def test_a_wrong_acceptance_is_refused_with_its_reason(
    knifetip: Command, drawing: Path, words: tuple[str, ...], code: int, expected: str
) -> None:
    found, out, err = knifetip(
        "program", drawing, *ROUTER, "-o", drawing.with_suffix(".ngc"), *words
    )
    assert found == code
    assert expected in " ".join((out + err).replace("│", "").split())


def test_the_edges_of_faults_can_be_left_out() -> None:
    message = Message("verify.past-end", tool="knife", length=0.07)
    figures: dict[str, Any] = {**EdgeFigures.zeros(9).columns()}
    findings = tuple(Finding("overcut", message, 0.07, edge=row) for row in (7, 2, 7, -1))
    # Edge 3 is the first chord of a curve.
    curve = Finding("overcut", message, 0.07, edge=3, edges=(3, 4, 5))
    verdict = Verdict(False, 0.01, (*findings, curve), 1.0, **figures)
    assert faulty_edges(verdict) == [2, 3, 4, 5, 7]
    shortfall = replace(findings[0], severity=Severity.SHORTFALL)
    verdict = Verdict(False, 0.01, (shortfall,), 1.0, **figures)
    assert faulty_edges(verdict) == []
