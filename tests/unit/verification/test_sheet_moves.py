"""Moves of axes that are not square are found on the sheet; arcs as ellipses."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from knifetip.model.machine import Machine
from knifetip.verification.columns import F64
from knifetip.verification.kinematics import tip_poses
from knifetip.verification.reading.moves import Moves
from knifetip.verification.reading.rs274.reader import READER
from knifetip.verification.reading.sheet_moves import (
    ELLIPSE,
    sheet_moves,
    with_sheet_resolution,
)
from tests.support.shapes import BOARD, MACHINE

#: A line and a clockwise arc of 200 mm by the wheel, whose datum is X 60, and a full circle.
PROGRAM = b"""G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G64 P0.0005 Q0.0005
T2 M6 G43
G0 X100 Y100 Z20 C90
G1 X100 Y1000 F6000
G4 P0
G2 X300 Y800 I0 J-200 C0
G93 G3 X300 Y800 I0 J100 C360 F2
G49
M2
"""


def leaning(degrees: float) -> Machine:
    return replace(MACHINE, squareness=degrees)


def program_moves() -> Moves:
    moves, faults = READER.read(PROGRAM, MACHINE, BOARD)
    assert faults == []
    return moves


def lean(points: F64, degrees: float) -> F64:
    angle = math.radians(degrees)
    result: F64 = points @ np.array([[1.0, 0.0], [math.cos(angle), math.sin(angle)]])
    return result


def test_ends_are_on_the_sheet_and_the_datum_is_of_the_axes() -> None:
    parts, move = sheet_moves(program_moves(), leaning(89.0))
    line = int(np.flatnonzero(move == 1)[0])
    # 1000 mm along Y, 17.4524 mm to the right; the joint includes 60 mm of the wheel.
    assert parts.end[line, :2] == pytest.approx((177.4524, 999.8477), abs=1e-4)
    tip = tip_poses(parts, leaning(89.0), BOARD)
    assert tip.end[line, :2] == pytest.approx((117.4524, 999.8477), abs=1e-4)
    assert np.isnan(parts.start[0]).all()
    np.testing.assert_array_equal(parts.start[1:], parts.end[:-1])


@pytest.mark.parametrize("degrees", [89.0, 89.9, 90.5])
def test_arcs_are_ellipses_within_a_bound_that_is_counted(degrees: float) -> None:
    axes = program_moves()
    parts, move = sheet_moves(axes, leaning(degrees))
    share = np.linspace(0.0, 1.0, 51)
    for row in np.flatnonzero(move >= 2):
        own = int(move[row])
        first = int(np.flatnonzero(move == own)[0])
        count = int((move == own).sum())
        spoke = axes.start[own, :2] - axes.centre[own]
        angle = math.atan2(spoke[1], spoke[0]) + axes.sweep[own] * (row - first + share) / count
        wheel = np.array([60.0, 0.0])
        round_ = math.hypot(*spoke) * np.column_stack([np.cos(angle), np.sin(angle)])
        ellipse = lean(axes.centre[own] - wheel + round_, degrees) + wheel
        radius = math.dist(parts.start[row, :2], parts.centre[row])
        beside = np.hypot(*(ellipse - parts.centre[row]).T) - radius
        assert np.abs(beside).max() <= ELLIPSE
        assert parts.blend[row] == pytest.approx(0.0005 + ELLIPSE)
        assert parts.end[row, :2] == pytest.approx(ellipse[-1], abs=1e-9)
        turn = np.unwrap(np.arctan2(*(ellipse[[0, -1]] - parts.centre[row]).T[::-1]))
        assert parts.sweep[row] == pytest.approx(turn[1] - turn[0], abs=1e-9)
    assert (np.bincount(move)[2:] > 3).all()
    assert parts.blend[1] == 0.0005
    # C turns evenly, and the parts of a timed move take its time together.
    last = np.flatnonzero(move == 3)
    np.testing.assert_allclose(np.diff(parts.end[last, 3]), 360.0 / len(last))
    assert (1.0 / parts.feed[last]).sum() == pytest.approx(0.5)
    assert parts.rested.sum() == axes.rested.sum()
    assert parts.rested[move == 2].sum() == 1


def test_poses_of_parts_are_joined_to_those_of_moves() -> None:
    axes, machine = program_moves(), leaning(89.5)
    parts, move = sheet_moves(axes, machine)
    whole = tip_poses(parts, machine, BOARD).joined(move)
    np.testing.assert_array_equal(whole.line, axes.line)
    np.testing.assert_allclose(whole.end[:, 2:], axes.end[:, 2:] - (MACHINE.stations[1].z, 0.0))
    np.testing.assert_allclose(
        whole.end[:, :2], lean(axes.end[:, :2] - (60.0, 0.0), 89.5), atol=1e-9
    )


def test_square_axes_change_nothing_and_leaning_ones_the_resolution() -> None:
    axes = replace(program_moves(), resolution=0.01)
    assert sheet_moves(axes, MACHINE).moves is axes
    assert with_sheet_resolution(axes, MACHINE) is axes
    # The longer half axis of an ellipse: √(1 + cos 89°).
    found = with_sheet_resolution(axes, leaning(91.0)).resolution
    assert found == pytest.approx(0.01 * math.sqrt(1.0174524))
