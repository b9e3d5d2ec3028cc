"""knifetip db, backup and restore: exit codes, what is printed, and what is never overwritten."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from knifetip.service.store import Store
from tests.support.command import Command
from tests.support.stored import add_drawing, add_job


@pytest.fixture
def shop(tmp_path: Path) -> Path:
    """Return the file of a database that contains one drawing and a job for it."""
    file = tmp_path / "shop.sqlite"
    with closing(Store(f"sqlite:///{file}")) as store:
        store.migrate()
        add_job(store)
    return file


@pytest.fixture
def knifetip(knifetip: Command, shop: Path, monkeypatch: pytest.MonkeyPatch) -> Command:
    """Return the function that runs ``knifetip``; its default database is ``shop``."""
    monkeypatch.setenv("KNIFETIP_DATABASE", f"sqlite:///{shop}")
    return knifetip


def drawings(file: Path) -> int:
    with closing(sqlite3.connect(file)) as database:
        (count,) = database.execute("SELECT count(*) FROM drawing").fetchone()
    return int(count)


def set_revision(file: Path, revision: str) -> None:
    with closing(sqlite3.connect(file)) as database:
        database.execute("UPDATE alembic_version SET version_num = ?", (revision,))
        database.commit()


def test_a_current_database_is_reported_as_up_to_date(knifetip: Command) -> None:
    for word in ("current", "check"):
        code, out, _ = knifetip("db", word)
        assert code == 0
        assert "up to date" in out
    assert knifetip("db", "upgrade")[:2] == (0, "The tables are up to date.\n")


def test_check_and_serve_refuse_a_database_of_a_newer_version(
    knifetip: Command, shop: Path
) -> None:
    set_revision(shop, "9999")
    assert "newer than" in knifetip("db", "current")[1]
    for words in (("db", "check"), ("db", "upgrade"), ("serve", "--port", "0"), ("worker",)):
        code, _, err = knifetip(*words)
        assert code == 3
        assert "revision 9999" in err
        assert "restore a backup" in err
    assert drawings(shop) == 1


def test_reading_a_missing_database_does_not_create_it(knifetip: Command, tmp_path: Path) -> None:
    for words in (("db", "current"), ("db", "check"), ("backup", tmp_path / "copy")):
        code, _, err = knifetip(*words, "--database", f"sqlite:///{tmp_path}/none.sqlite")
        assert code == 3
        assert "none.sqlite" in err
    assert not (tmp_path / "none.sqlite").exists()
    assert not (tmp_path / "copy").exists()


def test_a_backup_replaces_no_file_without_the_option(knifetip: Command, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    copy.write_text("mine")
    assert knifetip("backup", copy)[0] == 3
    assert copy.read_text() == "mine"
    assert knifetip("backup", copy, "--replace")[0] == 0
    assert drawings(copy) == 1
    assert not list(tmp_path.glob("copy-*"))  # no write-ahead log


def test_a_restored_database_replaces_the_former_one_which_is_kept(
    knifetip: Command, shop: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "copy"
    assert knifetip("backup", copy)[0] == 0
    with closing(Store(f"sqlite:///{shop}")) as store:
        add_drawing(store)
    assert knifetip("restore", copy)[0] == 3
    assert drawings(shop) == 2
    code, out, _ = knifetip("restore", copy, "--replace")
    assert code == 0
    assert drawings(shop) == 1
    (kept,) = tmp_path.glob("shop.sqlite.replaced.*")
    assert str(kept) in out
    assert drawings(kept) == 2


def test_a_database_in_use_is_not_replaced(knifetip: Command, shop: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    assert knifetip("backup", copy)[0] == 0
    with closing(Store(f"sqlite:///{shop}")) as store:
        assert store.alive()
        code, _, err = knifetip("restore", copy, "--replace")
        assert code == 3
        assert "is in use" in err
    assert knifetip("restore", copy, "--replace")[0] == 0


def test_the_log_of_a_deleted_database_is_not_applied_to_the_restored_one(
    knifetip: Command, shop: Path, tmp_path: Path
) -> None:
    copy, log = tmp_path / "copy", tmp_path / "shop.sqlite-wal"
    assert knifetip("backup", copy)[0] == 0
    # A server was killed, so that its log remained; then a person deleted the database.
    with closing(Store(f"sqlite:///{shop}")) as store:
        add_drawing(store)
        assert drawings(shop) == 2
        left = log.read_bytes()
    shop.unlink()
    log.write_bytes(left)
    assert knifetip("restore", copy)[0] == 0
    assert drawings(shop) == 1
    (kept,) = tmp_path.glob("shop.sqlite.replaced.*-wal")
    assert kept.read_bytes() == left


def test_a_damaged_database_is_replaced_and_kept(
    knifetip: Command, shop: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "copy"
    assert knifetip("backup", copy)[0] == 0
    shop.write_bytes(b"x" * 4096)
    code, out, err = knifetip("restore", copy, "--replace")
    assert code == 0, err
    assert drawings(shop) == 1
    (kept,) = tmp_path.glob("shop.sqlite.replaced.*")
    assert str(kept) in out
    assert kept.read_bytes() == b"x" * 4096


def test_only_a_whole_backup_of_knifetip_is_restored(
    knifetip: Command, shop: Path, tmp_path: Path
) -> None:
    text, foreign, torn, newer = (tmp_path / name for name in ("text", "foreign", "torn", "newer"))
    text.write_text("no database at all, but longer than the head of one" * 10)
    with closing(sqlite3.connect(foreign)) as database:
        database.execute("CREATE TABLE mine (id INTEGER)")
    assert knifetip("backup", torn)[0] == 0
    torn.write_bytes(torn.read_bytes()[:-8192])
    assert knifetip("backup", newer)[0] == 0
    set_revision(newer, "9999")
    orphans = tmp_path / "orphans"
    assert knifetip("backup", orphans)[0] == 0
    with closing(sqlite3.connect(orphans)) as database:
        database.execute("DELETE FROM drawing")
        database.commit()
    for file in (text, foreign, torn, newer, orphans, tmp_path / "none"):
        code, _, err = knifetip("restore", file, "--replace")
        assert code == 3, file
        assert str(file) in err
    assert drawings(shop) == 1
    assert not list(tmp_path.glob("shop.sqlite.replaced.*"))


def test_backup_names_the_commands_of_postgresql_and_no_password(
    knifetip: Command, tmp_path: Path
) -> None:
    url = "postgresql://shop:secret@localhost/knifetip"
    for word in ("backup", "restore"):
        code, _, err = knifetip(word, tmp_path / "copy", "--database", url)
        assert code == 3
        assert "pg_dump" in err
        assert "pg_restore" in err
        assert "secret" not in err
