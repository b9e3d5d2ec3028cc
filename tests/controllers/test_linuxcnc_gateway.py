"""Jobs of the service on a complete LinuxCNC, which the gateway runs through its remote shell.

    KNIFETIP_LINUXCNC_GATEWAY=1 pytest tests/controllers/test_linuxcnc_gateway.py

These tests do not run by default: linuxcncrsh 2.9 sometimes ends when a second client connects, as
the gateway and the test do here.
"""

from __future__ import annotations

import os
import time
from collections.abc import AsyncGenerator, AsyncIterator, Iterator, Mapping
from contextlib import aclosing, asynccontextmanager
from pathlib import Path

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.linuxcnc.driver import Linuxcnc, dial
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.stream import Progress, stream
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.post.rs274.tool_table import tool_table
from tests.controllers.linuxcnc_machine import Machine, missing_requirement, running
from tests.support.shapes import closed, dieline, edges

SKIP_REASON = missing_requirement()
if not SKIP_REASON and "KNIFETIP_LINUXCNC_GATEWAY" not in os.environ:
    SKIP_REASON = "linuxcncrsh may end with two clients (set KNIFETIP_LINUXCNC_GATEWAY=1 to try)"

pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]

TABLE = load.machine("router-table")
SAFE = SafeState.of(TABLE)
WHEEL, ROUTER = 1, 3  # outputs


@pytest.fixture(scope="module")
def machine() -> Iterator[Machine]:
    """Start LinuxCNC with the tool table of the router table; yield a connection to it."""
    with running(tool_table(TABLE)) as machine:
        yield machine


def creased_blank() -> bytes:
    """Return a program that creases a fold, then mills the blank around it."""
    blank = closed((100.0, 100.0), (300.0, 100.0), (300.0, 200.0), (100.0, 200.0))
    fold = edges(((200.0, 100.0), (200.0, 200.0)))
    line = dieline((LineType.CUT, blank), (LineType.CREASE, fold))
    work = plan(line, TABLE, load.board("greyboard-3.0"))
    toolpath = sequence([compensate(operation) for operation in work], TABLE)
    return process(toolpath, TABLE, "linuxcnc").text


PROGRAM = creased_blank()
LINES = PROGRAM.count(b"\n")


@asynccontextmanager
async def driver(machine: Machine, options: str = "") -> AsyncIterator[Linuxcnc]:
    """Connect the driver to LinuxCNC, and switch LinuxCNC on again afterwards."""
    controller = await dial(f"linuxcnc://{machine.address}/{options}", SAFE)
    try:
        yield controller
    finally:
        if controller.fault is not None:
            await controller.unlock()
        await controller.close()


def run(
    controller: Linuxcnc, text: bytes = PROGRAM, tools: Mapping[int, Pose] | None = None
) -> aclosing[AsyncGenerator[Progress, None]]:
    """Run a program with the tool table of the machine file; leaving the context aborts it."""
    offsets = tool_offsets(TABLE) if tools is None else tools
    return aclosing(stream(text, controller, limits=Limits.of(TABLE), tools=offsets))


async def run_to_end(
    controller: Linuxcnc, text: bytes = PROGRAM, tools: Mapping[int, Pose] | None = None
) -> list[Progress]:
    async with run(controller, text, tools) as updates:
        return [progress async for progress in updates]


async def run_until_milling(updates: AsyncGenerator[Progress, None]) -> None:
    async for progress in updates:
        if is_milling(progress):
            return
    raise AssertionError("the program ended without milling")


def is_milling(progress: Progress) -> bool:
    return progress.output == ROUTER and progress.position[2] < 0.0


def assert_safe(machine: Machine) -> None:
    assert machine.position()[2] >= TABLE.travel_z - 1e-3
    assert machine.lowered() == []
    assert not machine.spins()


# -- the driver -----------------------------------------------------------------------------------


async def test_a_program_runs_to_its_end_and_every_line_is_followed(machine: Machine) -> None:
    async with driver(machine) as controller:
        seen = await run_to_end(controller)
    executed = [progress.executed for progress in seen]
    assert executed == sorted(executed)
    assert len(set(executed)) > 20
    assert executed[-1] == LINES
    assert {progress.output for progress in seen} >= {-1, WHEEL, ROUTER}
    # The executed lines belong to the position: only milling and creasing are below the sheet.
    assert all(seen.output in (WHEEL, ROUTER) for seen in seen if seen.position[2] < 0.0)
    np.testing.assert_allclose(machine.position(), seen[-1].position, atol=1e-3)
    assert machine.lowered() == []
    assert not machine.spins()


async def test_a_hold_stops_and_a_step_and_resume_continue(machine: Machine) -> None:
    async with driver(machine) as controller, run(controller) as updates:
        await run_until_milling(updates)
        await controller.hold()
        await wait_until_still(controller, State.HOLD)
        before = machine.position()
        time.sleep(0.3)
        np.testing.assert_array_equal(machine.position(), before)
        assert machine.lowered() == [ROUTER]
        await controller.step()
        await wait_until_still(controller, State.HOLD)
        assert np.abs(machine.position() - before).max() > 1.0
        await controller.resume()
        executed = [progress.executed async for progress in updates]
        assert executed[-1] == LINES
    assert machine.lowered() == []


async def test_an_abort_lifts_the_tool_and_raises_the_stations(machine: Machine) -> None:
    async with driver(machine) as controller:
        async with run(controller) as updates:
            await run_until_milling(updates)
            assert machine.lowered() == [ROUTER]
            assert machine.spins()
        assert_safe(machine)
        assert controller.fault is None
        # The same connection can run the next program.
        assert (await run_to_end(controller))[-1].executed == LINES


async def test_a_machine_that_still_runs_is_taken_over_only_on_request(machine: Machine) -> None:
    first = await dial(machine.address, SAFE)
    updates = stream(PROGRAM, first, limits=Limits.of(TABLE), tools=tool_offsets(TABLE))
    await run_until_milling(updates)
    await first.close()  # like a gateway that was killed
    with pytest.raises(ControllerError, match="busy"):
        await dial(machine.address, SAFE)
    assert machine.lowered() == [ROUTER]
    second = await dial(machine.address, SAFE, stop_motion=True)
    assert_safe(machine)
    await second.close()
    with pytest.raises(ControllerError):
        await anext(updates)


async def test_an_emergency_stop_ends_the_job_and_unlock_raises_the_station(
    machine: Machine,
) -> None:
    async with driver(machine) as controller:
        async with run(controller) as updates:
            await run_until_milling(updates)
            machine.send("set enable EMCTOO")
            machine.send("set estop on")
            with pytest.raises(ControllerAlarm) as stopped:
                [progress async for progress in updates]
        assert "emergency stop" in stopped.value.text
        assert "not raised" in stopped.value.text
        assert machine.lowered() == [ROUTER]  # LinuxCNC leaves outputs as they are
        assert controller.alarm is not None
        locked = await dial(machine.address, SAFE)
        assert isinstance(locked.fault, ControllerAlarm)
        await locked.close()
        await controller.unlock()
        assert controller.fault is None
        assert_safe(machine)


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
    text = PROGRAM.replace(b"M2\n", line + b"\nM2\n")
    async with driver(machine) as controller:
        before = machine.position()
        with pytest.raises(ControllerRejected, match=match):
            await run_to_end(controller, text)
        if match != "limit":  # LinuxCNC checks travel only when it reaches the line
            np.testing.assert_array_equal(machine.position(), before)
        assert_safe(machine)


async def test_a_folder_that_linuxcnc_does_not_see_is_reported(
    machine: Machine, tmp_path: Path
) -> None:
    async with driver(machine, f"?programs={tmp_path}&remote=/nowhere") as controller:
        with pytest.raises(ControllerError) as refused:
            await run_to_end(controller)
        assert "/nowhere/knifetip-" in refused.value.text
        assert "programs=" in refused.value.hint
    assert list(tmp_path.iterdir()) == []


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
        time.sleep(0.3)
        await controller.stop_jog()
        await wait_until_still(controller)
        assert 20.0 < machine.position()[0] < 400.0
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


async def wait_until_still(controller: Linuxcnc, state: State = State.IDLE) -> None:
    deadline = time.monotonic() + 10.0
    while time.monotonic() < deadline:
        status = await controller.status()
        if status.state is state and status.still:
            return
    raise AssertionError(f"still {status.state}")
