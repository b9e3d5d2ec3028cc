"""The station of a gateway: what it reports, and which operations reach the machine."""

from __future__ import annotations

import asyncio
import itertools
import json
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.gateway import held_jogs, station
from knifetip.gateway.claim import run_gateway
from knifetip.gateway.controller import Controller, SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.hot_folder import HotFolder
from knifetip.gateway.job_server import GatewaySettings
from knifetip.simulators.grbl import simulator
from knifetip.simulators.grbl.table import BANNER, Table
from tests.support.expiry import EXPIRY
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
        self.watched = True  # a page shows the machine
        self.held = True  # a person holds the button of the last jog
        self.jog = ""  # id of the last jog
        self._ids = itertools.count(1)

    def ask(self, age: float = 0.0, **operation: Any) -> str:
        id = f"op-{next(self._ids)}"
        self.asked.append({**operation, "id": id, "age": age})
        if operation["operation"] == "jog":
            self.jog = id
        return id

    async def result(self, id: str) -> dict[str, Any]:
        while id not in self.results:
            await asyncio.sleep(0.01)
        return self.results[id]

    def notices(self) -> list[dict[str, Any]]:
        """Return the notices of the last report."""
        return self.reports[-1]["notices"] if self.reports else []

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
            answer = {"operations": operations, "waited": 0.0, "watched": self.watched}
            if self.held and self.jog:
                answer["jog"] = {"id": self.jog, "age": 0.0}
            return httpx.Response(200, json=answer)
        if path == "/api/gateway/claim" and not self.jobs:
            await asyncio.sleep(self.claim_seconds)
            return httpx.Response(204)
        return await super().__call__(request)


@asynccontextmanager
async def shop(
    monkeypatch: pytest.MonkeyPatch,
    speed: float = 50.0,
    office: StationOffice | None = None,
    prepare: Callable[[Table], None] = lambda _: None,
    dialled: list[Controller] | None = None,
) -> AsyncIterator[tuple[StationOffice, Table]]:
    """Run a gateway with a simulated table, which is prepared before the gateway connects.

    ``dialled`` gets each controller to which the gateway connects.
    """
    monkeypatch.setattr(station, "WATCHED_INTERVAL", 0.02)
    monkeypatch.setattr(station, "_PAUSE", 0.02)
    office = office or StationOffice()
    async with (
        await simulator.serve(MACHINE, speed=speed) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(120.0),
    ):
        prepare(server.table)

        async def dial(safe: SafeState, stop_motion: bool) -> Controller:
            controller = await driver.dial(
                server.address, safe, stop_motion=stop_motion, silence=5.0, poll=0.02
            )
            if dialled is not None:
                dialled.append(controller)
            return controller

        running = asyncio.create_task(
            run_gateway(
                GatewaySettings("http://office", MACHINE, "table-7", wait=0.1, beat=0.01),
                dial,
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
        asyncio.timeout(120.0),
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
    dialled: list[Controller] = []
    async with shop(monkeypatch, office=office, dialled=dialled) as (_, table):
        await office.report(connected=True, state="idle")
        # As real grblHAL does when the reset button of the machine is pressed.
        table.answer("")
        table.answer(BANNER)
        # An operation that the gateway gets before it has read this is refused.
        while dialled[0].fault is None:
            await asyncio.sleep(0.01)
        assert (await office.result(office.ask(**JOG)))["state"] == "done"
        await office.report(state="idle", position=[120.0, 0.0, 20.0, 0.0])
        assert len(dialled) == 2


async def test_a_late_operation_is_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        late = await office.result(office.ask(age=EXPIRY, **JOG))
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
        jog = office.ask(age=EXPIRY - 0.2, **JOG)
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


LONG: dict[str, Any] = {"operation": "jog", "axis": "X", "distance": 1000.0, "feed": 6000.0}


async def test_a_jog_stops_when_its_button_is_not_stated_as_held(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The server answers on: the page, its network or the person has let go."""
    monkeypatch.setattr(held_jogs, "JOG_RENEWAL", 0.3)
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        assert (await office.result(office.ask(**LONG)))["state"] == "done"
        await office.report(state="jog")
        office.held = False
        await office.report(state="idle")
        stopped = table.position[0]
        assert 0.0 < stopped < 900.0
        # A statement that comes late does not begin the jog again.
        office.held = True
        await asyncio.sleep(0.3)
        assert table.position[0] == stopped


async def test_a_jog_moves_on_while_its_button_is_held_up_to_its_distance(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(held_jogs, "JOG_RENEWAL", 0.3)
    async with shop(monkeypatch, speed=1.0) as (office, _):
        await office.report(connected=True, state="idle")
        assert (await office.result(office.ask(**{**LONG, "distance": 100.0})))["state"] == "done"
        await office.report(state="idle", position=[100.0, 0.0, 20.0, 0.0])


async def test_a_jog_whose_button_was_released_before_it_began_is_dropped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        office.held = False
        assert (await office.result(office.ask(age=1.0, **JOG)))["state"] == "expired"
        assert table.position == (0.0, 0.0, 20.0, 0.0)


async def test_a_dead_gateway_leaves_at_most_a_second_of_a_held_jog(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """At 100 mm/s the controller never has more than 100 mm, and moves on while they are held."""
    monkeypatch.setattr(held_jogs, "JOG_RENEWAL", 60.0)  # the computer may be busy
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        most = 0.0
        assert (await office.result(office.ask(**LONG)))["state"] == "done"
        while table.position[0] < 220.0:
            most = max(most, table.jogs_to[0] - table.position[0])
            await asyncio.sleep(0.01)
        assert 0.0 < most <= 100.5
        # As after kill -9: nothing that the gateway sends arrives any more.
        monkeypatch.setattr(table, "receive", lambda data: None)
        at = table.position[0]
        while table.state != "Idle":
            await asyncio.sleep(0.01)
        assert table.position[0] - at <= 100.5
        monkeypatch.setattr(held_jogs, "JOG_RENEWAL", 0.1)  # how long the end of the test waits


async def test_a_jog_that_was_stopped_at_the_machine_does_not_begin_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The button on the page is still held."""
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        await office.result(office.ask(**LONG))
        await office.report(state="jog")
        table.receive(b"\x85")
        stopped = table.position[0]
        reports = len(office.reports)
        while len(office.reports) < reports + 30:  # longer than the gateway looks for its motion
            await asyncio.sleep(0.01)
        assert table.position[0] == stopped < 900.0


async def test_a_stop_ends_a_jog_whose_button_is_still_stated_as_held(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # As if the stop came just when a piece was executed: rest alone does not end the jog then.
    monkeypatch.setattr(held_jogs, "_AT_END", 2000.0)
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        await office.result(office.ask(**LONG))
        await office.report(state="jog")
        assert (await office.result(office.ask(operation="stop_jog")))["state"] == "done"
        await office.report(state="idle")
        stopped, reports = table.position[0], len(office.reports)
        while len(office.reports) < reports + 30:
            await asyncio.sleep(0.01)
        assert table.position[0] == stopped


async def test_a_gateway_that_ends_stops_the_jog(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch, speed=1.0) as (office, table):
        await office.report(connected=True, state="idle")
        await office.result(office.ask(**LONG))
        await office.report(state="jog")
    assert table.state == "Idle"
    assert 0.0 < table.position[0] < 900.0


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


async def test_outputs_are_not_known_if_the_gateway_starts_in_an_alarm(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def lower_and_trip(table: Table) -> None:
        table.outputs[1] = True  # the last job of an earlier gateway has left it on
        table.trip_limit()

    async with shop(monkeypatch, prepare=lower_and_trip) as (office, table):
        report = await office.report(connected=True, state="alarm")
        assert (report["outputs"], report["outputs_known"]) == ([], False)
        await office.result(office.ask(operation="unlock"))
        await office.report(state="idle", outputs_known=True)
        assert not table.outputs[1]
        # Now it is known that this alarm has left nothing on.
        table.trip_limit()
        assert (await office.report(state="alarm"))["outputs_known"]


async def test_an_alarm_with_an_unlock_that_fails_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        table.trip_limit()
        await office.report(state="alarm")
        late = await office.result(office.ask(age=EXPIRY, operation="unlock"))
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


async def test_the_feed_of_a_running_job_is_changed_within_the_limits_of_the_machine(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        "tests.unit.gateway.test_station.MACHINE", replace(MACHINE, feed_override=(50, 120))
    )
    office = StationOffice(lease=30.0)
    office.jobs = True
    async with shop(monkeypatch, speed=0.2, office=office) as (office, table):
        while not office.beats or office.beats[-1]["line"] < 4:
            await asyncio.sleep(0.01)
        left = office.beats[-1]["seconds_left"]
        done = await office.result(office.ask(operation="feed_override", percent=53))
        assert done["state"] == "done"
        assert table.override == 53
        await office.report(override=53)
        while office.beats[-1]["seconds_left"] <= 1.3 * left:
            await asyncio.sleep(0.01)
        for percent in (49, 121):
            refused = await office.result(office.ask(operation="feed_override", percent=percent))
            assert refused["message"]["code"] == "operation.bad-override"
            assert refused["message"]["arguments"]["low"] == 50
        assert table.override == 53
        late = await office.result(office.ask(age=EXPIRY, operation="feed_override", percent=60))
        assert late["state"] == "expired"


async def test_each_job_begins_with_its_own_feed(monkeypatch: pytest.MonkeyPatch) -> None:
    office = StationOffice(lease=30.0)
    async with shop(monkeypatch, speed=5.0, office=office) as (office, table):
        await office.report(connected=True, state="idle")
        await office.result(office.ask(operation="feed_override", percent=150))
        assert table.override == 150
        office.jobs = True
        while not office.finished:
            await asyncio.sleep(0.01)
        assert table.override == 100
        await office.report(override=100)


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


# A way out of every state


async def test_a_hold_after_the_door_without_a_job_is_released(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with shop(monkeypatch) as (office, table):
        await office.report(connected=True, state="idle")
        table.open_door()
        opened = await office.report(state="door")
        assert opened["obstacle"]["code"] == "obstacle.door-open"
        refused = await office.result(office.ask(operation="release"))
        assert (refused["state"], refused["message"]["code"]) == ("refused", "operation.door-open")
        table.close_door()
        closed = await office.report(state="hold")
        assert closed["obstacle"]["code"] == "obstacle.door-closed"
        refused = await office.result(office.ask(operation="unlock"))
        assert refused["message"]["code"] == "operation.not-locked"
        before = table.position
        done = await office.result(office.ask(operation="release"))
        assert done["state"] == "done"
        free = await office.report(state="idle")
        assert free["obstacle"] is None
        assert table.position == before
        refused = await office.result(office.ask(operation="release"))
        assert refused["message"]["code"] == "operation.nothing-held"


async def run_until_lowered(office: StationOffice) -> None:
    """Wait until the running job has lowered station 2, whose output is 1."""
    while not office.beats or office.beats[-1]["line"] < 6:
        await asyncio.sleep(0.01)
    await office.report(outputs=[1])


async def test_a_cancel_with_an_open_door_ends_the_job_and_reports_the_lowered_station(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    office.jobs = True
    async with shop(monkeypatch, speed=1.0, office=office) as (office, table):
        await run_until_lowered(office)
        table.open_door()
        await office.report(state="door")
        office.jobs, office.command = False, lambda beat: "cancel"
        while not office.finished:
            await asyncio.sleep(0.01)
        end = office.finished[0]
        assert end["outcome"] == "interrupted"
        assert end["why"]["code"] == "controller.door-open"
        # The machine was seen at rest, so nothing after this line can be executed.
        assert end["line_at_most"] == end["line"] > 0
        opened = await office.report(state="door", outputs=[1])
        assert opened["obstacle"]["code"] == "obstacle.door-open"
        assert table.outputs[1]
        before = table.position
        table.close_door()
        await office.report(state="hold", outputs=[1])
        assert table.position == before
        assert (await office.result(office.ask(operation="release")))["state"] == "done"
        await office.report(state="idle", outputs=[])
        assert not table.outputs[1]


async def test_a_station_that_an_alarm_leaves_lowered_is_reported_until_it_is_unlocked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    office.jobs = True
    async with shop(monkeypatch, speed=1.0, office=office) as (office, table):
        await run_until_lowered(office)
        table.trip_limit()
        while not office.finished:
            await asyncio.sleep(0.01)
        office.jobs = False
        await office.report(state="alarm", outputs=[1])
        assert table.outputs[1]
        assert (await office.result(office.ask(operation="unlock")))["state"] == "done"
        await office.report(state="idle", outputs=[])
        assert not table.outputs[1]


async def test_a_gateway_that_finds_its_machine_held_says_so_and_releases_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(station, "WATCHED_INTERVAL", 0.02)
    office = StationOffice()
    async with (
        await simulator.serve(MACHINE, speed=50.0) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(120.0),
    ):
        table = server.table
        table.open_door()
        table.close_door()
        running = asyncio.create_task(
            run_gateway(
                GatewaySettings("http://office", MACHINE, "table-7", wait=0.1, beat=0.01),
                lambda safe, stop_motion: driver.dial(
                    server.address, safe, stop_motion=stop_motion, silence=5.0, poll=0.02
                ),
                client=client,
            )
        )
        try:
            held = await office.report(connected=True, state="hold")
            assert held["obstacle"]["code"] == "obstacle.door-closed"
            done = await office.result(office.ask(operation="release"))
            assert done["state"] == "done"
            await office.report(connected=True, state="idle", obstacle=None)
        finally:
            running.cancel()
            await asyncio.gather(running, return_exceptions=True)


async def test_the_machine_is_reported_as_it_is_before_its_job_is_done(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    at_end: list[dict[str, Any]] = []

    class Recording(StationOffice):
        async def __call__(self, request: httpx.Request) -> httpx.Response:
            if request.url.path == "/api/gateway/finish":
                at_end.append(self.reports[-1])
            return await super().__call__(request)

    office = Recording()
    office.jobs = True
    async with shop(monkeypatch, speed=20.0, office=office) as (_, _table):
        # Reports at the usual intervals would come later.
        monkeypatch.setattr(station, "WATCHED_INTERVAL", 3.0)
        while not at_end:
            await asyncio.sleep(0.01)
    assert (at_end[0]["state"], at_end[0]["outputs"]) == ("idle", [])
    assert at_end[0]["position"][2] == 20.0


async def test_a_machine_with_a_pressed_limit_switch_takes_no_job(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    async with shop(monkeypatch, office=office) as (_, table):
        await office.report(connected=True, state="idle", obstacle=None)
        table.trip_limit()
        await office.report(state="alarm")
        table.pressed = "X"
        done = await office.result(office.ask(operation="unlock"))
        assert done["state"] == "done"
        pressed = await office.report(state="idle", alarm=None)
        assert pressed["obstacle"]["code"] == "obstacle.limit-pressed"
        assert pressed["obstacle"]["text"] == (
            f"A limit switch of {pressed['obstacle']['arguments']['name']} is still pressed (X)."
        )
        office.jobs = True
        for _ in range(5):  # reports, during which the gateway looks for a free machine
            count = len(office.reports)
            while len(office.reports) == count:
                await asyncio.sleep(0.01)
        assert office.claims == []
        table.pressed = ""
        while not office.finished:
            await asyncio.sleep(0.01)
        assert office.finished[0]["outcome"] == "done"


async def test_a_limit_switch_that_stops_nothing_is_a_notice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    office = StationOffice()
    async with shop(monkeypatch, office=office) as (_, table):
        table.settings[21] = "0"  # hard limits off
        table.pressed = "Y"
        while not any(one["code"] == "obstacle.limit-unused" for one in office.notices()):
            await asyncio.sleep(0.01)
        assert (await office.report(state="idle"))["obstacle"] is None
        office.jobs = True
        while not office.finished:
            await asyncio.sleep(0.01)
        assert office.finished[0]["outcome"] == "done"


async def test_a_connection_is_reported_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody looks at the machine, so the next report at the usual interval would come too late."""
    monkeypatch.setattr(station, "IDLE_INTERVAL", 60.0)
    office = StationOffice()
    office.watched = False
    connects = asyncio.Event()
    async with (
        await simulator.serve(MACHINE, speed=50.0) as server,
        httpx.AsyncClient(transport=httpx.MockTransport(office)) as client,
        asyncio.timeout(120.0),
    ):

        async def connect(safe: SafeState, stop_motion: bool) -> driver.Grbl:
            await connects.wait()
            return await driver.dial(server.address, safe, stop_motion=stop_motion, poll=0.02)

        settings = GatewaySettings("http://office", MACHINE, "table-7", wait=0.1, beat=0.01)
        running = asyncio.create_task(run_gateway(settings, connect, client=client))
        assert not (await office.report(connected=False))["connected"]
        connects.set()
        await office.report(connected=True, state="idle")
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
