"""Details of an order that an ERP system or a user attaches to a drawing or a job.

The details are stored and returned, and lists are filtered by them; they change no program.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import sqlalchemy as sa

from knifetip.service.database.tables import Drawing, DrawingMetadata, Job, JobMetadata

Value: TypeAlias = str | int | float | bool
#: Columns by name; ``extra`` is the metadata.
Details: TypeAlias = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class DetailsFilter:
    """Conditions on the details of drawings or jobs; an empty value is no condition."""

    external_id: str = ""
    customer: str = ""
    due_after: float | None = None  #: earliest due time (seconds since 1970)
    due_before: float | None = None  #: due before this time (seconds since 1970)
    notes: str = ""  #: part of the notes, in any case
    metadata: Mapping[str, str] = field(default_factory=dict)  #: values as text, by key
    created_after: float | None = None  #: earliest creation (seconds since 1970)
    created_before: float | None = None  #: created before this time (seconds since 1970)
    updated_after: float | None = None  #: earliest last change (seconds since 1970)
    updated_before: float | None = None  #: changed last before this time (seconds since 1970)

    def conditions(self, table: type[Drawing] | type[Job]) -> list[sa.ColumnElement[bool]]:
        """Return the conditions on the rows of a table as SQL expressions."""
        found: list[sa.ColumnElement[bool]] = []
        if self.external_id:
            found.append(table.external_id == self.external_id)
        if self.customer:
            found.append(table.customer == self.customer)
        for column, after, before in (
            (table.due, self.due_after, self.due_before),
            (table.created, self.created_after, self.created_before),
            (table.updated, self.updated_after, self.updated_before),
        ):
            if after is not None:
                found.append(column >= after)
            if before is not None:
                found.append(column < before)
        if self.notes:
            found.append(contains(table.notes, self.notes))
        labels = JobMetadata if table is Job else DrawingMetadata
        for key, text in self.metadata.items():
            entry = sa.select(labels.owner).where(
                labels.token == _token(key, text), labels.owner == table.serial
            )
            found.append(entry.exists())
        return found


def contains(column: sa.SQLColumnExpression[str], text: str) -> sa.ColumnElement[bool]:
    """Return the condition that a column contains a text, in upper or lower case."""
    lowered = text.lower()
    for letter in sorted(set(lowered)):
        # SQLite's function ``lower`` changes ASCII letters only.
        if not letter.isascii() and len(letter.upper()) == 1:
            column = sa.func.replace(column, letter.upper(), letter, type_=sa.String)
    return column.icontains(lowered, autoescape=True)


def metadata_rows(table: type[Drawing] | type[Job], serial: int, extra: Details) -> list[Any]:
    """Return the rows by which a drawing or a job is found by its metadata.

    Parameters
    ----------
    table
        ``Drawing`` or ``Job``.
    serial
        Serial number of the drawing or the job.
    extra
        The metadata.
    """
    labels = JobMetadata if table is Job else DrawingMetadata
    return [
        labels(owner=serial, token=_token(key, value_text(value))) for key, value in extra.items()
    ]


def replace_metadata(
    session: Any, table: type[Drawing] | type[Job], serial: int, extra: Details
) -> None:
    """Replace the rows by which a drawing or a job is found by its metadata."""
    labels = JobMetadata if table is Job else DrawingMetadata
    session.execute(sa.delete(labels).where(labels.owner == serial))
    session.add_all(metadata_rows(table, serial, extra))


def value_text(value: Value) -> str:
    """Return a value of the metadata as text: a number without trailing zeros, true or false."""
    if isinstance(value, str):
        return value
    if isinstance(value, float) and value.is_integer() and abs(value) < 2**53:
        value = int(value)
    return json.dumps(value)


def _token(key: str, text: str) -> str:
    """Return a hash of a key and a value, since values are too long for an index."""
    return hashlib.sha256(f"{key}\0{text}".encode("utf-8", "replace")).hexdigest()[:40]
