"""Turns to write to the database: one thread at a time, urgent ones first."""

from __future__ import annotations

import threading
import time

import pytest

from knifetip.service.database.write_lock import PriorityLock


def waiting(turns: PriorityLock, name: str, order: list[str], urgent: bool) -> threading.Thread:
    """Start a thread that waits for a turn and then appends its name to ``order``."""

    def act() -> None:
        with turns.acquired(urgent):
            order.append(name)

    thread = threading.Thread(target=act)
    thread.start()
    time.sleep(0.05)
    return thread


def test_urgent_ones_come_before_those_that_wait_longer() -> None:
    turns = PriorityLock()
    order: list[str] = []
    with turns.acquired(False):
        threads = [
            waiting(turns, "first", order, False),
            waiting(turns, "second", order, False),
            waiting(turns, "heartbeat", order, True),
        ]
        assert order == []
    for thread in threads:
        thread.join(5.0)
    assert order[0] == "heartbeat"
    assert sorted(order[1:]) == ["first", "second"]


def test_a_turn_ends_when_its_work_fails() -> None:
    turns = PriorityLock()
    for _ in range(2):
        with pytest.raises(ZeroDivisionError), turns.acquired(True):
            _ = 1 // 0
    order: list[str] = []
    waiting(turns, "next", order, False).join(5.0)
    assert order == ["next"]


def test_there_is_never_more_than_one() -> None:
    turns = PriorityLock()
    inside, most = 0, 0

    def act(urgent: bool) -> None:
        nonlocal inside, most
        for _ in range(50):
            with turns.acquired(urgent):
                inside += 1
                most = max(most, inside)
                time.sleep(0.0002)
                inside -= 1

    threads = [threading.Thread(target=act, args=(number % 2 == 0,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert most == 1
