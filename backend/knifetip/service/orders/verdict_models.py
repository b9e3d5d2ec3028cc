"""Models for verdicts on programs: measurements, findings and accepted shortfalls."""

from __future__ import annotations

from typing import Any, TypeAlias

from pydantic import BaseModel, Field, create_model

from knifetip.model.edge_figures import EDGE_FIGURES
from knifetip.model.verdict import Severity
from knifetip.model.verdict_summary import SUMMARY
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.times import Moment


class _Limits(BaseModel):
    accepted: bool = Field(description="Whether the program may be sent to the machine")
    tolerance: float = Field(description="Maximum permitted deviation (mm)")


_FIGURES: Any = {
    name: (kind, Field(... if one.is_in_all else kind(0), description=one.meaning))
    for name, one in SUMMARY.items()
    for kind in (int if one.is_count else float,)
}
_Figures = create_model("_Figures", __base__=_Limits, **_FIGURES)


class VerdictSummary(_Figures):  # type: ignore[misc, valid-type]  # made by pydantic
    """Measurements of a program by the verifier: maxima over all edges, and totals (mm, mm², s)."""

    faults: int = Field(default=0, description="Number of faults; they cannot be accepted")
    shortfalls: int = Field(default=0, description="Number of shortfalls that no user has accepted")
    exceptions: int = Field(default=0, description="Number of accepted shortfalls")
    seconds: float = Field(description="Machine time of one copy (s)")
    seconds_retracted: float | None = Field(
        default=None,
        description="Machine time of one copy if the tool retracted fully for every turn (s); "
        "null if an older version compiled the job",
    )


class AcceptanceOut(BaseModel):
    """Who accepted a shortfall, when and why."""

    by: str = Field(description="Name of the user")
    reason: str = Field(description="Why the shortfall is acceptable")
    at: Moment = Field(description="Time of the decision")


class AcceptedShortfall(BaseModel):
    """A shortfall that a user accepted."""

    edge: int = Field(description="Row of the edge in the drawing, counted from 0")
    code: str = Field(description="Code of the finding's message")
    acceptance: AcceptanceOut = Field(description="Who accepted the shortfall")


class EarlierExceptions(BaseModel):
    """Shortfalls of a job that a user accepted for an earlier job."""

    job: str = Field(description="Id of the earlier job")
    created: Moment = Field(description="Time at which the earlier job was created")
    findings: list[AcceptedShortfall] = Field(description="Shortfalls that both jobs have")


class FindingOut(MessageOut):
    """One fault, shortfall or note of the verifier, with its edge and program line."""

    kind: str = Field(
        description="Kind of the finding: deviation, overcut, uncut, stray, depth, heading, order, "
        "feed, travel, program, unreached, kerf, fold, registration or planned"
    )
    severity: Severity = Field(
        default=Severity.FAULT,
        description="`fault`: the program is wrong or dangerous, and is refused. `shortfall`: the "
        "tool cannot make an edge as it is drawn; the program is refused until a user accepts the "
        "shortfall. `note`: the program leaves out or changes something as planned",
    )
    refuses: bool = Field(
        default=True, description="Whether the program is refused because of this finding"
    )
    acceptance: AcceptanceOut | None = Field(
        default=None, description="Who accepted the shortfall; null if it is not accepted"
    )
    measure: float = Field(description="Measured value (mm; degrees for `heading` and `fold`)")
    edge: int = Field(
        description="Row of the edge in the drawing, counted from 0; -1 if the finding concerns "
        "no edge"
    )
    edges: list[int] = Field(
        default=[],
        description="Rows of all edges of the drawing that the tool makes as one with `edge`, such "
        "as the chords of a curve, first `edge` itself. Empty if the finding concerns no edge, and "
        "in verdicts of older versions",
    )
    handle: str = Field(
        description="Handle of the edge's entity; empty if the finding concerns no edge"
    )
    line: int = Field(
        description="Program line, counted from 1; -1 if the finding concerns no line"
    )


#: X and Y in the drawing (mm).
Point: TypeAlias = tuple[float, float]


class UnreachedOut(BaseModel):
    """An area of the drawing that no cutter can reach."""

    area: float = Field(description="Size of the area (mm²)")
    x: float = Field(description="X of the centre in the drawing (mm)")
    y: float = Field(description="Y of the centre in the drawing (mm)")
    outline: list[tuple[Point, Point, float]] = Field(
        description="Lines and arcs of the outline of the area: start [X, Y] and end [X, Y] (mm), "
        "and bulge: tan(sweep / 4), 0 for a line"
    )


_COLUMNS: Any = {
    f"edge_{name}": (list[float], Field(description=f"Per edge: {figure.meaning}"))
    for name, figure in EDGE_FIGURES.items()
}
_EdgeColumns = create_model("_EdgeColumns", **_COLUMNS)


class VerdictOut(VerdictSummary, _EdgeColumns):  # type: ignore[misc, valid-type]  # made by pydantic
    """A verdict with columns of measurements; value i of a column belongs to edge i of the drawing.

    ``format=columns`` also contains the deviation of the tool's tip from an edge at m samples:
    ``sample_edge`` (row of the edge), ``sample_place`` (position along the edge, 0 … 1) and
    ``sample_deviation`` (mm, positive to the left of the edge).  The outlines of the areas that no
    cutter reaches consist of lines and arcs, one per row of ``area_ends`` (start and end points,
    mm) and ``area_bulge`` (tan(sweep / 4)).  ``area_first`` contains the first row of each outline,
    and ``area_size`` the area of each outline (mm²).
    """

    findings: list[FindingOut] = Field(
        description="Faults, then shortfalls, then notes; empty if there are none"
    )
    areas: list[UnreachedOut] = Field(
        description="Areas that no cutter reaches, the largest first; empty if there are none"
    )
