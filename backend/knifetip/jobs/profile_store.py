"""profile_store: classification profiles of customers, with optimistic locking by version."""

from __future__ import annotations

from collections.abc import Sequence

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import NoSuchJob, StaleVersion, WrongState
from knifetip.jobs.database import Database, rows, short
from knifetip.jobs.tables import Profile

#: More than any shop has customers; each is read when the list is.
MOST = 1000


class ProfileStore:
    """Classification profiles of customers."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def get(self, name: str) -> Profile | None:
        """Return a profile, or None where none of that name is kept."""
        with self._db.reading() as session:
            return session.scalar(sa.select(Profile).where(Profile.name == name))

    def all(self) -> Sequence[Profile]:
        """Return all profiles by name."""
        with self._db.reading() as session:
            return list(session.scalars(sa.select(Profile).order_by(Profile.name)))

    def save(
        self, name: str, title: str, text: str, version: int | None, *, anyway: bool = False
    ) -> Profile:
        """Keep a new profile, or change one that is still as it was at ``version``.

        Parameters
        ----------
        version
            That was looked at; None makes a new one.
        anyway
            Whatever it is now, if it is at all.

        Raises
        ------
        StaleVersion
            Somebody else changed it in between.
        WrongState
            There is one already, or there are too many.
        NoSuchJob
            It is gone.
        """
        now = self._db.clock()
        if version is None and not anyway:
            return self._add(name, title, text, now)
        with self._db.writing() as session:
            statement = sa.update(Profile).where(Profile.name == name)
            if not anyway:
                statement = statement.where(Profile.version == version)
            statement = statement.values(
                title=title, text=text, version=Profile.version + 1, updated=now
            )
            if rows(session, statement):
                return session.scalars(
                    sa.select(Profile)
                    .where(Profile.name == name)
                    .execution_options(populate_existing=True)
                ).one()
        if anyway:
            return self._add(name, title, text, now)
        raise self._stale(name, version)

    def _add(self, name: str, title: str, text: str, now: float) -> Profile:
        row = Profile(name=name, title=title, text=text, version=1, created=now, updated=now)
        try:
            with self._db.writing() as session:
                if (session.scalar(sa.select(sa.func.count(Profile.name))) or 0) >= MOST:
                    raise WrongState("profile.too-many", limit=MOST)
                session.add(row)
        except IntegrityError as reason:
            raise self._stale(name, None) from reason
        return row

    def delete(self, name: str, version: int | None = None) -> None:
        """Forget a profile; drawings and jobs keep the rules that they were made with.

        Raises
        ------
        NoSuchJob, StaleVersion
            There is none, or not at this version.
        """
        with self._db.writing() as session:
            statement = sa.delete(Profile).where(Profile.name == name)
            if version is not None:
                statement = statement.where(Profile.version == version)
            if rows(session, statement):
                return
        raise self._stale(name, version)

    def _stale(self, name: str, version: int | None) -> NoSuchJob | StaleVersion | WrongState:
        found = self.get(name)
        if found is None:
            return NoSuchJob("profile.not-kept", name=short(name))
        if version is None:
            return WrongState("profile.exists", name=short(name), version=found.version)
        return StaleVersion("profile.stale", name=short(name), version=found.version, given=version)
