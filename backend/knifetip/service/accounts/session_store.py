"""session_store: repository of the sessions of users in browsers.

A session is a random token in a cookie; only its SHA-256 is stored.  It ends after a time without
requests, at a fixed time after the sign-in, at the sign-out, and when password, role or state of
its user change.
"""

from __future__ import annotations

import hashlib
import secrets
from typing import Final

import sqlalchemy as sa

from knifetip.service.database.account_tables import BrowserSession, UserAccount
from knifetip.service.database.engine import Database

#: Longest time without a request (s): a shift.
IDLE: Final = 12 * 3600.0
#: Longest time after the sign-in (s).
LIFETIME: Final = 7 * 24 * 3600.0
#: Shortest time between two records of the use of a session (s).
_USE_INTERVAL: Final = 60.0


class SessionStore:
    """Repository of sessions."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def open(self, user: UserAccount) -> str:
        """Begin a session of a user and return its token; ended sessions are deleted."""
        token = secrets.token_urlsafe(32)
        now = self._db.clock()
        with self._db.writing() as session:
            session.execute(
                sa.delete(BrowserSession).where(
                    sa.or_(BrowserSession.expires <= now, BrowserSession.seen <= now - IDLE)
                )
            )
            values = {"seen": now, "expires": now + LIFETIME, "created": now}
            session.add(BrowserSession(digest=digest_of(token), user=user.id, **values))
            session.execute(
                sa.update(UserAccount).where(UserAccount.id == user.id).values(signed_in=now)
            )
        return token

    def find(self, token: str, *, used: bool = True) -> UserAccount | None:
        """Return the active user of a session; None if the session has ended.

        Parameters
        ----------
        token
            Token of the session.
        used
            Record the use of the session, which postpones its end.
        """
        query = (
            sa.select(BrowserSession, UserAccount)
            .join(UserAccount, UserAccount.id == BrowserSession.user)
            .where(BrowserSession.digest == digest_of(token), UserAccount.active.is_(True))
        )
        with self._db.reading() as session:
            found = session.execute(query).first()
        now = self._db.clock()
        if found is None or found[0].expires <= now or found[0].seen <= now - IDLE:
            return None
        if used and now - found[0].seen >= _USE_INTERVAL:
            with self._db.writing() as session:
                session.execute(
                    sa.update(BrowserSession)
                    .where(BrowserSession.digest == found[0].digest)
                    .values(seen=now)
                )
        user: UserAccount = found[1]
        return user

    def close(self, token: str) -> None:
        """End a session; nothing happens if it has ended."""
        with self._db.writing() as session:
            session.execute(
                sa.delete(BrowserSession).where(BrowserSession.digest == digest_of(token))
            )


def digest_of(token: str) -> str:
    """Return the SHA-256 digest of a session's token, under which the session is stored."""
    return hashlib.sha256(token.encode("utf-8", "replace")).hexdigest()
