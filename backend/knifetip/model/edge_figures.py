"""The figures that the verifier measures on each edge, each declared once.

From a field of ``EdgeFigures`` come the column of the verifier and of the verdict, the field of the
REST API, the conversion from cleaned to drawn edges (``cleaning.map_back``), and the line of the
page about an edge.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Annotated, Final, NamedTuple, Self, get_type_hints

import numpy as np

from knifetip.geometry.columns import F64


class Share(Enum):
    """What a figure of a cleaned edge means for the drawn edges that it replaces."""

    WORST = "worst"  #: it applies to each of them
    LENGTH = "length"  #: it is divided among them in proportion to their lengths
    DRAWN = "drawn"  #: it is measured on drawn edges only


class Figure(NamedTuple):
    """The declaration of a figure of an edge."""

    meaning: str  #: with the unit, as the REST API describes it
    share: Share = Share.WORST
    is_always_measured: bool = False  #: otherwise it is 0 where no check measured it
    #: code of the message with its title, if the page lists it with the edges where it is not 0
    title: str = ""


def _none() -> F64:
    return np.zeros(0)


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class EdgeFigures:
    """The figures of n edges, one column of shape (n,) each."""

    deviation: Annotated[
        F64,
        Figure(
            "maximum distance of the tip from the drawing (mm): the sum of edge_path_deviation, "
            "edge_blending and edge_fit_error",
            is_always_measured=True,
        ),
    ] = field(default_factory=_none)
    path_deviation: Annotated[
        F64,
        Figure(
            "maximum distance of the tip path from the edge (mm); empty if an older version "
            "compiled the job",
        ),
    ] = field(default_factory=_none)
    blending: Annotated[
        F64,
        Figure(
            "distance by which the controller may round the tip path (mm); empty if an older "
            "version compiled the job",
        ),
    ] = field(default_factory=_none)
    fit_error: Annotated[
        F64,
        Figure(
            "distance of the edge from the curve of the drawing file that it approximates (mm); "
            "empty if an older version compiled the job",
        ),
    ] = field(default_factory=_none)
    overcut: Annotated[
        F64,
        Figure(
            "length cut beyond the ends of the edge (mm)",
            is_always_measured=True,
        ),
    ] = field(default_factory=_none)
    uncut: Annotated[
        F64,
        Figure(
            "length that is not machined by mistake (mm)",
            Share.LENGTH,
            is_always_measured=True,
        ),
    ] = field(default_factory=_none)
    setback: Annotated[
        F64,
        Figure(
            "length that is not machined by plan, such as crease ends (mm)",
            Share.LENGTH,
            is_always_measured=True,
        ),
    ] = field(default_factory=_none)
    width: Annotated[
        F64,
        Figure(
            "width of a V-groove at the top face (mm); 0 for other edges",
        ),
    ] = field(default_factory=_none)
    web: Annotated[
        F64,
        Figure(
            "thickness of the board left below a V-groove (mm); 0 for other edges",
        ),
    ] = field(default_factory=_none)
    flank: Annotated[
        F64,
        Figure(
            "maximum deviation of the flanks of a V-groove (mm); 0 for other edges",
        ),
    ] = field(default_factory=_none)
    unreached: Annotated[
        F64,
        Figure(
            "length that no cutter reaches (mm)",
            Share.LENGTH,
        ),
    ] = field(default_factory=_none)
    bottom_uncut: Annotated[
        F64,
        Figure(
            "length not cut at the bottom face of the board (mm)",
            Share.LENGTH,
            title="figure.bottom-uncut",
        ),
    ] = field(default_factory=_none)
    top_overcut: Annotated[
        F64,
        Figure(
            "length cut beyond the ends at the top face of the board (mm)",
            title="figure.top-overcut",
        ),
    ] = field(default_factory=_none)
    unreached_distance: Annotated[
        F64,
        Figure(
            "maximum distance of its unreached length from the area that the cutter sweeps (mm)",
        ),
    ] = field(default_factory=_none)
    slit_length: Annotated[
        F64,
        Figure(
            "length of a slit that is milled as wide as the cutter (mm)",
            Share.LENGTH,
            title="figure.slit-length",
        ),
    ] = field(default_factory=_none)
    tidied: Annotated[
        F64,
        Figure(
            "distance of the cleaned edge from the edge as drawn (mm); empty if an older version "
            "compiled the job",
            Share.DRAWN,
        ),
    ] = field(default_factory=_none)

    @classmethod
    def zeros(cls, count: int) -> Self:
        """Return figures that are all 0, with ``count`` rows, one for each edge of the dieline."""
        return cls(**{name: np.zeros(count) for name in EDGE_FIGURES})

    def columns(self) -> dict[str, F64]:
        """Return the figures by name, without copies."""
        return {name: getattr(self, name) for name in EDGE_FIGURES}


#: The declarations of all figures, by name.
EDGE_FIGURES: Final[Mapping[str, Figure]] = {
    name: hint.__metadata__[0]
    for name, hint in get_type_hints(EdgeFigures, include_extras=True).items()
}
