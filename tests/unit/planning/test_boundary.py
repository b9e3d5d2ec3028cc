"""Which grooves end on the board's edge, and how far they run out over it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from knifetip.errors import FlankOutside
from knifetip.geometry.columns import F64
from knifetip.planning.boundary import BoardOutline, ends_at_waste, run_out_lengths
from knifetip.planning.cut_sides import cut_sides
from tests.support.shapes import closed, edges, rotation

SQUARE = closed((0, 0), (100, 0), (100, 100), (0, 100))


def out(
    point: tuple[float, float],
    towards: tuple[float, float],
    ends: F64 = SQUARE,
    bulge: ArrayLike | None = None,
    width: float = 2.0,
) -> tuple[float, bool]:
    """Return the run-out of a groove that ends at ``point``, and whether it ends on the edge."""
    bent = np.zeros(len(ends)) if bulge is None else np.array(bulge, float)
    outline = BoardOutline.from_cuts(ends, bent, cut_sides(ends, bent).waste)
    ahead = np.array([towards], float) / np.hypot(*towards)
    size, on_edge = run_out_lengths(np.array([point], float), ahead, width, outline, np.array([7]))
    return float(size[0]), bool(on_edge[0])


def test_a_groove_square_to_the_edge_has_no_run_out_and_ends_on_the_edge() -> None:
    assert out((100, 50), (1, 0)) == pytest.approx((0.0, True), abs=1e-12)


@pytest.mark.parametrize(("degrees", "extra"), [(45.0, 1.0), (30.0, 1.7320508), (60.0, 0.5773503)])
def test_run_out_at_an_angle_to_the_edge_grows_with_the_cotangent(
    degrees: float, extra: float
) -> None:
    # The groove is 2 wide; it meets the top edge at this angle.
    towards = (np.cos(np.radians(degrees)), np.sin(np.radians(degrees)))
    assert out((50, 100), towards) == pytest.approx((extra, True))


def test_an_end_inside_the_board_has_no_run_out() -> None:
    assert out((100 - 0.06, 50), (1, 1)) == (0.0, False)
    assert out((100, 50), (-1, 1)) == (0.0, False)


def test_a_gap_before_the_edge_is_added_to_the_run_out() -> None:
    assert out((100 - 0.04, 50), (1, 1))[0] == pytest.approx(1.0 + 0.04 * 2**0.5)


def test_a_groove_along_the_edge_is_refused() -> None:
    with pytest.raises(
        FlankOutside, match=r"edge 7 meets the edge of the board at an angle of only 4\.0°"
    ):
        out((50, 100), (np.cos(np.radians(4)), np.sin(np.radians(4))))


def test_both_flanks_leave_together_on_the_diagonal_of_an_outer_corner() -> None:
    # Each flank is 1 beside the diagonal, and so 1 behind the edge on its side.
    assert out((100, 100), (1, 1)) == pytest.approx((-1.0 + 1.0, True))


def test_at_an_outer_corner_each_flank_leaves_over_its_nearer_edge() -> None:
    # At 10° above due east the lower flank is past x = 100 after tan 10° mm, never past y = 100.
    towards = (np.cos(np.radians(10)), np.sin(np.radians(10)))
    size, on_edge = out((100, 100), towards)
    assert on_edge
    assert size == pytest.approx(0.0, abs=1e-12)


#: The square with a notch 20 wide and 20 deep in its top edge: each side leans by tan⁻¹ ½.
NOTCHED = closed((0, 0), (100, 0), (100, 100), (60, 100), (50, 80), (40, 100), (0, 100))
#: A plus, whose inner corners are square.
PLUS = closed(
    (100, 0), (200, 0), (200, 100), (300, 100), (300, 200), (200, 200),
    (200, 300), (100, 300), (100, 200), (0, 200), (0, 100), (100, 100),
)  # fmt: skip


def test_in_a_notch_both_halves_of_the_tool_pass_its_sides() -> None:
    # 1 mm beside the middle a side of the notch is 2 mm above its bottom.
    assert out((50, 80), (0, 1), NOTCHED) == pytest.approx((2.0, True))
    # At tan⁻¹ ¼ off the middle the left side is nearer in angle, and later to leave.
    size, on_edge = out((50, 80), (-1, 4), NOTCHED)
    ahead, beside = np.array([-1.0, 4.0]) / 17**0.5, np.array([-4.0, -1.0]) / 17**0.5
    left_corner = np.array([50.0, 80.0]) + size * ahead + beside
    assert on_edge
    # The left side runs from (50, 80) to (40, 100): 2 x + y = 180.
    assert 2.0 * left_corner[0] + left_corner[1] == pytest.approx(180.0)


def test_both_halves_leave_together_on_the_diagonal_of_an_inner_corner() -> None:
    assert out((200, 100), (1, -1), PLUS) == pytest.approx((1.0, True))


def test_a_groove_stops_at_an_inner_corner_with_board_ahead() -> None:
    # Along y = 100 the upper half of the groove would never leave the right arm.
    assert out((200, 100), (1, 0), PLUS) == (0.0, False)
    # The same applies 4° below it; at 6° it leaves, after 1 / tan 6°.
    low = np.radians(4.0)
    assert out((200, 100), (np.cos(low), -np.sin(low)), PLUS) == (0.0, False)
    low = np.radians(6.0)
    assert out((200, 100), (np.cos(low), -np.sin(low)), PLUS) == pytest.approx((9.51436, True))
    # A groove that points into the arm never leaves.
    assert out((200, 100), (1, 1), PLUS) == (0.0, False)


def test_a_run_out_that_would_reach_board_beyond_a_slot_is_refused() -> None:
    # Over the left wall of a slot 1.5 wide at 30°: √3 to go, and 1.5 / sin 30° = 3 to the far wall.
    slot = closed(
        (0, 0), (100, 0), (100, 100), (51.5, 100), (51.5, 20), (50, 20), (50, 100), (0, 100)
    )
    towards = (0.5, 3**0.5 / 2.0)
    assert out((50, 60), towards, slot, width=1.0) == pytest.approx((3**0.5 / 2.0, True))
    with pytest.raises(FlankOutside, match=r"edge 7 would continue 3\.46 mm beyond .* next part"):
        out((50, 60), towards, slot, width=4.0)


def test_a_run_out_into_the_neighbouring_blank_is_refused() -> None:
    two = np.concatenate([SQUARE, SQUARE + np.array([101.0, 0.0])])
    assert out((100, 50), (1, 0), two) == pytest.approx((0.0, True), abs=1e-12)
    with pytest.raises(FlankOutside, match="next part"):
        out((100, 50), (1, 1), two, width=3.0)


def test_a_round_edge_adds_its_sagitta() -> None:
    # A disc of radius 50 about (50, 0) in two halves; leaving its top at 45°.
    disc = edges(((0, 0), (100, 0)), ((100, 0), (0, 0)))
    size, on_edge = out((50, 50), (1, 1), disc, [1.0, 1.0])
    # The far corner is √2 along the tangent: 2 / 100 = 0.02 deeper, and √2 of that along the way.
    assert on_edge
    assert size == pytest.approx(1.0 + 0.02 * 2**0.5)


def test_without_cuts_there_is_no_board_edge() -> None:
    assert out((50, 100), (0, 1), edges(((0, 100), (100, 100)))) == (0.0, False)


@given(
    side=st.integers(0, 3),
    share=st.floats(0.2, 0.8),
    angle=st.floats(8.0, 172.0),
    degrees=st.floats(0.0, 360.0),
    backwards=st.booleans(),
    width=st.floats(0.2, 5.0),
)
def test_the_run_out_is_the_least_with_both_corners_past_the_edge(
    side: int, share: float, angle: float, degrees: float, backwards: bool, width: float
) -> None:
    turn = rotation(degrees)
    ends = SQUARE @ turn.T
    if backwards:
        ends = ends[:, ::-1]
    a, b = SQUARE[side] @ turn.T
    along = (b - a) / 100.0
    normal = np.array([along[1], -along[0]])
    point = a + share * 100.0 * along
    ahead = np.cos(np.radians(angle)) * along + np.sin(np.radians(angle)) * normal
    size, on_edge = out(point, ahead, ends, width=width)
    assert on_edge
    beside = width / 2.0 * np.array([-ahead[1], ahead[0]])
    past = [float((point + size * ahead + s * beside - point) @ normal) for s in (1, -1)]
    assert min(past) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_waste_lies_only_outside_all_outlines_that_cross(order: tuple[int, int]) -> None:
    squares = [SQUARE, SQUARE + 50.0]
    ends = np.concatenate([squares[order[0]], squares[order[1]]])
    bulge = np.zeros(len(ends))
    points = np.array([[0.0, 50.0], [100.0, 25.0], [100.0, 75.0], [150.0, 75.0], [75.0, 50.0]])
    ahead = np.array([[-1.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, -1.0]])
    for outline in BoardOutline.from_contours(ends, bulge, cut_sides(ends, bulge)):
        at_waste = ends_at_waste(points, ahead, outline)
        assert at_waste.tolist() == [True, True, False, True, False]
