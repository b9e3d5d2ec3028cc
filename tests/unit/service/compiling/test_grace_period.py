from __future__ import annotations

from knifetip.service.compiling.grace_period import GracePeriod
from knifetip.service.lifecycle.transitions import LEASE


def seconds(grace: GracePeriod, start: float, count: float) -> bool:
    """Ask ``grace`` every second for ``count`` seconds; return whether it is over at the end."""
    now = start
    over = grace.is_over(now)
    while now < start + count:
        now += 1.0
        over = grace.is_over(now)
    return over


def test_a_process_that_has_just_started_waits_one_lease() -> None:
    grace = GracePeriod()
    assert not seconds(grace, 1000.0, LEASE)
    assert grace.is_over(1000.0 + LEASE + 1.0)


def test_a_process_that_was_suspended_waits_anew() -> None:
    grace = GracePeriod()
    assert seconds(grace, 1000.0, LEASE + 5.0)
    assert not grace.is_over(5000.0)
    assert not seconds(grace, 5001.0, LEASE - 2.0)
    assert seconds(grace, 5001.0 + LEASE - 1.0, 3.0)


def test_a_clock_that_was_set_back_interrupts_nothing() -> None:
    grace = GracePeriod()
    assert seconds(grace, 1000.0, LEASE + 5.0)
    assert not grace.is_over(500.0)
