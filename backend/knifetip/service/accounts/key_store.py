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
from sqlalchemy.orm import Session

from knifetip.contract.job import new_id
from knifetip.errors import NotFound, RequestError, WrongState
from knifetip.harmless import harmless
from knifetip.service.database.account_tables import ApiKey
from knifetip.service.database.acting import set_subject
from knifetip.service.database.engine import Database, short
from knifetip.service.database.key_limits import UNLIMITED, KeyLimits
from knifetip.service.http.scopes import FOR_CUSTOMER, FOR_MACHINES, AccessScope

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
        limits: KeyLimits = UNLIMITED,
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
        limits
            Customer and machines for which the key is.  The key of a gateway without machines is
            bound to the first machine for which it is used.

        Raises
        ------
        RequestError
            The key has no title or no scope, or scopes that cannot have these limits.
        WrongState
            The key would be expired.
        """
        now = self._db.clock()
        title = harmless(title).strip()[:100]
        if not title or not scopes:
            raise RequestError("key.incomplete", source=["title", "scopes"])
        _check_limits(scopes, limits)
        if expires is not None and expires <= now:
            raise WrongState("key.expired-at-once", source=["expires"])
        id = new_id()
        secret = new_secret(id)
        row = ApiKey(
            id=id,
            title=title,
            digest=secret_digest(secret),
            scopes=sorted(scope.value for scope in set(scopes)),
            customer=harmless(limits.customer).strip()[:200],
            machines=sorted(limits.machines),
            any_machine=False,
            device=False,
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
            row = _find(session, id)
            set_subject(session, "key", id)
            row.revoked = row.revoked or self._db.clock()
            return row

    def rotate(self, id: str) -> tuple[ApiKey, str]:
        """Give a key a new secret, and return the key with it; the former secret becomes invalid.

        The key keeps its id, so that jobs, drawings and webhooks stay its own.

        Raises
        ------
        NotFound
            There is no such key.
        WrongState
            The key was revoked.
        """
        secret = new_secret(id)
        with self._db.writing() as session:
            row = _find(session, id)
            if row.revoked is not None:
                raise WrongState("key.revoked", id=id)
            set_subject(session, "key", id)
            row.digest = secret_digest(secret)
            return row, secret

    def bind(self, id: str, machine: str) -> None:
        """Bind the key of a gateway to the first machine for which it is used.

        Raises
        ------
        AccessDenied
            The key is bound to another machine.
        """
        with self._db.writing() as session:
            row = session.get(ApiKey, id, with_for_update=True)
            if row is None or row.any_machine:
                return
            if not row.machines:
                row.machines = [machine]
            KeyLimits(machines=frozenset(row.machines)).check_machine(machine)

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
            or not hmac.compare_digest(row.digest, secret_digest(secret))
            or row.revoked is not None
            or (row.expires is not None and row.expires <= now)
        ):
            return None
        if used and (row.used is None or now - row.used >= USE_INTERVAL):
            with self._db.writing() as session:
                session.execute(sa.update(ApiKey).where(ApiKey.id == row.id).values(used=now))
        return row


def _find(session: Session, id: str) -> ApiKey:
    row = session.get(ApiKey, id)
    if row is None:
        raise NotFound("key.unknown", id=short(id))
    return row


def _check_limits(scopes: Collection[AccessScope], limits: KeyLimits) -> None:
    """Raise ``RequestError`` if a key with one of the scopes cannot have limits."""
    for limited, permitted, field in (
        (bool(limits.customer), FOR_CUSTOMER, "customer"),
        (bool(limits.machines), FOR_MACHINES, "machines"),
    ):
        others = sorted(scope.value for scope in scopes if scope not in permitted)
        if limited and others:
            raise RequestError(
                "key.unlimited-scope",
                scope=others[0],
                scopes=[scope.value for scope in AccessScope if scope in permitted],
                source=[field],
            )


def is_secret(text: str) -> bool:
    """Return whether a text has the form of the secret of a key."""
    return _SECRET.fullmatch(text) is not None


def new_secret(id: str) -> str:
    """Return a new secret for the key with an id."""
    return f"kt_{id}_{secrets.token_urlsafe(32)}"


def secret_digest(secret: str) -> str:
    """Return the SHA-256 digest of a secret, under which it is stored."""
    return hashlib.sha256(secret.encode()).hexdigest()
