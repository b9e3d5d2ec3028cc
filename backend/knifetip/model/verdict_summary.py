"""The maxima and totals of a verdict, each declared once with its meaning and its value.

``presentation.verdict`` computes them, and the REST API has a field for each.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Final, NamedTuple

from knifetip.geometry.columns import F64
from knifetip.model.program_figures import PROGRAM_FIGURES
from knifetip.model.verdict import Verdict


class Summary(NamedTuple):
    """The declaration of a maximum or a total of a verdict."""

    meaning: str  #: with the unit, as the REST API describes it
    value: Callable[[Verdict], float]
    is_count: bool = False
    is_in_all: bool = False  #: whether the summaries that older versions stored have it, too


def _greatest(column: str) -> Callable[[Verdict], float]:
    """Return a function for the maximum of a column over all edges; 0 without edges."""
    return lambda verdict: float(_column(verdict, column).max(initial=0.0))


def _sum(column: str) -> Callable[[Verdict], float]:
    """Return a function for the sum of a column over all edges."""
    return lambda verdict: float(_column(verdict, column).sum())


def _column(verdict: Verdict, name: str) -> F64:
    column: F64 = getattr(verdict, name)
    return column


SUMMARY: Final[Mapping[str, Summary]] = {
    "deviation": Summary(
        "Maximum distance of the tip from the drawing (mm): the sum of the distance of the tip "
        "path from the edge, the rounding of the path by the controller, and the distance of the "
        "edge from the curve of the drawing file",
        _greatest("deviation"),
        is_in_all=True,
    ),
    "path_deviation": Summary(
        "Maximum distance of the tip path from an edge (mm)", _greatest("path_deviation")
    ),
    "blending": Summary(
        "Maximum distance by which the controller may round the tip path (mm); 0 if it follows "
        "the path exactly",
        _greatest("blending"),
    ),
    "fit_error": Summary(
        "Maximum distance of an edge from the curve of the drawing file that it approximates "
        "(mm); 0 for lines and circular arcs of the file",
        _greatest("fit_error"),
    ),
    "overcut": Summary(
        "Maximum length cut beyond the end of an edge (mm)", _greatest("overcut"), is_in_all=True
    ),
    "uncut": Summary(
        "Maximum length of one edge that is left uncut by mistake (mm)",
        _greatest("uncut"),
        is_in_all=True,
    ),
    "uncut_total": Summary("Length of all edges that is left uncut by mistake (mm)", _sum("uncut")),
    "setback_total": Summary(
        "Length of all edges that is left uncut by plan, such as at the ends of creases (mm)",
        _sum("setback"),
    ),
    "unreached": Summary(
        "Total area that no cutter reaches (mm²)", lambda verdict: float(verdict.areas.area.sum())
    ),
    "unreached_places": Summary(
        "Number of areas that no cutter reaches",
        lambda verdict: len(verdict.areas),
        is_count=True,
    ),
    "unreached_length": Summary(
        "Length of all edges that no cutter reaches (mm)", _sum("unreached")
    ),
    "unreached_distance": Summary(
        "Maximum distance of an edge that no cutter reaches from the area that the cutter sweeps "
        "(mm)",
        _greatest("unreached_distance"),
    ),
    "slit_length": Summary(
        "Length of slits that are milled as wide as the cutter (mm)", _sum("slit_length")
    ),
    "slit_places": Summary(
        "Number of slits that are milled as wide as the cutter",
        lambda verdict: int((verdict.slit_length > 0.0).sum()),
        is_count=True,
    ),
    **{
        name: Summary(one.meaning, attrgetter(f"program.{name}"))
        for name, one in PROGRAM_FIGURES.items()
    },
}
