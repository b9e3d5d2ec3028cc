"""Models for new jobs: drawing, machine, board and options, and shortfalls that a user accepts."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from knifetip.model.job_options import JobOptions
from knifetip.service.drawings.models import Override
from knifetip.service.http.models import WHOLE, Copies, Count, JsonBody, Name, Priority
from knifetip.service.order_details.models import OrderDetailsIn


class ShortfallIn(JsonBody):
    """A shortfall of a verdict, selected by its edge and its code."""

    edge: Count = Field(
        description="Row of the edge in the drawing, counted from 0, as in the finding"
    )
    code: str = Field(max_length=100, description="Code of the finding's message")


class ExceptionsIn(JsonBody):
    """Shortfalls of a verdict that a user accepts."""

    findings: list[ShortfallIn] = Field(
        min_length=1, max_length=1000, description="Shortfalls to accept"
    )
    reason: str = Field(
        min_length=1, max_length=500, description="Why the shortfalls are acceptable"
    )
    by: str = Field(min_length=1, max_length=100, description="Name of the user")


class JobChoices(JobOptions, OrderDetailsIn):
    """Choices for a new job, except its drawing."""

    machine: Name = Field(
        default="demo-table",
        description="Name of the machine in the library, as in `GET /api/machines`",
    )
    board: Name = Field(description="Name of the board in the library, as in `GET /api/boards`")
    profile: Name | None = Field(
        default=None,
        description="Name of the classification profile; null for the profile of the drawing",
    )
    copies: Copies = Field(default=1, description="Number of sheets to make")
    priority: Priority = Field(
        default=0,
        description="Priority in the queue of the machine; jobs with a higher number come first",
    )
    overrides: list[Override] = Field(
        default=[],
        max_length=1000,
        description="Line types of edges for this job only, in addition to those of the drawing",
    )
    release: bool = Field(
        default=False,
        description="Whether to queue the job as soon as its program is accepted; if false, the "
        "job stays `ready` until it is released",
    )
    exceptions: ExceptionsIn | None = Field(
        default=None,
        description="Shortfalls that the user accepts in advance, as those of an earlier job for "
        "the same drawing. Shortfalls that the program does not have are disregarded; all others "
        "refuse it. Null for none",
    )


class JobIn(JobChoices):
    """A new job: a drawing, a machine and a board."""

    drawing: Name = Field(description="Id of the drawing")
    revision: Annotated[int, Field(ge=1, le=2**31 - 1), WHOLE] | None = Field(
        default=None,
        description="Expected revision of the drawing; the status is 412 if the drawing has "
        "another one. Null for the newest revision",
    )
