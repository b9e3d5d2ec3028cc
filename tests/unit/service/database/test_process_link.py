"""Names of processes, and notifications between them, in SQLite and PostgreSQL."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psycopg
import pytest

from knifetip.errors import StoreError
from knifetip.service.database import postgres_link
from knifetip.service.database.change_notifier import RECEIVED, ChangeNotifier, machine_topic
from knifetip.service.database.engine import dialect_url
from knifetip.service.database.process_link import ProcessLink, join
from knifetip.service.store import Store
from tests.support.stored import add_job, migrated_store

_HOLD_NAME = """
import sys, time
from knifetip.service.database.change_notifier import ChangeNotifier
from knifetip.service.database.process_link import join
link = join(sys.argv[1], ChangeNotifier(), sys.argv[2], "worker")
print("joined", flush=True)
time.sleep(600)
"""


@pytest.fixture(autouse=True)
def _state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@contextmanager
def joined(
    url: str, name: str = "", changes: ChangeNotifier | None = None
) -> Iterator[ProcessLink]:
    link = join(dialect_url(url), changes or ChangeNotifier(), name, "server")
    try:
        yield link
    finally:
        link.close()


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(postgres_link, "_PATIENCE", 0.0)


@pytest.mark.usefixtures("impatient")
def test_two_processes_with_one_name_refuse_each_other(database_url: str) -> None:
    with joined(database_url, "press hall"):
        with pytest.raises(StoreError, match="with the name press hall"):
            join(dialect_url(database_url), ChangeNotifier(), "press hall", "worker")
        with joined(database_url, "press hall 2") as other:
            assert other.name == "press hall 2"
    with joined(database_url, "press hall") as again:
        assert again.name == "press hall"


def test_the_name_of_a_killed_process_is_free(database_url: str) -> None:
    holder = subprocess.Popen(
        [sys.executable, "-c", _HOLD_NAME, dialect_url(database_url), "a"],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert holder.stdout is not None
    try:
        assert holder.stdout.readline() == "joined\n"
    finally:
        holder.kill()
        holder.wait()
        holder.stdout.close()
    with joined(database_url, "a") as link:
        assert link.name == "a"


@pytest.mark.usefixtures("impatient")
def test_default_names_differ_and_remain_after_a_restart(database_url: str) -> None:
    with joined(database_url) as first, joined(database_url) as second:
        names = [first.name, second.name]
    assert names[0] != names[1]
    with joined(database_url) as first, joined(database_url) as second:
        assert [first.name, second.name] == names


@contextmanager
def linked_store(url: str, name: str) -> Iterator[Store]:
    with migrated_store(url) as store, joined(url, name, store.changes):
        # The link first wakes all subscribers.
        until(lambda: store.changes.connected)
        yield store


def until(condition: object) -> None:
    assert callable(condition)
    end = time.monotonic() + 60.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_a_change_wakes_its_subscribers_in_another_process(migrated_postgresql: str) -> None:
    with (
        linked_store(migrated_postgresql, "a") as here,
        linked_store(migrated_postgresql, "b") as there,
    ):
        received, table, router = (threading.Event() for _ in range(3))
        with (
            there.changes.subscribed(received.set, RECEIVED),
            there.changes.subscribed(table.set, machine_topic("demo-table")),
            there.changes.subscribed(router.set, machine_topic("router-table")),
        ):
            for event in (received, table, router):
                event.clear()
            here.changes.notify([machine_topic("router-table")])
            assert router.wait(10.0)
            assert not received.is_set()
            assert not table.is_set()
            add_job(here)
            assert received.wait(10.0)


def test_a_notification_does_not_come_back_to_its_sender(migrated_postgresql: str) -> None:
    with (
        linked_store(migrated_postgresql, "a") as here,
        linked_store(migrated_postgresql, "b") as there,
    ):
        calls: list[int] = []
        with here.changes.subscribed(lambda: calls.append(1), RECEIVED):
            here.changes.notify([RECEIVED])
            assert len(calls) == 1
            # A later notification was received, so this one was received too.
            woken = threading.Event()
            with here.changes.subscribed(woken.set, machine_topic("table")):
                there.changes.notify([machine_topic("table")])
                assert woken.wait(10.0)
            assert len(calls) == 1


def test_a_lost_connection_is_made_again_and_wakes_all(migrated_postgresql: str) -> None:
    with (
        linked_store(migrated_postgresql, "a") as here,
        linked_store(migrated_postgresql, "b") as there,
    ):
        woken = threading.Event()
        with there.changes.subscribed(woken.set, machine_topic("a table")):
            woken.clear()
            url = migrated_postgresql.replace("+psycopg", "")
            with psycopg.connect(url, autocommit=True) as admin:
                admin.execute(
                    "SELECT pg_terminate_backend(pid) FROM pg_stat_activity"
                    " WHERE application_name = 'knifetip b'"
                )
            assert woken.wait(10.0)
            until(lambda: there.changes.connected)
            woken.clear()
            here.changes.notify([machine_topic("a table")])
            assert woken.wait(10.0)


def test_a_notification_that_was_not_sent_is_sent_by_the_next_connection(
    migrated_postgresql: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    send, failed = postgres_link.PostgresLink._send, threading.Event()

    def fail_once(link: postgres_link.PostgresLink, connection: psycopg.Connection) -> None:
        if link.name == "a" and link._topics and not failed.is_set():
            failed.set()
            connection.close()
        send(link, connection)

    with (
        linked_store(migrated_postgresql, "a") as here,
        linked_store(migrated_postgresql, "b") as there,
    ):
        monkeypatch.setattr(postgres_link.PostgresLink, "_send", fail_once)
        woken = threading.Event()
        with there.changes.subscribed(woken.set, machine_topic("a table")):
            here.changes.notify([machine_topic("a table")])
            assert woken.wait(20.0)
        assert failed.is_set()


def test_a_waiting_link_uses_no_processor_time(migrated_postgresql: str) -> None:
    with linked_store(migrated_postgresql, "a"):
        before, began = time.process_time(), time.monotonic()
        time.sleep(1.0)
        assert time.process_time() - before < 0.2 * (time.monotonic() - began)
