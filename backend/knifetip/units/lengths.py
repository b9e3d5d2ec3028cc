"""lengths: evidence for the unit from the lengths of a drawing's edges.

The lengths are measured in file units; the result is a weight for each candidate unit.  The weights
come from the size of the drawing, from its shortest edges, and from the grid: the spacing, such as
1 mm or 1/16 in, of which the lengths of edges are multiples.  The grid is the strongest evidence.
Designers who draw in millimetres choose panels of whole or half millimetres; designers who draw in
inches choose sixteenths.  If x is a length in file units and f the number of millimetres in one
file unit, f x is a round number only with the right f:

    p(x | unit) ∝ w₀ + (1 - w₀) Σ wᵢ gᵢ / (2 f ε)

The sum is over the grid spacings gᵢ (mm) of which f x is a multiple.  ε is the precision of lengths
in the file (file units), wᵢ the fraction of lengths that are multiples of gᵢ, and w₀ the fraction
that are multiples of no grid spacing.  A grid finer than the precision is not used.  The product
of p over all lengths is averaged over a metric and an imperial table of gᵢ and wᵢ, each weighted
with the fraction of drawings in the unit that use the table, and over the possible values of w₀.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message
from knifetip.model.drawing import Drawing, extents
from knifetip.model.unit import MILLIMETRES, UnitEvidence, factor
from knifetip.units import weights

#: Number of lengths that are used: the lengths with the greatest total in the drawing.
_MOST: Final = 48
#: Best precision of a length, as a fraction of the drawing's size.
_EXACT: Final = 1e-5
#: A length that occurs this often, or makes up this fraction of the drawing, does not come from the
#: chords of a curve.
_REPEATED: Final = 4
_SUBSTANTIAL: Final = 0.005
#: An edge with a smaller bulge is a line.
_STRAIGHT: Final = 1e-9
#: Grid spacings (mm) that messages name, and their names.
_NAMED_GRIDS: Final = (
    (10.0, "10 mm"),
    (1.0, "1 mm"),
    (0.5, "0.5 mm"),
    (25.4, "1 in"),
    (25.4 / 16.0, "1/16 in"),
)
#: Number of coordinates whose decimals are counted.
_SAMPLE: Final = 4096
#: Paper sizes: shorter side, longer side (mm), name.
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
    """The different lengths of the straight edges of a drawing, and its size, in file units."""

    value: F64  #: (k,) lengths, ascending, at most 48
    total: F64  #: (k,) total length of the edges that have this length
    shortest: float  #: least length of edges that are not chords of a curve
    straight: int  #: number of straight edges
    width: float  #: width of the bounding box
    height: float
    #: possible precisions of lengths: of coordinates as floats, of their last decimal place
    exact: tuple[float, ...]

    @property
    def longer(self) -> float:
        """The longer side of the bounding box of the drawing (file units)."""
        return max(self.width, self.height)

    def size_in(self, unit: str) -> tuple[float, float]:
        """Return width and height of the drawing (mm) if one file unit is one ``unit``."""
        return self.width * MILLIMETRES[unit], self.height * MILLIMETRES[unit]


def drawing_lengths(drawing: Drawing) -> Lengths:
    """Return the different lengths of a drawing's straight edges, and its size, in file units."""
    return edge_lengths(drawing.ends / factor(drawing.unit), drawing.bulge)


def edge_lengths(ends: F64, bulge: F64) -> Lengths:
    """Return the different lengths of the straight edges, and the size of all edges together.

    Parameters
    ----------
    ends : (n, 2, 2)
        Start and end points of n edges, in any unit; the result is in the same unit.
    bulge : (n,)
        Bulges of the edges; 0 for straight edges.
    """
    straight = np.abs(bulge) < _STRAIGHT
    chosen = ends if straight.all() else ends[straight]
    low_x, low_y, high_x, high_y = _bounding_box(ends, bulge, straight)
    width, height = high_x - low_x, high_y - low_y
    size = max(width, height)
    across = chosen[:, 1] - chosen[:, 0]
    run = np.hypot(across[:, 0], across[:, 1])
    if not size > 0.0 or not np.isfinite(size) or not len(run):
        return Lengths(np.zeros(0), np.zeros(0), 0.0, len(run), width, height, (1.0,))
    step = 2.0 * _EXACT * size
    first, kind = unique_rows(np.round(run / step).astype(np.int64))
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


def _bounding_box(ends: F64, bulge: F64, straight: Bool) -> tuple[float, float, float, float]:
    """Return min x, min y, max x and max y of n edges, in the unit of their coordinates.

    ``ends`` (n, 2, 2): start and end points of the edges.
    ``bulge`` (n,): bulges of the edges.
    ``straight`` (n,): mask of the straight edges.
    """
    if not len(ends):
        return 0.0, 0.0, 0.0, 0.0
    # Reducing each column is ten times as fast as reducing along the rows.
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
    """Return the value of the last decimal place of the coordinates ``ends``, for example 0.01.

    The value is 1 for whole numbers, and 0 if the coordinates have more than six decimal places.
    """
    flat = ends.reshape(-1)
    sample = np.abs(flat[:: max(1, len(flat) // _SAMPLE)])
    for places in range(7):
        scaled = sample * 10.0**places
        if (np.abs(scaled - np.round(scaled)) < 1e-4).mean() >= 0.99:
            return float(10.0**-places)
    return 0.0


def relative_weights(weight: Mapping[str, float]) -> dict[str, float]:
    """Return for each candidate unit its weight of evidence, 0 for the least likely unit.

    ``weight`` contains the logarithm of the likelihood of each candidate.  The result is this
    logarithm minus the least one.  No result is greater than ``weights.HEAVIEST``: logarithms that
    are more than this below the greatest one are raised first.
    """
    most = max(weight.values())
    cut = {unit: max(value, most - weights.HEAVIEST) for unit, value in weight.items()}
    least = min(cut.values())
    return {unit: value - least for unit, value in cut.items()}


def evidence_of_units(
    kind: str, weight: Mapping[str, float], message: Mapping[str, Message]
) -> list[UnitEvidence]:
    """Return one ``UnitEvidence`` for each candidate unit, all of the same kind.

    Parameters
    ----------
    kind
        Name of the kind of evidence, which is stored in each record.
    weight
        For each candidate unit, the logarithm of its likelihood; ``relative_weights`` converts
        these to the weights of the evidence.
    message
        For each candidate unit, the message that describes the evidence.
    """
    return [
        UnitEvidence(unit, message[unit], value, kind)
        for unit, value in relative_weights(weight).items()
    ]


def size_evidence(lengths: Lengths) -> list[UnitEvidence]:
    """Return the evidence for each candidate unit from the longer side of the drawing.

    A unit gets a greater weight if this side, measured in the unit, has a usual length for a
    carton.  ``lengths`` contains the size of the drawing in file units.
    """
    weight = {
        unit: _interpolate(weights.SIZE, lengths.longer * scale)
        for unit, scale in MILLIMETRES.items()
    }
    message = {}
    for unit in MILLIMETRES:
        width, height = lengths.size_in(unit)
        code = "unit.size-usual" if weight[unit] >= weights.USUAL else "unit.size-unusual"
        message[unit] = Message(code, unit=unit, width=width, height=height)
    return evidence_of_units("size", weight, message)


def feature_evidence(lengths: Lengths) -> list[UnitEvidence]:
    """Return the evidence for each candidate unit from the shortest edge of the drawing.

    Slots and small flaps have usual lengths, since these depend on the caliper of the board.  The
    list is empty if the drawing has too few straight edges.  ``lengths`` are the lengths of the
    edges in file units.
    """
    if lengths.straight < weights.FEATURE_EDGES or not np.isfinite(lengths.shortest):
        return []
    least = lengths.shortest
    return evidence_of_units(
        "features",
        {unit: _interpolate(weights.FEATURE, least * scale) for unit, scale in MILLIMETRES.items()},
        {
            unit: Message("unit.shortest-edges", unit=unit, length=least * scale)
            for unit, scale in MILLIMETRES.items()
        },
    )


def paper_evidence(lengths: Lengths) -> list[UnitEvidence]:
    """Return evidence for each unit in which the drawing would be as large as a paper, such as A4.

    The drawing may have this size because it contains a frame or the outline of a page.
    ``lengths`` contains the size of the drawing in file units.
    """
    shorter, longer = sorted((lengths.width, lengths.height))
    found_in = []
    for unit, scale in MILLIMETRES.items():
        for width, height, name in _PAPER:
            if abs(shorter * scale - width) < 0.6 and abs(longer * scale - height) < 0.6:
                message = Message("unit.paper-size", unit=unit, sheet=name)
                found_in.append(UnitEvidence(unit, message, weights.PAPER, "paper"))
                break
    return found_in


def grid_evidence(lengths: Lengths) -> list[UnitEvidence]:
    """Return the evidence for each candidate unit: how many edge lengths are round numbers in it.

    The list is empty if the drawing has no straight edges.  ``lengths`` are the lengths of the
    edges in file units.
    """
    if not len(lengths.value):
        return []
    message = {unit: _grid_message(lengths, unit) for unit in MILLIMETRES}
    return evidence_of_units("grid", grid_likelihood(lengths), message)


def grid_likelihood(lengths: Lengths) -> dict[str, float]:
    """Return for each candidate unit the log-likelihood of the edge lengths.

    It is the logarithm of the probability of these lengths if the drawing is in the candidate unit.
    ``lengths`` are the lengths in file units.
    """
    result = {}
    for unit, scale in MILLIMETRES.items():
        metric = weights.DESIGNED_METRIC[unit]
        result[unit] = float(
            np.logaddexp(
                np.log(metric) + table_likelihood(lengths, scale, weights.METRIC),
                np.log(1.0 - metric) + table_likelihood(lengths, scale, weights.IMPERIAL),
            )
        )
    for family in weights.FAMILIES:
        least = max(result[unit] for unit in family) - weights.FAMILY_ADVANTAGE
        result.update({unit: max(result[unit], least) for unit in family})
    return result


def table_likelihood(lengths: Lengths, scale: float, table: Mapping[float, float]) -> float:
    """Return the log-likelihood of the edges' lengths if they are multiples of given grid spacings.

    Parameters
    ----------
    lengths
        Lengths of the edges of the drawing, in file units.
    scale
        Millimetres in one file unit.
    table
        Grid spacings (mm), and for each the fraction of lengths that are multiples of it.
    """
    fraction = min(1.0, weights.INDEPENDENT / len(lengths.value))
    return max(
        fraction * _log_likelihood(lengths.value, exact, table, scale) for exact in lengths.exact
    )


def _log_likelihood(value: F64, exact: float, table: Mapping[float, float], scale: float) -> float:
    grid = np.array(list(table)) / scale
    weight = np.array(list(table.values()))
    near = np.round(value[:, None] / grid)
    on = (np.abs(value[:, None] - near * grid) <= exact) & (near > 0.0)
    gain = np.where(2.0 * exact < grid, grid / (2.0 * exact), 1.0)
    good = np.where(on, weight * gain, 0.0).sum(axis=1) / weight.sum()
    off = np.array(weights.OFF_GRID)
    likely = np.log(off + (1.0 - off) * good[:, None]).sum(axis=0)
    return float(np.logaddexp.reduce(likely) - np.log(len(off)))


def _grid_message(lengths: Lengths, unit: str) -> Message:
    """Return the message that names the best grid spacing and how many lengths are multiples of it.

    For each grid spacing, the total length of the edges whose lengths are multiples of it is
    computed.  The best grid spacing is the one with the greatest total length.

    ``lengths``: lengths of the edges of the drawing, in file units.
    ``unit``: unit in which the drawing is assumed to be.
    """
    scale = MILLIMETRES[unit]
    fits = []
    for grid, name in _NAMED_GRIDS:
        if grid < 8.0 * lengths.exact[-1] * scale:
            continue
        near = np.round(lengths.value * scale / grid)
        on = (np.abs(lengths.value * scale - near * grid) <= lengths.exact[-1] * scale) & (near > 0)
        fits.append((float(lengths.total[on].sum()), int(on.sum()), name))
    if not fits:
        return Message("unit.imprecise", unit=unit)
    part, count, name = max(fits)
    percent = 100.0 * part / float(lengths.total.sum())
    return Message(
        "unit.multiples",
        unit=unit,
        count=count,
        all=len(lengths.value),
        percent=percent,
        grid=name,
    )


def _interpolate(points: tuple[tuple[float, float], ...], size: float) -> float:
    """Return the weight of evidence for a length ``size`` (mm).

    The weight is interpolated linearly in the logarithm of the length.

    ``points``: lengths (mm) in ascending order, each with its weight of evidence.
    """
    sizes, weight = zip(*points, strict=True)
    return float(np.interp(np.log(max(size, 1e-12)), np.log(sizes), weight))
