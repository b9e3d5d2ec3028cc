"""What is added to the panels of a carton: windows, hand holes, slots, slits, labels and folds."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Final

from tests.cartons.blank import QUARTER, Blank

#: A panel: x0, y0, x1, y1 (mm).
Panel = tuple[float, float, float, float]


def window(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a window, which may have a part with a hole and a fold in its waste."""
    x0, y0, x1, y1 = panel
    blank.rectangle("cut", x0, y0, x1, y1, rng.choice([0.0, 3.0, 8.0]))
    room = rng.choice([3.0, 6.5, 10.0])
    if min(x1 - x0, y1 - y0) > 2.0 * room + 40.0 and rng.random() < 0.5:
        a, b, c, d = x0 + room, y0 + room, x1 - room, y1 - room
        blank.rectangle("cut", a, b, c, d, rng.choice([0.0, 4.0]))
        middle = 0.5 * (b + d)
        if rng.random() < 0.5:
            blank.line("crease", a, middle, c, middle)
        else:
            blank.circle("cut", 0.5 * (a + c), middle, 0.2 * min(c - a, d - b))


def hand_hole(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a hand hole: two lines and two half circles, or a flap that hangs on a fold."""
    x0, y0, x1, y1 = panel
    wide, r = min(80.0, 0.8 * (x1 - x0)), min(12.0, 0.3 * (y1 - y0))
    if wide < 3.0 * r:
        return
    x, y = 0.5 * (x0 + x1 - wide) + r, 0.5 * (y0 + y1)
    end = x + wide - 2.0 * r
    if rng.random() < 0.5:
        blank.path(
            "cut",
            [(x, y - r), (end, y - r, 1.0), (end, y + r), (x, y + r, 1.0)],
            closed=True,
        )
    else:
        blank.path(
            rng.choice(["cut", "cut", "perforation"]),
            [
                (x - r, y + r),
                (x - r, y, QUARTER),
                (x, y - r),
                (end, y - r, QUARTER),
                (end + r, y),
                (end + r, y + r),
            ],
        )
        blank.line("crease", x - r, y + r, end + r, y + r)


def slot(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a narrow slot for a lock, upright or lying."""
    x0, y0, x1, y1 = panel
    x, y = rng.uniform(x0, 0.5 * (x0 + x1)), rng.uniform(y0, 0.5 * (y0 + y1))
    long, wide = rng.uniform(0.2, 0.5), rng.choice([0.5, 1.0, t, t + 0.5, 3.0])
    if rng.random() < 0.5:
        blank.rectangle("cut", x, y, x + long * (x1 - x0), y + wide)
    else:
        blank.rectangle("cut", x, y, x + wide, y + long * (y1 - y0))


def slit(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a slit inside a panel: straight, with a branch, crossed, or with bent ends."""
    x0, y0, x1, y1 = panel
    y, middle = 0.5 * (y0 + y1), 0.5 * (x0 + x1)
    a, b, up = middle - 0.3 * (x1 - x0), middle + 0.3 * (x1 - x0), 0.3 * (y1 - y0)
    style = rng.choice(["plain", "branch", "cross", "bent", "arc", "spline"])
    if style == "arc":
        blank.path("cut", [(a, y, 0.3), (b, y)])
        return
    if style == "spline":
        points = [(a + (b - a) * i / 6.0, y + 0.5 * up * math.sin(i)) for i in range(7)]
        blank.spline("cut", points)
        return
    if style == "bent":
        blank.path("cut", [(a, y + 0.3 * up), (a + 0.3 * up, y), (b - 0.3 * up, y), (b, y + up)])
        return
    blank.line("cut", a, y, b, y)
    if style == "branch":
        blank.line("cut", middle, y, middle, y + up)
    elif style == "cross":
        blank.line("cut", middle, y - up, middle, y + up)


def label(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a round or rectangular label, cut half through."""
    x0, y0, x1, y1 = panel
    x, y, r = 0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.3 * min(x1 - x0, y1 - y0)
    if rng.random() < 0.5:
        blank.circle("half-cut", x, y, r)
    else:
        blank.rectangle("half-cut", x - r, y - 0.6 * r, x + r, y + 0.6 * r, rng.choice([0, 2.0]))


def tear_out(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add an opening that is torn out along a perforation, round or rectangular."""
    x0, y0, x1, y1 = panel
    x, y, r = 0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.3 * min(x1 - x0, y1 - y0)
    if rng.random() < 0.5:
        blank.circle("perforation", x, y, r)
    else:
        blank.rectangle("perforation", x - r, y - r, x + r, y + r)
        blank.line("cut", x - 0.4 * r, y, x + 0.4 * r, y)


def fold(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a fold across a panel, straight or curved."""
    x0, y0, x1, y1 = panel
    if rng.random() < 0.6:
        blank.line("crease", x0, y0, x1, y1)
    else:
        y = 0.5 * (y0 + y1)
        points = [
            (x0 + (x1 - x0) * i / 8.0, y + 0.2 * (y1 - y0) * math.sin(0.8 * i)) for i in range(9)
        ]
        blank.spline("crease", points)


def holes(blank: Blank, panel: Panel, rng: Random, t: float) -> None:
    """Add a row of round holes, some of them small."""
    x0, y0, x1, y1 = panel
    r = rng.choice([1.0, 2.5, 3.0, 5.0])
    count = min(6, int((x1 - x0) / (4.0 * r)))
    for i in range(count):
        blank.circle("cut", x0 + (2.0 + 4.0 * i) * r, 0.5 * (y0 + y1), r)


FEATURES: Final[tuple[Callable[[Blank, Panel, Random, float], None], ...]] = (
    window,
    hand_hole,
    slot,
    slit,
    label,
    tear_out,
    fold,
    holes,
)


def add_features(blank: Blank, rng: Random, t: float) -> None:
    """Add a feature to some panels of a blank."""
    for panel in blank.panels:
        if min(panel[2] - panel[0], panel[3] - panel[1]) > 10.0 and rng.random() < 0.35:
            rng.choice(FEATURES)(blank, panel, rng, t)
