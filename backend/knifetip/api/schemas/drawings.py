"""drawings: what is said of drawings."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.api.schemas.common import LineTypeWord, Name, QuestionOut, Strict
from knifetip.api.schemas.messages import MessageOut
from knifetip.library.own import LONGEST

FateWord = Literal["kept", "merged", "dropped"]
Unit = Literal["mm", "cm", "m", "in", "ft", "pt", "px"]


class LedgerRow(BaseModel):
    """What became of one entity of the file."""

    handle: str
    kind: str
    layer: str
    fate: FateWord
    reason: str
    theme: str = Field(default="", description="The reason without names and numbers")
    length: float
    text: str = Field(default="", description="What is written there, where the entity is words")
    place: list[float] | None = Field(
        default=None,
        description="x, y and height of words (mm; file units while the unit is unknown)",
    )
    box: list[float] | None = Field(
        default=None,
        description="x min, y min, x max, y max of what gave no line, where the file tells it "
        "(mm; file units while the unit is unknown)",
    )


class LineTypeCount(BaseModel):
    """How much of a drawing has one line type."""

    type: LineTypeWord
    edges: int
    length: float


class LayerOut(BaseModel):
    """One pair of layer and colour as the drawing has it."""

    name: str
    colour: int
    edges: int
    length: float
    types: list[LineTypeWord]


class LedgerOut(BaseModel):
    """The entities of the file, counted and listed."""

    kept: int
    merged: int
    dropped: int
    rows: list[LedgerRow] = Field(description="The first 2,000; all of them under …/ledger")


class CleaningLengths(BaseModel):
    """Lengths over all edges (mm): drawn = kept + merged + dropped, worked = kept + added."""

    drawn: float
    kept: float
    merged: float
    dropped: float
    added: float
    worked: float
    no_work: float


class CleaningCounts(BaseModel):
    """How many edges have each fate."""

    kept: int
    merged: int
    dropped: int


class CleaningRow(BaseModel):
    """What became of one edge that is not worked exactly as it was drawn."""

    row: int
    handle: str
    fate: FateWord
    why: Literal["moved", "shortened", "longer", "joined", "fitted", "twice", "speck"]
    into: int = Field(description="Row of the edge that stands for its work, -1 for none")
    kept: float
    merged: float
    dropped: float
    added: float
    moved: float
    off: float
    text: str


class CleaningOut(BaseModel):
    """The ledger of cleaning."""

    lengths: CleaningLengths
    edges: CleaningCounts
    moved: float
    off: float
    rows: list[CleaningRow]


class UnitEvidenceOut(BaseModel):
    """Something that speaks for a unit."""

    unit: Unit
    text: str
    weight: float = Field(description="Logarithm of how much likelier than in the worst unit")


class UnitFindingOut(BaseModel):
    """What the file says and shows of its unit."""

    stated: Unit | Literal[""] = Field(description="By the file's header")
    ranking: list[Unit] = Field(description="The likeliest first")
    evidence: list[UnitEvidenceOut] = Field(description="The heaviest first")
    warnings: list[str] = Field(description="What somebody should look at, whatever the unit")


class ReportGroup(BaseModel):
    """What became of edges or entities for one reason."""

    fate: FateWord
    reason: str
    what: Literal["edges", "entities"] = Field(
        description="Edges have a place in the drawing; of other entities the ledger tells it"
    )
    kinds: list[str] = Field(description="Kinds of the entities, the most frequent first")
    count: int
    length: float


class ReportOut(BaseModel):
    """What became of all that was drawn: kept + merged + dropped = drawn (mm)."""

    drawn: float
    kept: float
    merged: float
    dropped: float
    groups: list[ReportGroup]


Revision = Annotated[int, Field(description="Counts the drawing's changes; its ETag")]


class DrawingOut(BaseModel):
    """A drawing that was read and classified."""

    id: str
    revision: Revision
    name: str
    created: float
    sha256: str
    unit: Unit | None
    unit_given: Unit | None = Field(description="By somebody; null for what the file says")
    evidence: str
    evidence_message: MessageOut | None = Field(default=None, description="The same, with its code")
    unit_finding: UnitFindingOut | None = Field(default=None, description="As for report")
    profile: str
    profile_state: Literal["current", "changed", "deleted"] = Field(
        description="Whether the profile is still as it was when this was classified"
    )
    rules: str = Field(
        description="The customer's profile as it was then (TOML); empty for one that is shipped"
    )
    segments: int
    bounds: tuple[float, float, float, float]
    width: float
    height: float
    counts: list[LineTypeCount]
    layers: list[LayerOut]
    questions: list[QuestionOut]
    overrides: int
    ledger: LedgerOut
    report: ReportOut | None = Field(default=None, description="None of an older knifetip")


class DrawingSummary(BaseModel):
    """A drawing in a list."""

    id: str
    revision: Revision
    name: str
    created: float
    unit: Unit | None
    width: float
    height: float
    segments: int
    questions: int


class EdgeOut(BaseModel):
    """One edge and why it is what it is."""

    row: int
    handle: str
    layer: str
    colour: int
    linetype: str
    type: LineTypeWord
    rule: str
    confidence: float
    alternatives: list[LineTypeWord] = Field(description="What else it could be, likeliest first")
    fate: FateWord
    reason: str = Field(description="Why it was merged or dropped")
    length: float
    start: tuple[float, float]
    end: tuple[float, float]
    bulge: float


class EdgesOut(BaseModel):
    """All edges of a drawing; the viewer asks for them as columns instead (see ``columns``)."""

    edges: list[EdgeOut]


class Override(Strict):
    """Give edges a line type, named by row, by handle, or by layer (and colour).

    ``type`` null takes an earlier override back.
    """

    type: LineTypeWord | None
    edges: list[int] | None = Field(default=None, max_length=200_000)
    handles: list[str] | None = Field(default=None, max_length=200_000)
    layer: str | None = None
    colour: int | None = None


class EdgesPatch(Strict):
    """Overrides, the later ones on top."""

    overrides: list[Override] = Field(min_length=1, max_length=1000)


class DrawingPatch(Strict):
    """What somebody decided about a drawing."""

    unit: Unit | Literal["file"] | None = Field(
        default=None, description='"file" takes back what somebody said: as the file has it'
    )
    profile: Name | None = Field(
        default=None, description="The same one again brings it up to date where it has changed"
    )
    rules: Annotated[str, Field(max_length=LONGEST)] = Field(
        default="",
        description="The customer's profile as it was once, or as it was before it was deleted "
        "(TOML); without it, as it is now",
    )
