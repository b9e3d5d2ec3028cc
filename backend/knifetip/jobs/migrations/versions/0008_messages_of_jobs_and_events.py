"""Store reasons of jobs and causes of events as messages instead of English text.

A text that was stored before becomes the message ``stored.text``.  A downgrade stores the English
text of each message.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import sqlalchemy as sa
from alembic import op

from knifetip.messages import from_json, hint, render
from knifetip.messages.codes import STORED

revision = "0008"
down_revision = "0007"
branch_labels = None
depends_on = None

_CHUNK = 1000  # rows per UPDATE
_MESSAGE = sa.JSON(none_as_null=True)
_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
_JOB = sa.table(
    "job",
    sa.column("serial", _SERIAL),
    sa.column("reason", sa.Text()),
    sa.column("hint", sa.Text()),
    sa.column("message", _MESSAGE),
)
_EVENT = sa.table(
    "event",
    sa.column("id", _SERIAL),
    sa.column("why", sa.Text()),
    sa.column("message", _MESSAGE),
)


def upgrade() -> None:
    for name in ("job", "event"):
        op.add_column(name, sa.Column("message", _MESSAGE, nullable=True))
    for rows in _chunks(sa.select(_JOB.c.serial, _JOB.c.reason, _JOB.c.hint), _JOB.c.serial):
        _update(
            _JOB,
            "serial",
            [
                {"key": serial, "message": _stored(reason, advice)}
                for serial, reason, advice in rows
                if reason or advice
            ],
        )
    for rows in _chunks(sa.select(_EVENT.c.id, _EVENT.c.why), _EVENT.c.id):
        _update(
            _EVENT, "id", [{"key": id, "message": _stored(why, "")} for id, why in rows if why]
        )
    op.drop_column("job", "reason")
    op.drop_column("job", "hint")
    op.drop_column("event", "why")


def downgrade() -> None:
    for name, column in (("job", "reason"), ("job", "hint"), ("event", "why")):
        op.add_column(name, sa.Column(column, sa.Text(), nullable=False, server_default=""))
    for rows in _chunks(sa.select(_JOB.c.serial, _JOB.c.message), _JOB.c.serial):
        _update(
            _JOB,
            "serial",
            [
                {
                    "key": serial,
                    "reason": render(from_json(message)),
                    "hint": hint(from_json(message)),
                }
                for serial, message in rows
                if message is not None
            ],
        )
    for rows in _chunks(sa.select(_EVENT.c.id, _EVENT.c.message), _EVENT.c.id):
        _update(
            _EVENT,
            "id",
            [
                {"key": id, "why": render(from_json(message))}
                for id, message in rows
                if message is not None
            ],
        )
    for name in ("job", "event"):
        op.drop_column(name, "message")


def _stored(text: str, advice: str) -> dict[str, object]:
    return {"code": STORED, "arguments": {"text": text, "hint": advice}}


def _chunks(
    query: sa.Select[Any], key: sa.ColumnElement[Any]
) -> Iterator[Sequence[Any]]:
    """Yield the rows of a query in chunks, ordered by their key."""
    last = -1
    while rows := op.get_bind().execute(query.where(key > last).order_by(key).limit(_CHUNK)).all():
        last = rows[-1][0]
        yield rows


def _update(table: sa.TableClause, key: str, rows: list[dict[str, object]]) -> None:
    """Set columns of rows; ``rows`` have the key as ``key`` and the columns by name."""
    if rows:
        names = rows[0].keys() - {"key"}
        statement = sa.update(table).where(table.c[key] == sa.bindparam("key"))
        values: dict[str, Any] = {name: sa.bindparam(name) for name in names}
        op.get_bind().execute(statement.values(values), rows)
