"""A backup made while jobs are written is a snapshot of the database, and is restored whole."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import threading
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
import sqlalchemy as sa

from knifetip.model.interpretation import Interpretation
from knifetip.service.drawings.store import NewDrawing
from knifetip.service.orders.store import JobOrder
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.store import Store
from tests.support.command import Command
from tests.support.serving.postgresql import create_database, installed_binaries

#: Jobs that exist before the backup begins.
BEFORE = 20


def sha256(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def add_compiled_job(store: Store, number: int) -> None:
    """Store a drawing and a job with a program; both contents depend on the number."""
    content = f"0\nEOF\n{number}\n".encode() * 500
    program = f"(job {number})\nM2\n".encode() * 500
    interpretation = Interpretation("mm")
    drawing = store.drawings.add(
        NewDrawing(
            name=f"{number}.dxf",
            content=content,
            sha256=sha256(content),
            interpretation=interpretation,
            summary={},
            edges=b"",
            import_report=b"",
        )
    )
    store.jobs.add(
        drawing,
        JobOrder(
            machine="demo-table", board="e-flute", interpretation=interpretation, release=True
        ),
    )
    job = store.compiles.begin("worker")
    assert job is not None
    result = CompileResult(
        accepted=True,
        message=None,
        program=program,
        sha256=sha256(program),
        lines=1000,
        toolpath=b"",
        verdict=b"",
        verdict_summary={"seconds": 1.0, "accepted": True},
    )
    store.compiles.save_result(job.id, job.epoch, result)


@contextmanager
def writing(url: str) -> Iterator[None]:
    """Write drawings and jobs on a thread, before and during the block."""
    stop, begun = threading.Event(), threading.Event()

    def write() -> None:
        with closing(Store(url)) as store:
            number = 0
            while not stop.is_set():
                add_compiled_job(store, number)
                number += 1
                if number == BEFORE:
                    begun.set()

    writer = threading.Thread(target=write)
    writer.start()
    try:
        assert begun.wait(60.0)
        yield
    finally:
        stop.set()
        writer.join(60.0)


def contents(url: str) -> dict[str, tuple[str, ...]]:
    """Return the hashes of drawing and program and the states of the events of each job.

    Each stored hash must be that of the stored bytes.
    """
    with closing(Store(url)) as store, store.database.reading() as session:
        ids = session.scalars(sa.text("SELECT id FROM job ORDER BY serial")).all()
        found = {}
        for id in ids:
            job = store.jobs.get(id)
            drawing = store.drawings.get(job.drawing)
            program = store.jobs.column(id, "program") if job.program_sha256 else b""
            assert sha256(store.drawings.column(drawing.id, "content")) == drawing.sha256
            assert not program or sha256(program) == job.program_sha256
            events = tuple(event.state for event in store.events.of_job(id))
            assert events[-1] == job.state
            found[id] = (drawing.sha256, job.program_sha256, *events)
    return found


def count_jobs(url: str) -> int:
    """Return the number of committed jobs."""
    with closing(Store(url)) as store, store.database.reading() as session:
        return int(session.scalar(sa.text("SELECT count(*) FROM job")) or 0)


def check(
    restored: dict[str, tuple[str, ...]], live: dict[str, tuple[str, ...]], committed: int
) -> None:
    """Check that the restored jobs are a snapshot of the live database.

    ``committed`` is the number of jobs when the backup began, all of which it must contain.
    """
    assert BEFORE <= committed <= len(restored) <= len(live)
    assert list(restored) == list(live)[: len(restored)]
    for id, (drawing, program, *events) in restored.items():
        assert drawing == live[id][0]
        assert program in ("", live[id][1])
        assert tuple(events) == live[id][2:][: len(events)]


def test_a_backup_of_sqlite_during_writes_is_restored_elsewhere(
    knifetip: Command, tmp_path: Path
) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    fresh = f"sqlite:///{tmp_path}/elsewhere/shop.sqlite"
    with closing(Store(url)) as store:
        store.migrate()
    with writing(url):
        for number in range(3):
            committed = count_jobs(url)
            code, _, err = knifetip("backup", tmp_path / f"copy{number}", "--database", url)
            assert code == 0, err
    code, _, err = knifetip("restore", tmp_path / "copy2", "--database", fresh)
    assert code == 0, err
    check(contents(fresh), contents(url), committed)
    with closing(Store(fresh)) as store:
        add_compiled_job(store, -1)


def test_a_dump_of_postgresql_during_writes_is_restored_elsewhere(
    postgresql_server: str, postgresql_url: str, tmp_path: Path
) -> None:
    binaries = installed_binaries()
    assert binaries is not None
    for program in ("pg_dump", "pg_restore"):
        if not (binaries / program).exists() and not shutil.which(program):
            pytest.skip(f"{program} is not installed")
    with closing(Store(postgresql_url)) as store:
        store.migrate()
    dump = tmp_path / "knifetip.dump"

    def run(program: str, *words: str) -> None:
        found = binaries / program
        subprocess.run([str(found) if found.exists() else program, *words], check=True)

    with writing(postgresql_url):
        address = postgresql_url.replace("+psycopg", "")
        committed = count_jobs(postgresql_url)
        run("pg_dump", "--format=custom", f"--file={dump}", address)
    fresh = create_database(postgresql_server, f"r{postgresql_url.split('/t')[1].split('?')[0]}")
    # The options of the how-to page.
    words = ("--exit-on-error", "--no-owner", f"--dbname={fresh.replace('+psycopg', '')}")
    run("pg_restore", *words, str(dump))
    check(contents(fresh), contents(postgresql_url), committed)
    with closing(Store(fresh)) as store:
        assert store.prepare() is None
        add_compiled_job(store, -1)
