"""Repository of the machines, boards and tools that users have made.

Each change stores a new version and keeps the old ones, because jobs refer to the version for which
they were compiled.  A change must name the version on which it is based (optimistic locking).
Entries of knifetip's library are found too; they are read-only, and their version is 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Final, NamedTuple, TypeVar

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.contract.job import State
from knifetip.errors import LibraryError, NotFound, StaleVersion, WrongState
from knifetip.library import load
from knifetip.library.definition import Definition, Shelf, board_of, machine_of
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.service.database.change_notifier import ALL
from knifetip.service.database.engine import Database, note_change, rows, short
from knifetip.service.database.tables import Job, LibraryEntry, LibraryVersion
from knifetip.service.library.outdated_jobs import changes_since_compile

Record = TypeVar("Record")

#: Greatest number of own machines, boards and tools; the list of machines parses all of them.
MAX_ENTRIES = 1000

_ENDED = (State.DONE, State.REFUSED, State.SCRAPPED, State.CANCELLED)
_SHOWN_JOBS = 3
_SHOWN_NAMES = 40
_CACHED = 512  # versions

#: The newest version of each entry.
_NEWEST = sa.and_(
    LibraryVersion.shelf == LibraryEntry.shelf,
    LibraryVersion.name == LibraryEntry.name,
    LibraryVersion.version == LibraryEntry.version,
)


class VersionNote(NamedTuple):
    """Who stored a version, and why; both may be empty."""

    by: str = ""
    note: str = ""


NO_NOTE: Final = VersionNote()


class LibraryStore:
    """Repository of the machines, boards and tools that users have made."""

    def __init__(self, database: Database) -> None:
        self._db = database
        # A stored version never changes.
        self._version = lru_cache(maxsize=_CACHED)(self._find_version)

    def all(self, *shelves: Shelf) -> Sequence[LibraryVersion]:
        """Return the newest version of each entry on the given shelves, ordered by name."""
        query = sa.select(LibraryVersion).join(LibraryEntry, _NEWEST)
        query = query.where(LibraryVersion.shelf.in_(shelves)).order_by(
            LibraryVersion.shelf, LibraryVersion.name
        )
        with self._db.reading() as session:
            return list(session.scalars(query))

    def versions(self, shelf: Shelf, name: str) -> Sequence[LibraryVersion]:
        """Return all versions of an entry, newest first; empty if it does not exist."""
        query = (
            sa.select(LibraryVersion)
            .join(
                LibraryEntry,
                sa.and_(
                    LibraryEntry.shelf == LibraryVersion.shelf,
                    LibraryEntry.name == LibraryVersion.name,
                ),
            )
            .where(LibraryVersion.shelf == shelf, LibraryVersion.name == name)
            .order_by(LibraryVersion.version.desc())
        )
        with self._db.reading() as session:
            return list(session.scalars(query))

    def newest_versions(self) -> frozenset[tuple[str, str, int]]:
        """Return kind, name and number of the newest version of each entry of the users."""
        query = sa.select(LibraryEntry.shelf, LibraryEntry.name, LibraryEntry.version)
        with self._db.reading() as session:
            return frozenset(session.execute(query))

    def get(self, shelf: Shelf, name: str, version: int | None = None) -> LibraryVersion | None:
        """Return a version of an entry, None if there is none.

        Versions of deleted entries are found too, because jobs refer to them.

        Parameters
        ----------
        shelf, name
            Kind and name of the entry.
        version
            Number of the version; None for the newest version of an entry that is not deleted.
        """
        query = sa.select(LibraryVersion).where(
            LibraryVersion.shelf == shelf, LibraryVersion.name == name
        )
        if version is None:
            query = query.join(LibraryEntry, _NEWEST)
        else:
            query = query.where(LibraryVersion.version == version)
        with self._db.reading() as session:
            return session.scalar(query)

    def definition(self, shelf: Shelf, name: str, version: int | None = None) -> Definition:
        """Return the definition of a user's entry, or of an entry of knifetip's library.

        Parameters
        ----------
        shelf, name
            Kind and name of the entry.
        version
            Number of the version; None for the newest.

        Raises
        ------
        LibraryError
            There is no such entry, or it has no such version.
        """
        if version is not None:
            return self._version(shelf, name, version)
        row = self.get(shelf, name)
        if row is not None:
            return Definition(shelf, row.name, row.version, row.text)
        return self._shipped_definition(shelf, name)

    def _find_version(self, shelf: Shelf, name: str, version: int) -> Definition:
        row = self.get(shelf, name, version)
        if row is not None:
            return Definition(shelf, row.name, row.version, row.text)
        newest = self.get(shelf, name)
        if newest is None and version == 0:
            return self._shipped_definition(shelf, name)
        raise LibraryError(
            "library.unknown-version",
            shelf=shelf.word,
            name=name[:80],
            version=version,
            newest=0 if newest is None else newest.version,
        )

    def _shipped_definition(self, shelf: Shelf, name: str) -> Definition:
        """Return the definition of an entry of knifetip's library."""
        shipped = load.names(shelf)
        if name not in shipped:
            known = [*(one.name for one in self.all(shelf)), *shipped]
            raise LibraryError(
                "library.unknown", shelf=shelf.word, name=name[:80], known=known[:_SHOWN_NAMES]
            )
        return Definition(shelf, name)

    def titles(self, row: Job) -> tuple[str, str]:
        """Return the titles of the machine and the board of a job, or their names if unusable."""
        try:
            machine = self.machine(row.machine, row.machine_version).title
        except LibraryError:
            machine = row.machine
        try:
            board = self.board(row.board, row.board_version).title
        except LibraryError:
            board = row.board
        return machine, board or row.board

    def changes(self, jobs: Sequence[Job]) -> dict[str, list[Message]]:
        """Return what has changed since the compile of each job, by id of the job.

        Jobs whose machine and board are unchanged are omitted.
        """
        if not any(row.machine_version or row.board_version for row in jobs):
            return {}
        with self._db.reading() as session:
            return changes_since_compile(session, jobs)

    def machine(self, name: str, version: int | None = None) -> Machine:
        """Return a machine of a user or of knifetip's library.

        Parameters
        ----------
        name
            Name of the machine.
        version
            Number of the version; None for the newest.

        Raises
        ------
        LibraryError
            There is no such machine or version, or it cannot be used by this version of knifetip.
        """
        return machine_of(self.definition(Shelf.MACHINES, name, version))

    def board(self, name: str, version: int | None = None) -> Board:
        """Return a board of a user or of knifetip's library.

        Parameters
        ----------
        name
            Name of the board.
        version
            Number of the version; None for the newest.

        Raises
        ------
        LibraryError
            There is no such board or version, or it cannot be used by this version of knifetip.
        """
        return board_of(self.definition(Shelf.BOARDS, name, version))

    def machines(self) -> list[Machine]:
        """Return the newest version of all machines: those of users, then those of the library.

        Machines that this version of knifetip cannot use are omitted.
        """
        return _usable(self._newest(Shelf.MACHINES), machine_of)

    def boards(self) -> list[Board]:
        """Return the newest version of all boards: those of users, then those of the library.

        Boards that this version of knifetip cannot use are omitted.
        """
        return _usable(self._newest(Shelf.BOARDS), board_of)

    def _newest(self, shelf: Shelf) -> list[Definition]:
        own = [Definition(shelf, row.name, row.version, row.text) for row in self.all(shelf)]
        return own + [Definition(shelf, name) for name in load.names(shelf)]

    def save(
        self,
        definition: Definition,
        title: str,
        note: VersionNote = NO_NOTE,
        *,
        replace_any: bool = False,
    ) -> LibraryVersion:
        """Store a new version of an entry, and return it.

        Parameters
        ----------
        definition
            The new definition; its version is the stored version on which the change is based, 0 to
            create an entry.
        title
            Title of the entry.
        note
            Who changed the entry, and why.
        replace_any
            If True, the version in ``definition`` is ignored: a stored entry with this name is
            replaced, and if there is none, the entry is created.

        Raises
        ------
        StaleVersion
            The stored entry has another version.
        WrongState
            The entry to create exists already, or there are too many entries.
        NotFound
            The entry to replace does not exist (jobs and entries have the same error class).
        """
        shelf, name, based_on = definition.shelf, definition.name, definition.version
        try:
            with self._db.writing() as session:
                entry = session.get(LibraryEntry, (shelf.value, name), with_for_update=True)
                if not replace_any and (entry.version if entry else 0) != based_on:
                    raise _conflict(shelf, name, entry, based_on)
                if entry is None:
                    entry = _new_entry(session, shelf, name)
                entry.version += 1
                row = LibraryVersion(
                    shelf=shelf.value,
                    name=name,
                    version=entry.version,
                    title=title[:200],
                    text=definition.text,
                    at=self._db.clock(),
                    by=note.by,
                    note=note.note,
                )
                session.add(row)
                # Gateways and waiting jobs depend on the newest version.
                note_change(session, ALL)
        except IntegrityError as reason:
            raise _conflict(shelf, name, self.get(shelf, name), based_on) from reason
        return row

    def delete(self, shelf: Shelf, name: str, version: int | None = None) -> None:
        """Delete an entry; its versions are kept, because jobs refer to them.

        Parameters
        ----------
        shelf, name
            Kind and name of the entry.
        version
            Version that the entry must have; None for any version.

        Raises
        ------
        NotFound
            There is no such entry (jobs and entries have the same error class).
        StaleVersion
            The entry has another version.
        WrongState
            A job that has not ended uses the entry.
        """
        with self._db.writing() as session:
            entry = session.get(LibraryEntry, (shelf.value, name), with_for_update=True)
            if entry is None or version not in (None, entry.version):
                raise _conflict(shelf, name, entry, version or 0)
            users = _jobs_with(session, shelf, name)
            if users:
                raise WrongState(
                    "library.in-use",
                    shelf=shelf.word,
                    name=name,
                    count=len(users),
                    jobs=users[:_SHOWN_JOBS],
                )
            rows(
                session,
                sa.delete(LibraryEntry).where(
                    LibraryEntry.shelf == shelf, LibraryEntry.name == name
                ),
            )


def _usable(
    definitions: Iterable[Definition], record_of: Callable[[Definition], Record]
) -> list[Record]:
    """Return the machines or boards that definitions describe, without those that are invalid."""
    records = []
    for definition in definitions:
        with suppress(LibraryError):
            records.append(record_of(definition))
    return records


def _new_entry(session: Session, shelf: Shelf, name: str) -> LibraryEntry:
    """Add an entry to the table and return it.

    Its version is that of a deleted entry with the same name, so that no version number is used
    twice; 0 if there was none.

    ``session``: session with the transaction of the caller.
    ``shelf``, ``name``: kind and name of the entry.
    Raises ``WrongState``: there are too many entries.
    """
    if (session.scalar(sa.select(sa.func.count()).select_from(LibraryEntry)) or 0) >= MAX_ENTRIES:
        raise WrongState("library.too-many", limit=MAX_ENTRIES)
    last = session.scalar(
        sa.select(sa.func.max(LibraryVersion.version)).where(
            LibraryVersion.shelf == shelf, LibraryVersion.name == name
        )
    )
    entry = LibraryEntry(shelf=shelf.value, name=name, version=last or 0)
    session.add(entry)
    return entry


def _jobs_with(session: Session, shelf: Shelf, name: str) -> list[str]:
    """Return the ids of the jobs that use a machine or a board and have not ended."""
    if shelf is Shelf.TOOLS:
        return []
    column = Job.machine if shelf is Shelf.MACHINES else Job.board
    query = sa.select(Job.id).where(column == name, Job.state.not_in(_ENDED)).order_by(Job.serial)
    return list(session.scalars(query))


def _conflict(
    shelf: Shelf, name: str, found: LibraryEntry | LibraryVersion | None, based_on: int
) -> NotFound | StaleVersion | WrongState:
    """Return the error for a change that names another version than the stored entry has.

    ``shelf``, ``name``: kind and name of the entry.
    ``found``: the stored entry, None if it does not exist.
    ``based_on``: version on which the change is based; 0 if the change creates the entry.
    """
    if found is None:
        return NotFound("library.not-stored", shelf=shelf.word, name=short(name))
    word, shown, version = shelf.word, short(name), found.version
    if not based_on:
        return WrongState("library.exists", shelf=word, name=shown, version=version)
    return StaleVersion("library.stale", shelf=word, name=shown, version=version, given=based_on)
