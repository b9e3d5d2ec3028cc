"""The queue of a machine: its order, and the operations on waiting jobs."""

from __future__ import annotations

import threading

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from knifetip.contract.job import Actor, ActorKind
from knifetip.errors import StaleEpoch, StaleVersion, WrongState
from knifetip.library.definition import Definition, Shelf
from knifetip.service.queues.store import Place, WaitingChange, order_version
from knifetip.service.store import Store
from tests.support.examples import examples
from tests.support.job_states import (
    RESULT,
    WAITING,
    confirm,
    queued,
    running,
    waiting,
)
from tests.support.stored import Clock, add_job

OTHER = Definition(Shelf.MACHINES, "other")
MIA = Actor(ActorKind.OPERATOR, "Mia")


def listed(store: Store, machine: str = "table") -> list[str]:
    return [job.id for job in store.queues.jobs(machine)]


def claimed_in_order(store: Store) -> list[str]:
    """Claim and finish jobs until none is left; return their ids in order."""
    ids = []
    while (job := store.gateways.claim("table", "gateway", manual=False)) is not None:
        store.gateways.finish(job.id, job.epoch, "done")
        ids.append(job.id)
    return ids


def events(store: Store, id: str) -> list[tuple[str, str]]:
    """Return code and originator of the events of a job since it was queued."""
    found = store.events.of_job(id)
    return [(event.message.code, event.who) for event in found if event.message][4:]


# Order


@examples(40, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(data=st.data())
def test_the_listed_order_is_the_order_of_the_claims(
    store: Store, clock: Clock, data: st.DataObject
) -> None:
    claimed_in_order(store)
    for id in listed(store):
        store.operators.cancel(id)
    expected: list[str] = []
    priority: dict[str, int] = {}
    for _ in range(data.draw(st.integers(2, 5))):
        clock.now += data.draw(st.sampled_from((0.0, 1.0)))
        job = queued(store, priority=data.draw(st.sampled_from((0, 0, 10))))
        priority[job.id] = job.priority
        expected = sorted([*expected, job.id], key=lambda id: -priority[id])
    for _ in range(data.draw(st.integers(0, 6))):
        id = data.draw(st.sampled_from(expected))
        if data.draw(st.booleans()):
            others = [other for other in expected if other != id]
            index = data.draw(st.integers(0, len(others)))
            ends = ["", *others, ""]
            moved = store.queues.move(id, Place(ends[index], ends[index + 1]), MIA)
            expected = [*others[:index], id, *others[index:]]
            priority[id] = moved.priority
        else:
            value = data.draw(st.sampled_from((-10, 0, 10)))
            store.queues.change(id, WaitingChange(priority=value), MIA)
            if value != priority[id]:
                priority[id] = value
                expected.remove(id)
                expected = sorted([*expected, id], key=lambda id: -priority[id])
        assert listed(store) == expected
        assert sorted(priority.values(), reverse=True) == [priority[id] for id in expected]
    held = data.draw(st.sets(st.sampled_from(expected)))
    for id in held:
        store.queues.change(id, WaitingChange(on_hold=True), MIA)
    assert listed(store) == expected
    assert claimed_in_order(store) == [id for id in expected if id not in held]


def test_a_new_job_comes_after_a_job_that_was_moved_to_the_end(store: Store) -> None:
    first, second = queued(store), queued(store)
    store.queues.move(first.id, Place(second.id, ""), MIA)
    third = queued(store)
    assert listed(store) == [second.id, first.id, third.id]


def test_many_moves_to_the_same_place_keep_the_order(store: Store) -> None:
    jobs = [queued(store).id for _ in range(4)]
    # Each move halves the distance of two ranks until no number is left between them.
    order = list(jobs)
    for _ in range(60):
        moved = order[3]
        store.queues.move(moved, Place(order[0], order[1]), MIA)
        order = [order[0], moved, order[1], order[2]]
        assert listed(store) == order
    assert claimed_in_order(store) == order


def test_a_job_gets_the_priority_that_its_new_place_requires(store: Store) -> None:
    urgent = queued(store, priority=20)
    normal, low = queued(store), queued(store, priority=-10)
    assert store.queues.move(normal.id, Place("", urgent.id), MIA).priority == 20
    assert store.queues.move(urgent.id, Place(low.id, ""), MIA).priority == -10
    assert listed(store) == [normal.id, low.id, urgent.id]
    assert events(store, urgent.id) == [
        ("queue.priority-changed", "operator Mia"),
        ("queue.moved-after", "operator Mia"),
    ]


def test_a_repeated_move_has_no_effect(store: Store) -> None:
    first, second, third = (queued(store) for _ in range(3))
    for _ in range(2):
        store.queues.move(third.id, Place(first.id, second.id), MIA)
    assert listed(store) == [first.id, third.id, second.id]
    assert events(store, third.id) == [("queue.moved-between", "operator Mia")]


@pytest.mark.parametrize(
    ("place", "order"),
    [(Place(previous=""), "cab"), (Place(next=""), "abc"), (Place(previous="a"), "acb")],
)
def test_one_neighbour_is_enough(store: Store, place: Place, order: str) -> None:
    ids = {letter: queued(store).id for letter in "abc"}
    named = Place(
        place.previous and ids[place.previous] if place.previous is not None else None, place.next
    )
    store.queues.move(ids["c"], named, MIA)
    assert listed(store) == [ids[letter] for letter in order]


# Two operators


def test_an_operator_does_not_undo_a_move_that_he_has_not_seen(store: Store) -> None:
    first, second, third, fourth = (queued(store) for _ in range(4))
    seen = order_version(store.queues.jobs("table"))
    store.queues.move(third.id, Place(first.id, second.id), MIA, seen)
    # The other operator still sees first and second next to each other.
    with pytest.raises(StaleVersion, match="has changed since"):
        store.queues.move(fourth.id, Place(first.id, second.id), MIA)
    # The neighbours are unchanged, but not the order.
    with pytest.raises(StaleVersion):
        store.queues.move(third.id, Place(fourth.id, ""), MIA, seen)
    assert listed(store) == [first.id, third.id, second.id, fourth.id]


def test_two_writers_leave_one_order(store: Store) -> None:
    jobs = [queued(store).id for _ in range(6)]
    start = threading.Barrier(2)
    claims: list[str] = []

    def shuffle() -> None:
        start.wait()
        for id in jobs[1:]:
            try:
                store.queues.move(id, Place(previous=""), MIA)
            except WrongState:
                continue  # claimed meanwhile

    def claim() -> None:
        start.wait()
        for _ in range(4):
            job = store.gateways.claim("table", "gateway", manual=False)
            assert job is not None
            claims.append(job.id)
            store.gateways.finish(job.id, job.epoch, "done")

    threads = [threading.Thread(target=target) for target in (shuffle, claim)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30.0)
    assert len(set(claims)) == 4
    rest = listed(store)
    assert sorted([*claims, *rest]) == sorted(jobs)
    assert claimed_in_order(store) == rest


@pytest.mark.parametrize("other", ["nothing", "running", "elsewhere"])
def test_a_neighbour_must_wait_for_the_same_machine(store: Store, other: str) -> None:
    neighbours = {"running": running(store).id, "nothing": "nothing"}
    neighbours["elsewhere"] = queued(store, machine="other").id
    job = queued(store)
    with pytest.raises(WrongState, match="does not wait for table"):
        store.queues.move(job.id, Place(previous=neighbours[other]), MIA)


# Changes of waiting jobs


def test_a_job_on_hold_keeps_its_place_and_is_not_claimed(store: Store) -> None:
    first, second = queued(store), queued(store)
    for _ in range(2):
        store.queues.change(first.id, WaitingChange(on_hold=True), MIA)
    assert listed(store) == [first.id, second.id]
    assert claimed_in_order(store) == [second.id]
    store.queues.change(first.id, WaitingChange(on_hold=False), MIA)
    assert claimed_in_order(store) == [first.id]
    assert events(store, first.id)[:2] == [
        ("queue.put-on-hold", "operator Mia"),
        ("queue.let-go", "operator Mia"),
    ]


def test_a_claimed_job_on_hold_returns_to_the_queue_before_it_is_confirmed(store: Store) -> None:
    job = waiting(store)
    other = queued(store)
    store.queues.change(job.id, WaitingChange(on_hold=True), MIA)
    with pytest.raises(StaleEpoch):
        store.gateways.heartbeat(job.id, job.epoch, WAITING)
    claimed = store.gateways.claim("table", "gateway", manual=True)
    assert claimed is not None
    assert claimed.id == other.id


def test_a_confirmed_job_cannot_be_put_on_hold_in_the_queue(store: Store) -> None:
    job = waiting(store)
    confirm(store, job.id)
    with pytest.raises(WrongState, match="has taken job"):
        store.queues.change(job.id, WaitingChange(on_hold=True), MIA)
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "start"


@pytest.mark.parametrize(
    "change", [WaitingChange(copies=2), WaitingChange(priority=1), WaitingChange(on_hold=False)]
)
def test_a_claimed_job_cannot_be_changed(store: Store, change: WaitingChange) -> None:
    job = waiting(store)
    with pytest.raises(WrongState, match="has taken job"):
        store.queues.change(job.id, change, MIA)


def test_a_running_job_cannot_be_moved_or_changed(store: Store) -> None:
    job = running(store)
    with pytest.raises(WrongState, match="is running"):
        store.queues.move(job.id, Place(previous=""), MIA)
    with pytest.raises(WrongState, match="is running"):
        store.queues.change(job.id, WaitingChange(copies=3), MIA)


def test_copies_change_while_a_job_waits_but_not_below_the_completed_ones(store: Store) -> None:
    job = running(store, copies=3)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=5, copies_done=2)
    store.interrupted.requeue(job.id)
    with pytest.raises(WrongState, match="2 copies"):
        store.queues.change(job.id, WaitingChange(copies=2), MIA)
    assert store.queues.change(job.id, WaitingChange(copies=5), MIA).copies == 5
    claimed = store.gateways.claim("table", "gateway", manual=False)
    assert claimed is not None
    assert (claimed.copies, claimed.copies_done) == (5, 2)


def test_a_job_can_be_changed_before_it_is_compiled(store: Store) -> None:
    job = add_job(store)
    changed = store.queues.change(job.id, WaitingChange(priority=10, copies=4, on_hold=True), MIA)
    assert (changed.priority, changed.copies, changed.on_hold) == (10, 4, True)


# Another machine


def test_a_job_moves_to_the_end_of_another_queue(store: Store) -> None:
    job, other = queued(store), queued(store, machine="other")
    moved = store.queues.transfer(job, OTHER, RESULT, MIA)
    assert (moved.machine, moved.state) == ("other", "queued")
    assert listed(store) == []
    assert listed(store, "other") == [other.id, job.id]
    assert events(store, job.id) == [("queue.transferred", "operator Mia")]


def test_a_job_that_was_claimed_meanwhile_stays_on_its_machine(store: Store) -> None:
    job = queued(store)
    store.gateways.claim("table", "gateway", manual=True)
    with pytest.raises(WrongState, match="has taken job"):
        store.queues.transfer(job, OTHER, RESULT, MIA)
    assert store.jobs.get(job.id).machine == "table"
