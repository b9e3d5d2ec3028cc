"""What makes the bodies of tools matter: bends, curves drawn as chords, and lines side by side."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Final

from tests.cartons.blank import Blank
from tests.cartons.features import Panel


def bent_crease(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a crease that is an arc."""
    x0, y0, x1, y1 = panel
    y = 0.5 * (y0 + y1)
    bulge = rng.choice([0.02, 0.1, 0.4, 1.0]) * min(1.0, (y1 - y0) / (x1 - x0))
    blank.path("crease", [(x0, y, bulge), (x1, y)])


def chord_circle(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a circle that is drawn as chords, in some cases over the true circle."""
    x0, y0, x1, y1 = panel
    r = rng.choice([0.3, 1.0, 3.0, 0.3 * min(x1 - x0, y1 - y0)])
    x, y, sides = 0.5 * (x0 + x1), 0.5 * (y0 + y1), rng.choice([24, 72, 360])
    turns = [2.0 * math.pi * k / sides for k in range(sides)]
    blank.path("cut", [(x + r * math.cos(a), y + r * math.sin(a)) for a in turns], closed=True)
    if rng.random() < 0.2:
        blank.circle("cut", x, y, r)


def small_holes(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a row of small holes."""
    x0, y0, x1, y1 = panel
    for k in range(4):
        blank.circle("cut", x0 + (k + 0.5) * (x1 - x0) / 4.0, 0.5 * (y0 + y1), 0.2 * 2.0**k)


def double_line(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a line twice, side by side."""
    x0, y0, x1, y1 = panel
    y, apart = 0.5 * (y0 + y1), rng.choice([0.004, 0.02, 0.04, 0.06, 0.3, t, 2.0 * t])
    kind = rng.choice(["cut", "crease", "half-cut", "v-groove"])
    other = kind if rng.random() < 0.7 else rng.choice(["cut", "crease"])
    over = rng.choice([0.0, 0.0, 0.1 * (x1 - x0)])
    blank.line(kind, x0, y, x1 - over, y)
    blank.line(other, x0 + over, y + apart, x1, y + apart)


def double_outline(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a window twice, one of them shifted, with a slit that ends on it."""
    x0, y0, x1, y1 = panel
    apart = rng.choice([0.004, 0.02, 0.04])
    blank.rectangle("cut", x0, y0, 0.6 * x0 + 0.4 * x1, y1)
    blank.rectangle("cut", x0 + apart, y0 + apart, 0.6 * x0 + 0.4 * x1 + apart, y1 + apart)
    y = 0.5 * (y0 + y1)
    blank.line("cut", 0.6 * x0 + 0.4 * x1 + apart, y, 0.2 * x0 + 0.8 * x1, y)


BODIES: Final[tuple[Callable[[Blank, Panel, Random, float], None], ...]] = (
    bent_crease,
    chord_circle,
    small_holes,
    double_line,
    double_outline,
)


def add_bodies(blank: Blank, rng: Random, t: float) -> None:
    """Fill a half of the panels of a blank."""
    for panel in blank.panels:
        if min(panel[2] - panel[0], panel[3] - panel[1]) > 10.0 and rng.random() < 0.5:
            rng.choice(BODIES)(blank, panel, rng, t)
