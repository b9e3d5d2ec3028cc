"""The driver of the gateway on a complete LinuxCNC, which it runs through the remote shell."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, AsyncIterator, Iterator, Mapping
from contextlib import aclosing, asynccontextmanager
from pathlib import Path

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import (
    CheckRefused,
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerSilent,
)
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.linuxcnc.driver import Linuxcnc, dial
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.stream import Progress, stream
from knifetip.model.dieline import LineType
from tests.controllers.linuxcnc_machine import Machine, Supply, missing_requirement, wait_until
from tests.controllers.quick_router import BOARD, ROUTER, TABLE, WHEEL
from tests.support.shapes import closed, dieline, edges

SKIP_REASON = missing_requirement()
pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]


SAFE = SafeState.from_machine(TABLE)
#: Columns of the samples with the valves: after joints, outputs 0 to 3 and spindle.
VALVE = {output: 4 + 4 + 1 + output for output in TABLE.outputs}


@pytest.fixture(scope="module")
def supply() -> Iterator[Supply]:
    with Supply(TABLE) as supply:
        yield supply


@pytest.fixture
def machine(supply: Supply) -> Iterator[Machine]:
    with supply.machine() as machine:
        yield machine


def creased_blank() -> bytes:
    """Return a program that creases a fold, then mills the blank around it."""
    blank = closed((100.0, 100.0), (220.0, 100.0), (220.0, 180.0), (100.0, 180.0))
    fold = edges(((160.0, 100.0), (160.0, 180.0)))
    line = dieline((LineType.CUT, blank), (LineType.CREASE, fold))
    work = plan(line, TABLE, BOARD)
    toolpath = sequence([compensate(operation) for operation in work], TABLE)
    return process(toolpath, TABLE, "linuxcnc").text


PROGRAM = creased_blank()
LINES = PROGRAM.count(b"\n")


#: End of the travel of X in the INI file (mm).
HIGHEST_X = TABLE.x.high + max(station.x for station in TABLE.stations)


@asynccontextmanager
async def driver(machine: Machine, options: str = "") -> AsyncIterator[Linuxcnc]:
    """Connect the driver to LinuxCNC."""
    controller = await dial(f"linuxcnc://{machine.address}/{options}", SAFE)
    try:
        yield controller
    finally:
        await controller.close()


def run(
    controller: Linuxcnc, text: bytes = PROGRAM, tools: Mapping[int, Pose] | None = None
) -> aclosing[AsyncGenerator[Progress, None]]:
    """Run a program with the tool table of the machine file; leaving the context aborts it."""
    offsets = tool_offsets(TABLE) if tools is None else tools
    return aclosing(stream(text, controller, limits=Limits.from_machine(TABLE), tools=offsets))


async def run_to_end(
    controller: Linuxcnc, text: bytes = PROGRAM, tools: Mapping[int, Pose] | None = None
) -> list[Progress]:
    async with run(controller, text, tools) as updates:
        return [progress async for progress in updates]


async def run_until_milling(updates: AsyncGenerator[Progress, None], machine: Machine) -> None:
    """Run a program until it mills, slowed down, so that it mills on for a while."""
    slow = False
    async for progress in updates:
        if not slow and progress.output == ROUTER:
            machine.override_feed(20)
            slow = True
        elif is_milling(progress):
            return
    raise AssertionError("the program ended without milling")


def is_milling(progress: Progress) -> bool:
    return progress.output == ROUTER and progress.position[2] < 0.0


def assert_safe(machine: Machine) -> None:
    assert machine.position()[2] >= TABLE.travel_z - 1e-3
    assert machine.lowered() == []
    assert not machine.spins()


# -- the driver -----------------------------------------------------------------------------------


async def test_the_feed_override_is_set_while_a_program_runs(machine: Machine) -> None:
    async with driver(machine) as controller:
        assert (await controller.status()).override == 100
        async with run(controller) as updates:
            async for progress in updates:
                if is_milling(progress):
                    break
            await controller.override_feed(30)
            assert (await controller.status()).override == 30
            await controller.override_feed(130)
            assert (await controller.status()).override == 130
        await controller.override_feed(100)
        assert (await controller.status()).override == 100


async def test_a_program_runs_to_its_end_and_every_line_is_followed(machine: Machine) -> None:
    async with driver(machine) as controller:
        seen = await run_to_end(controller)
    executed = [progress.executed for progress in seen]
    assert executed == sorted(executed)
    assert len(set(executed)) > 12
    assert executed[-1] == LINES
    assert {progress.output for progress in seen} >= {-1, WHEEL, ROUTER}
    # The executed lines belong to the position: only milling and creasing are below the sheet.
    assert all(seen.output in (WHEEL, ROUTER) for seen in seen if seen.position[2] < 0.0)
    np.testing.assert_allclose(machine.position(), seen[-1].position, atol=1e-3)
    assert machine.lowered() == []
    assert not machine.spins()


async def test_a_hold_stops_and_a_step_and_resume_continue(machine: Machine) -> None:
    async with driver(machine) as controller, run(controller) as updates:
        await run_until_milling(updates, machine)
        await controller.hold()
        await wait_until_still(controller, State.HOLD)
        assert await asyncio.to_thread(machine.comes_to_rest)
        before = machine.position()
        assert machine.lowered() == [ROUTER]
        machine.override_feed(100)
        # The first step ends the line in which the machine was held, the second one a whole line.
        for _ in range(2):
            await step(controller)
        assert np.abs(machine.position() - before).max() > 1.0
        await controller.resume()
        executed = [progress.executed async for progress in updates]
        assert executed[-1] == LINES
    assert machine.lowered() == []


async def test_an_abort_lifts_the_tool_and_raises_the_stations(machine: Machine) -> None:
    async with driver(machine) as controller:
        async with run(controller) as updates:
            await run_until_milling(updates, machine)
            assert machine.lowered() == [ROUTER]
            assert machine.spins()
        assert_safe(machine)
        assert controller.fault is None
        assert (await controller.status()).state is State.IDLE


async def test_a_machine_that_still_runs_is_taken_over_only_on_request(machine: Machine) -> None:
    first = await dial(machine.address, SAFE)
    running = asyncio.create_task(first.run(PROGRAM))
    await asyncio.to_thread(wait_until, lambda: machine.position()[2] < 0.0)
    # Like a gateway that was killed: it sends nothing more.
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)
    await first.close()
    busy = await dial(machine.address, SAFE)
    assert busy.fault is not None
    assert busy.fault.message.code == "controller.busy"
    assert machine.lowered() == [ROUTER]
    await busy.close()
    second = await dial(machine.address, SAFE, stop_motion=True)
    assert_safe(machine)
    await second.close()


async def test_a_remote_shell_that_hangs_is_noticed_and_the_machine_stopped(
    machine: Machine,
) -> None:
    controller = await dial(machine.address, SAFE, silence=0.8)
    async with run(controller) as updates:
        await run_until_milling(updates, machine)
        machine.stop_shell()
        asyncio.get_running_loop().call_later(2.0, machine.continue_shell)
        with pytest.raises(ControllerSilent) as silent:
            [progress async for progress in updates]
    assert "was lifted" in silent.value.text
    assert_safe(machine)
    await controller.close()


async def test_a_remote_shell_that_ends_is_noticed_and_the_unknown_state_reported(
    machine: Machine,
) -> None:
    controller = await dial(machine.address, SAFE, silence=0.8)
    async with run(controller) as updates:
        await run_until_milling(updates, machine)
        machine.kill_shell()
        with pytest.raises(ControllerError) as lost:
            [progress async for progress in updates]
    assert "connection to LinuxCNC" in lost.value.text
    assert "No controller responds" in lost.value.text
    assert controller.fault is not None
    await controller.close()


async def test_an_emergency_stop_ends_the_job_and_unlock_raises_the_station(
    machine: Machine,
) -> None:
    async with driver(machine) as controller:
        async with run(controller) as updates:
            await run_until_milling(updates, machine)

            mark = machine.mark()
            machine.press_emergency_stop()
            with pytest.raises(ControllerAlarm) as stopped:
                [progress async for progress in updates]
        assert "emergency stop" in stopped.value.text
        assert "not raised" in stopped.value.text
        assert machine.lowered() == [ROUTER]  # LinuxCNC leaves outputs as they are
        assert controller.alarm is not None
        with pytest.raises(ControllerAlarm, match="emergency stop"):
            await controller.unlock()  # the button is still pressed
        assert machine.lowered() == [ROUTER]
    controller = await dial(machine.address, SAFE)
    assert isinstance(controller.fault, ControllerAlarm)
    machine.release_emergency_stop()
    await controller.unlock()
    assert (await controller.status()).state is State.IDLE
    assert_safe(machine)
    await controller.close()
    # HAL has raised the station at once, and unlock has not lowered it again.
    assert machine.comes_to_rest()
    valve = machine.samples(mark)[:, VALVE[ROUTER]]
    assert valve[0] == 1.0
    assert valve[-1] == 0.0
    assert (np.diff(valve) <= 0.0).all()


async def test_a_tool_table_that_differs_from_the_machine_file_stops_the_job(
    machine: Machine,
) -> None:
    wrong = {**tool_offsets(TABLE), 2: (60.0, 3.0, -1.5, 0.0)}
    async with driver(machine) as controller:
        with pytest.raises(ControllerError, match=r"away from the path"):
            await run_to_end(controller, tools=wrong)
        assert_safe(machine)


@pytest.mark.parametrize(
    ("line", "match"),
    [(b"T9 M6 G43", "tool 9"), (b"G1 X5 Q3", "Q word"), (b"G0 X9000", "limit")],
    ids=["unknown tool", "bad word", "beyond the travel"],
)
async def test_a_program_that_linuxcnc_refuses_moves_nothing(
    machine: Machine, line: bytes, match: str
) -> None:
    text = PROGRAM.replace(b"M5\n", b"M5\n" + line + b"\n", 1)
    async with driver(machine) as controller:
        before = machine.position()
        with pytest.raises(ControllerRejected, match=match):
            await run_to_end(controller, text)
        np.testing.assert_array_equal(machine.position(), before)
        assert_safe(machine)


@pytest.mark.parametrize(
    "beyond",
    # The second one is an arc over the end of X, between two ends within the travel.
    [b"G0 X9000\n", b"G0 X%.1f Y200\nG2 Y100 I0 J-50 F6000\n" % (HIGHEST_X - 20.0)],
    ids=["line", "arc"],
)
async def test_a_move_beyond_the_travel_at_the_end_of_a_program_is_found_before_it_starts(
    machine: Machine, beyond: bytes
) -> None:
    at = PROGRAM.rindex(b"M5\n")
    text = PROGRAM[:at] + beyond + PROGRAM[at:]
    async with driver(machine) as controller:
        before = machine.position()
        with pytest.raises(CheckRefused) as refused:
            await run_to_end(controller, text)
        message = refused.value.message
        assert message.code == "linuxcnc.beyond-travel"
        assert message.arguments["line"] == text[: at + len(beyond)].count(b"\n")
        assert (message.arguments["axis"], controller.sent) == ("X", 0)
        assert machine.is_still()
        np.testing.assert_array_equal(machine.position(), before)
        assert machine.lowered() == []


async def test_the_limits_of_linuxcnc_count_from_the_present_zero(machine: Machine) -> None:
    async with driver(machine) as controller:
        await controller.park()
        await wait_until_still(controller)
        await controller.jog("X", 500.0, 60000.0)
        await wait_until_still(controller)
        await controller.zero("X")
        await wait_until_still(controller)  # the reported position has changed
        try:
            travel = await controller.travel()
            assert travel is not None
            assert travel.offset == pytest.approx((500.0, 0.0, 0.0, 0.0), abs=1e-4)
            text = b"G21 G90 G54\nG0 X%.1f\nM30\n" % (HIGHEST_X - 499.0)
            with pytest.raises(CheckRefused, match="line 2 would move X"):
                await run_to_end(controller, text)
        finally:
            await controller.jog("X", -500.0, 60000.0)
            await wait_until_still(controller)
            await controller.zero("X")


async def test_a_program_that_linuxcnc_does_not_begin_counts_as_not_sent(
    machine: Machine,
) -> None:
    """The INI file is on another computer, so only LinuxCNC has the limits."""
    text = PROGRAM.replace(b"M5\n", b"M5\nG0 X9000\n", 1)
    folder = machine.directory
    async with driver(machine, f"?programs={folder}&remote={folder}") as controller:
        with pytest.raises(ControllerRejected, match="No program line was executed"):
            await run_to_end(controller, text)
        assert controller.sent == 0


async def test_a_folder_that_linuxcnc_does_not_see_is_reported(
    machine: Machine, tmp_path: Path
) -> None:
    async with driver(machine, f"?programs={tmp_path}&remote=/nowhere") as controller:
        with pytest.raises(ControllerError) as refused:
            await run_to_end(controller)
        assert "/nowhere/knifetip-" in refused.value.text
        assert "programs=" in refused.value.hint
    assert list(tmp_path.iterdir()) == []


async def test_the_pieces_of_a_jog_follow_each_other(machine: Machine) -> None:
    """The second piece is sent while the first one moves, and ends where both together end."""
    async with driver(machine) as controller:
        await controller.home()
        start = machine.position()
        await controller.jog("X", 50.0, 1200.0)
        await asyncio.to_thread(wait_until, lambda: machine.position()[0] > start[0] + 10.0)
        await controller.jog("X", 50.0, 1200.0)
        assert machine.position()[0] < start[0] + 50.0
        await asyncio.to_thread(wait_until, lambda: machine.position()[0] > start[0] + 60.0)
        await wait_until_still(controller)
        np.testing.assert_allclose(machine.position() - start, [100.0, 0.0, 0.0, 0.0], atol=1e-4)


async def test_a_person_can_home_jog_zero_park_and_switch(machine: Machine) -> None:
    async with driver(machine) as controller:
        await controller.home()
        start = machine.position()
        await controller.jog("X", 12.5, 6000.0)
        await wait_until_still(controller)
        np.testing.assert_allclose(machine.position() - start, [12.5, 0.0, 0.0, 0.0], atol=1e-4)
        with pytest.raises(ControllerRejected, match="limit"):
            await controller.jog("X", 5000.0, 6000.0)
        await controller.jog("X", 500.0, 6000.0)
        await asyncio.to_thread(wait_until, lambda: machine.position()[0] > start[0] + 30.0)
        await controller.stop_jog()
        await wait_until_still(controller)
        assert machine.position()[0] < start[0] + 400.0
        await controller.zero("XY")
        assert (await controller.status()).position[:2] == (0.0, 0.0)
        x, y = machine.position()[:2]
        await controller._connection.execute(["G10 L2 P1 X0 Y0"])
        assert (await controller.status()).position[:2] == pytest.approx((x, y), abs=1e-4)
        await controller.switch(WHEEL, True)
        assert machine.lowered() == [WHEEL]
        assert controller.switched_on == {WHEEL}
        await controller.park()
        await wait_until_still(controller)
        assert_safe(machine)
        np.testing.assert_allclose(machine.position()[:2], SAFE.park, atol=1e-3)


async def step(controller: Linuxcnc) -> None:
    """Execute one line and wait for its end."""
    before = await controller.status()
    await controller.step()
    async with asyncio.timeout(120.0):
        while (await controller.status()).position == before.position:
            pass
    await wait_until_still(controller, State.HOLD)


async def wait_until_still(controller: Linuxcnc, state: State = State.IDLE) -> None:
    async with asyncio.timeout(120.0):
        while (status := await controller.status()).state is not state or not status.still:
            pass
