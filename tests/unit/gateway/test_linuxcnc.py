"""The conversation with LinuxCNC's remote shell, against a fake shell."""

from __future__ import annotations

import asyncio
import gc
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from knifetip.errors import (
    CheckRefused,
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerSilent,
)
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.interpreter import Interpreter, LineRefused
from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.linuxcnc.connection import RunningProgram
from knifetip.gateway.linuxcnc.driver import Linuxcnc, dial
from knifetip.gateway.stream import stream
from knifetip.library import load

SAFE = SafeState((0, 2), 20.0)


class Shell:
    """A fake linuxcncrsh with an idle machine that executes Z moves at once."""

    def __init__(self) -> None:
        self.values = {
            "estop": "OFF",
            "machine": "ON",
            "joint_homed": "YES YES YES YES NO NO",
            "program_status": "IDLE",
            "program_line": "0",
            "rel_act_pos": "1.0 2.0 -0.3 0.0 0.0 45.0",
            "error": "OK",
            "mode": "MANUAL",
            "optional_stop": "0",
            "feed_override": "100",
        }
        self.commands: list[str] = []
        self.deaf = False
        self.keeps_feed = False  # the feed override is not changed
        self.stops_after = ""  # an emergency stop follows the next request for this variable
        self.server: asyncio.Server | None = None

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while line := (await reader.readline()).decode().strip():
            if not self.deaf:
                writer.write(f"{self.reply(line)}\r\n".encode())
        writer.close()

    def reply(self, line: str) -> str:
        kind, _, rest = line.partition(" ")
        if kind == "hello":
            return "HELLO ACK EMCNETSVR 1.1" if rest.startswith("EMC ") else "HELLO NAK"
        if kind == "get":
            reply = f"{rest.upper()} {self.values[rest]}"
            if rest == self.stops_after:
                self.values |= {"estop": "ON", "machine": "OFF"}
            return reply
        self.commands.append(rest)
        name = rest.split()[0]
        if name == "feed_override" and not self.keeps_feed:
            self.values[name] = rest.split()[1]
        if name == "echo":
            return line
        if name == "mdi" and " Z" in rest:
            self.values["rel_act_pos"] = "1.0 2.0 20.0 0.0 0.0 45.0"
        # The line end in front is like that of LinuxCNC after some of its messages.
        return f"\r\nSET {name.upper()} ACK"


@asynccontextmanager
async def served(shell: Shell) -> AsyncIterator[str]:
    server = await asyncio.start_server(shell.serve, "127.0.0.1", 0)
    try:
        yield f"127.0.0.1:{server.sockets[0].getsockname()[1]}"
    finally:
        server.close()


@asynccontextmanager
async def dialled(
    shell: Shell, safe: SafeState = SAFE, silence: float = 0.3
) -> AsyncIterator[Linuxcnc]:
    async with served(shell) as address:
        controller = await dial(address, safe, silence=silence, poll=0.01)
        try:
            yield controller
        finally:
            await controller.close()


async def test_opening_lifts_the_tool_and_switches_every_output_off() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        # The lift counts as a move until a later report has the same position.
        while (status := await controller.status()).state is State.JOG:
            await asyncio.sleep(0.01)
    assert status.state is State.IDLE
    assert status.position == (1.0, 2.0, 20.0, 45.0)
    lines = [command for command in shell.commands if command.startswith("mdi")]
    assert lines[1:] == ["mdi G1 Z20.0000 F6000", "mdi M5", "mdi M65 P0", "mdi M65 P2"]


@pytest.mark.parametrize(
    ("variable", "value", "code"),
    [
        ("estop", "ON", "linuxcnc.estop"),
        ("machine", "OFF", "linuxcnc.machine-off"),
        ("joint_homed", "YES NO YES YES", "linuxcnc.not-homed"),
    ],
)
async def test_a_machine_that_is_not_ready_is_left_as_it_is(
    variable: str, value: str, code: str
) -> None:
    shell = Shell()
    shell.values[variable] = value
    async with dialled(shell) as controller:
        assert isinstance(controller.fault, ControllerAlarm)
        assert controller.fault.message.code == code
        assert controller.fault.hint
        assert controller.alarm == controller.fault.message
    # It is neither switched on nor homed nor moved.
    allowed = {"echo", "verbose", "enable", "set_wait"}
    assert {command.split()[0] for command in shell.commands} <= allowed


@pytest.mark.parametrize("variable", ["program_status", "machine", "estop", "joint_homed"])
async def test_an_emergency_stop_between_two_requests_is_not_taken_for_a_switch(
    variable: str,
) -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.stops_after = variable
        with pytest.raises(ControllerAlarm) as stopped:
            [await controller.status() for _ in range(2)]
        assert stopped.value.message.code == "linuxcnc.estop"


async def test_homing_is_refused_while_the_machine_is_off() -> None:
    shell = Shell()
    shell.values |= {"machine": "OFF", "joint_homed": "NO NO NO NO"}
    async with dialled(shell) as controller:
        with pytest.raises(ControllerAlarm, match="switched off"):
            await controller.home()
    assert "home -1" not in shell.commands


async def test_unlock_switches_the_machine_on_then_lifts_and_releases() -> None:
    shell = Shell()
    shell.values["machine"] = "OFF"
    async with dialled(shell) as controller:
        with pytest.raises(ControllerAlarm):
            await controller.unlock()  # the button is still pressed
        shell.values["machine"] = "ON"
        await controller.unlock()
        assert controller.fault is None
    assert shell.commands.index("machine on") < shell.commands.index("mdi M65 P0")


async def test_a_busy_machine_is_left_as_it_is() -> None:
    shell = Shell()
    shell.values["program_status"] = "RUNNING"
    async with dialled(shell) as controller:
        assert isinstance(controller.fault, ControllerOccupied)
        with pytest.raises(ControllerOccupied, match="busy"):
            await controller.status()
    assert "abort" not in shell.commands


async def test_silence_is_a_fault_soon() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.deaf = True
        with pytest.raises(ControllerSilent):
            await asyncio.wait_for(controller.status(), 1.0)
        with pytest.raises(ControllerSilent):
            await controller.status()
        shell.deaf = False
        await controller.stop()
        assert controller.fault is None


async def test_a_gateway_that_is_held_up_itself_does_not_take_linuxcnc_for_silent() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        asking = asyncio.create_task(controller.status())
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        time.sleep(0.5)  # longer than the limit of silence; nothing is read meanwhile
        assert (await asking).position[0] == 1.0


async def test_all_who_wait_for_a_reply_learn_that_there_was_silence() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.deaf = True
        shell_of = controller._connection.shell
        both = await asyncio.gather(
            shell_of.get("mode"), shell_of.get("mode"), return_exceptions=True
        )
        assert [type(error) for error in both] == [ControllerSilent] * 2


class Counter:
    """An observer that counts the reports it gets, and finds nothing wrong."""

    doubtful = True

    def __init__(self) -> None:
        self.count = 0

    def observe(self, status: Status) -> None:
        self.count += 1


async def test_a_position_that_has_not_changed_is_soon_no_second_evidence() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.values |= {"program_status": "RUNNING", "mode": "AUTO"}
        controller._connection.program = RunningProgram(0, 9)
        controller.observer = observer = Counter()
        for _ in range(3):
            await controller.status()
        assert observer.count == 1
        shell.values["rel_act_pos"] = "1.5 2.0 -0.3 0.0 0.0 45.0"
        await controller.status()
        assert observer.count == 2
        # A machine at rest at the wrong position is still detected.
        async with asyncio.timeout(60.0):
            while observer.count == 2:
                await controller.status()


@pytest.mark.parametrize("reply", ["1.0 2.0 20", "1.0 2.0 20.0 0.0 0.0 4x", ""])
async def test_a_garbled_position_is_a_fault(reply: str) -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.values["rel_act_pos"] = reply
        with pytest.raises(ControllerError) as raised:
            await controller.status()
        assert raised.value.message.code == "linuxcnc.unreadable"
        assert controller.fault is raised.value


async def test_a_cancelled_request_does_not_shift_the_replies() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        for _ in range(20):
            asking = asyncio.create_task(controller.status())
            await asyncio.sleep(0)
            asking.cancel()
        assert (await controller.status()).position[0] == 1.0


async def test_a_request_whose_caller_was_cancelled_logs_no_error(
    caplog: pytest.LogCaptureFixture,
) -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.deaf = True
        asking = asyncio.create_task(controller.status())
        await asyncio.sleep(0.05)
        asking.cancel()
        await asyncio.gather(asking, return_exceptions=True)
    await asyncio.sleep(0.05)
    gc.collect()
    assert caplog.text == ""


async def test_a_wrong_password_is_reported() -> None:
    async with served(Shell()) as address:
        with pytest.raises(ControllerError, match="password"):
            await dial(f"linuxcnc://{address}/?password=OTHER", SAFE, silence=0.3)


def test_the_options_of_an_address_are_read() -> None:
    assert LinuxcncAddress.parse("table").name == "table:5007"
    address = LinuxcncAddress.parse("linuxcnc://table:5008/?programs=/here&remote=/there&joints=5")
    assert (address.name, address.programs, address.remote) == ("table:5008", "/here", "/there")
    assert address.joints == 5


@pytest.mark.parametrize(
    "address",
    [
        "",
        "http://table:5007",
        "linuxcnc://table:port",
        "linuxcnc://table/?joints=many",
        "linuxcnc://table/?joints=0",
        "linuxcnc://table/?programme=/here",
        "linuxcnc://table/?programs=/a%20folder",
    ],
)
def test_a_bad_address_is_refused(address: str) -> None:
    with pytest.raises(ControllerError, match="not a valid address of LinuxCNC"):
        LinuxcncAddress.parse(address)


async def test_a_folder_that_cannot_be_written_is_reported(tmp_path: Path) -> None:
    async with served(Shell()) as address:
        missing = tmp_path / "missing"
        controller = await dial(f"linuxcnc://{address}/?programs={missing}", SAFE, silence=0.3)
        with pytest.raises(ControllerError, match="cannot be written to the folder"):
            await controller.check([b"M2"])
        await controller.close()


def test_a_line_of_the_last_program_is_not_taken_for_the_present_one() -> None:
    program = RunningProgram(0, 50)
    seen = []
    for line in (46, 46, 2, 4, 4, 46, 60):
        program.update(line)
        seen.append(program.line)
    assert seen == [0, 0, 2, 4, 4, 46, 50]


def test_the_offset_of_the_tool_is_added_from_g43_to_g49() -> None:
    interpreter = Interpreter(tools={2: (60.0, 0.0, -1.5, 10.0)})
    ends = []
    for line in (b"G0 X5 Z20", b"T2 M6 G43", b"G64 P0.005 Q0.005", b"G0 X100", b"G0 C5", b"G49"):
        if (move := interpreter.read(line).move) is not None:
            ends.append(move.end)
    interpreter.read(b"G0 X1")
    assert ends == [(5.0, 0.0, 20.0, 0.0), (160.0, 0.0, 20.0, 0.0), (160.0, 0.0, 20.0, 15.0)]
    assert interpreter.position == (1.0, 0.0, 20.0, 15.0)


def test_a_tool_without_offset_is_refused_and_grblhal_has_no_tools() -> None:
    with pytest.raises(LineRefused):
        Interpreter(tools={2: (0.0, 0.0, 0.0, 0.0)}).read(b"T3 M6 G43")
    with pytest.raises(LineRefused):
        Interpreter().read(b"T2 M6 G43")


async def test_a_piece_of_a_jog_begins_where_the_piece_before_it_ends() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        shell.values |= {"mode": "MDI", "rel_act_pos": "1.0 2.0 20.0 0.0 0.0 45.0"}
        shell.commands.clear()
        await controller.jog("X", 5.0, 600.0)
        shell.values |= {"program_status": "RUNNING", "rel_act_pos": "3.0 2.0 20.0 0.0 0.0 45.0"}
        await controller.jog("X", 5.0, 600.0)
        await controller.jog("Y", 5.0, 600.0)
        shell.values["program_status"] = "IDLE"
        await controller.stop_jog()
        await controller.jog("X", 5.0, 600.0)
    moves = [command for command in shell.commands if command.startswith("mdi G1")]
    assert moves == [
        "mdi G1 X6.0000 F600",
        "mdi G1 X11.0000 F600",
        "mdi G1 Y7.0000 F600",
        "mdi G1 X8.0000 F600",
    ]


class Limited(Shell):
    """A fake shell that refuses moves to more than 1000 mm, and is in motion after each other move.

    Like LinuxCNC, it passes on one message about a refused move in each later cycle.
    """

    def __init__(self) -> None:
        super().__init__()
        self.late: list[str] = []  # messages that were not passed on yet

    def reply(self, line: str) -> str:
        if line.startswith("set ") and self.late:
            self.values["error"] = self.late.pop(0)
        answer = super().reply(line)
        if line.startswith("set mdi G1 X"):
            if float(line.split()[3][1:]) > 1000.0:
                self.late = ["X's positive limit", "joint 0's positive limit", "invalid params"]
            else:
                self.values["program_status"] = "RUNNING"
        elif line == "get error":
            self.values["error"] = "OK"
        return answer


async def test_a_jog_after_a_refused_one_begins_at_the_reported_position() -> None:
    shell = Limited()
    # A position that changes while the controller is watched counts as a move.
    shell.values["rel_act_pos"] = "1.0 2.0 20.0 0.0 0.0 45.0"
    async with dialled(shell) as controller:
        shell.values["mode"] = "MDI"
        with pytest.raises(ControllerRejected) as refused:
            await controller.jog("X", 5000.0, 600.0)
        for text in ("X's positive limit", "joint 0's positive limit", "invalid params"):
            assert text in refused.value.text
        await controller.jog("X", 5.0, 600.0)
    assert shell.commands[-1] == "mdi G1 X6.0000 F600"


async def test_the_feed_override_is_set_and_reported() -> None:
    shell = Shell()
    async with dialled(shell) as controller:
        assert (await controller.status()).override == 100
        await controller.override_feed(70)
        assert "feed_override 70" in shell.commands
        assert (await controller.status()).override == 70
        shell.keeps_feed = True
        with pytest.raises(ControllerError, match=r"feed override of 70 % instead of 90 %"):
            await controller.override_feed(90)


class Stopping(Shell):
    """A LinuxCNC that another client stops in the second line of every program."""

    def __init__(self) -> None:
        super().__init__()
        self.values |= {"program": "", "joint_units": "MM MM MM DEGREE", "inifile": ""}
        self.values["rel_act_pos"] = "1.0 2.0 20.0 0.0 0.0 45.0"
        self._looks = 0

    def reply(self, line: str) -> str:
        if line.startswith("set open "):
            self.values["program"] = line.removeprefix("set open ")
        elif line == "set run":
            self.values |= {"program_status": "RUNNING", "mode": "AUTO"}
            self._looks = 0
        elif line == "get program_status" and self.values["program_status"] == "RUNNING":
            self._looks += 1
            if self._looks == 5:
                self.values |= {"program_line": "2", "rel_act_pos": "5.0 2.0 20.0 0.0 0.0 45.0"}
            elif self._looks == 30:
                self.values["program_status"] = "IDLE"
        return super().reply(line)


async def executed_lines(text: bytes, controller: Linuxcnc, seen: list[int]) -> None:
    async for progress in stream(text, controller, check=False, interval=0.01):
        seen.append(progress.executed)


async def test_a_program_that_another_client_stops_is_not_executed_to_its_end() -> None:
    text = b"G21 G90\nG1 X10 F600\nG1 X20\nG1 X30\n"
    async with dialled(Stopping()) as controller:
        for _ in range(2):  # the lines of the first program do not count for the second one
            seen: list[int] = []
            with pytest.raises(ControllerError, match=r"[01] of 4 .* Up to [34] more") as stopped:
                await executed_lines(text, controller, seen)
            assert "25.0 mm away" in stopped.value.text
            assert max(seen) < 2


class Refusing(Shell):
    """A LinuxCNC that reports an error as soon as it has begun a program."""

    def __init__(self, rest: str = "1.0 2.0 20.0 0.0 0.0 45.0", delay: float = 0.0) -> None:
        super().__init__()
        self.values |= {"program": "", "rel_act_pos": "1.0 2.0 20.0 0.0 0.0 45.0"}
        self._rest = rest  # position when it has stopped
        self._delay = delay  # time without an answer before the error (s)

    def reply(self, line: str) -> str:
        if line.startswith("set open "):
            self.values["program"] = line.removeprefix("set open ")
        elif line == "set run":
            self.values |= {"program_status": "RUNNING", "mode": "AUTO", "error": "Out of range."}
        elif line == "get error" and self.values["error"] != "OK":
            time.sleep(self._delay)
            self.values["rel_act_pos"] = self._rest
            error, self.values["error"] = self.values["error"], "OK"
            return f"ERROR {error}"
        elif line == "set abort":
            self.values["program_status"] = "IDLE"
        return Shell.reply(self, line)


@pytest.mark.parametrize(
    ("shell", "begun"),
    [
        (Refusing(), False),
        (Refusing(rest="1.0 2.1 20.0 0.0 0.0 45.0"), True),
        # The machine may have left its place and come back to it meanwhile.
        (Refusing(delay=0.7), True),
    ],
    ids=["at its place", "moved", "not watched"],
)
async def test_a_program_that_ends_at_its_start_before_its_first_line_was_not_begun(
    shell: Refusing, begun: bool
) -> None:
    text = b"G21 G90\nG1 X10 F600\nG1 X20\nG1 X30\n"
    async with dialled(shell, silence=3.0) as controller:
        before = controller.sent
        with pytest.raises(ControllerRejected, match=r"Out of range\.") as stopped:
            await executed_lines(text, controller, [])
        assert controller.sent - before == (4 if begun else 0)
        assert ("No program line was executed" in stopped.value.text) is not begun


INI = """[TRAJ]
COORDINATES = X Y Z C
[KINS]
KINEMATICS = trivkins coordinates=XYZC
[AXIS_X]
MIN_LIMIT = 0
MAX_LIMIT = 1000
[JOINT_0]
MIN_LIMIT = 0
MAX_LIMIT = 900
"""


@pytest.mark.parametrize(
    ("target", "limit"), [(b"X800.5", 900.0), (b"X-100.5", 0.0), (b"X799.5", None)]
)
async def test_a_program_beyond_the_travel_is_refused_before_it_starts(
    tmp_path: Path, target: bytes, limit: float | None
) -> None:
    shell = Stopping()
    ini = tmp_path / "machine.ini"
    ini.write_text(INI)
    # The zero of programs lies at X 100 of the machine.
    shell.values |= {"inifile": str(ini), "abs_act_pos": "101.0 2.0 20.0 0.0 0.0 45.0"}
    text = b"G21 G90\nG1 X10 F600\nG1 %b\nG1 X30\n" % target
    async with dialled(shell, SafeState.from_machine(load.machine("demo-table"))) as controller:
        with pytest.raises(ControllerError) as refused:
            await executed_lines(text, controller, [])
    if limit is None:
        assert "run" in shell.commands
        return
    assert isinstance(refused.value, CheckRefused)
    message = refused.value.message
    assert message.code == "linuxcnc.beyond-travel"
    assert (message.arguments["line"], message.arguments["axis"]) == (3, "X")
    assert message.arguments["limit"] == limit
    assert not any(command.startswith(("run", "open")) for command in shell.commands)
