"""Models for drawings and their edges."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.library.custom_profiles import MAX_BYTES
from knifetip.model.edit import MOST_EDITS, Edit
from knifetip.service.drawings.customer_answer_models import LearnedOut
from knifetip.service.drawings.report_models import ImportReportOut, OutcomeWord, ReportOut
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import (
    WHOLE,
    JsonBody,
    LineTypeWord,
    Name,
    PageQuery,
    QuestionOut,
)
from knifetip.service.http.times import Moment
from knifetip.service.order_details.models import (
    DetailsQuery,
    OrderDetailsOut,
    OrderDetailsPatch,
    TimesQuery,
)

_UnitWord = Literal["mm", "cm", "m", "in", "ft", "pt", "px", "px-90"]
Unit = Annotated[_UnitWord, LISTED]


class LineTypeCount(BaseModel):
    """Number and total length of the edges of one line type."""

    type: LineTypeWord = Field(
        description="Line type of the edges; `ignored` edges are not machined, `unclassified` "
        "edges have no line type yet"
    )
    edges: int = Field(description="Number of edges")
    length: float = Field(description="Total length of the edges (mm)")


class LayerOut(BaseModel):
    """Number, total length and line types of the edges that have the same layer and colour."""

    name: str = Field(description="Name of the layer in the file")
    colour: int = Field(description="AutoCAD colour index of the edges, 1 … 255")
    edges: int = Field(description="Number of edges")
    length: float = Field(description="Total length of the edges (mm)")
    types: list[LineTypeWord] = Field(description="Line types that occur among these edges")


class UnitEvidenceOut(MessageOut):
    """One observation that supports a unit for the drawing."""

    unit: Unit = Field(description="Unit that the observation supports")
    weight: float = Field(
        description="Strength of the evidence: natural logarithm of the likelihood ratio of this "
        "unit to the least likely unit"
    )


class UnitFindingOut(BaseModel):
    """The unit in the header of the file, all units ranked by likelihood, and the evidence."""

    stated: Unit | Literal[""] = Field(
        description="Unit in the header of the file; empty if the header contains none"
    )
    ranking: list[Unit] = Field(description="All units, the most likely first")
    evidence: list[UnitEvidenceOut] = Field(
        description="Observations that support a unit, the highest weight first"
    )
    warnings: list[MessageOut] = Field(
        description="Contradictions in the evidence, which the user should check; empty if there "
        "are none"
    )


Revision = Annotated[
    int, Field(description="Increases with each change of the drawing; part of its ETag")
]


Owner = Annotated[
    str,
    Field(
        description="Account that uploaded the drawing, as `account` in `GET /api/me`; empty for "
        "none, then every designer may change the drawing"
    ),
]
IsLayout = Annotated[
    bool,
    Field(description="Whether it is the sheet of a layout, which `PUT /layouts/{id}` changes"),
]
Shared = Annotated[
    bool, Field(description="Whether all designers may change the drawing, not only its owner")
]


class DrawingsQuery(TimesQuery, DetailsQuery, PageQuery):
    """Query parameters that select drawings; all conditions must be met."""


class PageOut(BaseModel):
    """A page of a file, from which the drawing may be read."""

    page: int = Field(description="Number of the page in the file, from 1")
    edges: int = Field(description="Number of edges on the page; 0 if it contains no drawing")
    width: float = Field(description="Width of the bounding box of the edges (mm)")
    height: float = Field(description="Height of the bounding box of the edges (mm)")
    picture: str = Field(description="Small picture of the edges as SVG; empty without edges")
    problem: MessageOut | None = Field(
        description="Why the page cannot be read; null if it can be read"
    )


class DrawingOut(OrderDetailsOut):
    """A drawing that has been read and classified."""

    id: str = Field(description="Id of the drawing, assigned by the server")
    revision: Revision
    name: str = Field(description="Name of the uploaded file")
    created: Moment = Field(description="Time of the upload")
    updated: Moment = Field(description="Time of the last change")
    owner: Owner = ""
    shared: Shared = False
    is_layout: IsLayout = False
    sha256: str = Field(description="SHA-256 of the uploaded file (64 hexadecimal digits)")
    unit: Unit | None = Field(
        description="Unit of the file; null while it is not decided, then all lengths are in file "
        "units"
    )
    unit_given: Unit | None = Field(
        description="Unit that the user set; null if the unit of the file applies"
    )
    unit_learned: list[str] = Field(
        default=[],
        description="Names of the customer's earlier drawings whose units decided `unit_given`, "
        "the newest first; empty if a user gave it, or if it is null",
    )
    evidence: str = Field(description="How the unit was determined: the text of `evidence_message`")
    evidence_message: MessageOut | None = Field(
        default=None,
        description="`evidence` as a message; null if an older version read the drawing",
    )
    unit_finding: UnitFindingOut | None = Field(
        default=None,
        description="Evidence for each unit; null if an older version read the drawing",
    )
    warnings: list[MessageOut] = Field(
        default=[],
        description="What the user should check: contradictions about the unit, objects that were "
        "left out although their author may have meant them, and folds on whose lines cuts are "
        "made; empty if there is nothing",
    )
    profile: str = Field(
        description="Name of the classification profile with which the drawing was classified"
    )
    profile_state: Literal["current", "changed", "deleted"] = Field(
        description="Whether the profile is still the one with which the drawing was classified, "
        "has changed since, or was deleted"
    )
    rules: str = Field(
        description="Text of the customer's profile with which the drawing was classified (TOML); "
        "empty for a profile of the library"
    )
    segments: int = Field(description="Number of edges of the drawing")
    length: float | None = Field(
        default=None,
        description="Total length of the edges (mm); null if an older version read the drawing",
    )
    bounds: tuple[float, float, float, float] = Field(
        description="Bounding box of the edges: x min, y min, x max, y max (mm; file units if "
        "`unit` is null)"
    )
    width: float = Field(
        description="Width of the bounding box, along X (mm; file units if `unit` is null)"
    )
    height: float = Field(
        description="Height of the bounding box, along Y (mm; file units if `unit` is null)"
    )
    counts: list[LineTypeCount] = Field(
        description="Number and total length of the edges of each line type that occurs"
    )
    layers: list[LayerOut] = Field(
        description="Edges by layer and colour: one item for each combination that occurs"
    )
    questions: list[QuestionOut] = Field(
        description="Questions that must be answered before a job can be created; empty if there "
        "are none"
    )
    overrides: int = Field(description="Number of edges with a line type set by the user")
    edits: list[Edit] = Field(
        default=[], description="Changes of the geometry that the user has made, in order"
    )
    learned: list[LearnedOut] = Field(
        default=[],
        description="Line types that earlier drawings of the same customer decided, by look; "
        "`PATCH /api/drawings/{id}/customer-answers` takes them back",
    )
    import_report: ImportReportOut = Field(description="Outcome of every entity of the file")
    report: ReportOut | None = Field(
        default=None,
        description="Total lengths and groups by outcome of import and cleaning; null if an older "
        "version read the drawing",
    )


class DrawingSummary(OrderDetailsOut):
    """A drawing as an item of a list of drawings."""

    id: str = Field(description="Id of the drawing, assigned by the server")
    revision: Revision
    name: str = Field(description="Name of the uploaded file")
    created: Moment = Field(description="Time of the upload")
    updated: Moment = Field(description="Time of the last change")
    owner: Owner = ""
    shared: Shared = False
    is_layout: IsLayout = False
    unit: Unit | None = Field(
        description="Unit of the file; null while it is not decided, then all lengths are in file "
        "units"
    )
    width: float = Field(
        description="Width of the bounding box of the edges, along X (mm; file units if `unit` is "
        "null)"
    )
    height: float = Field(
        description="Height of the bounding box of the edges, along Y (mm; file units if `unit` "
        "is null)"
    )
    segments: int = Field(description="Number of edges of the drawing")
    questions: int = Field(description="Number of open questions")


class EdgeOut(BaseModel):
    """One edge of a drawing with its line type and its outcome of cleaning."""

    row: int = Field(description="Row of the edge in the drawing, counted from 0")
    handle: str = Field(description="Handle of the edge's entity in the file")
    layer: str = Field(description="Name of the edge's layer in the file")
    colour: int = Field(description="AutoCAD colour index of the edge, 1 … 255")
    linetype: str = Field(description="Linetype in the file, such as DASHED")
    line_width: float | None = Field(
        description="Width with which the file draws the edge (mm, if the unit is known), 0 for "
        "the thinnest line; null if the file states none"
    )
    type: LineTypeWord = Field(
        description="Line type of the edge; an `ignored` edge is not machined, an `unclassified` "
        "edge has no line type yet"
    )
    rule: str = Field(
        description="Rule of the profile, or other evidence, that decided the line type"
    )
    confidence: float = Field(description="Confidence in the line type, 0 … 1")
    alternatives: list[LineTypeWord] = Field(
        description="Other possible line types, the likeliest first; empty if there are none"
    )
    outcome: OutcomeWord = Field(
        description="Outcome of cleaning: kept, merged into another edge, or dropped"
    )
    reason: str = Field(
        description="Reason for the outcome in English; empty if an older version read the drawing"
    )
    length: float = Field(description="Length of the edge (mm)")
    start: tuple[float, float] = Field(description="Start point X, Y (mm)")
    end: tuple[float, float] = Field(description="End point X, Y (mm)")
    bulge: float = Field(
        description="tan(sweep / 4) of an arc, positive counter-clockwise; 0 for a line"
    )


class EdgesOut(BaseModel):
    """All edges of a drawing; ``format=columns`` returns the same data as binary arrays."""

    edges: list[EdgeOut] = Field(description="Edges of the drawing, in the order of their rows")


class Override(JsonBody):
    """Sets the line type of edges, which are selected by row, by handle, or by layer and colour.

    If ``type`` is null, earlier overrides of the selected edges are removed.
    """

    type: LineTypeWord | None = Field(
        description="Line type to set; null removes earlier overrides of the selected edges"
    )
    edges: list[int] | None = Field(
        default=None,
        max_length=200_000,
        description="Rows of the edges to select, counted from 0; null to select by `handles` or "
        "by `layer` and `colour`",
    )
    handles: list[str] | None = Field(
        default=None,
        max_length=200_000,
        description="Handles of the entities whose edges to select; null to select in another way",
    )
    layer: str | None = Field(
        default=None, description="Name of the layer whose edges to select; null for any layer"
    )
    colour: Annotated[int, WHOLE] | None = Field(
        default=None,
        description="AutoCAD colour index of the edges to select, 1 … 255; null for any colour",
    )


class EdgesPatch(JsonBody):
    """Changes of the line types of edges."""

    overrides: list[Override] = Field(
        min_length=1,
        max_length=1000,
        description="Overrides, applied in order; later ones replace earlier ones for the same "
        "edges",
    )


class DrawingPatch(OrderDetailsPatch):
    """A change of the unit, the profile or the details of the order of a drawing."""

    unit: Annotated[Literal[_UnitWord, "file"], LISTED] | None = Field(
        default=None,
        description='New unit of the drawing; "file" restores the unit of the file; null leaves '
        "the unit as it is",
    )
    profile: Name | None = Field(
        default=None,
        description="Name of the new classification profile; the present name applies its current "
        "version; null leaves the profile as it is",
    )
    rules: Annotated[str, Field(max_length=MAX_BYTES)] = Field(
        default="",
        description="Text of an earlier or deleted version of the profile (TOML); empty for the "
        "current version",
    )
    edits: Annotated[list[Edit], Field(max_length=MOST_EDITS)] | None = Field(
        default=None,
        description="All changes of the geometry, applied in order to the edges of the file; they "
        "replace the present ones. Null leaves them as they are",
    )
    shared: bool | None = Field(
        default=None,
        description="Whether all designers may change the drawing; null for no change",
    )
