"""check: whether a toolpath can be written at all, in any language.

Toolpath -> nothing, or an error that names the first row that is wrong
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry.columns import Bool
from knifetip.model.toolpath import Motion, Toolpath

#: Coordinates beyond this are a mistake, on any table (mm, degrees).
FARTHEST: Final = 1e6
#: The slowest feed that says something (mm/min).
SLOWEST: Final = 1e-3
#: Any faster is a mistake (mm/min, degrees/min).
FASTEST: Final = 1e8


def place_of(toolpath: Toolpath, row: int) -> str:
    """Return the row of a toolpath, its motion and its edge, for a message."""
    edge = int(toolpath.source[row])
    motion = int(toolpath.motion[row])
    name = Motion(motion).name if motion in set(Motion) else f"motion {motion}"
    return f"Row {row} of the toolpath ({name}" + (f", edge {edge})" if edge >= 0 else ")")


def check_toolpath(toolpath: Toolpath) -> None:
    """Refuse a toolpath that cannot be printed, naming the first row that is wrong.

    Raises
    ------
    ProgramError
        It is empty, or a row has a number that is none, a feed that does not move, or is an arc
        where there may be none.
    """
    if len(toolpath) == 0:
        raise ProgramError("The toolpath has no moves.", "Classify an edge as something to make.")

    def refuse(wrong: Bool, what: str, hint: str) -> None:
        if wrong.any():
            row = int(np.argmax(wrong))
            edge = int(toolpath.source[row])
            values = f"bulge {toolpath.bulge[row]:g}, feed {toolpath.feed[row]:g}"
            here, there = (
                ", ".join(f"{value:g}" for value in pose) for pose in toolpath.pose[row : row + 2]
            )
            raise ProgramError(
                f"{place_of(toolpath, row)} {what}: from ({here}) to ({there}), {values}.",
                hint,
                [str(edge)] if edge >= 0 else [],
            )

    numbers: Bool = np.logical_and.reduce(np.isfinite(toolpath.pose), axis=1)
    finite = numbers[1:] & numbers[:-1] & np.isfinite(toolpath.bulge) & np.isfinite(toolpath.feed)
    again = "Send the drawing with a report: a stage before this one went wrong."
    refuse(~finite, "has a value that is not a number", again)
    far: Bool = np.logical_or.reduce(np.abs(toolpath.pose) > FARTHEST, axis=1)
    refuse(far[1:] | far[:-1], f"is farther than {FARTHEST:g} mm away", "Look at the unit.")
    rapid = toolpath.motion == Motion.RAPID
    refuse(toolpath.motion > max(Motion), "has a motion that is none", again)
    refuse(~rapid & (toolpath.feed < SLOWEST), "has no feed", "Give the tool a feed.")
    refuse(toolpath.feed > FASTEST, "has a feed beyond any machine", "Look at the tool's feed.")
    refuse(rapid & (np.abs(toolpath.bulge) > 0), "is a rapid along an arc", again)
    refuse(np.abs(toolpath.bulge) > 1.0 + 1e-6, "is an arc of more than half a turn", again)
