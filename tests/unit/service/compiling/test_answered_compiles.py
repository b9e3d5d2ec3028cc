"""A compile of the same input is answered with the stored program."""

from __future__ import annotations

import hashlib
from dataclasses import replace

import pytest

from knifetip.contract.job import Actor, ActorKind
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.service.database.tables import Job
from knifetip.service.store import Store
from tests.support.job_states import REFUSED, RESULT, compiling, execute

KEY = "5e" * 32
SOUND = replace(RESULT, sha256=hashlib.sha256(RESULT.program).hexdigest())


def compiled(store: Store) -> Job:
    job = compiling(store)
    store.compiles.save_result(job.id, job.epoch, SOUND, KEY)
    return store.jobs.get(job.id)


@pytest.mark.parametrize(("release", "state"), [(False, "ready"), (True, "queued")])
def test_a_job_with_the_same_input_gets_the_program_of_the_first(
    store: Store, release: bool, state: str
) -> None:
    first = compiled(store)
    second = compiling(store, release=release)
    assert store.compiles.answer(second.id, second.epoch, KEY)
    job = store.jobs.get(second.id)
    assert (job.state, job.program_of, job.owner) == (state, first.id, "")
    for column in ("program_sha256", "lines", "verdict_summary", "tools", "seconds"):
        assert getattr(job, column) == getattr(first, column)
    for column in ("program", "toolpath", "verdict"):
        assert store.jobs.column(job.id, column) == store.jobs.column(first.id, column)
    messages = [event.message for event in store.events.of_job(job.id)]
    assert Message("job.answered", job=first.id) in messages
    third = compiling(store)
    assert store.compiles.answer(third.id, third.epoch, KEY)
    assert store.jobs.get(third.id).program_of == first.id


def test_another_input_a_refusal_and_a_program_for_another_machine_answer_nothing(
    store: Store,
) -> None:
    refused = compiling(store)
    store.compiles.save_result(refused.id, refused.epoch, REFUSED, KEY)
    first = compiled(store)
    moved = replace(SOUND, program=b"other")
    machine = store.library.definition(Shelf.MACHINES, "router-table")
    store.queues.transfer(first, machine, moved, Actor(ActorKind.OPERATOR))
    job = compiling(store)
    assert not store.compiles.answer(job.id, job.epoch, KEY)
    assert not store.compiles.answer(job.id, job.epoch, "00" * 32)
    assert store.jobs.get(job.id).state == "compiling"


def test_a_damaged_program_answers_nothing(store: Store) -> None:
    first = compiled(store)
    execute(store, "UPDATE job SET program_sha256 = 'other' WHERE id = :id", id=first.id)
    job = compiling(store)
    assert not store.compiles.answer(job.id, job.epoch, KEY)
