"""The simulated controller without a network: its answers and the movements of its table."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from knifetip.library import load
from knifetip.simulators.grbl.table import Faults, Table

MACHINE = load.machine("demo-table")


class Bench:
    """A simulated table that records its answers."""

    def __init__(self, **options: Any) -> None:
        self.answers: list[str] = []
        self.table = Table(MACHINE, **options)
        self.table.answer = self.answers.append

    def send(self, text: bytes, *, elapse: float = 0.0) -> list[str]:
        """Send bytes, let ``elapse`` seconds pass, and return the answers."""
        self.answers.clear()
        self.table.receive(text)
        if elapse:
            self.table.elapse(elapse)
        return list(self.answers)


async def test_a_rapid_and_a_feed_end_where_they_should_and_take_their_time() -> None:
    bench = Bench()
    assert bench.send(b"G21 G90 G94\nG1 X500 F30000\n", elapse=10.0) == ["ok", "ok"]
    # 500 mm at 500 mm/s is 1 s; both ramps of 500 / 8,000 s have half the speed on average.
    assert bench.table.time == pytest.approx(1.0 + 500.0 / 8000.0)
    assert bench.table.position == (500.0, 0.0, 20.0, 0.0)


async def test_the_status_report_has_four_axes_buffers_and_the_line_number() -> None:
    bench = Bench()
    bench.send(b"N7 G1 X500 F30000\nN8 G1 X0\n", elapse=0.0625)
    assert bench.send(b"?") == [
        "<Run|MPos:15.625,0.000,20.000,0.000|Bf:13,128|FS:30000,0|Ln:7"
        "|Ov:100,100,100|WCO:0.000,0.000,0.000,0.000>"
    ]


async def test_lines_are_answered_until_the_planner_is_full() -> None:
    bench = Bench()
    lines = b"".join(b"X%d\n" % row for row in range(1, 21))
    assert bench.send(b"G1 F600\n" + lines) == ["ok"] * 16
    assert bench.send(b"", elapse=0.15) == ["ok"]


async def test_bytes_that_overflow_the_buffer_are_lost_and_garble_what_follows() -> None:
    bench = Bench()
    bench.send(b"G1 F600\n" + b"".join(b"X%d\n" % row for row in range(1, 16)))
    bench.send(b"X100\n" * 40)  # one line is taken out, then 128 bytes fit: 25 lines and "X10"
    assert bench.table.lost == 200 - 5 - 128
    answers = bench.send(b"", elapse=500.0)
    assert answers == ["ok"] * 26
    assert bench.send(b"0 Y\n", elapse=500.0) == ["error:2"]


async def test_realtime_bytes_pass_a_full_buffer() -> None:
    bench = Bench()
    bench.send(b"G1 F600\n" + b"".join(b"X%d\n" % row for row in range(1, 16)))
    bench.send(b"X100\n" * 40)
    assert bench.send(b"?")[0].startswith("<Run|")


async def test_a_hold_decelerates_in_mid_arc_and_resume_goes_on() -> None:
    bench = Bench(sample=0.001)
    bench.send(b"G0 X200\nG4 P0\n", elapse=10.0)
    bench.send(b"G3 X0 Y200 I-200 J0 F30000\n", elapse=0.3)
    bench.send(b"!", elapse=0.001)
    assert bench.send(b"?")[0].startswith("<Hold:1|")
    bench.send(b"", elapse=5.0)
    assert bench.send(b"?")[0].startswith("<Hold:0|")
    x, y, _, _ = bench.table.position
    assert np.hypot(x, y) == pytest.approx(200.0)
    assert 0.0 < y < 200.0
    bench.send(b"~", elapse=5.0)
    assert bench.table.position[:2] == (0.0, 200.0)
    assert bench.table.trace is not None
    arc = bench.table.trace.samples()[1:]
    on_arc = arc[arc[:, 2] > 0.0]
    np.testing.assert_allclose(np.hypot(on_arc[:, 1], on_arc[:, 2]), 200.0, atol=1e-9)


async def test_outputs_act_when_they_are_read_and_oscillation_waits() -> None:
    bench = Bench()
    answers = bench.send(b"G1 X100 F6000\nM64 P1\nM3 S1\n", elapse=0.5)
    assert answers == ["ok", "ok"]
    assert bench.table.outputs == {1: True}
    assert bench.table.switch_events[0].position[0] == 0.0
    assert not bench.table.oscillating
    assert bench.send(b"", elapse=1.0) == ["ok"]
    assert bench.table.oscillating


async def test_a_dwell_holds_back_its_answer_and_what_follows() -> None:
    bench = Bench()
    assert bench.send(b"G4 P0.5\nG0 X10\n", elapse=0.4) == []
    assert bench.table.position[0] == 0.0
    assert bench.send(b"", elapse=1.0) == ["ok", "ok"]
    assert bench.table.position[0] == 10.0


async def test_check_mode_reads_without_moving() -> None:
    bench = Bench()
    answers = bench.send(b"$C\nG1 X100 F6000\nG1 Y\n\nM64 P1\nG4 P10\n$C\n", elapse=1.0)
    assert answers[:7] == ["[MSG:Enabled]", "ok", "ok", "error:2", "ok", "ok", "ok"]
    assert answers[7:10] == ["[MSG:Disabled]", "ok", ""]
    assert answers[-1].startswith("GrblHAL")
    assert bench.table.position[0] == 0.0
    assert bench.table.outputs == {}
    assert bench.table.time == 0.0


async def test_a_move_beyond_the_travel_alarms_and_locks_until_reset_and_unlock() -> None:
    bench = Bench()
    assert bench.send(b"G0 X1700.1\n") == ["ALARM:2", "[MSG:Reset to continue]"]
    assert bench.send(b"?G0 X1\n") == []
    assert "[MSG:'$H'|'$X' to unlock]" in bench.send(b"\x18")
    assert bench.send(b"G0 X1\n") == ["error:9"]
    assert bench.send(b"$X\nG0 X1\n") == ["[MSG:Caution: Unlocked]", "ok", "ok"]


async def test_the_belly_of_an_arc_may_not_leave_the_travel_either() -> None:
    # Ends at y = 0 and 1,200; the belly of r = 600 reaches x = -600.
    bench = Bench()
    assert bench.send(b"G2 X0 Y1200 I0 J600 F6000\n") == ["ALARM:2", "[MSG:Reset to continue]"]


async def test_a_reset_while_moving_alarms_and_one_at_rest_does_not() -> None:
    bench = Bench()
    assert "ALARM:3" not in bench.send(b"\x18")
    bench.send(b"G1 X100 F6000\n", elapse=0.5)
    x = bench.table.position[0]
    assert bench.send(b"\x18")[0] == "ALARM:3"
    assert bench.table.position[0] == x
    assert bench.send(b"?")[0].startswith("<Alarm|")


async def test_a_reset_after_a_hold_keeps_the_machine_unlocked() -> None:
    bench = Bench()
    bench.send(b"G1 X100 F6000\n", elapse=0.5)
    bench.send(b"!", elapse=1.0)
    bench.send(b"\x18")
    assert bench.send(b"?")[0].startswith("<Idle|")
    assert bench.send(b"G1 X0 F6000\n", elapse=5.0) == ["ok"]
    assert bench.table.position[0] == 0.0


async def test_jogging_moves_and_other_lines_wait_their_turn() -> None:
    bench = Bench()
    assert bench.send(b"$J=G90 G21 Z30 F6000\n", elapse=0.01) == ["ok"]
    assert bench.send(b"?")[0].startswith("<Jog|")
    assert bench.send(b"G0 X1\n") == ["error:9"]
    bench.send(b"", elapse=5.0)
    assert bench.table.position[2] == 30.0
    assert bench.send(b"$J=Z100 F6000\n") == ["error:15"]
    assert bench.send(b"$J=Z10\n") == ["error:16"]


@pytest.mark.parametrize(
    ("line", "answer"), [(b"$Q\n", "error:3"), (b"$\n", "ok"), (b"$I\n", "ok"), (b"$$\n", "ok")]
)
async def test_commands_are_answered(line: bytes, answer: str) -> None:
    assert Bench().send(line)[-1] == answer


async def test_homing_unlocks() -> None:
    bench = Bench()
    bench.send(b"G0 X5000\n")
    bench.send(b"\x18")
    assert bench.send(b"$H\nG0 X10\n", elapse=5.0) == ["ok", "ok"]


async def test_faults_count_the_lines_of_the_program_outside_check_mode() -> None:
    bench = Bench(faults=Faults(drop_ok=frozenset({2}), errors={3: 24}))
    assert bench.send(b"$C\nG21\nG90\nG94\n$C\n").count("ok") == 5
    assert bench.send(b"G21\nG90\nG94\n\nG17\n") == ["ok", "error:24", "ok", "ok"]


async def test_the_reset_fault_strikes_half_way_along_its_arc() -> None:
    bench = Bench(faults=Faults(reset_in_arc=2))
    bench.send(b"G0 X600 Y400\nG3 X400 Y600 I-200 F30000\n", elapse=60.0)
    # About (400, 400), three quarters of a turn from 90 degrees: half way is at 225.
    answers = bench.send(b"G3 X600 Y400 J-200\n", elapse=60.0)
    assert answers[:2] == ["ok", ""]
    assert answers[3:] == ["[MSG:'$H'|'$X' to unlock]"]
    x, y, _, _ = bench.table.position
    assert np.degrees(np.arctan2(y - 400.0, x - 400.0)) == pytest.approx(-135.0, abs=0.5)
    assert bench.send(b"?")[0].startswith("<Alarm|")


async def test_a_speed_that_never_moves_is_refused() -> None:
    with pytest.raises(ValueError, match="never move"):
        Table(MACHINE, speed=0.0)
