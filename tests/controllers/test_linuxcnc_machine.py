"""Programs on a complete LinuxCNC with its planner: the joints follow the expected path."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.gateway.controller import SafeState
from knifetip.gateway.linuxcnc.driver import dial
from knifetip.post.emit import process
from tests.controllers.hand_written import BLANK, TABLE, ToolpathBuilder, add_creases, add_cuts
from tests.controllers.linuxcnc_machine import missing_requirement, running
from tests.controllers.linuxcnc_rs274 import F64, distances_beside_and_past

SKIP_REASON = missing_requirement()

pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]


async def test_joints_are_programmed_plus_datum_and_the_knife_stays_on_its_line() -> None:
    with running(TABLE) as machine:
        machine.make_ready()
        controller = await dial(machine.address, SafeState.from_machine(TABLE))
        mark = machine.mark()
        await controller.run(add_creases(add_cuts(ToolpathBuilder())).program())
        await controller.close()
        assert machine.comes_to_rest()
        seen = machine.samples(mark)[:, :4]
    # The wheel ends at (160, 73.9, 20) with heading 90; its datum is X +60, Z -1.5.
    np.testing.assert_allclose(seen[-1], [220.0, 73.9, 18.5, 90.0], atol=1e-4)
    # Only the knife, whose datum is zero, goes below the top of the mat.
    cut = seen[seen[:, 2] < -0.2999]
    assert len(cut) > 20
    # Without exact stops where C starts and stops turning, it would be 0.53.
    assert distance_from_blank(cut[:, :2]) < 0.006  # path tolerance P 0.005 plus rounding
    assert np.ptp(cut[:, 3]) > 180.0


async def test_the_knife_stays_on_its_line_of_a_leaning_table() -> None:
    leaning = replace(TABLE, squareness=89.5)
    path = add_cuts(ToolpathBuilder()).toolpath()
    text = process(path, leaning, "linuxcnc", notes=["placement X20 Y20"]).text
    with running(TABLE) as machine:
        machine.make_ready()
        controller = await dial(machine.address, SafeState.from_machine(TABLE))
        mark = machine.mark()
        await controller.run(text)
        await controller.close()
        assert machine.comes_to_rest()
        seen = machine.samples(mark)[:, :4]
    joints = seen[seen[:, 2] < -0.2999, :2]
    assert len(joints) > 20
    angle = np.radians(89.5)
    assert distance_from_blank(joints @ [[1.0, 0.0], [np.cos(angle), np.sin(angle)]]) < 0.006
    assert distance_from_blank(joints) > 0.1


def distance_from_blank(points: F64) -> float:
    """Return the greatest distance of points from the cuts of the blank (mm)."""
    ends, bulge, _ = BLANK
    off = np.full(len(points), np.inf)
    for edge, bend in zip(np.asarray(ends, float) + 20.0, bulge, strict=True):
        aside, past = distances_beside_and_past(
            points, np.tile(edge, (len(points), 1, 1)), np.full(len(points), bend)
        )
        off = np.minimum(off, np.hypot(aside, past))
    return float(off.max())
