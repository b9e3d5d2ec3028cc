import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from knifetip.model.dieline import Dieline, LineType
from knifetip.model.verdict import Finding, Severity, Verdict
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    CREASE,
    CUT,
    DIELINE,
    FOLD,
    GROOVE,
    HALF,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    RUN_OUT,
    SLIT,
    changed,
    cutter_program,
    dieline,
    knife_program,
    wheel_program,
)


def verdict_of(text: bytes) -> Verdict:
    return verify(text, DIELINE, PLACEMENT, MACHINE, BOARD)


def findings_of(old: str, new: str) -> list[Finding]:
    """Return the findings about the hand-written program with one line changed."""
    return list(verdict_of(changed(LINUXCNC, old, new)).findings)


def find_finding(kind: str, edge: int, findings: list[Finding]) -> Finding:
    chosen = [finding for finding in findings if (finding.kind, finding.edge) == (kind, edge)]
    assert len(chosen) >= 1, findings
    return chosen[0]


def test_a_crease_that_stops_early_is_uncut_by_the_missing_length() -> None:
    finding = find_finding("uncut", FOLD, findings_of("G1 Y65.6000 F30000", "G1 Y64.7600 F30000"))
    assert finding.measure == pytest.approx(0.84)
    assert finding.text == (
        "Edge 10, program line 18: 0.840 mm along the edge are left without a crease. "
        "The missing part begins 34.760 mm from the start of the edge."
    )


def test_a_crease_that_is_too_long_has_an_overcut() -> None:
    verdict = verdict_of(changed(LINUXCNC, "G1 Y65.6000 F30000", "G1 Y65.7000 F30000"))
    finding = find_finding("overcut", FOLD, list(verdict.findings))
    assert finding.measure == pytest.approx(0.1)
    # It still ends 0.1 before the edge does.
    assert verdict.overcut[FOLD] == 0.0
    past = verdict_of(changed(LINUXCNC, "G1 Y65.6000 F30000", "G1 Y66.0000 F30000"))
    assert past.overcut[FOLD] == pytest.approx(0.2)


@pytest.mark.parametrize("z", ["1.3998", "1.4002"])
def test_a_wheel_two_units_of_the_last_digit_too_deep_or_too_shallow_is_found(z: str) -> None:
    finding = find_finding("depth", FOLD, findings_of("G1 Z1.4000 F6000", f"G1 Z{z} F6000"))
    assert finding.measure == pytest.approx(2e-4)


def test_a_cut_beside_its_edge_is_a_deviation() -> None:
    text = LINUXCNC.decode().replace("Y35.0000", "Y35.0300").encode()
    finding = find_finding("deviation", SLIT, list(verdict_of(text).findings))
    assert finding.measure == pytest.approx(0.03)
    assert (
        "The path of the knife is 0.030 mm away from the edge that it should follow" in finding.text
    )


def test_the_rounding_of_the_controller_is_added_to_the_distance() -> None:
    text = LINUXCNC.decode().replace("Y35.0000", "Y35.0040").encode()
    assert verdict_of(text).accepted
    assert verdict_of(text).deviation[SLIT] == pytest.approx(0.009)
    text = LINUXCNC.decode().replace("Y35.0000", "Y35.0060").encode()
    finding = find_finding("deviation", SLIT, list(verdict_of(text).findings))
    assert finding.measure == pytest.approx(0.011)
    wide = changed(LINUXCNC, "G64 P0.0050 Q0.0050", "G64 P0.0110 Q0.0050")
    assert {finding.kind for finding in verdict_of(wide).findings} == {"deviation"}


def test_work_far_from_every_edge_is_a_stray() -> None:
    text = LINUXCNC.decode().replace("Y35.0000", "Y38.0000").encode()
    findings = list(verdict_of(text).findings)
    assert any(
        finding.kind == "stray" and "X40.000 Y38.000 (coordinates of the sheet)" in finding.text
        for finding in findings
    )
    assert find_finding("uncut", SLIT, findings).measure == pytest.approx(20.0)


def test_a_knife_on_a_crease_is_a_stray_with_the_edge() -> None:
    text = knife_program(
        "G0 X90 Y34.4 Z20 C90", "G0 Z4", "G1 Z-0.3 F6000", "G1 Y60 F24000", "G1 Z4 F6000"
    )
    strays = [finding for finding in verdict_of(text).findings if finding.kind == "stray"]
    assert "along edge 10, whose line type (crease)" in strays[0].text


def test_work_on_an_ignored_edge_is_a_stray() -> None:
    text = knife_program(
        "G0 X20 Y90 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", "G1 X60 F24000", "G1 Z4 F6000"
    )
    strays = [finding for finding in verdict_of(text).findings if finding.kind == "stray"]
    assert "along edge 13, whose line type (ignored)" in strays[0].text


def test_a_slit_must_stop_where_the_cut_in_the_top_face_ends() -> None:
    far = find_finding("overcut", SLIT, findings_of("G1 X59.5944 F24000", "G1 X60.0000 F24000"))
    assert far.measure == pytest.approx(0.4056, abs=1e-4)
    assert "0.406 mm beyond the end of the edge" in far.text
    short = find_finding("uncut", SLIT, findings_of("G1 X59.5944 F24000", "G1 X59.5000 F24000"))
    assert short.measure == pytest.approx(0.0944, abs=1e-4)


def test_a_cut_that_meets_another_must_run_over_by_its_slant() -> None:
    assert verdict_of(LINUXCNC).overcut[RUN_OUT] == pytest.approx(
        2.0 * math.tan(math.radians(10.0))
    )
    for y, kind, measure in (("80.4527", "overcut", 0.1), ("80.2527", "uncut", 0.1)):
        finding = find_finding(kind, RUN_OUT, findings_of("G1 Y80.3527 F24000", f"G1 Y{y} F24000"))
        assert finding.measure == pytest.approx(measure, abs=1e-4)


def test_a_closed_contour_must_run_over_its_start() -> None:
    for x, side, measure in (("70.4527", "beyond", 0.1), ("70.2527", "before", 0.1)):
        findings = findings_of("G1 X70.3527\n", f"G1 X{x}\n")
        assert [finding.kind for finding in findings] == [
            "overcut" if side == "beyond" else "uncut"
        ]
        assert f"0.100 mm {side} the end of the edge" in findings[0].text
        assert findings[0].measure == pytest.approx(measure, abs=1e-4)


def test_a_contour_may_start_anywhere_on_itself() -> None:
    text = LINUXCNC.decode().replace("G0 X70.0000 Y20.0000 C0", "G0 X33.3000 Y20.0000 C0")
    text = text.replace("G1 X70.0000\nG1 X70.3527", "G1 X33.6527")
    assert verdict_of(text.encode()).accepted


def test_a_contour_may_be_cut_in_reverse_with_turns_above_the_board() -> None:
    drawn = dieline(
        (CUT, 0, 0, 40, 0, 0.0), (CUT, 40, 0, 40, 40, 0.0), (CUT, 40, 40, 0, 40, 0.0),
        (CUT, 0, 40, 0, 0, 0.0),
    )  # fmt: skip
    air = ("G1 Z4 F6000",)
    down = ("G1 Z-0.3",)
    text = knife_program(
        "G0 X20 Y0 Z20 C180", "G0 Z4", "G1 Z-0.3 F6000", "G1 X0 F24000",
        *air, "G0 C90", *down, "G1 Y40 F24000",
        *air, "G0 C0", *down, "G1 X40 F24000",
        *air, "G0 C-90", *down, "G1 Y0 F24000",
        *air, "G0 C-180", *down, "G1 X20 F24000", "G1 X19.6473", *air,
    )  # fmt: skip
    verdict = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD)
    assert verdict.findings == ()
    # Without the overrun the bottom face of the board would remain connected.
    short = verify(changed(text, "G1 X19.6473\n", ""), drawn, (0.0, 0.0), MACHINE, BOARD)
    assert [finding.kind for finding in short.findings] == ["uncut"]


def cut_lines(*lines: tuple[float, float, float, float, float]) -> bytes:
    """Return a program that cuts lines x1, y1, x2, y2 one after the other, each at the last number
    as C, with a lift before each of them.
    """
    moves: list[str] = []
    for x, y, to_x, to_y, c in lines:
        moves += [f"G0 X{x} Y{y} Z4 C{c}", "G1 Z-0.3 F6000", f"G1 X{to_x} Y{to_y} F24000"]
        moves += ["G1 Z4 F6000"]
    return knife_program(*moves)


SQUARE = (
    (CUT, 0, 0, 40, 0, 0.0), (CUT, 40, 0, 40, 40, 0.0), (CUT, 40, 40, 0, 40, 0.0),
    (CUT, 0, 40, 0, 0, 0.0),
)  # fmt: skip
AROUND_SQUARE = (
    (CUT, -8, -8, 48, -8, 0.0), (CUT, 48, -8, 48, 48, 0.0), (CUT, 48, 48, -8, 48, 0.0),
    (CUT, -8, 48, -8, -8, 0.0),
)  # fmt: skip


def test_a_contour_that_starts_at_a_corner_with_a_lift_needs_no_overrun() -> None:
    drawn = dieline(*SQUARE)
    sides = ((0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180))
    whole = verify(cut_lines(*sides, (0, 40, 0, 0, 270)), drawn, (0.0, 0.0), MACHINE, BOARD)
    assert whole.findings == ()
    short = verify(cut_lines(*sides, (0, 40, 0, 0.1, 270)), drawn, (0.0, 0.0), MACHINE, BOARD)
    assert {finding.kind for finding in short.findings} == {"uncut"}
    assert short.findings[0].measure == pytest.approx(0.1)
    # An open cut that ended here would run on by 0.3527 mm.
    past = verify(cut_lines(*sides, (0, 40, 0, -0.3527, 270)), drawn, (0.0, 0.0), MACHINE, BOARD)
    assert {finding.kind for finding in past.findings} == {"overcut"}


def test_a_contour_that_starts_at_a_gentle_corner_needs_its_overrun() -> None:
    # A corner of 10°, at which the knife is not lifted.
    drawn = dieline((CUT, 0, 0, 40, 7.0531, 0.0), (CUT, 40, 7.0531, 40, 40, 0.0),
                    (CUT, 40, 40, -40, 40, 0.0), (CUT, -40, 40, -40, 0, 0.0),
                    (CUT, -40, 0, 0, 0, 0.0))  # fmt: skip
    sides = ((0, 0, 40, 7.0531, 10), (40, 7.0531, 40, 40, 90), (40, 40, -40, 40, 180),
             (-40, 40, -40, 0, 270), (-40, 0, 0, 0, 360))  # fmt: skip
    verdict = verify(cut_lines(*sides), drawn, (0.0, 0.0), MACHINE, BOARD)
    assert [finding.measure for finding in verdict.findings] == [pytest.approx(0.3527, abs=1e-4)]


@pytest.mark.parametrize(
    ("slit", "tip"),
    [
        # From the panel: beyond the corner lies waste, so the tip runs on.
        ((20, 20, 40, 40), (20, 20, 40.24939, 40.24939, 45)),
        # From the waste: beyond the corner lies the panel, so the tip stops on the corner, where
        # the contour begins.
        ((60, 60, 40, 40), (60, 60, 40, 40, 225)),
    ],
)
def test_a_contour_stops_on_its_corner_even_if_a_slit_ends_there(
    slit: tuple[float, float, float, float], tip: tuple[float, float, float, float, float]
) -> None:
    drawn = dieline(*SQUARE, (CUT, *slit, 0.0))
    sides = ((40, 40, 0, 40, 180), (0, 40, 0, 0, 270), (0, 0, 40, 0, 0))

    def kinds(end: float) -> set[str]:
        text = cut_lines(tip, *sides, (40, 0, 40, end, 90))
        return {f.kind for f in verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings}

    assert kinds(40) == set()
    assert kinds(39.9) == {"uncut"}
    assert kinds(40.1) & {"overcut", "uncut"}


@pytest.mark.parametrize("around", [(), AROUND_SQUARE])
def test_a_knife_that_returns_along_a_side_does_not_close_a_contour(
    around: tuple[tuple[LineType, float, float, float, float, float], ...],
) -> None:
    # After the closed square, the last side is cut again, back to the corner at which it began.
    # An open cut would stop on this corner if a panel lies beyond it; the path must not.
    sides = ((0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270))
    outer = [(*ends[1:5], 90 * k) for k, ends in enumerate(around)]
    drawn = dieline(*SQUARE, *around)
    once, again = cut_lines(*sides, *outer), cut_lines(*sides, (0, 0, 0, 40, 90), *outer)
    assert verify(once, drawn, (0.0, 0.0), MACHINE, BOARD).findings == ()
    findings = verify(again, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    assert {finding.kind for finding in findings} & {"overcut", "uncut"}


def test_an_edge_must_not_be_cut_in_both_directions() -> None:
    # The first side is cut backwards before the contour of a hole in a panel: at the corner where
    # the contour begins and ends, the blade cuts the panel's top face in a second direction.
    sides = ((0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270))
    outer = [(*ends[1:5], 90 * k) for k, ends in enumerate(AROUND_SQUARE)]
    drawn = dieline(*SQUARE, *AROUND_SQUARE)
    text = cut_lines((40, 0, 0, 0, 180), *sides, *outer)
    findings = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    assert [(found.message.code, found.edge) for found in findings] == [("verify.cut-both-ways", 0)]
    assert findings[0].measure == pytest.approx(40.0, abs=1e-3)


def test_a_contour_may_start_where_a_slit_from_the_waste_ends_on_its_side() -> None:
    # The slit ends on the right side, behind which lies the panel, so the tip stops there.
    drawn = dieline(*SQUARE, (CUT, 60, 20, 40, 20, 0.0))
    sides = ((40, 20, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270), (0, 0, 40, 0, 360))

    def kinds(slit: float, end: float) -> set[str]:
        text = cut_lines((60, 20, slit, 20, 180), *sides, (40, 0, 40, end, 450))
        return {f.kind for f in verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings}

    assert kinds(40, 20.3527) == set()
    assert kinds(40, 20.2527) == {"uncut"}
    assert kinds(40.1, 20.3527) == {"uncut"}


def test_a_cut_stops_at_its_own_end_even_if_another_cut_ends_near_it() -> None:
    # The planned stop of the second slit lies on the first one, 0.3944 mm before the stop of that.
    drawn = dieline((CUT, 20, 15, 40, 15, 0.0), (CUT, 39.2, 5, 39.2, 15, 0.0))

    def codes(end: float) -> set[str]:
        text = cut_lines((20, 15, end, 15, 0), (39.2, 5, 39.2, 15, 90))
        found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
        return {finding.message.code for finding in found}

    assert codes(39.5944) == set()
    assert "verify.comes-out-short" in codes(39.2)


def test_the_knife_may_turn_at_a_corner_just_before_the_end_of_a_cut() -> None:
    # The last edge of the cut from the left side to the slit is 0.042 mm long.
    drawn = dieline(
        *SQUARE, (CUT, 30, 10, 30, 40, 0.0), (CUT, 0, 20, 29.97, 20, 0.0),
        (CUT, 29.97, 20, 30, 20.03, 0.0),
    )  # fmt: skip
    sides = ((0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270))
    slit = (30, 40, 30, 10.4056, 270)

    def codes(*last: tuple[float, float, float, float, float]) -> set[str]:
        text = cut_lines(slit, (0, 20, 29.97, 20, 0), *last, *sides)
        found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
        return {finding.message.code for finding in found}

    there, back = (29.97, 20, 30, 20.03, 45), (30, 20.03, 29.97, 20, 225)
    assert codes(there) == set()
    # An end at which an edge continues is not the end of the cut.
    assert "verify.comes-out-short" in codes(there, back)
    assert "verify.comes-out-short" in codes(back)


def test_a_cut_must_begin_at_an_end_even_if_its_edge_is_cut_already() -> None:
    drawn = dieline((CUT, 20, 15, 40, 15, 0.0))
    text = cut_lines((20, 15, 39.5944, 15, 0), (30, 15, 39.5944, 15, 0))
    found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    assert "verify.goes-in-anywhere" in {finding.message.code for finding in found}


def findings_by_severity(text: bytes, drawn: Dieline) -> set[tuple[int, Severity, str]]:
    """Return the edge, the severity and the message code of each finding about a program."""
    found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    return {(finding.edge, finding.severity, finding.message.code) for finding in found}


def test_only_a_cut_with_both_ends_inside_a_panel_may_be_too_short_for_the_knife() -> None:
    # The blade cuts the top face 0.4056 mm ahead of its tip.
    contour = cut_lines(
        (0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270)
    )

    def found(*edges: tuple[LineType, float, float, float, float, float]) -> set[str]:
        said = findings_by_severity(contour, dieline(*SQUARE, *edges))
        assert all(edge >= 4 for edge, _, _ in said)
        return {severity.value for _, severity, _ in said}

    inside = (CUT, 20, 20, 20.3, 20, 0.0)
    assert found(inside) == {"shortfall"}
    assert found((CUT, 39.7, 20, 40, 20, 0.0)) == {"fault"}  # ends on the contour
    round_hole = ((CUT, 9.95, 10, 10.05, 10, 1.0), (CUT, 10.05, 10, 9.95, 10, 1.0))
    assert found(*round_hole) == {"fault"}
    assert found(*round_hole, inside) == {"fault", "shortfall"}


def test_a_short_cut_that_is_begun_is_no_shortfall() -> None:
    drawn = dieline((CUT, 20, 20, 20.3, 20, 0.0))
    found = findings_by_severity(cut_lines((20, 20, 20.1, 20, 0)), drawn)
    assert {severity for _, severity, _ in found} == {Severity.FAULT}


def test_a_short_groove_that_another_one_continues_must_be_made() -> None:
    kind = LineType.V_GROOVE
    drawn = dieline((kind, 20, 30, 59.2, 30, 0.0), (kind, 59.2, 30, 60, 30, 0.0))
    text = cutter_program("G0 X0 Y0 Z20 C0")
    assert {edge for edge, severity, _ in findings_by_severity(text, drawn)
            if severity is Severity.FAULT} == {0, 1}  # fmt: skip


def test_a_short_groove_that_is_begun_is_no_shortfall() -> None:
    # The blade is 3 mm wide.  Only the pass to the right is made.
    drawn = dieline((LineType.V_GROOVE, 20, 30, 22, 30, 0.0))
    right = ("G0 X21.5 Y20.7 Z4 C0", "G1 Y24 Z0.7 F3000", "G1 X23.5 F12000", "G1 Y20.7 Z4 F3000")
    found = findings_by_severity(cutter_program(*right), drawn)
    assert {severity for _, severity, _ in found} == {Severity.FAULT}


def test_a_groove_needs_both_its_passes() -> None:
    back = (
        "G0 X78.5000 Y59.3000 C180.0000\n"
        "G1 Y56.0000 Z0.7000\n"
        "G1 X38.5000 F12000\n"
        "G1 Y59.3000 Z4.0000 F3000\n"
    )
    findings = findings_of(back, "")
    finding = find_finding("uncut", GROOVE, findings)
    assert finding.measure == pytest.approx(40.0)
    assert "without a groove in the direction from the end to the start of the edge" in finding.text


def test_the_blade_runs_past_both_ends_of_a_groove_by_its_width() -> None:
    assert verdict_of(LINUXCNC).overcut[GROOVE] == 3.0
    strict = replace(BOARD, groove_overcut=2.5)
    findings = verify(LINUXCNC, DIELINE, PLACEMENT, MACHINE, strict).findings
    assert [(finding.kind, finding.edge) for finding in findings] == [("overcut", GROOVE)]
    assert findings[0].measure == 3.0


def test_a_groove_whose_tip_is_mirrored_is_refused() -> None:
    # 6 to the left of travel instead of the right: the tip runs 12 mm beside the line.
    text = LINUXCNC.decode()
    for old, new in (("Y40.7", "Y59.3"), ("Y44.0", "Y56.0")):
        text = text.replace(old, new)
    kinds = {finding.kind for finding in verdict_of(text.encode()).findings}
    assert {"stray", "uncut", "deviation"} <= kinds


def test_a_half_cut_at_the_depth_of_a_cut_is_a_stray() -> None:
    findings = findings_of("G1 Z1.0000 F6000", "G1 Z-0.3000 F6000")
    assert any("line type (half-cut)" in finding.text for finding in findings)
    assert find_finding("uncut", HALF, findings).measure == pytest.approx(40.0)


@pytest.mark.parametrize(
    ("degrees", "fine"),
    # 2.5 mm of blade swing 0.01 mm at 2 arcsin(0.01 / 5) = 0.22918°.
    [(0.229, True), (0.23, False), (-0.229, True), (-0.23, False), (179.0, False)],
)
def test_a_knife_may_be_turned_until_it_swings_by_a_hundredth(degrees: float, fine: bool) -> None:
    text = LINUXCNC.decode().replace("Y70.0000 C90.0000\n", f"Y70.0000 C{90 + degrees:.4f}\n", 1)
    findings = list(verdict_of(text.encode()).findings)
    if fine:
        assert findings == []
    else:
        assert find_finding("heading", RUN_OUT, findings).measure == pytest.approx(
            abs(degrees), abs=1e-3
        )


def test_a_wheel_may_be_turned_by_half_a_turn() -> None:
    assert findings_of("Y34.4000 Z20.0000 C90.0000", "Y34.4000 Z20.0000 C-90.0000") == []
    # Its contact of 4.2 mm swings 0.01 mm at 0.1364°.
    findings = findings_of("Y34.4000 Z20.0000 C90.0000", "Y34.4000 Z20.0000 C-89.8600")
    assert find_finding("heading", FOLD, findings).measure == pytest.approx(0.14)


def test_a_short_crease_is_pressed_at_the_depth_that_fits() -> None:
    drawn = dieline((CREASE, 50, 10, 50, 16.4, 0.0))
    depth = 15.0 - math.sqrt(216.0)

    def pressed(depth: float, y: float = 33.2, c: float = 90.0) -> Verdict:
        text = wheel_program(
            f"G0 X70 Y{y} Z20 C{c}", "G0 Z4", f"G1 Z{2.0 - depth:.4f} F6000", "G1 Z4"
        )
        return verify(text, drawn, PLACEMENT, MACHINE, BOARD)

    assert pressed(depth).findings == ()
    assert pressed(depth).setback[0] == pytest.approx(6.4)
    assert [finding.kind for finding in pressed(depth + 0.006).findings] == ["depth"]
    assert [finding.kind for finding in pressed(depth, c=91.0).findings] == ["heading"]
    assert {finding.kind for finding in pressed(depth, y=33.4).findings} == {"overcut", "uncut"}


def test_collinear_creases_may_be_rolled_together_or_at_their_own_depths() -> None:
    drawn = dieline((CREASE, 0, 0, 30, 0, 0.0), (CREASE, 60, 0, 30, 0, 0.0))
    back = math.sqrt(0.8 * 29.2) + 0.2
    text = wheel_program(
        f"G0 X{back:.4f} Y0 Z20 C0", "G0 Z4", "G1 Z1.2 F6000",
        f"G1 X{60 - back:.4f} F30000", "G1 Z4 F6000",
    )  # fmt: skip
    verdict = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD)
    assert verdict.findings == ()
    np.testing.assert_allclose(verdict.setback, [back, back], atol=1e-9)


def test_a_perforation_too_short_for_a_gap_is_one_cut_even_if_others_cross_it() -> None:
    lead = 0.4056  # 2.3 tan 10°
    kind = LineType.PERFORATION
    drawn = dieline(
        (kind, 0, 10, 8.5, 10, 0.0), (kind, 2, 6, 2, 14.5, 0.0), (kind, 5, 6, 5, 14.5, 0.0),
    )  # fmt: skip

    def texts(end: float) -> list[str]:
        end, up = round(end, 4), round(14.5 - lead, 4)
        text = cut_lines((0, 10, end, 10, 0), (2, 6, 2, up, 90), (5, 6, 5, up, 90))
        return [f.text for f in verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings]

    assert texts(8.5 - lead) == []
    assert texts(9.0 - lead) != []


@pytest.mark.parametrize("size", [7.0, 9.5, 40.0])
@pytest.mark.parametrize("joints", [0, 1, 30])
def test_a_perforation_that_is_cut_through_is_refused(size: float, joints: int) -> None:
    # 8.5 mm has no room for a gap between three cuts of 3 mm, and 7 mm has one between two.
    lead = 0.4056  # 2.3 tan 10°
    at = np.linspace(0.0, size, joints + 2)
    kind = LineType.PERFORATION
    drawn = dieline(*((kind, a, 10, b, 10, 0.0) for a, b in pairwise(at)))
    text = cut_lines((0, 10, round(size - lead, 4), 10, 0))
    found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    assert {one.message.code for one in found if one.refuses} == {"verify.perforation-cut"}


def test_a_perforation_of_many_edges_has_no_longer_cuts() -> None:
    lead = 0.4056  # 2.3 tan 10°
    at = np.linspace(0.0, 19.0, 39)
    kind = LineType.PERFORATION
    drawn = dieline(*((kind, a, 10, b, 10, 0.0) for a, b in pairwise(at)))
    text = cut_lines(*((x, 10, round(x + 8.5 - lead, 4), 10, 0) for x in (0, 10.5)))
    found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
    assert {one.message.code for one in found if one.refuses} == {"verify.perforation-cut"}


def test_a_perforation_has_cuts_and_gaps() -> None:
    drawn = dieline((LineType.PERFORATION, 0, 0, 18, 0, 0.0))
    lead = 2.3 * math.tan(math.radians(10.0))

    def perforated(pieces: list[tuple[float, float]]) -> Verdict:
        lines = ["G0 Z4"]
        for begin, end in pieces:
            lines += [
                f"G0 X{begin:.4f}", "G1 Z-0.3 F6000", f"G1 X{end - lead:.4f} F24000",
                "G1 Z4 F6000",
            ]  # fmt: skip
        text = knife_program("G0 X0 Y0 Z20 C0", *lines)
        return verify(text, drawn, (0.0, 0.0), MACHINE, BOARD)

    assert perforated([(0, 3), (5, 8), (10, 13), (15, 18)]).findings == ()
    assert {f.kind for f in perforated([(0, 3), (5, 8), (15, 18)]).findings} == {"uncut"}
    assert {f.kind for f in perforated([(0, 3), (5, 8), (10, 13.2), (15, 18)]).findings} == {
        "uncut",
        "deviation",
    }
    # A cut 0.008 mm off makes one gap longer and the next shorter; at 0.004 mm it is accepted.
    assert perforated([(0, 3), (4.996, 7.996), (10, 13), (15, 18)]).findings == ()
    shifted = perforated([(0, 3), (4.992, 7.992), (9.996, 12.996), (15, 18)]).findings
    assert [f.message.code for f in shifted] == ["verify.perforation-uneven"]
    # A cut between two cuts leaves no board that holds.
    through = perforated([(0, 3), (2.9, 5.9), (5, 8), (10, 13), (15, 18)]).findings
    assert {(f.kind, f.edge, round(f.measure, 3)) for f in through} == {
        ("overcut", 0, 0.433),
        ("overcut", 0, 1.233),
    }
    # 18 mm need four cuts of 3 mm, so that a gap is longer than 2 - 5 / 3 = 0.333 mm.
    near = perforated([(0, 3), (3.3, 6.3), (8.3, 11.3), (13, 16), (15, 18)]).findings
    assert ("overcut", 0.033) in {(f.kind, round(f.measure, 3)) for f in near}
    # 18.5 less the lead is 0.0944 past the end, and the gap before 15.5 is 2.9 of at most 2.4.
    past = perforated([(0, 3), (5, 8), (10, 13), (15.5, 18.5)]).findings
    assert {(f.kind, round(f.measure, 4)) for f in past} == {("overcut", 0.0944), ("uncut", 2.9056)}


def test_a_cut_may_overrun_along_a_perforation_but_not_replace_it() -> None:
    # In line: a slit as far as the outline, a perforation in the waste, and another slit.
    lead, over = 2.3 * math.tan(math.radians(10.0)), 2.0 * math.tan(math.radians(10.0))
    sides = ((0, 0, 40, 0, 0), (40, 0, 40, 40, 90), (40, 40, 0, 40, 180), (0, 40, 0, 0, 270))
    drawn = dieline(
        *SQUARE,
        (CUT, 10, 20, 40, 20, 0.0),
        (LineType.PERFORATION, 40, 20, 58, 20, 0.0),
        (CUT, 58, 20, 80, 20, 0.0),
    )

    def codes(*lines: tuple[float, float]) -> set[str]:
        slits = [(begin, 20.0, round(end, 4), 20.0, 0.0) for begin, end in lines]
        text = cut_lines(*slits, *sides)
        found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
        return {one.message.code for one in found if one.refuses}

    dashes = [(x, x + 3 - lead) for x in (40, 45, 50, 55)]
    apart = [(10, 40 + over), *dashes, (58, 80 - lead)]
    assert codes(*apart) == set()
    assert "verify.perforation-cut" in codes((10, 80 - lead))
    assert codes((10, 43 - lead), *dashes[1:], (58, 80 - lead)) != set()
