"""Jobs of the service on a complete LinuxCNC: uploaded, compiled, confirmed, run by the gateway.

Server and gateway are processes of their own, started as a user starts them.  The machine is only
observed, through its HAL pins; it is operated through the server.
"""

from __future__ import annotations

import asyncio
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from shapely import LineString, MultiPoint, Polygon, union_all
from shapely.geometry.base import BaseGeometry

from knifetip.gateway.linuxcnc.driver import dial
from knifetip.geometry.columns import F64
from knifetip.model.tool import Cutter
from tests.controllers.linuxcnc_machine import Machine, Supply, missing_requirement, wait_until
from tests.controllers.quick_router import BOARD, NAME, ROUTER, TABLE, TOML, WHEEL
from tests.support.serving.server import (
    Running,
    confirm_job,
    order_job,
    upload_drawing,
    wait_for_state,
)
from tests.support.writers import dxf_text as text

SKIP_REASON = missing_requirement()
pytestmark = [
    pytest.mark.controller,
    pytest.mark.xdist_group("linuxcnc"),
    pytest.mark.skipif(bool(SKIP_REASON), reason=SKIP_REASON),
]

#: Columns of the samples with the outputs.
COLUMN = {WHEEL: 4 + WHEEL, ROUTER: 4 + ROUTER}
DATUM = {station.output: (station.x, station.y) for station in TABLE.stations}
RADIUS = next(one.tool.radius for one in TABLE.stations if isinstance(one.tool, Cutter))

# A blank with a fold and a window, mm.
WIDTH, HEIGHT = 180.0, 120.0
FOLD = LineString([(50.0, 0.0), (50.0, HEIGHT)])
WINDOW = Polygon([(80.0, 30.0), (120.0, 30.0), (120.0, 70.0), (80.0, 70.0)])
BLANK = Polygon([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])


def drawing() -> bytes:
    rings = [BLANK.exterior, WINDOW.exterior]
    cuts = [(a, b) for ring in rings for a, b in zip(ring.coords, ring.coords[1:], strict=False)]
    lines = [text.line(*a, *b, (8, "CUT")) for a, b in cuts]
    return text.dxf(*lines, text.line(*FOLD.coords[0], *FOLD.coords[1], (8, "CREASE")))


# -- the service ----------------------------------------------------------------------------------


class Shop:
    """A server with a drawing, and a gateway for a machine; both are processes.

    Parameters
    ----------
    client
        Client of the server.
    folder
        Folder for the journal and the log of the gateway.
    """

    def __init__(self, client: httpx.Client, folder: Path) -> None:
        self.client = client
        self.drawing = upload_drawing(client, drawing())["id"]
        self.machine: Machine
        self._folder = folder
        self._gateway: subprocess.Popen[bytes] | None = None

    # -- the gateway ------------------------------------------------------------------------------

    def attach(self, machine: Machine) -> None:
        """Have a gateway run for a machine."""
        if self._gateway is None or self.machine is not machine:
            self.stop_gateway()
            self.machine = machine
            self.start_gateway()

    def start_gateway(self) -> None:
        """Start a gateway with the journal of the last one."""
        command = [
            *(sys.executable, "-m", "knifetip.cli", "gateway", "--machine", NAME),
            *("--server", str(self.client.base_url), "--journal", str(self._folder / "journal")),
            "--controller",
            f"linuxcnc://{self.machine.address}/?programs={self.machine.directory}",
        ]
        with (self._folder / "gateway.log").open("ab") as log:
            self._gateway = subprocess.Popen(command, stdout=log, stderr=log)

    def kill_gateway(self) -> None:
        """End the gateway as a power failure does."""
        self._end_gateway(signal.SIGKILL)

    def stop_gateway(self) -> None:
        """End the gateway as a service manager does."""
        self._end_gateway(signal.SIGTERM)

    def _end_gateway(self, signal_number: signal.Signals) -> None:
        gateway, self._gateway = self._gateway, None
        if gateway is not None:
            gateway.send_signal(signal_number)
            try:
                gateway.wait(30.0)
            finally:
                gateway.kill()
                gateway.wait()

    @property
    def log(self) -> str:
        """What the gateway has written to its terminal."""
        return (self._folder / "gateway.log").read_text(errors="replace")

    # -- requests to the server -------------------------------------------------------------------

    def order(self, **fields: object) -> str:
        """Order a job with further JSON fields; return its id."""
        order = {"board": BOARD.name, "machine": NAME, **fields}
        return str(order_job(self.client, self.drawing, **order)["id"])

    def post(self, path: str, **body: object) -> Any:
        answer = self.client.post(f"/api/{path}", json=body)
        assert answer.is_success, answer.text
        return answer.json()

    def get(self, path: str) -> Any:
        answer = self.client.get(f"/api/{path}")
        assert answer.is_success, answer.text
        return answer.json()

    def operate(self, operation: str) -> None:
        """Do an operation of the station page and wait for its end."""
        wait_until(lambda: self.get(f"machines/{NAME}/station")["connected"])
        path = f"machines/{NAME}/operations"
        id = self.post(path, operation=operation, hands_clear=True)["id"]
        wait_until(lambda: self.get(f"{path}/{id}")["state"] != "waiting")
        done = self.get(f"{path}/{id}")
        assert done["state"] == "done", done

    def start(self, job: str) -> None:
        """Release a job and confirm it at the table; wait until it runs."""
        wait_for_state(self.client, job, "ready")
        self.post(f"jobs/{job}/release")
        self.confirm(job)

    def confirm(self, job: str) -> None:
        wait_for_state(self.client, job, "running", confirm=True)

    def wait_for(self, job: str, *states: str) -> Any:
        return wait_for_state(self.client, job, *states)

    def program(self, job: str) -> str:
        return self.client.get(f"/api/jobs/{job}/program").text

    def wait_until_milling(self, percent: int = 10) -> None:
        """Wait until the router is deep in the board, with the machine slowed down.

        So it is still there when a test does the next thing, also on a busy computer.
        """
        machine = self.machine
        wait_until(lambda: machine.lowered() == [ROUTER])
        machine.override_feed(percent)
        wait_until(lambda: machine.position()[2] < 0.0)

    def wait_until_milling_the_outline(self, job: str) -> None:
        """Wait until the server reports that the last track has begun."""
        self.wait_until_milling(40)
        wait_until(lambda: self.get(f"jobs/{job}/tracks")[-1]["state"] == "begun", 30.0)
        self.wait_until_milling()

    def assert_safe(self) -> None:
        """Assert that the tool is up, all outputs are off, and nothing moves."""
        assert self.machine.lowered() == []
        assert not self.machine.spins()
        assert self.machine.position()[2] >= TABLE.travel_z - 1e-3
        assert self.machine.comes_to_rest()


@pytest.fixture(scope="module")
def supply() -> Iterator[Supply]:
    with Supply(TABLE) as supply:
        yield supply


@pytest.fixture(scope="module")
def open_shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    """Run a server with the machine among its definitions."""
    folder = tmp_path_factory.mktemp("shop")
    with Running(folder / "shop.sqlite", simulator=False) as client:
        toml = {"Content-Type": "application/toml"}
        assert client.put(f"/api/machines/{NAME}", content=TOML, headers=toml).is_success
        shop = Shop(client, folder)
        yield shop
        shop.stop_gateway()


@pytest.fixture
def shop(open_shop: Shop, supply: Supply) -> Iterator[Shop]:
    """Attach the gateway to a machine that is ready; no job is left after the test."""
    with supply.machine() as machine:
        open_shop.attach(machine)
        yield open_shop
        print(open_shop.log)  # pytest shows it if the test fails
        for job in open_shop.get("jobs"):
            for action in {"cancel", "scrap"} & set(job["actions"]):
                open_shop.post(f"jobs/{job['id']}/{action}")


# -- what the machine has made --------------------------------------------------------------------


def placement(program: str) -> tuple[float, float]:
    """Return the position of the drawing on the table (mm)."""
    found = re.search(r"\(placement X(\S+) Y(\S+)\)", program)
    assert found
    return float(found[1]), float(found[2])


def made(samples: F64, output: int, width: float, program: str) -> BaseGeometry:
    """Return the area in drawing coordinates that a tool was in while its station was lowered.

    Parameters
    ----------
    samples
        Samples of the machine.
    output
        Output that lowers the station.
    width
        Width of the track of the tool (mm).
    program
        The program, which states the position of the drawing.
    """
    low = (samples[:, COLUMN[output]] == 1.0) & (samples[:, 2] < BOARD.caliper - 0.5)
    xy = samples[:, :2] - DATUM[output] - placement(program)
    runs = np.split(np.arange(len(low)), np.flatnonzero(np.diff(low)) + 1)
    paths = [LineString(xy[run]) for run in runs if low[run[0]] and len(run) > 1]
    # At 1 kHz most points of straight lines are redundant.
    return union_all([path.simplify(0.005).buffer(width / 2.0) for path in paths])


def assert_made(samples: F64, program: str) -> None:
    """Assert that samples cover the whole drawing, and that the router stays outside the blank."""
    kerf = made(samples, ROUTER, 2.0 * RADIUS, program)
    # A round tool leaves the inner corners of the window.
    corners = MultiPoint(WINDOW.exterior.coords).buffer(RADIUS + 0.05)
    cuts = BLANK.exterior.union(WINDOW.exterior.difference(corners))
    assert kerf.buffer(0.05).covers(cuts)
    part = BLANK.difference(WINDOW)
    assert kerf.intersection(part.buffer(-0.05)).is_empty
    crease = made(samples, WHEEL, 0.4, program)
    # The round wheel presses beyond the ends of the crease.
    fold = LineString([FOLD.interpolate(8.0), FOLD.interpolate(FOLD.length - 8.0)])
    assert crease.covers(fold)


def assert_lowered_in_the_mat(samples: F64) -> None:
    """Assert that the router was in the mat only while its station was lowered.

    The spindle is another matter: ``abort`` of LinuxCNC stops it before the gateway lifts the tool.
    """
    low = samples[samples[:, 2] < 0.0]
    assert len(low)
    assert (low[:, COLUMN[ROUTER]] == 1.0).all()


def end_of(program: str) -> list[float]:
    """Return X, Y, Z, C where a program ends, without a tool offset."""
    ends = []
    for letter in "XYZC":
        ends.append(float(re.findall(rf"^G[0-3] .*{letter}(\S+)", program, re.MULTILINE)[-1]))
    return ends


# -- jobs -----------------------------------------------------------------------------------------


def test_a_job_is_held_resumed_and_done(shop: Shop) -> None:
    job = shop.order()
    shop.machine.press_emergency_stop()
    wait_until(lambda: shop.get(f"machines/{NAME}/station")["alarm"] is not None)
    shop.machine.release_emergency_stop()
    shop.operate("unlock")
    shop.operate("home")
    mark = shop.machine.mark()
    shop.start(job)
    shop.wait_until_milling()
    shop.post(f"jobs/{job}/hold")
    shop.wait_for(job, "held")
    assert shop.machine.comes_to_rest()
    assert shop.machine.lowered() == [ROUTER]
    shop.machine.override_feed(100)
    shop.post(f"jobs/{job}/resume", hands_clear=True)
    done = shop.wait_for(job, "done")
    assert done["line"] == done["lines"]
    shop.assert_safe()
    samples, program = shop.machine.samples(mark), shop.program(job)
    np.testing.assert_allclose(samples[-1, :4], end_of(program), atol=1e-3)
    assert_made(samples, program)
    assert_lowered_in_the_mat(samples)


def test_only_a_confirmation_with_all_checks_starts_a_copy(shop: Shop) -> None:
    job = shop.order(copies=2)
    wait_for_state(shop.client, job, "ready")
    shop.post(f"jobs/{job}/release")
    wait_until(lambda: shop.get(f"jobs/{job}")["waiting_for"] == "confirmation")
    checks = [check["id"] for check in shop.get(f"jobs/{job}/confirmation")["checks"]]
    for left_out in checks:
        given = [id for id in checks if id != left_out]
        refused = shop.client.post(f"/api/jobs/{job}/confirm", json={"checked": given})
        assert (refused.status_code, refused.json()["code"]) == (409, "job.not-checked")
    assert shop.machine.is_still()
    shop.confirm(job)
    shop.machine.override_feed(100)
    wait_until(lambda: shop.get(f"jobs/{job}")["waiting_for"] == "sheet")
    refused = shop.client.post(f"/api/jobs/{job}/resume", json={"hands_clear": True})
    assert (refused.status_code, refused.json()["code"]) == (409, "job.needs-sheet")
    assert shop.machine.comes_to_rest()
    assert shop.machine.lowered() == []
    assert confirm_job(shop.client, job).status_code == 200
    assert shop.wait_for(job, "done")["copies_done"] == 2
    shop.assert_safe()


def test_a_program_beyond_the_travel_stays_in_the_queue_until_it_is_tried_again(
    shop: Shop,
) -> None:
    async def set_zero(y: float) -> None:
        controller = await dial(shop.machine.address)
        await controller._connection.execute([f"G10 L2 P1 Y{y}"])
        await controller.close()

    def move_zero(y: float) -> None:
        """Set the zero of programs to Y of the machine (mm), as a person does at LinuxCNC."""
        shop.stop_gateway()  # linuxcncrsh has one client at a time
        asyncio.run(set_zero(y))
        shop.start_gateway()

    job = shop.order()
    move_zero(1200.0)
    try:
        wait_for_state(shop.client, job, "ready")
        shop.post(f"jobs/{job}/release")
        wait_until(lambda: shop.get(f"jobs/{job}")["waiting_for"] == "confirmation")
        before = shop.machine.position()  # at rest, with the tool lifted
        confirm_job(shop.client, job)
        wait_until(lambda: shop.get(f"jobs/{job}")["waiting_for"] == "check")
        row = shop.get(f"jobs/{job}")
        assert (row["state"], row["line"]) == ("queued", 0)
        assert row["check_refusal"]["code"] == "linuxcnc.beyond-travel"
        assert "Set X Y zero" in row["hint"]
        assert "recheck" in row["actions"]
        np.testing.assert_array_equal(shop.machine.position(), before)
        assert shop.machine.lowered() == []
    finally:
        move_zero(0.0)
    shop.post(f"jobs/{job}/recheck")
    shop.confirm(job)
    assert shop.wait_for(job, "done")["copies_done"] == 1


def test_a_jog_ends_when_its_button_is_not_held(shop: Shop) -> None:
    shop.operate("park")
    assert shop.machine.comes_to_rest()
    path, mark = f"machines/{NAME}/operations", shop.machine.mark()
    # A move of 15 s that no person renews.
    shop.post(path, operation="jog", axis="X", distance=300.0, feed=1200.0)

    def travelled() -> float:
        samples = shop.machine.samples(mark)
        return float(np.ptp(samples[:, 0])) if len(samples) else 0.0

    wait_until(lambda: travelled() > 1.0)
    wait_until(shop.machine.is_still)
    assert 1.0 < travelled() < 200.0


def test_a_cancelled_job_is_continued_from_a_contour(shop: Shop) -> None:
    job = shop.order()
    mark = shop.machine.mark()
    shop.start(job)
    shop.wait_until_milling_the_outline(job)
    shop.post(f"jobs/{job}/cancel")
    cancelled = shop.wait_for(job, "cancelled")
    shop.assert_safe()
    before, program = shop.machine.samples(mark), shop.program(job)
    stop = cancelled["stopped_at"]
    assert 0 < stop["line"] < cancelled["lines"]
    assert stop["station"] == 4
    # The place is where the router has left the board.
    np.testing.assert_allclose(stop["position"][:2], before[-1, :2], atol=1e-3)

    shop.machine.override_feed(100)
    contour = shop.get(f"jobs/{job}/tracks")[-1]["number"]
    rest = shop.post(f"jobs/{job}/rest", from_track=contour, release=True)["id"]
    mark = shop.machine.mark()
    shop.confirm(rest)
    shop.wait_for(rest, "done")
    shop.assert_safe()
    after = shop.machine.samples(mark)
    assert_made(np.concatenate([before, after]), program)
    with pytest.raises(AssertionError):
        assert_made(before, program)
    # The rest makes neither the fold nor the window again.
    assert made(after, WHEEL, 0.4, program).is_empty
    assert not made(after, ROUTER, 2.0 * RADIUS, program).intersects(WINDOW)
    assert_lowered_in_the_mat(np.concatenate([before, after]))


def test_a_gateway_that_is_stopped_in_a_cut_stops_its_machine(shop: Shop) -> None:
    job = shop.order()
    shop.start(job)
    shop.wait_until_milling()
    mark = shop.machine.mark()
    shop.stop_gateway()
    shop.assert_safe()
    assert_lowered_in_the_mat(shop.machine.samples(mark))
    interrupted = shop.wait_for(job, "interrupted")
    assert 0 < interrupted["stopped_at"]["line"] < interrupted["lines"]
    shop.post(f"jobs/{job}/scrap")


def test_a_gateway_killed_in_a_cut_takes_its_machine_back(shop: Shop) -> None:
    job = shop.order()
    mark = shop.machine.mark()
    shop.start(job)
    shop.wait_until_milling()
    shop.kill_gateway()
    assert not shop.machine.is_still()  # LinuxCNC goes on by itself
    assert shop.machine.lowered() == [ROUTER]
    shop.start_gateway()
    wait_until(lambda: shop.machine.lowered() == [])
    wait_until(lambda: (shop.get(f"jobs/{job}")["stopped_at"] or {"certain": False})["certain"])
    interrupted = shop.wait_for(job, "interrupted")
    # LinuxCNC was asked for the line before it was stopped.
    assert 0 < interrupted["stopped_at"]["line"] < interrupted["lines"]
    assert {track["state"] for track in shop.get(f"jobs/{job}/tracks")} <= {"cut", "begun", "uncut"}
    shop.assert_safe()
    samples, program = shop.machine.samples(mark), shop.program(job)
    assert_lowered_in_the_mat(samples)
    # The gateway has stopped the program, not its end.
    with pytest.raises(AssertionError):
        assert_made(samples, program)
    shop.post(f"jobs/{job}/scrap")


def test_a_program_that_ran_to_its_end_without_its_gateway_is_done(shop: Shop) -> None:
    job = shop.order()
    mark = shop.machine.mark()
    shop.start(job)
    shop.wait_until_milling(40)
    shop.kill_gateway()
    shop.machine.override_feed(100)
    shop.machine.wait_for_idle()
    shop.start_gateway()
    # The lease of the killed gateway may expire first: then the job is interrupted until the new
    # gateway has asked the controller.
    wait_until(lambda: shop.get(f"jobs/{job}")["state"] == "done", 60.0)
    done = shop.get(f"jobs/{job}")
    assert (done["line"], done["stopped_at"]) == (done["lines"], None)
    assert_made(shop.machine.samples(mark), shop.program(job))
    shop.assert_safe()


def test_a_program_that_a_person_stops_at_the_controller_is_not_told_as_executed(
    shop: Shop,
) -> None:
    job = shop.order()
    shop.start(job)
    shop.wait_until_milling()
    shop.machine.abort()
    interrupted = shop.wait_for(job, "interrupted")
    stopped = interrupted["stopped_at"]
    assert stopped["line"] < interrupted["lines"] == stopped["line_at_most"]
    assert not stopped["certain"]
    wait_until(lambda: shop.machine.lowered() == [])
    shop.assert_safe()
    shop.post(f"jobs/{job}/scrap")


def test_a_program_that_a_person_has_stopped_without_its_gateway_is_not_done(shop: Shop) -> None:
    job = shop.order()
    shop.start(job)
    shop.wait_until_milling()
    shop.kill_gateway()
    shop.machine.abort()
    shop.start_gateway()
    wait_until(lambda: shop.machine.lowered() == [])
    interrupted = shop.wait_for(job, "interrupted")
    assert interrupted["stopped_at"]["line_at_most"] == interrupted["lines"]
    answer = shop.client.post(f"/api/jobs/{job}/rest", json={"release": True})
    assert (answer.status_code, answer.json()["code"]) == (422, "rest.statement-needed")
    shop.post(f"jobs/{job}/scrap")
