"""tables: the rows that the store keeps, in SQLite or PostgreSQL.

Drawing ← Job, each with its Events; the customers' Profiles; and the Gateways that ask for work.
What is large is deferred: it is read only where it is asked for by name.
"""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column

#: Jobs that keep others from their machine: on its table, or claimed and waiting for the operator.
_RESERVES_TABLE = sa.text(
    "state IN ('running', 'held', 'interrupted') OR (state = 'queued' AND confirmation <> '')"
)
_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


class Base(DeclarativeBase):
    """All tables of knifetip."""


class Profile(Base):
    """A classification profile that a customer keeps, beside those that are shipped."""

    __tablename__ = "profile"

    name: Mapped[str] = mapped_column(sa.String(64), primary_key=True)
    title: Mapped[str] = mapped_column(sa.String(200))
    text: Mapped[str] = mapped_column(sa.Text)  #: TOML, as it came or as the page wrote it
    version: Mapped[int]  #: counts the changes, so that none is lost between two users
    created: Mapped[float] = mapped_column(sa.Double)
    updated: Mapped[float] = mapped_column(sa.Double)


class Drawing(Base):
    """A file that was read and classified."""

    __tablename__ = "drawing"

    serial: Mapped[int] = mapped_column(_SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    name: Mapped[str] = mapped_column(sa.String(200))
    created: Mapped[float] = mapped_column(sa.Double)
    sha256: Mapped[str] = mapped_column(sa.String(64))
    unit_given: Mapped[str] = mapped_column(sa.String(2))  #: by the user; empty: the file's own
    profile: Mapped[str] = mapped_column(sa.String(200))
    version: Mapped[int]  #: counts the changes, so that none is lost between two users
    #: TOML of the profile as it was when it classified this; empty where that is shipped
    rules: Mapped[str] = mapped_column(sa.Text, default="")
    #: what the page shows: unit, evidence, bounds, counts, layers, questions
    summary: Mapped[dict[str, Any]] = mapped_column(sa.JSON)
    key: Mapped[str | None] = mapped_column(sa.String(200), unique=True)  #: Idempotency-Key
    fingerprint: Mapped[str] = mapped_column(sa.String(64))  #: of the request under that key
    content: Mapped[bytes] = mapped_column(sa.LargeBinary, deferred=True)
    overrides: Mapped[bytes] = mapped_column(sa.LargeBinary, deferred=True)  #: (n,) 255 for none
    edges: Mapped[bytes] = mapped_column(sa.LargeBinary, deferred=True)  #: see ``columns``
    ledger: Mapped[bytes] = mapped_column(sa.LargeBinary, deferred=True)  #: JSON, deflated


class Job(Base):
    """An order, its program and where it stands."""

    __tablename__ = "job"
    __table_args__ = (
        sa.Index(
            "one_job_on_a_table",
            "machine",
            unique=True,
            sqlite_where=_RESERVES_TABLE,
            postgresql_where=_RESERVES_TABLE,
        ),
        sa.Index("job_by_state", "state", "machine"),
    )

    serial: Mapped[int] = mapped_column(_SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    state: Mapped[str] = mapped_column(sa.String(16))
    drawing: Mapped[str] = mapped_column(sa.ForeignKey("drawing.id"), index=True)
    drawing_name: Mapped[str] = mapped_column(sa.String(200))
    machine: Mapped[str] = mapped_column(sa.String(200))
    board: Mapped[str] = mapped_column(sa.String(200))
    profile: Mapped[str] = mapped_column(sa.String(200))
    #: TOML of the profile as it was when this was ordered; empty where that is shipped
    rules: Mapped[str] = mapped_column(sa.Text, default="")
    unit_given: Mapped[str] = mapped_column(sa.String(2))
    copies: Mapped[int]
    priority: Mapped[int]
    release: Mapped[bool]  #: queue it as soon as it is ready
    created: Mapped[float] = mapped_column(sa.Double)
    updated: Mapped[float] = mapped_column(sa.Double)
    queued: Mapped[float] = mapped_column(sa.Double)  #: when; 0 before
    reason: Mapped[str] = mapped_column(sa.Text)  #: why it was refused or interrupted
    hint: Mapped[str] = mapped_column(sa.Text)
    source: Mapped[list[str]] = mapped_column(sa.JSON)
    questions: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON)
    attempt: Mapped[int]  #: of the compile
    epoch: Mapped[int]  #: grows with each owner: what an earlier owner says is refused
    owner: Mapped[str] = mapped_column(sa.String(200))  #: the worker or gateway that has it
    lease: Mapped[float] = mapped_column(sa.Double)  #: until when it has it
    owner_epoch: Mapped[int] = mapped_column(default=0)  #: of the last gateway that claimed it
    #: what the operator must confirm under this claim: see ``Confirmation``
    confirmation: Mapped[str] = mapped_column(sa.String(8), default="")
    #: stations that the program uses, in their order: number, name, kind
    tools: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON, default=list)
    #: by the operator, of the gateway: hold, resume or cancel; empty when it is done
    requested_action: Mapped[str] = mapped_column(sa.String(8))
    stage: Mapped[str] = mapped_column(sa.String(80))
    progress: Mapped[float] = mapped_column(sa.Double)
    line: Mapped[int]
    lines: Mapped[int]
    copies_done: Mapped[int]
    copies_before: Mapped[int]  #: that were done under earlier owners
    position: Mapped[list[float] | None] = mapped_column(sa.JSON(none_as_null=True))
    seconds: Mapped[float] = mapped_column(sa.Double)
    seconds_left: Mapped[float | None] = mapped_column(sa.Double)
    program_sha256: Mapped[str] = mapped_column(sa.String(64))
    judged: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    key: Mapped[str | None] = mapped_column(sa.String(200), unique=True)
    fingerprint: Mapped[str] = mapped_column(sa.String(64))
    #: how a cutter goes round corners; None leaves it to the machine
    corners: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    overrides: Mapped[bytes] = mapped_column(sa.LargeBinary, deferred=True)
    program: Mapped[bytes | None] = mapped_column(sa.LargeBinary, deferred=True)
    toolpath: Mapped[bytes | None] = mapped_column(sa.LargeBinary, deferred=True)
    verdict: Mapped[bytes | None] = mapped_column(sa.LargeBinary, deferred=True)


class Event(Base):
    """Something that happened to a job or a drawing; rows are only ever added."""

    __tablename__ = "event"
    __table_args__ = (
        sa.Index("event_by_subject", "subject"),
        {"sqlite_autoincrement": True},
    )

    id: Mapped[int] = mapped_column(_SERIAL, primary_key=True, autoincrement=True)
    kind: Mapped[str] = mapped_column(sa.String(8))  #: job or drawing
    subject: Mapped[str] = mapped_column(sa.String(32))
    at: Mapped[float] = mapped_column(sa.Double)
    state: Mapped[str] = mapped_column(sa.String(16))
    who: Mapped[str] = mapped_column(sa.String(200))
    why: Mapped[str] = mapped_column(sa.Text)


class Gateway(Base):
    """A gateway and when it last asked for work."""

    __tablename__ = "gateway"

    machine: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    name: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    seen: Mapped[float] = mapped_column(sa.Double)
