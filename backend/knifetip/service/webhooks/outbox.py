"""Outbox of webhooks: the deliveries that an event of a job or drawing sends to other systems.

The deliveries are written in the transaction of the event, so that there is one for each event that
was committed, and none for rolled-back ones.  ``WebhookQueue`` takes them from here.
"""

from __future__ import annotations

import json
import secrets
from collections.abc import Mapping, Sequence
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip import tracing
from knifetip.contract.job import State
from knifetip.service.database.change_notifier import WEBHOOK
from knifetip.service.database.engine import note_change
from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.database.tables import Drawing, Event, Job
from knifetip.service.http.time_text import rfc3339
from knifetip.service.webhooks.tables import Webhook, WebhookDelivery

UPDATED: Final = "job.updated"  #: an event of a job that leaves its state as it is
TEST: Final = "webhook.test"  #: sent on request only, to each endpoint whatever it subscribes to
#: Types of the events to which an endpoint can subscribe.
EVENT_TYPES: Final = (
    *(f"job.{state.value}" for state in State),
    UPDATED,
    "drawing.read",
    "drawing.changed",
    "drawing.deleted",
)

_JOB: Final = (
    *("id", "state", "drawing", "drawing_name", "machine", "board", "profile"),
    *("copies", "copies_done", "priority", "resumes", "lines", "seconds", "program_sha256"),
)
_JOB_TIMES: Final = ("created", "updated", "due")
_DRAWING: Final = ("id", "name", "sha256", "version")
_DRAWING_TIMES: Final = ("created", "due")
_DETAILS: Final = ("external_id", "customer", "notes", "extra")  #: of the order


def enqueue_event(session: Session, event: Event, *, new_state: bool) -> None:
    """Write a delivery of an event for each active endpoint that subscribes to its type.

    Parameters
    ----------
    session
        Session with the transaction that writes the event.
    event
        The event, added to the session.
    new_state
        Whether the job was created or came to another state with this event.
    """
    endpoints = session.execute(
        sa.select(Webhook.serial, Webhook.event_types, Webhook.customer, Webhook.machines).where(
            Webhook.active
        )
    ).all()
    if not endpoints:
        return
    if event.kind == "job":
        event_type = f"job.{event.state}" if new_state else UPDATED
    else:
        event_type = f"{event.kind}.{event.state}"
    subscribed = [one for one in endpoints if not one.event_types or event_type in one.event_types]
    if not subscribed:
        return
    session.flush()  # the event gets its number
    data = _subject_data(session, event)
    receivers = [
        one.serial for one in subscribed if _may_see(one.customer, one.machines, event.kind, data)
    ]
    if not receivers:
        return
    message = None if event.message is None else event.message.as_json()
    payload = {
        "type": event_type,
        "id": event.id,
        "timestamp": rfc3339(event.at),
        "data": {
            **data,
            "event": {"who": event.who, "message": message},
        },
    }
    context = tracing.traceparent() or _order_context(session, event)
    note_change(session, WEBHOOK)
    for serial in receivers:
        session.add(new_delivery(serial, event_type, event.subject, payload, event.at, context))


def _may_see(only: str, machines: Sequence[str], kind: str, data: Mapping[str, Any]) -> bool:
    """Return whether an endpoint gets an event of a job or a drawing.

    ``only``, ``machines``: customer and machines of the endpoint, which are those of the key that
    added it; empty for all.
    """
    limits = KeyLimits(only, frozenset(machines))
    subject = data[kind]
    customer = subject.get("customer", "")
    if kind == "job":
        return limits.sees_job(customer, subject.get("machine", ""))
    return limits.customer in ("", customer)


def new_delivery(
    webhook: int,
    event_type: str,
    subject: str,
    payload: dict[str, Any],
    at: float,
    traceparent: str = "",
) -> WebhookDelivery:
    """Return a delivery that is due at once.

    Parameters
    ----------
    webhook
        Serial number of the endpoint.
    event_type, subject
        Type of the event, and id of the job or drawing.
    payload
        JSON data of the request.
    at
        Present time (seconds since 1970).
    traceparent
        Context of the trace to which the event belongs; "" for none.
    """
    return WebhookDelivery(
        # Without a full stop, which separates the parts of the signed text.
        id=f"msg_{secrets.token_hex(14)}",
        webhook=webhook,
        event_type=event_type,
        subject=subject,
        payload=json.dumps(payload, ensure_ascii=False, separators=(",", ":")),
        created=at,
        state="pending",
        due=at,
        lease=0.0,
        tries=0,
        attempts=[],
        traceparent=traceparent,
    )


def _order_context(session: Session, event: Event) -> str:
    """Return the context of the trace of the order of a job; "" for none.

    It is that of events outside the spans of a request, a compile and a run, such as the start of a
    job by a heartbeat.
    """
    if event.kind != "job" or not tracing.is_on():
        return ""
    return session.scalar(sa.select(Job.traceparent).where(Job.id == event.subject)) or ""


def _subject_data(session: Session, event: Event) -> dict[str, Any]:
    """Return the data of the job or drawing of an event, as they are after the event."""
    table: type[Job] | type[Drawing]
    table, names, times = (
        (Job, _JOB, _JOB_TIMES) if event.kind == "job" else (Drawing, _DRAWING, _DRAWING_TIMES)
    )
    columns = [getattr(table, name) for name in (*names, *times, *_DETAILS)]
    row = session.execute(sa.select(*columns).where(table.id == event.subject)).first()
    if row is None:  # deleted
        return {event.kind: {"id": event.subject}}
    found = dict(zip((*names, *times, *_DETAILS), row, strict=True))
    found["metadata"] = found.pop("extra")
    for name in times:
        found[name] = None if found[name] is None else rfc3339(found[name])
    return {event.kind: found}
