"""The same Idempotency-Key of two principals names two requests, in SQLite and PostgreSQL."""

from __future__ import annotations

import threading
import time

import pytest
import sqlalchemy as sa

from knifetip.errors import KeyReused
from knifetip.service.database.acting import ActingPrincipal, acting_as
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Job
from knifetip.service.store import Store
from tests.support.job_states import RESULT, compiling, drawing, ordered

#: A user, an API key with the id of that user, and two principals without an account.
PRINCIPALS = (("user", "u1"), ("key", "u1"), ("server-key", ""), ("local", ""))


def key_of(kind: str, id: str, fingerprint: str = "f") -> RequestKey:
    """Return the key "k" of a request that a principal sends."""
    with acting_as(ActingPrincipal(kind, "a name", id, "an action")):
        return RequestKey("k", fingerprint)


def ready(store: Store) -> Job:
    job = compiling(store)
    store.compiles.save_result(job.id, job.epoch, RESULT)
    return job


def test_each_principal_gets_a_drawing_and_a_job_of_its_own(store: Store) -> None:
    keys = [key_of(*one) for one in PRINCIPALS]
    drawings = [drawing(store, key).id for key in keys]
    jobs = [ordered(store, key).id for key in keys]
    assert len(set(drawings)) == len(set(jobs)) == len(PRINCIPALS)
    assert [drawing(store, key).id for key in keys] == drawings
    assert [ordered(store, key).id for key in keys] == jobs
    # The content of the request counts for its own principal only.
    with pytest.raises(KeyReused):
        drawing(store, key_of("user", "u1", "another"))
    assert drawing(store, key_of("user", "u2", "another")).id not in drawings


def test_a_command_of_another_principal_is_carried_out(store: Store) -> None:
    first, second = ready(store), ready(store)
    store.programs.release(first.id, key_of("user", "u1", "release the first"))
    with pytest.raises(KeyReused):
        store.programs.release(second.id, key_of("user", "u1", "release the second"))
    released = store.programs.release(second.id, key_of("user", "u2", "release the second"))
    assert released.state == "queued"
    # A repetition by the same principal changes nothing.
    store.operators.cancel(second.id)
    repeated = store.programs.release(second.id, key_of("user", "u2", "release the second"))
    assert repeated.state == "cancelled"


def test_two_commands_with_one_key_at_the_same_time(store: Store) -> None:
    """The key of the first is stored but not committed when the second looks for it."""
    first, second = ready(store), ready(store)
    refused: list[Exception] = []

    def release_second() -> None:
        try:
            store.programs.release(second.id, key_of("user", "u1", "release the second"))
        except Exception as reason:
            refused.append(reason)

    other = threading.Thread(target=release_second)
    with store.database.writing() as session:
        key = key_of("user", "u1", "release the first")
        assert store.operators._keys.repeated(session, first.id, key) is None
        other.start()
        wait_until_blocked(store)
    other.join()
    assert [type(reason) for reason in refused] == [KeyReused]
    assert store.jobs.get(second.id).state == "ready"


def wait_until_blocked(store: Store) -> None:
    """Wait until a transaction of PostgreSQL waits for another one; SQLite has one at a time."""
    if not store.database.url.startswith("postgresql"):
        return
    waiting = sa.text("SELECT count(*) FROM pg_locks WHERE NOT granted")
    end = time.monotonic() + 60.0
    while True:
        with store.database.reading() as session:
            if session.scalar(waiting):
                return
        assert time.monotonic() < end
        time.sleep(0.01)
