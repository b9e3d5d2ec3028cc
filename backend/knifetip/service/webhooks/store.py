"""Repository of webhooks: their endpoints, and the deliveries to them."""

from __future__ import annotations

import base64
import secrets
from collections.abc import Sequence
from enum import StrEnum
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip import tracing
from knifetip.contract.job import new_id
from knifetip.errors import NotFound, WrongState
from knifetip.service.database.acting import acting_limits, acting_owner
from knifetip.service.database.change_notifier import WEBHOOK
from knifetip.service.database.engine import Database, rows, short
from knifetip.service.http.time_text import rfc3339
from knifetip.service.webhooks.outbox import TEST, new_delivery
from knifetip.service.webhooks.queue import bury_pending
from knifetip.service.webhooks.tables import Webhook, WebhookDelivery

#: Greatest number of endpoints; each one is written to in the transaction of every event.
MAX_WEBHOOKS: Final = 50

_SECRET_BYTES = 32


class DeliveryState(StrEnum):
    """State of a delivery."""

    PENDING = "pending"  #: it is sent, or sent again
    DELIVERED = "delivered"
    DEAD = "dead"  #: a dead letter: it is sent again only on request


def new_secret() -> str:
    """Return a random secret in the form of Standard Webhooks."""
    return "whsec_" + base64.b64encode(secrets.token_bytes(_SECRET_BYTES)).decode()


class WebhookStore:
    """Repository of webhooks: their endpoints, and the deliveries to them."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def add(self, url: str, description: str, event_types: Sequence[str], who: str) -> Webhook:
        """Store a new endpoint with a new secret, and return it.

        Parameters
        ----------
        url
            http or https URL, which the caller has checked.
        description
            Text for persons.
        event_types
            Types of the events to send; empty for all.
        who
            Person or program that adds it.

        Raises
        ------
        WrongState
            There are ``MAX_WEBHOOKS`` endpoints.
        """
        limits = acting_limits()
        row = Webhook(
            id=new_id(),
            url=url,
            description=description,
            event_types=list(event_types),
            secret=new_secret(),
            previous_secret="",
            previous_until=0.0,
            active=True,
            created=self._db.clock(),
            created_by=who[:200],
            owner=acting_owner(),
            customer=limits.customer,
            machines=sorted(limits.machines),
            failures=0,
            resume_at=0.0,
        )
        with self._db.writing() as session:
            count = session.scalar(sa.select(sa.func.count()).select_from(Webhook)) or 0
            if count >= MAX_WEBHOOKS:
                raise WrongState("webhook.too-many", count=count)
            session.add(row)
        return row

    def all(self) -> list[Webhook]:
        """Return the endpoints, oldest first."""
        with self._db.reading() as session:
            return list(session.scalars(sa.select(Webhook).order_by(Webhook.serial)))

    def get(self, id: str) -> Webhook:
        """Return the endpoint with an id.

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        """
        with self._db.reading() as session:
            return _find(session, id)

    def change(self, id: str, **changes: Any) -> Webhook:
        """Change columns of an endpoint, and return it.

        An endpoint that is switched off gets no further deliveries: the pending ones become dead
        letters.

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        """
        with self._db.writing() as session:
            row = _find(session, id)
            for name, value in changes.items():
                setattr(row, name, value)
            # Another URL, or one that was switched on again, gets its first attempt at once.
            row.failures, row.resume_at = 0, 0.0
            if not row.active:
                bury_pending(session, row.serial)
        self._db.changes.notify((WEBHOOK,))
        return row

    def rotate_secret(self, id: str, overlap: float) -> Webhook:
        """Give an endpoint a new secret, and return it.

        Parameters
        ----------
        id
            Id of the endpoint.
        overlap
            Time for which requests are also signed with the former secret (s).

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        """
        with self._db.writing() as session:
            row = _find(session, id)
            row.previous_secret, row.secret = row.secret, new_secret()
            row.previous_until = self._db.clock() + overlap
        return row

    def delete(self, id: str) -> None:
        """Delete an endpoint and its deliveries.

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        """
        with self._db.writing() as session:
            session.execute(sa.delete(Webhook).where(Webhook.serial == _find(session, id).serial))

    def send_test(self, id: str) -> WebhookDelivery:
        """Write a delivery of a test event to an endpoint, and return it.

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        WrongState
            The endpoint is switched off.
        """
        with self._db.writing() as session:
            webhook = _find(session, id)
            _check_active(webhook)
            now = self._db.clock()
            payload = {"type": TEST, "timestamp": rfc3339(now), "data": {"webhook": webhook.id}}
            context = tracing.traceparent()
            row = new_delivery(webhook.serial, TEST, webhook.id, payload, now, context)
            row.due = 0.0  # before all others: a person waits for the result
            session.add(row)
            webhook.resume_at = 0.0
        self._db.changes.notify((WEBHOOK,))
        return row

    def deliveries(
        self, id: str, state: str | None, before: int | None, limit: int
    ) -> list[WebhookDelivery]:
        """Return deliveries to an endpoint, newest first.

        Parameters
        ----------
        id
            Id of the endpoint.
        state
            Return only those in this state; None for all.
        before
            Return only those with a smaller serial number; None for all.
        limit
            Greatest number of deliveries.

        Raises
        ------
        NotFound
            There is no endpoint with this id.
        """
        with self._db.reading() as session:
            query = sa.select(WebhookDelivery).where(
                WebhookDelivery.webhook == _find(session, id).serial
            )
            if state is not None:
                query = query.where(WebhookDelivery.state == state)
            if before is not None:
                query = query.where(WebhookDelivery.serial < before)
            query = query.order_by(WebhookDelivery.serial.desc()).limit(limit)
            return list(session.scalars(query))

    def delivery(self, id: str, delivery: str) -> WebhookDelivery:
        """Return a delivery to an endpoint.

        Raises
        ------
        NotFound
            There is no endpoint or delivery with this id.
        """
        with self._db.reading() as session:
            row = session.scalar(
                sa.select(WebhookDelivery).where(
                    WebhookDelivery.webhook == _find(session, id).serial,
                    WebhookDelivery.id == delivery,
                )
            )
            if row is None:
                raise NotFound("webhook.unknown-delivery", delivery=short(delivery))
            return row

    def overlap_end(self, webhook: Webhook) -> float | None:
        """Return the end of the overlap with the former secret; None if that does not sign."""
        overlaps = webhook.previous_secret and webhook.previous_until > self._db.clock()
        return webhook.previous_until if overlaps else None

    def pause_end(self, webhook: Webhook) -> float | None:
        """Return the end of the pause of an endpoint; None if it does not pause."""
        return webhook.resume_at if webhook.resume_at > self._db.clock() else None

    def last_delivery(self, webhook: Webhook) -> WebhookDelivery | None:
        """Return the newest delivery to an endpoint, None if there is none."""
        query = (
            sa.select(WebhookDelivery)
            .where(WebhookDelivery.webhook == webhook.serial)
            .order_by(WebhookDelivery.serial.desc())
            .limit(1)
        )
        with self._db.reading() as session:
            return session.scalar(query)

    def replay(self, id: str, delivery: str | None = None) -> list[WebhookDelivery]:
        """Send a delivery again, or all dead letters of an endpoint; return them, newest first.

        The id of a delivery, which is its header ``webhook-id``, remains.

        Parameters
        ----------
        id
            Id of the endpoint.
        delivery
            Id of the delivery, in any state; None for all dead letters.

        Raises
        ------
        NotFound
            There is no endpoint or delivery with this id.
        WrongState
            The endpoint is switched off.
        """
        with self._db.writing() as session:
            webhook = _find(session, id, lock=True)
            _check_active(webhook)
            chosen = WebhookDelivery.webhook == webhook.serial
            if delivery is None:
                chosen = sa.and_(chosen, WebhookDelivery.state == DeliveryState.DEAD)
            else:
                chosen = sa.and_(chosen, WebhookDelivery.id == delivery)
            changed = rows(
                session,
                sa.update(WebhookDelivery)
                .where(chosen)
                .values(state="pending", due=self._db.clock(), tries=0, lease=0.0)
                .execution_options(synchronize_session=False),
            )
            if delivery is not None and not changed:
                raise NotFound("webhook.unknown-delivery", delivery=short(delivery))
            webhook.failures, webhook.resume_at = 0, 0.0
            chosen = WebhookDelivery.webhook == webhook.serial
            chosen &= (
                WebhookDelivery.state == DeliveryState.PENDING
                if delivery is None
                else WebhookDelivery.id == delivery
            )
            found = session.scalars(
                sa.select(WebhookDelivery)
                .where(chosen)
                .order_by(WebhookDelivery.serial.desc())
                .limit(100)
            )
            replayed = list(found)
        self._db.changes.notify((WEBHOOK,))
        return replayed


def _find(session: Session, id: str, *, lock: bool = False) -> Webhook:
    query = sa.select(Webhook).where(Webhook.id == id)
    row = session.scalar(query.with_for_update() if lock else query)
    if row is None:
        raise unknown_webhook_error(id)
    return row


def unknown_webhook_error(id: str) -> NotFound:
    """Return the error that there is no endpoint with an id."""
    return NotFound("webhook.unknown", webhook=short(id))


def _check_active(webhook: Webhook) -> None:
    if not webhook.active:
        raise WrongState("webhook.inactive", webhook=webhook.id)
