"""The driver of boards with an MCX314 against a simulated board, with each fault of the link."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, AsyncIterator
from contextlib import aclosing, asynccontextmanager
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
)
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.mcx314 import connection
from knifetip.gateway.mcx314.connection import RunningProgram
from knifetip.gateway.mcx314.driver import Mcx314, dial
from knifetip.gateway.mcx314.link import Link
from knifetip.gateway.motion import Limits
from knifetip.gateway.operations import perform
from knifetip.gateway.stream import Progress, stream
from knifetip.library import load
from knifetip.simulators.mcx314 import simulator
from knifetip.simulators.mcx314.board_link import LinkFaults
from knifetip.simulators.mcx314.simulator import BoardServer

TABLE = load.machine("v-groove-table")
SAFE = SafeState.from_machine(TABLE)
HEAD = """MCX314 1
PULSES X200 Y200 Z400 C100
GO Z8000
OUT 0 OFF
OUT 1 OFF
OUT 2 OFF
OSC OFF
OUT 0 ON
OSC ON
DWELL 150
"""
FOOT = "GO Z8000\nOUT 0 OFF\nOUT 1 OFF\nOUT 2 OFF\nOSC OFF\nEND\n"


def strips(count: int) -> bytes:
    """Return a program that cuts strips of 300 mm along X, 5 mm apart, at 400 mm/s."""
    text = HEAD
    for strip in range(count):
        text += f"GO X10000 Y{4000 + 1000 * strip} C0\nGO Z800\nLINE Z-920 V40000\n"
        # In pieces of 1 mm, as the chords of an arc.
        text += "LINE X200 V80000\n" + "LINE X200 V80000 JOIN\n" * 299
        text += "LINE Z920 V40000\n"
    return (text + FOOT).encode()


@asynccontextmanager
async def connected(
    *, speed: float = 5.0, homed: bool = True, silence: float = 0.6, sample: float = 0.0
) -> AsyncIterator[tuple[BoardServer, Mcx314]]:
    """Start a simulated board and connect the driver to it; yield both."""
    async with await simulator.serve(TABLE, speed=speed, sample=sample, homed=homed) as server:
        controller = await dial(server.address, SAFE, silence=silence, poll=0.02)
        try:
            yield server, controller
        finally:
            await controller.close()


def run(text: bytes, controller: Mcx314) -> aclosing[AsyncGenerator[Progress, None]]:
    return aclosing(stream(text, controller, limits=Limits.from_machine(TABLE), interval=0.01))


async def run_to_end(text: bytes, controller: Mcx314) -> list[Progress]:
    async with asyncio.timeout(120.0), run(text, controller) as updates:
        return [progress async for progress in updates]


async def until_cutting(updates: AsyncGenerator[Progress, None], share: float = 0.2) -> Progress:
    """Return the first report in the middle of a strip, with the knife in the board."""
    async for progress in updates:
        if progress.position[2] < 0.0 and progress.executed > share * progress.lines:
            return progress
    raise AssertionError("the program ended without a cut")


async def fails(
    updates: AsyncGenerator[Progress, None], kind: type[ControllerError]
) -> ControllerError:
    async with asyncio.timeout(120.0):
        with pytest.raises(kind) as failure:
            async for _ in updates:
                pass
    return failure.value


def alarm_code(controller: Mcx314) -> str:
    """Return the code of the alarm that locks a controller, "" for none."""
    return "" if controller.alarm is None else controller.alarm.code


def faults(server: BoardServer, **counts: int) -> None:
    """Inject faults at requests that come after the present one, by their distance."""
    now = server.board.requests
    chosen: dict[str, Any] = {
        name: now + count
        if name in ("hang_up", "silent_from")
        else frozenset(range(now + count, now + count + 900, 31))
        for name, count in counts.items()
    }
    server.board.faults = LinkFaults(**chosen)


def assert_safe(server: BoardServer) -> None:
    board = server.board
    assert board.position[2] >= TABLE.travel_z - 1e-9
    assert board.outputs == set()
    assert not board.oscillates
    # The knife was lifted before its station was released.
    released = [event for event in board.switched if event.output == 0 and not event.on][-1]
    assert released.position[2] == 8000
    assert not released.moving
    assert board.refusals == []


# -- programs -------------------------------------------------------------------------------------


async def test_a_program_runs_to_its_end_and_the_executed_line_follows_the_head() -> None:
    text = strips(3)
    rows = text.decode().splitlines()
    async with connected() as (server, controller):
        seen = await run_to_end(text, controller)
        board = server.board
        assert (board.refusals, board.starved) == ([], 0)
        assert_safe(server)
        assert controller.acknowledged == controller.sent == len(rows)
        # The same connection runs the next program.
        assert (await run_to_end(strips(1), controller))[-1].executed == strips(1).count(b"\n")
    executed = [progress.executed for progress in seen]
    assert executed == sorted(executed)
    assert len(set(executed)) > 20
    assert seen[-1].executed == seen[-1].lines == len(rows)
    # The head is at the depth of the cut before the plunge counts as executed.
    cutting = [
        progress
        for progress in seen
        if progress.position[2] == -0.3 and (progress.executed - 13) % 304 in range(1, 299)
    ]
    assert len(cutting) > 10
    for progress in cutting:
        # Line 14 is the first piece of the first strip, of 304 lines each.
        strip, piece = divmod(progress.executed - 13, 304)
        assert progress.position[1] == 20.0 + 5.0 * strip
        assert abs(progress.position[0] - 50.0 - piece) <= 1.5
        assert progress.output == 0


async def test_a_hold_stops_on_the_path_and_a_resume_continues_it() -> None:
    async with (
        connected(sample=0.002) as (server, controller),
        run(strips(2), controller) as course,
    ):
        await until_cutting(course)
        await controller.hold()
        async for progress in course:
            if progress.state is State.HOLD and (await controller.status()).still:
                break
        held = server.board.position
        assert held[2] == -0.3
        assert 50.0 < held[0] < 350.0
        assert server.board.outputs == {0}
        for _ in range(10):
            await anext(course)
        assert server.board.position == held
        await controller.resume()
        rest = [progress async for progress in course]
        assert rest[-1].executed == rest[-1].lines
        assert_safe(server)
        samples = server.board.samples()
    low = samples[samples[:, 3] == -0.3]
    assert set(low[:, 2]) == {20.0, 25.0}
    for y in (20.0, 25.0):
        cut = np.sort(low[low[:, 2] == y, 1])
        assert (cut[0], cut[-1]) == pytest.approx((50.0, 350.0), abs=1.0)
        assert np.diff(cut).max() < 0.9


async def test_an_abort_ramps_down_lifts_the_tool_and_releases_the_station() -> None:
    async with connected() as (server, controller):
        async with run(strips(2), controller) as course:
            await until_cutting(course)
            assert server.board.outputs == {0}
        assert_safe(server)
        assert controller.fault is None
        assert (await controller.status()).state is State.IDLE
        assert (await run_to_end(strips(1), controller))[-1].state is State.IDLE


async def test_an_aborted_program_counts_as_ended_when_the_next_one_is_followed() -> None:
    async with connected() as (_, controller):
        async with run(strips(2), controller) as course:
            progress = await until_cutting(course)
        assert progress.executed < progress.lines
        assert (await controller.status()).acknowledged == controller.sent == progress.lines


async def test_the_line_that_the_board_executes_is_reported_and_not_the_sent_one() -> None:
    async with connected() as (server, controller), run(strips(2), controller) as course:
        progress = await until_cutting(course)
        program = server.board.program
        assert program is not None
        assert program.loaded > progress.executed + 50


# -- faults of the link ---------------------------------------------------------------------------


@pytest.mark.parametrize("fault", ["drop_answers", "damage_answers", "ignore"])
async def test_requests_are_repeated_and_executed_once(fault: str) -> None:
    text = strips(3)
    async with connected(speed=1.0, silence=1.5) as (server, controller):
        link = controller._connection.link
        async with run(text, controller) as course:
            await until_cutting(course, 0.05)
            faults(server, **{fault: 1})
            seen = [progress async for progress in course]
        assert seen[-1].executed == text.count(b"\n")
        assert link.repeated > 2
        assert server.board.refusals == []
        # Each output was switched as often as in a run without faults.
        assert [event.on for event in server.board.switched if event.output == 0].count(True) == 1
        assert_safe(server)


async def test_a_silent_board_ends_the_job_and_stops_by_itself(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(connection, "PATIENCE", 0.5)
    async with connected() as (server, controller):
        async with run(strips(8), controller) as course:
            await until_cutting(course, 0.05)
            faults(server, silent_from=1)
            failure = await fails(course, ControllerSilent)
        assert "has not answered for 0.6 s" in failure.text
        assert "not in a safe state" in failure.text
        # The gateway could not, but the board did.
        assert_safe(server)
        assert server.board.state == "IDLE"


async def test_a_lost_connection_ends_in_the_safe_state_by_reconnecting() -> None:
    async with connected() as (server, controller), run(strips(8), controller) as course:
        await until_cutting(course, 0.05)
        faults(server, hang_up=2)
        board = server.board
        task = asyncio.create_task(fails(course, ControllerError))
        while not board.hangs_up:
            await asyncio.sleep(0.01)
        await asyncio.sleep(0.05)
        board.faults = LinkFaults()
        failure = await task
        assert "connection" in failure.text
        assert "stations were raised" in failure.text
        assert_safe(server)


async def test_a_gateway_that_is_gone_leaves_a_machine_that_makes_itself_safe(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(connection, "PATIENCE", 0.4)
    async with connected() as (server, controller), run(strips(8), controller) as course:
        await until_cutting(course, 0.05)
        await controller.close()
        async with asyncio.timeout(120.0):
            while server.board.state != "IDLE" or server.board.outputs:
                await asyncio.sleep(0.02)
        assert_safe(server)
        await fails(course, ControllerError)


async def test_a_machine_that_still_runs_is_taken_over_only_on_request() -> None:
    async with connected(speed=1.0) as (server, first):
        updates = stream(strips(4), first, limits=Limits.from_machine(TABLE), interval=0.01)
        await until_cutting(updates, 0.02)
        await first.close()
        busy = await dial(server.address, SAFE)
        with pytest.raises(ControllerOccupied, match="is busy"):
            await busy.status()
        await busy.close()
        assert server.board.outputs == {0}
        second = await dial(server.address, SAFE, stop_motion=True)
        assert_safe(server)
        await second.close()
        await updates.aclose()


async def test_a_program_that_another_client_discards_is_an_error() -> None:
    async with connected() as (server, controller), run(strips(4), controller) as course:
        await until_cutting(course, 0.05)
        other = Link(server.address, 1.0)
        server.board.receive(b"")
        await other.close()
        server.board._execution.abort()
        failure = await fails(course, ControllerError)
        assert "has discarded the program" in failure.text
        assert_safe(server)


# -- faults of the machine ------------------------------------------------------------------------


async def test_a_reset_is_noticed_and_only_homing_helps() -> None:
    async with connected() as (server, controller):
        async with run(strips(4), controller) as course:
            await until_cutting(course, 0.05)
            server.board.reset()
            failure = await fails(course, ControllerReset)
        assert "not lifted" in failure.text
        assert server.board.outputs == set()
        assert alarm_code(controller) == "mcx314.alarm-unhomed"
        with pytest.raises(ControllerAlarm):
            await controller.status()
        await controller.home()
        assert alarm_code(controller) == ""
        assert_safe(server)
        assert (await run_to_end(strips(1), controller))[-1].state is State.IDLE


async def test_an_emergency_stop_ends_the_job_and_is_cleared_by_a_person() -> None:
    async with connected() as (server, controller):
        async with run(strips(4), controller) as course:
            await until_cutting(course, 0.05)
            server.board.press_stop()
            failure = await fails(course, ControllerAlarm)
        assert "emergency stop" in failure.text
        assert server.board.position[2] == -0.3
        # The outputs are off although the tool could not be lifted.
        assert server.board.outputs == set()
        with pytest.raises(ControllerRejected, match="emergency"):
            await controller.unlock()
        server.board.release_stop()
        await controller.unlock()
        assert alarm_code(controller) == "mcx314.alarm-unhomed"
        await controller.home()
        assert alarm_code(controller) == ""
        assert_safe(server)


@pytest.mark.parametrize(
    ("alarm", "words"),
    [
        ("limit-X", "axis X .* is at its limit switch"),
        ("drive-C", "drive of the axis C .* reports a fault"),
        ("chip", "received a segment too late"),
        ("smoke", "reports the alarm smoke"),
    ],
)
async def test_each_alarm_has_its_meaning(alarm: str, words: str) -> None:
    async with connected() as (server, controller), run(strips(1), controller) as course:
        await until_cutting(course, 0.05)
        server.board.trip(alarm)
        failure = await fails(course, ControllerAlarm)
    with pytest.raises(ControllerAlarm, match=words):
        raise failure
    assert failure.hint


async def test_a_head_off_its_path_is_stopped() -> None:
    async with connected(speed=1.0) as (server, controller), run(strips(4), controller) as course:
        await until_cutting(course, 0.02)
        server.board.chip.lose(1, 400)
        failure = await fails(course, ControllerError)
        assert "2.0 mm away from the path" in failure.text
        assert server.board.outputs == set()


async def test_a_board_that_is_not_homed_is_returned_locked() -> None:
    async with connected(homed=False) as (server, controller):
        assert isinstance(controller.fault, ControllerAlarm)
        assert "not homed" in controller.fault.text
        assert controller.connected
        with pytest.raises(ControllerAlarm):
            await controller.status()
        await controller.home()
        assert (await controller.status()).position == (0.0, 0.0, 20.0, 0.0)
        assert server.board.state == "IDLE"


# -- what is refused ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b"LINE Z-920", b"G1 Z-920", "Program line 13 .* is not an instruction"),
        (b"PULSES X200", b"PULSES X100", "other pulses per millimetre"),
    ],
)
async def test_a_wrong_program_is_refused_before_a_line_is_sent(
    old: bytes, new: bytes, words: str
) -> None:
    async with connected() as (server, controller):
        with pytest.raises(ControllerRejected, match=words):
            await run_to_end(strips(1).replace(old, new), controller)
        assert server.board.program is None
        assert controller.fault is None


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        (b"MCX314 1", b"MCX314 2", "line 1 format"),
        (b"LINE Z-920 V40000", b"LINE Z-920 V400001", "line 13 speed"),
        (b"LINE Z-920 V40000", b"LINE X1 Y1 Z1 C1 V40000", "line 13 axes"),
        (b"LINE Z-920 V40000", b"LINE Z-9200000 V40000", "line 13 range"),
        (b"DWELL 150", b"END", "line 10 end"),
        (b"PULSES X200 Y200 Z400 C100\n", b"; no pulses\n", "line 3 pulses"),
    ],
)
async def test_the_board_refuses_lines_and_the_machine_is_made_safe(
    old: bytes, new: bytes, code: str
) -> None:
    async with connected(speed=50.0) as (server, controller):
        with pytest.raises(ControllerRejected, match=rf"refused LOAD: {code}"):
            await run_to_end(strips(1).replace(old, new, 1), controller)
        assert server.board.position[2] == 20.0
        assert server.board.outputs == set()
        # The board has reported that it had begun no line.
        assert controller.sent == 0


@pytest.mark.parametrize("way", ["reset", "begun", "discarded"])
async def test_a_board_that_cannot_tell_whether_it_has_begun_counts_as_begun(way: str) -> None:
    text = strips(1).replace(b"LINE Z-920 V40000", b"LINE Z-920 V400001", 1)
    async with connected() as (server, controller):
        board, load = server.board, controller._load

        async def failing(text: bytes, program: RunningProgram) -> None:
            try:
                await load(text, program)
            except ControllerRejected:
                if way == "reset":
                    board.reset()
                elif way == "discarded":
                    board._execution.abort()
                    board._execution.work()
                elif board.program is not None:
                    board.program.done = 1
                raise

        controller._load = failing  # type: ignore[method-assign]  # of this object only
        with pytest.raises(ControllerError):
            await run_to_end(text, controller)
        assert controller.sent == text.count(b"\n")


async def test_another_device_is_refused() -> None:
    async def answer(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while await reader.readline():
            writer.write(b"ok\r\n")
        writer.close()

    server = await asyncio.start_server(answer, "127.0.0.1", 0)
    port = server.sockets[0].getsockname()[1]
    async with server:
        with pytest.raises(ControllerSilent, match="has not answered"):
            await dial(f"127.0.0.1:{port}", SAFE, silence=0.2)


# -- operations of a person -----------------------------------------------------------------------


async def operate(controller: Mcx314, name: OperationName, **arguments: Any) -> None:
    operation = replace(Operation(name), **arguments)
    await perform(operation, controller, TABLE, lambda: False)


async def wait_until_still(controller: Mcx314) -> tuple[float, ...]:
    while (status := await controller.status()).state is not State.IDLE or not status.still:
        await asyncio.sleep(0.01)
    return status.position


async def test_a_person_can_jog_zero_park_and_switch() -> None:
    async with connected(speed=5.0) as (server, controller):
        await operate(controller, OperationName.JOG, axis="X", distance=120.5, feed=6000.0)
        assert (await controller.status()).state is State.JOG
        assert await wait_until_still(controller) == (120.5, 0.0, 20.0, 0.0)
        await operate(controller, OperationName.JOG, axis="C", distance=-90.0, feed=6000.0)
        assert await wait_until_still(controller) == (120.5, 0.0, 20.0, -90.0)
        await operate(controller, OperationName.ZERO, axes="XC")
        assert await wait_until_still(controller) == (0.0, 0.0, 20.0, 0.0)
        assert server.board.position == (120.5, 0.0, 20.0, -90.0)
        await operate(controller, OperationName.SWITCH, output=1, on=True)
        assert controller.switched_on == frozenset({1})
        assert server.board.outputs == {1}
        await operate(controller, OperationName.SPINDLE, station=1, on=True)
        assert (controller.spinning, server.board.oscillates) == (1, True)
        await operate(controller, OperationName.PARK)
        assert (controller.spinning, controller.switched_on) == (0, frozenset())
        assert (server.board.oscillates, server.board.outputs) == (False, set())
        await wait_until_still(controller)
        assert server.board.refusals == []


async def test_a_jog_can_be_stopped() -> None:
    async with connected(speed=1.0) as (server, controller):
        await operate(controller, OperationName.JOG, axis="X", distance=1000.0, feed=30000.0)
        while server.board.position[0] < 10.0:
            await asyncio.sleep(0.01)
        await operate(controller, OperationName.STOP_JOG)
        x, *_ = await wait_until_still(controller)
        assert 10.0 < x < 500.0
        assert server.board.refusals == []


async def test_the_board_stops_a_jog_whose_gateway_is_dead() -> None:
    """At 100 mm/s; with a gateway the jog of 1000 mm takes 10 s."""
    async with connected(speed=1.0) as (server, controller):
        await operate(controller, OperationName.JOG, axis="X", distance=1000.0, feed=6000.0)
        while server.board.position[0] < 150.0:  # longer than the board waits
            await asyncio.sleep(0.01)
        at = server.board.position[0]
        await controller.close()
        before = -1.0
        while server.board.position[0] != before:
            before = server.board.position[0]
            await asyncio.sleep(0.1)
        assert 0.0 < before - at < 160.0
        assert server.board.position[2] == 20.0
        assert server.board.refusals == []


async def test_runs_above_the_board_are_refused() -> None:
    async with connected() as (_, controller):
        with pytest.raises(ControllerError, match="dry_run"):
            await operate(controller, OperationName.DRY_RUN)
