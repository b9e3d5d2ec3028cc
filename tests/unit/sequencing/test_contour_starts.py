"""The starts of closed paths are the best ones for the order of the paths."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline, toolpaths
from knifetip.library import load
from knifetip.model.contour_starts import ContourStarts
from knifetip.model.dieline import Dieline, LineType
from knifetip.sequencing import contour_starts
from knifetip.sequencing.contour_starts import choose_starts
from knifetip.sequencing.head import parking_pose
from knifetip.sequencing.nearest import nearest_neighbour
from knifetip.sequencing.order import link_times
from tests.support.cartons.known_size import drawing_of
from tests.support.shapes import closed, dieline

MACHINE = load.machine("demo-table")
STATION = MACHINE.stations[0]


@pytest.mark.parametrize("seed", range(5))
def test_no_other_starts_are_better_in_the_same_order(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(contour_starts, "_ROUNDS", 1)
    random = np.random.default_rng(seed)
    first = np.array([0, 3, 4, 6, 9, 12])
    entry, leave = (
        np.column_stack([random.uniform(0, 300, (12, 2)), random.uniform(-400, 400, 12)])
        for _ in range(2)
    )
    starts = ContourStarts(first, 10 * np.arange(12, dtype=np.int32), entry, leave)
    chosen = choose_starts(starts, STATION, MACHINE) // 10
    head = parking_pose(STATION, MACHINE)[[0, 1, 3]]
    axes = [MACHINE.x, MACHINE.y, MACHINE.c]
    pace = np.array([[axis.velocity for axis in axes], [axis.acceleration for axis in axes]])
    near = [
        low
        + link_times(entry[low:high], np.tile(head, (high - low, 1)), head, pace, 360.0).argmin()
        for low, high in itertools.pairwise(first.tolist())
    ]
    order = nearest_neighbour(entry[near, :2], leave[near, :2], head[:2])

    def time(rows: tuple[int, ...]) -> float:
        some = np.array(rows)[order]
        return float(link_times(entry[some], leave[some], head, pace, 360.0).sum())

    best = min(time(rows) for rows in itertools.product(*map(range, first[:-1], first[1:])))
    assert time(tuple(chosen.tolist())) == pytest.approx(best, abs=1e-12)


def test_a_single_start_is_returned() -> None:
    starts = ContourStarts(np.array([0, 1]), np.array([7]), np.zeros((1, 3)), np.zeros((1, 3)))
    assert choose_starts(starts, STATION, MACHINE).tolist() == [7]


def test_one_path_starts_nearest_to_the_parking_position_whatever_its_first_edge_is() -> None:
    corner = np.array([[400.0, 300.0], [100.0, 300.0], [100.0, 80.0], [400.0, 80.0]])
    for turned in range(4):
        pose = np.column_stack([np.roll(corner, turned, axis=0), np.zeros(4)])
        starts = ContourStarts(np.array([0, 4]), np.arange(4, dtype=np.int32), pose, pose)
        begin = int(choose_starts(starts, STATION, MACHINE)[0])
        assert pose[begin, :2].tolist() == [100.0, 80.0]


def cartons(count: int) -> Dieline:
    """Return ``count`` triangles in a row, of different sizes and orientations."""
    random = np.random.default_rng(count)
    turn = random.uniform(0, 2 * np.pi, count)[:, None] + np.array([0.0, 2.0, 4.0])
    radius = random.uniform(20, 40, (count, 1, 1))
    corner = radius * np.stack([np.cos(turn), np.sin(turn)], axis=2)
    corner[..., 0] += 60.0 + 100.0 * np.arange(count)[:, None]
    shapes = [closed(*map(tuple, each.tolist())) for each in corner]
    return dieline((LineType.CUT, np.concatenate(shapes)))


@pytest.mark.parametrize("machine", ["demo-table", "laser-table", "router-table"])
def test_programs_with_chosen_starts_are_faster_and_accepted(
    machine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn, board = cartons(8), load.board("greyboard-2.0")
    job = replace(drawing_of(drawn.ends), unit="mm"), drawn, load.machine(machine), board
    chosen = pipeline.compile(*job)
    assert chosen.verdict.accepted, chosen.verdict.findings
    monkeypatch.setattr(toolpaths, "contour_starts", lambda operation: None)
    assert chosen.seconds < pipeline.compile(*job).seconds - 1e-3
