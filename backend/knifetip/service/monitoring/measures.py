"""Numbers of a database for monitoring: jobs by machine and state, gateways, pending deliveries."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import sqlalchemy as sa

from knifetip.contract.job import ENDED, State
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import Gateway, Job
from knifetip.service.webhooks.tables import WebhookDelivery

#: States whose jobs are counted: a count of ended jobs would read the whole history.
COUNTED: Final = tuple(
    state.value for state in State if state not in ENDED or state is State.INTERRUPTED
)

# A parameter would not match the condition of the partial index.
_PENDING: Final[sa.ColumnClause[str]] = sa.literal_column("'pending'")


@dataclass(frozen=True, slots=True)
class DatabaseMeasures:
    """Numbers of jobs, gateways and deliveries in a database at one time."""

    jobs: dict[tuple[str, str], int]  #: number of jobs by machine and state
    silent: dict[str, float]  #: seconds since the last request of a gateway, by machine
    deliveries: int  #: webhook deliveries that are pending


def measure(database: Database, machines: int) -> DatabaseMeasures:
    """Return the numbers of a database.

    Parameters
    ----------
    database
        The database.
    machines
        Greatest number of machines with a row each; the jobs of all others count for "other".
    """
    jobs = (
        sa.select(Job.machine, Job.state, sa.func.count())
        .where(Job.state.in_(COUNTED))
        .group_by(Job.machine, Job.state)
        .order_by(Job.machine, Job.state)
    )
    seen = (
        sa.select(Gateway.machine, sa.func.max(Gateway.seen))
        .group_by(Gateway.machine)
        .order_by(sa.func.max(Gateway.seen).desc())
        .limit(machines)
    )
    pending = sa.select(sa.func.count()).where(WebhookDelivery.state == _PENDING)
    with database.reading() as session:
        counted = session.execute(jobs).all()
        gateways = session.execute(seen).all()
        deliveries = session.scalar(pending) or 0
    now = database.clock()
    named = sorted({machine for machine, _, _ in counted})[:machines]
    sums: dict[tuple[str, str], int] = {}
    for machine, state, count in counted:
        key = (machine if machine in named else "other", state)
        sums[key] = sums.get(key, 0) + count
    silent = {machine: max(0.0, now - last) for machine, last in gateways}
    return DatabaseMeasures(sums, silent, deliveries)
