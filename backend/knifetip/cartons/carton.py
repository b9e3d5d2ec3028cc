"""carton: the record of a drawn carton: cuts, folds and panels, and the edges of its drawing.

The drawing shows the inside of the carton, so that folds go up, towards the reader, as a rule.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from knifetip.geometry.columns import F64, U8
from knifetip.geometry.path import Paths
from knifetip.model.dieline import LineType

Point: TypeAlias = tuple[float, float]
#: Least and greatest coordinates: x min, y min, x max, y max (mm).
Box: TypeAlias = tuple[float, float, float, float]


class Panel(NamedTuple):
    """A panel or a flap of a carton."""

    name: str  #: such as "front" or "glue-flap"; unique in the carton
    box: Box  #: bounding box on the blank (mm)
    point: Point  #: a point on the blank that lies in the panel (mm)


class Fold(NamedTuple):
    """A straight fold between two panels.

    Several folds may join the same panels, as where a slit interrupts a fold.
    """

    start: Point  #: mm
    end: Point  #: mm
    #: angle by which the panel is turned when the carton is closed (degrees): up > 0, down < 0, and
    #: 0 for coplanar panels
    angle: float
    base: str  #: name of the panel that stays in place
    panel: str  #: name of the panel that turns
    line_type: LineType = LineType.CREASE  #: CREASE, V_GROOVE or PERFORATION


class Edges(NamedTuple):
    """The n lines and arcs of a carton: those of its cuts, then its folds."""

    ends: F64  #: (n, 2, 2) mm
    bulge: F64  #: (n,) tan(sweep / 4)
    line_type: U8  #: (n,) LineType
    angle: F64  #: (n,) ``Fold.angle``; 0 for a cut


@dataclass(frozen=True, eq=False, slots=True)
class Carton:
    """A drawn carton.

    The panels and folds form a tree: each panel but the first turns around the folds of one other
    panel.  Panels that are glued to each other or lock into each other are not in the tree.
    """

    outline: Paths  #: one closed path, the outer cut
    cuts: tuple[Paths, ...]  #: slits and holes
    folds: tuple[Fold, ...]
    panels: tuple[Panel, ...]  #: the first one stays in place

    def edges(self) -> Edges:
        """Return all lines and arcs of the drawing."""
        paths = (self.outline, *self.cuts)
        ends = [np.stack([path.start, path.end], axis=1) for path in paths]
        bulge = np.concatenate([path.bulge for path in paths])
        folds = np.array([(fold.start, fold.end) for fold in self.folds]).reshape(-1, 2, 2)
        kinds = [fold.line_type for fold in self.folds]
        cut, none = np.full(len(bulge), LineType.CUT), np.zeros(len(bulge))
        return Edges(
            np.concatenate([*ends, folds]),
            np.concatenate([bulge, np.zeros(len(folds))]),
            np.concatenate([cut, kinds]).astype(np.uint8),
            np.concatenate([none, [fold.angle for fold in self.folds]]),
        )
