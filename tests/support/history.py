"""Fill a database with ended jobs, their events and runs, by copying one job with SQL."""

from __future__ import annotations

from typing import Any, Final

import sqlalchemy as sa

from knifetip.service.database.tables import (
    Base,
    Drawing,
    Event,
    Job,
    MachineRun,
    RunLength,
    ToolWork,
)
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.store import Store
from tests.support.job_states import queued

#: Every tenth job is for one of the machines "demo-table", "table-1", …, "table-9".
MACHINES: Final = ("demo-table", *(f"table-{number}" for number in range(1, 10)))
_SPACING: Final = 30.0  # seconds between the ends of two jobs
_EVENTS: Final = 6  # of a job that was made


def complete_job(store: Store) -> Job:
    """Order, compile, claim and finish a job; return it."""
    ready = queued(store, machine="demo-table")
    job = store.gateways.claim(ready.machine, "history", manual=False)
    assert job is not None
    assert job.id == ready.id
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=3))
    store.gateways.finish(job.id, job.epoch, "done")
    return store.jobs.get(job.id)


def fill(store: Store, count: int) -> None:
    """Add ended jobs to a store: nine of ten are done, the others refused.

    Parameters
    ----------
    store
        The store; its database has all tables.
    count
        Number of jobs; each has six events, a run and a length of the run.
    """
    model = complete_job(store)
    with store.database.writing() as session:
        postgresql = session.get_bind().dialect.name == "postgresql"
        if postgresql:
            numbers = "SELECT generate_series(1, :count) AS k"
        else:
            numbers = (
                "WITH RECURSIVE n(k) AS (SELECT 1 UNION ALL SELECT k + 1 FROM n WHERE k < :count)"
                " SELECT k FROM n"
            )
        machine = "CASE k % 10 WHEN 0 THEN 'demo-table' ELSE 'table-' || (k % 10) END"
        id = "'h' || k"
        end = f"CAST(:now AS DOUBLE PRECISION) - (:count - k) * {_SPACING}"

        def copy(table: type[Base], where: str, numbered: str = numbers, **changed: str) -> None:
            names = [column.name for column in table.__table__.columns]
            values = [changed.get(name, f"m.{name}") for name in names]
            source = table.__tablename__
            session.execute(
                sa.text(
                    f"INSERT INTO {source} ({', '.join(names)}) SELECT {', '.join(values)}"
                    f" FROM ({numbered}) AS numbers CROSS JOIN {source} AS m WHERE {where}"
                ),
                parameters,
            )

        parameters: dict[str, Any] = {
            "count": count,
            "now": model.updated,
            "job": model.id,
            "drawing": model.drawing,
        }
        first = {
            table: (session.scalar(sa.select(sa.func.max(column))) or 0) + 1
            for table, column in (
                (Drawing, Drawing.serial),
                (Job, Job.serial),
                (Event, Event.id),
                (MachineRun, MachineRun.id),
            )
        }
        copy(Drawing, "m.id = :drawing", serial=f"{first[Drawing]} + k", id=id, sha256="'s' || k")
        copy(
            Job,
            "m.id = :job",
            serial=f"{first[Job]} + k",
            id=id,
            drawing=id,
            machine=machine,
            state="CASE WHEN k % 10 = 3 THEN 'refused' ELSE 'done' END",
            created=end,
            updated=end,
            ended=end,
        )
        copy(
            Event,
            "m.subject = :job",
            id=f"{first[Event]} + k * {_EVENTS} + (m.id % {_EVENTS})",
            subject=id,
            at=end,
        )
        copy(
            MachineRun,
            "m.job = :job",
            id=f"{first[MachineRun]} + k",
            job=id,
            machine=machine,
            started=f"{end} - 20.0",
            ended=end,
        )
        session.add(RunLength(run=first[MachineRun] - 1, station=1, line_type="cut", length=1234.5))
        session.flush()
        parameters["run"] = first[MachineRun] - 1
        copy(RunLength, "m.run = :run", run=f"{first[MachineRun]} + k")
        worked = sa.select(MachineRun.machine, RunLength.station, sa.func.sum(RunLength.length))
        worked = worked.join_from(RunLength, MachineRun, MachineRun.id == RunLength.run)
        session.execute(sa.delete(ToolWork))
        session.execute(
            sa.insert(ToolWork).from_select(
                ["machine", "station", "length"],
                worked.group_by(MachineRun.machine, RunLength.station),
            )
        )
        if postgresql:
            # PostgreSQL does so by itself after a while, SQLite never.
            session.execute(sa.text("ANALYZE"))
            for table in (Drawing, Job, Event, MachineRun):
                name, key = table.__tablename__, next(iter(table.__table__.primary_key)).name
                session.execute(
                    sa.text(
                        f"SELECT setval(pg_get_serial_sequence('{name}', '{key}'),"
                        f" (SELECT max({key}) FROM {name}))"
                    )
                )
