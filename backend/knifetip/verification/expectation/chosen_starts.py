"""The starts and directions of closed cuts that the user has chosen, in sheet coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.edge_choice import choices_by_edge
from knifetip.model.job_options import ContourStart
from knifetip.verification.columns import F64
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.expectation.edges import place_edges

_FORWARD: Final = {"forward": True, "reverse": False}


@dataclass(frozen=True, eq=False, slots=True)
class ExpectedStart:
    """The chosen start and direction of the closed cut with one edge."""

    row: int  #: row of the edge that is made for the chosen one, for findings
    curve: F64  #: (6,) the chosen edge as drawn, see ``curves.curve``
    place: float  #: mm along the edge at which the cut must begin; NaN for anywhere
    forward: bool | None  #: whether the cut must run along the edge or back; None for either
    moved: float  #: greatest distance of the cut from the edge as drawn, because of cleaning (mm)
    placement: tuple[float, float]  #: offset from the drawing's to the sheet's coordinates (mm)

    @property
    def point(self) -> F64:
        """Point at which the cut must begin, (2,) mm; NaN for anywhere."""
        result: F64 = point_at(self.curve[None], np.array([self.place]))[0]
        return result

    @property
    def left(self) -> F64:
        """Unit vector to the left of the edge at ``point``, (2,)."""
        azimuth = np.radians(azimuth_at(self.curve[None], np.array([self.place]))[0])
        return np.array([-np.sin(azimuth), np.cos(azimuth)])


def expected_starts(
    starts: Sequence[ContourStart],
    drawn: Dieline,
    cleaned: Cleaned,
    placement: tuple[float, float],
) -> list[ExpectedStart]:
    """Return what the user's choices of starts and directions require of a program.

    Parameters
    ----------
    drawn, cleaned
        The edges of the drawing, to whose rows the choices refer, and the cleaned edges.
    placement : mm
        Offset (x, y) from the drawing's to the sheet's coordinates.

    Raises
    ------
    PlanError
        The drawing has no such edge.
    GeometryError
        A coordinate of the placement or of an edge is not finite.
    """
    if not starts:
        return []
    edges = place_edges(drawn, placement)
    moved = np.maximum(cleaned.off, cleaned.moved)
    result = []
    for row, start in choices_by_edge(starts, drawn.line_type):
        if start.at is None and start.direction == "free":
            continue
        found = np.flatnonzero(edges.row == row)
        if len(found):
            curve = edges.curve[found[0]]
            place = np.nan if start.at is None else start.at * float(curve[5])
            forward = _FORWARD.get(start.direction)
            # A dropped edge has no cut; its finding has no edge.
            own = int(cleaned.cleaned_row[row])
            result.append(ExpectedStart(own, curve, place, forward, float(moved[row]), placement))
    return result
