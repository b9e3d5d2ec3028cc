"""Turns and order: the bench of ``order``, and the tables of backend/docs/turning.md.

    python -m tests.benchmarks.turning        writes the page anew

The seconds on it come from ``duration``, which the tests hold against the simulated table; only the
last column of the second table is this computer's.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from knifetip.compensation.compensate import compensate
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.tool import Reversal
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.planning.placement import placement
from knifetip.planning.plan import plan
from knifetip.sequencing.air_moves import with_full_retracts
from knifetip.sequencing.duration import duration
from knifetip.sequencing.order import greedy_order, link_times, short_order
from knifetip.sequencing.sequence import sequence
from tests.support.shapes import closed, dieline
from tests.support.truth.named import NAMED, SAMPLES, Named

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "backend" / "docs" / "turning.md"
CORPUS = Path(os.environ.get("KNIFETIP_CORPUS", ROOT.parent / "shared" / "corpus"))
MACHINE = load.machine("demo-table")
HOME = np.zeros(3)
_AXES = (MACHINE.x, MACHINE.y, MACHINE.c)
PACE = np.array([[axis.velocity for axis in _AXES], [axis.acceleration for axis in _AXES]])
#: Axes that need no time to start, and a C that needs none at all: time is distance.
DISTANCE = np.array([[1.0, 1.0, 1e9], [1e9, 1e9, 1e12]])


def strokes(count: int, way: Reversal) -> tuple[F64, F64]:
    """Strokes of 20 mm at every heading on a square metre, run from either end."""
    random = np.random.default_rng(1)
    start, azimuth = random.uniform(0, 1000, (count, 2)), random.uniform(0, 360, count)
    ahead = np.column_stack([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    begin = np.column_stack([start, azimuth])
    finish = np.column_stack([start + 20.0 * ahead, azimuth])
    if way == Reversal.ONE:
        return np.stack([begin, begin]), np.stack([finish, finish])
    return np.stack([begin, finish]), np.stack([finish, begin])


def order_shortest() -> tuple[str, int, Callable[[], object], dict[str, Callable[[], object]], int]:
    """Order reversible tracks, greedily and then shorter."""
    entry, leave = strokes(1000, Reversal.EITHER)
    return (
        "reversible tracks, 2-opt + Or-opt + swaps",
        1000,
        lambda: short_order(entry, leave, HOME, PACE, 180.0, Reversal.EITHER),
        {"greedy": lambda: greedy_order(entry, leave, HOME, Reversal.EITHER)},
        3,
    )


def _saved(named: Named) -> Iterator[str]:
    """Yield the row of a drawing: turns, seconds with full retracts and with the least lift."""
    _, drawn, board = named.classified(CORPUS)
    placed = replace(drawn, ends=drawn.ends + np.array(placement(drawn, MACHINE)))
    toolpaths = [compensate(operation) for operation in plan(placed, MACHINE, board)]
    path = sequence(toolpaths, MACHINE)
    full, least = duration(with_full_retracts(path, MACHINE), MACHINE), duration(path, MACHINE)
    yield (
        f"| {named} | {_turns(path)} | {full:.1f} | {least:.1f} | "
        f"{full - least:.1f} | {100.0 * (full - least) / full:.0f} % |"
    )


def _turns(path: Toolpath) -> int:
    """Return how many rapids run below travel height."""
    low = (path.pose[:-1, 2] < MACHINE.travel_z) & (path.pose[1:, 2] < MACHINE.travel_z)
    return int(((path.motion == Motion.RAPID) & low).sum())


def _grooves() -> Iterator[str]:
    """Yield the row of a pre-cut board whose grooves run out on both sides."""
    lines = np.array([[(80.0, y), (520.0, y)] for y in np.arange(50.0, 350.0, 30.0)])
    corners = closed((100, 20), (500, 20), (500, 380), (100, 380))
    outline = Paths(corners[:, 0], corners[:, 1], np.zeros(4), np.array([0, 4]))
    board = load.board("greyboard-2.0")
    work = [compensate(plan(dieline((LineType.V_GROOVE, lines)), MACHINE, board)[0])]
    above = sequence(work, MACHINE)
    full, least = duration(with_full_retracts(above, MACHINE), MACHINE), duration(above, MACHINE)
    outside = duration(sequence(work, MACHINE, outline), MACHINE)
    yield f"| full retract at every turn | {full:.2f} | |"
    yield f"| least lift above the board | {least:.2f} | {100 * (full - least) / full:.0f} % |"
    yield f"| no lift outside the board | {outside:.2f} | {100 * (full - outside) / full:.0f} % |"


def _metres(into: F64, out: F64) -> float:
    before = np.concatenate([HOME[None], out[:-1]])
    return float(np.hypot(*(into - before)[:, :2].T).sum()) / 1000.0


def _orders() -> Iterator[str]:
    """Yield how long the links of 1,000 strokes are, greedily and shortest."""
    for way, period, ends in (
        (Reversal.EITHER, 180.0, "either end"),
        (Reversal.ONE, 360.0, "one end"),
    ):
        entry, leave = strokes(1000, way)
        for what, pace, unit in (("time", PACE, "s"), ("distance", DISTANCE, "m")):
            short_order(entry, leave, HOME, pace, period, way)
            begin = time.perf_counter()
            found = short_order(entry, leave, HOME, pace, period, way)
            took = time.perf_counter() - begin
            totals = []
            for order, flip in (greedy_order(entry, leave, HOME, way), found):
                side = flip.astype(np.int64)
                into, out = entry[side, order], leave[side, order]
                totals.append(
                    float(link_times(into, out, HOME, pace, period).sum())
                    if unit == "s"
                    else _metres(into, out)
                )
            first, best = totals
            yield (
                f"| {ends} | {what} | {first:.1f} {unit} | {best:.1f} {unit} | "
                f"{100.0 * (first - best) / first:.0f} % | {took:.2f} s |"
            )


def main() -> None:
    """Write the page."""
    rows: list[str] = []
    for named in SAMPLES + (NAMED if CORPUS.is_dir() else ()):
        rows.extend(_saved(named))
    text = TEXT.format(
        saved="\n".join(rows), grooves="\n".join(_grooves()), orders="\n".join(_orders())
    )
    PAGE.write_text(text)
    print(text)


TEXT = """# Turning between tracks

From the end of one track to the start of the next the head moves straight, C turns by the smaller
angle within its travel, and the tool is lifted along its own axis by the height at which it would
otherwise cut the board, plus the machine's clearance (`knifetip.sequencing.air_moves`, after the
turning paper, sections 1 to 3). It retracts fully only at tool changes.
`python -m tests.benchmarks.turning` writes this page.

## Time saved by the least lift

The same tracks in the same order on the demo table, once with a full retract to travel height
(20 mm) at every turn, between tracks and inside them, once with the least lift. Seconds by
`sequencing.duration`, which stays within 2 % of the simulated table on the samples. Three of them
on a headless LinuxCNC took 12 to 21 % longer than computed (23.2, 46.3 and 22.4 s instead of 19.2,
39.2 and 19.9): the blending of its planner is not modelled, only its exact stops.

| drawing | turns | full retracts, s | least lift, s | saved, s | saved |
|---|---|---|---|---|---|
{saved}

## Outside the board

If the outline of the board is given (`sequence(toolpaths, machine, outline)`), a tool whose tip
circle is off the board, and remains off it during the move, turns without a lift; it only keeps
clear of the mat. Ten V-grooves that run out on both sides of a pre-cut board:

| turns | s | saved |
|---|---|---|
{grooves}

The pipeline passes no outline: a drawing shows the blank, which is surrounded by the rest of the
sheet. The verifier assumes board everywhere too.

## Order of tracks

1,000 strokes of 20 mm on a square metre, ordered by the nearest end (greedy) and by the order that
knifetip uses (now). Time is the time of the slowest axis, C included, from rest to rest. Distance
is the same search with infinite acceleration and a free C, so that it minimises the larger of
X and Y; the table has the straight distance.

| strokes from | minimised | greedy | now | saved | computed in |
|---|---|---|---|---|---|
{orders}
"""

if __name__ == "__main__":
    main()
