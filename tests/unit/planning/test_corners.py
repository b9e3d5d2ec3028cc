"""Corner choices of the user, matched with the corners of contours."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.errors import PlanError
from knifetip.fields import InvalidFields, check_fields
from knifetip.library import load
from knifetip.model.corners import AS_OTHERS, CornerAt, Corners
from knifetip.model.dieline import LineType
from knifetip.model.operation import Operation
from knifetip.planning.plan import plan
from tests.support.shapes import closed, dieline

ROUTER = load.machine("router-table")
BOARD = load.board("greyboard-3.0")
#: An L whose inside corner is at (200, 200), with a hole in it.
BLANK = closed((100, 100), (300, 100), (300, 200), (200, 200), (200, 250), (100, 250))
HOLE = closed((120, 120), (170, 120), (170, 160), (120, 160))
LINE = dieline((LineType.CUT, BLANK), (LineType.CUT, HOLE))


def outer(corners: Corners) -> Operation:
    return plan(LINE, ROUTER, BOARD, corners)[-1]


def at(operation: Operation, x: float, y: float) -> tuple[int, float]:
    """Return type and k at the corner at (x, y)."""
    (row,) = np.flatnonzero((operation.paths.start == (x, y)).all(axis=1))
    return int(operation.corner_at[row]), float(operation.k_at[row])


def test_without_a_choice_corners_have_the_type_of_the_operation() -> None:
    operation = plan(LINE, ROUTER, BOARD)[-1]
    assert (operation.corner, operation.k, operation.interference) == ("auto", 0.5, "trim")
    assert (operation.corner_at == AS_OTHERS).all()


def test_type_k_and_interference_apply_to_every_milling_operation() -> None:
    operations = plan(LINE, ROUTER, BOARD, Corners(type="D", k=0.3, interference="refuse"))
    settings = {(one.corner, one.k, one.interference) for one in operations}
    assert settings == {("D", 0.3, "refuse")}


def test_a_choice_applies_to_its_corner_only() -> None:
    operation = outer(
        Corners(
            type="D",
            at=(CornerAt(x=300.2, y=99.8, type="C", k=0.25), CornerAt(x=100, y=250, type="B")),
        )
    )
    assert at(operation, 300, 100) == (1, 0.25)
    kind, k = at(operation, 100, 250)
    assert (kind, np.isnan(k)) == (0, True)
    assert (operation.corner_at == AS_OTHERS).sum() == 4


def test_positions_are_in_drawing_coordinates() -> None:
    moved = replace(LINE, ends=LINE.ends + np.array([20.0, 30.0]))
    corners = Corners(at=(CornerAt(x=300, y=100, type="C"),))
    operation = plan(moved, ROUTER, BOARD, corners, placement=(20.0, 30.0))[-1]
    assert at(operation, 320, 130)[0] == 1


def test_a_position_without_a_corner_is_refused_with_the_nearest_corners() -> None:
    with pytest.raises(
        PlanError, match=r"within 0\.5 mm of X 299 mm, Y 100 mm.* 1\.00 mm away"
    ) as caught:
        outer(Corners(at=(CornerAt(x=299, y=100, type="C"),)))
    assert "(300.00, 100.00)" in caught.value.hint


def test_a_choice_for_an_inner_corner_is_refused() -> None:
    with pytest.raises(PlanError, match="X 200 mm, Y 200 mm is an inside corner"):
        outer(Corners(at=(CornerAt(x=200, y=200, type="C"),)))


def test_every_corner_of_a_hole_is_an_inner_corner() -> None:
    with pytest.raises(PlanError, match="inside corner"):
        outer(Corners(at=(CornerAt(x=120, y=120, type="D"),)))


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"type": "E"}, "'E'"),
        ({"type": "D", "k": 1.0}, "k.*1"),
        ({"type": "D", "k": float("nan")}, "k.*nan"),
        ({"interference": "ignore"}, "'ignore'"),
        ({"at": [{"x": 100, "y": 100, "type": "X"}]}, "at 1.*'X'"),
        ({"at": [{"x": 100, "y": 100, "type": "D", "k": 0.0}]}, "at 1.*k.*0"),
        ({"at": [{"x": float("inf"), "y": 100, "type": "D"}]}, "at 1.*x"),
    ],
)
def test_an_invalid_choice_is_refused(fields: dict[str, Any], words: str) -> None:
    with pytest.raises(InvalidFields, match=words):
        check_fields(Corners, fields)


def test_a_table_with_a_knife_has_no_corner_types() -> None:
    with pytest.raises(PlanError, match="has no rotating cutter"):
        plan(LINE, load.machine("demo-table"), BOARD, Corners(type="D"))
