"""Models for the reports on a drawing: import, cleaning, and the blanks on its sheet."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.service.http.message_models import MessageOut

OutcomeWord = Annotated[Literal["kept", "merged", "dropped"], LISTED]


class ImportReportRow(BaseModel):
    """Import outcome of one entity of the file."""

    handle: str = Field(
        description="Handle of the entity: its identifier in the file, or one that the reader "
        "assigned"
    )
    kind: str = Field(description="Type of the entity in the file, such as LINE or TEXT")
    layer: str = Field(description="Name of the entity's layer in the file")
    outcome: OutcomeWord = Field(
        description="kept: the entity became edges. merged: it equals another entity. dropped: it "
        "gave no edge"
    )
    reason: MessageOut = Field(description="Reason for the outcome")
    length: float = Field(
        description="Total length of the edges that the entity gave (mm; file units if the unit "
        "is unknown)"
    )
    text: str = Field(
        default="", description="Content of a text or dimension; empty for other entities"
    )
    place: list[float] | None = Field(
        default=None,
        description="x, y and height of the letters of a text or dimension (mm; file units if the "
        "unit is unknown); null for other entities, and if the location is not known",
    )
    box: list[float] | None = Field(
        default=None,
        description="x min, y min, x max, y max of an entity without edges (mm; file units if the "
        "unit is unknown); null for an entity with edges, and if the location is not "
        "in the file",
    )


class ImportReportOut(BaseModel):
    """Import report: the number of entities by outcome, and a row for each entity."""

    kept: int = Field(description="Number of entities that became edges")
    merged: int = Field(
        description="Number of entities that were left out because they equal other entities"
    )
    dropped: int = Field(description="Number of entities that gave no edge")
    rows: list[ImportReportRow] = Field(
        description="One row for each entity; in a drawing only the first 2,000, all in "
        "`/api/drawings/{id}/import-report`"
    )


class CleaningLengths(BaseModel):
    """Total lengths of the edges of a drawing by outcome of cleaning (mm)."""

    drawn: float = Field(
        description="Length of the edges that have to be machined, as drawn: `kept` + `merged` + "
        "`dropped` (mm)"
    )
    kept: float = Field(description="Length that is machined as drawn (mm)")
    merged: float = Field(description="Length that lies on other edges, which are machined (mm)")
    dropped: float = Field(
        description="Length that is too short to be machined or outside all panels (mm)"
    )
    added: float = Field(description="Length added by closing gaps and fitting curves (mm)")
    worked: float = Field(description="Length that is machined: `kept` + `added` (mm)")
    no_work: float = Field(
        description="Length of edges that are ignored or not classified; not part of `drawn` (mm)"
    )


class CleaningCounts(BaseModel):
    """Number of edges that cleaning kept, merged and dropped."""

    kept: int = Field(description="Number of edges that are machined, and of edges without work")
    merged: int = Field(
        description="Number of edges that lie on other edges or were joined to them"
    )
    dropped: int = Field(
        description="Number of edges that are too short to be machined or outside all panels"
    )


class CleaningRow(MessageOut):
    """Outcome of cleaning for one edge that is machined with a change, or not at all."""

    row: int = Field(description="Row of the edge in the drawing, counted from 0")
    handle: str = Field(description="Handle of the edge's entity in the file")
    outcome: OutcomeWord = Field(
        description="kept: the edge is machined with a change. merged: another edge is machined "
        "in its place. dropped: it is not machined"
    )
    reason: Literal[
        "moved",
        "shortened",
        "longer",
        "joined",
        "fitted",
        "twice",
        "near",
        "speck",
        "off_panel",
        "loop",
    ] = Field(
        description="moved: an end was moved. shortened: a part lies on other edges. longer: other "
        "edges were joined to this edge. joined: the edge became part of a collinear edge. fitted: "
        "the edge became part of a fitted line or arc. twice: the edge lies on other edges. "
        "near: the edge lies less than 0.05 mm beside other edges and was merged into them. "
        "speck: the edge is too short to be machined. off_panel: the edge, or a part of it, "
        "belongs to a fold and lies outside all panels. loop: the edge belongs to a loop of short "
        "edges at a corner"
    )
    into: int = Field(
        description="Row of the edge that is machined instead: the edge itself if it is kept, -1 "
        "if it is dropped"
    )
    kept: float = Field(description="Length that is machined for the edge (mm)")
    merged: float = Field(description="Length that lies on other edges, which are machined (mm)")
    dropped: float = Field(
        description="Length that is too short to be machined or outside all panels (mm)"
    )
    added: float = Field(description="Length added by closing gaps and fitting curves (mm)")
    moved: float = Field(description="Maximum distance by which an end was moved (mm)")
    off: float = Field(
        description="Maximum distance of the edge as drawn from what is machined for it (mm)"
    )


class CleaningOut(BaseModel):
    """Cleaning report of a drawing: lengths, counts, and a row for each changed edge."""

    lengths: CleaningLengths = Field(description="Total lengths of the edges by outcome (mm)")
    edges: CleaningCounts = Field(description="Numbers of edges by outcome")
    moved: float = Field(description="Maximum distance by which an end was moved (mm)")
    off: float = Field(
        description="Maximum distance of an edge as drawn from what is machined for it (mm)"
    )
    rows: list[CleaningRow] = Field(
        description="One row for each edge that is not machined exactly as drawn; other edges "
        "have no row"
    )


class BlankOut(BaseModel):
    """A blank: board that a closed cut separates from the waste around it."""

    area: float = Field(description="Area without holes (mm²)")
    bounds: tuple[float, float, float, float] = Field(
        description="Lowest x and y, then highest x and y (mm)"
    )
    outline: list[tuple[float, float]] = Field(
        description="Corners (x, y) in mm, counter-clockwise"
    )
    holes: list[list[tuple[float, float]]] = Field(
        description="Corners (x, y) of each hole in mm, clockwise"
    )


class BlanksOut(BaseModel):
    """The blanks of a drawing, largest first."""

    area: float = Field(description="Area of all blanks, without holes (mm²)")
    blanks: list[BlankOut] = Field(description="The blanks; empty if the cuts enclose no area")


class ReportGroup(BaseModel):
    """Edges or entities that have the same outcome of cleaning or import, for the same reason."""

    outcome: OutcomeWord = Field(
        description="Outcome of the edges or entities: kept, merged or dropped"
    )
    reason: MessageOut = Field(
        description="Reason for the outcome of the first edge or entity of the group; measured "
        "values in it may differ for the rest"
    )
    what: Literal["edges", "entities"] = Field(
        description="What `count` counts: edges of the drawing, or entities of the file that gave "
        "no edge"
    )
    kinds: list[str] = Field(
        description="Types of the entities in the file, such as LINE, the most frequent first; at "
        "most 6"
    )
    count: int = Field(description="Number of edges or entities")
    length: float = Field(
        description="Total length of the edges or entities (mm; file units if the unit is unknown)"
    )


class ReportOut(BaseModel):
    """Total lengths by outcome of import and cleaning, and groups of edges and entities."""

    drawn: float = Field(
        description="Length of all edges and entities of the file: `kept` + `merged` + `dropped` "
        "(mm)"
    )
    kept: float = Field(
        description="Length that is kept (mm); edges that are ignored or not classified are "
        "included"
    )
    merged: float = Field(
        description="Length that lies on other edges or equals other entities (mm)"
    )
    dropped: float = Field(
        description="Length that is left out because it is too short, or is not a drawing line (mm)"
    )
    groups: list[ReportGroup] = Field(
        description="Edges and entities in groups by outcome and reason: dropped, merged, kept"
    )
