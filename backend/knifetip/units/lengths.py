"""lengths: what the lengths of a drawing, mere numbers so far, tell of their unit.

    Drawing -> Lengths in file units -> a weight for each unit: size, small features, grid

The grid is the strong one.  Somebody who draws in millimetres makes panels of whole or half
millimetres, somebody who draws in inches makes them of sixteenths.  If x is a length in file units
and f the millimetres to one, x is a good number only with the right f:

    p(x | unit) ∝ w₀ + (1 - w₀) Σ wᵢ gᵢ / (2 f ε)     over the grids gᵢ (mm) that f x lies on

where ε is how exactly the file gives lengths (file units) and the weights w say how often a length
is a multiple of gᵢ, w₀ of none.  A grid that is finer than what the file resolves is no grid.
The lengths' product is summed over the metric and the imperial table, each with its share among
drawings of that unit, and over how many lengths of a drawing are off all grids.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.distinct import distinct
from knifetip.model.drawing import Drawing, extents
from knifetip.model.unit import MILLIMETRES, NAMES, UnitEvidence, factor
from knifetip.units import weights

#: Lengths that are looked at: those that make up most of the drawing.
_MOST: Final = 48
#: How exact a length is taken to be at best, as a share of the drawing's size.
_EXACT: Final = 1e-5
#: Edges of a length that occurs so often, or is such a share of the drawing, are no chords.
_REPEATED: Final = 4
_SUBSTANTIAL: Final = 0.005
#: A bulge under this is a line.
_STRAIGHT: Final = 1e-9
#: Grids of which the evidence tells.
_TOLD: Final = (
    (10.0, "10 mm"),
    (1.0, "1 mm"),
    (0.5, "0.5 mm"),
    (25.4, "1 in"),
    (25.4 / 16.0, "1/16 in"),
)
#: Coordinates that are looked at for their decimals.
_SAMPLE: Final = 4096
#: Sheets of paper: shorter side, longer side (mm), name.
_PAPER: Final = (
    (841.0, 1189.0, "A0"),
    (594.0, 841.0, "A1"),
    (420.0, 594.0, "A2"),
    (297.0, 420.0, "A3"),
    (210.0, 297.0, "A4"),
    (148.0, 210.0, "A5"),
    (215.9, 279.4, "letter"),
    (279.4, 431.8, "tabloid"),
)


@dataclass(frozen=True, eq=False, slots=True)
class Lengths:
    """The straight lengths of a drawing, each once, in file units."""

    value: F64  #: (k,) those that make up most of it, at most 48
    total: F64  #: (k,) how much of the drawing is of this length
    shortest: float  #: length that edges have which are no chords of a curve
    straight: int  #: edges that are straight
    width: float
    height: float
    exact: tuple[float, ...]  #: how exactly lengths may be given: as they are, and as rounded

    @property
    def longer(self) -> float:
        """The longer side."""
        return max(self.width, self.height)


def lengths(drawing: Drawing) -> Lengths:
    """Return the lengths of a drawing in file units."""
    return of_edges(drawing.ends / factor(drawing.unit), drawing.bulge)


def of_edges(ends: F64, bulge: F64) -> Lengths:
    """Return the lengths of edges in file units."""
    straight = np.abs(bulge) < _STRAIGHT
    chosen = ends if straight.all() else ends[straight]
    low_x, low_y, high_x, high_y = _box(ends, bulge, straight)
    width, height = high_x - low_x, high_y - low_y
    size = max(width, height)
    across = chosen[:, 1] - chosen[:, 0]
    run = np.hypot(across[:, 0], across[:, 1])
    if not size > 0.0 or not np.isfinite(size) or not len(run):
        return Lengths(np.zeros(0), np.zeros(0), 0.0, len(run), width, height, (1.0,))
    step = 2.0 * _EXACT * size
    first, kind = distinct(np.round(run / step).astype(np.int64))
    total: F64 = np.bincount(kind, weights=run, minlength=len(first)).astype(np.float64)
    repeats = np.bincount(kind, minlength=len(first))
    value = run[first]
    kept = value > step
    value, total, repeats = value[kept], total[kept], repeats[kept]
    if not len(value):
        return Lengths(value, total, 0.0, len(run), width, height, (1.0,))
    own = (repeats >= _REPEATED) | (total >= _SUBSTANTIAL * total.sum())
    if len(value) > _MOST:
        most = np.argpartition(-total, _MOST)[:_MOST]
        value, total, own = value[most], total[most], own[most]
    shortest = float(value[own].min(initial=np.inf))
    order = np.argsort(value)
    exact: tuple[float, ...] = (_EXACT * size,)
    quantum = _quantum(chosen)
    if _EXACT * size < quantum <= 0.011:
        exact = (*exact, quantum)
    return Lengths(value[order], total[order], shortest, len(run), width, height, exact)


def _box(ends: F64, bulge: F64, straight: Bool) -> tuple[float, float, float, float]:
    if not len(ends):
        return 0.0, 0.0, 0.0, 0.0
    # Column by column, which is ten times as fast as along the rows.
    x, y = ends[:, :, 0], ends[:, :, 1]
    box = float(x.min()), float(y.min()), float(x.max()), float(y.max())
    if straight.all():
        return box
    low_x, low_y, high_x, high_y = extents(ends[~straight], bulge[~straight])
    return (
        min(box[0], float(low_x)),
        min(box[1], float(low_y)),
        max(box[2], float(high_x)),
        max(box[3], float(high_y)),
    )


def _quantum(ends: F64) -> float:
    """Return the last decimal place that coordinates have, 0 where they have all places."""
    flat = ends.reshape(-1)
    sample = np.abs(flat[:: max(1, len(flat) // _SAMPLE)])
    for places in range(7):
        scaled = sample * 10.0**places
        if (np.abs(scaled - np.round(scaled)) < 1e-4).mean() >= 0.99:
            return float(10.0**-places)
    return 0.0


def balanced(weight: Mapping[str, float]) -> dict[str, float]:
    """Return weights counted from the least, none farther from the greatest than allowed."""
    most = max(weight.values())
    cut = {unit: max(value, most - weights.HEAVIEST) for unit, value in weight.items()}
    least = min(cut.values())
    return {unit: value - least for unit, value in cut.items()}


def evidence(kind: str, weight: Mapping[str, float], text: Mapping[str, str]) -> list[UnitEvidence]:
    """Return one kind of evidence for all units."""
    return [UnitEvidence(unit, text[unit], value, kind) for unit, value in balanced(weight).items()]


def by_size(found: Lengths) -> list[UnitEvidence]:
    """Return what the overall size tells: a carton is neither 5 mm nor 50 m large."""
    weight = {
        unit: _line(weights.SIZE, found.longer * scale) for unit, scale in MILLIMETRES.items()
    }
    text = {
        unit: f"in {NAMES[unit]} the drawing is {measure(found.width * scale)} × "
        f"{measure(found.height * scale)} mm, "
        f"{'as cartons are' if weight[unit] >= weights.USUAL else 'which few cartons are'}"
        for unit, scale in MILLIMETRES.items()
    }
    return evidence("size", weight, text)


def by_features(found: Lengths) -> list[UnitEvidence]:
    """Return what the shortest edges tell: slots and flaps follow the caliper of boards."""
    if found.straight < weights.FEATURE_EDGES or not np.isfinite(found.shortest):
        return []
    least = found.shortest
    return evidence(
        "features",
        {unit: _line(weights.FEATURE, least * scale) for unit, scale in MILLIMETRES.items()},
        {
            unit: f"in {NAMES[unit]} its shortest edges are {measure(least * scale)} mm"
            for unit, scale in MILLIMETRES.items()
        },
    )


def by_paper(found: Lengths) -> list[UnitEvidence]:
    """Return whether the drawing is as large as a sheet of paper: it has a frame, or is a page."""
    short, long = sorted((found.width, found.height))
    told = []
    for unit, scale in MILLIMETRES.items():
        for width, height, name in _PAPER:
            if abs(short * scale - width) < 0.6 and abs(long * scale - height) < 0.6:
                text = f"in {NAMES[unit]} the drawing is exactly as large as a sheet of {name}"
                told.append(UnitEvidence(unit, text, weights.PAPER, "paper"))
                break
    return told


def by_grid(found: Lengths) -> list[UnitEvidence]:
    """Return what good numbers tell: which unit makes the lengths multiples of something."""
    if not len(found.value):
        return []
    text = {unit: _on_grid(found, unit) for unit in MILLIMETRES}
    return evidence("grid", grid_likelihood(found), text)


def grid_likelihood(found: Lengths) -> dict[str, float]:
    """Return the logarithm of how likely the lengths are in each unit."""
    result = {}
    for unit, scale in MILLIMETRES.items():
        metric = weights.DESIGNED_METRIC[unit]
        result[unit] = float(
            np.logaddexp(
                np.log(metric) + table_likelihood(found, scale, weights.METRIC),
                np.log(1.0 - metric) + table_likelihood(found, scale, weights.IMPERIAL),
            )
        )
    for family in weights.FAMILIES:
        least = max(result[unit] for unit in family) - weights.KIN
        result.update({unit: max(result[unit], least) for unit in family})
    return result


def table_likelihood(found: Lengths, scale: float, table: Mapping[float, float]) -> float:
    """Return the logarithm of how likely the lengths are, ``scale`` mm to one, by one table."""
    share = min(1.0, weights.INDEPENDENT / len(found.value))
    return max(share * _summed(found.value, exact, table, scale) for exact in found.exact)


def _summed(value: F64, exact: float, table: Mapping[float, float], scale: float) -> float:
    grid = np.array(list(table)) / scale
    weight = np.array(list(table.values()))
    near = np.round(value[:, None] / grid)
    on = (np.abs(value[:, None] - near * grid) <= exact) & (near > 0.0)
    gain = np.where(2.0 * exact < grid, grid / (2.0 * exact), 1.0)
    good = np.where(on, weight * gain, 0.0).sum(axis=1) / weight.sum()
    off = np.array(weights.OFF_GRID)
    likely = np.log(off + (1.0 - off) * good[:, None]).sum(axis=0)
    return float(np.logaddexp.reduce(likely) - np.log(len(off)))


def _on_grid(found: Lengths, unit: str) -> str:
    """Say how much lies on the grid that fits best in this unit."""
    scale = MILLIMETRES[unit]
    told = []
    for grid, name in _TOLD:
        if grid < 8.0 * found.exact[-1] * scale:
            continue
        near = np.round(found.value * scale / grid)
        on = (np.abs(found.value * scale - near * grid) <= found.exact[-1] * scale) & (near > 0)
        told.append((float(found.total[on].sum()), int(on.sum()), name))
    if not told:
        return f"in {NAMES[unit]} lengths are given too coarsely to be multiples of anything"
    part, count, name = max(told)
    percent = 100.0 * part / float(found.total.sum())
    return (
        f"in {NAMES[unit]} {count} of {len(found.value)} lengths, {percent:.0f} % of the line, "
        f"are multiples of {name}"
    )


def _line(points: tuple[tuple[float, float], ...], size: float) -> float:
    at, weight = zip(*points, strict=True)
    return float(np.interp(np.log(max(size, 1e-12)), np.log(at), weight))


def measure(size: float) -> str:
    """Return a length with as many places as are of use."""
    return f"{size:.0f}" if abs(size) >= 1000.0 else f"{size:.1f}" if size >= 1 else f"{size:.3g}"
