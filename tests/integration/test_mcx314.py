"""Jobs on the simulated board of an MCX314: from the drawing to the pulses, also after faults."""

from __future__ import annotations

import asyncio
import re
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import aclosing, contextmanager, suppress
from pathlib import Path

import httpx
import numpy as np
import pytest
import shapely

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.gateway import claim
from knifetip.gateway.controller import SafeState
from knifetip.gateway.hot_folder import find_driver
from knifetip.gateway.job_server import GatewaySettings
from knifetip.gateway.mcx314.driver import dial
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import stream
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.pipeline import Compiled
from knifetip.sequencing.tracks import RestChoice, find_tracks, row_lines
from knifetip.simulators.mcx314 import simulator
from knifetip.simulators.mcx314.board import Board
from tests.support.drawings import drawing
from tests.support.serving.server import Running, order_job, square, upload_drawing, wait_for_state
from tests.support.shapes import closed, dieline, edges

MACHINE, BOARD = load.machine("v-groove-table"), load.board("greyboard-2.0")
#: A blank with round corners, a window, a curved slit, a crease and a V-groove.
BOX = dieline(
    (LineType.CUT, closed((0, 8), (8, 0), (92, 0), (100, 8), (100, 60), (0, 60))),
    (LineType.CUT, closed((60, 20), (80, 20), (80, 40), (60, 40))),
    (LineType.CREASE, edges(((25, 0), (25, 60)))),
    (LineType.V_GROOVE, edges(((45, 10), (45, 50)))),
    bulge={0: np.tan(np.pi / 8.0), 2: np.tan(np.pi / 8.0), 8: 0.2},
)


def compiled(line: Dieline = BOX) -> Compiled:
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    made = pipeline.compile(lines, line, MACHINE, BOARD)
    assert made.verdict.accepted, made.verdict.findings
    return made


@pytest.mark.parametrize(
    ("overrun", "codes"),
    [
        ("LINE Y56 V80000 JOIN", set()),
        ("LINE X1 Y56 V80013 JOIN", set()),
        ("LINE X2 Y56 V80051 JOIN", {"verify.wrong-heading"}),
    ],
)
def test_a_short_overrun_may_be_turned_by_the_rounding_of_its_ends(
    overrun: str, codes: set[str]
) -> None:
    """Half a pulse at either end of 56 pulses turns the line by 1.02°."""
    board = load.board("e-flute")
    line = dieline(
        (LineType.CUT, closed((100, 100), (140, 100), (140, 140), (100, 140))),
        (LineType.CUT, edges(((120, 136), (120, 140)))),
    )
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line))
    made = pipeline.compile(lines, line, MACHINE, board)
    program = made.program.text.replace(b"LINE Y56 V80000 JOIN", overrun.encode())
    assert overrun.encode() in program
    verdict = pipeline.verify(program, line, made.placement, MACHINE, board)
    assert {one.message.code for one in verdict.findings if one.refuses} == codes


@pytest.mark.parametrize("radius", [2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 40.0])
@pytest.mark.parametrize("board", ["b-flute", "e-flute", "greyboard-2.0", "fbb-0.4"])
def test_a_wheel_follows_tight_creases_at_a_lower_speed(radius: float, board: str) -> None:
    crease = edges(((50.0 - radius, 45.0), (50.0 + radius, 45.0)))
    line = dieline(
        (LineType.CUT, closed((0, 0), (100, 0), (100, 90), (0, 90))),
        (LineType.CREASE, crease),
        bulge={4: 0.8},
    )
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    made = pipeline.compile(lines, line, MACHINE, load.board(board))
    # The wheel bends what it presses; a person may accept that.
    codes = {one.message.code for one in made.verdict.findings}
    assert codes <= {"verify.crease-too-bent", "verify.narrow-rim"}


def test_a_chord_is_driven_no_slower_than_writing_the_next_one_needs() -> None:
    line = dieline(
        (LineType.CUT, closed((0, 0), (100, 0), (100, 90), (0, 90))),
        (LineType.CREASE, edges(((40, 45), (60, 45)))),
        bulge={4: 0.8},
    )
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    board = load.board("e-flute")
    made = pipeline.compile(lines, line, MACHINE, board)
    text = made.program.text.decode().splitlines()
    wheel = next(row for row, words in enumerate(text) if "Crease wheel" in words)
    # Every chord of the crease joins, and has a heading.
    chord = next(n for n in range(wheel, len(text)) if re.search("C.* JOIN", text[n]))
    speed = int(re.findall(r"V(\d+)", text[chord])[0])
    text[chord] = text[chord].replace(f"V{speed}", f"V{speed // 2}")
    slower = "".join(f"{words}\n" for words in text).encode()
    verdict = pipeline.verify(slower, line, made.placement, MACHINE, board)
    assert "verify.wrong-time" not in {one.message.code for one in made.verdict.findings}
    assert "verify.wrong-time" in {one.message.code for one in verdict.findings}


async def execute(program: bytes, last: int | None = None) -> tuple[Board, int]:
    """Run a program on a simulated board until it ends, or until a tool is in the board after line
    ``last``; return the board and the number of lines that were reported as executed.
    """
    executed = 0
    async with await simulator.serve(MACHINE, speed=8.0, sample=0.002) as server:
        controller = await dial(server.address, SafeState.from_machine(MACHINE), poll=0.02)
        course = stream(program, controller, limits=Limits.from_machine(MACHINE), interval=0.01)
        async with asyncio.timeout(120.0), aclosing(course):
            async for progress in course:
                executed = progress.executed
                if last is not None and executed >= last and progress.position[2] < BOARD.caliper:
                    break
        await controller.close()
        assert server.board.refusals == []
        assert server.board.outputs == set()
        assert server.board.position[2] >= MACHINE.travel_z - 1.5
        return server.board, executed


def tip_paths(board: Board) -> list[tuple[int, F64]]:
    """Return the path of each tool's tip in the board: station, and points (n, 2) on the sheet.

    The dimensions of the tools are those of the machine file.
    """
    samples_ = board.samples()
    times = np.array([event.time for event in board.switched if event.output >= 0])
    events = [event for event in board.switched if event.output >= 0]
    paths: list[tuple[int, F64]] = []
    offsets = {0: (0.0, 0.0, 0.0), 1: (60.0, 0.0, -1.5), 2: (-60.0, 0.0, 0.0)}
    down: dict[float, int] = {}
    for event in events:
        down[event.time] = event.output if event.on else -1
    station = np.array([down[time_] for time_ in times])
    at = np.searchsorted(times, samples_[:, 0], side="right") - 1
    which = np.where(at >= 0, station[at], -1)
    for output, (x, y, z) in offsets.items():
        own = samples_[which == output]
        tip = own[:, 1:3] - (x, y)
        if output == 2:
            heading = np.radians(own[:, 4])
            ahead = np.column_stack([np.cos(heading), np.sin(heading)])
            right = np.column_stack([np.sin(heading), -np.cos(heading)])
            tip = tip - 6.0 * right - 1.5 * ahead
        low = own[:, 3] - z < BOARD.caliper - 0.2
        starts = np.flatnonzero(np.diff(np.concatenate([[0], low.astype(int)])) == 1)
        ends = np.flatnonzero(np.diff(np.concatenate([low.astype(int), [0]])) == -1)
        paths += [(output, tip[a : b + 1]) for a, b in zip(starts, ends, strict=True) if b > a]
    return paths


def drawn(line: Dieline, placement: tuple[float, float]) -> dict[int, list[shapely.LineString]]:
    """Return the drawn edges on the sheet by the output of the station that makes them."""
    outputs = {LineType.CUT: 0, LineType.CREASE: 1, LineType.V_GROOVE: 2}
    found: dict[int, list[shapely.LineString]] = {0: [], 1: [], 2: []}
    for (start, end), bulge, kind in zip(line.ends, line.bulge, line.line_type, strict=True):
        angle = 4.0 * np.arctan(bulge)
        fraction = np.linspace(0.0, 1.0, 200 if bulge else 2)
        chord = end - start
        if bulge:
            normal = np.array([-chord[1], chord[0]])
            centre = (start + end) / 2.0 + normal * (1.0 - bulge**2) / (4.0 * bulge)
            turn = angle * fraction
            out = start - centre
            cos, sin = np.cos(turn), np.sin(turn)
            points = centre + np.column_stack(
                [out[0] * cos - out[1] * sin, out[0] * sin + out[1] * cos]
            )
        else:
            points = start + fraction[:, None] * chord
        found[outputs[LineType(int(kind))]].append(shapely.LineString(points + placement))
    return found


def assert_covered(boards: list[Board], line: Dieline, placement: tuple[float, float]) -> None:
    """Check with shapely that the pulses cover all drawn lines, and nothing else."""
    wanted = drawn(line, placement)
    paths = [path for board in boards for path in tip_paths(board)]
    for output, edges_ in wanted.items():
        own = [shapely.LineString(points) for station, points in paths if station == output]
        # Samples are up to 0.8 mm apart; on the arcs of 8 mm their chords deviate by 0.01 mm.
        worked = shapely.union_all(own).buffer(0.03)
        for edge in edges_:
            # A wheel and a slanted blade begin inside the ends of their lines.
            inside = np.arange(5.0, edge.length - 5.0, 0.5)
            inner = shapely.line_interpolate_point(edge, inside)
            assert worked.covers(shapely.MultiPoint(inner)), (output, edge)
        allowed = shapely.union_all(edges_).buffer(0.03, cap_style="round")
        ends = shapely.union_all(
            [shapely.Point(edge.coords[k]) for edge in edges_ for k in (0, -1)]
        )
        stray = shapely.union_all(own).difference(shapely.union(allowed, ends.buffer(3.0)))
        assert stray.length < 1e-6, (output, stray)


@pytest.mark.parametrize("name", sorted(samples()))
def test_the_samples_are_accepted(name: str) -> None:
    drawing_ = pipeline.read(samples()[name])
    line = pipeline.classify(drawing_, load.profile("default"))
    made = pipeline.compile(drawing_, line, MACHINE, load.board("e-flute"))
    assert made.verdict.accepted
    assert {one.message.code for one in made.verdict.findings} == {"verify.blade-bend"}
    # The same input gives the same bytes.
    again = pipeline.compile(drawing_, line, MACHINE, load.board("e-flute"))
    assert again.program.text == made.program.text


async def test_the_pulses_of_a_whole_program_cover_the_drawn_lines() -> None:
    made = compiled()
    board, executed = await execute(made.program.text)
    assert executed == len(made.program)
    assert_covered([board], BOX, made.placement)


@pytest.mark.parametrize("share", [0.4, 0.8])
async def test_an_interrupted_program_and_its_rest_cover_the_drawn_lines(share: float) -> None:
    made = compiled()
    tracks = find_tracks(made.toolpath, row_lines(made.program, len(made.toolpath)))
    line = int(tracks.first_line[int(share * len(tracks))])
    before, executed = await execute(made.program.text, line)
    assert executed < len(made.program)
    lines = drawing(BOX.ends, [("0", 7, "CONTINUOUS")] * len(BOX), bulge=BOX.bulge)
    rest = pipeline.compile_rest(
        lines, BOX, MACHINE, BOARD, pipeline.rest_of(made, RestChoice(), executed)
    )
    assert rest.verdict.accepted, rest.verdict.findings
    after, executed = await execute(rest.program.text)
    assert executed == len(rest.program)
    assert_covered([before, after], BOX, made.placement)
    for alone in (before, after):
        with pytest.raises(AssertionError):
            assert_covered([alone], BOX, made.placement)


# -- through the service --------------------------------------------------------------------------


class Shop:
    """A simulated board with its gateway, in a thread, for a running server."""

    def __init__(self, url: str, journal: Path, speed: float) -> None:
        self.board: Board | None = None
        self._settings = GatewaySettings(url, MACHINE, "mcx", journal=journal, beat=0.05)
        self._speed = speed
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[None] | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)

    def _run(self) -> None:
        with suppress(asyncio.CancelledError):
            asyncio.run(self._serve())

    async def _serve(self) -> None:
        self._loop, self._task = asyncio.get_running_loop(), asyncio.current_task()
        async with await simulator.serve(MACHINE, speed=self._speed, sample=0.002) as server:
            self.board = server.board
            driver = find_driver(MACHINE, server.address)
            await claim.run_gateway(
                self._settings,
                lambda safe, stop: driver(server.address, safe, stop_motion=stop),
            )

    def do(self, action: Callable[[], None]) -> None:
        """Do something with the board in the thread that simulates it."""
        assert self._loop is not None
        self._loop.call_soon_threadsafe(action)

    def __enter__(self) -> Shop:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._loop is not None and self._task is not None:
            self._loop.call_soon_threadsafe(self._task.cancel)
        self._thread.join(20.0)


@contextmanager
def shop(tmp_path: Path, speed: float) -> Iterator[tuple[httpx.Client, Shop]]:
    with (
        Running(tmp_path / "shop.sqlite", simulator=False) as client,
        Shop(str(client.base_url), tmp_path / "journal", speed) as table,
    ):
        yield client, table


def until(holds: Callable[[], bool], seconds: float = 30.0) -> None:
    deadline = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def ordered(client: httpx.Client) -> str:
    drawing_ = upload_drawing(client, square())["id"]
    order = order_job(client, drawing_, machine="v-groove-table", release=True)
    return str(order["id"])


@pytest.mark.xdist_group("mcx314")
def test_a_job_runs_through_the_service_with_hold_abort_and_rest(tmp_path: Path) -> None:
    with shop(tmp_path, speed=4.0) as (client, table):
        job = ordered(client)
        wait_for_state(client, job, "running", confirm=True)
        board = table.board
        assert board is not None
        until(lambda: board.position[2] < 0.0)
        client.post(f"/api/jobs/{job}/hold")
        wait_for_state(client, job, "held")
        place = board.position
        assert place[2] < MACHINE.travel_z
        assert board.outputs
        time.sleep(0.2)
        assert board.position == place
        client.post(f"/api/jobs/{job}/resume", json={"hands_clear": True})
        found = wait_for_state(client, job, "done")
        assert found["line"] == found["lines"]
        text = client.get(f"/api/jobs/{job}/program").content
        assert text.startswith(b"MCX314 1\n")
        assert board.refusals == []

        second = ordered(client)
        wait_for_state(client, second, "running", confirm=True)
        until(lambda: board.position[2] < 0.0 and board.position[0] > 60.0)
        assert board.outputs
        client.post(f"/api/jobs/{second}/cancel")
        wait_for_state(client, second, "cancelled")
        assert board.outputs == set()
        assert not board.oscillates
        assert board.position[2] >= MACHINE.travel_z


@pytest.mark.long
@pytest.mark.xdist_group("mcx314")
def test_an_interrupted_job_is_continued_from_a_contour_through_the_service(
    tmp_path: Path,
) -> None:
    with shop(tmp_path, speed=4.0) as (client, table):
        job = ordered(client)
        wait_for_state(client, job, "running", confirm=True)
        board = table.board
        assert board is not None
        until(lambda: board.position[2] < 0.0 and board.position[0] > 60.0)
        table.do(board.press_stop)
        wait_for_state(client, job, "interrupted")
        assert board.outputs == set()
        table.do(board.release_stop)
        station = "/api/machines/v-groove-table/station"
        until(lambda: client.get(station).json()["connected"])
        for name in ("unlock", "home"):
            answer = client.post(
                "/api/machines/v-groove-table/operations",
                json={"operation": name, "hands_clear": True},
            )
            assert answer.status_code in (200, 201, 202), answer.text
        until(lambda: board.state == "IDLE")
        answer = client.post(f"/api/jobs/{job}/rest", json={"release": True})
        assert answer.status_code == 201, answer.text
        rest = answer.json()["id"]
        found = wait_for_state(client, rest, "done", confirm=True)
        assert found["line"] == found["lines"]
        assert client.get(f"/api/jobs/{job}").json()["state"] == "continued"
        assert board.refusals == []
