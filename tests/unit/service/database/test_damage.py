"""A damaged SQLite file is found by backup, doctor, readiness and every request."""

from __future__ import annotations

import asyncio
import logging
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
import sqlalchemy as sa
import sqlalchemy.exc

from knifetip.errors import StoreError
from knifetip.server.machine_reservation import reserved_machine
from knifetip.service.database.damage import find_damage, unusable
from knifetip.service.database.engine import Database
from knifetip.service.monitoring.fault_log import FaultLog
from knifetip.service.monitoring.readiness import DamageWatch
from knifetip.service.refusals.failures import failure_of
from knifetip.service.store import Store
from tests.support.command import Command


def url_of(file: Path) -> str:
    return f"sqlite:///{file}"


@pytest.fixture
def shop(tmp_path: Path) -> Path:
    """Return a database file whose page 30 has random bytes."""
    file = tmp_path / "shop.sqlite"
    with closing(Database(url_of(file))) as database:
        database.prepare()
    with closing(sqlite3.connect(file)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    assert find_damage(file) == ""
    with file.open("r+b") as content:
        content.seek(29 * 4096)
        content.write(bytes(range(256)) * 128)
    return file


def test_the_fault_is_found_and_a_file_of_another_format_too(shop: Path, tmp_path: Path) -> None:
    assert find_damage(shop) != ""
    other = tmp_path / "text.sqlite"
    other.write_bytes(b"this is no database" * 1000)
    assert "not a database" in find_damage(other)


def test_a_backup_of_a_damaged_database_is_refused_and_keeps_the_good_copy(
    shop: Path, tmp_path: Path, knifetip: Command
) -> None:
    good = tmp_path / "backup.sqlite"
    good.write_bytes(b"the copy of yesterday")
    code, _, err = knifetip("backup", str(good), "--replace", "--database", url_of(shop))
    assert code == 3
    assert "is damaged" in err
    assert "knifetip restore" in err
    assert good.read_bytes() == b"the copy of yesterday"
    assert list(tmp_path.glob("*.part")) == []


def test_a_damaged_database_can_be_replaced_by_a_backup(
    shop: Path, tmp_path: Path, knifetip: Command
) -> None:
    copy = tmp_path / "copy.sqlite"
    with closing(Database(url_of(copy))) as database:
        database.prepare()
    code, _, err = knifetip("restore", str(copy), "--replace", "--database", url_of(shop))
    assert code == 0, err
    assert find_damage(shop) == ""
    assert [find_damage(kept) != "" for kept in tmp_path.glob("shop.sqlite.replaced.*Z")] == [True]


def test_doctor_names_the_damage(shop: Path, knifetip: Command) -> None:
    code, out, err = knifetip("doctor", "--database", url_of(shop))
    assert code != 0
    assert "is damaged" in out + err


async def test_readiness_reports_the_damage_and_its_end(shop: Path, tmp_path: Path) -> None:
    now = 0.0
    with closing(Store(url_of(shop))) as store:
        watch = DamageWatch(store, lambda: now)
        assert watch.fault() == "ok"  # the first check has begun
        await watch.ended()
        assert watch.fault() == "damaged"
    with closing(Store(url_of(tmp_path / "good.sqlite"))) as store:
        store.prepare()
        watch = DamageWatch(store, lambda: now)
        watch.fault()
        await watch.ended()
        # A request was refused: it is damaged until a check that begins at once finds it good.
        watch.report()
        assert watch.fault() == "damaged"
        await watch.ended()
        assert watch.fault() == "ok"


@pytest.mark.parametrize(
    ("code", "status", "message"),
    [
        (sqlite3.SQLITE_CORRUPT, 503, "server.database-damaged"),
        (sqlite3.SQLITE_CORRUPT_INDEX, 503, "server.database-damaged"),
        (sqlite3.SQLITE_NOTADB, 503, "server.database-damaged"),
        (sqlite3.SQLITE_FULL, 507, "limit.disk-full"),
        (sqlite3.SQLITE_BUSY, 503, "server.database-silent"),
    ],
)
def test_the_answer_to_a_request_names_the_cause(code: int, status: int, message: str) -> None:
    failure = failure_of(refused(code))
    assert (failure.status, failure.message.code) == (status, message)


def refused(code: int) -> sqlalchemy.exc.DBAPIError:
    cause = sqlite3.DatabaseError("refused")
    cause.sqlite_errorcode = code
    return sqlalchemy.exc.DatabaseError("SELECT 1", {}, cause)


async def test_a_failing_database_is_logged_once_and_its_end_too(
    caplog: pytest.LogCaptureFixture,
) -> None:
    fails = True

    def probe() -> None:
        if fails:
            raise refused(sqlite3.SQLITE_FULL)

    log = FaultLog(probe, pause=0.001)
    with caplog.at_level(logging.WARNING, "knifetip.api"):
        for _ in range(50):
            log.note("limit.disk-full", refused(sqlite3.SQLITE_FULL), "POST /api/jobs")
            await asyncio.sleep(0.0)
        assert len(caplog.records) == 1
        fails = False
        async with asyncio.timeout(120.0):
            while len(caplog.records) < 2:
                await asyncio.sleep(0.001)
    assert "answers again after limit.disk-full" in caplog.records[1].getMessage()
    await log.close()


def test_a_read_only_database_is_a_sentence(tmp_path: Path) -> None:
    engine = sa.create_engine(f"sqlite:///file:{tmp_path}/none.sqlite?mode=ro&uri=true")
    with pytest.raises(sqlalchemy.exc.OperationalError) as raised:
        engine.connect()
    text = str(unusable(raised.value))
    assert "unable to open database file" in text
    assert "sqlalche.me" not in text


@pytest.mark.parametrize(
    "command",
    [
        ("serve", "--port", "0"),
        ("worker",),
        ("db", "upgrade"),
        ("user", "list"),
        ("key", "list"),
    ],
)
def test_a_folder_that_cannot_be_made_ends_every_command_with_a_sentence(
    tmp_path: Path, knifetip: Command, command: tuple[str, ...]
) -> None:
    (tmp_path / "file").write_text("no folder")
    place = f"sqlite:///{tmp_path}/file/inside/shop.sqlite"
    code, _, err = knifetip(*command, "--database", place)
    assert code == 3
    assert "cannot be used" in err or "does not exist" in err
    assert "Traceback" not in err


def test_a_second_server_does_not_get_the_machine_of_the_first(tmp_path: Path) -> None:
    journal = tmp_path / "shop.sqlite.gateway.jsonl"
    with (
        reserved_machine(journal, "demo-table", 8080),
        pytest.raises(StoreError, match=r"\(port 8080, process \d+\).* demo-table"),
        reserved_machine(journal, "demo-table", 8081),
    ):
        pass
    with reserved_machine(journal, "demo-table", 8081):
        pass
