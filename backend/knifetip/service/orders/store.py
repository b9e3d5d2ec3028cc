"""Repository of jobs: store and find jobs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip import tracing
from knifetip.contract.job import (
    ADVICE,
    CONTINUABLE,
    OPERATOR,
    State,
    new_id,
)
from knifetip.errors import WrongState
from knifetip.messages import Message
from knifetip.model.acceptance import Exceptions
from knifetip.model.interpretation import Interpretation
from knifetip.service.content.store import ContentStore
from knifetip.service.database.acting import acting_limits, acting_owner
from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import OWN, Drawing, Job
from knifetip.service.drawings.interpretations import job_columns
from knifetip.service.drawings.store import unknown_drawing_error
from knifetip.service.lifecycle.transitions import Transitions, unknown_job_error
from knifetip.service.order_details.details import Details, DetailsFilter, metadata_rows
from knifetip.service.orders.remaining_copies import batch_of, remaining_copies
from knifetip.service.processes.rest_record import RestRecord

#: Priority of a job that continues a sheet: this sheet lies on the table.
_FIRST: Final = 100


@dataclass(frozen=True, slots=True)
class JobOrder:
    """Data of a new job, except its drawing: machine, board, interpretation and number of copies.

    The interpretation contains the user's decisions about the drawing, such as unit and profile.
    """

    machine: str
    board: str
    interpretation: Interpretation
    copies: int = 1
    priority: int = 0  #: jobs with a higher one are claimed first
    release: bool = False  #: queue the job when it is ready
    exceptions: Exceptions | None = None  #: shortfalls that the user accepts in advance
    machine_version: int = 0  #: version of a user's machine; 0 for one of the library
    board_version: int = 0  #: version of a user's board; 0 for one of the library
    details: Details = field(default_factory=dict)  #: columns of ``order_details``


@dataclass(frozen=True, slots=True)
class JobFilter:
    """Conditions on jobs; an empty value is no condition."""

    details: DetailsFilter = field(default_factory=DetailsFilter)
    drawing: str = ""  #: id of the drawing
    machine: str = ""
    board: str = ""

    def conditions(self) -> list[sa.ColumnElement[bool]]:
        """Return the conditions as SQL expressions."""
        found = self.details.conditions(Job)
        if self.drawing:
            found.append(Job.drawing == self.drawing)
        if self.machine:
            found.append(Job.machine == self.machine)
        if self.board:
            found.append(Job.board == self.board)
        return found


@dataclass(frozen=True, slots=True)
class Continuation:
    """Data of a new job that continues the work of another one, or makes it again."""

    rest: RestRecord | None  #: what remains on the sheet; None for the whole program again
    executed: int = 0  #: executed lines of the other job when ``rest`` was chosen
    copies: int | None = 1  #: None for those that remain of the batch: see ``remaining_copies``
    release: bool = False  #: queue the job when it is ready
    exceptions: Exceptions | None = None  #: shortfalls that the user accepted in the other job


class JobStore:
    """Repository of jobs: store and find jobs."""

    def __init__(
        self, database: Database, contents: ContentStore, transitions: Transitions
    ) -> None:
        self._db = database
        self._contents = contents
        self._transitions = transitions

    def add(
        self,
        drawing: Drawing,
        order: JobOrder,
        key: RequestKey | None = None,
    ) -> Job:
        """Store a new job in the state ``received`` and return it.

        Parameters
        ----------
        drawing
            Drawing of the job.
        order
            Machine, board, interpretation and number of copies.
        key
            Key of the request, None if it has none.  If a job was stored with this key, that job is
            returned and nothing is stored.

        Raises
        ------
        NotFound
            The drawing was deleted since it was read.
        KeyReused
            The key was used for a request with another content.
        AccessDenied
            The key of the sender is for other machines, or another customer.
        """
        limits = acting_limits()
        limits.check_machine(order.machine)
        details = limits.ordered_details(order.details)
        staged = self._contents.stage(overrides=order.interpretation.overrides)
        row = Job(
            **_new_columns(self._db.clock(), key),
            **staged.columns,
            drawing=drawing.id,
            drawing_name=drawing.name,
            machine=order.machine,
            board=order.board,
            machine_version=order.machine_version,
            board_version=order.board_version,
            **job_columns(order.interpretation),
            copies=order.copies,
            priority=order.priority,
            release=order.release,
            exceptions=None if order.exceptions is None else order.exceptions.as_json(),
            **details,
        )
        try:
            with self._db.writing() as session:
                self._contents.keep(session, staged)
                session.add(row)
                session.flush()  # assigns the serial number
                session.add_all(metadata_rows(Job, row.serial, row.extra or {}))
                event = Message("job.ordered")
                self._transitions.write_job_event(
                    session,
                    row.id,
                    State.RECEIVED,
                    OPERATOR,
                    event,
                    row.machine,
                    new_state=True,
                )
        except IntegrityError:
            if key is not None and (earlier := self.find(key)) is not None:
                return earlier
            self._require_drawing(drawing.id)
            raise
        return row

    def _require_drawing(self, id: str) -> None:
        """Raise ``NotFound`` if a drawing was deleted after it was read."""
        with self._db.reading() as session:
            if session.scalar(sa.select(Drawing.serial).where(Drawing.id == id)) is None:
                raise unknown_drawing_error(id)

    def add_continuation(
        self, parent: str, continuation: Continuation, key: RequestKey | None = None
    ) -> Job:
        """Store a new job that continues the work of another one, or makes it again; return it.

        It has the drawing, the machine, the board and the interpretation of the other job.

        Parameters
        ----------
        parent
            Id of the other job.
        continuation
            What the new job makes.  If it makes the remaining copies of a batch, ``parent`` may
            also be a job that made the rest of a sheet of the batch.
        key
            Key of the request, None if it has none.  If a job was stored with this key, that job is
            returned and nothing is stored.

        Raises
        ------
        NotFound
            There is no job with the id ``parent``.
        WrongState
            The other job has not ended its work, has no program, was executed further in the
            meantime, its sheet is continued by a third job, or no copy of its batch remains.
        KeyReused
            The key was used for a request with another content.
        """
        try:
            with self._db.writing() as session:
                before = self._transitions.lock(session, parent)
                if continuation.copies is None:
                    before = self._transitions.lock(session, batch_of(session, before))
                    continuation = self._with_remaining(session, before, continuation)
                self._check_continuable(session, before, continuation)
                own = _new_columns(self._db.clock(), key)
                row = Job(**own, **_continued_columns(before, continuation))
                session.add(row)
                session.flush()  # assigns the serial number
                session.add_all(metadata_rows(Job, row.serial, row.extra))
                whole = continuation.rest is None
                for id, state, event in (
                    (
                        before.id,
                        before.state,
                        Message("rest.whole-ordered" if whole else "rest.ordered", job=row.id),
                    ),
                    (
                        row.id,
                        State.RECEIVED,
                        Message("rest.copy-of" if whole else "rest.continues", job=before.id),
                    ),
                ):
                    self._transitions.write_job_event(
                        session, id, state, OPERATOR, event, new_state=id == row.id
                    )
        except IntegrityError:
            if key is None or (earlier := self.find(key)) is None:
                raise
            return earlier
        return row

    def remaining_copies(self, rows: Sequence[Job]) -> dict[str, int]:
        """Return the number of copies that remain to be ordered for each job (see the module)."""
        with self._db.reading() as session:
            return remaining_copies(session, rows)

    def _with_remaining(
        self, session: Session, row: Job, continuation: Continuation
    ) -> Continuation:
        """Return a continuation with the number of copies that remain of the batch ``row``.

        Raises ``WrongState``: the sheet of an interrupted job still occupies its table, or no copy
        remains.
        """
        if row.state == State.INTERRUPTED:
            raise WrongState("rest.sheet-first", job=row.id)
        copies = remaining_copies(session, [row]).get(row.id, 0)
        if not copies:
            raise WrongState("rest.no-copies", job=row.id, copies=row.copies)
        return replace(continuation, copies=copies)

    def _check_continuable(self, session: Session, row: Job, continuation: Continuation) -> None:
        """Raise ``WrongState`` unless a job may be continued by a new one."""
        if row.state not in CONTINUABLE or not row.lines:
            raise WrongState(
                "rest.wrong-state",
                job=row.id,
                state=row.state,
                advice=ADVICE[State(row.state)],
            )
        if continuation.rest is None:
            return
        if row.line != continuation.executed:
            raise WrongState("rest.line-changed", job=row.id, line=row.line)
        unused = sa.and_(Job.state.in_((State.REFUSED, State.CANCELLED)), Job.line == 0)
        later = session.scalar(
            sa.select(Job.id)
            .where(Job.resumes == row.id, Job.rest.is_not(None), sa.not_(unused))
            .limit(1)
        )
        if later is not None:
            raise WrongState("rest.continued-already", job=row.id, other=later)

    def find(self, key: RequestKey) -> Job | None:
        """Return the job that was stored with the key of a request, None if there is none.

        Raises
        ------
        KeyReused
            The key was used for a request with another content.
        """
        with self._db.reading() as session:
            row = session.scalar(sa.select(Job).where(Job.key == key.stored))
        return None if row is None else key.check(row)

    def get(self, id: str) -> Job:
        """Return the job with an id, without the program, the tool path and other large columns.

        Raises
        ------
        NotFound
            There is no job with this id.
        """
        with self._db.reading() as session:
            visible = acting_limits().job_conditions()
            row = session.scalar(sa.select(Job).where(Job.id == id, *visible))
        if row is None:
            raise unknown_job_error(id)
        return row

    def get_with(self, id: str, *columns: str) -> Job:
        """Return a job in which some of the large values are loaded.

        One query reads all of them, so that they belong together.

        Parameters
        ----------
        id
            Id of the job.
        *columns
            Names of the large values to load; see ``column``.

        Raises
        ------
        NotFound
            There is no job with this id.
        WrongState
            There is no such value: the job is not compiled yet, or it was refused.
        ContentLost
            A value is missing or altered.
        """
        row = self._contents.find(Job, Job.id == id, *columns)
        if row is None:
            raise unknown_job_error(id)
        for column in columns:
            if getattr(row, f"{column}_address") is None:
                raise WrongState("store.no-column", kind="job", id=id, column=column)
        return row

    def column(self, id: str, column: str) -> bytes:
        """Return a large value of a job.

        Parameters
        ----------
        id
            Id of the job.
        column
            ``overrides`` (line types that the user has set), ``program``, ``toolpath`` or
            ``verdict``.

        Raises
        ------
        NotFound
            There is no job with this id.
        WrongState
            There is none: the job is not compiled yet, or it was refused.
        ContentLost
            The value is missing or altered.
        """
        return self._contents.value(Job, id, column, "job")

    def search(
        self,
        states: Sequence[str] = (),
        before: int | None = None,
        limit: int = 100,
        ids: Sequence[str] | None = None,
        wanted: JobFilter | None = None,
    ) -> list[Job]:
        """Return the jobs that meet all conditions, newest first.

        Parameters
        ----------
        states
            States that the jobs may have; empty for all states.
        before
            Return only jobs with a smaller serial number; None for all.
        limit
            Greatest number of jobs.
        ids
            Ids of the jobs; None for all.
        wanted
            Further conditions; None for none.
        """
        query = sa.select(Job).order_by(Job.serial.desc()).limit(limit)
        query = query.where(*acting_limits().job_conditions())
        if states:
            query = query.where(Job.state.in_(states))
        if before is not None:
            query = query.where(Job.serial < before)
        if ids is not None:
            query = query.where(Job.id.in_(ids))
        if wanted is not None:
            query = query.where(*wanted.conditions())
        with self._db.reading() as session:
            return list(session.scalars(query))

    def last_with_exceptions(self, row: Job) -> Job | None:
        """Return the newest earlier job for the same file, unit, machine and board whose verdict
        has accepted shortfalls, None if there is none.
        """
        file = sa.select(Drawing.sha256).where(Drawing.id == row.drawing).scalar_subquery()
        query = (
            sa.select(Job)
            .where(
                Job.drawing.in_(sa.select(Drawing.id).where(Drawing.sha256 == file)),
                # A sum, so that SQLite finds the jobs by their drawings.
                Job.serial + 0 < row.serial,
                Job.unit_given == row.unit_given,
                Job.machine == row.machine,
                Job.board == row.board,
                Job.verdict_summary["exceptions"].as_integer() > 0,
                *acting_limits().job_conditions(),
            )
            .order_by((Job.serial + 0).desc())
            .limit(1)
        )
        with self._db.reading() as session:
            return session.scalar(query)


def _continued_columns(before: Job, continuation: Continuation) -> dict[str, Any]:
    """Return the columns that a job takes over from the job ``before``, which it continues.

    They have the changes that ``continuation`` contains.
    """
    rest, exceptions = continuation.rest, continuation.exceptions
    changed = {
        "resumes": before.id,
        "rest": None if rest is None else rest.as_json(),
        "copies": continuation.copies,
        "release": continuation.release,
        "priority": before.priority if rest is None else _FIRST,
        "exceptions": None if exceptions is None else exceptions.as_json(),
    }
    copied = {
        name: getattr(before, name)
        for name, column in sa.inspect(Job).columns.items()
        if not column.info.get(OWN)
    }
    if rest is None:
        # A new sheet lies elsewhere: its marks are measured again.
        changed["stored_options"] = before.options.with_measured(()).model_dump(mode="json")
    return copied | changed


def _new_columns(now: float, key: RequestKey | None) -> dict[str, Any]:
    """Return the columns of a new job that are no defaults: its id, and who orders it when.

    ``now``: present time (seconds since 1970).
    ``key``: key of the request, None if it has none.
    """
    return {
        "id": new_id(),
        "created": now,
        "updated": now,
        "ordered_by": acting_owner(),
        "traceparent": tracing.traceparent(),
        "key": None if key is None else key.stored,
        "fingerprint": "" if key is None else key.fingerprint,
    }
