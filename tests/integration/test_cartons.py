"""Random cartons are accepted, if need be after following hints; ``python -m tests.cartons`` runs
more of them.

The drawings below were refused wrongly when random cartons first contained them.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.corners import Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.sheet import Sheet
from knifetip.model.toolpath import Motion
from knifetip.model.verdict import Severity
from knifetip.pipeline import Compiled
from tests.cartons.campaign import Tally, run
from tests.cartons.job import random_job
from tests.cartons.trial import attempt_drawing, attempt_job
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE
PERFORATION = LineType.PERFORATION


def compiled(
    line: Dieline, machine: str, board: str, options: JobOptions | None = None
) -> Compiled:
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    return pipeline.compile(
        lines,
        line,
        load.machine(machine),
        load.board(board),
        options=options or JobOptions(),
    )


def refusals(made: Compiled) -> list[str]:
    """Return the findings that refuse a program."""
    return [finding.text for finding in made.verdict.findings if finding.refuses]


def test_random_cartons_are_accepted() -> None:
    tally = Tally()
    failures = [f"{job}: {outcome.text}" for job, outcome in run(45, 5, tally)]
    assert failures == []
    fates = sum((fates for fates in tally.by_machine.values()), start=tally.refusals.copy())
    assert fates["accepted"] > 20
    assert fates["by hint"] > 5


def test_a_wheel_that_turns_at_a_joint_with_a_gap_does_not_travel() -> None:
    # The second crease turns by 0.9° and begins 0.0015 mm beside the end of the first one.
    folds = edges(((10, 30), (60, 30)), ((60, 30.0015), (110, 30.787)))
    panel = closed((0, 0), (120, 0), (120, 60), (0, 60))
    line = dieline((CUT, panel), (CREASE, folds))
    for machine in ("two-carriage-table", "demo-table", "flat-cutter-hpgl"):
        assert refusals(compiled(line, machine, "greyboard-3.0")) == []


@pytest.mark.parametrize(("seed", "number"), [(7, 816), (101, 91)])
def test_rounded_blanks_do_not_exceed_the_travel_of_a_flat_cutter(seed: int, number: int) -> None:
    job = random_job(seed, number)
    assert job.machine.name == "flat-cutter-hpgl"
    outcome = attempt_job(job)
    # The outline of the second drawing is open, so its sheet is not known.
    assert set(outcome.followed) <= {"sheet.without-outline: no sheet"}
    assert outcome.fate in ("accepted", "by hint")


@pytest.mark.parametrize("space", [3.0, 10.0])
def test_grooves_of_blanks_in_a_row_run_out_beside_each_other(space: float) -> None:
    # On a sheet that was cut to the outline, a run-out may be so long that the blade turns there;
    # the groove of the next blank begins within this length.
    blanks = [closed((x, 0), (x + 60, 0), (x + 60, 40), (x, 40)) for x in (0.0, 60.0 + space)]
    grooves = edges(*(((x + 0.04, 20), (x + 59.96, 20)) for x in (0.0, 60.0 + space)))
    line = dieline(*((CUT, blank) for blank in blanks), (GROOVE, grooves))
    made = compiled(line, "demo-table", "greyboard-2.0", JobOptions(sheet=Sheet()))
    assert refusals(made) == []


def test_a_perforated_circle_is_accepted_on_a_flat_cutter() -> None:
    ring = edges(((101.41, 60.005), (58.81, 60.005)), ((58.81, 60.005), (101.41, 60.005)))
    panel = closed((0, 0), (150, 0), (150, 120), (0, 120))
    line = dieline((CUT, panel), (PERFORATION, ring), bulge={4: 1.0, 5: 1.0})
    assert refusals(compiled(line, "flat-cutter-hpgl", "greyboard-2.0")) == []


@pytest.mark.parametrize("gap", [0.0015, 0.0019, 0.002, 0.0021, 0.05])
@pytest.mark.parametrize("machine", ["demo-table", "flat-cutter-hpgl"])
def test_gaps_in_a_contour_at_the_limit_of_joining_are_closed(machine: str, gap: float) -> None:
    panel: F64 = closed((0, 0), (90.123, 0), (90.123, 60.456), (0, 60.456))
    for side in range(4):
        long = panel[side, 1] - panel[side, 0]
        panel[side, 1] -= gap * long / np.hypot(*long)
    made = compiled(dieline((CUT, panel)), machine, "b-flute")
    assert refusals(made) == []
    # No end is free, so nothing remains uncut.
    assert made.verdict.setback.max() < 1e-9


def test_a_gap_across_a_corner_leaves_two_free_ends() -> None:
    # The ends are 0.04 mm apart along X and along Y, so 0.057 mm.
    cuts = edges(
        ((0, 0), (100, 0)),
        ((100, 0), (100, 60)),
        ((100, 60), (6, 60)),
        ((5.96, 59.96), (0, 54)),
        ((0, 54), (0, 0)),
    )
    made = compiled(dieline((CUT, cuts)), "demo-table", "e-flute")
    assert refusals(made) == []
    assert made.verdict.setback.max() > 0.3


def test_a_fold_at_the_height_of_a_joint_is_trimmed() -> None:
    # The right side of the panel is drawn in two pieces that are 0.001 mm apart, at the height of
    # one of the folds.
    cuts = edges(
        ((0, 0), (100, 0)),
        ((100, 0), (100, 29.9995)),
        ((100, 30.0005), (100, 80)),
        ((100, 80), (0, 80)),
        ((0, 80), (0, 0)),
    )
    folds = edges(((0, 30), (99.9, 30)), ((50, -0.4), (50, 80.3)))
    made = compiled(dieline((CUT, cuts), (CREASE, folds)), "demo-table", "fbb-0.4")
    assert refusals(made) == []


@pytest.mark.parametrize("machine", ["two-carriage-table", "flat-cutter-hpgl"])
def test_a_knife_that_turns_at_a_joint_with_a_gap_does_not_travel(machine: str) -> None:
    turns = np.linspace(0.0, 2.0 * np.pi, 36, endpoint=False)
    panel: F64 = closed(*zip(60.0 * np.cos(turns), 60.0 * np.sin(turns), strict=True))
    panel[:, 1] -= 0.0015 * (panel[:, 1] - panel[:, 0]) / 10.5
    assert refusals(compiled(dieline((CUT, panel)), machine, "fbb-0.4")) == []


def test_round_blanks_may_touch() -> None:
    # The upper one touches the lower one from above, at the middle of an arc.
    blanks = edges(*(line for y in (0.0, 80.0) for line in (((0, y), (80, y)), ((80, y), (0, y)))))
    line = dieline((CUT, blanks), bulge=dict.fromkeys(range(4), 1.0))
    assert refusals(compiled(line, "demo-table", "greyboard-2.0")) == []


def test_round_blanks_may_touch_within_the_digits_of_a_drawing() -> None:
    # The second blank is turned by 180°; the arcs of the two blanks cross each other by 0.0001 mm.
    blank = edges(
        ((0, 3), (10, 0)),
        ((10, 0), (110, 0)),
        ((110, 0), (210, 0)),
        ((210, 0), (210, 60)),
        ((210, 60), (110, 60)),
        ((110, 60), (10, 60)),
        ((10, 60), (0, 57)),
        ((0, 57), (0, 3)),
    )
    turned = np.array([220.0, 60.0 + 60.0 + 2 * 0.35 * 50.0 - 0.0001]) - blank
    line = dieline(
        (CUT, blank), (CUT, turned), bulge=dict.fromkeys([1, 2, 4, 5, 9, 10, 12, 13], 0.35)
    )
    assert refusals(compiled(line, "demo-table", "b-flute")) == []


def test_blanks_that_coincide_nearly_are_cleaned_within_the_limit() -> None:
    # The last edge of the first blank is 0.009 mm from the first one of the second blank, and
    # 0.005 mm shifted along it.
    first = closed((0, 0), (80, 0), (80, 60), (0, 60))
    second = closed((80.009, 0.005), (160, 0.005), (160, 60.005), (80.009, 60.005))
    line = dieline((CUT, first), (CUT, second))
    assert refusals(compiled(line, "demo-table", "fbb-0.4")) == []


def faults(made: Compiled) -> list[str]:
    """Return the findings that no user can accept."""
    return [f.text for f in made.verdict.findings if f.severity is Severity.FAULT]


def test_a_crease_shorter_than_the_distance_of_touching_does_not_continue_itself() -> None:
    # A tiny triangle at the end of a long crease.
    folds = edges(
        ((20.0, 30.0), (60.0, 30.0)),
        ((60.0, 30.0), (60.0138, 29.9683)),
        ((60.0138, 29.9683), (60.0378, 29.9729)),
        ((60.0378, 29.9729), (60.0, 30.0)),
    )
    line = dieline((CUT, closed((0, 0), (120, 0), (120, 100), (0, 100))), (CREASE, folds))
    assert faults(compiled(line, "demo-table", "fbb-0.4")) == []


def test_arcs_cross_a_crease_where_they_are() -> None:
    # Between two holes of radius 20 mm, 9.4 mm of the crease remain.  The wheel is pressed there at
    # a depth that depends on this length.
    turn = np.radians(102.0)
    step = 20.0 * np.array([np.cos(turn), np.sin(turn)])
    halves = [
        (tuple(centre + way * step), tuple(centre - way * step))
        for centre in (np.array([35.0, 50.0]), np.array([84.4, 50.0]))
        for way in (1.0, -1.0)
    ]
    panel = closed((0, 0), (120, 0), (120, 100), (0, 100))
    line = dieline(
        (CUT, panel),
        (CUT, edges(*halves)),
        (CREASE, edges(((2.0, 50.0), (118.0, 50.0)))),
        bulge=dict.fromkeys(range(4, 8), 1.0),
    )
    assert refusals(compiled(line, "demo-table", "e-flute")) == []


def test_creases_around_a_corner_with_gaps_are_set_back_alike() -> None:
    # The ends of the upright creases are 0.054 mm apart; ends of others lie between them.
    folds = edges(
        ((75.488, 323.03707), (75.488, 374.0676)),
        ((75.488, 260.0), (75.488, 322.98351)),
        ((75.51897, 323.05432), (100.0, 347.53535)),
        ((110.0, 323.02338), (75.52158, 323.02338)),
        ((40.0, 323.02338), (75.52433, 323.02338)),
    )
    panel = closed((0, 240), (120, 240), (120, 400), (0, 400))
    assert refusals(compiled(dieline((CUT, panel), (CREASE, folds)), "demo-table", "b-flute")) == []


@pytest.mark.corpus
def test_curls_drawn_twice_are_cut_by_a_drag_knife(corpus: Path) -> None:
    """The knife must not leave the board between two curls that are 0.004 mm apart."""
    data = (corpus / "generated__florianfesti__boxes/PaperBox_100x40x140.dxf").read_bytes()
    outcome = attempt_drawing(data, load.machine("drag-knife-hpgl"), load.board("fbb-0.4"))
    assert outcome.fate == "accepted", outcome.text


@pytest.mark.corpus
@pytest.mark.parametrize(
    ("name", "board"),
    [
        ("generated__florianfesti__boxes/PaperBox_100x40x140.dxf", "fbb-0.4"),
        ("skymakerolof__dxf/test/resources/blocks1.dxf", "e-flute"),
    ],
)
def test_edges_without_a_line_type_may_be_creased(corpus: Path, name: str, board: str) -> None:
    read = pipeline.read((corpus / name).read_bytes(), "mm")
    decided = pipeline.interpret(read, Interpretation()).line_type.copy()
    decided[decided == LineType.UNCLASSIFIED] = CREASE
    line = pipeline.interpret(read, Interpretation(overrides=decided.tobytes()))
    made = pipeline.compile(read, line, load.machine("demo-table"), load.board(board))
    assert faults(made) == []


def test_the_gap_between_creases_that_reach_into_a_slot_is_not_pressed() -> None:
    # The row of three creases has equal gaps.
    slot = edges(((98, 20), (98, 80)), ((106, 80), (106, 20)))
    folds = edges(((5, 50), (45, 50)), ((51, 50), (99, 50)), ((105, 50), (145, 50)))
    line = dieline(
        (CUT, closed((0, 0), (150, 0), (150, 100), (0, 100))), (CUT, slot), (CREASE, folds)
    )
    made = compiled(line, "v-groove-table", "greyboard-2.0")
    assert faults(made) == []
    path = made.toolpath
    x = path.pose[1:, 0] - made.placement[0]
    creased = (path.motion != Motion.RAPID) & (path.source >= 6)
    assert not (creased & (x > 99.0) & (x < 105.0)).any()


# The ends are 0.054 mm apart, or two creases overlap by 0.3 mm in slightly different directions.
@pytest.mark.parametrize("number", [579, 636])
def test_creases_that_nearly_meet_at_a_corner_are_set_back_alike(number: int) -> None:
    assert attempt_job(random_job(302, number)).fate in ("accepted", "by hint")


def test_a_slit_whose_last_edge_is_shorter_than_the_lead_is_accepted() -> None:
    # The knife stops before the corner, so it arrives in the direction of the edge before it.
    slit = edges(((60, 20), (60, 50)), ((60, 50), (60.3, 50)))
    other = edges(((60.3, 50.06), (60.3, 80)))
    panel = closed((0, 0), (120, 0), (120, 100), (0, 100))
    line = dieline((CUT, panel), (CUT, slit), (CUT, other))
    assert refusals(compiled(line, "demo-table", "b-flute")) == []


def test_a_contour_may_start_at_a_corner_whose_arc_is_made_of_chords() -> None:
    # The arc on the lower edge turns by 15.2° at both ends, and nothing else is a
    # corner, so the knife is lifted there.  The plotter cuts the arc as chords, of which the first
    # and the last one turn by less than the swivel angle of 15°.
    turn, radius = np.radians(15.2), 12.0
    x = 2.0 * radius * np.sin(turn)
    line = dieline(
        (CUT, closed((0, 0), (x, 0), (50, 0), (50, 50), (-50, 50), (-50, 0))),
        bulge={0: np.tan(0.5 * turn), 2: 1.0, 4: 1.0},
    )
    assert refusals(compiled(line, "flat-cutter-hpgl", "greyboard-3.0")) == []


def test_a_path_at_the_corner_of_fitted_curves_on_a_flat_cutter_follows_one_of_them() -> None:
    # Rounded to plotter units, the path along one side of the window passes the end of this side,
    # and is a little nearer to the other side there.
    window = closed((70.035, 40.005), (85.062, 20.025), (94.827, 36.786))
    panel = closed((0, 0), (150, 0), (150, 120), (0, 120))
    line = dieline((CUT, panel), (CUT, window))
    fitted = replace(line, fit_error=np.where(np.arange(len(line)) < 4, 0.0, 0.0004))
    made = compiled(fitted, "flat-cutter-hpgl", "fbb-0.4")
    assert refusals(made) == []


@pytest.mark.parametrize(
    ("seed", "number"),
    [
        (71200, 2063),
        (71200, 2725),
        (70155, 538),
        (92004, 683),
        (93002, 338),
        (93002, 1064),
        (93001, 1871),
        (95001, 3054),
    ],
)
def test_drawings_of_campaigns_that_were_refused_are_accepted(seed: int, number: int) -> None:
    # A line between two arcs that is shorter than the chip takes to be given the next one; a
    # circle of 0.6 mm over its polygon of hundredths; curves in rounded chords under
    # a cutter; creases that end beside short ones at a slot; a lead-in beside a slit; a hole of
    # two arcs that meet at a slight angle; and a cut that ends 0.06 mm beside a groove.
    outcome = attempt_job(random_job(seed, number, bodies=True))
    assert outcome.fate in ("accepted", "excepted")


def test_corners_of_type_d_between_rounded_chords_are_accepted() -> None:
    # A disc in 360 chords, in hundredths: where two of them meet, the centre stays 0.0095 mm away
    # from the path beside a third.
    turns = np.linspace(0.0, 2.0 * np.pi, 360, endpoint=False)
    x, y = 30.077 + 7.0 * np.cos(turns), 30.004 + 7.0 * np.sin(turns)
    outline = closed(*np.round(np.stack([x, y], axis=1), 2).tolist())
    options = JobOptions(corners=Corners(type="D", k=0.5))
    made = compiled(dieline((CUT, outline)), "router-table", "greyboard-1.5", options)
    assert refusals(made) == []


def test_a_wheel_rolls_straight_over_a_short_gap_between_creases() -> None:
    # Rounded to thousandths, the lines across the gaps turn by up to 0.2°; the contact of the
    # wheel is 15 mm long.
    folds = edges(
        ((-8.711, 14.65), (-8.298, -42.006)),
        ((-9.148, 74.543), (-8.713, 14.838)),
        ((-8.297, -42.231), (-7.856, -102.698)),
    )
    panel = closed((-70, -103), (142, -103), (142, 76), (-70, 76))
    made = compiled(dieline((CUT, panel), (CREASE, folds)), "demo-table", "eb-flute")
    assert refusals(made) == []
