"""Limit of the processor time of a reading; the times are processor time, not time on the clock."""

from __future__ import annotations

import time
from contextlib import suppress

import pytest

from knifetip.errors import DrawingTooLarge
from knifetip.formats.cpu_limit import limit_cpu


def burn(seconds: float) -> None:
    """Use so much processor time."""
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def test_a_reading_that_uses_its_time_is_refused() -> None:
    with pytest.raises(DrawingTooLarge) as refused, limit_cpu(0.2):
        burn(30.0)
    assert refused.value.message.code == "reading.too-slow"


def test_a_reader_that_catches_the_error_is_stopped_again() -> None:
    def read() -> None:
        with suppress(DrawingTooLarge):
            burn(30.0)
        burn(30.0)

    with pytest.raises(DrawingTooLarge), limit_cpu(0.1):
        read()


def test_nothing_is_raised_within_the_time_and_after_it() -> None:
    with limit_cpu(5.0):
        burn(0.1)
    with limit_cpu(0.2):
        pass
    burn(0.5)


def test_waiting_uses_no_time() -> None:
    with limit_cpu(0.3):
        time.sleep(0.6)
