from __future__ import annotations

import sqlite3
import threading
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from sqlalchemy.dialects import postgresql
from sqlalchemy.schema import CreateIndex

from knifetip.errors import (
    KeyReused,
    MachineBusy,
    NoSuchJob,
    StaleEpoch,
    StaleRevision,
    StaleVersion,
    StoreError,
    WrongState,
)
from knifetip.jobs import migrations
from knifetip.jobs.store import ATTEMPTS, LEASE, Result, Store
from knifetip.jobs.tables import Base, Drawing, Job

LINES = 231
RESULT = Result(
    accepted=True,
    reason="",
    program=b"G0 X0\n" * LINES,
    sha256="ab" * 32,
    lines=LINES,
    toolpath=b"KTIP",
    verdict=b"KTIP",
    judged={"seconds": 12.5, "accepted": True},
)
REFUSED = Result(
    accepted=False,
    reason="Edge 3 is 0.4 mm off.",
    program=b"",
    sha256="",
    lines=0,
    toolpath=b"",
    verdict=b"",
    judged={"seconds": 0.0, "accepted": False},
    source=["2F4"],
)


MIGRATIONS = Path(migrations.__file__).parent


class Clock:
    now = 1000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(tmp_path: Path, clock: Clock) -> Iterator[Store]:
    store = Store(f"sqlite:///{tmp_path}/shop.sqlite", clock)
    store.migrate()
    yield store
    store.close()


def drawing(store: Store, **more: str) -> Drawing:
    return store.add_drawing(
        name="tray.dxf",
        content=b"0\nEOF\n",
        sha256="0" * 64,
        unit_given="mm",
        profile="default",
        overrides=b"\xff",
        summary={"unit": "mm"},
        edges=b"KTIP",
        ledger=b"",
        **more,
    )


def ordered(store: Store, **more: object) -> Job:
    fields = {"machine": "table", "board": "e-flute", "profile": "default", "overrides": b""}
    return store.add_job(drawing(store), **{**fields, **more})


def compiling(store: Store, **more: object) -> Job:
    job = store.begin_compile(ordered(store, **more).id, 1, "worker")
    assert job is not None
    return job


def queued(store: Store, **more: object) -> Job:
    job = compiling(store, release=True, **more)
    store.compiled(job.id, job.epoch, RESULT)
    return store.job(job.id)


def running(store: Store, **more: object) -> Job:
    queued(store, **more)
    job = store.claim("table", "gateway")
    assert job is not None
    return job


def course(store: Store, id: str) -> list[str]:
    return [event.state for event in store.events_of(id)]


# The way of a job


def test_a_job_goes_from_received_to_done_and_every_step_is_an_event(store: Store):
    job = running(store)
    assert (job.state, job.lines, job.program_sha256) == ("running", LINES, "ab" * 32)
    store.finish(job.id, job.epoch, "done", "")
    assert course(store, job.id) == [
        "received",
        "compiling",
        "ready",
        "queued",
        "running",
        "done",
    ]
    done = store.job(job.id)
    assert (done.line, done.copies_done, done.seconds_left) == (LINES, 1, 0.0)


def test_a_job_that_was_not_ordered_to_be_queued_waits_to_be_released(store: Store):
    job = compiling(store)
    store.compiled(job.id, job.epoch, RESULT)
    assert store.job(job.id).state == "ready"
    assert store.claim("table", "gateway") is None
    assert store.release(job.id).state == "queued"


def test_a_verdict_outside_tolerance_refuses_the_job_with_its_edges(store: Store):
    job = compiling(store, release=True)
    store.compiled(job.id, job.epoch, REFUSED)
    job = store.job(job.id)
    assert (job.state, job.reason, job.source) == ("refused", "Edge 3 is 0.4 mm off.", ["2F4"])


def test_the_event_is_written_with_the_move_or_not_at_all(store: Store):
    job = queued(store)
    with pytest.raises(WrongState):
        store.release(job.id)
    assert course(store, job.id)[-1] == "queued"
    assert len(course(store, job.id)) == 4


@pytest.mark.parametrize("move", ["release", "requeue", "scrap", "hold", "resume"])
def test_a_received_job_can_only_be_cancelled(store: Store, move: str):
    job = ordered(store)
    with pytest.raises(WrongState, match="is received"):
        getattr(store, move)(job.id)
    assert store.cancel(job.id).state == "cancelled"


@pytest.mark.parametrize("move", ["release", "requeue", "scrap", "hold", "resume", "cancel"])
def test_a_job_that_is_done_stays_done(store: Store, move: str):
    job = running(store)
    store.finish(job.id, job.epoch, "done", "")
    with pytest.raises(WrongState, match="is done"):
        getattr(store, move)(job.id)


def test_a_job_that_does_not_exist_is_named(store: Store):
    with pytest.raises(NoSuchJob, match="no job 'nothing'"):
        store.cancel("nothing")
    with pytest.raises(NoSuchJob, match="no drawing"):
        store.drawing("nothing")


# One job on a table


def test_two_claims_on_one_machine_give_one_job(store: Store):
    first, second = queued(store), queued(store)
    claimed = store.claim("table", "one")
    assert claimed is not None
    assert claimed.id == first.id
    with pytest.raises(MachineBusy, match=first.id):
        store.claim("table", "two")
    assert store.job(second.id).state == "queued"


@pytest.mark.parametrize("state", ["running", "held", "interrupted"])
def test_the_database_itself_refuses_a_second_job_on_a_table(
    store: Store, tmp_path: Path, state: str
):
    running(store)
    second = queued(store)
    direct = sqlite3.connect(f"{tmp_path}/shop.sqlite")
    with closing(direct), pytest.raises(sqlite3.IntegrityError, match="UNIQUE"):
        direct.execute("UPDATE job SET state = ? WHERE id = ?", (state, second.id))


def test_postgresql_is_told_the_same_index():
    (index,) = [index for index in Job.__table__.indexes if index.name == "one_job_on_a_table"]
    said = str(CreateIndex(index).compile(dialect=postgresql.dialect()))
    assert "UNIQUE" in said
    assert "WHERE state IN ('running', 'held', 'interrupted')" in said


def test_ten_gateways_that_claim_at_once_get_one_job(store: Store):
    for _ in range(3):
        queued(store)
    got: list[Job | None] = []
    refused: list[Exception] = []
    start = threading.Barrier(10)

    def claim(name: str) -> None:
        start.wait()
        try:
            got.append(store.claim("table", name))
        except MachineBusy as reason:
            refused.append(reason)

    threads = [threading.Thread(target=claim, args=(f"g{n}",)) for n in range(10)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    # PostgreSQL shows a row that another is claiming to nobody: None is as good a no as busy.
    assert len([job for job in got if job is not None]) == 1
    assert len(got) + len(refused) == 10


def test_machines_do_not_wait_for_each_other(store: Store):
    running(store)
    other = queued(store, machine="other")
    claimed = store.claim("other", "gateway")
    assert claimed is not None
    assert claimed.id == other.id


def test_a_claim_takes_the_highest_priority_and_then_the_oldest(store: Store, clock: Clock):
    late = queued(store, priority=0)
    clock.now += 1.0
    urgent = queued(store, priority=5)
    clock.now += 1.0
    queued(store, priority=5)
    order = []
    for _ in range(3):
        job = store.claim("table", "gateway")
        assert job is not None
        order.append(job.id)
        store.finish(job.id, job.epoch, "done", "")
    assert order[0] == urgent.id
    assert order[2] == late.id


# Epochs and leases


def test_each_claim_has_a_new_epoch_and_an_earlier_owner_is_refused(store: Store, clock: Clock):
    job = running(store)
    clock.now += LEASE + 0.1
    store.sweep()
    store.requeue(job.id)
    again = store.claim("table", "other gateway")
    assert again is not None
    assert again.epoch > job.epoch
    with pytest.raises(StaleEpoch, match=f"epoch {job.epoch}"):
        store.heartbeat(job.id, job.epoch, line=5)
    with pytest.raises(StaleEpoch):
        store.finish(job.id, job.epoch, "done", "")
    assert store.job(job.id).state == "running"


def test_a_silent_gateway_interrupts_its_job_and_never_queues_it(store: Store, clock: Clock):
    job = running(store)
    store.heartbeat(job.id, job.epoch, line=199)
    clock.now += LEASE - 0.1
    store.sweep()
    assert store.job(job.id).state == "running"
    clock.now += 0.2
    store.sweep()
    job = store.job(job.id)
    assert job.state == "interrupted"
    assert job.reason == "The gateway gateway fell silent at line 199 of 231."
    assert store.on_table() == {"table": job.id}


def test_a_heartbeat_renews_the_lease(store: Store, clock: Clock):
    job = running(store)
    for line in range(20):
        clock.now += LEASE / 2
        assert store.heartbeat(job.id, job.epoch, line=line) == "continue"
        store.sweep()
    assert store.job(job.id).state == "running"


def test_a_finish_that_is_said_twice_does_no_harm(store: Store):
    job = running(store)
    store.finish(job.id, job.epoch, "interrupted", "a belt tore")
    assert store.finish(job.id, job.epoch, "interrupted", "a belt tore").reason == "a belt tore"
    assert course(store, job.id).count("interrupted") == 1


def test_an_interrupted_job_is_queued_again_from_its_first_line_or_scrapped(store: Store):
    job = running(store)
    store.heartbeat(job.id, job.epoch, line=100)
    store.finish(job.id, job.epoch, "interrupted", "a belt tore")
    again = store.requeue(job.id)
    assert (again.state, again.line, again.reason) == ("queued", 0, "")
    job = store.claim("table", "gateway")
    assert job is not None
    store.finish(job.id, job.epoch, "interrupted", "")
    assert store.scrap(job.id).state == "scrapped"
    assert store.on_table() == {}


def test_copies_that_were_cut_before_an_interruption_count(store: Store):
    job = running(store, copies=3)
    store.heartbeat(job.id, job.epoch, line=LINES, copies_done=1, held=True)
    assert store.events_of(job.id)[-1].why == "copy 1 of 3 is done: put a new sheet on the table"
    store.finish(job.id, job.epoch, "interrupted", "")
    store.requeue(job.id)
    again = store.claim("table", "gateway")
    assert again is not None
    store.heartbeat(again.id, again.epoch, line=LINES, copies_done=1, held=True)
    assert store.job(job.id).copies_done == 2


def test_a_resume_starts_one_copy_and_not_the_one_after(store: Store):
    job = running(store, copies=3)
    store.heartbeat(job.id, job.epoch, line=LINES, copies_done=1, held=True)
    store.resume(job.id)
    assert store.heartbeat(job.id, job.epoch, line=LINES, copies_done=1, held=True) == "resume"
    # The second copy was so short that no heartbeat fell into it.
    answer = store.heartbeat(job.id, job.epoch, line=LINES, copies_done=2, held=True)
    assert answer == "continue"
    assert store.events_of(job.id)[-1].why.startswith("copy 2 of 3 is done")


# What the operator wants


def test_hold_and_resume_go_through_the_gateway(store: Store):
    job = running(store)
    assert store.hold(job.id).state == "running"
    assert store.heartbeat(job.id, job.epoch, line=5) == "hold"
    assert store.heartbeat(job.id, job.epoch, line=6) == "hold"
    assert store.heartbeat(job.id, job.epoch, line=6, held=True) == "continue"
    assert store.job(job.id).state == "held"
    assert store.resume(job.id).wish == "resume"
    assert store.heartbeat(job.id, job.epoch, line=6, held=True) == "resume"
    assert store.heartbeat(job.id, job.epoch, line=7) == "continue"
    assert store.job(job.id).state == "running"


def test_a_running_job_is_cancelled_by_its_gateway(store: Store):
    job = running(store)
    assert store.cancel(job.id).state == "running"
    with pytest.raises(WrongState, match="being cancelled"):
        store.resume(job.id)
    assert store.cancel(job.id).wish == "cancel"
    assert store.heartbeat(job.id, job.epoch, line=5) == "cancel"
    assert store.finish(job.id, job.epoch, "cancelled", "").state == "cancelled"


def test_an_interrupted_job_cannot_be_cancelled_away_from_its_table(store: Store):
    job = running(store)
    store.finish(job.id, job.epoch, "interrupted", "")
    with pytest.raises(WrongState) as caught:
        store.cancel(job.id)
    assert caught.value.mend == "Look at the table, then queue it again or scrap it."


# Compiles


def test_a_compile_that_was_cancelled_cannot_leave_its_result(store: Store):
    job = compiling(store)
    store.cancel(job.id)
    assert not store.compile_progress(job.id, job.epoch, "plan", 0.1)
    with pytest.raises(WrongState):
        store.compiled(job.id, job.epoch, RESULT)
    assert store.job(job.id).state == "cancelled"


def test_a_compile_whose_worker_fell_silent_is_tried_again_and_the_old_one_is_fenced(
    store: Store, clock: Clock
):
    job = compiling(store)
    store.compile_progress(job.id, job.epoch, "verify", 0.7)
    clock.now += LEASE + 0.1
    assert store.sweep(patience=-1.0) == [(job.id, 2)]
    assert store.begin_compile(job.id, 1, "the old worker") is None
    again = store.begin_compile(job.id, 2, "a new worker")
    assert again is not None
    with pytest.raises(StaleEpoch):
        store.compiled(job.id, job.epoch, RESULT)
    store.compiled(job.id, again.epoch, RESULT)
    assert store.job(job.id).state == "ready"


def test_a_worker_that_comes_back_under_the_same_attempt_takes_its_compile_up_again(store: Store):
    job = compiling(store)
    again = store.begin_compile(job.id, 1, "worker")
    assert again is not None
    assert again.epoch == job.epoch + 1
    with pytest.raises(StaleEpoch):
        store.refuse(job.id, job.epoch, "late", "")


def test_a_drawing_that_kills_every_compile_is_refused_in_the_end(store: Store, clock: Clock):
    job = compiling(store)
    for attempt in range(2, ATTEMPTS + 1):
        clock.now += LEASE + 0.1
        assert store.sweep(patience=-1.0) == [(job.id, attempt)]
        assert store.begin_compile(job.id, attempt, "worker") is not None
    clock.now += LEASE + 0.1
    assert store.sweep(patience=-1.0) == []
    assert store.job(job.id).state == "refused"
    assert "5 compiles" in store.job(job.id).reason


def test_a_job_that_nobody_compiles_is_handed_out_again(store: Store, clock: Clock):
    job = ordered(store)
    assert store.sweep() == []
    clock.now += 3.0
    assert store.sweep() == [(job.id, 1)]


# Drawings, keys, events


def test_a_key_answers_with_the_first_result_and_refuses_another_request(store: Store):
    first = drawing(store, key="k", fingerprint="f")
    assert drawing(store, key="k", fingerprint="f").id == first.id
    with pytest.raises(KeyReused):
        drawing(store, key="k", fingerprint="another")
    job = ordered(store, key="k", fingerprint="f")
    assert ordered(store, key="k", fingerprint="f").id == job.id
    with pytest.raises(KeyReused):
        store.job_of("k", "another")


def test_a_change_to_a_drawing_that_changed_meanwhile_is_refused(store: Store):
    row = drawing(store)
    assert store.change_drawing(row.id, row.version, "first", overrides=b"\x01").version == 2
    with pytest.raises(StaleRevision, match="revision 2") as stale:
        store.change_drawing(row.id, row.version, "second", overrides=b"\x02")
    assert stale.value.revision == 2
    assert store.drawing_column(row.id, "overrides") == b"\x01"


def test_a_change_to_a_drawing_that_was_deleted_meanwhile_is_refused(store: Store):
    row = drawing(store)
    store.delete_drawing(row.id)
    with pytest.raises(NoSuchJob):
        store.change_drawing(row.id, row.version, "late", overrides=b"\x01")


def test_what_is_read_of_a_drawing_is_of_one_revision(store: Store):
    row = drawing(store)
    store.change_drawing(row.id, 1, "second", overrides=b"\x02", edges=b"two", unit_given="in")
    read = store.drawing_with(row.id, "overrides", "edges")
    store.change_drawing(row.id, 2, "third", overrides=b"\x03", edges=b"three", unit_given="mm")
    seen = (read.version, read.overrides, read.edges, read.unit_given)
    assert seen == (2, b"\x02", b"two", "in")


def test_a_drawing_with_jobs_is_kept(store: Store):
    job = ordered(store)
    with pytest.raises(WrongState, match=job.id):
        store.delete_drawing(job.drawing)
    free = drawing(store)
    store.delete_drawing(free.id)
    with pytest.raises(NoSuchJob):
        store.drawing(free.id)


def test_events_are_numbered_upwards_and_never_twice(store: Store):
    job = queued(store)
    last = store.last_event()
    store.cancel(job.id)
    (event,) = store.events_after(last)
    assert (event.subject, event.state, event.who) == (job.id, "cancelled", "operator")
    assert event.id > last


def test_a_gateway_is_connected_while_it_asks_and_while_it_works(store: Store, clock: Clock):
    assert store.connected(6.0) == set()
    store.saw_gateway("table", "gateway")
    store.saw_gateway("table", "gateway")
    assert store.connected(6.0) == {"table"}
    clock.now += 7.0
    assert store.connected(6.0) == set()
    job = running(store)
    assert store.connected(6.0) == {"table"}
    clock.now += LEASE + 1.0
    assert store.connected(6.0) == set()
    assert store.job(job.id).state == "running"


# The database


def test_the_migrations_make_the_tables_that_the_code_expects(store: Store, tmp_path: Path):
    engine = sa.create_engine(store.url)
    with engine.connect() as connection:
        assert compare_metadata(MigrationContext.configure(connection), Base.metadata) == []
    engine.dispose()


def test_to_migrate_twice_changes_nothing(store: Store):
    job = queued(store)
    store.migrate()
    assert store.job(job.id).state == "queued"


def test_a_database_of_before_corners_could_be_chosen_keeps_its_jobs(store: Store):
    job = queued(store)
    settings = Config()
    settings.set_main_option("script_location", str(MIGRATIONS))
    engine = sa.create_engine(store.url)
    with engine.begin() as connection:
        settings.attributes["connection"] = connection
        command.downgrade(settings, "0001")
        assert "corners" not in {row["name"] for row in sa.inspect(connection).get_columns("job")}
    engine.dispose()
    store.migrate()
    kept = store.job(job.id)
    assert (kept.state, kept.corners) == ("queued", None)


@pytest.mark.parametrize("url", ["nonsense", "sqlite://", "sqlite:///:memory:", "mysql://h/d", ""])
def test_a_database_that_cannot_be_used_is_refused_with_a_mend(url: str):
    with pytest.raises(StoreError) as caught:
        Store(url)
    assert "sqlite:///FILE" in caught.value.mend


def test_a_profile_counts_its_changes_and_is_never_overwritten_unseen(store: Store):
    first = store.keep_profile("acme", "Acme", "title = 'Acme'", None)
    assert first.version == 1
    with pytest.raises(WrongState, match="already, at version 1"):
        store.keep_profile("acme", "Other", "", None)
    assert store.keep_profile("acme", "B", "title = 'B'", 1).version == 2
    with pytest.raises(StaleVersion, match=r"at version 2.*from version 1") as caught:
        store.keep_profile("acme", "C", "", 1)
    assert 'If-Match: "2"' in caught.value.mend
    kept = store.profile("acme")
    assert kept is not None
    assert (kept.title, kept.text) == ("B", "title = 'B'")
    with pytest.raises(StaleVersion):
        store.delete_profile("acme", 1)
    store.delete_profile("acme", 2)
    assert store.profile("acme") is None
    with pytest.raises(NoSuchJob):
        store.keep_profile("acme", "C", "", 2)
    assert store.keep_profile("acme", "D", "", None, anyway=True).version == 1
