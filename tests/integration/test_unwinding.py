"""A knife unwinds axis C where a contour turns beyond its limits."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import TravelExceeded
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.tool import Knife
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: tan(90° / 4), the bulge of a quarter circle to the left.
QUARTER = 0.41421356237309503

CUT = LineType.CUT


def comb(teeth: int, radius: float) -> Dieline:
    """Return a contour with rounded slots in its upper side, which turns on and on."""
    points: list[tuple[float, float]] = [(0, 0), (20.0 * teeth + 10, 0), (20.0 * teeth + 10, 60)]
    bulge: dict[int, float] = {}
    for tooth in range(teeth, 0, -1):
        x = 20.0 * tooth
        points += [(x, 60), (x, 60 - 30), (x - 2 * radius, 30), (x - 2 * radius, 60)]
        bulge[len(points) - 3] = -1.0
    return dieline((CUT, closed(*points, (0, 60))), bulge=bulge)


def rounded(width: float, height: float, radius: float) -> Dieline:
    """Return a rectangle with rounded corners, which begins with its lower side."""
    w, h, r = width, height, radius
    points = [(r, 0), (w - r, 0), (w, r), (w, h - r), (w - r, h), (r, h), (0, h - r), (0, r)]
    return dieline((CUT, closed(*points)), bulge=dict.fromkeys((1, 3, 5, 7), QUARTER))


def spiral(turns: int) -> Dieline:
    """Return an open cut of half circles that become larger."""
    points, x = [(300.0, 300.0)], 300.0
    for half in range(2 * turns):
        x += (10.0 + 5.0 * half) * (1 if half % 2 else -1)
        points.append((x, 300.0))
    lines = edges(*pairwise(points))
    return dieline((CUT, lines), bulge=dict.fromkeys(range(2 * turns), 1.0))


def compiled(line: Dieline, limit: float, dialect: str, knife: Knife | None = None) -> Compiled:
    """Compile a job for the demonstration table with C from -limit to +limit degrees."""
    machine = load.machine("demo-table")
    machine = replace(machine, c=replace(machine.c, low=-limit, high=limit))
    if knife:
        first = replace(machine.stations[0], tool=knife)
        machine = replace(machine, stations=(first, *machine.stations[1:]))
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    return pipeline.compile(lines, line, machine, load.board("greyboard-2.0"), dialect=dialect)


@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
@pytest.mark.parametrize("limit", [270.0, 360.0])
@pytest.mark.parametrize(
    "line", [comb(7, 3.0), rounded(200, 100, 10), spiral(4)], ids=["comb", "rounded", "spiral"]
)
def test_contours_are_unwound_at_lifts(line: Dieline, limit: float, dialect: str) -> None:
    made = compiled(line, limit, dialect)
    assert [finding.text for finding in made.verdict.findings if finding.refuses] == []
    assert np.abs(made.toolpath.pose[:, 3]).max() <= limit + 1e-6


@pytest.mark.parametrize("limit", [270.0, 360.0])
@pytest.mark.parametrize(
    "change", [{"trail": 5.0, "oscillating": False}, {"lead_in": 5.0, "lead_out": 5.0}]
)
def test_drag_knives_and_knives_with_leads_are_unwound(
    change: dict[str, Any], limit: float
) -> None:
    knife = load.machine("demo-table").stations[0].tool
    assert isinstance(knife, Knife)
    changed = replace(knife, **change)
    for line in (rounded(200, 100, 10), spiral(3)):
        made = compiled(line, limit, "grblhal", changed)
        assert [finding.text for finding in made.verdict.findings if finding.refuses] == []


def test_a_contour_within_the_limits_has_no_further_lift() -> None:
    plain = compiled(rounded(200, 100, 10), 1080.0, "grblhal").toolpath
    assert (plain.motion == Motion.LIFT).sum() == 1


def test_a_range_of_less_than_a_turn_is_refused() -> None:
    with pytest.raises(TravelExceeded):
        compiled(rounded(200, 100, 10), 90.0, "grblhal")
