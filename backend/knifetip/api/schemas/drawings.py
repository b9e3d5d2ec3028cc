"""Models for drawings, their edges, import reports and cleaning reports."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.api.schemas.common import LineTypeWord, Name, QuestionOut, Strict
from knifetip.api.schemas.messages import MessageOut
from knifetip.library.custom_profiles import MAX_BYTES

OutcomeWord = Literal["kept", "merged", "dropped"]
Unit = Literal["mm", "cm", "m", "in", "ft", "pt", "px"]


class ImportReportRow(BaseModel):
    """Import outcome of one entity of the file."""

    handle: str = Field(description="Handle of the entity in the file")
    kind: str = Field(description="Type of the entity in the file")
    layer: str
    outcome: OutcomeWord
    reason: MessageOut
    length: float = Field(description="Length of the edges that the entity gave (mm)")
    text: str = Field(default="", description="Content of a text entity")
    place: list[float] | None = Field(
        default=None,
        description="x, y and height of a text (mm; file units if the unit is unknown)",
    )
    box: list[float] | None = Field(
        default=None,
        description="x min, y min, x max, y max of an entity without edges, if "
        "its location is in the file (mm; file units if the unit is unknown)",
    )


class LineTypeCount(BaseModel):
    """Number and total length of the edges of one line type."""

    type: LineTypeWord
    edges: int = Field(description="Number of edges")
    length: float = Field(description="Total length of the edges (mm)")


class LayerOut(BaseModel):
    """Number, total length and line types of the edges that have the same layer and colour."""

    name: str
    colour: int = Field(description="AutoCAD colour index")
    edges: int = Field(description="Number of edges")
    length: float = Field(description="Total length of the edges (mm)")
    types: list[LineTypeWord] = Field(description="Line types of the edges")


class ImportReportOut(BaseModel):
    """Import report: the number of entities by outcome, and a row for each entity."""

    kept: int = Field(description="Number of entities that are kept")
    merged: int = Field(description="Number of entities that equal other entities")
    dropped: int = Field(description="Number of entities that gave no edge")
    rows: list[ImportReportRow] = Field(
        description="One row per entity; at most 2,000 in a drawing, all in …/import-report"
    )


class CleaningLengths(BaseModel):
    """Total lengths of the edges of a drawing by outcome of cleaning (mm).

    ``drawn`` is the sum of ``kept``, ``merged`` and ``dropped``.  ``worked`` is the sum of ``kept``
    and ``added``.
    """

    drawn: float = Field(description="Length in the drawing")
    kept: float = Field(description="Length that is machined as drawn")
    merged: float = Field(description="Length that lies on other edges, which are machined")
    dropped: float = Field(description="Length that is too short to be machined")
    added: float = Field(description="Length added by closing gaps and fitting curves")
    worked: float = Field(description="Length that is machined")
    no_work: float = Field(description="Length of edges that are ignored or not classified")


class CleaningCounts(BaseModel):
    """Number of edges that cleaning kept, merged and dropped."""

    kept: int
    merged: int
    dropped: int


class CleaningRow(MessageOut):
    """Outcome of cleaning for one edge that is not machined exactly as drawn."""

    row: int = Field(description="Row of the edge in the drawing")
    handle: str
    outcome: OutcomeWord
    reason: Literal["moved", "shortened", "longer", "joined", "fitted", "twice", "speck"] = Field(
        description="moved: an end was moved. shortened: a part lies on other edges. longer: other "
        "edges were joined to this edge. joined: the edge became part of a collinear edge. fitted: "
        "the edge became part of a fitted line or arc. twice: the edge lies on other edges. "
        "speck: the edge is too short to be machined"
    )
    into: int = Field(description="Row of the edge that is machined instead; -1 for none")
    kept: float = Field(description="Length that is machined for the edge (mm)")
    merged: float = Field(description="Length that lies on other edges, which are machined (mm)")
    dropped: float = Field(description="Length that is too short to be machined (mm)")
    added: float = Field(description="Length added by closing gaps and fitting curves (mm)")
    moved: float = Field(description="Maximum distance by which an end was moved (mm)")
    off: float = Field(description="Maximum distance of the edge from what is machined for it (mm)")


class CleaningOut(BaseModel):
    """Cleaning report of a drawing: lengths, counts, and a row for each changed edge."""

    lengths: CleaningLengths
    edges: CleaningCounts
    moved: float = Field(description="Maximum distance by which an end was moved (mm)")
    off: float = Field(description="Maximum distance of an edge from what is machined for it (mm)")
    rows: list[CleaningRow]


class UnitEvidenceOut(MessageOut):
    """One observation that supports a unit for the drawing."""

    unit: Unit
    weight: float = Field(description="Logarithm of the likelihood ratio to the least likely unit")


class UnitFindingOut(BaseModel):
    """The unit in the header of the file, all units ranked by likelihood, and the evidence."""

    stated: Unit | Literal[""] = Field(
        description="Unit in the file's header; empty if there is none"
    )
    ranking: list[Unit] = Field(description="Units, most likely first")
    evidence: list[UnitEvidenceOut] = Field(description="Highest weight first")
    warnings: list[MessageOut] = Field(description="Contradictions that the user should check")


class ReportGroup(BaseModel):
    """Edges or entities that have the same outcome of cleaning or import, for the same reason."""

    outcome: OutcomeWord
    reason: MessageOut = Field(
        description="Reason for the first one; measured values may differ for the rest"
    )
    what: Literal["edges", "entities"] = Field(
        description="What is counted: edges of the drawing, or entities that gave no edge"
    )
    kinds: list[str] = Field(description="Kinds of entities, most frequent first")
    count: int = Field(description="Number of edges or entities")
    length: float = Field(description="Total length (mm)")


class ReportOut(BaseModel):
    """Total lengths by outcome of import and cleaning (mm), and groups of edges and entities.

    ``drawn`` is the sum of ``kept``, ``merged`` and ``dropped``.
    """

    drawn: float
    kept: float
    merged: float
    dropped: float
    groups: list[ReportGroup]


Revision = Annotated[
    int, Field(description="Increases with each change of the drawing; part of its ETag")
]


class DrawingOut(BaseModel):
    """A drawing that has been read and classified."""

    id: str
    revision: Revision
    name: str = Field(description="Name of the uploaded file")
    created: float
    sha256: str = Field(description="SHA-256 of the uploaded file")
    unit: Unit | None = Field(
        description="Unit of the file; null while it is not decided: lengths are then in file units"
    )
    unit_given: Unit | None = Field(
        description="Unit set by the user; null for the unit of the file"
    )
    evidence: str = Field(description="How the unit was determined")
    evidence_message: MessageOut | None = Field(default=None, description="`evidence` as a message")
    unit_finding: UnitFindingOut | None = Field(
        default=None, description="Null if the drawing was read by an older version"
    )
    profile: str
    profile_state: Literal["current", "changed", "deleted"] = Field(
        description="Whether the profile has changed since the drawing was classified"
    )
    rules: str = Field(
        description="Customer's profile of the classification (TOML); empty for a library profile"
    )
    segments: int = Field(description="Number of edges")
    length: float | None = Field(
        default=None, description="Null if the drawing was read by an older version"
    )
    bounds: tuple[float, float, float, float] = Field(
        description="Bounding box of the edges: x min, y min, x max, y max (mm)"
    )
    width: float
    height: float
    counts: list[LineTypeCount]
    layers: list[LayerOut]
    questions: list[QuestionOut]
    overrides: int = Field(description="Number of edges with a line type set by the user")
    import_report: ImportReportOut
    report: ReportOut | None = Field(
        default=None, description="Null if the drawing was read by an older version"
    )


class DrawingSummary(BaseModel):
    """A drawing in a list of drawings."""

    id: str
    revision: Revision
    name: str
    created: float
    unit: Unit | None = Field(
        description="Unit of the file; null while it is not decided: lengths are then in file units"
    )
    width: float
    height: float
    segments: int = Field(description="Number of edges")
    questions: int = Field(description="Number of open questions")


class EdgeOut(BaseModel):
    """One edge with its line type, the rule that decided the line type, and the edge's outcome.

    The outcome is that of import or cleaning: kept, merged or dropped.
    """

    row: int = Field(description="Row of the edge in the drawing")
    handle: str = Field(description="Handle of the entity in the file")
    layer: str
    colour: int = Field(description="AutoCAD colour index")
    linetype: str = Field(description="Linetype in the file, such as DASHED")
    type: LineTypeWord
    rule: str = Field(description="Rule or evidence that decided the line type")
    confidence: float = Field(description="Confidence in the line type, 0 … 1")
    alternatives: list[LineTypeWord] = Field(
        description="Other possible line types, most likely first"
    )
    outcome: OutcomeWord
    reason: str = Field(description="Reason for the outcome of the edge; empty if it is kept")
    length: float
    start: tuple[float, float] = Field(description="Start point X, Y (mm)")
    end: tuple[float, float] = Field(description="End point X, Y (mm)")
    bulge: float = Field(
        description="tan(sweep / 4) of an arc, positive counter-clockwise; 0 for a line"
    )


class EdgesOut(BaseModel):
    """All edges of a drawing; ``format=columns`` returns the same data as binary columns."""

    edges: list[EdgeOut]


class Override(Strict):
    """Sets the line type of edges, which are selected by row, by handle, or by layer and colour.

    If ``type`` is null, earlier overrides of the selected edges are removed.
    """

    type: LineTypeWord | None
    edges: list[int] | None = Field(default=None, max_length=200_000, description="Rows of edges")
    handles: list[str] | None = Field(
        default=None, max_length=200_000, description="Handles of entities"
    )
    layer: str | None = None
    colour: int | None = Field(default=None, description="AutoCAD colour index")


class EdgesPatch(Strict):
    """Overrides, which are applied in order; later ones replace earlier ones."""

    overrides: list[Override] = Field(min_length=1, max_length=1000)


class DrawingPatch(Strict):
    """A change of the unit or the profile of a drawing."""

    unit: Unit | Literal["file"] | None = Field(
        default=None, description='"file" restores the unit of the file'
    )
    profile: Name | None = Field(
        default=None,
        description="Name of the profile; the present name applies its current version",
    )
    rules: Annotated[str, Field(max_length=MAX_BYTES)] = Field(
        default="",
        description="Earlier or deleted profile version (TOML). Default: the current version",
    )
