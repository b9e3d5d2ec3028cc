"""answers: the meaning of the answers of grbl 1.1 and grblHAL.

A status report such as ``<Run|MPos:1.000,2.000,0.000,90.000|Bf:14,110|FS:500,0>`` becomes a
``Report``; an error or alarm code becomes a message.  The codes and fields are those of grbl's
published interface; the texts of the messages are those of knifetip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from knifetip.gateway.controller import State
from knifetip.gateway.motion import Pose
from knifetip.messages import Message

_STATES = {
    "Idle": State.IDLE,
    "Run": State.RUN,
    "Hold": State.HOLD,
    "Jog": State.JOG,
    "Home": State.HOME,
    "Check": State.CHECK,
    "Door": State.DOOR,
    "Alarm": State.ALARM,
    "Sleep": State.SLEEP,
    "Tool": State.TOOL,
}

#: Letters of limit switches in the field Pn; the others are probe, door and buttons.
_AXES = "XYZABC"

ERRORS = {
    1: Message("grbl.error-1"),
    2: Message("grbl.error-2"),
    3: Message("grbl.error-3"),
    4: Message("grbl.error-4"),
    5: Message("grbl.error-5"),
    6: Message("grbl.error-6"),
    7: Message("grbl.error-7"),
    8: Message("grbl.error-8"),
    9: Message("grbl.error-9"),
    10: Message("grbl.error-10"),
    11: Message("grbl.error-11"),
    12: Message("grbl.error-12"),
    13: Message("grbl.error-13"),
    14: Message("grbl.error-14"),
    15: Message("grbl.error-15"),
    16: Message("grbl.error-16"),
    17: Message("grbl.error-17"),
    18: Message("grbl.error-18"),
    20: Message("grbl.error-20"),
    21: Message("grbl.error-21"),
    22: Message("grbl.error-22"),
    23: Message("grbl.error-23"),
    24: Message("grbl.error-24"),
    25: Message("grbl.error-25"),
    26: Message("grbl.error-26"),
    27: Message("grbl.error-27"),
    28: Message("grbl.error-28"),
    29: Message("grbl.error-29"),
    30: Message("grbl.error-30"),
    31: Message("grbl.error-31"),
    32: Message("grbl.error-32"),
    33: Message("grbl.error-33"),
    34: Message("grbl.error-34"),
    35: Message("grbl.error-35"),
    36: Message("grbl.error-36"),
    37: Message("grbl.error-37"),
    38: Message("grbl.error-38"),
    39: Message("grbl.error-39"),
    60: Message("grbl.error-60"),
    79: Message("grbl.error-79"),
}

ALARMS = {
    1: Message("grbl.alarm-1"),
    2: Message("grbl.alarm-2"),
    3: Message("grbl.alarm-3"),
    4: Message("grbl.alarm-4"),
    5: Message("grbl.alarm-5"),
    6: Message("grbl.alarm-6"),
    7: Message("grbl.alarm-7"),
    8: Message("grbl.alarm-8"),
    9: Message("grbl.alarm-9"),
    10: Message("grbl.alarm-10"),
    11: Message("grbl.alarm-11"),
    12: Message("grbl.alarm-12"),
    14: Message("grbl.alarm-14"),
    17: Message("grbl.alarm-17"),
}


#: Code of the alarm for a program line whose target is beyond the travel of an axis.
SOFT_LIMIT = 2
#: Code of the alarm while an emergency stop button is pressed: the controller ignores a reset.
EMERGENCY_STOP = 10


def error_meaning(code: int) -> Message:
    """Return a message that explains the answer ``error:code`` of a controller."""
    return ERRORS.get(code, Message("grbl.unknown-error"))


def alarm_meaning(code: int) -> Message:
    """Return a message that explains the alarm ``ALARM:code`` of a controller."""
    return ALARMS.get(code, Message("grbl.unknown-alarm"))


@dataclass(frozen=True, slots=True)
class Report:
    """The fields of a status report of grbl.

    Optional fields that were not sent are None (positions and free space) or 0 (feed and number of
    the executed line).
    """

    state: State
    still: bool
    machine: Pose | None = None  #: MPos
    work: Pose | None = None  #: WPos
    offset: Pose | None = None  #: WCO
    free: int | None = None  #: first figure of Bf: blocks free in the planner
    free_bytes: int | None = None  #: second figure of Bf: bytes free in the receive buffer
    feed: float = 0.0
    number: int = 0  #: Ln
    axes: int = 0  #: number of axes in the last position field
    pressed: str = ""  #: letters of the axes in Pn: limit switches that are pressed
    door_open: bool = False  #: the safety door is open, or was not closed for long enough
    override: int | None = None  #: first figure of Ov: feed override (%)


def report(line: str, rotary: int = 3) -> Report | None:
    """Return the fields of a status report of grbl; None if the line is damaged.

    Parameters
    ----------
    line
        The received line, such as ``<Idle|MPos:0.000,0.000,0.000,0.000>``.
    rotary
        Index of the axis that rotates the tool (see ``Capabilities.rotary_axis``).
    """
    if not (line.startswith("<") and line.endswith(">")):
        return None
    word, *fields = line[1:-1].split("|")
    name, _, detail = word.partition(":")
    if not name:
        return None
    state = _STATES.get(name, State.BUSY)
    still = state in (State.IDLE, State.CHECK, State.ALARM, State.SLEEP, State.TOOL) or (
        (state is State.HOLD and detail in ("", "0"))
        or (state is State.DOOR and detail in ("", "0", "1"))
    )
    door_open = state is State.DOOR and detail not in ("", "0")
    poses: dict[str, Pose] = {}
    free, free_bytes, feed, number, axes, pressed = None, None, 0.0, 0, 0, ""
    override = None
    try:
        for field in fields:
            key, _, value = field.partition(":")
            if key in ("MPos", "WPos", "WCO"):
                poses[key] = _pose(value, rotary)
                axes = value.count(",") + 1
            elif key == "Bf":
                blocks, _, bytes_free = value.partition(",")
                free, free_bytes = int(blocks), int(bytes_free) if bytes_free else None
            elif key in ("FS", "F"):
                feed = float(value.split(",")[0])
                if not math.isfinite(feed):
                    return None
            elif key == "Ln":
                number = int(value)
            elif key == "Ov":
                override = int(value.split(",")[0])
            elif key == "Pn":
                pressed = "".join(letter for letter in value if letter in _AXES)
    except ValueError:
        return None
    machine, work, offset = (poses.get(key) for key in ("MPos", "WPos", "WCO"))
    return Report(
        state,
        still,
        machine,
        work,
        offset,
        free,
        free_bytes,
        feed,
        number,
        axes,
        pressed,
        door_open,
        override,
    )


def _pose(value: str, rotary: int) -> Pose:
    """Return the pose in a position field of a status report: x, y, z (mm) and c (degrees).

    Axes that are not reported are 0.

    ``value``: axis positions separated by commas, such as ``1.000,2.000,0.000,90.000``.
    ``rotary``: index of the axis that rotates the tool.
    Raises ``ValueError``: a position is not a finite number.
    """
    axes = [float(part) for part in value.split(",")]
    if not all(map(math.isfinite, axes)):
        raise ValueError(value)
    x, y, z = (axes + [0.0] * 3)[:3]
    return x, y, z, axes[rotary] if rotary < len(axes) else 0.0
