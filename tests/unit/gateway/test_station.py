"""The station of a gateway: what it reports, and which operations reach the machine."""

from __future__ import annotations

import asyncio
import itertools
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.gateway import simulator, station
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.hot_folder import HotFolder
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.table import BANNER, Table
from tests.unit.gateway.test_claim import MACHINE, Office

JOG: dict[str, Any] = {"operation": "jog", "axis": "X", "distance": 120.0, "feed": 30000.0}


class StationOffice(Office):
    """A fake server that also takes reports on the machine and answers with operations."""

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self.reports: list[dict[str, Any]] = []
        self.results: dict[str, dict[str, Any]] = {}
        self.asked: list[dict[str, Any]] = []
        self.jobs = False
        self.claim_seconds = 0.02  # time for which a claim without a job waits
        self.silent = False  # reports on the machine are not answered
        self._ids = itertools.count(1)

    def ask(self, age: float = 0.0, **operation: Any) -> str:
        id = f"op-{next(self._ids)}"
        self.asked.append({**operation, "id": id, "age": age})
        return id

    async def result(self, id: str) -> dict[str, Any]:
        while id not in self.results:
            await asyncio.sleep(0.01)
        return self.results[id]

    async def report(self, **wanted: Any) -> dict[str, Any]:
        """Wait for a report with some values, and return it."""
        while not any(
            all(report[name] == value for name, value in wanted.items())
            for report in self.reports[-1:]
        ):
            await asyncio.sleep(0.01)
        return self.reports[-1]

    async def __call__(self, request: httpx.Request) -> httpx.Response:
        path = request.url.path
        if path == "/api/gateway/station":
            if self.silent:
                raise httpx.ConnectError("no route", request=request)
            report = json.loads(request.content)
            self.reports.append(report)
            self.results |= {result["id"]: result for result in report["results"]}
            operations, self.asked = self.asked, []
            answer = {"operations": operations, "waited": 0.0, "watched": True}
            return httpx.Response(200, json=answer)
        if path == "/api/gateway/claim" and not self.jobs:
            await asyncio.sleep(self.claim_seconds)
            return httpx.Response(204)
        return await super().__call__(request)


@asynccontextmanager
async def shop(
    monkeypatch: pytest.MonkeyPatch, speed: float = 50.0, office: StationOffice | None = None
) -> AsyncIterator[tuple[StationOffice, Table]]:
    """Run a gateway with a simulated table."""
    monkeypatch.setattr(station, "WATCHED_INTERVAL", 0.02)
    monkeypatch.setattr(station, "_PAUSE", 0.02)
    office = office or StationOffice()
    async with (
        await simulator.serve(MACHINE, speed=speed) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(20.0),
    ):
        running = asyncio.create_task(
            run_gateway(
                GatewaySettings("http://office", MACHINE, "table-7", wait=0.1, beat=0.01),
                lambda safe, stop_motion: driver.dial(
                    server.address, safe, stop_motion=stop_motion, silence=0.5, poll=0.02
                ),
                client=client,
            )
        )
        try:
            yield office, server.table
        finally:
            running.cancel()
            await asyncio.gather(running, return_exceptions=True)


async def test_the_report_names_state_position_and_operations(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with shop(monkeypatch) as (office, _):
        report = await office.report(connected=True, state="idle")
        assert report["gateway"] == "table-7"
        assert report["machine"] == MACHINE.name
        assert report["position"] == [0.0, 0.0, 20.0, 0.0]
        assert report["alarm"] is None
        assert report["outputs"] == []
        assert "unlock" in report["operations"]


async def test_a_folder_of_any_language_reports_that_it_reports_nothing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(station, "WATCHED_INTERVAL", 0.02)
    office = StationOffice()

    async def connect(safe: SafeState, stop_motion: bool) -> HotFolder:
        del safe, stop_motion
        return HotFolder(tmp_path, MACHINE.name, ".ngc")

    async with (
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(20.0),
    ):
        settings = GatewaySettings("http://office", MACHINE, "table-7", wait=0.1, beat=0.01)
        running = asyncio.create_task(run_gateway(settings, connect, client=client))
        report = await office.report(connected=True)
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
    assert (report["state"], report["position"], report["operations"]) == ("unreported", None, [])


async def test_a_jog_and_an_output_that_a_person_asks_for(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        assert (await office.result(office.ask(**JOG)))["state"] == "done"
        await office.report(state="idle", position=[120.0, 0.0, 20.0, 0.0])
        switched = office.ask(operation="switch", output=2, on=True)
        assert (await office.result(switched))["state"] == "done"
        await office.report(outputs=[2])
        assert table.outputs[2]


async def test_after_a_reset_at_the_machine_an_operation_connects_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    office.claim_seconds = 60.0
    async with shop(monkeypatch, office=office) as (_, table):
        await office.report(connected=True, state="idle")
        # As real grblHAL does when the reset button of the machine is pressed.
        table.answer("")
        table.answer(BANNER)
        assert (await office.result(office.ask(**JOG)))["state"] == "done"
        await office.report(state="idle", position=[120.0, 0.0, 20.0, 0.0])


async def test_a_late_operation_is_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        late = await office.result(office.ask(age=3.0, **JOG))
        assert late["state"] == "expired"
        assert late["message"]["code"] == "operation.expired"
        assert table.position == (0.0, 0.0, 20.0, 0.0)


async def test_an_operation_that_waits_too_long_for_another_is_dropped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Parking holds the machine until Z is lifted; the jog behind it expires meanwhile."""
    async with shop(monkeypatch, speed=0.2) as (office, table):
        await office.report(connected=True, state="idle")
        await office.result(office.ask(operation="jog", axis="Z", distance=-15.0, feed=30000.0))
        await office.report(state="idle", position=[0.0, 0.0, 5.0, 0.0])
        assert table.position[2] == pytest.approx(5.0)
        office.ask(operation="park")
        jog = office.ask(age=2.8, **JOG)
        assert (await office.result(jog))["state"] == "expired"
        assert table.position[0] == 0.0


async def test_a_stop_cancels_the_jog_and_what_waits_behind_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        long: dict[str, Any] = {"operation": "jog", "axis": "X", "distance": 1000.0, "feed": 6000.0}
        assert (await office.result(office.ask(**long)))["state"] == "done"
        await office.report(state="jog")
        assert (await office.result(office.ask(operation="stop_jog")))["state"] == "done"
        await office.report(state="idle")
        assert 0.0 < table.position[0] < 500.0


async def test_a_jog_stops_when_the_server_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(station, "EXPIRY", 0.4)
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        long: dict[str, Any] = {"operation": "jog", "axis": "X", "distance": 1000.0, "feed": 6000.0}
        assert (await office.result(office.ask(**long)))["state"] == "done"
        office.silent = True
        while table.state != "Idle":
            await asyncio.sleep(0.01)
        assert 0.0 < table.position[0] < 500.0


async def test_homing_is_reported_and_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    stopped = asyncio.Event()

    async def home(_: driver.Grbl) -> None:
        await stopped.wait()

    async def stop_jog(_: driver.Grbl) -> None:
        stopped.set()

    monkeypatch.setattr(driver.Grbl, "home", home)
    monkeypatch.setattr(driver.Grbl, "stop_jog", stop_jog)
    async with shop(monkeypatch) as (office, table):
        await office.report(state="idle")
        table.trip_limit()
        await office.report(state="alarm")
        homing = office.ask(operation="home")
        await office.report(state="home", alarm=None)
        assert (await office.result(office.ask(operation="stop_jog")))["state"] == "done"
        await office.result(homing)
        await office.report(state="alarm")


async def test_after_an_alarm_a_person_unlocks_and_the_gateway_claims_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice(confirm=True)
    office.command = lambda beat: "start" if beat["waiting"] else "continue"
    async with shop(monkeypatch, office=office) as (office, table):
        await office.report(connected=True, state="idle")
        table.trip_limit()
        report = await office.report(state="alarm", connected=True)
        assert report["alarm"]["code"] == "controller.in-alarm"
        assert report["alarm"]["arguments"]["code"] == 1
        assert report["alarm"]["hint"]
        jog = await office.result(office.ask(**JOG))
        assert jog["state"] == "refused"
        assert (await office.result(office.ask(operation="unlock")))["state"] == "done"
        await office.report(state="idle", alarm=None)
        assert table.position == (0.0, 0.0, 20.0, 0.0)
        office.jobs = True
        while not office.finished:
            await asyncio.sleep(0.01)
        assert office.finished[0]["outcome"] == "done"


async def test_an_alarm_with_an_unlock_that_fails_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        table.trip_limit()
        await office.report(state="alarm")
        late = await office.result(office.ask(age=3.5, operation="unlock"))
        assert late["state"] == "expired"
        await office.report(state="alarm")
        assert table.state == "Alarm"


async def test_nothing_is_carried_out_while_a_job_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    office = StationOffice(lease=30.0)
    office.jobs = True
    async with shop(monkeypatch, speed=0.2, office=office) as (office, table):
        while not office.beats or office.beats[-1]["line"] < 4:
            await asyncio.sleep(0.01)
        for arguments in (JOG, {"operation": "home"}, {"operation": "stop_jog"}):
            refused = await office.result(office.ask(**arguments))
            assert refused["state"] == "refused"
            assert refused["message"]["code"] == "operation.job-on-machine"
        report = await office.report(outputs=[1])
        assert report["state"] in ("run", "idle")
        assert table.outputs[1]


async def test_a_person_may_jog_while_a_job_waits_for_its_confirmation(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice(confirm=True, lease=30.0)
    office.command = lambda beat: "wait"
    office.jobs = True
    async with shop(monkeypatch, office=office) as (office, _):
        while not office.beats:
            await asyncio.sleep(0.01)
        assert (await office.result(office.ask(**JOG)))["state"] == "done"
        await office.report(state="idle", position=[120.0, 0.0, 20.0, 0.0])
        assert office.finished == []
        office.command = lambda beat: "start" if beat["waiting"] else "continue"
        while not office.finished:
            await asyncio.sleep(0.01)
        assert office.finished[0]["outcome"] == "done"


@pytest.mark.parametrize(
    "broken",
    [
        {"operations": [{"id": "x", "age": -5.0, "operation": "home"}]},
        {"operations": [{"id": "x", "age": float("inf"), "operation": "home"}]},
        {"operations": [{"id": "x", "age": 0.0, "operation": "jump"}]},
        {"operations": [{"id": "x", "operation": "home"}]},
        {},
    ],
)
async def test_a_malformed_answer_moves_nothing(
    monkeypatch: pytest.MonkeyPatch, broken: dict[str, Any]
) -> None:
    class Broken(StationOffice):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            answer = await super().__call__(request)
            if request.url.path == "/api/gateway/station" and len(self.reports) == 2:
                text = json.dumps({"waited": 0.0, "watched": True, **broken})
                return httpx.Response(200, content=text)
            return answer

    async with shop(monkeypatch, office=Broken()) as (office, table):
        while len(office.reports) < 5:
            await asyncio.sleep(0.01)
        assert office.results == {}
        assert table.position == (0.0, 0.0, 20.0, 0.0)
