"""What a gateway that takes over concludes about a program that ran without it."""

from __future__ import annotations

import hashlib
from pathlib import Path

import httpx
import pytest

from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import Controller, SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.interpreter import Interpreter
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.journal import Journal
from knifetip.gateway.motion import Pose
from knifetip.gateway.takeover import Found, has_ended
from knifetip.library import load
from tests.unit.gateway.test_claim import Office, table

MACHINE = load.machine("demo-table")
PATH = "/tmp/knifetip-a.ngc"
PROGRAM = b"""G21 G90 G17
G0 Z20
M64 P1
G0 X100 Y100
G1 Z-1 F6000
G1 X200 F9000
G1 Z20
M65 P1
G0 X0 Y0
G0 Z20
M2
"""
LINES = PROGRAM.count(b"\n")
END: Pose = (0.0, 0.0, 20.0, 0.0)


@pytest.mark.parametrize(
    ("executed", "rest", "ended"),
    [
        (5, END, True),
        (8, END, True),
        (5, (0.0, 0.3, 20.0, 0.0), False),  # somewhere else
        (5, (200.0, 100.0, 20.0, 0.0), False),  # at the end of line 7
        (5, (150.0, 100.0, -1.0, 0.0), False),  # in a cut
        (LINES, END, False),  # nothing remains that could show it
    ],
)
def test_a_machine_that_rests_only_where_its_program_ends_has_executed_it(
    executed: int, rest: Pose, *, ended: bool
) -> None:
    assert has_ended(PROGRAM, Interpreter(rest), executed, rest) is ended


def test_a_position_that_the_program_also_passes_before_its_end_proves_nothing() -> None:
    passing = PROGRAM.replace(b"G0 X0 Y0\n", b"G0 X0 Y0\nG0 X50 Y50\nG0 X-50 Y-50\nG0 X0 Y0\n")
    assert not has_ended(passing, Interpreter(END), 5, END)
    assert has_ended(passing, Interpreter(END), 11, END)


class Recalling(driver.Grbl):
    """A controller that knows which program it executes."""

    program_name = ""
    found: Found | None = None


async def report_of(
    tmp_path: Path, found: Found | None, *, copies: int = 1, wrong_program: bool = False
) -> dict[str, object]:
    """Return what a gateway reports that was killed at line 5 and then finds something."""
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, hashlib.sha256(PROGRAM).hexdigest(), LINES, copies)
    journal.begin_copy("job-0")
    journal.program("job-0", PATH)
    journal.line("job-0", 0, 5, 5)
    office = Office(PROGRAM if not wrong_program else b"G21\n")
    office.claim["program"] = "/api/gateway/program/job-0"
    async with table(speed=100.0) as server:

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            controller = await driver.dial(server.address, safe, stop_motion=stop_motion)
            controller.__class__ = Recalling
            controller.found = found  # type: ignore[attr-defined]  # of Recalling
            return controller

        async with httpx.AsyncClient(transport=httpx.MockTransport(office)) as client:
            settings = GatewaySettings(
                "http://office", MACHINE, "table-7", wait=0.1, beat=0.01, journal=path
            )
            await run_gateway(settings, connect, client=client, jobs=1)
    return office.finished[0]


async def test_a_program_that_ran_to_its_end_alone_is_done(tmp_path: Path) -> None:
    report = await report_of(tmp_path, Found(PATH, rest=END))
    assert (report["outcome"], report["line"], report["copies_done"]) == ("done", LINES, 1)


async def test_after_the_first_of_two_copies_the_second_is_left(tmp_path: Path) -> None:
    report = await report_of(tmp_path, Found(PATH, rest=END), copies=2)
    assert (report["outcome"], report["line"], report["copies_done"]) == ("interrupted", 0, 1)
    assert report["line_at_most"] == 0


async def test_a_program_that_was_held_at_a_line_stopped_there(tmp_path: Path) -> None:
    report = await report_of(tmp_path, Found(PATH, executed=6))
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("interrupted", 6, 6)


@pytest.mark.parametrize(
    "found",
    [
        None,
        Found("/tmp/of-another.ngc", rest=END),
        Found("/tmp/of-another.ngc", executed=9),
        Found(PATH),
        Found(PATH, executed=3),  # less than the journal records
        Found(PATH, rest=(150.0, 100.0, -1.0, 0.0)),
    ],
)
async def test_what_is_not_certain_is_a_lower_bound(tmp_path: Path, found: Found | None) -> None:
    report = await report_of(tmp_path, found)
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("interrupted", 5, None)


async def test_without_the_program_nothing_is_concluded_from_a_position(tmp_path: Path) -> None:
    report = await report_of(tmp_path, Found(PATH, rest=END), wrong_program=True)
    assert (report["outcome"], report["line"], report["line_at_most"]) == ("interrupted", 5, None)
