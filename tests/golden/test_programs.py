"""The program of a small job in each language, byte for byte: three stations, arcs, a V-groove."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from knifetip.library.load import machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.emit import process
from tests.support.programs import laser
from tests.support.shapes import toolpath

QUARTER = np.tan(np.pi / 8)
R, P, F, S, L = Motion.RAPID, Motion.PLUNGE, Motion.FEED, Motion.SWIVEL, Motion.LIFT

#: Station, motion, x, y, z and c at the end, bulge, and feed of each move.
MOVES: list[tuple[int, Motion, float, float, float, float, float, float]] = [
    (2, R, 150, 73.9, 20, 90, 0, 0),
    (2, P, 150, 73.9, 1.6, 90, 0, 6000),
    (2, F, 150, 126.1, 1.6, 90, 0, 30000),
    (2, L, 150, 126.1, 20, 90, 0, 6000),
    (3, R, 209.2, 91.5, 20, 90, 0, 0),
    (3, R, 209.2, 91.5, 4, 90, 0, 0),
    (3, P, 206, 91.5, 0.8, 90, 0, 3000),
    (3, F, 206, 111.5, 0.8, 90, 0, 12000),
    (3, L, 209.2, 111.5, 4, 90, 0, 3000),
    (3, R, 209.2, 111.5, 20, 90, 0, 0),
    (1, R, 120, 70, 20, 0, 0, 0),
    (1, P, 120, 70, -0.3, 0, 0, 6000),
    (1, F, 210, 70, -0.3, 0, 0, 24000),
    (1, F, 220, 80, -0.3, 90, QUARTER, 24000),
    (1, F, 220, 130, -0.3, 90, 0, 24000),
    (1, S, 220, 130, -0.3, 180, 0, 72000),
    (1, F, 120, 130, -0.3, 180, 0, 24000),
    (1, F, 120, 70, -0.3, 360, 1, 24000),
    (1, L, 120, 70, 20, 360, 0, 6000),
]


def small_job() -> Toolpath:
    poses = [(0.0, 0.0, 20.0, 0.0), *[(x, y, z, c) for _, _, x, y, z, c, _, _ in MOVES]]
    rows = [(motion, feed, station) for station, motion, *_, feed in MOVES]
    return toolpath(poses, rows, bulge=[move[6] for move in MOVES])


def small_program(dialect: str, path: Toolpath | None = None) -> bytes:
    notes = ["placement X20.0000 Y20.0000", "board greyboard-2.0 caliper 2.0"]
    return process(path or small_job(), machine("demo-table"), dialect, notes=notes).text


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_the_small_job_equals_its_golden_program(
    dialect: str, golden: Callable[[str, bytes], None]
) -> None:
    golden(f"small-job-{dialect}.ngc", small_program(dialect))


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_the_laser_job_equals_its_golden_program(
    dialect: str, golden: Callable[[str, bytes], None]
) -> None:
    golden(f"laser-job-{dialect}.ngc", laser.program(dialect).text)


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
def test_a_change_of_a_tenth_of_a_micrometre_fails(
    dialect: str, golden: Callable[[str, bytes], None], request: pytest.FixtureRequest
) -> None:
    if request.config.getoption("--accept", default=False):
        pytest.skip("the golden files are being written")
    path = small_job()
    pose = np.array(path.pose)
    pose[13, 0] += 0.0001
    with pytest.raises(pytest.fail.Exception, match=r"\+G1 X210\.0001"):
        golden(f"small-job-{dialect}.ngc", small_program(dialect, replace(path, pose=pose)))
