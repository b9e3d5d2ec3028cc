"""encoded_polyline: decode the parameters of the instruction PE (polyline encoded) of HP-GL/2.

Each number is written with digits of base 64, the lowest digit first; the highest digit has a code
above 190 and so ends the number.  After the flag "7", the base is 32, and the highest digit has a
code above 94.  The lowest bit of a number is its sign.  Flags between the numbers select a pen,
lift the pen for the next point, make the next point absolute, or set the number of binary places.

Source: PCL 5 Printer Language Technical Reference Manual (HP 5961-0509), chapter 20, PE.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits

_PEN: Final = ord(":")
_UP: Final = ord("<")
_FRACTION: Final = ord(">")
_ABSOLUTE: Final = ord("=")
_SEVEN_BITS: Final = ord("7")
_FLAGS: Final = frozenset((_PEN, _UP, _FRACTION, _ABSOLUTE, _SEVEN_BITS))
#: Code of the digit 0, and distance of the codes of last digits from those of other digits.
_ZERO: Final = 63
_LAST_64: Final = 128
_LAST_32: Final = 32
#: Greatest number of binary places, and of digits of a number.
_PLACES: Final = 26
_DIGITS: Final = 12


class EncodedPoint(NamedTuple):
    """A point of an encoded polyline, and how the pen gets there."""

    x: float
    y: float
    down: bool  #: whether the pen draws a line to the point
    absolute: bool  #: whether x and y are coordinates, not distances from the point before
    pen: int | None  #: pen that is selected before the move, None for the same pen


def decode(text: bytes, position: int, limits: Limits) -> Iterator[EncodedPoint]:
    """Yield the points of an encoded polyline.

    Parameters
    ----------
    text
        Parameters of the instruction.
    position
        Position of the instruction in the file, for messages.
    limits
        Limits of the number of segments.

    Raises
    ------
    NotADrawing
        The parameters are damaged.
    DrawingTooLarge
        The polyline has more points than the limit of segments.
    """
    down_next = True
    absolute = seven_bits = False
    pen: int | None = None
    places = 0
    flag = 0
    number, digits = 0, 0
    x: float | None = None
    points = 0
    for byte in text:
        code = byte & 127 if seven_bits or (byte & 127) in _FLAGS else byte
        if code in _FLAGS:
            if digits or flag in (_PEN, _FRACTION) or x is not None:
                raise _damage_error(position)
            if code == _UP:
                down_next = False
            elif code == _ABSOLUTE:
                absolute = True
            elif code == _SEVEN_BITS:
                seven_bits = True
            else:
                flag = code
            continue
        base, last = (32, _LAST_32) if seven_bits else (64, _LAST_64)
        digit = code - _ZERO
        if not 0 <= digit < base and not 0 <= digit - last < base:
            continue  # the plotter ignores other characters
        is_last = digit >= last
        number += (digit - last if is_last else digit) * base**digits
        digits += 1
        if not is_last:
            if digits > _DIGITS:
                raise _damage_error(position)
            continue
        value = -(number >> 1) if number & 1 else number >> 1
        number, digits = 0, 0
        if flag == _PEN:
            pen, flag = value, 0
        elif flag == _FRACTION:
            if abs(value) > _PLACES:
                raise _damage_error(position)
            places, flag = value, 0
        elif x is None:
            x = value / 2.0**places
        else:
            points += 1
            if points > limits.segments:
                raise DrawingTooLarge(
                    "reading.too-many-segments", format="HPGL", limit=limits.segments
                )
            yield EncodedPoint(x, value / 2.0**places, down_next, absolute, pen)
            x, down_next, absolute, pen = None, True, False, None
    if digits or x is not None or flag:
        raise _damage_error(position)


def _damage_error(position: int) -> NotADrawing:
    return NotADrawing("plt.bad-polyline", position=position)
