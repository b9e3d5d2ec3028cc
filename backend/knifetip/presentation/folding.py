"""A folded drawing as JSON data: panels with their places, folds, and faults."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from knifetip.folding.motion import panel_transforms
from knifetip.folding.records import FoldFinding, FoldTree
from knifetip.folding.solid import panel_solids
from knifetip.geometry.columns import F64
from knifetip.messages import finite

#: Decimals of lengths (mm) and angles (°), and of the numbers of transforms.
_DECIMALS: Final = 3
_EXACT: Final = 9


def folding_json(tree: FoldTree, faults: Sequence[FoldFinding], fraction: float) -> dict[str, Any]:
    """Return a folded drawing as JSON data (mm, °); panels and folds count from 1.

    Parameters
    ----------
    tree
        The fold tree.
    faults
        Faults of the blanks when they are folded by their whole angles.
    fraction
        Share of its angle by which each fold has turned, 0 … 1.
    """
    placed = panel_transforms(tree, np.array([fraction]))[0]
    panels = [
        {
            "number": k + 1,
            "blank": panel.blank + 1,
            "area": round(panel.polygon.area, _DECIMALS),
            "bottom": [_rounded(ring) for ring in solid.bottom],
            "top": [_rounded(ring) for ring in solid.top],
            "transform": placed[k].round(_EXACT).tolist(),
        }
        for k, (panel, solid) in enumerate(zip(tree.panels, panel_solids(tree), strict=True))
    ]
    folds = [
        {
            "number": k + 1,
            "parent": fold.parent + 1,
            "child": fold.child + 1,
            "type": fold.hinge.line_type.word,
            "axis": fold.axis.round(_EXACT).tolist(),
            "length": round(fold.hinge.length, _DECIMALS),
            "angle": fold.angle,
            "opening": fold.opening,
            "closes": fold.closes,
            "straight": fold.hinge.straight,
        }
        for k, fold in enumerate(tree.folds)
    ]
    return {
        "caliper": tree.caliper,
        "fraction": fraction,
        "roots": [root + 1 for root in tree.roots],
        "order": [number + 1 for number in tree.order],
        "panels": panels,
        "folds": folds,
        "findings": [_finding(fault) for fault in faults],
    }


def _finding(fault: FoldFinding) -> dict[str, Any]:
    return {
        **fault.message.as_json(),
        "panels": [panel + 1 for panel in fault.panels],
        "fold": None if fault.fold < 0 else fault.fold + 1,
        "place": [round(value, _DECIMALS) for value in fault.place],
        "measure": round(finite(fault.measure), _DECIMALS),
    }


def _rounded(ring: F64) -> list[list[float]]:
    points: list[list[float]] = ring.round(_DECIMALS).tolist()
    return points
