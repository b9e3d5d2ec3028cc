"""The verifier and the engines: programs of deliberately broken engines are each refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip import compensate, pipeline, plan, process, sequence
from knifetip.compensation import crease, knife, tracks, vgroove
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.tool import VCutter
from knifetip.model.verdict import Verdict
from knifetip.verification.verify import verify
from tests.support.modules import original
from tests.support.shapes import closed, dieline, edges
from tests.support.truth.named import SAMPLES, Named

CARTON, TRAY, RIGID = SAMPLES


def verdict(named: Named) -> Verdict:
    drawing, dieline, board = named.classified(None)
    return pipeline.compile(drawing, dieline, load.machine("demo-table"), board).verdict


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_programs_of_the_engines_are_accepted(named: Named) -> None:
    result = verdict(named)
    assert result.accepted, result.findings[:3]
    assert result.deviation.max() < 0.006
    assert result.uncut.sum() == 0.0


@pytest.mark.parametrize("dimension", ["back", "half_width"])
@pytest.mark.parametrize("error", [-0.02, 0.02])
def test_a_v_cutter_whose_d_or_r_is_wrong_by_a_fiftieth_is_refused(
    monkeypatch: pytest.MonkeyPatch, dimension: str, error: float
) -> None:
    right = vgroove.head_offset

    def wrong(start: F64, end: F64, cutter: VCutter) -> F64:
        return right(start, end, replace(cutter, **{dimension: getattr(cutter, dimension) + error}))

    monkeypatch.setattr(vgroove, "head_offset", wrong)
    assert not verdict(RIGID).accepted


def test_a_head_on_the_wrong_side_of_the_groove_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = original(vgroove, "right_normal")
    monkeypatch.setattr(vgroove, "right_normal", lambda vectors: -right(vectors))
    assert not verdict(RIGID).accepted


def test_a_plunge_the_wrong_way_along_the_blade_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = vgroove.sideways_move
    monkeypatch.setattr(vgroove, "sideways_move", lambda *args: -right(*args))
    assert not verdict(RIGID).accepted


@pytest.mark.parametrize("named", [CARTON, TRAY], ids=str)
def test_c_turning_the_wrong_way_is_refused(monkeypatch: pytest.MonkeyPatch, named: Named) -> None:
    right = tracks.headings

    def wrong(paths: Paths) -> tuple[F64, F64]:
        start, end = right(paths)
        return -start, -end

    monkeypatch.setattr(knife, "headings", wrong)
    monkeypatch.setattr(crease, "headings", wrong)
    assert not verdict(named).accepted


def test_c_turning_the_wrong_way_on_the_v_cutter_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    right = original(vgroove, "azimuth")
    monkeypatch.setattr(vgroove, "azimuth", lambda vectors: -right(vectors))
    assert not verdict(RIGID).accepted


@pytest.mark.parametrize("factor", [0.9, 1.1])
def test_a_wheel_set_back_too_little_or_too_much_is_refused(
    monkeypatch: pytest.MonkeyPatch, factor: float
) -> None:
    right = crease.half_contact_length
    monkeypatch.setattr(
        crease, "half_contact_length", lambda depth, wheel: factor * right(depth, wheel)
    )
    assert not verdict(TRAY).accepted


def test_a_blade_that_runs_on_inside_a_panel_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    outline = closed((0, 0), (200, 0), (200, 100), (0, 100))
    line = dieline((LineType.CUT, outline), (LineType.CUT, edges(((50, 50), (120, 50)))))
    machine, board = load.machine("demo-table"), load.board("greyboard-2.0")

    def verdict_of() -> Verdict:
        operations = plan(line, machine, board)
        toolpath = sequence([compensate(operation) for operation in operations], machine)
        text = process(toolpath, machine, "grblhal").text
        return verify(text, line, (0.0, 0.0), machine, board)

    assert verdict_of().accepted
    right = original(knife, "trim_ends")
    monkeypatch.setattr(knife, "trim_ends", lambda paths, a, b: right(paths, 0.0 * a, 0.0 * b))
    finding = verdict_of().findings[0]
    assert (finding.kind, finding.edge) == ("overcut", 4)
    # The blade at 10° cuts 2.3 mm deep, through the board and into the mat.
    assert finding.measure == pytest.approx(2.3 * 0.17633, abs=1e-3)
