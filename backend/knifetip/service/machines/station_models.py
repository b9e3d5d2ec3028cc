"""Models of the stations of machines: reports of gateways, and operations of persons."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import BaseModel, Field, model_validator

from knifetip.contract.operations import (
    EXPIRY,
    HANDS_CLEAR,
    JOG_RENEWAL,
    LARGEST_SHIFT,
    LEAST_SHARE,
)
from knifetip.fields import LISTED, field_error
from knifetip.service.http.message_models import MessageIn, MessageOut
from knifetip.service.http.models import WHOLE, Count, JsonBody, Name, Pose
from knifetip.service.http.times import Moment

Coordinate = Annotated[float, Field(ge=-1e5, le=1e5)]
Shift = Annotated[float, Field(ge=-LARGEST_SHIFT, le=LARGEST_SHIFT)]
OperationWord = Annotated[
    Literal[
        "unlock",
        "home",
        "jog",
        "stop_jog",
        "zero",
        "park",
        "switch",
        "spindle",
        "dry_run",
        "frame",
        "tool_check",
        "lift",
        "release",
        "hold",
        "resume",
        "feed_override",
    ],
    LISTED,
]
StateWord = Literal[
    "idle",
    "run",
    "hold",
    "jog",
    "home",
    "check",
    "door",
    "alarm",
    "sleep",
    "tool",
    "busy",
    "unreported",
    "",
]

_OUTPUTS_KNOWN = (
    "Whether all other outputs are off. False after the gateway was started while an alarm locked "
    "the controller: a station may be down until the machine is unlocked, homed or released"
)
_POSITION = (
    "Position of the axes in the work coordinates of programs: X, Y, Z (mm) and C (degrees); null "
    "if it is not known"
)
_STATE = (
    "State of the controller. unreported: the controller takes programs and reports nothing, so a "
    "person confirms the end of each program. Empty if the controller is not connected"
)
_OBSTACLE = (
    "Why a connected machine takes no job although no alarm locks it, or why the job on it does "
    "not move, such as a hold or an open safety door, with what to do; null if there is nothing in "
    "its way"
)
#: Arguments that an operation needs, by its name.
_NEEDED = {
    "jog": ("axis", "distance", "feed"),
    "zero": ("axes",),
    "switch": ("output", "on"),
    "spindle": ("station", "on"),
    "tool_check": ("station", "point"),
    "feed_override": ("percent",),
}


class _Activity(BaseModel):
    """What a machine does above the board for a person, while a job waits for its operator."""

    kind: Literal["dry_run", "frame", "tool_check"] = Field(
        description="dry_run: the program of the job. frame: round the box of sheet or work. "
        "tool_check: a station above a point, lowered almost to the board"
    )
    job: Name = Field(description="Id of the job that waits")
    state: Literal["running", "held", "done", "stopped", "failed"] = Field(
        description="done: it has ended. stopped: a person has stopped it, the job has left the "
        "machine, or the server was silent. failed: the machine has failed"
    )
    line: Count = Field(description="Executed lines; those of a dry run are those of the program")
    progress: float = Field(ge=0.0, le=1.0, description="Executed share of the lines")
    seconds_left: float | None = Field(
        description="Estimated time until the end (s); null if unknown"
    )
    position: Pose | None = Field(
        description="Position on the sheet: X, Y of the head axis, Z of the tip (mm), C (degrees); "
        "null if it is not known",
    )
    station: Count | None = Field(
        description="Number of the station whose path is shown; null for none"
    )


class ActivityIn(_Activity, JsonBody):
    """A run above the board, as the gateway reports it."""

    message: MessageIn | None = Field(
        default=None, description="Why it has failed, or what it has left out; else null"
    )


class ActivityOut(_Activity):
    """A run above the board while a job waits for its operator."""

    message: MessageOut | None = Field(
        description="Why it has failed, or what it has left out; else null"
    )


class StationOut(BaseModel):
    """State of a machine for the person at it."""

    machine: str = Field(description="Name of the machine")
    gateway: str = Field(description="Name of the gateway of the machine; empty if it is silent")
    connected: bool = Field(
        description="Whether the gateway is connected to the server and to the controller"
    )
    state: StateWord = Field(description=_STATE)
    alarm: MessageOut | None = Field(
        description="Alarm that locks the controller, with what to do; null if there is none"
    )
    obstacle: MessageOut | None = Field(description=_OBSTACLE)
    position: Pose | None = Field(description=_POSITION)
    outputs: list[int] = Field(
        description="Numbers of the digital outputs that are on, such as those of the pistons "
        "that lower stations"
    )
    outputs_known: bool = Field(description=_OUTPUTS_KNOWN)
    operations: list[str] = Field(
        description="Operations that the controller can do, as in `POST "
        "/api/machines/{name}/operations`"
    )
    spindle: int | None = Field(
        description="Number of the station whose spindle or oscillation was switched on by hand; "
        "null for none"
    )
    override: int | None = Field(
        description="Feed override: share of the programmed feeds (%); null if the controller has "
        "none"
    )
    activity: ActivityOut | None = Field(
        description="The last run above the board while a job waits; null if there was none"
    )
    notices: list[MessageOut] = Field(
        description="Why the controller is not connected, or harmless differences between its "
        "settings and the machine file, with what to do"
    )
    job: str = Field(
        description="Id of the job on the machine, or of the job that waits for a confirmation; "
        "empty if there is none"
    )
    seen_seconds_ago: float | None = Field(
        description="Time since the last report of the gateway (s); null if there was none"
    )


class OperationIn(JsonBody):
    """An operation that a person at the machine asks for."""

    operation: OperationWord = Field(
        description="unlock: clear an alarm without homing. home: find the zero of all axes by "
        "their switches. jog: move one axis by at most a distance, while `POST "
        "/api/machines/{name}/operations/{id}/renew` is repeated. stop_jog: stop the jog that is "
        "running. zero: set the work coordinates of axes to zero at the present position. park: "
        "lift the tool and move it to the corner of the table. switch: switch an output on or off. "
        "spindle: switch the spindle or the oscillation of a station on or off. "
        "dry_run: run the program of the job that waits for its operator above the board, with "
        "all outputs and the spindle off; the job keeps waiting. frame: move round the box of the "
        "sheet, or of the work if the sheet has no size, above the board. tool_check: "
        "move a station above a point and lower it almost to the board, with the spindle off. "
        "lift: lift the tool straight up and switch everything off. release: discard what the "
        "controller holds or does without a job, such as after an opened door, in a sleep, in "
        "check mode or at a tool change, and switch everything off, without motion. hold, resume: "
        "hold and resume such a run; stop_jog stops it. feed_override: change the feed of the "
        "program that runs, which is 100 % at the start of each job"
    )
    hands_clear: bool = Field(
        default=False,
        description="States that hands are clear of the machine; this counts for the request only. "
        "home, zero, park, dry_run, frame, tool_check, resume, and what is switched on, need it or "
        f"a statement of the last {HANDS_CLEAR:g} s by `POST /api/machines/{{name}}/hands-clear`",
    )
    axis: Literal["X", "Y", "Z", "C"] | None = Field(
        default=None, description="Axis of a jog; required for `jog`"
    )
    distance: float | None = Field(
        default=None,
        ge=-1e5,
        le=1e5,
        description="Signed distance of a jog (mm or degrees); required for `jog`",
    )
    feed: float | None = Field(
        default=None,
        gt=0.0,
        le=1e6,
        description="Speed of a jog (mm/min or degrees/min); required for `jog`",
    )
    axes: str | None = Field(
        default=None,
        pattern="^[XYZC]{1,4}$",
        description="Letters of the axes to set to zero, such as XY; required for `zero`",
    )
    output: Annotated[int, Field(ge=0, le=255), WHOLE] | None = Field(
        default=None, description="Number of the output to switch; required for `switch`"
    )
    on: bool | None = Field(
        default=None,
        description="Whether to switch it on; required for `switch` and `spindle`",
    )
    station: Annotated[int, Field(ge=1, le=255), WHOLE] | None = Field(
        default=None,
        description="Number of the station; required for `spindle` and `tool_check`",
    )
    point: Annotated[tuple[Coordinate, Coordinate], Field(strict=False)] | None = Field(
        default=None,
        description="Point on the table: X, Y in the coordinates of programs (mm); required for "
        "`tool_check`",
    )
    shift: Annotated[tuple[Shift, Shift, Shift, Shift], Field(strict=False)] | None = Field(
        default=None,
        description="Trial correction of the datum of the station: X, Y, Z (mm) and C (degrees), "
        "for `tool_check`; null for none",
    )
    share: float | None = Field(
        default=None,
        ge=LEAST_SHARE,
        le=1.0,
        description="Share of the feeds, for `dry_run`, and of the velocities, for `frame`; null: "
        "1 for `dry_run`, and 0.1 for `frame`",
    )

    percent: Annotated[int, Field(ge=10, le=200), WHOLE] | None = Field(
        default=None,
        description="Share of the programmed feeds (%), within `feed_override` of the machine "
        "file; required for `feed_override`",
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        """Return this model unchanged if it has the arguments that its operation needs."""
        for name in _NEEDED.get(self.operation, ()):
            if getattr(self, name) is None:
                raise field_error("operation.missing-argument", request=self.operation, name=name)
        return self


class HandsClearOut(BaseModel):
    """How long the statement counts that hands are clear of a machine."""

    until: Moment = Field(description="Time until which the statement counts")
    seconds: float = Field(description="Time for which it counts from now on (s)")


class OperationOut(BaseModel):
    """An operation that a person at the machine has asked for."""

    id: str = Field(description="Id of the operation")
    state: Literal["waiting", "done", "refused", "expired"] = Field(
        description=f"waiting: not executed yet. done: the controller has accepted it. refused: "
        f"the machine did not do it. expired: it was not begun within {EXPIRY:g} s and will not be "
        "executed, or its result was not reported"
    )
    message: MessageOut | None = Field(
        description="Reason, if the operation was refused or has expired; else null"
    )


class ResultIn(JsonBody):
    """Result of an operation that a gateway has received."""

    id: Name = Field(description="Id of the operation")
    state: Annotated[Literal["done", "refused", "expired"], LISTED] = Field(
        description="done: the controller has accepted it. refused: the machine did not do it. "
        "expired: it arrived too late and was dropped"
    )
    message: MessageIn | None = Field(default=None, description="Reason; null for none")


class StationIn(JsonBody):
    """Report of a gateway on its machine."""

    gateway: Name = Field(description="Name of the gateway")
    machine: Name = Field(description="Name of the machine")
    connected: bool = Field(description="Whether the controller is connected")
    state: StateWord = Field(default="", description=_STATE)
    alarm: MessageIn | None = Field(
        default=None, description="Alarm that locks the controller; null if there is none"
    )
    obstacle: MessageIn | None = Field(default=None, description=_OBSTACLE)
    position: Pose | None = Field(default=None, description=_POSITION)
    outputs: Annotated[list[Count], Field(max_length=64)] = Field(
        default=[], description="Numbers of the digital outputs that are on"
    )
    outputs_known: bool = Field(default=True, description=_OUTPUTS_KNOWN)
    operations: Annotated[list[Name], Field(max_length=32)] = Field(
        default=[], description="Operations that the controller can do"
    )
    spindle: Count | None = Field(
        default=None,
        description="Number of the station whose spindle was switched on by hand; null for none",
    )
    override: Count | None = Field(
        default=None, description="Feed override (%); null if the controller has none"
    )
    activity: ActivityIn | None = Field(
        default=None, description="The last run above the board; null if there was none"
    )
    notices: Annotated[list[MessageIn], Field(max_length=100)] = Field(
        default=[],
        description="Why the controller is not connected, or harmless differences between its "
        "settings and the machine file",
    )
    results: Annotated[list[ResultIn], Field(max_length=100)] = Field(
        default=[], description="Results of operations since the last report"
    )
    wait: float = Field(
        default=0.0,
        ge=0.0,
        le=10.0,
        description="Longest time that the server may wait for an operation before it answers (s)",
    )


class HeldJogOut(BaseModel):
    """A jog whose button the person still holds."""

    id: str = Field(description="Id of the operation")
    age: float = Field(
        description="Time from the last statement of the person to this answer (s); the gateway "
        f"stops the jog when it is older than {JOG_RENEWAL:g} s"
    )


class AskedOut(BaseModel):
    """An operation that the gateway shall execute now."""

    id: str = Field(description="Id of the operation")
    age: float = Field(
        description="Time from the request of the person to this answer (s); the gateway drops an "
        f"operation that is older than {EXPIRY:g} s before it is executed"
    )
    operation: str = Field(description="Name of the operation")
    axis: str | None = Field(default=None, description="Axis of a jog")
    distance: float | None = Field(default=None, description="Distance of a jog (mm or degrees)")
    feed: float | None = Field(default=None, description="Speed of a jog (per minute)")
    axes: str | None = Field(default=None, description="Letters of the axes to set to zero")
    output: int | None = Field(default=None, description="Number of the output to switch")
    on: bool | None = Field(default=None, description="Whether to switch the output on")
    station: int | None = Field(default=None, description="Number of the station")
    share: float | None = Field(default=None, description="Share of the feeds, for dry runs")
    percent: int | None = Field(default=None, description="Feed override (%)")
    point: tuple[float, float] | None = Field(default=None, description="Point of a tool check")
    height: float | None = Field(
        default=None, description="Height of the tip above the mat in a tool check (mm)"
    )
    shift: Pose | None = Field(
        default=None, description="Trial correction of the datum in a tool check (mm, degrees)"
    )
    box: Pose | None = Field(
        default=None, description="Box of a frame: x0, y0, x1, y1 (mm); null: that of the work"
    )


class StationAnswer(BaseModel):
    """Response to the report of a gateway on its machine: the operations to execute now."""

    operations: list[AskedOut] = Field(
        description="Operations to execute now, oldest first; each is sent only once"
    )
    waited: float = Field(description="Time that the server waited before this answer (s)")
    watched: bool = Field(
        description="Whether a person looks at the machine: then reports are wanted every 0.3 s"
    )
    jog: HeldJogOut | None = Field(
        default=None, description="The jog whose button is held; null if there is none"
    )
