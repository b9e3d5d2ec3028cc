"""Creases that a cut crosses, and double ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.errors import EdgeTooShort
from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.operation import End, Operation
from knifetip.model.tool import CreaseWheel
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, MACHINE, dieline, edges

ACROSS = edges(((0, 0), (100, 0)))
#: A board on which the depth of a crease is equal in all directions, so that arcs stay whole.
EVEN = replace(BOARD, crease_across=BOARD.crease_along)


def rolled(
    creases: F64,
    cuts: F64 | None = None,
    bulge: dict[int, float] | None = None,
    board: Board = BOARD,
    machine: Machine = MACHINE,
) -> Operation:
    groups = [(LineType.CREASE, creases)]
    if cuts is not None:
        groups.append((LineType.CUT, cuts))
    return plan(dieline(*groups, bulge=bulge), machine, board)[0]


def test_a_crease_crossed_by_a_cut_becomes_two_with_free_ends() -> None:
    operation = rolled(ACROSS, edges(((40, -10), (40, 10))))
    np.testing.assert_allclose(operation.paths.end, [[40, 0], [100, 0]])
    np.testing.assert_allclose(operation.paths.start, [[0, 0], [40, 0]])
    assert operation.start.tolist() == operation.finish.tolist() == [End.FREE, End.FREE]
    assert operation.source.tolist() == [0, 0]


@pytest.mark.parametrize(
    "cut",
    [
        ((40, 0), (40, 10)), ((0, -10), (0, 10)), ((40, 1), (40, 10)), ((20, 0), (80, 0)),
        ((20, -1e-5), (80, 2e-5)), ((20, -0.47), (80, 0.47)),
    ],
    ids=[
        "ends on it", "runs through its end", "stops before it", "runs along it",
        "runs along it but for rounding", "at 0.9°",
    ],
)  # fmt: skip
def test_a_cut_that_does_not_cross_does_not_split(
    cut: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    assert len(rolled(ACROSS, edges(cut)).paths) == 1


def test_a_cut_at_a_little_more_than_one_degree_splits() -> None:
    # 1.08°
    assert len(rolled(ACROSS, edges(((20, -0.57), (80, 0.57)))).paths) == 2


@pytest.mark.parametrize(
    "cuts",
    [
        (((40, -10), (40, 0)), ((40, 0), (40, 10))),
        (((40, 0), (30, -10)), ((50, 10), (40, 0))),
        (((40, -10), (40.0, -0.03)), ((40, 10), (40, 0.03)), ((40, 10), (60, 10))),
    ],
    ids=["straight", "slanted", "within the gap"],
)
@pytest.mark.parametrize("pieces", [1, 2])
def test_a_crease_is_split_where_a_cut_goes_through_it_at_a_vertex(
    cuts: tuple[tuple[tuple[int, int], tuple[float, float]], ...], pieces: int
) -> None:
    crease = (
        edges(((0, 0), (100, 0))) if pieces == 1 else edges(((0, 0), (40, 0)), ((100, 0), (40, 0)))
    )
    operation = rolled(crease, edges(*cuts))
    assert len(operation.paths) == 2
    np.testing.assert_allclose(np.sort(operation.paths.start[:, 0] % 100.0), [0, 40], atol=1e-9)
    assert operation.start.tolist() == operation.finish.tolist() == [End.FREE, End.FREE]


def test_cuts_that_end_on_a_crease_from_one_side_do_not_split_it() -> None:
    vee = edges(((30, 10), (40, 0)), ((40, 0), (50, 10)))
    assert len(rolled(ACROSS, vee).paths) == 1
    # A cut that is drawn 0.01 mm too long, in two pieces, does not split it either.
    assert len(rolled(ACROSS, edges(((40, 10), (40, 0)), ((40, 0), (40, -0.01)))).paths) == 1
    # Cuts from both sides at different positions do not split it either.
    assert len(rolled(ACROSS, edges(((40, 0), (40, 10)), ((41, 0), (41, -10)))).paths) == 1


def test_a_curved_crease_is_split_where_a_cut_goes_through_it_at_a_vertex() -> None:
    # The lowest point of half a circle; the crease runs due east there.
    cuts = edges(((50, -80), (50, -50)), ((50, -50), (60, 0)))
    operation = rolled(ACROSS, cuts, bulge={0: 1.0}, board=EVEN)
    np.testing.assert_allclose(operation.paths.end[0], [50, -50], atol=1e-9)
    assert len(operation.paths) == 2


def test_a_crease_of_two_pieces_is_split_at_its_joint_once() -> None:
    pieces = edges(((0, 0), (40, 0)), ((40, 0), (100, 0)))
    operation = rolled(pieces, edges(((40, -10), (40, 10))))
    assert len(operation.paths) == 2
    assert operation.source.tolist() == [0, 1]
    assert operation.finish.tolist() == [End.FREE, End.FREE]


def test_cuts_that_end_beside_a_joint_are_not_connected_by_it() -> None:
    # The cuts end 0.06 mm apart, on opposite sides; the joint lies between them.
    pieces = edges(((0, 0), (40.03, 0)), ((40.03, 0), (100, 0)))
    operation = rolled(pieces, edges(((40, 0), (40, 10)), ((40.06, 0), (40.06, -10))))
    assert len(operation.paths) == 1


@pytest.mark.parametrize(("apart", "many"), [(0.04, 2), (0.05, 2), (0.06, 3)])
def test_cuts_that_cross_a_crease_near_each_other_split_it_once(apart: float, many: int) -> None:
    cuts = edges(((40, -10), (40, 10)), ((40 + apart, -10), (40 + apart, 10)))
    operation = rolled(ACROSS, cuts)
    assert len(operation.paths) == many
    np.testing.assert_allclose(operation.paths.end[0], [40, 0], atol=1e-9)
    np.testing.assert_allclose(operation.paths.start[-1], [40 + apart, 0], atol=1e-9)


def test_a_crease_is_split_at_its_joint_by_a_cut_beside_it() -> None:
    pieces = edges(((0, 0), (40, 0)), ((40, 0), (100, 0)))
    operation = rolled(pieces, edges(((40.0015, -10), (40.0015, 10))))
    np.testing.assert_array_equal(operation.paths.end, [[40, 0], [100, 0]])


def test_no_crease_continues_another_one_where_a_cut_crosses_both() -> None:
    # The creases overlap by 0.03 mm, so the cut is too near to their ends to split one of them.
    creases = edges(((0, 0), (40, 0)), ((39.97, 0), (100, 0.5)))
    uncut, cut = rolled(creases), rolled(creases, edges(((39.98, -10), (39.98, 10))))
    assert uncut.finish.tolist() == [End.CONTINUED, End.FREE]
    assert uncut.start.tolist() == [End.FREE, End.CONTINUED]
    assert cut.start.tolist() == cut.finish.tolist() == [End.FREE, End.FREE]


def test_creases_beside_a_crossing_in_another_direction_continue_each_other() -> None:
    creases = edges(((0, 0), (100, 0)), ((40, 50), (40, 0.02)), ((40, -50), (40, -0.02)))
    operation = rolled(creases, edges(((30, -5), (50, 5))))
    ends = dict(zip(operation.source.tolist(), operation.finish.tolist(), strict=True))
    assert (ends[1], ends[2]) == (End.CONTINUED, End.CONTINUED)
    assert len(operation.paths) == 4


def test_a_curved_crease_is_split_by_a_straight_cut() -> None:
    # Half a circle of radius 50 from (0, 0) to (100, 0); the cut ends at its lowest point.
    operation = rolled(ACROSS, edges(((50, -80), (50, 0))), bulge={0: 1.0}, board=EVEN)
    np.testing.assert_allclose(operation.paths.end[0], [50, -50], atol=1e-9)
    np.testing.assert_allclose(operation.paths.bulge, np.tan(np.pi / 8), atol=1e-9)


def test_a_double_crease_is_two_lines_side_by_side_and_equally_long() -> None:
    operation = rolled(ACROSS, board=replace(BOARD, double_crease=3.0))
    np.testing.assert_allclose(operation.paths.start, [[0, 1.5], [0, -1.5]])
    np.testing.assert_allclose(operation.paths.end, [[100, 1.5], [100, -1.5]])
    assert operation.source.tolist() == [0, 0]


def test_a_double_crease_bends_on_two_circles_about_one_centre() -> None:
    operation = rolled(ACROSS, bulge={0: 1.0}, board=replace(EVEN, double_crease=3.0))
    # Radius 50 about (50, 0): the lines begin 48.5 and 51.5 west of it.
    np.testing.assert_allclose(np.sort(operation.paths.start[:, 0]), [-1.5, 1.5], atol=1e-12)
    np.testing.assert_allclose(operation.paths.start[:, 1], 0.0, atol=1e-12)
    np.testing.assert_allclose(operation.paths.bulge, 1.0)


def test_a_bend_tighter_than_half_a_double_crease_is_refused() -> None:
    with pytest.raises(EdgeTooShort, match=r"radius of 1\.00 mm"):
        rolled(edges(((0, 0), (2, 0))), bulge={0: 1.0}, board=replace(BOARD, double_crease=2.0))


def test_a_double_crease_of_two_pieces_meets_on_the_mitre() -> None:
    pieces = edges(((0, 0), (50, 0)), ((50, 0), (100, 0.5)))
    operation = rolled(pieces, board=replace(BOARD, double_crease=2.0))
    for path in range(2):
        first = operation.paths.first[path]
        np.testing.assert_allclose(operation.paths.end[first], operation.paths.start[first + 1])


@pytest.mark.parametrize(("caliper", "number"), [(0.4, 2), (1.4, 4), (1.5, 4), (2.0, 5), (9.0, 5)])
def test_the_narrowest_wheel_at_least_as_wide_as_the_board_is_thick(
    caliper: float, number: int
) -> None:
    wheels = [replace(MACHINE.stations[1], number=n, tool=CreaseWheel(15.0, w, 30000.0, 6000.0))
              for n, w in ((2, 0.7), (5, 3.0), (4, 1.5))]  # fmt: skip
    machine = replace(MACHINE, stations=(*wheels, MACHINE.stations[0]))
    board = replace(BOARD, caliper=caliper, crease_along=0.2, crease_across=0.2)
    assert rolled(ACROSS, board=board, machine=machine).station == number


@given(
    places=st.lists(st.integers(2, 97), min_size=1, max_size=8, unique=True),
    slant=st.floats(-60.0, 60.0),
)
def test_cuts_at_any_angle_split_where_they_cross(places: list[int], slant: float) -> None:
    lean = 10.0 * np.tan(np.radians(slant))
    cuts = edges(*[((x - lean, -10.0), (x + lean, 10.0)) for x in places])
    operation = rolled(ACROSS, cuts)
    expected = [0, *sorted(places), 100]
    np.testing.assert_allclose(operation.paths.start[:, 0], expected[:-1], atol=1e-9)
    np.testing.assert_allclose(operation.paths.end[:, 0], expected[1:], atol=1e-9)
    assert set(operation.source.tolist()) == {0}


def test_a_closed_crease_is_set_back_only_at_its_corner() -> None:
    ring = rolled(edges(((0, 0), (200, 0)), ((200, 0), (0, 0))), bulge={0: 1.0, 1: 1.0})
    assert len(ring.paths) == 1
    assert (ring.start[0], ring.finish[0]) == (End.CONTINUED, End.CONTINUED)
    # A drop: two tangents from (0, 0) to a circle, whose arc turns by 240°.
    far, high = 60.0 * 3.0**0.5 * np.array([np.cos(np.pi / 6.0), np.sin(np.pi / 6.0)])
    low, top = (far, -high), (far, high)
    drop = edges(((0, 0), low), (low, top), (top, (0, 0)))
    for board in (BOARD, replace(BOARD, double_crease=2.0)):
        made = rolled(drop, bulge={1: float(np.tan(np.radians(60.0)))}, board=board)
        assert (made.start == End.FREE).all()
        assert (made.finish == End.FREE).all()
        gap = made.paths.start[made.paths.first[:-1]] - made.paths.end[made.paths.first[1:] - 1]
        # Both lines of a double crease end beside the corner, and are not mitred there.
        assert np.hypot(*gap.T).max() <= 2.0


#: A rounded square of creases that begins with an arc, at (38, 40).
ROUNDED = edges(
    ((38, 40), (40, 38)), ((40, 38), (40, 2)), ((40, 2), (38, 0)), ((38, 0), (2, 0)),
    ((2, 0), (0, 2)), ((0, 2), (0, 38)), ((0, 38), (2, 40)), ((2, 40), (38, 40)),
)  # fmt: skip
BENDS = dict.fromkeys((0, 2, 4, 6), -(2**0.5 - 1.0))


@pytest.mark.parametrize(
    ("cuts", "starts"),
    [
        ([((36, 50), (36, -10))], [[36, 40], [36, 0]]),
        ([((36, 50), (36, 30))], [[36, 40]]),
        ([((50, 20), (30, 20)), ((-10, 20), (10, 20))], [[0, 20], [40, 20]]),
    ],
    ids=["twice", "once", "away from its start"],
)
def test_a_closed_crease_that_is_split_has_no_end_where_it_began(
    cuts: list[tuple[tuple[float, float], tuple[float, float]]], starts: list[list[float]]
) -> None:
    operation = rolled(ROUNDED, edges(*cuts), BENDS, EVEN)
    np.testing.assert_allclose(operation.paths.start[operation.paths.first[:-1]], starts, atol=1e-9)
    assert set(operation.start.tolist() + operation.finish.tolist()) == {End.FREE}
    gaps = operation.paths.start[1:] - operation.paths.end[:-1]
    inner = np.setdiff1d(np.arange(len(gaps)), operation.paths.first[1:-1] - 1)
    np.testing.assert_allclose(gaps[inner], 0.0, atol=1e-9)


def test_a_closed_crease_that_a_cut_crosses_where_it_begins_is_split_there_only() -> None:
    operation = rolled(ROUNDED, edges(((38, 50), (38, 30))), BENDS, EVEN)
    np.testing.assert_allclose(operation.paths.start[operation.paths.first[:-1]], [[38, 40]])
    assert operation.start.tolist() == operation.finish.tolist() == [End.FREE]
