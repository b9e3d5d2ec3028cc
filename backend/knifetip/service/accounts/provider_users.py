"""provider_users: repository of the users who sign in at a provider of OpenID Connect."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.contract.job import new_id
from knifetip.errors import SignInRefused
from knifetip.service.accounts.user_store import UserStore
from knifetip.service.database.account_tables import UsedSignIn, UserAccount
from knifetip.service.database.engine import Database
from knifetip.service.http.scopes import AccessScope

#: Time for which a used attempt is stored (s); older ones are refused for their age.
_KEPT: Final = 3600.0
_RETRIES: Final = 4
_NOT_IN_NAMES: Final = re.compile(r"[^a-z0-9._@+-]+")


@dataclass(frozen=True, slots=True)
class ProviderUser:
    """A user as a provider has confirmed it, in one attempt to sign in."""

    issuer: str
    subject: str  #: identifier of the user at the provider
    name: str  #: name at the provider
    role: AccessScope | None  #: None if the user has none at this server
    attempt: str  #: text that identifies the attempt

    @property
    def key(self) -> str:
        """Text that identifies the user among those of all providers."""
        return hashlib.sha256(f"{self.issuer}\0{self.subject}".encode()).hexdigest()


class ProviderUsers:
    """Repository of users of a provider."""

    def __init__(self, database: Database, users: UserStore) -> None:
        self._db = database
        self._users = users

    def record_sign_in(self, provider_user: ProviderUser) -> UserAccount:
        """Return the user that a provider has confirmed, created or with the present role.

        A user who has signed in before is found by the identifier, never by the name.  If the name
        belongs to another user, a number is added to it.

        Raises
        ------
        SignInRefused
            The attempt was used before, or the user has no role or is disabled.
        WrongState
            The user is the last administrator and would have another role.
        """
        for _ in range(_RETRIES):
            # Another request may create the user, or use the attempt, at the same time.
            with suppress(IntegrityError):
                return self._find_or_create(provider_user)
        return self._find_or_create(provider_user)

    def _find_or_create(self, provider_user: ProviderUser) -> UserAccount:
        now = self._db.clock()
        with self._db.writing() as session:
            if session.get(UsedSignIn, provider_user.attempt) is not None:
                raise SignInRefused("oidc.used")
            if provider_user.role is None:
                raise SignInRefused("oidc.no-role", name=provider_user.name[:64])
            session.execute(sa.delete(UsedSignIn).where(UsedSignIn.at < now - _KEPT))
            session.add(UsedSignIn(digest=provider_user.attempt, at=now))
            row = session.scalar(
                sa.select(UserAccount)
                .where(UserAccount.subject == provider_user.key)
                .with_for_update()
            )
            if row is None:
                row = UserAccount(
                    id=new_id(),
                    name=_free_name(session, provider_user.name),
                    kind="oidc",
                    subject=provider_user.key,
                    role=provider_user.role.value,
                    password="",
                    active=True,
                    created=now,
                    created_by=provider_user.issuer[:200],
                    signed_in=None,
                )
                session.add(row)
            elif not row.active:
                raise SignInRefused("oidc.disabled", name=row.name)
            elif row.role != provider_user.role:
                self._users.set_role(session, row, provider_user.role)
            session.flush()
            return row


def _free_name(session: Session, wanted: str) -> str:
    """Return a permitted user name that is not in use, as similar to the wanted one as possible."""
    query = sa.select(UserAccount.id)
    return next(
        name
        for name in _names(wanted)
        if session.scalar(query.where(UserAccount.name == name)) is None
    )


def _names(wanted: str) -> Iterator[str]:
    base = _NOT_IN_NAMES.sub("-", wanted.lower()).lstrip("._@+-")[:56] or "user"
    yield base
    number = 2
    while True:
        yield f"{base}-{number}"
        number += 1
