"""The verifier and the router: its programs are accepted, and wrong offsets are refused."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.compensation import centre_paths, radius
from knifetip.compensation.centre_paths import CentrePaths
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.acceptance import with_exceptions
from knifetip.model.board import Board, Deflection
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import Cutter
from knifetip.model.toolpath import Motion
from knifetip.model.verdict import Acceptance, Severity, Verdict
from knifetip.sequencing import sequence as order
from knifetip.verification.verify import verify
from tests.support.modules import original
from tests.support.shapes import closed, dieline, edges
from tests.support.verdicts import has_faults

ROUTER = load.machine("router-table")
BOARD = load.board("greyboard-3.0")
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 200), (200, 200), (200, 250), (100, 250))),
    (LineType.CUT, closed((120, 120), (170, 120), (170, 160), (120, 160))),
    (LineType.CUT, edges(((200, 120), (200, 180)))),
    bulge={1: 0.2, 7: -0.1},
)


def verdict(board: Board = BOARD, dialect: str = "linuxcnc", corner: str = "auto") -> Verdict:
    work = [replace(operation, corner=corner) for operation in plan(LINE, ROUTER, board)]
    toolpath = sequence([compensate(operation) for operation in work], ROUTER)
    return verify(process(toolpath, ROUTER, dialect).text, LINE, (0.0, 0.0), ROUTER, board)


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("corner", ["B", "C", "D", "auto"])
def test_programs_of_the_router_are_accepted(dialect: str, corner: str) -> None:
    result = verdict(dialect=dialect, corner=corner)
    assert not has_faults(result), result.findings[:3]


@pytest.mark.parametrize("factor", [0.99, 1.01])
def test_a_radius_wrong_by_a_hundredth_is_refused(
    monkeypatch: pytest.MonkeyPatch, factor: float
) -> None:
    right = original(centre_paths, "offset_paths")

    def wrong(paths: Paths, distance: float, side: int, **more: Any) -> Any:
        return right(paths, distance * factor, side, **more)

    monkeypatch.setattr(centre_paths, "offset_paths", wrong)
    assert has_faults(verdict())


def test_a_cutter_on_the_wrong_side_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = original(centre_paths, "offset_paths")

    def wrong(paths: Paths, distance: float, side: int, **more: Any) -> Any:
        return right(paths, distance, -side, **more)

    monkeypatch.setattr(centre_paths, "offset_paths", wrong)
    monkeypatch.setattr(
        radius, "_add_leads", lambda _operation, _cutter, way, _held: _without_leads(way)
    )
    assert has_faults(verdict())


def _without_leads(centre: CentrePaths) -> tuple[Paths, I32, U8, tuple[Message, ...]]:
    return centre.paths, centre.segment, np.full(len(centre.segment), Motion.FEED, np.uint8), ()


def test_a_deflection_of_the_board_is_accepted_and_its_opposite_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    soft = replace(BOARD, deflection=(Deflection("Router", 0.08, 0.05),))
    result = verdict(soft)
    assert not has_faults(result), result.findings[:3]
    right = original(centre_paths, "shift_centres")
    monkeypatch.setattr(
        centre_paths, "shift_centres", lambda paths, side, x, y: right(paths, -side, x, y)
    )
    assert has_faults(verdict(soft))


def test_a_cutter_stays_out_of_a_blank_beside_another_that_a_cut_divides() -> None:
    # The cutter is 6 mm wide, and the waste between the blanks 3 mm.
    beside = dieline(
        (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
        (LineType.CUT, closed((203, 100), (300, 100), (300, 200), (203, 200))),
        (LineType.CUT, edges(((100, 150), (200, 150)))),
    )
    found = verdict_of(beside)
    assert not has_faults(found), found.findings[:3]
    left = {finding.edge for finding in found.findings if finding.kind == "unreached"}
    assert left == {1, 7}


def test_blanks_that_a_narrow_gap_leaves_joined_are_a_shortfall() -> None:
    # A lug of 8 mm ends 3 mm before the other blank: nearer than three radii to the cut, but longer
    # than the side of a corner.
    lug = closed((100, 100), (200, 100), (200, 146), (206, 146), (206, 154), (200, 154),
                 (200, 200), (100, 200))  # fmt: skip
    other = closed((209, 100), (300, 100), (300, 200), (209, 200))
    found = verdict_of(dieline((LineType.CUT, lug), (LineType.CUT, other)))
    severity = {one.edge: one.severity for one in found.findings if one.kind == "unreached"}
    assert severity[11] is Severity.SHORTFALL
    assert max(found.unreached_distance) < 9.0


def test_a_cutter_stays_out_of_a_neck_between_its_two_reaches(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # The mean reach, 2.96 mm, fits into the neck of the notch; along X the cutter reaches 3 mm.
    notch = dieline(
        (
            LineType.CUT,
            closed((100, 100), (200, 100), (200, 150), (155.95, 150), (155.95, 130), (165, 130),
                   (165, 110), (141, 110), (141, 130), (150, 130), (150, 150), (100, 150)),
        )
    )  # fmt: skip
    soft = replace(BOARD, deflection=(Deflection("Router", 0.0, 0.08),))
    found = verdict_of(notch, soft)
    assert {one.kind for one in found.findings} == {"unreached"}
    equal = replace(BOARD, deflection=(Deflection("Router", 0.04, 0.04),))
    assert not has_faults(verdict_of(notch, equal))
    # A path through the neck enters both walls, which the verifier refuses.
    monkeypatch.setattr(centre_paths, "_crosses_itself", lambda _paths: False)
    gouges = [one for one in verdict_of(notch, soft).findings if one.kind == "overcut"]
    assert {one.edge for one in gouges} >= {3, 9}
    assert max(one.measure for one in gouges) == pytest.approx(0.05, abs=0.001)
    assert all(one.severity is Severity.FAULT for one in gouges)


#: An outline with a pocket as wide as a cutter of 2 mm, and as deep as its radius.
POCKET = closed((54.032, 90.939), (37.39, 76.202), (38.053, 75.454), (36.556, 74.128),
                (35.893, 74.877), (20, 60.803), (60, 20))  # fmt: skip
#: An outline with a jog of 0.06 mm in one side, round which the centre has a short arc.
JOG = closed((79.1, 20.0), (87.48, 78.57), (87.48, 78.63), (95.85, 137.13), (36.75, 145.59),
             (20, 28.46))  # fmt: skip


@pytest.mark.parametrize(("outline", "radius"), [(POCKET, 1.0), (JOG, 3.0)])
def test_hundredths_at_corners_are_no_fault(outline: F64, radius: float) -> None:
    machine = with_diameter(ROUTER, 2.0 * radius)
    found = verdict_of(dieline((LineType.CUT, outline)), machine=machine)
    assert not has_faults(found), found.findings[:3]


def test_a_stretch_that_the_cutter_misses_by_a_tenth_is_a_fault(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # The neck lets the disc in; the program ends beside it.
    machine = with_diameter(ROUTER, 2.0)
    wide = dieline((LineType.CUT, closed((20, 20), (60, 20), (60, 60), (41.1, 60), (41.1, 55),
                                         (39.0, 55), (39.0, 60), (20, 60))))  # fmt: skip
    assert not has_faults(verdict_of(wide, machine=machine))
    right = original(centre_paths, "offset_paths")

    def narrower(paths: Paths, distance: float, side: int, **more: Any) -> Any:
        return right(paths, distance + 0.06, side, **more)

    monkeypatch.setattr(centre_paths, "offset_paths", narrower)
    assert has_faults(verdict_of(wide, machine=machine))


def with_diameter(machine: Machine, diameter: float) -> Machine:
    """Return a machine whose cutter has another diameter."""
    stations = [
        replace(one, tool=replace(one.tool, radius=0.5 * diameter))
        if isinstance(one.tool, Cutter)
        else one
        for one in machine.stations
    ]
    return replace(machine, stations=tuple(stations))


def verdict_of(
    line: Dieline, board: Board = BOARD, dialect: str = "linuxcnc", machine: Machine = ROUTER
) -> Verdict:
    work = [compensate(operation) for operation in plan(line, machine, board)]
    text = process(sequence(work, machine), machine, dialect).text
    return verify(text, line, (0.0, 0.0), machine, board)


CUT = LineType.CUT
FRAME = (CUT, closed((50, 50), (250, 50), (250, 200), (50, 200)))
HELD = replace(BOARD, bridge_width=0.8, bridge_spacing=160.0)
OUTLINE = (CUT, closed((100, 100), (400, 100), (400, 300), (100, 300)))
ROUND = (CUT, edges(((100, 200), (300, 200)), ((300, 200), (100, 200))))
NOTCHED = (CUT, closed((100, 100), (400, 100), (400, 300), (270, 300), (250, 220), (230, 300),
                       (100, 300)))  # fmt: skip


#: A window with two lugs, whose corners are so close to each other that only type B fits between.
LUGS = np.array([(8, 0), (17, 0), (17, 26), (27, 26), (27, 0), (35, 0), (42, -33)]) * 0.6 + 200.0


@pytest.mark.parametrize("corner", ["C", "D", "auto"])
def test_corners_near_another_contour_are_milled_as_type_b(corner: str) -> None:
    line = dieline(OUTLINE, (CUT, closed(*LUGS)))
    work = [compensate(replace(each, corner=corner)) for each in plan(line, ROUTER, BOARD)]
    toolpath = sequence(work, ROUTER)
    (note,) = (each for each in toolpath.notes if each.code == "corner.replaced")
    assert note.arguments["count"] == 2
    text = process(toolpath, ROUTER, "linuxcnc").text
    result = verify(text, line, (0.0, 0.0), ROUTER, BOARD)
    assert not has_faults(result), result.findings[:3]


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("step", [0.0, 1.2])
@pytest.mark.parametrize(
    ("outline", "bulge"),
    [(OUTLINE, {}), (OUTLINE, {1: 0.2, 3: -0.2}), (ROUND, {0: 1.0, 1: 1.0}), (NOTCHED, {})],
    ids=["blank", "with arcs", "disc", "notched"],
)
def test_a_blank_held_by_bridges_is_accepted(
    dialect: str, step: float, outline: tuple[LineType, F64], bulge: dict[int, float]
) -> None:
    stations = [
        replace(held, tool=replace(held.tool, step=step)) if isinstance(held.tool, Cutter) else held
        for held in ROUTER.stations
    ]
    machine = replace(ROUTER, stations=tuple(stations))
    slit = edges(((200, 150), (200, 250)))
    result = verdict_of(dieline(outline, (CUT, slit), bulge=bulge), HELD, dialect, machine)
    assert not has_faults(result), result.findings[:3]


@pytest.mark.parametrize("wrong", [-0.05, 0.05])
def test_bridges_that_are_too_narrow_or_too_wide_are_refused(
    monkeypatch: pytest.MonkeyPatch, wrong: float
) -> None:
    right = original(radius, "insert_gaps")

    def gapped(paths: Paths, path: I32, middle: F64, gap: float) -> Any:
        return right(paths, path, middle, gap + wrong)

    monkeypatch.setattr(radius, "insert_gaps", gapped)
    result = verdict_of(dieline(OUTLINE), HELD)
    kind = "uncut" if wrong > 0 else "overcut"
    found = next(finding for finding in result.findings if finding.kind == kind)
    assert found.measure == pytest.approx(0.05, abs=1e-3)


def test_a_part_without_bridges_is_refused_if_the_board_requires_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    line = dieline(OUTLINE)
    monkeypatch.setattr(
        radius, "_add_bridge_gaps", lambda _operation, _cutter, way: (way, _none(way))
    )
    assert "0 bridges hold the part" in verdict_of(line, HELD).findings[0].text
    assert not has_faults(verdict_of(line))


def _none(way: CentrePaths) -> Bool:
    return way.paths.closed & False


def test_blanks_and_holes_that_touch_in_a_point_are_accepted() -> None:
    one, other = (
        closed((150, 150), (200, 150), (200, 200), (150, 200)),
        closed((200, 200), (240, 200), (240, 240), (200, 240)),
    )
    assert not has_faults(verdict_of(dieline((CUT, one), (CUT, other))))
    assert not has_faults(verdict_of(dieline(OUTLINE, (CUT, one), (CUT, other))))


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_line_that_is_slit_and_outline_is_milled_as_both(dialect: str) -> None:
    # The line of the side flap, from (200, 140) to (300, 140), is a slit as far as the lower flap
    # reaches, and outline beyond it.
    cuts = edges(
        ((100, 100), (260, 100)),
        ((260, 100), (260, 140)),
        ((200, 140), (300, 140)),
        ((300, 140), (300, 240)),
        ((300, 240), (100, 240)),
        ((100, 240), (100, 100)),
    )
    result = verdict_of(dieline((CUT, cuts)), dialect=dialect)
    assert {finding.message.code for finding in result.findings} == {"verify.wide-slit"}
    assert result.slit_length[2] == pytest.approx(60.0, abs=0.01)
    # Samples of the outline beyond the slit are at their place on the whole line.
    place = result.samples.place[result.samples.edge == 2]
    assert place.max() == pytest.approx(1.0, abs=0.02)
    assert (np.abs(place - 0.6) < 0.02).any()


def with_lead(angle: float) -> Machine:
    """Return the router's machine with a lead-in of 7 mm at this angle."""
    stations = [
        replace(held, tool=replace(held.tool, approach=angle, lead=7.0))
        if isinstance(held.tool, Cutter)
        else held
        for held in ROUTER.stations
    ]
    return replace(ROUTER, stations=tuple(stations))


@pytest.mark.parametrize("corner", ["B", "C", "D"])
@pytest.mark.parametrize("angle", [-120.0, -90.0, -60.0, -30.0, 30.0, 60.0, 90.0])
def test_lead_ins_of_every_angle_are_accepted(angle: float, corner: str) -> None:
    # A frame with a round window and an L-shaped one, whose corner the tool goes round inside.
    ell = closed((130, 130), (220, 130), (220, 170), (180, 170), (180, 220), (130, 220))
    line = dieline(
        OUTLINE, (CUT, ell), (CUT, ROUND[1] * 0.4 + (220.0, 120.0)), bulge={10: 1, 11: 1}
    )
    machine = with_lead(angle)
    operations = [replace(each, corner=corner) for each in plan(line, machine, BOARD)]
    work = [compensate(operation) for operation in operations]
    text = process(sequence(work, machine), machine, "linuxcnc").text
    result = verify(text, line, (0.0, 0.0), machine, BOARD)
    assert not has_faults(result), result.findings[:3]
    leads = sum(int((path.motion == Motion.LEAD_IN).sum()) for path in work)
    codes = [note.code for path in work for note in path.notes]
    # The disc goes round 90° of the outline and of the L, but the round window has no corner.
    arcs = 2 if -90.0 <= angle < 0.0 else 0
    assert leads == 2 * (3 + arcs)
    # At 30°, there is room for half of some leads of 7 mm only.
    beside = ["lead.shortened"] if angle == 30.0 else []
    round_corners = ["lead.no-corner"] * (2 if angle == -120.0 else 1)
    assert codes == (round_corners if angle < 0.0 else beside)


def test_a_contour_without_room_for_a_lead_in_is_noted() -> None:
    line = dieline((CUT, closed((100, 100), (160, 100), (160, 106.2), (100, 106.2))), FRAME)
    work = [compensate(operation) for operation in plan(line, ROUTER, BOARD)]
    assert [note.code for path in work for note in path.notes] == ["lead.no-room"]


def test_holes_that_the_cutter_does_not_enter_are_shortfalls() -> None:
    line = dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 200), (100, 200))),
        (LineType.CUT, closed((130, 120), (135, 120), (135, 170), (130, 170))),
        # All points of this hole are nearer to the cut round the part than the cutter's radius.
        (LineType.CUT, closed((100.3, 120), (101.8, 120), (101.8, 121.5), (100.3, 121.5))),
        (LineType.CUT, edges(((150, 150), (154, 150)), ((154, 150), (150, 150)))),
        (LineType.CREASE, edges(((200, 120), (200, 180)))),
        bulge={12: 1.0, 13: 1.0},
    )
    toolpath = sequence([compensate(operation) for operation in plan(line, ROUTER, BOARD)], ROUTER)
    result = verify(process(toolpath, ROUTER).text, line, (0.0, 0.0), ROUTER, BOARD)
    assert not has_faults(result), result.findings[:3]
    refused = [(one.edge, one.message.code) for one in result.findings if one.refuses]
    assert sorted(refused) == [(edge, "verify.contour-unreached") for edge in range(4, 14)]
    assert with_exceptions(result, refused, Acceptance("Ada", "punched by hand", 0.0)).accepted


def nested(x: float, y: float, *more: tuple[LineType, F64]) -> Dieline:
    """Return a part of 60 × 40 mm in a hole of 100 × 80 mm, at a position in the hole."""
    right, top = 120 + x + 60, 120 + y + 40
    return dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
        (LineType.CUT, closed((120, 120), (220, 120), (220, 200), (120, 200))),
        (LineType.CUT, closed((120 + x, 120 + y), (right, 120 + y), (right, top), (120 + x, top))),
        *more,
    )


@pytest.mark.parametrize("y", [2.0, 5.0, 7.0, 20.0])
@pytest.mark.parametrize("x", [2.0, 5.5, 12.0])
def test_a_part_near_the_hole_in_which_it_lies_is_milled_as_far_as_the_cutter_fits(
    x: float, y: float
) -> None:
    line = nested(x, y)
    toolpath = sequence([compensate(operation) for operation in plan(line, ROUTER, BOARD)], ROUTER)
    result = verify(process(toolpath, ROUTER).text, line, (0.0, 0.0), ROUTER, BOARD)
    assert not has_faults(result), result.findings[:3]
    # The left and the lower side of the part, and the facing sides of the hole.
    shortfall = {edge for edge in (8, 11) if result.unreached[edge] > 30.0}
    assert shortfall == {edge for edge, gap in ((8, y), (11, x)) if gap < 6.0}


def test_a_part_in_a_hole_that_is_too_narrow_all_round_is_left_out() -> None:
    line = dieline(
        (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
        (LineType.CUT, closed((120, 120), (180, 120), (180, 180), (120, 180))),
        (LineType.CUT, closed((122, 122), (178, 122), (178, 178), (122, 178))),
    )
    toolpath = sequence([compensate(operation) for operation in plan(line, ROUTER, BOARD)], ROUTER)
    result = verify(process(toolpath, ROUTER).text, line, (0.0, 0.0), ROUTER, BOARD)
    assert not has_faults(result), result.findings[:3]
    refused = {
        one.edge: one.message.code
        for one in result.findings
        if one.refuses and one.kind != "near"  # the two contours are 2 mm apart
    }
    assert refused == dict.fromkeys(range(4, 12), "verify.contour-unreached")
    # The strip round the part, without the part: one outline, with a line to the part and back.
    assert result.areas.area.tolist() == pytest.approx([60.0**2 - 56.0**2])
    assert len(result.areas.bulge) == 4 + 1 + 4 + 1
    start, end = result.areas.ends[:, 0], result.areas.ends[:, 1]
    np.testing.assert_allclose(end, np.roll(start, -1, axis=0))


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("excess", [-5e-4, -1e-6, 0.0, 6e-7, 2e-5, 5e-4, 2e-3])
def test_a_round_hole_as_wide_as_the_cutter_is_made(excess: float, dialect: str) -> None:
    right = 156.0 + 2.0 * excess
    hole = edges(((150, 150), (right, 150)), ((right, 150), (150, 150)))
    line = dieline(FRAME, (CUT, hole), bulge={4: 1.0, 5: 1.0})
    result = verdict_of(line, dialect=dialect)
    assert not result.findings
    # Without the hole in the program, its edges are shortfalls or faults.
    work = [compensate(operation) for operation in plan(dieline(FRAME), ROUTER, BOARD)]
    text = process(sequence(work, ROUTER), ROUTER, dialect).text
    assert {one.edge for one in verify(text, line, (0.0, 0.0), ROUTER, BOARD).findings} >= {4, 5}


@pytest.mark.parametrize("shift", [-1e-5, 0.0, 1e-5])
def test_a_round_hole_is_made_if_the_centre_crosses_it_on_a_line(shift: float) -> None:
    # The circle of the centre is written as lines.  One of them goes through its middle, so
    # rounding decides on which half of the circle its points are.
    y = 150.0 + shift
    hole = edges(((150, y), (156.003, y)), ((156.003, y), (150, y)))
    line = dieline(FRAME, (CUT, hole), bulge={4: 1.0, 5: 1.0})
    assert not verdict_of(line, dialect="linuxcnc").findings


@pytest.mark.parametrize("excess", [0.0, 0.0015])
def test_a_round_hole_beside_which_the_cutter_plunges_is_refused(
    monkeypatch: pytest.MonkeyPatch, excess: float
) -> None:
    right = 156.0 + 2.0 * excess
    hole = edges(((150, 150), (right, 150)), ((right, 150), (150, 150)))
    line = dieline(FRAME, (CUT, hole), bulge={4: 1.0, 5: 1.0})
    widened = original(centre_paths, "_widen_round_holes")

    def moved(paths: Paths, distance: float, side: int) -> Paths:
        paths = widened(paths, distance, side)
        shift = np.where((np.abs(paths.bulge) > 0.5)[:, None], (0.012, 0.0), 0.0)
        return replace(paths, start=paths.start + shift, end=paths.end + shift)

    monkeypatch.setattr(centre_paths, "_widen_round_holes", moved)
    assert {one.edge for one in verdict_of(line).findings if one.refuses} & {4, 5}


@pytest.mark.parametrize(
    ("shift", "fit_error", "is_refused"),
    [(0.004, 0.0, False), (0.001, 0.0075, False), (0.004, 0.0075, True)],
)
def test_the_cutter_passes_a_round_hole_by_what_the_fit_of_its_arcs_leaves(
    monkeypatch: pytest.MonkeyPatch, shift: float, fit_error: float, is_refused: bool
) -> None:
    hole = edges(((150, 150), (156, 150)), ((156, 150), (150, 150)))
    line = dieline(FRAME, (CUT, hole), bulge={4: 1.0, 5: 1.0})
    line = replace(line, fit_error=np.repeat([0.0, fit_error], [4, 2]))
    widened = original(centre_paths, "_widen_round_holes")

    def moved(paths: Paths, distance: float, side: int) -> Paths:
        paths = widened(paths, distance, side)
        by = np.where((np.abs(paths.bulge) > 0.5)[:, None], (shift, 0.0), 0.0)
        return replace(paths, start=paths.start + by, end=paths.end + by)

    monkeypatch.setattr(centre_paths, "_widen_round_holes", moved)
    refused = {one.edge for one in verdict_of(line).findings if one.refuses}
    assert bool(refused & {4, 5}) == is_refused


def test_an_arc_round_a_corner_beside_another_edge_is_no_deviation_from_it() -> None:
    # The slot is as wide as the cutter at its mouth and narrower inside.  The centre goes in by
    # 0.04 mm along the slanted side, and back on the arc round the corner of the other side.
    left = closed((100, 60), (200, 60), (200, 120), (131.64, 120), (131.64, 123), (200, 126),
                  (200, 190), (100, 190))  # fmt: skip
    right = np.array([(403.0, 0.0)]) + left * (-1.0, 1.0)
    result = verdict_of(dieline((CUT, left), (CUT, right)))
    assert not has_faults(result), result.findings[:3]


def test_a_panel_between_open_ones_ends_beside_the_sheet() -> None:
    # Gaps of 0.3 mm make the outlines of the outer panels slits, which are made before the middle
    # panel.  If its path ended between two panels, the sheet would hold neither of them.
    outline = edges(
        ((160, 100), (160, 120)), ((160, 120.3), (160, 200)), ((160, 200.3), (160, 260)),
        ((160, 260), (100, 260)), ((100, 260), (100, 100)), ((100, 100), (160, 100)),
    )  # fmt: skip
    folds = edges(((100, 150), (160, 150)), ((160, 170), (100, 170)))
    line, laser = dieline((CUT, outline), (CUT, folds)), load.machine("laser-table")
    (contour,) = (each for each in plan(line, laser, BOARD) if each.side)
    assert sorted(contour.source[contour.endable].tolist()) == [1, 4]
    result = verdict_of(line, dialect="grblhal", machine=laser)
    assert not has_faults(result), result.findings[:3]


@pytest.mark.parametrize("name", ["router-table", "laser-table"])
def test_a_slit_on_which_other_slits_end_is_accepted(name: str) -> None:
    # Each piece between the ends is shorter than half of the slit.
    slits = edges(((150, 120), (150, 180)), ((150, 140), (90, 140)), ((150, 160), (200, 160)))
    result = verdict_of(dieline(FRAME, (CUT, slits)), machine=load.machine(name))
    assert not has_faults(result), result.findings[:3]


def test_leads_may_cross_a_crease_after_the_first_cut_of_its_outline() -> None:
    # In the hole the lead-outs of all passes but the last one cross the creases.
    stations = [
        replace(held, tool=replace(held.tool, step=1.2)) if isinstance(held.tool, Cutter) else held
        for held in ROUTER.stations
    ]
    machine = replace(ROUTER, stations=tuple(stations))
    hole = closed((120, 100), (180, 100), (180, 160), (120, 160))
    creases = edges(((130, 104), (170, 104)), ((130, 156), (170, 156)),
                    ((124, 110), (124, 150)), ((176, 110), (176, 150)))  # fmt: skip
    result = verdict_of(dieline(FRAME, (CUT, hole), (LineType.CREASE, creases)), machine=machine)
    assert not has_faults(result), result.findings[:3]


@pytest.mark.parametrize("excess", [-1e-9, 1e-9])
def test_rounded_corners_with_the_radius_of_the_cutter_are_made(excess: float) -> None:
    r = 3.0 + excess
    hole = closed((120 + r, 100), (180 - r, 100), (180, 100 + r), (180, 160 - r),
                  (180 - r, 160), (120 + r, 160), (120, 160 - r), (120, 100 + r))  # fmt: skip
    bend = dict.fromkeys((5, 7, 9, 11), math.tan(math.pi / 8.0))
    result = verdict_of(dieline(FRAME, (CUT, hole), bulge=bend))
    assert not has_faults(result), result.findings[:3]


def test_a_disc_may_touch_a_cut_in_a_loose_piece_but_not_make_it_again() -> None:
    # The square has gaps at its corners, so it is cut on its line.  On its way round the small
    # contour, which is cut after it, the disc touches the end of the slit in the square.
    square = edges(((50.1, 20), (149.9, 20)), ((150, 20.1), (150, 79.9)),
                   ((149.9, 80), (50.1, 80)), ((50, 79.9), (50, 20.1)))  # fmt: skip
    slit = edges(((50.1, 50), (149.9, 50)))
    small = closed((49.9, 53), (49.94, 53), (49.94, 53.04), (49.9, 53.04))
    line = dieline((CUT, square), (CUT, slit), (CUT, small))
    assert not has_faults(verdict_of(line))
    work = [compensate(operation) for operation in plan(line, ROUTER, BOARD)]
    text = process(sequence([*work, *work[:1]], ROUTER), ROUTER, "linuxcnc").text
    repeated = verify(text, line, (0.0, 0.0), ROUTER, BOARD)
    late = [one for one in repeated.findings if one.message.code == "verify.loose-piece"]
    assert [one.edge for one in late] == [4]


@pytest.mark.parametrize("mouth", [2.0, 5.0, 5.9])
def test_a_bay_with_a_narrow_mouth_is_milled_before_the_path_round_its_part(
    monkeypatch: pytest.MonkeyPatch, mouth: float
) -> None:
    # The path round the part begins nearer to the parking position than that in the bay.
    left = 380 - mouth
    part = closed((100, 100), (400, 100), (400, 180), (380, 180), (380, 178), (395, 178),
                  (395, 130), (320, 130), (320, 178), (left, 178), (left, 180),
                  (100, 180))  # fmt: skip
    line = dieline((CUT, part))
    assert not has_faults(verdict_of(line))
    monkeypatch.setattr(order, "split_enclosed", lambda toolpath, _tool: [toolpath])
    late = [one for one in verdict_of(line).findings if one.severity is Severity.FAULT]
    assert {one.message.code for one in late} == {"verify.loose-piece"}
    assert {one.edge for one in late} == {4, 5, 6, 7, 8}


def test_a_bay_that_the_cutter_leaves_through_its_mouth_is_one_path() -> None:
    part = closed((100, 100), (400, 100), (400, 180), (380, 180), (380, 178), (395, 178),
                  (395, 130), (320, 130), (320, 178), (373.9, 178), (373.9, 180),
                  (100, 180))  # fmt: skip
    assert not has_faults(verdict_of(dieline((CUT, part))))
