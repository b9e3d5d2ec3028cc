"""Number and positions of bridges."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.knife import knife_toolpath
from knifetip.errors import NoRoomForBridges
from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.model.toolpath import Motion
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges, rotation

HELD = replace(BOARD, bridge_width=0.5, bridge_spacing=150.0)
OUTLINE = closed((0, 0), (200, 0), (200, 100), (0, 100))


def cut(ends: F64, board: Board = HELD, bulge: dict[int, float] | None = None) -> Operation:
    return plan(dieline((LineType.CUT, ends), bulge=bulge), MACHINE, board)[-1]


def gaps(operation: Operation) -> tuple[F64, F64]:
    """Return the middles and widths of the bridges of one contour."""
    end, start = operation.paths.end[operation.paths.first[1:] - 1], operation.paths.start
    begin = np.roll(start[operation.paths.first[:-1]], -1, axis=0)
    return (end + begin) / 2.0, np.hypot(*(begin - end).T)


def test_a_blank_of_600_mm_is_held_by_four_bridges_of_half_a_millimetre() -> None:
    operation = cut(OUTLINE)
    middle, width = gaps(operation)
    assert len(operation.paths) == 4
    np.testing.assert_allclose(width, 0.5)
    # 75, 225, 375 and 525 mm along the contour from the first corner.
    expected = [[75, 0], [200, 25], [125, 100], [0, 75]]
    np.testing.assert_allclose(sorted(middle.tolist()), sorted(expected), atol=1e-9)
    assert set(operation.start.tolist() + operation.finish.tolist()) == {End.BRIDGE}
    assert operation.paths.lengths.sum() == pytest.approx(600.0 - 4 * 0.5)


def test_a_contour_has_at_least_two_bridges() -> None:
    assert len(cut(closed((0, 0), (30, 0), (30, 20), (0, 20))).paths) == 2


def test_a_bridge_on_a_corner_is_moved_five_millimetres_away() -> None:
    # On 4 × 100 bridges are due at 50, 150 …; if the square starts in a side's middle, at corners.
    square = edges(((50, 0), (100, 0)), ((100, 0), (100, 100)), ((100, 100), (0, 100)),
                   ((0, 100), (0, 0)), ((0, 0), (50, 0)))  # fmt: skip
    middle, _ = gaps(cut(square, replace(HELD, bridge_spacing=110.0)))
    corner = np.abs(middle - np.round(middle / 100.0) * 100.0).max(axis=1)
    assert corner.min() >= 5.0 + 0.25 - 1e-9


def test_the_top_face_ends_at_the_bridge() -> None:
    path = knife_toolpath(cut(OUTLINE))
    lifted = np.flatnonzero(path.motion == Motion.LIFT)
    middle, _ = gaps(cut(OUTLINE))
    # 45° over 2.3 mm: the tip stops that much before the bridge.
    apart = np.hypot(*(path.pose[lifted][:, None, :2] - middle[None]).transpose(2, 0, 1)).min(
        axis=0
    )
    np.testing.assert_allclose(apart, 2.3 + 0.25)


def test_holes_slits_and_open_outlines_have_no_bridges() -> None:
    hole = closed((20, 20), (40, 20), (40, 40), (20, 40))
    inner = plan(dieline((LineType.CUT, OUTLINE), (LineType.CUT, hole)), MACHINE, HELD)[0]
    assert inner.start.tolist() == [End.CLOSED]
    assert cut(OUTLINE[:3]).start.tolist() == [End.FREE]


def test_a_disc_has_bridges_on_its_arcs() -> None:
    disc = edges(((0, 0), (100, 0)), ((100, 0), (0, 0)))
    operation = cut(disc, bulge={0: 1.0, 1: 1.0})
    # The contour is 314 mm long: three bridges.
    assert len(operation.paths) == 3


def test_a_rounded_blank_has_bridges_on_its_straight_segments() -> None:
    quarter = np.tan(np.pi / 8)
    ends = edges(((10, 0), (90, 0)), ((90, 0), (100, 10)), ((100, 10), (100, 90)),
                 ((100, 90), (90, 100)), ((90, 100), (10, 100)), ((10, 100), (0, 90)),
                 ((0, 90), (0, 10)), ((0, 10), (10, 0)))  # fmt: skip
    operation = cut(ends, bulge=dict.fromkeys((1, 3, 5, 7), float(quarter)))
    middle, _ = gaps(operation)
    assert (np.minimum(np.abs(middle), np.abs(middle - 100)).min(axis=1) < 1e-9).all()


def test_a_contour_without_room_for_bridges_is_refused() -> None:
    with pytest.raises(NoRoomForBridges, match=r"12\.0 mm long, which is too short for 2 bridges"):
        cut(closed((0, 0), (3, 0), (3, 3), (0, 3)), replace(HELD, bridge_width=2.0))


@given(
    width=st.floats(60.0, 400.0), height=st.floats(60.0, 300.0), slant=st.floats(-20.0, 20.0),
    bridge=st.floats(0.2, 2.0), spacing=st.floats(60.0, 300.0), degrees=st.floats(0.0, 360.0),
    start=st.integers(0, 3),
)  # fmt: skip
def test_bridges_keep_their_spacing_and_their_distance_from_corners(
    width: float,
    height: float,
    slant: float,
    bridge: float,
    spacing: float,
    degrees: float,
    start: int,
) -> None:
    corners = [(0, 0), (width, slant), (width, height), (0, height)]
    ends = np.roll(closed(*corners), -start, axis=0) @ rotation(degrees).T
    operation = cut(ends, replace(BOARD, bridge_width=bridge, bridge_spacing=spacing))
    middle, gap = gaps(operation)
    assert len(middle) >= 2
    np.testing.assert_allclose(gap, bridge, rtol=1e-6)
    assert operation.paths.lengths.max() + bridge <= spacing + 1e-6
    to_corner = np.hypot(*(middle[:, None] - ends[None, :, 0]).transpose(2, 0, 1))
    assert to_corner.min() >= 5.0 + bridge / 2.0 - 1e-6
    whole = np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum()
    assert operation.paths.lengths.sum() == pytest.approx(whole - len(middle) * bridge)


def test_bridges_stay_clear_of_slit_mouths_and_ends_of_creases() -> None:
    # Without them, bridges would be at 75 of the lower side and at 125 of the upper one.
    slit, crease = edges(((75, 0), (75, 30))), edges(((125, 60), (125, 100)))
    line = dieline((LineType.CUT, OUTLINE), (LineType.CUT, slit), (LineType.CREASE, crease))
    middle, width = gaps(plan(line, MACHINE, replace(HELD, bridge_spacing=160.0))[-1])
    np.testing.assert_allclose(width, 0.5)
    lower, upper = middle[middle[:, 1] == 0.0, 0], middle[middle[:, 1] == 100.0, 0]
    assert np.abs(lower - 75.0).min() == pytest.approx(5.25)
    assert np.abs(upper - 125.0).min() == pytest.approx(5.25)


def test_a_contour_with_crease_ends_everywhere_still_gets_bridges() -> None:
    creases = edges(*[((x, 0), (x, 100)) for x in range(8, 200, 8)],
                    *[((0, y), (200, y)) for y in range(8, 100, 8)])  # fmt: skip
    operation = plan(dieline((LineType.CUT, OUTLINE), (LineType.CREASE, creases)), MACHINE, HELD)[
        -1
    ]
    assert len(operation.paths) == 4


def test_there_is_no_superfluous_bridge() -> None:
    # With a spacing of 160 mm six bridges would suffice, but not all fit at their positions.
    long = closed((0, 0), (400, 0), (400, 8), (0, 8))
    middle, _ = gaps(cut(long, replace(HELD, bridge_spacing=170.0)))
    round_ = np.sort(np.where(middle[:, 1] == 0.0, middle[:, 0], 816.0 - middle[:, 0]))
    away = np.diff(np.append(round_, round_[0] + 816.0))
    assert (away + np.roll(away, 1)).min() > 170.0
