"""Models for nestings: searches for the places of drawings on sheets."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.model.layout import LayoutSheet, PlacedDrawing
from knifetip.model.nesting import NestingJob
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import Count, JsonBody
from knifetip.service.http.times import Moment

NestingStateName = Annotated[Literal["running", "done", "stopped", "failed", "interrupted"], LISTED]


class NestingIn(NestingJob, JsonBody):
    """A new nesting: drawings with their numbers, sheets, and the time of the search."""

    seed: Count = Field(
        default=0, description="Number from which the random choices of the search follow"
    )


class NestedSheet(BaseModel):
    """A sheet with placed drawings; with a name, it is the body of `POST /api/layouts`."""

    sheet: LayoutSheet = Field(description="The sheet")
    placed: list[PlacedDrawing] = Field(
        description="The copies on the sheet, with the revisions of their drawings"
    )
    use: float = Field(description="Share of the whole sheet that the copies use (%)")


class NestingOut(BaseModel):
    """A nesting, with the best arrangement so far."""

    id: str = Field(description="Id of the nesting, assigned by the server")
    created: Moment = Field(description="Time at which it began")
    state: NestingStateName = Field(
        description="running: better arrangements are searched. done: the time is over. stopped: a "
        "user stopped it. failed: `message` states why. interrupted: the server was stopped. "
        "`sheets` is the best arrangement in each state"
    )
    seconds: float = Field(
        description="Time from the begin to the best arrangement (s); 0 if there is none yet"
    )
    limit: float = Field(description="Time after which the search ends (s)")
    count: int = Field(description="Number of copies of all drawings")
    use: float = Field(
        description="Share of the board that the copies use (%); of the last sheet, the board up "
        "to its last copy counts. 0 if there is no arrangement yet"
    )
    rectangles_use: float = Field(
        description="The same if the bounding boxes of the drawings were placed in columns (%)"
    )
    in_holes: int = Field(description="Number of copies that lie in holes of others")
    sheets: list[NestedSheet] = Field(
        description="All sheets of the best arrangement; empty if there is none yet"
    )
    message: MessageOut | None = Field(description="Why it failed; null otherwise")
