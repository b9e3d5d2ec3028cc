"""answers: meaning of the responses of grbl 1.1 and grblHAL.

b"<Run|MPos:1.000,2.000,0.000,90.000|Bf:14,110|FS:500,0>" -> Report      9 -> "it is locked …"

Codes and fields as in grbl's published interface; the texts are our own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from knifetip.gateway.controller import State
from knifetip.gateway.motion import Pose

_STATES = {
    "Idle": State.IDLE,
    "Run": State.RUN,
    "Hold": State.HOLD,
    "Jog": State.JOG,
    "Home": State.HOME,
    "Check": State.CHECK,
    "Door": State.DOOR,
    "Alarm": State.ALARM,
}

ERRORS = {
    1: "a word without its letter",
    2: "a number that cannot be read",
    3: "a $ command that it does not know",
    4: "a negative value where none may be",
    5: "homing is switched off in its settings",
    6: "a step pulse that is too short",
    7: "its settings could not be read and were set to defaults",
    8: "this is possible only while it is idle",
    9: "it is locked by an alarm or jogs",
    10: "soft limits need homing",
    11: "the line is too long",
    12: "a setting beyond its step rate",
    13: "a safety door is open",
    14: "its stored build line is too long",
    15: "a jog beyond the travel",
    16: "a jog without a feed, or with a word that has no place in it",
    17: "laser mode without a variable output",
    18: "it was reset and waits",
    20: "a command that it does not know",
    21: "two commands of one modal group in a line",
    22: "no feed has been set",
    23: "a command that must be a whole number is not",
    24: "two commands in a line want the axis words",
    25: "a word twice in a line",
    26: "a command without the axis words that it needs",
    27: "a line number out of range",
    28: "a command without its P or L word",
    29: "a work offset that it does not have",
    30: "G53 without G0 or G1",
    31: "axis words that no command uses",
    32: "an arc without axis words in its plane",
    33: "an arc whose ends do not lie on one circle",
    34: "an arc whose radius cannot be worked out",
    35: "an arc without I and J",
    36: "words that no command uses",
    37: "a tool length offset on the wrong axis",
    38: "a tool number that is too high",
    39: "a value out of range",
    60: "its memory card could not be opened",
    79: "an emergency stop is pressed",
}

ALARMS = {
    1: "a limit switch was hit; its position is lost",
    2: "a move would have left the travel of the machine",
    3: "it was reset while moving; its position may be lost",
    4: "the probe was not in the expected state",
    5: "the probe did not touch",
    6: "homing was reset",
    7: "the door was opened during homing",
    8: "homing could not leave the limit switch",
    9: "homing did not find the limit switch",
    10: "an emergency stop is pressed",
    11: "it must be homed first",
    12: "a limit switch is closed",
    14: "the spindle did not reach its speed",
    17: "a motor driver reports a fault",
}


def error_text(code: int) -> str:
    """Return the meaning of ``error:code``."""
    return ERRORS.get(code, "an error that has no name here")


def alarm_text(code: int) -> str:
    """Return the meaning of ``ALARM:code``."""
    return ALARMS.get(code, "an alarm that has no name here")


@dataclass(frozen=True, slots=True)
class Report:
    """The fields of a status report; None for fields that were not sent."""

    state: State
    still: bool
    machine: Pose | None = None  #: MPos
    work: Pose | None = None  #: WPos
    offset: Pose | None = None  #: WCO
    free: int | None = None  #: first figure of Bf: blocks free in the planner
    room: int | None = None  #: second figure of Bf: bytes free in the receive buffer
    feed: float = 0.0
    number: int = 0  #: Ln


def rotary_axis(letters: str) -> int:
    """Return the index of the axis that rotates the tool; ``letters`` as in ``[AXS:n:letters]``."""
    return next((letters.index(axis) for axis in "CA" if axis in letters), 3)


def report(line: str, rotary: int = 3) -> Report | None:
    """Parse a status report; return None if the line is damaged.

    ``rotary`` is the index of the axis that rotates the tool (see ``rotary_axis``).
    """
    if not (line.startswith("<") and line.endswith(">")):
        return None
    word, *fields = line[1:-1].split("|")
    name, _, detail = word.partition(":")
    if not name:
        return None
    state = _STATES.get(name, State.BUSY)
    still = state in (State.IDLE, State.CHECK, State.ALARM) or (
        state in (State.HOLD, State.DOOR) and detail in ("", "0")
    )
    poses: dict[str, Pose] = {}
    free, room, feed, number = None, None, 0.0, 0
    try:
        for field in fields:
            key, _, value = field.partition(":")
            if key in ("MPos", "WPos", "WCO"):
                poses[key] = _pose(value, rotary)
            elif key == "Bf":
                blocks, _, bytes_free = value.partition(",")
                free, room = int(blocks), int(bytes_free) if bytes_free else None
            elif key in ("FS", "F"):
                feed = float(value.split(",")[0])
            elif key == "Ln":
                number = int(value)
    except ValueError:
        return None
    machine, work, offset = (poses.get(key) for key in ("MPos", "WPos", "WCO"))
    return Report(state, still, machine, work, offset, free, room, feed, number)


def _pose(value: str, rotary: int) -> Pose:
    """Return X, Y, Z and the rotary axis; axes that the controller does not have are 0."""
    axes = [float(part) for part in value.split(",")]
    if not all(map(math.isfinite, axes)):
        raise ValueError(value)
    x, y, z = (axes + [0.0] * 3)[:3]
    return x, y, z, axes[rotary] if rotary < len(axes) else 0.0
