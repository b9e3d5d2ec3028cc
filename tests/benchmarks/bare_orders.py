"""The least time of an order: two inserted rows behind FastAPI.

python -m tests.benchmarks.bare_orders URL PORT
"""

from __future__ import annotations

import secrets
import sys
import time
from typing import Any

import sqlalchemy as sa
import uvicorn
from fastapi import FastAPI
from pydantic import BaseModel

META = sa.MetaData()
JOBS = sa.Table(
    "bare_job",
    META,
    sa.Column("serial", sa.Integer, primary_key=True),
    sa.Column("id", sa.String(32), unique=True),
    sa.Column("drawing", sa.String(32)),
    sa.Column("machine", sa.String(200)),
    sa.Column("board", sa.String(200)),
    sa.Column("created", sa.Double),
)
EVENTS = sa.Table(
    "bare_event",
    META,
    sa.Column("id", sa.Integer, primary_key=True),
    sa.Column("subject", sa.String(32), index=True),
    sa.Column("state", sa.String(16)),
)


class BareOrder(BaseModel):
    """A new job."""

    drawing: str
    machine: str
    board: str


def make_app(url: str) -> FastAPI:
    """Return an application that stores orders in a database."""
    engine = sa.create_engine(url, pool_size=10, max_overflow=40)
    if engine.dialect.name == "sqlite":
        sa.event.listen(engine, "connect", _connect)
        sa.event.listen(engine, "begin", lambda one: one.exec_driver_sql("BEGIN IMMEDIATE"))
    META.create_all(engine)
    app = FastAPI()

    @app.post("/api/jobs", status_code=201)
    def order(wanted: BareOrder) -> dict[str, str]:
        id = secrets.token_hex(5)
        with engine.begin() as connection:
            row = {"id": id, "created": time.time(), **wanted.model_dump()}
            connection.execute(JOBS.insert().values(row))
            connection.execute(EVENTS.insert().values(subject=id, state="received"))
        return {"id": id}

    @app.get("/readyz")
    def ready() -> dict[str, str]:
        return {}

    return app


def _connect(connection: Any, _record: object) -> None:
    """Make commits as durable as those of knifetip."""
    connection.isolation_level = None
    for pragma in ("busy_timeout=30000", "journal_mode=WAL", "synchronous=FULL"):
        connection.execute(f"PRAGMA {pragma}")


if __name__ == "__main__":
    uvicorn.run(make_app(sys.argv[1]), port=int(sys.argv[2]), log_level="error")
