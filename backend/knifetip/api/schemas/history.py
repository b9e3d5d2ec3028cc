"""Models for ended jobs, statistics of the machines, and the use of their tools."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from knifetip.api.schemas.common import JsonBody, Parameters
from knifetip.api.schemas.messages import MessageOut
from knifetip.api.schemas.order_details import DetailsQuery
from knifetip.api.schemas.times import Moment, MomentIn, OptionalMoment, in_order
from knifetip.fields import LISTED

By = Annotated[str, Field(max_length=100)]


class PeriodQuery(Parameters):
    """Query parameters that select a machine and a period."""

    machine: str = Field(
        default="", max_length=200, description="Name of the machine; empty for all machines"
    )
    since: MomentIn | None = Field(default=None, description="Earliest end; null for no limit")
    until: MomentIn | None = Field(
        default=None, description="Time before which the end is; null for no limit"
    )

    _ordered = in_order(("since", "until"))


class HistoryQuery(DetailsQuery, PeriodQuery):
    """Query parameters that select ended jobs; all conditions must be met."""

    state: list[
        Annotated[
            Literal["done", "refused", "interrupted", "scrapped", "continued", "cancelled"], LISTED
        ]
    ] = Field(default=[], description="States of the jobs; may be repeated; all if it is missing")
    board: str = Field(
        default="", max_length=200, description="Name of the board; empty for all boards"
    )
    drawing: str = Field(
        default="",
        max_length=200,
        description="Part of the name of the drawing, in any case; empty for all drawings",
    )
    cursor: str | None = Field(
        default=None,
        max_length=60,
        pattern=r"^\d{1,12}(\.\d{1,20})?-\d{1,18}$",
        description="Position in the list where the page begins, from the Link header of the "
        "previous page",
    )
    limit: int = Field(default=50, ge=1, le=500, description="Maximum number of jobs in the list")


class StatisticsQuery(PeriodQuery):
    """Query parameters that select statistics."""

    step: Annotated[Literal["day", "week", "month"], LISTED] = Field(
        default="week", description="Length of a period; weeks begin on Monday"
    )
    zone: str = Field(
        default="UTC",
        max_length=60,
        description="Time zone in which periods begin at midnight, such as Europe/Berlin",
    )


class StatisticsOut(BaseModel):
    """Sums of the runs of a machine that ended in a period; a run is one stay of a job on it."""

    model_config = ConfigDict(from_attributes=True)

    machine: str = Field(description="Name of the machine")
    start: Moment = Field(description="Begin of the period")
    jobs: int = Field(description="Number of jobs that became done")
    copies: int = Field(description="Number of completed copies")
    runs: int = Field(description="Number of runs")
    interruptions: int = Field(description="Number of runs that were interrupted")
    interrupted_share: float = Field(description="Share of runs that were interrupted, 0 … 1")
    seconds: float = Field(description="Time from the starts of the runs to their ends (s)")
    sheets: dict[str, int] = Field(
        description="Number of used sheets by name of the board, with those that were not completed"
    )
    lengths: dict[str, float] = Field(
        description="Length that the tools worked in the board by line type, such as cut and "
        "crease (m)"
    )


class ToolUseOut(BaseModel):
    """The use of the tool in a station since the tool was changed."""

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")
    used: float = Field(
        description="Length that the tool has worked in the board since its last change, with "
        "the job on the machine (m)"
    )
    life: float = Field(description="Length that the tool may work (m); 0 for no limit")
    share: float = Field(description="Used fraction of the life; 0 if the life has no limit")
    changed: OptionalMoment = Field(description="Time of the last change; null if none is recorded")
    changed_by: str = Field(description="Who changed the tool; empty if no change is recorded")
    warning: Literal["", "near", "over"] = Field(
        description="near: from 90 % of the life on. over: the life is used up, and the operator "
        "must confirm the tool before a job starts. Empty: no warning"
    )
    message: MessageOut | None = Field(description="Text of the warning; null if there is none")


class ToolChangeIn(JsonBody):
    """A person has put a new tool into a station."""

    by: By = Field(default="", description="Name of the person; empty if it is not known")


class ToolLifeIn(JsonBody):
    """The life of the tool in a station."""

    life: float = Field(
        ge=0.0, le=1e7, description="Length that the tool may work (m); 0 for no limit"
    )
    by: By = Field(default="", description="Name of the person; empty if it is not known")


class ToolEventOut(BaseModel):
    """A change of a tool, or of its life, by a person."""

    station: int = Field(description="Number of the station")
    kind: Literal["changed", "life"] = Field(
        description="changed: a new tool was put into the station. life: another life was set"
    )
    at: Moment = Field(description="Time of the change")
    who: str = Field(description="The person: operator, followed by the name if it is known")
    length: float = Field(
        description="Of a changed tool the length that it had worked; otherwise the new life (m)"
    )
