"""path_builder: build paths from the operators of a content stream, in path coordinates.

For example, ``10 20 m 30 20 l h`` gives two lines, the second of which closes the path.

Source: ISO 32000-1, chapter 8.5.2.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from typing import Final

import numpy as np

from knifetip.drawing_builder.path_segments import too_many
from knifetip.drawing_builder.path_table import CUBIC, LINE, Table
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64


class PathBuilder:
    """Builds the current path from operators, and collects the segments of the kept paths."""

    def __init__(self, limits: Limits) -> None:
        self.kind = array("B")
        self.numbers = array("d")  #: eight for each segment, as in ``paths.Table``
        self.wrong: str  #: the first operator with invalid operands, empty if none
        self.started: bool  #: whether the current path has operators
        self._limits = limits
        self._kept = 0
        self._start_path()

    def add(self, operator: str, operands: list[float]) -> None:
        """Apply a path operator with its operands to the current path.

        ``operator`` is a key of ``BUILDERS``.  The first operator with invalid operands is stored
        in the attribute ``wrong``.
        """
        try:
            BUILDERS[operator](self, *operands)
        except TypeError:
            # The number or the type of the operands is wrong.
            self.wrong = self.wrong or operator
        self.started = True

    @property
    def size(self) -> int:
        """Number of segments of the current path."""
        return len(self.kind) - self._kept

    def ends(self) -> F64:
        """Return the n end points and control points of the current path's segments, (n, 2)."""
        numbers = np.array(self.numbers[8 * self._kept :]).reshape(-1, 4, 2)
        curved = np.array(self.kind[self._kept :]) == CUBIC
        return np.concatenate([numbers[:, :2].reshape(-1, 2), numbers[curved, 2:].reshape(-1, 2)])

    def table(self) -> Table:
        """Return the segments of the current path."""
        numbers = np.array(self.numbers[8 * self._kept :]).reshape(-1, 8)
        return Table(
            np.array(self.kind[self._kept :], np.uint8), numbers, np.zeros(self.size, np.int64)
        )

    def keep(self) -> int:
        """Add the current path to the kept paths and start a new path.

        Returns the number of segments of the path that was added.
        """
        size = self.size
        self._kept = len(self.kind)
        self._start_path()
        return size

    def drop(self) -> None:
        """Remove the segments of the current path and start a new path."""
        del self.kind[self._kept :]
        del self.numbers[8 * self._kept :]
        self._start_path()

    def _start_path(self) -> None:
        self.wrong, self.started = "", False
        self._x = self._y = self._start_x = self._start_y = float("nan")

    def _move(self, x: float, y: float) -> None:
        self._x, self._y = self._start_x, self._start_y = x, y

    def _line(self, x: float, y: float) -> None:
        self.kind.append(LINE)
        self.numbers.extend((self._x, self._y, x, y, 0.0, 0.0, 0.0, 0.0))
        self._x, self._y = x, y
        if len(self.kind) > self._limits.segments:
            raise too_many(self._limits, "PDF")

    def _curve(self, a: float, b: float, c: float, d: float, x: float, y: float) -> None:
        self.kind.append(CUBIC)
        self.numbers.extend((self._x, self._y, x, y, a, b, c, d))
        self._x, self._y = x, y
        if len(self.kind) > self._limits.segments:
            raise too_many(self._limits, "PDF")

    def _curve_from(self, c: float, d: float, x: float, y: float) -> None:
        self._curve(self._x, self._y, c, d, x, y)

    def _curve_to(self, a: float, b: float, x: float, y: float) -> None:
        self._curve(a, b, x, y, x, y)

    def _close(self) -> None:
        if self._x != self._start_x or self._y != self._start_y:
            self._line(self._start_x, self._start_y)

    def _rectangle(self, x: float, y: float, wide: float, high: float) -> None:
        self._move(x, y)
        self._line(x + wide, y)
        self._line(x + wide, y + high)
        self._line(x, y + high)
        self._close()


#: Operators that build a path.
BUILDERS: Final[dict[str, Callable[..., None]]] = {
    "m": PathBuilder._move,
    "l": PathBuilder._line,
    "c": PathBuilder._curve,
    "v": PathBuilder._curve_from,
    "y": PathBuilder._curve_to,
    "h": PathBuilder._close,
    "re": PathBuilder._rectangle,
}
