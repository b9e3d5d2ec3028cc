"""Models for the queue of a machine, and for changes of waiting jobs."""

from __future__ import annotations

from typing import Final

from pydantic import BaseModel, ConfigDict, Field, model_validator
from pydantic.config import JsonDict

from knifetip.fields import field_error
from knifetip.service.http.models import Copies, JsonBody, Name, Priority
from knifetip.service.order_details.models import OrderDetailsPatch
from knifetip.service.orders.models import JobOut

_BY = Field(
    default="",
    max_length=100,
    description="Name of the operator, for the record of job events; empty if it is not known",
)


class QueueEntry(BaseModel):
    """A job in the queue of a machine, with its place and estimates of its times."""

    place: int = Field(
        description="Place in the queue, from 1; 0 for the job that occupies the machine"
    )
    seconds: float = Field(
        description="Estimated machine time of all copies that remain, without the time in which "
        "the machine waits for the operator (s)"
    )
    starts_in: float | None = Field(
        description="Estimated time until the job starts: the machine time of the jobs before it "
        "(s). Null if it cannot be estimated: the job is on hold or must be compiled again, or the "
        "machine is occupied by an interrupted job"
    )
    picture: str = Field(description="URL of a picture of the drawing (SVG)")
    job: JobOut = Field(description="The job")


class QueueOut(BaseModel):
    """The queue of a machine in the order in which the jobs run."""

    machine: str = Field(description="Name of the machine in the library")
    entries: list[QueueEntry] = Field(
        description="The job that occupies the machine, if there is one, then the waiting jobs in "
        "the order in which the machine takes them. Jobs on hold keep their places and are skipped"
    )


#: At least one neighbour; generators of clients disregard it, unlike ``anyOf``.
_NEIGHBOUR: Final[JsonDict] = {
    "if": {"required": ["previous"], "properties": {"previous": {"type": "string"}}},
    "else": {"required": ["next"], "properties": {"next": {"type": "string"}}},
}


class MoveIn(JsonBody):
    """A new place of a waiting job, given by its neighbours; at least one is required."""

    model_config = ConfigDict(json_schema_extra=_NEIGHBOUR)

    previous: str | None = Field(
        default=None,
        max_length=40,
        description="Id of the waiting job after which the job is to be; empty for the beginning "
        "of the queue; null to give `next` only",
    )
    next: str | None = Field(
        default=None,
        max_length=40,
        description="Id of the waiting job before which the job is to be; empty for the end of "
        "the queue; null to give `previous` only. If both are given and other jobs are between "
        "them, the status is 412",
    )
    by: str = _BY

    @model_validator(mode="after")
    def _has_neighbour(self) -> MoveIn:
        if self.previous is None and self.next is None:
            raise field_error("field.no-neighbour")
        return self


class WaitingChangeIn(OrderDetailsPatch):
    """New values of a waiting job, or new details of the order of any job.

    Priority, copies and hold stay as they are if they are null.
    """

    priority: Priority | None = Field(
        default=None,
        description="Priority in the queue of the machine; jobs with a higher number come first. "
        "The page uses -10 (low), 0 (normal), 10 (high) and 20 (urgent)",
    )
    copies: Copies | None = Field(default=None, description="Number of sheets to make")
    on_hold: bool | None = Field(
        default=None, description="Whether the machine is to take other jobs first"
    )
    by: str = _BY


class TransferIn(JsonBody):
    """Another machine for a waiting job."""

    machine: Name = Field(description="Name of the machine, as in `GET /api/machines`")
    by: str = _BY
