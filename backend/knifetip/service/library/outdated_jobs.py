"""Jobs that were compiled for a machine or a board of a user that has changed since.

A job stores the versions for which it was compiled.  Version 0 is an entry of knifetip's library,
which does not change.
"""

from __future__ import annotations

from collections.abc import Sequence

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.errors import WrongState
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.service.database.tables import Job, LibraryEntry


def changes_since_compile(session: Session, jobs: Sequence[Job]) -> dict[str, list[Message]]:
    """Return what has changed since the compile of each job, by id of the job.

    Jobs whose machine and board are unchanged are omitted.  The caller begins the transaction.
    """
    used = {
        row.id: [
            (shelf, name, version)
            for shelf, name, version in (
                (Shelf.MACHINES, row.machine, row.machine_version),
                (Shelf.BOARDS, row.board, row.board_version),
            )
            if version
        ]
        for row in jobs
    }
    names = {name for entries in used.values() for _, name, _ in entries}
    found = session.scalars(sa.select(LibraryEntry).where(LibraryEntry.name.in_(names)))
    newest = {(entry.shelf, entry.name): entry.version for entry in found}
    changes = {
        id: [
            _change_message(shelf, name, version, newest.get((shelf.value, name)))
            for shelf, name, version in entries
            if newest.get((shelf.value, name)) != version
        ]
        for id, entries in used.items()
    }
    return {id: messages for id, messages in changes.items() if messages}


def require_current(session: Session, row: Job) -> None:
    """Raise ``WrongState`` if the machine or the board of a job has changed since its compile."""
    changes = changes_since_compile(session, [row])
    if changes:
        raise WrongState("job.outdated", job=row.id, changes=changes[row.id])


def newest_versions(session: Session, row: Job) -> tuple[int, int]:
    """Return the newest versions of the machine and the board of a job; 0 for shipped entries.

    Raises
    ------
    WrongState
        The machine or the board was deleted.
    """
    newest = []
    for shelf, name, version in (
        (Shelf.MACHINES, row.machine, row.machine_version),
        (Shelf.BOARDS, row.board, row.board_version),
    ):
        entry = session.get(LibraryEntry, (shelf.value, name))
        if entry is None and version:
            raise WrongState("library.deleted", shelf=shelf.word, name=name)
        newest.append(0 if entry is None else entry.version)
    return newest[0], newest[1]


def _change_message(shelf: Shelf, name: str, version: int, newest: int | None) -> Message:
    """Return the message that an entry has changed since ``version``; None: it was deleted."""
    if newest is None:
        return Message("library.deleted-since", shelf=shelf.word, name=name, version=version)
    return Message(
        "library.changed-since", shelf=shelf.word, name=name, version=version, newest=newest
    )


def outdated() -> sa.ColumnElement[bool]:
    """Return the condition that a job was compiled for a machine or board that has since changed.

    A job for an entry of knifetip's library is never outdated.  A job for a deleted entry is.
    """

    conditions = []
    for shelf, name, version in (
        (Shelf.MACHINES, Job.machine, Job.machine_version),
        (Shelf.BOARDS, Job.board, Job.board_version),
    ):
        same = sa.exists().where(
            LibraryEntry.shelf == shelf, LibraryEntry.name == name, LibraryEntry.version == version
        )
        conditions.append(sa.and_(version > 0, ~same))
    return sa.or_(*conditions)
