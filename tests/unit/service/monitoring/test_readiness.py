"""Readiness: on a full disk the server reports it, stores nothing partially, and continues."""

from __future__ import annotations

import errno
import shutil
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx
import pytest
import sqlalchemy as sa

from knifetip.errors import StoreError
from knifetip.service.compiling.service import CompileService
from knifetip.service.content.store import ContentStore
from knifetip.service.database.damage import is_disk_full
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import WriteProbe
from knifetip.service.database.write_probe import write_probe
from knifetip.service.limits import disk_space as storage_module
from knifetip.service.monitoring import readiness as readiness_module
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.serving.server import order_job, run_server, square, upload_drawing

pytestmark = pytest.mark.xdist_group("readiness")

MEGABYTE = 1 << 20


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """Folder on a disk of its own with 24 MB; skips where no file system can be mounted."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = shutil.which("mount")
    if sys.platform != "linux" or mount is None:
        pytest.skip("no file system can be mounted on this system")
    command = [mount, "-t", "tmpfs", "-o", "size=24m", "tmpfs", str(folder)]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("this user may not mount a file system")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "--lazy", str(folder)], check=True)


@pytest.fixture(autouse=True)
def _no_kept_results(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(readiness_module, "_KEEP", 0.0)
    monkeypatch.setattr(readiness_module, "_KEEP_CONTENTS", 0.0)


def fill(folder: Path, leave: int = 0) -> Path:
    """Fill the disk of a folder except for some bytes; return the file that does it."""
    file = folder / "other-data"
    count = shutil.disk_usage(folder).free - leave
    with file.open("wb", buffering=0) as opened, suppress(OSError):
        while count > 0:
            count -= opened.write(bytes(min(count, 65536)))
    assert shutil.disk_usage(folder).free <= leave + 65536
    return file


def claim_job(client: httpx.Client) -> dict[str, object]:
    job = order_job(client, upload_drawing(client, square())["id"], release=True)["id"]
    ask = {"gateway": "g", "machine": "demo-table", "wait": 50}
    claim = client.post("/api/gateway/claim", json=ask).json()
    assert claim["job"] == job
    return {"job": job, "epoch": claim["epoch"], "line": 1}


def test_with_little_space_uploads_and_orders_are_refused_and_the_job_goes_on(
    small_disk: Path,
) -> None:
    settings = Settings(database=f"sqlite:///{small_disk}/shop.sqlite", name="test", min_free=2)
    with run_server(settings) as client:
        beat = claim_job(client)
        before = client.get("/api/drawings").json()
        assert client.get("/readyz").status_code == 200
        other = fill(small_disk, leave=MEGABYTE)

        ready = client.get("/readyz")
        assert ready.status_code == 503
        assert ready.json()["status"] == "failing"
        assert ready.json()["checks"]["disk"].endswith("MB free, 2 MB needed")
        assert ready.json()["checks"]["database"] == "ok"
        refused = client.post("/api/drawings", files={"file": ("b.dxf", square(side=200.0))})
        assert refused.status_code == 507
        assert refused.json()["code"] == "limit.disk-low"
        order = {"drawing": before[0]["id"], "board": "e-flute"}
        assert client.post("/api/jobs", json=order).status_code == 507

        for _ in range(20):
            assert client.post("/api/gateway/heartbeat", json=beat).status_code == 200
        done = {"job": beat["job"], "epoch": beat["epoch"], "outcome": "done"}
        assert client.post("/api/gateway/finish", json=done).status_code == 200
        assert client.get(f"/api/jobs/{beat['job']}").json()["state"] == "done"

        other.unlink()
        assert client.get("/readyz").status_code == 200
        assert client.get("/api/drawings").json() == before
        upload_drawing(client, square(side=200.0))


def test_on_a_full_disk_nothing_half_is_stored(small_disk: Path) -> None:
    settings = Settings(database=f"sqlite:///{small_disk}/shop.sqlite", name="test", min_free=0)
    with run_server(settings) as client:
        beat = claim_job(client)
        before = client.get("/api/drawings").json()
        other = fill(small_disk)
        # Comments make the file large, so that it cannot fit into space that the database has kept.
        large = square(extra=("999\n" + "x" * 100 + "\n",) * 60_000)
        refused = client.post("/api/drawings", files={"file": ("large.dxf", large)})
        assert refused.status_code == 507, refused.text
        assert refused.json()["code"] == "limit.disk-full"
        ready = client.get("/readyz")
        assert ready.status_code == 503
        assert "ok" not in {ready.json()["status"], ready.json()["checks"]["disk"]}

        other.unlink()
        assert client.get("/api/drawings").json() == before
        assert client.get("/readyz").status_code == 200
        assert client.post("/api/gateway/heartbeat", json=beat).status_code == 200
        assert client.get(f"/api/jobs/{beat['job']}").json()["state"] == "running"


def test_a_probe_writes(database_url: str) -> None:
    store = Store(database_url, clock=lambda: 1234.5)
    store.prepare()
    write_probe(store.database)
    with store.database.reading() as session:
        assert session.scalars(sa.select(WriteProbe.at)).all() == [1234.5]
    store.close()


def test_a_database_that_cannot_be_written_is_not_ready(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        assert client.get("/readyz").json()["checks"]["database"] == "ok"

        def refuse(_database: Database) -> None:
            raise sa.exc.OperationalError("UPDATE", {}, sqlite3.OperationalError("read-only"))

        monkeypatch.setattr(readiness_module, "write_probe", refuse)
        ready = client.get("/readyz")
        assert ready.status_code == 503
        assert ready.json()["checks"]["database"] == "OperationalError"
        assert ready.json()["status"] == "failing"


def readiness(client: httpx.Client, status: int) -> httpx.Response:
    """Return the answer of /readyz as soon as it has a status; fail after 10 s without it."""
    end = time.monotonic() + 60.0
    while (ready := client.get("/readyz")).status_code != status:
        assert time.monotonic() < end, ready.text
        time.sleep(0.01)
    return ready


def test_a_damaged_database_is_not_ready_until_a_check_finds_it_good(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(readiness_module, "_KEEP_DAMAGE", 0.0)
    faults = [""]
    monkeypatch.setattr(Database, "damage", lambda _: faults[-1])
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        assert client.get("/readyz").status_code == 200
        faults.append("Page 7 is never used.")
        ready = readiness(client, 503)
        assert ready.json()["status"] == "failing"
        checks = ready.json()["checks"]
        assert checks.pop("database") == "damaged"
        assert set(checks.values()) == {"ok"}
        faults.append("")
        assert readiness(client, 200).json()["checks"]["database"] == "ok"


@contextmanager
def hanging(monkeypatch: pytest.MonkeyPatch, owner: object, name: str) -> Iterator[list[int]]:
    """Replace a check by one that does not end before the block; yield an entry for each call."""
    began: list[int] = []
    end = threading.Event()

    def hang(_owner: object) -> None:
        began.append(1)
        assert end.wait(60.0)

    monkeypatch.setattr(owner, name, hang)
    try:
        yield began
    finally:
        end.set()


def test_a_check_that_hangs_occupies_one_thread_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        monkeypatch.setattr(readiness_module, "_PATIENCE", 0.01)
        with hanging(monkeypatch, readiness_module, "write_probe") as began:
            for _ in range(3):
                assert client.get("/readyz").json()["checks"]["database"] == "no answer"
            assert len(began) == 1
        monkeypatch.setattr(readiness_module, "_PATIENCE", 60.0)
        assert client.get("/readyz").status_code == 200


def test_a_folder_that_cannot_be_written_is_not_ready(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    storage = storage_module.Storage(f"sqlite:///{tmp_path}/shop.sqlite", 0)
    assert storage.fault() == "ok"

    def refuse(**_options: object) -> None:
        raise OSError(errno.EROFS, "Read-only file system")

    monkeypatch.setattr("tempfile.TemporaryFile", refuse)
    assert storage.fault() == "not writable: Read-only file system"


def test_a_store_that_cannot_be_used_is_not_ready(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        assert client.get("/readyz").json()["checks"]["contents"] == "ok"

        def lose(_contents: ContentStore) -> None:
            raise StoreError("content.unavailable", url="s3://secret", reason="connection refused")

        monkeypatch.setattr(ContentStore, "probe", lose)
        ready = client.get("/readyz")
        assert ready.status_code == 503
        assert ready.json()["checks"]["contents"] == "not usable"
        assert ready.json()["checks"]["database"] == "ok"
        assert "secret" not in ready.text


def test_a_silent_store_does_not_hide_the_state_of_the_database(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        monkeypatch.setattr(readiness_module, "_PATIENCE", 1.0)
        with hanging(monkeypatch, ContentStore, "probe") as began:
            found = [client.get("/readyz").json()["checks"] for _ in range(2)]
            while found[-1]["database"] != "ok":  # on a busy computer
                assert len(found) < 30
                found.append(client.get("/readyz").json()["checks"])
            assert {checks["contents"] for checks in found} == {"no answer"}
            assert len(began) == 1


def test_compile_threads_that_stopped_are_not_ready(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = Settings(database=f"sqlite:///{tmp_path}/shop.sqlite", name="test")
    with run_server(settings) as client:
        monkeypatch.setattr(CompileService, "seconds_since_sweep", 500.0)
        ready = client.get("/readyz")
        assert ready.status_code == 503
        assert ready.json()["checks"]["workers"] == "silent for 500 s"


@pytest.mark.parametrize("kind", [errno.ENOSPC, errno.EDQUOT, errno.EACCES])
def test_a_full_disk_is_distinguished_from_other_errors(kind: int) -> None:
    assert is_disk_full(OSError(kind, "text")) == (kind != errno.EACCES)


def test_postgresql_and_sqlite_report_a_full_disk() -> None:
    class DiskFull(Exception):
        sqlstate = "53100"

    full = sqlite3.OperationalError("database or disk is full")
    full.sqlite_errorcode = sqlite3.SQLITE_FULL
    assert is_disk_full(sa.exc.OperationalError("", {}, full))
    assert is_disk_full(sa.exc.OperationalError("", {}, DiskFull()))
    assert not is_disk_full(sa.exc.OperationalError("", {}, sqlite3.OperationalError("locked")))
