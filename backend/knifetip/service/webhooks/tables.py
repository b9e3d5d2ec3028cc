"""Tables of webhooks: endpoints of other systems, and the deliveries of events to them."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Mapped, mapped_column

from knifetip import tracing
from knifetip.service.database.tables import SERIAL, Base


class Webhook(Base):
    """An endpoint of another system to which events of jobs and drawings are sent."""

    __tablename__ = "webhook"

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    url: Mapped[str] = mapped_column(sa.String(2000))
    description: Mapped[str] = mapped_column(sa.String(200))
    #: types of the events to send, see ``outbox.EVENT_TYPES``; empty for all
    event_types: Mapped[list[str]] = mapped_column(sa.JSON)
    secret: Mapped[str] = mapped_column(sa.String(100))  #: signs the requests; "whsec_" and base64
    previous_secret: Mapped[str] = mapped_column(sa.String(100), default="")
    #: until when requests are also signed with ``previous_secret``
    previous_until: Mapped[float] = mapped_column(sa.Double, default=0.0)
    active: Mapped[bool] = mapped_column(default=True)
    created: Mapped[float] = mapped_column(sa.Double)
    created_by: Mapped[str] = mapped_column(sa.String(200))
    #: account that added it, see ``database.acting``; empty for none
    owner: Mapped[str] = mapped_column(sa.String(80), default="")
    #: limits of the key that added it, see ``database.key_limits``
    customer: Mapped[str] = mapped_column(sa.String(200), default="")
    machines: Mapped[list[str]] = mapped_column(sa.JSON, default=list)
    #: failed attempts since the last success, for all deliveries together
    failures: Mapped[int] = mapped_column(default=0)
    #: nothing is sent before this time, because several attempts failed one after the other
    resume_at: Mapped[float] = mapped_column(sa.Double, default=0.0)


_PENDING = sa.text("state = 'pending'")


class WebhookDelivery(Base):
    """An event that is sent to one endpoint, with the attempts so far."""

    __tablename__ = "webhook_delivery"
    # The sender reads only pending deliveries, so its queries do not grow with the history.
    __table_args__ = (
        sa.Index(
            "delivery_due",
            *("webhook", "due", "serial"),
            sqlite_where=_PENDING,
            postgresql_where=_PENDING,
        ),
        sa.Index(
            "delivery_of_subject",
            *("webhook", "subject", "serial"),
            sqlite_where=_PENDING,
            postgresql_where=_PENDING,
        ),
        sa.Index("delivery_by_webhook", "webhook", "serial"),
    )

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(40), unique=True)  #: the header webhook-id
    webhook: Mapped[int] = mapped_column(
        SERIAL, sa.ForeignKey("webhook.serial", ondelete="CASCADE")
    )
    event_type: Mapped[str] = mapped_column(sa.String(40))
    subject: Mapped[str] = mapped_column(sa.String(32))  #: id of the job or drawing
    payload: Mapped[str] = mapped_column(sa.Text)  #: the JSON text that is signed and sent
    created: Mapped[float] = mapped_column(sa.Double)
    state: Mapped[str] = mapped_column(sa.String(10))  #: see ``store.DeliveryState``
    due: Mapped[float] = mapped_column(sa.Double)  #: earliest time of the next attempt
    lease: Mapped[float] = mapped_column(sa.Double, default=0.0)  #: until when a sender has it
    tries: Mapped[int] = mapped_column(default=0)  #: attempts since it was created or replayed
    #: all attempts: time, HTTP status (0 for no answer), duration (s) and fault
    attempts: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON)
    #: context of the trace to which the event belongs; empty for none
    traceparent: Mapped[str] = mapped_column(sa.String(tracing.LENGTH), default="")
