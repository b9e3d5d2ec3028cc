"""Copies of a stopped job that were ordered, and that no job has made or is going to make."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence
from typing import NamedTuple

import sqlalchemy as sa
from sqlalchemy.orm import Session

from knifetip.contract.job import State
from knifetip.service.database.tables import Job

#: States in which the machine has stopped a job, or an operator has given it up.
_STOPPED = (State.INTERRUPTED, State.SCRAPPED, State.CONTINUED, State.CANCELLED)
#: States of a job that makes no more sheets and that no other job continues.
_GIVEN_UP = (State.REFUSED, State.SCRAPPED, State.CANCELLED)


class _Order(NamedTuple):
    """A job as one of those that continue each other's work."""

    id: str
    resumes: str | None
    is_rest: bool
    state: str
    copies: int
    copies_done: int
    was_run: bool


_COLUMNS = (
    Job.id,
    Job.resumes,
    Job.rest.is_not(None),
    Job.state,
    Job.copies,
    Job.copies_done,
    Job.owner_epoch > 0,
)


def remaining_copies(session: Session, rows: Sequence[Job]) -> dict[str, int]:
    """Return the number of copies that remain to be ordered for each job; a 0 is omitted.

    A batch is stopped in the middle of a copy, of which another job makes the rest.  The copies
    after it are not made by themselves.  For a job that makes the rest of a sheet, the copies are
    those of the batch to which the sheet belongs.

    Parameters
    ----------
    session
        Session with a transaction.
    rows
        Jobs in any states.
    """
    asked = [row for row in rows if row.rest is not None or (row.copies > 1 and _is_stopped(row))]
    if not asked:
        return {}
    batches = {row.id: _batch(session, _order(row)) for row in asked}
    children = _descendants(session, {batch.id for batch in batches.values()})
    remaining = {id: _remaining(batch, children) for id, batch in batches.items()}
    return {id: count for id, count in remaining.items() if count}


def batch_of(session: Session, row: Job) -> str:
    """Return the job whose sheet a job continues, directly or over others; else the job itself."""
    return _batch(session, _order(row)).id


def _is_stopped(row: Job) -> bool:
    return row.state in _STOPPED and row.owner_epoch > 0


def _order(row: Job) -> _Order:
    return _Order(
        row.id,
        row.resumes,
        row.rest is not None,
        row.state,
        row.copies,
        row.copies_done,
        row.owner_epoch > 0,
    )


def _batch(session: Session, order: _Order) -> _Order:
    while order.is_rest and order.resumes is not None:
        found = session.execute(sa.select(*_COLUMNS).where(Job.id == order.resumes)).first()
        if found is None:
            break  # it was deleted
        order = _Order(*found)
    return order


def _descendants(session: Session, ids: Collection[str]) -> dict[str, list[_Order]]:
    """Return the later jobs that continue or repeat some jobs, by the job that each one names."""
    children: defaultdict[str, list[_Order]] = defaultdict(list)
    found: Iterable[str] = ids
    while found:
        rows = session.execute(sa.select(*_COLUMNS).where(Job.resumes.in_(found)))
        orders = [_Order(*row) for row in rows]
        for order in orders:
            children[order.resumes or ""].append(order)
        # Those that make the whole program again have batches of their own.
        found = [order.id for order in orders if order.is_rest]
    return children


def _remaining(batch: _Order, children: dict[str, list[_Order]]) -> int:
    if batch.copies == 1 or batch.state not in _STOPPED or not batch.was_run:
        return 0
    ordered = sum(
        again.copies_done if again.state in _GIVEN_UP else again.copies
        for again in _copies_of(batch.id, children)
    )
    sheet = int(_is_sheet_made(batch.id, children))
    return max(batch.copies - batch.copies_done - sheet - ordered, 0)


def _copies_of(id: str, children: dict[str, list[_Order]]) -> list[_Order]:
    """Return the jobs that repeat the program of a job, or of a job that continued its sheet."""
    found = []
    for child in children.get(id, ()):
        found += _copies_of(child.id, children) if child.is_rest else [child]
    return found


def _is_sheet_made(id: str, children: dict[str, list[_Order]]) -> bool:
    """Return whether another job has made the rest of the sheet of a job, or is going to."""
    return any(
        child.is_rest
        and (child.state not in (*_GIVEN_UP, State.CONTINUED) or _is_sheet_made(child.id, children))
        for child in children.get(id, ())
    )
