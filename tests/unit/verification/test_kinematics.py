import math

import numpy as np
import pytest

from knifetip.model.machine import Station
from knifetip.model.tool import Knife
from knifetip.verification.curves.curve import arc_curves, azimuth_at, line_curves, point_at
from knifetip.verification.kinematics import tip_offset
from knifetip.verification.tools import OperationKind
from knifetip.verification.verify import trace_program
from tests.support.programs.handwritten import (
    BOARD,
    LINUXCNC,
    MACHINE,
    cutter_program,
    knife_program,
)


def test_the_tip_of_a_v_cutter_has_its_offset_from_the_head() -> None:
    station = MACHINE.station(3)
    np.testing.assert_allclose(tip_offset(np.array([0.0]), station), [[-1.5, 6.0]], atol=1e-12)
    np.testing.assert_allclose(tip_offset(np.array([90.0]), station), [[-6.0, -1.5]], atol=1e-12)
    np.testing.assert_allclose(tip_offset(np.array([180.0]), station), [[1.5, -6.0]], atol=1e-12)


def test_the_tip_of_a_drag_knife_is_behind_its_axis() -> None:
    drag = Station(1, "Drag", Knife(10.0, 1.0, 15.0, 1.0, 1.0, trail=2.0), 0, 0, 0, 0, -1)
    np.testing.assert_allclose(tip_offset(np.array([90.0]), drag), [[0.0, -2.0]], atol=1e-12)


def test_the_tips_of_the_hand_written_program_are_at_the_planned_points() -> None:
    _, tip, work = trace_program(LINUXCNC, MACHINE, BOARD)
    row = {int(line): index for index, line in enumerate(tip.line)}
    np.testing.assert_allclose(tip.end[row[18]], [90.0, 65.6, 1.4, 90.0], atol=1e-9)
    np.testing.assert_allclose(tip.end[row[29]], [80.0, 50.0, 0.7, 0.0], atol=1e-9)
    # Before the plunge the tip is on the line of the blade: 3.3 higher and 3.3 to the right.
    np.testing.assert_allclose(tip.end[row[27]], [40.0, 46.7, 4.0, 0.0], atol=1e-9)
    np.testing.assert_allclose(tip.end[row[33]], [40.0, 50.0, 0.7, 180.0], atol=1e-9)
    assert [OperationKind(int(trade)) for trade in np.unique(work.operation)] == list(
        OperationKind
    )[:4]
    ends = work.ends()
    np.testing.assert_allclose(ends[0][0], [90.0, 34.4], atol=1e-9)


def test_a_plunge_and_a_lift_give_one_point() -> None:
    text = knife_program("G0 X50 Y60 Z20 C0", "G0 Z4", "G1 Z-0.3 F6000", "G1 Z4")
    _, _, work = trace_program(text, MACHINE, BOARD)
    assert len(work.z) == 1
    assert work.curve[0, 5] == 0.0
    np.testing.assert_array_equal(work.ends()[1], [[50.0, 60.0]])


def test_each_stretch_without_lifting_is_a_track() -> None:
    _, _, work = trace_program(LINUXCNC, MACHINE, BOARD)
    assert len(np.unique(work.track)) == 7
    assert (np.diff(work.track) >= 0).all()


def test_the_chords_of_a_turning_v_cutter_are_within_a_tenth_of_a_micrometre() -> None:
    text = cutter_program(
        "G0 X0 Y0 Z20 C0", "G0 Z4", "G1 Y3.3 Z0.7 F3000", "G93 G1 X10 C90 F100", "G94 G1 Z4 F3000"
    )
    _, _, work = trace_program(text, MACHINE, BOARD)
    head = np.linspace([0.0, 3.3, 0.0], [10.0, 3.3, 90.0], 50)
    tips = head[:, :2] + tip_offset(head[:, 2], MACHINE.station(3))
    start, end = work.ends()
    chain = np.vstack([start, end[-1:]])
    step = np.diff(chain, axis=0)
    for point in tips:
        along = np.clip(((point - chain[:-1]) * step).sum(axis=1) / (step**2).sum(axis=1), 0, 1)
        off = np.hypot(*(point - chain[:-1] - along[:, None] * step).T).min()
        assert off < 1e-4
    np.testing.assert_allclose(work.heading[-1, 1], 90.0)


@pytest.mark.parametrize("sweep", [1.0, -1.0])
def test_points_and_directions_along_an_arc(sweep: float) -> None:
    quarter = sweep * math.pi / 2.0
    curve = arc_curves(np.array([[5.0, 5.0]]), np.array([[7.0, 5.0]]), np.array([quarter]))
    np.testing.assert_allclose(curve[0, 5], math.pi)
    np.testing.assert_allclose(point_at(curve, curve[:, 5]), [[5.0, 5.0 + 2.0 * sweep]])
    np.testing.assert_allclose(azimuth_at(curve, np.zeros(1)), 90.0 * sweep)
    turned = azimuth_at(curve, curve[:, 5]) % 360.0
    np.testing.assert_allclose(turned, 180.0)


def test_a_line_without_length_is_a_point() -> None:
    curve = line_curves(np.array([[1.0, 2.0]]), np.array([[1.0, 2.0]]))
    np.testing.assert_array_equal(point_at(curve, np.zeros(1)), [[1.0, 2.0]])
