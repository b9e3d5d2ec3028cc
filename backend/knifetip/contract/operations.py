"""Operations that a person at the machine requests: the server stores them, a gateway runs them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

#: Seconds after which an operation that was not executed yet expires.
EXPIRY = 3.0
#: Seconds after which a jog is stopped that the person does not state anew to hold.
JOG_RENEWAL = 1.0
#: Seconds for which the statement counts that hands are clear of the machine.
HANDS_CLEAR = 60.0
#: Smallest share of the feeds of a program.
LEAST_SHARE = 0.05
#: Largest trial correction of X, Y and Z (mm) and of C (degrees).
LARGEST_SHIFT = 20.0


class OperationName(StrEnum):
    """Operations that a person at the machine can ask for."""

    UNLOCK = "unlock"  #: clear an alarm without motion
    HOME = "home"  #: find the zero of all axes by their switches
    JOG = "jog"  #: move one axis by a distance
    STOP_JOG = "stop_jog"  #: stop the jog or the homing cycle that is running
    ZERO = "zero"  #: set the work coordinates of axes to zero at the present position
    PARK = "park"  #: lift the tool, then move it to the corner of the table
    SWITCH = "switch"  #: switch a digital output on or off
    SPINDLE = "spindle"  #: switch the spindle or the oscillation of a station on or off
    DRY_RUN = "dry_run"  #: run the program of the waiting job above the board
    FRAME = "frame"  #: move round the box of the sheet or of the work, above the board
    TOOL_CHECK = "tool_check"  #: move a station above a point, and lower it almost to the board
    LIFT = "lift"  #: lift the tool straight up, and switch everything off
    RELEASE = "release"  #: discard what the controller holds, and switch everything off
    HOLD = "hold"  #: hold a dry run
    RESUME = "resume"  #: resume a dry run
    FEED_OVERRIDE = "feed_override"  #: change the feed of the program that runs


#: Operations that run a program above the board while a job waits (``station``).
RUNS = frozenset({OperationName.DRY_RUN, OperationName.FRAME, OperationName.TOOL_CHECK})
#: Operations that change such a run, and are executed while it uses the machine.
OF_RUNS = frozenset({OperationName.HOLD, OperationName.RESUME, OperationName.STOP_JOG})
#: Operations that are executed while a job runs.
DURING_JOBS = frozenset({OperationName.FEED_OVERRIDE})
#: Operations that free a controller while a job waits for its next sheet; it keeps waiting.
BETWEEN_COPIES = frozenset(
    {
        OperationName.UNLOCK,
        OperationName.HOME,
        OperationName.RELEASE,
        OperationName.LIFT,
        OperationName.STOP_JOG,
    }
)
#: Operations that move the machine by themselves: hands must be clear.  A jog is not among them: it
#: moves only while the person holds its button.
_MOVING = frozenset(
    {
        *RUNS,
        OperationName.HOME,
        OperationName.ZERO,
        OperationName.PARK,
        OperationName.RESUME,
    }
)
#: Operations that lower a station or turn a tool when they switch something on.
_SWITCHING = frozenset({OperationName.SWITCH, OperationName.SPINDLE})


def needs_clear_hands(name: str, on: bool) -> bool:
    """Return whether an operation may only be asked for with hands clear of the machine.

    Parameters
    ----------
    name
        Name of the operation.
    on
        Whether the operation switches something on.
    """
    return name in _MOVING or (on and name in _SWITCHING)


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation that a person at the machine has asked for, with its arguments."""

    name: OperationName
    axis: str = ""  #: letter of the axis to jog
    distance: float = 0.0  #: signed distance of the jog (mm or degrees)
    feed: float = 0.0  #: speed of the jog (mm/min or degrees/min)
    axes: str = ""  #: letters of the axes to set to zero
    output: int = -1  #: number of the output to switch
    on: bool = False
    station: int = 0  #: number of the station that is checked, or whose spindle is switched
    share: float = 1.0  #: share of the feeds of a dry run
    percent: int = 100  #: feed override (%)
    box: tuple[float, float, float, float] | None = None  #: x0, y0, x1, y1 of a frame (mm)
    point: tuple[float, float] | None = None  #: of a tool check, as in programs (mm)
    height: float = 0.0  #: of the tip above the mat in a tool check (mm)
    #: trial correction of the datum in a tool check: X, Y, Z (mm) and C (degrees)
    shift: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
