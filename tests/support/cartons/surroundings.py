"""Annotations that people draw around a carton, and typical flaws of their drawings."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import shapely

from knifetip.geometry import arc
from tests.support.cartons.plan import Plan, Stroke


def _add_dimensions(plan: Plan) -> None:
    x0, y0, x1, y1 = plan.bounds
    for gap in (15.0, 30.0):
        y, x = y0 - gap, x1 + gap
        plan.line(x0, y, x1, y, "dimension")
        plan.line(x, y0, x, y1, "dimension")
        for at, way in ((x0, 1.0), (x1, -1.0)):
            plan.line(at, y0 - 2.0, at, y - 3.0, "dimension")
            for side in (0.8, -0.8):
                plan.line(at, y, at + way * 3.0, y + side, "dimension")
        for at, way in ((y0, 1.0), (y1, -1.0)):
            plan.line(x1 + 2.0, at, x + 3.0, at, "dimension")
            for side in (0.8, -0.8):
                plan.line(x, at, x + side, at + way * 3.0, "dimension")
        plan.text(f"{x1 - x0:.1f}", 0.5 * (x0 + x1), y + 1.0, part="dimension")
        plan.text(f"{y1 - y0:.1f}", x + 1.0, 0.5 * (y0 + y1), part="dimension")


def _add_inner_dimensions(plan: Plan) -> None:
    """Add dimensions inside the panels, from crease to crease, as plain lines with arrowheads."""
    _, y0, _, y1 = plan.bounds
    y = y0 + 0.437 * (y1 - y0)
    at = sorted({round(s.x0, 6) for s in plan.strokes if s.part == "crease" and s.x0 == s.x1})
    for left, right in pairwise(at):
        if right - left < 30.0:
            continue
        plan.line(left, y, right, y, "dimension")
        for x, way in ((left, 1.0), (right, -1.0)):
            for side in (0.8, -0.8):
                plan.line(x, y, x + way * 3.0, y + side, "dimension")
        plan.text(f"{right - left:.1f}", 0.5 * (left + right), y + 1.0, part="dimension")


def _add_frame(plan: Plan) -> None:
    x0, y0, x1, y1 = plan.bounds
    left, low, right, top = x0 - 50.0, y0 - 110.0, x1 + 60.0, y1 + 40.0
    plan.rectangle(left, low, right, top, "frame")
    for row in range(1, 4):
        plan.line(right - 110.0, low + 10.0 * row, right, low + 10.0 * row, "frame")
        plan.text(("Design", "Kunde", "Date")[row - 1], right - 106.0, low + 10.0 * row - 7.0)
    plan.line(right - 110.0, low, right - 110.0, low + 30.0, "frame")


def _add_legend(plan: Plan) -> None:
    """Add a legend: a line in the style of each line type, with its name beside it."""
    x0, y0, _, _ = plan.bounds
    for row, part in enumerate(("outer", "crease", "perforation")):
        y = y0 - 70.0 - 8.0 * row
        plan.strokes.append(Stroke(x0, y, x0 + 20.0, y, "legend", 0.0, part))
        plan.text(("Cut", "Crease", "Perforation")[row], x0 + 24.0, y - 1.5)


def _add_marks(plan: Plan) -> None:
    """Add registration crosses with rings, and crop marks at the corners."""
    x0, y0, x1, y1 = plan.bounds
    for x, y in ((0.5 * (x0 + x1), y1 + 60.0), (x0 - 60.0, 0.5 * (y0 + y1))):
        plan.line(x - 5.0, y, x + 5.0, y, "mark")
        plan.line(x, y - 5.0, x, y + 5.0, "mark")
        plan.circle(x, y, 3.0, "mark")
    for x, sx in ((x0, -1.0), (x1, 1.0)):
        for y, sy in ((y0, -1.0), (y1, 1.0)):
            plan.line(x + sx * 6.0, y, x + sx * 12.0, y, "mark")
            plan.line(x, y + sy * 6.0, x, y + sy * 12.0, "mark")


def _add_grain_arrows(plan: Plan) -> None:
    """Add two arrows for the direction of the grain: one inside a panel, one beside the carton."""
    _, y0, x1, y1 = plan.bounds
    for x, y in ((x1 + 45.0, 0.5 * (y0 + y1)), _most_distant_point(plan)):
        plan.line(x, y - 9.0, x, y + 9.0, "grain")
        for way in (1.0, -1.0):
            for side in (1.5, -1.5):
                plan.line(x, y + way * 9.0, x + side, y + way * 6.0, "grain")
    plan.text("GRAIN", x1 + 48.0, 0.5 * (y0 + y1))


def _most_distant_point(plan: Plan) -> tuple[float, float]:
    """Return the point (x, y) inside the outline that is farthest from every line, on a coarse
    grid.
    """
    x0, y0, x1, y1 = plan.bounds
    best, farthest = -1.0, (x0, y0)
    ends = np.array([(s.x0, s.y0, s.x1, s.y1) for s in plan.strokes])
    cut = np.array([s.part == "outer" for s in plan.strokes])
    a, d = ends[:, :2], ends[:, 2:] - ends[:, :2]
    for u in np.linspace(0.03, 0.97, 24):
        for v in np.linspace(0.03, 0.97, 24):
            p = np.array([x0 + u * (x1 - x0), y0 + v * (y1 - y0)])
            fraction = ((p - a) * d).sum(axis=1) / np.maximum((d * d).sum(axis=1), 1e-12)
            away = np.hypot(*(a + np.clip(fraction, 0, 1)[:, None] * d - p).T).min()
            up = (ends[:, 1] > p[1]) != (ends[:, 3] > p[1])
            with np.errstate(all="ignore"):
                at = ends[:, 0] + (p[1] - ends[:, 1]) * d[:, 0] / d[:, 1]
            if away > best and (up & cut & (at > p[0])).sum() % 2 == 1:
                best, farthest = away, (float(p[0]), float(p[1]))
    return farthest


def _add_bleed(plan: Plan) -> None:
    """Add a bleed: the outline of the blank, offset outwards by 3 mm."""
    lines = [shapely.LineString(_points(s)) for s in plan.strokes if s.part in ("outer", "crease")]
    blank = shapely.union_all(shapely.polygonize([shapely.union_all(lines, grid_size=1e-4)]))
    around = blank.buffer(3.0, join_style="mitre", mitre_limit=2.0)
    for ring in getattr(around, "geoms", [around]):
        points = list(ring.exterior.simplify(0.01).coords)
        for (x0, y0), (x1, y1) in pairwise(points):
            plan.line(x0, y0, x1, y1, "bleed")


def _points(stroke: Stroke, count: int = 24) -> list[tuple[float, float]]:
    ends = np.array([[stroke.x0, stroke.y0], [stroke.x1, stroke.y1]])
    fraction = np.linspace(0.0, 1.0, count if stroke.bulge else 2)
    start, end = (np.repeat(one[None], len(fraction), 0) for one in ends)
    return [
        tuple(p) for p in arc.point_at(start, end, np.full(len(fraction), stroke.bulge), fraction)
    ]


def _add_safety_square(plan: Plan) -> None:
    """Add a square inside a panel, which limits the area for text."""
    x, y = _most_distant_point(plan)
    ends = np.array([(s.x0, s.y0, s.x1, s.y1) for s in plan.strokes])
    near = np.abs(ends.reshape(-1, 2) - (x, y)).max(axis=1)
    half = max(8.0, 0.35 * float(near.min()))
    plan.rectangle(x - half, y - half, x + half, y + half, "safety")


def _add_glue_hatching(plan: Plan) -> None:
    """Add hatching on the glue flap: five short oblique lines."""
    x0, y0, _, y1 = plan.bounds
    for k in range(5):
        y = y0 + (0.3 + 0.08 * k) * (y1 - y0)
        plan.line(x0 + 3.0, y, x0 + 9.0, y + 6.0, "glue")


def _add_scale_bar(plan: Plan) -> None:
    x0, _, _, y1 = plan.bounds
    plan.line(x0, y1 + 25.0, x0 + 100.0, y1 + 25.0, "mark")
    for k in range(6):
        plan.line(x0 + 20.0 * k, y1 + 25.0, x0 + 20.0 * k, y1 + 28.0, "mark")
    plan.text("100 mm", x0 + 104.0, y1 + 25.0)


def _add_letters(plan: Plan) -> None:
    """Add text as lines: a T, an O of chords and an L, once inside a panel and once beside the
    carton.
    """
    x0, _, _, y1 = plan.bounds
    for x, y in (_most_distant_point(plan), (x0, y1 + 8.0)):
        plan.line(x, y + 5.0, x + 3.0, y + 5.0, "text")
        plan.line(x + 1.5, y, x + 1.5, y + 5.0, "text")
        ring = [
            (x + 6.0 + 1.5 * math.cos(0.5 * k), y + 2.5 + 2.5 * math.sin(0.5 * k))
            for k in range(12)
        ]
        plan.polyline(ring, "text")
        plan.line(x + 9.0, y, x + 9.0, y + 5.0, "text")
        plan.line(x + 9.0, y, x + 12.0, y, "text")


def _add_two_copies(plan: Plan) -> None:
    """Add two copies of the carton, one to the right and one above."""
    x0, y0, x1, y1 = plan.bounds
    plan.strokes += plan.moved(x1 - x0 + 12.0, 0.0) + plan.moved(0.0, y1 - y0 + 12.0)


def _add_five_copies(plan: Plan) -> None:
    """Add five copies of the carton in a grid of 3 × 2 without gaps: common edges are drawn
    twice.
    """
    x0, y0, x1, y1 = plan.bounds
    one = list(plan.strokes)
    for column in range(3):
        for row in range(2):
            if column or row:
                source = Plan(one)
                plan.strokes += source.moved(column * (x1 - x0), row * (y1 - y0))


SURROUNDINGS: dict[str, Callable[[Plan], None]] = {
    "three-up": _add_two_copies,
    "six-up": _add_five_copies,
    "inner dimensions": _add_inner_dimensions,
    "glue": _add_glue_hatching,
    "safety": _add_safety_square,
    "letters": _add_letters,
    "grain": _add_grain_arrows,
    "bleed": _add_bleed,
    "dimensions": _add_dimensions,
    "scale bar": _add_scale_bar,
    "marks": _add_marks,
    "legend": _add_legend,
    "frame": _add_frame,
}


def _repeat_some(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    twice = [s for s in strokes if rng.random() < 0.15]
    return strokes + [replace(s, x0=s.x1, y0=s.y1, x1=s.x0, y1=s.y0, bulge=-s.bulge) for s in twice]


def _split_some(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    """Return the strokes with some lines split in two pieces, some of which overlap."""
    out = []
    for s in strokes:
        if s.bulge or rng.random() < 0.7 or math.hypot(s.x1 - s.x0, s.y1 - s.y0) < 20.0:
            out.append(s)
            continue
        at = float(rng.uniform(0.3, 0.7))
        over = float(rng.choice([0.0, 0.05]))
        x, y = s.x0 + at * (s.x1 - s.x0), s.y0 + at * (s.y1 - s.y0)
        out.append(replace(s, x1=x, y1=y))
        back = at - over
        out.append(replace(s, x0=s.x0 + back * (s.x1 - s.x0), y0=s.y0 + back * (s.y1 - s.y0)))
    return out


def _displace_ends(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    """Return the strokes with every end displaced by up to 0.02 mm in x and y."""
    off = rng.uniform(-0.02, 0.02, (len(strokes), 4)).tolist()
    return [
        replace(s, x0=s.x0 + d[0], y0=s.y0 + d[1], x1=s.x1 + d[2], y1=s.y1 + d[3])
        for s, d in zip(strokes, off, strict=True)
    ]


def _round_coordinates(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    """Return the strokes with coordinates rounded to one decimal."""
    return [
        replace(s, x0=round(s.x0, 1), y0=round(s.y0, 1), x1=round(s.x1, 1), y1=round(s.y1, 1))
        for s in strokes
    ]


def _shorten_creases(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    """Return the strokes with creases shortened by 1.5 mm at both ends, like creasing rules of a
    die.
    """
    out = []
    for s in strokes:
        long = math.hypot(s.x1 - s.x0, s.y1 - s.y0)
        if s.part != "crease" or s.bulge or long < 12.0:
            out.append(s)
            continue
        dx, dy = 1.5 * (s.x1 - s.x0) / long, 1.5 * (s.y1 - s.y0) / long
        out.append(replace(s, x0=s.x0 + dx, y0=s.y0 + dy, x1=s.x1 - dx, y1=s.y1 - dy))
    return out


def _dash_creases(strokes: list[Stroke], rng: np.random.Generator) -> list[Stroke]:
    """Return the strokes with straight creases replaced by rows of dashes."""
    out = []
    for s in strokes:
        long = math.hypot(s.x1 - s.x0, s.y1 - s.y0)
        if s.part != "crease" or s.bulge or long < 30.0:
            out.append(s)
            continue
        count = round((long + 3.0) / 9.0)
        dash = (long - 3.0 * (count - 1)) / count
        ux, uy = (s.x1 - s.x0) / long, (s.y1 - s.y0) / long
        for k in range(count):
            at = k * (dash + 3.0)
            x, y = s.x0 + at * ux, s.y0 + at * uy
            out.append(replace(s, x0=x, y0=y, x1=x + dash * ux, y1=y + dash * uy))
    return out


FLAWS: dict[str, Callable[[list[Stroke], np.random.Generator], list[Stroke]]] = {
    "short creases": _shorten_creases,
    "dashes": _dash_creases,
    "pieces": _split_some,
    "doubles": _repeat_some,
    "gaps": _displace_ends,
    "rounded": _round_coordinates,
}
