"""Corner types that the user has chosen for edges: paths of the cutter, and refusals."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.library import load
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.dieline import LineType
from knifetip.model.job_options import EdgeCorner, JobOptions
from knifetip.model.tool import Cutter
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank of 100 × 100 mm (edges 0 to 3: below, right, above, left), another one (4 to 7), and a
#: crease (8).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (200, 100), (200, 200), (100, 200))),
    (LineType.CUT, closed((240, 100), (340, 100), (340, 200), (240, 200))),
    (LineType.CREASE, edges(((120, 150), (180, 150)))),
)
FIRST = {"below-left": (100, 100), "below-right": (200, 100), "right": (200, 200)}
SECOND = ((240, 100), (340, 100), (340, 200), (240, 200))


def compiled(
    *choices: EdgeCorner, corners: Corners | None = None, machine: str = "router-table"
) -> Compiled:
    drawn = drawing(LINE.ends, [("CUT", 7, "CONTINUOUS")] * len(LINE), bulge=LINE.bulge)
    options = JobOptions(edge_corners=choices, corners=corners)
    target = load.machine(machine), load.board("greyboard-3.0")
    return pipeline.compile(drawn, LINE, *target, options=options)


def choice(kind: Any, *rows: int, k: float | None = None) -> EdgeCorner:
    return EdgeCorner(edges=rows, type=kind, k=k)


def radius_at(made: Compiled, corner: tuple[float, float]) -> float:
    """Return the radius of the arc on which the cutter's centre goes round a corner (mm); 0 for
    straight lines.
    """
    path = made.toolpath
    start, end = path.pose[:-1, :2], path.pose[1:, :2]
    middle = (start + end) / 2.0 - made.placement
    near = np.hypot(*(middle - corner).T) < 4.0
    arcs = near & (path.bulge != 0.0) & (path.motion == Motion.FEED)
    if not arcs.any():
        return 0.0
    row = np.flatnonzero(arcs)[0]
    # A chord of an arc of 4 atan(b) is 2 r sin(2 atan(b)) long.
    half = 2.0 * np.arctan(abs(path.bulge[row]))
    return float(np.hypot(*(end[row] - start[row])) / (2.0 * np.sin(half)))


def cutter_radius() -> float:
    station = load.machine("router-table").station_for(LineType.CUT)
    assert station is not None
    assert isinstance(station.tool, Cutter)
    return station.tool.radius


def test_the_corners_of_a_chain_have_its_type() -> None:
    made = compiled(choice("C", 0, 1, 2, 3), choice("B", 4, 5, 6, 7))
    assert made.verdict.accepted
    radius = cutter_radius()
    assert [radius_at(made, corner) for corner in FIRST.values()] == [0.0] * 3
    assert [radius_at(made, corner) for corner in SECOND] == pytest.approx([radius] * 4, abs=1e-6)


def test_a_corner_has_the_type_of_the_edge_along_which_the_cutter_arrives() -> None:
    # The cutter runs clockwise: along the lower edge from the right to the left.
    made = compiled(EdgeCorner(line_type="cut", type="B"), choice("C", 0))
    assert made.verdict.accepted
    assert radius_at(made, FIRST["below-left"]) == 0.0
    assert radius_at(made, FIRST["below-right"]) > 0.0


def test_k_of_an_edge_replaces_that_of_the_job() -> None:
    whole = Corners(type="D", k=0.75)
    made = compiled(choice("D", 4, 5, 6, 7, k=0.25), corners=whole)
    assert made.verdict.accepted
    # At a right angle, the arc of type D has the radius r (1 - k).
    radius = cutter_radius()
    assert radius_at(made, FIRST["right"]) == pytest.approx(0.25 * radius, abs=1e-6)
    assert radius_at(made, SECOND[0]) == pytest.approx(0.75 * radius, abs=1e-6)
    # Without a type, k is for corners of the type of the job.
    same = compiled(choice("usual", 4, 5, 6, 7, k=0.25), corners=whole)
    assert same.program.text == made.program.text


def test_the_type_of_a_single_corner_counts_more() -> None:
    single = Corners(type="B", at=(CornerAt(x=200, y=100, type="C"),))
    made = compiled(choice("D", 0, 1, 2, 3), corners=single)
    assert made.verdict.accepted
    assert radius_at(made, FIRST["below-right"]) == 0.0
    assert 0.0 < radius_at(made, FIRST["right"]) < radius_at(made, SECOND[0])


def test_a_choice_of_nothing_changes_nothing() -> None:
    assert compiled(choice("usual", 0)).program.text == compiled().program.text


@pytest.mark.parametrize(
    ("picked", "machine", "text"),
    [
        (choice("C", 0), "demo-table", "cuts with no router or laser"),
        (choice("C", 8), "router-table", "only cuts have corner types"),
        (choice("C", 9), "router-table", "the drawing has 9 edges"),
    ],
)
def test_corners_that_cannot_be_chosen_are_refused(
    picked: EdgeCorner, machine: str, text: str
) -> None:
    with pytest.raises(PlanError, match=text):
        compiled(picked, machine=machine)
