"""Models of the stations of machines: reports of gateways, and operations of persons."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import BaseModel, Field, model_validator

from knifetip.api.schemas.common import Count, Name, Strict
from knifetip.api.schemas.messages import MessageIn, MessageOut
from knifetip.fields import LISTED, field_error
from knifetip.gateway.operations import EXPIRY

Pose = tuple[float, float, float, float]
OperationWord = Annotated[
    Literal["unlock", "home", "jog", "stop_jog", "zero", "park", "switch"], LISTED
]
StateWord = Literal[
    "idle", "run", "hold", "jog", "home", "check", "door", "alarm", "busy", "unreported", ""
]

_POSITION = (
    "Position of the axes in the work coordinates of programs: X, Y, Z (mm) and C (degrees); null "
    "if it is not known"
)
_STATE = (
    "State of the controller. unreported: the controller takes programs and reports nothing, so a "
    "person confirms the end of each program. Empty if the controller is not connected"
)
#: Arguments that an operation needs, by its name.
_NEEDED = {"jog": ("axis", "distance", "feed"), "zero": ("axes",), "switch": ("output", "on")}


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
    position: Pose | None = Field(description=_POSITION)
    outputs: list[int] = Field(
        description="Numbers of the digital outputs that are on, such as those of the pistons "
        "that lower stations"
    )
    operations: list[str] = Field(
        description="Operations that the controller can do, as in `POST "
        "/api/machines/{name}/operations`"
    )
    job: str = Field(
        description="Id of the job on the machine, or of the job that waits for a confirmation; "
        "empty if there is none"
    )
    seen_seconds_ago: float | None = Field(
        description="Time since the last report of the gateway (s); null if there was none"
    )


class OperationIn(Strict):
    """An operation that a person at the machine asks for."""

    operation: OperationWord = Field(
        description="unlock: clear an alarm without homing. home: find the zero of all axes by "
        "their switches. jog: move one axis by a distance. stop_jog: stop the jog that is "
        "running. zero: set the work coordinates of axes to zero at the present position. park: "
        "lift the tool and move it to the corner of the table. switch: switch an output on or off"
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
    output: Annotated[int, Field(ge=0, le=255)] | None = Field(
        default=None, description="Number of the output to switch; required for `switch`"
    )
    on: bool | None = Field(
        default=None, description="Whether to switch the output on; required for `switch`"
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        """Return this model unchanged if it has the arguments that its operation needs."""
        for name in _NEEDED.get(self.operation, ()):
            if getattr(self, name) is None:
                raise field_error("operation.missing-argument", request=self.operation, name=name)
        return self


class OperationOut(BaseModel):
    """An operation that a person at the machine has asked for."""

    id: str = Field(description="Id of the operation")
    state: Literal["waiting", "done", "refused", "expired"] = Field(
        description=f"waiting: not carried out yet. done: the controller has accepted it. refused: "
        f"the machine did not do it. expired: it was not begun within {EXPIRY:g} s and will not be "
        "carried out, or its result was not reported"
    )
    message: MessageOut | None = Field(
        description="Reason, if the operation was refused or has expired; else null"
    )


class ResultIn(Strict):
    """Result of an operation that a gateway has received."""

    id: Name = Field(description="Id of the operation")
    state: Annotated[Literal["done", "refused", "expired"], LISTED] = Field(
        description="done: the controller has accepted it. refused: the machine did not do it. "
        "expired: it arrived too late and was dropped"
    )
    message: MessageIn | None = Field(default=None, description="Reason; null for none")


class StationIn(Strict):
    """Report of a gateway on its machine."""

    gateway: Name = Field(description="Name of the gateway")
    machine: Name = Field(description="Name of the machine")
    connected: bool = Field(description="Whether the controller is connected")
    state: StateWord = Field(default="", description=_STATE)
    alarm: MessageIn | None = Field(
        default=None, description="Alarm that locks the controller; null if there is none"
    )
    position: Pose | None = Field(default=None, description=_POSITION)
    outputs: Annotated[list[Count], Field(max_length=64)] = Field(
        default=[], description="Numbers of the digital outputs that are on"
    )
    operations: Annotated[list[Name], Field(max_length=32)] = Field(
        default=[], description="Operations that the controller can do"
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


class AskedOut(BaseModel):
    """An operation that the gateway shall carry out now."""

    id: str = Field(description="Id of the operation")
    age: float = Field(
        description="Time from the request of the person to this answer (s); the gateway drops an "
        f"operation that is older than {EXPIRY:g} s before it is carried out"
    )
    operation: str = Field(description="Name of the operation")
    axis: str | None = Field(default=None, description="Axis of a jog")
    distance: float | None = Field(default=None, description="Distance of a jog (mm or degrees)")
    feed: float | None = Field(default=None, description="Speed of a jog (per minute)")
    axes: str | None = Field(default=None, description="Letters of the axes to set to zero")
    output: int | None = Field(default=None, description="Number of the output to switch")
    on: bool | None = Field(default=None, description="Whether to switch the output on")


class StationAnswer(BaseModel):
    """Response to the report of a gateway on its machine: the operations to carry out now."""

    operations: list[AskedOut] = Field(
        description="Operations to carry out now, oldest first; each is sent only once"
    )
    waited: float = Field(description="Time that the server waited before this answer (s)")
    watched: bool = Field(
        description="Whether a person looks at the machine: then reports are wanted every 0.3 s"
    )
