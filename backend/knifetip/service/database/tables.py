"""Tables of the store in SQLite or PostgreSQL.

The tables contain drawings, jobs, events of drawings and jobs, profiles, machines, boards and tools
of users, gateways, and the stations of machines with the operations that persons request.  Those of
webhooks are in ``webhooks.tables``, those of users, keys and the audit log in
``account_tables``; the import of ``store`` adds them to the metadata of ``Base``.
Large values of drawings and jobs are in the table ``content``: see ``content.store``.
"""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import DeclarativeBase, Mapped, MappedColumn, mapped_column

from knifetip import tracing
from knifetip.contract.job import State
from knifetip.messages import Message
from knifetip.model.job_options import JobOptions
from knifetip.service.database.large_value import LargeValue
from knifetip.service.database.message_column import MessageColumn, MessagesColumn

#: Jobs that occupy their machine: on its table, or claimed and waiting for the operator.
_RESERVES_TABLE = sa.text(
    "state IN ('running', 'held', 'interrupted') OR (state = 'queued' AND confirmation <> '')"
)
#: Time of a statement that was never made, or that has ended (s).
NEVER_STATED = -1e9
#: Type of serial numbers.
SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
#: Key in ``Column.info`` of columns that a job does not take over from a job that it continues.
OWN = "own"


class Base(DeclarativeBase):
    """Base class of all tables."""


class DatabaseVersion(Base):
    """A migration of the database, with the version of knifetip that executed it."""

    __tablename__ = "database_version"

    id: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    version: Mapped[str] = mapped_column(sa.String(64))  #: of knifetip
    revision: Mapped[str] = mapped_column(sa.String(32))  #: of the tables after the migration
    at: Mapped[float] = mapped_column(sa.Double)  #: seconds since 1970


class WriteProbe(Base):
    """One row that health checks change, to check whether the database can be written to."""

    __tablename__ = "write_probe"

    id: Mapped[int] = mapped_column(primary_key=True)
    at: Mapped[float] = mapped_column(sa.Double)  #: seconds since 1970


class Profile(Base):
    """A classification profile of a customer."""

    __tablename__ = "profile"

    name: Mapped[str] = mapped_column(sa.String(64), primary_key=True)
    title: Mapped[str] = mapped_column(sa.String(200))
    text: Mapped[str] = mapped_column(sa.Text)  #: TOML
    version: Mapped[int]  #: increases with each change, for optimistic locking
    created: Mapped[float] = mapped_column(sa.Double)
    updated: Mapped[float] = mapped_column(sa.Double)


class LibraryEntry(Base):
    """A machine, a board or a tool of a user, with the number of its newest version."""

    __tablename__ = "library_entry"

    shelf: Mapped[str] = mapped_column(sa.String(16), primary_key=True)  #: see ``Shelf``
    name: Mapped[str] = mapped_column(sa.String(64), primary_key=True)
    version: Mapped[int]  #: increases with each change, also after a deletion


class LibraryVersion(Base):
    """A version of a machine, a board or a tool of a user; it is never changed or deleted."""

    __tablename__ = "library_version"

    shelf: Mapped[str] = mapped_column(sa.String(16), primary_key=True)
    name: Mapped[str] = mapped_column(sa.String(64), primary_key=True)
    version: Mapped[int] = mapped_column(primary_key=True)
    title: Mapped[str] = mapped_column(sa.String(200))
    text: Mapped[str] = mapped_column(sa.Text)  #: TOML
    at: Mapped[float] = mapped_column(sa.Double)
    by: Mapped[str] = mapped_column(sa.String(100))  #: who stored it; may be empty
    note: Mapped[str] = mapped_column(sa.String(200))  #: what was changed and why; may be empty


class Content(Base):
    """Bytes to which drawings and jobs refer by their SHA-256; never changed (ADR 94)."""

    __tablename__ = "content"

    address: Mapped[str] = mapped_column(sa.String(64), primary_key=True)  #: SHA-256 of the bytes
    #: time from which no drawing or job may refer to it; None: the last sweep found one that does
    unused_since: Mapped[float | None] = mapped_column(sa.Double, default=None)
    #: the bytes; None if they are in the folder or the bucket of the option --store
    data: Mapped[bytes | None] = mapped_column(sa.LargeBinary, deferred=True)


def _own_column(*arguments: Any, **options: Any) -> MappedColumn[Any]:
    """Declare a column of a job that another job which continues its work does not take over."""
    return mapped_column(*arguments, info={OWN: True}, **options)


def _address_column(*, own: bool = False) -> MappedColumn[str | None]:
    # The database finds what refers to a content by the index, before it deletes the content.
    declare = _own_column if own else mapped_column
    return declare(sa.ForeignKey("content.address"), index=True, default=None)


class Drawing(Base):
    """A stored drawing: its file, its interpretation, and the data that were read from it."""

    __tablename__ = "drawing"
    __table_args__ = (
        sa.Index("drawing_by_sha256", "sha256"),
        sa.Index("drawing_by_external_id", "external_id", "serial"),
        sa.Index("drawing_by_customer", "customer", "serial"),
        sa.Index("drawing_by_due", "due"),
        sa.Index("drawing_by_created", "created"),
        sa.Index("drawing_by_updated", "updated"),
    )

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    name: Mapped[str] = mapped_column(sa.String(200))
    created: Mapped[float] = mapped_column(sa.Double)
    sha256: Mapped[str] = mapped_column(sa.String(64))
    #: unit set by the user or learned; empty for the unit of the file
    unit_given: Mapped[str] = mapped_column(sa.String(8))
    #: names of the customer's files that gave ``unit_given``; empty if a user gave it
    unit_learned: Mapped[list[str]] = mapped_column(sa.JSON, default=list)
    profile: Mapped[str] = mapped_column(sa.String(200))
    version: Mapped[int]  #: increases with each change, for optimistic locking
    #: TOML of the profile at classification; empty for one of the library
    rules: Mapped[str] = mapped_column(sa.Text, default="")
    #: what earlier drawings of the customer taught, see ``customer_answers.learned_text``
    learned: Mapped[str] = mapped_column(sa.Text, default="")
    #: edits of the geometry, see ``model.edit``
    edits: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON, default=list)
    #: data for the page: unit, evidence, bounds, counts, layers, questions
    summary: Mapped[dict[str, Any]] = mapped_column(sa.JSON)
    #: ``RequestKey.stored`` of the request; None if it had no key
    key: Mapped[str | None] = mapped_column(sa.String(200), unique=True)
    fingerprint: Mapped[str] = mapped_column(sa.String(64))  #: hash of the request with that key
    updated: Mapped[float] = mapped_column(sa.Double, default=0.0)  #: time of the last change
    #: account that uploaded it, see ``acting``; empty for one that every designer changes
    owner: Mapped[str] = mapped_column(sa.String(80), default="")
    shared: Mapped[bool] = mapped_column(default=False)  #: every designer may change it
    #: a ``Layout``, from which the drawing was composed; None for an uploaded drawing
    layout: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    #: details of the order: see ``order_details``
    external_id: Mapped[str] = mapped_column(sa.String(200), default="")
    customer: Mapped[str] = mapped_column(sa.String(200), default="")
    due: Mapped[float | None] = mapped_column(sa.Double, default=None)  #: seconds since 1970
    notes: Mapped[str] = mapped_column(sa.Text, default="")
    extra: Mapped[dict[str, Any]] = mapped_column("metadata", sa.JSON, default=dict)
    content_address: Mapped[str | None] = _address_column()
    overrides_address: Mapped[str | None] = _address_column()
    edges_address: Mapped[str | None] = _address_column()
    import_report_address: Mapped[str | None] = _address_column()
    content = LargeValue()  #: the file
    overrides = LargeValue()  #: (n,) 255 for none
    edges = LargeValue()  #: packed ``EdgeTable``
    import_report = LargeValue()  #: JSON, deflated


class Job(Base):
    """A job with its program, state and progress."""

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
        sa.Index("job_by_state_serial", "state", "serial"),
        sa.Index("job_by_compile_key", "compile_key", "serial"),
        sa.Index("job_by_end", "ended", "serial"),
        sa.Index("job_by_external_id", "external_id", "serial"),
        sa.Index("job_by_customer", "customer", "serial"),
        sa.Index("job_by_due", "due"),
        sa.Index("job_by_created", "created"),
        sa.Index("job_by_updated", "updated"),
    )

    serial: Mapped[int] = _own_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = _own_column(sa.String(32), unique=True)
    state: Mapped[str] = _own_column(sa.String(16), default=State.RECEIVED)
    drawing: Mapped[str] = mapped_column(sa.ForeignKey("drawing.id"), index=True)
    drawing_name: Mapped[str] = mapped_column(sa.String(200))
    machine: Mapped[str] = mapped_column(sa.String(200))
    board: Mapped[str] = mapped_column(sa.String(200))
    #: versions for which it is compiled; 0 for entries of knifetip's library
    machine_version: Mapped[int] = mapped_column(default=0)
    board_version: Mapped[int] = mapped_column(default=0)
    profile: Mapped[str] = mapped_column(sa.String(200))
    #: TOML of the profile when the job was created; empty for one of the library
    rules: Mapped[str] = mapped_column(sa.Text, default="")
    #: what earlier drawings of the customer taught, see ``customer_answers.learned_text``
    learned: Mapped[str] = mapped_column(sa.Text, default="")
    #: edits of the geometry, see ``model.edit``
    edits: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON, default=list)
    unit_given: Mapped[str] = mapped_column(sa.String(8))
    copies: Mapped[int]
    priority: Mapped[int]
    release: Mapped[bool]  #: queue the job when it is ready
    created: Mapped[float] = _own_column(sa.Double)
    updated: Mapped[float] = _own_column(sa.Double)
    queued: Mapped[float] = _own_column(sa.Double, default=0.0)  #: time of queueing; 0 before
    #: orders the queued jobs of equal priority, see ``machine_queues.TURN``
    rank: Mapped[float] = _own_column(sa.Double, default=0.0)
    on_hold: Mapped[bool] = _own_column(default=False)  #: not claimed while it is True
    #: why the machine refused the program in its check run; not claimed while it is set
    check_refusal: Mapped[Message | None] = _own_column(MessageColumn)
    #: time at which the machine began the first copy; 0 before
    started: Mapped[float] = _own_column(sa.Double, default=0.0, server_default="0")
    #: time of the last move to one of the states ``job.ENDED``; 0 before
    ended: Mapped[float] = _own_column(sa.Double, default=0.0)
    #: why it was refused or interrupted, or why its compile has not begun
    message: Mapped[Message | None] = _own_column(MessageColumn)
    source: Mapped[list[str]] = _own_column(sa.JSON, default=list)
    #: rows of the edges of the drawing that the message concerns
    edges: Mapped[list[int]] = _own_column(sa.JSON, default=list)
    questions: Mapped[list[dict[str, Any]]] = _own_column(sa.JSON, default=list)
    attempt: Mapped[int] = _own_column(default=1)  #: number of compile attempts
    #: increases with each owner; reports of earlier owners are refused
    epoch: Mapped[int] = _own_column(default=0)
    #: worker or gateway that owns the job
    owner: Mapped[str] = _own_column(sa.String(200), default="")
    lease: Mapped[float] = _own_column(sa.Double, default=0.0)  #: expiry time of the lease
    #: epoch of the last gateway that claimed the job
    owner_epoch: Mapped[int] = _own_column(default=0)
    #: what the operator must confirm: see ``Confirmation``
    confirmation: Mapped[str] = _own_column(sa.String(8), default="")
    #: stations that the program uses, ordered by number: number, name, kind
    tools: Mapped[list[dict[str, Any]]] = _own_column(sa.JSON, default=list)
    #: requested by the operator: hold, resume or cancel; empty when done
    requested_action: Mapped[str] = _own_column(sa.String(8), default="")
    #: phase of the run that the gateway reported last: see ``GatewayReport.phase``
    phase: Mapped[int] = _own_column(default=0)
    stage: Mapped[str] = _own_column(sa.String(80), default="")
    progress: Mapped[float] = _own_column(sa.Double, default=0.0)
    line: Mapped[int] = _own_column(default=0)
    lines: Mapped[int] = _own_column(default=0)
    copies_done: Mapped[int] = _own_column(default=0)
    copies_before: Mapped[int] = _own_column(default=0)  #: copies completed under earlier owners
    position: Mapped[list[float] | None] = _own_column(sa.JSON(none_as_null=True))
    seconds: Mapped[float] = _own_column(sa.Double, default=0.0)
    seconds_left: Mapped[float | None] = _own_column(sa.Double)
    program_sha256: Mapped[str] = _own_column(sa.String(64), default="")
    verdict_summary: Mapped[dict[str, Any] | None] = _own_column(sa.JSON(none_as_null=True))
    #: the fields of ``ProgramFacts``
    facts: Mapped[dict[str, Any]] = _own_column(sa.JSON, default=dict, server_default="{}")
    #: hash of the input of an accepted program (see ``compiling.key``); empty if it was changed
    compile_key: Mapped[str] = _own_column(sa.String(64), default="")
    #: id of an earlier job with the same input whose program this job has; empty if compiled
    program_of: Mapped[str] = _own_column(sa.String(32), default="")
    key: Mapped[str | None] = _own_column(sa.String(200), unique=True)
    fingerprint: Mapped[str] = _own_column(sa.String(64))
    #: the fields of ``options``
    stored_options: Mapped[dict[str, Any]] = mapped_column("options", sa.JSON, default=dict)
    #: shortfalls that the order accepts: see ``model.acceptance.Exceptions``; None for none
    exceptions: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    #: id of the job whose work this one continues or makes again; None for none
    resumes: Mapped[str | None] = mapped_column(sa.String(32), index=True, default=None)
    #: the work that remains on the sheet of that job: see ``rest_record``; None for the whole
    rest: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    #: where the machine stopped a job that was cancelled or interrupted: line, position, station
    stopped_at: Mapped[dict[str, Any] | None] = _own_column(sa.JSON(none_as_null=True))
    #: account that ordered it, see ``acting``; empty for none
    ordered_by: Mapped[str] = _own_column(sa.String(80), default="")
    #: key of the gateway that claimed it last, see ``acting``; empty for none
    claimed_by: Mapped[str] = _own_column(sa.String(80), default="")
    feeds: Mapped[bool] = _own_column(default=False)  #: the machine feeds the sheets itself
    #: the program is handed over, and a person must confirm that the machine has executed it
    awaits_end: Mapped[bool] = _own_column(default=False)
    #: a line of the program may have been executed since the last claim
    begun: Mapped[bool] = _own_column(default=True)
    #: context of the trace of its order, for its compile and its run; empty for none
    traceparent: Mapped[str] = _own_column(sa.String(tracing.LENGTH), default="")
    #: details of the order: see ``order_details``
    external_id: Mapped[str] = mapped_column(sa.String(200), default="")
    customer: Mapped[str] = mapped_column(sa.String(200), default="")
    due: Mapped[float | None] = mapped_column(sa.Double, default=None)  #: seconds since 1970
    notes: Mapped[str] = mapped_column(sa.Text, default="")
    extra: Mapped[dict[str, Any]] = mapped_column("metadata", sa.JSON, default=dict)
    overrides_address: Mapped[str | None] = _address_column()
    program_address: Mapped[str | None] = _address_column(own=True)
    toolpath_address: Mapped[str | None] = _address_column(own=True)
    verdict_address: Mapped[str | None] = _address_column(own=True)
    overrides = LargeValue()  #: (n,) 255 for none
    program = LargeValue()
    toolpath = LargeValue()
    verdict = LargeValue()
    #: worked lengths by program line, see ``worked_lengths``
    lengths: Mapped[bytes | None] = _own_column(sa.LargeBinary, deferred=True)

    @property
    def options(self) -> JobOptions:
        """The options that the user chose for the job."""
        return JobOptions.model_validate(self.stored_options)


class TaughtDrawing(Base):
    """What a drawing teaches about the drawings of its customer; it outlives the drawing."""

    __tablename__ = "taught_drawing"
    __table_args__ = (sa.Index("taught_drawing_by_customer", "customer", "at"),)

    drawing: Mapped[str] = mapped_column(sa.String(32), primary_key=True)  #: id
    customer: Mapped[str] = mapped_column(sa.String(200))
    name: Mapped[str] = mapped_column(sa.String(200))  #: file name
    sha256: Mapped[str] = mapped_column(sa.String(64))  #: of the file
    at: Mapped[float] = mapped_column(sa.Double)  #: time of the last change
    unit: Mapped[str] = mapped_column(sa.String(8), default="")  #: that a user gave to the file
    uses: Mapped[list[dict[str, Any]]] = mapped_column(sa.JSON)  #: see ``customer_answers.LookUse``


class RefusedLook(Base):
    """A look for which a user has switched off the answers from a customer's earlier drawings."""

    __tablename__ = "refused_look"

    customer: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    token: Mapped[str] = mapped_column(sa.String(64), primary_key=True)  #: SHA-256 of the look
    look: Mapped[dict[str, Any]] = mapped_column(sa.JSON)  #: fields of ``customer_answers.Look``
    at: Mapped[float] = mapped_column(sa.Double)


class DrawingMetadata(Base):
    """A key and a value of the metadata of a drawing, by which it is found."""

    __tablename__ = "drawing_metadata"
    __table_args__ = (sa.Index("drawing_metadata_by_owner", "owner"),)

    token: Mapped[str] = mapped_column(sa.String(40), primary_key=True)  #: hash of key and value
    owner: Mapped[int] = mapped_column(
        SERIAL, sa.ForeignKey("drawing.serial", ondelete="CASCADE"), primary_key=True
    )


class JobMetadata(Base):
    """A key and a value of the metadata of a job, by which it is found."""

    __tablename__ = "job_metadata"
    __table_args__ = (sa.Index("job_metadata_by_owner", "owner"),)

    token: Mapped[str] = mapped_column(sa.String(40), primary_key=True)  #: hash of key and value
    owner: Mapped[int] = mapped_column(
        SERIAL, sa.ForeignKey("job.serial", ondelete="CASCADE"), primary_key=True
    )


class DrawingDocument(Base):
    """A large JSON answer about a drawing, which was made for one version of the drawing."""

    __tablename__ = "drawing_document"

    owner: Mapped[int] = mapped_column(
        SERIAL, sa.ForeignKey("drawing.serial", ondelete="CASCADE"), primary_key=True
    )
    kind: Mapped[str] = mapped_column(sa.String(40), primary_key=True)
    version: Mapped[str] = mapped_column(sa.String(200))  #: of the owner and of knifetip
    content: Mapped[bytes] = mapped_column(sa.LargeBinary)  #: JSON, gzip


class JobDocument(Base):
    """A large JSON answer about a job, which was made for one version of the job."""

    __tablename__ = "job_document"

    owner: Mapped[int] = mapped_column(
        SERIAL, sa.ForeignKey("job.serial", ondelete="CASCADE"), primary_key=True
    )
    kind: Mapped[str] = mapped_column(sa.String(40), primary_key=True)
    version: Mapped[str] = mapped_column(sa.String(200))  #: of the owner and of knifetip
    content: Mapped[bytes] = mapped_column(sa.LargeBinary)  #: JSON, gzip


class CommandKey(Base):
    """The Idempotency-Key of a command that was executed."""

    __tablename__ = "command_key"
    __table_args__ = (sa.Index("command_key_by_job", "job"),)

    key: Mapped[str] = mapped_column(sa.String(200), primary_key=True)  #: ``RequestKey.stored``
    fingerprint: Mapped[str] = mapped_column(sa.String(64))  #: hash of the command with that key
    job: Mapped[str] = mapped_column(sa.String(32), sa.ForeignKey("job.id", ondelete="CASCADE"))
    created: Mapped[float] = mapped_column(sa.Double)


class AnsweredRequest(Base):
    """A request with an Idempotency-Key, and its answer; kept for some days."""

    __tablename__ = "answered_request"
    __table_args__ = (sa.Index("answered_request_by_time", "created"),)

    key: Mapped[str] = mapped_column(sa.String(200), primary_key=True)  #: ``RequestKey.stored``
    fingerprint: Mapped[str] = mapped_column(sa.String(64))  #: hash of the request with that key
    created: Mapped[float] = mapped_column(sa.Double)
    status: Mapped[int]  #: HTTP status of the answer; 0 before it is known
    headers: Mapped[dict[str, str]] = mapped_column(sa.JSON)  #: of the answer
    body: Mapped[bytes] = mapped_column(sa.LargeBinary)


class Event(Base):
    """A change of a job or a drawing; rows are only appended."""

    __tablename__ = "event"
    __table_args__ = (
        sa.Index("event_by_subject", "subject"),
        {"sqlite_autoincrement": True},
    )

    id: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    kind: Mapped[str] = mapped_column(sa.String(8))  #: job or drawing
    subject: Mapped[str] = mapped_column(sa.String(32))
    at: Mapped[float] = mapped_column(sa.Double)
    state: Mapped[str] = mapped_column(sa.String(16))
    who: Mapped[str] = mapped_column(sa.String(200))
    message: Mapped[Message | None] = mapped_column(MessageColumn)  #: what happened


class Gateway(Base):
    """A gateway and the time of its last request."""

    __tablename__ = "gateway"

    machine: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    name: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    seen: Mapped[float] = mapped_column(sa.Double)


class MachineRun(Base):
    """A run of a job on a machine, from its start to its end; kept when the job is deleted."""

    __tablename__ = "machine_run"
    __table_args__ = (
        sa.UniqueConstraint("job", "epoch", name="one_run_of_a_claim"),
        sa.Index("run_by_end", "machine", "ended"),
        sa.Index("run_by_end_of_all", "ended"),
        sa.Index("run_by_machine", "machine", "id"),
    )

    id: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    job: Mapped[str] = mapped_column(sa.String(32))  #: id of the job
    epoch: Mapped[int]  #: epoch of the gateway's claim
    machine: Mapped[str] = mapped_column(sa.String(200))
    board: Mapped[str] = mapped_column(sa.String(200))
    started: Mapped[float] = mapped_column(sa.Double)
    ended: Mapped[float] = mapped_column(sa.Double)  #: 0 while the job is on the machine
    outcome: Mapped[str] = mapped_column(sa.String(16))  #: state of the job at the end of the run
    copies: Mapped[int]  #: copies completed in this run
    sheets: Mapped[int]  #: sheets used: those of the copies, and one that was begun


class RunLength(Base):
    """The length that one station worked in a run, for one line type."""

    __tablename__ = "run_length"

    run: Mapped[int] = mapped_column(
        sa.ForeignKey("machine_run.id", ondelete="CASCADE"), primary_key=True
    )
    station: Mapped[int] = mapped_column(primary_key=True)  #: number of the station
    line_type: Mapped[str] = mapped_column(sa.String(16), primary_key=True)
    length: Mapped[float] = mapped_column(sa.Double)  #: mm


class ToolWork(Base):
    """The length that a station has worked in all ended runs of a machine.

    It is a sum of the lengths of runs, so that no reader has to go through the history.
    """

    __tablename__ = "tool_work"

    machine: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    station: Mapped[int] = mapped_column(primary_key=True)  #: number of the station
    length: Mapped[float] = mapped_column(sa.Double)  #: mm


class ToolEvent(Base):
    """A change of a tool or of its life by a person; rows are only appended."""

    __tablename__ = "tool_event"
    __table_args__ = (sa.Index("tool_event_by_machine", "machine", "station"),)

    id: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    machine: Mapped[str] = mapped_column(sa.String(200))
    station: Mapped[int]  #: number of the station
    kind: Mapped[str] = mapped_column(sa.String(8))  #: "changed" (a new tool) or "life"
    at: Mapped[float] = mapped_column(sa.Double)
    who: Mapped[str] = mapped_column(sa.String(200))
    #: mm; of a changed tool the length that it had worked, otherwise the new life, 0 for no limit
    length: Mapped[float] = mapped_column(sa.Double)
    #: mm; of a changed tool the part of ``length`` in the run that was not finished then
    unfinished: Mapped[float] = mapped_column(sa.Double, default=0.0)
    #: mm; of a changed tool the length that its station had worked in the runs that had ended
    worked_before: Mapped[float] = mapped_column(sa.Double, default=0.0)


class Station(Base):
    """The last report of a gateway on its machine.

    Times are those of ``Database.timer``.
    """

    __tablename__ = "station"

    machine: Mapped[str] = mapped_column(sa.String(200), primary_key=True)
    gateway: Mapped[str] = mapped_column(sa.String(200), default="")
    reported: Mapped[float] = mapped_column(sa.Double, default=0.0)  #: time of the report
    watched: Mapped[float] = mapped_column(sa.Double, default=0.0)  #: last time a person looked
    #: last time a person stated that hands are clear, if the statement has not ended since
    hands_clear: Mapped[float] = mapped_column(sa.Double, default=NEVER_STATED)
    connected: Mapped[bool] = mapped_column(default=False)  #: the controller is connected
    state: Mapped[str] = mapped_column(sa.String(16), default="")  #: of the controller
    alarm: Mapped[Message | None] = mapped_column(MessageColumn)
    #: why the machine takes no job although it is connected and not locked; None if it is free
    obstacle: Mapped[Message | None] = mapped_column(MessageColumn)
    position: Mapped[list[float] | None] = mapped_column(sa.JSON(none_as_null=True))
    outputs: Mapped[list[int]] = mapped_column(sa.JSON, default=list)  #: outputs that are on
    outputs_known: Mapped[bool] = mapped_column(default=True)  #: all others are off
    operations: Mapped[list[str]] = mapped_column(sa.JSON, default=list)
    spindle: Mapped[int | None]  #: station whose spindle was switched on by hand; None for none
    override: Mapped[int | None]  #: feed override (%); None if the controller has none
    #: last run above the board, as the gateway reports it; None if there was none
    activity: Mapped[dict[str, Any] | None] = mapped_column(sa.JSON(none_as_null=True))
    #: why the controller is not connected, or harmless differences of its settings
    notices: Mapped[list[Message]] = mapped_column(MessagesColumn, default=list)


class Operation(Base):
    """An operation that a person at a machine has asked for; kept for a short time.

    Times are those of ``Database.timer``.
    """

    __tablename__ = "operation"
    __table_args__ = (sa.Index("operation_by_state", "machine", "state"),)

    serial: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    id: Mapped[str] = mapped_column(sa.String(32), unique=True)
    machine: Mapped[str] = mapped_column(sa.String(200))
    request: Mapped[dict[str, Any]] = mapped_column(sa.JSON)  #: name and arguments
    state: Mapped[str] = mapped_column(sa.String(8))  #: waiting, done, refused or expired
    message: Mapped[Message | None] = mapped_column(MessageColumn)
    asked: Mapped[float] = mapped_column(sa.Double)
    #: when it was given to the gateway, so that it is given only once
    handed: Mapped[float | None] = mapped_column(sa.Double)
    #: when the person last stated that the button of the jog is held; None for other operations
    renewed: Mapped[float | None] = mapped_column(sa.Double)
