"""ASGI middleware that applies the rules of access to requests and signs users in (ADR 21, 83)."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Mapping
from functools import partial
from typing import Protocol
from urllib.parse import quote

import sqlalchemy.exc
from fastapi import Response
from starlette.requests import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from knifetip.errors import SignInRefused, SignInSlowDown
from knifetip.messages import Message
from knifetip.service.accounts import sign_in as signin
from knifetip.service.accounts.access_rules import (
    NO_ACCOUNTS,
    AccessRules,
    Proof,
    Refusal,
    RequestFacts,
    find_access,
    is_api,
    is_probe,
    same_key,
)
from knifetip.service.accounts.account_access import Pairing
from knifetip.service.http.principal import Principal
from knifetip.service.http.problems import problem
from knifetip.service.limits.clients import Clients, refuse_excess

_log = logging.getLogger("knifetip.api")

#: Delay of the answer to a wrong key (s).  Requests with the right key are never delayed or
#: blocked, so an attacker who guesses keys cannot stop the heartbeats of a gateway.
WRONG_KEY_DELAY = 1.0

#: Headers that proxies add to requests; few add all of them.
_PROXY_HEADERS = (
    *("forwarded", "via", "x-real-ip"),
    *("x-forwarded-for", "x-forwarded-host", "x-forwarded-proto"),
)


def request_facts(scope: Scope, cookie: str) -> RequestFacts:
    """Return method, path, headers and addresses of an ASGI request."""
    request = Request(scope)
    headers = request.headers
    hosts = headers.getlist("host")
    server = scope.get("server") or ("", 0)
    # Behind a proxy, the peer address is that of the proxy and does not identify the sender.
    forwarded = any(name in headers for name in _PROXY_HEADERS)
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
        user_session=request.cookies.get(signin.session_cookie(request)) if hosts else None,
    )


class AccountLookup(Protocol):
    """Finds the owners of credentials in the database, and signs users in."""

    async def proof(self, facts: RequestFacts, *, used: bool = True) -> Proof:
        """Return the owner of the credentials of a request, and whether an administrator exists."""

    async def sign_in(self, name: str, password: str, address: str) -> str:
        """Begin a session of a user and return its token; raise ``SignInRefused`` if refused."""

    async def record_key_sign_in(self, address: str) -> None:
        """Record that a browser has signed in with the key of the server."""

    async def pair(self, code: str, title: str, address: str) -> Pairing:
        """Pair a browser with a machine; raise ``SignInRefused`` if refused."""


class NoAccounts:
    """Accounts of a server without a database."""

    async def proof(self, facts: RequestFacts, *, used: bool = True) -> Proof:  # noqa: ARG002  # protocol
        """Return that there are no accounts."""
        return Proof()

    async def sign_in(self, name: str, password: str, address: str) -> str:  # noqa: ARG002  # protocol
        """Raise ``SignInRefused``."""
        raise SignInRefused("sign-in.wrong")

    async def record_key_sign_in(self, address: str) -> None:
        """Do nothing: there is no audit log."""

    async def pair(self, code: str, title: str, address: str) -> Pairing:  # noqa: ARG002  # protocol
        """Raise ``SignInRefused``."""
        raise SignInRefused("sign-in.wrong-code")


class ProviderSignIn(Protocol):
    """Signs users in at a provider, such as one of OpenID Connect."""

    title: str  #: name of the provider on the sign-in page

    async def answer(self, request: Request, ways: signin.SignInMethods) -> Response | None:
        """Return the response to a request of a sign-in; None if it is another request."""


class Access:
    """ASGI middleware that applies the access rules to every request."""

    def __init__(
        self,
        app: ASGIApp,
        rules: AccessRules,
        accounts: AccountLookup | None = None,
        provider: ProviderSignIn | None = None,
        clients: Clients | None = None,
    ) -> None:
        self.app = app
        self._clients = clients
        self.rules = rules
        self._accounts = accounts or NoAccounts()
        self._provider = provider
        self._cookie = signin.cookie_name(rules.key)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward the request to the application, or send a refusal or the sign-in page."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1008})
            return
        facts = request_facts(scope, self._cookie)
        try:
            proof = NO_ACCOUNTS if is_probe(facts) else await self._accounts.proof(facts)
        except sqlalchemy.exc.SQLAlchemyError as error:
            _log.error("%s %s", facts.method, facts.path, exc_info=error)
            await problem(503, Message("server.database-silent"))(scope, receive, send)
            return
        found = find_access(self.rules, facts, time.time(), proof)
        refused = found if isinstance(found, Refusal) else None
        state = scope.setdefault("state", {})
        state["refused"] = refused is not None
        if isinstance(found, Principal):
            state["principal"] = found
            state["permission"] = partial(self._is_permitted, facts, state)
        answer: Response | None = None
        if refused is not None and self._clients is not None and not is_probe(facts):
            # The limiter inside this middleware sees accepted requests only.
            answer = refuse_excess(self._clients, Request(scope))
            if answer is not None:
                await answer(scope, receive, send)
                return
        title = "" if self._provider is None else self._provider.title
        ways = signin.SignInMethods(proof.closed, bool(self.rules.key), title)
        if any(ways) and (refused is None or refused.status == 401):
            answer = await self._sign_in(Request(scope, receive), facts, refused, ways)
        elif refused is not None:
            if refused.wrong_key:
                await asyncio.sleep(WRONG_KEY_DELAY)
            answer = _problem(refused)
        await (answer or self.app)(scope, receive, send)

    async def _is_permitted(self, facts: RequestFacts, state: Mapping[str, object]) -> bool:
        """Return whether a request that was accepted would still be accepted from its principal.

        ``facts``: headers of the request.
        """
        proof = await self._accounts.proof(facts, used=False)
        return find_access(self.rules, facts, time.time(), proof) == state["principal"]

    async def _sign_in(
        self,
        request: Request,
        facts: RequestFacts,
        refused: Refusal | None,
        ways: signin.SignInMethods,
    ) -> Response | None:
        """Return the response to a sign-in or to a refused request, or None to forward the request.

        A sign-in is a request with the key in its URL, or the sign-in form.  If the request is
        refused and comes from a browser that loads the page, the response is the sign-in page.

        ``request``, ``facts``: the request, and its method, path, headers and addresses.
        ``refused``: refusal of the request; None if the request is accepted.
        """
        if refused is not None and refused.wrong_key:
            await asyncio.sleep(WRONG_KEY_DELAY)
            return _problem(refused)
        if facts.path == signin.PAIR_PATH and facts.method in ("GET", "POST"):
            return await self._pair_device(request)
        if self._provider is not None:
            answer = await self._provider.answer(request, ways)
            if answer is not None:
                return answer
        fields = await signin.given_fields(request)
        if fields is not None and "name" in fields:
            return await self._sign_in_user(request, fields, ways)
        if fields is not None and (ways.key or request.method == "POST"):
            if ways.key and same_key(fields.get("key", ""), self.rules.key):
                await self._accounts.record_key_sign_in(_address(request))
                cookie = signin.key_cookie(self.rules.key, time.time())
                return signin.welcome(request, cookie)
            await asyncio.sleep(WRONG_KEY_DELAY)
            return signin.sign_in_page(ways, "This key is wrong.")
        if refused is None:
            return None
        if is_api(facts.path) or facts.method != "GET" or not signin.wants_page(request):
            return _problem(refused)
        # A browser that follows a link from another site does not send a SameSite=Strict cookie.
        # The page reloads itself once, and the browser then sends it.  Over plain HTTP no header
        # shows that this is the case.
        own = facts.fetch_site in ("same-origin", "none")
        return signin.sign_in_page(ways, again="" if own else signin.retry_url(request))

    async def _pair_device(self, request: Request) -> Response:
        """Return the page for pairing a device, or pair the device with the code of a form."""
        if request.method == "GET":
            return signin.pairing_page()
        fields = await signin.pairing_fields(request)
        try:
            found = await self._accounts.pair(
                fields.get("code", ""), fields.get("device", ""), _address(request)
            )
        except (SignInRefused, SignInSlowDown) as reason:
            return signin.pairing_page(f"{reason.text} {reason.hint}")
        place = f"#/station/{quote(found.machine, safe='')}"
        return signin.welcome(request, signin.device_cookie(request, found.token), place)

    async def _sign_in_user(
        self, request: Request, fields: Mapping[str, str], ways: signin.SignInMethods
    ) -> Response:
        try:
            token = await self._accounts.sign_in(
                fields["name"], fields.get("password", ""), _address(request)
            )
        except (SignInRefused, SignInSlowDown) as reason:
            return signin.sign_in_page(ways, f"{reason.text} {reason.hint}")
        return signin.welcome(request, signin.user_cookie(request, token))


def _address(request: Request) -> str:
    return "" if request.client is None else request.client.host


def _problem(refused: Refusal) -> Response:
    headers = {"WWW-Authenticate": "Bearer"} if refused.status == 401 else {}
    return problem(refused.status, refused.message, headers=headers)
