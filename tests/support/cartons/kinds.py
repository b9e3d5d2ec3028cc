"""Cartons of many kinds as plans; sizes and details are drawn from a random generator."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from knifetip.dxf.samples.cartons import corrugated_tray, rigid_box_blank
from knifetip.dxf.samples.tuck_end import tuck_end_carton
from knifetip.dxf.samples.write import Layer
from knifetip.geometry.path import Paths
from tests.support.cartons.plan import Plan

_PART_OF_LAYER = {"CUT": "outer", "CREASE": "crease", "V-GROOVE": "v-groove"}


def slotted_case(rng: np.random.Generator) -> Plan:
    """Return a slotted case (FEFCO 0201) with slots or slits between its flaps."""
    plan = Plan()
    long, wide, high = rng.uniform(120, 500), rng.uniform(80, 300), rng.uniform(60, 400)
    slot = float(rng.choice([0.0, 6.0, 8.0]))
    glue, flap = 30.0, wide / 2.0
    x = np.cumsum([glue, long, wide, long, wide]).tolist()
    low, top, end = flap, flap + high, 2.0 * flap + high
    outline = [(glue, low), (0.0, low + 10.0), (0.0, top - 10.0), (glue, top)]
    for y, tip, order in ((top, end, range(4)), (low, 0.0, range(3, -1, -1))):
        for panel in order:
            left = x[panel] + (slot / 2.0 if panel else 0.0)
            right = x[panel + 1] - (slot / 2.0 if panel < 3 else 0.0)
            way = [(left, y), (left, tip), (right, tip), (right, y)]
            outline += way if y == top else way[::-1]
    if slot:
        plan.polyline(
            [point for i, point in enumerate(outline) if point != outline[i - 1]], "outer"
        )
    else:
        ring = [(glue, low), (0.0, low + 10.0), (0.0, top - 10.0), (glue, top), (glue, end)]
        plan.polyline([*ring, (x[4], end), (x[4], 0.0), (glue, 0.0)], "outer")
        for at in x[1:4]:
            plan.line(at, 0.0, at, low, "outer")
            plan.line(at, top, at, end, "outer")
    for at in x[:4]:
        plan.line(at, low, at, top, "crease")
    inset = slot / 2.0
    for y in (low, top):
        for panel in range(4):
            left = x[panel] + (inset if panel else 0.0)
            right = x[panel + 1] - (inset if panel < 3 else 0.0)
            plan.line(left, y, right, y, "crease")
    return plan


def tray(rng: np.random.Generator) -> Plan:
    """Return a tray with glued corners, which has slits or notches beside the corner flaps."""
    plan = Plan()
    long, wide, high = rng.uniform(80, 400), rng.uniform(60, 300), rng.uniform(25, 90)
    notch = float(rng.choice([0.0, 2.0]))
    for side in (0.0, wide):
        plan.line(0.0, side, long, side, "crease")
    for side in (0.0, long):
        plan.line(side, 0.0, side, wide, "crease")
        plan.line(side, 0.0, side, -high, "crease")
        plan.line(side, wide, side, wide + high, "crease")
    if notch:
        ring = [(-high, -high), (long + high, -high)]
        ring += [(long + high, -notch), (long, -notch), (long, 0.0), (long + high, notch)]
        ring += [(long + high, wide - notch), (long, wide), (long, wide + notch)]
        ring += [(long + high, wide + notch), (long + high, wide + high), (-high, wide + high)]
        ring += [(-high, wide + notch), (0.0, wide + notch), (0.0, wide), (-high, wide - notch)]
        ring += [(-high, notch), (0.0, 0.0), (0.0, -notch), (-high, -notch)]
        plan.polyline(ring, "outer")
    else:
        plan.rectangle(-high, -high, long + high, wide + high, "outer")
        for y in (0.0, wide):
            plan.line(-high, y, 0.0, y, "outer")
            plan.line(long, y, long + high, y, "outer")
    return plan


def _sampled(parts: list[tuple[Layer, Paths]]) -> Plan:
    plan = Plan()
    for layer, paths in parts:
        for start, end, bulge in zip(paths.start, paths.end, paths.bulge, strict=True):
            (x0, y0), (x1, y1) = start.tolist(), end.tolist()
            plan.line(x0, y0, x1, y1, _PART_OF_LAYER[layer.name], float(bulge))
    return plan


def tuck_end(rng: np.random.Generator) -> Plan:
    """Return a reverse tuck-end carton."""
    return _sampled(
        tuck_end_carton(rng.uniform(60, 160), rng.uniform(35, 70), rng.uniform(80, 220))
    )


def rolled_tray(_rng: np.random.Generator) -> Plan:
    """Return a tray with rolled-over ends: double creases with slots on them."""
    return _sampled(corrugated_tray())


def rigid_box(_rng: np.random.Generator) -> Plan:
    """Return the blank of a rigid box, which has V-grooves and no creases."""
    return _sampled(rigid_box_blank())


def sleeve(rng: np.random.Generator) -> Plan:
    """Return a sleeve of four panels and a glue flap, with a tear-open perforation across the
    panels.
    """
    plan = Plan()
    x = np.cumsum([0.0, 15.0, *rng.uniform(40, 160, 2)]).tolist()
    x += [x[-1] + x[2] - x[1], x[-1] + x[3] - x[1]]
    high = rng.uniform(60, 250)
    x = sorted(set(x))
    plan.rectangle(0.0, 0.0, x[-1], high, "outer")
    for at in x[1:-1]:
        plan.line(at, 0.0, at, high, "crease")
    if rng.random() < 0.5:
        plan.line(0.0, high * 0.3, x[-1], high * 0.3, "perforation")
    return plan


def mailer(rng: np.random.Generator) -> Plan:
    """Return a mailer (FEFCO 0427): a roll-end front tuck with locks, ears and double creases."""
    plan = Plan()
    a, b, h = rng.uniform(120, 320), rng.uniform(90, 220), rng.uniform(30, 80)
    t = float(rng.choice([1.5, 3.0]))
    x0, x1 = h * 2 + t, h * 2 + t + a
    y = [0.0, h, h + b, 2 * h + b, 2 * h + 2 * b, 2 * h + 2 * b + h]
    # Front, base, back, lid and tuck; the base has rolled-over side walls, the others have ears.
    ring = [(x0, 0.0), (x1, 0.0), (x1 + h - t, 0.3 * h), (x1 + h - t, h - 1.0), (x1, h)]
    ring += [(x1 + h, h + 1.0), (x1 + 2 * h + t, h + 3.0)]
    ring += [(x1 + 2 * h + t, h + b - 3.0), (x1 + h, h + b - 1.0), (x1, h + b)]
    ring += [(x1 + h - t, h + b + 1.0), (x1 + h - t, y[3] - 0.3 * h), (x1, y[3])]
    ring += [(x1 + h / 2, y[3] + 4.0), (x1 + h / 2, y[4] - 8.0), (x1, y[4])]
    ring += [(x1 - 4.0, y[5]), (x0 + 4.0, y[5])]
    mirrored = [(x0 + x1 - x, v) for x, v in ring[2:-2]]
    plan.polyline([*ring, *mirrored[::-1]], "outer")
    for at in (y[1], y[2], y[3], y[4]):
        plan.line(x0, at, x1, at, "crease")
    for sign, edge in ((1.0, x1), (-1.0, x0)):
        plan.line(edge, y[1], edge, y[2], "crease")
        plan.line(edge, y[2], edge, y[3], "crease")
        plan.line(edge, y[3], edge, y[4], "crease")
        # A double crease where the wall rolls over.
        for step in (0.0, t):
            at = edge + sign * (h + step)
            low = 1.0 + 2.0 * step / (h + t)
            plan.line(at, h + low, at, h + b - low, "crease")
        for v in (h + 0.3 * b, h + 0.7 * b):
            mid = edge + sign * (2 * h + t - 6.0)
            plan.rectangle(mid - 1.5, v - 8.0, mid + 1.5, v + 8.0, "inner")
    return plan


def counter_display(rng: np.random.Generator) -> Plan:
    """Return a counter display with a curved back, slots and a round hole."""
    plan = Plan()
    a, b, h = rng.uniform(120, 300), rng.uniform(60, 150), rng.uniform(60, 160)
    x = np.cumsum([0.0, 20.0, b, a, b]).tolist()
    front, back = 0.4 * h, 1.6 * h
    ring: list[tuple[float, ...]] = [
        (0.0, 8.0), (x[1], 0.0), (x[2], 0.0), (x[2], -b), (x[3], -b), (x[3], 0.0), (x[4], 0.0),
        (x[4], front, -0.15), (x[3], h), (x[3], back, 0.35), (x[2], back), (x[2], h, -0.15),
        (x[1], front), (0.0, front - 8.0),
    ]  # fmt: skip
    plan.polyline(ring, "outer")
    for at, top in ((x[1], front), (x[2], h), (x[3], h)):
        plan.line(at, 0.0, at, top, "crease")
    plan.line(x[2], 0.0, x[3], 0.0, "crease")
    middle = 0.5 * (x[2] + x[3])
    plan.circle(middle, back - 10.0, 6.0, "inner")
    for at in (middle - 0.25 * a, middle + 0.25 * a):
        plan.rectangle(at - 12.0, 0.5 * h, at + 12.0, 0.5 * h + 2.0, "inner")
    return plan


def pillow(rng: np.random.Generator) -> Plan:
    """Return a pillow box, whose creases at both ends are arcs."""
    plan = Plan()
    w, h, bend = rng.uniform(60, 160), rng.uniform(80, 240), 0.3
    flap = 0.5 * w * bend
    ring: list[tuple[float, ...]] = [(0.0, 5.0), (15.0, 0.0, bend), (15.0 + w, 0.0, bend)]
    ring += [(15.0 + 2 * w, 0.0), (15.0 + 2 * w, h, bend), (15.0 + w, h, bend), (15.0, h)]
    ring += [(0.0, h - 5.0)]
    plan.polyline(ring, "outer")
    for at in (15.0, 15.0 + w):
        plan.line(at, 0.0, at, h, "crease")
    for left in (15.0, 15.0 + w):
        plan.line(left, 0.0, left + w, 0.0, "crease", -bend)
        plan.line(left, h, left + w, h, "crease", bend)
    plan.circle(15.0 + 0.5 * w, 0.5 * h + flap, 4.0, "inner")
    return plan


def tear_case(rng: np.random.Generator) -> Plan:
    """Return a slotted case with a tear strip between two perforations across all panels."""
    plan = slotted_case(rng)
    _, y0, x1, y1 = plan.bounds
    middle = 0.5 * (y0 + y1)
    for at in (middle - 5.0, middle + 5.0):
        plan.line(0.0, at, x1, at, "perforation")
    return plan


def auto_bottom(rng: np.random.Generator) -> Plan:
    """Return a crash-lock carton: diagonal creases, and slits that separate the bottom flaps."""
    plan = Plan()
    a, b, h = rng.uniform(70, 160), rng.uniform(50, 68), rng.uniform(80, 200)
    x = np.cumsum([0.0, 15.0, a, b, a, b]).tolist()
    down = 0.75 * b
    top = [(x[-1], h)]
    for left, right in zip(x[-2:0:-1], x[:1:-1], strict=True):
        top += [(right - 0.5, h + 0.5 * b), (left + 0.5, h + 0.5 * b), (left, h)]
    ring = [(0.0, 8.0)]
    for left, right in pairwise(x[1:]):
        ring += [(left, 0.0), (left + 2.0, -down), (right - 2.0, -down)]
    plan.polyline([*ring, (x[-1], 0.0), *top, (0.0, h - 8.0)], "outer")
    for at in x[1:-1]:
        plan.line(at, 0.0, at, h, "crease")
    for left, right in pairwise(x[1:]):
        plan.line(left, 0.0, right, 0.0, "crease")
        plan.line(left, h, right, h, "crease")
    for panel in (2, 4):
        left = x[panel]
        plan.line(left, 0.0, left + 0.6 * b, -down, "crease")
    return plan


def bag(rng: np.random.Generator) -> Plan:
    """Return a carrier bag: creases that cross each other, gussets, and holes for a cord."""
    plan = Plan()
    a, g, h = rng.uniform(100, 260), rng.uniform(50, 110), rng.uniform(160, 320)
    x = np.cumsum([0.0, 20.0, a, g / 2, g / 2, a, g / 2, g / 2]).tolist()
    top, bottom = h - 40.0, 0.6 * g + 20.0
    plan.rectangle(0.0, 0.0, x[-1], h, "outer")
    for at in x[1:-1]:
        plan.line(at, 0.0, at, h, "crease")
    for at in (bottom, top):
        plan.line(0.0, at, x[-1], at, "crease")
    for left in (x[2], x[5]):
        plan.line(left, bottom, left + g / 2, bottom + g / 2, "crease")
        plan.line(left + g / 2, bottom + g / 2, left + g, bottom, "crease")
    for left in (x[1], x[4]):
        for at in (left + 0.3 * a, left + 0.7 * a):
            plan.circle(at, h - 20.0, 3.0, "inner")
    return plan


def hang_tag(rng: np.random.Generator) -> Plan:
    """Return a folded card with a Euro hole and a half-cut sticker."""
    plan = Plan()
    a, h = rng.uniform(50, 110), rng.uniform(80, 180)
    r = 6.0
    ring: list[tuple[float, ...]] = []
    corner = math.tan(math.pi / 8.0)
    for cx, cy, first in ((2 * a, 0.0, 0), (2 * a, h, 1), (0.0, h, 2), (0.0, 0.0, 3)):
        sx, sy = (1 if cx == 0 else -1), (1 if cy == 0 else -1)
        one, two = (cx + sx * r, cy), (cx, cy + sy * r)
        if first % 2:
            one, two = two, one
        ring += [(*one, corner), (*two, 0.0)]
    plan.polyline(ring, "outer")
    plan.line(a, 0.0, a, h, "crease")
    x, y, w, d = 1.5 * a, h - 15.0, 10.0, 3.0
    plan.polyline(
        [(x - w, y - d), (x + w, y - d, 1.0), (x + w, y + d), (x - w, y + d, 1.0)], "inner"
    )
    plan.rectangle(0.2 * a, 0.2 * h, 0.8 * a, 0.5 * h, "half-cut")
    return plan


def window_sleeve(rng: np.random.Generator) -> Plan:
    """Return a sleeve with a window across two panels and slits for a card."""
    plan = Plan()
    a, b, h = rng.uniform(60, 140), rng.uniform(30, 58), rng.uniform(80, 200)
    x = np.cumsum([0.0, 12.0, a, b, a, b]).tolist()
    ring = [(0.0, 6.0), (x[1], 0.0), (x[-1], 0.0), (x[-1], h), (x[1], h), (0.0, h - 6.0)]
    plan.polyline(ring, "outer")
    left, right, low, high = x[1] + 0.5 * a, x[2] + 0.5 * b, 0.3 * h, 0.7 * h
    plan.rectangle(left, low, right, high, "inner")
    for at in (x[1], x[3], x[4]):
        plan.line(at, 0.0, at, h, "crease")
    plan.line(x[2], 0.0, x[2], low, "crease")
    plan.line(x[2], high, x[2], h, "crease")
    for y in (0.4 * h, 0.6 * h):
        plan.line(x[3] + 0.3 * a, y, x[3] + 0.7 * a, y, "inner")
    return plan


def folder(rng: np.random.Generator) -> Plan:
    """Return a folder with a pocket, a double spine and slits for a business card."""
    plan = Plan()
    a, h, p, s = 220.0, 307.0, 80.0, float(rng.choice([0.0, 5.0]))
    spine = [a] if not s else [a, a + s]
    wide = 2 * a + s
    ring = [(0.0, 0.0), (spine[-1] + 2.0, 0.0), (spine[-1] + 6.0, -p), (wide - 2.0, -p)]
    ring += [(wide, 0.0), (wide, h), (0.0, h)]
    plan.polyline(ring, "outer")
    for at in spine:
        plan.line(at, 0.0, at, h, "crease")
    plan.line(spine[-1] + 2.0, 0.0, wide, 0.0, "crease")
    x, y = wide - 150.0, -20.0
    for dx, dy in ((0.0, 0.0), (80.0, 0.0)):
        plan.line(x + dx, y + dy, x + dx + 10.0, y + dy - 10.0, "inner")
    return plan


def hexagon(rng: np.random.Generator) -> Plan:
    """Return a six-sided carton with a lid; only the creases of its body are vertical."""
    plan = Plan()
    a, h = rng.uniform(40, 80), rng.uniform(80, 180)
    x = [12.0 + a * k for k in range(7)]
    ring: list[tuple[float, ...]] = [(0.0, 6.0)]
    for k in range(6):
        ring += [(x[k], 0.0), (x[k] + 0.2 * a, -0.4 * a), (x[k + 1] - 0.2 * a, -0.4 * a)]
    ring += [(x[6], 0.0), (x[6], h)]
    side = a * math.sqrt(3.0)
    for k in range(5, -1, -1):
        if k == 2:
            ring += [(x[3], h), (x[3] + 0.5 * a, h + 0.5 * side), (x[3], h + side)]
            ring += [(x[2], h + side), (x[2] - 0.5 * a, h + 0.5 * side), (x[2], h)]
        else:
            ring += [(x[k + 1] - 0.15 * a, h + 0.3 * a), (x[k] + 0.15 * a, h + 0.3 * a), (x[k], h)]
    ring = [p for i, p in enumerate(ring) if p != ring[i - 1]]
    plan.polyline([*ring, (0.0, h - 6.0)], "outer")
    for at in x[:6]:
        plan.line(at, 0.0, at, h, "crease")
    for k in range(6):
        plan.line(x[k], 0.0, x[k + 1], 0.0, "crease")
        plan.line(x[k], h, x[k + 1], h, "crease")
    return plan


def crossed_case(rng: np.random.Generator) -> Plan:
    """Return a slotted case (FEFCO 0201) with one crease across all panels, which slits cross."""
    plan = Plan()
    a, b, h = rng.uniform(120, 400), rng.uniform(100, 300), rng.uniform(80, 300)
    x, f = np.cumsum([0.0, 35.0, a, b, a, b]).tolist(), b / 2.0
    ring = [(0.0, f + 15.0), (x[1], f), (x[1], 0.0), (x[5], 0.0), (x[5], 2 * f + h)]
    plan.polyline([*ring, (x[1], 2 * f + h), (x[1], f + h), (0.0, f + h - 15.0)], "outer")
    for y in (f, f + h):
        plan.line(x[1], y, x[5], y, "crease")
    for at in x[1:5]:
        plan.line(at, f, at, f + h, "crease")
    for at in x[2:5]:
        plan.line(at, 0.0, at, f, "inner")
        plan.line(at, f + h, at, 2 * f + h, "inner")
    return plan


KINDS: tuple[Callable[[np.random.Generator], Plan], ...] = (
    slotted_case,
    crossed_case,
    tray,
    tuck_end,
    sleeve,
    rolled_tray,
    rigid_box,
    mailer,
    counter_display,
    pillow,
    tear_case,
    auto_bottom,
    bag,
    hang_tag,
    window_sleeve,
    folder,
    hexagon,
)
