"""Properties of every engine: rotation, reversal, mirroring, another start, tip on the edge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from knifetip.compensation.compensate import compensate
from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.plan import plan
from tests.support.examples import examples
from tests.support.shapes import BOARD, CUTTER, KNIFE, MACHINE, closed, dieline, edges, rotation

angles = st.floats(-360.0, 360.0)
places = st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0))
lengths = st.floats(15.0, 800.0)
bulges = st.floats(-0.9, 0.9).filter(lambda b: abs(b) > 0.01)
straight = st.sampled_from([LineType.CREASE, LineType.V_GROOVE, LineType.CUT, LineType.HALF_CUT])
bent = st.sampled_from([LineType.CREASE, LineType.CUT])
thousand = examples(1000)


def edge(place: tuple[float, float], azimuth: float, length: float) -> F64:
    return np.array([[place, place + length * rotation(azimuth)[:, 0]]], float)


def made(kind: LineType, ends: F64, bulge: float = 0.0, grain: float = 90.0) -> Toolpath:
    line = dieline((kind, ends), bulge={0: bulge})
    return compensate(plan(line, MACHINE, replace(BOARD, grain=grain))[0])


def tips(path: Toolpath, kind: LineType) -> F64:
    """Return the positions of the tip of the tool for a line type, (n, 2).

    They are computed from the toolpath without code of the engines.
    """
    c = np.radians(path.pose[:, 3])
    ahead, right = np.column_stack([np.cos(c), np.sin(c)]), np.column_stack([np.sin(c), -np.cos(c)])
    if kind == LineType.V_GROOVE:
        return path.pose[:, :2] - 4.0 * right - 1.5 * ahead
    return path.pose[:, :2]


@thousand
@given(kind=straight, place=places, azimuth=angles, length=lengths)
def test_the_tip_follows_a_line(
    kind: LineType, place: tuple[float, float], azimuth: float, length: float
) -> None:
    ends = edge(place, azimuth, length)
    path = made(kind, ends)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    assert len(fed) > 0
    along = (ends[0, 1] - ends[0, 0]) / length
    for row in np.concatenate([fed, fed + 1]):
        off = tips(path, kind)[row] - ends[0, 0]
        assert abs(along[0] * off[1] - along[1] * off[0]) < 1e-9
        assert -1e-9 <= along @ off <= length + 1e-9


@thousand
@given(kind=bent, place=places, azimuth=angles, length=lengths, bulge=bulges)
def test_the_tip_follows_an_arc_and_c_its_tangent(
    kind: LineType, place: tuple[float, float], azimuth: float, length: float, bulge: float
) -> None:
    ends = edge(place, azimuth, length)
    path = made(kind, ends, bulge)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    chord = ends[0, 1] - ends[0, 0]
    middle = ends[0].mean(axis=0) + (1 - bulge**2) / (4 * bulge) * np.array([-chord[1], chord[0]])
    radius = length * (1 + bulge**2) / (4 * abs(bulge))
    for row in np.concatenate([fed, fed + 1]):
        spoke = path.pose[row, :2] - middle
        assert np.hypot(*spoke) == pytest.approx(radius, rel=1e-9)
        c = np.radians(path.pose[row, 3])
        # C is perpendicular to the radius, in the direction of travel.
        moment = spoke[0] * np.sin(c) - spoke[1] * np.cos(c)
        assert moment == pytest.approx(np.sign(bulge) * radius, rel=1e-9)


@thousand
@given(kind=straight, place=places, azimuth=angles, length=lengths, degrees=angles)
def test_rotating_the_board_rotates_the_path_of_the_head(
    kind: LineType, place: tuple[float, float], azimuth: float, length: float, degrees: float
) -> None:
    turn = rotation(degrees)
    ends = edge(place, azimuth, length)
    before = made(kind, ends)
    after = made(kind, ends @ turn.T, grain=90.0 + degrees)
    np.testing.assert_allclose(after.pose[:, :2], before.pose[:, :2] @ turn.T, atol=1e-8)
    np.testing.assert_allclose(after.pose[:, 2], before.pose[:, 2], atol=1e-9)
    turned = after.pose[:, 3] - before.pose[:, 3] - degrees
    np.testing.assert_allclose((turned + 180) % 360 - 180, 0.0, atol=1e-8)


@thousand
@given(place=places, azimuth=angles, length=lengths)
def test_a_groove_drawn_in_reverse_is_the_same_groove(
    place: tuple[float, float], azimuth: float, length: float
) -> None:
    ends = edge(place, azimuth, length)
    there, back = made(LineType.V_GROOVE, ends), made(LineType.V_GROOVE, ends[:, ::-1])
    fed = np.flatnonzero(there.motion == Motion.FEED)
    # The first pass of one is the second pass of the other.
    np.testing.assert_allclose(there.pose[fed, :2], back.pose[fed[::-1], :2], atol=1e-9)
    np.testing.assert_allclose(there.pose[fed + 1, :2], back.pose[fed[::-1] + 1, :2], atol=1e-9)


@thousand
@given(place=places, azimuth=angles, length=lengths)
def test_a_crease_drawn_in_reverse_ends_at_the_other_start(
    place: tuple[float, float], azimuth: float, length: float
) -> None:
    ends = edge(place, azimuth, length)
    there, back = made(LineType.CREASE, ends), made(LineType.CREASE, ends[:, ::-1])
    np.testing.assert_allclose(there.pose[:, :3], back.pose[::-1, :3], atol=1e-8)


@given(length=lengths)
def test_mirroring_a_groove_does_not_mirror_the_path_of_a_v_cutter(length: float) -> None:
    ends = edge((0.0, 0.0), 30.0, length)
    mirror = np.array([1.0, -1.0])
    before, after = made(LineType.V_GROOVE, ends), made(LineType.V_GROOVE, ends * mirror)
    # The blade is tilted to one side, so its mirror image is another tool.
    assert np.abs(after.pose[:, :2] - before.pose[:, :2] * mirror).max() > CUTTER.back


@given(length=lengths, bulge=bulges)
def test_mirroring_a_cut_mirrors_the_path_of_a_knife(length: float, bulge: float) -> None:
    ends = edge((0.0, 0.0), 30.0, length)
    mirror = np.array([1.0, -1.0])
    before, after = made(LineType.CUT, ends, bulge), made(LineType.CUT, ends * mirror, -bulge)
    np.testing.assert_allclose(after.pose[:, :2], before.pose[:, :2] * mirror, atol=1e-8)
    np.testing.assert_allclose(after.bulge, -before.bulge)


def fed_moves(path: Toolpath) -> F64:
    """Return start and end of each move at feed, sorted by the start, (n, 6)."""
    fed = np.flatnonzero(path.motion == Motion.FEED)
    moves = np.hstack([path.pose[fed, :3], path.pose[fed + 1, :3]])
    sorted_moves: F64 = moves[np.lexsort(np.round(moves, 6).T)]
    return sorted_moves


@given(start=st.integers(0, 4), width=st.floats(20.0, 300.0))
def test_a_closed_contour_is_cut_alike_from_any_first_edge(start: int, width: float) -> None:
    corners = [(0, 0), (width, 0), (width + 5, 30), (width, 50), (-60, 50)]
    ends = np.roll(closed(*corners), -start, axis=0)
    path, first = made(LineType.CUT, ends), made(LineType.CUT, closed(*corners))
    # Where it starts among its corners is chosen by time later; the work is the same.
    np.testing.assert_allclose(fed_moves(path), fed_moves(first), atol=1e-9)


@thousand
@given(
    side=st.integers(0, 3), share=st.floats(0.3, 0.7), angle=st.floats(15.0, 165.0),
    degrees=angles, length=st.floats(20.0, 60.0), passes=st.integers(1, 4),
)  # fmt: skip
def test_a_groove_leaves_the_board_with_its_whole_width_in_every_pass(
    side: int, share: float, angle: float, degrees: float, length: float, passes: int
) -> None:
    turn = rotation(degrees)
    outline = closed((0, 0), (300, 0), (300, 300), (0, 300)) @ turn.T
    a, b = outline[side]
    along = (b - a) / 300.0
    inward = np.array([-along[1], along[0]])
    point = a + 300.0 * share * along
    ahead = np.cos(np.radians(angle)) * along + np.sin(np.radians(angle)) * inward
    groove = np.array([[point, point + length * ahead]])
    board = replace(BOARD, groove_pass=BOARD.groove_depth / passes)
    line = dieline((LineType.CUT, outline), (LineType.V_GROOVE, groove))
    operation = plan(line, MACHINE, board)[0]
    path = compensate(operation)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    assert len(fed) == 2 * passes
    # In all passes the tip starts or ends at the point where the last corner is off the board.
    tip = tips(path, LineType.V_GROOVE) - point
    width = 2.0 * BOARD.groove_depth
    beside = width / 2.0 * np.array([-ahead[1], ahead[0]])
    for row in (*fed[::2], *(fed[1::2] + 1)):
        out = [float((tip[row] + s * beside) @ inward) for s in (1, -1)]
        assert max(out) == pytest.approx(0.0, abs=1e-9)
    # The other end is inside the board and is not extended.
    for row in (*(fed[::2] + 1), *fed[1::2]):
        np.testing.assert_allclose(tip[row], length * ahead, atol=1e-9)
    depths = BOARD.caliper - path.pose[fed, 2]
    np.testing.assert_allclose(depths, np.repeat(np.arange(1, passes + 1) / passes, 2))


@thousand
@given(place=places, azimuth=angles, length=lengths, apart=st.floats(0.5, 6.0), bulge=bulges)
def test_a_double_crease_is_half_its_width_to_either_side(
    place: tuple[float, float], azimuth: float, length: float, apart: float, bulge: float
) -> None:
    bent = bulge if abs(bulge) > 0.3 else 0.0
    ends = edge(place, azimuth, length)
    line = dieline((LineType.CREASE, ends), bulge={0: bent})
    path = compensate(plan(line, MACHINE, replace(BOARD, double_crease=apart))[0])
    fed = np.flatnonzero(path.motion == Motion.FEED)
    # An arc is divided where the angle to the grain changes the depth.
    tracks = path.track[fed]
    assert len(set(tracks.tolist())) == 2
    assert len(fed) == 2 or bent
    chord = ends[0, 1] - ends[0, 0]
    normal = np.array([-chord[1], chord[0]]) / length
    for row, side in zip(fed, np.where(tracks == tracks[0], 1.0, -1.0), strict=True):
        for pose in path.pose[[row, row + 1], :2]:
            if bent:
                up = (1 - bent**2) / (4 * bent) * length
                spoke = pose - ends[0].mean(axis=0) - up * normal
                radius = length * (1 + bent**2) / (4 * abs(bent))
                off = np.sign(bent) * (radius - np.hypot(*spoke))
            else:
                off = (pose - ends[0, 0]) @ normal
            assert off == pytest.approx(side * apart / 2.0, abs=1e-8)


@thousand
@given(count=st.integers(3, 12), dash=st.floats(4.0, 9.0), gap=st.floats(1.0, 5.9),
       place=places, azimuth=angles)  # fmt: skip
def test_a_dashed_crease_is_creased_like_a_solid_one(
    count: int, dash: float, gap: float, place: tuple[float, float], azimuth: float
) -> None:
    low = np.arange(count) * (dash + gap)
    ahead = rotation(azimuth)[:, 0]
    drawn = np.array(place) + np.stack([low, low + dash], axis=1)[..., None] * ahead
    whole = edge(place, azimuth, low[-1] + dash)
    dashed, solid = made(LineType.CREASE, drawn), made(LineType.CREASE, whole)
    for row in (0, 1, -2, -1):
        np.testing.assert_allclose(dashed.pose[row, :3], solid.pose[row, :3], atol=1e-5)
    assert (dashed.motion == Motion.PLUNGE).sum() == 1


@thousand
@given(width=st.floats(60.0, 300.0), height=st.floats(60.0, 300.0), degrees=angles,
       bridge=st.floats(0.2, 1.5), start=st.integers(0, 3))  # fmt: skip
@example(width=60.0, height=60.0, degrees=121.5, bridge=1.015625, start=1)
def test_bridges_have_the_same_positions_on_a_rotated_board(
    width: float, height: float, degrees: float, bridge: float, start: int
) -> None:
    board = replace(BOARD, bridge_width=bridge, bridge_spacing=150.0)
    ends = np.roll(closed((0, 0), (width, 0), (width, height), (0, height)), -start, axis=0)
    straight = plan(dieline((LineType.CUT, ends)), MACHINE, board)[0]
    turned = plan(dieline((LineType.CUT, ends @ rotation(degrees).T)), MACHINE, board)[0]
    np.testing.assert_allclose(
        turned.paths.start, straight.paths.start @ rotation(degrees).T, atol=1e-6
    )
    path = compensate(straight)
    down = path.pose[1:][path.motion == Motion.PLUNGE][:, :2]
    begun = straight.paths.start[straight.paths.first[:-1]]
    # The blade plunges at the start of each piece and lifts 2.3 mm before its end.
    for place in begun:
        assert np.hypot(*(down - place).T).min() < 1e-9
    stops = straight.paths.end[straight.paths.first[1:] - 1]
    lifted = path.pose[:-1][path.motion == Motion.LIFT][:, :2]
    for place in stops:
        assert np.hypot(*(lifted - place).T).min() == pytest.approx(2.3)


def test_a_tool_of_zero_dimensions_follows_the_edge() -> None:
    line = dieline((LineType.V_GROOVE, edges(((0, 0), (50, 20)))))
    operation = plan(line, MACHINE, BOARD)[0]
    path = compensate(replace(operation, tool=replace(CUTTER, back=0.0, half_width=0.0)))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed, :2], [[0, 0], [50, 20]], atol=1e-12)
    cut = plan(dieline((LineType.CUT, edges(((0, 0), (50, 20))))), MACHINE, BOARD)[0]
    path = compensate(replace(cut, tool=replace(KNIFE, blade_angle=0.0)))
    np.testing.assert_allclose(path.pose[[1, 2], :2], [[0, 0], [50, 20]], atol=1e-12)
