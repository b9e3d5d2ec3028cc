"""The selection of edges that may have another line beside them loses no finding."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.verdict import Finding
from knifetip.verification.checks.lines import near_lines
from knifetip.verification.checks.lines.edges_beside import edges_beside
from knifetip.verification.expectation.edges import place_edges
from knifetip.verification.findings import Findings
from tests.support.shapes import BOARD, MACHINE, closed, dieline, edges

KINDS = (LineType.CUT, LineType.CREASE, LineType.V_GROOVE, LineType.HALF_CUT)


def random_lines(seed: int) -> Dieline:
    """Return short lines and arcs at a few angles on a small area, of all line types."""
    random = np.random.default_rng(seed)
    groups, bulge, count = [], {}, 0
    for kind in KINDS:
        for _ in range(12):
            x, y = random.uniform(0.0, 60.0, 2)
            angle = np.radians(random.choice([0.0, 0.0, 5.0, 14.0, 16.0, 90.0, 97.0]))
            size = random.uniform(4.0, 40.0)
            end = (x + size * np.cos(angle), y + size * np.sin(angle))
            groups.append((kind, edges(((x, y), end))))
            if random.uniform() < 0.2:
                bulge[count] = float(random.choice([-0.4, 0.05, 1.0]))
            count += 1
    return dieline(*groups, bulge=bulge)


def findings(line: Dieline, machine: Machine) -> list[Finding]:
    context: Any = SimpleNamespace(
        edges=place_edges(line, (0.0, 0.0)), board=BOARD, machine=machine, findings=Findings()
    )
    near_lines.check_near_lines(context)
    return list(context.findings.sorted())


@pytest.mark.parametrize("seed", range(12))
def test_no_finding_is_lost(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    line = random_lines(seed)
    # Without a V-cutter the caliper is the greatest distance of all.
    machine = MACHINE if seed % 2 else replace(MACHINE, stations=MACHINE.stations[:2])
    selected = findings(line, machine)
    monkeypatch.setattr(near_lines, "edges_beside", lambda some, *_: np.ones(len(some), np.bool_))
    assert len(selected) >= 2
    assert selected == findings(line, machine)


def beside(line: Dieline, limit: float) -> list[bool]:
    limits = np.full((len(LineType), len(LineType)), limit)
    return list(edges_beside(place_edges(line, (0.0, 0.0)), limits, 1e-4, 15.0))


def test_panels_with_gaps_of_the_limit_have_nothing_beside_them() -> None:
    panels = [
        (kind, closed((x, 0.0), (x + 10.0, 0.0), (x + 10.0, 10.0), (x, 10.0)))
        for x, kind in ((0.0, LineType.CUT), (12.0, LineType.CREASE))
    ]
    assert not any(beside(dieline(*panels), 2.0))
    assert beside(dieline(*panels), 2.01) == [False, True, False, False, False, False, False, True]


@pytest.mark.parametrize(
    ("start", "end", "is_beside"),
    [
        ((10.0, 1.0), (20.0, 1.0), True),
        ((10.0, 3.0), (20.0, 3.0), False),  # too far away
        ((101.0, 1.0), (120.0, 1.0), False),  # past its end
        ((100.0, 0.0), (10.0, 2.0), False),  # with a common end
        ((10.0, 1.0), (11.0, 1.4), False),  # at 22°
        ((10.0, 3.0), (90.0, -3.0), True),  # across at 4°, all ends far away
        ((-10.0, 4.0), (10.0, 1.0), True),  # nearer than the limit at one end only
    ],
)
def test_lines_are_beside_a_line_of_100_mm(
    start: tuple[float, float], end: tuple[float, float], is_beside: bool
) -> None:
    line = dieline((LineType.CUT, edges(((0.0, 0.0), (100.0, 0.0)), (start, end))))
    assert beside(line, 2.0)[0] == is_beside
