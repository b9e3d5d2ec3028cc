"""HPGL to a plotter over TCP, over a serial port with flow control, and to a folder."""

from __future__ import annotations

import asyncio
import os
import socket
import time
import tty
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, aclosing, asynccontextmanager, suppress
from pathlib import Path

import httpx
import pytest

from knifetip.errors import ControllerError, ProgramError
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import State
from knifetip.gateway.hot_folder import find_driver
from knifetip.gateway.hpgl import driver
from knifetip.gateway.hpgl.driver import RAISE
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.stream import stream
from knifetip.gateway.transport import connect
from knifetip.library import load
from knifetip.model.machine import Machine
from tests.unit.gateway.test_claim import Beat, Office

MACHINE = load.machine("flat-cutter-hpgl")
PROGRAM = b"IN;\nPA;\nPU;\nSP1;\nFS30;\nVS40;\nPU400,400;\nPD4400,400;\nPU;\nSP0;\n"
LONG = (
    b"IN;\nPA;\nPU;\nSP1;\nFS30;\nVS40;\n"
    + b"".join(b"PU%d,400;\nPD%d,4400;\n" % (row, row) for row in range(20000))
    + b"PU;\nSP0;\n"
)


class Plotter:
    """The far end of a connection: collects bytes while it accepts any."""

    def __init__(self) -> None:
        self.received = b""
        self.accepts = asyncio.Event()
        self.accepts.set()

    async def read_from(self, reader: asyncio.StreamReader) -> None:
        while True:
            await self.accepts.wait()
            data = await reader.read(512)
            if not data:
                return
            self.received += data


@asynccontextmanager
async def network_plotter() -> AsyncIterator[tuple[Plotter, str]]:
    plotter = Plotter()

    serving: list[asyncio.Task[None]] = []

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            with suppress(OSError):
                await plotter.read_from(reader)
        finally:
            writer.transport.abort()

    def accept(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        serving.append(asyncio.create_task(serve(reader, writer)))

    listener = socket.create_server(("127.0.0.1", 0))
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    server = await asyncio.start_server(accept, sock=listener, limit=512)
    host, port = server.sockets[0].getsockname()
    try:
        yield plotter, f"tcp://{host}:{port}"
    finally:
        for task in serving:
            task.cancel()
        await asyncio.gather(*serving, return_exceptions=True)
        server.close()
        await asyncio.sleep(0.01)  # until the sockets are closed


@asynccontextmanager
async def serial_plotter() -> AsyncIterator[tuple[Plotter, str]]:
    plotter = Plotter()
    master, slave = os.openpty()
    tty.setraw(slave)
    reading = asyncio.create_task(_read_terminal(plotter, master))
    try:
        yield plotter, f"serial://{os.ttyname(slave)}?flow=rtscts"
    finally:
        reading.cancel()
        os.close(master)
        os.close(slave)


async def _read_terminal(plotter: Plotter, master: int) -> None:
    os.set_blocking(master, False)
    while True:
        await plotter.accepts.wait()
        with suppress(BlockingIOError):
            plotter.received += os.read(master, 512)
        await asyncio.sleep(0.001)


FarEnd = Callable[[], AbstractAsyncContextManager[tuple[Plotter, str]]]
PLOTTERS = [
    network_plotter,
    pytest.param(
        serial_plotter, marks=pytest.mark.skipif(os.name != "posix", reason="no pseudo-terminals")
    ),
]


@pytest.fixture(autouse=True)
def _short_times(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(driver, "PATIENCE", 1.0)


async def run_job(office: Office, machine: Machine, address: str) -> None:
    """Run a gateway for a controller at an address until one job has ended."""
    dial = find_driver(machine, address)
    settings = GatewaySettings("http://office", machine, "plotter-1", wait=0.1, beat=0.01)
    async with (
        asyncio.timeout(120.0),
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
    ):
        await run_gateway(
            settings,
            lambda safe, stop_motion: dial(address, safe, stop_motion=stop_motion),
            client=client,
            jobs=1,
        )


@pytest.mark.parametrize("far_end", PLOTTERS)
async def test_a_job_is_done_only_when_a_person_has_confirmed_its_end(far_end: FarEnd) -> None:
    office = Office(PROGRAM)
    asked: list[bytes] = []

    async with far_end() as (plotter, address):

        def command(beat: Beat) -> str:
            if not beat["held"]:
                return "continue"
            asked.append(plotter.received)
            return "end" if len(asked) == 20 else "continue"

        office.command = command
        await run_job(office, MACHINE, address)
        assert plotter.received == PROGRAM
    assert asked[0] == PROGRAM
    assert len(asked) >= 20
    assert office.finished[0]["outcome"] == "done"
    assert office.finished[0]["line"] == PROGRAM.count(b"\n")
    # Nothing is known before that: neither a position nor an executed line nor the time left.
    assert {beat["line"] for beat in office.beats} <= {0, PROGRAM.count(b"\n")}
    assert all(beat["position"] is None for beat in office.beats)
    assert {beat["seconds_left"] for beat in office.beats} <= {None, 0.0}


async def test_a_resume_does_not_confirm_the_end() -> None:
    office = Office(PROGRAM)
    held: list[Beat] = []

    async with network_plotter() as (_, address):

        def command(beat: Beat) -> str:
            if not beat["held"]:
                return "continue"
            held.append(beat)
            return "resume" if len(held) < 20 else "cancel"

        office.command = command
        await run_job(office, MACHINE, address)
    assert len(held) >= 20
    assert all(beat["awaits_end"] for beat in held)
    assert office.finished[0]["outcome"] != "done"


async def test_each_end_and_each_sheet_is_a_phase_of_its_own() -> None:
    office = Office(PROGRAM, copies=2)
    waits = ("run", "first end", "sheet", "second end")
    phases: dict[str, set[int]] = {wait: set() for wait in waits}

    async with network_plotter() as (plotter, address):

        def command(beat: Beat) -> str:
            if not beat["held"]:
                if not beat["copies_done"] and not phases["first end"]:
                    phases["run"].add(beat["phase"])
                return "continue"
            second = len(plotter.received) > len(PROGRAM)
            wait = "first end" if not beat["copies_done"] else "second end" if second else "sheet"
            phases[wait].add(beat["phase"])
            return "end" if beat["awaits_end"] else "resume"

        office.command = command
        await run_job(office, MACHINE, address)
    assert all(phases.values())
    assert len(set.union(*phases.values())) == sum(map(len, phases.values()))
    assert office.finished[0]["outcome"] == "done"


@pytest.mark.parametrize("far_end", PLOTTERS)
async def test_a_cancelled_job_sends_no_more_and_raises_the_tool(far_end: FarEnd) -> None:
    office = Office(LONG)
    async with far_end() as (plotter, address):

        def command(beat: Beat) -> str:
            return "cancel" if len(plotter.received) > 5000 else "continue"

        office.command = command
        await run_job(office, MACHINE, address)
        await asyncio.sleep(0.1)
        body, raised = plotter.received[: -len(RAISE)], plotter.received[-len(RAISE) :]
    assert raised == RAISE
    assert LONG.startswith(body)
    assert body.endswith(b"\n")
    assert len(body) < len(LONG)
    assert office.finished[0]["outcome"] == "interrupted"
    assert "raises the tool after that" in office.finished[0]["why"]["text"]


@pytest.mark.parametrize("far_end", PLOTTERS)
async def test_a_cancel_is_reported_even_if_the_plotter_accepts_nothing(far_end: FarEnd) -> None:
    office = Office(LONG)
    stopped: list[float] = []
    async with far_end() as (plotter, address):

        def command(beat: Beat) -> str:
            if len(plotter.received) < 5000:
                return "continue"
            if plotter.accepts.is_set():
                plotter.accepts.clear()
                stopped.append(time.monotonic())
            # By then all buffers on the way are full.
            return "cancel" if time.monotonic() - stopped[0] > 1.0 else "continue"

        office.command = command
        async with asyncio.timeout(120.0):
            await run_job(office, MACHINE, address)
    assert "has accepted no data for 1 s" in office.finished[0]["why"]["text"]


async def test_lines_count_as_executed_when_they_no_longer_fit_into_the_buffer() -> None:
    async with network_plotter() as (plotter, address):
        plotter.accepts.clear()
        controller = await driver.dial(f"{address}?buffer=1000")
        running = asyncio.create_task(controller.run(LONG))
        await asyncio.sleep(0.3)
        status = await controller.status()
        assert status.state is State.RUN
        assert not status.located
        done = b"".join(LONG.splitlines(keepends=True)[: status.acknowledged])
        sent = b"".join(LONG.splitlines(keepends=True)[: status.sent])
        assert 1000 <= len(sent) - len(done) <= 1000 + driver.PIECE + 20
        running.cancel()
        with pytest.raises(
            ControllerError, match=r"has accepted no data|rest of the program is not sent"
        ):
            await controller.stop()
        await controller.close()


async def test_a_hold_is_not_reported_because_the_plotter_goes_on() -> None:
    async with network_plotter() as (plotter, address):
        plotter.accepts.clear()
        controller = await driver.dial(address)
        async with aclosing(stream(LONG, controller, interval=0.01)) as steps:
            async for progress in steps:
                await controller.hold()
                assert progress.state in (State.IDLE, State.RUN)
                if progress.state is State.RUN:
                    break
            plotter.accepts.set()
            with pytest.raises(ControllerError, match="rest of the program is not sent"):
                await steps.aclose()
        await controller.close()


async def test_a_program_with_control_bytes_is_refused_before_a_byte_is_sent() -> None:
    async with network_plotter() as (plotter, address):
        controller = await driver.dial(address)
        with pytest.raises(ProgramError, match="Line 2"):
            async for _ in stream(b"IN;\nPA;\x1b.(;\n", controller):
                pass
        await controller.close()
    assert plotter.received == b""


async def test_a_plotter_that_may_have_a_part_of_a_program_raises_its_tool() -> None:
    async with network_plotter() as (plotter, address):
        controller = await driver.dial(address, stop_motion=True)
        await asyncio.sleep(0.05)
        await controller.close()
    assert plotter.received == RAISE


@pytest.mark.parametrize(
    "address", ["serial:///dev/ttyUSB0", "serial:///dev/ttyUSB0?flow=none", "tcp://h?buffer=x"]
)
async def test_a_wrong_address_is_refused_with_an_example(address: str) -> None:
    with pytest.raises(ControllerError, match="not the address of a plotter"):
        await driver.dial(address)


async def test_without_a_port_the_raw_port_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    addresses = []

    async def record(address: str) -> None:
        addresses.append(address)
        raise ControllerError("controller.bad-address", address=address, schemes=[])

    monkeypatch.setattr(driver, "connect", record)
    for address in ("tcp://plotter", "plotter", "plotter:5000"):
        with suppress(ControllerError):
            await driver.dial(address)
    assert addresses == ["tcp://plotter:9100", "tcp://plotter:9100", "tcp://plotter:5000"]


@pytest.mark.parametrize(
    ("name", "suffix"), [("flat-cutter-hpgl", ".plt"), ("two-carriage-table", ".ngc")]
)
async def test_a_folder_takes_programs_of_every_language(
    tmp_path: Path, name: str, suffix: str
) -> None:
    machine = load.machine(name)
    office = Office(PROGRAM, copies=2)
    seen: list[list[str]] = []

    def command(beat: Beat) -> str:
        if beat["held"]:
            seen.append(sorted(file.name for file in tmp_path.glob(f"*{suffix}")))
        if beat["awaits_end"]:
            return "end"
        return "resume" if beat["held"] else "continue"

    office.command = command
    await run_job(office, machine, tmp_path.as_uri())
    first, second = f"{name}-0001{suffix}", f"{name}-0002{suffix}"
    assert [first] in seen
    assert seen[-1] == [first, second]
    assert (tmp_path / first).read_bytes() == (tmp_path / second).read_bytes() == PROGRAM
    assert office.finished[0]["outcome"] == "done"
    assert sorted(file.name for file in tmp_path.iterdir()) == [first, second]


async def test_the_program_of_a_killed_gateway_is_deleted_at_the_next_start(
    tmp_path: Path,
) -> None:
    dial = find_driver(MACHINE, tmp_path.as_uri())
    done = tmp_path / f"{MACHINE.name}-0001.plt"
    done.write_bytes(PROGRAM)
    killed = asyncio.create_task((await dial(tmp_path.as_uri())).run(PROGRAM))
    async with asyncio.timeout(60.0):
        while len(list(tmp_path.glob("*.plt"))) < 2:
            await asyncio.sleep(0.01)
    killed.cancel()
    await dial(tmp_path.as_uri())
    # The executed program is the user's, and is kept.
    assert list(tmp_path.iterdir()) == [done]


@pytest.mark.parametrize("name", ["../precious.plt", "precious.plt", ""])
async def test_a_wrong_note_about_a_program_deletes_nothing(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "programs"
    folder.mkdir()
    files = [tmp_path / "precious.plt", folder / "precious.plt"]
    for file in files:
        file.write_bytes(PROGRAM)
    note = folder / f".{MACHINE.name}-unconfirmed"
    note.write_text(name, encoding="utf-8")
    await find_driver(MACHINE, folder.as_uri())(folder.as_uri())
    assert [file.exists() for file in (*files, note)] == [True, True, False]


@pytest.mark.parametrize(
    ("taken", "words"), [(False, "was deleted"), (True, "has taken the program file")]
)
async def test_a_cancelled_program_is_deleted_unless_the_machine_has_taken_it(
    tmp_path: Path, taken: bool, words: str
) -> None:
    controller = await find_driver(MACHINE, tmp_path.as_uri())(tmp_path.as_uri())
    running = asyncio.create_task(controller.run(PROGRAM))
    async with asyncio.timeout(60.0):
        while not (files := list(tmp_path.glob("*.plt"))):
            await asyncio.sleep(0.01)
    if taken:
        files[0].unlink()
    with pytest.raises(ControllerError, match=words):
        await controller.stop()
    running.cancel()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("address", ["file:///", "file://host/folder", "file:///no/such/folder"])
async def test_a_wrong_folder_is_refused(address: str) -> None:
    with pytest.raises(ControllerError, match="folder"):
        await find_driver(MACHINE, address)(address)


async def test_a_port_with_flow_control_finishes_the_piece_of_a_cancelled_write() -> None:
    async with serial_plotter() as (plotter, address):
        plotter.accepts.clear()
        port = await connect(address)
        piece = b"x" * 60000
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.2):
                await port.write(piece)
        plotter.accepts.set()
        await port.write(b"end")
        async with asyncio.timeout(60.0):
            while not plotter.received.endswith(b"end"):
                await asyncio.sleep(0.01)
        assert plotter.received == piece + b"end"
        await port.close()
