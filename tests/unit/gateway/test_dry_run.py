"""Dry runs on the simulated table, while a job waits for its operator."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.gateway import station
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.grbl import driver
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.journal import Journal
from knifetip.model.machine import Machine
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import Table
from tests.unit.gateway.test_claim import MACHINE, PROGRAM, Office, gateway
from tests.unit.gateway.test_station import JOG, StationOffice

DRY: dict[str, Any] = {"operation": "dry_run", "share": 1.0}


@asynccontextmanager
async def waiting_job(
    monkeypatch: pytest.MonkeyPatch,
    speed: float = 50.0,
    machine: Machine = MACHINE,
    journal: Path | None = None,
) -> AsyncIterator[tuple[StationOffice, Table]]:
    """Run a gateway with a simulated table whose positions are recorded; its job waits."""
    monkeypatch.setattr(station, "WATCHED_INTERVAL", 0.02)
    monkeypatch.setattr(station, "_PAUSE", 0.02)
    office = StationOffice(confirm=True, lease=30.0)
    office.command = lambda beat: "wait"
    office.jobs = True
    async with (
        await simulator.serve(machine, speed=speed, sample=0.001) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(120.0),
    ):
        running = asyncio.create_task(
            run_gateway(
                GatewaySettings(
                    "http://office", machine, "table-7", journal=journal, wait=0.1, beat=0.01
                ),
                lambda safe, stop_motion: driver.dial(
                    server.address, safe, stop_motion=stop_motion, silence=0.5, poll=0.02
                ),
                client=client,
            )
        )
        try:
            while not office.beats:
                await asyncio.sleep(0.01)
            yield office, server.table
        finally:
            running.cancel()
            await asyncio.gather(running, return_exceptions=True)


async def activity(office: StationOffice, *states: str) -> dict[str, Any]:
    """Wait until the machine reports an activity in one of some states, and return it."""
    while True:
        found: dict[str, Any] | None = office.reports[-1]["activity"] if office.reports else None
        if found is not None and found["state"] in states:
            return found
        await asyncio.sleep(0.01)


def assert_above_board(table: Table) -> None:
    assert table.trace is not None
    samples = table.trace.samples()
    assert len(samples) > 0
    assert samples[:, 3].min() >= 20.0 - 1e-9
    assert not any(event.on for event in table.switch_events)
    assert not table.oscillating


async def test_a_dry_run_stays_above_the_board_and_the_job_keeps_waiting(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        assert (await office.result(office.ask(**DRY)))["state"] == "done"
        done = await activity(office, "done", "failed", "stopped")
        assert (done["kind"], done["job"], done["state"]) == ("dry_run", "job-1", "done")
        assert (done["line"], done["progress"]) == (PROGRAM.count(b"\n"), 1.0)
        assert done["position"][:2] == pytest.approx([500.0, 100.0])
        assert done["station"] == 2
        assert_above_board(table)
        assert table.trace is not None
        assert table.trace.samples()[:, 1].max() == pytest.approx(560.0)
        # Nothing has happened to the job.
        assert office.finished == []
        assert all(beat["waiting"] and beat["line"] == 0 for beat in office.beats)
        assert all(beat["copies_done"] == 0 and not beat["held"] for beat in office.beats)
        office.command = lambda beat: "start" if beat["waiting"] else "continue"
        while not office.finished:
            await asyncio.sleep(0.01)
        assert office.finished[0]["outcome"] == "done"
        assert any(event.on for event in table.switch_events)


async def test_a_dry_run_is_held_resumed_and_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    async with waiting_job(monkeypatch, speed=0.4) as (office, table):
        assert (await office.result(office.ask(**DRY | {"share": 0.5})))["state"] == "done"
        while table.position[0] < 20.0:
            await asyncio.sleep(0.01)
        # While it runs, the machine does nothing else.
        refused = await office.result(office.ask(**JOG))
        assert refused["message"]["code"] == "dry-run.uses-machine"
        assert (await office.result(office.ask(operation="hold")))["state"] == "done"
        held = await activity(office, "held")
        assert 0.0 <= held["progress"] < 1.0
        while table.state != "Hold:0":
            await asyncio.sleep(0.01)
        here = table.position
        await asyncio.sleep(0.2)
        assert table.position == here
        assert (await office.result(office.ask(operation="resume")))["state"] == "done"
        while table.position[0] < here[0] + 5.0:
            await asyncio.sleep(0.01)
        assert (await office.result(office.ask(operation="stop_jog")))["state"] == "done"
        await activity(office, "stopped")
        await office.report(state="idle")
        assert here[0] < table.position[0] < 560.0
        assert table.position[2] == pytest.approx(20.0)
        assert_above_board(table)
        assert office.finished == []
        late = await office.result(office.ask(operation="resume"))
        assert late["message"]["code"] == "dry-run.not-running"


async def test_a_dry_run_that_a_killed_gateway_left_held_is_stopped_at_the_next_start(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    path = tmp_path / "journal"
    async with waiting_job(monkeypatch, speed=0.4, journal=path) as (office, _):
        await office.result(office.ask(**DRY | {"share": 0.5}))
        await office.result(office.ask(operation="hold"))
        await activity(office, "held")
        held = path.read_bytes()
        await office.result(office.ask(operation="stop_jog"))
        await activity(office, "stopped")
        while Journal(path).is_abandoned():
            await asyncio.sleep(0.01)
    path.write_bytes(held)
    next_office = Office()
    async with await simulator.serve(MACHINE, speed=20.0) as server:
        host, _, port = server.address.rpartition(":")
        _, writer = await asyncio.open_connection(host, int(port))
        async with asyncio.timeout(120.0):
            writer.write(b"G1 X500 F600\n")
            while server.table.state != "Run":
                await asyncio.sleep(0.01)
            writer.write(b"!")
            while not server.table.state.startswith("Hold"):
                await asyncio.sleep(0.01)
            writer.close()
        await gateway(next_office, server, journal=path)
    assert [end["outcome"] for end in next_office.finished] == ["done"]


async def test_an_output_that_was_switched_on_by_hand_is_off_in_a_dry_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        await office.result(office.ask(operation="switch", output=1, on=True))
        assert table.outputs[1]
        await office.result(office.ask(**DRY))
        await activity(office, "done")
        assert not any(table.outputs.values())


async def test_a_lowered_head_is_lifted_before_it_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        down: dict[str, Any] = {"operation": "jog", "axis": "Z", "distance": -17.0, "feed": 6000.0}
        await office.result(office.ask(**down))
        await office.report(state="idle", position=[0.0, 0.0, 3.0, 0.0])
        await office.result(office.ask(**DRY))
        assert (await activity(office, "done", "failed"))["state"] == "done"
        assert table.trace is not None
        moved = table.trace.samples()
        across = moved[(abs(moved[:, 1]) > 1e-9) | (abs(moved[:, 2]) > 1e-9)]
        assert across[:, 3].min() >= 20.0 - 1e-9


@pytest.mark.parametrize("end", ["silent", "cancelled", "started"])
async def test_a_dry_run_stops_without_its_person_and_without_its_job(
    monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    monkeypatch.setattr(station, "EXPIRY", 0.4)
    async with waiting_job(monkeypatch, speed=0.4) as (office, table):
        assert (await office.result(office.ask(**DRY | {"share": 0.2})))["state"] == "done"
        while table.position[0] < 5.0:
            await asyncio.sleep(0.01)
        if end == "silent":
            office.silent = True
        elif end == "cancelled":
            office.command = lambda beat: "cancel"
        else:
            office.command = lambda beat: "start" if beat["waiting"] else "continue"
        while table.state != "Idle":
            await asyncio.sleep(0.01)
        assert table.position[0] < 500.0
        assert_above_board(table)
        if end != "silent":
            while not office.finished:
                await asyncio.sleep(0.01)
            # A start behind a dry run would be a surprise: the job goes back, and nothing was cut.
            expected = {"cancelled": "cancelled", "started": "returned"}[end]
            assert office.finished[0]["outcome"] == expected
            assert office.finished[0]["line"] == 0


async def test_a_frame_goes_round_the_given_box_or_the_work(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        box = [20.0, 30.0, 420.0, 330.0]
        framed: dict[str, Any] = {"operation": "frame", "share": 1.0, "box": box}
        assert (await office.result(office.ask(**framed)))["state"] == "done"
        assert (await activity(office, "done", "failed"))["state"] == "done"
        assert_above_board(table)
        assert table.trace is not None
        x, y = table.trace.samples()[:, 1], table.trace.samples()[:, 2]
        # The crease wheel of the job, whose axis is 60 mm beside the head.
        assert (x.max(), y.max()) == pytest.approx((480.0, 330.0))
        assert table.position[:2] == pytest.approx((80.0, 30.0))
        beyond = framed | {"box": [0.0, 0.0, 1690.0, 100.0]}
        refused = await office.result(office.ask(**beyond))
        assert refused["message"]["code"] == "operation.beyond-travel"


async def test_no_dry_run_without_a_job_that_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    async with waiting_job(monkeypatch) as (office, table):
        office.command = lambda beat: "cancel"
        while not office.finished:
            await asyncio.sleep(0.01)
        await office.report(state="idle")
        refused = await office.result(office.ask(**DRY))
        assert refused["message"]["code"] == "dry-run.no-job"
        assert table.position == (0.0, 0.0, 20.0, 0.0)


async def test_a_fault_of_the_machine_ends_the_dry_run(monkeypatch: pytest.MonkeyPatch) -> None:
    async with waiting_job(monkeypatch, speed=0.4) as (office, table):
        await office.result(office.ask(**DRY | {"share": 0.2}))
        while table.position[0] < 5.0:
            await asyncio.sleep(0.01)
        table.trip_limit()
        failed = await activity(office, "failed", "done", "stopped")
        assert failed["state"] == "failed"
        assert failed["message"]["text"]
        assert (await office.report(state="alarm"))["alarm"] is not None
