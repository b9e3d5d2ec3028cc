"""Programs on a complete LinuxCNC with its planner: the joints follow the expected path."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.gateway.controller import SafeState
from knifetip.gateway.linuxcnc.driver import dial
from tests.controllers.hand_written import BLANK, TABLE, ToolpathBuilder, add_creases, add_cuts
from tests.controllers.linuxcnc_machine import missing_requirement, running
from tests.controllers.linuxcnc_rs274 import distances_beside_and_past

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
    ends, bulge, _ = BLANK
    edges = np.asarray(ends, float) + 20.0
    off = np.full(len(cut), np.inf)
    for edge, bend in zip(edges, bulge, strict=True):
        aside, past = distances_beside_and_past(
            cut[:, :2], np.tile(edge, (len(cut), 1, 1)), np.full(len(cut), bend)
        )
        off = np.minimum(off, np.hypot(aside, past))
    # Without exact stops where C starts and stops turning, it would be 0.53.
    assert off.max() < 0.006  # path tolerance P 0.005 plus rounding
    assert np.ptp(cut[:, 3]) > 180.0
