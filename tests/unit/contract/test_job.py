from __future__ import annotations

from knifetip.contract.job import (
    ADVICE,
    ON_TABLE,
    TRANSITIONS,
    Action,
    ActorKind,
    State,
    action_between,
    new_id,
    sources,
)


def reachable(start: State, without: frozenset[State] = frozenset()) -> set[State]:
    found = {start}
    while more := {b for a, _, b, _ in TRANSITIONS if a in found and b not in found | without}:
        found |= more
    return found


def test_every_state_can_be_reached_from_received() -> None:
    assert reachable(State.RECEIVED) == set(State)


def test_nothing_leads_out_of_the_ends() -> None:
    ends = {State.DONE, State.SCRAPPED, State.CONTINUED, State.CANCELLED}
    assert {row.source for row in TRANSITIONS} == set(State) - ends


def test_only_an_operator_who_accepts_shortfalls_leads_out_of_a_refusal() -> None:
    leaving = [row for row in TRANSITIONS if row.source == "refused"]
    assert [(row.action, row.target, row.actors) for row in leaving] == [
        (Action.ACCEPT, State.READY, (ActorKind.OPERATOR,))
    ]


def test_an_interrupted_job_is_left_by_an_operator_or_a_late_report() -> None:
    leaving = {row.target: {*row.actors} for row in TRANSITIONS if row.source == "interrupted"}
    assert leaving == {
        # A late report that nothing was executed: an operator lets it be tried again.
        State.QUEUED: {ActorKind.OPERATOR, ActorKind.GATEWAY},
        State.SCRAPPED: {ActorKind.OPERATOR},
        # A worker releases the job that continues this one, if the operator ordered it so.
        State.CONTINUED: {ActorKind.OPERATOR, ActorKind.WORKER},
        # A late report of the last gateway is evidence; it starts no machine.
        State.DONE: {ActorKind.OPERATOR, ActorKind.GATEWAY},
    }


def test_a_job_that_ran_is_never_queued_again_except_through_interrupted() -> None:
    """The only other way is a program that its machine has refused before it executed a line."""
    ways = [row for row in TRANSITIONS if row.target is State.QUEUED]
    assert {row.action for row in ways} == {Action.RELEASE, Action.REQUEUE, Action.RETURN}
    assert {row.source for row in ways if row.action is Action.RETURN} == {
        State.RUNNING,
        State.HELD,
    }
    assert {row.source for row in ways if row.action is Action.REQUEUE} == {State.INTERRUPTED}


def test_nothing_runs_that_was_not_ready_and_queued() -> None:
    assert State.RUNNING not in reachable(State.RECEIVED, without=frozenset({State.READY}))
    assert State.RUNNING not in reachable(State.RECEIVED, without=frozenset({State.QUEUED}))


def test_the_party_that_moves_a_job_distinguishes_its_sources() -> None:
    assert sources(Action.CANCEL, ActorKind.GATEWAY) == (State.RUNNING, State.HELD)
    assert sources(Action.INTERRUPT, ActorKind.OPERATOR) == ()


def test_a_state_and_an_action_have_one_row_and_an_action_one_target() -> None:
    assert len({(row.source, row.action) for row in TRANSITIONS}) == len(TRANSITIONS)
    assert len({(row.action, row.target) for row in TRANSITIONS}) == len(Action)
    assert all(action_between(row.source, row.target) is row.action for row in TRANSITIONS)
    assert set(ADVICE) == set(State)


def test_a_board_lies_on_the_table_while_running_held_and_interrupted() -> None:
    assert {*ON_TABLE} == {"running", "held", "interrupted"}


def test_ids_are_ten_signs_that_cannot_be_mistaken_for_another() -> None:
    ids = {new_id() for _ in range(1000)}
    assert len(ids) == 1000
    assert {len(id) for id in ids} == {10}
    assert not set("".join(ids)) & set("0o1il")
