"""Models for jobs, their events and the verdicts on their programs."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from pydantic import BaseModel, Field, computed_field

from knifetip.api.schemas.common import Name, QuestionOut, Strict
from knifetip.api.schemas.drawings import Override
from knifetip.api.schemas.messages import MessageOut
from knifetip.jobs.operator_actions import OperatorAction
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
CornerParameter = Annotated[
    float, Field(gt=0.0, lt=1.0, description="Parameter k of type D: 0 is like B, 1 is like C")
]


class CornerAt(Strict):
    """Corner type of one corner, which is selected by its position."""

    x: float = Field(description="Position in the drawing (mm), within 0.5 mm of the corner")
    y: float = Field(description="Position in the drawing (mm)")
    type: CornerType
    k: CornerParameter | None = Field(
        default=None, description="Parameter k of this corner. Default: k of the job"
    )


class Corners(Strict):
    """Types of the outer corners of a job: the path of a cutter or a laser round these corners.

    Type B is an arc.  Type C consists of straight lines with a stop at each bend.  Type D consists
    of a line, an arc and a line.  ``auto`` chooses for each corner the type that is fastest on the
    machine.
    """

    type: CornerType = "auto"
    k: CornerParameter = 0.5
    interference: Literal["trim", "refuse"] = Field(
        default="trim",
        description="Reaction if the cutter does not fit: leave the area uncut, or refuse the job",
    )
    at: list[CornerAt] = Field(
        default=[], max_length=1000, description="Corners with a type of their own"
    )


class JobIn(Strict):
    """A new job: a drawing, a machine and a board."""

    drawing: Name
    revision: Annotated[int, Field(ge=1, le=2**31 - 1)] | None = Field(
        default=None, description="Expected revision of the drawing; 412 if it has changed since"
    )
    machine: Name = "demo-table"
    board: Name
    profile: Name | None = Field(
        default=None, description="Classification profile. Default: the profile of the drawing"
    )
    copies: int = Field(default=1, ge=1, le=1000, description="Number of sheets to make")
    priority: int = Field(
        default=0, ge=-100, le=100, description="Jobs with a higher priority come first"
    )
    overrides: list[Override] = Field(
        default=[], max_length=1000, description="Line types of edges for this job only"
    )
    corners: Corners | None = Field(
        default=None,
        description="Corner types, for routers and lasers only; null: the fastest types",
    )
    release: bool = Field(default=False, description="Queue the job as soon as it is ready")


class ConfirmIn(Strict):
    """Confirmation of a job by the operator; all fields are optional."""

    board: Name | None = Field(
        default=None, description="Board on the table; refused if it is not the board of the job"
    )
    by: str = Field(default="", max_length=100, description="Name of the operator, for the record")


class JobTool(BaseModel):
    """A station that the program of a job uses."""

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool")


class VerdictSummary(BaseModel):
    """Measurements of a program by the verifier: maxima over all edges, and totals (mm, mm², s)."""

    accepted: bool = Field(description="Whether the program may be sent to the machine")
    tolerance: float = Field(description="Maximum permitted deviation (mm)")
    deviation: float = Field(description="Maximum distance of the tip from an edge (mm)")
    overcut: float = Field(description="Maximum length cut beyond the end of an edge (mm)")
    uncut: float = Field(description="Maximum uncut length of one edge (mm)")
    uncut_total: float = Field(default=0.0, description="Uncut length of all edges (mm)")
    setback_total: float = Field(default=0.0, description="Setback of all edges (mm)")
    unreached: float = Field(default=0.0, description="Area that no cutter reaches (mm²)")
    unreached_places: int = Field(default=0, description="Number of areas that no cutter reaches")
    seconds: float = Field(description="Machine time of the program (s)")
    seconds_retracted: float | None = Field(
        default=None, description="Machine time if the tool retracted fully for every turn (s)"
    )


class JobOut(BaseModel):
    """A job with its state and progress."""

    id: str
    state: JobState
    actions: list[OperatorAction] = Field(
        description="Actions that an operator may perform now; each is a route of the job. All "
        "others are refused with 409"
    )
    message: MessageOut | None = Field(
        description="Why the job was refused or interrupted, or what it waits for; null if there "
        "is nothing to report"
    )
    reason: str = Field(description="Text of `message` in English; empty if it is null")
    hint: str = Field(description="Hint of `message` in English")
    source: list[str] = Field(description="Handles of the entities that `message` concerns")
    questions: list[QuestionOut] = Field(description="Open questions for which the job was refused")
    drawing: str = Field(description="Id of the drawing")
    drawing_name: str
    machine: str
    board: str
    profile: str = Field(description="Classification profile of the job")
    copies: int = Field(description="Number of sheets to make")
    copies_done: int = Field(description="Number of completed sheets")
    priority: int
    created: float
    updated: float
    waiting_for: Literal["", "confirmation", "sheet", "machine", "turn"] = Field(
        default="",
        description="What the job waits for: the confirmation of table, board and tools; "
        "the confirmation of the next sheet; the machine; its turn in the queue. `message` "
        "describes it",
    )
    tools: list[JobTool] = Field(
        default=[], description="Stations that the program uses; empty before the job is compiled"
    )
    requested_action: Literal["", "hold", "resume", "cancel"] = Field(
        default="",
        description="Action that the operator requested and that the machine has not executed yet",
    )
    stage: Stage | Literal[""] = Field(
        description="Stage of the compile; `prepare` while the server compiles functions that the "
        "job needs; empty while the job is not being compiled"
    )
    progress: float = Field(
        description="Completed fraction of the compile or of the execution, 0 … 1"
    )
    line: int = Field(description="Number of executed lines of the program")
    lines: int = Field(description="Number of program lines")
    position: tuple[float, float, float, float] | None = Field(
        description="Position on the sheet while running: X, Y of the head axis, Z of the tip, C"
    )
    seconds: float = Field(description="Estimated machine time of one copy (s)")
    seconds_left: float | None = Field(
        description="Estimated time until the present copy ends (s); null if it is unknown"
    )
    corners: Corners | None = Field(
        description="Corner types of the job; null for the fastest types"
    )
    program_sha256: str = Field(
        description="SHA-256 of the program; empty before the job is compiled"
    )
    verdict: VerdictSummary | None = Field(description="Null before the program is verified")

    @computed_field(  # type: ignore[prop-decorator]
        description="Former name of hint", json_schema_extra={"deprecated": True}
    )
    @property
    def mend(self) -> str:
        return self.hint

    @computed_field(  # type: ignore[prop-decorator]
        description="Former name of requested_action", json_schema_extra={"deprecated": True}
    )
    @property
    def wish(self) -> Literal["", "hold", "resume", "cancel"]:
        return self.requested_action


class JobEvent(BaseModel):
    """One state change of a job: its time, author and reason."""

    id: int
    job: str = Field(description="Id of the job")
    at: float = Field(description="Time of the change")
    state: JobState = Field(description="State after the change")
    who: str = Field(description="Author of the change")
    message: MessageOut | None = Field(description="Description of the change")
    why: str = Field(description="Text of `message` in English")


class FindingOut(MessageOut):
    """One fault that the verifier found, with its edge and program line."""

    kind: str = Field(description="Kind of the fault")
    measure: float = Field(description="Measured value (mm; degrees for a heading)")
    edge: int = Field(description="Row of the edge; -1 for none")
    handle: str = Field(description="Handle of the edge; empty for none")
    line: int = Field(description="Program line, counted from 1; -1 for none")


#: X and Y in the drawing (mm).
Point: TypeAlias = tuple[float, float]


class UnreachedOut(BaseModel):
    """An area of the drawing that no cutter can reach."""

    area: float = Field(description="Size of the area (mm²)")
    x: float = Field(description="X of the centre in the drawing (mm)")
    y: float = Field(description="Y of the centre in the drawing (mm)")
    outline: list[tuple[Point, Point, float]] = Field(
        description="Lines and arcs of the outline: start, end and bulge, tan(sweep / 4)"
    )


class VerdictOut(VerdictSummary):
    """A verdict with columns of measurements; value i of a column belongs to edge i of the drawing.

    ``format=columns`` also contains samples of the deviation: ``sample_edge``, ``sample_place``
    (position along the edge, 0 … 1) and ``sample_deviation`` (mm, positive to the left).  The
    outlines of the areas that no cutter reaches are in the columns ``area_ends``, ``area_bulge``,
    ``area_first`` (first row of each outline) and ``area_size`` (mm²).
    """

    findings: list[FindingOut]
    areas: list[UnreachedOut] = Field(description="Areas that no cutter reaches, largest first")
    edge_deviation: list[float] = Field(
        description="Maximum distance of the tip from the edge (mm)"
    )
    edge_overcut: list[float] = Field(description="Length cut beyond the ends of the edge (mm)")
    edge_uncut: list[float] = Field(
        description="Length of the edge that is not machined by mistake (mm)"
    )
    edge_setback: list[float] = Field(
        description="Length of the edge that is not machined by plan, such as crease ends (mm)"
    )
    edge_width: list[float] = Field(
        description="Width of a V-groove at the top face (mm); 0 for other edges"
    )
    edge_web: list[float] = Field(description="Board left below a V-groove (mm); 0 for other edges")
    edge_flank: list[float] = Field(description="Maximum deviation of a V-groove's flank (mm)")
    edge_unreached: list[float] = Field(description="Length that no cutter reaches (mm)")
    edge_bottom_uncut: list[float] = Field(description="Length not cut at the bottom face (mm)")
    edge_top_overcut: list[float] = Field(
        description="Length cut beyond the ends at the top face (mm)"
    )
