"""Requests and answers of the REST API: the only words that are spoken at this door.

Lengths are mm, angles degrees, times seconds since 1970 (UTC) or durations in seconds.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr

from knifetip.library.own import LONGEST

LineTypeWord = Literal[
    "unclassified", "cut", "crease", "v-groove", "perforation", "half-cut", "ignored", "combi"
]
FateWord = Literal["kept", "merged", "dropped"]
Unit = Literal["mm", "cm", "m", "in", "ft", "pt", "px"]
JobState = Literal[
    "received",
    "compiling",
    "ready",
    "queued",
    "running",
    "held",
    "done",
    "refused",
    "interrupted",
    "scrapped",
    "cancelled",
]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Count = Annotated[int, Field(ge=0, le=2**31 - 1)]


class Strict(BaseModel):
    """A request: what it does not know, it refuses."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class QuestionOut(BaseModel):
    """Something that somebody must decide before anything is cut."""

    kind: Literal["unit", "line-type", "tool"]
    text: str
    choices: list[str]
    edges: list[int]
    layer: str
    colour: int


class Problem(BaseModel):
    """An error as RFC 9457 has it, with the mend and the entities that it is about."""

    type: str = "about:blank"
    title: str
    status: int
    detail: str
    mend: str = ""
    source: list[str] = []
    questions: list[QuestionOut] = []


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


class DrawingOut(BaseModel):
    """A drawing that was read and classified."""

    id: str
    name: str
    created: float
    sha256: str
    unit: Unit | None
    unit_given: Unit | None = Field(description="By somebody; null for what the file says")
    evidence: str
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


CornerType = Literal["auto", "B", "C", "D"]
Knob = Annotated[float, Field(gt=0.0, lt=1.0, description="Of the D type: 0 is as B, 1 as C")]


class CornerAt(Strict):
    """One corner, named by its place, that is made otherwise than the rest."""

    x: float = Field(description="mm in the drawing; within 0.5 mm of the corner")
    y: float
    type: CornerType
    k: Knob | None = Field(default=None, description="None for that of the rest")


class Corners(Strict):
    """How a router, or a beam with its kerf, goes round corners that stand out towards it.

    B on an arc, C on straight lines with a stop at each bend, D on line, arc and line; auto takes
    for each corner what is over soonest on the machine.
    """

    type: CornerType = "auto"
    k: Knob = 0.5
    interference: Literal["trim", "refuse"] = Field(
        default="trim", description="Where the cutter does not fit: leave that uncut, or refuse"
    )
    at: list[CornerAt] = Field(default=[], max_length=1000)


class JobIn(Strict):
    """An order: this drawing, on this board, on this machine."""

    drawing: Name
    machine: Name = "demo-table"
    board: Name
    profile: Name | None = None
    copies: int = Field(default=1, ge=1, le=1000)
    priority: int = Field(default=0, ge=-100, le=100)
    overrides: list[Override] = Field(default=[], max_length=1000)
    corners: Corners | None = Field(
        default=None, description="Only for machines that mill; left to the machine where null"
    )
    release: bool = Field(default=False, description="Queue it as soon as it is ready")


class VerdictSummary(BaseModel):
    """The verdict in figures (mm, s)."""

    accepted: bool
    tolerance: float
    deviation: float
    overcut: float
    uncut: float
    unreached: float = Field(default=0.0, description="mm² that no cutter gets to")
    unreached_places: int = Field(default=0, description="In so many places")
    seconds: float
    seconds_retracted: float | None = Field(
        default=None, description="What it would take if every turn were a full retract"
    )


class JobOut(BaseModel):
    """A job and where it stands."""

    id: str
    state: JobState
    reason: str
    mend: str
    source: list[str]
    questions: list[QuestionOut]
    drawing: str
    drawing_name: str
    machine: str
    board: str
    profile: str
    copies: int
    copies_done: int
    priority: int
    created: float
    updated: float
    wish: Literal["", "hold", "resume", "cancel"] = Field(
        default="", description="What the operator asked for and the machine has not done yet"
    )
    stage: str = Field(description="What the compile is doing now, empty when it is not compiling")
    progress: float = Field(description="0 … 1 of the compile, or of the run")
    line: int = Field(description="Lines of the program that the machine has executed")
    lines: int
    position: tuple[float, float, float, float] | None = Field(
        description="Head axis X, Y, tip Z, C while running, in sheet coordinates"
    )
    seconds: float = Field(description="Nominal machine time of one copy")
    seconds_left: float | None
    corners: Corners | None
    program_sha256: str
    verdict: VerdictSummary | None


class JobEvent(BaseModel):
    """One transition of a job: when, who and why."""

    id: int
    job: str
    at: float
    state: JobState
    who: str
    why: str


class FindingOut(BaseModel):
    """One thing that the judge found."""

    kind: str
    text: str
    measure: float
    edge: int
    handle: str
    line: int


class UnreachedOut(BaseModel):
    """A place that no cutter gets to."""

    area: float = Field(description="mm²")
    x: float = Field(description="mm in the drawing, of its middle")
    y: float


class VerdictOut(VerdictSummary):
    """The verdict, edge by edge: row i is edge i of the drawing.

    As columns it has the map of deviations besides (``sample_edge``, ``sample_place`` as a share of
    the edge's length, ``sample_deviation`` in mm to its left), and the outlines of what is not
    reached (``area_ends``, ``area_bulge``, ``area_first``, ``area_size``).
    """

    findings: list[FindingOut]
    areas: list[UnreachedOut] = Field(description="What no cutter gets to, the largest first")
    edge_deviation: list[float]
    edge_overcut: list[float]
    edge_uncut: list[float]
    edge_setback: list[float]
    edge_width: list[float] = Field(description="Of a V-groove at the top face; 0 for others")
    edge_web: list[float] = Field(description="Of board left below a V-groove; 0 for others")
    edge_flank: list[float] = Field(description="The farthest that a groove's flank is off")
    edge_unreached: list[float] = Field(description="Length that no cutter can touch")
    edge_bottom_uncut: list[float] = Field(description="Length not cut through the bottom face")
    edge_top_overcut: list[float] = Field(description="Cut past the edge's ends in the top face")


class ToolOut(BaseModel):
    """A tool with the dimensions that the engines use."""

    kind: Literal["knife", "crease-wheel", "v-cutter", "cutter"]
    dimensions: dict[str, float | bool]


class StationOut(BaseModel):
    """A station: joint position = programmed position + datum."""

    number: int
    name: str
    datum: dict[str, float]
    output: int
    tool: ToolOut


class MachineOut(BaseModel):
    """A machine of the library and what is on it now."""

    name: str
    title: str
    width: float
    height: float
    dialect: str
    origin: tuple[float, float]
    travel_z: float
    into_mat: float
    axes: dict[str, dict[str, float]]
    stations: list[StationOut]
    gateway: Literal["connected", "absent"]
    job: str | None


class DeflectionOut(BaseModel):
    """How far a tool gives way in a board (mm)."""

    tool: str
    x: float
    y: float


class BoardOut(BaseModel):
    """A board of the library."""

    name: str
    title: str
    material: str
    caliper: float
    grain: float
    crease_along: float
    crease_across: float
    groove_depth: float
    deflection: list[DeflectionOut]


class MeasuredPoint(Strict):
    """One point of a contour that was cut and measured."""

    azimuth: float = Field(ge=-360.0, le=360.0, description="Degrees, of the cutter's travel there")
    dx: float = Field(ge=-100.0, le=100.0, description="mm: where it came to lie, less as drawn")
    dy: float = Field(ge=-100.0, le=100.0)


class CalibrationIn(Strict):
    """Points measured on a contour that a machine's cutter cut in a board."""

    machine: Name
    tool: Name = Field(description="Name of its station")
    side: Literal["left", "right"] = Field(
        default="left", description="Of travel, where the cutter ran; knifetip's programs: left"
    )
    points: list[MeasuredPoint] = Field(min_length=1, max_length=10_000)


class CalibrationOut(BaseModel):
    """How far the cutter gives way in the board, and the lines to keep in the board's file."""

    board: str
    machine: str
    tool: str
    x: float = Field(description="mm, where the contour runs along Y")
    y: float = Field(description="mm, where it runs along X")
    residual: float = Field(description="mm, the farthest that a point is from what these say")
    toml: str


Patterns = Annotated[list[str], Field(max_length=500)]
Colours = Annotated[
    list[StrictInt | StrictStr], Field(max_length=500, description='AutoCAD indices, or "#rrggbb"')
]


class RuleIn(Strict):
    """One rule: an edge that meets every condition has the type.

    Patterns are shell globs, compared without regard to case; an empty list is no condition.
    """

    type: LineTypeWord
    layer: Patterns = []
    colour: Colours = []
    linetype: Patterns = []
    entity: Patterns = []
    block: Patterns = []


class ProfileIn(Strict):
    """A customer's profile: the first rule that an edge meets decides."""

    title: Name
    extends: Name | None = Field(default=None, description="A shipped profile, whose rules are met")
    overrules: bool = Field(default=True, description="These rules before those that it extends")
    rules: list[RuleIn] = Field(max_length=500)
    version: Count | None = Field(default=None, description="That was looked at; or send If-Match")


class RuleOut(BaseModel):
    """One rule of a profile."""

    type: LineTypeWord
    words: str
    layer: list[str] = []
    colour: list[int | str] = []
    linetype: list[str] = []
    entity: list[str] = []
    block: list[str] = []
    inherited: bool = Field(default=False, description="From the profile that this one extends")


class ProfileOut(BaseModel):
    """A classification profile."""

    name: str
    title: str
    shipped: bool = Field(default=False, description="With knifetip: read it, do not change it")
    extends: str | None = None
    overrules: bool = False
    version: int = Field(default=0, description="Counts the changes; 0 of those that are shipped")
    updated: float = 0.0
    rules: list[RuleOut]
    fault: str = Field(default="", description="Why it cannot be used any more")


class ChangeOut(BaseModel):
    """Edges that would be something else."""

    before: LineTypeWord
    after: LineTypeWord
    edges: list[int]


class PreviewRule(RuleOut):
    """One rule, and what it takes of a drawing."""

    edges: int
    length: float


class PreviewOut(BaseModel):
    """What a profile would do to a drawing."""

    rules: list[PreviewRule]
    open: int = Field(description="Edges that no rule takes")
    changes: list[ChangeOut]


class ProposalOut(BaseModel):
    """A rule that would have said what somebody corrected."""

    rule: RuleOut
    explains: list[int] = Field(description="Corrected edges that it covers")
    sure: bool = Field(description="It changes no edge that was decided")
    changes: list[ChangeOut] = Field(description="What else would become something else")


class StationTool(ToolOut):
    """A tool and where it is mounted."""

    machine: str
    station: int
    name: str


class ClaimIn(Strict):
    """A gateway asks for work and says how long it will wait for it."""

    gateway: Name
    machine: Name
    wait: float = Field(default=20.0, ge=0.0, le=60.0)


class Claim(BaseModel):
    """A job for this gateway alone, until the lease runs out."""

    job: str
    epoch: int
    lease: float = Field(description="Seconds; each heartbeat renews it")
    program: str = Field(description="URL of the program's bytes")
    sha256: str
    lines: int
    copies: int


class HeartbeatIn(Strict):
    """What the machine did since the last one."""

    job: Name
    epoch: Count
    line: Count
    copies_done: Count = 0
    held: bool = False
    position: tuple[float, float, float, float] | None = None
    seconds_left: float | None = None


class HeartbeatOut(BaseModel):
    """What the operator wants."""

    command: Literal["continue", "hold", "resume", "cancel"]
    lease: float


class FinishIn(Strict):
    """How it ended."""

    job: Name
    epoch: Count
    outcome: Literal["done", "interrupted", "cancelled"]
    why: str = Field(default="", max_length=2000)


class Health(BaseModel):
    """Whether the service is alive and ready."""

    status: Literal["ok", "starting"]
    version: str
    checks: dict[str, str] = {}
