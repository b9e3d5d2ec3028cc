import math

import numpy as np
import pytest

from knifetip.errors import GeometryError
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel
from knifetip.verification.expectation.crease_lines import split_at_cuts
from knifetip.verification.expectation.edges import pairs_within, place_edges
from knifetip.verification.expectation.expected_work import (
    ExpectedCreases,
    expected_creases,
    groove_continues,
    knife_ends,
)
from tests.support.programs.handwritten import (
    BOARD,
    CREASE,
    CUT,
    DIELINE,
    MACHINE,
    PLACEMENT,
    RUN_OUT,
    SLIT,
    dieline,
)


def wheel() -> CreaseWheel:
    tool = MACHINE.station(2).tool
    assert isinstance(tool, CreaseWheel)
    return tool


WHEEL = wheel()


def expected_of(*edges: tuple[float, float, float, float]) -> ExpectedCreases:
    drawn = dieline(*((CREASE, *edge, 0.0) for edge in edges))
    return expected_creases(place_edges(drawn, (0.0, 0.0)), BOARD, WHEEL)


def test_a_free_crease_is_set_back_by_its_contact_and_the_clearance() -> None:
    found = expected_of((0, 0, 0, 50))
    # √(0.6 (30 - 0.6)) + 0.2 = 4.4
    np.testing.assert_allclose([found.low[0], found.high[0]], [4.4, 45.6])
    assert np.isnan(found.press_depth[0])


@pytest.mark.parametrize(("rise", "pieces"), [(1e-5, 1), (0.47, 1), (0.57, 2), (20.0, 2)])
def test_a_cut_splits_a_crease_that_it_crosses_at_more_than_one_degree(
    rise: float, pieces: int
) -> None:
    # 0.47 is 0.9°, and 0.57 is 1.08°.
    drawn = dieline((CREASE, 0, 0, 100, 0, 0.0), (CUT, 20, -rise, 80, rise, 0.0))
    placed = place_edges(drawn, (0.0, 0.0))
    split, _ = split_at_cuts(placed.with_types(CREASE), placed.with_types(CUT))
    assert len(split) == pieces


def test_the_setback_of_a_curved_crease_follows_from_the_tangent_at_its_end() -> None:
    # A quarter of a circle from the direction along the grain to the one across it.
    drawn = dieline((CREASE, 0, 0, 50, 50, 1.0 - math.sqrt(2.0)))
    found = expected_creases(place_edges(drawn, (0.0, 0.0)), BOARD, WHEEL)
    length = 25.0 * math.pi
    finish = math.sqrt(0.8 * (30.0 - 0.8)) + 0.2
    np.testing.assert_allclose([found.low[0], found.high[0]], [4.4, length - finish])


def test_a_crease_that_another_continues_is_not_set_back_there() -> None:
    found = expected_of((0, 0, 0, 50), (0, 80, 0, 50), (0, 80, 30, 80))
    np.testing.assert_allclose(found.low[:2], [4.4, 4.4])
    np.testing.assert_allclose(found.high[:2], [50.0, 30.0])


def test_a_crease_that_turns_by_more_than_a_degree_does_not_continue() -> None:
    bend = math.radians(2.0)
    found = expected_of((0, 0, 0, 50), (0, 50, 30 * math.sin(bend), 50 + 30 * math.cos(bend)))
    np.testing.assert_allclose(found.high[0], 45.6)


def test_a_setback_longer_than_the_last_edge_continues_in_the_next_one() -> None:
    found = expected_of((0, 0, 0, 50), (0, 50, 0, 53))
    np.testing.assert_allclose(found.high[0], 48.6)
    assert found.high[1] <= found.low[1]


def test_a_short_crease_is_pressed_in_its_middle_at_the_depth_that_fits() -> None:
    # 6.4 long: ± 3 between the clearances, and 3² = δ (30 - δ) gives δ = 15 - √216 = 0.3031.
    found = expected_of((0, 0, 0, 6.4))
    assert found.pressed[0]
    assert not found.refused[0]
    np.testing.assert_allclose(found.press_depth, [15.0 - math.sqrt(216.0)])
    np.testing.assert_allclose([found.low[0], found.high[0]], [3.2, 3.2])


@pytest.mark.parametrize(("length", "is_refused"), [(0.3, True), (1.4, True), (1.6, False)])
def test_a_crease_without_depth_between_its_clearances_is_refused(
    length: float, is_refused: bool
) -> None:
    # 0.01 mm deep, the wheel touches 2 √(0.01 · 29.99) = 1.095 mm, and 0.4 mm remain free.
    assert bool(expected_of((0, 0, 0, length)).refused[0]) is is_refused


def test_knife_ends_of_the_hand_written_dieline() -> None:
    edges = place_edges(DIELINE, PLACEMENT)
    cuts = edges.with_types(LineType.CUT)
    slant = math.tan(math.radians(10.0))
    ends = knife_ends(cuts, cuts, 2.3 * slant, 2.0 * slant)
    slit, run_out = (
        int(np.flatnonzero(cuts.row == SLIT)[0]),
        int(np.flatnonzero(cuts.row == RUN_OUT)[0]),
    )
    assert ends.free[2 * slit : 2 * slit + 2].all()
    np.testing.assert_allclose(ends.stop[2 * slit + 1], [60.0 - 0.40555, 35.0], atol=1e-5)
    np.testing.assert_allclose(ends.stop[2 * slit], [40.0 + 0.40555, 35.0], atol=1e-5)
    assert ends.meets[2 * run_out + 1]
    assert not ends.meets[2 * run_out]
    np.testing.assert_allclose(ends.stop[2 * run_out + 1], [70.0, 80.35265], atol=1e-5)


def test_the_stop_before_a_free_end_may_lie_round_a_corner() -> None:
    drawn = dieline((CUT, 0, 0, 10, 0, 0.0), (CUT, 10, 0, 10, 0.25, 0.0))
    edges = place_edges(drawn, (0.0, 0.0))
    ends = knife_ends(edges, edges, 0.4, 0.3)
    np.testing.assert_allclose(ends.stop[3], [9.85, 0.0], atol=1e-12)


@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize(("stub", "stop"), [(0.25, 10.0), (0.41, None)])
def test_the_stop_before_a_stub_lies_on_its_corner(
    first: int, stub: float, stop: float | None
) -> None:
    ends = [(0.0, 0.0, 10.0, 0.0), (10.0, 0.0, 10.0, stub)]
    if first:
        ends = [(x1, y1, x0, y0) for x0, y0, x1, y1 in reversed(ends)]
    drawn = dieline(*((CUT, *end, 0.0) for end in ends))
    edges = place_edges(drawn, (0.0, 0.0))
    found = knife_ends(edges, edges, 0.4, 0.3, swivel=15.0)
    free = 0 if first else 3
    wanted = [10.0, 0.0] if stop else [10.0, stub - 0.4]
    np.testing.assert_allclose(found.stop[free], wanted, atol=1e-12)
    assert found.setback[free] == pytest.approx(stub if stop else 0.4)
    on_stub = [-1, -1] if not stop else [free, -1] if first else [-1, free]
    assert found.stub_end.tolist() == on_stub
    # The other end has room, and a path that turns by less is not lifted.
    np.testing.assert_allclose(found.stop[3 - free], [0.4, 0.0], atol=1e-12)
    smooth = knife_ends(edges, edges, 0.4, 0.3, swivel=90.0)
    assert (smooth.stub_end == -1).all()


def test_only_a_collinear_groove_continues_another() -> None:
    groove = LineType.V_GROOVE
    drawn = dieline(
        (groove, 0, 0, 10, 0, 0.0), (groove, 20, 0, 10, 0, 0.0), (groove, 20, 0, 30, 0.01, 0.0)
    )
    assert groove_continues(place_edges(drawn, (0.0, 0.0))).tolist() == [
        False,
        True,
        False,
        True,
        False,
        False,
    ]


def test_pairs_within_agrees_with_all_distances() -> None:
    chance = np.random.default_rng(5)
    one, other = chance.uniform(0, 3, (200, 2)), chance.uniform(0, 3, (300, 2))
    a, b = pairs_within(one, other, 0.1)
    distance = np.hypot(*(one[:, None] - other).transpose(2, 0, 1))
    assert set(zip(a.tolist(), b.tolist(), strict=True)) == set(
        zip(*(side.tolist() for side in np.nonzero(distance <= 0.1)), strict=True)
    )
    assert len(a) == len(set(zip(a.tolist(), b.tolist(), strict=True)))


def test_too_many_edges_at_one_point_raise_an_error() -> None:
    with pytest.raises(GeometryError, match="pairs of end points of edges"):
        pairs_within(np.zeros((5000, 2)), np.zeros((5000, 2)), 0.05)


def test_edges_without_length_are_left_out() -> None:
    edges = place_edges(dieline((CUT, 1, 1, 1, 1, 0.0), (CUT, 0, 0, 1, 0, 0.0)), (0.0, 0.0))
    assert edges.row.tolist() == [1]


@pytest.mark.parametrize(
    ("slit", "overrun"),
    [
        ((50, 20, 50, 40), 0.0),  # on a slit
        ((30, 70, 30, 100), 0.3),  # on the outline
        ((30, 130, 30, 100), 0.0),  # on the outline, from the waste
        ((90, 20, 100, 0), 0.3),  # at an outer corner
        ((70, 50, 70, 60), 0.3),  # on the edge of a hole
        ((70, 72, 70, 80), 0.0),  # on the edge of a hole, from its inside
        ((50, 50, 60, 60), 0.3),  # at a corner of a hole
        ((60, 50, 60, 60), 0.0),  # along an edge of a hole
    ],
)
def test_the_tip_passes_an_end_on_a_cut_only_if_waste_lies_ahead(
    slit: tuple[float, float, float, float], overrun: float
) -> None:
    panel, hole = (0.0, 100.0), (60.0, 80.0)
    drawn = dieline(
        *(
            (CUT, *ends, 0.0)
            for low, high in (panel, hole)
            for ends in (
                (low, low, high, low),
                (high, low, high, high),
                (high, high, low, high),
                (low, high, low, low),
            )
        ),
        (CUT, 20, 40, 55, 40, 0.0),
        (CUT, *slit, 0.0),
    )
    edges = place_edges(drawn, (0.0, 0.0))
    ends = knife_ends(edges, edges, 0.4, 0.3)
    assert ends.meets[-1]
    assert ends.overrun[-1] == overrun
    direction = np.subtract(slit[2:], slit[:2]) / math.dist(slit[2:], slit[:2])
    np.testing.assert_allclose(ends.stop[-1], slit[2:] + overrun * direction, atol=1e-12)


def test_an_overrun_at_outlines_that_cross_is_planned_outside_both_only() -> None:
    # Two squares of 40 mm; a corner of each lies inside the other.  Slits end on the left side of
    # the first one from inside, and on its right side, which is inside the second one above 20 mm.
    def square(x: float, y: float) -> list[tuple[LineType, float, float, float, float, float]]:
        corners = [(x, y), (x + 40, y), (x + 40, y + 40), (x, y + 40)]
        pairs = zip(corners, corners[1:] + corners[:1], strict=True)
        return [(CUT, *start, *end, 0.0) for start, end in pairs]

    slits = [(CUT, 10, 10, 0, 10, 0.0), (CUT, 30, 10, 40, 10, 0.0), (CUT, 30, 30, 40, 30, 0.0)]
    for squares in (square(0, 0) + square(20, 20), square(20, 20) + square(0, 0)):
        cuts = place_edges(dieline(*squares, *slits), (0.0, 0.0))
        found = knife_ends(cuts, cuts, 0.1, 0.07)
        assert found.overrun[17:22:2].tolist() == [0.07, 0.07, 0.0]


def test_an_overrun_into_a_hole_that_crosses_its_outline_is_not_planned() -> None:
    # The hole is drawn across the outline, so it is not clear which faces are waste.
    hole = [(CUT, 30, 10, 50, 10, 0.0), (CUT, 50, 10, 50, 30, 0.0), (CUT, 50, 30, 30, 30, 0.0)]
    hole += [(CUT, 30, 30, 30, 10, 0.0)]
    outline = [(CUT, 0, 0, 40, 0, 0.0), (CUT, 40, 0, 40, 40, 0.0), (CUT, 40, 40, 0, 40, 0.0)]
    outline += [(CUT, 0, 40, 0, 0, 0.0)]
    cuts = place_edges(dieline(*hole, *outline, (CUT, 10, 20, 30, 20, 0.0)), (0.0, 0.0))
    found = knife_ends(cuts, cuts, 0.1, 0.07)
    assert found.overrun[17] == 0.0
