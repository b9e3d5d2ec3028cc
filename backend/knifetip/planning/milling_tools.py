"""milling_tools: the cutters of a job of which the user has chosen several, each for some contours.

A contour has one offset, so one cutter makes it, with one lead-in.  Contours of one cutter that
face each other have one offset too, which keeps the disc out of both; contours of different cutters
or lead-ins have separate ones, so they must be farther apart than the disc is wide.
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
    """The cutters, with their lead-ins, that make q pieces of cuts."""

    setups: tuple[Setup, ...]  #: one for each cutter and lead-in
    of_piece: I64  #: (q,) index in ``setups`` of each piece

    @property
    def radii(self) -> F64:
        """Radius of the cutter of each setup (mm)."""
        tools = [setup.station.tool for setup in self.setups]
        return np.array([tool.radius for tool in tools if isinstance(tool, DiscTool)])


def cutter_radii(setup: Setup, rows: I32) -> F64:
    """Return the radius of the cutter that makes each of m cuts, (m,) mm.

    ``rows`` (m,): indices of the cuts in the dieline.
    """
    radii = np.zeros(len(rows))
    for own, own_setup in setup.tool_groups(rows):
        assert isinstance(own_setup.station.tool, DiscTool)
        radii[own] = own_setup.station.tool.radius
    return radii


def milling_tools(setup: Setup, source: I32, contour: I64) -> MillingTools:
    """Return the cutters and lead-ins that make q pieces of cuts.

    A cutter or a lead-in that is chosen for one edge of a contour is for the whole contour.

    Parameters
    ----------
    source : (q,)
        Index in the dieline of the edge of each piece.
    contour : (q,)
        Contour of each piece; -1 for none.

    Raises
    ------
    PlanError
        Different cutters or lead-ins are chosen for edges of one contour, or a lead-in is too short
        for the cutter.
    """
    station = setup.chosen_stations(source)
    station = _of_contours(station, source, contour, "tool-choice.several")
    station = np.where(station > 0, station, setup.station.number)
    lead = _of_contours(setup.chosen_leads(source), source, contour, "lead-choice.several")
    pairs, of_piece = np.unique(np.column_stack([station, lead]), axis=0, return_inverse=True)
    of_piece = of_piece.ravel().astype(np.int64)
    setups = []
    for index, (number, lead_number) in enumerate(pairs.tolist()):
        own_setup = setup.with_station(number).with_lead(lead_number)
        fault = own_setup.station.tool.fault
        if lead_number and fault is not None:
            own = source[of_piece == index]
            raise PlanError("lead-choice.bad", edge=own[0], reason=fault, at_edges=own)
        setups.append(own_setup)
    return MillingTools(tuple(setups), of_piece)


def _of_contours(number: I64, source: I32, contour: I64, code: str) -> I64:
    """Return what is chosen for each of q pieces, (q,), 0 for nothing, after a choice for one piece
    has become that of its contour.

    ``number`` (q,): what is chosen for the edge of each piece, 0 for nothing.
    ``code``: code of the error if different numbers are chosen for one contour.
    """
    given = np.flatnonzero((number > 0) & (contour >= 0))
    if len(given) == 0:
        return number
    highest = np.zeros(int(contour.max()) + 2, np.int64)
    np.maximum.at(highest, contour[given], number[given])
    for piece in given[number[given] != highest[contour[given]]][:1]:
        same = given[contour[given] == contour[piece]]
        other = same[number[same] == highest[contour[piece]]][0]
        raise PlanError(code, edge=source[piece], other=source[other], at_edges=source[same])
    result: I64 = np.where(contour >= 0, highest[contour], number)
    return result


def check_facing_tools(
    tools: MillingTools, paths: Paths, tool: I64, milled: Bool, source: I32
) -> None:
    """Raise ``PlanError`` if contours of different cutters or lead-ins are nearer than a cutter is
    wide.

    Parameters
    ----------
    paths
        Paths with the cutter on their left.
    tool, milled : (p,)
        Index in ``tools.setups`` of each path, and mask of the closed paths that separate a part
        from waste.
    source : (n,)
        Index in the dieline of the edge of each segment.
    """
    if len(tools.setups) == 1:
        return
    radii = tools.radii
    one, other, distance = facing_pairs(paths, milled, 2.0 * float(radii.max()))
    diameter = 2.0 * np.maximum(radii[tool[one]], radii[tool[other]])
    for k in np.flatnonzero((tool[one] != tool[other]) & (distance < diameter))[:1]:
        edge, facing = source[paths.first[one[k]]], source[paths.first[other[k]]]
        numbers = {tools.setups[tool[row[k]]].station.number for row in (one, other)}
        raise PlanError(
            "tool-choice.facing" if len(numbers) > 1 else "lead-choice.facing",
            edge=edge,
            other=facing,
            distance=distance[k],
            diameter=diameter[k],
            at_edges=[edge, facing],
        )
