"""Repository of large JSON answers about drawings and jobs, which are made once for each version.

A document is made again from its drawing or job whenever it is missing, so it needs no backup.  It
is deleted with its drawing or job.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Drawing, DrawingDocument, Job, JobDocument

#: Another version of knifetip may make other JSON.
_PROGRAM: Final = version("knifetip")


class DocumentStore:
    """Repository of documents: one of each kind for each drawing and each job."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def find(self, owner: Drawing | Job, kind: str, version: str) -> bytes | None:
        """Return a document, or None if it was not made for this version of its owner.

        Parameters
        ----------
        owner
            The drawing or the job that the document is about.
        kind
            Kind of the document.
        version
            Version of the owner.
        """
        table = _table(owner)
        query = sa.select(table.content).where(
            table.owner == owner.serial, table.kind == kind, table.version == _key(version)
        )
        with self._db.reading() as session:
            content = session.scalar(query)
        return None if content is None else bytes(content)

    def keep(self, owner: Drawing | Job, kind: str, version: str, content: bytes) -> None:
        """Store a document in place of the earlier one of its kind; see ``find``.

        Nothing is stored if the owner was deleted meanwhile, or if another server stores the same
        document at this moment.
        """
        table = _table(owner)
        row = table(owner=owner.serial, kind=kind, version=_key(version), content=content)
        try:
            with self._db.writing() as session:
                session.execute(
                    sa.delete(table).where(table.owner == owner.serial, table.kind == kind)
                )
                session.add(row)
        except IntegrityError:
            pass


def _table(owner: Drawing | Job) -> type[DrawingDocument] | type[JobDocument]:
    return DrawingDocument if isinstance(owner, Drawing) else JobDocument


def _key(version: str) -> str:
    return f"{version} {_PROGRAM}"
