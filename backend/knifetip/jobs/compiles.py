"""compiles: what a compile worker does to a job, while it holds its epoch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.jobs.job import State, Who
from knifetip.jobs.moves import LEASE, rows
from knifetip.jobs.orders import Orders
from knifetip.jobs.tables import Job
from knifetip.model.stage import Stage

ATTEMPTS = 5  #: compiles that may die under a job before it is refused
_NEXT = sa.select(Job.id).where(Job.state == State.RECEIVED).order_by(Job.serial).limit(1)


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
    #: stations that the program uses, in their order: number, name, kind
    tools: list[dict[str, Any]] = field(default_factory=list)


class Compiles(Orders):
    """The jobs of the store, as compile workers move them."""

    def begin_compile(self, worker: str) -> Job | None:
        """Take the received job that has waited longest; None if there is none."""
        with self._reading() as session:
            if session.scalar(_NEXT) is None:
                return None
        with self._writing() as session:
            id = session.scalar(_NEXT.with_for_update(skip_locked=True))
            if id is None:
                return None
            row = self._fresh(session, id)
            self._move(
                session,
                id,
                State.COMPILING,
                Who.WORKER,
                f"attempt {row.attempt}",
                name=worker,
                epoch=row.epoch,
                changes_epoch=row.epoch + 1,
                owner=worker,
                lease=self.clock() + LEASE,
                stage=Stage.READ.value,
                progress=0.0,
            )
            return self._fresh(session, id)

    def recover_compiles(self, worker: str) -> None:
        """Take back the jobs that an earlier process of this name was compiling when it died."""
        with self._writing() as session:
            dead = sa.select(Job).where(Job.state == State.COMPILING, Job.owner == worker)
            for row in session.scalars(dead.with_for_update()).all():
                self._take_back_compile(session, row)

    def _take_back_compile(self, session: Session, row: Job) -> None:
        """Return a job whose worker is silent to the queue, unless too many compiles died."""
        if row.attempt < ATTEMPTS:
            self._move(
                session,
                row.id,
                State.RECEIVED,
                Who.CLOCK,
                f"The worker {row.owner} stopped responding in stage {row.stage}.",
                epoch=row.epoch,
                attempt=row.attempt + 1,
                stage="",
                progress=0.0,
            )
            return
        why = f"{ATTEMPTS} compiles of the job died, the last in stage {row.stage}."
        self._move(
            session,
            row.id,
            State.REFUSED,
            Who.CLOCK,
            why,
            epoch=row.epoch,
            reason=why,
            hint="Send a smaller drawing, or report this one as a bug.",
            stage="",
        )

    def compile_progress(self, id: str, epoch: int, stage: Stage, progress: float) -> bool:
        """Say how far a compile is and renew its lease; False when the job is no longer ours."""
        with self._writing() as session:
            return bool(
                rows(
                    session,
                    sa.update(Job)
                    .where(Job.id == id, Job.state == State.COMPILING, Job.epoch == epoch)
                    .values(stage=stage.value, progress=progress, lease=self.clock() + LEASE),
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
            "tools": result.tools,
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
                    hint="Change the drawing, the line types or the board; nothing was cut.",
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
        hint: str,
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
                hint=hint,
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
