"""check: checks of a toolpath that hold for all controller languages.

Toolpath -> nothing, or an error that reports the first wrong row
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry.columns import Bool
from knifetip.messages import Message
from knifetip.model.toolpath import Motion, Toolpath

#: Greatest coordinate; no table is larger (mm, degrees).
FARTHEST: Final = 1e6
#: Least feed (mm/min).
SLOWEST: Final = 1e-3
#: Greatest feed (mm/min, degrees/min).
FASTEST: Final = 1e8


def describe_row(toolpath: Toolpath, row: int) -> Message:
    """Return a message that names a row of a toolpath, its motion and its edge."""
    edge = int(toolpath.source[row])
    motion = int(toolpath.motion[row])
    name = Motion(motion).name if motion in set(Motion) else f"motion {motion}"
    if edge < 0:
        return Message("toolpath.row", row=row, motion=name)
    return Message("toolpath.row-of-edge", row=row, motion=name, edge=edge)


def check_toolpath(toolpath: Toolpath) -> None:
    """Raise an error if a toolpath cannot be written; it reports the first wrong row.

    Raises
    ------
    ProgramError
        The toolpath is empty, or a row has a number that is not finite or out of range, an unknown
        motion, no feed, or an arc that is a rapid or longer than half a turn.
    """
    if len(toolpath) == 0:
        raise ProgramError("toolpath.empty")

    def refuse(wrong: Bool, code: str, **measures: float) -> None:
        if wrong.any():
            row = int(np.argmax(wrong))
            edge = int(toolpath.source[row])
            start, end = (
                ", ".join(f"{value:g}" for value in pose) for pose in toolpath.pose[row : row + 2]
            )
            raise ProgramError(
                code,
                place=describe_row(toolpath, row),
                move=f"from ({start}) to ({end}), bulge {toolpath.bulge[row]:g}, "
                f"feed {toolpath.feed[row]:g}",
                source=[str(edge)] if edge >= 0 else [],
                **measures,
            )

    numbers: Bool = np.logical_and.reduce(np.isfinite(toolpath.pose), axis=1)
    finite = numbers[1:] & numbers[:-1] & np.isfinite(toolpath.bulge) & np.isfinite(toolpath.feed)
    refuse(~finite, "toolpath.not-finite")
    far: Bool = np.logical_or.reduce(np.abs(toolpath.pose) > FARTHEST, axis=1)
    refuse(far[1:] | far[:-1], "toolpath.too-far", limit=FARTHEST)
    rapid = toolpath.motion == Motion.RAPID
    refuse(toolpath.motion > max(Motion), "toolpath.unknown-motion")
    refuse(~rapid & (toolpath.feed < SLOWEST), "toolpath.no-feed")
    refuse(toolpath.feed > FASTEST, "toolpath.feed-too-fast")
    refuse(rapid & (np.abs(toolpath.bulge) > 0), "toolpath.rapid-arc")
    refuse(np.abs(toolpath.bulge) > 1.0 + 1e-6, "toolpath.arc-too-long")
