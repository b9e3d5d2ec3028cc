"""The depth of creases along curves: 0.4 along the grain (Y), 0.6 across it (X)."""

from __future__ import annotations

from dataclasses import replace
from math import radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.crease import crease_toolpath
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.operation import Operation
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, MACHINE, dieline, edges

#: Greatest difference of depth that the verifier permits is 0.005 mm.
MOST = 0.004
QUARTER = tan(radians(90.0) / 4.0)


def planned(
    bulge: float, board: Board = BOARD, end: tuple[float, float] = (50.0, 50.0)
) -> Operation:
    ends = edges(((0.0, 0.0), end))
    return plan(dieline((LineType.CREASE, ends), bulge={0: bulge}), MACHINE, board)[0]


def depth_of_tangents(tangents: F64, board: Board = BOARD) -> F64:
    across = np.arctan2(tangents[:, 1], tangents[:, 0]) - radians(board.grain)
    result: F64 = board.crease_along + (board.crease_across - board.crease_along) * (
        np.sin(across) ** 2
    )
    return result


@given(
    sweep=st.floats(-350.0, 350.0).filter(lambda sweep: abs(sweep) > 0.1),
    grain=st.floats(0.0, 180.0),
    across=st.floats(0.1, 1.4),
)
def test_the_depth_along_an_arc_differs_from_the_rule_by_less_than_is_permitted(
    sweep: float, grain: float, across: float
) -> None:
    board = replace(BOARD, grain=grain, crease_across=across)
    operation = planned(tan(radians(sweep) / 4.0), board)
    paths = operation.paths
    for fraction in np.linspace(0.0, 1.0, 5):
        tangents = arc.tangent_at(
            paths.start, paths.end, paths.bulge, np.full(len(paths.bulge), fraction)
        )
        error = operation.depth[:, 0] - depth_of_tangents(tangents, board)
        assert np.abs(error).max() <= MOST + 1e-9


def test_the_pieces_of_an_arc_are_one_path_on_the_arc() -> None:
    operation = planned(QUARTER)
    paths = operation.paths
    assert len(paths) == 1
    # sin(θ/2) = 0.004 / 0.2 gives θ = 2.29° and 40 pieces.
    assert len(paths.bulge) == 40
    assert (paths.start[1:] == paths.end[:-1]).all()
    assert (paths.start[0] == [0.0, 0.0]).all()
    assert (paths.end[-1] == [50.0, 50.0]).all()
    # The centre of the arc is (0, 50).
    np.testing.assert_allclose(np.hypot(*(paths.end - [0.0, 50.0]).T), 50.0)
    np.testing.assert_allclose(arc.radius(paths.start, paths.end, paths.bulge), 50.0)
    assert set(operation.source.tolist()) == {0}


def test_creases_of_one_depth_are_not_split() -> None:
    assert len(planned(0.0).paths.bulge) == 1
    same = replace(BOARD, crease_across=BOARD.crease_along)
    assert len(planned(QUARTER, same).paths.bulge) == 1
    # From 89° to 91° the depth changes by less than the permitted error.
    narrow = tan(radians(2.0) / 4.0)
    assert len(planned(narrow, end=(0.0, 50.0)).paths.bulge) == 1


def test_the_setback_of_an_arc_follows_from_the_tangents_at_its_ends() -> None:
    path = crease_toolpath(planned(QUARTER))
    length = 25.0 * np.pi
    for row, depth in ((1, 0.6), (-2, 0.4)):
        back = sqrt(depth * (30.0 - depth)) + 0.2
        position = back if row == 1 else length - back
        angle = position / 50.0
        expected = [50.0 * sin(angle), 50.0 - 50.0 * np.cos(angle)]
        assert path.pose[row, :2] == pytest.approx(expected, abs=1e-9)


def test_a_double_crease_on_an_arc_follows_the_rule_on_both_lines() -> None:
    operation = planned(QUARTER, replace(BOARD, double_crease=2.0))
    paths = operation.paths
    assert len(paths) == 2
    assert np.diff(paths.first).tolist() == [40, 40]
    for tangents in arc.tangents(paths.start, paths.end, paths.bulge):
        error = operation.depth[:, 0] - depth_of_tangents(tangents)
        assert np.abs(error).max() <= MOST + 1e-9
