"""user_store: repository of the users of a server.

Users are never deleted, so that events and the audit log name them; they can be disabled.  A change
of the password, the role or the state of a user ends the sessions of the user.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.contract.job import new_id
from knifetip.errors import NotFound, RequestError, WrongState
from knifetip.service.accounts import passwords
from knifetip.service.accounts.session_store import digest_of
from knifetip.service.database.account_tables import BrowserSession, UserAccount
from knifetip.service.database.acting import set_subject
from knifetip.service.database.engine import Database, short
from knifetip.service.http.scopes import ROLES, AccessScope

_NAME: Final = re.compile(r"[a-z0-9][a-z0-9._@+-]{0,63}")


class UserStore:
    """Repository of users."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def all(self) -> Sequence[UserAccount]:
        """Return all users, ordered by name."""
        with self._db.reading() as session:
            return list(session.scalars(sa.select(UserAccount).order_by(UserAccount.name)))

    def has_admin(self) -> bool:
        """Return whether there is an administrator; once there is one, there always is one."""
        query = sa.select(UserAccount.id).where(UserAccount.role == AccessScope.ADMIN.value)
        with self._db.reading() as session:
            return session.scalar(query.limit(1)) is not None

    def add(self, name: str, password: str, role: AccessScope, by: str = "") -> UserAccount:
        """Store a new user and return it.

        Parameters
        ----------
        name
            Name of the user; capital letters are made small.
        password
            Password of at least ten characters.
        role
            One of ``ROLES``.
        by
            Name of the administrator.

        Raises
        ------
        RequestError
            The name, the password or the role is not permitted.
        WrongState
            There is a user with this name.
        """
        name = name.lower()
        if _NAME.fullmatch(name) is None:
            raise RequestError("user.bad-name", name=short(name), source=["name"])
        _check_role(role)
        passwords.check_password(password, name)
        now = self._db.clock()
        row = UserAccount(
            id=new_id(),
            name=name,
            role=role.value,
            password=passwords.hash_password(password),
            active=True,
            created=now,
            created_by=by[:200],
            signed_in=None,
        )
        try:
            with self._db.writing() as session:
                set_subject(session, "user", name)
                session.add(row)
        except IntegrityError as reason:
            raise WrongState("user.exists", name=name) from reason
        return row

    def change(
        self,
        name: str,
        *,
        role: AccessScope | None = None,
        active: bool | None = None,
        password: str | None = None,
        kept_session: str | None = None,
    ) -> UserAccount:
        """Change a user, end the sessions of the user, and return the user.

        Parameters
        ----------
        name
            Name of the user.
        role, active, password
            New values; None for no change.
        kept_session
            Token of a session that does not end; None to end all sessions.

        Raises
        ------
        NotFound
            There is no such user.
        WrongState
            The user is the last active administrator and would no longer be one.
        RequestError
            The password or the role is not permitted.
        """
        if role is not None:
            _check_role(role)
        hashed = None
        if password is not None:
            passwords.check_password(password, name)
            hashed = passwords.hash_password(password)
        with self._db.writing() as session:
            row = _find(session, name)
            set_subject(session, "user", row.name)
            if row.kind == "oidc" and hashed is not None:
                raise WrongState("user.at-provider", name=row.name)
            was_admin = _is_admin(row)
            row.role = row.role if role is None else role.value
            row.active = row.active if active is None else active
            row.password = row.password if hashed is None else hashed
            _end_sessions(session, row, was_admin, kept_session)
            return row

    @staticmethod
    def set_role(session: Session, row: UserAccount, role: AccessScope) -> None:
        """Set the role of a user in a transaction, and end the sessions of the user.

        Raises
        ------
        WrongState
            The user is the last active administrator and would no longer be one.
        """
        was_admin = _is_admin(row)
        row.role = role.value
        _end_sessions(session, row, was_admin)

    def authenticate(self, name: str, password: str) -> UserAccount | None:
        """Return the active user with a name and a password; None if there is none.

        The call takes the same time for an unknown name.
        """
        with self._db.reading() as session:
            row = session.scalar(sa.select(UserAccount).where(UserAccount.name == name.lower()))
        right = passwords.is_password(password, None if row is None else row.password)
        if row is None or not right or not row.active:
            return None
        if passwords.is_outdated(row.password):
            values = {"password": passwords.hash_password(password)}
            with self._db.writing() as session:
                session.execute(
                    sa.update(UserAccount).where(UserAccount.id == row.id).values(**values)
                )
        return row

    def exists(self, name: str) -> bool:
        """Return whether there is a user with a name."""
        with self._db.reading() as session:
            query = sa.select(UserAccount.id).where(UserAccount.name == name.lower())
            return session.scalar(query) is not None

    def kind_of(self, name: str) -> str | None:
        """Return how a user signs in, ``password`` or ``oidc``; None if there is no such user."""
        with self._db.reading() as session:
            query = sa.select(UserAccount.kind).where(UserAccount.name == name.lower())
            return session.scalar(query)


def _end_sessions(
    session: Session, row: UserAccount, was_admin: bool, kept: str | None = None
) -> None:
    """End the sessions of a changed user, unless there would be no active administrator.

    The session with the token ``kept`` does not end.
    """
    session.flush()
    if was_admin and not _is_admin(row) and not _active_admins(session):
        raise WrongState("user.last-admin", name=row.name)
    statement = sa.delete(BrowserSession).where(BrowserSession.user == row.id)
    if kept is not None:
        statement = statement.where(BrowserSession.digest != digest_of(kept))
    session.execute(statement)


def _find(session: Session, name: str) -> UserAccount:
    row = session.scalar(
        sa.select(UserAccount).where(UserAccount.name == name.lower()).with_for_update()
    )
    if row is None:
        raise NotFound("user.unknown", name=short(name))
    return row


def _check_role(role: AccessScope) -> None:
    if role not in ROLES:
        raise RequestError(
            "user.bad-role", role=role.value, roles=[one.value for one in ROLES], source=["role"]
        )


def _is_admin(row: UserAccount) -> bool:
    return row.active and row.role == AccessScope.ADMIN


def _active_admins(session: Session) -> bool:
    query = sa.select(UserAccount.id).where(
        UserAccount.role == AccessScope.ADMIN.value, UserAccount.active.is_(True)
    )
    # Locked, so that two administrators cannot disable each other at the same time.
    return bool(session.scalars(query.with_for_update()).all())
