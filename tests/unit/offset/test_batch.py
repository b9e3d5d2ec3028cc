"""Offsets on several cores equal those on one core, bit for bit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from knifetip.errors import ZeroLengthEdge
from knifetip.geometry import parallel
from knifetip.geometry.path import Paths
from knifetip.offset import batch
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from tests.support.shapes import paths as paths_of


def notched(count: int) -> Paths:
    """Squares of 20 mm side by side, each with a slit of 1 mm where a tool of 2 mm does not fit."""
    corners = np.array(
        [(0, 0), (20, 0), (20, 20), (10.5, 20), (10.5, 12), (9.5, 12), (9.5, 20), (0, 20)], float
    )
    start = (corners + np.arange(count)[:, None, None] * (30.0, 0.0)).reshape(-1, 8, 2)
    bulge = np.zeros((count, 8))
    bulge[::2, 0] = -0.2
    end = np.roll(start, -1, axis=1)
    return paths_of(
        start.reshape(-1, 2), end.reshape(-1, 2), bulge.reshape(-1), np.arange(count + 1) * 8
    )


def offset_on_cores(
    number: int, monkeypatch: pytest.MonkeyPatch, *args: Any, **options: Any
) -> OffsetPaths:
    """Return the offset of paths, computed on a number of cores."""
    monkeypatch.setattr(batch, "_MIN_SEGMENTS", 8)
    monkeypatch.setattr("os.cpu_count", lambda: number)
    return offset_paths(*args, **options)


@pytest.mark.parametrize("number", [2, 3, 7, 64])
def test_several_cores_give_the_result_of_one(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    paths = notched(41)
    side = np.where(np.arange(41) % 3 == 0, 1, -1)
    one = offset_on_cores(1, monkeypatch, paths, 2.0, side)
    many = offset_on_cores(number, monkeypatch, paths, 2.0, side)
    for name in ("start", "end", "bulge", "first"):
        assert np.array_equal(getattr(one.paths, name), getattr(many.paths, name)), name
    for name in ("source", "inserted", "owner", "unreached"):
        assert np.array_equal(getattr(one, name), getattr(many, name)), name
    # Of the slit's 8 mm² the disc reaches a circular segment 1 mm wide: 0.0425 mm².
    assert many.unreached[side == -1] == pytest.approx(8.0 - 0.0424752, abs=1e-6)


def test_paths_of_one_region_stay_together(monkeypatch: pytest.MonkeyPatch) -> None:
    paths, group = notched(40), np.arange(40) // 4
    one = offset_on_cores(1, monkeypatch, paths, 6.0, -1, group=group)
    many = offset_on_cores(3, monkeypatch, paths, 6.0, -1, group=group)
    # They are 10 mm apart: a tool of radius 6 mm does not pass, and its paths cross.
    assert len(one.paths) == len(many.paths) == 10
    assert np.array_equal(one.paths.start, many.paths.start)


def test_of_several_failures_the_first_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    paths = notched(40)
    end, start = paths.end.copy(), paths.start.copy()
    for path in (35, 12, 27):
        end[8 * path + 1] = start[8 * path + 1]
        start[8 * path + 2] = start[8 * path + 1]
    with pytest.raises(ZeroLengthEdge) as caught:
        offset_on_cores(4, monkeypatch, Paths(start, end, paths.bulge, paths.first), 2.0, -1)
    assert caught.value.message.arguments["edges"] == (97,)


def test_a_small_batch_uses_one_core(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.cpu_count", lambda: 8)
    monkeypatch.setattr(parallel, "ThreadPoolExecutor", None)
    assert len(offset_paths(notched(100), 2.0, -1).paths) == 100
