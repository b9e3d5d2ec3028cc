"""Models of the protocol between the server and a gateway, which controls one machine."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.service.http.message_models import MessageIn
from knifetip.service.http.models import Count, JsonBody, Name, Pose


class ClaimIn(JsonBody):
    """Request of a gateway for the next job of its machine."""

    gateway: Name = Field(
        description="Name of the gateway, unique among all gateways, as it is shown in job events"
    )
    machine: Name = Field(
        description="Name of the machine in the library, as in `GET /api/machines`"
    )
    machine_version: Count | None = Field(
        default=None,
        description="Version of the machine definition that the gateway uses, from `GET "
        "/api/machines/{name}/definition`; null for a definition of its own, which is not compared",
    )
    wait: float = Field(
        default=20.0, ge=0.0, le=60.0, description="Maximum time to wait for a job (s)"
    )
    announces_begin: bool = Field(
        default=False,
        description="Whether the gateway sends no program line before a heartbeat with `begun` is "
        "answered. If its lease expires before that, the job returns to the queue; otherwise it "
        "becomes `interrupted`",
    )


class Claim(BaseModel):
    """A job that is assigned to a gateway until its lease expires.

    Each heartbeat renews the lease.
    """

    job: str = Field(description="Id of the job")
    epoch: int = Field(description="Increases with each claim; to be sent with every report")
    lease: float = Field(description="Duration of the lease (s); renewed by each heartbeat")
    program: str = Field(description="URL of the program, relative to the server")
    sha256: str = Field(description="SHA-256 of the program (64 hexadecimal digits)")
    lines: int = Field(description="Number of program lines")
    copies: int = Field(description="Number of copies that remain to be made")
    seconds: float = Field(
        default=0.0, description="Stated time of a copy on the machine (s); 0 if it is not known"
    )
    confirm: bool = Field(
        default=False,
        description="Send nothing to the machine; send heartbeats with `waiting` until the reply "
        "is `start`",
    )
    traceparent: str = Field(
        default="",
        description="Context of the trace of the order (W3C Trace Context); empty for none",
    )


class HeartbeatIn(JsonBody):
    """Report of a gateway on the progress of its job."""

    job: Name = Field(description="Id of the job, from the claim")
    epoch: Count = Field(description="Epoch of the claim")
    line: Count = Field(description="Number of executed program lines of the present copy")
    copies_done: Count = Field(default=0, description="Copies completed since this claim")
    held: bool = Field(default=False, description="Whether the machine has stopped and can resume")
    waiting: bool = Field(
        default=False,
        description="Nothing has been sent to the machine; the gateway waits for `start`",
    )
    position: Pose | None = Field(
        default=None,
        description="Position on the sheet: X, Y of the head axis, Z of the tip (mm), C "
        "(degrees); null if it is not known",
    )
    seconds_left: float | None = Field(
        default=None,
        description="Estimated time until the present copy ends (s); null if it is not known",
    )
    phase: Count = Field(
        default=0,
        description="Number of the phase of the run since the claim. A new phase begins when the "
        "machine continues after a hold, and when the gateway itself begins to wait for the "
        "operator. The replies `resume` and `end` count only in the phase of the report",
    )
    awaits_end: bool = Field(
        default=False,
        description="Whether the whole program was handed over to a controller that reports "
        "nothing, so that a person must confirm that the machine has executed it",
    )
    begun: bool = Field(
        default=True,
        description="Whether the first program line is sent as soon as this heartbeat is answered, "
        "or was sent before",
    )


class HeartbeatOut(BaseModel):
    """Response to a heartbeat: the command for the gateway."""

    command: Literal["wait", "start", "continue", "hold", "resume", "end", "cancel"] = Field(
        description="Command for the gateway: wait: send nothing to the machine yet. start: begin "
        "the program. continue: no change. hold: stop the machine so that it can "
        "resume. resume: continue after a hold, or start the next copy. end: a person has seen "
        "that the program is executed. cancel: stop the machine and end the job"
    )
    lease: float = Field(description="Duration of the lease from now on (s)")


class FinishIn(JsonBody):
    """Report of a gateway that a job has ended."""

    job: Name = Field(description="Id of the job, from the claim")
    epoch: Count = Field(description="Epoch of the claim")
    outcome: Annotated[
        Literal["done", "interrupted", "cancelled", "returned", "refused"], LISTED
    ] = Field(
        description="done: all copies are complete. interrupted: the machine stopped before the "
        "end. cancelled: the machine was stopped as requested. returned: the job is "
        "released; no program line was executed. refused: the machine has not begun the program, "
        "because its check run refused it or a failure came first; the job stays in the queue "
        "until an operator lets it be tried again"
    )
    why: Annotated[str, Field(max_length=2000)] | MessageIn = Field(
        default="",
        description="Cause of the end: a message, or a text for which there is no code; empty for "
        "none",
    )
    line: Count | None = Field(
        default=None,
        description="Last executed program line; null for the line of the last heartbeat",
    )
    line_at_most: Count | None = Field(
        default=None,
        description="Most program lines of the present copy that the machine may have executed; "
        "equal to `line` if the gateway followed the machine to its stop. Null if it is not known",
    )
    copies_done: Count | None = Field(
        default=None,
        description="Copies completed since this claim; null for the number in the last heartbeat",
    )
    position: Pose | None = Field(
        default=None,
        description="Position on the sheet at which the machine stopped: X, Y of the head axis, Z "
        "of the tip before it was lifted (mm), C (degrees); null for that of the last heartbeat",
    )
    station: Count | None = Field(
        default=None,
        description="Number of the station that was in use when the machine stopped; null if "
        "there was none, or if it is not known",
    )
