"""How often a controller is asked for a report."""

from __future__ import annotations

import math

import pytest

from knifetip.gateway.grbl.polling import Polling
from knifetip.gateway.transport import byte_rate


def test_grblhal_is_asked_twice_as_often_as_other_firmware() -> None:
    assert Polling.for_controller(grblhal=True, byte_rate=math.inf) == Polling(0.05, 0.01)
    assert Polling.for_controller(grblhal=False, byte_rate=math.inf) == Polling(0.1, 0.02)


# 115,200 bits per second are 11,520 bytes per second, of which reports of 110 bytes may take a
# quarter: 26 reports per second.
@pytest.mark.parametrize(
    ("baud", "usual", "soon"),
    [(1_000_000, 0.05, 0.01), (115_200, 0.05, 0.038), (9600, 0.458, 0.458)],
)
def test_reports_take_at_most_a_quarter_of_a_slow_connection(
    baud: int, usual: float, soon: float
) -> None:
    polling = Polling.for_controller(grblhal=True, byte_rate=baud / 10.0)
    assert (polling.usual, polling.soon) == pytest.approx((usual, soon), abs=1e-3)


def test_a_connection_that_states_no_speed_limits_nothing() -> None:
    class Quick:
        address = "wire"

    class Slow(Quick):
        byte_rate = 960.0

    # arg-type: a transport needs no more than these attributes here.
    assert byte_rate(Quick()) == math.inf  # type: ignore[arg-type]
    assert byte_rate(Slow()) == 960.0  # type: ignore[arg-type]
