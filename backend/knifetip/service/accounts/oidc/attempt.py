"""One attempt of a browser to sign in at the provider.

The browser keeps a random text in a cookie.  State, nonce and PKCE verifier are hashes of it, so
that any server of the database can finish what another one has begun, and nothing is stored for
a stranger who begins only.
"""

from __future__ import annotations

import base64
import hashlib
import secrets
from dataclasses import dataclass
from typing import Final

#: Time in which the user must sign in at the provider (s).
LIFETIME: Final = 600


@dataclass(frozen=True, slots=True)
class SignInAttempt:
    """An attempt, with the text in the cookie."""

    cookie: str  #: ``TIME.RANDOM``

    @property
    def state(self) -> str:
        """Text that the provider returns with the code."""
        return self._derived_key("state")

    @property
    def nonce(self) -> str:
        """Text that the provider writes into the ID token."""
        return self._derived_key("nonce")

    @property
    def verifier(self) -> str:
        """Text with which this server proves that it has begun the attempt (PKCE)."""
        return self._derived_key("verifier")

    @property
    def digest(self) -> str:
        """Text under which a finished attempt is stored, so that it cannot be used again."""
        return hashlib.sha256(f"used {self.cookie}".encode()).hexdigest()

    def _derived_key(self, purpose: str) -> str:
        digest = hashlib.sha256(f"{purpose} {self.cookie}".encode()).digest()
        return base64.urlsafe_b64encode(digest).rstrip(b"=").decode("ascii")


def new_attempt(now: float) -> SignInAttempt:
    """Return a new attempt; ``now`` is in seconds since 1970."""
    return SignInAttempt(f"{int(now)}.{secrets.token_urlsafe(32)}")


def attempt_of(cookie: str, now: float) -> SignInAttempt | None:
    """Return the attempt of a cookie; None if the text is malformed or too old."""
    begun, _, random = cookie.partition(".")
    if not (begun.isascii() and begun.isdecimal() and len(begun) < 16 and len(random) == 43):
        return None
    if not cookie.isascii() or not -60 <= now - int(begun) <= LIFETIME:
        return None
    return SignInAttempt(cookie)
