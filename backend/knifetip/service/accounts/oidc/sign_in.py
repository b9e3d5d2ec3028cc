"""The two requests of a sign-in by OpenID Connect: to the provider, and back from it."""

from __future__ import annotations

import hmac
import time
from collections.abc import Awaitable, Callable
from typing import Final

from fastapi import Response
from fastapi.responses import RedirectResponse
from starlette.requests import Request

from knifetip.errors import SignInRefused, WrongState
from knifetip.service.accounts import sign_in as signin
from knifetip.service.accounts.oidc.attempt import LIFETIME, attempt_of, new_attempt
from knifetip.service.accounts.oidc.provider import Provider
from knifetip.service.accounts.oidc.settings import CALLBACK, OidcSettings
from knifetip.service.accounts.provider_users import ProviderUser

#: Begins a session of a user from an address, and returns its token.
OpenSession = Callable[[ProviderUser, str], Awaitable[str]]

#: Texts of errors that RFC 6749 and OpenID Connect define; others are not shown.
_DECLINED: Final = frozenset(
    {"access_denied", "login_required", "consent_required", "interaction_required"}
)


class OidcSignIn:
    """Sends browsers to the provider, and finds the users of those that come back."""

    def __init__(self, settings: OidcSettings, open_session: OpenSession) -> None:
        """Sign users of a provider in."""
        self.title = settings.title
        self._settings = settings
        self._provider = Provider(settings)
        self._open_session = open_session

    async def answer(self, request: Request, ways: signin.SignInMethods) -> Response | None:
        """Return the response to a request of a sign-in; None if it is another request."""
        path = request.url.path
        if request.method != "GET" or path not in (signin.OIDC_PATH, CALLBACK):
            return None
        try:
            if path == signin.OIDC_PATH:
                return await self._begin(request)
            token = await self._finish(request)
        except (SignInRefused, WrongState) as reason:
            answer = signin.sign_in_page(ways, f"{reason.text} {reason.hint}")
        else:
            answer = signin.welcome(request, signin.user_cookie(request, token))
        if path == CALLBACK:
            # An attempt cannot be used twice.
            answer.delete_cookie(
                _cookie_name(request), path=CALLBACK, httponly=True, samesite="lax"
            )
        return answer

    async def _begin(self, request: Request) -> Response:
        """Return the response that sends a browser to the provider, with the cookie of an attempt.

        Raises ``SignInRefused``: the provider does not answer.
        """
        attempt = new_attempt(time.time())
        url = await self._provider.sign_in_url(attempt, self._redirect(request))
        answer = RedirectResponse(url, 302, headers={"Cache-Control": "no-store"})
        answer.set_cookie(
            _cookie_name(request),
            attempt.cookie,
            max_age=LIFETIME,
            path=CALLBACK,
            secure=self._redirect(request).startswith("https:"),
            httponly=True,
            # Not strict: the browser comes back from the site of the provider.
            samesite="lax",
        )
        return answer

    async def _finish(self, request: Request) -> str:
        """Return the token of a session for a browser that comes back from the provider.

        Raises ``SignInRefused``: the browser has not begun the attempt, the provider has refused
        the user or the code, its token is wrong, or the user may not use this server.
        """
        sent = request.query_params
        attempt = attempt_of(request.cookies.get(_cookie_name(request), ""), time.time())
        state = sent.get("state", "").encode("utf-8", "replace")
        if attempt is None or not hmac.compare_digest(state, attempt.state.encode()):
            raise SignInRefused("oidc.not-begun")
        # A provider that another one was mixed up with (RFC 9207).
        if sent.get("iss", self._settings.issuer) != self._settings.issuer:
            raise SignInRefused("oidc.bad-token", reason="iss")
        if "error" in sent or not sent.get("code"):
            fault = sent.get("error", "")
            raise SignInRefused("oidc.declined", reason=fault if fault in _DECLINED else "error")
        redirect = self._redirect(request)
        identity = await self._provider.identity(attempt, sent["code"], redirect)
        address = "" if request.client is None else request.client.host
        user = ProviderUser(
            self._settings.issuer, identity.subject, identity.name, identity.role, attempt.digest
        )
        return await self._open_session(user, address)

    def _redirect(self, request: Request) -> str:
        own = f"{request.url.scheme}://{request.headers.get('host', '')}"
        return (self._settings.public_url or own) + CALLBACK


def _cookie_name(request: Request) -> str:
    return signin.session_cookie(request).replace("session", "oidc")
