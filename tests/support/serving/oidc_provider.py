"""A small provider of OpenID Connect that signs one user in without asking, and can be at fault."""

from __future__ import annotations

import base64
import json
import secrets
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Final
from urllib.parse import parse_qs, unquote, urlencode, urlsplit

from authlib.oauth2.rfc7636 import create_s256_code_challenge
from joserfc import jwt
from joserfc.jwk import ECKey, KeySet, RSAKey

CLIENT: Final = "knifetip"
SECRET: Final = "a secret: with % and ü"


class OidcProvider:
    """The provider; tests change its user, its claims, its keys and what it demands."""

    def __init__(self) -> None:
        self.issuer = ""
        self.user: dict[str, Any] = {
            "sub": "248289761001",
            "preferred_username": "Anna Example",
            "roles": ["cutting", "shop"],
        }
        self.key: RSAKey | ECKey = RSAKey.generate_key(2048, {"kid": "first", "use": "sig"})
        self.published: list[RSAKey | ECKey] = [self.key]
        self.algorithm = "RS256"
        self.changes: dict[str, Any] = {}  #: claims of the ID token that are wrong; None: missing
        self.once = True  #: a code can be used once only
        self.down = False
        self.codes: dict[str, dict[str, str]] = {}
        self.requests: list[str] = []

    def metadata(self) -> dict[str, Any]:
        return {
            "issuer": self.issuer,
            "authorization_endpoint": f"{self.issuer}/authorize",
            "token_endpoint": f"{self.issuer}/token",
            "jwks_uri": f"{self.issuer}/jwks",
            "response_types_supported": ["code"],
            "subject_types_supported": ["public"],
            "id_token_signing_alg_values_supported": ["RS256"],
        }

    def authorize(self, sent: dict[str, str]) -> str:
        """Return the URL to which the browser is sent back, with a code."""
        assert sent["response_type"] == "code"
        assert sent["client_id"] == CLIENT
        assert "openid" in sent["scope"].split()
        assert sent["code_challenge_method"] == "S256"
        code = secrets.token_urlsafe(16)
        self.codes[code] = sent
        return f"{sent['redirect_uri']}?{urlencode({'code': code, 'state': sent['state']})}"

    def token(self, sent: dict[str, str], authorization: str) -> dict[str, Any]:
        """Return the answer of the token endpoint."""
        expected = f"{CLIENT}:{SECRET}"
        given = base64.b64decode(authorization.removeprefix("Basic ")).decode()
        if ":".join(map(unquote, given.split(":"))) != expected:
            return {"error": "invalid_client"}
        asked = self.codes.get(sent["code"])
        if self.once:
            self.codes.pop(sent["code"], None)
        if (
            asked is None
            or sent["grant_type"] != "authorization_code"
            or sent["redirect_uri"] != asked["redirect_uri"]
            or create_s256_code_challenge(sent["code_verifier"]) != asked["code_challenge"]
        ):
            return {"error": "invalid_grant"}
        now = int(time.time())
        claims: dict[str, Any] = {
            **self.user,
            "iss": self.issuer,
            "aud": CLIENT,
            "iat": now,
            "exp": now + 300,
            "nonce": asked["nonce"],
            **self.changes,
        }
        claims = {name: value for name, value in claims.items() if value is not None}
        header = {"alg": self.algorithm, "kid": self.key.kid}
        token = jwt.encode(header, claims, self.key, algorithms=[self.algorithm])
        return {"access_token": "none", "token_type": "Bearer", "id_token": token}


@contextmanager
def run_provider() -> Iterator[OidcProvider]:
    """Run a provider on a port of this computer."""
    provider = OidcProvider()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            url = urlsplit(self.path)
            provider.requests.append(url.path)
            if provider.down:
                self._answer(500, {})
            elif url.path == "/.well-known/openid-configuration":
                self._answer(200, provider.metadata())
            elif url.path == "/jwks":
                keys = KeySet(list(provider.published))
                self._answer(200, dict(keys.as_dict(private=False)))
            else:
                self.send_response(302)
                self.send_header("Location", provider.authorize(_fields(url.query)))
                self.end_headers()

        def do_POST(self) -> None:
            provider.requests.append(self.path)
            body = self.rfile.read(int(self.headers["Content-Length"])).decode()
            answer = provider.token(_fields(body), self.headers.get("Authorization", ""))
            self._answer(400 if "error" in answer else 200, answer)

        def _answer(self, status: int, body: dict[str, Any]) -> None:
            content = json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def log_message(self, *_: object) -> None:
            """Write no log."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    provider.issuer = f"http://127.0.0.1:{server.server_port}"
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield provider
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def _fields(text: str) -> dict[str, str]:
    return {name: values[0] for name, values in parse_qs(text).items()}
