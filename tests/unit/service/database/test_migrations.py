"""A database of each revision, with rows in all its tables, is migrated to a later one."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic import command

from knifetip.service.store import Store
from tests.support.revisions import alembic_settings, all_revisions
from tests.unit.service.database.test_schema import _row

#: Values of columns that other rows refer to, or whose type is not that of a plain text.
_VALUES: dict[str, dict[str, object]] = {
    "drawing": {"id": "d1"},
    "job": {"id": "j1", "drawing": "d1", "state": "held", "machine": "m1"},
    "command_key": {"job": "j1"},
    "machine_run": {"id": 1},
}


def fill(url: str, revision: str) -> set[str]:
    """Create the tables of a revision, and add a row to each; return the names of the tables."""
    settings = alembic_settings()
    engine = sa.create_engine(url)
    tables = sa.MetaData()
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.upgrade(settings, revision)
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


@pytest.mark.parametrize("revision", all_revisions())
def test_rows_of_each_revision_are_there_after_the_migration(
    revision: str, tmp_path: Path, later_version: Callable[[], None]
) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    names = fill(url, revision)
    later_version()
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
