"""jobs: what is said of jobs, and of the verdicts on their programs."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, computed_field

from knifetip.api.schemas.common import Name, QuestionOut, Strict
from knifetip.api.schemas.drawings import Override
from knifetip.api.schemas.messages import MessageOut
from knifetip.model.stage import Stage

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
    revision: Annotated[int, Field(ge=1, le=2**31 - 1)] | None = Field(
        default=None, description="Of the drawing that was looked at; 412 if it has changed since"
    )
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


class ConfirmIn(Strict):
    """What the operator found on the table; each of it may be left out."""

    board: Name | None = Field(
        default=None, description="The board that lies there; another than the job's is refused"
    )
    by: str = Field(default="", max_length=100, description="Who confirms, for the record")


class JobTool(BaseModel):
    """A station that a job's program uses."""

    station: int
    name: str
    kind: str


class VerdictSummary(BaseModel):
    """The verdict in figures (mm, s)."""

    accepted: bool
    tolerance: float
    deviation: float
    overcut: float
    uncut: float = Field(description="Greatest length of one edge that is not cut (mm)")
    uncut_total: float = Field(default=0.0, description="Sum over all edges (mm)")
    setback_total: float = Field(default=0.0, description="Sum over all edges (mm)")
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
    hint: str
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
    waiting_for: Literal["", "confirmation", "sheet", "machine", "turn"] = Field(
        default="",
        description="What keeps it from going on, with the words in reason and hint: the "
        "operator's confirmation of table, board and tools; of the next sheet; the machine; its "
        "turn in the queue",
    )
    tools: list[JobTool] = Field(
        default=[], description="Stations that the program uses; empty before it is compiled"
    )
    requested_action: Literal["", "hold", "resume", "cancel"] = Field(
        default="", description="What the operator requested and the machine has not done yet"
    )
    stage: Stage | Literal[""] = Field(
        description="Stage of the compile; empty while the job is not being compiled"
    )
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

    @computed_field(  # type: ignore[prop-decorator]
        description="The former name of hint", json_schema_extra={"deprecated": True}
    )
    @property
    def mend(self) -> str:
        return self.hint

    @computed_field(  # type: ignore[prop-decorator]
        description="The former name of requested_action", json_schema_extra={"deprecated": True}
    )
    @property
    def wish(self) -> Literal["", "hold", "resume", "cancel"]:
        return self.requested_action


class JobEvent(BaseModel):
    """One transition of a job: when, who and why."""

    id: int
    job: str
    at: float
    state: JobState
    who: str
    why: str


class FindingOut(MessageOut):
    """One fault that the verifier found, with its place."""

    kind: str
    measure: float = Field(description="mm, or degrees for a heading")
    edge: int = Field(description="Row of the drawing, -1 where it is about none")
    handle: str
    line: int = Field(description="1-based line of the program, -1 where it is about none")


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
