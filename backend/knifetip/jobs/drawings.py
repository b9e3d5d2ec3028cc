"""drawings: what was uploaded, and what somebody decided about it."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import undefer

from knifetip.errors import NoSuchJob, StaleRevision, WrongState
from knifetip.jobs.interpretations import drawing_columns
from knifetip.jobs.job import Who, new_id
from knifetip.jobs.moves import Moves, rows, same_request, short
from knifetip.jobs.tables import Drawing, Job
from knifetip.model.interpretation import Interpretation


class Drawings(Moves):
    """The drawings of the store."""

    def add_drawing(
        self,
        *,
        name: str,
        content: bytes,
        sha256: str,
        interpretation: Interpretation,
        summary: dict[str, Any],
        edges: bytes,
        ledger: bytes,
        key: str | None = None,
        fingerprint: str = "",
    ) -> Drawing:
        """Keep a drawing that was read; the same key gives the drawing that it first made.

        Raises
        ------
        WrongState
            The key was used for another request.
        """
        row = Drawing(
            id=new_id(),
            name=name,
            created=self.clock(),
            sha256=sha256,
            **drawing_columns(interpretation),
            version=1,
            summary=summary,
            key=key,
            fingerprint=fingerprint,
            content=content,
            edges=edges,
            ledger=ledger,
        )
        try:
            with self._writing() as session:
                session.add(row)
                self._note(session, "drawing", row.id, "read", str(Who.OPERATOR), name)
        except IntegrityError:
            if key is None or (earlier := self.drawing_of(key, fingerprint)) is None:
                raise
            return earlier
        return row

    def drawing_of(self, key: str, fingerprint: str) -> Drawing | None:
        """Return the drawing that a request with this Idempotency-Key made, with its ledger."""
        with self._reading() as session:
            row = session.scalar(
                sa.select(Drawing).where(Drawing.key == key).options(undefer(Drawing.ledger))
            )
        return None if row is None else same_request(row, key, fingerprint)

    def drawing(self, id: str) -> Drawing:
        """Return a drawing without its large columns."""
        return self.drawing_with(id)

    def drawing_with(self, id: str, *columns: str) -> Drawing:
        """Return a drawing with these of its large columns, all of the same revision."""
        large = [undefer(getattr(Drawing, column)) for column in columns]
        with self._reading() as session:
            row = session.scalar(sa.select(Drawing).where(Drawing.id == id).options(*large))
        if row is None:
            raise _no_drawing(id)
        return row

    def drawing_column(self, id: str, column: str) -> bytes:
        """Return one of a drawing's large columns: content, overrides, edges or ledger."""
        return self._column(Drawing, id, column, "drawing")

    def drawings(self, before: int | None, limit: int) -> list[Drawing]:
        """Return drawings, the newest first, older than the one with serial ``before``."""
        query = sa.select(Drawing).order_by(Drawing.serial.desc()).limit(limit)
        if before is not None:
            query = query.where(Drawing.serial < before)
        with self._reading() as session:
            return list(session.scalars(query))

    def change_drawing(self, id: str, version: int, why: str, **changes: Any) -> Drawing:
        """Change a drawing that is still as it was at ``version``; return it with its ledger.

        Raises
        ------
        NoSuchJob
            It was deleted in between.
        StaleRevision
            It was changed in between.
        """
        with self._writing() as session:
            changed = rows(
                session,
                sa.update(Drawing)
                .where(Drawing.id == id, Drawing.version == version)
                .values(version=version + 1, **changes),
            )
            if not changed:
                now = session.scalar(sa.select(Drawing.version).where(Drawing.id == id))
                if now is None:
                    raise _no_drawing(id)
                raise StaleRevision(id, now, str(version))
            self._note(session, "drawing", id, "changed", str(Who.OPERATOR), why)
            # As this change left it: another may follow before anything else is read.
            return session.scalars(
                sa.select(Drawing).where(Drawing.id == id).options(undefer(Drawing.ledger))
            ).one()

    def delete_drawing(self, id: str) -> None:
        """Forget a drawing that no job was made from."""
        self.drawing(id)
        with self._writing() as session:
            if used := session.scalar(sa.select(Job.id).where(Job.drawing == id).limit(1)):
                raise WrongState("drawing.in-use", job=used, drawing=id)
            session.execute(sa.delete(Drawing).where(Drawing.id == id))
            self._note(session, "drawing", id, "deleted", str(Who.OPERATOR), "")


def _no_drawing(id: str) -> NoSuchJob:
    return NoSuchJob("drawing.unknown", drawing=short(id))
