"""The figures that the verifier measures on each edge, and how they become figures of drawn edges.

A figure is declared here once.  ``Verdict`` has a column for it, the REST API a field, and
``cleaning.map_back`` converts it from cleaned to drawn edges.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Final, NamedTuple


class Share(Enum):
    """What a figure of a cleaned edge means for the drawn edges that it replaces."""

    WORST = "worst"  #: it applies to each of them
    LENGTH = "length"  #: it is divided among them in proportion to their lengths
    DRAWN = "drawn"  #: it is measured on drawn edges only


class Figure(NamedTuple):
    """A figure of an edge."""

    meaning: str  #: with the unit, as the REST API describes it
    share: Share = Share.WORST
    is_always_measured: bool = False  #: otherwise it is 0 where no check measured it


EDGE_FIGURES: Final[Mapping[str, Figure]] = {
    "deviation": Figure(
        "maximum distance of the tip from the drawing (mm): the sum of edge_path_deviation, "
        "edge_blending and edge_fit_error",
        is_always_measured=True,
    ),
    "path_deviation": Figure(
        "maximum distance of the tip path from the edge (mm); empty if an older version compiled "
        "the job"
    ),
    "blending": Figure(
        "distance by which the controller may round the tip path (mm); empty if an older version "
        "compiled the job"
    ),
    "fit_error": Figure(
        "distance of the edge from the curve of the drawing file that it approximates (mm); empty "
        "if an older version compiled the job"
    ),
    "overcut": Figure("length cut beyond the ends of the edge (mm)", is_always_measured=True),
    "uncut": Figure(
        "length that is not machined by mistake (mm)", Share.LENGTH, is_always_measured=True
    ),
    "setback": Figure(
        "length that is not machined by plan, such as crease ends (mm)",
        Share.LENGTH,
        is_always_measured=True,
    ),
    "width": Figure("width of a V-groove at the top face (mm); 0 for other edges"),
    "web": Figure("thickness of the board left below a V-groove (mm); 0 for other edges"),
    "flank": Figure("maximum deviation of the flanks of a V-groove (mm); 0 for other edges"),
    "unreached": Figure("length that no cutter reaches (mm)", Share.LENGTH),
    "bottom_uncut": Figure("length not cut at the bottom face of the board (mm)", Share.LENGTH),
    "top_overcut": Figure("length cut beyond the ends at the top face of the board (mm)"),
    "unreached_distance": Figure(
        "maximum distance of its unreached length from the area that the cutter sweeps (mm)"
    ),
    "slit_length": Figure(
        "length of a slit that is milled as wide as the cutter (mm)", Share.LENGTH
    ),
    "tidied": Figure(
        "distance of the cleaned edge from the edge as drawn (mm); empty if an older version "
        "compiled the job",
        Share.DRAWN,
    ),
}
