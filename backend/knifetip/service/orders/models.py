"""Models for jobs, their confirmation and their events."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, computed_field

from knifetip.contract.operations import HANDS_CLEAR
from knifetip.fields import LISTED
from knifetip.model.job_options import JobOptions
from knifetip.model.program_facts import ProgramFacts
from knifetip.model.stage import Stage
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import Count, JsonBody, Name, PageQuery, QuestionOut
from knifetip.service.http.times import Moment, OptionalMoment
from knifetip.service.order_details.models import DetailsQuery, OrderDetailsOut, TimesQuery
from knifetip.service.orders.operator_actions import OperatorAction
from knifetip.service.orders.verdict_models import VerdictSummary

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
        "continued",
        "cancelled",
    ],
    LISTED,
]


class JobsQuery(TimesQuery, DetailsQuery, PageQuery):
    """Query parameters that select jobs; all conditions must be met."""

    state: list[JobState] = Field(
        default=[], description="States of the jobs; may be repeated; all if it is missing"
    )
    drawing: str = Field(
        default="", max_length=200, description="Id of the drawing; empty for all drawings"
    )
    machine: str = Field(
        default="", max_length=200, description="Name of the machine; empty for all machines"
    )
    board: str = Field(
        default="", max_length=200, description="Name of the board; empty for all boards"
    )


class ConfirmIn(JsonBody):
    """Confirmation of a job by the operator, with the checks that were made at the machine."""

    checked: Annotated[list[Name], Field(max_length=300)] = Field(
        default=[],
        description="Ids of the checks that the operator has made at the machine: all `checks` of "
        "`GET /api/jobs/{id}/confirmation`. The request is refused if one is missing",
    )
    changed: Annotated[list[Count], Field(max_length=100)] = Field(
        default=[],
        description="Numbers of the stations into which the operator has put new tools; each "
        "change is recorded, and the used length of the tool is 0 again",
    )
    worn_reason: str = Field(
        default="",
        max_length=200,
        description="Why tools at the end of their lives stay in use for this copy; recorded in "
        "the events of the job. If it is empty, the request is refused while such a tool is used",
    )
    by: str = Field(
        default="",
        max_length=100,
        description="Name of the operator, for the record of job events; empty if it is not known",
    )


class EndIn(JsonBody):
    """Statement that the machine has executed a program whose end it does not report."""

    phase: Count | None = Field(
        default=None,
        description="`phase` of the job for which the operator decided; the request is refused if "
        "the job is in another one. Null for no check",
    )


class ResumeIn(EndIn):
    """Request to resume a job that is held in a copy."""

    hands_clear: bool = Field(
        default=False,
        description="States that hands are clear of the machine; this counts for the request only. "
        f"Without it a statement of the last {HANDS_CLEAR:g} s by "
        "`POST /api/machines/{name}/hands-clear` is needed, which then ends",
    )


class JobTool(BaseModel):
    """One tool that the program of a job uses: its station and its kind."""

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")


class StopOut(BaseModel):
    """Place at which the machine stopped a job."""

    line: int = Field(description="Number of executed program lines of the present copy")
    line_at_most: int = Field(
        description="Most program lines of the present copy that the machine may have executed; "
        "greater than `line` if nobody observed the machine until it stopped"
    )
    certain: bool = Field(
        description="Whether `line` is exact. If false, the machine may have executed more lines, "
        "up to `line_at_most`: a job that continues the sheet needs a statement of the operator "
        "which tracks are made"
    )
    position: tuple[float, float, float, float] | None = Field(
        description="Position on the sheet: X, Y of the head axis, Z of the tip before it was "
        "lifted (mm), C (degrees); null if it is not known"
    )
    station: int | None = Field(
        description="Number of the station that was in use; null if there was none, or if it is "
        "not known"
    )


class JobOut(OrderDetailsOut, JobOptions, ProgramFacts):
    """A job with its options, state and progress."""

    # The answer is built by the server; unlike in orders, it has all fields.
    model_config = ConfigDict(
        strict=False,
        extra="ignore",
        frozen=False,
        json_schema_serialization_defaults_required=True,
    )

    id: str = Field(description="Id of the job, assigned by the server")
    state: JobState = Field(
        description="State of the job. received: the compile has not begun. compiling: the "
        "program is made. ready: the program is accepted. queued: the job waits for "
        "its machine. running: the machine executes it. held: the machine has stopped "
        "and can resume. done: all sheets are made. refused: the job cannot be "
        "compiled. interrupted: the machine stopped before the end. scrapped: an "
        "interrupted job was given up. continued: another job continues the work of an interrupted "
        "one. cancelled: the job was cancelled"
    )
    actions: list[OperatorAction] = Field(
        description="Actions that an operator may perform now; each is a route of the job. All "
        "others are refused with 409"
    )
    message: MessageOut | None = Field(
        description="Why the job was refused or interrupted, or what it waits for; null if there "
        "is nothing to report"
    )
    reason: str = Field(description="Text of `message`; empty if `message` is null")
    hint: str = Field(
        description="Hint of `message`; empty if there is none. That of an interrupted "
        "job begins with the best way: to continue the sheet, with the number of tracks left"
    )
    source: list[str] = Field(
        description="Handles of the entities that `message` concerns; empty if it concerns none"
    )
    edges: list[int] = Field(
        description="Rows of the edges of the drawing that `message` concerns, at most 1000: all "
        "edges because of which the job is refused, also where they are parts of one entity. Empty "
        "if it concerns none"
    )
    questions: list[QuestionOut] = Field(
        description="Open questions for which the job was refused; empty if there are none"
    )
    drawing: str = Field(description="Id of the drawing")
    drawing_name: str = Field(description="File name of the drawing")
    machine: str = Field(description="Name of the machine")
    machine_version: int = Field(
        description="Version of the machine for which the job is compiled; 0 for a machine of "
        "knifetip's library"
    )
    board: str = Field(description="Name of the board")
    board_version: int = Field(
        description="Version of the board for which the job is compiled; 0 for a board of "
        "knifetip's library"
    )
    profile: str = Field(description="Name of the classification profile of the job")
    resumes: str | None = Field(
        default=None,
        description="Id of the job whose work this one continues or makes again; null for none",
    )
    is_rest: bool = Field(
        default=False,
        description="Whether the job makes the rest of the sheet of the job `resumes`; false for "
        "the whole program",
    )
    copies: int = Field(description="Number of sheets to make")
    copies_done: int = Field(description="Number of completed sheets")
    program_of: str = Field(
        default="",
        description="Id of an earlier job with the same input whose program this job has, so that "
        "it was not compiled again; empty if it was compiled",
    )
    remaining_copies: int = Field(
        default=0,
        description="Number of copies of a stopped batch that no job has made or is going to "
        "make; a job that makes the rest of a sheet of the batch shows it, too. They are ordered "
        "with `POST /api/jobs/{id}/rest` and `remaining`",
    )
    priority: int = Field(
        description="Priority in the queue of the machine; jobs with a higher number come first"
    )
    created: Moment = Field(description="Time at which the job was created")
    updated: Moment = Field(description="Time of the last change of the job")
    waiting_for: Literal[
        "", "confirmation", "sheet", "machine", "turn", "hold", "check", "compile"
    ] = Field(
        default="",
        description="What the job waits for. confirmation: the operator must confirm table, board "
        "and tools. sheet: the operator must confirm the next sheet. machine: the "
        "machine has not claimed the job. turn: other jobs come first. hold: the job is on "
        "hold in the queue. check: the machine has not begun the program (`check_refusal`), and "
        "waits until an operator lets it be tried again. compile: the machine or the board has "
        "changed, so the job must be compiled again. Empty: it does not wait. "
        "`message` describes the reason",
    )
    queue_position: int | None = Field(
        default=None,
        description="Place of the job in the queue of its machine, from 1; null if it does not "
        "wait there",
    )
    estimated_start: Moment | None = Field(
        default=None,
        description="Estimated start: now, and the machine time of the jobs before it. Null if the "
        "job does not wait in a queue, or if `no_estimate` states why there is none",
    )
    no_estimate: Literal["", "hold", "check", "compile", "interrupted", "gateway"] = Field(
        default="",
        description="Why a waiting job has no estimated start. hold: it is on hold. check: the "
        "machine has refused its program. compile: it "
        "must be compiled again. interrupted: an interrupted job occupies the machine. gateway: "
        "the machine is not connected. Empty otherwise",
    )
    check_refusal: MessageOut | None = Field(
        default=None,
        description="Why the machine has not begun the program: its check run refused it, or a "
        "failure came before the first line. Nothing was executed. The job stays in the queue "
        "and is not taken again by itself: try it again with `recheck`, compile it again or cancel "
        "it. Null if there was no such failure",
    )
    on_hold: bool = Field(
        default=False,
        description="Whether an operator put the job on hold in the queue; its machine then takes "
        "other jobs first",
    )
    started: OptionalMoment = Field(
        default=None,
        description="Time at which the machine began the first copy; null before, and for jobs "
        "that were begun with an older version",
    )
    ended: OptionalMoment = Field(
        default=None,
        description="Time at which the job became done, refused, interrupted, scrapped or "
        "cancelled; null before",
    )
    tools: list[JobTool] = Field(
        default=[], description="Stations that the program uses; empty before the job is compiled"
    )
    requested_action: Literal["", "hold", "resume", "cancel"] = Field(
        default="",
        description="Action that the operator requested and that the machine has not executed "
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
    phase: int = Field(
        default=0,
        description="Number of the phase of the run: it increases whenever the machine goes on "
        "after a hold, and whenever the job begins to wait for something else",
    )
    position: tuple[float, float, float, float] | None = Field(
        description="Position on the sheet: X, Y of the head axis, Z of the tip (mm), C "
        "(degrees); null if it is not known"
    )
    stopped_at: StopOut | None = Field(
        description="Where the machine stopped the job, if it was cancelled or interrupted; null "
        "if it was not, or if nothing was sent to the machine"
    )
    seconds: float = Field(
        description="Estimated machine time of one copy (s); 0 before the job is compiled"
    )
    seconds_left: float | None = Field(
        description="Estimated time until the present copy ends (s); null if it is not known"
    )
    program_sha256: str = Field(
        description="SHA-256 of the program (64 hexadecimal digits); empty before the job is "
        "compiled"
    )
    verdict: VerdictSummary | None = Field(
        description="Summary of the verdict on the program; null before the program is verified"
    )

    # mypy accepts no decorator on a property; pydantic requires it, here and below.
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
    at: Moment = Field(description="Time of the change")
    state: JobState = Field(description="State after the change")
    who: str = Field(
        description="Cause of the change: operator, worker (compile), gateway or clock (expired "
        "lease), followed by its name if it is known"
    )
    message: MessageOut | None = Field(
        description="Description of the change; null if there is nothing to add to the state"
    )
    why: str = Field(description="Text of `message`; empty if `message` is null")
