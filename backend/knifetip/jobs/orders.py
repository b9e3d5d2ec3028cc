"""orders: the jobs, their events, and what an operator does with them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import NoSuchJob, WrongState
from knifetip.jobs.job import LEASED, State, Who, new_id, sources
from knifetip.jobs.moves import Moves, mend, rows, same_request, short
from knifetip.jobs.tables import Drawing, Event, Job


class Orders(Moves):
    """The jobs of the store, as people see and move them."""

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
        corners: dict[str, Any] | None = None,
        rules: str = "",
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
            rules=rules,
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
            corners=corners,
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
        return None if row is None else same_request(row, key, fingerprint)

    def job(self, id: str) -> Job:
        """Return a job without its large columns."""
        with self._reading() as session:
            row = session.scalar(sa.select(Job).where(Job.id == id))
        if row is None:
            raise NoSuchJob(f"There is no job {short(id)}.", "GET /api/jobs lists them.")
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
                changed = rows(
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
                        mend(row.state),
                    )
                self._note(session, "job", id, row.state, str(Who.OPERATOR), f"asked to {wish}")
        return self.job(id)
