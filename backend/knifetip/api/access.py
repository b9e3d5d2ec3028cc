"""access: which requests are answered, by Host, Origin, peer address and key (ADR 0021).

    RequestFacts + AccessRules -> None, or a Refusal

The checks are pure functions of what one request shows.  ``Access`` is the ASGI middleware that
collects these facts and sends the refusals.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import re
import time
from dataclasses import dataclass
from typing import TypeAlias

from fastapi import Response
from starlette.requests import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from knifetip.api import signin
from knifetip.api.problems import problem
from knifetip.messages import Message

Authority: TypeAlias = tuple[str, int | None]

#: Seconds before a wrong key is answered.  Requests with the right key are never delayed or
#: blocked: a stranger who guesses keys must not be able to stop a gateway's heartbeats.
WRONG_KEY_DELAY = 1.0
#: Paths that need no key: probes of containers and load balancers ask for them.
OPEN_PATHS = ("/healthz", "/readyz")

_SAFE = ("GET", "HEAD", "OPTIONS")
# What an HTML form can send to another site without asking, besides multipart (uploads need that).
_FORMS = ("application/x-www-form-urlencoded", "text/plain")
_PORTS = {"http": 80, "https": 443}
_AUTHORITY = re.compile(r"(\[[0-9a-f:.]+\]|[a-z0-9._-]+)(?::([0-9]{1,5}))?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class AccessRules:
    """Who may use a server."""

    key: str = ""  #: empty: only this machine may use the server
    hosts: tuple[str, ...] = ()  #: NAME or NAME:PORT that a request's Host may have besides
    loopback_only: bool = False  #: the server is bound to loopback addresses only


@dataclass(frozen=True, slots=True)
class RequestFacts:
    """What a request shows of its sender."""

    method: str
    path: str
    scheme: str
    host: str | None  #: None where there is no Host header, or more than one
    peer: str | None  #: address; None where it is not known
    server: tuple[str, int]  #: address and port of this end of the connection
    origins: tuple[str, ...] = ()
    fetch_site: str | None = None
    agent: str | None = None
    content_type: str = ""
    marked: bool = False  #: has an X-Knifetip header
    authorization: str | None = None
    session: str | None = None  #: value of the session cookie


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a request is not answered."""

    status: int
    message: Message

    @property
    def wrong_key(self) -> bool:
        """Whether the request has a key that is wrong."""
        return self.message.code == "request.wrong-key"


def refusal(rules: AccessRules, facts: RequestFacts, now: float) -> Refusal | None:
    """Return why a request is refused, or None if it may pass.

    Parameters
    ----------
    now
        Seconds since the epoch, against which sessions expire.
    """
    bearer = _bearer(facts.authorization) if rules.key else None
    keyed = bearer is not None and same_key(bearer, rules.key)
    if bearer is not None and not keyed:
        return Refusal(401, Message("request.wrong-key"))
    host = authority(facts.host or "")
    # A key in a header proves intent: no browser sends it because a page tells it to.
    if host is None or not (keyed or _is_listed(rules, facts, host)):
        return _wrong_host(facts)
    return (
        _foreign_page(facts, host)
        or _html_form(facts)
        or (None if keyed else _without_key(rules, facts, host, now))
    )


def _wrong_host(facts: RequestFacts) -> Refusal:
    if facts.host is None:
        return Refusal(400, Message("request.no-host"))
    return Refusal(421, Message("request.wrong-host", host=facts.host[:100]))


def _foreign_page(facts: RequestFacts, host: Authority) -> Refusal | None:
    """Refuse a change that a page of another origin may have sent."""
    if facts.method in _SAFE:
        return None
    same = False
    for origin in facts.origins:
        scheme, separator, rest = origin.partition("://")
        named = authority(rest) if separator else None
        same = (
            named is not None
            and scheme.lower() == facts.scheme
            and _with_port(named, scheme.lower()) == _with_port(host, facts.scheme)
        )
        if not same:
            return Refusal(403, Message("request.foreign-page", origin=origin[:100]))
    if facts.fetch_site not in (None, "same-origin", "none"):
        return Refusal(403, Message("request.foreign-origin"))
    if same or facts.marked or facts.authorization is not None:
        return None
    # Every browser's User-Agent begins like this, and no page can change it without asking first.
    if not facts.agent or facts.agent.lower().startswith("mozilla/"):
        return Refusal(403, Message("request.not-marked"))
    return None


def _html_form(facts: RequestFacts) -> Refusal | None:
    """Refuse forms on API routes: a browser sends them anywhere without asking."""
    kind = facts.content_type.partition(";")[0].strip().lower()
    if facts.method in _SAFE or not _is_api(facts.path) or kind not in _FORMS:
        return None
    return Refusal(415, Message("request.html-form", media=kind))


def _without_key(
    rules: AccessRules, facts: RequestFacts, host: Authority, now: float
) -> Refusal | None:
    """Refuse requests from other machines that have no key and no session."""
    if facts.path in OPEN_PATHS and facts.method in _SAFE:
        return None
    near = is_loopback(facts.peer or "")
    if near and (rules.loopback_only or is_loopback(host[0])):
        return None
    if not rules.key:
        return Refusal(403, Message("request.local-only"))
    if signin.is_session(facts.session or "", rules.key, now):
        return None
    return Refusal(401, Message("request.key-needed"))


def _is_listed(rules: AccessRules, facts: RequestFacts, host: Authority) -> bool:
    """Return whether a Host is a loopback name, this connection's own address, or allowed.

    A rebound name passes none of these.  The connection's own address cannot be forged by a name
    server, so that a server which listens everywhere needs no list of its addresses.
    """
    name, _ = host
    address, port = facts.server
    own = is_loopback(name) or (_ip(name) is not None and _ip(name) == _ip(address))
    if own and _with_port(host, facts.scheme)[1] == port:
        return True
    for allowed in map(authority, rules.hosts):
        if allowed is not None and allowed[0] == name:
            wanted = allowed[1]
            if wanted is None or wanted == _with_port(host, facts.scheme)[1]:
                return True
    return False


def authority(text: str) -> Authority | None:
    """Return name (lower case, IPv6 without brackets) and port of ``NAME[:PORT]``, or None."""
    found = _AUTHORITY.fullmatch(text)
    if found is None:
        return None
    name, port = found[1].lower(), found[2]
    if name.startswith("["):
        name = name[1:-1]
        if _ip(name) is None:
            return None
    return name, None if port is None else int(port)


def _with_port(host: Authority, scheme: str) -> tuple[str, int]:
    name, port = host
    return name, _PORTS.get(scheme, 80) if port is None else port


def _ip(text: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        address = ipaddress.ip_address(text)
    except ValueError:
        return None
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return mapped or address


def is_loopback(name: str) -> bool:
    """Return whether a host name or an address is this machine's own."""
    address = _ip(name)
    return name == "localhost" if address is None else address.is_loopback


def _is_api(path: str) -> bool:
    return path == "/api" or path.startswith("/api/")


def same_key(given: str, key: str) -> bool:
    """Return whether two keys are equal, in a time that does not depend on where they differ."""
    digests = (hashlib.sha256(text.encode("utf-8", "replace")).digest() for text in (given, key))
    return hmac.compare_digest(*digests)


def _bearer(header: str | None) -> str | None:
    scheme, _, key = (header or "").partition(" ")
    return key.strip() if scheme.lower() == "bearer" else None


def facts_of(scope: Scope, cookie: str) -> RequestFacts:
    """Return what an ASGI request shows; ``cookie`` is the name of the session's cookie."""
    request = Request(scope)
    headers = request.headers
    hosts = headers.getlist("host")
    server = scope.get("server") or ("", 0)
    # A proxy in between hides whose request it is: its own address then proves nothing.
    forwarded = "forwarded" in headers or "x-forwarded-for" in headers
    return RequestFacts(
        method=scope["method"],
        path=scope["path"],
        scheme=scope["scheme"],
        host=hosts[0] if len(hosts) == 1 else None,
        peer=None if forwarded or request.client is None else request.client.host,
        server=(str(server[0]), int(server[1] or 0)),
        origins=tuple(headers.getlist("origin")),
        fetch_site=headers.get("sec-fetch-site"),
        agent=headers.get("user-agent"),
        content_type=headers.get("content-type", ""),
        marked="x-knifetip" in headers,
        authorization=headers.get("authorization"),
        session=request.cookies.get(cookie),
    )


class Access:
    """ASGI middleware around the whole application."""

    def __init__(self, app: ASGIApp, rules: AccessRules) -> None:
        self.app = app
        self.rules = rules
        self._cookie = signin.cookie_name(rules.key)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or answer with why not, or let its sender sign in."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1008})
            return
        facts = facts_of(scope, self._cookie)
        refused = refusal(self.rules, facts, time.time())
        answer: Response | None = None
        if self.rules.key and (refused is None or refused.status == 401):
            answer = await self._signed_in(Request(scope, receive), facts, refused)
        elif refused is not None:
            answer = _problem(refused)
        await (answer or self.app)(scope, receive, send)

    async def _signed_in(
        self, request: Request, facts: RequestFacts, refused: Refusal | None
    ) -> Response | None:
        """Return the answer to a key that was given, or to a request that needs one."""
        if refused is not None and refused.wrong_key:
            await asyncio.sleep(WRONG_KEY_DELAY)
            return _problem(refused)
        given = await signin.given_key(request)
        if given is not None:
            if same_key(given, self.rules.key):
                return signin.welcome(request, self.rules.key, time.time())
            await asyncio.sleep(WRONG_KEY_DELAY)
            return signin.page("This key is wrong.")
        if refused is None:
            return None
        if _is_api(facts.path) or facts.method != "GET" or not signin.wants_page(request):
            return _problem(refused)
        # After a link on another site a browser holds back a SameSite=Strict cookie, and sends it
        # with the next request, which this page makes.  Over plain HTTP no header tells of that.
        own = facts.fetch_site in ("same-origin", "none")
        return signin.page(again="" if own else signin.next_try(request))


def _problem(refused: Refusal) -> Response:
    headers = {"WWW-Authenticate": "Bearer"} if refused.status == 401 else {}
    return problem(refused.status, refused.message, headers=headers)
