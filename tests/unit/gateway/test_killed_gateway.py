"""What the next gateway reports of a job whose gateway was killed, for each kind of controller."""

from __future__ import annotations

import asyncio
import hashlib
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import Controller, SafeState
from knifetip.gateway.grbl import driver as grbl
from knifetip.gateway.hot_folder import HotFolder
from knifetip.gateway.hpgl import driver as hpgl
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.journal import Journal
from knifetip.gateway.mcx314 import driver as mcx314
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.simulators.mcx314 import simulator as board_simulator
from tests.unit.gateway.test_claim import Office, table
from tests.unit.gateway.test_hpgl_driver import network_plotter
from tests.unit.gateway.test_mcx314_driver import SAFE, TABLE, strips

GRBL = load.machine("demo-table")
#: 400 short lines after each other, then the end.
CUTS = 400
LONG = (
    b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG0 Z20.0000\nG0 X100 Y100 Z2\n"
    + b"".join(b"G1 X%d F12000\n" % (100 + cut % 200) for cut in range(CUTS))
    + b"G0 Z20\nM30\n"
)
LINES = LONG.count(b"\n")

Connecting = Callable[[SafeState, bool], Awaitable[Controller]]


def journal_of(path: Path, program: bytes, line: int, copies: int = 1) -> Journal:
    """Return the journal of a gateway that was killed in a cut."""
    journal = Journal(path)
    journal.begin("job-1", 3, hashlib.sha256(program).hexdigest(), program.count(b"\n"), copies)
    journal.begin_copy("job-1")
    journal.line("job-1", 0, line, line)
    return journal


async def report_of(path: Path, machine: Machine, connect: Connecting) -> dict[str, Any]:
    """Return what a gateway reports that is started after the one of the journal was killed."""
    office = Office()
    async with (
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(120.0),
    ):
        settings = GatewaySettings(
            "http://office", machine, "table-7", wait=0.1, beat=0.01, journal=path
        )
        running = asyncio.create_task(run_gateway(settings, connect, client=client))
        while not office.finished:
            await asyncio.sleep(0.01)
        running.cancel()
        with suppress(asyncio.CancelledError):
            await running
    return office.finished[0]


async def test_the_journal_of_grbl_is_always_ahead_of_the_lines_that_were_sent(
    tmp_path: Path,
) -> None:
    """Whenever the gateway is killed, the bound is true, and soon it is not the whole program."""
    path = tmp_path / "journal"
    office = Office(LONG)
    before: list[int] = []  # lines of the gateway itself, such as those that switch outputs off
    bounds: list[tuple[int, int]] = []  # lines that the controller has got, bound in the journal

    def note(beat: dict[str, Any]) -> str:
        left, got = Journal(path).unfinished(), server.table.lines_read - before[-1]
        if left is not None and got > 0:
            bounds.append((got, left.sent_at_most or 0))
        return "continue"

    office.command = note
    async with (
        table(speed=2.0) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(60.0),
    ):
        settings = GatewaySettings(
            "http://office", GRBL, "table-7", wait=0.1, beat=0.005, journal=path
        )

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            controller = await grbl.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)
            before.append(server.table.lines_read)
            return controller

        await run_gateway(settings, connect, client=client, jobs=1)
    assert office.finished[0]["outcome"] == "done"
    assert bounds
    assert all(got <= bound for got, bound in bounds)
    # At most one block of lines and what is in the buffer of the controller.
    assert all(bound <= got + 64 + 20 for got, bound in bounds)
    assert min(bound for _, bound in bounds) < LINES // 2


@pytest.mark.parametrize(
    ("noted", "at_most"), [(70, 70), (LINES + 50, LINES), (10, 20), (None, None)]
)
async def test_the_bound_of_the_journal_is_reported(
    tmp_path: Path, noted: int | None, at_most: int | None
) -> None:
    path = tmp_path / "journal"
    journal = journal_of(path, LONG, 20)
    if noted is not None:
        journal.record_sending("job-1", 0, noted)
    async with table(speed=40.0) as server:

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            return await grbl.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        report = await report_of(path, GRBL, connect)
    assert (report["outcome"], report["line"], report["line_at_most"]) == (
        "interrupted",
        20,
        at_most,
    )


@pytest.mark.parametrize(("job", "copy"), [("job-0", 0), ("job-1", 1)])
def test_the_bound_of_another_job_or_copy_does_not_count(
    tmp_path: Path, job: str, copy: int
) -> None:
    path = tmp_path / "journal"
    journal = journal_of(path, LONG, 20, copies=3)
    journal.record_sending(job, copy, 70)
    left = Journal(path).unfinished()
    assert left is not None
    assert left.sent_at_most is None
    journal.begin("job-1", 4, "", LINES)  # the same job, claimed again
    again = Journal(path).unfinished()
    assert again is not None
    assert again.sent_at_most is None


def test_a_bound_that_cannot_be_written_is_removed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "journal"
    journal = journal_of(path, LONG, 20)
    journal.record_sending("job-1", 0, 64)

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("knifetip.gateway.journal.os.fsync", full)
    journal.record_sending("job-1", 0, 128)
    left = Journal(path).unfinished()
    assert left is not None
    assert left.sent_at_most is None


async def test_a_board_is_asked_and_stops_where_its_lines_are_known(tmp_path: Path) -> None:
    program = strips(3)
    async with await board_simulator.serve(TABLE, speed=2.0) as server:
        first = await mcx314.dial(server.address, SAFE, poll=0.02)
        running = asyncio.create_task(first.run(program))
        async with asyncio.timeout(120.0):
            while server.board.position[2] >= 0.0:  # until it cuts
                await asyncio.sleep(0.01)
        path = tmp_path / "journal"
        journal = Journal(path)
        digest = hashlib.sha256(program).hexdigest()
        journal.begin("job-1", 3, digest, program.count(b"\n"))
        journal.begin_copy("job-1")
        journal.program("job-1", first.program_name)
        journal.line("job-1", 0, 4, 4)
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        await first.close()

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            return await mcx314.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        report = await report_of(path, TABLE, connect)
        assert server.board.position[2] == SAFE.lift
        assert server.board.outputs == set()
    assert report["outcome"] == "interrupted"
    assert 12 < report["line"] < program.count(b"\n")
    assert report["line_at_most"] == report["line"]


async def test_a_job_whose_gateway_was_killed_in_the_check_run_returns_to_the_queue(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    digest = hashlib.sha256(LONG).hexdigest()
    Journal(path).begin("job-1", 3, digest, LINES)
    async with table(speed=40.0) as server:

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            return await grbl.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        report = await report_of(path, GRBL, connect)
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("returned", 0, 0)
    assert report["why"]["code"] == "gateway.switched-off-before-begin"


async def test_of_a_journal_of_an_earlier_version_it_is_not_known_whether_it_was_begun(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    Journal(path).begin("job-1", 3, hashlib.sha256(LONG).hexdigest(), LINES)
    path.write_text(path.read_text().replace(', "copy_begun": false', ""))
    left = Journal(path).unfinished()
    assert left is not None
    assert left.copy_begun


@pytest.mark.parametrize("moved", [False, True])
async def test_a_board_tells_a_program_that_it_has_not_begun(
    tmp_path: Path, *, moved: bool
) -> None:
    """It has the first lines, and begins only with half a queue of them."""
    program = strips(3)
    async with await board_simulator.serve(TABLE, speed=2.0) as server:
        first = await mcx314.dial(server.address, SAFE, poll=0.02)
        number = await first._connection.request(f"BEGIN {program.count(bytes([10]))}")
        name = first._connection.name_of(number.removeprefix("PROGRAM="))
        head = "|".join(program.decode().splitlines()[:4])
        await first._connection.request(f"LOAD {number.removeprefix('PROGRAM=')} 1 {head}")
        if moved:
            assert server.board.program is not None
            server.board.program.done = 1  # its first line was executed
        path = tmp_path / "journal"
        journal = Journal(path)
        digest = hashlib.sha256(program).hexdigest()
        journal.begin("job-1", 3, digest, program.count(b"\n"))
        journal.begin_copy("job-1")
        journal.program("job-1", name)
        await first.close()

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            return await mcx314.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        report = await report_of(path, TABLE, connect)
    expected = ("interrupted", 1) if moved else ("returned", 0)
    assert (report["outcome"], report["line"]) == expected


async def test_of_a_plotter_nothing_but_a_lower_bound_is_known(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal_of(path, b"PU;\n" * 40, 8)
    async with network_plotter() as (_, address):

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            return await hpgl.dial(address, safe, stop_motion=stop_motion)

        report = await report_of(path, load.machine("flat-cutter-hpgl"), connect)
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("interrupted", 8, None)


async def test_of_a_hot_folder_nothing_but_a_lower_bound_is_known(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal_of(path, LONG, 0)
    folder = tmp_path / "folder"
    folder.mkdir()

    async def connect(safe: SafeState, stop_motion: bool) -> Controller:
        del safe, stop_motion
        controller = HotFolder(folder, GRBL.name, ".ngc")
        await controller.open()
        return controller

    report = await report_of(path, GRBL, connect)
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("interrupted", 0, None)
