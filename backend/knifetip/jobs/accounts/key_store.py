"""key_store: repository of API keys.

The secret of a key is ``kt_ID_SECRET`` with 256 random bits.  Only its SHA-256 is stored: a secret
with so many random bits cannot be guessed, so a slow hash is not needed.
"""

from __future__ import annotations

import hashlib
import hmac
import re
import secrets
from collections.abc import Collection, Sequence
from typing import Final

import sqlalchemy as sa

from knifetip.errors import NotFound, RequestError, WrongState
from knifetip.harmless import harmless
from knifetip.jobs.accounts.account_tables import ApiKey
from knifetip.jobs.accounts.acting import set_subject
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.database import Database, short
from knifetip.jobs.job import new_id

#: Shortest time between two records of the use of a key (s).
USE_INTERVAL: Final = 60.0
_SECRET: Final = re.compile(r"kt_([a-z0-9]{10})_([A-Za-z0-9_-]{43})")


class KeyStore:
    """Repository of API keys."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def all(self) -> Sequence[ApiKey]:
        """Return all keys, the newest first."""
        with self._db.reading() as session:
            query = sa.select(ApiKey).order_by(ApiKey.created.desc(), ApiKey.id)
            return list(session.scalars(query))

    def add(
        self,
        title: str,
        scopes: Collection[AccessScope],
        expires: float | None = None,
        by: str = "",
    ) -> tuple[ApiKey, str]:
        """Store a new key; return it with its secret, which cannot be read again.

        Parameters
        ----------
        title
            What uses the key.
        scopes
            Scopes of the key, at least one.
        expires
            Time at which the key becomes invalid (seconds since 1970); None for never.
        by
            Name of the administrator.

        Raises
        ------
        RequestError
            The key has no title or no scope, or would be expired.
        """
        now = self._db.clock()
        title = harmless(title).strip()[:100]
        if not title or not scopes:
            raise RequestError("key.incomplete", source=["title", "scopes"])
        if expires is not None and expires <= now:
            raise WrongState("key.expired-at-once", source=["expires"])
        id = new_id()
        secret = f"kt_{id}_{secrets.token_urlsafe(32)}"
        row = ApiKey(
            id=id,
            title=title,
            digest=_digest(secret),
            scopes=sorted(scope.value for scope in set(scopes)),
            created=now,
            created_by=by[:200],
            expires=expires,
            used=None,
            revoked=None,
        )
        with self._db.writing() as session:
            set_subject(session, "key", id)
            session.add(row)
        return row, secret

    def revoke(self, id: str) -> ApiKey:
        """Make a key invalid for ever, and return it; a repeated call has no effect.

        Raises
        ------
        NotFound
            There is no such key.
        """
        with self._db.writing() as session:
            row = session.get(ApiKey, id)
            if row is None:
                raise NotFound("key.unknown", id=short(id))
            set_subject(session, "key", id)
            row.revoked = row.revoked or self._db.clock()
            return row

    def find(self, secret: str, *, used: bool = True) -> ApiKey | None:
        """Return the valid key with a secret; None if there is none.

        Parameters
        ----------
        secret
            Secret of the key.
        used
            Record the use of the key.
        """
        parts = _SECRET.fullmatch(secret)
        if parts is None:
            return None
        with self._db.reading() as session:
            row = session.get(ApiKey, parts[1])
        now = self._db.clock()
        if (
            row is None
            or not hmac.compare_digest(row.digest, _digest(secret))
            or row.revoked is not None
            or (row.expires is not None and row.expires <= now)
        ):
            return None
        if used and (row.used is None or now - row.used >= USE_INTERVAL):
            with self._db.writing() as session:
                session.execute(sa.update(ApiKey).where(ApiKey.id == row.id).values(used=now))
        return row


def _digest(secret: str) -> str:
    return hashlib.sha256(secret.encode()).hexdigest()
