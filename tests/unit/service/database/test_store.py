"""Drawings, keys of requests, events and the tables of the database."""

from __future__ import annotations

import os
import sqlite3
import stat
from pathlib import Path

import psycopg
import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext

from knifetip.errors import (
    KeyReused,
    NotFound,
    StaleRevision,
    StaleVersion,
    StoreError,
    WrongState,
)
from knifetip.service.database import migrations
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Base
from knifetip.service.lifecycle.transitions import LEASE
from knifetip.service.store import Store
from tests.support.job_states import (
    drawing,
    ordered,
    queued,
    running,
)
from tests.support.messages import stored
from tests.support.stored import Clock, migrated_store

MIGRATIONS = Path(migrations.__file__).parent


# Drawings, keys, events


def test_a_key_answers_with_the_first_result_and_refuses_another_request(store: Store) -> None:
    key, reused = RequestKey("k", "f"), RequestKey("k", "another")
    first = drawing(store, key)
    assert drawing(store, key).id == first.id
    with pytest.raises(KeyReused):
        drawing(store, reused)
    job = ordered(store, key)
    assert ordered(store, key).id == job.id
    with pytest.raises(KeyReused):
        store.jobs.find(reused)


def test_a_change_to_a_drawing_that_changed_meanwhile_is_refused(store: Store) -> None:
    row = drawing(store)
    assert (
        store.drawings.change(row.id, row.version, stored("first"), overrides=b"\x01").version == 2
    )
    with pytest.raises(StaleRevision, match="revision 2") as stale:
        store.drawings.change(row.id, row.version, stored("second"), overrides=b"\x02")
    assert stale.value.revision == 2
    assert store.drawings.column(row.id, "overrides") == b"\x01"


def test_a_change_to_a_drawing_that_was_deleted_meanwhile_is_refused(store: Store) -> None:
    row = drawing(store)
    store.drawings.delete(row.id)
    with pytest.raises(NotFound):
        store.drawings.change(row.id, row.version, stored("late"), overrides=b"\x01")


def test_what_is_read_of_a_drawing_is_of_one_revision(store: Store) -> None:
    row = drawing(store)
    store.drawings.change(
        row.id, 1, stored("second"), overrides=b"\x02", edges=b"two", unit_given="in"
    )
    read = store.drawings.get_with(row.id, "overrides", "edges")
    store.drawings.change(
        row.id, 2, stored("third"), overrides=b"\x03", edges=b"three", unit_given="mm"
    )
    seen = (read.version, read.overrides, read.edges, read.unit_given)
    assert seen == (2, b"\x02", b"two", "in")


def test_a_drawing_with_jobs_is_kept(store: Store) -> None:
    job = ordered(store)
    with pytest.raises(WrongState, match=job.id):
        store.drawings.delete(job.drawing)
    free = drawing(store)
    store.drawings.delete(free.id)
    with pytest.raises(NotFound):
        store.drawings.get(free.id)


def test_events_are_numbered_upwards_and_never_twice(store: Store) -> None:
    job = queued(store)
    last = store.events.last_id()
    store.operators.cancel(job.id)
    (event,) = store.events.after(last)
    assert (event.subject, event.state, event.who) == (job.id, "cancelled", "operator")
    assert event.id > last


def test_a_gateway_is_connected_while_it_asks_and_while_it_works(
    store: Store, clock: Clock
) -> None:
    assert store.machines.connected_machines(6.0) == set()
    store.machines.record_contact("table", "gateway")
    store.machines.record_contact("table", "gateway")
    assert store.machines.connected_machines(6.0) == {"table"}
    clock.now += 7.0
    assert store.machines.connected_machines(6.0) == set()
    job = running(store)
    assert store.machines.connected_machines(6.0) == {"table"}
    clock.now += LEASE + 1.0
    assert store.machines.connected_machines(6.0) == set()
    assert store.jobs.get(job.id).state == "running"


# The database


def test_the_migrations_make_the_tables_that_the_code_expects(store: Store, tmp_path: Path) -> None:
    engine = sa.create_engine(store.database.url)
    with engine.connect() as connection:
        assert compare_metadata(MigrationContext.configure(connection), Base.metadata) == []
    engine.dispose()


def test_a_connection_in_use_is_closed_when_it_is_returned_to_a_closed_database(
    store: Store,
) -> None:
    with store.database.reading() as session:
        connection = session.connection().connection.dbapi_connection
        assert connection is not None
        store.close()
        connection.cursor().execute("SELECT 1")
    with pytest.raises((psycopg.OperationalError, sqlite3.ProgrammingError), match="closed"):
        connection.cursor().execute("SELECT 1")


def test_to_migrate_twice_changes_nothing(store: Store) -> None:
    job = queued(store)
    store.migrate()
    assert store.jobs.get(job.id).state == "queued"


@pytest.mark.skipif(os.name != "posix", reason="file modes of POSIX")
def test_only_its_owner_can_read_a_new_database(tmp_path: Path) -> None:
    with migrated_store(f"sqlite:///{tmp_path}/shop.sqlite"):
        modes = {file.name: stat.S_IMODE(file.stat().st_mode) for file in tmp_path.iterdir()}
    assert set(modes) == {"shop.sqlite", "shop.sqlite-wal", "shop.sqlite-shm"}
    assert set(modes.values()) == {0o600}


@pytest.mark.parametrize("url", ["nonsense", "sqlite://", "sqlite:///:memory:", "mysql://h/d", ""])
def test_a_database_that_cannot_be_used_is_refused_with_a_hint(url: str) -> None:
    with pytest.raises(StoreError) as caught:
        Store(url)
    assert "sqlite:///FILE" in caught.value.hint


def test_a_password_in_a_url_that_cannot_be_used_is_not_shown() -> None:
    with pytest.raises(StoreError) as caught:
        Store("postgresql://shop:s3cret@db.example:port/shop")
    assert "db.example" in caught.value.text
    assert "s3cret" not in f"{caught.value.text} {caught.value.hint}"


def test_a_profile_counts_its_changes_and_is_never_overwritten_unseen(store: Store) -> None:
    first = store.profiles.save("acme", "Acme", "title = 'Acme'", None)
    assert first.version == 1
    with pytest.raises(WrongState, match="already exists, at version 1"):
        store.profiles.save("acme", "Other", "", None)
    assert store.profiles.save("acme", "B", "title = 'B'", 1).version == 2
    with pytest.raises(StaleVersion, match=r"at version 2.*on version 1") as caught:
        store.profiles.save("acme", "C", "", 1)
    assert 'If-Match: "2"' in caught.value.hint
    kept = store.profiles.get("acme")
    assert kept is not None
    assert (kept.title, kept.text) == ("B", "title = 'B'")
    with pytest.raises(StaleVersion):
        store.profiles.delete("acme", 1)
    store.profiles.delete("acme", 2)
    assert store.profiles.get("acme") is None
    with pytest.raises(NotFound):
        store.profiles.save("acme", "C", "", 2)
    assert store.profiles.save("acme", "D", "", None, replace_any=True).version == 1
