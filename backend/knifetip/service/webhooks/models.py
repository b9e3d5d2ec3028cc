"""Models for webhooks and their deliveries."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.service.http.models import JsonBody, PageQuery
from knifetip.service.http.times import Moment

EventType = Annotated[
    Literal[
        "job.received", "job.compiling", "job.ready", "job.queued", "job.running", "job.held",
        "job.done", "job.refused", "job.interrupted", "job.scrapped", "job.continued",
        "job.cancelled", "job.updated", "drawing.read", "drawing.changed", "drawing.deleted",
    ],
    LISTED,
]  # fmt: skip
DeliveryStateWord = Literal["pending", "delivered", "dead"]
Url = Annotated[str, Field(min_length=1, max_length=2000)]
Description = Annotated[str, Field(max_length=200)]
EventTypes = Annotated[list[EventType], Field(max_length=30)]


class WebhookIn(JsonBody):
    """A new endpoint to which events are sent."""

    url: Url = Field(
        description="http or https URL of the endpoint; redirects are not followed",
        examples=["https://erp.example/hooks/knifetip"],
    )
    description: Description = Field(default="", description="What the endpoint is for")
    event_types: EventTypes = Field(
        default=[], description="Types of the events that are sent; empty for all"
    )


class WebhookPatch(JsonBody):
    """Changes of an endpoint; a field that is null stays as it is."""

    url: Url | None = Field(default=None, description="New URL; null for no change")
    description: Description | None = Field(
        default=None, description="New description; null for no change"
    )
    event_types: EventTypes | None = Field(
        default=None, description="New types of events; empty for all, null for no change"
    )
    active: bool | None = Field(
        default=None,
        description="Whether events are sent. If it becomes false, the pending deliveries become "
        "dead letters. Null for no change",
    )


class RotationIn(JsonBody):
    """How a new secret replaces the present one."""

    overlap_hours: float = Field(
        default=24.0,
        ge=0.0,
        le=720.0,
        description="Time for which requests are signed with both secrets (hours)",
    )


class DeliveriesQuery(PageQuery):
    """Query parameters that select deliveries."""

    state: DeliveryStateWord | None = Field(
        default=None, description="State of the deliveries; all if it is missing"
    )


class AttemptOut(BaseModel):
    """One attempt to send a delivery."""

    at: Moment = Field(description="Time of the attempt")
    status: int = Field(description="HTTP status of the answer; 0 if there was none")
    seconds: float = Field(description="Duration (s)")
    answer: str = Field(
        default="",
        description="Beginning of the answer without control characters, whatever its status; at "
        "most 200 characters",
    )
    fault: str = Field(
        description="Why there was no answer, or the beginning of an answer that is no success; "
        "empty for a success"
    )


class DeliveryOut(BaseModel):
    """An event that is sent to an endpoint, with the attempts so far."""

    id: str = Field(description="Id of the delivery, which is sent in the header webhook-id")
    event_type: str = Field(description="Type of the event; webhook.test for a test")
    subject: str = Field(description="Id of the job, the drawing, or the webhook of a test")
    state: DeliveryStateWord = Field(
        description="pending: it is sent, or sent again later. delivered: the endpoint accepted "
        "it. dead: it is sent again only on request"
    )
    created: Moment = Field(description="Time of the event")
    next_attempt: Moment | None = Field(
        description="Earliest time of the next attempt; null if none follows"
    )
    attempts: list[AttemptOut] = Field(description="Attempts, oldest first; at most the last 100")


class SentDeliveryOut(DeliveryOut):
    """A delivery with the text that is signed and sent."""

    payload: str = Field(description="Body of the request: JSON")


class WebhookOut(BaseModel):
    """An endpoint to which events are sent."""

    id: str = Field(description="Id of the webhook")
    url: str = Field(description="URL of the endpoint")
    description: str = Field(description="What the endpoint is for; may be empty")
    event_types: list[EventType] = Field(
        description="Types of the events that are sent; empty for all"
    )
    active: bool = Field(
        description="Whether events are sent. An endpoint that answers 410 is switched off"
    )
    created: Moment = Field(description="Time at which it was added")
    created_by: str = Field(description="Who added it")
    previous_secret_until: Moment | None = Field(
        description="Time until which requests are signed with the former secret, too; null if "
        "only the present one signs"
    )
    failures: int = Field(description="Failed attempts since the last success; 0 if it works")
    paused_until: Moment | None = Field(
        description="After several failed attempts in a row nothing is sent before this time, and "
        "then one delivery at a time until the endpoint accepts one; null if it is not paused"
    )
    last_delivery: DeliveryOut | None = Field(description="Newest delivery; null if there is none")


class NewWebhookOut(WebhookOut):
    """An endpoint with its secret, which is shown only in this answer."""

    secret: str = Field(
        description="Secret with which requests are signed, as Standard Webhooks prescribes; it "
        "cannot be read again"
    )
