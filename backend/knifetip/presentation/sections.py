"""Sections of the board across an edge: what each tool of a program makes there, to scale."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.columns import I64
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.tool import kind_of
from knifetip.model.tool.cross_section import CrossSection
from knifetip.model.toolpath import Motion

Columns = Mapping[str, NDArray[Any]]

#: The figures of a verdict about an edge that a section states.
FIGURES: Final = (
    *("deviation", "overcut", "uncut", "setback", "flank", "top_overcut", "bottom_uncut"),
    "slit_length",
)
#: Depths that differ by less belong to one pass (mm).
_SAME_DEPTH: Final = 0.01


class ToolSection(NamedTuple):
    """What the tool of one station makes of the board across an edge (mm and degrees)."""

    station: int
    name: str  #: of the station
    kind: str  #: of the tool
    shape: str  #: of the tool's mark: line, disc, groove or wheel
    depth: float  #: of the deepest pass below the top face, at most the caliper
    beyond: float  #: by which the tip is below the bottom face
    base: float  #: thickness of the board that remains below
    passes: int
    cross: CrossSection


class EdgeSection(NamedTuple):
    """The section of the board across an edge of a drawing."""

    edge: int
    made_as: int  #: edge in whose name it is made; -1 if the program does not make it
    caliper: float
    required_fold: float  #: angle by which the board must fold at a V-groove
    tools: list[ToolSection]  #: in the order of the work
    figures: dict[str, float]  #: of ``FIGURES``, those that the verdict has


def edge_section(
    edge: int, toolpath: Columns, verdict: Columns, machine: Machine, board: Board
) -> EdgeSection:
    """Return the section of the board across an edge, as the program makes it.

    Parameters
    ----------
    edge
        Row of the edge in the drawing.
    toolpath, verdict
        The unpacked arrays of the tool path and of the verdict of a job.
    machine, board
        The machine and the board for which the job is compiled.
    """
    made = int(toolpath["made_as"][edge]) if "made_as" in toolpath else edge
    feed = toolpath["motion"] == Motion.FEED
    rows = np.flatnonzero(feed & (toolpath["source"] == made)) if made >= 0 else np.zeros(0, int)
    stations = toolpath["tool"][rows]
    order = np.unique(stations, return_index=True)[1]
    tools = [
        _tool_section(rows[stations == stations[first]], toolpath, machine, board)
        for first in np.sort(order)
    ]
    figures = {name: float(verdict[name][edge]) for name in FIGURES if name in verdict}
    tools = [_measured(one, edge, verdict) for one in tools]
    return EdgeSection(edge, made if tools else -1, board.caliper, board.fold_angle, tools, figures)


def _tool_section(rows: I64, toolpath: Columns, machine: Machine, board: Board) -> ToolSection:
    """Return the section that the tool of some rows of a toolpath makes, from its heights."""
    station = machine.station(int(toolpath["tool"][rows[0]]))
    tool, caliper = station.tool, board.caliper
    mark = tool.footprint
    low = np.minimum(toolpath["pose"][rows, 2], toolpath["pose"][rows + 1, 2])
    # The height of a tool without a tip, such as that of a laser's focus, is no depth.
    deepest = caliper if mark.any_height else max(caliper - float(low.min()), 0.0)
    depth = min(deepest, caliper)
    passes = 1 if mark.any_height else len(np.unique(np.round(low / _SAME_DEPTH)))
    return ToolSection(
        station.number,
        station.name,
        kind_of(tool).name,
        mark.shape,
        depth,
        deepest - depth,
        caliper - depth,
        passes,
        tool.cross_section(depth),
    )


def _measured(section: ToolSection, edge: int, verdict: Columns) -> ToolSection:
    """Return a groove with the width and the web that the verifier has measured."""
    if section.shape != "groove" or "width" not in verdict or verdict["width"][edge] <= 0.0:
        return section
    cross = section.cross._replace(top_width=float(verdict["width"][edge]))
    return section._replace(cross=cross, base=float(verdict["web"][edge]))
