"""Records of a tool path: moves of the head's axis after compensation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from knifetip.geometry.columns import F64, I32, I64, U8, freeze, hand_over
from knifetip.messages import Message


class Motion(IntEnum):
    """The purpose of a move of the head."""

    RAPID = 0  #: air move at full speed
    PLUNGE = 1  #: down into the board
    LEAD_IN = 2
    FEED = 3  #: along an edge
    SWIVEL = 4  #: rotation of C alone, with the tool in the board
    LEAD_OUT = 5
    LIFT = 6  #: up out of the board


@dataclass(frozen=True, eq=False, slots=True)
class Toolpath:
    """n moves of a tool between n + 1 poses.

    A pose is the position of the head's axis (x, y), the angle c and the height z of the tip.
    Moves with the same ``track`` ≥ 0 are machined without a lift and keep their order.  Rapids with
    ``track`` -1 connect the tracks.  Before sequencing, the tracks are in the order of the drawing,
    and the rapids are placeholders that the function ``sequence`` replaces.
    """

    pose: F64  #: (n + 1, 4) x y z in mm, c in degrees, unwrapped
    bulge: F64  #: (n,) tan(sweep / 4) of the move in XY
    motion: U8  #: (n,) Motion
    feed: F64  #: (n,) mm/min along XYZ; degrees/min for a SWIVEL; 0 for RAPID
    source: I32  #: (n,) row of the edge in the dieline, -1 between edges
    tool: U8  #: (n,) station number
    track: I32  #: (n,) number of the track, -1 between tracks
    #: what the moves leave out or change as planned, such as the type of a corner
    notes: tuple[Message, ...] = ()
    one_way: bool = False  #: the tracks must be run from their start to their end
    #: first track of each operation of a sequenced toolpath, in their order; empty if not known
    stages: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "bulge", freeze(self.bulge, np.float64, -1))
        rows = len(self.bulge)
        put(self, "pose", freeze(self.pose, np.float64, rows + 1, 4))
        put(self, "motion", freeze(self.motion, np.uint8, rows))
        put(self, "feed", freeze(self.feed, np.float64, rows))
        put(self, "source", freeze(self.source, np.int32, rows))
        put(self, "tool", freeze(self.tool, np.uint8, rows))
        put(self, "track", freeze(self.track, np.int32, rows))

    @classmethod
    def from_new(cls, columns: Mapping[str, NDArray[Any]], notes: tuple[Message, ...]) -> Toolpath:
        """Return a toolpath of new arrays, which it takes over without copies.

        ``columns`` are the arrays by the names of the fields.  They become read-only.
        """
        owned: dict[str, Any] = {name: hand_over(column) for name, column in columns.items()}
        return cls(**owned, notes=notes)

    def __len__(self) -> int:
        return len(self.bulge)

    def with_moves(self, rows: I64, pose: F64) -> Toolpath:
        """Return a toolpath of m moves between new poses; each has the properties of a move of this
        one.

        ``rows`` (m,) is, for each new move, the move with the same bulge, motion, feed, source,
        tool and track; moves may be repeated or left out.  ``pose`` (m + 1, 4) are the poses; the
        array becomes read-only.
        """
        names = ("bulge", "motion", "feed", "source", "tool", "track")
        columns = {name: getattr(self, name)[rows] for name in names}
        return Toolpath.from_new({"pose": pose, **columns}, self.notes)
