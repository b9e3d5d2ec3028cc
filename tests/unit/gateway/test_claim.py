"""One job of the gateway: claim, stream, heartbeat, finish, and its behaviour after failures."""

from __future__ import annotations

import asyncio
import hashlib
import json
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.errors import ConnectionLost, GatewayRefused, StaleVersion
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import Controller, SafeState, State, Status
from knifetip.gateway.grbl import driver
from knifetip.gateway.job_run import JobRun, Lease
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.journal import Journal
from knifetip.gateway.stream import Progress
from knifetip.library import load
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import Faults, Table
from tests.support.messages import stored

MACHINE = load.machine("demo-table")

# The coordinates include the datum of station 2, the crease wheel: X +60, Z -1.5.
PROGRAM = b"""G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G0 Z20.0000
M64 P1
G4 P0.15
G0 X160.0000 Y100.0000 Z18.5000 C0.0000
G1 Z-1.0000 F6000.0
G1 X560.0000 F30000.0
G1 Z18.5000 F6000.0
G0 Z20.0000
M65 P1
M30
"""


#: Lines with which the gateway brings the table into its safe state when it connects.
TAKEOVER = 1 + len(MACHINE.outputs)
#: JSON of a heartbeat or of its response.
Beat = dict[str, Any]


class Office:
    """A fake server that offers one job and records the requests of the gateway."""

    def __init__(
        self,
        program: bytes = PROGRAM,
        *,
        copies: int = 1,
        lease: float = 5.0,
        sha256: str | None = None,
        confirm: bool = False,
    ) -> None:
        self.program = program
        self.claim: Beat = {
            "job": "job-1",
            "epoch": 3,
            "lease": lease,
            "program": "/api/jobs/job-1/program",
            "sha256": sha256 or hashlib.sha256(program).hexdigest(),
            "lines": program.count(b"\n"),
            "copies": copies,
            "confirm": confirm,
        }
        self.headers: list[httpx.Headers] = []
        self.claims: list[Beat] = []
        self.beats: list[Beat] = []
        self.finished: list[Beat] = []
        self.command: Callable[[Beat], str] = lambda beat: "continue"
        self.reachable = True
        self.refuses = False  # the key of the gateway
        self.stale = False
        self.deaf = 0  # number of responses to finish that are lost
        self.delayed: Callable[[Beat], Awaitable[None]] | None = (
            None  # the response to a heartbeat waits for this
        )

    async def __call__(self, request: httpx.Request) -> httpx.Response:
        if not self.reachable:
            raise httpx.ConnectError("no route", request=request)
        if self.refuses:
            return httpx.Response(401, json={"detail": "The key was revoked."})
        self.headers.append(request.headers)
        body = json.loads(request.content) if request.content else {}
        path = request.url.path
        if path == "/api/gateway/claim":
            self.claims.append(body)
            if len(self.claims) > 1:
                return httpx.Response(204)
            return httpx.Response(200, json=self.claim)
        if path == self.claim["program"]:
            return httpx.Response(200, content=self.program)
        if path == "/api/gateway/heartbeat":
            self.beats.append(body)
            if self.stale:
                return httpx.Response(409, json={"title": "stale"})
            answer = {"command": self.command(body), "lease": self.claim["lease"]}
            if self.delayed:
                await self.delayed(body)
            return httpx.Response(200, json=answer)
        if path == "/api/gateway/finish":
            if self.deaf:
                self.deaf -= 1
                return httpx.Response(503)
            self.finished.append(body)
            return httpx.Response(200, json={})
        if path == "/api/gateway/station":
            return httpx.Response(404)  # a server without stations
        raise AssertionError(path)


@asynccontextmanager
async def table(**options: Any) -> AsyncIterator[simulator.Server]:
    async with await simulator.serve(
        MACHINE, speed=options.pop("speed", 20.0), **options
    ) as server:
        yield server


async def gateway(office: Office, server: simulator.Server, **options: Any) -> None:
    """Run a gateway at a simulated table until one job has ended."""
    async with httpx.AsyncClient(transport=httpx.MockTransport(office)) as client:
        async with asyncio.timeout(120.0):
            connect = options.pop(
                "connect",
                lambda safe, stop_motion: driver.dial(
                    server.address, safe, stop_motion=stop_motion, silence=0.5, poll=0.02
                ),
            )
            machine = options.pop("machine", MACHINE)
            settings = GatewaySettings(
                "http://office", machine, "table-7", wait=0.1, beat=0.01, **options
            )
            await run_gateway(settings, connect, client=client, jobs=1)


async def test_the_time_left_begins_with_the_stated_time_also_between_two_copies() -> None:
    office = Office(copies=2)
    office.claim["seconds"] = 12.0
    office.command = lambda beat: "resume" if beat["held"] else "continue"
    async with table() as server:
        await gateway(office, server)
    assert office.beats[0]["seconds_left"] == 12.0
    between = [beat for beat in office.beats if beat["copies_done"] == 1 and beat["held"]]
    # The simulated table is 20 times as fast as the real one: the second copy is expected sooner.
    assert between
    assert all(0.0 < beat["seconds_left"] <= 12.0 for beat in between)


async def test_a_job_is_claimed_run_and_finished() -> None:
    office = Office()
    async with table() as server:
        await gateway(office, server)
        assert server.table.position == (560.0, 100.0, 20.0, 0.0)
    assert office.claims == [
        {"gateway": "table-7", "machine": "demo-table", "wait": 0.1, "announces_begin": True}
    ]
    assert office.finished == [
        {
            "job": "job-1",
            "epoch": 3,
            "outcome": "done",
            "why": "",
            "line": 11,
            "line_at_most": 11,
            "copies_done": 1,
            "position": None,
            "station": None,
        }
    ]
    lines = [beat["line"] for beat in office.beats]
    assert lines[-1] > 0
    assert lines == sorted(lines)
    assert all(beat["epoch"] == 3 and not beat["held"] for beat in office.beats)
    assert all(headers["X-Knifetip"] == "gateway" for headers in office.headers)


@pytest.mark.parametrize(("sha256", "outcome"), [(None, "done"), ("0" * 64, "refused")])
async def test_the_end_of_a_run_is_counted_once(sha256: str | None, outcome: str) -> None:
    runs: list[tuple[str, float]] = []
    office = Office(sha256=sha256)
    async with table() as server:
        await gateway(office, server, observe=lambda *run: runs.append(run))
    assert [run[0] for run in runs] == [office.finished[0]["outcome"]] == [outcome]
    assert 0.0 < runs[0][1] < 20.0


async def test_positions_are_those_of_the_head_on_the_sheet() -> None:
    office = Office()
    async with table(speed=5.0) as server:
        await gateway(office, server)
    cutting = [beat["position"] for beat in office.beats if beat["line"] == 6]
    assert cutting
    for x, y, z, c in cutting:
        # 160 … 560 and -1.0 in the program are 100 … 500 and 0.5 without the wheel's datum.
        assert 100.0 <= x <= 500.0
        # At the end of the plunge the report may deviate by its rounding.
        assert (y, z, c) == pytest.approx((100.0, 0.5, 0.0), abs=0.005)


async def test_another_program_than_the_verified_one_never_reaches_the_machine() -> None:
    office = Office(sha256="0" * 64)
    async with table() as server:
        await gateway(office, server)
        assert server.table.time == 0.0
    assert office.finished[0]["outcome"] == "refused"
    assert (office.finished[0]["line"], office.finished[0]["line_at_most"]) == (0, 0)
    assert "SHA-256" in office.finished[0]["why"]["text"]


async def test_between_two_copies_it_waits_as_held_for_a_new_sheet() -> None:
    office = Office(copies=2)
    waits = []

    def command(beat: Beat) -> str:
        if beat["copies_done"] == 1 and beat["held"]:
            waits.append(beat)
            return "resume" if len(waits) == 5 else "continue"
        return "continue"

    office.command = command
    async with table() as server:
        await gateway(office, server)
        assert [event.output for event in server.table.switch_events if event.on] == [1, 1]
    assert len(waits) >= 5
    assert all(beat["line"] == 11 for beat in waits)
    assert office.finished[0]["outcome"] == "done"


def released(table: Table) -> bool:
    """Return whether station 2 was lowered and raised again."""
    return [event.on for event in table.switch_events if event.output == 1][-2:] == [True, False]


async def test_a_resume_that_comes_late_does_not_start_the_next_copy() -> None:
    office = Office(copies=2)
    # Sends resume in every response except to held jobs, and cancel at the end.
    held = []

    def command(beat: Beat) -> str:
        if beat["held"]:
            held.append(beat)
            return "cancel" if len(held) == 5 else "continue"
        return "resume"

    office.command = command
    begun: list[Beat] = []
    async with table() as server:

        async def delayed(beat: Beat) -> None:
            # The program begins when its announcement is answered.
            while not beat["held"] and begun and not released(server.table):
                await asyncio.sleep(0.005)
            begun.extend([beat] if beat["begun"] else [])
            await asyncio.sleep(0.1 if not beat["held"] else 0.0)

        office.delayed = delayed
        await gateway(office, server)
        assert [event.output for event in server.table.switch_events if event.on] == [1]
    assert office.finished[0]["outcome"] == "cancelled"


def test_an_answer_to_a_report_of_an_earlier_phase_does_not_resume() -> None:
    run = JobRun(Lease("job-1", 3, 5.0, "", "", 2, confirm=False), 0.0)
    run.begin_phase()
    run.held = True
    before = run.heartbeat()
    run.begin_phase()  # the program is handed over while the server answers
    run.apply_answer("resume", held=bool(before["held"]), phase=run.phase - 1)
    assert run.requested == ""
    run.apply_answer("resume", held=True, phase=run.phase)
    assert run.requested == "resume"
    run.begin_phase()
    assert run.requested == ""


async def test_hold_stops_the_machine_in_mid_line_and_resume_goes_on() -> None:
    office = Office()
    held = []

    def command(beat: Beat) -> str:
        if beat["held"]:
            held.append(beat["position"])
            return "resume" if len(held) > 25 else "continue"
        return "hold" if beat["line"] == 6 and not held else "continue"

    office.command = command
    async with table(speed=2.0) as server:
        await gateway(office, server)
        assert server.table.position[0] == 560.0
    assert 100.0 < held[-1][0] < 500.0
    # The machine brakes for 0.06 s of its own time and then is at rest.
    assert held[20:25] == [held[20]] * 5
    assert office.finished[0]["outcome"] == "done"


async def test_an_open_door_holds_the_job_and_closing_it_does_not_resume() -> None:
    office = Office()
    held: list[Beat] = []

    async with table(speed=2.0) as server:

        def command(beat: Beat) -> str:
            if beat["line"] == 6 and not held:
                server.table.open_door()
            if not beat["held"]:
                return "continue"
            held.append(beat)
            if len(held) == 60:
                server.table.close_door()
            # The first request to resume comes while the door is open.
            return "resume" if len(held) == 30 or len(held) > 90 else "continue"

        office.command = command
        await gateway(office, server)
        assert server.table.position[0] == 560.0
    assert office.finished[0]["outcome"] == "done"
    # The machine braked and then stood still until it was resumed with its door closed.
    assert 100.0 < held[20]["position"][0] < 500.0
    assert [beat["position"] for beat in held[20:90]] == [held[20]["position"]] * 70


async def test_cancel_stops_the_machine_raises_the_tool_and_is_reported() -> None:
    office = Office()
    office.command = lambda beat: "cancel" if beat["line"] == 6 else "continue"
    async with table(speed=2.0) as server:
        await gateway(office, server)
        x, _, z, _ = server.table.position
        assert 160.0 < x < 560.0
        assert z == 20.0
        assert server.table.state == "Idle"
        assert server.table.outputs == {0: False, 1: False, 2: False}
    (report,) = office.finished
    assert report["outcome"] == "cancelled"
    assert "line 6" in report["why"]["text"]
    # The place is that of the head at rest, at the height before the lift, in the crease.
    assert report["station"] == 2
    assert report["position"] == pytest.approx([x - 60.0, 100.0, 0.5, 0.0], abs=2e-3)


async def test_a_job_that_is_no_longer_ours_stops_the_machine_and_is_reported_with_its_line() -> (
    None
):
    office = Office()

    def command(beat: Beat) -> str:
        office.stale = beat["line"] == 6
        return "continue"

    office.command = command
    async with table(speed=2.0) as server:
        await gateway(office, server)
        assert 160.0 < server.table.position[0] < 560.0
        assert server.table.position[2] == 20.0
    # The server accepts the report while the job is interrupted, and refuses it otherwise.
    (report,) = office.finished
    assert (report["outcome"], report["line"], report["epoch"]) == ("interrupted", 6, 3)
    assert "the machine was stopped" in report["why"]["text"]


async def test_without_the_server_the_machine_goes_on_for_the_lease_and_then_holds() -> None:
    # Longer than a pause of a busy computer, which would end the lease before the cut.
    office = Office(lease=0.5)

    def command(beat: Beat) -> str:
        office.reachable = beat["line"] != 6
        return "continue"

    office.command = command
    async with table(speed=0.5) as server:
        working = asyncio.create_task(gateway(office, server))
        async with asyncio.timeout(120.0):
            while server.table.state != "Hold:0":
                await asyncio.sleep(0.01)
        x = server.table.position[0]
        assert 160.0 < x < 560.0
        # Once the server is reachable again, the gateway reports held and waits.
        beats = len(office.beats)
        office.command = lambda beat: "continue"
        office.reachable = True
        while len(office.beats) < beats + 10:
            await asyncio.sleep(0.01)
        assert office.beats[-1]["held"]
        assert server.table.position[0] == x
        office.command = lambda beat: "resume" if beat["held"] else "continue"
        server.table.speed = 20.0
        await working
        assert server.table.position[0] == 560.0
    assert office.finished[0]["outcome"] == "done"


async def test_a_failure_of_the_controller_interrupts_with_its_words() -> None:
    office = Office()
    async with table(faults=Faults(disconnect=11)) as server:
        await gateway(office, server)
    assert office.finished[0]["outcome"] == "interrupted"
    assert "is lost" in office.finished[0]["why"]["text"]


async def test_a_table_that_is_switched_off_takes_no_job() -> None:
    office = Office()
    calls = []

    async with table() as server:

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            calls.append(len(office.claims))
            if len(calls) < 3:
                raise ConnectionLost("controller.unreachable", address="wire", reason="off")
            return await driver.dial(server.address, safe, silence=0.5, poll=0.02)

        await gateway(office, server, connect=connect)
    assert calls == [0, 0, 0]
    assert office.finished[0]["outcome"] == "done"


async def test_the_end_is_reported_until_the_server_has_received_it() -> None:
    office = Office()
    office.deaf = 2
    async with table(speed=100.0) as server:
        await gateway(office, server)
    assert len(office.finished) == 1


async def test_switching_the_gateway_off_stops_the_machine_and_is_reported() -> None:
    office = Office()
    async with table(speed=0.5) as server:
        working = asyncio.create_task(gateway(office, server))
        async with asyncio.timeout(120.0):
            while not (office.beats and office.beats[-1]["line"] == 6):
                await asyncio.sleep(0.01)
        server.table.speed = 20.0
        working.cancel()
        with pytest.raises(asyncio.CancelledError):
            await working
        assert server.table.state == "Idle"
        assert server.table.position[2] == 20.0
        assert server.table.position[0] < 560.0
    assert office.finished[0]["outcome"] == "interrupted"
    assert "sends jobs to the machine) was stopped" in office.finished[0]["why"]["text"]
    assert office.finished[0]["line"] == 6


async def test_the_journal_has_every_step_and_an_end(tmp_path: Path) -> None:
    office = Office()
    path = tmp_path / "journal"
    async with table() as server:
        await gateway(office, server, journal=path)
    rows = [json.loads(row) for row in path.read_text().splitlines()]
    assert rows[0]["event"] == "begin"
    assert rows[-1]["event"] == "end"
    executed = [row["executed"] for row in rows if row["event"] == "line"]
    assert executed == sorted(executed)
    assert executed[-1] == 11


async def test_a_job_ended_by_a_power_failure_is_reported_at_the_next_start(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, "00", 40)
    journal.line("job-0", 0, 17, 20)
    office = Office()
    async with table(speed=100.0) as server:
        await gateway(office, server, journal=path)
    first, second = office.finished
    assert (first["job"], first["epoch"], first["outcome"]) == ("job-0", 9, "interrupted")
    assert (first["line"], first["copies_done"]) == (17, 0)
    assert second["outcome"] == "done"
    assert journal.unfinished() is None


async def test_a_gateway_killed_while_it_stopped_the_machine_stops_it_at_the_next_start(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, "00", 40)
    # The end was already reported to the server; the controller was held and got nothing else.
    journal.end("job-0", 9, "interrupted", None)
    office = Office()
    async with table() as server:
        host, _, port = server.address.rpartition(":")
        _, writer = await asyncio.open_connection(host, int(port))
        async with asyncio.timeout(120.0):
            writer.write(b"M64 P0\nG1 X500 F600\n")
            while not (server.table.state == "Run" and server.table.outputs.get(0)):
                await asyncio.sleep(0.01)
            writer.write(b"!")
            while not server.table.state.startswith("Hold"):
                await asyncio.sleep(0.01)
            writer.close()
        await gateway(office, server, journal=path)
        assert not any(server.table.outputs.values())
    assert office.finished[0]["outcome"] == "done"


async def test_a_journal_that_cannot_be_written_does_not_interrupt_the_cut(tmp_path: Path) -> None:
    path = tmp_path / "journal"

    def command(beat: Beat) -> str:
        if beat["line"] and not path.is_dir():
            path.unlink()
            path.mkdir()
        return "continue"

    office = Office()
    office.command = command
    async with table(speed=2.0) as server:
        await gateway(office, server, journal=path)
    assert path.is_dir()
    assert [end["outcome"] for end in office.finished] == ["done"]


# Start by the operator


async def test_nothing_is_sent_to_the_machine_before_the_start() -> None:
    office = Office(confirm=True)
    waits = []
    async with table() as server:

        def command(beat: Beat) -> str:
            if not beat["waiting"]:
                return "continue"
            waits.append(server.table.time)
            return "start" if len(waits) == 20 else "wait"

        office.command = command
        await gateway(office, server)
    assert waits == [0.0] * 20
    assert [beat["waiting"] for beat in office.beats[:21]] == [True] * 20 + [False]
    assert office.finished[0]["outcome"] == "done"


async def test_a_job_that_is_withdrawn_while_it_waits_never_moves_the_machine() -> None:
    office = Office(confirm=True)

    def command(beat: Beat) -> str:
        office.stale = len(office.beats) == 5
        return "wait"

    office.command = command
    async with table() as server:
        await gateway(office, server)
        assert server.table.time == 0.0
    assert len(office.beats) == 6
    assert "Nothing was sent" in office.finished[0]["why"]["text"]
    assert office.finished[0]["line"] == 0


async def test_a_table_that_is_jogged_gives_a_waiting_job_back(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = Office(confirm=True)
    office.command = lambda _: "wait" if len(office.beats) < 500 else "start"
    async with table() as server:

        async def connect(safe: SafeState, stop_motion: bool) -> Controller:
            controller = await driver.dial(
                server.address, safe, stop_motion=stop_motion, silence=0.5, poll=0.02
            )
            true_status = controller.status

            async def status() -> Status:
                jogged = len(office.beats) >= 5
                found = await true_status()
                return replace(found, state=State.JOG) if jogged else found

            monkeypatch.setattr(controller, "status", status)
            return controller

        await gateway(office, server, connect=connect)
        assert server.table.time == 0.0
    (report,) = office.finished
    assert (report["outcome"], report["line"]) == ("returned", 0)
    assert "not idle: it reports the state jog" in report["why"]["text"]


async def test_a_controller_that_fails_while_a_job_waits_gives_it_back() -> None:
    office = Office(confirm=True)
    async with table() as server:

        def command(_: Beat) -> str:
            if len(office.beats) == 5:
                server.table.receive(b"\x18")
            return "wait" if len(office.beats) < 500 else "start"

        office.command = command
        await gateway(office, server)
        assert server.table.time == 0.0
    (report,) = office.finished
    assert (report["outcome"], report["line"]) == ("returned", 0)
    assert "was reset" in report["why"]["text"]


async def test_a_gateway_that_is_switched_off_while_it_waits_gives_its_claim_back() -> None:
    office = Office(confirm=True)
    office.command = lambda _: "wait"
    async with table() as server:
        working = asyncio.create_task(gateway(office, server))
        async with asyncio.timeout(120.0):
            while len(office.beats) < 3:
                await asyncio.sleep(0.01)
        working.cancel()
        with pytest.raises(asyncio.CancelledError):
            await working
        assert server.table.time == 0.0
    assert office.finished[0]["outcome"] == "returned"


async def test_a_program_that_the_check_run_refuses_is_returned_with_the_reason() -> None:
    office = Office(PROGRAM.replace(b"G4 P0.15", b"G5 P0.15"))
    async with table() as server:
        await gateway(office, server)
        assert server.table.position[:2] == (0.0, 0.0)
    (end,) = office.finished
    assert (end["outcome"], end["line"], end["line_at_most"]) == ("refused", 0, 0)
    assert end["why"]["code"] == "controller.rejected-in-check"


async def test_a_program_that_leaves_the_travel_is_refused_and_unlocks_the_machine() -> None:
    office = Office(PROGRAM.replace(b"X560.0000", b"X9560.0000"))
    async with table() as server:
        await gateway(office, server)
        assert server.table.state == "Idle"
    assert [end["outcome"] for end in office.finished] == ["refused"]


class CheckRun:
    """Connects to a simulated table, whose check run does what a test says."""

    def __init__(
        self, server: simulator.Server, act: Callable[[driver.Grbl], Awaitable[None]]
    ) -> None:
        self._server = server
        self._act = act

    async def __call__(self, safe: SafeState, stop_motion: bool) -> Controller:
        controller = await driver.dial(
            self._server.address, safe, stop_motion=stop_motion, silence=0.5, poll=0.02
        )
        act = self._act

        async def check(lines: object) -> None:
            await act(controller)

        controller.check = check  # type: ignore[method-assign]  # of this object only
        return controller


@pytest.mark.parametrize(
    ("failure", "code"), [("reset", "controller.reset"), ("lost", "controller.lost")]
)
async def test_a_failure_before_the_first_line_returns_the_job_with_the_reason(
    failure: str, code: str
) -> None:
    office = Office()
    async with table() as server:

        async def fail(controller: driver.Grbl) -> None:
            if failure == "reset":
                server.table.receive(b"\x18")
            else:
                await controller._connection._transport.close()
            await asyncio.sleep(5.0)

        await gateway(office, server, connect=CheckRun(server, fail))
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["line"], end["line_at_most"]) == ("returned", 0, 0)
    assert end["why"]["arguments"]["error"]["code"] == code


async def test_a_controller_that_is_gone_before_the_program_starts_returns_the_job() -> None:
    class Resetting(Office):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            if request.url.path == self.claim["program"]:
                server.table.receive(b"\x18")
                await asyncio.sleep(0.1)
            return await super().__call__(request)

    office, dials = Resetting(), 0

    async def connect(safe: SafeState, stop_motion: bool) -> Controller:
        nonlocal dials
        dials += 1
        if dials == 2:
            raise ConnectionLost("controller.unreachable", address="wire", reason="off")
        return await driver.dial(server.address, safe, silence=0.5, poll=0.02)

    async with table() as server:
        await gateway(office, server, connect=connect)
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["line"]) == ("returned", 0)
    assert end["why"]["code"] == "controller.unreachable"


async def test_a_gateway_that_is_switched_off_in_the_check_run_gives_the_job_back() -> None:
    office = Office()
    async with table() as server:
        checks = asyncio.Event()

        async def wait(_: driver.Grbl) -> None:
            checks.set()
            await asyncio.sleep(5.0)

        working = asyncio.create_task(gateway(office, server, connect=CheckRun(server, wait)))
        async with asyncio.timeout(120.0):
            await checks.wait()
        working.cancel()
        with pytest.raises(asyncio.CancelledError):
            await working
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["why"]["code"]) == ("returned", "gateway.switched-off")


async def test_the_first_line_waits_until_the_server_knows_that_it_begins(tmp_path: Path) -> None:
    office = Office()
    path = tmp_path / "journal"
    async with table() as server:
        before: list[tuple[float, bool]] = []

        async def delayed(beat: Beat) -> None:
            if beat["begun"] and not before:
                await asyncio.sleep(0.1)
                left = Journal(path).unfinished()
                before.append((server.table.time, left is not None and left.copy_begun))

        office.delayed = delayed
        await gateway(office, server, journal=path)
    # Neither has the machine moved until then, nor is the begin in the journal.
    assert before == [(0.0, False)]
    assert office.finished[0]["outcome"] == "done"


async def test_a_server_that_is_silent_until_the_lease_ends_gets_the_job_back_unbegun() -> None:
    office = Office(lease=0.5)
    async with table() as server:

        async def silent(beat: Beat) -> None:
            if beat["begun"]:
                await asyncio.sleep(1.0)  # more than the gateway waits for an answer

        office.delayed = silent
        await gateway(office, server)
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["line"], end["line_at_most"]) == ("returned", 0, 0)
    assert end["why"]["code"] == "gateway.server-silent-before-start"


async def test_a_job_that_is_withdrawn_in_its_check_run_is_returned() -> None:
    office = Office()
    async with table() as server:

        async def withdraw(_: driver.Grbl) -> None:
            office.stale = True

        await gateway(office, server, connect=CheckRun(server, withdraw))
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["why"]["code"]) == (
        "returned",
        "gateway.job-withdrawn-before-start",
    )


async def test_a_job_whose_begin_cannot_be_recorded_is_not_begun(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(journal: Journal, job: str, copy: int = 0) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Journal, "begin_copy", full)
    office = Office()
    async with table() as server:
        await gateway(office, server, journal=tmp_path / "journal")
        assert server.table.time == 0.0
    (end,) = office.finished
    assert (end["outcome"], end["why"]["code"]) == ("refused", "gateway.system-error")


async def test_a_failure_after_the_first_line_was_sent_interrupts_the_job() -> None:
    office = Office()
    async with table(faults=Faults(errors={TAKEOVER + 1: 20})) as server:
        await gateway(office, server)
    (end,) = office.finished
    assert (end["outcome"], end["line"]) == ("interrupted", 0)


# Reports from the journal


async def test_a_job_that_was_cut_to_its_end_is_reported_done_at_the_next_start(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, "00", 40, copies=2)
    journal.record_copy("job-0", 1)
    journal.line("job-0", 1, 40, 40)
    journal.record_copy("job-0", 2)
    office = Office()
    office.deaf = 2
    async with table(speed=100.0) as server:
        await gateway(office, server, journal=path)
    first, second = office.finished
    assert (first["job"], first["epoch"], first["outcome"]) == ("job-0", 9, "done")
    assert second["job"] == "job-1"


async def test_a_job_of_which_a_copy_is_missing_is_not_reported_done(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, "00", 40, copies=2)
    journal.line("job-0", 0, 40, 40)
    journal.record_copy("job-0", 1)
    office = Office()
    async with table(speed=100.0) as server:
        await gateway(office, server, journal=path)
    first = office.finished[0]
    assert (first["outcome"], first["line"], first["copies_done"]) == ("interrupted", 0, 1)


async def test_an_outcome_that_was_not_heard_is_reported_in_its_own_words(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("job-0", 9, "00", 40)
    journal.line("job-0", 0, 17, 20)
    journal.record_outcome("job-0", "interrupted", stored("A belt tore."))
    office = Office()
    async with table(speed=100.0) as server:
        await gateway(office, server, journal=path)
    first = office.finished[0]
    assert (first["outcome"], first["why"]["text"], first["line"]) == (
        "interrupted",
        "A belt tore.",
        17,
    )


async def test_the_journal_records_each_copy_and_the_outcome_before_the_report(
    tmp_path: Path,
) -> None:
    office = Office(copies=2)
    office.command = lambda beat: "resume" if beat["held"] else "continue"
    path = tmp_path / "journal"
    async with table() as server:
        await gateway(office, server, journal=path)
    rows = [json.loads(row) for row in path.read_text().splitlines()]
    steps = [row["event"] for row in rows if row["event"] != "line"]
    assert steps == ["begin", *["copy-begin", "copy"] * 2, "outcome", "end"]
    assert rows[0]["copies"] == 2


async def test_a_withdrawal_after_the_last_line_does_not_make_a_finished_cut_interrupted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = Office()

    async def stream(*_args: object, **_options: object) -> AsyncIterator[Progress]:
        at = (0.0,) * 4
        yield Progress(5, 11, 11, at, State.RUN, -1, 1.0)
        office.stale = True
        beats = len(office.beats)
        while len(office.beats) == beats:
            await asyncio.sleep(0.01)
        await asyncio.sleep(0.05)
        yield Progress(11, 11, 11, at, State.IDLE, -1, 0.0)

    monkeypatch.setattr("knifetip.gateway.copy_runner.stream", stream)
    async with table() as server:
        await gateway(office, server)
    assert office.beats[-1]["line"] == 5
    assert office.finished[0]["outcome"] == "done"


async def test_a_gateway_whose_machine_has_changed_ends_so_that_it_can_be_loaded_again() -> None:
    class Changed(Office):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            if request.url.path == "/api/gateway/claim":
                return httpx.Response(412, json={"title": "stale"})
            return await super().__call__(request)

    async with table() as server:
        with pytest.raises(StaleVersion) as changed:
            await gateway(Changed(), server, machine=replace(MACHINE, version=3))
        assert changed.value.message.arguments["version"] == 3
        assert server.table.position == (0.0, 0.0, 20.0, 0.0)


# A server that refuses the key of the gateway


@pytest.mark.parametrize("status", [401, 403])
async def test_a_gateway_whose_key_is_refused_ends_with_the_reason(status: int) -> None:
    class Closed(Office):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            return httpx.Response(status, json={"detail": "The scope gateway is missing."})

    async with table() as server:
        with pytest.raises(GatewayRefused) as refused:
            await gateway(Closed(), server)
    assert refused.value.message.arguments["reason"] == "The scope gateway is missing."
    assert "--scope gateway" in refused.value.hint


async def test_a_gateway_that_is_refused_does_not_wait_for_its_controller() -> None:
    office = Office()
    office.refuses = True

    async def switched_off(safe: SafeState, stop_motion: bool) -> Controller:
        raise ConnectionRefusedError("the table is switched off")

    async with table() as server:
        with pytest.raises(GatewayRefused):
            await gateway(office, server, connect=switched_off)


async def test_a_key_that_is_revoked_in_a_cut_brings_the_machine_to_safety_after_the_lease(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    office = Office(lease=0.5)

    def command(beat: Beat) -> str:
        office.refuses = beat["line"] == 6
        return "continue"

    office.command = command
    async with table(speed=0.5) as server:
        with pytest.raises(GatewayRefused):
            await gateway(office, server, journal=path)
        assert server.table.state == "Idle"
        assert server.table.position[2] == 20.0
        assert 160.0 < server.table.position[0] < 560.0
        assert not any(server.table.outputs.values())
    # The end is not lost: the next gateway with a valid key reports it.
    unfinished = Journal(path).unfinished()
    assert unfinished is not None
    assert (unfinished.job, unfinished.outcome, unfinished.line) == ("job-1", "interrupted", 6)
    assert unfinished.cause is not None
    assert unfinished.cause.code == "gateway.access-refused"
    later = Office()
    async with table(speed=100.0) as server:
        await gateway(later, server, journal=path)
    assert [one["outcome"] for one in later.finished] == ["interrupted", "done"]


async def test_a_key_that_is_refused_for_less_than_the_lease_does_not_stop_the_machine() -> None:
    office = Office(lease=30.0)
    answered = office.__call__
    refused = 0

    class Flickering(Office):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            nonlocal refused
            if request.url.path.endswith("heartbeat") and refused < 5:
                refused += 1
                return httpx.Response(401)
            return await answered(request)

    async with table(speed=2.0) as server:
        await gateway(Flickering(), server)
        assert server.table.position[0] == 560.0
    assert refused == 5
    assert office.finished[0]["outcome"] == "done"


async def test_a_cut_that_ends_while_the_key_is_refused_is_reported_done_later(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    office = Office(lease=30.0)

    def command(beat: Beat) -> str:
        office.refuses = beat["line"] == 6
        return "continue"

    office.command = command
    async with table(speed=10.0) as server:
        with pytest.raises(GatewayRefused):
            await gateway(office, server, journal=path)
        assert server.table.position[0] == 560.0
    later = Office()
    async with table(speed=100.0) as server:
        await gateway(later, server, journal=path)
    assert [one["outcome"] for one in later.finished] == ["done", "done"]


async def test_between_two_copies_a_refused_gateway_does_not_wait_for_ever(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    office = Office(lease=0.5, copies=2)

    def command(beat: Beat) -> str:
        office.refuses = beat["copies_done"] == 1
        return "continue"

    office.command = command
    async with table(speed=50.0) as server:
        with pytest.raises(GatewayRefused):
            await gateway(office, server, journal=path)
    unfinished = Journal(path).unfinished()
    assert unfinished is not None
    assert (unfinished.outcome, unfinished.copies_done) == ("interrupted", 1)


async def test_a_job_that_waits_for_its_start_is_left_when_the_key_is_refused() -> None:
    office = Office(lease=0.1, confirm=True)

    def command(beat: Beat) -> str:
        office.refuses = True
        return "wait"

    office.command = command
    async with table() as server:
        with pytest.raises(GatewayRefused):
            await gateway(office, server)
        assert server.table.position == (0.0, 0.0, 20.0, 0.0)


async def test_a_machine_that_may_still_move_is_stopped_before_a_refused_gateway_ends(
    tmp_path: Path,
) -> None:
    path = tmp_path / "journal"
    Journal(path).begin("job-0", 9, "00", 40)
    office = Office()
    office.refuses = True
    attempts = 0
    async with table() as server:

        async def second_time(safe: SafeState, stop_motion: bool) -> Controller:
            nonlocal attempts
            attempts += 1
            if attempts == 1:
                raise ConnectionRefusedError("the table is switched off")
            assert stop_motion
            return await driver.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        host, _, port = server.address.rpartition(":")
        _, writer = await asyncio.open_connection(host, int(port))
        async with asyncio.timeout(120.0):
            writer.write(b"M64 P0\nG1 X500 F600\n")
            while not (server.table.state == "Run" and server.table.outputs.get(0)):
                await asyncio.sleep(0.01)
            writer.close()
        with pytest.raises(GatewayRefused):
            await gateway(office, server, journal=path, connect=second_time)
        assert attempts == 2
        assert not any(server.table.outputs.values())
        assert server.table.position[0] < 500.0
    assert Journal(path).unfinished() is not None


async def test_what_a_person_has_begun_ends_with_a_refused_gateway() -> None:
    office = Office()
    async with table() as server:
        opened: list[Controller] = []

        async def spinning(safe: SafeState, stop_motion: bool) -> Controller:
            controller = await driver.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)
            await controller.switch(0, True)
            opened.append(controller)
            office.refuses = True
            return controller

        with pytest.raises(GatewayRefused):
            await gateway(office, server, connect=spinning)
        assert opened
        assert not any(server.table.outputs.values())
