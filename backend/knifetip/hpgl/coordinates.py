"""coordinates: the scaling, rotation and window of a plot.

A plotter moves in plotter units of 1/40 mm.  The instruction SC defines user units: either by a
number of plotter units (scaling type 2), or by the user coordinates of the points P1 and P2, which
the instruction IP sets in plotter units.  Without IP these points depend on the paper and the
plotter, so the size of the plot is not known.

Source: PCL 5 Printer Language Technical Reference Manual (HP 5961-0509), chapter 19, IP, IR, RO, SC
and IW.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from knifetip.drawing_builder.clip import UNCLIPPED, Clip
from knifetip.errors import NotADrawing
from knifetip.geometry.affine import Matrix, compose
from knifetip.hpgl.instructions import Instruction, count_is_wrong
from knifetip.hpgl.shapes import Point

#: Length of a plotter unit (mm).
PLOTTER_UNIT: Final = 0.025
#: Scaling types of SC: P1 and P2 scale both axes, both axes have the smaller scale, the scale is
#: given in plotter units.
_BOTH_AXES: Final = 0
_SAME_SCALE: Final = 1
_BY_FACTOR: Final = 2


@dataclass(frozen=True, slots=True)
class Coordinates:
    """The coordinate system of a plot after some of its instructions."""

    #: x and y of P1 and of P2 (plotter units); None if they depend on the plotter
    first: Point | None = None
    second: Point | None = None
    scaling: tuple[float, ...] = ()  #: values of SC; () for plotter units
    quarters: int = 0  #: rotation by quarter turns

    @property
    def stated_scale(self) -> bool:
        """Whether the file states the length of a unit."""
        return (
            not self.scaling
            or self._type == _BY_FACTOR
            or not (self.first is None or self.second is None)
        )

    @property
    def _type(self) -> int:
        return int(self.scaling[4]) if len(self.scaling) > 4 else _BOTH_AXES

    def matrix(self) -> Matrix:
        """Return the matrix from the units of coordinates to mm.

        If the file does not state the length of a unit, the matrix only rotates.
        """
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[self.quarters]
        turn = (cosine, sine, -sine, cosine, 0.0, 0.0)
        if not self.stated_scale:
            return turn
        unit = (PLOTTER_UNIT, 0.0, 0.0, PLOTTER_UNIT, 0.0, 0.0)
        return compose(compose(unit, turn), self._user_matrix())

    def _user_matrix(self) -> Matrix:
        """Return the matrix from user units to plotter units."""
        if not self.scaling:
            return (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        if self._type == _BY_FACTOR:
            x, x_scale, y, y_scale = self.scaling[:4]
            left, bottom = self.first or (0.0, 0.0)
            return x_scale, 0.0, 0.0, y_scale, left - x_scale * x, bottom - y_scale * y
        assert self.first is not None  # because the scale is stated
        assert self.second is not None
        low_x, high_x, low_y, high_y = self.scaling[:4]
        left, bottom = self.first
        wide, high = self.second[0] - left, self.second[1] - bottom
        x_scale, y_scale = wide / (high_x - low_x), high / (high_y - low_y)
        if self._type == _SAME_SCALE:
            scale = min(abs(x_scale), abs(y_scale))
            x_scale, y_scale = (scale if one > 0.0 else -scale for one in (x_scale, y_scale))
            across, up = self.scaling[5:7] if len(self.scaling) > 5 else (50.0, 50.0)
            left += (wide - x_scale * (high_x - low_x)) * across / 100.0
            bottom += (high - y_scale * (high_y - low_y)) * up / 100.0
        return x_scale, 0.0, 0.0, y_scale, left - x_scale * low_x, bottom - y_scale * low_y

    def change(self, instruction: Instruction) -> Coordinates:
        """Return the coordinate system after an instruction IP, IR, RO or SC.

        Raises
        ------
        NotADrawing
            The instruction has a wrong number of values or an invalid scale.
        """
        if instruction.name == "SC":
            return self._scale(instruction)
        if instruction.name == "RO":
            if len(instruction.values) > 1:
                raise count_is_wrong(instruction, 0, 1)
            degrees = instruction.values[0] if instruction.values else 0.0
            return replace(self, quarters=round(degrees / 90.0) % 4)
        values = instruction.values
        if len(values) not in (0, 2, 4):
            raise count_is_wrong(instruction, 0, 2, 4)
        if instruction.name == "IR" or not values:
            return replace(self, first=None, second=None)
        first = values[0], values[1]
        second: Point | None = None
        if len(values) == 4:
            second = values[2], values[3]
        elif self.first is not None and self.second is not None:
            # P2 keeps its distance from P1.
            second = (
                self.second[0] + first[0] - self.first[0],
                self.second[1] + first[1] - self.first[1],
            )
        if second is not None and (first[0] == second[0] or first[1] == second[1]):
            raise NotADrawing("plt.bad-scale", position=instruction.position, name=instruction.name)
        return replace(self, first=first, second=second)

    def _scale(self, instruction: Instruction) -> Coordinates:
        values = instruction.values
        if not values:
            return replace(self, scaling=())
        if len(values) not in (4, 5, 7):
            raise count_is_wrong(instruction, 0, 4, 5, 7)
        kind = values[4] if len(values) > 4 else _BOTH_AXES
        if kind == _BY_FACTOR:
            is_valid = values[1] != 0.0 and values[3] != 0.0
        else:
            is_valid = (
                kind in (_BOTH_AXES, _SAME_SCALE)
                and values[0] != values[1]
                and values[2] != values[3]
            )
        if not is_valid:
            raise NotADrawing("plt.bad-scale", position=instruction.position, name=instruction.name)
        return replace(self, scaling=tuple(values))


def window(instruction: Instruction, matrix: Matrix) -> Clip:
    """Return the visible area that an instruction IW sets.

    Parameters
    ----------
    instruction
        The instruction; without values, everything is visible.
    matrix
        Matrix from the units of coordinates to mm; it turns by multiples of 90°.

    Raises
    ------
    NotADrawing
        The instruction has a wrong number of values.
    """
    if not instruction.values:
        return UNCLIPPED
    if len(instruction.values) != 4:
        raise count_is_wrong(instruction, 0, 4)
    x, y, u, v = instruction.values
    (x, y), (u, v) = transform(matrix, (x, y)), transform(matrix, (u, v))
    return UNCLIPPED.intersect_box((min(x, u), min(y, v), max(x, u), max(y, v)))


def transform(matrix: Matrix, point: Point) -> Point:
    """Return a point that is transformed by a matrix."""
    a, b, c, d, e, f = matrix
    x, y = point
    return a * x + c * y + e, b * x + d * y + f


def transform_back(matrix: Matrix, point: Point) -> Point:
    """Return the point that an invertible matrix transforms to ``point``."""
    a, b, c, d, e, f = matrix
    x, y = point[0] - e, point[1] - f
    area = a * d - b * c
    return (d * x - c * y) / area, (a * y - b * x) / area
