"""Parametric cartons with random sizes, as packaging designers draw them.

Every function draws one blank.  Sizes, allowances and details vary; ``t`` is the caliper of the
board (mm), by which locks, slots and double creases are as wide as in practice.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Final

from tests.cartons.blank import QUARTER, Blank

Corner = tuple[float, ...]


def tuck_end(rng: Random, t: float) -> Blank:
    """A tuck-end carton: two tuck lids with slit locks, four dust flaps, and a glue flap."""
    blank = Blank()
    wide, deep, high = rng.uniform(35, 150), rng.uniform(20, 80), rng.uniform(40, 220)
    glue = rng.uniform(10, 18)
    x = [glue, glue + wide, glue + wide + deep, glue + 2 * wide + deep, glue + 2 * (wide + deep)]
    straight = rng.random() < 0.5
    top = [(0, "lid"), (1, "dust"), (2, ""), (3, "dust")]
    low = top if straight else [(0, ""), (1, "dust"), (2, "lid"), (3, "dust")]
    slot = rng.choice([0.0, 0.3, 0.5, 1.0, max(t, 0.5), 2.0])
    dust, tuck, lock = rng.uniform(0.5, 0.9) * deep, rng.uniform(8, 0.5 * deep + 6), 0.15 * wide
    outline: list[Corner] = [(glue, 0.0), (0.0, rng.uniform(3, 10)), (0.0, high - 5.0)]
    for way, flaps in ((1.0, top), (-1.0, low)):
        y0 = high if way > 0 else 0.0
        edge: list[Corner] = []
        for panel, flap in flaps:
            a, b = x[panel], x[panel + 1]
            if flap == "lid":
                r = rng.uniform(2, min(8.0, tuck - 1.0, 0.3 * wide))
                y1 = y0 + way * deep
                turn = -way * QUARTER
                edge += [
                    (a, y0),
                    (a, y1),
                    (a, y1 + way * (tuck - r), turn),
                    (a + r, y1 + way * tuck),
                    (b - r, y1 + way * tuck, turn),
                    (b, y1 + way * (tuck - r)),
                    (b, y0),
                ]
                blank.line("crease", a, y0, b, y0)
                blank.line("crease", a + lock, y1, b - lock, y1)
                blank.line("cut", a, y1, a + lock, y1)
                blank.line("cut", b - lock, y1, b, y1)
                blank.panel(a, min(y0, y1), b, max(y0, y1))
            elif flap == "dust":
                end = y0 + way * dust
                edge += [
                    (a + slot, y0),
                    (a + slot, y0 + way * 0.35 * dust),
                    (a + slot + 0.2 * deep, end),
                    (b - slot - 0.1 * deep, end),
                    (b - slot, y0 + way * 0.6 * dust),
                    (b - slot, y0),
                ]
                blank.line("crease", a + slot, y0, b - slot, y0)
            else:
                edge += [(a, y0), (b, y0)]
        outline += edge if way > 0 else [_turned(edge, i) for i in range(len(edge) - 1, -1, -1)]
    blank.path("cut", _ring(outline), closed=True)
    for at in x[:4]:
        blank.line("crease", at, 0.0, at, high)
    for a, b in pairwise(x):
        blank.panel(a, 0.0, b, high)
    return blank


def _turned(points: list[Corner], i: int) -> Corner:
    """Return a point of a path that is gone through backwards, with the bulge of its side."""
    before = points[i - 1] if i else ()
    bulge = -before[2] if len(before) > 2 else 0.0
    return (points[i][0], points[i][1], bulge)


def _ring(points: list[Corner]) -> list[Corner]:
    """Return the points of a ring without repeated ones."""
    return [p for i, p in enumerate(points) if math.dist(p[:2], points[i - 1][:2]) > 1e-9]


def slotted_case(rng: Random, t: float) -> Blank:
    """A slotted case (FEFCO 0201) with slits, plain slots or slots with round ends."""
    blank = Blank()
    long, wide, high = rng.uniform(60, 300), rng.uniform(40, 180), rng.uniform(40, 250)
    glue, slot = rng.uniform(20, 35), rng.choice([0.0, 0.0, t + 1.0, 5.0, 6.0, 8.0])
    flap = 0.5 * wide + rng.choice([0.0, 0.5 * t])
    x = [glue]
    for size in (long, wide, long, wide - rng.choice([0.0, t])):
        x.append(x[-1] + size)
    low, top, end = flap, flap + high, 2.0 * flap + high
    taper = rng.choice([0.0, rng.uniform(3, 15)])
    left: list[Corner] = [(glue, low), (0.0, low + taper), (0.0, top - taper), (glue, top)]
    if slot == 0.0:
        blank.path("cut", [*left, (glue, end), (x[4], end), (x[4], 0.0), (glue, 0.0)], closed=True)
        for at in x[1:4]:
            blank.line("cut", at, 0.0, at, low)
            blank.line("cut", at, top, at, end)
    else:
        h, bulge = 0.5 * slot, rng.choice([0.0, 1.0])
        deeper = rng.choice([0.0, 0.0, t])
        up: list[Corner] = [(glue, end)]
        down: list[Corner] = [(x[4], 0.0)]
        for at in x[1:4]:
            up += [(at - h, end), (at - h, top - deeper, bulge), (at + h, top - deeper)]
            up += [(at + h, end)]
        for at in x[3:0:-1]:
            down += [(at + h, 0.0), (at + h, low + deeper, bulge), (at - h, low + deeper)]
            down += [(at - h, 0.0)]
        blank.path("cut", [*left, *up, (x[4], end), *down, (glue, 0.0)], closed=True)
    for at in x[:4]:
        inset = rng.choice([0.0, 0.0, 0.5 * t])
        blank.line("crease", at, low + inset, at, top - inset)
    for y in (low, top):
        if slot == 0.0 and rng.random() < 0.5:
            blank.line("crease", x[0], y, x[4], y)
            continue
        for i, (a, b) in enumerate(pairwise(x)):
            h = 0.5 * slot
            blank.line("crease", a + (h if i else 0.0), y, b - (h if i < 3 else 0.0), y)
    for a, b in pairwise(x):
        blank.panel(a, low, b, top)
    return blank


def mailer(rng: Random, t: float) -> Blank:
    """A mailer (FEFCO 0427) with rolled side walls, tabs in slots, and a lid with ears."""
    blank = Blank()
    wide, deep, high = rng.uniform(80, 260), rng.uniform(60, 180), rng.uniform(20, 60)
    roll, tab = 2.0 * t, max(2.0 * t, 3.0)
    gap = rng.choice([0.0, 0.5, t, 2.0])
    ear = min(0.45 * deep, 0.8 * high + 10.0)
    back, lid = deep + high, 2.0 * deep + high
    half = rng.uniform(12, 0.35 * deep)
    right: list[Corner] = [
        (wide, -high),
        (wide + ear, -high + 2.0),
        (wide + ear, -gap),
        (wide, -gap),
        (wide, gap),
    ]
    side: list[Corner] = [
        (wide + high, gap),
        (wide + high + roll, gap),
        (wide + 2 * high + roll - t, gap + 1.0),
        (wide + 2 * high + roll - t, 0.5 * deep - half),
        (wide + 2 * high + roll - t + tab, 0.5 * deep - half),
        (wide + 2 * high + roll - t + tab, 0.5 * deep + half),
        (wide + 2 * high + roll - t, 0.5 * deep + half),
        (wide + 2 * high + roll - t, deep - gap - 1.0),
        (wide + high + roll, deep - gap),
        (wide + high, deep - gap),
    ]
    right += side
    flap, r = high - t, min(0.5 * high, 12.0)
    right += [
        (wide, deep - gap),
        (wide, deep + gap),
        (wide + ear, deep + gap),
        (wide + ear, back - 2.0),
        (wide, back),
        (wide, back + 2.0),
        (wide + flap, back + 6.0),
        (wide + flap, lid - r - 2.0, QUARTER),
        (wide + flap - r, lid - 2.0),
        (wide, lid),
        (wide - t, lid + flap - 6.0),
        (wide - t - 6.0, lid + flap),
    ]
    left = [_mirrored(right, i, wide) for i in range(len(right) - 1, -1, -1)]
    blank.path("cut", _ring([*right, *left]), closed=True)
    for x, way in ((0.0, -1.0), (wide, 1.0)):
        blank.line("crease", x, -high, x, -gap)
        blank.line("crease", x, gap, x, deep - gap)
        blank.line("crease", x, deep + gap, x, back)
        blank.line("crease", x, back + 2.0, x, lid)
        for far in (high, high + roll):
            blank.line("crease", x + way * far, gap, x + way * far, deep - gap)
        # The slot for the tab lies on the fold of the base.
        inner = x - way * (t + 0.5)
        low, top = 0.5 * deep - half - 0.5, 0.5 * deep + half + 0.5
        blank.rectangle("cut", min(inner, x), low, max(inner, x), top)
    for y in (0.0, deep, back, lid):
        blank.line("crease", 0.0, y, wide, y)
    blank.panel(0.0, 0.0, wide, deep, 8.0)
    blank.panel(0.0, back, wide, lid, 8.0)
    return blank


def _mirrored(points: list[Corner], i: int, wide: float) -> Corner:
    """Return a point of a path mirrored at the middle of a blank and gone through backwards."""
    before = points[i - 1] if i else ()
    # A mirror changes the sense of an arc, and the direction changes it back.
    bulge = before[2] if len(before) > 2 else 0.0
    return (wide - points[i][0], points[i][1], bulge)


def tray(rng: Random, t: float) -> Blank:
    """A tray with corner flaps beside slits or notches, or with gusset corners."""
    blank = Blank()
    long, wide, high = rng.uniform(50, 300), rng.uniform(40, 200), rng.uniform(15, 70)
    style = rng.choice(["slit", "notch", "gusset"])
    for y in (0.0, wide):
        blank.line("crease", 0.0, y, long, y)
    for x in (0.0, long):
        blank.line("crease", x, 0.0, x, wide)
    if style == "notch":
        n = rng.choice([0.5, 1.0, t, 3.0])
        ring: list[Corner] = [(-high, -high), (long + high, -high)]
        ring += [(long + high, -n), (long, -n), (long, 0.0), (long + high, n)]
        ring += [(long + high, wide - n), (long, wide), (long, wide + n), (long + high, wide + n)]
        ring += [(long + high, wide + high), (-high, wide + high), (-high, wide + n)]
        ring += [(0.0, wide + n), (0.0, wide), (-high, wide - n), (-high, n), (0.0, 0.0)]
        ring += [(0.0, -n), (-high, -n)]
        blank.path("cut", ring, closed=True)
    else:
        blank.rectangle("cut", -high, -high, long + high, wide + high, rng.choice([0.0, 5.0]))
    for x, right in ((0.0, -1.0), (long, 1.0)):
        for y, up in ((0.0, -1.0), (wide, 1.0)):
            inset = n if style == "notch" else 0.0
            blank.line("crease", x, y + up * inset, x, y + up * high)
            if style == "slit":
                blank.line("cut", x, y, x + right * high, y)
            elif style == "gusset":
                blank.line("crease", x, y, x + right * high, y)
                short = rng.choice([0.0, 3.0])
                blank.line("crease", x, y, x + right * (high - short), y + up * (high - short))
    blank.panel(0.0, 0.0, long, wide)
    return blank


def sleeve(rng: Random, t: float) -> Blank:
    """A sleeve with a tear strip between perforations, and thumb notches."""
    blank = Blank()
    a, b, high = rng.uniform(40, 140), rng.uniform(15, 70), rng.uniform(40, 200)
    glue, r = rng.uniform(10, 16), min(rng.uniform(6, 11), 0.3 * a)
    x = [glue, glue + a, glue + a + b, glue + 2 * a + b, glue + 2 * (a + b)]
    middle = 0.5 * (x[0] + x[1])
    taper = rng.choice([0.0, 4.0])
    blank.path(
        "cut",
        [
            (0.0, taper),
            (glue, 0.0),
            (middle - r, 0.0, -1.0),
            (middle + r, 0.0),
            (x[4], 0.0),
            (x[4], high),
            (middle + r, high, -1.0),
            (middle - r, high),
            (glue, high),
            (0.0, high - taper),
        ],
        closed=True,
    )
    kind = rng.choice(["crease", "crease", "perforation"])
    for at in x[:4]:
        blank.line("crease" if at == x[0] else kind, at, 0.0, at, high)
    if rng.random() < 0.6:
        for y in (0.4 * high, 0.4 * high + rng.uniform(6, 12)):
            blank.line("perforation", x[0], y, x[4], y)
    blank.panel(x[1], 0.0, x[2], high)
    blank.panel(x[2], 0.55 * high + 12.0, x[3], high)
    return blank


def rigid_box(rng: Random, t: float) -> Blank:
    """A base or lid of a rigid box: a cross whose walls fold at V-grooves."""
    blank = Blank()
    long, wide, high = rng.uniform(60, 260), rng.uniform(40, 180), rng.uniform(12, 60)
    miss = rng.choice([0.0, 0.0, 0.02, 0.04, -0.1])
    ring: list[Corner] = [(0.0, -high), (long, -high), (long, 0.0), (long + high, 0.0)]
    ring += [(long + high, wide), (long, wide), (long, wide + high), (0.0, wide + high)]
    ring += [(0.0, wide), (-high, wide), (-high, 0.0), (0.0, 0.0)]
    style = rng.choice(["corner", "sheet", "inset"])
    if style == "sheet":
        # The square corners stay on the blank, and are cut out along the grooves.
        blank.rectangle("cut", -high, -high, long + high, wide + high)
        for x in (0.0, long):
            blank.line("v-groove", x, -high + miss, x, wide + high - miss)
        for y in (0.0, wide):
            blank.line("v-groove", -high + miss, y, long + high - miss, y)
    else:
        blank.path("cut", ring, closed=True)
        inset = rng.uniform(0.5, 1.5) * t if style == "inset" else 0.0
        for y, way in ((0.0, -1.0), (wide, 1.0)):
            blank.line("v-groove", miss, y + way * inset, long - miss, y + way * inset)
        for x, way in ((0.0, -1.0), (long, 1.0)):
            blank.line("v-groove", x + way * inset, miss, x + way * inset, wide - miss)
    blank.panel(0.0, 0.0, long, wide, 8.0)
    return blank


def divider(rng: Random, t: float) -> Blank:
    """A strip of a divider, with slots of half its height, plain or with a funnel."""
    blank = Blank()
    count, pitch, high = rng.randint(2, 6), rng.uniform(20, 60), rng.uniform(30, 120)
    slot = rng.choice([0.0, t, t + 0.5, t + 1.0])
    long, funnel = (count + 1) * pitch, rng.choice([0.0, 3.0])
    if slot == 0.0:
        blank.rectangle("cut", 0.0, 0.0, long, high)
        for i in range(count):
            blank.line("cut", (i + 1) * pitch, high, (i + 1) * pitch, 0.5 * high)
        return blank
    top: list[Corner] = []
    for i in range(count, 0, -1):
        x = i * pitch
        top += [(x + 0.5 * slot + funnel, high)]
        top += [(x + 0.5 * slot, high - 2.0 * funnel), (x + 0.5 * slot, 0.5 * high)]
        top += [(x - 0.5 * slot, 0.5 * high), (x - 0.5 * slot, high - 2.0 * funnel)]
        top += [(x - 0.5 * slot - funnel, high)]
    blank.path(
        "cut", _ring([(0.0, 0.0), (long, 0.0), (long, high), *top, (0.0, high)]), closed=True
    )
    return blank


def pillow(rng: Random, t: float) -> Blank:
    """A pillow box: its ends fold in along curves, drawn as arcs or splines."""
    blank = Blank()
    wide, high, glue = rng.uniform(50, 120), rng.uniform(60, 160), rng.uniform(10, 15)
    rise, form = rng.uniform(0.12, 0.25) * wide, rng.choice(["arc", "spline"])
    bulge = 2.0 * rise / wide
    x = [glue, glue + wide, glue + 2 * wide]
    blank.path(
        "cut",
        [
            (0.0, 3.0),
            (x[0], 0.0, bulge),
            (x[1], 0.0, bulge),
            (x[2], 0.0),
            (x[2], high, bulge),
            (x[1], high, bulge),
            (x[0], high),
            (0.0, high - 3.0),
        ],
        closed=True,
    )
    blank.line("crease", x[0], 0.0, x[0], high)
    blank.line("crease", x[1], 0.0, x[1], high)
    for y, way in ((0.0, 1.0), (high, -1.0)):
        for a, b in pairwise(x):
            if form == "arc":
                blank.path("crease", [(a, y, -way * bulge), (b, y)])
            else:
                steps = [i / 8.0 for i in range(9)]
                curve = [(a + s * (b - a), y + way * rise * 4.0 * s * (1.0 - s)) for s in steps]
                blank.spline("crease", curve)
    blank.panel(x[0], 1.3 * rise, x[1], high - 1.3 * rise, 6.0)
    return blank


def display(rng: Random, t: float) -> Blank:
    """A display tray: sides with a wavy front edge, drawn as a spline."""
    blank = Blank()
    long, wide = rng.uniform(80, 240), rng.uniform(50, 140)
    front, back = rng.uniform(20, 40), rng.uniform(60, 120)
    glue = rng.uniform(10, 18)
    for y in (0.0, wide):
        blank.line("crease", 0.0, y, long, y)
    for x, way in ((0.0, -1.0), (long, 1.0)):
        blank.line("crease", x, 0.0, x, wide)
        curve = []
        for i in range(9):
            s = i / 8.0
            reach = front + (back - front) * (3.0 * s * s - 2.0 * s**3)
            curve.append((x + way * reach, s * wide))
        blank.spline("cut", curve)
        blank.path("cut", [(x, -front), (x, 0.0), (x + way * front, 0.0)])
        tab = x + way * glue
        blank.path(
            "cut", [(x, wide), (tab, wide + 4.0), (tab, wide + back - 4.0), (x, wide + back)]
        )
        blank.path("cut", [(x + way * back, wide), (x, wide)])
        blank.line("crease", x, wide, x, wide + back)
    blank.line("cut", 0.0, -front, long, -front)
    blank.line("cut", 0.0, wide + back, long, wide + back)
    blank.panel(0.0, 0.0, long, wide)
    blank.panel(0.0, wide, long, wide + back)
    return blank


def fan(rng: Random, t: float) -> Blank:
    """A cup sleeve: two concentric arcs, and creases towards their centre."""
    blank = Blank()
    inner, high = rng.uniform(120, 220), rng.uniform(50, 110)
    angle = math.radians(rng.uniform(40, 85))
    bulge = math.tan(0.25 * angle)

    def at(radius: float, share: float) -> tuple[float, float]:
        turn = 0.5 * math.pi + (0.5 - share) * angle
        return radius * math.cos(turn), radius * math.sin(turn)

    outer = inner + high
    blank.path(
        "cut",
        [
            (*at(inner, 0.0), -bulge),
            at(inner, 1.0),
            (*at(outer, 1.0), bulge),
            at(outer, 0.0),
        ],
        closed=True,
    )
    for share in sorted(rng.uniform(0.08, 0.92) for _ in range(rng.randint(1, 4))):
        kind = rng.choice(["crease", "crease", "perforation"])
        blank.path(kind, [at(inner, share), at(outer, share)])
    return blank


def wallet(rng: Random, t: float) -> Blank:
    """A folder with round corners, a pocket, and curved slits that hold a card."""
    blank = Blank()
    wide, high, pocket = rng.uniform(80, 200), rng.uniform(100, 220), rng.uniform(40, 80)
    r, spine = rng.uniform(2, 8), rng.choice([0.0, 3.0, 5.0])
    blank.rectangle("cut", 0.0, 0.0, 2 * wide + spine, high, r)
    blank.line("crease", wide, 0.0, wide, high)
    if spine:
        blank.line("crease", wide + spine, 0.0, wide + spine, high)
    ear: list[Corner] = [(wide + spine + 2.0, 0.0), (wide + spine + 8.0, -pocket)]
    ear += [(2 * wide + spine - r - 2.0, -pocket), (2 * wide + spine - r - 2.0, 0.0)]
    blank.path("cut", ear)
    x, y = 0.25 * wide, 0.35 * high
    for a, b, turn in ((x, y, 1.0), (x + 40.0, y, -1.0)):
        blank.path("cut", [(a, b, -turn * 0.6), (a + 12.0 * turn * 0.2, b + 14.0)])
    blank.panel(wide + spine, 0.0, 2 * wide + spine, high, 10.0)
    return blank


def snap_lock(rng: Random, t: float) -> Blank:
    """A carton with a snap-lock bottom, whose flaps have slanted and hooked sides."""
    blank = Blank()
    wide, deep, high = rng.uniform(50, 130), rng.uniform(35, 90), rng.uniform(50, 180)
    glue, s = 14.0, rng.choice([0.5, 1.0, t])
    x = [glue, glue + wide, glue + wide + deep, glue + 2 * wide + deep, glue + 2 * (wide + deep)]
    d, h = 0.5 * deep, 0.6 * deep
    low: list[Corner] = [(x[4] - s, 0.0), (x[4] - s, -0.4 * d), (x[3] + 0.45 * deep, -h)]
    low += [(x[3] + 0.2 * deep, -h), (x[3] + s, -d), (x[3] + s, 0.0)]
    low += [(x[3], 0.0), (x[3] - s, -h), (x[3] - 0.25 * wide, -h), (x[3] - 0.3 * wide, -d)]
    low += [(x[2] + 0.3 * wide, -d), (x[2] + 0.25 * wide, -h), (x[2] + s, -h), (x[2], 0.0)]
    low += [(x[2] - s, 0.0), (x[2] - s, -d), (x[1] + 0.55 * deep, -h), (x[1] + s, -0.4 * d)]
    low += [(x[1] + s, 0.0), (x[1], 0.0), (x[1] - s, -d - 2.0)]
    low += [(x[1] - 0.28 * wide, -d - 2.0), (x[1] - 0.28 * wide, -h - 4.0)]
    low += [(x[0] + 0.28 * wide, -h - 4.0), (x[0] + 0.28 * wide, -d - 2.0)]
    low += [(x[0] + s, -d - 2.0), (x[0], 0.0)]
    top: list[Corner] = [(0.0, 6.0), (0.0, high - 6.0), (x[0], high), (x[4], high), (x[4], 0.0)]
    blank.path("cut", _ring([*top, *low]), closed=True)
    for at in x[:4]:
        blank.line("crease", at, 0.0, at, high)
    for i, (a, b) in enumerate(pairwise(x)):
        inset = s if i in (1, 3) else 0.0
        blank.line("crease", a + inset, 0.0, b - inset, 0.0)
        blank.panel(a, 0.0, b, high)
    return blank


def insert(rng: Random, t: float) -> Blank:
    """A flat insert with round, angular and freely formed openings for products."""
    blank = Blank()
    long, wide = rng.uniform(120, 300), rng.uniform(80, 200)
    blank.rectangle("cut", 0.0, 0.0, long, wide, rng.choice([0.0, 3.0, 10.0]))
    half = 0.5 * long
    middle, reach = 0.5 * wide, 0.28 * min(half, wide)
    shape = rng.choice(["circle", "bottle", "pocket"])
    if shape == "circle":
        blank.circle("cut", 0.5 * half, middle, reach)
    elif shape == "bottle":
        turns = [2.0 * math.pi * i / 12.0 for i in range(13)]
        radii = [reach * (1.0 + 0.25 * math.cos(3.0 * turn)) for turn in turns]
        around = [
            (0.5 * half + r * math.cos(turn), middle + r * math.sin(turn))
            for r, turn in zip(radii, turns, strict=True)
        ]
        blank.spline("cut", around)
    else:
        blank.rectangle(
            "cut", 0.5 * half - reach, middle - reach, 0.5 * half + reach, middle + reach, 6.0
        )
        blank.line("crease", 0.15 * half, 0.1 * wide, 0.15 * half, 0.9 * wide)
    blank.panel(half, 0.0, long, wide, 6.0)
    return blank


#: Every style by its name.
STYLES: Final[dict[str, Callable[[Random, float], Blank]]] = {
    made.__name__: made
    for made in (
        tuck_end,
        slotted_case,
        mailer,
        tray,
        sleeve,
        rigid_box,
        divider,
        pillow,
        display,
        fan,
        wallet,
        snap_lock,
        insert,
    )
}
