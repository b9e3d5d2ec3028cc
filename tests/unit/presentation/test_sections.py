"""Sections of the board against dimensions and trigonometry stated here."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from knifetip.library import load
from knifetip.model.toolpath import Motion
from knifetip.presentation.sections import EdgeSection, edge_section

MACHINE = load.machine("demo-table")
BOARD = load.board("greyboard-2.0")


def toolpath(station: int, *tips: float) -> dict[str, Any]:
    """Return the arrays of a path that makes edge 0 once at each height of the tip (mm)."""
    rows = len(tips)
    pose = np.zeros((rows + 1, 4))
    pose[1:, 2] = tips
    pose[0, 2] = tips[0]
    return {
        "pose": pose,
        "motion": np.full(rows, Motion.FEED, np.uint8),
        "source": np.zeros(rows, np.int32),
        "tool": np.full(rows, station, np.uint8),
        # Edge 1 is made as edge 0, and edge 2 is not made.
        "made_as": np.array([0, 0, -1], np.int32),
    }


def verdict(**columns: float) -> dict[str, Any]:
    names = ("deviation", "overcut", "uncut", "setback", "width", "web", "flank")
    return {name: np.full(3, columns.get(name, 0.0)) for name in names}


def section(path: dict[str, Any], edge: int = 0, **measured: float) -> EdgeSection:
    return edge_section(edge, path, verdict(**measured), MACHINE, BOARD)


def test_a_groove_has_its_web_its_width_and_the_angle_of_the_fold() -> None:
    # Two passes of equal depth for the flanks; 2 mm board, tip 0.4 mm above the mat.
    found = section(toolpath(3, 0.4, 0.4), width=3.21, web=0.4, overcut=2.5)
    (tool,) = found.tools
    assert (tool.kind, tool.shape, tool.passes) == ("v-cutter", "groove", 1)
    assert tool.depth == pytest.approx(1.6)
    assert tool.base == 0.4
    # The width is the one that the verifier has measured.
    assert (tool.cross.top_width, tool.cross.flank_angle) == (3.21, 45.0)
    assert (tool.cross.fold_angle, found.required_fold) == (90.0, 90.0)
    assert found.figures["overcut"] == 2.5
    # Without a measurement it follows from depth and tilt.
    (tool,) = section(toolpath(3, 0.4)).tools
    assert tool.cross.top_width == pytest.approx(2 * 1.6 * math.tan(math.radians(45.0)))


def test_a_crease_has_a_rim_a_contact_and_a_base() -> None:
    (tool,) = section(toolpath(2, 1.2)).tools
    assert (tool.cross.rim_width, tool.cross.wheel_radius) == (0.7, 15.0)
    assert [tool.depth, tool.base, tool.beyond] == pytest.approx([0.8, 1.2, 0.0])
    # Half a chord of a circle of 15 mm at 0.8 mm below its rim.
    chord = 2 * math.sqrt(15.0**2 - (15.0 - 0.8) ** 2)
    assert tool.cross.contact_length == pytest.approx(chord)


def test_a_cut_ends_in_the_mat_and_runs_ahead_in_the_top_face() -> None:
    (tool,) = section(toolpath(1, 1.0, -0.3)).tools
    assert [tool.depth, tool.beyond, tool.base, tool.passes] == pytest.approx([2.0, 0.3, 0.0, 2])
    assert tool.cross.blade_width == 3.0
    assert tool.cross.blade_lead == pytest.approx(2.0 * math.tan(math.radians(10.0)))


def test_an_edge_is_made_as_another_one_or_not_at_all() -> None:
    path = toolpath(1, -0.3)
    assert (section(path, 1).made_as, len(section(path, 1).tools)) == (0, 1)
    assert (section(path, 2).made_as, section(path, 2).tools) == (-1, [])


def test_tools_follow_in_the_order_of_the_work() -> None:
    first, then = toolpath(2, 1.2), toolpath(1, -0.3)
    both = {
        name: np.concatenate([first[name], then[name]]) for name in ("motion", "source", "tool")
    }
    pose = np.array([[0, 0, z, 0] for z in (1.2, 1.2, -0.3)], float)
    found = section({**both, "pose": pose, "made_as": first["made_as"]})
    assert [tool.station for tool in found.tools] == [2, 1]


def test_a_laser_cuts_through_from_the_height_of_its_focus() -> None:
    machine = load.machine("laser-table")
    (station,) = (one for one in machine.stations if one.is_beam)
    path = toolpath(station.number, 5.0)
    (tool,) = edge_section(0, path, verdict(), machine, BOARD).tools
    assert (tool.shape, tool.depth, tool.base) == ("disc", 2.0, 0.0)
    assert tool.cross.top_width == station.tool.dimensions["kerf"]
