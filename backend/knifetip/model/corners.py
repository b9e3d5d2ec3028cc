"""Corner types of a job: how the path of a cutter passes around convex corners of contours."""

from __future__ import annotations

from typing import Annotated, Final, Literal, get_args

from pydantic import Field

from knifetip.fields import LISTED, PartTable

_Type = Literal["B", "C", "D", "auto"]
#: Corner types; a code in a column is an index into this tuple.
TYPES: Final[tuple[str, ...]] = get_args(_Type)
#: Code in a column: the corner has the corner type of its operation.
AS_OTHERS: Final = 255
CornerType = Annotated[_Type, LISTED]
CornerParameter = Annotated[
    float, Field(gt=0.0, lt=1.0, description="Parameter k of type D: 0 is like B, 1 is like C")
]


class CornerAt(PartTable):
    """Corner type of one corner, which is selected by its position."""

    x: float = Field(
        description="X in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    y: float = Field(
        description="Y in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    type: CornerType = Field(
        description="Corner type of this corner; auto: the type that is fastest on the machine"
    )
    k: CornerParameter | None = Field(
        default=None,
        description="Parameter k of this corner, if it has type D; null for the `k` of the job",
    )


class Corners(PartTable):
    """Types of the outer corners of a job.

    At an outer corner the cutter or laser stays on the waste side of the contour and so moves
    around the corner.  The type is the shape of this path.  Type B is an arc.  Type C consists of
    straight lines with a stop at each bend.  Type D consists of a line, an arc and a line.
    ``auto`` chooses for each corner the type that is fastest on the machine.
    """

    type: CornerType = Field(
        default="auto",
        description="Type of all corners that are not in `at`; auto: for each corner the type "
        "that is fastest on the machine",
    )
    k: CornerParameter = Field(
        default=0.5,
        description="Parameter k of corners of type D, between 0 (like type B) and 1 (like type C)",
    )
    interference: Annotated[Literal["trim", "refuse"], LISTED] = Field(
        default="trim",
        description="What happens if the cutter does not fit into a place: trim leaves the area "
        "uncut, refuse refuses the job",
    )
    at: tuple[CornerAt, ...] = Field(
        default=(),
        strict=False,  # JSON has lists
        max_length=1000,
        description="Corners with a type of their own; empty if there are none",
    )
