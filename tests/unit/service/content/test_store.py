"""Contents of drawings and jobs by their SHA-256: in the database, a folder, or a bucket."""

from __future__ import annotations

import hashlib
import os
import threading
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import pytest
import sqlalchemy as sa

from knifetip.errors import ContentLost, StoreError
from knifetip.model.interpretation import Interpretation
from knifetip.service.content import store as content_store
from knifetip.service.content.objects import open_objects
from knifetip.service.content.store import address_of
from knifetip.service.database.tables import Content, Drawing, Job
from knifetip.service.drawings.store import NewDrawing
from knifetip.service.store import Store
from tests.support.job_states import RESULT, compiling
from tests.support.stored import Clock

DAY = 86_400.0
FILE = b"0\nSECTION\n" * 1000
PROGRAM = b"G1 X10\n" * 1000
SOUND = replace(RESULT, program=PROGRAM, sha256=hashlib.sha256(PROGRAM).hexdigest())


@pytest.fixture(params=["database", "folder"])
def anywhere(
    request: pytest.FixtureRequest, migrated_url: str, clock: Clock, tmp_path: Path
) -> Iterator[Store]:
    """A store whose large values are in the database, then one with a folder."""
    objects = "" if request.param == "database" else (tmp_path / "contents").as_uri()
    store = Store(migrated_url, clock, objects)
    yield store
    store.close()


def upload(store: Store, content: bytes = FILE) -> Drawing:
    return store.drawings.add(
        NewDrawing(
            "tray.dxf", content, address_of(content), Interpretation("mm"), {}, b"edges", b"report"
        )
    )


def contents(store: Store) -> set[str]:
    with store.database.reading() as session:
        return set(session.scalars(sa.select(Content.address)))


def compiled(store: Store) -> Job:
    job = compiling(store)
    store.compiles.save_result(job.id, job.epoch, SOUND, "5e" * 32)
    return store.jobs.get(job.id)


def stored_files(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.rglob("*") if path.is_file())


def test_equal_files_are_stored_once_and_read_back(anywhere: Store, tmp_path: Path) -> None:
    first, second = upload(anywhere), upload(anywhere)
    assert first.content_address == second.content_address == address_of(FILE)
    assert contents(anywhere) == {address_of(data) for data in (FILE, b"", b"edges", b"report")}
    for drawing in (first, second):
        row = anywhere.drawings.get_with(drawing.id, "content", "edges")
        assert (row.content, row.edges) == (FILE, b"edges")
        assert anywhere.drawings.column(drawing.id, "content") == FILE
    in_folder = [address_of(FILE)] if (tmp_path / "contents").exists() else []
    assert stored_files(tmp_path / "contents") == in_folder


def test_a_value_that_was_not_loaded_is_no_empty_value(anywhere: Store) -> None:
    row = anywhere.drawings.get(upload(anywhere).id)
    with pytest.raises(AttributeError, match=r"Drawing\.content is not loaded"):
        _ = row.content


def test_a_content_is_deleted_a_day_after_its_last_row(
    anywhere: Store, clock: Clock, tmp_path: Path
) -> None:
    first, second = upload(anywhere), upload(anywhere)
    anywhere.drawings.delete(first.id)
    for _ in range(3):
        assert anywhere.contents.sweep() == 0
        clock.now += 2 * DAY
    anywhere.drawings.delete(second.id)
    assert anywhere.contents.sweep() == 0
    clock.now += DAY - 1.0
    assert anywhere.contents.sweep() == 0
    clock.now += 2.0
    assert anywhere.contents.sweep() == 4
    assert contents(anywhere) == set()
    assert stored_files(tmp_path / "contents") == []


def test_a_content_that_is_used_again_is_no_longer_marked(anywhere: Store, clock: Clock) -> None:
    anywhere.drawings.delete(upload(anywhere).id)
    anywhere.contents.sweep()
    clock.now += DAY / 2
    again = upload(anywhere)
    anywhere.contents.sweep()
    clock.now += DAY
    assert anywhere.contents.sweep() == 0
    anywhere.drawings.delete(again.id)
    anywhere.contents.sweep()  # the mark is new
    clock.now += DAY / 2
    assert anywhere.contents.sweep() == 0
    assert address_of(FILE) in contents(anywhere)


def test_a_content_that_is_announced_during_a_sweep_keeps_its_day(
    migrated_url: str, clock: Clock, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store(migrated_url, clock, (tmp_path / "contents").as_uri())
    store.drawings.delete(upload(store).id)
    mark = store.contents._mark

    def announce(addresses: Sequence[str], since: float | None) -> None:
        clock.now += 5.0  # the sweep is slow
        store.contents.stage(content=FILE)
        mark(addresses, since)

    with monkeypatch.context() as patch:
        patch.setattr(store.contents, "_mark", announce)
        store.contents.sweep()
    clock.now += DAY - 1.0
    store.contents.sweep()
    assert stored_files(tmp_path / "contents") == [address_of(FILE)]
    clock.now += 2.0
    store.contents.sweep()
    assert stored_files(tmp_path / "contents") == []
    store.close()


def test_what_a_transaction_under_way_refers_to_is_not_deleted(
    anywhere: Store, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    anywhere.drawings.delete(upload(anywhere).id)
    anywhere.contents.sweep()
    clock.now += 2 * DAY
    kept = anywhere.contents.keep
    referred, swept = threading.Event(), threading.Event()

    def keep(session: sa.orm.Session, staged: content_store.StagedContents) -> dict[str, str]:
        columns = kept(session, staged)
        referred.set()
        # With SQLite the sweep waits for this transaction, with PostgreSQL for the row.
        swept.wait(0.3)
        return columns

    monkeypatch.setattr(anywhere.contents, "keep", keep)
    drawings: list[Drawing] = []
    uploading = threading.Thread(target=lambda: drawings.append(upload(anywhere)))
    uploading.start()
    assert referred.wait(10.0)
    anywhere.contents.sweep()
    swept.set()
    uploading.join(10.0)
    assert anywhere.drawings.column(drawings[0].id, "content") == FILE


def damage(store: Store, address: str, folder: Path, data: bytes | None) -> None:
    """Replace a content in the folder or, if it is not there, in the database; None removes it."""
    path = folder / address[:2] / address
    if not path.exists():
        with store.database.writing() as session:
            session.execute(sa.update(Content).where(Content.address == address).values(data=data))
    elif data is None:
        path.unlink()
    else:
        path.write_bytes(data)


@pytest.mark.parametrize("altered", [True, False])
def test_a_damaged_program_is_an_error_and_answers_no_job(
    anywhere: Store, tmp_path: Path, altered: bool
) -> None:
    first = compiled(anywhere)
    data = PROGRAM[:-1] + b"X" if altered else None
    damage(anywhere, address_of(PROGRAM), tmp_path / "contents", data)
    with pytest.raises(StoreError, match=first.id) as caught:
        anywhere.jobs.column(first.id, "program")
    if altered:
        assert isinstance(caught.value, ContentLost)
    second = compiling(anywhere)
    assert not anywhere.compiles.answer(second.id, second.epoch, "5e" * 32)
    # The compile that follows gives the same bytes, which mend the damage.
    anywhere.compiles.save_result(second.id, second.epoch, SOUND, "5e" * 32)
    assert anywhere.jobs.column(first.id, "program") == PROGRAM


def test_nothing_is_stored_if_the_folder_cannot_be_written(
    database_url: str, clock: Clock, tmp_path: Path
) -> None:
    folder = tmp_path / "contents"
    store = Store(database_url, clock, folder.as_uri())
    store.migrate()
    folder.rmdir()
    folder.write_bytes(b"a file in its place")
    with pytest.raises(StoreError, match="cannot be used"):
        upload(store)
    assert store.drawings.recent(None, 10) == []
    store.close()


def test_contents_of_a_folder_need_the_option(
    database_url: str, clock: Clock, tmp_path: Path
) -> None:
    with_folder = Store(database_url, clock, (tmp_path / "contents").as_uri())
    with_folder.migrate()
    drawing = upload(with_folder)
    with_folder.close()
    without = Store(database_url, clock)
    with pytest.raises(StoreError, match="outside the database"):
        without.drawings.column(drawing.id, "content")
    clock.now += 10 * DAY
    without.drawings.delete(drawing.id)
    without.contents.sweep()
    clock.now += 2 * DAY
    without.contents.sweep()
    assert contents(without) == {address_of(FILE)}  # its file could not be deleted
    upload(without)  # writes it to the database
    assert without.drawings.get_with(upload(without).id, "content").content == FILE
    without.close()


def test_files_are_on_the_disk_before_their_row(
    database_url: str, clock: Clock, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[str] = []
    fsync = os.fsync

    def recorded(handle: int) -> None:
        synced.append(os.readlink(f"/proc/self/fd/{handle}"))
        fsync(handle)

    monkeypatch.setattr(os, "fsync", recorded)
    store = Store(database_url, clock, (tmp_path / "contents").as_uri())
    store.migrate()
    upload(store)
    address = address_of(FILE)
    path = tmp_path / "contents" / address[:2] / address
    assert synced[:2] == [str(path), str(path.parent)]
    store.close()


@pytest.mark.parametrize(
    "url", ["contents", "file://contents", "file:///", "s3://", "s3://key:secret@bucket", "ftp://a"]
)
def test_other_urls_are_refused_with_a_hint(url: str) -> None:
    with pytest.raises(StoreError) as caught:
        open_objects(url)
    assert "s3://BUCKET/PREFIX" in caught.value.hint


def test_without_the_extra_the_error_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "obstore.store", None)
    assert open_objects("") is None
    with pytest.raises(StoreError) as caught:
        open_objects(tmp_path.as_uri())
    assert "knifetip[s3]" in caught.value.hint


def test_the_default_does_not_import_obstore() -> None:
    import subprocess
    import sys

    code = "import sys, knifetip.service.store; sys.exit('obstore' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
