"""Large values of drawings and jobs by their SHA-256 (ADR 94).

The table ``content`` has one row for each content; drawings and jobs refer to it by foreign keys,
so that the database never deletes what one of them, or a transaction under way, refers to.
The bytes are in the row or, beyond ``_IN_ROW`` bytes and with the option --store, in a folder or a
bucket.

Contents are written first, then the rows that refer to them::

    staged = contents.stage(content=file, edges=edges)
    with database.writing() as session:
        session.add(Drawing(**contents.keep(session, staged)))
"""

from __future__ import annotations

import hashlib
import logging
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeVar

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session, aliased

from knifetip.errors import ContentLost, NotFound, StoreError, WrongState
from knifetip.service.content.objects import Objects
from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database, insert_into, rows, short
from knifetip.service.database.tables import Base, Content, Drawing, Job

_IN_ROW: Final = 4096  #: bytes up to which a content is in the database with any option
_PAGE: Final = 500  #: contents that one query of a sweep reads
#: Time (s) for which an unused content is kept: readers may have its address, and writers may have
#: written it for a row that they store later.
_KEPT: Final = 86_400.0
_OWNERS: Final[tuple[type[Base], ...]] = (Drawing, Job)
_REFERENCES: Final = tuple(
    getattr(table, column.key)
    for table in _OWNERS
    for column in sa.inspect(table).columns
    if column.foreign_keys and column.key.endswith("_address")
)
_Row = TypeVar("_Row", Drawing, Job)
_log = logging.getLogger("knifetip.jobs")


@dataclass(frozen=True, slots=True)
class StagedContents:
    """Contents that ``stage`` has prepared for a row; those in the object store are written."""

    values: Mapping[str, bytes]  #: by name of the attribute
    addresses: Mapping[str, str]  #: by name of the attribute
    outside: frozenset[str]  #: addresses in the object store

    @property
    def columns(self) -> dict[str, str]:
        """Addresses by name of the column."""
        return {f"{name}_address": address for name, address in self.addresses.items()}


class ContentStore:
    """Contents in the database and in an object store.

    Parameters
    ----------
    database
        The database.
    objects
        Folder or bucket for new contents; None to keep all in the database.
    """

    def __init__(self, database: Database, objects: Objects | None = None) -> None:
        self._db = database
        self._objects = objects

    def stage(self, **values: bytes) -> StagedContents:
        """Prepare contents for a transaction, and write those that are kept outside the database.

        Parameters
        ----------
        **values
            Contents by the names of their attributes, such as ``program``.

        Raises
        ------
        StoreError
            The folder or the bucket cannot be written.
        """
        addresses = {name: address_of(data) for name, data in values.items()}
        large = {
            addresses[name]: data
            for name, data in values.items()
            if self._objects is not None and len(data) > _IN_ROW
        }
        if self._objects is not None and large:
            self._announce(sorted(large))
            for address, data in large.items():
                # Also if there is such an object: it may be damaged.
                self._objects.put(address, data)
        return StagedContents(values, addresses, frozenset(large))

    def _announce(self, addresses: Sequence[str]) -> None:
        """Keep sweeps from deleting objects that are about to be written."""
        with self._db.writing() as session:
            for address in addresses:
                insert = insert_into(session, Content).values(
                    address=address, unused_since=self._db.clock()
                )
                session.execute(
                    insert.on_conflict_do_update(
                        index_elements=[Content.address],
                        set_={"unused_since": insert.excluded.unused_since},
                    )
                )

    def keep(self, session: Session, staged: StagedContents) -> dict[str, str]:
        """Store contents in the transaction that refers to them.

        Returns
        -------
        dict[str, str]
            The columns that refer to them, by name.
        """
        inside = {
            address: staged.values[name]
            for name, address in staged.addresses.items()
            if address not in staged.outside
        }
        # Always in the same order, so that two transactions do not wait for each other.
        query = sa.select(Content.address).where(Content.address.in_(sorted(inside)))
        query = query.order_by(Content.address).with_for_update(read=True, key_share=True)
        present = set(session.scalars(query)) if inside else set()
        for address in sorted(inside):
            data = inside[address]
            if address in present:
                damaged = Content.data.is_distinct_from(data)
                session.execute(
                    sa.update(Content)
                    .where(Content.address == address, damaged)
                    .values(data=data)
                    .execution_options(synchronize_session=False)
                )
            else:
                insert = insert_into(session, Content).values(address=address, data=data)
                session.execute(
                    insert.on_conflict_do_update(
                        index_elements=[Content.address], set_={"data": insert.excluded.data}
                    )
                )
        if staged.outside:
            in_row = sa.and_(Content.address.in_(staged.outside), Content.data.is_not(None))
            session.execute(
                sa.update(Content)
                .where(in_row)
                .values(data=None)
                .execution_options(synchronize_session=False)
            )
        return staged.columns

    def find(
        self, table: type[_Row], condition: sa.ColumnElement[bool], *names: str
    ) -> _Row | None:
        """Return the row that meets a condition, with some of its large values; None without one.

        One query reads the addresses and the contents, so that they belong together.

        Parameters
        ----------
        table
            ``Drawing`` or ``Job``.
        condition
            Condition that at most one row meets.
        *names
            Names of the large values.

        Raises
        ------
        ContentLost
            A content is missing or altered.
        StoreError
            The folder or the bucket cannot be read.
        """
        contents = [aliased(Content) for _ in names]
        query = sa.select(table, *(content.data for content in contents)).where(condition)
        query = query.where(*acting_limits().conditions(table))
        for name, content in zip(names, contents, strict=True):
            query = query.outerjoin(content, content.address == getattr(table, f"{name}_address"))
        with self._db.reading() as session:
            found = session.execute(query).first()
        if found is None:
            return None
        row: _Row = found[0]
        for name, data in zip(names, found[1:], strict=True):
            address = getattr(row, f"{name}_address")
            if address is not None:
                setattr(row, name, self._checked_content(address, data, row.id))
        return row

    def value(self, table: type[Drawing] | type[Job], id: str, name: str, kind: str) -> bytes:
        """Return a large value of a drawing or a job.

        Parameters
        ----------
        table
            ``Drawing`` or ``Job``.
        id
            Id of the drawing or the job.
        name
            Name of the value.
        kind
            ``drawing`` or ``job``, for error messages.

        Raises
        ------
        NotFound
            There is no drawing or job with this id.
        WrongState
            It has no such value.
        ContentLost
            The content is missing or altered.
        StoreError
            The folder or the bucket cannot be read.
        """
        address = getattr(table, f"{name}_address")
        query = sa.select(address, Content.data).outerjoin(Content, Content.address == address)
        query = query.where(*acting_limits().conditions(table))
        with self._db.reading() as session:
            found = session.execute(query.where(table.id == id)).first()
        if found is None:
            raise NotFound("store.unknown", kind=kind, id=short(id))
        if found[0] is None:
            raise WrongState("store.no-column", kind=kind, id=id, column=name)
        return self._checked_content(found[0], found[1], id)

    def _checked_content(self, address: str, data: bytes | None, owner: str) -> bytes:
        """Return a content that has its address, from the database or the object store."""
        if data is None:
            if self._objects is None:
                raise StoreError("content.outside", owner=owner, address=address)
            data = self._objects.get(address)
        if data is None:
            raise ContentLost("content.missing", owner=owner, address=address)
        if address_of(data) != address:
            _log.error("the content %s of %s is damaged", address, owner)
            raise ContentLost("content.altered", owner=owner, address=address)
        return data

    def has_outside(self) -> bool:
        """Return whether the bytes of a content are outside the database."""
        query = sa.select(Content.address).where(Content.data.is_(None)).limit(1)
        with self._db.reading() as session:
            return session.scalar(query) is not None

    def probe(self) -> None:
        """Write, read and delete an object in the folder or bucket, if there is one.

        Raises
        ------
        StoreError
            The folder or the bucket cannot be used.
        ContentLost
            The object is not what was written.
        """
        if self._objects is None:
            return
        data = os.urandom(16)
        name = address_of(data)
        self._objects.put(name, data)
        if self._objects.get(name) != data:
            raise ContentLost("content.altered", owner="probe", address=name)
        self._objects.delete(name)

    def sweep(self) -> int:
        """Delete the contents to which nothing has referred for a day; return their number.

        The first sweep that finds a content unused marks it, and a later one deletes it.
        """
        now, deleted = self._db.clock(), 0
        for page in self._pages():
            marked = [row.address for row in page if row.is_used and row.since is not None]
            self._mark(marked, None)
            unused = [row for row in page if not row.is_used]
            self._mark([row.address for row in unused if row.since is None], now)
            for row in unused:
                is_kept = row.is_outside and self._objects is None
                if row.since is not None and row.since < now - _KEPT and not is_kept:
                    deleted += self._delete(row.address, now - _KEPT, row.is_outside)
        return deleted

    def _pages(self) -> Iterator[Sequence[sa.Row[str, float | None, bool, bool]]]:
        """Yield the contents in pages.

        A row has the ``address``, the time ``since`` which it may be unused, whether a row refers
        to it (``is_used``), and whether its bytes are outside the database (``is_outside``).
        """
        query = sa.select(
            Content.address,
            Content.unused_since.label("since"),
            _is_used().label("is_used"),
            Content.data.is_(None).label("is_outside"),
        ).order_by(Content.address)
        last = ""
        while True:
            with self._db.reading() as session:
                page = session.execute(query.where(Content.address > last).limit(_PAGE)).all()
            if not page:
                return
            yield page
            last = page[-1].address

    def _mark(self, addresses: Sequence[str], since: float | None) -> None:
        """Set or clear the time from which contents may be unused.

        A time that a writer has announced since is kept.
        """
        marked = Content.unused_since.is_not(None)
        chosen = sa.and_(Content.address.in_(addresses), ~marked if since is not None else marked)
        # Always in the same order, so that two transactions do not wait for each other.
        locked = sa.select(Content.address).where(chosen).order_by(Content.address)
        if not addresses:
            return
        with self._db.writing() as session:
            found = session.scalars(locked.with_for_update(key_share=True)).all()
            session.execute(
                sa.update(Content)
                .where(Content.address.in_(found))
                .values(unused_since=since)
                .execution_options(synchronize_session=False)
            )

    def _delete(self, address: str, before: float, is_outside: bool) -> bool:
        """Delete a content that was unused before a time, unless a row refers to it meanwhile."""
        unused = sa.and_(Content.unused_since < before, ~_is_used())
        statement = sa.delete(Content).where(Content.address == address, unused)
        statement = statement.execution_options(synchronize_session=False)
        try:
            with self._db.writing() as session:
                if not rows(session, statement):
                    return False
                # Before the commit: a transaction that writes this content again waits for it.
                if is_outside and self._objects is not None:
                    self._objects.delete(address)
        except IntegrityError:
            return False  # a transaction that had begun refers to it
        return True


def address_of(data: bytes) -> str:
    """Return the address of a content: its SHA-256 in hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def _is_used() -> sa.ColumnElement[bool]:
    """Return the condition that a drawing or a job refers to a content.

    The least address that is not less than that of the content is the first entry of an index.
    With EXISTS, PostgreSQL would read all rows: it assumes that a column with one value for almost
    all rows, such as that of line types, has this value here too.
    """
    return sa.or_(
        *(
            sa.select(sa.func.min(column))
            .where(column >= Content.address)
            .scalar_subquery()
            .is_not_distinct_from(Content.address)
            for column in _REFERENCES
        )
    )
