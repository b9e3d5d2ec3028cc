"""Curved grooves: refused, or cut as chords within a stated error."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.compensation.vgroove import vgroove_toolpath
from knifetip.errors import CurvedGroove
from knifetip.model.dieline import LineType
from knifetip.model.operation import End, Operation
from knifetip.planning.plan import plan
from tests.support.shapes import BOARD, CUTTER, MACHINE, dieline, edges


def grooved(bulge: float, span: float, error: float) -> Operation:
    line = dieline((LineType.V_GROOVE, edges(((0, 0), (span, 0)))), bulge={0: bulge})
    return plan(line, MACHINE, replace(BOARD, groove_curve=error))[0]


def test_a_board_without_groove_curve_refuses_arcs() -> None:
    with pytest.raises(CurvedGroove, match="straight blade"):
        grooved(0.1, 400.0, 0.0)


RING = dieline(
    (LineType.V_GROOVE, edges(((0, 0), (400, 0)), ((400, 0), (0, 0)))), bulge={0: 1.0, 1: 1.0}
)


def test_a_closed_groove_of_arcs_is_refused_or_cut_as_chords_like_an_open_one() -> None:
    with pytest.raises(CurvedGroove, match="2 V-grooves are arcs"):
        plan(RING, MACHINE, BOARD)
    operation = plan(RING, MACHINE, replace(BOARD, groove_curve=0.2))[0]
    assert (operation.paths.bulge == 0.0).all()
    assert set(operation.source.tolist()) == {0, 1}
    # Each chord continues the one before it all the way round.
    ends = np.concatenate([operation.start, operation.finish])
    assert (ends == End.CONTINUED).all()
    assert len(vgroove_toolpath(operation)) > 0


def test_an_arc_too_tight_for_the_blade_is_refused() -> None:
    # At R 50 the blade's 3 mm leave by 9 / 100 = 0.09 mm even from a chord of no length.
    with pytest.raises(CurvedGroove, match=r"radius of 50\.0 mm\. A straight blade of 3\.00 mm"):
        grooved(1.0, 100.0, 0.08)


@given(
    bulge=st.floats(0.05, 1.0), span=st.floats(600.0, 2000.0), error=st.floats(0.05, 0.5),
    left=st.booleans(),
)  # fmt: skip
def test_chords_and_blade_ends_stay_within_the_error_of_the_arc(
    bulge: float, span: float, error: float, left: bool
) -> None:
    operation = grooved(bulge if left else -bulge, span, error)
    radius = span * (1 + bulge**2) / (4 * bulge)
    middle = np.array([span / 2, (1 - bulge**2) / (4 * bulge) * span * (1 if left else -1)])
    paths = operation.paths
    np.testing.assert_allclose(np.hypot(*(paths.start - middle).T), radius)
    half = (paths.start + paths.end) / 2.0
    sagitta = radius - np.hypot(*(half - middle).T)
    chord = paths.end - paths.start
    length = np.hypot(*chord.T)
    tip = paths.end + chord / length[:, None] * 2.0 * CUTTER.half_width
    assert sagitta.max() <= error + 1e-9
    assert (np.hypot(*(tip - middle).T) - radius).max() <= error + 1e-9
    # Only the groove's own two ends are free.
    ends = np.concatenate([operation.start, operation.finish])
    assert (ends == End.FREE).sum() == 2
    assert set(operation.source.tolist()) == {0}
