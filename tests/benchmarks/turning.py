"""Benchmark of the order of tracks, and the tables of backend/docs/turning.md.

    python -m tests.benchmarks.turning        writes the page

Seconds on the page are computed by ``duration``, which the tests compare with the simulated table;
only the last column of the last table is time on this computer.
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
#: Axes without acceleration time, and a C axis that takes no time: time equals distance.
DISTANCE = np.array([[1.0, 1.0, 1e9], [1e9, 1e9, 1e12]])


def strokes(count: int, reversal: Reversal) -> tuple[F64, F64]:
    """Return entry and exit poses (x, y, azimuth) of random strokes of 20 mm, (2, n, 3) each.

    The first axis is the direction of travel: as drawn, and reversed if ``reversal`` permits it.
    """
    random = np.random.default_rng(1)
    start, azimuth = random.uniform(0, 1000, (count, 2)), random.uniform(0, 360, count)
    ahead = np.column_stack([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    begin = np.column_stack([start, azimuth])
    finish = np.column_stack([start + 20.0 * ahead, azimuth])
    if reversal == Reversal.ONE:
        return np.stack([begin, begin]), np.stack([finish, finish])
    return np.stack([begin, finish]), np.stack([finish, begin])


def order_shortest() -> tuple[str, int, Callable[[], object], dict[str, Callable[[], object]], int]:
    """Order reversible tracks: a greedy order, then its improvement."""
    entry, leave = strokes(1000, Reversal.EITHER)
    return (
        "reversible tracks, 3-opt + double bridges",
        1000,
        lambda: short_order(entry, leave, HOME, PACE, 180.0, Reversal.EITHER),
        {"greedy": lambda: greedy_order(entry, leave, HOME, Reversal.EITHER)},
        3,
    )


def _time_rows(named: Named) -> Iterator[str]:
    """Yield the table row of a drawing: turns, and seconds with full retracts and with least
    lifts.
    """
    _, drawn, board = named.classified(CORPUS)
    placed = replace(drawn, ends=drawn.ends + np.array(placement(drawn, MACHINE)))
    toolpaths = [compensate(operation) for operation in plan(placed, MACHINE, board)]
    path = sequence(toolpaths, MACHINE)
    full, least = duration(with_full_retracts(path, MACHINE), MACHINE), duration(path, MACHINE)
    yield (
        f"| {named} | {_count_turns(path)} | {full:.1f} | {least:.1f} | "
        f"{full - least:.1f} | {100.0 * (full - least) / full:.0f} % |"
    )


def _count_turns(path: Toolpath) -> int:
    """Return the number of rapids below travel height."""
    low = (path.pose[:-1, 2] < MACHINE.travel_z) & (path.pose[1:, 2] < MACHINE.travel_z)
    return int(((path.motion == Motion.RAPID) & low).sum())


def _groove_rows() -> Iterator[str]:
    """Yield the table rows of a pre-cut board whose grooves run out on both sides."""
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


def _order_rows() -> Iterator[str]:
    """Yield the table rows of the total length of air moves between 1,000 strokes."""
    for reversal, period, ends in (
        (Reversal.EITHER, 180.0, "either end"),
        (Reversal.ONE, 360.0, "one end"),
    ):
        entry, leave = strokes(1000, reversal)
        for quantity, pace, unit in (("time", PACE, "s"), ("distance", DISTANCE, "m")):
            short_order(entry, leave, HOME, pace, period, reversal)
            begin = time.perf_counter()
            shortest = short_order(entry, leave, HOME, pace, period, reversal)
            seconds = time.perf_counter() - begin
            totals = []
            for order, flip in (greedy_order(entry, leave, HOME, reversal), shortest):
                side = flip.astype(np.int64)
                into, out = entry[side, order], leave[side, order]
                totals.append(
                    float(link_times(into, out, HOME, pace, period).sum())
                    if unit == "s"
                    else _metres(into, out)
                )
            first, best = totals
            yield (
                f"| {ends} | {quantity} | {first:.1f} {unit} | {best:.1f} {unit} | "
                f"{100.0 * (first - best) / first:.0f} % | {seconds:.2f} s |"
            )


def main() -> None:
    """Write backend/docs/turning.md."""
    rows: list[str] = []
    for named in SAMPLES + (NAMED if CORPUS.is_dir() else ()):
        rows.extend(_time_rows(named))
    text = TEXT.format(
        saved="\n".join(rows), grooves="\n".join(_groove_rows()), orders="\n".join(_order_rows())
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

If a job states that its sheet was cut to size (`sheet`, `--sheet`), a tool that is off the sheet
by the machine's clearance, and remains so during the move, turns without a lift; it only keeps
clear of the mat ([decision 62](decisions/0062-turning.md)). Ten V-grooves that run out by 20 mm on
both sides of a pre-cut board:

| turns | s | saved |
|---|---|---|
{grooves}

Without a stated sheet there may be board everywhere, for the verifier too: a drawing shows the
blank, which is surrounded by the rest of the sheet.

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
