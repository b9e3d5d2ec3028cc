"""Programs over TCP to the simulated table: its movements, and the end of every failure."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncGenerator, AsyncIterator
from contextlib import aclosing, asynccontextmanager
from typing import Any

import numpy as np
import pytest

from knifetip.errors import (
    CheckRefused,
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
    ProgramError,
)
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.grbl import driver
from knifetip.gateway.grbl.driver import Grbl
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import Progress, stream
from knifetip.gateway.transport import connect
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import Faults, Table

MACHINE = load.machine("demo-table")
SAFE = SafeState.from_machine(MACHINE)
#: Safe state of the table, and the number of lines that the takeover sends: M5, M65 per output.
RELEASED = [(output, False) for output in SAFE.outputs]
TAKEOVER = 1 + len(RELEASED)

HEADER = """(knifetip 0.1.0)
(placement X20.0000 Y20.0000)
G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G0 Z20.0000
M64 P0
M3 S1
G4 P0.1500
"""
FOOTER = """G0 Z20.0000
M65 P0
M5
M30
"""


def slots(count: int) -> bytes:
    """Return a program that cuts slots of 200 × 10 mm with round ends, C along the outline."""
    text = HEADER
    for slot in range(count):
        y = 100.0 + 20.0 * slot
        text += f"""G0 X100.0000 Y{y:.4f} C0.0000
G1 Z-0.3000 F6000.0
G1 X300.0000 F24000.0
G93
G3 X300.0000 Y{y + 10.0:.4f} I0.0000 J5.0000 C180.0000 F600.0
G94
G1 X100.0000 F24000.0
G93
G3 X100.0000 Y{y:.4f} I0.0000 J-5.0000 C360.0000 F600.0
G94
G0 Z20.0000
"""
    return (text + FOOTER).encode()


def off_the_slots(samples: np.ndarray) -> np.ndarray:
    """Return the distance of each sample (time, x, y) from the outline of the nearest slot (mm)."""
    x, y = samples[:, 1], (samples[:, 2] - 100.0) % 20.0
    ends = np.hypot(x - np.clip(x, 100.0, 300.0), y - 5.0)
    return np.abs(np.where((x < 100.0) | (x > 300.0), ends, np.abs(y - 5.0)) - 5.0)


@asynccontextmanager
async def connected_table(
    *, speed: float = 50.0, faults: Faults | None = None, sample: float = 0.0, window: int = 128
) -> AsyncIterator[tuple[Table, Grbl]]:
    """Start a simulated table and connect a controller to it; yield both.

    Parameters
    ----------
    speed
        Speed of the table as a multiple of a real one.
    faults
        Faults that the table simulates.
    sample
        Period with which the table records its position (s), 0 for no records.
    window
        Size of the controller's receive buffer in bytes.
    """
    async with await simulator.serve(
        MACHINE, speed=speed, faults=faults, sample=sample, window=window
    ) as server:
        controller = await driver.dial(server.address, SAFE, silence=0.4, poll=0.02)
        try:
            yield server.table, controller
        finally:
            await controller.close()


def samples_of(table: Table) -> F64:
    """Return the recorded samples (time and pose) of a table."""
    assert table.trace is not None
    return table.trace.samples()


def run(program: bytes, controller: Grbl, **options: Any) -> AsyncGenerator[Progress]:
    asked: dict[str, Any] = {"limits": Limits.from_machine(MACHINE), "interval": 0.01} | options
    return stream(program, controller, **asked)


async def stream_to_end(program: bytes, controller: Grbl, **options: Any) -> list[Progress]:
    """Stream a program to its end; return all reports of progress."""
    async with asyncio.timeout(120.0), aclosing(run(program, controller, **options)) as course:
        return [progress async for progress in course]


async def test_the_table_moves_along_the_program_and_nowhere_else() -> None:
    program = slots(5)
    assert len(program) > 10 * 128
    async with connected_table(sample=0.002) as (table, controller):
        course = await stream_to_end(program, controller)
        assert table.lost == 0
        samples = samples_of(table)
    low = samples[samples[:, 3] < 0.0]
    assert len(low) > 1000
    assert off_the_slots(low).max() < 1e-6
    # Every slot was cut completely: both straight sides, and both ends as far as 95 and 305.
    assert low[:, 1].min() == pytest.approx(95.0, abs=0.1)
    assert low[:, 1].max() == pytest.approx(305.0, abs=0.1)
    assert {round(y) for y in low[:, 2]} >= {100 + 20 * slot for slot in range(5)}
    # On the arcs C is the azimuth of the tangent.
    right = low[low[:, 1] > 300.001]
    radial = np.degrees(np.arctan2((right[:, 2] - 100.0) % 20.0 - 5.0, right[:, 1] - 300.0))
    np.testing.assert_allclose(right[:, 4], radial + 90.0, atol=0.1)
    last = course[-1]
    assert last.executed == last.acknowledged == last.lines == program.count(b"\n")
    assert last.state is State.IDLE
    assert last.seconds_left == 0.0


async def test_the_executed_line_follows_the_head_and_not_what_was_sent() -> None:
    program = slots(4)
    rows = program.decode().splitlines()
    async with connected_table(speed=5.0) as (_, controller):
        course = await stream_to_end(program, controller)
    executed = [progress.executed for progress in course]
    assert executed == sorted(executed)
    assert max(progress.acknowledged - progress.executed for progress in course) >= 5
    straight = [
        progress
        for progress in course
        if progress.state is State.RUN and 110.0 < progress.position[0] < 290.0
    ]
    assert len(straight) > 8
    for progress in straight:
        # Outward passes run along y = 100, 120 …, return passes along y = 110, 130 ….
        row = rows[progress.executed]
        if progress.position[2] < 0.0:
            out = round(progress.position[1]) % 20 == 0
            assert row.startswith("G1 X300" if out else "G1 X100"), (progress, row)


async def test_remaining_seconds_decrease_and_are_nearly_correct() -> None:
    async with connected_table(speed=5.0) as (table, controller):
        left: dict[int, tuple[float | None, float]] = {}
        async with aclosing(run(slots(2), controller)) as course:
            async for progress in course:
                if progress.state is State.RUN:
                    left.setdefault(progress.executed, (progress.seconds_left, table.time))
    first, began = next(iter(left.values()))
    assert first == pytest.approx(table.time - began, rel=0.2)
    seconds = [each for each, _ in left.values() if each is not None]
    assert len(seconds) == len(left)
    assert seconds[-1] < 0.2 * seconds[0]


async def test_pistons_move_only_while_the_table_is_at_rest() -> None:
    async with connected_table() as (table, controller):
        await stream_to_end(slots(2), controller)
        switched = [(event.output, event.on) for event in table.switch_events]
        assert switched[: len(RELEASED)] == RELEASED
        assert switched[len(RELEASED) :] == [(0, True), (0, False)]
        assert not any(event.moving for event in table.switch_events)
        assert table.switch_events[-1].position[2] == 20.0


async def test_a_greater_buffer_is_used_when_the_controller_reports_one() -> None:
    async with connected_table(window=1024) as (table, controller):
        await stream_to_end(slots(3), controller)
        assert table.lost == 0


async def test_a_thousand_lines_arrive_in_order_at_a_thousandfold_speed() -> None:
    program = slots(50)
    async with connected_table(speed=1000.0) as (table, controller):
        course = await stream_to_end(program, controller)
        assert course[-1].executed == program.count(b"\n") > 500
        assert table.position[1] == 100.0 + 20.0 * 49


async def test_a_dropped_ok_ends_in_silence_that_names_a_line_with_the_tool_up() -> None:
    async with connected_table(faults=Faults(drop_ok=frozenset({TAKEOVER + 20}))) as (
        table,
        controller,
    ):
        with pytest.raises(
            ControllerSilent, match=r"No response to program line \d+ .*was received"
        ):
            await stream_to_end(slots(1), controller)
        assert table.state == "Idle"
        assert table.position[2] == 20.0
        # The controller is in a known state: the next program runs.
        assert controller.fault is None
        await stream_to_end(slots(1), controller)


async def test_a_reset_within_an_arc_stops_everything() -> None:
    program = slots(3)
    async with connected_table(speed=5.0, faults=Faults(reset_in_arc=2), sample=0.001) as (
        table,
        controller,
    ):
        with pytest.raises(ControllerReset, match="was reset"):
            await stream_to_end(program, controller)
        where = table.position
        # In the middle of the arc at the left end of the first slot, near (100, 105).
        assert where[0] == pytest.approx(95.0, abs=0.05)
        assert where[1] == pytest.approx(105.0, abs=0.5)
        await asyncio.sleep(0.05)
        assert table.position == where
        assert table.state == "Alarm"
        with pytest.raises(ControllerAlarm, match="locked"):
            await controller.send(b"G0 Z20", 1)
        samples = samples_of(table)
    low = samples[samples[:, 3] < 0.0]
    assert off_the_slots(low).max() < 1e-6
    assert low[:, 2].max() <= 110.0 + 1e-9


async def test_after_an_alarm_only_the_operator_can_continue() -> None:
    async with await simulator.serve(MACHINE, speed=50.0) as server:
        server.table.receive(b"G0 X5000\n\x18")
        controller = await driver.dial(server.address, silence=0.4)
        with pytest.raises(ControllerAlarm, match="locked"):
            await stream_to_end(slots(1), controller)
        assert server.table.state == "Alarm"
        await controller.unlock()
        assert (await stream_to_end(slots(1), controller))[-1].state is State.IDLE
        await controller.close()


async def test_hold_within_an_arc_stops_and_resume_finishes_the_same_path() -> None:
    async with connected_table(speed=2.0, sample=0.0005) as (table, controller):
        held, asked = [], False
        async with aclosing(run(slots(1), controller, interval=0.002)) as course:
            async for progress in course:
                if progress.position[0] > 270.0 and not asked:
                    table.speed = 0.2
                if progress.position[0] > 300.1 and not asked:
                    asked = True
                    await controller.hold()
                if progress.state is State.HOLD:
                    table.speed = 50.0
                    if table.state == "Hold:0":
                        held.append(progress)
                    if len(held) == 10:
                        await controller.resume()
        assert asked
        x, y, z, _ = held[5].position
        assert held[5].position == held[9].position
        assert math.hypot(x - 300.0, y - 105.0) == pytest.approx(5.0, abs=1e-3)
        assert z == -0.3
        samples = samples_of(table)
    assert off_the_slots(samples[samples[:, 3] < 0.0]).max() < 1e-6


async def test_closing_the_stream_stops_the_machine_and_raises_the_tool() -> None:
    async with connected_table(speed=2.0) as (table, controller):
        async with aclosing(run(slots(3), controller)) as course:
            async for progress in course:
                if progress.position[2] < 0.0 and progress.position[0] > 150.0:
                    break
        assert (await controller.status()).state is State.IDLE
        x, y, z, _ = table.position
        assert z == 20.0
        assert (150.0 < x < 300.0, y) == (True, 100.0)
        assert not table.oscillating
        await stream_to_end(slots(1), controller)


async def test_closing_the_stream_during_the_check_moves_nothing() -> None:
    async with connected_table() as (table, controller):
        async with aclosing(run(slots(50), controller, interval=0.001)) as course:
            async for progress in course:
                if progress.state is State.CHECK:
                    break
        assert table.state == "Idle"
        assert table.time == 0.0


async def test_a_line_that_the_controller_would_refuse_stops_the_job_before_it_moves() -> None:
    program = slots(2).replace(b"G1 X300.0000 F24000.0\n", b"G1 X300.0000 F24000.0 Q7\n")
    async with connected_table() as (table, controller):
        with pytest.raises(ControllerRejected, match=r"line 10 .*error:20"):
            await stream_to_end(program, controller)
        assert table.time == 0.0
        assert not any(table.outputs.values())
        await stream_to_end(slots(1), controller)


async def test_a_move_beyond_the_travel_is_found_before_anything_moves() -> None:
    program = slots(2).replace(b"X300.0000", b"X1800.0000")
    async with connected_table() as (table, controller):
        with pytest.raises(CheckRefused, match="ALARM:2"):
            await stream_to_end(program, controller)
        assert table.time == 0.0


async def test_a_line_refused_in_the_middle_stops_the_machine_with_the_tool_up() -> None:
    async with connected_table(faults=Faults(errors={TAKEOVER + 25: 20})) as (table, controller):
        with pytest.raises(ControllerRejected, match=r"line 25 .*error:20"):
            await stream_to_end(slots(3), controller)
        assert table.state == "Idle"
        assert table.position[2] == 20.0
        assert table.position[1] < 140.0


async def test_a_broken_connection_ends_the_job_at_once() -> None:
    async with connected_table(faults=Faults(disconnect=TAKEOVER + 12)) as (_, controller):
        with pytest.raises(ControllerError, match="is lost"):
            await stream_to_end(slots(2), controller)


async def test_a_program_with_realtime_bytes_in_a_comment_is_never_sent() -> None:
    program = b"(is this the box?)\n" + slots(1)
    async with connected_table() as (table, controller):
        with pytest.raises(ProgramError, match="Line 1 of the program contains the byte 0x3f"):
            await stream_to_end(program, controller, check=False)
        assert table.time == 0.0


async def test_an_empty_program_is_done_at_once() -> None:
    async with connected_table() as (_, controller):
        assert (await stream_to_end(b"", controller))[-1].lines == 0


async def test_a_table_takes_one_sender_at_a_time_and_the_next_one_after_it() -> None:
    async with await simulator.serve(MACHINE, speed=50.0) as server:
        first = await driver.dial(server.address, silence=0.4)
        second = await connect(server.address)
        assert b"another sender" in await second.read()
        assert await second.read() == b""
        await second.close()
        await first.close()
        async with asyncio.timeout(60.0):
            while True:
                try:
                    third = await driver.dial(server.address, silence=0.4)
                    break
                except ControllerError:
                    await asyncio.sleep(0.01)
        assert (await third.status()).state is State.IDLE
        await third.close()


async def test_noise_from_the_network_does_not_stop_the_table() -> None:
    async with await simulator.serve(MACHINE, speed=50.0) as server:
        transport = await connect(server.address)
        await transport.write(bytes(range(0x80, 0x100)) + b"GET / HTTP/1.1\r\n\r\n" + b"\x00" * 500)
        await transport.close()
        async with asyncio.timeout(60.0):
            while True:
                try:
                    controller = await driver.dial(server.address, silence=0.4)
                    break
                except ControllerError:
                    await asyncio.sleep(0.01)
        await stream_to_end(slots(1), controller)
        await controller.close()
