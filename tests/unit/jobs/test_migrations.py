"""A database of each earlier revision, with rows in all its tables, is migrated to the newest."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic.config import Config
from alembic.script import ScriptDirectory

from knifetip.jobs.store import Store
from knifetip.library import load
from tests.unit.jobs.test_schema import MIGRATIONS, _row, run_alembic

#: Values of columns that other rows refer to, or whose type is not that of a plain text.
_VALUES: dict[str, dict[str, object]] = {
    "drawing": {"id": "d1", "content": b"0\nEOF\n"},
    "job": {"id": "j1", "drawing": "d1", "state": "held", "machine": "m1", "program": b"M2\n"},
    "command_key": {"job": "j1"},
    "machine_run": {"id": 1},
}


def revisions() -> list[str]:
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    found = ScriptDirectory.from_config(settings).walk_revisions()
    return [script.revision for script in found][:0:-1]


def fill(url: str) -> set[str]:
    """Add a row to each table; return the names of the tables."""
    engine = sa.create_engine(url)
    tables = sa.MetaData()
    with engine.begin() as connection:
        tables.reflect(connection)
        for table in tables.sorted_tables:
            if table.name not in ("alembic_version", "write_probe"):
                values = dict(_VALUES.get(table.name, {}))
                for key in table.foreign_keys:
                    if key.column.name == "serial" or key.column.table.name == "machine_run":
                        values[key.parent.name] = 1
                known = {name: values[name] for name in values if name in table.columns}
                connection.execute(sa.insert(table).values(_row(table, **known)))
    engine.dispose()
    return {name for name in tables.tables if name != "alembic_version"}


@pytest.mark.parametrize("revision", revisions())
def test_rows_of_each_revision_are_there_after_the_migration(revision: str, tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    run_alembic(url, revision)
    names = fill(url)
    with closing(Store(url)) as store:
        store.prepare()
        assert store.database.schema().is_current
        job = store.jobs.get("j1")
        assert (job.state, job.drawing, job.machine) == ("held", "d1", "m1")
        with store.database.reading() as session:
            for name in names:
                count = session.scalar(sa.select(sa.func.count()).select_from(sa.table(name)))
                assert count, name
            assert session.execute(sa.text("PRAGMA foreign_key_check")).all() == []


def test_the_use_of_tools_is_the_same_after_its_migration_to_running_sums(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    run_alembic(url, "0097")
    engine, tables = sa.create_engine(url), sa.MetaData()
    with engine.begin() as connection:
        tables.reflect(connection)

        def insert(name: str, **values: object) -> None:
            table = tables.tables[name]
            connection.execute(sa.insert(table).values(_row(table, **values)))

        for number, ended in enumerate((10.0, 30.0, 0.0), 1):
            insert("machine_run", id=number, job=f"j{number}", machine="table", ended=ended)
            for station in (1, 2):
                length = 100.0 * number * station
                insert("run_length", run=number, station=station, line_type="cut", length=length)
        insert("tool_event", machine="table", station=1, kind="changed", at=20.0, unfinished=0.0)
    engine.dispose()
    machine = replace(load.machine("demo-table", files=False), name="table")
    with closing(Store(url)) as store:
        store.prepare()
        uses = {use.station: use.used for use in store.tools.uses(machine)}
    assert uses == {1: 200.0, 2: 200.0 + 400.0, 3: 0.0}
