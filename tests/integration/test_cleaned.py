"""Damaged drawings through all stages: the same program, and a verdict for the drawn edges."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.cleaning.clean import Extent, clean
from knifetip.geometry.columns import F64, I64
from knifetip.library import load
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from tests.support.truth.named import SAMPLES, Named

TABLE = load.machine("demo-table")


def with_more(
    drawing: Drawing, line: Dieline, ends: F64, bulge: F64, like: I64
) -> tuple[Drawing, Dieline]:
    """Return the drawing and its dieline with additional edges.

    ``like`` is the row of the edge whose style and line type each additional edge gets, (n,).
    """
    columns: dict[str, Any] = {
        name: np.concatenate([getattr(drawing, name), getattr(drawing, name)[like]])
        for name in (
            *("entity", "layer", "colour", "true_colour", "linetype"),
            *("line_width", "fit_error"),
        )
    }
    more = replace(
        drawing,
        ends=np.concatenate([drawing.ends, ends]),
        bulge=np.concatenate([drawing.bulge, bulge]),
        **columns,
    )
    return more, replace(
        line,
        ends=more.ends,
        bulge=more.bulge,
        line_type=np.concatenate([line.line_type, line.line_type[like]]),
        source=np.arange(len(more), dtype=np.int32),
        rule=np.concatenate([line.rule, line.rule[like]]),
        confidence=np.concatenate([line.confidence, line.confidence[like]]),
        face=np.concatenate([line.face, line.face[like]]),
        part=np.concatenate([line.part, line.part[like]]),
        fit_error=np.concatenate([line.fit_error, line.fit_error[like]]),
    )


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_a_sample_with_everything_drawn_twice_gives_the_same_program(named: Named) -> None:
    drawing, line, board = named.classified(None)
    whole = pipeline.compile(drawing, line, TABLE, board)
    every = np.arange(len(line))
    twice = with_more(drawing, line, line.ends[:, ::-1], -line.bulge, every)
    made = pipeline.compile(*twice, TABLE, board)
    assert made.program.text == whole.program.text
    assert made.verdict.accepted
    assert len(made.verdict.deviation) == 2 * len(line)
    np.testing.assert_array_equal(made.toolpath.source, whole.toolpath.source)
    assert made.verdict.uncut.sum() == whole.verdict.uncut.sum()


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_a_sample_in_pieces_with_creases_under_its_cuts_is_accepted(named: Named) -> None:
    drawing, line, board = named.classified(None)
    straight = np.flatnonzero((line.bulge == 0.0) & (line.line_type == LineType.CUT))
    # Every straight cut is split in two, with a crease under a part of it.
    ends = line.ends.copy()
    middle = ends[straight].mean(axis=1)
    pieces = np.stack([middle, ends[straight, 1]], axis=1)
    ends[straight, 1] = middle
    under = ends[straight] * 0.5 + middle[:, None] * 0.5
    broken, pieced = with_more(
        replace(drawing, ends=ends),
        replace(line, ends=ends),
        np.concatenate([pieces, under]),
        np.zeros(2 * len(straight)),
        np.concatenate([straight, straight]),
    )
    kinds = pieced.line_type.copy()
    kinds[-len(straight) :] = LineType.CREASE
    made = pipeline.compile(broken, replace(pieced, line_type=kinds), TABLE, board)
    assert made.verdict.accepted, made.verdict.findings[:2]
    whole = pipeline.compile(drawing, line, TABLE, board)
    assert made.verdict.setback.sum() == pytest.approx(whole.verdict.setback.sum(), abs=1e-6)
    assert made.toolpath.source.max() < len(broken)


def test_a_blank_left_open_at_its_corners_is_cut_closed() -> None:
    drawing, line, board = SAMPLES[2].classified(None)
    ends = line.ends.copy()
    cut = np.flatnonzero((line.line_type == LineType.CUT) & (line.bulge == 0.0))
    way = ends[cut, 1] - ends[cut, 0]
    ends[cut, 0] += 0.02 * way / np.hypot(*way.T)[:, None]
    made = pipeline.compile(replace(drawing, ends=ends), replace(line, ends=ends), TABLE, board)
    assert made.verdict.accepted
    np.testing.assert_allclose(made.verdict.tidied[cut].max(), 0.02, atol=1e-9)
    whole = pipeline.compile(drawing, line, TABLE, board)
    assert made.seconds == pytest.approx(whole.seconds, rel=1e-3)


def test_a_program_that_cuts_by_a_cleaning_that_lost_an_edge_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawing, line, board = SAMPLES[0].classified(None)

    def careless(given: Dieline, extent: Extent = Extent.ALL) -> Cleaned:
        made = clean(given, extent)
        kinds = made.dieline.line_type.copy()
        kinds[3] = LineType.IGNORED
        return replace(made, dieline=replace(made.dieline, line_type=kinds))

    monkeypatch.setattr("knifetip.checked_cleaning.clean", careless)
    verdict = pipeline.compile(drawing, line, TABLE, board).verdict
    assert not verdict.accepted
    assert ("Edge 3: Internal error in cleaning: the edge has the line type") in verdict.findings[
        0
    ].text


def test_flaws_in_a_file_by_another_author_are_reported_for_each_edge(corpus: Path) -> None:
    named = Named("Obrary__Parametric-Papercraft/Interchange-Files", "cube.dxf", "e-flute", "mm")
    drawing, line, board = named.classified(corpus)
    made = pipeline.compile(drawing, line, TABLE, board)
    assert made.verdict.accepted
    # Four cuts of 40 mm lie on cuts of 50 mm.
    assert pipeline.clean(line).merged[[11, 14, 36, 54]].tolist() == [40.0] * 4
    assert not np.isin(made.toolpath.source, [11, 14, 36, 54]).any()
