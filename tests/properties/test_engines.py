"""What every engine must satisfy: turn, reverse, mirror, start elsewhere, tip on the line."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from knifetip.compensation.compensate import compensate
from knifetip.model.dieline import LineType
from knifetip.model.toolpath import Motion
from knifetip.planning.plan import plan
from shapes import BOARD, CUTTER, KNIFE, MACHINE, closed, dieline, edges, rotation

angles = st.floats(-360.0, 360.0)
places = st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0))
lengths = st.floats(15.0, 800.0)
bulges = st.floats(-0.9, 0.9).filter(lambda b: abs(b) > 0.01)
straight = st.sampled_from([LineType.CREASE, LineType.V_GROOVE, LineType.CUT, LineType.HALF_CUT])
bent = st.sampled_from([LineType.CREASE, LineType.CUT])
thousand = settings(max_examples=1000, deadline=None)


def edge(place, azimuth, length):
    return np.array([[place, place + length * rotation(azimuth)[:, 0]]], float)


def made(kind, ends, bulge=0.0, grain=90.0):
    line = dieline((kind, ends), bulge={0: bulge})
    return compensate(plan(line, MACHINE, replace(BOARD, grain=grain))[0])


def tips(path, kind):
    """Where the tip is, by sums of this test alone."""
    c = np.radians(path.pose[:, 3])
    ahead, right = np.column_stack([np.cos(c), np.sin(c)]), np.column_stack([np.sin(c), -np.cos(c)])
    if kind == LineType.V_GROOVE:
        return path.pose[:, :2] - 4.0 * right - 1.5 * ahead
    return path.pose[:, :2]


@thousand
@given(kind=straight, place=places, azimuth=angles, length=lengths)
def test_the_tip_is_on_the_line(kind, place, azimuth, length):
    ends = edge(place, azimuth, length)
    path = made(kind, ends)
    fed = np.flatnonzero(path.motion == Motion.FEED)
    along = (ends[0, 1] - ends[0, 0]) / length
    for row in np.concatenate([fed, fed + 1]):
        off = tips(path, kind)[row] - ends[0, 0]
        assert abs(along[0] * off[1] - along[1] * off[0]) < 1e-9
        assert -1e-9 <= along @ off <= length + 1e-9


@thousand
@given(kind=bent, place=places, azimuth=angles, length=lengths, bulge=bulges)
def test_the_tip_is_on_the_arc_and_c_on_its_tangent(kind, place, azimuth, length, bulge):
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
        # On the tangent: C stands square on the spoke, to the side to which the arc turns.
        moment = spoke[0] * np.sin(c) - spoke[1] * np.cos(c)
        assert moment == pytest.approx(np.sign(bulge) * radius, rel=1e-9)


@thousand
@given(kind=straight, place=places, azimuth=angles, length=lengths, degrees=angles)
def test_the_head_turns_with_the_board(kind, place, azimuth, length, degrees):
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
def test_a_groove_drawn_the_other_way_is_the_same_groove(place, azimuth, length):
    ends = edge(place, azimuth, length)
    there, back = made(LineType.V_GROOVE, ends), made(LineType.V_GROOVE, ends[:, ::-1])
    fed = np.flatnonzero(there.motion == Motion.FEED)
    # Its first pass is the other's second.
    np.testing.assert_allclose(there.pose[fed, :2], back.pose[fed[::-1], :2], atol=1e-9)
    np.testing.assert_allclose(there.pose[fed + 1, :2], back.pose[fed[::-1] + 1, :2], atol=1e-9)


@thousand
@given(place=places, azimuth=angles, length=lengths)
def test_a_crease_drawn_the_other_way_ends_where_it_began(place, azimuth, length):
    ends = edge(place, azimuth, length)
    there, back = made(LineType.CREASE, ends), made(LineType.CREASE, ends[:, ::-1])
    np.testing.assert_allclose(there.pose[:, :3], back.pose[::-1, :3], atol=1e-8)


@given(length=lengths)
def test_a_v_cutter_is_not_mirror_proof(length):
    ends = edge((0.0, 0.0), 30.0, length)
    mirror = np.array([1.0, -1.0])
    before, after = made(LineType.V_GROOVE, ends), made(LineType.V_GROOVE, ends * mirror)
    # The blade leans to one side: its mirror image is another tool.
    assert np.abs(after.pose[:, :2] - before.pose[:, :2] * mirror).max() > CUTTER.back


@given(length=lengths, bulge=bulges)
def test_a_knife_is_mirror_proof(length, bulge):
    ends = edge((0.0, 0.0), 30.0, length)
    mirror = np.array([1.0, -1.0])
    before, after = made(LineType.CUT, ends, bulge), made(LineType.CUT, ends * mirror, -bulge)
    np.testing.assert_allclose(after.pose[:, :2], before.pose[:, :2] * mirror, atol=1e-8)
    np.testing.assert_allclose(after.bulge, -before.bulge)


@given(start=st.integers(0, 4), width=st.floats(20.0, 300.0))
def test_a_closed_contour_is_cut_the_same_wherever_its_drawing_begins(start, width):
    corners = [(0, 0), (width, 0), (width + 5, 30), (width, 50), (-60, 50)]
    ends = np.roll(closed(*corners), -start, axis=0)
    path, first = made(LineType.CUT, ends), made(LineType.CUT, closed(*corners))
    np.testing.assert_allclose(path.pose[:, :3], first.pose[:, :3], atol=1e-9)


def test_zero_dimensions_give_the_identity():
    line = dieline((LineType.V_GROOVE, edges(((0, 0), (50, 20)))))
    operation = plan(line, MACHINE, BOARD)[0]
    path = compensate(replace(operation, tool=replace(CUTTER, back=0.0, half_width=0.0)))
    fed = np.flatnonzero(path.motion == Motion.FEED)
    np.testing.assert_allclose(path.pose[fed, :2], [[0, 0], [50, 20]], atol=1e-12)
    cut = plan(dieline((LineType.CUT, edges(((0, 0), (50, 20))))), MACHINE, BOARD)[0]
    path = compensate(replace(cut, tool=replace(KNIFE, blade_angle=0.0)))
    np.testing.assert_allclose(path.pose[[1, 2], :2], [[0, 0], [50, 20]], atol=1e-12)
