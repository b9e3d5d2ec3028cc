"""Jobs on printed sheets: the program follows the measured marks, and wrong ones are refused."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from shapely import Polygon, affinity, box, get_coordinates, points

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.errors import PlanError, TravelExceeded
from knifetip.geometry.similarity import Similarity
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.job_options import JobOptions
from knifetip.model.registration import Registration
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Severity
from knifetip.planning import registration as planned
from knifetip.planning.sheet_outline import sheet_outline
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.measured_marks import sheet_turn
from knifetip.verification.expectation.sheet_area import place_sheet
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline

MARKS = ((5.0, 5.0), (280.0, 5.0), (5.0, 240.0))
TURN, SCALE, SHIFT = 3.0, 1.004, (70.0, 40.0)


@cache
def carton() -> tuple[Drawing, Dieline]:
    drawn = pipeline.read(dict(samples())["tuck-end-carton.dxf"])
    return drawn, pipeline.classify(drawn, load.profile("default"))


def lie(x: float, y: float, turn: float = TURN, scale: float = SCALE) -> tuple[float, float]:
    """Where shapely places a point of the drawing on the table."""
    point = affinity.rotate(points(x, y), turn, origin=(0, 0))
    point = affinity.scale(point, scale, scale, origin=(0, 0))
    (found,) = get_coordinates(affinity.translate(point, *SHIFT)).tolist()
    return found[0], found[1]


def measured(*offsets: tuple[float, float], **others: Any) -> Registration:
    """The marks as measured on the sheet, each with an error of its own (mm)."""
    errors = [*offsets, *[(0.0, 0.0)] * (len(MARKS) - len(offsets))]
    places = [
        (x + dx, y + dy)
        for (x, y), (dx, dy) in zip((lie(*mark) for mark in MARKS), errors, strict=True)
    ]
    return Registration(marks=MARKS, measured=tuple(places), **others)


def compiled(registration: Registration | None, **others: Any) -> pipeline.Compiled:
    drawn, edges = carton()
    options = JobOptions(registration=registration, **others)
    return pipeline.compile(
        drawn, edges, load.machine("demo-table"), load.board("solid-1.0"), options=options
    )


@cache
def on_sheet() -> pipeline.Compiled:
    return compiled(measured())


def test_the_program_lies_on_the_print() -> None:
    result = on_sheet()
    assert result.verdict.accepted, result.verdict.findings
    assert result.placement == (0.0, 0.0)
    # The tip of the knife and the axis of the wheel pass through the ends of the drawn lines.
    _, edges = carton()
    cut = np.unique(edges.ends[edges.line_type == LineType.CUT].reshape(-1, 2).round(6), axis=0)
    placed = np.array([lie(x, y) for x, y in cut.tolist()])
    assert len(placed) > 10
    ends = np.concatenate([result.toolpath.pose[:, :2]])
    distance = np.hypot(*(placed[:, None] - ends[None]).transpose(2, 0, 1)).min(axis=1)
    # The head leads or follows the tip of its knife by its trail.
    assert distance.max() < 12.0


def test_the_verdict_states_how_the_sheet_lies() -> None:
    notes = [one for one in on_sheet().verdict.findings if one.kind == "registration"]
    (note,) = notes
    assert note.severity is Severity.NOTE
    stated = note.message.arguments
    assert stated["turn"] == pytest.approx(TURN)
    assert stated["scale"] == pytest.approx(SCALE)
    assert (stated["x"], stated["y"]) == pytest.approx(SHIFT)
    assert stated["error"] == pytest.approx(0.0, abs=1e-9)
    assert b"turn 3.0000 scale 1.004000" in on_sheet().program.text


def test_a_cutter_keeps_its_true_radius() -> None:
    """The head is as far from the line on the sheet as the cutter's radius, not 1.004 times."""
    corners = ((0.0, 0.0), (280.0, 0.0), (280.0, 240.0), (0.0, 240.0))
    square = dieline((LineType.CUT, closed(*corners)))
    machine, board = load.machine("router-table"), load.board("solid-1.0")
    drawn = drawing(square.ends, [("CUT", 7, "CONTINUOUS")] * len(square))
    options = JobOptions(registration=measured())
    result = pipeline.compile(drawn, square, machine, board, options=options)
    assert result.verdict.accepted
    outline = Polygon([lie(*corner) for corner in corners]).exterior
    pose = result.toolpath.pose
    cutting = pose[pose[:, 2] < board.caliper / 2.0, :2]
    near = np.round(outline.distance(points(cutting)), 3)
    tool = next(one.tool for one in machine.stations if one.number == result.toolpath.tool[-1])
    assert near.min() == tool.dimensions["radius"]
    assert (near == near.min()).sum() > 4


def test_without_a_measurement_the_sheet_lies_at_the_stops() -> None:
    result = compiled(Registration(marks=MARKS))
    assert result.placement == compiled(None).placement
    (note,) = (one for one in result.verdict.findings if one.kind == "registration")
    assert note.message.code == "registration.not-measured"
    assert not note.refuses


def test_a_program_of_a_measured_sheet_is_verified_alone() -> None:
    _, edges = carton()
    machine, board = load.machine("demo-table"), load.board("solid-1.0")

    def accepted(registration: Registration | None) -> bool:
        options = JobOptions(registration=registration)
        text = on_sheet().program.text
        verdict = pipeline.verify(text, edges, (0.0, 0.0), machine, board, options=options)
        return verdict.accepted

    assert accepted(measured())
    assert not accepted(None)
    assert not accepted(measured((0.2, 0.0)))


WRONG: dict[str, Callable[[Similarity], Similarity]] = {
    "the turn has the wrong sign": lambda map: map._replace(b=-map.b),
    "the map is applied twice": lambda map: Similarity(
        map.a * map.a - map.b * map.b,
        2.0 * map.a * map.b,
        *map.apply(np.array([map.x, map.y])).tolist(),
    ),
    "the scale is left out": lambda map: map._replace(a=map.a / map.scale, b=map.b / map.scale),
    "the scale is that of its inverse": lambda map: map._replace(
        a=map.a / map.scale**2, b=map.b / map.scale**2
    ),
    "the shift is 0.1 mm off": lambda map: map._replace(x=map.x + 0.1),
}


@pytest.mark.parametrize("fault", WRONG)
def test_a_wrongly_laid_drawing_is_refused(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    original = planned.lay_edges
    monkeypatch.setattr(
        pipeline,
        "lay_edges",
        lambda edges, map: original(edges, None if map is None else WRONG[fault](map)),
    )
    verdict = compiled(measured()).verdict
    assert not verdict.accepted
    assert {one.message.code for one in verdict.findings if one.refuses} == {
        "registration.edge-elsewhere"
    }


def test_marks_that_fit_badly_are_refused_with_place_and_measure() -> None:
    with pytest.raises(PlanError) as error:
        compiled(measured((0.0, 0.0), (3.0, 0.0)))
    assert error.value.message.code == "registration.error"
    assert error.value.message.arguments["distance"] > 0.5
    # A greater limit lets the same marks pass.
    assert compiled(measured((0.0, 0.0), (3.0, 0.0), limit=1.5)).verdict.accepted


def test_the_scale_is_kept_if_the_order_says_so() -> None:
    with pytest.raises(PlanError) as error:
        compiled(measured(scale="keep"))
    # Marks 275 mm apart are measured 276.1 mm apart.
    assert error.value.message.code == "registration.error"
    result = compiled(measured(scale="keep", limit=1.0))
    assert result.verdict.accepted
    assert b"scale 1.000000" in result.program.text


@pytest.mark.parametrize(
    ("code", "places"),
    [
        ("registration.scale", [lie(*mark, scale=1.03) for mark in MARKS]),
        ("registration.mirrored", [(300.0 - x, y) for x, y in MARKS]),
        ("registration.close", [(100.0, 100.0), (300.0, 100.0), (100.2, 100.1)]),
    ],
)
def test_impossible_measurements_are_refused(code: str, places: list[tuple[float, float]]) -> None:
    with pytest.raises(PlanError) as error:
        compiled(Registration(marks=MARKS, measured=tuple(places)))
    assert error.value.message.code == code


def test_a_sheet_that_lies_past_the_table_is_refused() -> None:
    with pytest.raises(TravelExceeded) as error:
        compiled(Registration(marks=MARKS, measured=tuple((x + 1400.0, y) for x, y in MARKS)))
    assert error.value.message.code == "registration.off-table"


def test_a_turned_sheet_with_a_size_is_where_its_corners_are() -> None:
    """Planner and verifier place it by different calculations, and shapely by a third one."""
    sheet, table = Sheet(width=310.0, height=280.0, margin=10.0), load.machine("demo-table")
    drawn, edges = carton()
    laid = planned.lay_edges(edges, measured().similarity)
    outline = sheet_outline(sheet, laid, table, TURN)
    area = place_sheet(sheet, place_edges(laid, (0.0, 0.0)), sheet_turn(measured()))
    x, y = lie(*drawn.bounds[:2].tolist())
    wanted = affinity.rotate(box(x - 10.0, y - 10.0, x + 300.0, y + 270.0), TURN, origin=(x, y))
    for start in (outline.start, area.start):
        assert wanted.symmetric_difference(Polygon(start.tolist())).area < 0.01
    assert compiled(measured(), sheet=sheet).verdict.accepted


def test_a_turned_sheet_must_lie_on_the_table() -> None:
    with pytest.raises(PlanError) as error:
        compiled(measured(), sheet=Sheet(width=1580.0, height=280.0, margin=10.0))
    assert error.value.message.code == "sheet.off-table"
    # The far corner of the turned sheet is higher than its near one.
    top = error.value.message.arguments["top"]
    assert top > 280.0 + 1580.0 * math.sin(math.radians(TURN))
