"""Faults on the connection to a controller: each ends with the machine in its safe state.

The table is simulated in memory, and its time advances with every ``?``; only the limit of silence
depends on the clock.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import AsyncIterator, Callable
from contextlib import aclosing

import pytest

from knifetip.errors import (
    ConnectionLost,
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
    KnifetipError,
)
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl.driver import Grbl
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import Progress, stream
from knifetip.library import load
from knifetip.simulators.grbl.table import BANNER, Table

MACHINE = load.machine("demo-table")
SAFE = SafeState.from_machine(MACHINE)
SILENCE = 0.3
#: Seconds by which the table's time advances with each ``?``.
STEP = 0.02

PROGRAM = (
    "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20.0000\nM64 P1\nG4 P0.15\n"
    + "".join(
        f"G0 X{160 + 40 * row}.0000 Y100.0000\nG1 Z-1.0000 F6000.0\n"
        f"G1 Y{300 + row}.0000 F20000.0\nG1 Z18.5000 F6000.0\n"
        for row in range(8)
    )
    + "G0 Z20.0000\nM65 P1\nM5\nM30\n"
).encode()
LINES = PROGRAM.count(b"\n")
#: A line of the program in the middle of the creases.
MIDDLE = 18


SpoilAnswer = Callable[[str], list[str]]
SpoilLine = Callable[[bytes], bytes]


class Wire:
    """A Transport to a table in memory that can modify lines and answers."""

    address = "wire"

    def __init__(self, table: Table) -> None:
        self.table = table
        self.spoil_answer: SpoilAnswer = lambda line: [line]
        self.spoil_line: SpoilLine = lambda line: line
        self.open = True
        self.muted = False
        self.oks = 0  # answers to lines of the program, without check mode
        self.moves = 0
        self._disabled = False
        self.checked = False
        self._out: asyncio.Queue[bytes] = asyncio.Queue()
        table.answer = self._answer

    def _answer(self, line: str) -> None:
        # The greeting after check mode ends the check; earlier ones follow the takeover's reset.
        self._disabled = self._disabled or line == "[MSG:Disabled]"
        self.checked = self.checked or (self._disabled and line == BANNER)
        if line == "ok" and self.checked:
            self.oks += 1
        for part in self.spoil_answer(line):
            self.say(part + "\r\n")

    def say(self, text: str) -> None:
        if self.open and not self.muted:
            self._out.put_nowait(text.encode("latin-1"))

    def cut(self) -> None:
        self.open = False
        self.table.answer = lambda line: None
        self._out.put_nowait(b"")

    async def read(self) -> bytes:
        return await self._out.get()

    async def write(self, data: bytes) -> None:
        if not self.open:
            return
        if data == b"?":
            self.table.elapse(STEP)
        elif self.checked and re.match(rb"G1 Y", data):
            self.moves += 1
            data = self.spoil_line(data)
        self.table.receive(data)

    async def close(self) -> None:
        self.open = False


class Bench:
    """A table, a connection to it, and a controller that streams the program."""

    def __init__(self) -> None:
        self.table = Table(MACHINE)
        self.wire = Wire(self.table)
        self.reachable = True  # whether a lost connection can be opened again
        self.controller = Grbl(
            self.wire, safe=SAFE, reconnect=self._reconnect, silence=SILENCE, poll=0.01
        )

    async def _reconnect(self) -> Wire:
        if not self.reachable:
            raise ConnectionLost("controller.unreachable", address="wire", reason="off")
        self.wire = Wire(self.table)
        return self.wire

    async def run(self, program: bytes = PROGRAM) -> Progress:
        """Stream a program; return the last report of progress."""
        course = stream(
            program, self.controller, limits=Limits.from_machine(MACHINE), interval=0.001
        )
        async with asyncio.timeout(120.0), aclosing(course) as steps:
            return [progress async for progress in steps][-1]

    def at_answer(self, spoil: SpoilAnswer, number: int = MIDDLE) -> None:
        """Modify the answer to the program line ``number``: ``spoil`` returns the lines sent
        instead.
        """

        def spoil_answer(line: str) -> list[str]:
            if line == "ok" and self.wire.oks == number and self.wire.checked:
                self.wire.spoil_answer = lambda line: [line]
                return spoil(line)
            return [line]

        self.wire.spoil_answer = spoil_answer

    def at_move(self, spoil: SpoilLine, number: int = 3) -> None:
        """Modify the move ``number`` on its way to the table: ``spoil`` returns the bytes sent
        instead.
        """

        def spoil_line(line: bytes) -> bytes:
            return spoil(line) if self.wire.moves == number else line

        self.wire.spoil_line = spoil_line

    def assert_safe(self) -> None:
        assert self.table.state == "Idle"
        assert self.table.position[2] == 20.0
        assert not any(self.table.outputs.values())
        assert not self.table.oscillating
        assert self.table.lost == 0


@pytest.fixture
async def bench() -> AsyncIterator[Bench]:
    bench = Bench()
    await bench.controller.open()
    yield bench
    await bench.controller.close()


async def test_the_program_runs_to_its_end_and_its_station_was_lowered(bench: Bench) -> None:
    progress = await bench.run()
    assert progress.executed == progress.lines == LINES
    assert [event.on for event in bench.table.switch_events if event.output == 1] == [
        False,
        True,
        False,
    ]
    bench.assert_safe()


# -- Faults that end the job


def stranger_resets(bench: Bench) -> SpoilAnswer:
    def spoil(line: str) -> list[str]:
        bench.table.receive(b"\x18")
        return [line]

    return spoil


def mute(bench: Bench, line: str) -> list[str]:
    bench.wire.muted = True
    asyncio.get_running_loop().call_later(1.5 * SILENCE, setattr, bench.wire, "muted", False)
    return [line]


def cut(bench: Bench) -> list[str]:
    bench.wire.cut()
    return []


ANSWERS: dict[str, tuple[Callable[[Bench], SpoilAnswer], type[KnifetipError], str]] = {
    "doubled": (lambda bench: lambda line: [line, line], ControllerError, "was sent twice"),
    "lost": (
        lambda bench: lambda line: [],
        ControllerSilent,
        "a response of the controller was lost",
    ),
    "garbled": (lambda bench: lambda line: ["\xfe\x81" + line], ControllerSilent, "was lost"),
    "glued": (lambda bench: lambda line: [line + line], ControllerSilent, "was lost"),
    "banner": (lambda bench: lambda line: [BANNER, line], ControllerReset, "was reset"),
    "false alarm": (lambda bench: lambda line: ["ALARM:1", line], ControllerAlarm, "ALARM:1"),
    "stranger's ok": (
        lambda bench: lambda line: ["ok", "ok", line],
        ControllerError,
        "was sent twice",
    ),
    "reset": (stranger_resets, ControllerAlarm, "ALARM:3"),
    "cut": (lambda bench: lambda line: cut(bench), ControllerError, "connection .* is lost"),
    "stall": (lambda bench: lambda line: mute(bench, line), ControllerSilent, "not responded"),
}


@pytest.mark.parametrize("kind", ANSWERS)
async def test_a_spoilt_answer_ends_the_job_with_the_machine_safe(bench: Bench, kind: str) -> None:
    spoil, error, words = ANSWERS[kind]
    bench.at_answer(spoil(bench))
    with pytest.raises(error, match=words) as raised:
        await bench.run()
    bench.assert_safe()
    assert "head was lifted to Z 20.0 mm, and the stations were raised" in raised.value.text
    assert raised.value.hint
    # The machine is in a known state: the next program runs.
    assert bench.controller.fault is None
    assert (await bench.run()).executed == LINES


@pytest.mark.parametrize("number", range(1, LINES + 1))
async def test_a_doubled_answer_is_noticed_wherever_it_comes_and_overruns_nothing(
    bench: Bench, number: int
) -> None:
    bench.at_answer(lambda line: [line, line], number)
    with pytest.raises(ControllerError, match="was sent twice"):
        await bench.run()
    bench.assert_safe()


@pytest.mark.parametrize("spoil", [[], ["\xfe\x81ok"], ["okok"]], ids=["lost", "garbled", "glued"])
async def test_a_lost_answer_is_noticed_while_the_machine_moves(
    bench: Bench, spoil: list[str]
) -> None:
    rows = "".join(f"G1 X{100 + row % 2 * 50} Y{100 + row} F20000\n" for row in range(300))
    program = f"G21 G90\nG0 Z20\n{rows}M30\n".encode()
    times: list[float] = []

    def spoil_answer(line: str) -> list[str]:
        times.append(bench.table.time)
        return spoil

    bench.at_answer(spoil_answer, 30)
    with pytest.raises(ControllerSilent, match="contains fewer bytes than were sent"):
        await bench.run(program)
    assert bench.controller.acknowledged < 60
    assert bench.table.time - times[0] < 1.0
    bench.assert_safe()


async def test_after_a_lost_connection_the_lines_in_the_buffer_are_counted(bench: Bench) -> None:
    bench.at_answer(lambda line: cut(bench))
    with pytest.raises(ControllerError) as raised:
        await bench.run()
    found = re.search(r"(\d+) of (\d+) program lines .* Up to (\d+) more", raised.value.text)
    assert found is not None
    executed, lines, more = map(int, found.groups())
    assert lines == LINES
    # 15 blocks in the planner, and the lines in a buffer of 128 bytes.
    assert executed < MIDDLE <= executed + more <= executed + 15 + 12


async def test_a_connection_that_stays_lost_ends_in_words_that_the_machine_is_not_safe(
    bench: Bench,
) -> None:
    bench.reachable = False
    bench.at_answer(lambda line: cut(bench))
    with pytest.raises(
        ControllerError, match="The machine is not in a safe state: No controller responds"
    ):
        await bench.run()
    assert bench.controller.fault is not None


async def test_an_alarm_with_a_cause_at_the_machine_is_left_to_the_operator(bench: Bench) -> None:
    def limit_switch(line: str) -> list[str]:
        bench.table._alarm(1)
        return [line]

    bench.at_answer(limit_switch)
    with pytest.raises(ControllerAlarm, match=r"ALARM:1.*stations may still be lowered"):
        await bench.run()
    assert bench.table.state == "Alarm"


@pytest.mark.parametrize(
    ("spoil", "error", "words"),
    [
        (
            lambda line: line.replace(b"Y30", b"Y34"),
            ControllerError,
            "away from the path of the program",
        ),
        (lambda line: line[:-1], ControllerRejected, "rejected program line"),
        (lambda line: line + line, ControllerError, "did not send"),
    ],
    ids=["digit", "newline", "doubled"],
)
async def test_a_line_spoilt_on_its_way_never_ends_as_done(
    bench: Bench, spoil: SpoilLine, error: type[KnifetipError], words: str
) -> None:
    bench.at_move(spoil)
    with pytest.raises(error, match=words):
        await bench.run()
    bench.assert_safe()


# -- Faults that are tolerated


@pytest.mark.parametrize(
    "extra",
    [
        "<Idle|MPos:0.000,0.000,20.000,0.000|Bf:15,128|FS:0,0>",
        "<Run|MPos:900.000,0.000,20.000,0.000|Bf:0,0|FS:0,0>",
        "".join(map(chr, range(128, 158))),
        "<Run|MPos:1,2",
    ],
    ids=["idle", "elsewhere", "noise", "torn"],
)
async def test_a_false_report_and_noise_are_borne(bench: Bench, extra: str) -> None:
    bench.at_answer(lambda line: [extra, line])
    assert (await bench.run()).executed == LINES


async def test_lines_that_come_in_pieces_are_borne(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = bench.wire.say

    def say(text: str) -> None:
        real(text[:1])
        real(text[1:])

    monkeypatch.setattr(bench.wire, "say", say)
    assert (await bench.run()).executed == LINES
