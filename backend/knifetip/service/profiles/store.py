"""Repository of the classification profiles of customers.

A change must name the version on which it is based (optimistic locking).
"""

from __future__ import annotations

from collections.abc import Sequence

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import NotFound, StaleVersion, WrongState
from knifetip.service.database.engine import Database, rows, short
from knifetip.service.database.tables import Profile

#: Greatest number of profiles; a list of profiles parses all of them.
MAX_PROFILES = 1000


class ProfileStore:
    """Repository of the classification profiles of customers."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def get(self, name: str) -> Profile | None:
        """Return the profile with a name, None if there is none."""
        with self._db.reading() as session:
            return session.scalar(sa.select(Profile).where(Profile.name == name))

    def all(self) -> Sequence[Profile]:
        """Return the profiles of all customers, ordered by name."""
        with self._db.reading() as session:
            return list(session.scalars(sa.select(Profile).order_by(Profile.name)))

    def newest_versions(self) -> frozenset[tuple[str, int, float]]:
        """Return name, version and time of the last change of each profile."""
        query = sa.select(Profile.name, Profile.version, Profile.updated)
        with self._db.reading() as session:
            return frozenset(session.execute(query))

    def save(
        self, name: str, title: str, text: str, version: int | None, *, replace_any: bool = False
    ) -> Profile:
        """Create or replace a classification profile, and return it.

        Parameters
        ----------
        name, title, text
            Name, title and TOML text of the profile.
        version
            Version of the stored profile on which the change is based; None to create a profile.
        replace_any
            If True, ``version`` is ignored: a stored profile with this name is replaced, and if
            there is none, the profile is created.

        Raises
        ------
        StaleVersion
            The stored profile has another version.
        WrongState
            The profile to create exists already, or there are too many profiles.
        NotFound
            The profile to replace was deleted (jobs and profiles have the same error class).
        """
        now = self._db.clock()
        if version is None and not replace_any:
            return self._add(name, title, text, now)
        with self._db.writing() as session:
            statement = sa.update(Profile).where(Profile.name == name)
            if not replace_any:
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
        if replace_any:
            return self._add(name, title, text, now)
        raise self._missing_or_stale_error(name, version)

    def _add(self, name: str, title: str, text: str, now: float) -> Profile:
        row = Profile(name=name, title=title, text=text, version=1, created=now, updated=now)
        try:
            with self._db.writing() as session:
                if (session.scalar(sa.select(sa.func.count(Profile.name))) or 0) >= MAX_PROFILES:
                    raise WrongState("profile.too-many", limit=MAX_PROFILES)
                session.add(row)
        except IntegrityError as reason:
            raise self._missing_or_stale_error(name, None) from reason
        return row

    def delete(self, name: str, version: int | None = None) -> None:
        """Delete a profile; drawings and jobs keep the rules with which they were made.

        Parameters
        ----------
        name
            Name of the profile.
        version
            Version that the profile must have; None for any version.

        Raises
        ------
        NotFound
            There is no profile with this name (jobs and profiles have the same error class).
        StaleVersion
            The profile has another version.
        """
        with self._db.writing() as session:
            statement = sa.delete(Profile).where(Profile.name == name)
            if version is not None:
                statement = statement.where(Profile.version == version)
            if rows(session, statement):
                return
        raise self._missing_or_stale_error(name, version)

    def _missing_or_stale_error(
        self, name: str, version: int | None
    ) -> NotFound | StaleVersion | WrongState:
        found = self.get(name)
        if found is None:
            return NotFound("profile.not-kept", name=short(name))
        if version is None:
            return WrongState(
                "library.exists", shelf="profile", name=short(name), version=found.version
            )
        return StaleVersion(
            "library.stale",
            shelf="profile",
            name=short(name),
            version=found.version,
            given=version,
        )
