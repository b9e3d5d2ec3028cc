"""Drawings that are put together on a sheet, and the verifier's answer about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.errors import DrawingTooLarge
from knifetip.layout import compose as composing
from knifetip.layout.blanks import find_blanks
from knifetip.layout.collisions import find_off_sheet, find_overlaps, place_blanks
from knifetip.layout.compose import ComposedSheet, Source, compose
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.layout import Layout, LayoutSheet, PlacedDrawing
from knifetip.model.verdict import Finding
from knifetip.verification.checks.layout.check import PlacedCopy, check_layout
from tests.support.serving.server import square
from tests.support.shapes import closed, dieline

SHEET = LayoutSheet(width=1200.0, height=800.0)


@cache
def carton() -> Source:
    """The tuck-end carton of the samples."""
    drawing = pipeline.read(dict(samples())["tuck-end-carton.dxf"])
    return Source(drawing, pipeline.classify(drawing, load.profile("default")))


def placed(x: float, y: float, **others: Any) -> PlacedDrawing:
    return PlacedDrawing(drawing="carton", x=x, y=y, **others)


def composed(*entries: PlacedDrawing) -> ComposedSheet:
    return compose(Layout(sheet=SHEET, placed=entries), [carton()], [0] * len(entries))


def findings(sheet: ComposedSheet, changed: Dieline | None = None) -> Sequence[Finding]:
    copies = [PlacedCopy(carton().dieline, copy.position) for copy in sheet.copies]
    return check_layout(changed or sheet.dieline, copies)


@pytest.mark.parametrize("turn", [0.0, 90.0, -90.0, 180.0, 33.3])
@pytest.mark.parametrize("mirror", [False, True])
def test_the_box_of_a_copy_begins_where_it_is_placed(turn: float, mirror: bool) -> None:
    sheet = composed(placed(20.0, 35.0, turn=turn, mirror=mirror))
    np.testing.assert_allclose(sheet.drawing.bounds[:2], (20.0, 35.0), atol=1e-6)
    made = carton().dieline.line_type != LineType.IGNORED
    assert len(sheet.dieline) == made.sum()
    assert sheet.drawing.lengths.sum() == pytest.approx(carton().drawing.lengths[made].sum())
    assert findings(sheet) == []


def test_rows_and_columns_have_the_given_gaps() -> None:
    sheet = composed(placed(10.0, 10.0, columns=2, rows=2, gap_x=8.0, gap_y=5.0))
    boxes = np.array([copy.box for copy in sheet.copies])
    width, height = boxes[0, 2:] - boxes[0, :2]
    np.testing.assert_allclose(
        boxes[:, :2] - 10.0,
        [(0.0, 0.0), (width + 8.0, 0.0), (0.0, height + 5.0), (width + 8.0, height + 5.0)],
    )
    assert findings(sheet) == []


def test_each_copy_is_a_part_of_its_own() -> None:
    sheet = composed(placed(10.0, 10.0, columns=3, gap_x=5.0))
    parts = [set(sheet.dieline.part[sheet.copy == copy].tolist()) - {-1} for copy in range(3)]
    assert all(parts)
    assert not (parts[0] & parts[1]) | (parts[1] & parts[2])


@pytest.mark.parametrize("mirror", [False, True])
def test_the_verifier_finds_each_change_of_an_edge(mirror: bool) -> None:
    sheet = composed(placed(0.0, 0.0), placed(400.0, 0.0, turn=90.0, mirror=mirror))
    dieline = sheet.dieline
    row = int(np.flatnonzero((sheet.copy == 1) & (dieline.bulge != 0.0))[0])
    ends, bulge, line_type = dieline.ends.copy(), dieline.bulge.copy(), dieline.line_type.copy()
    ends[row, 0, 0] += 0.001
    bulge[row] = -bulge[row]
    line_type[row] = LineType.CREASE
    for change in ({"ends": ends}, {"bulge": bulge}, {"line_type": line_type}):
        (finding,) = findings(sheet, replace(dieline, **change))
        assert (finding.message.code, finding.edge) == ("layout.edge-elsewhere", row)
        assert finding.message.arguments["copy"] == 2


def test_the_verifier_finds_missing_and_added_edges() -> None:
    one, two = composed(placed(0.0, 0.0)), composed(placed(0.0, 0.0, columns=2, gap_x=5.0))
    assert [finding.message.code for finding in findings(two, one.dieline)] == [
        "layout.edges-missing"
    ]
    assert [finding.message.code for finding in findings(one, two.dieline)] == [
        "layout.edges-added"
    ]


def test_overlaps_and_copies_off_the_sheet_are_found() -> None:
    sheet = composed(placed(10.0, 10.0, columns=2), placed(100.0, 10.0), placed(1100.0, 700.0))
    blanks = find_blanks(pipeline.clean(carton().dieline).dieline)
    areas = place_blanks(sheet.copies, [blanks])
    assert [(pair.copy, pair.other) for pair in find_overlaps(areas)] == [(0, 2), (1, 2)]
    (off,) = find_off_sheet(sheet.copies, SHEET)
    assert off.copy == 3
    assert off.distance == pytest.approx(sheet.copies[3].box[2] - 1200.0)


def test_a_sheet_has_a_limit_of_edges(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(composing, "MOST_EDGES", 3 * len(composed(placed(0.0, 0.0)).dieline) - 1)
    composed(placed(0.0, 0.0, columns=2))
    with pytest.raises(DrawingTooLarge):
        composed(placed(0.0, 0.0, columns=3))


def test_a_sheet_of_copies_compiles_to_an_accepted_program() -> None:
    sheet = composed(placed(10.0, 10.0, columns=2), placed(10.0, 400.0, turn=90.0))
    machine, board = load.machine("demo-table"), load.board("fbb-0.4")
    compiled = pipeline.compile(sheet.drawing, sheet.dieline, machine, board)
    assert compiled.verdict.accepted


@pytest.mark.parametrize(("gap", "drawn"), [(0.0, 2), (5.0, 1)])
def test_the_common_line_of_neighbours_without_a_gap_is_cut_once(gap: float, drawn: int) -> None:
    corners = closed((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0))
    source = Source(pipeline.read(square()), dieline((LineType.CUT, corners)))
    row = placed(50.0, 50.0, columns=3, gap_x=gap)
    sheet = compose(Layout(sheet=SHEET, placed=(row,)), [source], [0])
    compiled = pipeline.compile(
        sheet.drawing, sheet.dieline, load.machine("demo-table"), load.board("fbb-0.4")
    )
    path = compiled.toolpath
    lengths = np.hypot(*np.diff(path.pose[:, :2], axis=0).T)
    for x in (150.0, 250.0 + gap):
        edges = np.flatnonzero((sheet.dieline.ends[:, :, 0] == x).all(axis=1))
        assert len(edges) == drawn
        # A knife cuts a few mm more than the line at its ends.
        assert lengths[np.isin(path.source, edges)].sum() == pytest.approx(100.0, abs=15.0)
