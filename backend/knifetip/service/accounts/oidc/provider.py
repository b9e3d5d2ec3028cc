"""Requests to the provider: its metadata, its keys, and the exchange of a code for an identity."""

from __future__ import annotations

import asyncio
import logging
import ssl
import time
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final
from urllib.parse import quote

import httpx
from authlib.oauth2.rfc6749.parameters import prepare_grant_uri
from authlib.oauth2.rfc7636 import create_s256_code_challenge
from authlib.oidc.core import CodeIDToken
from joserfc import jwt
from joserfc.errors import JoseError
from joserfc.jwk import KeySet

from knifetip.errors import SignInRefused
from knifetip.service.accounts.oidc.attempt import SignInAttempt
from knifetip.service.accounts.oidc.settings import OidcSettings
from knifetip.service.http.scopes import ROLES, AccessScope

_log = logging.getLogger("knifetip.service.accounts.oidc")

_KEPT: Final = 3600.0  # seconds for which metadata and keys are used
_PAUSE: Final = 5.0  # seconds after a failure or a request for new keys before the next one
_TIMEOUT: Final = 10.0
_AT_ONCE: Final = 4  # exchanges of codes at the same time
_LEEWAY: Final = 60  # seconds by which the clocks may differ
_LARGEST: Final = 1 << 20  # bytes of an answer
# Public keys only: with HS256 the client secret could sign tokens, with "none" everybody.
_ALGORITHMS: Final = (
    *("RS256", "RS384", "RS512", "PS256", "PS384", "PS512"),
    *("ES256", "ES384", "ES512", "EdDSA", "Ed25519"),
)


@dataclass(frozen=True, slots=True)
class Identity:
    """A user of the provider."""

    subject: str  #: identifier of the user at the provider, which never changes
    name: str  #: name that the user has chosen or an administrator has given; may change
    role: AccessScope | None  #: greatest of the mapped roles; None for none


class Provider:
    """The provider of a server, with its cached metadata and keys."""

    def __init__(self, settings: OidcSettings) -> None:
        self.settings = settings
        self._metadata: Mapping[str, Any] = {}
        self._keys = KeySet([])
        self._read = -_KEPT  # time of the last successful request for metadata and keys
        self._asked = -_PAUSE
        self._lock = asyncio.Lock()
        self._exchanges = asyncio.Semaphore(_AT_ONCE)

    @cached_property
    def _tls(self) -> ssl.SSLContext:
        """Settings of TLS for all requests: loading the certificates takes 0.04 s."""
        return httpx.create_ssl_context()

    async def sign_in_url(self, attempt: SignInAttempt, redirect: str) -> str:
        """Return the URL at which a user signs in.

        Parameters
        ----------
        attempt
            The attempt, whose cookie the browser gets.
        redirect
            URL to which the provider sends the browser back.

        Raises
        ------
        SignInRefused
            The provider does not answer, or its metadata is wrong.
        """
        await self._read_metadata()
        url: str = prepare_grant_uri(
            self._endpoint("authorization_endpoint"),
            self.settings.client_id,
            "code",
            redirect_uri=redirect,
            scope="openid profile email",
            state=attempt.state,
            nonce=attempt.nonce,
            code_challenge=create_s256_code_challenge(attempt.verifier),
            code_challenge_method="S256",
        )
        return url

    async def identity(self, attempt: SignInAttempt, code: str, redirect: str) -> Identity:
        """Exchange a code for an ID token, check the token, and return its user.

        Parameters
        ----------
        attempt
            The attempt for which the provider has made the code.
        code
            The code.
        redirect
            URL to which the provider has sent the browser back.

        Raises
        ------
        SignInRefused
            The provider does not answer or refuses the code, or the token is wrong.
        """
        async with self._exchanges:
            await self._read_metadata()
            answer = await self._exchange(attempt, code, redirect)
            token = answer.get("id_token")
            if not isinstance(token, str):
                raise SignInRefused("oidc.bad-token", reason="id_token")
            claims = await self._claims(token)
        self._check(claims, attempt, answer)
        name = claims.get("preferred_username") or claims.get("email") or claims["sub"]
        return Identity(str(claims["sub"]), str(name), self._role(claims))

    def _endpoint(self, name: str) -> str:
        url = self._metadata.get(name)
        if not isinstance(url, str):
            raise SignInRefused("oidc.unreachable", issuer=self.settings.issuer)
        return url

    async def _read_metadata(self, *, again: bool = False) -> None:
        """Read the metadata and the keys of the provider, if they are old or ``again`` is set."""
        async with self._lock:
            now = time.monotonic()
            if now - self._read < _KEPT and not again:
                return
            if now - self._asked < _PAUSE:
                if self._metadata:
                    return
                raise SignInRefused("oidc.unreachable", issuer=self.settings.issuer)
            self._asked = now
            issuer = self.settings.issuer
            found = await self._request(
                "GET", issuer.rstrip("/") + "/.well-known/openid-configuration"
            )
            if found.get("issuer") != issuer:
                _log.error("the metadata of %s is that of %s", issuer, found.get("issuer"))
                raise SignInRefused("oidc.unreachable", issuer=issuer)
            self._metadata = found
            keys = await self._request("GET", self._endpoint("jwks_uri"))
            try:
                self._keys = KeySet.import_key_set(keys)  # type: ignore[arg-type]  # from JSON
            except (JoseError, KeyError, TypeError, ValueError) as reason:
                _log.error("the keys of %s cannot be read: %s", issuer, reason)
                raise SignInRefused("oidc.unreachable", issuer=issuer) from reason
            self._read = now

    async def _exchange(
        self, attempt: SignInAttempt, code: str, redirect: str
    ) -> Mapping[str, Any]:
        fields = {
            "grant_type": "authorization_code",
            "code": code,
            "redirect_uri": redirect,
            "code_verifier": attempt.verifier,
        }
        id, secret = self.settings.client_id, self.settings.client_secret
        auth = None
        methods = self._metadata.get("token_endpoint_auth_methods_supported")
        if secret and (not methods or "client_secret_basic" in methods):
            # Encoded before they are joined: RFC 6749, section 2.3.1.
            auth = httpx.BasicAuth(quote(id, safe=""), quote(secret, safe=""))
        else:
            fields["client_id"] = id
            if secret:
                fields["client_secret"] = secret
        return await self._request("POST", self._endpoint("token_endpoint"), fields, auth)

    async def _request(
        self,
        method: str,
        url: str,
        fields: Mapping[str, str] | None = None,
        auth: httpx.BasicAuth | None = None,
    ) -> Mapping[str, Any]:
        """Send a request to the provider and return the JSON object in its answer."""
        issuer = self.settings.issuer
        try:
            async with httpx.AsyncClient(timeout=_TIMEOUT, verify=self._tls) as client:
                answer = await client.request(
                    method, url, data=fields, auth=auth, headers={"Accept": "application/json"}
                )
            found = answer.json() if len(answer.content) <= _LARGEST else None
        except (httpx.HTTPError, httpx.InvalidURL, ValueError) as reason:
            _log.error("%s %s: %s", method, url, reason or type(reason).__name__)
            raise SignInRefused("oidc.unreachable", issuer=issuer) from reason
        if isinstance(found, dict) and answer.is_success:
            return found
        fault = found.get("error") if isinstance(found, dict) else None
        _log.error("%s %s: status %d, %s", method, url, answer.status_code, fault)
        if method == "POST" and answer.is_client_error:
            raise SignInRefused("oidc.code-refused", reason=str(fault or answer.status_code)[:100])
        raise SignInRefused("oidc.unreachable", issuer=issuer)

    async def _claims(self, token: str) -> CodeIDToken:
        """Check the signature of a token and return its claims."""
        try:
            try:
                found = jwt.decode(token, self._keys, algorithms=_ALGORITHMS)
            except (JoseError, ValueError):
                # The provider may have a new key.
                await self._read_metadata(again=True)
                found = jwt.decode(token, self._keys, algorithms=_ALGORITHMS)
        except (JoseError, ValueError) as reason:
            raise _wrong_token(reason) from reason
        return CodeIDToken(found.claims, found.header)

    def _check(
        self, claims: CodeIDToken, attempt: SignInAttempt, answer: Mapping[str, Any]
    ) -> None:
        """Check issuer, audience, times, nonce and hash of the access token."""
        claims.options = {
            "iss": {"essential": True, "value": self.settings.issuer},
            "sub": {"essential": True},
            "aud": {"essential": True, "value": self.settings.client_id},
            "exp": {"essential": True},
            "iat": {"essential": True},
        }
        claims.params = {
            "client_id": self.settings.client_id,
            "nonce": attempt.nonce,
            "access_token": answer.get("access_token"),
        }
        try:
            claims.validate(leeway=_LEEWAY)
        except (JoseError, ValueError, TypeError) as reason:
            raise _wrong_token(reason) from reason

    def _role(self, claims: Mapping[str, Any]) -> AccessScope | None:
        """Return the greatest of the roles that the claims of a user name."""
        value: Any = claims
        for part in self.settings.roles_claim.split("."):
            value = value.get(part) if isinstance(value, Mapping) else None
        values = [value] if isinstance(value, str) else value if isinstance(value, list) else []
        given = {self.settings.roles.get(one) for one in values if isinstance(one, str)}
        return next((role for role in reversed(ROLES) if role in given), None)


def _wrong_token(reason: Exception) -> SignInRefused:
    _log.error("an ID token was refused: %s", reason)
    return SignInRefused("oidc.bad-token", reason=str(reason)[:100])
