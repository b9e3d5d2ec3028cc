"""Turns beside a sheet that was cut to size: accepted there, and refused over the sheet."""

from __future__ import annotations

import re

import numpy as np
import pytest

from knifetip.compensation.compensate import compensate
from knifetip.model.dieline import LineType
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Verdict
from knifetip.planning.plan import plan
from knifetip.planning.sheet_outline import sheet_outline
from knifetip.post.emit import process
from knifetip.sequencing.duration import duration
from knifetip.sequencing.sequence import sequence
from knifetip.verification.checks.motion.sheet import _footprints
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.sheet_area import place_sheet
from knifetip.verification.verify import verify
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

BLANK = closed((0, 0), (300, 0), (300, 200), (0, 200))
DRAWN = dieline(
    (LineType.CUT, BLANK),
    (LineType.V_GROOVE, edges(*(((0, y), (300, y)) for y in range(40, 200, 40)))),
)
SHEET = Sheet(width=300.0, height=200.0)


def emitted(sheet: Sheet | None) -> tuple[bytes, float]:
    """Return the program for the grooved blank, and its duration."""
    outline = None if sheet is None else sheet_outline(sheet, DRAWN, MACHINE)
    operations = plan(DRAWN, MACHINE, BOARD, sheet=outline)
    path = sequence(
        [compensate(operation) for operation in operations],
        MACHINE,
        None if outline is None else outline.edges,
    )
    return process(path, MACHINE, tolerance=0.01).text, duration(path, MACHINE)


def verdict_of(text: bytes, sheet: Sheet | None) -> Verdict:
    return verify(text, DRAWN, (0.0, 0.0), MACHINE, BOARD, sheet=sheet)


def test_turns_beside_the_sheet_have_no_lift_and_save_time() -> None:
    (low, quick), (high, slow) = emitted(SHEET), emitted(None)
    assert verdict_of(low, SHEET).accepted
    assert verdict_of(low, Sheet()).accepted
    assert verdict_of(high, None).accepted
    assert verdict_of(high, SHEET).accepted
    assert quick < slow
    assert low.count(b"Z4.0000") < high.count(b"Z4.0000")


@pytest.mark.parametrize(
    "sheet",
    [
        None,
        Sheet(width=310.0, height=200.0, margin=5.0),
        Sheet(width=301.0, height=200.0),
        Sheet(width=302.0, height=200.0),
    ],
)
def test_the_same_turns_are_refused_over_a_larger_sheet(sheet: Sheet | None) -> None:
    codes = {finding.message.code for finding in verdict_of(emitted(SHEET)[0], sheet).findings}
    assert ("verify.rapid-near-sheet" if sheet else "verify.rapid-in-board") in codes


def test_a_lift_left_out_over_the_sheet_is_refused() -> None:
    text = emitted(None)[0]
    lines = text.split(b"\n")
    lifts = [row for row, line in enumerate(lines) if re.match(rb"G1 .*Z4\.0000", line)]
    refused = 0
    for row in lifts:
        mutant = b"\n".join(lines[:row] + lines[row + 1 :])
        refused += not verdict_of(mutant, SHEET).accepted
    assert len(lifts) >= 8
    assert refused == len(lifts)


@pytest.mark.parametrize("shift", [-2.5, -3.5, -5.0, -20.0])
def test_a_low_turn_that_comes_nearer_than_the_clearance_is_refused(shift: float) -> None:
    # Each rapid below the top face is moved along X, towards the sheet on its right side.
    text = emitted(SHEET)[0]
    found = [
        match
        for match in re.finditer(rb"G0 X(-?[\d.]+) Y[-\d.]+ C[-\d.]+\n", text)
        if float(match[1]) > 300.0
    ]
    assert found
    for match in found:
        moved = b"%.4f" % (float(match[1]) + shift)
        mutant = text[: match.start(1)] + moved + text[match.end(1) :]
        assert "verify.rapid-near-sheet" in {
            finding.message.code for finding in verdict_of(mutant, SHEET).findings
        }


def test_a_low_turn_in_the_mat_is_refused() -> None:
    text = emitted(SHEET)[0].replace(b"Z1.0000", b"Z-0.1000")
    codes = {finding.message.code for finding in verdict_of(text, SHEET).findings}
    assert "verify.rapid-near-sheet" in codes


def test_a_footprint_turns_with_the_head() -> None:
    # Corners 2 mm ahead of the axis, 3 mm to its right, and 1 mm behind it.
    corners = np.array([(2.0, 0.0), (0.0, 3.0), (-1.0, 0.0)])
    poses = np.array([(10.0, 20.0, 0.0, 0.0), (10.0, 20.0, 0.0, 90.0), (10.0, 20.0, 0.0, -90.0)])
    assert _footprints(poses, corners) == pytest.approx(
        np.array(
            [
                [(12.0, 20.0), (10.0, 17.0), (9.0, 20.0)],
                [(10.0, 22.0), (13.0, 20.0), (10.0, 19.0)],
                [(10.0, 18.0), (7.0, 20.0), (10.0, 21.0)],
            ]
        )
    )


def test_the_area_of_a_round_sheet_is_bounded_by_its_arcs() -> None:
    drawn = dieline(
        (LineType.CUT, edges(((0, 0), (100, 0)), ((100, 0), (0, 0)))), bulge={0: 1.0, 1: 1.0}
    )
    area = place_sheet(Sheet(), place_edges(drawn, (0.0, 0.0)))
    points = np.array([(50.0, 49.0), (50.0, 51.0), (50.0, -60.0)])
    assert area.contains(points).tolist() == [True, False, False]
    assert area.distances(points[:, None]) == pytest.approx([1.0, 1.0, 10.0], abs=2e-3)


@pytest.mark.parametrize("kind", [LineType.CUT, LineType.CREASE])
@pytest.mark.parametrize(("x", "known"), [(320.0, False), (290.0, True)])
def test_an_edge_outside_all_outlines_leaves_the_sheet_unknown(
    kind: LineType, x: float, known: bool
) -> None:
    blank = closed((0, 0), (300, 0), (300, 200), (0, 200))
    drawn = dieline((LineType.CUT, blank), (kind, edges(((x, 20), (x, 180)))))
    area = place_sheet(Sheet(), place_edges(drawn, (0.0, 0.0)))
    assert len(area.start) == (4 if known else 0)


def test_a_cut_across_the_outline_belongs_to_the_sheet() -> None:
    blank = closed((0, 0), (300, 0), (300, 200), (0, 200))
    drawn = dieline((LineType.CUT, np.concatenate([blank, edges(((280, 100), (320, 100)))])))
    assert len(place_sheet(Sheet(), place_edges(drawn, (0.0, 0.0))).start) >= 4
