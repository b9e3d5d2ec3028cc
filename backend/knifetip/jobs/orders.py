"""orders: the jobs, their events, and what an operator does with them."""

from __future__ import annotations

from collections.abc import Sequence

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import NoSuchJob, WrongState
from knifetip.jobs.interpretations import job_columns
from knifetip.jobs.job import LEASED, Confirmation, State, Who, new_id, sources
from knifetip.jobs.moves import Moves, advice_for, rows, same_request, short
from knifetip.jobs.tables import Drawing, Event, Job
from knifetip.messages import from_json
from knifetip.model.interpretation import Interpretation


class Orders(Moves):
    """The jobs of the store, as people see and move them."""

    def add_job(
        self,
        drawing: Drawing,
        *,
        machine: str,
        board: str,
        interpretation: Interpretation,
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
            **job_columns(interpretation),
            copies=copies,
            priority=priority,
            release=release,
            created=now,
            updated=now,
            queued=0.0,
            reason="",
            hint="",
            source=[],
            questions=[],
            attempt=1,
            epoch=0,
            owner="",
            lease=0.0,
            owner_epoch=0,
            confirmation=Confirmation.NONE.value,
            tools=[],
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
        return None if row is None else same_request(row, key, fingerprint)

    def job(self, id: str) -> Job:
        """Return a job without its large columns."""
        with self._reading() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id))
        if row is None:
            raise NoSuchJob("job.unknown", job=short(id))
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
        """Queue an interrupted job again, at its former place: the table has been cleared."""
        with self._writing() as session:
            self._move(
                session,
                id,
                State.QUEUED,
                Who.OPERATOR,
                "queued again",
                only=(State.INTERRUPTED,),
                lease=0.0,
                line=0,
                position=None,
                reason="",
                hint="",
                wish="",
                seconds_left=None,
            )
        return self.job(id)

    def scrap(self, id: str) -> Job:
        """Give an interrupted job up: its table is free again."""
        with self._writing() as session:
            self._move(session, id, State.SCRAPPED, Who.OPERATOR, "scrapped", wish="")
        return self.job(id)

    def declare_finished(self, id: str) -> Job:
        """End an interrupted job as done: an operator found all its sheets complete."""
        with self._writing() as session:
            row = self._fresh(session, id)
            self._move(
                session,
                id,
                State.DONE,
                Who.OPERATOR,
                f"declared finished at line {row.line} of {row.lines}",
                line=row.lines,
                copies_done=row.copies,
                reason="",
                hint="",
                wish="",
                lease=0.0,
                seconds_left=0.0,
            )
        return self.job(id)

    def confirm(self, id: str, board: str = "", by: str = "") -> Job:
        """Confirm that the table is clear and the job's board and tools are in place.

        Starts a job that a gateway has claimed, the next copy of one that waits for a sheet, or
        lets one go on that was started without a confirmation.  To confirm twice changes nothing.

        Parameters
        ----------
        board
            The board that lies on the table, where the operator names it.
        by
            Who confirms, for the record.

        Raises
        ------
        WrongState
            The job does not wait for a confirmation, or for another board.
        """
        with self._writing() as session:
            row = self._fresh(session, id)
            if board and board != row.board:
                raise WrongState("job.other-board", job=id, board=row.board, given=short(board))
            confirmed = row.confirmation == Confirmation.GIVEN and row.wish != "cancel"
            going = row.state in (State.QUEUED, State.RUNNING) or row.wish == "resume"
            if confirmed and going:
                return row
            self._check_waiting(row)
            sheet = row.confirmation == Confirmation.SHEET
            wish = "" if row.state == State.QUEUED else "resume"
            session.execute(
                sa.update(Job)
                .where(Job.id == id)
                .values(confirmation=Confirmation.GIVEN.value, wish=wish, updated=self.clock())
                .execution_options(synchronize_session=False)
            )
            what = "new sheet" if sheet else "table clear"
            why = f"confirmed: {what}, board {row.board}"
            self._note(session, "job", id, row.state, f"{Who.OPERATOR} {by}".strip(), why)
            return self._fresh(session, id)

    def _check_waiting(self, row: Job) -> None:
        """Raise WrongState unless the job waits for the operator's confirmation."""
        if row.wish == "cancel":
            raise WrongState("job.being-cancelled", job=row.id)
        if row.confirmation in (Confirmation.AWAITED, Confirmation.SHEET):
            if row.state == State.QUEUED and row.lease < self.clock():
                raise WrongState("job.gateway-silent", gateway=row.owner, job=row.id)
            return
        match row.state:
            case State.QUEUED:
                raise WrongState("job.not-taken", job=row.id, machine=row.machine)
            case State.HELD:
                raise WrongState("job.no-sheet-awaited", job=row.id)
            case State.RUNNING:
                raise WrongState("job.nothing-to-confirm", job=row.id)
            case _:
                advice = from_json(row.hint) if row.hint else advice_for(row.state)
                raise WrongState(
                    "job.no-confirmation-awaited", job=row.id, state=row.state, advice=advice
                )

    def hold(self, id: str) -> Job:
        """Ask the gateway to hold; the job is ``held`` when the machine stands."""
        return self._wish(id, "hold", (State.RUNNING,), already=State.HELD)

    def resume(self, id: str) -> Job:
        """Ask the gateway to go on; between two copies this confirms the new sheet."""
        return self._wish(id, "resume", (State.HELD, State.RUNNING))

    def cancel(self, id: str) -> Job:
        """Cancel a job: at once before it runs, by its gateway while it does."""
        before = sources(State.CANCELLED, Who.OPERATOR)
        with self._writing() as session:
            state = session.scalar(sa.select(Job.state).where(Job.id == id).with_for_update())
            if state in before or state not in LEASED:
                self._move(
                    session,
                    id,
                    State.CANCELLED,
                    Who.OPERATOR,
                    "cancelled",
                    stage="",
                    confirmation=Confirmation.NONE.value,
                )
                return self._fresh(session, id)
        return self._wish(id, "cancel", LEASED)

    def _wish(
        self, id: str, wish: str, states: Sequence[State], already: State | None = None
    ) -> Job:
        with self._writing() as session:
            row = self._fresh(session, id)
            changes = {"wish": wish, "updated": self.clock()}
            if wish == "resume" and row.confirmation == Confirmation.AWAITED:
                raise WrongState("job.not-confirmed", job=id)
            if wish == "resume" and row.confirmation == Confirmation.SHEET:
                changes["confirmation"] = Confirmation.GIVEN.value
            if row.state != already and row.wish != wish:
                changed = rows(
                    session,
                    sa.update(Job)
                    .where(Job.id == id, Job.state.in_(states), Job.wish != "cancel")
                    .values(**changes),
                )
                if not changed and row.wish == "cancel":
                    raise WrongState("job.cancelled-before-request", job=id, request=wish)
                if not changed:
                    raise WrongState(
                        "job.wrong-state-for-request",
                        job=id,
                        state=row.state,
                        request=wish,
                        states=states,
                        advice=advice_for(row.state),
                    )
                self._note(session, "job", id, row.state, str(Who.OPERATOR), f"asked to {wish}")
        return self.job(id)
