"""Models for ended jobs and for statistics of the machines."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from knifetip.fields import LISTED
from knifetip.service.http.models import Parameters
from knifetip.service.http.times import Moment, MomentIn, in_order
from knifetip.service.order_details.models import DetailsQuery


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
    """Sums of the runs of a machine that ended in a period; a job on it is one run."""

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
