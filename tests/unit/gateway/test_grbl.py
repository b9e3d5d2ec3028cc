"""The grbl protocol of the sender, tested with a scripted controller."""

from __future__ import annotations

import asyncio
import re
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager

import pytest

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
    ProgramError,
)
from knifetip.gateway.controller import SafeState, State
from knifetip.gateway.grbl.driver import Grbl
from knifetip.gateway.grbl.polling import Polling

BANNER = "Grbl 1.1h ['$' for help]"


class Wire:
    """A Transport to a scripted controller.

    ``answers`` maps lines to answers; other lines are answered with ``ok`` while ``obliging`` is
    true, and not at all otherwise.
    """

    address = "wire"

    def __init__(
        self,
        answers: dict[str, str] | None = None,
        *,
        state: str = "Idle",
        options: str = "[OPT:V,15,128]",
    ) -> None:
        self.answers = {"$I": f"{options}\nok", "$C": "ok"} | (answers or {})
        self.state = state
        self.position = "0,0,0,0"
        self.obliging = True
        self.mute = False
        self.lines: list[str] = []
        self.realtime = b""
        self.asked = 0
        self.most = 0
        self._due = 0
        self._out: asyncio.Queue[bytes] = asyncio.Queue()

    def say(self, text: str) -> None:
        self._out.put_nowait("".join(f"{line}\r\n" for line in text.split("\n")).encode())

    async def read(self) -> bytes:
        return await self._out.get()

    async def write(self, data: bytes) -> None:
        if data == b"\x18":
            self.realtime += data
            self.say(f"\n{BANNER}")
        elif data == b"?":
            self.asked += 1
            if not self.mute:
                self.say(f"<{self.state}|MPos:{self.position}|Bf:15,{128 - self._due}>")
        elif data in (b"!", b"~"):
            self.realtime += data
            if self.state != "Idle":
                self.state = "Hold:0" if data == b"!" else "Run"
        else:
            assert data.endswith(b"\n")
            self._due += len(data)
            self.most = max(self.most, self._due)
            line = data.decode().strip()
            self.lines.append(line)
            if line in self.answers:
                self.say(self.answers[line])
                self._due -= len(data)
            elif self.obliging:
                self.say("ok")
                self._due -= len(data)

    async def close(self) -> None:
        self._out.put_nowait(b"")


def fault_of(controller: Grbl) -> ControllerError | None:
    """Return the current fault of a controller, None if there is none."""
    return controller.fault


@asynccontextmanager
async def opened(
    wire: Wire,
    *,
    silence: float = 0.2,
    safe: SafeState | None = None,
    reconnect: Callable[[], Awaitable[Wire]] | None = None,
) -> AsyncIterator[Grbl]:
    controller = Grbl(wire, safe=safe, reconnect=reconnect, silence=silence, poll=0.02)
    try:
        await controller.open()
        yield controller
    finally:
        await controller.close()


async def test_opening_resets_a_controller_at_rest_and_asks_for_its_buffers() -> None:
    wire = Wire(options="[OPT:VNMSL,35,1024,4,0]")
    async with opened(wire) as controller:
        assert wire.realtime == b"\x18"
        assert wire.lines == ["$I"]
        assert controller.capacity == 35
        assert (await controller.status()).state is State.IDLE


@pytest.mark.parametrize(
    ("echo", "changed"),
    [
        ("[echo: G1X10Y20]", False),
        ("[echo: G1 X10 Y20 (cut)]", False),
        ("[echo: G1X10Y30]", True),
        ("[echo: G1X1", False),  # damaged in transit, so it is ignored
    ],
)
async def test_a_line_that_is_echoed_must_be_the_line_that_was_sent(
    echo: str, changed: bool
) -> None:
    wire = Wire({"g1 x10 y20 (cut)": f"{echo}\nok"})
    async with opened(wire) as controller:
        await controller.send(b"g1 x10 y20 (cut)", 7)
        if changed:
            with pytest.raises(ControllerError, match=r"'G1X10Y30' instead of program line 7"):
                await controller.drain()
        else:
            await controller.drain()
            assert controller.acknowledged == 1


@pytest.mark.parametrize(
    ("options", "polling"),
    [
        ("[OPT:VNMSL,35,1024,4,0]\n[FIRMWARE:grblHAL]", Polling(0.05, 0.01)),
        ("[OPT:V,15,128]", Polling(0.1, 0.02)),
    ],
)
async def test_the_firmware_decides_how_often_it_is_asked(options: str, polling: Polling) -> None:
    controller = Grbl(Wire(options=options), silence=2.0)
    try:
        await controller.open()
        assert controller.polling == polling
    finally:
        await controller.close()


async def test_answers_to_an_earlier_sender_do_not_disturb_the_opening() -> None:
    wire = Wire()
    wire.say("ok\nerror:2\n[MSG:stale]\nok")
    async with opened(wire) as controller:
        assert controller.fault is None
        wire.say("ok")
        await asyncio.sleep(0.05)
        assert "was sent twice" in str(fault_of(controller))


async def test_a_machine_at_rest_is_asked_rarely_until_a_line_is_sent() -> None:
    wire = Wire()
    async with opened(wire, silence=5.0) as controller:
        await asyncio.sleep(0.1)
        asked = wire.asked
        await asyncio.sleep(0.3)
        assert wire.asked - asked <= 1
        wire.obliging = False
        await controller.send(b"G1 X1", 1)
        await asyncio.sleep(0.3)
        assert wire.asked - asked >= 6


@pytest.mark.parametrize("state", ["Run", "Hold:0", "Jog", "Home", "Door:1"])
async def test_a_machine_that_is_busy_is_left_alone(state: str) -> None:
    wire = Wire(state=state)
    with pytest.raises(ControllerError, match="is busy"):
        async with opened(wire):
            pass
    assert wire.realtime == b""
    assert wire.lines == []


async def test_a_machine_in_alarm_is_not_unlocked_from_here() -> None:
    wire = Wire(state="Alarm")
    with pytest.raises(ControllerAlarm, match="locked") as alarm:
        async with opened(wire):
            pass
    assert "$H" in alarm.value.hint
    assert "$X" not in wire.lines


async def test_a_wire_without_a_controller_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    wire = Wire()
    wire.mute = True
    monkeypatch.setattr(wire, "say", lambda text: None)
    with pytest.raises(ControllerSilent):
        async with opened(wire, silence=0.05):
            pass


async def test_characters_in_flight_never_exceed_the_buffer() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.obliging = False
        wire.state = "Run"
        # 28 bytes and a newline: four fit into 127; one is kept free in case of a doubled answer.
        line = b"G1 X100.0000 Y200.0000 F1200"
        sending = [asyncio.create_task(controller.send(line, row)) for row in range(1, 11)]
        await asyncio.sleep(0.02)
        assert len(wire.lines) == 1 + 3
        for answered in range(10):
            wire._due -= 29
            wire.say("ok")
            async with asyncio.timeout(120.0):
                while len(wire.lines) < 1 + min(10, 4 + answered):
                    await asyncio.sleep(0)
            await asyncio.sleep(0.001)
            assert len(wire.lines) == 1 + min(10, 4 + answered)
        await asyncio.gather(*sending)
        await controller.drain()
        assert wire.most <= 127
        assert controller.acknowledged == 10


async def test_a_line_that_would_never_fit_is_refused_before_it_is_sent() -> None:
    async with opened(Wire()) as controller:
        with pytest.raises(ProgramError, match="Line 3 of the program has 127 bytes"):
            await controller.send(b"(" + b"x" * 126, 3)


@pytest.mark.parametrize("byte", [b"!", b"~", b"?", b"\x18", b"\x85", b"\n"])
async def test_bytes_that_a_controller_obeys_never_leave_in_a_line(byte: bytes) -> None:
    wire = Wire()
    async with opened(wire) as controller:
        with pytest.raises(ProgramError, match=re.escape(f"0x{byte.hex()}")):
            await controller.send(b"(cut here" + byte + b")", 1)
        assert wire.lines == ["$I"]


async def test_a_refused_line_is_named_with_its_number_text_and_reason() -> None:
    wire = Wire({"G1 X5": "error:22"})
    async with opened(wire) as controller:
        await controller.send(b"G21", 1)
        await controller.send(b"G1 X5", 2)
        with pytest.raises(ControllerRejected, match=r"line 2 \(G1 X5\): no feed.*error:22"):
            await controller.drain()


async def test_check_mode_names_the_first_wrong_line_and_leaves_no_fault(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wire = Wire({"G1 X5": "error:22", "G43": "error:20", "$C": "ok"})
    real = wire.write

    async def write(data: bytes) -> None:
        await real(data)
        if data == b"$C\n" and wire.lines.count("$C") == 2:
            wire.say(BANNER)

    monkeypatch.setattr(wire, "write", write)
    async with opened(wire) as controller:
        with pytest.raises(ControllerRejected, match=r"line 2 \(G1 X5\)") as refused:
            await controller.check([b"G21", b"G1 X5", b"G43"])
        assert "before anything moved" in refused.value.text
        assert controller.fault is None
        assert controller.acknowledged == 0
        assert (await controller.status()).state is State.IDLE


@pytest.mark.parametrize(
    "end", [f"[MSG:Disabled]\nok\n{BANNER}", f"[\n{BANNER}", BANNER], ids=["ok", "cut", "banner"]
)
async def test_the_banner_ends_the_check_also_if_the_reset_has_cleared_the_answer(
    monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    wire = Wire()
    real = wire.write

    async def write(data: bytes) -> None:
        await real(data)
        if data == b"$C\n":
            wire.answers["$C"] = end

    monkeypatch.setattr(wire, "write", write)
    async with opened(wire) as controller:
        await controller.check([b"G21", b"M30"])
        await controller.send(b"G21", 1)
        await controller.drain()
        assert controller.fault is None
        assert controller.acknowledged == 1
        assert wire.lines == ["$I", "$C", "G21", "M30", "$C", "G21"]


class SlowLine(Wire):
    """A controller that reads its line slowly, so that a request waits behind the lines before it.

    Each line is answered after ``pace`` seconds.  Requests that arrive while lines wait have one
    report, at the end.
    """

    pace = 0.1

    def __init__(self) -> None:
        super().__init__()
        self._waiting: list[bytes] = []
        self._reads: asyncio.Task[None] | None = None

    async def write(self, data: bytes) -> None:
        if self._reads is None and data not in (b"$C\n", b"G21\n"):
            await super().write(data)
            return
        self._waiting.append(data)
        if self._reads is None:
            self._reads = asyncio.create_task(self._read_slowly())

    async def _read_slowly(self) -> None:
        asked = False
        while self._waiting:
            data = self._waiting.pop(0)
            if data == b"?":
                asked = True
                continue
            await asyncio.sleep(self.pace)
            await super().write(data)
            if data == b"$C\n" and self.lines.count("$C") == 2:
                self.say(BANNER)
        self._reads = None
        if asked:
            await super().write(b"?")


class Discarding(Wire):
    """After the banner that ends a check, it discards all lines until a report is requested."""

    deaf = False

    async def write(self, data: bytes) -> None:
        if data == b"?":
            self.deaf = False
        elif self.deaf:
            return
        await super().write(data)
        if data == b"$C\n" and self.lines.count("$C") == 2:
            self.deaf = True
            self.say(BANNER)


async def test_a_program_begins_when_the_controller_answers_again_after_its_check() -> None:
    async with opened(Discarding()) as controller:
        await controller.check([b"G21", b"M30"])
        await controller.send(b"G21", 1)
        await controller.drain()
        assert controller.fault is None
        assert controller.acknowledged == 1


async def test_a_controller_that_answers_lines_of_the_check_slowly_is_not_silent() -> None:
    wire = SlowLine()
    async with opened(wire, silence=1.0) as controller:
        await controller.check([b"G21"] * 20)  # 2 s, in which it reports nothing
        assert controller.fault is None
        assert wire.lines.count("G21") == 20


async def test_an_old_report_in_the_check_is_no_lost_answer() -> None:
    wire = Wire()
    async with opened(wire, silence=20.0) as controller:
        lines = [b"G1 X%d" % number for number in range(5)]
        checking = asyncio.create_task(controller.check(lines))
        wire.obliging = False
        while wire.lines[-1:] != ["G1 X4"]:
            await asyncio.sleep(0.01)
        wire._due = 0  # as if none of the lines had been received
        before = wire.asked
        while wire.asked < before + 10:
            await asyncio.sleep(0.01)
        wire.answers["$C"] = BANNER
        for _ in lines:
            wire.say("ok")
        await checking
        assert controller.fault is None


async def test_a_controller_that_stops_in_the_check_is_silent() -> None:
    wire = Wire()
    async with opened(wire, silence=0.2) as controller:
        wire.mute, wire.obliging = True, False
        with pytest.raises(ControllerSilent, match="has not responded"):
            await controller.check([b"G21", b"G1 X5"])


async def test_outputs_are_not_switched_by_the_check(monkeypatch: pytest.MonkeyPatch) -> None:
    wire = Wire()
    real = wire.write

    async def write(data: bytes) -> None:
        await real(data)
        if data == b"$C\n" and wire.lines.count("$C") == 2:
            wire.say(BANNER)

    monkeypatch.setattr(wire, "write", write)
    async with opened(wire) as controller:
        await controller.check([b"G21", b"M64 P1", b"M65 P1", b"M30"])
        assert wire.lines == ["$I", "$C", "G21", "M30", "$C"]


async def test_a_lost_answer_while_idle_is_silence_that_names_the_line() -> None:
    wire = Wire({"G1 X5": "[MSG:lost]"})
    async with opened(wire, silence=0.1) as controller:
        await controller.send(b"G21", 1)
        await controller.send(b"G1 X5", 2)
        with pytest.raises(
            ControllerSilent,
            match=r"idle.*response of the controller was lost.*program line 2 \(G1 X5\)",
        ):
            await controller.drain()


async def test_an_answer_may_take_as_long_as_the_machine_runs_or_holds() -> None:
    wire = Wire({"G1 X5": "[MSG:later]"})
    async with opened(wire, silence=0.06) as controller:
        wire.state = "Run"
        await controller.send(b"G1 X5", 1)
        await asyncio.sleep(0.15)
        assert controller.fault is None
        wire.say("ok")
        await controller.drain()


async def test_a_dwell_may_take_its_seconds() -> None:
    wire = Wire({"G4 P0.2": "[MSG:later]"})
    async with opened(wire, silence=0.06) as controller:
        await controller.send(b"G4 P0.2", 1)
        await asyncio.sleep(0.15)
        assert controller.fault is None


async def test_no_report_at_all_is_silence() -> None:
    wire = Wire()
    async with opened(wire, silence=0.06) as controller:
        wire.mute = True
        wire.obliging = False
        await controller.send(b"G1 X5", 1)
        with pytest.raises(ControllerSilent, match="has not responded"):
            await controller.drain()


async def test_a_process_that_was_busy_does_not_call_the_controller_silent() -> None:
    wire = Wire()
    async with opened(wire, silence=0.06) as controller:
        wire.state = "Run"
        time.sleep(0.2)
        await asyncio.sleep(0.05)
        assert controller.fault is None


async def test_an_unexpected_banner_is_a_reset() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.obliging = False
        wire.state = "Run"
        await controller.send(b"G1 X5", 1)
        wire.say(BANNER)
        with pytest.raises(ControllerReset, match=r"was reset.* No response to program line 1"):
            await controller.drain()
        with pytest.raises(ControllerReset):
            await controller.send(b"G1 X6", 2)
        with pytest.raises(ControllerReset):
            await controller.resume()
        assert wire.lines == ["$I", "G1 X5"]


async def test_an_alarm_has_a_text() -> None:
    wire = Wire({"G1 X5000": "ALARM:2"})
    async with opened(wire) as controller:
        await controller.send(b"G1 X5000", 1)
        with pytest.raises(
            ControllerAlarm, match=r"ALARM:2: a move would have gone beyond the travel range"
        ):
            await controller.drain()


async def test_an_alarm_whose_words_were_lost_is_seen_in_the_state() -> None:
    wire = Wire({"G1 X5": "[MSG:lost]"})
    async with opened(wire) as controller:
        await controller.send(b"G1 X5", 1)
        wire.state = "Alarm"
        with pytest.raises(ControllerAlarm, match="reports an alarm"):
            await controller.drain()


async def test_an_answer_to_a_line_of_another_client_is_a_fault() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.say("ok")
        with pytest.raises(ControllerError, match="did not send"):
            await controller.status()


async def test_a_lost_connection_names_the_answer_that_was_due() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.obliging = False
        await controller.send(b"G1 X5", 1)
        await wire.close()
        with pytest.raises(
            ControllerError, match=r"is lost. No response to program line 1 \(G1 X5\)"
        ):
            await controller.drain()


async def test_noise_on_the_wire_is_passed_over() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.say("\x00\xff<Run|MPos:1,2")
        wire.say("x" * 20_000)
        wire.say("<Idle|MPos:a,b>")
        assert (await controller.status()).position == (0.0, 0.0, 0.0, 0.0)
        assert controller.fault is None


async def test_positions_are_in_the_numbers_of_the_program() -> None:
    wire = Wire()
    wire.position = "110,220,20,90"
    async with opened(wire) as controller:
        wire.say("<Idle|MPos:110,220,20,90|WCO:100,200,0,0>")
        assert (await controller.status()).position == (10.0, 20.0, 20.0, 90.0)
        # The offset is reported only occasionally, so the last one is kept.
        assert (await controller.status()).position == (10.0, 20.0, 20.0, 90.0)


RELEASE = ["M5", "M65 P0", "M65 P2"]


async def test_stopping_holds_resets_raises_the_tool_and_releases_the_stations(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wire = Wire()
    wire.position = "10,20,20,90"
    async with opened(wire, safe=SafeState((0, 2), 20.0)) as controller:
        assert wire.lines == ["$I", *RELEASE]
        wire.obliging = False
        wire.state, wire.position = "Run", "10,20,-0.3,90"
        await controller.send(b"G1 X5", 1)
        wire.obliging = True
        real = wire.write

        async def write(data: bytes) -> None:
            await real(data)
            if data == b"\x18":
                wire.state = "Idle"

        monkeypatch.setattr(wire, "write", write)
        await controller.stop()
        assert wire.realtime == b"\x18!\x18"
        assert wire.lines[-4:] == ["$J=G90 G21 Z20.0000 F6000", *RELEASE]


async def test_stopping_high_enough_does_not_lower_the_tool() -> None:
    wire = Wire()
    wire.position = "10,20,30,90"
    async with opened(wire, safe=SafeState((0, 2), 20.0)) as controller:
        await controller.stop()
        assert wire.lines == ["$I", *RELEASE, *RELEASE]


async def test_the_takeover_raises_a_tool_that_was_left_low_and_releases_the_stations() -> None:
    wire = Wire()
    wire.position = "10,20,-0.3,90"
    async with opened(wire, safe=SafeState((0, 2), 20.0)):
        assert wire.lines == ["$I", "$J=G90 G21 Z20.0000 F6000", *RELEASE]


async def test_an_output_that_the_controller_does_not_have_is_named_and_the_others_released() -> (
    None
):
    wire = Wire({"M65 P0": "error:39"})
    wire.position = "10,20,30,90"
    with pytest.raises(
        ControllerRejected, match=r"rejected the command M65 P0: a value is out of range"
    ):
        async with opened(wire, safe=SafeState((0, 2), 20.0)):
            pass
    # grblHAL refuses what follows with the same error until an empty line.
    assert wire.lines == ["$I", "M5", "M65 P0", "", "M65 P2"]


@pytest.mark.parametrize("state", ["Run", "Hold:0"])
async def test_a_machine_that_runs_a_program_of_ours_is_stopped_at_the_takeover(
    monkeypatch: pytest.MonkeyPatch, state: str
) -> None:
    wire = Wire(state=state)
    wire.position = "10,20,30,90"
    real = wire.write

    async def write(data: bytes) -> None:
        await real(data)
        if data == b"\x18":
            wire.state = "Idle"

    monkeypatch.setattr(wire, "write", write)
    controller = Grbl(wire, safe=SafeState((0, 2), 20.0), silence=0.2, poll=0.02)
    await controller.open(stop_motion=True)
    assert wire.realtime == b"!\x18"
    assert wire.lines == [*RELEASE, "$I"]
    await controller.close()


@pytest.mark.parametrize("state", ["Jog", "Home", "Door:1"])
async def test_what_a_person_does_at_the_machine_is_never_stopped_by_a_takeover(state: str) -> None:
    wire = Wire(state=state)
    controller = Grbl(wire, silence=0.2, poll=0.02)
    with pytest.raises(ControllerError, match="is busy"):
        await controller.open(stop_motion=True)
    assert wire.realtime == b""
    await controller.close()


async def test_more_bytes_in_the_buffer_than_are_unanswered_is_an_answer_too_many() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.obliging = False
        wire.state = "Run"
        await controller.send(b"G1 X5", 1)
        wire.say("<Run|MPos:0,0,0,0|Bf:0,122>")
        await controller.status()
        assert controller.fault is None
        wire.say("ok\n<Run|MPos:0,0,0,0|Bf:0,122>\n<Run|MPos:0,0,0,0|Bf:0,122>")
        async with asyncio.timeout(60.0):
            while (fault := fault_of(controller)) is None:
                await asyncio.sleep(0.001)
        assert "a response was sent twice" in fault.text


async def test_an_alarm_that_is_over_does_not_unlock_a_later_one() -> None:
    wire = Wire()
    async with opened(wire) as controller:
        wire.say("<Alarm|MPos:0,0,0,0>\nALARM:3")
        async with asyncio.timeout(60.0):
            while controller.last_alarm != 3:
                await asyncio.sleep(0.001)
            wire.say("<Idle|MPos:0,0,0,0>")
            while controller.last_alarm != 0:
                await asyncio.sleep(0.001)


async def test_settling_waits_for_rest_and_for_the_answer_to_its_own_question() -> None:
    wire = Wire({"$G": "[GC:G0 G54]\nok"})
    async with opened(wire) as controller:
        await controller.send(b"G1 X5", 1)
        assert (await controller.settle()).state is State.IDLE
        assert wire.lines == ["$I", "G1 X5", "$G"]


async def test_the_answer_of_another_line_to_that_question_is_an_answer_too_many() -> None:
    # A late ok of a line that was already counted as answered, then the expected answer.
    wire = Wire({"$G": "ok\n[GC:G0 G54]"})
    async with opened(wire) as controller:
        with pytest.raises(ControllerError, match="a response was sent twice"):
            await controller.settle()


async def test_the_tool_s_turn_is_read_from_the_axis_that_the_controller_names() -> None:
    wire = Wire({"$I": "[OPT:V,15,128]\n[AXS:6:XYZABC]\nok"})
    async with opened(wire) as controller:
        wire.position = "1,2,3,4,5,90"
        assert (await controller.status()).position == (1.0, 2.0, 3.0, 90.0)
