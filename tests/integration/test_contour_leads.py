"""Lead-ins that the user has chosen for contours: paths of the cutter, verdicts, and refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import ContourLead, EdgeTool, JobOptions
from knifetip.model.toolpath import Motion
from knifetip.model.verdict import Verdict
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank (edges 0 to 3), another one (4 to 7), and a crease (8).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
    (LineType.CUT, closed((240, 100), (340, 100), (340, 200), (240, 200))),
    (LineType.CREASE, edges(((120, 150), (180, 150)))),
)
#: Two blanks 1.5 mm apart.
NEAR = dieline(
    (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
    (LineType.CUT, closed((201.5, 100), (301.5, 100), (301.5, 200), (201.5, 200))),
)
#: Radius of the cutter of router-table (mm).
RADIUS = 3.0
BOARD = load.board("greyboard-3.0")


def compiled(
    *leads: ContourLead,
    line: Dieline = LINE,
    machine: str = "router-table",
    tools: tuple[EdgeTool, ...] = (),
) -> Compiled:
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(contour_leads=leads, edge_tools=tools)
    return pipeline.compile(drawn, line, load.machine(machine), BOARD, options=options)


def verdict(text: bytes, made: Compiled, *leads: ContourLead) -> Verdict:
    machine, options = load.machine("router-table"), JobOptions(contour_leads=leads)
    return pipeline.verify(text, LINE, made.placement, machine, BOARD, options=options)


def lead(*rows: int, length: float | None = None, approach: float | None = None) -> ContourLead:
    return ContourLead(edges=rows, length=length, approach=approach)


def lead_lengths(made: Compiled, rows: range) -> set[float]:
    """Return the lengths of the straight lead-ins to the contour of some edges (mm)."""
    path = made.toolpath
    own = (path.motion == Motion.LEAD_IN) & np.isin(path.source, rows) & (path.bulge == 0.0)
    moved = np.diff(path.pose[:, :2], axis=0)[own]
    return set(np.round(np.hypot(*moved.T), 6).tolist())


def codes(found: Verdict) -> set[str]:
    return {one.message.code for one in found.findings if one.refuses}


def test_a_contour_has_the_chosen_length_and_angle() -> None:
    usual = lead_lengths(compiled(), range(4))
    made = compiled(lead(4, length=8.0))
    assert made.verdict.accepted, codes(made.verdict)
    # At 90°, the centre moves from L to r beside the contour.
    assert lead_lengths(made, range(4, 8)) == {8.0 - RADIUS}
    assert lead_lengths(made, range(4)) == usual
    made = compiled(lead(4, 5, 6, 7, length=8.0, approach=30.0))
    assert made.verdict.accepted, codes(made.verdict)
    expected = math.sqrt(64.0 + RADIUS**2 - 2.0 * 8.0 * RADIUS * math.sin(math.radians(30.0)))
    assert lead_lengths(made, range(4, 8)) == {round(expected, 6)}


def test_a_lead_in_round_a_corner_can_be_chosen() -> None:
    made = compiled(ContourLead(line_type="cut", length=4.0, approach=-90.0))
    assert made.verdict.accepted, codes(made.verdict)
    assert lead_lengths(made, range(8)) == {4.0}


def test_a_lead_in_longer_than_the_gap_is_halved_or_left_out() -> None:
    made = compiled(lead(0, length=50.0))
    assert made.verdict.accepted, codes(made.verdict)
    (length,) = lead_lengths(made, range(4))
    assert length in (50.0 - RADIUS, (50.0 - RADIUS) / 2.0)


@pytest.mark.parametrize(
    "chosen",
    [
        lead(4, length=8.0),
        lead(4, length=8.0, approach=30.0),
        lead(4, length=4.0, approach=-90.0),
    ],
)
def test_a_program_of_another_lead_in_is_refused(chosen: ContourLead) -> None:
    usual, made = compiled(), compiled(chosen)
    assert codes(verdict(made.program.text, made, chosen)) == set()
    assert codes(verdict(usual.program.text, usual, chosen)) == {"verify.other-lead"}


@pytest.mark.parametrize(
    "chosen",
    [
        lead(4, length=8.0),
        lead(4, length=8.0, approach=30.0),
        lead(4, length=4.0, approach=-60.0),
    ],
)
def test_half_a_lead_in_is_refused_where_there_is_room(
    chosen: ContourLead, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.compensation.leads._LEAD_FRACTIONS", (0.5, 0.0))
    assert codes(compiled(chosen).verdict) == {"verify.short-lead"}


@pytest.mark.parametrize("approach", [90.0, 30.0])
def test_a_contour_without_a_lead_in_is_refused_where_there_is_room(
    approach: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    chosen = lead(4, length=8.0, approach=approach)
    monkeypatch.setattr("knifetip.compensation.leads._LEAD_FRACTIONS", (0.0,))
    assert codes(compiled(chosen).verdict) == {"verify.short-lead"}


@pytest.mark.parametrize(
    ("size", "length", "note"),
    [(40.0, 30.0, None), (40.0, 39.0, "lead.shortened"), (12.0, 50.0, "lead.no-room")],
)
def test_a_lead_in_is_shortened_without_room_only_and_that_is_reported(
    size: float, length: float, note: str | None
) -> None:
    # A square hole: the lead-in comes from the side across.
    far = 130.0 + size
    hole = closed((130, 130), (130, far), (far, far), (far, 130))
    line = dieline(
        (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))), (LineType.CUT, hole)
    )
    made = compiled(lead(4, length=length), line=line)
    assert made.verdict.accepted, codes(made.verdict)
    notes = {one.message.code for one in made.verdict.findings}
    assert notes & {"lead.shortened", "lead.no-room"} == ({note} if note else set())


@pytest.mark.parametrize(
    ("chosen", "machine", "text"),
    [
        ((lead(0, length=5.0),), "demo-table", "cuts with no router or laser"),
        ((lead(8, length=5.0),), "router-table", "only cuts have lead-ins"),
        ((lead(0, length=0.5),), "router-table", "must be 0 or greater than the tool radius"),
        ((lead(0, length=8.0, approach=5.0),), "router-table", "begins nearer to the contour"),
        ((lead(0, length=5.0), lead(1, length=4.5)), "router-table", "Choose the same lead-in"),
    ],
)
def test_lead_ins_that_cannot_be_made_are_refused(
    chosen: tuple[ContourLead, ...], machine: str, text: str
) -> None:
    with pytest.raises(PlanError, match=text):
        compiled(*chosen, machine=machine)


def test_contours_in_each_others_way_need_one_lead_in() -> None:
    with pytest.raises(PlanError, match="different lead-ins were chosen for their contours"):
        compiled(lead(0, length=5.0), line=NEAR)


def test_cutter_and_lead_in_are_chosen_on_different_edges_of_a_contour() -> None:
    tools = (EdgeTool(edges=(5,), station=6),)
    made = compiled(lead(7, length=8.0), machine="fine-router-table", tools=tools)
    assert made.verdict.accepted, codes(made.verdict)
    assert lead_lengths(made, range(4, 8)) == {8.0 - 0.75}
