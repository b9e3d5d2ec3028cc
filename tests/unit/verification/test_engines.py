"""Rules for grooves, creases and bridges, each with a program worked out by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Finding, Severity, Verdict
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.expectation.outline import count_enclosing, find_outlines
from knifetip.verification.expectation.run_outs import run_outs
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    CREASE,
    CUT,
    MACHINE,
    cutter_program,
    dieline,
    knife_program,
    wheel_program,
)

GROOVE = LineType.V_GROOVE


def verdict_of(
    text: bytes, drawn: Dieline, board: Board = BOARD, machine: Machine = MACHINE
) -> Verdict:
    return verify(text, drawn, (0.0, 0.0), machine, board)


def kinds(verdict: Verdict) -> set[tuple[str, int]]:
    return {(finding.kind, finding.edge) for finding in verdict.findings}


# -- V-grooves: cutter d 6, r 1.5, 45°; 1.3 deep, so 2.6 wide at the top face, web 0.7


def groove_passes(x0: float, x1: float, y: float, *depths: float, aside: float = 0.0) -> list[str]:
    """Return the program lines of both passes of a groove along y from x0 to x1.

    ``aside`` displaces the first pass to the right (mm).
    """
    lines = []
    for depth in depths:
        rise = depth + 2.0
        low = 2.0 - depth
        # Eastward the head is 1.5 east and 6 south of the tip; lifted by Δz, Δz further south.
        lines += [
            f"G0 X{x0 + 1.5:.4f} Y{y - 6 - rise - aside:.4f} C0", "G0 Z4",
            f"G1 Y{y - 6 - aside:.4f} Z{low:.4f} F3000", f"G1 X{x1 + 1.5:.4f} F12000",
            f"G1 Y{y - 6 - rise - aside:.4f} Z4 F3000",
            f"G0 X{x1 - 1.5:.4f} Y{y + 6 + rise:.4f} C180",
            f"G1 Y{y + 6:.4f} Z{low:.4f} F3000", f"G1 X{x0 - 1.5:.4f} F12000",
            f"G1 Y{y + 6 + rise:.4f} Z4 F3000",
        ]  # fmt: skip
    return lines


INSIDE = dieline((GROOVE, 20, 30, 60, 30, 0.0))


def test_the_verdict_has_width_web_and_flanks_of_a_groove() -> None:
    verdict = verdict_of(cutter_program(*groove_passes(20, 60, 30, 1.3)), INSIDE)
    assert verdict.findings == ()
    np.testing.assert_allclose(
        [verdict.width[0], verdict.web[0], verdict.flank[0]], [2.6, 0.7, 0.0], atol=1e-9
    )


def test_a_flank_error_widens_the_groove_by_the_same_length() -> None:
    # 0.004 to the right: the flank is out by as much.
    verdict = verdict_of(cutter_program(*groove_passes(20, 60, 30, 1.3, aside=0.004)), INSIDE)
    assert verdict.findings == ()
    np.testing.assert_allclose([verdict.flank[0], verdict.width[0]], [0.004, 2.604], atol=1e-9)
    # 0.006 to the right is accepted alone, but not with 0.0049 too deep: together 0.0109.
    far = verdict_of(
        cutter_program(*groove_passes(20, 60, 30, 1.3049, aside=0.006)), INSIDE
    ).findings
    assert any(
        "meets the top face of the board 0.0109 mm too far from the centre line" in finding.text
        for finding in far
    )


def test_a_groove_that_cannot_fold_by_the_angle_of_the_board_is_a_shortfall() -> None:
    # The blade leans by 45°, so the flanks enclose 90°.
    text = cutter_program(*groove_passes(20, 60, 30, 1.3))
    assert verdict_of(text, INSIDE, replace(BOARD, fold_angle=90.0)).findings == ()
    verdict = verdict_of(text, INSIDE, replace(BOARD, fold_angle=120.0))
    assert not verdict.accepted
    (finding,) = verdict.findings
    assert (finding.kind, finding.edge, finding.severity) == ("fold", 0, Severity.SHORTFALL)
    assert finding.measure == pytest.approx(30.0)
    assert "fold by 90.0°, but the board must fold by 120.0°" in finding.text


def test_a_groove_may_be_cut_in_passes_that_go_deeper() -> None:
    assert (
        verdict_of(cutter_program(*groove_passes(20, 60, 30, 0.5, 1.0, 1.3)), INSIDE).findings == ()
    )
    back = verdict_of(cutter_program(*groove_passes(20, 60, 30, 1.0, 0.5, 1.3)), INSIDE)
    assert kinds(back) == {("depth", 0)}
    assert back.findings[0].measure == pytest.approx(0.5)
    shallow = verdict_of(cutter_program(*groove_passes(20, 60, 30, 0.5, 1.0)), INSIDE)
    # At 45° the edges of a groove that is 0.3 less deep are 0.3 further inside.
    assert kinds(shallow) == {("depth", 0), ("deviation", 0)}
    assert shallow.flank[0] == pytest.approx(0.3)
    assert shallow.web[0] == pytest.approx(1.0)


#: A blank of 100 × 60 whose left side leans by 45°, and a groove across it.
BLANK = dieline(
    (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 60, 0.0), (CUT, 100, 60, 60, 60, 0.0),
    (CUT, 60, 60, 0, 0, 0.0), (GROOVE, 30, 30, 100, 30, 0.0),
)  # fmt: skip


def groove_findings(x0: float, x1: float) -> list[Finding]:
    verdict = verdict_of(cutter_program(*groove_passes(x0, x1, 30, 1.3)), BLANK)
    return [finding for finding in verdict.findings if finding.edge == 4]


def test_a_groove_runs_out_until_its_whole_width_has_left_the_board() -> None:
    # No run-out is required at a right angle; at 45° it is (W/2) tan 45° = 1.3.
    assert groove_findings(28.7, 100.0) == []
    short = groove_findings(28.75, 100.0)
    assert {finding.kind for finding in short} == {"uncut"}
    assert short[0].measure == pytest.approx(0.05)
    assert ". The tool must also process the board before the start of the edge" in short[0].text
    assert {finding.kind for finding in groove_findings(28.7, 99.9)} == {"uncut"}
    # A longer run-out is refused, because a neighbouring blank may be there.
    assert {finding.kind for finding in groove_findings(28.6, 100.0)} == {"overcut"}
    assert {finding.kind for finding in groove_findings(28.7, 100.1)} == {"overcut"}


def test_which_ends_of_grooves_must_run_out() -> None:
    outline_ = dieline(
        (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 50, 100, 0, 0.0), (CUT, 100, 50, 50, 50, 0.0),
        (CUT, 50, 50, 50, 100, 0.0), (CUT, 50, 100, 0, 100, 0.0), (CUT, 0, 0, 0, 100, 0.0),
        (CUT, 20, 20, 30, 20, 1.0), (CUT, 30, 20, 20, 20, 1.0),
    )  # fmt: skip
    cuts = place_edges(outline_, (0.0, 0.0))
    bounds = find_outlines(cuts)
    assert bounds.outer.tolist() == [True] * 6 + [False] * 2
    assert bounds.depth.tolist() == [0] * 6 + [1, 1]
    points = np.array([[10.0, 10.0], [25.0, 20.0], [75.0, 75.0]])
    assert count_enclosing(points, bounds).tolist() == [1, 2, 0]
    grooves = place_edges(
        dieline(
            (GROOVE, 0, 0, 40, 40, 0.0),  # from an outer corner, symmetrically
            (GROOVE, 0, 50, 50, 50, 0.0),  # into the notch: half of it meets board
            (GROOVE, 0, 60, 50, 90, 0.0),  # at tan 30/50 to both sides
            (GROOVE, 25, 25, 25, 60, 0.0),  # from the hole, which is no edge of the board
        ),
        (0.0, 0.0),
    )
    asked = run_outs(grooves, cuts, 1.3)
    assert asked.boundary.tolist() == [True, False, True, False, True, True, False, False]
    np.testing.assert_allclose(asked.least, [0, 0, 0, 0, 0.78, 0.78, 0, 0], atol=1e-9)


@pytest.mark.parametrize("gap", [0.0, 0.02, 0.049])
def test_a_gap_before_the_edge_is_part_of_the_run_out(gap: float) -> None:
    # Square to the right side, and at 45° to the left side.
    drawn = place_edges(dieline((GROOVE, 30 + gap, 30, 100 - gap, 30, 0.0)), (0.0, 0.0))
    asked = run_outs(drawn, place_edges(BLANK, (0.0, 0.0)).with_types(CUT), 1.3)
    assert asked.boundary.tolist() == [True, True]
    np.testing.assert_allclose(asked.least, [1.3 + gap, gap], atol=1e-9)


def test_a_gap_wider_than_a_contact_is_not_bridged() -> None:
    drawn = place_edges(dieline((GROOVE, 40, 30, 100 - 0.06, 30, 0.0)), (0.0, 0.0))
    asked = run_outs(drawn, place_edges(BLANK, (0.0, 0.0)).with_types(CUT), 1.3)
    assert not asked.boundary.any()


def test_a_curved_groove_is_refused_unless_the_board_allows_chords() -> None:
    # A chord of 40 over an arc with a sagitta of 0.1: bulge 0.1 / 20.
    drawn = dieline((GROOVE, 20, 30, 60, 30, 0.1 / 20.0))
    text = cutter_program(*groove_passes(20, 60, 30, 1.3))
    assert ("deviation", 0) in kinds(verdict_of(text, drawn))
    assert verdict_of(text, drawn, replace(BOARD, groove_curve=0.11)).findings == ()
    assert not verdict_of(text, drawn, replace(BOARD, groove_curve=0.08)).accepted


# -- creases: R 15; across the grain 0.8 deep, so s = √(0.8 · 29.2) and 0.2 clear

BACK = math.sqrt(0.8 * 29.2) + 0.2


def rolled_creases(*ways: tuple[float, float, float]) -> bytes:
    lines = ["G0 C0"]
    for x0, x1, y in ways:
        lines += [f"G0 X{x0:.4f} Y{y:.4f}", "G0 Z4", "G1 Z1.2 F6000", f"G1 X{x1:.4f} F30000",
                  "G1 Z4 F6000"]  # fmt: skip
    return wheel_program(*lines)


def test_a_double_crease_needs_both_its_lines() -> None:
    drawn, board = dieline((CREASE, 0, 0, 60, 0, 0.0)), replace(BOARD, double_crease=2.0)
    both = verdict_of(rolled_creases((BACK, 60 - BACK, 1), (BACK, 60 - BACK, -1)), drawn, board)
    assert both.findings == ()
    assert both.setback[0] == pytest.approx(2 * BACK)
    one = verdict_of(rolled_creases((BACK, 60 - BACK, 1)), drawn, board)
    assert kinds(one) == {("uncut", 0)}
    assert {"uncut", "deviation"} == {
        f.kind for f in verdict_of(rolled_creases((BACK, 60 - BACK, 0)), drawn, board).findings
    }


DASHES = dieline(*((CREASE, 20 * k, 0, 20 * k + 12, 0, 0.0) for k in range(4)))


def test_dashes_may_be_rolled_as_one_crease() -> None:
    assert verdict_of(rolled_creases((BACK, 72 - BACK, 0)), DASHES).findings == ()
    # Each dash rolled alone has its own setback.
    alone = [(20 * k + BACK, 20 * k + 12 - BACK, 0.0) for k in range(4)]
    assert verdict_of(rolled_creases(*alone), DASHES).findings == ()
    # Two are no dashes.
    two = dieline((CREASE, 0, 0, 30, 0, 0.0), (CREASE, 38, 0, 68, 0, 0.0))
    assert not verdict_of(rolled_creases((BACK, 68 - BACK, 0)), two).accepted
    # A gap with a cut on it is a slot.
    slot = dieline(*((CREASE, 20 * k, 0, 20 * k + 12, 0, 0.0) for k in range(4)),
                   (CUT, 12, -5, 12, 5, 0.0))  # fmt: skip
    assert ("stray", -1) in kinds(verdict_of(rolled_creases((BACK, 72 - BACK, 0)), slot))
    # So is a gap into which the dashes on both sides reach, if cuts cross both near it.
    for into, stray in ((2, True), (5, False)):
        sides = [(CUT, x, -5, x, 5, 0.0) for x in (12 - into, 20 + into)]
        reached = dieline(*((CREASE, 20 * k, 0, 20 * k + 12, 0, 0.0) for k in range(4)), *sides)
        between = (12 - into + BACK, 20 + into - BACK, 0)
        found = kinds(verdict_of(rolled_creases(between), reached))
        assert (("stray", -1) in found) == stray
    # And gaps of 19 between pieces of 12 are more than one and a half.
    wide = dieline(*((CREASE, 31 * k, 0, 31 * k + 12, 0, 0.0) for k in range(4)))
    assert not verdict_of(rolled_creases((BACK, 105 - BACK, 0)), wide).accepted


def test_a_crease_between_short_ones_may_be_rolled_alone() -> None:
    # Their gaps are alike for one measure of regular gaps, and not for another one.
    drawn = dieline((CREASE, -0.34, 0, -0.24, 0, 0.0), (CREASE, 0, 0, 87, 0, 0.0),
                    (CREASE, 87.32, 0, 87.39, 0, 0.0))  # fmt: skip
    alone = verdict_of(rolled_creases((BACK, 87 - BACK, 0)), drawn)
    assert {finding.edge for finding in alone.findings if finding.refuses} == {0, 2}
    together = verdict_of(rolled_creases((BACK - 0.34, 87.39 - BACK, 0)), drawn)
    assert together.findings == ()


def test_a_crease_drawn_twice_in_part_is_rolled_once() -> None:
    drawn = dieline((CREASE, 0, 0, 60, 0, 0.0), (CREASE, 100, 0, 57, 0, 0.0),
                    (CREASE, 0, 20, 50, 20, 0.0), (CREASE, 50, 20, 0, 20, 0.0))  # fmt: skip
    verdict = verdict_of(rolled_creases((BACK, 100 - BACK, 0), (BACK, 50 - BACK, 20)), drawn)
    assert verdict.findings == ()
    np.testing.assert_allclose(verdict.setback, [BACK, BACK, 2 * BACK, 2 * BACK])


def test_a_crease_that_a_cut_crosses_has_clearance_on_both_sides() -> None:
    drawn = dieline((CREASE, 0, 0, 60, 0, 0.0), (CUT, 30, -20, 30, 20, 0.0))
    kept = verdict_of(rolled_creases((BACK, 30 - BACK, 0), (30 + BACK, 60 - BACK, 0)), drawn)
    assert {finding.edge for finding in kept.findings if finding.refuses} == {1}
    assert kept.setback[0] == pytest.approx(4 * BACK)
    through = verdict_of(rolled_creases((BACK, 60 - BACK, 0)), drawn)
    assert ("overcut", 0) in kinds(through)


def test_each_crease_is_checked_for_the_wheel_that_rolls_it() -> None:
    # A second wheel of R 10 in station 4: s = √(0.8 · 19.2) = 3.9192.
    small = Station(4, "Small", CreaseWheel(10.0, 0.7, 30000.0, 6000.0), 0, 0, 0, 0, 3)
    machine = replace(MACHINE, stations=(*MACHINE.stations, small))
    drawn = dieline((CREASE, 0, 0, 60, 0, 0.0), (CREASE, 0, 20, 60, 20, 0.0))
    back = math.sqrt(0.8 * 19.2) + 0.2

    def program(other: float) -> bytes:
        first = rolled_creases((BACK, 60 - BACK, 0)).replace(b"M65 P2\n", b"M65 P2\nM65 P3\n")
        change = f"""G0 Z20
M65 P1
T4 M6 G43
M64 P3
G4 P0.15
G0 X{other:.4f} Y20 C0
G0 Z4
G1 Z1.2 F6000
G1 X{60 - other:.4f} F30000
G1 Z4 F6000
G0 Z20.0000
M65 P3"""
        return first.replace(b"G0 Z20.0000\nM65 P1", change.encode())

    assert verdict_of(program(back), drawn, machine=machine).findings == ()
    assert kinds(verdict_of(program(BACK), drawn, machine=machine)) == {("uncut", 1)}


# -- bridges: the lead over 2.3 mm is 0.4056

SQUARE = dieline(
    (CUT, 0, 0, 60, 0, 0.0), (CUT, 60, 0, 60, 40, 0.0), (CUT, 60, 40, 0, 40, 0.0),
    (CUT, 0, 40, 0, 0, 0.0),
)  # fmt: skip
LEAD = 2.3 * math.tan(math.radians(10.0))
NICKED = replace(BOARD, bridge_width=0.5, bridge_spacing=110.0)


def square_with_bridges(first: float = 30.0, second: float = 30.0, stop: float = 0.25) -> bytes:
    """Return a square with bridges about ``first`` below and ``second`` above."""
    down, up = "G1 Z-0.3 F6000", "G1 Z4 F6000"
    return knife_program(
        f"G0 X{first + 0.25:.4f} Y0 Z20 C0", "G0 Z4", down, "G1 X60 F24000", up,
        "G0 C90", down, "G1 Y40 F24000", up,
        "G0 C180", down, f"G1 X{second + 0.25 + LEAD:.4f} F24000", up,
        f"G0 X{second - 0.25:.4f}", down, "G1 X0 F24000", up,
        "G0 C270", down, "G1 Y0 F24000", up,
        "G0 C360", down, f"G1 X{first - stop - LEAD:.4f} F24000", up,
    )  # fmt: skip


def test_bridges_of_the_board_s_width_in_the_top_face_are_accepted() -> None:
    verdict = verdict_of(square_with_bridges(), SQUARE, NICKED)
    assert verdict.findings == ()
    np.testing.assert_allclose(verdict.setback, [0.5 + LEAD, 0, 0.5 + LEAD, 0], atol=1e-3)
    # Without bridges in the board's settings none is allowed.
    assert not verdict_of(square_with_bridges(), SQUARE).accepted


@pytest.mark.parametrize(("stop", "kind"), [(0.2, "overcut"), (0.3, "uncut")])
def test_a_bridge_too_narrow_or_too_wide_is_refused(stop: float, kind: str) -> None:
    verdict = verdict_of(square_with_bridges(stop=stop), SQUARE, NICKED)
    assert kinds(verdict) == {(kind, 0)}
    assert verdict.findings[0].measure == pytest.approx(0.05, abs=1e-3)


def test_bridges_too_far_apart_too_near_a_corner_or_too_few_are_refused() -> None:
    # Half way round is 100: moved by 12 mm each the longer way is 124.
    far = verdict_of(square_with_bridges(18.0, 42.0 + 0.0), SQUARE, NICKED).findings
    assert far == ()
    wide = verdict_of(square_with_bridges(18.0, 18.0), SQUARE, NICKED)
    assert any("124.000 mm away from the next" in finding.text for finding in wide.findings)
    corner = verdict_of(square_with_bridges(4.0, 56.0), SQUARE, NICKED)
    assert kinds(corner) == {("deviation", 0), ("deviation", 2)}
    assert corner.findings[0].measure == pytest.approx(5.25 - 4.0, abs=1e-3)
    none = knife_program(
        "G0 X30 Y0 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", "G1 X60 F24000", "G1 Z4 F6000",
        "G0 C90", "G1 Z-0.3", "G1 Y40 F24000", "G1 Z4 F6000", "G0 C180", "G1 Z-0.3",
        "G1 X0 F24000", "G1 Z4 F6000", "G0 C270", "G1 Z-0.3", "G1 Y0 F24000", "G1 Z4 F6000",
        "G0 C360", "G1 Z-0.3", "G1 X30.3527 F24000", "G1 Z4 F6000",
    )  # fmt: skip
    assert verdict_of(none, SQUARE).findings == ()
    assert "0 bridges hold the part" in verdict_of(none, SQUARE, NICKED).findings[0].text


# -- cuts drawn over each other


@pytest.mark.parametrize("again", [(0, 0, 50, 0), (50, 0, 0, 0), (20, 0, 50, 0), (50, 0, 10, 0)])
def test_a_slit_drawn_twice_is_cut_once(again: tuple[int, int, int, int]) -> None:
    drawn = dieline((CUT, 0, 0, 50, 0, 0.0), (CUT, *again, 0.0))
    text = knife_program(
        "G0 X0 Y0 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", f"G1 X{50 - LEAD:.4f} F24000", "G1 Z4 F6000"
    )
    verdict = verdict_of(text, drawn)
    assert verdict.findings == ()
    np.testing.assert_allclose(verdict.setback, LEAD, atol=1e-4)


# -- the map


def test_the_samples_have_edge_position_and_deviation() -> None:
    # From 0.006 to the left to 0.002 to the right of an edge that is drawn westward.
    drawn = dieline((CUT, 50, 0, 0, 0, 0.0))
    text = knife_program(
        "G0 X0 Y0.006 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", f"G1 X{50 - LEAD:.4f} Y-0.002 F24000",
        "G1 Z4 F6000",
    )  # fmt: skip
    samples = verdict_of(text.replace(b"P0.0050 Q0.0050", b"P0.0010 Q0.0010"), drawn).samples
    assert samples.edge.tolist() == [0, 0, 0]
    low = LEAD / 50
    np.testing.assert_allclose(samples.place, [low, (1.0 + low) / 2.0, 1.0], atol=1e-5)
    np.testing.assert_allclose(samples.deviation, [0.002, -0.002, -0.006], atol=1e-6)


def test_both_faces_of_the_board_have_figures() -> None:
    # A slit that ends inside: the bottom face lacks 2 tan 10°, the top none.
    drawn = dieline((CUT, 0, 0, 50, 0, 0.0), (CUT, 0, 30, 50, 30, 0.0), (CUT, 50, 30, 50, 20, 0.0))
    text = knife_program(
        "G0 X0 Y0 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", f"G1 X{50 - LEAD:.4f} F24000", "G1 Z4 F6000",
        "G0 Y30 X0", "G1 Z-0.3", "G1 X50 F24000", "G1 Z4 F6000",
        "G0 C-90", "G1 Z-0.3", f"G1 Y{20 + LEAD:.4f} F24000", "G1 Z4 F6000",
    )  # fmt: skip
    verdict = verdict_of(text, drawn)
    assert verdict.findings == ()
    slant = math.tan(math.radians(10.0))
    np.testing.assert_allclose(verdict.bottom_uncut, [2 * slant, 0, 2 * slant], atol=1e-4)
    # Where the blade is lifted and turned at a corner, the top face is cut 2.3 tan 10° past it.
    np.testing.assert_allclose(verdict.top_overcut, [0, LEAD, 0], atol=1e-4)
