"""Measure the claim of the patent: sharp corners of type B, C and D on the planner of LinuxCNC.

    python -m tests.benchmarks.patent_table  ->  backend/docs/d-type-table.md and .log

The same polygons are milled from outside with each type.  LinuxCNC runs without a display, and its
``sampler`` records both joints in every servo period (1 ms of machine time), so the figures do not
depend on the load of the computer.  Requires linuxcnc-uspace; takes about five minutes.
"""

from __future__ import annotations

import asyncio
import subprocess
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np

from knifetip.compensation.corner import corner_durations, corner_lengths
from knifetip.gateway.linuxcnc.driver import Linuxcnc, dial
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.offset.offset_paths import offset_paths
from knifetip.offset.transition import Corner
from tests.controllers import linuxcnc_machine

DOCS = Path(__file__).resolve().parents[2] / "backend" / "docs"
SIDE = 30.0  #: mm
K = 0.5
RADII = (1.0, 3.0, 6.0)  #: mm
FEEDS = (6000.0, 12000.0, 24000.0)  #: mm/min
RUN_SECONDS = 1.0  #: approximate duration of a run, rounded to whole laps (s)
ACCELERATION = 8000.0  #: acceleration of X and Y (mm/s²)
#: The disc touches a corner while its centre is nearer to it than r plus this distance (mm).
TOUCH = 0.02
#: The centre is at rest if it moves less than this in a servo period (mm).
REST_STEP = 1e-6

HEADER = """\
# LinuxCNC {version}, headless, servo period 1 ms, G64 P0.005 Q0.005, polygons of {side:g} mm sides
# axes 1500 mm/s and 8000 mm/s2, k = {k:g}; times in ms of LinuxCNC's own servo periods
# shape turn_deg r_mm feed_mm_min type laps way_mm ms_a_lap ms_at_a_corner slowest_mm_s
"""


@dataclass(frozen=True)
class Shape:
    """A polygon with sides of length ``SIDE``, travelled counter-clockwise."""

    name: str
    turns: tuple[float, ...]  #: turn angle at each corner (degrees)

    @property
    def corners(self) -> F64:
        heading = np.radians(np.concatenate([[0.0], np.cumsum(self.turns)[:-1]]))
        steps = SIDE * np.column_stack([np.cos(heading), np.sin(heading)])
        return np.concatenate([[[0.0, 0.0]], np.cumsum(steps, axis=0)[:-1]])


SHAPES = (
    Shape("hexagon", (60.0,) * 6),
    Shape("square", (90.0,) * 4),
    Shape("triangle", (120.0,) * 3),
    Shape("rhombus", (150.0, 30.0) * 2),
)


@dataclass(frozen=True)
class Row:
    """The measurements of one run."""

    shape: Shape
    radius: float
    feed: float
    corner: Corner
    laps: int
    path_length: float  #: length of the centre's path in one lap (mm)
    cycle: float  #: duration of one lap (ms)
    touch: float  #: mean time of contact with a corner (ms)
    slowest: float  #: lowest speed near the corners (mm/s)

    def line(self) -> str:
        """Return the measurements as a line of the log."""
        return (
            f"{self.shape.name} {'/'.join(f'{t:g}' for t in self.shape.turns[:2])}"
            f" {self.radius:g} {self.feed:g} {self.corner.name} {self.laps} {self.path_length:.4f}"
            f" {self.cycle:.1f} {self.touch:.2f} {self.slowest:.1f}"
        )


def centre(shape: Shape, radius: float, corner: Corner) -> Paths:
    """Return the path of the cutter's centre around a polygon, from the middle of its first
    side.
    """
    corners = shape.corners
    middle = corners[:1] + np.array([SIDE / 2.0, 0.0])
    start = np.concatenate([middle, corners[1:], corners[:1]])
    end = np.concatenate([corners[1:], corners[:1], middle])
    contour = Paths(start, end, np.zeros(len(start)), np.array([0, len(start)]))
    beside = offset_paths(contour, radius, -1, corner=corner, k=K)
    assert len(beside.paths) == 1
    return beside.paths


def program(path: Paths, feed: float, laps: int) -> bytes:
    """Return a program that follows a closed path ``laps`` times, with a dwell before and after."""
    x, y = path.start[0] + PLACE
    lines = ["G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1", "G64 P0.005 Q0.005"]
    lines += [f"G0 X{x:.4f} Y{y:.4f}", "G4 P0.05", f"F{feed:g}"]
    middles = arc.centre(path.start, path.end, path.bulge)
    for a, b, bend, middle in [*zip(path.start, path.end, path.bulge, middles, strict=True)] * laps:
        (x, y), (i, j) = b + PLACE, middle - a
        word = "G1" if bend == 0.0 else "G3" if bend > 0.0 else "G2"
        lines.append(f"{word} X{x:.4f} Y{y:.4f}" + (f" I{i:.4f} J{j:.4f}" if bend else ""))
    return "\n".join([*lines, "G4 P0.05", "M2", ""]).encode()


#: Position of the polygons on the table (mm).
PLACE = np.array([100.0, 100.0])


async def measure(
    machine: linuxcnc_machine.Machine, controller: Linuxcnc, shape: Shape, radius: float,
    feed: float, corner: Corner,
) -> Row:  # fmt: skip
    """Run the program of one polygon with a corner type; return the measurements."""
    path = centre(shape, radius, corner)
    length = float(path.lengths[0])
    laps = max(1, round(RUN_SECONDS * feed / 60.0 / length))
    mark = machine.mark()
    await controller.run(program(path, feed, laps))
    assert machine.is_still()  # the sampler has written all samples
    positions = machine.samples(mark)[:, :2]
    step = np.hypot(*np.diff(positions, axis=0).T)
    moving = np.flatnonzero(step > REST_STEP)
    # The last sequence of moves: a dwell separates it from the rapid to the start.
    begin = moving[np.flatnonzero(np.diff(moving, prepend=-1000) > 20)[-1]]
    cut, speed = positions[begin : moving[-1] + 2], 1000.0 * step[begin : moving[-1] + 1]
    corner_distance = np.hypot(*(cut[:, None] - (shape.corners + PLACE)).transpose(2, 0, 1)).min(
        axis=1
    )
    assert corner_distance.min() > radius - 0.006, (
        f"the planner cut {radius - corner_distance.min():.4f} mm into a corner"
    )
    near = corner_distance[1:] < 1.5 * radius
    return Row(
        shape, radius, feed, corner, laps, length,
        cycle=len(speed) / laps,
        touch=float((corner_distance[1:] <= radius + TOUCH).sum()) / (laps * len(shape.corners)),
        slowest=float(speed[near].min()),
    )  # fmt: skip


def table(rows: list[Row], version: str) -> str:
    """Return the text of backend/docs/d-type-table.md; ``version`` is that of LinuxCNC."""
    runs = {(r.shape.name, r.radius, r.feed, r.corner): r for r in rows}
    cases = product(SHAPES, RADII, FEEDS)
    lines = []
    quicker = smoother = lost = 0
    off = []
    for shape, radius, feed in cases:
        b, c, d = (runs[shape.name, radius, feed, corner] for corner in Corner)
        quicker += d.cycle < c.cycle
        smoother += d.touch < b.touch
        lost += d.cycle > b.cycle
        count = len(shape.turns)
        model = 1000.0 * corner_durations(
            np.radians(shape.turns), radius, np.full(count, K), feed / 60.0, ACCELERATION
        ).sum(axis=0)
        expected = [model[Corner.C] - model[Corner.B], model[Corner.D] - model[Corner.B]]
        off.append(np.abs(np.subtract([c.cycle - b.cycle, d.cycle - b.cycle], expected)) / count)
        cells = [f"{'/'.join(f'{t:g}' for t in dict.fromkeys(shape.turns))}°", f"{radius:g}",
                 f"{feed / 1000:g}"]  # fmt: skip
        cells += [f"{run.path_length:.2f}" for run in (b, c, d)]
        cells += [f"{run.cycle:.0f}" for run in (b, c, d)]
        cells += [f"{run.touch:.1f}" for run in (b, c, d)]
        cells += [f"{run.slowest:.0f}" for run in (b, c, d)]
        lines.append("| " + " | ".join(cells) + " |")
    count = len(lines)
    return PAGE.format(
        version=version, count=count, quicker=quicker, smoother=smoother, lost=lost,
        side=SIDE, k=K, touch=TOUCH, rows="\n".join(lines),
        c_off=np.median(off, axis=0)[0], c_worst=np.max(off, axis=0)[0],
        d_off=np.median(off, axis=0)[1], d_worst=np.max(off, axis=0)[1],
    )  # fmt: skip


PAGE = """\
# Corner types B, C and D, measured on the same corners

![The path of the centre around one corner in types B, C and D](corners.svg)

`python -m tests.benchmarks.patent_table` writes this page; the figures of every run are in
[d-type-table.log](d-type-table.log).

Regular polygons of {side:g} mm sides (and a rhombus, whose corners turn by 150° and 30°) are milled
from outside on LinuxCNC ({version}), headless, with its own planner: G64 P0.005,
axes of 8,000 mm/s² and 1,500 mm/s, k = {k:g}.  Times are servo periods of 1 ms that LinuxCNC's
`sampler` counted.

- **path** is the length of the centre's path once around the polygon.
- **lap** is the time of one turn around the polygon.
- **contact** is the mean time for which the disc touches one corner, that is, its centre is within
  r + {touch:g} mm of the corner.  A long contact burns the corner, as the patent states.
  Part of it is the path along the sides before B₀ and after E₀, in every type.
- **slowest** is the least speed within 1.5 r of a corner.

Claims of the patent, and the results of {count} cases:

- D is longer than B and shorter than C: in all {count}, by construction.
- D leaves the corner sooner than B: in {smoother} of {count}.
- D is quicker than C, which stops at its bends: in {quicker} of {count}.
- B is quicker than D, whose arc is tighter: in {lost} of {count}.  So D is not chosen for its
  time: "auto" selects B unless its contact would burn the corner, and D then.

`compensation/corner.py` computes the additional time of D over B at a corner with an error of
{d_off:.1f} ms (median) and {d_worst:.1f} ms (largest), and that of C with
{c_off:.1f} and {c_worst:.1f} ms.  LinuxCNC uses √3/2 of the acceleration on arcs (83 mm/s at
r 1 mm, the model 89), and blends the stops of C slightly.

| turn | r mm | feed m/min | path B mm | C | D | lap B ms | C | D | contact B ms | C | D \
| slowest B mm/s | C | D |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
{rows}
"""


def check(rows: list[Row]) -> None:
    """Assert that the measured path lengths agree with the table of the patent."""
    for row in rows:
        turn = np.radians(row.shape.turns)
        around = corner_lengths(turn, row.radius, np.full(len(turn), K))[:, row.corner].sum()
        assert abs(row.path_length - SIDE * len(turn) - around) < 1e-6


async def measure_all(machine: linuxcnc_machine.Machine) -> list[Row]:
    """Measure all shapes, radii, feeds and corner types."""
    controller = await dial(machine.address)
    rows: list[Row] = []
    for shape, radius, feed, corner in product(SHAPES, RADII, FEEDS, Corner):
        rows.append(await measure(machine, controller, shape, radius, feed, corner))
        print(rows[-1].line(), flush=True)
    await controller.close()
    return rows


def main() -> None:
    """Measure all shapes, radii, feeds and corner types; write the table and its log."""
    reason = linuxcnc_machine.missing_requirement()
    if reason:
        raise SystemExit(reason)
    version = subprocess.run(
        ["dpkg-query", "-W", "-f=${Version}", "linuxcnc-uspace"],
        capture_output=True, text=True, check=False,
    ).stdout or "of unknown version"  # fmt: skip
    with linuxcnc_machine.running(load.machine("router-table")) as machine:
        machine.make_ready()
        rows = asyncio.run(measure_all(machine))
    check(rows)
    head = HEADER.format(version=version, side=SIDE, k=K)
    log = head + "".join(f"{row.line()}\n" for row in rows)
    (DOCS / "d-type-table.log").write_text(log, "utf-8")
    (DOCS / "d-type-table.md").write_text(table(rows, version), "utf-8")


if __name__ == "__main__":
    main()
