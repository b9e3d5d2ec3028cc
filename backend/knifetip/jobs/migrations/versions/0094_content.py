"""Move the large values of drawings and jobs to the table content, by their SHA-256."""

import hashlib
from collections.abc import Iterator
from typing import Any

import sqlalchemy as sa
from alembic import op

revision = "0094"
down_revision = "0091"
branch_labels = None
depends_on = None

#: Columns that are moved, and whether they must have a value.
VALUES = {
    "drawing": {"content": True, "overrides": True, "edges": True, "import_report": True},
    "job": {"overrides": True, "program": False, "toolpath": False, "verdict": False},
}
#: Rows whose serial numbers are read at a time; large values of one row are in memory.
BATCH = 1000

CONTENT = sa.table(
    "content",
    sa.column("address", sa.String()),
    sa.column("unused_since", sa.Double()),
    sa.column("data", sa.LargeBinary()),
)


def upgrade() -> None:
    op.create_table(
        "content",
        sa.Column("address", sa.String(64), primary_key=True),
        sa.Column("unused_since", sa.Double(), nullable=True),
        sa.Column("data", sa.LargeBinary(), nullable=True),
    )
    for name, columns in VALUES.items():
        for column in columns:
            # SQLite adds a foreign key to a table only with its column.
            op.execute(
                f"ALTER TABLE {name} ADD COLUMN {column}_address VARCHAR(64) "
                "REFERENCES content (address)"
            )
        _move(name, columns)
        for column in columns:
            op.drop_column(name, column)
            op.create_index(f"ix_{name}_{column}_address", name, [f"{column}_address"])


def _move(name: str, columns: dict[str, bool]) -> None:
    """Move the values of a table to contents."""
    connection = op.get_bind()
    table = _table(name, columns)
    for serial in _serials(table):
        query = sa.select(*(table.c[column] for column in columns)).where(table.c.serial == serial)
        values = connection.execute(query).one()
        changes: dict[str, Any] = {}
        for (column, is_needed), data in zip(columns.items(), values, strict=True):
            if data is None:
                continue
            address = hashlib.sha256(data).hexdigest()
            present = sa.select(CONTENT.c.address).where(CONTENT.c.address == address)
            if connection.execute(present).first() is None:
                connection.execute(sa.insert(CONTENT).values(address=address, data=bytes(data)))
            # Emptied, since SQLite and PostgreSQL copy the bytes of dropped columns.
            changes |= {f"{column}_address": address, column: b"" if is_needed else None}
        connection.execute(sa.update(table).where(table.c.serial == serial).values(changes))


def downgrade() -> None:
    connection = op.get_bind()
    outside = sa.select(CONTENT.c.address).where(CONTENT.c.data.is_(None)).limit(1)
    if connection.execute(outside).first() is not None:
        raise RuntimeError("contents are in a folder or a bucket, which older versions cannot read")
    for name, columns in VALUES.items():
        for column, is_needed in columns.items():
            op.drop_index(f"ix_{name}_{column}_address", name)
            empty = sa.text("''") if is_needed else None
            op.add_column(
                name,
                sa.Column(column, sa.LargeBinary(), nullable=not is_needed, server_default=empty),
            )
            table = _table(name, columns)
            address = table.c[f"{column}_address"]
            data = sa.select(CONTENT.c.data).where(CONTENT.c.address == address)
            connection.execute(
                sa.update(table)
                .where(address.is_not(None))
                .values({column: data.scalar_subquery()})
            )
            op.drop_column(name, f"{column}_address")
    op.drop_table("content")


def _table(name: str, columns: dict[str, bool]) -> sa.TableClause:
    return sa.table(
        name,
        sa.column("serial", sa.BigInteger()),
        *(sa.column(column, sa.LargeBinary()) for column in columns),
        *(sa.column(f"{column}_address", sa.String()) for column in columns),
    )


def _serials(table: sa.TableClause) -> Iterator[Any]:
    """Yield the serial numbers of the rows of a table in their order."""
    connection = op.get_bind()
    last = -1
    query = sa.select(table.c.serial).order_by(table.c.serial).limit(BATCH)
    while found := connection.execute(query.where(table.c.serial > last)).scalars().all():
        yield from found
        last = found[-1]
