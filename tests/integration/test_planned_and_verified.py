"""What planning adds to a drawing, from plan to verdict: run-outs, passes, bridges, folds."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.cleaning.clean import clean
from knifetip.errors import FlankOutside
from knifetip.geometry.columns import F64, Bool
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.verdict import Finding, Severity, Verdict
from knifetip.planning import blade_operations, crease_operations, groove_operations
from knifetip.verification.verify import verify
from tests.support.modules import original
from tests.support.shapes import closed, dieline, edges, with_dimensions

MACHINE, BOARD = load.machine("demo-table"), load.board("greyboard-2.0")
OUTLINE = (LineType.CUT, closed((100, 100), (400, 100), (400, 300), (100, 300)))
ROUND = edges(((100, 200), (300, 200)), ((300, 200), (100, 200)))
CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE


def verdict_of(line: Dieline, machine: Machine = MACHINE, **asked: Any) -> Verdict:
    board = replace(BOARD, **asked)
    operations = plan(line, machine, board)
    toolpath = sequence([compensate(operation) for operation in operations], machine)
    text = process(toolpath, machine, "grblhal").text
    return verify(text, line, (0.0, 0.0), machine, board)


def faults(verdict: Verdict) -> list[Finding]:
    """Return the findings that a user cannot accept."""
    return [finding for finding in verdict.findings if finding.severity is Severity.FAULT]


@pytest.mark.parametrize("degrees", [7.0, 20.0, 45.0, 70.0, 90.0])
@pytest.mark.parametrize("step", [0.0, 0.5])
def test_a_groove_that_meets_the_edge_at_any_angle(degrees: float, step: float) -> None:
    reach = 40.0 / np.tan(np.radians(degrees)) if degrees < 90.0 else 0.0
    start = 120.0 if reach > 200.0 else 150.0
    # The groove starts at most 40 mm below the top edge and ends on it.
    share = min(1.0, 200.0 / max(reach, 1.0))
    groove = edges(((start, 300 - 40 * share), (start + reach * share, 300)))
    verdict = verdict_of(dieline(OUTLINE, (GROOVE, groove)), groove_pass=step)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize(
    ("kind", "ends", "code"),
    [
        (CUT, (((200, 200), (200.4, 200)),), "verify.cut-too-short"),
        (CUT, (((200, 200), (200.2, 200)), ((200.2, 200), (200.2, 200.2))), "verify.cut-too-short"),
        (LineType.HALF_CUT, (((200, 200), (200.1, 200)),), "verify.cut-too-short"),
        (GROOVE, (((200, 200), (200.8, 200)),), "verify.groove-too-short"),
    ],
)
def test_an_edge_that_is_too_short_for_the_tool_is_a_shortfall(
    kind: LineType, ends: Any, code: str
) -> None:
    other = (CREASE, edges(((150, 110), (150, 290))))
    verdict = verdict_of(dieline(OUTLINE, (kind, edges(*ends)), other))
    assert faults(verdict) == []
    found = {
        (finding.edge, finding.message.code)
        for finding in verdict.findings
        if finding.severity is Severity.SHORTFALL
    }
    assert found == {(4 + place, code) for place in range(len(ends))}


@pytest.mark.parametrize(
    ("kind", "long", "least"), [(CUT, 0.45, 0.41), (LineType.HALF_CUT, 0.2, 0.18), (GROOVE, 3.2, 3)]
)
def test_an_edge_that_is_left_out_although_the_tool_can_make_it_is_a_fault(
    kind: LineType, long: float, least: float
) -> None:
    assert long > least
    line = dieline(OUTLINE, (kind, edges(((200, 200), (200 + long, 200)))))
    whole = plan(line, MACHINE, BOARD)
    text = process(
        sequence([compensate(some) for some in whole if 4 not in some.source], MACHINE), MACHINE,
        "grblhal",
    ).text  # fmt: skip
    found = faults(verify(text, line, (0.0, 0.0), MACHINE, BOARD))
    assert {finding.message.code for finding in found} == {"verify.not-worked"}


@pytest.mark.parametrize("kind", [CUT, LineType.HALF_CUT])
def test_a_stub_shorter_than_the_lead_of_the_blade_is_made_if_the_cut_can_start_there(
    kind: LineType,
) -> None:
    # At the start the blade enters exactly.
    slit = ((150, 200), (250, 200)), ((250, 200), (250, 200.15))
    for ends in (slit, [end[::-1] for end in slit[::-1]]):
        verdict = verdict_of(dieline(OUTLINE, (kind, edges(*ends))))
        assert not [one for one in verdict.findings if one.severity is not Severity.NOTE]


def u_shape(stub: float) -> Dieline:
    """Return a blank with a slit that has a stub at both ends."""
    first = ((150, 200 + stub), (150, 200))
    slit = edges(first, ((150, 200), (250, 200)), ((250, 200), (250, 200 + stub)))
    return dieline(OUTLINE, (CUT, slit))


def test_a_stub_shorter_than_the_lead_of_the_blade_at_the_finish_is_a_shortfall() -> None:
    # The lead is (2 + 0.3) tan 10° = 0.4055 mm.
    (finding,) = verdict_of(u_shape(0.4)).findings
    assert finding.severity is Severity.SHORTFALL
    assert finding.message.code == "verify.stub-too-short"
    assert finding.edge == 6
    assert finding.measure == pytest.approx(0.4)
    assert verdict_of(u_shape(0.41)).accepted


def test_a_knife_that_stops_before_the_corner_of_a_stub_is_refused() -> None:
    line = u_shape(0.4)
    text = process(
        sequence([compensate(some) for some in plan(line, MACHINE, BOARD)], MACHINE), MACHINE,
        "grblhal",
    ).text  # fmt: skip
    assert text.count(b"X250.0000") == 1
    found = faults(
        verify(text.replace(b"X250.0000", b"X249.9945"), line, (0.0, 0.0), MACHINE, BOARD)
    )
    assert {finding.message.code for finding in found} == set()
    found = faults(
        verify(text.replace(b"X250.0000", b"X249.9000"), line, (0.0, 0.0), MACHINE, BOARD)
    )
    assert "verify.comes-out-short" in {finding.message.code for finding in found}


NOTCHED = (CUT, closed((100, 100), (400, 100), (400, 300), (270, 300), (250, 260), (230, 300),
                       (100, 300)))  # fmt: skip
PLUS = (CUT, closed((200, 100), (300, 100), (300, 200), (400, 200), (400, 300), (200, 300)))


@pytest.mark.parametrize(
    ("outline", "groove"),
    [
        (NOTCHED, ((250, 120), (250, 260))),
        (NOTCHED, ((240, 160), (250, 260))),
        (NOTCHED, ((200, 200), (250, 260))),
        (PLUS, ((220, 280), (300, 200))),
        (OUTLINE, ((400, 300), (300, 180))),
    ],
    ids=[
        "notch",
        "notch, slanted",
        "meets the edge of the board at an angle of only",
        "inner corner",
        "outer corner",
    ],
)
def test_a_groove_that_ends_at_a_corner_of_the_board(
    outline: tuple[LineType, F64], groove: tuple[tuple[int, int], tuple[int, int]]
) -> None:
    verdict = verdict_of(dieline(outline, (GROOVE, edges(groove))))
    assert verdict.accepted, verdict.findings[:2]


def test_a_groove_that_does_not_run_out_into_a_notch_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    line = dieline(NOTCHED, (GROOVE, edges(((250, 120), (250, 260)))))
    right = original(groove_operations, "run_out_lengths")

    def stopped(*args: object) -> tuple[F64, Bool]:
        size, on_edge = right(*args)
        return 0.0 * size, on_edge

    monkeypatch.setattr(groove_operations, "run_out_lengths", stopped)
    assert not verdict_of(line).accepted


@pytest.mark.parametrize(
    "cut",
    [((250, 100), (250, 300)), ((250, 200.04), (250, 300)), ((200, 130), (300, 270))],
    ids=["common edge of two blanks", "ends on the groove", "slanted"],
)
def test_a_groove_that_a_cut_crosses(cut: tuple[tuple[int, float], tuple[int, int]]) -> None:
    line = dieline(OUTLINE, (GROOVE, edges(((100, 200), (400, 200)))), (CUT, edges(cut)))
    verdict = verdict_of(line)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("factor", [0.0, 0.8])
def test_a_groove_that_does_not_run_out_far_enough_is_refused(
    monkeypatch: pytest.MonkeyPatch, factor: float
) -> None:
    line = dieline(OUTLINE, (GROOVE, edges(((200, 200), (300, 300)))))
    assert verdict_of(line).accepted
    right = original(groove_operations, "run_out_lengths")

    def short(*args: object) -> tuple[F64, Bool]:
        size, on_edge = right(*args)
        return factor * size, on_edge

    monkeypatch.setattr(groove_operations, "run_out_lengths", short)
    assert not verdict_of(line).accepted


def test_a_curved_groove_within_the_error_that_the_board_allows() -> None:
    line = dieline(OUTLINE, (GROOVE, edges(((120, 150), (380, 150)))), bulge={4: 0.1})
    assert verdict_of(line, groove_curve=0.1).accepted


@pytest.mark.parametrize(
    ("contour", "bulge"),
    [
        (OUTLINE[1], {}),
        (ROUND, {0: 1.0, 1: 1.0}),
        (closed((100, 100), (400, 100), (380, 300), (110, 290)), {}),
    ],
    ids=["blank", "disc", "slanted"],
)
def test_a_part_held_by_bridges(contour: F64, bulge: dict[int, float]) -> None:
    line = dieline((CUT, contour), bulge=bulge)
    verdict = verdict_of(line, bridge_width=0.8, bridge_spacing=200.0)
    assert verdict.accepted, verdict.findings[:2]


def test_an_outline_begun_and_ended_in_the_waste() -> None:
    knife = with_dimensions(MACHINE.stations[0].tool, lead_in=5.0, lead_out=5.0)
    stations = (replace(MACHINE.stations[0], tool=knife), *MACHINE.stations[1:])
    verdict = verdict_of(dieline(OUTLINE), replace(MACHINE, stations=stations))
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("apart", [0.0, 3.0])
def test_creases_crossed_dashed_and_drawn_twice(apart: float) -> None:
    dashes = edges(*[((150 + 9 * i, 150), (156 + 9 * i, 150)) for i in range(10)])
    line = dieline(
        OUTLINE,
        (CREASE, dashes),
        (CREASE, edges(((150, 200), (250, 200)), ((300, 200), (200, 200)))),
        (CREASE, edges(((150, 250), (250, 280)))),
        (CUT, edges(((200, 235), (200, 285)))),
    )
    verdict = verdict_of(line, double_crease=apart)
    assert verdict.accepted, verdict.findings[:2]


def dashes(count: int, length: float, gap: float) -> F64:
    """Return a row of dashes along y = 150, (n, 2, 2)."""
    step = length + gap
    return edges(*[((150 + step * i, 150), (150 + step * i + length, 150)) for i in range(count)])


@pytest.mark.parametrize("short", ["press", "refuse"])
@pytest.mark.parametrize(
    "row",
    [(10, 3.0, 3.0), (20, 1.0, 1.0), (10, 3.0, 4.4), (3, 3.0, 3.0), (10, 0.5, 0.5)],
    ids=str,
)
def test_dashes_shorter_than_the_setback_are_one_crease(
    row: tuple[int, float, float], short: str
) -> None:
    # The wheel's setback is 5.1 mm at both ends of the row.
    verdict = verdict_of(dieline(OUTLINE, (CREASE, dashes(*row))), short_crease=short)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("row", [(2, 3.0, 3.0), (10, 3.0, 4.6), (5, 1.0, 1.0)], ids=str)
def test_short_creases_and_short_rows_of_dashes_are_pressed(row: tuple[int, float, float]) -> None:
    verdict = verdict_of(dieline(OUTLINE, (CREASE, dashes(*row))), short_crease="press")
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize(
    "cut",
    [
        ((176.5, 130), (176.5, 170)),
        ((180, 130), (180, 170)),
        ((176.5, 130), (176.5, 150), (170, 170)),
        ((180, 130), (180, 150), (190, 170)),
        ((176.5, 130), (176.5, 150)),
        ((180, 130), (180, 150)),
    ],
    ids=["gap", "dash", "vertex in a gap", "vertex on a dash", "ends in a gap", "ends on a dash"],
)
def test_dashes_and_a_cut(cut: tuple[tuple[float, int], ...]) -> None:
    line = dieline(OUTLINE, (CREASE, dashes(10, 4.0, 3.0)), (CUT, edges(*pairwise(cut))))
    verdict = verdict_of(line)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize(
    ("ends", "cuts"),
    [
        ((150, 200, 200.3, 250, 250.3, 300), (200.4,)),
        ((150, 200, 200.3, 250, 250.3, 300), (199.9,)),
        ((150, 200, 200.3, 250, 250.3, 300), (200.4, 249.9)),
        ((150, 200, 200.3, 250, 250.3, 300, 303, 350), (304.0,)),
        ((150, 200, 200.3, 250, 253.3, 300), (254.0,)),
    ],
    ids=["after a gap", "before a gap", "beside both gaps", "at a wide gap", "two wide gaps"],
)
def test_a_cut_through_a_crease_so_near_a_gap_that_the_wheel_stops_before_both(
    ends: tuple[float, ...], cuts: tuple[float, ...]
) -> None:
    creases = edges(*[((a, 150), (b, 150)) for a, b in zip(ends[::2], ends[1::2], strict=True)])
    crossing = edges(*[((x, 130), (x, 170)) for x in cuts])
    verdict = verdict_of(dieline(OUTLINE, (CREASE, creases), (CUT, crossing)))
    # Beside a gap that is none between dashes, 1 mm of crease is too short for the wheel.
    faults = [each for each in verdict.findings if each.severity is Severity.FAULT]
    assert not faults, faults[:2]


def test_a_crease_that_a_cut_goes_through_at_a_vertex(monkeypatch: pytest.MonkeyPatch) -> None:
    cut = edges(((200, 130), (200, 150)), ((200, 150), (210, 170)))
    line = dieline(OUTLINE, (CREASE, edges(((150, 150), (300, 150)))), (CUT, cut))
    assert verdict_of(line).accepted
    right = original(crease_operations, "split_at_cuts")
    monkeypatch.setattr(
        crease_operations,
        "split_at_cuts",
        lambda paths, _ends, _bulge, closed: right(paths, cut[:0], cut[:0, 0, 0], closed),
    )
    assert not verdict_of(line).accepted


CROSSING = ((200, 130), (200, 170)), ((200, 130), (200, 150), (230, 170))


@pytest.mark.parametrize("past", [-0.06, -0.05, -0.035, 0.001, 0.035, 0.05, 0.06])
@pytest.mark.parametrize("cut", CROSSING, ids=["straight", "vertex"])
@pytest.mark.parametrize(
    "turned", [(False, False), (True, False), (False, True), (True, True)], ids=str
)
def test_a_cut_that_crosses_creases_near_their_joint(
    past: float, cut: tuple[tuple[int, int], ...], turned: tuple[bool, bool]
) -> None:
    joint = (200.0 + past, 150)
    creases = edges(((120, 150), joint), (joint, (350, 150)))
    creases = np.where(np.array(turned)[:, None, None], creases[:, ::-1], creases)
    verdict = verdict_of(dieline(OUTLINE, (CREASE, creases), (CUT, edges(*pairwise(cut)))))
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("stub", [0.01, 0.04, 0.05, 0.06])
def test_a_crease_with_a_joint_near_the_cuts_at_its_end(stub: float) -> None:
    cuts = edges(((180, 150), (200, 150)), ((200, 150), (220, 150)))
    creases = edges(((200, 150), (200, 150 + stub)), ((200, 150 + stub), (200, 220)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, creases), (CUT, cuts)))
    assert verdict.accepted, verdict.findings[:2]


def test_cuts_that_end_on_both_sides_of_a_joint_of_creases() -> None:
    cuts = edges(((200, 150), (200, 160)), ((200.06, 150), (200.06, 140)))
    creases = edges(((120, 150), (200.03, 150)), ((200.03, 150), (300, 150)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, creases), (CUT, cuts)))
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("past", [-0.06, -0.05, -0.01, 0.0, 0.01, 0.05, 0.05001, 0.06])
@pytest.mark.parametrize("shift", [0.0, 0.1, 0.7, 1.3])
def test_a_crease_that_ends_a_little_before_or_behind_a_cut(past: float, shift: float) -> None:
    crease = edges(((120 + shift, 150), (200 + shift + past, 150)))
    cut = edges(((200 + shift, 130), (200 + shift, 170)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, crease), (CUT, cut)), short_crease="press")
    assert not faults(verdict), verdict.findings[:2]


@pytest.mark.parametrize("apart", [0.0, 0.03, 0.05, 0.06])
def test_cuts_that_end_on_both_sides_of_a_crease_side_by_side(apart: float) -> None:
    cuts = edges(((200, 130), (200, 150)), ((200 + apart, 150), (200 + apart, 170)))
    for crease in edges(((120, 150), (350, 150)), ((350, 150), (120, 150))):
        verdict = verdict_of(dieline(OUTLINE, (CREASE, crease[None]), (CUT, cuts)))
        assert verdict.accepted, verdict.findings[:2]


def test_a_row_of_creases_with_gaps_of_which_only_some_are_alike() -> None:
    ends = ((120, 170), (170.38, 190), (190.72, 230), (230.79, 300), (300.54, 340))
    row = edges(*[((low, 150), (high, 150)) for low, high in ends])
    cut = edges(((231.14, 130), (231.14, 170)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, row), (CUT, cut)), short_crease="press")
    assert not faults(verdict), verdict.findings[:2]


def test_creases_that_are_drawn_a_little_into_the_slots_between_them() -> None:
    ends = ((120, 200.3), (204.8, 260.2), (264.7, 340))
    row = edges(*[((low, 150), (high, 150)) for low, high in ends])
    slots = [(CUT, edges(((x, 130), (x, 152)))) for x in (200, 205, 260, 265)]
    verdict = verdict_of(dieline(OUTLINE, (CREASE, row), *slots), short_crease="press")
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize(("behind", "stated"), [(0.3, False), (5.0, True)])
def test_the_end_of_a_crease_behind_a_cut_is_a_shortfall_if_it_is_long(
    behind: float, stated: bool
) -> None:
    crease = edges(((120, 150), (200 + behind, 150)))
    cut = edges(((200, 130), (200, 170)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, crease), (CUT, cut)), short_crease="refuse")
    codes = {finding.message.code for finding in verdict.findings}
    assert "verify.crease-stops-at-cut" in codes
    assert ("verify.crease-too-short" in codes) == stated


#: An S of two arcs and a half circle: the depth changes along them.
CURVED = (
    CREASE,
    edges(((150, 150), (210, 190)), ((210, 190), (270, 230)), ((300, 200), (300, 250))),
)
BOARD_DEPTHS = ("caliper", "crease_along", "crease_across")


@pytest.mark.parametrize("board", ["fbb-0.4", "greyboard-2.0", "greyboard-3.0", "b-flute"])
def test_a_crease_on_a_curve_is_as_deep_as_its_tangent_requires(board: str) -> None:
    line = dieline(OUTLINE, CURVED, bulge={4: 0.4, 5: -0.4, 6: 1.0})
    values = load.board(board)
    verdict = verdict_of(line, **{name: getattr(values, name) for name in BOARD_DEPTHS})
    assert faults(verdict) == [], verdict.findings[:2]


@pytest.mark.parametrize("board", ["fbb-0.4", "greyboard-3.0", "b-flute"])
@pytest.mark.parametrize("turn", [0.2, 0.5, 0.9, -0.9])
def test_a_crease_along_the_chords_of_a_curve_is_accepted(board: str, turn: float) -> None:
    # From 45° to the grain on, the depth changes with every chord, up or down.
    direction = np.radians(45.0 + turn * np.arange(40))
    steps = 2.5 * np.stack([np.cos(direction), np.sin(direction)], axis=1)
    corners = np.cumsum(np.concatenate([np.array([[150.0, 130.0]]), steps]), axis=0)
    chords = np.stack([corners[:-1], corners[1:]], axis=1)
    values = load.board(board)
    verdict = verdict_of(
        dieline(OUTLINE, (CREASE, chords)),
        **{name: getattr(values, name) for name in BOARD_DEPTHS},
    )
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("degrees", [60.0, 180.0])
def test_a_crease_of_one_depth_along_a_curve_is_refused(
    monkeypatch: pytest.MonkeyPatch, degrees: float
) -> None:
    bulge = float(np.tan(np.radians(degrees) / 4.0))
    line = dieline(OUTLINE, (CREASE, edges(((150, 150), (250, 150)))), bulge={4: bulge})
    assert verdict_of(line).accepted
    monkeypatch.setattr(crease_operations, "_DEPTH_ERROR", 1.0)
    assert {one.kind for one in verdict_of(line).findings if one.refuses} == {"depth"}


#: A slit inside the outline, on which other cuts end.
SLIT = (CUT, edges(((150, 200), (350, 200))))


@pytest.mark.parametrize(
    ("outline", "cuts", "past"),
    [
        (OUTLINE, [((250, 150), (250, 200))], 0.0),
        (OUTLINE, [((250, 200), (250, 150)), ((250, 200), (250, 260))], 0.0),
        (OUTLINE, [((250, 200), (300, 280)), ((180, 220), (150, 200))], 0.0),
        (OUTLINE, [((250, 200), (250, 300))], 0.3527),
        (OUTLINE, [((250, 80), (250, 100)), ((250, 400), (250, 300))], 0.0),  # from the waste
        (OUTLINE, [((370, 250), (400, 300))], 0.3527),  # to an outer corner
        (NOTCHED, [((250, 220), (250, 260))], 0.3527),
        (NOTCHED, [((200, 240), (250, 260))], 0.0),  # at the notch, towards the panel behind it
        (OUTLINE, [((250, 150), (250, 250))], 0.0),  # a crossing
    ],
)
def test_a_knife_does_not_cut_the_panel_behind_a_slit(
    outline: tuple[LineType, F64], cuts: list[Any], past: float
) -> None:
    line = dieline(outline, SLIT, (CUT, edges(*cuts)))
    verdict = verdict_of(line)
    assert verdict.accepted, verdict.findings[:2]
    ended = np.arange(len(line) - len(cuts), len(line))
    assert verdict.overcut[ended].max() == pytest.approx(past, abs=1e-3)


def test_the_verifier_refuses_a_tip_that_passes_a_slit(monkeypatch: pytest.MonkeyPatch) -> None:
    line = dieline(OUTLINE, SLIT, (CUT, edges(((250, 150), (250, 200)))))
    monkeypatch.setattr(
        blade_operations, "ends_at_waste", lambda points, *_: np.ones(len(points), np.bool_)
    )
    verdict = verdict_of(line)
    assert not verdict.accepted
    assert (verdict.findings[0].kind, verdict.findings[0].edge) == ("overcut", 5)
    assert verdict.findings[0].measure == pytest.approx(0.3527, abs=1e-3)


@pytest.mark.parametrize("over", [0.003, 0.02, 0.05, 0.1, 0.45, 3.0, 12.0, 20.0, 30.0])
@pytest.mark.parametrize("pair", [0.0, 2.0])
def test_a_crease_drawn_over_the_outline(over: float, pair: float) -> None:
    drawn = dieline(OUTLINE, (CREASE, edges(((200.1, 100 - over), (200.1, 300 + over)))))
    verdict = verdict_of(clean(drawn).dieline, double_crease=pair)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("over", [0.003, 0.02, 0.05, 0.1, 0.45, 3.0, 20.0])
@pytest.mark.parametrize("step", [0.0, 0.5])
def test_a_groove_drawn_over_the_outline(over: float, step: float) -> None:
    drawn = dieline(OUTLINE, (GROOVE, edges(((200.1, 100 - over), (210.1, 300 + over)))))
    verdict = verdict_of(clean(drawn).dieline, groove_pass=step)
    assert verdict.accepted, verdict.findings[:2]


@pytest.mark.parametrize("kind", [CREASE, GROOVE])
def test_a_fold_across_a_narrow_window(kind: LineType) -> None:
    window = (CUT, closed((200, 180), (208, 180), (208, 220), (200, 220)))
    drawn = dieline(OUTLINE, window, (kind, edges(((100, 200), (400, 200)))))
    verdict = verdict_of(clean(drawn).dieline)
    assert verdict.accepted, verdict.findings[:2]


def test_a_row_of_dashes_drawn_over_the_outline() -> None:
    row = edges(*[((99 + 6 * k, 150), (103 + 6 * k, 150)) for k in range(20)])
    verdict = verdict_of(clean(dieline(OUTLINE, (CREASE, row))).dieline)
    assert verdict.accepted, verdict.findings[:2]


def notes_of(verdict: Verdict, code: str) -> list[dict[str, Any]]:
    return [
        dict(each.message.arguments)
        for each in verdict.findings
        if each.message.code == code and each.severity == Severity.NOTE
    ]


@pytest.mark.parametrize("pair", [0.0, 2.0])
def test_notes_about_cuts_at_creases(pair: float) -> None:
    cuts = edges(((200, 130), (200, 170)), ((250, 150), (250, 200)), ((150, 250), (150, 270)))
    creases = edges(((150, 150), (300, 150)), ((150, 160), (300, 160)), ((150, 240), (300, 240)))
    verdict = verdict_of(dieline(OUTLINE, (CREASE, creases), (CUT, cuts)), double_crease=pair)
    assert verdict.accepted, verdict.findings[:2]
    (stop,) = notes_of(verdict, "verify.crease-stops-at-cut")
    assert stop["count"] == 2
    assert stop["distance"] == pytest.approx(np.sqrt(0.6 * 29.4) + BOARD.end_clearance, abs=0.5)
    # The cut at x = 250 ends on the first crease from above, and crosses the second one.
    assert notes_of(verdict, "verify.crease-meets-cuts") == [{"count": 1}]


def test_no_notes_about_creases_that_end_on_cuts() -> None:
    verdict = verdict_of(dieline(OUTLINE, (CREASE, edges(((100, 200), (400, 200))))))
    assert verdict.accepted
    assert verdict.findings == ()


@pytest.mark.parametrize("others", [[], [((150, 150), (300, 150))]])
def test_a_crease_too_short_for_the_wheel_is_a_shortfall(
    others: list[tuple[tuple[float, float], tuple[float, float]]],
) -> None:
    drawn = dieline(OUTLINE, (CREASE, edges(((200, 200), (200, 204)), *others)))
    verdict = verdict_of(drawn, short_crease="refuse")
    (finding,) = verdict.findings
    assert (finding.severity, finding.edge) == (Severity.SHORTFALL, 4)
    assert finding.message.code == "verify.crease-too-short"
    assert not verdict.accepted
    assert verdict.setback[4] == pytest.approx(4.0)


def test_a_press_on_a_board_that_refuses_short_creases_is_a_fault() -> None:
    drawn = dieline(OUTLINE, (CREASE, edges(((200, 200), (200, 204)), ((150, 150), (300, 150)))))
    operations = plan(drawn, MACHINE, BOARD)
    toolpath = sequence([compensate(operation) for operation in operations], MACHINE)
    text = process(toolpath, MACHINE, "grblhal").text
    verdict = verify(text, drawn, (0.0, 0.0), MACHINE, replace(BOARD, short_crease="refuse"))
    assert any(finding.severity == Severity.FAULT for finding in verdict.findings)


BESIDE = {
    "outline": (OUTLINE, ((130, 101.1), (370, 101.1)), 0.2),
    "outline, backwards": (OUTLINE, ((370, 101.1), (130, 101.1)), -0.2),
    "left outline": (OUTLINE, ((101.2, 280), (101.2, 120)), 0.1),
    "from edge to edge": (OUTLINE, ((100, 101.05), (400, 101.05)), 0.25),
}


def grooved(line: tuple[tuple[float, float], tuple[float, float]], *more: Any) -> Dieline:
    return dieline(OUTLINE, *more, (GROOVE, edges(line)))


@pytest.mark.parametrize("name", BESIDE)
@pytest.mark.parametrize("step", [0.0, 0.5])
def test_a_groove_is_shifted_away_from_the_outline(name: str, step: float) -> None:
    _, line, shift = BESIDE[name]
    verdict = verdict_of(grooved(line), groove_pass=step)
    assert verdict.accepted, verdict.findings[:2]
    (note,) = verdict.findings
    assert (note.severity, note.edge) == (Severity.NOTE, 4)
    assert note.message.code == "verify.groove-shifted"
    assert note.message.arguments["distance"] == pytest.approx(abs(shift))


def test_a_groove_is_shifted_away_from_a_window_and_a_slit() -> None:
    window = (CUT, closed((200, 150), (260, 150), (260, 198.9), (200, 198.9)))
    slit = (CUT, edges(((300, 201.1), (350, 203))))
    for more in (window, slit):
        verdict = verdict_of(grooved(((120, 200), (390, 200)), more))
        assert verdict.accepted, (more, verdict.findings[:2])
        assert [note.measure for note in verdict.findings] == [pytest.approx(0.2)]


@pytest.mark.parametrize(
    ("line", "more", "limit"),
    [
        (((130, 100.9), (370, 100.9)), None, 0.3),  # farther than the board allows
        (((130, 101.1), (370, 101.1)), None, 0.1),
        (((130, 101.1), (370, 101.1)), None, 0.0),
        (((130, 101.1), (370, 101.1)), ((130, 102.3), (200, 102.3)), 0.3),  # on both sides
        (((130, 101.1), (370, 101.1)), ((130, 102.5), (200, 102.5)), 0.3),  # in the way
        (((130, 100.02), (370, 100.02)), None, 2.0),  # on the cut
    ],
)
def test_a_groove_that_must_not_be_shifted_is_refused(
    line: tuple[tuple[float, float], tuple[float, float]], more: Any, limit: float
) -> None:
    slit = () if more is None else ((CUT, edges(more)),)
    with pytest.raises(FlankOutside):
        verdict_of(grooved(line, *slit), groove_shift=limit)


def test_a_larger_shift_may_be_allowed_by_the_board() -> None:
    assert verdict_of(grooved(((130, 100.5), (370, 100.5))), groove_shift=0.8).accepted


@pytest.mark.parametrize("factor", [0.0, 0.8, 1.2, -1.0])
def test_the_verifier_computes_the_shift_by_itself(
    factor: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = original(groove_operations, "clearing_shifts")
    monkeypatch.setattr(groove_operations, "check_flanks", lambda *_: None)
    monkeypatch.setattr(groove_operations, "damaging_paths", lambda *_: np.zeros(0, np.int64))
    monkeypatch.setattr(groove_operations, "clearing_shifts", lambda *given: factor * right(*given))
    verdict = verdict_of(grooved(((130, 101.1), (370, 101.1))))
    assert any(finding.severity == Severity.FAULT for finding in verdict.findings)
