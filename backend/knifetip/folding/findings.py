"""findings: what is wrong with the blanks when they are folded by their angles.

Panels may overlap by the caliper of the board, because creases and edges give way by as much.  In
thin board 1 mm is permitted, since drawings have allowances of this size.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import Final

import numpy as np
import shapely

from knifetip.folding.contact import FLAT, Crossing, Plate, crossings, facing_overlap
from knifetip.folding.motion import panel_transforms
from knifetip.folding.records import FoldFinding, FoldTree
from knifetip.geometry.columns import F64
from knifetip.messages import Message

#: Least overlap that is a fault (mm).
_LEAST: Final = 1.0
#: Depth by which solids may lie deeper in each other, for rounding (mm).
_ROUNDING: Final = 0.05
#: Angle by which a fold may exceed the opening of its groove (°).
_ANGLE: Final = 0.5
#: Most findings of a drawing.
MOST_FINDINGS: Final = 100


def find_faults(tree: FoldTree) -> list[FoldFinding]:
    """Return the faults of the folded blanks: folds first, then panels; at most 100."""
    placed = panel_transforms(tree, np.ones(1))[0]
    margin = max(tree.caliper, _LEAST)
    found = [*_fold_faults(tree), *_gaps(tree, placed, margin)]
    found += islice(_panel_faults(tree, placed, margin), MOST_FINDINGS)
    return found[:MOST_FINDINGS]


def _fold_faults(tree: FoldTree) -> Iterator[FoldFinding]:
    """Yield the folds that are not straight, and those whose grooves are too narrow."""
    for number, fold in enumerate(tree.folds):
        panels = (fold.child, fold.parent)
        middle = fold.axis[:, :2].mean(axis=0).tolist()
        place = (middle[0], middle[1])
        named = {"panel": fold.child + 1, "other": fold.parent + 1}
        if not fold.hinge.straight:
            message = Message("folding.not-straight", **named)
            yield FoldFinding(panels, number, place, fold.hinge.length, message)
        elif fold.opening is not None and fold.angle > fold.opening + _ANGLE:
            message = Message(
                "folding.groove-narrow", **named, angle=fold.opening, required=fold.angle
            )
            yield FoldFinding(panels, number, place, fold.angle - fold.opening, message)


def _gaps(tree: FoldTree, placed: F64, margin: float) -> Iterator[FoldFinding]:
    """Yield the folds that turn nothing, and whose panels do not meet."""
    for number, fold in enumerate(tree.folds):
        if not fold.closes:
            continue
        points = np.column_stack([fold.axis, np.ones(2)])
        apart = points @ placed[fold.parent].T - points @ placed[fold.child].T
        gap = float(np.linalg.norm(apart, axis=1).max())
        if gap > margin:
            message = Message(
                "folding.gap", panel=fold.child + 1, other=fold.parent + 1, distance=gap
            )
            middle = fold.axis[:, :2].mean(axis=0).tolist()
            panels = (fold.child, fold.parent)
            yield FoldFinding(panels, number, (middle[0], middle[1]), gap, message)


def _panel_faults(tree: FoldTree, placed: F64, margin: float) -> Iterator[FoldFinding]:
    """Yield panels of one blank that cross, or reach too far; folded neighbours do not count."""
    plates = _plates(tree, placed, margin)
    joined = {frozenset((fold.parent, fold.child)) for fold in tree.folds}
    for one, other in _near_pairs(plates, margin):
        if frozenset((one, other)) in joined:
            continue
        if tree.panels[one].blank != tree.panels[other].blank:
            continue
        faults = [
            _crossing_fault((one, other), crossing, margin, tree.caliper)
            for crossing in crossings(plates[one], plates[other], margin)
        ]
        worst = max((fault for fault in faults if fault), key=lambda f: f.measure, default=None)
        if worst is not None:
            yield worst
            continue
        overlap = facing_overlap(plates[one], plates[other], 1.5 * margin)
        if overlap > margin:
            message = Message(
                "folding.flaps-overlap", panel=one + 1, other=other + 1, distance=overlap
            )
            place = tree.panels[one].polygon.point_on_surface()
            yield FoldFinding((one, other), -1, (place.x, place.y), overlap, message)


def _crossing_fault(
    pair: tuple[int, int], crossing: Crossing, margin: float, caliper: float
) -> FoldFinding | None:
    """Return what is wrong where two panels meet; None if they overlap within the margin."""
    through = crossing.through
    shorter = int(through[1] < through[0])
    depth, permitted = _solid_depth(crossing, caliper)
    # The part of each flap behind the other panel, seen from its fold.
    behind = [
        None if hinge is None or abs(hinge) <= margin else (high if hinge < 0.0 else -low)
        for hinge, (low, high) in zip(crossing.hinge, crossing.reach, strict=True)
    ]
    is_flat = crossing.angle <= FLAT
    hanging = [k for k in range(2) if (behind[k] or 0.0) > margin and not is_flat]
    if min(through) > margin and not is_flat:
        far = behind[shorter]
        long = far is not None and far <= through[shorter] + margin
        code = "folding.flap-too-long" if long else "folding.collision"
        distance = through[shorter]
    elif hanging:
        shorter = hanging[0]
        code, distance = "folding.flap-too-long", behind[shorter] or 0.0
    elif depth > permitted:
        code, distance = "folding.solids-collide", depth
    else:
        return None
    panels = (pair[shorter], pair[1 - shorter])
    named = {"panel": panels[0] + 1, "other": panels[1] + 1, "distance": distance}
    if code == "folding.solids-collide":
        named["caliper"] = caliper
    message = Message(code, **named)
    return FoldFinding(panels, -1, crossing.places[shorter], distance, message)


def _solid_depth(crossing: Crossing, caliper: float) -> tuple[float, float]:
    """Return how far the solids of two panels lie in each other, and how far they may (mm).

    Solids of thickness T whose middle faces cross at the angle α can be separated along the normal
    of either panel; r is how far the other one reaches through its middle face::

        depth = r sin α + T / 2 (1 + cos α)

    A depth of T (1 + cos α) is permitted: the caliper, by which creases and edges give way, and
    what panels that lie on each other share, because their folds lie on common lines.
    """
    angle = math.radians(crossing.angle)
    half = caliper / 2.0 * (1.0 + math.cos(angle))
    depth = min(crossing.through) * math.sin(angle) + half
    return depth, half + max(half, _LEAST) + _ROUNDING


def _plates(tree: FoldTree, placed: F64, margin: float) -> list[Plate]:
    """Return the middle faces of the panels."""
    middles = shapely.STRtree(shapely.points(tree.cuts.mean(axis=1)))
    flaps = _flaps(tree)
    plates = []
    for k, panel in enumerate(tree.panels):
        inner = middles.query(panel.polygon.buffer(-0.1), "intersects")
        slits = [shapely.MultiLineString([*tree.cuts[inner]]), *panel.polygon.interiors]
        # Twice the margin, because what lies within the margin of a panel touches it.
        around = shapely.union_all([shapely.buffer(one, 2.0 * margin) for one in slits])
        closed = shapely.difference(panel.polygon, around)
        # A panel that consists of slits is compared as a whole.
        closed = panel.polygon if closed.is_empty else closed
        plates.append(Plate(panel.polygon, closed, placed[k], tree.caliper / 2.0, flaps.get(k)))
    return plates


def _flaps(tree: FoldTree) -> dict[int, F64]:
    """Return fold and direction of the panels with one fold, which are no roots."""
    folds_of: dict[int, list[int]] = {}
    for number, fold in enumerate(tree.folds):
        for panel in (fold.parent, fold.child):
            folds_of.setdefault(panel, []).append(number)
    flaps = {}
    for panel, numbers in folds_of.items():
        fold = tree.folds[numbers[0]]
        if len(numbers) == 1 and fold.child == panel and not fold.closes:
            along = fold.axis[1, :2] - fold.axis[0, :2]
            away = np.array([-along[1], along[0]]) / np.hypot(*along)
            flaps[panel] = np.stack([fold.axis[:, :2].mean(axis=0), away])
    return flaps


def _near_pairs(plates: list[Plate], margin: float) -> Iterator[tuple[int, int]]:
    """Yield the pairs of panels whose bounding boxes in space are near each other."""
    if not plates:
        return
    low, high = [], []
    for plate in plates:
        corners = shapely.get_coordinates(plate.outline.exterior)
        points = corners @ plate.placed[:3, :2].T + plate.origin
        low.append(points.min(axis=0) - margin)
        high.append(points.max(axis=0) + margin)
    lows, highs = np.array(low), np.array(high)
    for one in range(len(plates) - 1):
        near = (lows[one + 1 :] <= highs[one]).all(axis=1) & (highs[one + 1 :] >= lows[one]).all(1)
        for other in (np.flatnonzero(near) + one + 1).tolist():
            yield one, other
