"""tree: order the panels of a sheet by their folds, from a root panel of each blank.

The root is the largest panel that is no flap.  The tree grows by the longest straight fold each
time (the method of Prim, "Shortest connection networks and some generalizations", 1957).  A fold
between two panels that the tree joins already turns nothing; the finding ``folding.gap`` shows
whether it closes.
"""

from __future__ import annotations

import heapq
from typing import Final

import numpy as np

from knifetip.folding.records import Fold, FoldOptions, FoldTree, Hinge, Sheet
from knifetip.model.board import Board
from knifetip.model.dieline import LineType

#: Angle of a crease (°).
_CREASE_ANGLE: Final = 90.0
#: Share of the area of the largest panel from which a panel can be the root.
_AS_LARGE: Final = 0.99


def build_tree(sheet: Sheet, board: Board, options: FoldOptions) -> FoldTree:
    """Return the fold tree of a sheet of a board.

    The axis of a V-groove lies in the bottom face, opposite to the groove.  The axis of a crease
    lies in the middle of the board.
    """
    roots = _roots(sheet)
    of_panel: dict[int, list[int]] = {}
    for number, hinge in enumerate(sheet.hinges):
        for panel in hinge.panels:
            of_panel.setdefault(panel, []).append(number)
    order: list[int] = []
    parent: dict[int, int] = {}
    reached = set(roots)
    waiting: list[tuple[bool, float, int, int]] = []

    def wait(panel: int) -> None:
        for number in of_panel.get(panel, ()):
            hinge = sheet.hinges[number]
            heapq.heappush(waiting, (not hinge.straight, -hinge.length, number, panel))

    for root in roots:
        wait(root)
    while waiting:
        _, _, number, panel = heapq.heappop(waiting)
        other = _other(sheet.hinges[number], panel)
        if other in reached:
            continue
        reached.add(other)
        order.append(number)
        parent[number] = panel
        wait(other)
    folds = [
        _fold(hinge, parent.get(number), board, options, number)
        for number, hinge in enumerate(sheet.hinges)
    ]
    return FoldTree(sheet.panels, tuple(folds), sheet.cuts, roots, tuple(order), board.caliper)


def _roots(sheet: Sheet) -> tuple[int, ...]:
    """Return the root panel of each blank: of the largest panels the one nearest to the middle.

    A panel with one fold is a flap, which is a root only if a blank has no other panels.
    """
    count = np.bincount([k for hinge in sheet.hinges for k in hinge.panels], minlength=1)
    roots = []
    for blank in sorted({panel.blank for panel in sheet.panels}):
        mine = [k for k, panel in enumerate(sheet.panels) if panel.blank == blank]
        inner = [k for k in mine if k < len(count) and count[k] > 1] or mine
        area = np.array([sheet.panels[k].polygon.area for k in mine])
        centre = np.array([sheet.panels[k].polygon.centroid.coords[0] for k in mine])
        middle = area @ centre / area.sum()
        largest = max(sheet.panels[k].polygon.area for k in inner)
        away = {
            k: float(np.hypot(*(centre[mine.index(k)] - middle)))
            for k in inner
            if sheet.panels[k].polygon.area >= _AS_LARGE * largest
        }
        roots.append(min(away, key=lambda k: away[k]))
    return tuple(roots)


def _other(hinge: Hinge, panel: int) -> int:
    return hinge.panels[1] if hinge.panels[0] == panel else hinge.panels[0]


def _fold(
    hinge: Hinge, parent: int | None, board: Board, options: FoldOptions, number: int
) -> Fold:
    """Return the fold of a hinge; its parent is None if it turns nothing."""
    start = hinge.panels[0] if parent is None else parent
    ends = hinge.ends if start == hinge.panels[0] else hinge.ends[::-1]
    groove = hinge.line_type == LineType.V_GROOVE
    height = 0.0 if groove else board.caliper / 2.0
    axis = np.column_stack([ends, np.full(2, height)])
    angle = options.angles.get(number)
    if not hinge.straight:
        angle = 0.0
    elif angle is None:
        down = options.side_up == "outside"
        angle = board.fold_angle if groove else -_CREASE_ANGLE if down else _CREASE_ANGLE
    opening = options.opening if options.opening is not None else board.fold_angle
    return Fold(
        start,
        _other(hinge, start),
        hinge,
        axis,
        angle,
        opening if groove else None,
        parent is None,
    )
