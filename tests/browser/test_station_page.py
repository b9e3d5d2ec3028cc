"""The person at the table: the station page on a tablet, with touch, on the simulated table.

The table runs in a thread of the test, so that the test can trip its limit switch; the server and
the gateway are processes of their own.
"""

from __future__ import annotations

import asyncio
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

import httpx
import pytest
from playwright.sync_api import Browser, FloatRect, Locator, Page, expect

from knifetip.dxf.samples import samples
from knifetip.library import load
from knifetip.simulators.grbl.simulator import Server, serve
from knifetip.simulators.grbl.table import Table
from tests.browser.accessibility import assert_accessible, record_view
from tests.browser.windows import open_window
from tests.support.serving.server import confirm_job

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("accounts"),
    pytest.mark.timeout(600),
]

MACHINE = "demo-table"
#: Fast enough for a test, slow enough to hold a job.
SPEED = 2.0
#: Sizes of the tablet and its colour scheme.
TABLETS = [(1024, 768, "dark"), pytest.param((820, 1180, "light"), marks=pytest.mark.long)]
#: Height from which the head may move across the board (mm).
LIFT = 20.0
#: Smallest side of what a finger presses (CSS pixels).
FINGER = 44


class SimulatedTable:
    """A simulated table that runs in a thread of its own."""

    def __init__(self) -> None:
        self.loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self.loop.run_forever, daemon=True)
        self._thread.start()
        starting = serve(load.machine(MACHINE), speed=SPEED, sample=0.02)
        self.server: Server = asyncio.run_coroutine_threadsafe(starting, self.loop).result(10)

    @property
    def table(self) -> Table:
        return self.server.table

    def trip_limit(self) -> None:
        """Enter the alarm that a limit switch causes."""
        self.loop.call_soon_threadsafe(self.table.trip_limit)

    def close(self) -> None:
        asyncio.run_coroutine_threadsafe(self.server.close(), self.loop).result(10)
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join(10)
        self.loop.close()


class Workshop(NamedTuple):
    """A server, a gateway and a simulated table."""

    url: str
    table: SimulatedTable
    server: subprocess.Popen[bytes]


def wait_until(is_so: Callable[[], bool], what: str, seconds: float = 120.0) -> None:
    deadline = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < deadline, what
        time.sleep(0.1)


def answers(url: str) -> bool:
    try:
        return httpx.get(url, timeout=2.0, trust_env=False).status_code == 200
    except httpx.HTTPError:
        return False


@pytest.fixture(scope="module")
def workshop(built: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Workshop]:
    folder = tmp_path_factory.mktemp("workshop")
    with socket.socket() as door:
        door.bind(("127.0.0.1", 0))
        port = door.getsockname()[1]
    url = f"http://127.0.0.1:{port}"
    table = SimulatedTable()
    knifetip = [sys.executable, "-m", "knifetip.cli"]
    database = f"sqlite:///{folder / 'station.sqlite'}"
    options = ["--no-simulator", "--no-samples", "--port", str(port), "--database", database]
    gateway = ["gateway", "--server", url, "--machine", MACHINE]
    gateway += ["--controller", f"tcp://{table.server.address}", "--journal", str(folder / "j")]
    with (folder / "log").open("wb") as log:
        server = subprocess.Popen([*knifetip, "serve", *options], stdout=log, stderr=log)
        processes = [server]
        try:
            wait_until(lambda: answers(f"{url}/readyz"), "the server does not answer", 120.0)
            processes.append(subprocess.Popen([*knifetip, *gateway], stdout=log, stderr=log))
            yield Workshop(url, table, server)
        finally:
            for process in reversed(processes):
                end(process)
            table.close()


def end(process: subprocess.Popen[bytes]) -> None:
    process.send_signal(signal.SIGINT)
    try:
        process.wait(20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


@pytest.fixture
def own_machine(workshop: Workshop, api: httpx.Client, tmp_path: Path) -> Iterator[SimulatedTable]:
    """Run a gateway for a machine of a user, a copy of the demo table."""
    fields = api.get(f"/api/machines/{MACHINE}/definition").json()["fields"]
    assert api.put("/api/machines/mine", json=fields | {"title": "My table"}).status_code == 201
    table = SimulatedTable()
    command = [sys.executable, "-m", "knifetip.cli", "gateway", "--server", workshop.url]
    command += ["--machine", "mine", "--controller", f"tcp://{table.server.address}"]
    with (tmp_path / "log").open("wb") as log:
        gateway = subprocess.Popen(
            [*command, "--journal", str(tmp_path / "j")], stdout=log, stderr=log
        )
        try:
            yield table
        finally:
            end(gateway)
            table.close()


@pytest.fixture
def api(workshop: Workshop) -> Iterator[httpx.Client]:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(
        base_url=workshop.url, timeout=60.0, trust_env=False, headers=headers
    ) as client:
        yield client
        # The jobs of a test that has failed do not keep the table from the next one.
        for job in client.get("/api/jobs").json():
            for action in {"cancel", "scrap"}.intersection(job["actions"]):
                client.post(f"/api/jobs/{job['id']}/{action}").raise_for_status()
        table = workshop.table.table
        if table.position[2] < LIFT or any(table.outputs.values()):
            wait_until(lambda: is_homed(client), "the table is not homed after the test", 60.0)


def is_homed(api: httpx.Client) -> bool:
    """Home the table, and return whether it did so."""
    operations = f"/api/machines/{MACHINE}/operations"
    asked = api.post(operations, json={"operation": "home", "hands_clear": True})
    if asked.status_code != 202:
        return False
    operation: dict[str, Any] = asked.json()
    while operation["state"] == "waiting":
        time.sleep(0.1)
        operation = api.get(f"{operations}/{operation['id']}").json()
    return bool(operation["state"] == "done")


@pytest.fixture(params=TABLETS, ids=lambda size: f"{size[0]}x{size[1]}")
def tablet(
    browser: Browser, workshop: Workshop, request: pytest.FixtureRequest
) -> Iterator[tuple[Page, str]]:
    """Open the station page on a tablet; fail if it writes an error to the console."""
    width, height, scheme = request.param
    context = open_window(
        browser, viewport={"width": width, "height": height}, has_touch=True, color_scheme=scheme
    )
    page = context.new_page()
    page.set_default_timeout(90_000)
    expect.set_options(timeout=90_000)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{workshop.url}/#/station/{MACHINE}")
    yield page, f"station-{width}"
    context.close()
    assert errors == []


def send_job(api: httpx.Client, copies: int, machine: str = MACHINE, **others: object) -> str:
    """Send a job of a sample drawing to the machine, and return its id."""
    name = "rigid-box-blank.dxf"
    drawing = api.post("/api/drawings", files={"file": (name, samples()[name])}).json()["id"]
    order = {"drawing": drawing, "machine": machine, "board": "greyboard-2.0", "copies": copies}
    answer = api.post("/api/jobs", json={**order, **others, "release": True})
    assert answer.status_code in (201, 202), answer.text
    job = str(answer.json()["id"])

    def waits() -> bool:
        now = api.get(f"/api/jobs/{job}").json()
        assert now["state"] in ("received", "compiling", "queued"), now
        return bool(now["waiting_for"] == "confirmation")

    wait_until(waits, "the job does not wait for the operator", 120.0)
    return job


def station(api: httpx.Client) -> dict[str, Any]:
    found: dict[str, Any] = api.get(f"/api/machines/{MACHINE}/station").json()
    return found


def assert_done(page: Page, label: str) -> None:
    outcome = page.get_by_test_id("outcome")
    expect(outcome).to_contain_text(f"{label}: done")


def tap_operation(page: Page, *test_ids: str) -> None:
    """Tap the buttons of an operation, again if the operation expired on a busy computer."""
    outcome = page.get_by_test_id("outcome")
    for _ in range(5):
        for test_id in test_ids:
            page.get_by_test_id(test_id).tap()
        expect(outcome).to_have_attribute("data-state", re.compile("^(done|refused|expired)$"))
        if outcome.get_attribute("data-state") != "expired":
            break


def carry_out(page: Page, test_id: str, label: str) -> None:
    """Tap a button of an operation, and wait until the machine has executed it."""
    tap_operation(page, test_id)
    assert_done(page, label)


def state_hands_clear(page: Page) -> None:
    """Press that hands are clear; it counts until the machine has moved.

    A tap beside the button, which moves when the outcome of an operation appears, is repeated, as
    a person would do.  So is one that the page takes back, because it learns late of a motion that
    has ended meanwhile.
    """
    hands = page.get_by_test_id("hands-clear").first
    deadline = time.monotonic() + 120.0
    while hands.get_attribute("aria-pressed") != "true":
        assert time.monotonic() < deadline, "hands are not stated to be clear"
        hands.tap()
        with suppress(AssertionError):
            expect(hands).to_have_attribute("aria-pressed", "true", timeout=5000)


def enable_by_hands(page: Page, target: Locator) -> None:
    """State that hands are clear until a target is enabled by it.

    On a busy computer the page learns late of a motion that has ended meanwhile, and takes the
    statement back with it.  A person then states it again.
    """
    deadline = time.monotonic() + 120.0
    while time.monotonic() < deadline:
        state_hands_clear(page)
        with suppress(AssertionError):
            expect(target).to_be_enabled(timeout=3000)
            return
    expect(target).to_be_enabled()


def set_zero(page: Page) -> None:
    """Set the zero of X and Y here, and answer the question."""
    enable_by_hands(page, page.get_by_test_id("operation-zero"))
    tap_operation(page, "operation-zero", "question-yes")
    assert_done(page, "Set X Y zero here")


def box_of(target: Locator) -> FloatRect:
    box = target.bounding_box()
    assert box is not None
    return box


#: Returns the buttons and links that are smaller than a size. One call measures all of them: the
#: page may replace a button between two calls.
SMALL_TARGETS = """size => [...document.querySelectorAll("button, a, [data-testid=check]")]
    .filter(target => target.checkVisibility({ visibilityProperty: true }))
    .map(target => ({ text: target.innerText, ...target.getBoundingClientRect().toJSON() }))
    .filter(({ width, height }) => width > 0 && Math.min(width, height) < size)
    .map(({ text, width, height }) => `${text}: ${width} x ${height}`)"""


def assert_reachable(page: Page) -> None:
    """Check that all targets are large enough for a finger, and that nothing sticks out."""
    assert page.evaluate(SMALL_TARGETS, FINGER - 0.5) == []
    wide = page.evaluate("document.documentElement.scrollWidth - window.innerWidth")
    assert wide <= 0


def tick_hands(page: Page) -> None:
    """Tick again that hands are clear, after the machine has moved."""
    page.locator("[data-check=table]").tap()
    expect(page.locator("[data-check=table] input")).to_be_checked()


def tick_all(page: Page) -> None:
    start = page.get_by_test_id("station-start")
    expect(page.get_by_test_id("check").first).to_be_visible()
    for check in page.get_by_test_id("check").all():
        expect(start).to_be_disabled()
        check.tap()
    expect(start).to_be_enabled()


def test_a_job_is_confirmed_held_resumed_stopped_and_the_machine_moved_by_touch(
    tablet: tuple[Page, str], workshop: Workshop, api: httpx.Client, screenshots: Path
) -> None:
    page, name = tablet
    state = page.get_by_test_id("station-state")
    expect(state).to_have_text("At rest", timeout=60_000)
    expect(page.get_by_test_id("emergency")).to_contain_text("not an emergency stop")
    expect(page.get_by_test_id("station-stop")).to_be_disabled()

    # Confirm one by one, then start.
    job = send_job(api, copies=2)
    expect(state).to_have_text("Waiting for operator")
    checks = page.get_by_test_id("checks")
    for text in ("Greyboard 2.0 mm", "Oscillating knife", "V-cutter", "X 20, Y 20 mm"):
        expect(checks).to_contain_text(text)
    assert_reachable(page)
    page.wait_for_timeout(800)
    record_view(page, screenshots / f"{name}-1-checks.png")
    tick_all(page)
    record_view(page, screenshots / f"{name}-2-ticked.png")
    page.get_by_test_id("station-start").tap()
    expect(state).to_have_text("Running")
    expect(page.get_by_test_id("station-copy")).to_have_text("copy 1 of 2")
    expect(page.get_by_test_id("station-left")).to_be_visible()

    # The feed is changed in steps, and shown as the controller reports it.
    feed = page.get_by_test_id("feed-override-value")
    expect(feed).to_have_text("100 %")
    expect(page.get_by_test_id("feed-nominal")).to_be_disabled()
    page.get_by_test_id("feed-slower").tap()
    expect(feed).to_have_text("90 %")
    page.get_by_test_id("feed-nominal").tap()
    expect(feed).to_have_text("100 %")

    # While a job runs, nothing else moves the machine, and the page shows the reason.
    page.get_by_test_id("station-hold").tap()
    expect(state).to_have_text("Paused")
    assert_done(page, "Hold")
    page.get_by_test_id("tab-machine").tap()
    expect(page.get_by_test_id("operations-reason")).to_contain_text("A job is held")
    expect(page.get_by_test_id("operation-home")).to_be_disabled()
    expect(page.get_by_test_id("jog-x1")).to_have_attribute("aria-disabled", "true")
    page.get_by_test_id("tab-job").tap()
    record_view(page, screenshots / f"{name}-3-held.png")
    expect(page.get_by_test_id("station-resume")).to_be_disabled()
    page.get_by_test_id("hands-clear").tap()
    page.get_by_test_id("station-resume").tap()
    expect(state).to_have_text("Running")

    # A moving machine is stopped at once, without a question.
    page.get_by_test_id("station-stop").tap()
    wait_until(lambda: api.get(f"/api/jobs/{job}").json()["state"] == "cancelled", "not stopped")
    expect(page.get_by_test_id("station-job")).to_have_attribute("data-state", "cancelled")
    expect(page.get_by_test_id("question-text")).to_be_hidden()
    expect(page.get_by_test_id("after-interruption")).to_contain_text("head stopped")
    page.wait_for_timeout(800)
    record_view(page, screenshots / f"{name}-4-stopped.png")
    wait_until(lambda: station(api)["state"] == "idle", "the machine is not at rest")

    # An alarm, its meaning and the ways out.
    workshop.table.trip_limit()
    alarm = page.get_by_test_id("alarm")
    expect(alarm).to_be_visible()
    expect(state).to_have_text("Alarm")
    assert_reachable(page)
    record_view(page, screenshots / f"{name}-5-alarm.png")
    carry_out(page, "alarm-unlock", "Unlock")
    expect(alarm).to_be_hidden()
    page.get_by_test_id("tab-machine").tap()
    expect(page.get_by_test_id("operation-home")).to_be_disabled()
    state_hands_clear(page)
    carry_out(page, "operation-home", "Home")
    # The statement has ended with the motion.
    expect(page.get_by_test_id("operation-park")).to_be_disabled()

    # At most the chosen distance, and only as long as the finger is down.
    expect(page.get_by_test_id("jog-x1")).to_have_attribute("aria-disabled", "false")
    assert_reachable(page)
    record_view(page, screenshots / f"{name}-6-machine.png")
    expect(page.get_by_test_id("spindle-1")).to_be_disabled()
    state_hands_clear(page)
    carry_out(page, "spindle-1", "Oscillating knife: oscillation on")
    assert workshop.table.table.oscillating
    expect(page.get_by_test_id("spindle-1")).to_have_attribute("aria-checked", "true")
    carry_out(page, "spindle-1", "Oscillating knife: oscillation off")
    assert hold_arrow(page, "jog-x1", workshop, 10.0) == pytest.approx(10.0, abs=0.01)
    page.get_by_test_id("jog-limit-5000").tap()
    assert hold_arrow(page, "jog-y1", workshop, 30.0) < 1000.0
    expect(page.get_by_test_id("outcome")).to_contain_text("Stop Y: done")
    stopped = workshop.table.table.position[1]
    time.sleep(1.0)
    assert workshop.table.table.position[1] == stopped

    state_hands_clear(page)
    carry_out(page, "operation-park", "Park")
    wait_until(lambda: abs(workshop.table.table.position[0]) < 0.01, "the machine is not parked")


@pytest.mark.long
def test_a_waiting_job_is_run_above_the_board_by_touch(
    tablet: tuple[Page, str], workshop: Workshop, api: httpx.Client, screenshots: Path
) -> None:
    page, name = tablet
    state = page.get_by_test_id("station-state")
    expect(state).to_have_text("At rest", timeout=60_000)
    job = send_job(api, copies=1)
    expect(state).to_have_text("Waiting for operator")
    table = workshop.table.table
    assert table.trace is not None
    before, switched = len(table.trace.samples()), len(table.switch_events)
    worn = api.get(f"/api/machines/{MACHINE}/tools").json()
    expect(page.get_by_test_id("operation-frame")).to_be_disabled()
    expect(page.get_by_test_id("operation-dry_run")).to_be_disabled()
    tick_all(page)

    # Hold, resume and stop are the large buttons of a job; its start waits.  The slowest run does
    # not end before it is stopped, however long the page takes.
    page.get_by_test_id("share-10").tap()
    page.get_by_test_id("dry-run").scroll_into_view_if_needed()
    assert_reachable(page)
    record_view(page, screenshots / f"{name}-8-dry-run-offered.png")
    tap_operation(page, "operation-dry_run")
    expect(state).to_have_text("Dry run")
    assert_done(page, "Start dry run")
    expect(page.get_by_test_id("station-start")).to_be_disabled()
    expect(page.get_by_test_id("dry-run-progress")).to_be_visible()
    # The page may show the activity before the next report states it.
    wait_until(lambda: (station(api)["activity"] or {"line": 0})["line"] > 20, "it does not move")
    refused = api.post(f"/api/jobs/{job}/confirm", json={})
    assert refused.json()["code"] == "dry-run.in-progress"
    tap_operation(page, "station-hold")
    expect(state).to_have_text("Dry run paused")
    page.wait_for_timeout(500)
    record_view(page, screenshots / f"{name}-9-dry-run-held.png")
    # Hands may be at the sheet while it is held.
    expect(page.get_by_test_id("station-resume")).to_be_disabled()
    tick_hands(page)
    tap_operation(page, "station-resume")
    expect(state).to_have_text("Dry run")
    tap_operation(page, "station-stop")
    expect(page.get_by_test_id("dry-run-end")).to_contain_text("was stopped")
    expect(state).to_have_text("Waiting for operator")

    expect(page.get_by_test_id("operation-frame")).to_be_disabled()
    tick_hands(page)
    page.get_by_test_id("operation-frame").tap()
    expect(state).to_have_text("Frame")
    expect(page.get_by_test_id("dry-run-end")).to_contain_text("Frame has ended", timeout=60_000)
    page.get_by_test_id("dry-run").scroll_into_view_if_needed()
    record_view(page, screenshots / f"{name}-10-framed.png")

    # Nothing was cut, and nothing counts as cut.
    assert table.trace.samples()[before:, 3].min() >= 20.0 - 1e-9
    events = list(table.switch_events)[switched:]
    assert events
    assert not any(event.on for event in events)
    now = api.get(f"/api/jobs/{job}").json()
    assert (now["state"], now["line"], now["copies_done"]) == ("queued", 0, 0)
    assert api.get(f"/api/machines/{MACHINE}/tools").json() == worn
    expect(page.get_by_test_id("station-start")).to_be_disabled()
    tick_hands(page)
    expect(page.get_by_test_id("station-start")).to_be_enabled()
    api.post(f"/api/jobs/{job}/cancel")
    expect(state).to_have_text("At rest")


@pytest.fixture
def worn_station(api: httpx.Client) -> Iterator[int]:
    """Wear the tool of one station to the end of its life, and return the number of the station."""
    tools = f"/api/machines/{MACHINE}/tools"
    wait_until(lambda: station(api)["state"] == "idle", "the machine is not at rest")
    job = send_job(api, copies=1)

    def used() -> dict[int, float]:
        return {tool["station"]: tool["used"] for tool in api.get(tools).json() if tool["used"]}

    confirm_job(api, job).raise_for_status()
    wait_until(lambda: bool(used()), "no tool has worked")
    api.post(f"/api/jobs/{job}/cancel").raise_for_status()
    wait_until(lambda: api.get(f"/api/jobs/{job}").json()["state"] == "cancelled", "not stopped")
    worn = min(used())
    api.put(f"{tools}/{worn}/life", json={"life": used()[worn] / 2.0}).raise_for_status()
    yield worn
    api.put(f"{tools}/{worn}/life", json={"life": 0.0}).raise_for_status()


@pytest.mark.long
def test_a_tool_at_the_end_of_its_life_is_changed_or_kept_for_a_reason(
    tablet: tuple[Page, str], api: httpx.Client, worn_station: int, screenshots: Path
) -> None:
    page, name = tablet
    start, worn = page.get_by_test_id("station-start"), page.get_by_test_id("worn-tools")
    changed = page.get_by_test_id(f"worn-changed-{worn_station}")
    job = send_job(api, copies=1)
    expect(worn).to_contain_text(f"new tool into station {worn_station}")
    for check in page.get_by_test_id("check").all():
        check.tap()
    expect(start).to_be_disabled()
    assert_reachable(page)
    record_view(page, screenshots / f"{name}-11-worn.png")
    page.get_by_test_id("worn-reason").fill("last sheet")
    expect(start).to_be_enabled()
    page.get_by_test_id("worn-reason").fill("")
    expect(start).to_be_disabled()
    changed.check(force=True)
    expect(page.get_by_test_id("worn-reason")).to_be_hidden()
    record_view(page, screenshots / f"{name}-12-changed.png")
    start.tap()
    wait_until(lambda: api.get(f"/api/jobs/{job}").json()["state"] == "running", "not started")
    tools = api.get(f"/api/machines/{MACHINE}/tools").json()
    assert [tool["warning"] for tool in tools if tool["station"] == worn_station] == [""]
    api.post(f"/api/jobs/{job}/cancel").raise_for_status()
    wait_until(lambda: api.get(f"/api/jobs/{job}").json()["state"] == "cancelled", "not stopped")


def test_a_tool_is_checked_above_a_point_and_its_offset_corrected_by_touch(
    tablet: tuple[Page, str], workshop: Workshop, api: httpx.Client, screenshots: Path
) -> None:
    page, name = tablet
    state = page.get_by_test_id("station-state")
    expect(state).to_have_text("At rest", timeout=60_000)
    job = send_job(api, copies=1)
    expect(state).to_have_text("Waiting for operator")
    page.get_by_test_id("check-tool-3").tap()
    facts = page.get_by_test_id("tool-facts")
    # Jobs of other tests may have worn it already.
    for text in ("V-cutter:", "tilt 45°", "worked along", "X \u221260.00"):
        expect(facts).to_contain_text(text)
    expect(page.get_by_test_id("tool-check-move")).to_be_disabled()
    tick_hands(page)
    tap_operation(page, "tool-check-move")
    expect(page.get_by_test_id("dry-run-progress")).to_be_visible()
    assert_accessible(page)
    table = workshop.table.table
    # Corner of the drawing at 20, 20; 2 mm above 2 mm of board.
    wait_until(
        lambda: table.position == pytest.approx((-40.0, 20.0, 4.0, 0.0), abs=1e-3),
        "the tool is not above the point",
        60.0,
    )
    expect(state).to_have_text("Waiting for operator")
    assert [number for number, on in table.outputs.items() if on] == [2]
    page.get_by_test_id("shift-X").scroll_into_view_if_needed()
    assert_reachable(page)
    page.get_by_test_id("shift-X-more").tap()
    page.get_by_test_id("shift-X-more").tap()
    page.get_by_test_id("shift-C-less").tap()
    expect(page.get_by_test_id("shift-X")).to_contain_text("0.40")
    expect(page.get_by_test_id("tool-check-right")).to_be_disabled()
    page.wait_for_timeout(500)
    record_view(page, screenshots / f"{name}-11-tool-check.png")
    tick_hands(page)
    tap_operation(page, "tool-check-move")
    wait_until(
        lambda: table.position == pytest.approx((-39.6, 20.0, 4.0, -0.2), abs=1e-3),
        "the correction is not tried",
        60.0,
    )
    # The demo table is part of the library: its file cannot be changed.
    expect(page.get_by_test_id("tool-check-save")).to_be_enabled()
    page.get_by_test_id("tool-check-save").tap()
    outcome = page.get_by_test_id("outcome")
    expect(outcome).to_contain_text("belongs to the library")
    expect(outcome).to_contain_text("Copy it under a name of its own")
    record_view(page, screenshots / f"{name}-12-not-saved.png")
    tap_operation(page, "tool-check-lift")
    assert_done(page, "Lift")
    assert table.position[2] == pytest.approx(20.0)
    assert not any(table.outputs.values())
    page.get_by_test_id("shift-X-less").tap()
    page.get_by_test_id("shift-X-less").tap()
    page.get_by_test_id("shift-C-more").tap()
    page.get_by_test_id("tool-check-right").tap()
    ticked = page.locator("[data-statement]").filter(has_text="V-cutter")
    expect(ticked).to_have_attribute("data-ticked", "true")
    api.post(f"/api/jobs/{job}/cancel")
    expect(state).to_have_text("At rest")


def test_a_printed_sheet_is_measured_by_touch(
    tablet: tuple[Page, str], workshop: Workshop, api: httpx.Client, screenshots: Path
) -> None:
    page, name = tablet
    expect(page.get_by_test_id("station-state")).to_have_text("At rest", timeout=60_000)
    job = send_job(api, copies=1, registration={"marks": [[0.0, 0.0], [100.0, 0.0]]})
    panel, compile = page.get_by_test_id("marks"), page.get_by_test_id("marks-compile")
    expect(panel).to_contain_text("expected at X")
    expect(page.get_by_test_id("check").filter(has_text="at the stops")).to_be_visible()
    page.get_by_test_id("camera").tap()
    expect(page.get_by_test_id("no-camera")).to_be_visible()
    page.get_by_test_id("camera").tap()
    page.get_by_test_id("jog-limit-100").tap()
    hold_arrow(page, "jog-y1", workshop, 100.0)
    hold_arrow(page, "jog-x1", workshop, 100.0)

    def expect_position() -> None:
        x, y, *_ = workshop.table.table.position
        text = f"X {x:.2f} · Y {y:.2f}"
        expect(page.get_by_test_id("marks-position")).to_have_text(text)

    for _ in range(4):
        expect_position()
        page.get_by_test_id("take-mark-1").tap()
        expect(compile).to_be_disabled()
        first = workshop.table.table.position[0]
        hold_arrow(page, "jog-x1", workshop, 100.0)
        # A second hold, as on a busy computer, moves farther: the first mark is taken again there.
        if workshop.table.table.position[0] == pytest.approx(first + 100.0, abs=0.01):
            break
    expect_position()
    page.get_by_test_id("take-mark-2").tap()
    expect(page.get_by_test_id("marks-fit")).to_contain_text("turn 0.000° · scale 1.00000")
    panel.scroll_into_view_if_needed()
    assert_reachable(page)
    assert_accessible(page)
    record_view(page, screenshots / f"{name}-13-marks.png")
    compile.tap()
    expect(page.get_by_test_id("check").filter(has_text="not moved")).to_be_visible(timeout=60_000)
    measured = api.get(f"/api/jobs/{job}").json()["registration"]["measured"]
    assert measured[1][0] - measured[0][0] == pytest.approx(100.0, abs=0.01)
    api.post(f"/api/jobs/{job}/cancel").raise_for_status()


@pytest.mark.usefixtures("api")
def test_outputs_are_switched_and_the_zero_is_set_by_hand(
    tablet: tuple[Page, str], workshop: Workshop, screenshots: Path
) -> None:
    page, name = tablet
    table = workshop.table.table
    expect(page.get_by_test_id("station-state")).to_have_text("At rest", timeout=60_000)
    page.get_by_test_id("tab-machine").tap()
    output = page.get_by_test_id("output-1")
    expect(output).to_have_attribute("aria-checked", "false")
    expect(output).to_be_disabled()
    enable_by_hands(page, output)
    carry_out(page, "output-1", "Crease wheel on")
    wait_until(lambda: bool(table.outputs[1]), "the output is off")
    expect(output).to_have_attribute("aria-checked", "true")
    assert_reachable(page)
    output.scroll_into_view_if_needed()
    record_view(page, screenshots / f"{name}-13-output-on.png")
    carry_out(page, "output-1", "Crease wheel off")
    expect(output).to_have_attribute("aria-checked", "false")
    assert not table.outputs[1]

    # Below the travel height nothing moves across the board, and no station is lowered.
    hold_arrow(page, "jog-z0", workshop, 10.0)
    expect(page.get_by_test_id("outcome")).to_contain_text("done")
    state_hands_clear(page)
    expect(output).to_be_disabled()
    expect(page.get_by_test_id("jog-x1")).to_have_attribute("aria-disabled", "true")
    hold_arrow(page, "jog-z1", workshop, 10.0)
    enable_by_hands(page, output)

    # The zero is set after a question, and every later position is counted from it.
    hold_arrow(page, "jog-x1", workshop, 10.0)
    position = page.get_by_test_id("station-position")
    expect(position).not_to_contain_text(re.compile(r"X\s*0\.0"))
    zero = page.get_by_test_id("operation-zero")
    expect(zero).to_be_disabled()
    enable_by_hands(page, zero)
    zero.tap()
    page.get_by_test_id("question-no").tap()
    expect(position).not_to_contain_text(re.compile(r"X\s*0\.0"))
    set_zero(page)
    expect(position).to_contain_text(re.compile(r"X\s*0\.0\s*Y\s*0\.0"))
    record_view(page, screenshots / f"{name}-14-zero.png")
    carry_out(page, "operation-home", "Home")
    # The zero of the other tests is where the machine is homed.
    set_zero(page)


def tap_twice(page: Page, target: Locator) -> None:
    """Tap twice at the same place, as a person does who is not sure of the first tap."""
    target.scroll_into_view_if_needed()
    box = box_of(target)
    for _ in range(2):
        page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


def test_a_second_tap_neither_answers_a_question_nor_moves_the_buttons_below(
    tablet: tuple[Page, str], screenshots: Path
) -> None:
    page, name = tablet
    expect(page.get_by_test_id("station-state")).to_have_text("At rest", timeout=60_000)
    page.get_by_test_id("tab-machine").tap()
    state_hands_clear(page)
    output, yes = page.get_by_test_id("output-1"), page.get_by_test_id("question-yes")
    zero = page.get_by_test_id("operation-zero")
    zero.scroll_into_view_if_needed()
    before = box_of(output)
    tap_twice(page, zero)
    expect(yes).to_be_enabled()
    assert box_of(output) == before
    assert page.get_by_test_id("outcome").count() == 0
    record_view(page, screenshots / f"{name}-15-question.png")
    page.get_by_test_id("question-no").tap()
    expect(yes).to_be_hidden()
    assert box_of(output) == before
    assert page.get_by_test_id("outcome").count() == 0


@pytest.mark.long
def test_a_corrected_offset_becomes_a_new_version_for_which_the_job_is_compiled_again(
    browser: Browser,
    workshop: Workshop,
    api: httpx.Client,
    own_machine: SimulatedTable,
    screenshots: Path,
) -> None:
    context = open_window(browser, viewport={"width": 1024, "height": 768}, has_touch=True)
    page = context.new_page()
    expect.set_options(timeout=60_000)
    page.goto(f"{workshop.url}/#/station/mine")
    state = page.get_by_test_id("station-state")
    expect(state).to_have_text("At rest")
    job = send_job(api, 1, "mine")
    expect(state).to_have_text("Waiting for operator")
    page.get_by_test_id("check-tool-3").tap()
    page.get_by_test_id("shift-Y-more").tap()
    tick_hands(page)
    tap_operation(page, "tool-check-move")
    table = own_machine.table
    wait_until(
        lambda: table.position == pytest.approx((-40.0, 20.2, 4.0, 0.0), abs=1e-3),
        "the correction is not tried",
        60.0,
    )
    expect(state).to_have_text("Waiting for operator")
    page.get_by_test_id("tool-check-save").tap()
    assert_done(page, "Save the offset of V-cutter")
    saved = api.get("/api/machines/mine/definition").json()
    assert saved["version"] == 2
    datum = next(one["datum"] for one in saved["fields"]["station"] if one["number"] == 3)
    assert datum == {"x": -60.0, "y": 0.2, "z": 0.0, "c": 0.0}
    expect(state).to_have_text("Out of date")
    again = page.get_by_test_id("station-recompile")
    again.scroll_into_view_if_needed()
    record_view(page, screenshots / "station-1024-13-out-of-date.png")
    again.tap()
    # The gateway loads the new version by itself, and takes the job again.
    expect(state).to_have_text("Waiting for operator")
    assert api.get(f"/api/jobs/{job}").json()["machine_version"] == 2
    assert table.position[2] == pytest.approx(20.0)
    tick_all(page)
    page.get_by_test_id("station-start").tap()
    expect(state).to_have_text("Running")
    api.post(f"/api/jobs/{job}/cancel")
    wait_until(lambda: api.get(f"/api/jobs/{job}").json()["state"] == "cancelled", "not stopped")
    context.close()


def hold_arrow(page: Page, arrow: str, workshop: Workshop, distance: float) -> float:
    """Hold an arrow down with a finger until its axis has moved; return the distance moved.

    A move whose renewal is late, as on a busy computer, ends before: the arrow is then pressed
    again, as a person would do.
    """
    target = page.get_by_test_id(arrow)
    target.scroll_into_view_if_needed()
    box = box_of(target)
    session = page.context.new_cdp_session(page)
    point = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
    touch = "Input.dispatchTouchEvent"
    axis = "xyzc".index(arrow.removeprefix("jog-")[0])

    def moved() -> float:
        return abs(workshop.table.table.position[axis] - before)

    for _ in range(4):
        before = workshop.table.table.position[axis]
        deadline = time.monotonic() + 8.0
        session.send(touch, {"type": "touchStart", "touchPoints": [point]})
        while moved() < distance - 0.01 and time.monotonic() < deadline:
            page.wait_for_timeout(50)
        session.send(touch, {"type": "touchEnd", "touchPoints": []})
        rest = re.compile("At rest|Waiting for operator")
        expect(page.get_by_test_id("station-state")).to_have_text(rest)
        if moved() >= distance - 0.01:
            return moved()
    pytest.fail(f"{arrow} does not move its axis by {distance} mm")


def test_a_page_without_server_shows_this_and_disables_its_buttons(
    tablet: tuple[Page, str], screenshots: Path
) -> None:
    page, name = tablet
    expect(page.get_by_test_id("station-state")).to_have_text(re.compile("At rest|Alarm"))
    expect(page.get_by_test_id("no-server")).to_be_hidden()
    page.context.set_offline(True)
    expect(page.get_by_test_id("no-server")).to_contain_text("emergency stop")
    page.get_by_test_id("tab-machine").tap()
    for test_id in ("operation-home", "operation-park", "station-start", "station-stop"):
        expect(page.get_by_test_id(test_id)).to_be_disabled()
    expect(page.get_by_test_id("jog-x1")).to_have_attribute("aria-disabled", "true")
    record_view(page, screenshots / f"{name}-7-no-server.png")
    page.context.set_offline(False)
    expect(page.get_by_test_id("no-server")).to_be_hidden()
