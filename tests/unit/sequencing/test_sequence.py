"""The joined toolpath: order of tracks, air moves, headings, travel."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.compensation.compensate import compensate
from knifetip.errors import PlanError, TravelExceeded
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.model.dieline import LineType
from knifetip.model.machine import Axis, Machine
from knifetip.model.tool import VCutter
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from knifetip.sequencing.sequence import sequence
from tests.support.shapes import BOARD, KNIFE, MACHINE, closed, dieline, edges


def sequenced(*groups: tuple[LineType, F64], machine: Machine = MACHINE) -> Toolpath:
    operations = plan(dieline(*groups), machine, BOARD)
    return sequence([compensate(operation) for operation in operations], machine)


def test_the_toolpath_starts_and_ends_at_the_parking_position() -> None:
    path = sequenced((LineType.CUT, edges(((10, 10), (90, 10)))))
    np.testing.assert_array_equal(path.pose[0], [0, 0, 20, 0])
    np.testing.assert_array_equal(path.pose[-1], [0, 0, 20, 0])


def test_a_tool_is_changed_at_travel_height() -> None:
    path = sequenced(
        (LineType.CREASE, edges(((10, 10), (10, 90)))),
        (LineType.CUT, edges(((20, 10), (90, 10)))),
    )
    change = np.flatnonzero(path.tool[1:] != path.tool[:-1])
    assert len(change) == 1
    assert path.pose[change[0] + 1, 2] == 20.0
    # The new tool first moves above its start, then down.
    np.testing.assert_allclose(path.pose[change[0] + 2, :3], [20, 10, 20])


def test_links_between_tracks_stay_above_the_board() -> None:
    path = sequenced(
        (
            LineType.CUT,
            np.concatenate([closed((0, 0), (9, 0), (9, 9)), closed((30, 0), (39, 0), (39, 9))]),
        )
    )
    rapid = path.motion == Motion.RAPID
    assert path.pose[1:][rapid][:, 2].min() == 4.0  # caliper 2 and clearance 2


def test_every_row_of_the_tracks_occurs_once() -> None:
    groups = [(LineType.CREASE, edges(*[((x, 10), (x, 90)) for x in range(10, 90, 7)]))]
    operation = plan(dieline(*groups), MACHINE, BOARD)[0]
    before = compensate(operation)
    after = sequence([before], MACHINE)
    fed = after.motion == Motion.FEED
    assert sorted(after.source[fed]) == sorted(before.source[before.motion == Motion.FEED])
    assert after.track.max() == before.track.max()


def test_the_wheel_turns_by_less_than_a_quarter_between_creases() -> None:
    path = sequenced(
        (
            LineType.CREASE,
            edges(((10, 10), (10, 90)), ((12, 90), (12, 10)), ((14, 10), (14, 90))),
        )
    )
    rapid = np.flatnonzero(path.motion == Motion.RAPID)[2:-2]
    assert np.abs(np.diff(path.pose[:, 3]))[rapid].max() <= 90.0


def test_c_stays_within_its_travel() -> None:
    squares = np.concatenate(
        [closed((x, 0), (x + 9, 0), (x + 9, 9), (x, 9)) for x in range(0, 400, 20)]
    )
    path = sequenced((LineType.CUT, squares))
    assert path.pose[:, 3].min() >= -1080
    assert path.pose[:, 3].max() <= 1080


def test_c_also_unwinds_in_the_air_within_a_track() -> None:
    # Sixty right angles to the left would be fifteen turns.
    size = np.arange(300.0, 0.0, -5.0)
    turns = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])[np.arange(60) % 4]
    corners = np.concatenate([[[0.0, 0.0]], np.cumsum(size[:, None] * turns, axis=0)])
    spiral = np.stack([corners[:-1], corners[1:]], axis=1)
    path = sequenced((LineType.CUT, spiral))
    assert path.pose[:, 3].max() <= 1080
    assert (path.motion == Motion.FEED).sum() == 60


def test_the_error_names_the_head_that_would_leave_the_machine() -> None:
    narrow = replace(MACHINE, x=Axis(-500.0, 100.0, 1500.0, 8000.0))
    with pytest.raises(
        TravelExceeded,
        match=r"Wheel \(station 2\) would move 10\.00 mm beyond the upper end of the travel of "
        "axis X",
    ):
        sequenced((LineType.CREASE, edges(((50, 10), (50, 90)))), machine=narrow)


def test_a_job_without_work_is_refused() -> None:
    with pytest.raises(PlanError, match="The drawing contains nothing that the machine can make"):
        sequence([], MACHINE)


def test_a_crease_is_rolled_from_the_end_that_is_nearer() -> None:
    # The left end of the first crease is nearer to (0, 0), so it is rolled from left to right.
    path = sequenced(
        (LineType.CREASE, edges(((90, 10), (10, 10)), ((90, 20), (10, 20)))),
    )
    fed = np.flatnonzero(path.motion == Motion.FEED)
    assert path.pose[fed[0], 0] < 20 < 80 < path.pose[fed[0] + 1, 0]
    assert path.pose[fed[1], 0] > 80 > 20 > path.pose[fed[1] + 1, 0]
    # Backwards the plunge is still a plunge, and the lift a lift.
    for row in fed:
        assert path.motion[row - 1 : row + 2].tolist() == [Motion.PLUNGE, Motion.FEED, Motion.LIFT]
        assert path.pose[row - 1, 2] > path.pose[row, 2] == path.pose[row + 1, 2]
        assert path.pose[row + 2, 2] > path.pose[row + 1, 2]


def test_a_reversed_arc_has_the_opposite_bulge_and_a_tangent_wheel() -> None:
    # A half circle over (0, 50) … (100, 50), drawn from its far end: bulge 1 becomes -1.
    # On a board with one depth for all directions the arc stays whole.
    line = dieline((LineType.CREASE, edges(((100, 50), (0, 50)))), bulge={0: 1.0})
    even = replace(BOARD, crease_across=BOARD.crease_along)
    path = sequence([compensate(plan(line, MACHINE, even)[0])], MACHINE)
    row = int(np.flatnonzero(path.motion == Motion.FEED)[0])
    assert path.pose[row, 0] < 1.0
    assert path.bulge[row] < -0.9
    # At the left end the tangent is vertical: C is 90 or 270, except for the turn in the setback.
    assert abs(path.pose[row, 3] % 180.0 - 90.0) < 6.0
    assert path.pose[row + 1, 3] - path.pose[row, 3] == pytest.approx(
        4.0 * np.degrees(np.arctan(path.bulge[row]))
    )


def test_a_v_groove_is_begun_at_its_nearer_end_and_both_its_flanks_are_cut() -> None:
    line = (LineType.V_GROOVE, edges(((300, 50), (100, 50))))
    path = sequenced(line)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    assert len(fed) == 2
    # Out from x = 100, C 0, head right of travel (y - 4) and ahead (x + 1.5); back the other way.
    np.testing.assert_allclose(path.pose[fed[0], :2], [101.5, 46.0])
    np.testing.assert_allclose(path.pose[fed[0] + 1, :2], [301.5, 46.0])
    np.testing.assert_allclose(path.pose[fed[1], :2], [298.5, 54.0])
    np.testing.assert_allclose(path.pose[fed[1] + 1, :2], [98.5, 54.0])
    assert abs(path.pose[fed[1], 3] - path.pose[fed[0], 3]) == pytest.approx(180.0)


def test_a_slanted_blade_is_never_run_backwards() -> None:
    cuts = edges(*[((90, y), (10, y)) for y in range(10, 60, 10)])
    path = sequenced((LineType.CUT, cuts))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    assert len(fed) == 5
    assert (path.pose[fed + 1, 0] < path.pose[fed, 0]).all()


def test_an_upright_blade_is_run_backwards_and_turned() -> None:
    upright = replace(
        MACHINE,
        stations=(
            replace(MACHINE.stations[0], tool=replace(KNIFE, blade_angle=0.0)),
            *MACHINE.stations[1:],
        ),
    )
    cuts = edges(*[((90, y), (10, y)) for y in range(10, 60, 10)])
    path = sequenced((LineType.CUT, cuts), machine=upright)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    way = np.sign(path.pose[fed + 1, 0] - path.pose[fed, 0])
    assert set(way) == {-1.0, 1.0}
    np.testing.assert_allclose(np.cos(np.radians(path.pose[fed, 3])), way, atol=1e-9)


def test_two_runs_give_the_same_toolpath() -> None:
    random = np.random.default_rng(3)
    ends = random.uniform(0, 500, (60, 2, 2))
    one, two = (sequenced((LineType.CREASE, ends)) for _ in range(2))
    np.testing.assert_array_equal(one.pose, two.pose)


def sheet(x: float, y: float, width: float, height: float) -> Paths:
    ends = closed((x, y), (x + width, y), (x + width, y + height), (x, y + height))
    return Paths(ends[:, 0], ends[:, 1], np.zeros(4), np.array([0, 4]))


def test_a_groove_that_has_left_the_board_turns_without_a_lift() -> None:
    # The board is 100 … 300 wide; the grooves run out by 40 mm on both sides of it.
    lines = edges(((60, 50), (340, 50)), ((60, 80), (340, 80)))
    operation = plan(dieline((LineType.V_GROOVE, lines)), MACHINE, BOARD)[0]
    high = sequence([compensate(operation)], MACHINE)
    low = sequence([compensate(operation)], MACHINE, sheet(100, 0, 200, 400))
    # Groove 1 out, turn, back, link, groove 2 out, turn, back: three lifts fewer.
    assert (high.motion == Motion.LIFT).sum() == 4
    assert (low.motion == Motion.LIFT).sum() == 1
    turns = np.flatnonzero((low.motion == Motion.RAPID) & (low.pose[1:, 2] < 2.0))
    assert len(turns) == 3
    np.testing.assert_allclose(low.pose[1:][turns, 2], 1.0)
    fed = [path.pose[1:][path.motion == Motion.FEED] for path in (high, low)]
    np.testing.assert_allclose(*fed)


def test_a_groove_that_has_not_quite_left_the_board_turns_above_it() -> None:
    # 2 mm past the edge the tip circle of 1.5 mm about the blade still reaches back over it.
    lines = edges(((98.5, 50), (301.5, 50)))
    operation = plan(dieline((LineType.V_GROOVE, lines)), MACHINE, BOARD)[0]
    low = sequence([compensate(operation)], MACHINE, sheet(100, 0, 200, 400))
    assert low.pose[:, 2][1:][low.motion == Motion.RAPID].min() == 4.0


def test_a_knife_beside_the_board_is_lifted_off_the_mat() -> None:
    cuts = edges(((60, 50), (20, 50)), ((60, 80), (20, 80)))
    operation = plan(dieline((LineType.CUT, cuts)), MACHINE, BOARD)[0]
    low = sequence([compensate(operation)], MACHINE, sheet(100, 0, 200, 400))
    link = np.flatnonzero((low.motion == Motion.RAPID) & (low.pose[1:, 2] < 4.0))
    # It cuts at -0.3 and travels at the machine's clearance above the mat: 2 mm.
    np.testing.assert_allclose(low.pose[1:][link, 2], 2.0)
    assert len(link) == 1


def test_a_wide_tilted_blade_is_lifted_further_along_its_axis() -> None:
    wide = VCutter(back=4.0, half_width=6.0, tilt=45.0)
    machine = replace(MACHINE, stations=(replace(MACHINE.stations[2], tool=wide),))
    board = replace(BOARD, groove_overcut=20.0)
    line = dieline((LineType.V_GROOVE, edges(((100, 50), (300, 50)))))
    path = sequence([compensate(plan(line, machine, board)[0])], machine)
    turn = np.flatnonzero(path.motion == Motion.RAPID)
    turn = turn[path.pose[1:][turn, 2] < 20.0]
    # The circle hangs 6 sin 45° = 4.243 below the tip, 2.243 of it below the face at 2: so much up.
    assert path.pose[1:][turn, 2].max() == pytest.approx(2.0 + 6.0 * np.sin(np.pi / 4))
