"""Records of folding: panels, folds, the choices of the user, and what was found.

Before folding, the board lies between z = 0 and z = caliper; x and y are those of the drawing.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from shapely import Polygon

from knifetip.geometry.columns import F64, I64
from knifetip.messages import Message
from knifetip.model.dieline import LineType

SideUp = Literal["outside", "inside"]


@dataclass(frozen=True, eq=False, slots=True)
class Panel:
    """A part of a blank between cuts and folds, which stays flat."""

    blank: int  #: index of its blank, from the largest one
    polygon: Polygon  #: mm; the outline runs counter-clockwise, holes clockwise
    #: hinge on each side of the outline and of each hole, (k,) each; -1 for a cut side
    hinges: tuple[I64, ...]


@dataclass(frozen=True, eq=False, slots=True)
class Hinge:
    """Folding lines between two panels."""

    panels: tuple[int, int]  #: indices of the panels
    line_type: LineType
    ends: F64  #: (2, 2) outermost points of the lines (mm); the first panel lies on their right
    length: float  #: length of the lines without gaps (mm)
    straight: bool  #: whether all lines lie on one straight line


@dataclass(frozen=True, eq=False, slots=True)
class Sheet:
    """The panels of all blanks of a drawing, and the hinges between them."""

    panels: tuple[Panel, ...]
    hinges: tuple[Hinge, ...]
    cuts: F64  #: (c, 2, 2) chords of the cuts (mm)


@dataclass(frozen=True, slots=True)
class FoldOptions:
    """How the blanks are folded."""

    #: side of the carton that lies on top: creases fold away from it if it is the outside
    side_up: SideUp = "outside"
    opening: float | None = None  #: opening angle of grooves (°); None: fold angle of the board
    angles: Mapping[int, float] = field(default_factory=dict)  #: angles by index of the fold (°)


@dataclass(frozen=True, eq=False, slots=True)
class Fold:
    """A hinge in the fold tree: its second panel turns about the axis."""

    parent: int  #: index of the panel nearer to the root
    child: int  #: index of the panel that turns
    hinge: Hinge
    #: (2, 3) start and end of the axis in the flat board (mm); the child lies on its left
    axis: F64
    angle: float  #: angle at the end (°); positive: the child rises towards the top face
    #: angle at which the flanks of the groove meet (°); None for a crease
    opening: float | None
    closes: bool  #: whether other folds join the two panels already, so that it turns nothing


@dataclass(frozen=True, eq=False, slots=True)
class FoldTree:
    """The panels of a sheet in the order of their folds, for a board."""

    panels: tuple[Panel, ...]
    folds: tuple[Fold, ...]  #: in the order of the hinges
    cuts: F64  #: (c, 2, 2) chords of the cuts (mm)
    roots: tuple[int, ...]  #: panel of each blank that stays in place
    order: tuple[int, ...]  #: folds that turn a panel, each after the folds of its parent
    caliper: float  #: mm


class FoldFinding(NamedTuple):
    """A fault of the folded blanks."""

    panels: tuple[int, ...]  #: indices of the panels, the faulty one first
    fold: int  #: index of the fold; -1 for none
    place: tuple[float, float]  #: on the first panel, in the drawing (mm)
    measure: float  #: mm, or degrees for angles
    message: Message
