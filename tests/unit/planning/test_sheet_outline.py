"""The outline of a sheet that was cut to size, and the run-out of grooves past its edge."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import PlanError
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.sheet import Sheet
from knifetip.planning.placement import placement
from knifetip.planning.plan import plan
from knifetip.planning.sheet_outline import sheet_outline, sheet_run_outs
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

BLANK = closed((0, 0), (300, 0), (300, 200), (0, 200))


def grooved(*grooves: tuple[tuple[float, float], tuple[float, float]]) -> Dieline:
    return dieline((LineType.CUT, BLANK), (LineType.V_GROOVE, edges(*grooves)))


def run_outs(drawn: Dieline, sheet: Sheet | None) -> list[list[float]]:
    outline = None if sheet is None else sheet_outline(sheet, drawn, MACHINE)
    operation = plan(drawn, MACHINE, BOARD, sheet=outline)[0]
    result: list[list[float]] = np.round(operation.run_out, 3).tolist()
    return result


@pytest.mark.parametrize("sheet", [Sheet(), Sheet(width=300, height=200)])
def test_a_groove_to_the_edge_of_the_sheet_runs_out_until_the_blade_can_turn(sheet: Sheet) -> None:
    # Half the blade 1.5, and beyond it its extent √(1.5² + 1²), the clearance 2 and 0.05 to spare.
    far = round(1.5 + math.hypot(1.5, 1.0) + 2.0 + 0.05, 3)
    assert run_outs(grooved(((0, 50), (300, 50))), sheet) == [[far, far]]
    assert run_outs(grooved(((0, 50), (300, 50))), None) == [[0.0, 0.0]]


def test_a_groove_to_an_edge_inside_the_sheet_runs_out_as_without_a_sheet() -> None:
    drawn = grooved(((0, 50), (300, 50)))
    placed = replace(drawn, ends=drawn.ends + 20.0)
    assert run_outs(placed, Sheet(width=340, height=240, margin=20.0)) == [[0.0, 0.0]]


def test_the_run_out_is_longer_at_a_slanted_edge_and_absent_along_it() -> None:
    outline = sheet_outline(Sheet(), grooved(), MACHINE)
    points = np.array([(300.0, 50.0), (300.0, 60.0), (300.0, 200.0)])
    angle = np.radians([30.0, 70.0, 0.0])
    ahead = np.column_stack([np.cos(angle), np.sin(angle)])
    found = sheet_run_outs(points, ahead, (1.5, 1.0), 2.0, outline)
    extent = math.hypot(1.5, 1.0) + 2.05
    # The last point is a corner of the sheet.
    assert found == pytest.approx([1.5 + extent / math.cos(math.radians(30.0)), 0.0, 0.0])


def test_a_run_out_into_a_notch_of_the_sheet_is_left_out() -> None:
    notched = closed((0, 0), (300, 0), (300, 90), (295, 90), (295, 100), (300, 100), (300, 200))
    drawn = dieline((LineType.CUT, np.concatenate([notched, closed((400, 0), (500, 0), (450, 9))])))
    outline = sheet_outline(Sheet(), drawn, MACHINE)
    points, ahead = np.array([(295.0, 95.0), (300.0, 50.0)]), np.array([(1.0, 0.0), (1.0, 0.0)])
    notch, edge = sheet_run_outs(points, ahead, (1.5, 1.0), 3.5, outline)
    assert (notch, edge > 0.0) == (0.0, True)


def test_the_ends_of_an_outline_are_equal_where_they_meet() -> None:
    # The ends at the middle of the sides differ by rounding, as those of copies of a blank do.
    sides = closed((0, 0), (150, 0), (300, 0), (300, 100), (300, 200), (0, 200), (0, 100))
    sides[:, 0, 1] += np.where(sides[:, 0, 1] == 100.0, 1.4e-14, 0.0)
    outline = sheet_outline(Sheet(), dieline((LineType.CUT, sides)), MACHINE)
    begins, ends = sorted(outline.start.tolist()), sorted(outline.end.tolist())
    assert len(begins) == 7
    assert begins == ends


def test_a_window_is_no_sheet_for_creases_around_it() -> None:
    # The outline has a gap of 0.2 mm at a corner, so only the window is closed.
    window = closed((50, 50), (150, 50), (150, 150), (50, 150))
    opened = BLANK.copy()
    opened[0, 0, 0] = 0.2
    fold = edges(((200, 0), (200, 200)))
    drawn = dieline((LineType.CUT, np.concatenate([window, opened])), (LineType.CREASE, fold))
    with pytest.raises(PlanError, match="no closed outline"):
        sheet_outline(Sheet(), drawn, MACHINE)


def test_cuts_outside_all_outlines_leave_the_sheet_unknown() -> None:
    apart = edges(((320, 20), (320, 180)))
    drawn = dieline((LineType.CUT, np.concatenate([BLANK, apart])))
    with pytest.raises(PlanError, match="no closed outline"):
        sheet_outline(Sheet(), drawn, MACHINE)
    # A cut that runs past the outline belongs to the blank.
    crossing = edges(((280, 100), (320, 100)))
    drawn = dieline((LineType.CUT, np.concatenate([BLANK, crossing])))
    assert len(sheet_outline(Sheet(), drawn, MACHINE).bulge) >= 4


def test_parts_in_a_window_are_no_edge_of_the_sheet() -> None:
    window = closed((50, 50), (150, 50), (150, 150), (50, 150))
    part = closed((60, 60), (90, 60), (90, 90), (60, 90))
    drawn = dieline((LineType.CUT, np.concatenate([BLANK, window, part])))
    assert len(sheet_outline(Sheet(), drawn, MACHINE).bulge) == 4


@pytest.mark.parametrize(
    ("sheet", "expected"),
    [
        (Sheet(width=299, height=200), "too small"),
        (Sheet(width=310, height=205, margin=10), "310.0 × 210.0 mm"),
        (Sheet(width=400, height=300, margin=10), "would lie from X -10.0, Y -10.0"),
        (Sheet(width=1601, height=300), "the table of Test table reaches from 0 to 1,600"),
    ],
)
def test_a_sheet_that_does_not_fit_is_refused(sheet: Sheet, expected: str) -> None:
    with pytest.raises(PlanError, match=expected):
        sheet_outline(sheet, grooved(), MACHINE)


def test_an_open_outline_is_no_sheet() -> None:
    with pytest.raises(PlanError, match="no closed outline"):
        sheet_outline(Sheet(), dieline((LineType.CUT, BLANK[:3])), MACHINE)


@pytest.mark.parametrize(
    ("margins", "corner"),
    [((3.0, None), (7.0, 7.0)), ((3.0, 30.0), (7.0, 0.0)), ((40.0, 5.0), (0.0, 5.0))],
)
def test_a_sheet_with_wide_margins_begins_at_the_edge_of_the_table(
    margins: tuple[float, float | None], corner: tuple[float, float]
) -> None:
    machine = replace(MACHINE, origin=(10.0, 10.0))
    sheet = Sheet(width=400.0, height=300.0, margin=margins[0], margin_below=margins[1])
    assert sheet.corner(machine.origin) == corner
    drawn = grooved()
    x, y = placement(drawn, machine, sheet)
    assert (x, y) == tuple(map(sum, zip(corner, sheet.margins, strict=True)))
    outline = sheet_outline(sheet, replace(drawn, ends=drawn.ends + np.array([x, y])), machine)
    assert tuple(outline.start.min(axis=0)) == corner
