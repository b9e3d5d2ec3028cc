"""transform: parse the ``transform`` attribute into a matrix.

The matrix (a, b, c, d, e, f) maps (x, y) to (a x + c y + e, b x + d y + f).
"""

from __future__ import annotations

import math
import re
from typing import Final

from knifetip.formats.invalid_content import InvalidContent
from knifetip.geometry.affine import IDENTITY, Matrix, compose

_CALL: Final = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")
_SEPARATOR: Final = re.compile(r"[\s,]+")
_NUMBER: Final = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def parse_numbers(text: str) -> list[float]:
    """Return the numbers in a text.

    They are separated by blanks or commas, or only by the sign of the second number ("3-4").

    Raises
    ------
    InvalidContent
        The text contains something that is not a number.
    """
    rest = _SEPARATOR.sub("", _NUMBER.sub("", text))
    if rest:
        raise InvalidContent("import.value-not-numbers", value=rest[:20])
    return [float(number) for number in _NUMBER.findall(text)]


def parse_transform(text: str) -> Matrix:
    """Return the matrix of a ``transform`` attribute, such as "translate(10 20) rotate(90)".

    The last transform in the text is applied first.

    Raises
    ------
    InvalidContent
        The text is not a valid list of transforms.
    """
    matrix = IDENTITY
    position = 0
    while position < len(text):
        call = _CALL.match(text, position)
        if call is None:
            if not text[position:].strip(" \t\r\n,"):
                break
            raise InvalidContent(
                "import.value-not-transform", value=text[position : position + 30].strip()
            )
        matrix = compose(matrix, _matrix_of(call[1], parse_numbers(call[2])))
        position = call.end()
    return matrix


def _matrix_of(name: str, arguments: list[float]) -> Matrix:
    count = len(arguments)
    if name == "matrix" and count == 6:
        a, b, c, d, e, f = arguments
        return a, b, c, d, e, f
    if name == "translate" and count in (1, 2):
        return 1.0, 0.0, 0.0, 1.0, arguments[0], arguments[1] if count == 2 else 0.0
    if name == "scale" and count in (1, 2):
        return arguments[0], 0.0, 0.0, arguments[-1], 0.0, 0.0
    if name == "rotate" and count in (1, 3):
        cosine, sine = cosine_and_sine(arguments[0])
        turn = (cosine, sine, -sine, cosine, 0.0, 0.0)
        if count == 1:
            return turn
        _, x, y = arguments
        return compose((1.0, 0.0, 0.0, 1.0, x, y), compose(turn, (1.0, 0.0, 0.0, 1.0, -x, -y)))
    if name == "skewX" and count == 1:
        return 1.0, 0.0, math.tan(math.radians(arguments[0])), 1.0, 0.0, 0.0
    if name == "skewY" and count == 1:
        return 1.0, math.tan(math.radians(arguments[0])), 0.0, 1.0, 0.0, 0.0
    raise InvalidContent("import.value-transform-numbers", name=name, count=count)


def cosine_and_sine(degrees: float) -> tuple[float, float]:
    """Return cosine and sine of an angle in degrees, exact for multiples of 90°.

    Raises
    ------
    InvalidContent
        The angle is not finite.
    """
    if not math.isfinite(degrees):
        raise InvalidContent("import.value-angle", degrees=degrees)
    quarter, rest = divmod(degrees % 360.0, 90.0)
    if rest == 0.0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
    angle = math.radians(degrees)
    return math.cos(angle), math.sin(angle)
