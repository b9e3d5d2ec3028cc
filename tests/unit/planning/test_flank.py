"""V-grooves beside cuts."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.errors import FlankOutside
from knifetip.model.dieline import LineType
from knifetip.planning.plan import plan
from shapes import BOARD, MACHINE, closed, dieline, edges

# 1 mm deep with a blade at 45°: the flanks reach 1 mm to either side.
OUTLINE = (LineType.CUT, closed((0, 0), (200, 0), (200, 100), (0, 100)))


def planned(groove, *more, bulge=None):
    return plan(dieline(OUTLINE, (LineType.V_GROOVE, groove), *more, bulge=bulge), MACHINE, BOARD)


def test_a_groove_across_the_board_may_run_out_at_its_ends():
    assert planned(edges(((50, 0), (60, 100))))


def test_a_groove_beside_the_edge_is_refused_where_its_flank_would_leave():
    assert planned(edges(((0, 1.1), (200, 1.1))))
    slanted = edges(((10, 0.5), (190, 2.0)))
    with pytest.raises(FlankOutside, match=r"edge 4 is 2\.00 mm wide"):
        planned(slanted)


def test_a_hole_beside_a_groove_is_refused():
    hole = (LineType.CUT, edges(((100, 50), (110, 50)), ((110, 50), (100, 50))))
    beside = edges(((20, 55.5), (180, 55.5)))
    with pytest.raises(FlankOutside):
        planned(beside, hole, bulge={5: 1.0, 6: 1.0})
    assert planned(beside + np.array([0.0, 2.0]), hole, bulge={5: 1.0, 6: 1.0})
