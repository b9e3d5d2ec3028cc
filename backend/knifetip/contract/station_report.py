"""station_report: what a gateway reports about its machine, and what the server answers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from knifetip.contract.operations import Operation, OperationName
from knifetip.messages import Message, with_text

#: State of a controller that takes programs and reports nothing: a person confirms their end.
UNREPORTED = "unreported"


class ActivityState(StrEnum):
    """State of an activity of the machine for a person."""

    RUNNING = "running"
    HELD = "held"
    DONE = "done"
    STOPPED = "stopped"  #: by a person, or because the job or the server did not stay
    FAILED = "failed"

    @property
    def is_over(self) -> bool:
        """Whether the machine has ended the activity."""
        return self not in (ActivityState.RUNNING, ActivityState.HELD)


@dataclass(frozen=True, slots=True)
class Activity:
    """What the machine does for a person while a job waits, as it is reported to the server."""

    kind: str  #: name of the operation: ``dry_run``, ``frame`` or ``tool_check``
    job: str  #: id of the job that waits
    state: ActivityState
    line: int = 0  #: executed lines of the program; those of a dry run are those of the job
    progress: float = 0.0  #: share of the lines that are executed, 0 to 1
    seconds_left: float | None = None
    #: on the sheet, as in the heartbeats of a job
    position: tuple[float, float, float, float] | None = None
    station: int | None = None  #: number of the station whose path is shown
    message: Message | None = None  #: why it has failed, or what it has left out

    def as_json(self) -> dict[str, object]:
        """Return the fields of the report to the server."""
        message = None if self.message is None else with_text(self.message)
        return {
            "kind": self.kind,
            "job": self.job,
            "state": self.state.value,
            "line": self.line,
            "progress": self.progress,
            "seconds_left": self.seconds_left,
            "position": self.position,
            "station": self.station,
            "message": message,
        }


@dataclass(frozen=True, slots=True)
class StationReport:
    """State of the controller of a machine."""

    connected: bool
    state: str = ""  #: state of the controller; "" if it is not connected
    alarm: Message | None = None
    #: why the machine takes no job although no alarm locks it, or why the job on it does not move,
    #: with what to do; None if nothing is in its way
    obstacle: Message | None = None
    position: tuple[float, float, float, float] | None = None  #: in work coordinates
    outputs: tuple[int, ...] = ()  #: outputs that are on
    outputs_known: bool = True  #: all others are off; if False, they may be on
    operations: tuple[str, ...] = ()  #: operations that the controller can do
    override: int | None = None  #: feed override (%); None if the controller has none
    spindle: int | None = None  #: station whose spindle was switched on by hand; None for none
    activity: Activity | None = None  #: the last program above the board; None if there was none
    #: why there is no connection, or harmless differences of settings from the machine file
    notices: tuple[Message, ...] = ()

    def as_json(self) -> dict[str, object]:
        """Return the fields of the request that reports the state to the server."""
        return {
            "connected": self.connected,
            "state": self.state,
            "alarm": None if self.alarm is None else with_text(self.alarm),
            "obstacle": None if self.obstacle is None else with_text(self.obstacle),
            "position": self.position,
            "outputs": self.outputs,
            "outputs_known": self.outputs_known,
            "operations": self.operations,
            "spindle": self.spindle,
            "override": self.override,
            "activity": None if self.activity is None else self.activity.as_json(),
            "notices": [with_text(notice) for notice in self.notices],
        }


@dataclass(frozen=True, slots=True)
class OperationResult:
    """Result of an operation."""

    id: str
    state: str  #: done, refused or expired
    message: Message | None = None

    def as_json(self) -> dict[str, object]:
        """Return the fields of the request that reports the result to the server."""
        message = None if self.message is None else with_text(self.message)
        return {"id": self.id, "state": self.state, "message": message}


@dataclass(frozen=True, slots=True)
class OperationRequest:
    """An operation that a person has asked for, as the server sends it."""

    id: str
    age: float  #: time from the request of the person to the answer of the server (s)
    operation: Operation


@dataclass(frozen=True, slots=True)
class HeldJog:
    """A jog whose button a person still holds."""

    id: str
    age: float  #: time from the last statement of the person to the answer of the server (s)


@dataclass(frozen=True, slots=True)
class StationAnswer:
    """The server's answer to a report."""

    operations: Sequence[OperationRequest]
    waited: float  #: time that the server waited before it answered (s)
    watched: bool  #: a person looks at the machine
    held: HeldJog | None = None  #: the jog whose button the person still holds; None for none

    @classmethod
    def from_answer(cls, answer: Mapping[str, Any]) -> StationAnswer:
        """Return the answer with the fields of a JSON object.

        Raises
        ------
        ValueError, KeyError, TypeError
            A field is missing or has a wrong value.
        """
        return cls(
            [_request(one) for one in answer["operations"]],
            _duration(answer["waited"]),
            bool(answer["watched"]),
            _held(answer.get("jog")),
        )


def _request(fields: Mapping[str, Any]) -> OperationRequest:
    given = {name: value for name, value in fields.items() if value is not None}
    return OperationRequest(
        str(given["id"]),
        _duration(given["age"]),
        Operation(
            OperationName(given["operation"]),
            str(given.get("axis", "")),
            _finite(given.get("distance", 0.0)),
            _finite(given.get("feed", 0.0)),
            str(given.get("axes", "")),
            int(given.get("output", -1)),
            bool(given.get("on", False)),
            int(given.get("station", 0)),
            _finite(given.get("share", 1.0)),
            int(given.get("percent", 100)),
            _box(given.get("box")),
            _point(given.get("point")),
            _finite(given.get("height", 0.0)),
            _box(given.get("shift")) or (0.0, 0.0, 0.0, 0.0),
        ),
    )


def _held(fields: Mapping[str, Any] | None) -> HeldJog | None:
    return None if fields is None else HeldJog(str(fields["id"]), _duration(fields["age"]))


def _box(value: Any) -> tuple[float, float, float, float] | None:
    if value is None:
        return None
    x0, y0, x1, y1 = (_finite(one) for one in value)
    return x0, y0, x1, y1


def _point(value: Any) -> tuple[float, float] | None:
    if value is None:
        return None
    x, y = (_finite(one) for one in value)
    return x, y


def _finite(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{value!r} is not finite")
    return number


def _duration(value: Any) -> float:
    """Return a duration (s); a negative one would make an operation younger than it is."""
    number = _finite(value)
    if number < 0.0:
        raise ValueError(f"the duration {value!r} is negative")
    return number
