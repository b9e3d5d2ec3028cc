"""List of drawings and layouts, each with its newest job: the table of work of the page.

A page of the list is one query.  The newest job of a drawing is found by the index of jobs by their
drawings, so that a row costs the same in a large database.
"""

from __future__ import annotations

from typing import Any, Final, Literal

import sqlalchemy as sa
from pydantic import BaseModel, Field
from sqlalchemy.orm import aliased

from knifetip.service.database.acting import acting_limits
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.models import DrawingSummary
from knifetip.service.http.models import PageQuery
from knifetip.service.order_details.details import contains
from knifetip.service.orders.models import JobOut, JobState

Sort = Literal["newest", "name", "customer", "due", "board", "machine", "state", "time"]

_JOB: Final = aliased(Job)
_SERIAL: Final = Drawing.serial.desc()
#: The states in the order in which a job passes through them.
_STATES: Final[tuple[JobState, ...]] = (
    *("received", "compiling", "refused", "ready", "queued", "running", "held", "interrupted"),
    *("done", "continued", "scrapped", "cancelled"),
)
#: The details of the job where it has its own, as the page shows them.
_CUSTOMER: Final = sa.func.coalesce(sa.func.nullif(_JOB.customer, ""), Drawing.customer)
_DUE: Final = sa.func.coalesce(_JOB.due, Drawing.due)
#: What the list is sorted by; NULL for rows without a value.
_KEYS: Final[dict[Sort, Any]] = {
    "name": sa.func.lower(Drawing.name),
    "customer": sa.func.nullif(sa.func.lower(_CUSTOMER), ""),
    "due": _DUE,
    "board": _JOB.board,
    "machine": _JOB.machine,
    "state": sa.case({state: at for at, state in enumerate(_STATES)}, value=_JOB.state),
    "time": sa.func.nullif(_JOB.seconds, 0.0),
}


class OrdersQuery(PageQuery):
    """Query parameters that select drawings and their newest jobs; all conditions must be met."""

    search: str = Field(
        default="",
        max_length=200,
        description="Text that the file name, the customer or the number of the order contains, in "
        "upper or lower case; empty for all",
    )
    state: list[JobState | Literal["none"]] = Field(
        default=[],
        description="States of the newest job, `none` for drawings without a job; may be repeated; "
        "all if it is missing",
    )
    machine: str = Field(
        default="",
        max_length=200,
        description="Name of the machine of the newest job; empty for all machines",
    )
    sort: Sort = Field(
        default="newest",
        description="Order of the list. newest: last uploaded first. name, customer, board, "
        "machine: by the alphabet. due: earliest due time first. state: state of the newest job, "
        "from received to ended. time: shortest machine time first. Rows without a value come last",
    )
    reverse: bool = Field(
        default=False,
        description="Sort the other way round; rows without a value still come last",
    )


class OrderRow(BaseModel):
    """A drawing or the sheet of a layout with its newest job, as an item of a list."""

    drawing: DrawingSummary = Field(description="The drawing")
    file: str = Field(
        description="SHA-256 of the uploaded file; drawings with the same value have the same file"
    )
    job: JobOut | None = Field(description="The newest job of the drawing; null if there is none")


def find_orders(database: Database, wanted: OrdersQuery) -> list[tuple[Drawing, Job | None]]:
    """Return drawings with their newest jobs, beginning at the position ``wanted.cursor``.

    Parameters
    ----------
    database
        The database of the server.
    wanted
        Conditions, order and page.
    """
    limits = acting_limits()
    newest = (
        sa.select(sa.func.max(Job.serial))
        .where(Job.drawing == Drawing.id, *limits.job_conditions())
        .correlate(Drawing)
        .scalar_subquery()
    )
    query = sa.select(Drawing, _JOB).outerjoin(_JOB, _JOB.serial == newest)
    query = query.where(*limits.drawing_conditions())
    if wanted.search:
        columns = (Drawing.name, Drawing.customer, Drawing.external_id)
        query = query.where(sa.or_(*(contains(column, wanted.search) for column in columns)))
    if wanted.state:
        states = [state for state in wanted.state if state != "none"]
        none = _JOB.serial.is_(None) if "none" in wanted.state else sa.false()
        query = query.where(sa.or_(none, _JOB.state.in_(states)))
    if wanted.machine:
        query = query.where(_JOB.machine == wanted.machine)
    query = query.order_by(*_order(wanted)).offset(wanted.cursor or 0).limit(wanted.limit)
    with database.reading() as session:
        return [(drawing, job) for drawing, job in session.execute(query)]


def _order(wanted: OrdersQuery) -> tuple[Any, ...]:
    if wanted.sort == "newest":
        return (Drawing.serial if wanted.reverse else _SERIAL,)
    key = _KEYS[wanted.sort]
    return key.is_(None), key.desc() if wanted.reverse else key, _SERIAL
