"""tableside: what a gateway does to a job, and what the clock does when it falls silent."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.errors import MachineBusy
from knifetip.jobs.compiles import ATTEMPTS
from knifetip.jobs.job import LEASED, ON_TABLE, State, Who
from knifetip.jobs.moves import LEASE, mend, stale
from knifetip.jobs.orders import Orders
from knifetip.jobs.tables import Gateway, Job


class Tableside(Orders):
    """The jobs of the store, as gateways move them."""

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
        with self._writing(urgent=True) as session:
            row = self._fresh(session, id)
            if row.epoch != epoch or row.state not in LEASED:
                raise stale(id, row.state, row.epoch, epoch)
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
        with self._writing(urgent=True) as session:
            row = self._fresh(session, id)
            if row.epoch == epoch and row.state == goal:
                return row
            if row.epoch != epoch or row.state not in LEASED:
                raise stale(id, row.state, row.epoch, epoch)
            ended: dict[str, Any] = {"wish": "", "lease": 0.0, "seconds_left": None}
            if goal is State.DONE:
                ended |= {"line": row.lines, "copies_done": row.copies, "seconds_left": 0.0}
            if goal is State.INTERRUPTED:
                ended |= {
                    "reason": why or f"The gateway gave up at line {row.line}.",
                    "mend": mend(State.INTERRUPTED),
                }
            self._move(
                session, id, goal, Who.GATEWAY, why or outcome, name=row.owner, epoch=epoch, **ended
            )
        return self.job(id)

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
                    mend=mend(State.INTERRUPTED),
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
