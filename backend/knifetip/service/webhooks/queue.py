"""Queue of pending deliveries of webhooks, for any number of senders on one database.

A sender claims a delivery with a lease, sends it, and stores the result.  If it is killed
before that, the delivery is sent again when the lease has expired, with the same id: a delivery
arrives at least once.

Order: for one endpoint and one job or drawing, a delivery waits while an earlier one is pending,
until that has failed ``IN_ORDER`` times; a request that an endpoint never accepts does not block
the others for days.  Deliveries of different jobs do not wait for each other.

Failures: each delivery has its own delays.  An endpoint pauses only after ``PAUSE_AFTER`` failures
in a row, and then gets one delivery at a time until it accepts one.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.orm import Session, aliased

from knifetip.service.database.engine import Database, rows
from knifetip.service.webhooks.outbox import TEST
from knifetip.service.webhooks.tables import Webhook, WebhookDelivery

#: Time from each failed attempt to the next one (s); 3.2 days in all.
DELAYS: Final = (
    *(1.0, 5.0, 30.0, 120.0, 600.0, 1800.0, 3600.0, 7200.0, 14_400.0, 28_800.0),
    *(43_200.0,) * 5,
)
#: Each delay is multiplied by a random number in this range.
JITTER: Final = (0.8, 1.2)
#: Failed attempts after which a delivery no longer holds back later ones of its subject.
IN_ORDER: Final = 7
#: Failures in a row, of any deliveries, after which an endpoint pauses.
PAUSE_AFTER: Final = 5
#: Deliveries that one sender sends to one endpoint at the same time; fewer after failures.
PER_ENDPOINT: Final = 4
#: Time for which a sender has a delivery (s); longer than an attempt may take.
LEASE: Final = 30.0
#: Status with which an endpoint refuses all further deliveries.
GONE: Final = 410

#: As SQL text: SQLite uses a partial index only if the query has its condition literally.
_PENDING: Final[sa.ColumnClause[str]] = sa.literal_column("'pending'")
_LONGEST_PAUSE = 600.0  # greatest pause of an endpoint (s)
_KEPT = 100  # attempts of a delivery that are kept
_KEEP = 30 * 86_400.0  # seconds for which deliveries that are not pending are kept
_BATCH = 500  # deliveries that one transaction deletes


@dataclass(frozen=True, slots=True)
class ClaimedDelivery:
    """A delivery that a sender has claimed, with the endpoint as it was then."""

    serial: int
    webhook: int  #: serial number of the endpoint
    id: str
    url: str
    payload: str
    secrets: tuple[str, ...]  #: the present secret, then the previous one if it is still valid
    event_type: str
    attempt: int  #: 1 for the first
    traceparent: str  #: context of the trace to which the event belongs; "" for none


@dataclass(frozen=True, slots=True)
class DeliveryAttempt:
    """The result of one attempt to send a delivery."""

    at: float  #: seconds since 1970
    status: int  #: HTTP status; 0 without an answer
    seconds: float
    fault: str = ""  #: why there was no answer, or the beginning of an answer that is no success
    answer: str = ""  #: beginning of the answer, whatever its status

    @property
    def succeeded(self) -> bool:
        """Whether the endpoint has accepted the delivery."""
        return 200 <= self.status < 300

    def as_json(self) -> dict[str, Any]:
        """Return the attempt as JSON data."""
        return {
            "at": self.at,
            "status": self.status,
            "seconds": round(self.seconds, 3),
            "fault": self.fault,
            "answer": self.answer,
        }


class WebhookQueue:
    """Repository of the pending deliveries of webhooks."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def has_pending(self) -> bool:
        """Return whether there is a pending delivery."""
        query = sa.select(WebhookDelivery.serial).where(WebhookDelivery.state == _PENDING)
        with self._db.reading() as session:
            return session.scalar(query.limit(1)) is not None

    def claim(
        self, in_flight: Mapping[int, int] = MappingProxyType({}), lease: float = LEASE
    ) -> ClaimedDelivery | None:
        """Claim the next delivery; return None if none may be sent now.

        It is one to the endpoint with the fewest deliveries in flight, so that slow and busy
        endpoints do not delay the others; of these, the one that is due first.

        Parameters
        ----------
        in_flight
            Number of deliveries that this sender is sending to each endpoint, by serial number.
        lease
            Time for which the sender has the delivery (s).
        """
        now = self._db.clock()
        # Without a write, which would lock SQLite, as long as nothing is due.
        with self._db.reading() as session:
            due = sorted(
                (in_flight.get(serial, 0), row.due, row.serial, serial)
                for serial in self._ready_endpoints(session, in_flight, now)
                if (row := self._first_due(session, serial, now)) is not None
            )
        for *_, serial in due:
            with self._db.writing() as session:
                row = self._first_due(session, serial, now)
                endpoint = session.get(Webhook, serial)
                if row is None or endpoint is None or not endpoint.active:
                    continue
                row.lease = now + lease
                previous = endpoint.previous_secret
                valid = bool(previous) and endpoint.previous_until > now
                return ClaimedDelivery(
                    row.serial,
                    serial,
                    row.id,
                    endpoint.url,
                    row.payload,
                    (endpoint.secret, *((previous,) if valid else ())),
                    row.event_type,
                    row.tries + 1,
                    row.traceparent,
                )
        return None

    def _ready_endpoints(
        self, session: Session, in_flight: Mapping[int, int], now: float
    ) -> list[int]:
        """Return the serial numbers of the endpoints that may get a further delivery."""
        query = sa.select(Webhook.serial, Webhook.failures).where(
            Webhook.active, Webhook.resume_at <= now
        )
        return [
            serial
            for serial, failures in session.execute(query.order_by(Webhook.serial))
            # An endpoint that does not answer does not occupy many senders.
            if in_flight.get(serial, 0) < max(PER_ENDPOINT - failures, 1)
        ]

    def _first_due(self, session: Session, webhook: int, now: float) -> WebhookDelivery | None:
        """Return the first delivery to an endpoint that may be sent now, locked in PostgreSQL."""
        earlier = aliased(WebhookDelivery)
        query = (
            sa.select(WebhookDelivery)
            .where(
                WebhookDelivery.webhook == webhook,
                WebhookDelivery.state == _PENDING,
                WebhookDelivery.due <= now,
                # A lease further in the future was written before the clock was set back.
                sa.or_(WebhookDelivery.lease <= now, WebhookDelivery.lease > now + 2.0 * LEASE),
                sa.or_(
                    # A test that failed does not hold back the next one.
                    WebhookDelivery.event_type == TEST,
                    ~sa.exists().where(
                        earlier.webhook == webhook,
                        earlier.state == _PENDING,
                        earlier.subject == WebhookDelivery.subject,
                        earlier.serial < WebhookDelivery.serial,
                        earlier.tries < IN_ORDER,
                    ),
                ),
            )
            .order_by(WebhookDelivery.due, WebhookDelivery.serial)
            .limit(1)
            .with_for_update(skip_locked=True)
        )
        return session.scalar(query)

    def store(self, claimed: ClaimedDelivery, attempt: DeliveryAttempt) -> None:
        """Store the result of an attempt, and when the next one is due.

        An endpoint that answers ``GONE`` is switched off, and its pending deliveries are not sent.
        """
        with self._db.writing() as session:
            # The endpoint before its deliveries, as everywhere: otherwise two transactions could
            # wait for each other.
            endpoint = session.get(Webhook, claimed.webhook, with_for_update=True)
            row = session.get(WebhookDelivery, claimed.serial, with_for_update=True)
            if row is None or endpoint is None:
                return  # the endpoint was deleted
            row.attempts = [*row.attempts, attempt.as_json()][-_KEPT:]
            row.lease = 0.0
            row.tries += 1
            if attempt.succeeded:
                row.state = "delivered"
                self._endpoint_works(session, endpoint)
                return
            delay = _delay(row.tries)
            if delay is None:
                row.state = "dead"
            else:
                row.due = self._db.clock() + delay
            endpoint.failures += 1
            endpoint.resume_at = self._db.clock() + _pause(endpoint.failures)
            if attempt.status == GONE:
                endpoint.active = False
                bury_pending(session, endpoint.serial)

    def _endpoint_works(self, session: Session, endpoint: Webhook) -> None:
        """Make all pending deliveries to an endpoint due, after it has paused."""
        if endpoint.failures >= PAUSE_AFTER:
            session.execute(
                sa.update(WebhookDelivery)
                .where(
                    WebhookDelivery.webhook == endpoint.serial,
                    WebhookDelivery.state == _PENDING,
                    WebhookDelivery.due > self._db.clock(),
                )
                .values(due=self._db.clock())
                .execution_options(synchronize_session=False)
            )
        endpoint.failures, endpoint.resume_at = 0, 0.0

    def delete_old(self) -> int:
        """Delete deliveries that are older than 30 days and not pending; return their number."""
        end = self._db.clock() - _KEEP
        last = deleted = 0
        while True:
            with self._db.writing() as session:
                page = session.execute(
                    sa.select(
                        WebhookDelivery.serial, WebhookDelivery.created, WebhookDelivery.state
                    )
                    .where(WebhookDelivery.serial > last)
                    .order_by(WebhookDelivery.serial)
                    .limit(_BATCH)
                ).all()
                old = [row for row in page if row.created < end]
                gone = [row.serial for row in old if row.state != "pending"]
                if gone:
                    chosen = WebhookDelivery.serial.in_(gone)
                    deleted += rows(session, sa.delete(WebhookDelivery).where(chosen))
            # Pending ones may be older, if their endpoint does not answer.
            if len(old) < _BATCH:
                return deleted
            last = page[-1].serial


def bury_pending(session: Session, webhook: int) -> None:
    """Make the pending deliveries to an endpoint dead letters, which can be sent again."""
    session.execute(
        sa.update(WebhookDelivery)
        .where(WebhookDelivery.webhook == webhook, WebhookDelivery.state == _PENDING)
        .values(state="dead", lease=0.0)
        .execution_options(synchronize_session=False)
    )


def _delay(failures: int) -> float | None:
    """Return the time to the next attempt after a number of failures (s); None for no attempt."""
    if failures > len(DELAYS):
        return None
    return DELAYS[failures - 1] * random.uniform(*JITTER)


def _pause(failures: int) -> float:
    """Return the pause of an endpoint after a number of failures in a row (s)."""
    if failures < PAUSE_AFTER:
        return 0.0
    delay = _delay(failures - PAUSE_AFTER + 1)
    return min(delay or _LONGEST_PAUSE, _LONGEST_PAUSE)
