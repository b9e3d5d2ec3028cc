"""Runs of machines: statistics, the use of tools, and the history of ended jobs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any
from zoneinfo import ZoneInfo

import numpy as np
import pytest

from knifetip.contract.job import Actor, ActorKind
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.history.statistics_store import period_start
from knifetip.service.history.store import HistoryFilter
from knifetip.service.store import Store
from knifetip.service.tools.worked_lengths import lengths_until, pack_lengths
from tests.support.job_states import LINES, RESULT, compiling
from tests.support.stored import Clock

MIA = Actor(ActorKind.OPERATOR, "Mia")
UTC = ZoneInfo("UTC")
QUARTER = math.tan(math.pi / 8.0)

#: X and Y of the poses, and the moves between them: bulge, motion, edge, station, program line.
POINTS = [(0, 0), (0, 0), (300, 0), (300, 100), (300, 100), (0, 100), (0, 100), (100, 200), (0, 0)]
MOVES = [
    (0.0, Motion.PLUNGE, -1, 1, 10),
    (0.0, Motion.FEED, 0, 1, 20),  # 300 mm of cut
    (0.0, Motion.FEED, 0, 1, 30),  # 100 mm of cut
    (0.0, Motion.LIFT, -1, 1, 40),
    (0.0, Motion.RAPID, -1, 2, 50),
    (0.0, Motion.PLUNGE, -1, 2, 60),
    (QUARTER, Motion.FEED, 1, 2, 200),  # a quarter of a circle with a radius of 100 mm, creased
    (0.0, Motion.RAPID, -1, 2, LINES),
]
ARC = 50.0 * math.pi


def table() -> bytes:
    bulge, motion, source, tool, line = map(np.array, zip(*MOVES, strict=True))
    pose = np.zeros((len(POINTS), 4))
    pose[:, :2] = POINTS
    path = Toolpath(
        pose=pose,
        bulge=bulge,
        motion=motion.astype(np.uint8),
        feed=np.zeros(len(MOVES)),
        source=source.astype(np.int32),
        tool=tool.astype(np.uint8),
        track=np.zeros(len(MOVES), np.int32),
    )
    kinds = np.array([LineType.CUT, LineType.CREASE], np.uint8)
    return pack_lengths(path, line.astype(np.int32), kinds)


RESULT_WITH_LENGTHS = replace(RESULT, lengths=table())


@pytest.fixture(scope="module")
def machine() -> Machine:
    """Return the demo table with a life of 1 m for the tool in station 1."""
    demo = load.machine("demo-table", files=False)
    first, *others = demo.stations
    return replace(demo, name="table", stations=(replace(first, life=1.0), *others))


def run(store: Store, **more: object) -> Job:
    """Return a running job whose program has worked lengths."""
    job = compiling(store, release=True, **more)
    store.compiles.save_result(job.id, job.epoch, RESULT_WITH_LENGTHS)
    claimed = store.gateways.claim("table", "gateway", manual=False)
    assert claimed is not None
    return claimed


def used(store: Store, machine: Machine) -> dict[int, float]:
    return {use.station: use.used for use in store.tools.uses(machine)}


# Lengths


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (0, {}),
        (19, {}),
        (20, {(1, "cut"): 300.0}),
        (199, {(1, "cut"): 400.0}),
        (200, {(1, "cut"): 400.0, (2, "crease"): ARC}),
        (None, {(1, "cut"): 400.0, (2, "crease"): ARC}),
    ],
)
def test_the_worked_length_ends_at_the_executed_line(
    line: int | None, expected: dict[tuple[int, str], float]
) -> None:
    assert lengths_until(table(), line) == pytest.approx(expected)


def test_a_program_of_an_older_version_has_no_lengths() -> None:
    assert lengths_until(None) == {}


# Use of tools


def test_a_completed_copy_counts_whole_and_an_interrupted_one_to_its_line(
    store: Store, machine: Machine
) -> None:
    job = run(store, copies=3)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=25, copies_done=1)
    assert used(store, machine) == pytest.approx({1: 700.0, 2: ARC, 3: 0.0})
    store.interrupted.requeue(job.id)
    again = store.gateways.claim("table", "gateway", manual=False)
    assert again is not None
    store.gateways.finish(again.id, again.epoch, "done")
    assert used(store, machine) == pytest.approx({1: 1500.0, 2: 3.0 * ARC, 3: 0.0})


def test_a_running_job_counts_up_to_the_reported_line(store: Store, machine: Machine) -> None:
    job = run(store, copies=2)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=30))
    assert used(store, machine)[1] == pytest.approx(400.0)
    # Between two copies the last line is that of the completed copy.
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=LINES, copies_done=1))
    assert used(store, machine)[1] == pytest.approx(400.0)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=20, copies_done=1))
    assert used(store, machine)[1] == pytest.approx(700.0)


def test_a_late_report_corrects_the_length(store: Store, machine: Machine, clock: Clock) -> None:
    job = run(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=20))
    clock.now += 60.0
    store.leases.run()
    assert used(store, machine)[1] == pytest.approx(300.0)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=30)
    assert used(store, machine)[1] == pytest.approx(400.0)
    clock.now += 1000.0
    store.interrupted.declare_finished(job.id)
    assert used(store, machine) == pytest.approx({1: 400.0, 2: ARC, 3: 0.0})
    (sums,) = store.statistics.sums(0.0, 1e10, "day", UTC)
    assert (sums.runs, sums.jobs, sums.interruptions, sums.seconds) == (1, 1, 0, 60.0)


def test_a_late_report_of_an_ended_run_is_not_counted_for_a_new_tool(
    store: Store, machine: Machine, clock: Clock
) -> None:
    job = run(store)
    store.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=20))
    clock.now += 60.0
    store.leases.run()
    clock.now += 1.0
    store.tools.record_change(machine, 1, MIA)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=30)
    assert used(store, machine)[1] == 0.0
    clock.now += 1.0
    store.interrupted.declare_finished(job.id)
    assert used(store, machine) == pytest.approx({1: 0.0, 2: ARC, 3: 0.0})
    again = run(store)
    clock.now += 1.0
    store.gateways.finish(again.id, again.epoch, "done")
    assert used(store, machine) == pytest.approx({1: 400.0, 2: 2.0 * ARC, 3: 0.0})


def test_warnings_come_at_nine_tenths_and_at_the_end_of_the_life(
    store: Store, machine: Machine, clock: Clock
) -> None:
    def state() -> tuple[float, str]:
        use = store.tools.uses(machine)[0]
        return round(use.share, 3), use.warning

    job = run(store, copies=2)
    store.gateways.finish(job.id, job.epoch, "done")
    assert state() == (0.8, "")
    store.tools.set_life(machine, 1, 800.0 / 0.9, MIA)
    assert state() == (0.9, "near")
    store.tools.set_life(machine, 1, 800.0, MIA)
    assert state() == (1.0, "over")
    store.tools.set_life(machine, 1, 0.0, MIA)
    assert state() == (0.0, "")
    clock.now += 1.0
    use, *_ = store.tools.record_change(machine, 1, MIA)
    assert (use.used, use.changed, use.changed_by) == (0.0, clock.now, "operator Mia")
    changed, *lives = store.tools.events("table")
    assert (changed.kind, changed.who, changed.length) == ("changed", "operator Mia", 800.0)
    assert len(lives) == 3


# Statistics


def test_statistics_agree_with_a_count_by_hand(store: Store, clock: Clock) -> None:
    day = 86_400.0
    clock.now = 20_000.0 * day + 100.0
    for copies, board in ((2, "e-flute"), (1, "b-flute")):
        job = run(store, copies=copies, board=board)
        clock.now += 30.0
        store.gateways.finish(job.id, job.epoch, "done")
    job = run(store)
    clock.now += 10.0
    store.gateways.finish(job.id, job.epoch, "interrupted", line=20)
    store.interrupted.scrap(job.id)
    clock.now += day
    job = run(store)
    clock.now += 5.0
    store.gateways.finish(job.id, job.epoch, "cancelled", line=0)
    first, second = store.statistics.sums(0.0, 1e10, "day", UTC)
    assert (first.machine, first.start) == ("table", 20_000.0 * day)
    assert (first.jobs, first.copies, first.runs, first.interruptions) == (2, 3, 3, 1)
    assert first.seconds == pytest.approx(70.0)
    assert first.sheets == {"e-flute": 3, "b-flute": 1}
    assert first.lengths == pytest.approx({"cut": 3 * 400.0 + 300.0, "crease": 3 * ARC})
    assert (second.jobs, second.copies, second.runs, second.sheets) == (0, 0, 1, {})
    assert store.statistics.sums(0.0, 1e10, "day", UTC, "other") == []
    assert store.statistics.sums(0.0, 20_001.0 * day, "day", UTC) == [first]


@pytest.mark.parametrize(
    ("step", "expected"),
    [("day", "2026-03-29"), ("week", "2026-03-23"), ("month", "2026-03-01")],
)
def test_periods_begin_at_midnight_of_the_zone(step: str, expected: str) -> None:
    from datetime import datetime

    zone = ZoneInfo("Europe/Berlin")
    # The clocks are set forward on this Sunday.
    at = datetime(2026, 3, 29, 23, 30, tzinfo=zone).timestamp()
    # arg-type: pytest passes the literals of `step` as str.
    begin = datetime.fromtimestamp(period_start(at, step, zone), zone)  # type: ignore[arg-type]
    assert (begin.strftime("%Y-%m-%d"), begin.hour) == (expected, 0)


# History


def ended(store: Store, clock: Clock, outcome: str = "done", **more: object) -> Job:
    clock.now += 10.0
    job = run(store, **more)
    store.gateways.finish(job.id, job.epoch, outcome)
    if outcome == "interrupted":
        store.interrupted.scrap(job.id)
    return store.jobs.get(job.id)


def test_history_lists_ended_jobs_by_their_end(store: Store, clock: Clock) -> None:
    first = ended(store, clock)
    second = ended(store, clock, "interrupted", board="b-flute")
    third = ended(store, clock, "cancelled")
    run(store)

    def found(**conditions: Any) -> list[str]:
        rows = store.history.search(HistoryFilter(**conditions), None, 10)
        return [row.id for row in rows]

    assert found() == [third.id, second.id, first.id]
    assert found(states=["scrapped", "done"]) == [second.id, first.id]
    assert found(board="b-flute") == [second.id]
    assert found(machine="other") == []
    assert found(drawing="TRAY") == [third.id, second.id, first.id]
    assert found(drawing="%") == []
    assert found(since=second.ended, until=third.ended) == [second.id]
    page = store.history.search(HistoryFilter(), None, 2)
    rest = store.history.search(HistoryFilter(), (page[-1].ended, page[-1].serial), 2)
    assert [row.id for row in (*page, *rest)] == [third.id, second.id, first.id]


def test_old_jobs_are_deleted_and_their_statistics_are_kept(
    store: Store, clock: Clock, machine: Machine
) -> None:
    old, new = ended(store, clock), ended(store, clock)
    before = store.statistics.sums(0.0, 1e10, "day", UTC), used(store, machine)
    assert store.history.delete_before(new.ended) == 1
    assert [row.id for row in store.history.search(HistoryFilter(), None, 10)] == [new.id]
    # The events remain, so that the log still contains every action with its user.
    assert [event.state for event in store.events.of_job(old.id)][-1] == "done"
    assert (store.statistics.sums(0.0, 1e10, "day", UTC), used(store, machine)) == before


def test_a_job_that_cannot_be_saved_is_kept_and_does_not_hold_back_the_others(
    store: Store, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.service.history.store._BATCH", 2)
    jobs = [ended(store, clock).id for _ in range(5)]
    lost = jobs[:2]
    offered: list[str] = []

    def save(ids: Sequence[str]) -> list[str]:
        offered.extend(ids)
        return [id for id in ids if id not in lost]

    assert store.history.delete_before(clock.now + 1e6, save) == 3
    assert offered == jobs
    left = store.history.search(HistoryFilter(), None, 10)
    assert sorted(row.id for row in left) == sorted(lost)


def test_an_interrupted_job_is_never_deleted(store: Store, clock: Clock) -> None:
    job = run(store)
    store.gateways.finish(job.id, job.epoch, "interrupted", line=3)
    assert store.history.delete_before(clock.now + 1e6) == 0
    assert store.jobs.get(job.id).state == "interrupted"
