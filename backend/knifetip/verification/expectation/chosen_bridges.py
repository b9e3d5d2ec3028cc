"""The bridges that the user has placed, in sheet coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.job_options import BridgeAt
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.curve import point_at
from knifetip.verification.expectation.edges import place_edges


@dataclass(frozen=True, eq=False, slots=True)
class ExpectedBridge:
    """A stretch of an edge that must stay uncut."""

    row: int  #: row of the edge that makes most of the chosen one, for findings
    rows: I64  #: rows of the edges that make the chosen one
    point: F64  #: (2,) mm, middle of the bridge
    width: float  #: mm, in the top face
    moved: float  #: greatest distance of the cut from the edge as drawn, because of cleaning (mm)


def expected_bridges(
    bridges: Sequence[BridgeAt],
    drawn: Dieline,
    cleaned: Cleaned,
    placement: tuple[float, float],
) -> list[ExpectedBridge]:
    """Return the stretches that must stay uncut because the user has placed bridges.

    Parameters
    ----------
    drawn, cleaned
        The edges of the drawing, to whose rows the bridges refer, and the cleaned edges.
    placement : mm
        Offset (x, y) from the drawing's to the sheet's coordinates.

    Raises
    ------
    GeometryError
        A coordinate of the placement or of an edge is not finite.
    """
    if not bridges:
        return []
    edges = place_edges(drawn, placement)
    moved = np.maximum(cleaned.off, cleaned.moved)
    parts = cleaned.stretches
    result = []
    for bridge in bridges:
        for row in bridge.edges:
            found = np.flatnonzero(edges.row == row)
            made = parts.cleaned[(parts.row == row) & (parts.cleaned >= 0)].astype(np.int64)
            if len(found) == 0 or len(made) == 0:
                continue
            curve = edges.curve[found]
            point = point_at(curve, bridge.at * curve[:, 5])[0]
            own = int(cleaned.cleaned_row[row])
            result.append(
                ExpectedBridge(own, np.unique(made), point, bridge.width, float(moved[row]))
            )
    return result
