"""Repository of drawings, with the line types that users have set for their edges."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.contract.job import OPERATOR, new_id
from knifetip.errors import ContentLost, NotFound, StaleRevision, WrongState
from knifetip.messages import Message
from knifetip.model.interpretation import Interpretation
from knifetip.service.content.store import ContentStore
from knifetip.service.database.acting import acting_limits, acting_owner
from knifetip.service.database.engine import Database, rows, short
from knifetip.service.database.large_value import LargeValue
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.interpretations import drawing_columns
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.order_details.details import (
    Details,
    DetailsFilter,
    metadata_rows,
    replace_metadata,
)

_BATCH: Final = 1000  # drawings that one query for old ones finds


@dataclass(frozen=True, slots=True)
class NewDrawing:
    """A drawing to store: its file, its interpretation and the data that were read from it.

    The interpretation contains the unit, the profile and the line types that the user has set.
    """

    name: str  #: file name
    content: bytes  #: the file
    sha256: str  #: of the file
    interpretation: Interpretation
    summary: dict[str, Any]  #: see ``tables.Drawing``
    edges: bytes  #: packed ``EdgeTable``
    import_report: bytes  #: JSON, deflated
    details: Details = field(default_factory=dict)  #: columns of ``order_details``
    #: names of the customer's files that gave the unit; empty if a user gave it
    unit_learned: tuple[str, ...] = ()
    layout: dict[str, Any] | None = None  #: see ``tables.Drawing``


class DrawingStore:
    """Repository of drawings: store, find, change and delete them."""

    def __init__(
        self, database: Database, contents: ContentStore, transitions: Transitions
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions

    def add(
        self,
        new: NewDrawing,
        key: RequestKey | None = None,
    ) -> Drawing:
        """Store a drawing and return it.

        Parameters
        ----------
        new
            The drawing to store.
        key
            Key of the request, None if it has none.  If a drawing was stored with this key, that
            drawing is returned and nothing is stored.

        Raises
        ------
        KeyReused
            The key was used for a request with another content.
        StoreError
            The contents cannot be written to the folder or the bucket.
        AccessDenied
            The key of the sender is for another customer.
        """
        details = acting_limits().ordered_details(new.details)
        now = self._db.clock()
        staged = self._contents.stage(
            content=new.content,
            overrides=new.interpretation.overrides,
            edges=new.edges,
            import_report=new.import_report,
        )
        row = Drawing(
            id=new_id(),
            name=new.name,
            created=now,
            updated=now,
            owner=acting_owner(),
            sha256=new.sha256,
            **drawing_columns(new.interpretation),
            unit_learned=list(new.unit_learned),
            layout=new.layout,
            version=1,
            summary=new.summary,
            key=None if key is None else key.stored,
            fingerprint="" if key is None else key.fingerprint,
            content=new.content,
            edges=new.edges,
            import_report=new.import_report,
            **staged.columns,
            **details,
        )
        try:
            with self._db.writing() as session:
                self._contents.keep(session, staged)
                session.add(row)
                session.flush()  # assigns the serial number
                session.add_all(metadata_rows(Drawing, row.serial, row.extra or {}))
                self._transitions.write_drawing_event(
                    session,
                    row.id,
                    "read",
                    OPERATOR,
                    Message("drawing.read", name=new.name),
                )
        except IntegrityError:
            if key is None or (earlier := self.find(key)) is None:
                raise
            return earlier
        return row

    def find(self, key: RequestKey) -> Drawing | None:
        """Return the drawing that was stored with the key of a request, None if there is none.

        The import report of the drawing is loaded too.

        Raises
        ------
        KeyReused
            The key was used for a request with another content.
        """
        row = self._contents.find(Drawing, Drawing.key == key.stored, "import_report")
        return None if row is None else key.check(row)

    def get(self, id: str) -> Drawing:
        """Return the drawing with an id, without the file, the edges and other large columns.

        Raises
        ------
        NotFound
            There is no drawing with this id (jobs and drawings have the same error class).
        """
        return self.get_with(id)

    def get_with(self, id: str, *columns: str) -> Drawing:
        """Return a drawing in which some of the large values are loaded.

        One query reads all of them, so that they belong to the same version of the drawing.

        Parameters
        ----------
        id
            Id of the drawing.
        *columns
            Names of the large values to load: ``content``, ``overrides``, ``edges`` or
            ``import_report``.

        Raises
        ------
        NotFound
            There is no drawing with this id (jobs and drawings have the same error class).
        ContentLost
            A value is missing or altered.
        """
        row = self._contents.find(Drawing, Drawing.id == id, *columns)
        if row is None:
            raise unknown_drawing_error(id)
        return row

    def column(self, id: str, column: str) -> bytes:
        """Return a large value of a drawing.

        Parameters
        ----------
        id
            Id of the drawing.
        column
            ``content`` (the file), ``overrides`` (line types that the user has set), ``edges`` or
            ``import_report``.

        Raises
        ------
        NotFound
            There is no drawing with this id (jobs and drawings have the same error class).
        WrongState
            The drawing has no such value.
        ContentLost
            The value is missing or altered.
        """
        return self._contents.value(Drawing, id, column, "drawing")

    def recent(
        self,
        before: int | None,
        limit: int,
        wanted: DetailsFilter | None = None,
        *,
        layouts: bool = False,
    ) -> list[Drawing]:
        """Return at most ``limit`` drawings, newest first.

        Parameters
        ----------
        before
            Return only drawings with a smaller serial number; None for all.
        limit
            Greatest number of drawings.
        wanted
            Conditions on the details of their orders; None for none.
        layouts
            Whether to return layouts instead of uploaded drawings.
        """
        query = sa.select(Drawing).order_by(Drawing.serial.desc()).limit(limit)
        query = query.where(Drawing.layout.is_not(None) if layouts else Drawing.layout.is_(None))
        query = query.where(*acting_limits().drawing_conditions())
        if before is not None:
            query = query.where(Drawing.serial < before)
        if wanted is not None:
            query = query.where(*wanted.conditions(Drawing))
        with self._db.reading() as session:
            return list(session.scalars(query))

    def change(self, id: str, version: int, event: Message, **changes: Any) -> Drawing:
        """Change columns and large values of a drawing; return it with its import report.

        Parameters
        ----------
        id
            Id of the drawing.
        version
            Version of the drawing on which the change is based.
        event
            Description of the change, for the log of events.
        **changes
            New values of columns and large values, by name.

        Raises
        ------
        NotFound
            The drawing was deleted since it was read.
        StaleRevision
            The drawing has another version, because it was changed since it was read.
        """
        acting_limits().check_change(changes)
        large = [name for name in changes if isinstance(getattr(Drawing, name), LargeValue)]
        contents = {name: changes.pop(name) for name in large}
        import_report = contents.get("import_report")
        if import_report is None:
            unchanged = sa.and_(Drawing.id == id, Drawing.version == version)
            before = self._contents.find(Drawing, unchanged, "import_report")
            import_report = b"" if before is None else before.import_report
        staged = self._contents.stage(**contents)
        with self._db.writing() as session:
            changes |= self._contents.keep(session, staged)
            changed = rows(
                session,
                sa.update(Drawing)
                .where(Drawing.id == id, Drawing.version == version)
                .values(version=version + 1, updated=self._db.clock(), **changes),
            )
            if not changed:
                now = session.scalar(sa.select(Drawing.version).where(Drawing.id == id))
                if now is None:
                    raise unknown_drawing_error(id)
                raise StaleRevision(id, now, str(version))
            if "extra" in changes:
                serial = session.scalars(sa.select(Drawing.serial).where(Drawing.id == id)).one()
                replace_metadata(session, Drawing, serial, changes["extra"])
            self._transitions.write_drawing_event(session, id, "changed", OPERATOR, event)
            # Read in this transaction, because another request may change the drawing after it.
            row = session.scalars(sa.select(Drawing).where(Drawing.id == id)).one()
        row.import_report = import_report
        return row

    def delete(self, id: str, check: Callable[[Drawing], None] | None = None) -> None:
        """Delete a drawing from which no job was made.

        Parameters
        ----------
        id
            Id of the drawing.
        check
            Called with the drawing, locked; an error of it keeps the drawing.  None for no check.

        Raises
        ------
        NotFound
            There is no drawing with this id (jobs and drawings have the same error class).
        WrongState
            A job was made from the drawing.
        """
        self.get(id)
        with self._db.writing() as session:
            # An order of this drawing that is being stored ends first, or finds it deleted.
            row = session.scalar(sa.select(Drawing).where(Drawing.id == id).with_for_update())
            if row is not None and check is not None:
                check(row)
            if used := session.scalar(sa.select(Job.id).where(Job.drawing == id).limit(1)):
                raise WrongState("drawing.in-use", job=used, drawing=id)
            session.execute(sa.delete(Drawing).where(Drawing.id == id))
            self._transitions.write_drawing_event(
                session, id, "deleted", OPERATOR, Message("drawing.deleted")
            )

    def delete_unused_before(self, end: float, save: Callable[[str], None] | None = None) -> int:
        """Delete the drawings that were uploaded before a time and of which no job is stored.

        Parameters
        ----------
        end
            Drawings that were uploaded before this time are deleted (seconds since 1970).
        save
            Called with the id of a drawing before it is deleted; an error of it keeps the drawing.

        Returns
        -------
        The number of deleted drawings.
        """
        used = sa.exists().where(Job.drawing == Drawing.id)
        page = sa.select(Drawing.serial, Drawing.id).where(Drawing.created < end, ~used)
        page = page.order_by(Drawing.serial).limit(_BATCH)
        last = deleted = 0
        while True:
            with self._db.reading() as session:
                found = session.execute(page.where(Drawing.serial > last)).all()
            if not found:
                return deleted
            for _, id in found:
                # Deleted or used meanwhile, or its file is lost.
                with suppress(NotFound, WrongState, ContentLost):
                    if save is not None:
                        save(id)
                    self.delete(id)
                    deleted += 1
            last = found[-1].serial


def unknown_drawing_error(id: str) -> NotFound:
    """Return the error that there is no drawing with an id."""
    return NotFound("drawing.unknown", drawing=short(id))
