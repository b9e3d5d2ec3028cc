"""Sends the pending deliveries of webhooks, signed as Standard Webhooks prescribes.

Every server sends; the leases of ``WebhookQueue`` ensure that no two of them send one delivery at
the same time.  A server sends some deliveries to each endpoint at the same time, but only one of
those of one job or drawing.
"""

from __future__ import annotations

import asyncio
import logging
import re
import ssl
import time
from collections import Counter
from collections.abc import Awaitable
from contextlib import suppress
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import version
from typing import Final
from urllib.parse import urlsplit

import httpx
from standardwebhooks import Webhook

from knifetip import tracing
from knifetip.errors import RequestError
from knifetip.service.components import Service
from knifetip.service.database.change_event import event_on_change
from knifetip.service.database.change_notifier import WEBHOOK
from knifetip.service.webhooks.egress import resolve
from knifetip.service.webhooks.queue import ClaimedDelivery, DeliveryAttempt
from knifetip.tracing import SpanKind

#: Time limit of one attempt (s), from the resolution of the name to the end of the answer.
TIME_LIMIT: Final = 15.0
#: Bytes of an answer that are read.
ANSWER_LIMIT: Final = 16_384

_AT_ONCE = 16  # deliveries that a server sends at the same time
_POLL = 1.0  # seconds between two queries while deliveries are pending
_IDLE_POLL = 5.0  # seconds between two queries otherwise, for events of other servers
_CLEAN = 3600.0  # seconds between two deletions of old deliveries
_SHOWN = 200  # characters of a fault that are stored
_log = logging.getLogger("knifetip.api")


class WebhookSender:
    """Sends the pending deliveries of webhooks until its task is cancelled."""

    def __init__(self, service: Service) -> None:
        self._queue = service.store.webhook_queue
        self._changes = service.store.changes
        self._private = service.settings.webhook_private
        self._clock = service.store.database.clock
        self._sending: dict[asyncio.Task[None], int] = {}  # the endpoint of each
        self._done = asyncio.Event()
        self._cleaned = -_CLEAN

    async def run(self) -> None:
        """Send deliveries; runs until its asyncio task is cancelled."""
        try:
            with event_on_change(self._changes, WEBHOOK) as changed:
                while True:
                    pause = _IDLE_POLL
                    try:
                        pause = await self._send_due()
                    except Exception:
                        _log.exception("the webhooks could not be read")
                    await self._wait(changed.wait(pause))
        finally:
            for task in self._sending:
                task.cancel()
            await asyncio.gather(*self._sending, return_exceptions=True)

    async def _wait(self, change: Awaitable[object]) -> None:
        """Wait for a change in the store or for the end of an attempt."""
        waiting = asyncio.ensure_future(change)
        done = asyncio.ensure_future(self._done.wait())
        try:
            await asyncio.wait((waiting, done), return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in (waiting, done):
                task.cancel()
        self._done.clear()

    async def _send_due(self) -> float:
        """Begin to send the due deliveries; return the time until the next query (s)."""
        while len(self._sending) < _AT_ONCE:
            in_flight = Counter(self._sending.values())
            claimed = await asyncio.to_thread(self._queue.claim, in_flight)
            if claimed is None:
                break
            task = asyncio.create_task(self._send(claimed))
            self._sending[task] = claimed.webhook
            task.add_done_callback(self._end)
        if time.monotonic() - self._cleaned >= _CLEAN:
            self._cleaned = time.monotonic()
            await asyncio.to_thread(self._queue.delete_old)
        pending = bool(self._sending) or await asyncio.to_thread(self._queue.has_pending)
        return _POLL if pending else self._changes.poll(_IDLE_POLL)

    async def _send(self, claimed: ClaimedDelivery) -> None:
        try:
            with tracing.span(
                "webhook",
                SpanKind.CLIENT,
                claimed.traceparent,
                webhook=claimed.webhook,
                event_type=claimed.event_type,
                attempt=claimed.attempt,
            ) as span:
                attempt = await attempt_delivery(claimed, self._clock(), private=self._private)
                if attempt.status:
                    span.set(status=attempt.status)
                if not attempt.succeeded:
                    span.fail(str(attempt.status or "unanswered"))
                    _log.warning(
                        "webhook %s: status %d %s", claimed.id, attempt.status, attempt.fault
                    )
            await asyncio.to_thread(self._queue.store, claimed, attempt)
        except Exception:
            # The delivery is sent again when its lease has expired.
            _log.exception("the result of the webhook %s was not stored", claimed.id)

    def _end(self, task: asyncio.Task[None]) -> None:
        del self._sending[task]
        self._done.set()


async def attempt_delivery(
    claimed: ClaimedDelivery, now: float, *, private: bool
) -> DeliveryAttempt:
    """Send a delivery once and return the result.

    Redirects are not followed, proxies of the environment are not used, and the answer is read up
    to ``ANSWER_LIMIT``.

    Parameters
    ----------
    claimed
        The delivery.
    now
        Present time (seconds since 1970), which is signed.
    private
        Whether loopback and private addresses are permitted.
    """
    start = time.monotonic()
    status, answer, fault = 0, "", ""
    try:
        async with asyncio.timeout(TIME_LIMIT):
            status, content = await _post(claimed, now, private)
        answer = _visible(content.decode("utf-8", "replace")[:_SHOWN])
        if not 200 <= status < 300:
            fault = answer
    except TimeoutError:
        fault = f"no complete answer within {TIME_LIMIT:.0f} s"
    except (httpx.HTTPError, httpx.InvalidURL, OSError, RequestError, UnicodeError) as reason:
        fault = _cause(reason)
    return DeliveryAttempt(now, status, time.monotonic() - start, _visible(fault[:_SHOWN]), answer)


def _cause(reason: Exception) -> str:
    """Return why an endpoint was not reached, without numbers and words of the programs here."""
    if isinstance(reason, UnicodeError):
        return "the host of the URL is not valid"
    text = getattr(reason, "strerror", None) or str(reason)
    return re.sub(r"^\[Errno -?\d+\] ", "", text) or "the connection failed"


def _visible(text: str) -> str:
    """Return a text of another system without control characters, which affect terminals."""
    return "".join(letter if letter.isprintable() else " " for letter in text).strip()


async def _post(claimed: ClaimedDelivery, now: float, private: bool) -> tuple[int, bytes]:
    """Send a delivery to the first address of its host that accepts a connection."""
    *others, last = await resolve(claimed.url, private=private)
    # An address that does not answer leaves time for the next one.
    limits = httpx.Timeout(TIME_LIMIT, connect=TIME_LIMIT / (len(others) + 1))
    async with httpx.AsyncClient(
        verify=_tls_settings(), trust_env=False, timeout=limits, follow_redirects=False
    ) as client:
        for address in others:
            with suppress(httpx.ConnectError, httpx.ConnectTimeout):
                return await _post_to(address, client, claimed, now)
        return await _post_to(last, client, claimed, now)


async def _post_to(
    address: str, client: httpx.AsyncClient, claimed: ClaimedDelivery, now: float
) -> tuple[int, bytes]:
    parts = urlsplit(claimed.url)
    shown = f"[{address}]" if ":" in address else address
    # The connection goes to the address that was checked; name and certificate are those of the
    # URL.
    target = httpx.URL(claimed.url).copy_with(host=shown)
    headers = {
        "Host": parts.netloc,
        "Content-Type": "application/json",
        # The beginning of the answer is shown, as it arrives.
        "Accept-Encoding": "identity",
        "User-Agent": f"knifetip/{version('knifetip')}",
        **signature_headers(claimed, now),
        **tracing.headers(),
    }
    async with client.stream(
        "POST",
        target,
        content=claimed.payload.encode(),
        headers=headers,
        extensions={"sni_hostname": parts.hostname or ""},
    ) as response:
        answer = b""
        async for chunk in response.aiter_raw():
            answer += chunk
            if len(answer) >= ANSWER_LIMIT:
                break
        return response.status_code, answer[:ANSWER_LIMIT]


@cache
def _tls_settings() -> ssl.SSLContext:
    """Return the settings of TLS; certificates of the authorities of the system are accepted.

    The certificate of an authority of the shop itself is found as by other programs: in the store
    of the system, or in ``SSL_CERT_FILE`` or ``SSL_CERT_DIR``.
    """
    context = httpx.create_ssl_context(trust_env=False)
    context.load_default_certs()
    return context


def signature_headers(claimed: ClaimedDelivery, now: float) -> dict[str, str]:
    """Return the headers with id, time and signatures of a delivery, one for each valid secret."""
    at = datetime.fromtimestamp(int(now), UTC)
    signatures = [
        Webhook(secret).sign(claimed.id, at, claimed.payload) for secret in claimed.secrets
    ]
    return {
        "webhook-id": claimed.id,
        "webhook-timestamp": str(int(now)),
        "webhook-signature": " ".join(signatures),
    }
