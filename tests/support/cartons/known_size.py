"""Drawings of cartons of known size in any unit: the data for tests of the unit evidence."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.drawing import Annotation, Drawing
from knifetip.model.unit import MILLIMETRES
from tests.support.drawings import Header, drawing

#: One inch, and common calipers of boards in mm: metric ones, and ones given in inches.
INCH = 25.4
_METRIC_CALIPERS = (0.3, 0.4, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0)
_IMPERIAL_CALIPERS = tuple(INCH * part for part in (0.012, 0.018, 0.024, 1 / 32, 1 / 16, 1 / 8))
#: Numbers of decimals with which programs write coordinates, by unit; None for all decimals.
DECIMALS: dict[str, tuple[int | None, ...]] = {
    "mm": (1, 2, 3, 6, None),
    "cm": (2, 3, 6, None),
    "m": (4, 5, 6, None),
    "in": (3, 4, 6, None),
    "ft": (4, 5, 6, None),
    "pt": (2, 3, 6, None),
    "px": (2, 3, 6, None),
    "px-90": (2, 3, 6, None),
}

Lines = list[tuple[float, float, float, float]]


@dataclass(frozen=True)
class Carton:
    """A carton with its dimensions and its lines (x1, y1, x2, y2), in mm."""

    style: str
    length: float
    width: float
    height: float
    caliper: float
    lines: Lines
    imperial: bool


def slotted(length: float, width: float, height: float, t: float, small: float) -> Lines:
    """Return the lines of a slotted case: four panels, eight flaps and a glue flap.

    ``t`` is the caliper; ``small`` scales the width of the glue flap, 1 for 30 mm.
    """
    flap = width / 2 + t / 2
    panels = [length, width, length, width - t]
    top, bottom = height + 2 * t + flap, -flap
    glue = 30.0 * small
    lines: Lines = [(-glue, 0.0, -glue, height), (-glue, 0.0, 0.0, 0.0)]
    lines.append((-glue, height, 0.0, height))
    x = 0.0
    for panel in panels:
        low, high = (x + t, x + panel - t) if panel > 8 * t else (x, x + panel)
        lines += [
            (x, 0.0, x, height + 2 * t),
            (x, 0.0, x + panel, 0.0),
            (x, height + 2 * t, x + panel, height + 2 * t),
            (low, top, high, top),
            (low, height + 2 * t, low, top),
            (high, height + 2 * t, high, top),
            (low, bottom, high, bottom),
            (low, 0.0, low, bottom),
            (high, 0.0, high, bottom),
        ]
        x += panel
    return [*lines, (x, 0.0, x, height + 2 * t)]


def tuck_end(length: float, width: float, height: float, t: float, small: float) -> Lines:
    """Return the lines of a tuck-end carton: panels narrowed by calipers, tapered dust flaps.

    ``t`` is the caliper; ``small`` scales the glue flap, the tucks and the tapers.
    """
    panels = [length, width, length - t, width - 2 * t]
    tuck = (16.0 if width > 40 else 8.0) * small
    glue, taper, step = 12.0 * small, 4.0 * small, 6.0 * small
    lines: Lines = [(0.0, 0.0, -glue, taper), (-glue, taper, -glue, height - taper)]
    lines.append((-glue, height - taper, 0.0, height))
    x = 0.0
    for number, panel in enumerate(panels):
        lines += [(x, 0.0, x, height), (x, 0.0, x + panel, 0.0), (x, height, x + panel, height)]
        if number % 2:
            up = panel / 2
            for base, way in ((height, 1.0), (0.0, -1.0)):
                lines += [
                    (x, base, x + t, base + way * step),
                    (x + t, base + way * step, x + up / 4, base + way * up),
                    (x + up / 4, base + way * up, x + panel - t, base + way * up),
                    (x + panel - t, base + way * up, x + panel, base),
                ]
        elif number == 0:
            y = height + width
            lines += [
                (x, height, x, y),
                (x + panel, height, x + panel, y),
                (x, y, x + panel, y),
                (x + t, y + t, x + t, y + tuck),
                (x + t, y + tuck, x + panel - t, y + tuck),
            ]
        x += panel
    return [*lines, (x, 0.0, x, height)]


def tray(length: float, width: float, height: float, t: float, _small: float) -> Lines:
    """Return the lines of a tray with four walls and glued corners; ``t`` is the caliper."""
    lines: Lines = []
    for x0, y0, x1, y1 in (
        (0.0, 0.0, length, width),
        (0.0, -height, length, 0.0),
        (0.0, width, length, width + height),
        (-height, 0.0, 0.0, width),
        (length, 0.0, length + height, width),
    ):
        lines += [(x0, y0, x1, y0), (x1, y0, x1, y1), (x1, y1, x0, y1), (x0, y1, x0, y0)]
    for x, way in ((0.0, -1.0), (length, 1.0)):
        for y, up in ((0.0, -1.0), (width, 1.0)):
            out = x + way * (height - 2 * t)
            lines += [(x, y + up * height, out, y + up * (height - t)), (out, y + up * t, x, y)]
    return lines


STYLES = {"slotted": slotted, "tuck end": tuck_end, "tray": tray}


def carton(chance: random.Random) -> Carton:
    """Return a carton of random style and size; a quarter of all cartons have sizes in inches."""
    imperial = chance.random() < 0.25
    style = chance.choice(list(STYLES))
    if imperial:
        grid = INCH / chance.choice([1, 2, 4, 8, 16])
        caliper = chance.choice(_IMPERIAL_CALIPERS)
    else:
        grid = chance.choice([10.0, 5.0, 1.0, 1.0, 0.5])
        caliper = chance.choice(_METRIC_CALIPERS)
    if style == "slotted":
        caliper = max(caliper, 1.5 if not imperial else INCH / 16)

    def random_side(low: float, high: float) -> float:
        size = math.exp(chance.uniform(math.log(low), math.log(high)))
        return max(round(size / grid), 1) * grid

    low = 60.0 if style == "slotted" else 26.0
    sides = random_side(low, 500.0), random_side(low, 350.0), random_side(low, 350.0)
    # Small features are whole millimetres or sixteenths of an inch.
    small = INCH / 16.0 if imperial and chance.random() < 0.9 else 1.0
    return Carton(style, *sides, caliper, STYLES[style](*sides, caliper, small), imperial)


def drawing_of(ends: F64, stated: str = "", texts: tuple[Annotation, ...] = ()) -> Drawing:
    """Return a drawing of straight edges, (n, 2, 2) in file units, before its unit is determined.

    ``stated`` is the unit that the file's header states, "" for none.
    """
    return drawing(ends, [("0", 7, "CONTINUOUS")] * len(ends), header=Header("", stated, texts))


def carton_drawing(
    one: Carton,
    unit: str,
    stated: str,
    *,
    decimals: int | None = None,
    annotation: str = "",
    chance: random.Random | None = None,
    turn: float = 0.0,
) -> Drawing:
    """Return the drawing of a carton.

    Parameters
    ----------
    unit
        Unit of the coordinates.
    stated
        Unit that the header states, "" for none.
    decimals
        Number of decimals to which coordinates are rounded; None for no rounding.
    annotation
        "" for none, "dimensions", "texts" or "title"; if " mm" or " in" follows, the texts
        contain this unit.
    chance
        Random generator for the spelling of the texts.
    turn : radians
        Angle by which the carton is rotated.
    """
    ends = np.array(one.lines).reshape(-1, 2, 2) / MILLIMETRES[unit]
    if turn:
        cos, sin = math.cos(turn), math.sin(turn)
        ends = ends @ np.array([[cos, sin], [-sin, cos]])
    if decimals is not None:
        ends = np.round(ends, decimals)
    return drawing_of(ends, stated, _annotations(one, unit, annotation, chance or random.Random(0)))


def _annotations(
    one: Carton, unit: str, annotation: str, chance: random.Random
) -> tuple[Annotation, ...]:
    if not annotation:
        return ()
    kind, _, suffix = annotation.partition(" ")
    scale = MILLIMETRES[suffix or ("in" if one.imperial else "mm")]

    def format_length(size: float) -> str:
        if one.imperial and not suffix and chance.random() < 0.5:
            whole, part = divmod(round(size / INCH * 16), 16)
            shorter = math.gcd(part, 16)
            fraction = f"{part // shorter}/{16 // shorter}" if part else ""
            return f'{whole} {fraction}"' if whole and part else f'{fraction or whole}"'
        return f"{size / scale:.3f}".rstrip("0").rstrip(".")

    sizes = (one.length, one.width, one.height)
    if kind == "title":
        inside = "x".join(format_length(size) for size in sizes)
        return (Annotation(f"BOX {inside} {suffix}".strip(), 0, 0, 3, math.nan, "TEXT", "0"),)
    measured = kind == "dimensions"
    return tuple(
        Annotation(
            f"{format_length(size)} {suffix}".strip(),
            0.0,
            0.0,
            3.0,
            size / MILLIMETRES[unit] if measured else math.nan,
            "DIMENSION" if measured else "TEXT",
            "0",
        )
        for size in sizes
    )
