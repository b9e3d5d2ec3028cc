"""outline: a path while it is built, in the coordinates that it is written in.

    m 10 20, l 30 20, h -> two lines, there and back

Source: ISO 32000-1, chapter 8.5.2.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from typing import Final

import numpy as np

from knifetip.drawing_builder.paths import CUBIC, LINE, too_many
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64


class Outline:
    """The segments of all paths that are kept so far, and behind them those of the next one."""

    def __init__(self, limits: Limits) -> None:
        self.kind = array("B")
        self.numbers = array("d")  #: eight to a segment, as ``paths.Table`` has them
        self.wrong: str  #: the operator that cannot be read
        self.begun: bool
        self._limits = limits
        self._kept = 0
        self._over()

    def add(self, operator: str, given: list[float]) -> None:
        """Go on with the path by one of ``BUILDS``."""
        try:
            BUILDS[operator](self, *given)
        except TypeError:
            # Too few numbers, too many, or something that is none.
            self.wrong = self.wrong or operator
        self.begun = True

    @property
    def size(self) -> int:
        """Segments of the path."""
        return len(self.kind) - self._kept

    def ends(self) -> F64:
        """Return the points between which the path lies, (n, 2)."""
        numbers = np.array(self.numbers[8 * self._kept :]).reshape(-1, 4, 2)
        curved = np.array(self.kind[self._kept :]) == CUBIC
        return np.concatenate([numbers[:, :2].reshape(-1, 2), numbers[curved, 2:].reshape(-1, 2)])

    def keep(self) -> int:
        """Keep the path, and return how many segments it has."""
        size = self.size
        self._kept = len(self.kind)
        self._over()
        return size

    def drop(self) -> None:
        """Forget the path."""
        del self.kind[self._kept :]
        del self.numbers[8 * self._kept :]
        self._over()

    def _over(self) -> None:
        self.wrong, self.begun = "", False
        self._x = self._y = self._home_x = self._home_y = float("nan")

    def _move(self, x: float, y: float) -> None:
        self._x, self._y = self._home_x, self._home_y = x, y

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
        if self._x != self._home_x or self._y != self._home_y:
            self._line(self._home_x, self._home_y)

    def _rectangle(self, x: float, y: float, wide: float, high: float) -> None:
        self._move(x, y)
        self._line(x + wide, y)
        self._line(x + wide, y + high)
        self._line(x, y + high)
        self._close()


#: Operators that build a path.
BUILDS: Final[dict[str, Callable[..., None]]] = {
    "m": Outline._move,
    "l": Outline._line,
    "c": Outline._curve,
    "v": Outline._curve_from,
    "y": Outline._curve_to,
    "h": Outline._close,
    "re": Outline._rectangle,
}
