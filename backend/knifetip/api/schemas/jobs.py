"""Models for jobs, their events and the verdicts on their programs."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from pydantic import BaseModel, Field, computed_field, model_validator

from knifetip.api.schemas.common import Name, QuestionOut, Strict
from knifetip.api.schemas.drawings import Override
from knifetip.api.schemas.messages import MessageOut
from knifetip.fields import LISTED, field_error
from knifetip.jobs.operator_actions import OperatorAction
from knifetip.model.stage import Stage
from knifetip.model.verdict import Severity

JobState = Annotated[
    Literal[
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
    ],
    LISTED,
]
CornerType = Annotated[Literal["auto", "B", "C", "D"], LISTED]
CornerParameter = Annotated[
    float, Field(gt=0.0, lt=1.0, description="Parameter k of type D: 0 is like B, 1 is like C")
]
Lift = Annotated[Literal["clearance", "least"], LISTED]
SheetSize = Annotated[float, Field(gt=0.0, le=10_000.0)]


class CornerAt(Strict):
    """Corner type of one corner, which is selected by its position."""

    x: float = Field(
        description="X in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    y: float = Field(
        description="Y in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    type: CornerType = Field(
        description="Corner type of this corner; auto: the type that is fastest on the machine"
    )
    k: CornerParameter | None = Field(
        default=None,
        description="Parameter k of this corner, if it has type D; null for the `k` of the job",
    )


class Corners(Strict):
    """Types of the outer corners of a job.

    At an outer corner the cutter or laser stays on the waste side of the contour and so moves
    around the corner.  The type is the shape of this path.  Type B is an arc.  Type C consists of
    straight lines with a stop at each bend.  Type D consists of a line, an arc and a line.
    ``auto`` chooses for each corner the type that is fastest on the machine.
    """

    type: CornerType = Field(
        default="auto",
        description="Type of all corners that are not in `at`; auto: for each corner the type "
        "that is fastest on the machine",
    )
    k: CornerParameter = Field(
        default=0.5,
        description="Parameter k of corners of type D, between 0 (like type B) and 1 (like type C)",
    )
    interference: Annotated[Literal["trim", "refuse"], LISTED] = Field(
        default="trim",
        description="What happens if the cutter does not fit into a place: trim leaves the area "
        "uncut, refuse refuses the job",
    )
    at: list[CornerAt] = Field(
        default=[],
        max_length=1000,
        description="Corners with a type of their own; empty if there are none",
    )


class Sheet(Strict):
    """A sheet that was cut to size before the job.

    No board lies outside it, so tools turn without a lift beside it.  The sheet is a rectangle if
    it has a size.  Without a size, it was cut to the outline of the drawing.
    """

    width: SheetSize | None = Field(
        default=None,
        description="Size along X (mm); null for a sheet that was cut to the outline of the "
        "drawing",
    )
    height: SheetSize | None = Field(
        default=None, description="Size along Y (mm); null exactly if `width` is null"
    )
    margin: float = Field(
        default=0.0,
        ge=0.0,
        le=10_000.0,
        description="Distance of the drawing from the left and from the lower edge of the sheet "
        "(mm); 0 for a sheet without a size",
    )

    @model_validator(mode="after")
    def _whole(self) -> Sheet:
        if (self.width is None) != (self.height is None) or (self.width is None and self.margin):
            raise field_error("field.sheet-size")
        return self


class ShortfallIn(Strict):
    """A shortfall of a verdict, selected by its edge and its code."""

    edge: Annotated[int, Field(ge=0, le=2**31 - 1)] = Field(
        description="Row of the edge in the drawing, counted from 0, as in the finding"
    )
    code: str = Field(max_length=100, description="Code of the finding's message")


class ExceptionsIn(Strict):
    """Shortfalls of a verdict that a user accepts."""

    findings: list[ShortfallIn] = Field(
        min_length=1, max_length=1000, description="Shortfalls to accept"
    )
    reason: str = Field(
        min_length=1, max_length=500, description="Why the shortfalls are acceptable"
    )
    by: str = Field(min_length=1, max_length=100, description="Name of the user")


class JobIn(Strict):
    """A new job: a drawing, a machine and a board."""

    drawing: Name = Field(description="Id of the drawing")
    revision: Annotated[int, Field(ge=1, le=2**31 - 1)] | None = Field(
        default=None,
        description="Expected revision of the drawing; the status is 412 if the drawing has "
        "another one. Null for the newest revision",
    )
    machine: Name = Field(
        default="demo-table",
        description="Name of the machine in the library, as in `GET /api/machines`",
    )
    board: Name = Field(description="Name of the board in the library, as in `GET /api/boards`")
    profile: Name | None = Field(
        default=None,
        description="Name of the classification profile; null for the profile of the drawing",
    )
    copies: int = Field(default=1, ge=1, le=1000, description="Number of sheets to make")
    priority: int = Field(
        default=0,
        ge=-100,
        le=100,
        description="Priority in the queue of the machine; jobs with a higher number come first",
    )
    overrides: list[Override] = Field(
        default=[],
        max_length=1000,
        description="Line types of edges for this job only, in addition to those of the drawing",
    )
    corners: Corners | None = Field(
        default=None,
        description="Corner types, for routers and lasers only; null for the fastest types",
    )
    sheet: Sheet | None = Field(
        default=None,
        description="Sheet that was cut to size before the job; null if the sheet may be larger "
        "than the drawing",
    )
    lift: Lift = Field(
        default="clearance",
        description="Height of the tool above the board in turns. clearance: the clearance of the "
        "machine. least: the `turn_clearance` of the machine where that is faster; only for board "
        "that lies flat",
    )
    release: bool = Field(
        default=False,
        description="Whether to queue the job as soon as its program is accepted; if false, the "
        "job stays `ready` until it is released",
    )
    exceptions: ExceptionsIn | None = Field(
        default=None,
        description="Shortfalls that the user accepts in advance, as those of an earlier job for "
        "the same drawing. Shortfalls that the program does not have are disregarded; all others "
        "refuse it. Null for none",
    )


class ConfirmIn(Strict):
    """Confirmation of a job by the operator; all fields are optional."""

    board: Name | None = Field(
        default=None,
        description="Name of the board on the table; the request is refused if it is not the "
        "board of the job. Null for no check",
    )
    by: str = Field(
        default="",
        max_length=100,
        description="Name of the operator, for the record of job events; empty if it is not known",
    )


class JobTool(BaseModel):
    """One tool that the program of a job uses: its station and its kind."""

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")


class VerdictSummary(BaseModel):
    """Measurements of a program by the verifier: maxima over all edges, and totals (mm, mm², s)."""

    accepted: bool = Field(description="Whether the program may be sent to the machine")
    tolerance: float = Field(description="Maximum permitted deviation (mm)")
    deviation: float = Field(
        description="Maximum distance of the tip from the drawing (mm): the sum of the distance of "
        "the tip path from the edge, the rounding of the path by the controller, and the distance "
        "of the edge from the curve of the drawing file"
    )
    path_deviation: float = Field(
        default=0.0, description="Maximum distance of the tip path from an edge (mm)"
    )
    blending: float = Field(
        default=0.0,
        description="Maximum distance by which the controller may round the tip path (mm); 0 if it "
        "follows the path exactly",
    )
    fit_error: float = Field(
        default=0.0,
        description="Maximum distance of an edge from the curve of the drawing file that it "
        "approximates (mm); 0 for lines and circular arcs of the file",
    )
    overcut: float = Field(description="Maximum length cut beyond the end of an edge (mm)")
    uncut: float = Field(
        description="Maximum length of one edge that is left uncut by mistake (mm)"
    )
    uncut_total: float = Field(
        default=0.0, description="Length of all edges that is left uncut by mistake (mm)"
    )
    setback_total: float = Field(
        default=0.0,
        description="Length of all edges that is left uncut by plan, such as at the ends of "
        "creases (mm)",
    )
    unreached: float = Field(default=0.0, description="Total area that no cutter reaches (mm²)")
    unreached_places: int = Field(default=0, description="Number of areas that no cutter reaches")
    unreached_length: float = Field(
        default=0.0, description="Length of all edges that no cutter reaches (mm)"
    )
    unreached_distance: float = Field(
        default=0.0,
        description="Maximum distance of an edge that no cutter reaches from the area that the "
        "cutter sweeps (mm)",
    )
    slit_length: float = Field(
        default=0.0, description="Length of slits that are milled as wide as the cutter (mm)"
    )
    slit_places: int = Field(
        default=0, description="Number of slits that are milled as wide as the cutter"
    )
    faults: int = Field(default=0, description="Number of faults; they cannot be accepted")
    shortfalls: int = Field(default=0, description="Number of shortfalls that no user has accepted")
    exceptions: int = Field(default=0, description="Number of accepted shortfalls")
    seconds: float = Field(description="Machine time of one copy (s)")
    seconds_retracted: float | None = Field(
        default=None,
        description="Machine time of one copy if the tool retracted fully for every turn (s); "
        "null if an older version compiled the job",
    )


class JobOut(BaseModel):
    """A job with its state and progress."""

    id: str = Field(description="Id of the job, assigned by the server")
    state: JobState = Field(
        description="State of the job. received: the compile has not begun. compiling: the "
        "program is made. ready: the program is accepted. queued: the job waits for "
        "its machine. running: the machine executes it. held: the machine has stopped "
        "and can resume. done: all sheets are made. refused: the job cannot be "
        "compiled. interrupted: the machine stopped before the end. scrapped: an "
        "interrupted job was given up. cancelled: the job was cancelled"
    )
    actions: list[OperatorAction] = Field(
        description="Actions that an operator may perform now; each is a route of the job. All "
        "others are refused with 409"
    )
    message: MessageOut | None = Field(
        description="Why the job was refused or interrupted, or what it waits for; null if there "
        "is nothing to report"
    )
    reason: str = Field(description="Text of `message` in English; empty if `message` is null")
    hint: str = Field(description="Hint of `message` in English; empty if there is none")
    source: list[str] = Field(
        description="Handles of the entities that `message` concerns; empty if it concerns none"
    )
    questions: list[QuestionOut] = Field(
        description="Open questions for which the job was refused; empty if there are none"
    )
    drawing: str = Field(description="Id of the drawing")
    drawing_name: str = Field(description="File name of the drawing")
    machine: str = Field(description="Name of the machine in the library")
    board: str = Field(description="Name of the board in the library")
    profile: str = Field(description="Name of the classification profile of the job")
    copies: int = Field(description="Number of sheets to make")
    copies_done: int = Field(description="Number of completed sheets")
    priority: int = Field(
        description="Priority in the queue of the machine; jobs with a higher number come first"
    )
    created: float = Field(
        description="Time at which the job was created (seconds since 1970-01-01 UTC)"
    )
    updated: float = Field(
        description="Time of the last change of the job (seconds since 1970-01-01 UTC)"
    )
    waiting_for: Literal["", "confirmation", "sheet", "machine", "turn"] = Field(
        default="",
        description="What the job waits for. confirmation: the operator must confirm table, board "
        "and tools. sheet: the operator must confirm the next sheet. machine: the "
        "machine has not claimed the job. turn: other jobs come first. Empty: it does "
        "not wait. `message` describes the reason",
    )
    tools: list[JobTool] = Field(
        default=[], description="Stations that the program uses; empty before the job is compiled"
    )
    requested_action: Literal["", "hold", "resume", "cancel"] = Field(
        default="",
        description="Action that the operator requested and that the machine has not carried out "
        "yet; empty for none",
    )
    stage: Stage | Literal[""] = Field(
        description="Stage of the compile; `prepare` while the server compiles functions that the "
        "job needs; empty while the job is not being compiled"
    )
    progress: float = Field(
        description="Completed fraction of the compile or of the execution, 0 … 1"
    )
    line: int = Field(description="Number of executed program lines of the present copy")
    lines: int = Field(description="Number of program lines; 0 before the job is compiled")
    position: tuple[float, float, float, float] | None = Field(
        description="Position on the sheet: X, Y of the head axis, Z of the tip (mm), C "
        "(degrees); null if it is not known"
    )
    seconds: float = Field(
        description="Estimated machine time of one copy (s); 0 before the job is compiled"
    )
    seconds_left: float | None = Field(
        description="Estimated time until the present copy ends (s); null if it is not known"
    )
    corners: Corners | None = Field(
        description="Corner types of the job; null for the fastest types"
    )
    sheet: Sheet | None = Field(
        description="Sheet that was cut to size before the job; the operator must load this "
        "sheet. Null if the sheet may be larger than the drawing",
    )
    lift: Lift = Field(description="Height of the tool above the board in turns")
    program_sha256: str = Field(
        description="SHA-256 of the program (64 hexadecimal digits); empty before the job is "
        "compiled"
    )
    verdict: VerdictSummary | None = Field(
        description="Summary of the verdict on the program; null before the program is verified"
    )

    # mypy accepts no decorator on a property; pydantic requires it.
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
    """One state change of a job: its time, its cause (such as the operator) and its description."""

    id: int = Field(description="Number of the event; increases with time")
    job: str = Field(description="Id of the job")
    at: float = Field(description="Time of the change (seconds since 1970-01-01 UTC)")
    state: JobState = Field(description="State after the change")
    who: str = Field(
        description="Cause of the change: operator, worker (compile), gateway or clock (expired "
        "lease), followed by its name if it is known"
    )
    message: MessageOut | None = Field(
        description="Description of the change; null if there is nothing to add to the state"
    )
    why: str = Field(description="Text of `message` in English; empty if `message` is null")


class AcceptanceOut(BaseModel):
    """Who accepted a shortfall, when and why."""

    by: str = Field(description="Name of the user")
    reason: str = Field(description="Why the shortfall is acceptable")
    at: float = Field(description="Time of the decision (seconds since 1970)")


class AcceptedShortfall(BaseModel):
    """A shortfall that a user accepted."""

    edge: int = Field(description="Row of the edge in the drawing, counted from 0")
    code: str = Field(description="Code of the finding's message")
    acceptance: AcceptanceOut = Field(description="Who accepted the shortfall")


class EarlierExceptions(BaseModel):
    """Shortfalls of a job that a user accepted for an earlier job."""

    job: str = Field(description="Id of the earlier job")
    created: float = Field(description="Time of the earlier order (seconds since 1970)")
    findings: list[AcceptedShortfall] = Field(description="Shortfalls that both jobs have")


class FindingOut(MessageOut):
    """One fault, shortfall or note of the verifier, with its edge and program line."""

    kind: str = Field(
        description="Kind of the finding: deviation, overcut, uncut, stray, depth, heading, order, "
        "feed, travel, program, unreached, kerf, fold or planned"
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
        description="Row of the edge in the drawing, counted from 0; -1 if the fault concerns no "
        "edge"
    )
    handle: str = Field(
        description="Handle of the edge's entity; empty if the fault concerns no edge"
    )
    line: int = Field(description="Program line, counted from 1; -1 if the fault concerns no line")


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


class VerdictOut(VerdictSummary):
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
    edge_deviation: list[float] = Field(
        description="Per edge: maximum distance of the tip from the drawing (mm): the sum of "
        "edge_path_deviation, edge_blending and edge_fit_error"
    )
    edge_path_deviation: list[float] = Field(
        description="Per edge: maximum distance of the tip path from the edge (mm); empty if an "
        "older version compiled the job"
    )
    edge_blending: list[float] = Field(
        description="Per edge: distance by which the controller may round the tip path (mm); empty "
        "if an older version compiled the job"
    )
    edge_fit_error: list[float] = Field(
        description="Per edge: distance of the edge from the curve of the drawing file that it "
        "approximates (mm); empty if an older version compiled the job"
    )
    edge_overcut: list[float] = Field(
        description="Per edge: length cut beyond the ends of the edge (mm)"
    )
    edge_uncut: list[float] = Field(
        description="Per edge: length that is not machined by mistake (mm)"
    )
    edge_setback: list[float] = Field(
        description="Per edge: length that is not machined by plan, such as crease ends (mm)"
    )
    edge_width: list[float] = Field(
        description="Per edge: width of a V-groove at the top face (mm); 0 for other edges"
    )
    edge_web: list[float] = Field(
        description="Per edge: thickness of the board left below a V-groove (mm); 0 for other edges"
    )
    edge_flank: list[float] = Field(
        description="Per edge: maximum deviation of the flanks of a V-groove (mm); 0 for other "
        "edges"
    )
    edge_unreached: list[float] = Field(description="Per edge: length that no cutter reaches (mm)")
    edge_unreached_distance: list[float] = Field(
        description="Per edge: maximum distance of its unreached length from the area that the "
        "cutter sweeps (mm)"
    )
    edge_slit_length: list[float] = Field(
        description="Per edge: length of a slit that is milled as wide as the cutter (mm)"
    )
    edge_tidied: list[float] = Field(
        description="Per edge: distance of the cleaned edge from the edge as drawn (mm); empty if "
        "an older version compiled the job"
    )
    edge_bottom_uncut: list[float] = Field(
        description="Per edge: length not cut at the bottom face of the board (mm)"
    )
    edge_top_overcut: list[float] = Field(
        description="Per edge: length cut beyond the ends at the top face of the board (mm)"
    )
