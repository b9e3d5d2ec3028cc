"""store: the database of drawings, jobs, events and gateways, in SQLite or PostgreSQL.

"sqlite:///knifetip.sqlite" -> Store

Every move of a job is one UPDATE … WHERE state = … in one transaction with the event that records
it.  Two who want the same job, or two jobs that want the same table, are parted by the database:
by that WHERE, by the job's epoch, and by a unique index on the machine of the jobs on a table.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from sqlalchemy import event as on
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from knifetip.errors import KeyReused, MachineBusy, NoSuchJob, StaleEpoch, StoreError, WrongState
from knifetip.jobs.job import LEASED, ON_TABLE, State, Who, new_id, sources
from knifetip.jobs.tables import Drawing, Event, Gateway, Job

LEASE = 10.0  #: seconds that a gateway or a worker may be silent
ATTEMPTS = 5  #: compiles that may die under a job before it is refused
_MIGRATIONS = Path(__file__).parent / "migrations"
_MIGRATING = 0x6B6E_6966  # PostgreSQL's advisory lock of the migration


@dataclass(frozen=True, slots=True)
class Result:
    """What a compile hands to the store."""

    accepted: bool
    reason: str  #: of a refusal
    program: bytes
    sha256: str
    lines: int
    toolpath: bytes  #: see ``columns``
    verdict: bytes  #: see ``columns``
    judged: dict[str, Any]  #: the verdict in four figures
    source: list[str] = field(default_factory=list)


def _sqlite(engine: sa.Engine) -> None:
    @on.listens_for(engine, "connect")
    def connect(connection: Any, _record: object) -> None:
        # Transactions are begun below: left to itself the driver begins them only before the
        # first write, so that what was read may no longer be true when it is acted upon.
        connection.isolation_level = None
        connection.execute("PRAGMA busy_timeout=30000")
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
        connection.execute("PRAGMA foreign_keys=ON")

    @on.listens_for(engine, "begin")
    def begin(connection: sa.Connection) -> None:
        writes = connection.get_execution_options().get("writes", False)
        connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


def _check(url: str) -> None:
    try:
        parts = sa.make_url(url)
        backend = parts.get_backend_name()
    except sa.exc.ArgumentError:
        backend = ""
    if backend not in ("sqlite", "postgresql"):
        raise StoreError(
            f"{url!r} is not the URL of a database.",
            "It is sqlite:///FILE or postgresql://USER@HOST/NAME.",
        )
    if backend == "sqlite":
        if parts.database in (None, "", ":memory:"):
            raise StoreError(
                "A database in memory would forget its jobs.", "Name a file: sqlite:///FILE."
            )
        Path(parts.database).parent.mkdir(parents=True, exist_ok=True)


def dialect_url(url: str) -> str:
    """Return the URL with the driver that is installed: psycopg for PostgreSQL."""
    for scheme in ("postgresql://", "postgres://"):
        if url.startswith(scheme):
            return "postgresql+psycopg://" + url.removeprefix(scheme)
    return url


class Store:
    """The database; safe to use from many threads and from many processes."""

    def __init__(self, url: str, clock: Callable[[], float] = time.time) -> None:
        self.url = dialect_url(url)
        self.clock = clock
        _check(self.url)
        self._engine = sa.create_engine(self.url, pool_size=10, max_overflow=40)
        if self._engine.dialect.name == "sqlite":
            _sqlite(self._engine)
        self._writer = self._engine.execution_options(writes=True)

    def migrate(self) -> None:
        """Bring the tables to the newest form, from none at all if need be."""
        settings = Config()
        settings.set_main_option("script_location", str(_MIGRATIONS).replace("%", "%%"))
        with self._writer.begin() as connection:
            if connection.dialect.name == "postgresql":
                connection.execute(sa.select(sa.func.pg_advisory_xact_lock(_MIGRATING)))
            settings.attributes["connection"] = connection
            command.upgrade(settings, "head")

    def close(self) -> None:
        """Close all connections."""
        self._engine.dispose()

    @contextmanager
    def _reading(self) -> Iterator[Session]:
        with Session(self._engine, expire_on_commit=False) as session:
            yield session

    @contextmanager
    def _writing(self) -> Iterator[Session]:
        with Session(self._writer, expire_on_commit=False) as session, session.begin():
            yield session

    def alive(self) -> bool:
        """Return True if the database answers."""
        with self._reading() as session:
            return bool(session.scalar(sa.select(sa.literal(1))))

    # Drawings

    def add_drawing(
        self,
        *,
        name: str,
        content: bytes,
        sha256: str,
        unit_given: str,
        profile: str,
        overrides: bytes,
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
            unit_given=unit_given,
            profile=profile,
            version=1,
            summary=summary,
            key=key,
            fingerprint=fingerprint,
            content=content,
            overrides=overrides,
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
        """Return the drawing that a request with this Idempotency-Key made, or None."""
        with self._reading() as session:
            row = session.scalar(sa.select(Drawing).where(Drawing.key == key))
        return None if row is None else _same_request(row, key, fingerprint)

    def drawing(self, id: str) -> Drawing:
        """Return a drawing without its large columns."""
        with self._reading() as session:
            row = session.scalar(sa.select(Drawing).where(Drawing.id == id))
        if row is None:
            raise NoSuchJob(f"There is no drawing {_short(id)}.", "GET /api/drawings lists them.")
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
        """Change a drawing that is still as it was at ``version``.

        Raises
        ------
        WrongState
            Somebody else changed it in between.
        """
        with self._writing() as session:
            changed = _rows(
                session,
                sa.update(Drawing)
                .where(Drawing.id == id, Drawing.version == version)
                .values(version=version + 1, **changes),
            )
            if not changed:
                raise WrongState(
                    f"Drawing {id} was changed by somebody else at the same moment.", "Try again."
                )
            self._note(session, "drawing", id, "changed", str(Who.OPERATOR), why)
        return self.drawing(id)

    def delete_drawing(self, id: str) -> None:
        """Forget a drawing that no job was made from."""
        self.drawing(id)
        with self._writing() as session:
            if used := session.scalar(sa.select(Job.id).where(Job.drawing == id).limit(1)):
                raise WrongState(
                    f"Job {used} was made from drawing {id}, so it is kept as its record.",
                    "Only drawings without jobs can be deleted.",
                )
            session.execute(sa.delete(Drawing).where(Drawing.id == id))
            self._note(session, "drawing", id, "deleted", str(Who.OPERATOR), "")

    # Jobs

    def add_job(
        self,
        drawing: Drawing,
        *,
        machine: str,
        board: str,
        profile: str,
        overrides: bytes,
        copies: int = 1,
        priority: int = 0,
        release: bool = False,
        key: str | None = None,
        fingerprint: str = "",
    ) -> Job:
        """Keep an order as ``received``; the same key gives the job that it first made.

        Raises
        ------
        WrongState
            The key was used for another request.
        """
        now = self.clock()
        row = Job(
            id=new_id(),
            state=State.RECEIVED.value,
            drawing=drawing.id,
            drawing_name=drawing.name,
            machine=machine,
            board=board,
            profile=profile,
            unit_given=drawing.unit_given,
            copies=copies,
            priority=priority,
            release=release,
            created=now,
            updated=now,
            queued=0.0,
            reason="",
            mend="",
            source=[],
            questions=[],
            attempt=1,
            epoch=0,
            owner="",
            lease=0.0,
            wish="",
            stage="",
            progress=0.0,
            line=0,
            lines=0,
            copies_done=0,
            copies_before=0,
            position=None,
            seconds=0.0,
            seconds_left=None,
            program_sha256="",
            judged=None,
            key=key,
            fingerprint=fingerprint,
            overrides=overrides,
            program=None,
            toolpath=None,
            verdict=None,
        )
        try:
            with self._writing() as session:
                session.add(row)
                self._note(session, "job", row.id, State.RECEIVED, str(Who.OPERATOR), "ordered")
        except IntegrityError:
            if key is None or (earlier := self.job_of(key, fingerprint)) is None:
                raise
            return earlier
        return row

    def job_of(self, key: str, fingerprint: str) -> Job | None:
        """Return the job that a request with this Idempotency-Key made, or None."""
        with self._reading() as session:
            row = session.scalar(sa.select(Job).where(Job.key == key))
        return None if row is None else _same_request(row, key, fingerprint)

    def job(self, id: str) -> Job:
        """Return a job without its large columns."""
        with self._reading() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id))
        if row is None:
            raise NoSuchJob(f"There is no job {_short(id)}.", "GET /api/jobs lists them.")
        return row

    def job_column(self, id: str, column: str) -> bytes:
        """Return one of a job's large columns: overrides, program, toolpath or verdict.

        Raises
        ------
        WrongState
            The job has none yet, or was refused before it had one.
        """
        return self._column(Job, id, column, "job")

    def jobs(
        self,
        states: Sequence[str] = (),
        before: int | None = None,
        limit: int = 100,
        ids: Sequence[str] | None = None,
    ) -> list[Job]:
        """Return jobs in any of these states (all, if none is named), the newest first."""
        query = sa.select(Job).order_by(Job.serial.desc()).limit(limit)
        if states:
            query = query.where(Job.state.in_(states))
        if before is not None:
            query = query.where(Job.serial < before)
        if ids is not None:
            query = query.where(Job.id.in_(ids))
        with self._reading() as session:
            return list(session.scalars(query))

    def events_of(self, id: str) -> list[Event]:
        """Return all that happened to a job, in order."""
        self.job(id)
        with self._reading() as session:
            return list(
                session.scalars(sa.select(Event).where(Event.subject == id).order_by(Event.id))
            )

    def events_after(self, last: int, limit: int = 1000) -> list[Event]:
        """Return what happened after an event, in order."""
        query = sa.select(Event).where(Event.id > last).order_by(Event.id).limit(limit)
        with self._reading() as session:
            return list(session.scalars(query))

    def last_event(self) -> int:
        """Return the id of the newest event, 0 if nothing ever happened."""
        with self._reading() as session:
            return session.scalar(sa.select(sa.func.max(Event.id))) or 0

    # What an operator does

    def release(self, id: str) -> Job:
        """Queue a job that is ready."""
        with self._writing() as session:
            self._move(
                session,
                id,
                State.QUEUED,
                Who.OPERATOR,
                "released",
                only=(State.READY,),
                queued=self.clock(),
            )
        return self.job(id)

    def requeue(self, id: str) -> Job:
        """Queue an interrupted job again: the operator has seen to the table."""
        with self._writing() as session:
            self._move(
                session,
                id,
                State.QUEUED,
                Who.OPERATOR,
                "queued again",
                only=(State.INTERRUPTED,),
                queued=self.clock(),
                line=0,
                position=None,
                reason="",
                mend="",
                wish="",
                seconds_left=None,
            )
        return self.job(id)

    def scrap(self, id: str) -> Job:
        """Give an interrupted job up: its table is free again."""
        with self._writing() as session:
            self._move(session, id, State.SCRAPPED, Who.OPERATOR, "scrapped", wish="")
        return self.job(id)

    def hold(self, id: str) -> Job:
        """Ask the gateway to hold; the job is ``held`` when the machine stands."""
        return self._wish(id, "hold", (State.RUNNING,), already=State.HELD)

    def resume(self, id: str) -> Job:
        """Ask the gateway to go on."""
        return self._wish(id, "resume", (State.HELD, State.RUNNING))

    def cancel(self, id: str) -> Job:
        """Cancel a job: at once before it runs, by its gateway while it does."""
        before = sources(State.CANCELLED, Who.OPERATOR)
        with self._writing() as session:
            state = session.scalar(sa.select(Job.state).where(Job.id == id).with_for_update())
            if state in before or state not in LEASED:
                self._move(session, id, State.CANCELLED, Who.OPERATOR, "cancelled", stage="")
                return self._fresh(session, id)
        return self._wish(id, "cancel", LEASED)

    def _wish(
        self, id: str, wish: str, states: Sequence[State], already: State | None = None
    ) -> Job:
        with self._writing() as session:
            row = self._fresh(session, id)
            if row.state != already and row.wish != wish:
                changed = _rows(
                    session,
                    sa.update(Job)
                    .where(Job.id == id, Job.state.in_(states), Job.wish != "cancel")
                    .values(wish=wish, updated=self.clock()),
                )
                if not changed and row.wish == "cancel":
                    raise WrongState(
                        f"Job {id} is being cancelled, so it cannot {wish}.",
                        "Wait until the machine stands.",
                    )
                if not changed:
                    raise WrongState(
                        f"Job {id} is {row.state}, and {wish} is for a job that is "
                        f"{' or '.join(states)}.",
                        _mend(row.state),
                    )
                self._note(session, "job", id, row.state, str(Who.OPERATOR), f"asked to {wish}")
        return self.job(id)

    # What a compile worker does

    def begin_compile(self, id: str, attempt: int, worker: str) -> Job | None:
        """Take a received job, or one whose worker died under this same attempt.

        None if the job has gone on without this attempt: cancelled, or given to another.
        """
        with self._writing() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id).with_for_update())
            if row is None or row.attempt != attempt:
                return None
            if row.state not in (State.RECEIVED, State.COMPILING):
                return None
            again = row.state == State.COMPILING
            if again:
                row.epoch += 1
                row.lease = self.clock() + LEASE
                row.owner = worker
                row.updated = self.clock()
                self._note(
                    session, "job", id, State.COMPILING, f"{Who.WORKER} {worker}", "taken up again"
                )
            else:
                self._move(
                    session,
                    id,
                    State.COMPILING,
                    Who.WORKER,
                    f"attempt {attempt}",
                    name=worker,
                    epoch=row.epoch,
                    changes_epoch=row.epoch + 1,
                    owner=worker,
                    lease=self.clock() + LEASE,
                    stage="read",
                    progress=0.0,
                )
        return self.job(id)

    def compile_progress(self, id: str, epoch: int, stage: str, progress: float) -> bool:
        """Say how far a compile is and renew its lease; False when the job is no longer ours."""
        with self._writing() as session:
            return bool(
                _rows(
                    session,
                    sa.update(Job)
                    .where(Job.id == id, Job.state == State.COMPILING, Job.epoch == epoch)
                    .values(stage=stage[:80], progress=progress, lease=self.clock() + LEASE),
                )
            )

    def compiled(self, id: str, epoch: int, result: Result) -> None:
        """Keep what a compile made: ready (and queued, if that was ordered) or refused."""
        kept: dict[str, Any] = {
            "program": result.program,
            "program_sha256": result.sha256,
            "lines": result.lines,
            "toolpath": result.toolpath,
            "verdict": result.verdict,
            "judged": result.judged,
            "seconds": result.judged["seconds"],
            "stage": "",
            "progress": 1.0,
            "owner": "",
            "lease": 0.0,
        }
        with self._writing() as session:
            if not result.accepted:
                self._move(
                    session,
                    id,
                    State.REFUSED,
                    Who.WORKER,
                    result.reason,
                    epoch=epoch,
                    reason=result.reason,
                    source=result.source,
                    mend="Change the drawing, the line types or the board; nothing was cut.",
                    **kept,
                )
                return
            self._move(session, id, State.READY, Who.WORKER, "verified", epoch=epoch, **kept)
            if session.scalar(sa.select(Job.release).where(Job.id == id)):
                self._move(
                    session,
                    id,
                    State.QUEUED,
                    Who.WORKER,
                    "released by its order",
                    queued=self.clock(),
                )

    def refuse(
        self,
        id: str,
        epoch: int,
        reason: str,
        mend: str,
        source: Sequence[str] = (),
        questions: Sequence[dict[str, Any]] = (),
    ) -> None:
        """Refuse a job that could not be compiled."""
        with self._writing() as session:
            self._move(
                session,
                id,
                State.REFUSED,
                Who.WORKER,
                reason,
                epoch=epoch,
                reason=reason,
                mend=mend,
                source=list(source),
                questions=list(questions),
                stage="",
                owner="",
                lease=0.0,
            )

    def give_back(self, id: str, epoch: int) -> None:
        """Return a job whose compile was broken off, so that it is tried again."""
        with self._writing() as session:
            attempt = self._fresh(session, id).attempt
            self._move(
                session,
                id,
                State.RECEIVED,
                Who.WORKER,
                "broken off",
                epoch=epoch,
                attempt=attempt + 1,
                stage="",
                progress=0.0,
                owner="",
                lease=0.0,
            )

    # What a gateway does

    def saw_gateway(self, machine: str, name: str) -> None:
        """Note that a gateway asked for work."""
        with self._writing() as session:
            session.merge(Gateway(machine=machine, name=name, seen=self.clock()))

    def connected(self, within: float) -> set[str]:
        """Return the machines whose gateway was heard within so many seconds."""
        now = self.clock()
        asking = sa.select(Gateway.machine).where(Gateway.seen > now - within)
        working = sa.select(Job.machine).where(Job.state.in_(LEASED), Job.lease > now)
        with self._reading() as session:
            return {*session.scalars(asking), *session.scalars(working)}

    def on_table(self) -> dict[str, str]:
        """Return the job on each machine's table."""
        query = sa.select(Job.machine, Job.id).where(Job.state.in_(ON_TABLE))
        with self._reading() as session:
            return {row.machine: row.id for row in session.execute(query)}

    def claim(self, machine: str, gateway: str) -> Job | None:
        """Give the next queued job of a machine to a gateway, or None if there is none.

        ``running`` is committed when this returns, before a byte goes to the controller.

        Raises
        ------
        MachineBusy
            Another job is on the table of this machine.
        """
        following = (
            sa.select(Job)
            .where(Job.machine == machine, Job.state == State.QUEUED)
            .order_by(Job.priority.desc(), Job.queued, Job.serial)
            .limit(1)
        )
        with self._reading() as session:
            if session.scalar(following) is None:
                return None
        try:
            with self._writing() as session:
                row = session.scalar(following.with_for_update(skip_locked=True))
                if row is None:
                    return None
                id = row.id
                self._move(
                    session,
                    id,
                    State.RUNNING,
                    Who.GATEWAY,
                    "claimed",
                    name=gateway,
                    epoch=row.epoch,
                    changes_epoch=row.epoch + 1,
                    owner=gateway,
                    lease=self.clock() + LEASE,
                    wish="",
                    line=0,
                    position=None,
                    copies_before=row.copies_done,
                )
        except IntegrityError as reason:
            other = self.on_table().get(machine, "another job")
            raise MachineBusy(
                f"Job {other} is on the table of {machine}.",
                "One job at a time: finish it, queue it again or scrap it.",
            ) from reason
        return self.job(id)

    def heartbeat(
        self,
        id: str,
        epoch: int,
        *,
        line: int,
        copies_done: int = 0,
        held: bool = False,
        position: Sequence[float] | None = None,
        seconds_left: float | None = None,
    ) -> str:
        """Take a gateway's word, renew its lease and say what the operator wants.

        Returns
        -------
        str
            ``continue``, ``hold``, ``resume`` or ``cancel``.

        Raises
        ------
        StaleEpoch
            The job is no longer this gateway's: stop the machine.
        """
        with self._writing() as session:
            row = self._fresh(session, id)
            if row.epoch != epoch or row.state not in LEASED:
                raise _stale(id, row.state, row.epoch, epoch)
            heard: dict[str, Any] = {
                "line": min(line, row.lines),
                "copies_done": min(row.copies_before + copies_done, row.copies),
                "position": None if position is None else list(position),
                "seconds_left": seconds_left,
                "lease": self.clock() + LEASE,
            }
            new_copy = held and heard["copies_done"] > row.copies_done
            wish = row.wish
            # A wish to go on is spent by going on: it must not start the copy after the next.
            if wish == ("hold" if held else "resume") or (new_copy and wish == "resume"):
                wish = ""
            heard["wish"] = wish
            goal = State.HELD if held else State.RUNNING
            why = f"at line {line}"
            if new_copy:
                done = f"copy {heard['copies_done']} of {row.copies} is done"
                why = f"{done}: put a new sheet on the table"
            if goal != row.state:
                self._move(
                    session, id, goal, Who.GATEWAY, why, name=row.owner, epoch=epoch, **heard
                )
            else:
                session.execute(sa.update(Job).where(Job.id == id).values(**heard))
                if new_copy:
                    self._note(session, "job", id, goal, f"{Who.GATEWAY} {row.owner}", why)
        return wish or "continue"

    def finish(self, id: str, epoch: int, outcome: str, why: str) -> Job:
        """Take a gateway's word for how a job ended; to say it twice does no harm.

        Raises
        ------
        StaleEpoch
            The job is no longer this gateway's.
        """
        goal = State(outcome)
        with self._writing() as session:
            row = self._fresh(session, id)
            if row.epoch == epoch and row.state == goal:
                return row
            if row.epoch != epoch or row.state not in LEASED:
                raise _stale(id, row.state, row.epoch, epoch)
            ended: dict[str, Any] = {"wish": "", "lease": 0.0, "seconds_left": None}
            if goal is State.DONE:
                ended |= {"line": row.lines, "copies_done": row.copies, "seconds_left": 0.0}
            if goal is State.INTERRUPTED:
                ended |= {
                    "reason": why or f"The gateway gave up at line {row.line}.",
                    "mend": _mend(State.INTERRUPTED),
                }
            self._move(
                session, id, goal, Who.GATEWAY, why or outcome, name=row.owner, epoch=epoch, **ended
            )
        return self.job(id)

    # What the clock does

    def sweep(self, patience: float = 2.0) -> list[tuple[str, int]]:
        """Take back what silent owners had; return the jobs that wait for a worker.

        A job on a table becomes ``interrupted``, never ``queued``.  A compile is tried again.

        Returns
        -------
        list of (job, attempt)
            Received more than ``patience`` seconds ago, and still not begun.
        """
        now = self.clock()
        silent = sa.select(Job.id).where(Job.state.in_((*LEASED, State.COMPILING)), Job.lease < now)
        with self._reading() as session:
            ids = list(session.scalars(silent))
        for id in ids:
            self._take_back(id, now)
        waiting = sa.select(Job.id, Job.attempt).where(
            Job.state == State.RECEIVED, Job.updated < now - patience
        )
        with self._reading() as session:
            return [(id, attempt) for id, attempt in session.execute(waiting)]

    def _take_back(self, id: str, now: float) -> None:
        with self._writing() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id).with_for_update())
            if row is None or row.lease >= now:
                return
            if row.state in LEASED:
                why = f"The gateway {row.owner} fell silent at line {row.line} of {row.lines}."
                self._move(
                    session,
                    id,
                    State.INTERRUPTED,
                    Who.CLOCK,
                    why,
                    epoch=row.epoch,
                    changes_epoch=row.epoch + 1,
                    reason=why,
                    mend=_mend(State.INTERRUPTED),
                    seconds_left=None,
                    wish="",
                )
            elif row.state == State.COMPILING and row.attempt < ATTEMPTS:
                self._move(
                    session,
                    id,
                    State.RECEIVED,
                    Who.CLOCK,
                    f"The worker {row.owner} fell silent in stage {row.stage}.",
                    epoch=row.epoch,
                    attempt=row.attempt + 1,
                    stage="",
                    progress=0.0,
                )
            elif row.state == State.COMPILING:
                why = f"{ATTEMPTS} compiles of it died, the last in stage {row.stage}."
                self._move(
                    session,
                    id,
                    State.REFUSED,
                    Who.CLOCK,
                    why,
                    epoch=row.epoch,
                    reason=why,
                    mend="Send a smaller drawing, or show us this one.",
                    stage="",
                )

    # Beneath all of them

    def _move(
        self,
        session: Session,
        id: str,
        goal: State,
        who: Who,
        why: str,
        *,
        name: str = "",
        epoch: int | None = None,
        only: tuple[State, ...] = (),
        changes_epoch: int | None = None,
        **changes: Any,
    ) -> None:
        """Move a job, if it is where such a move begins, and write the event beside it.

        Raises
        ------
        NoSuchJob, WrongState, StaleEpoch
            It was not moved.
        """
        statement = sa.update(Job).where(Job.id == id, Job.state.in_(only or sources(goal, who)))
        if epoch is not None:
            statement = statement.where(Job.epoch == epoch)
        if changes_epoch is not None:
            changes["epoch"] = changes_epoch
        # Rows that were read in this session keep what they said: the caller reads afresh.
        statement = statement.execution_options(synchronize_session=False)
        values = {"state": goal.value, "updated": self.clock(), **changes}
        if not _rows(session, statement.values(**values)):
            raise self._refusal(session, id, goal, epoch)
        self._note(session, "job", id, goal, f"{who} {name}".strip(), why)

    def _refusal(
        self, session: Session, id: str, goal: str, epoch: int | None
    ) -> NoSuchJob | WrongState | StaleEpoch:
        found = session.execute(sa.select(Job.state, Job.epoch).where(Job.id == id)).first()
        if found is None:
            return NoSuchJob(f"There is no job {_short(id)}.", "GET /api/jobs lists them.")
        state, current = found
        if epoch is not None and epoch != current:
            return _stale(id, state, current, epoch)
        return WrongState(f"Job {id} is {state}, so it cannot become {goal}.", _mend(state))

    def _note(
        self, session: Session, kind: str, subject: str, state: str, who: str, why: str
    ) -> None:
        session.add(
            Event(
                kind=kind,
                subject=subject,
                at=self.clock(),
                state=str(state),
                who=who[:200],
                why=why,
            )
        )

    def _fresh(self, session: Session, id: str) -> Job:
        row = session.scalar(
            sa.select(Job)
            .where(Job.id == id)
            .with_for_update()
            .execution_options(populate_existing=True)
        )
        if row is None:
            raise NoSuchJob(f"There is no job {_short(id)}.", "GET /api/jobs lists them.")
        return row

    def _column(self, table: type[Drawing] | type[Job], id: str, column: str, word: str) -> bytes:
        query = sa.select(getattr(table, column), table.id).where(table.id == id)
        with self._reading() as session:
            found = session.execute(query).first()
        if found is None:
            raise NoSuchJob(f"There is no {word} {_short(id)}.", f"GET /api/{word}s lists them.")
        if found[0] is None:
            raise WrongState(
                f"{word.capitalize()} {id} has no {column}.",
                "It is made by the compile; see the job's state and reason.",
            )
        return bytes(found[0])


def _stale(id: str, state: str, current: int, epoch: int) -> StaleEpoch:
    return StaleEpoch(
        f"Job {id} is {state} in epoch {current}, and this was said in epoch {epoch}.",
        "It belongs to nobody or to another now: stop the machine and claim again.",
    )


def _rows(session: Session, statement: sa.Update) -> int:
    return cast("sa.CursorResult[Any]", session.execute(statement)).rowcount


def _short(id: str) -> str:
    return repr(id if len(id) <= 40 else id[:40] + "…")


def _mend(state: str) -> str:
    match state:
        case State.INTERRUPTED:
            return "Look at the table, then queue it again or scrap it."
        case State.RECEIVED | State.COMPILING:
            return "Wait until it is ready."
        case State.READY:
            return "Release it first."
        case State.QUEUED:
            return "Wait until a gateway has claimed it."
        case State.RUNNING | State.HELD:
            return "Hold, resume or cancel it."
        case _:
            return "Order it again."


def _same_request(row: Any, key: str, fingerprint: str) -> Any:
    if row.fingerprint != fingerprint:
        raise KeyReused(
            f"The Idempotency-Key {_short(key)} was used for another request.",
            "Take a new key for a new request.",
        )
    return row
