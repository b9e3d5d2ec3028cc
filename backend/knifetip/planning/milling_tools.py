"""milling_tools: the cutters of a job of which the user has chosen several, each for some contours.

A contour has one offset, so one cutter makes it.  Contours of one cutter that face each other have
one offset too, which keeps the disc out of both; contours of different cutters have separate ones,
so they must be farther apart than the disc is wide.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.model.tool import DiscTool
from knifetip.planning.facing_contours import facing_pairs
from knifetip.planning.setup import Setup


@dataclass(frozen=True, eq=False, slots=True)
class MillingTools:
    """The cutters that make m cuts."""

    setups: tuple[Setup, ...]  #: one for each cutter
    of_cut: I64  #: (m,) index in ``setups`` of the cutter of each cut
    chosen: Bool  #: (m,) mask of the cuts for which the user has chosen it

    @property
    def radii(self) -> F64:
        """Radius of each cutter (mm)."""
        tools = [setup.station.tool for setup in self.setups]
        return np.array([tool.radius for tool in tools if isinstance(tool, DiscTool)])

    @property
    def widest(self) -> float:
        """Radius of the thickest cutter (mm)."""
        return float(self.radii.max(initial=0.0))


def milling_tools(setup: Setup, rows: I32) -> MillingTools:
    """Return the cutters that make m cuts, whose indices in the dieline are ``rows``, (m,)."""
    of_cut = np.zeros(len(rows), np.int64)
    setups: list[Setup] = []
    for own, own_setup in setup.tool_groups(rows):
        of_cut[own] = len(setups)
        setups.append(own_setup)
    return MillingTools(tuple(setups), of_cut, setup.chosen_stations(rows) > 0)


def tools_of_contours(tools: MillingTools, row: I64, contour: I64, source: I32) -> I64:
    """Return the index of the cutter that makes each of q pieces of cuts, (q,).

    A cutter that is chosen for one edge of a contour makes the whole contour.

    Parameters
    ----------
    row, contour : (q,)
        Cut of which each piece is a part, and its contour; -1 for none.
    source : (q,)
        Index in the dieline of the edge of each piece.

    Raises
    ------
    PlanError
        Different cutters are chosen for edges of one contour.
    """
    tool, count = tools.of_cut[row], len(tools.setups)
    if count == 1:
        return tool
    given = np.flatnonzero(tools.chosen[row] & (contour >= 0))
    lowest = np.full(int(contour.max(initial=-1)) + 2, count)
    np.minimum.at(lowest, contour[given], tool[given])
    for piece in given[tool[given] != lowest[contour[given]]][:1]:
        same = given[contour[given] == contour[piece]]
        other = same[tool[same] == lowest[contour[piece]]][0]
        raise PlanError(
            "tool-choice.several", edge=source[piece], other=source[other], at_edges=source[same]
        )
    of_contour = lowest[contour]
    result: I64 = np.where((contour >= 0) & (of_contour < count), of_contour, tool)
    return result


def check_facing_tools(
    tools: MillingTools, paths: Paths, tool: I64, milled: Bool, source: I32
) -> None:
    """Raise ``PlanError`` if contours of different cutters are nearer than a cutter is wide.

    Parameters
    ----------
    paths
        Paths with the cutter on their left.
    tool, milled : (p,)
        Cutter of each path, and mask of the closed paths that separate a part from waste.
    source : (n,)
        Index in the dieline of the edge of each segment.
    """
    if len(tools.setups) == 1:
        return
    one, other, distance = facing_pairs(paths, milled, 2.0 * tools.widest)
    diameter = 2.0 * np.maximum(tools.radii[tool[one]], tools.radii[tool[other]])
    for k in np.flatnonzero((tool[one] != tool[other]) & (distance < diameter))[:1]:
        edge, facing = source[paths.first[one[k]]], source[paths.first[other[k]]]
        raise PlanError(
            "tool-choice.facing",
            edge=edge,
            other=facing,
            distance=distance[k],
            diameter=diameter[k],
            at_edges=[edge, facing],
        )
