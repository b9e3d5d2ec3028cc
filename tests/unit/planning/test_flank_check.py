"""V-grooves beside cuts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import FlankOutside
from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.model.operation import Operation
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

#: A board that allows no shift of grooves.
UNSHIFTED = replace(BOARD, groove_shift=0.0)

# 1 mm deep with a blade at 45°: the flanks reach 1 mm to either side.
OUTLINE = (LineType.CUT, closed((0, 0), (200, 0), (200, 100), (0, 100)))


def planned(
    groove: F64, *more: tuple[LineType, F64], bulge: dict[int, float] | None = None
) -> list[Operation]:
    return plan(
        dieline(OUTLINE, (LineType.V_GROOVE, groove), *more, bulge=bulge), MACHINE, UNSHIFTED
    )


def test_a_groove_across_the_board_runs_out_at_both_ends() -> None:
    assert planned(edges(((50, 0), (60, 100))))


def test_a_groove_is_refused_if_its_flank_would_leave_the_board() -> None:
    assert planned(edges(((0, 1.1), (200, 1.1))))
    slanted = edges(((10, 0.5), (190, 2.0)))
    with pytest.raises(FlankOutside, match=r"edge 4 is 2\.00 mm wide"):
        planned(slanted)


def test_a_hole_beside_a_groove_is_refused() -> None:
    hole = (LineType.CUT, edges(((100, 50), (110, 50)), ((110, 50), (100, 50))))
    beside = edges(((20, 55.5), (180, 55.5)))
    with pytest.raises(FlankOutside):
        planned(beside, hole, bulge={5: 1.0, 6: 1.0})
    assert planned(beside + np.array([0.0, 2.0]), hole, bulge={5: 1.0, 6: 1.0})


@pytest.mark.parametrize("aside", [0.1, 0.5, 0.95, 0.99])
@pytest.mark.parametrize("far", [False, True])
def test_a_groove_along_a_cut_is_refused_with_the_cut_and_the_distance(
    aside: float, far: bool
) -> None:
    y = 100.0 - aside if far else aside
    with pytest.raises(FlankOutside) as refused:
        planned(edges(((25, y), (175, y))))
    error = refused.value
    assert (
        f"its flank reaches {1.0 - aside:.2f} mm sideways across the cut at edge {2 if far else 0}"
        in str(error)
    )
    assert f"The cut lies only {aside:.2f} mm from the centre line of the groove" in str(error)
    assert "75.0 mm from the start of the groove" in str(error)
    assert f"Move the groove and the cut {1.0 - aside:.2f} mm further apart" in error.hint
    assert error.edges == (4, 2 if far else 0)


@pytest.mark.parametrize(
    "groove",
    [
        ((0, 0.5), (200, 0.5)),  # from edge to edge: it meets cuts at both ends
        ((100, 0.5), (103, 0.5)),  # shorter than what is left out at ends that meet cuts
    ],
)
def test_a_groove_of_any_length_along_the_edge_is_refused(
    groove: tuple[tuple[int, float], tuple[int, float]],
) -> None:
    with pytest.raises(FlankOutside):
        planned(edges(groove))


def test_a_slit_between_the_flanks_along_the_groove_is_refused() -> None:
    groove = edges(((20, 50), (180, 50)))
    for slit in (((60, 50.5), (90, 50.5)), ((90, 49.5), (60, 49.5)), ((60, 49.6), (90, 50.4))):
        with pytest.raises(FlankOutside, match="cut at edge 5"):
            planned(groove, (LineType.CUT, edges(slit)))


@pytest.mark.parametrize(
    "slit",
    [
        ((180, 30), (180, 70)),  # the groove ends on it
        ((181, 30), (181, 70)),  # the groove ends just before it
        ((179, 30), (179, 70)),  # the groove runs out over it
        ((180, 50), (190, 50)),  # it starts at the end of the groove
        ((175, 30), (185, 70)),  # oblique
        ((99.9, 49.2), (100.1, 50.8)),  # it lies across the groove, between its flanks
        ((100, 30), (100, 70)),  # across the groove
        ((90, 40), (109, 60)),  # at 46°
        ((100, 50.04), (100, 70)),  # it ends on the groove
        ((100, 50.06), (100, 70)),  # it ends between the line of the groove and its flank
        ((60, 51.01), (90, 51.01)),
        ((181, 50.5), (190, 50.5)),
    ],
)
def test_a_groove_may_end_on_a_cut_cross_it_or_run_far_beside_it(
    slit: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    assert planned(edges(((20, 50), (180, 50))), (LineType.CUT, edges(slit)))


@pytest.mark.parametrize(
    "slit",
    [
        ((90, 40), (111, 60)),
        ((100, 50.06), (121, 70)),  # it ends between the line of the groove and its flank
        ((100, 50.06), (100, 50.9)),  # between line and flank, it comes from neither
    ],
)
def test_a_cut_across_a_groove_is_refused_if_it_slants_or_crosses_no_flank(
    slit: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    with pytest.raises(FlankOutside):
        planned(edges(((20, 50), (180, 50))), (LineType.CUT, edges(slit)))


@pytest.mark.parametrize(("gap", "fine"), [(0.99, False), (1.01, True)])
def test_the_distance_to_a_round_cut_is_measured_to_its_arc(gap: float, fine: bool) -> None:
    # A hole of r 30, whose chords of 45° would be up to 2.3 mm away from it.
    hole = (LineType.CUT, edges(((70, 65), (130, 65)), ((130, 65), (70, 65))))
    groove = edges(((20, 35 - gap), (180, 35 - gap)))
    if fine:
        assert planned(groove, hole, bulge={5: 1.0, 6: 1.0})
    else:
        with pytest.raises(FlankOutside, match="cut at edge"):
            planned(groove, hole, bulge={5: 1.0, 6: 1.0})


def test_a_short_groove_may_end_on_cuts_at_both_ends() -> None:
    slits = edges(((100, 40), (100, 60)), ((102, 45), (102, 55)), ((101, 51.2), (103, 51.2)))
    assert planned(edges(((100, 50), (102, 50))), (LineType.CUT, slits))
