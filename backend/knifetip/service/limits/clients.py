"""Limits of each client: requests in a time, and listeners to events (ADR 84).

A client is a user or an API key; requests without either count for their address.  Requests of
gateways and health checks have no limit, so that no client can stop a machine by its load.
"""

from __future__ import annotations

import ipaddress
import math
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from fastapi import Response
from starlette.datastructures import MutableHeaders
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip import messages
from knifetip.service.http.principal import PrincipalKind, principal_of
from knifetip.service.http.problems import problem
from knifetip.service.http.scopes import AccessScope

_UNLIMITED: Final = ("/healthz", "/readyz")
_GATEWAY: Final = "/api/gateway/"
_EVENTS: Final = "/api/events"
_REMEMBERED: Final = 10_000  # clients whose requests are counted
_RETRY: Final = 5  # seconds after which a further listener may try again
# All clients without an account have the same kind; their addresses distinguish them.
_SHARED: Final = (PrincipalKind.NONE, PrincipalKind.LOCAL)


@dataclass(frozen=True, slots=True)
class ClientLimits:
    """Limits of each client."""

    rate: int = 200  #: requests in a second on average; 0 for no limit
    burst: int = 2000  #: requests that may come at once after a pause
    listeners: int = 64  #: streams of events of one client
    all_listeners: int = 512  #: streams of events of all clients


class TokenBuckets:
    """One token bucket for each client: a request takes a token, and tokens return with time.

    Parameters
    ----------
    rate
        Tokens that return in a second.
    size
        Tokens of a full bucket.
    clock
        Seconds of a clock that does not jump.
    """

    def __init__(self, rate: float, size: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._rate = rate
        self._size = size
        self._clock = clock
        #: tokens and the time at which they were counted; the client of the last request is last
        self._buckets: dict[str, tuple[float, float]] = {}

    def take(self, client: str) -> float:
        """Take a token of a client and return how many remain; less than 0 if there was none."""
        now = self._clock()
        # The client is put at the end again.
        tokens, counted = self._buckets.pop(client, (float(self._size), now))
        tokens = min(self._size, tokens + (now - counted) * self._rate)
        remaining = tokens - 1.0
        self._buckets[client] = tokens if remaining < 0 else remaining, now
        if len(self._buckets) > _REMEMBERED:
            # The least recent client has the fullest bucket, so it loses no or few tokens.
            del self._buckets[next(iter(self._buckets))]
        return remaining


class Clients:
    """Counters of each client: its remaining tokens, and its open event streams."""

    def __init__(self, limits: ClientLimits) -> None:
        self.limits = limits
        self.buckets = TokenBuckets(limits.rate, limits.burst)
        self.listeners: Counter[str] = Counter()


def refuse_excess(clients: Clients, request: Request) -> Response | None:
    """Count a request that access control refuses; return 429 beyond the rate, None within it.

    Refused requests are counted separately, so that a page of another site cannot use up the rate
    of the programs on the computer of its visitor.
    """
    limits = clients.limits
    name = f"refused {client_name(request)}"
    remaining = clients.buckets.take(name) if limits.rate else 0.0
    return _too_many_requests(limits, remaining) if remaining < 0 else None


class ClientLimiter:
    """ASGI middleware that refuses requests of a client beyond its limits with 429.

    It must be inside the access control, which finds the principal of a request.
    """

    def __init__(self, app: ASGIApp, clients: Clients) -> None:
        self.app = app
        self._clients = clients

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request, or refuse it if its client has sent too many."""
        path = scope.get("path", "")
        if scope["type"] != "http" or path in _UNLIMITED or _is_of_gateway(scope):
            await self.app(scope, receive, send)
            return
        client = client_name(Request(scope))
        limits = self._clients.limits
        if limits.rate:
            remaining = self._clients.buckets.take(client)
            if remaining < 0:
                await _too_many_requests(limits, remaining)(scope, receive, send)
                return
            send = _with_headers(limits, int(remaining), send)
        if path == _EVENTS and scope["method"] == "GET":
            await self._listen(client, scope, receive, send)
        else:
            await self.app(scope, receive, send)

    async def _listen(self, client: str, scope: Scope, receive: Receive, send: Send) -> None:
        limits, listeners = self._clients.limits, self._clients.listeners
        if listeners[client] >= limits.listeners:
            await _too_many_listeners(429, limits.listeners)(scope, receive, send)
            return
        if listeners.total() >= limits.all_listeners:
            await _too_many_listeners(503, limits.all_listeners)(scope, receive, send)
            return
        listeners[client] += 1
        try:
            await self.app(scope, receive, send)
        finally:
            listeners[client] -= 1
            if not listeners[client]:
                del listeners[client]


def _is_of_gateway(scope: Scope) -> bool:
    """Return whether a gateway sends a request; others would be refused and fill the audit log."""
    scopes = principal_of(Request(scope)).scopes
    return scope["path"].startswith(_GATEWAY) and AccessScope.GATEWAY in scopes


def client_name(request: Request) -> str:
    """Return a text that is equal for all requests of one client."""
    principal = principal_of(request)
    if principal.kind not in _SHARED:
        return f"{principal.kind} {principal.id or principal.name}"
    return "" if request.client is None else network_of(request.client.host)


def network_of(host: str) -> str:
    """Return a text that is equal for all addresses that one computer can use.

    It is the address itself for IPv4, and the network /64 for IPv6, in which a computer has 2^64
    addresses.
    """
    try:
        address = ipaddress.ip_address(host)
    except ValueError:
        return host
    if isinstance(address, ipaddress.IPv4Address):
        return host
    if address.ipv4_mapped is not None:  # on a socket that accepts IPv6 and IPv4
        return str(address.ipv4_mapped)
    return str(ipaddress.ip_network((int(address), 64), strict=False))


def _too_many_requests(limits: ClientLimits, remaining: float) -> Response:
    seconds = math.ceil(-remaining / limits.rate)
    return problem(
        429,
        messages.Message("limit.too-many-requests", rate=limits.rate, seconds=seconds),
        headers={"Retry-After": str(seconds), **_rate_headers(limits, 0)},
    )


def _too_many_listeners(status: int, limit: int) -> Response:
    message = messages.Message("limit.too-many-listeners", limit=limit)
    return problem(status, message, headers={"Retry-After": str(_RETRY)})


def _rate_headers(limits: ClientLimits, remaining: int) -> dict[str, str]:
    """Return the header fields of the IETF draft "RateLimit header fields for HTTP"."""
    window = math.ceil(limits.burst / limits.rate)
    return {
        "RateLimit-Policy": f'"client";q={limits.burst};w={window}',
        "RateLimit": f'"client";r={remaining};t={1 if remaining == 0 else 0}',
    }


def _with_headers(limits: ClientLimits, remaining: int, send: Send) -> Send:
    async def send_with_headers(event: Message) -> None:
        if event["type"] == "http.response.start":
            headers = MutableHeaders(scope=event)
            for name, value in _rate_headers(limits, remaining).items():
                headers[name] = value
        await send(event)

    return send_with_headers
