import math
import re
from dataclasses import replace

import numpy as np
import pytest
import shapely

from knifetip.model.board import Board, Deflection
from knifetip.model.dieline import Dieline
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Cutter
from knifetip.model.verdict import Finding, Severity, Verdict
from knifetip.verification.checks.milling.geometry import is_beside_arc, spans_near_points
from knifetip.verification.columns import F64
from knifetip.verification.curves.curve import line_curves
from knifetip.verification.curves.intervals import uncovered_edges
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import BOARD, CUT, MACHINE, changed, dieline
from tests.support.shapes import with_dimensions

#: A router of 3 mm radius on output 0, and nothing else.
ROUTER: Machine = replace(
    MACHINE,
    stations=(
        Station(1, "Router", Cutter(3.0, 6000.0, 1200.0, speed=20000.0), 0.0, 0.0, 0.0, 0.0, 0),
    ),
)

#: A part of 100 × 80 with a hole of 30 × 20 in it.
PART = dieline(
    (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 80, 0.0), (CUT, 100, 80, 0, 80, 0.0),
    (CUT, 0, 80, 0, 0, 0.0),
    (CUT, 30, 30, 60, 30, 0.0), (CUT, 60, 30, 60, 50, 0.0), (CUT, 60, 50, 30, 50, 0.0),
    (CUT, 30, 50, 30, 30, 0.0),
)  # fmt: skip

HOLE = (
    "G0 X45 Y33 Z20", "G0 Z4", "G1 Z-0.3 F1200",
    "G1 X57 F6000", "G1 Y47", "G1 X33", "G1 Y33", "G1 X45", "G1 Z4 F1200",
)  # fmt: skip
#: Clockwise, 3 mm outside; the corners are rounded (B), square (C) or cut between (D).
ROUND = (
    "G0 X50 Y-3", "G1 Z-0.3 F1200", "G1 X0 F6000", "G2 X-3 Y0 I0 J3", "G1 Y80", "G2 X0 Y83 I3 J0",
    "G1 X100", "G2 X103 Y80 I0 J-3", "G1 Y0", "G2 X100 Y-3 I-3 J0", "G1 X50", "G1 Z4 F1200",
)  # fmt: skip
SQUARE = (
    "G0 X50 Y-3", "G1 Z-0.3 F1200", "G1 X-3 F6000", "G1 Y83", "G1 X103", "G1 Y-3", "G1 X50",
    "G1 Z4 F1200",
)  # fmt: skip
#: k = 1/2: l = 1.5, r' = 1.5.
BETWEEN = (
    "G0 X50 Y-3", "G1 Z-0.3 F1200",
    "G1 X-1.5 F6000", "G2 X-3 Y-1.5 I0 J1.5", "G1 Y81.5", "G2 X-1.5 Y83 I1.5 J0",
    "G1 X101.5", "G2 X103 Y81.5 I0 J-1.5", "G1 Y-1.5", "G2 X101.5 Y-3 I-1.5 J0", "G1 X50",
    "G1 Z4 F1200",
)  # fmt: skip


def program(*lines: str) -> bytes:
    head = "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG64 P0.0050 Q0.0050\nG0 Z20.0000"
    body = "\n".join(lines)
    down, up = "M64 P0\nM3 S20000\nG4 P0.15\nG0 C0", "M65 P0\nM5"
    return f"{head}\nT1 M6 G43\n{down}\n{body}\nG0 Z20.0000\n{up}\nG49\nM2\n".encode()


def verdict_of(text: bytes, drawn: Dieline = PART, board: Board = BOARD) -> Verdict:
    return verify(text, drawn, (0.0, 0.0), ROUTER, board)


def faults(verdict: Verdict) -> tuple[Finding, ...]:
    """Return the faults among the findings of a verdict."""
    return tuple(found for found in verdict.findings if found.severity is Severity.FAULT)


def limits(verdict: Verdict) -> dict[tuple[str, int], Finding]:
    """Return the shortfalls and notes of a verdict by kind and edge."""
    return {(f.kind, f.edge): f for f in verdict.findings if f.severity is not Severity.FAULT}


@pytest.mark.parametrize("outside", [ROUND, SQUARE, BETWEEN], ids="BCD")
def test_a_part_cut_from_outside_and_its_hole_from_inside_is_accepted(
    outside: tuple[str, ...],
) -> None:
    verdict = verdict_of(program(*HOLE, *outside))
    assert verdict.accepted
    assert faults(verdict) == ()
    np.testing.assert_allclose(verdict.deviation, 0.005)
    np.testing.assert_allclose(verdict.overcut, 0.0, atol=1e-9)
    # In the corners of the hole r tan 45° = 3 mm of both edges remain uncut.
    np.testing.assert_allclose(verdict.unreached, [0, 0, 0, 0, 6, 6, 6, 6], atol=0.03)
    found = limits(verdict)
    assert list(found) == [("unreached", edge) for edge in (4, 5, 6, 7)]
    assert {finding.severity for finding in found.values()} == {Severity.NOTE}
    assert [finding.measure for finding in found.values()] == pytest.approx([6.0] * 4, abs=0.03)
    # The disc that touches both edges leaves r (√2 - 1) to the corner.
    beyond = 3.0 * (math.sqrt(2.0) - 1.0)
    np.testing.assert_allclose(verdict.unreached_distance, [0, 0, 0, 0] + [beyond] * 4, atol=1e-6)
    assert "in 2 places, without cutting into a part. The edge lies up to 1.243 mm" in (
        found["unreached", 4].text
    )


def test_the_swept_area_does_not_intersect_the_part_in_shapely() -> None:
    rectangle = shapely.box(0, 0, 100, 80) - shapely.box(30, 30, 60, 50)
    way = shapely.union_all(
        [
            shapely.LineString([(50, -3), (-3, -3), (-3, 83), (103, 83), (103, -3), (50, -3)]),
            shapely.LineString([(45, 33), (57, 33), (57, 47), (33, 47), (33, 33), (45, 33)]),
        ]
    )
    swept = way.buffer(3.0, quad_segs=256)
    assert swept.intersection(rectangle).area < 1e-9
    # The corners of the hole keep (1 - π/4) r² each: tan(φ/2) - φ/2 at φ = 90°.
    hole = shapely.box(30, 30, 60, 50)
    kept = (hole - swept).area - shapely.box(36, 36, 54, 44).area
    assert kept == pytest.approx(4 * (1 - math.pi / 4) * 9, rel=1e-4)
    assert verdict_of(program(*HOLE, *SQUARE)).accepted


@pytest.mark.parametrize(
    ("old", "new", "edge", "measure"),
    [
        ("G1 Y80\n", "G1 X-2.98 Y80\n", 3, 0.02),
        ("G1 X57 F6000", "G1 X57.02 F6000", 5, 0.02),
        ("G0 X50 Y-3\n", "G0 X50 Y-2.98\n", 0, 0.02),
    ],
)
def test_a_disc_that_cuts_into_the_part_is_refused_with_edge_and_depth(
    old: str, new: str, edge: int, measure: float
) -> None:
    findings = faults(verdict_of(changed(program(*HOLE, *ROUND), old, new)))
    mine = [finding for finding in findings if (finding.kind, finding.edge) == ("overcut", edge)]
    assert mine[0].measure == pytest.approx(measure, abs=1e-6)
    assert (
        f"cuts sideways into a part, up to {measure:.3f} mm from the edge of the part"
        in mine[0].text
    )


def test_a_chord_across_a_corner_is_refused() -> None:
    # From B0 straight to E0: the chord is 3 / √2 = 2.1213 from the corner.
    text = changed(program(*HOLE, *ROUND), "G2 X-3 Y0 I0 J3", "G1 X-3 Y0")
    findings = faults(verdict_of(text))
    assert max(finding.measure for finding in findings) == pytest.approx(3 - 3 / math.sqrt(2))
    assert {finding.kind for finding in findings} == {"overcut"}


def test_an_edge_that_is_not_touched_is_uncut() -> None:
    text = program(*HOLE, *(line.replace("-3", "-3.03") for line in SQUARE))
    findings = {(finding.kind, finding.edge): finding for finding in faults(verdict_of(text))}
    assert set(findings) == {("uncut", 0), ("uncut", 3)}
    assert findings["uncut", 0].measure == pytest.approx(100.0)


def test_a_hole_left_out_and_a_hole_cut_from_outside_are_refused() -> None:
    assert {f.edge for f in faults(verdict_of(program(*SQUARE)))} == {4, 5, 6, 7}
    outside = ("G0 X45 Y27 Z20", "G0 Z4", "G1 Z-0.3 F1200", "G1 X63 F6000", "G1 Y53", "G1 X27",
               "G1 Y27", "G1 X45", "G1 Z4 F1200")  # fmt: skip
    kinds = {finding.kind for finding in faults(verdict_of(program(*outside, *SQUARE)))}
    assert kinds == {"uncut", "stray"}


def test_a_path_that_stops_early_leaves_that_length_uncut() -> None:
    text = changed(program(*HOLE, *SQUARE), "G1 X50\n", "G1 X80\n")
    (finding,) = faults(verdict_of(text))
    assert (finding.kind, finding.edge) == ("uncut", 0)
    assert finding.measure == pytest.approx(30.0)


def test_a_cutter_that_is_not_through_is_refused() -> None:
    text = program(*HOLE, *SQUARE).replace(b"Z-0.3", b"Z0.1")
    assert {"depth", "uncut"} == {finding.kind for finding in faults(verdict_of(text))}


def test_a_shallow_pass_without_a_final_pass_is_refused() -> None:
    stepped = with_dimensions(ROUTER.stations[0].tool, step=2.0)
    machine = replace(ROUTER, stations=(replace(ROUTER.stations[0], tool=stepped),))

    def found(pass_end: int) -> list[tuple[str, int]]:
        text = program(*HOLE, *SQUARE[:-2], "G1 X80", "G1 Z4 F1200").decode()
        first = f"G0 X90 Y-3\nG1 Z1 F1200\nG1 X{pass_end} F6000\nG1 Z4 F1200\n"
        text = text.replace("G0 X50 Y-3\n", first + "G0 X50 Y-3\n", 1)
        findings = verify(text.encode(), PART, (0.0, 0.0), machine, BOARD).findings
        return [(f.message.code, round(f.measure)) for f in findings if f.kind == "stray"]

    assert found(80) == []
    assert found(60) == [("verify.pass-alone", 20)]


def test_a_cutter_at_rest_is_refused() -> None:
    text = program(*HOLE, *SQUARE).replace(b"M3 S20000\n", b"")
    assert any("spindle is off" in finding.text for finding in faults(verdict_of(text)))


def test_work_far_off_in_the_waste_is_a_stray() -> None:
    text = program(*HOLE, *SQUARE, "G0 X200 Y200", "G1 Z-0.3 F1200", "G1 X220 F6000", "G1 Z4 F1200")
    assert [finding.kind for finding in faults(verdict_of(text))] == ["stray"]


def test_a_machine_with_a_knife_has_no_work_for_its_cutter() -> None:
    both = replace(MACHINE, stations=(*MACHINE.stations, replace(ROUTER.stations[0], number=4,
                                                                  output=3)))  # fmt: skip
    text = program(*HOLE, *SQUARE).replace(b"T1", b"T4").replace(b"P0\n", b"P3\n")
    found = {finding.kind for finding in verify(text, PART, (0.0, 0.0), both, BOARD).findings}
    assert {"uncut", "stray"} <= found


@pytest.mark.parametrize("aside", [0.0, 0.0062])
def test_a_corner_beside_the_path_of_a_facing_part(aside: float) -> None:
    # The parts are a little farther apart than the disc is wide, so that the path past a corner of
    # one of them runs nearly on the path beside the other.
    low = 86.0062
    block = dieline(
        (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 80, 0.0), (CUT, 100, 80, 0, 80, 0.0),
        (CUT, 0, 80, 0, 0, 0.0),
        (CUT, -5, low, 150, low, 0.0), (CUT, 150, low, 150, 160, 0.0),
        (CUT, 150, 160, -5, 160, 0.0), (CUT, -5, 160, -5, low, 0.0),
    )  # fmt: skip
    facing = (
        f"G0 X50 Y{low - 3 - aside:.4f}", "G1 Z-0.3 F1200", "G1 X-8 F6000", "G1 Y163", "G1 X153",
        f"G1 Y{low - 3 - aside:.4f}", "G1 X50", "G1 Z4 F1200",
    )  # fmt: skip
    found = faults(verdict_of(program(*BETWEEN, *facing), block))
    assert bool(found) == (aside > 0.0), found


def test_a_round_part_and_a_hole_too_tight_for_the_disc() -> None:
    drawn = dieline(
        (CUT, 60, 40, 20, 40, 1.0), (CUT, 20, 40, 60, 40, 1.0),  # R 20
        (CUT, 42.5, 40, 37.5, 40, 1.0), (CUT, 37.5, 40, 42.5, 40, 1.0),  # R 2.5
    )  # fmt: skip
    text = program(
        "G0 X63 Y40 Z20", "G0 Z4", "G1 Z-0.3 F1200", "G2 X17 Y40 I-23 J0 F6000",
        "G2 X63 Y40 I23 J0", "G1 Z4 F1200",
    )  # fmt: skip
    verdict = verdict_of(text, drawn)
    assert faults(verdict) == ()
    np.testing.assert_allclose(verdict.unreached, [0, 0, 2.5 * math.pi, 2.5 * math.pi])
    smaller = text.replace(b"X63", b"X62.98").replace(b"X17", b"X17.02").replace(b"23", b"22.98")
    finding = faults(verdict_of(smaller, drawn))[0]
    assert finding.kind == "overcut"
    assert finding.measure == pytest.approx(0.02)


def test_a_round_hole_is_milled_from_inside() -> None:
    drawn = dieline(
        (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 80, 0.0), (CUT, 100, 80, 0, 80, 0.0),
        (CUT, 0, 80, 0, 0, 0.0), (CUT, 60, 40, 40, 40, 1.0), (CUT, 40, 40, 60, 40, 1.0),  # R 10
    )  # fmt: skip

    def milled(radius: float) -> Verdict:
        hole = (f"G0 X{50 + radius:.4f} Y40 Z20", "G0 Z4", "G1 Z-0.3 F1200",
                f"G3 X{50 - radius:.4f} Y40 I{-radius:.4f} J0 F6000",
                f"G3 X{50 + radius:.4f} Y40 I{radius:.4f} J0",
                "G1 Z4 F1200")  # fmt: skip
        return verdict_of(program(*hole, *SQUARE), drawn)

    assert faults(milled(7.0)) == ()
    assert {finding.kind for finding in faults(milled(6.98))} == {"uncut"}
    wide = faults(milled(7.02))
    assert {(finding.kind, finding.edge) for finding in wide} >= {("overcut", 4), ("overcut", 5)}
    assert wide[0].measure == pytest.approx(0.02)


def test_a_disc_that_is_no_circle_is_beside_an_arc_a_little_past_its_end() -> None:
    # A quarter of a circle with a radius of 10 mm, and points 13 mm from its centre.
    quarter = np.array([(1.0, 0.0, 0.0, 10.0, 0.0, 5.0 * math.pi)])
    angles = np.radians([-1.0, -0.5, 45.0, 90.5, 91.0])
    points = 13.0 * np.column_stack([np.cos(angles), np.sin(angles)])

    def beside(x: float, y: float) -> list[bool]:
        edges = np.repeat(quarter, len(points), axis=0)
        mask: list[bool] = is_beside_arc(points, edges, np.array([x, y])).tolist()
        return mask

    assert beside(3.0, 3.0) == [False, False, True, False, False]
    # 0.5° are 0.113 mm, and 1° is 0.227 mm.
    assert beside(3.0, 2.9) == [False, True, True, True, False]


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("wider", [-0.0004, 0.0, 0.0004])
def test_the_disc_turns_on_the_spot_in_a_corner_as_round_as_itself(
    wider: float, backwards: bool
) -> None:
    r, b = 3.0 + wider, math.tan(math.pi / 8.0)
    drawn = dieline(
        (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 80, 0.0), (CUT, 100, 80, 0, 80, 0.0),
        (CUT, 0, 80, 0, 0, 0.0),
        (CUT, 30 + r, 30, 60 - r, 30, 0.0), (CUT, 60 - r, 30, 60, 30 + r, b),
        (CUT, 60, 30 + r, 60, 50 - r, 0.0), (CUT, 60, 50 - r, 60 - r, 50, b),
        (CUT, 60 - r, 50, 30 + r, 50, 0.0), (CUT, 30 + r, 50, 30, 50 - r, b),
        (CUT, 30, 50 - r, 30, 30 + r, 0.0), (CUT, 30, 30 + r, 30 + r, 30, b),
    )  # fmt: skip
    ways = [f"G1 X{x} Y{y}" for x, y in ((57, 33), (57, 47), (33, 47), (33, 33), (45, 33))]
    if backwards:
        ways = [*ways[-2::-1], ways[-1]]
    hole = ("G0 X45 Y33 Z20", "G0 Z4", "G1 Z-0.3 F1200", "F6000", *ways, "G1 Z4 F1200")
    assert faults(verdict_of(program(*hole, *SQUARE), drawn)) == ()
    farther = [way.replace("X57", "X57.03") for way in hole]
    wrong = faults(verdict_of(program(*farther, *SQUARE), drawn))
    assert wrong[0].measure == pytest.approx(0.03, abs=0.001)
    corner = hole.index("G1 X57 Y33")
    across = [*hole[: corner + 1], "G1 X62 Y28", "G1 X57 Y33", *hole[corner + 1 :]]
    crossed = faults(verdict_of(program(*across, *SQUARE), drawn))
    assert max(finding.measure for finding in crossed) >= 3.0


def test_a_slot_narrower_than_the_disc_is_unreached_and_one_that_is_wider_is_not() -> None:
    def slotted(width: float, bottom: float = 20.0) -> Dieline:
        left, right = 50 - width / 2, 50 + width / 2
        return dieline(
            (CUT, 0, 0, 100, 0, 0.0), (CUT, 100, 0, 100, 40, 0.0), (CUT, 100, 40, right, 40, 0.0),
            (CUT, right, 40, right, bottom, 0.0), (CUT, right, bottom, left, bottom, 0.0),
            (CUT, left, bottom, left, 40, 0.0), (CUT, left, 40, 0, 40, 0.0),
            (CUT, 0, 40, 0, 0, 0.0),
        )  # fmt: skip

    over = program("G0 X50 Y-3 Z20", "G0 Z4", "G1 Z-0.3 F1200", "G1 X-3 F6000", "G1 Y43",
                   "G1 X103", "G1 Y-3", "G1 X50", "G1 Z4 F1200")  # fmt: skip
    narrow = verdict_of(over, slotted(5.0))
    assert faults(narrow) == ()
    np.testing.assert_allclose(narrow.unreached[[3, 4, 5]], [20, 5, 20], atol=0.01)
    assert not narrow.accepted
    assert all(
        limits(narrow)["unreached", edge].severity is Severity.SHORTFALL for edge in (3, 4, 5)
    )
    # The bottom of the slot, y = 20, is 23 below the path at y = 43.
    np.testing.assert_allclose(narrow.unreached_distance[[3, 4, 5]], 20.0, atol=1e-3)
    # A notch 5 mm deep: only its bottom is known to be no corner.
    notch = verdict_of(over, slotted(5.0, 35.0))
    severity = {edge: limits(notch)["unreached", edge].severity for edge in (3, 4, 5)}
    assert severity == {3: Severity.NOTE, 4: Severity.SHORTFALL, 5: Severity.NOTE}
    wide = verdict_of(over, slotted(8.0))
    # Of the 20 mm of each side, 17 can be touched; of the bottom 2.
    assert {(f.kind, f.edge) for f in faults(wide)} == {("uncut", 3), ("uncut", 4), ("uncut", 5)}
    np.testing.assert_allclose(wide.uncut[[3, 4, 5]], [17, 2, 17], atol=0.05)


def test_an_open_cut_is_followed_on_its_line_from_end_to_end() -> None:
    drawn = dieline((CUT, 10, 10, 60, 10, 0.0))

    def kinds(x: float, y: float, until: float) -> set[str]:
        cut = ("G0 Z4", "G1 Z-0.3 F1200", f"G1 X{until:.4f} F6000", "G1 Z4 F1200")
        verdict = verdict_of(program(f"G0 X{x:.4f} Y{y:.4f} Z20", *cut), drawn)
        return {finding.kind for finding in faults(verdict)}

    assert kinds(10, 10, 60) == set()
    assert kinds(10, 13, 60) == {"uncut"}
    assert kinds(10, 10, 59.98) == {"uncut"}
    assert kinds(9.98, 10, 60) == {"overcut"}
    assert kinds(10, 10, 80) == {"overcut", "stray"}


def test_a_lead_or_a_contour_on_the_line_of_an_open_cut_does_not_follow_this_cut() -> None:
    # A scrap cut in the hole ends in the lead of the hole, and another one, 3 mm below the part,
    # on the path round the part.
    scrap, below = (CUT, 45, 33.6, 45, 42, 0.0), (CUT, 20, -3, 90, -3, 0.0)
    drawn = dieline(*(
        (CUT, *ends.ravel().tolist(), 0.0) for ends in PART.ends
    ), scrap, below)  # fmt: skip
    cuts = (
        "G0 X45 Y42", "G1 Z-0.3 F1200", "G1 Y33.6 F6000", "G1 Z4 F1200",
        "G0 X20 Y-3", "G1 Z-0.3 F1200", "G1 X90 F6000", "G1 Z4 F1200",
    )  # fmt: skip
    hole = ("G0 X45 Y34.5 Z20", "G0 Z4", "G1 Z-0.3 F1200", "G1 Y33 F6000", *HOLE[3:])
    text = program(*cuts, *hole, *ROUND)
    assert faults(verdict_of(text, drawn)) == ()
    # The scrap cut itself must stop at its end.
    found = faults(verdict_of(changed(text, "G1 Y33.6 F6000", "G1 Y33.4 F6000"), drawn))
    assert [f.message.code for f in found] == ["verify.past-open-cut"]


def test_a_contour_between_open_cuts_on_all_sides_does_not_follow_them() -> None:
    # The open outline of a neighbour lies 3 mm beside all four sides of the part.
    sides = ((5, -3, 95, -3), (103, 5, 103, 75), (95, 83, 5, 83), (-3, 75, -3, 5))
    drawn = dieline(
        *((CUT, *ends.ravel().tolist(), 0.0) for ends in PART.ends),
        *((CUT, *side, 0.0) for side in sides),
    )
    cuts = [
        line
        for x, y, to_x, to_y in sides
        for line in (f"G0 X{x} Y{y}", "G1 Z-0.3 F1200", f"G1 X{to_x} Y{to_y} F6000", "G1 Z4 F1200")
    ]
    found = faults(verdict_of(program(*HOLE, *cuts, *ROUND), drawn))
    assert "verify.past-open-cut" not in [finding.message.code for finding in found]


def test_a_slit_that_becomes_as_wide_as_the_cutter_is_a_shortfall_with_its_length() -> None:
    drawn = dieline((CUT, 10, 10, 60, 10, 0.0), (CUT, 10, 40, 40, 40, 0.0))
    cuts = ("G0 Z4", "G1 Z-0.3 F1200", "G1 X60 F6000", "G1 Z4 F1200", "G0 X10 Y40",
            "G1 Z-0.3 F1200", "G1 X40 F6000", "G1 Z4 F1200")  # fmt: skip
    verdict = verdict_of(program("G0 X10 Y10 Z20", *cuts), drawn)
    assert faults(verdict) == ()
    assert not verdict.accepted
    found = limits(verdict)
    assert {finding.severity for finding in found.values()} == {Severity.SHORTFALL}
    assert {key: round(finding.measure, 3) for key, finding in found.items()} == {
        ("kerf", 0): 50.0,
        ("kerf", 1): 30.0,
    }
    np.testing.assert_allclose(verdict.slit_length, [50.0, 30.0])
    assert "mills 30.000 mm of the slit 6.00 mm wide" in found["kerf", 1].text
    # A slit of which only a part is cut is a fault; the milled part is still a shortfall.
    half = verdict_of(
        program("G0 X10 Y10 Z20", *cuts[:5], *cuts[5:6], "G1 X25 F6000", cuts[7]), drawn
    )
    assert not half.accepted
    assert half.slit_length[1] == pytest.approx(15.0)


def test_a_kerf_as_narrow_as_that_of_a_laser_is_no_shortfall() -> None:
    drawn = dieline((CUT, 10, 10, 60, 10, 0.0))
    cut = ("G0 X10 Y10 Z20", "G0 Z4", "G1 Z-0.3 F1200", "G1 X60 F6000", "G1 Z4 F1200")
    tool = Cutter(0.2, 6000.0, 1200.0, speed=20000.0)
    thin = replace(ROUTER, stations=(replace(ROUTER.stations[0], tool=tool),))
    verdict = verify(program(*cut), drawn, (0.0, 0.0), thin, BOARD)
    [note] = verdict.findings
    assert (note.message.code, note.severity) == ("verify.narrow-slits", Severity.NOTE)
    assert dict(note.message.arguments) == {"count": 1, "length": pytest.approx(50.0), "width": 0.4}
    assert not verdict.slit_length.any()


def test_a_deflected_cutter_runs_nearer_and_on_ellipses_round_corners() -> None:
    # δx = 0.2, δy = 0.1: 2.8 from the edges at the sides, 2.9 above and below.
    board = replace(BOARD, deflection=(Deflection("Router", 0.2, 0.1),))
    hole = [line.replace("57", "57.2").replace("33", "32.8" if "X33" in line else "32.9")
            .replace("47", "47.1") for line in HOLE]  # fmt: skip
    hole = [line.replace("X45 Y33", "X45 Y32.9") for line in hole]

    def ellipse(x: float, y: float, first: float) -> list[str]:
        angles = np.radians(np.linspace(first, first - 90.0, 41)[1:])
        return [f"G1 X{x + 2.8 * math.cos(a):.5f} Y{y + 2.9 * math.sin(a):.5f}" for a in angles]

    # Chords of an ellipse run inside it by up to r (1 - cos(90° / 80)) = 0.0006.
    way = ("G0 X50 Y-2.9", "G1 Z-0.3 F1200", "G1 X0 F6000", *ellipse(0, 0, 270), "G1 Y80",
           *ellipse(0, 80, 180), "G1 X100", *ellipse(100, 80, 90), "G1 Y0", *ellipse(100, 0, 0),
           "G1 X50", "G1 Z4 F1200")  # fmt: skip
    text = program(*hole, *way)
    assert faults(verdict_of(text, PART, board)) == ()
    stiff = {finding.kind for finding in faults(verdict_of(text))}
    assert "overcut" in stiff
    # The path of a rigid tool leaves uncut the length of the deflection.
    soft = {finding.kind for finding in faults(verdict_of(program(*HOLE, *ROUND), PART, board))}
    assert soft == {"uncut"}


def test_a_round_part_is_cut_on_an_ellipse_if_deflections_differ() -> None:
    board = replace(BOARD, deflection=(Deflection("Router", 0.2, 0.1),))
    drawn = dieline((CUT, 60, 40, 20, 40, 1.0), (CUT, 20, 40, 60, 40, 1.0))

    def way(a: float, b: float) -> bytes:
        angles = np.radians(np.linspace(0.0, -360.0, 361))
        points = [f"X{40 + a * math.cos(t):.5f} Y{40 + b * math.sin(t):.5f}" for t in angles]
        return program(f"G0 {points[0]} Z20", "G0 Z4", "G1 Z-0.3 F1200", f"G1 {points[1]} F6000",
                       *(f"G1 {point}" for point in points[2:]), "G1 Z4 F1200")  # fmt: skip

    # Chords of one degree run inside a circle of 23 by 0.0009.
    assert faults(verdict_of(way(22.8, 22.9), drawn, board)) == ()
    assert not verdict_of(way(22.9, 22.8), drawn, board).accepted
    assert not verdict_of(way(22.78, 22.9), drawn, board).accepted


def test_a_changed_digit_that_moves_the_disc_is_refused() -> None:
    text = program(*HOLE, *ROUND)
    chance = np.random.default_rng(3)
    raw = np.frombuffer(text, np.uint8)
    words = [(m.start(1), m.end(1)) for m in re.finditer(rb"[XYIJ](-?\d+\.?\d*)", text)]
    caught = total = 0
    for first, last in words:
        for place in range(first, last):
            if not 48 <= raw[place] <= 57:
                continue
            mutant = bytearray(text)
            mutant[place] = 48 + (raw[place] - 48 + chance.integers(1, 10)) % 10
            total += 1
            caught += not verdict_of(bytes(mutant)).accepted
    # A change that only shortens the start and the end, which overlap on one line, cuts the same.
    assert total > 40
    assert caught >= total - 6


def test_uncovered_edges_are_the_rest_of_the_intervals() -> None:
    edge, begin, end = uncovered_edges(
        np.array([1, 0, 1]), np.array([2.0, 0.0, 1.0]), np.array([5.0, 4.0, 3.0]),
        np.array([4.0, 9.0, 2.0]),
    )  # fmt: skip
    assert edge.tolist() == [1, 1, 2]
    np.testing.assert_array_equal(begin, [0.0, 5.0, 0.0])
    np.testing.assert_array_equal(end, [1.0, 9.0, 2.0])


def test_the_span_of_a_line_near_a_point() -> None:
    line: F64 = line_curves(np.array([[0.0, 0.0]]), np.array([[10.0, 0.0]]))
    low, high = spans_near_points(line, np.array([[5.0, 3.0]]), 5.0)
    np.testing.assert_allclose([low[0], high[0]], [1.0, 9.0])
    low, high = spans_near_points(line, np.array([[5.0, 6.0]]), 5.0)
    assert high[0] < low[0]
