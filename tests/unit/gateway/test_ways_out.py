"""The way out of every state of a controller, with and without a job.

``tests/support/controller_states.json`` is the table of states; the tests of the page read it too.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import aclosing, asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from knifetip.contract.operations import Operation, OperationName
from knifetip.contract.station_report import StationReport
from knifetip.errors import ControllerAlarm, ControllerError
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.grbl.driver import Grbl
from knifetip.gateway.job_run import JobRun, Lease
from knifetip.gateway.journal import Journal
from knifetip.gateway.linuxcnc.driver import dial
from knifetip.gateway.machine_link import MachineLink
from knifetip.gateway.operations import OperableController, perform, require_possible
from knifetip.gateway.station import MachineStation
from knifetip.gateway.stream import stream
from knifetip.library import load
from knifetip.messages import hint
from tests.support.controller_states import STATES, ControllerState
from tests.unit.gateway.test_grbl import Wire
from tests.unit.gateway.test_linuxcnc import Shell, served

MACHINE = load.machine("demo-table")
SAFE = SafeState((), 20.0)
#: Operations that free a controller.
WAYS = (OperationName.UNLOCK, OperationName.HOME, OperationName.RELEASE)
SITUATIONS = ("no job", "job waits for its confirmation", "in a cut", "between two copies")
PROGRAM = b"G21 G90\nG1 X10 F600\nG1 X20\nM30\n"
CELLS = [(one, situation) for one in STATES for situation in SITUATIONS]


class Controller(Wire):
    """A scripted grbl that a reset, ``$X`` and ``$H`` bring to rest, as far as each one can."""

    def enter(self, state: ControllerState) -> None:
        head, _, fields = str(state.report).partition("|")
        self.state = head
        self.position = f"0,0,20,0|{fields}".rstrip("|")
        if state.alarm:
            self.say(f"ALARM:{state.alarm}")

    async def write(self, data: bytes) -> None:
        if data == b"!":
            return  # what is held, asleep or locked stays so
        if data == b"\x18" and self.state != "Alarm":
            self.state = "Idle"
        if data in (b"$X\n", b"$H\n"):
            self.state = "Idle"
            self.position = "0,0,20,0"
        await super().write(data)


class Cnc(Shell):
    """A fake LinuxCNC that its commands bring to rest, as far as each one can."""

    def reply(self, line: str) -> str:
        reply = super().reply(line)
        match line.removeprefix("set "):
            case "estop off":
                self.values["estop"] = "OFF"
            case "machine on":
                self.values["machine"] = "ON"
            case "home -1":
                self.values["joint_homed"] = "YES YES YES YES"
            case "abort":
                self.values["program_status"] = "IDLE"
        return reply


@asynccontextmanager
async def connected(state: ControllerState) -> AsyncIterator[OperableController]:
    """Yield a controller whose last report has a state."""
    if not isinstance(state.report, str):
        shell = Cnc()
        shell.values |= {"rel_act_pos": "0 0 20 0 0 0", **state.report}
        async with served(shell) as address:
            cnc = await dial(address, SAFE, silence=0.5, poll=0.01)
            try:
                yield cnc
            finally:
                await cnc.close()
        return
    wire = Controller()
    wire.position = "0,0,20,0"
    controller = Grbl(wire, safe=SAFE, silence=1.0, poll=0.01)
    try:
        await controller.open()
        wire.enter(state)
        with suppress(ControllerAlarm):
            await controller.status()
        yield controller
    finally:
        await controller.close()


def run_in(situation: str) -> JobRun | None:
    if situation == "no job":
        return None
    confirm = situation == "job waits for its confirmation"
    run = JobRun(Lease("j", 1, 30.0, "/p", "0" * 64, 2, confirm), 0.0)
    run.between_copies = situation == "between two copies"
    return run


async def report_of(controller: OperableController, situation: str) -> StationReport:
    """Return what the station reports of a controller in a situation."""

    async def connect(safe: SafeState, stop_motion: bool) -> Any:
        del safe, stop_motion
        return controller

    link = MachineLink(SAFE, connect)
    with suppress(ControllerError):
        await link.connected()
    link.run = run_in(situation)
    server: Any = None
    return MachineStation(link, server, MACHINE, Journal(None)).report()


@pytest.mark.parametrize(("state", "situation"), CELLS, ids=lambda one: str(one))
async def test_the_report_names_the_state_and_what_to_do(
    state: ControllerState, situation: str
) -> None:
    wanted = state.free
    if situation == "in a cut":
        # A job that the state ends is not on the machine any more.
        wanted, situation = state.cut, "no job" if state.ends_cut else situation
    async with connected(state) as controller:
        report = await report_of(controller, situation)
    assert report.connected
    assert report.state == state.state
    said = report.alarm or report.obstacle
    assert ("" if said is None else said.code) == wanted.code
    assert said is None or hint(said)


@pytest.mark.parametrize("state", STATES, ids=str)
async def test_exactly_the_operations_of_the_table_lead_out(state: ControllerState) -> None:
    async with connected(state) as controller:
        for name in WAYS:
            possible = True
            try:
                await require_possible(Operation(name), controller, MACHINE)
            except ControllerError:
                possible = False
            # Homing also begins at rest.  Of two ways out of an alarm the page names the one that
            # its cause needs, the controller refuses the other.
            if name not in state.free.ways and state.state in ("idle", "alarm"):
                continue
            assert possible is (name in state.free.ways), name


@pytest.mark.parametrize(
    ("state", "way"), [(state, way) for state in STATES for way in state.free.ways], ids=str
)
async def test_the_operation_brings_the_controller_to_rest(
    state: ControllerState, way: str
) -> None:
    async with asyncio.timeout(120.0), connected(state) as controller:
        await perform(Operation(OperationName(way)), controller, MACHINE, lambda: False)
        assert controller.alarm is None
        assert (await controller.status()).state is State.IDLE
        after = await report_of(controller, "no job")
        assert (after.alarm, after.obstacle) == (None, None)


@pytest.mark.parametrize(
    "state", [one for one in STATES if one.controller == "grbl" and one.state != "idle"], ids=str
)
async def test_a_job_in_a_cut_is_held_or_ends(state: ControllerState) -> None:
    """It is never shown as running while the controller executes nothing of it."""
    wire = Controller()
    wire.position = "0,0,20,0"
    controller = Grbl(wire, safe=SAFE, silence=1.0, poll=0.01)
    held = failed = False
    try:
        await controller.open()
        async with (
            asyncio.timeout(120.0),
            aclosing(stream(PROGRAM, controller, check=False, interval=0.01)) as updates,
        ):
            wire.obliging = False
            try:
                async for progress in updates:
                    if controller.sent and wire.state == "Idle":
                        wire.enter(state)
                        wire.obliging = True  # what brings it into its safe state is answered
                    if held := progress.held:
                        break
            except ControllerError:
                failed = True
    finally:
        await controller.close()
    assert (held, failed) == (not state.ends_cut, state.ends_cut)


def test_the_table_has_every_state_of_a_controller_that_lasts() -> None:
    moving = {State.RUN, State.JOG, State.HOME, State.BUSY}  # they end by themselves
    shown = {State(one.state) for one in STATES} | {State.DOOR}
    assert shown == set(State) - moving


def test_the_table_of_states_is_where_the_page_reads_it() -> None:
    root = Path(__file__).parents[3]
    page = (root / "frontend/src/state/station/wayOut.test.ts").read_text()
    assert "tests/support/controller_states.json" in page
