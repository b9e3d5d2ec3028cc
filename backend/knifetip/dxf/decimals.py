"""decimals: parse decimal numbers in bytes, rounded correctly like Python's ``float``.

A decimal of up to 19 digits is w · 10^q with an integer w < 2^64.  If w < 2^53 and |q| ≤ 22, the
doubles w and 10^|q| are exact, and one multiplication or division gives the correctly rounded
result.  Otherwise w is multiplied by a 128-bit approximation of 10^q.  This decides the rounding
unless the product is too near the middle between two doubles.  A number whose rounding is not
decided is left to ``float``.  The same applies to a number of more than 19 digits, unless its first
19 digits decide the rounding.

Eight digits of a fraction are parsed at once, as one integer of 64 bits.

Source: Clinger, "How to read floating point numbers accurately" (1990), for the exact case;
Lemire, "Number parsing at a gigabyte per second" (2021), for the approximation.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.dxf.byte_scan import ONE, eight_bytes_at
from knifetip.geometry.columns import F64
from knifetip.kernels import U8_1, U64, inline_kernel, kernel

#: Certainty of the result of ``number``.
EXACT: Final = 0
UNSURE: Final = 1
WRONG: Final = 2

_EIGHT: Final = np.uint64(8)
_NOT: Final = np.uint64(1 << 40)

#: Digits that a word of 64 bits can hold.
_DIGITS: Final = 19
#: Powers of ten that a double holds exactly.
_EXACT_POWERS: Final[F64] = np.array([10.0**power for power in range(23)])
_MIN_POWER: Final = -290
_MAX_POWER: Final = 290


def _powers() -> Any:
    """Return 10^q, for each q from ``_MIN_POWER`` to ``_MAX_POWER``, as a 128-bit significand.

    The significand is the first 128 bits of 10^q, beginning with its highest bit that is 1.  The
    array has the shape (581, 2) and the type uint64: upper and lower 64 bits of each significand.
    """
    table = np.empty((_MAX_POWER - _MIN_POWER + 1, 2), np.uint64)
    for row, q in enumerate(range(_MIN_POWER, _MAX_POWER + 1)):
        if q >= 0:
            power = 10**q
            size = power.bit_length()
            bits = power << (128 - size) if size <= 128 else power >> (size - 128)
        else:
            divisor = 10**-q
            bits = (1 << (127 + divisor.bit_length())) // divisor
            bits >>= bits.bit_length() - 128
        table[row] = bits >> 64, bits & 0xFFFF_FFFF_FFFF_FFFF
    return table


_POWERS: Final = _powers()
#: 2^e for e from -1022 to 1023.
_TWOS: Final[F64] = np.ldexp(1.0, np.arange(-1022, 1024))


@inline_kernel
def _product(a: U64, b: U64) -> Any:
    """Return the upper and the lower 64 bits of the 128-bit product a · b."""
    half = np.uint64(0xFFFFFFFF)
    shift = np.uint64(32)
    a_low, a_high = a & half, a >> shift
    b_low, b_high = b & half, b >> shift
    low = a_low * b_low
    one = a_high * b_low
    two = a_low * b_high
    middle = (low >> shift) + (one & half) + (two & half)
    high = a_high * b_high + (one >> shift) + (two >> shift) + (middle >> shift)
    return high, (middle << shift) | (low & half)


@kernel
def _round_to_double(w: U64, q: int) -> tuple[float, int]:
    """Return w · 10^q, for w > 0, rounded to a double, and whether the rounding is certain.

    The second value is the constant ``EXACT`` if the rounding is certain.  Otherwise it is
    ``UNSURE``, and the first value is 0.
    """
    if q < _MIN_POWER or q > _MAX_POWER:
        return 0.0, UNSURE
    one = np.uint64(1)
    top = np.uint64(63)
    free = 0
    while (w >> top) == 0:
        w = w << one
        free += 1
    exponent = ((217706 * q) >> 16) + 64 - free
    high, low = _product(w, _POWERS[q - _MIN_POWER, 0])
    below = np.uint64(0x1FF)
    if (high & below) == below and low + w < low:
        lower_product, rest = _product(w, _POWERS[q - _MIN_POWER, 1])
        sum_ = low + lower_product
        if sum_ < low:
            high = high + one
        low = sum_
        if (high & below) == below and low + one == 0 and rest + w < rest:
            return 0.0, UNSURE
    first = high >> top
    mantissa = high >> (first + np.uint64(9))
    if first == 0:
        exponent -= 1
    if low == 0 and (high & below) == 0 and (mantissa & np.uint64(3)) == one:
        return 0.0, UNSURE
    mantissa = (mantissa + (mantissa & one)) >> one
    if (mantissa >> np.uint64(53)) > 0:
        mantissa = mantissa >> one
        exponent += 1
    if exponent < -1021 or exponent > 1022:
        return 0.0, UNSURE
    # 53 bits times a power of two: the product is exact.
    return float(np.int64(mantissa)) * 2.0**-52 * _TWOS[exponent + 1022], EXACT


@inline_kernel
def _eight(data: U8_1, position: U64) -> Any:
    """Parse eight decimal digits, the bytes ``data[position]`` to ``data[position + 7]``.

    Returns the integer that they represent, or the constant ``_NOT`` if one of these bytes is not a
    digit.
    """
    word = eight_bytes_at(data, position)
    upper, zeros = np.uint64(0xF0F0F0F0F0F0F0F0), np.uint64(0x3030303030303030)
    # A digit is 3 in its upper half, also when 6 is added.
    if (word & upper) != zeros or ((word + np.uint64(0x0606060606060606)) & upper) != zeros:
        return _NOT
    # Pairs of digits, then of pairs, then of fours, all at once.
    word -= zeros
    word = word * np.uint64(10) + (word >> np.uint64(8))
    pairs = np.uint64(0x000000FF000000FF)
    low = (word & pairs) * np.uint64(0x000F424000000064)
    high = ((word >> np.uint64(16)) & pairs) * np.uint64(0x0000271000000001)
    return ((low + high) >> np.uint64(32)) & np.uint64(0xFFFFFFFF)


@inline_kernel
def _exponent(data: U8_1, position: U64, end: U64) -> Any:
    """Parse the decimal exponent of a number, the characters that follow the letter E.

    Returns the exponent, limited to ±100,000; the position after the exponent; and whether the
    exponent has at least one digit.  Parsing starts at ``data[position]`` and stops before
    ``data[end]``.
    """
    negative = False
    if position < end and (data[position] == 45 or data[position] == 43):
        negative = data[position] == 45
        position += ONE
    power = 0
    has_digit = False
    while position < end and 48 <= data[position] <= 57:
        has_digit = True
        power = min(power * 10 + int(data[position] - 48), 100_000)
        position += ONE
    return -power if negative else power, position, has_digit


@kernel(allocates=False)
def number(data: U8_1, first: U64, last: U64) -> tuple[float, Any, int]:
    """Parse the decimal number on a line.

    Parameters
    ----------
    data : (m,) uint8
        Bytes of the file.
    first
        Position of the line, which may begin and end with blanks.
    last
        Position at which parsing stops.

    Returns
    -------
    value
        The number; undefined if ``sure`` is not ``EXACT``.
    after
        Position of the line's end, LF or CR; undefined if ``sure`` is ``WRONG``.
    sure
        ``EXACT`` if the number is correctly rounded; ``UNSURE`` if the caller must parse the number
        with ``float``; ``WRONG`` if the line is not a finite number.
    """
    position, end = first, last
    while position < end and (data[position] == 32 or data[position] == 9):
        position += ONE
    negative = False
    if position < end and (data[position] == 45 or data[position] == 43):
        negative = data[position] == 45
        position += ONE
    w = np.uint64(0)
    ten = np.uint64(10)
    digits = 0
    any_ = False
    has_more = False  # digits behind the nineteenth that are not 0
    q = 0
    while position < end and 48 <= data[position] <= 57:
        any_ = True
        if digits == _DIGITS:
            has_more = has_more or data[position] != 48
            q += 1
        elif digits > 0 or data[position] != 48:
            digits += 1
            w = w * ten + np.uint64(data[position] - 48)
        position += ONE
    if position < end and data[position] == 46:
        position += ONE
        while 0 < digits <= _DIGITS - 8 and position + _EIGHT <= end:
            several = _eight(data, position)
            if several == _NOT:
                break
            w = w * np.uint64(100_000_000) + several
            digits += 8
            q -= 8
            position += _EIGHT
        while position < end and 48 <= data[position] <= 57:
            any_ = True
            if digits == _DIGITS:
                has_more = has_more or data[position] != 48
            else:
                if digits > 0 or data[position] != 48:
                    digits += 1
                    w = w * ten + np.uint64(data[position] - 48)
                q -= 1
            position += ONE
    if not any_:
        return 0.0, position, WRONG
    if position < end and (data[position] == 69 or data[position] == 101):
        power, position, has_digit = _exponent(data, position + ONE, end)
        if not has_digit:
            return 0.0, position, WRONG
        q += power
    while position < end and (data[position] == 32 or data[position] == 9):
        position += ONE
    if position < end and data[position] != 10 and data[position] != 13:
        return 0.0, position, WRONG
    sign = -1.0 if negative else 1.0
    if w == 0:
        return 0.0 * sign, position, EXACT
    if has_more:
        # The number is between w and w + 1: if both round to one double, so does the number.
        value, sure = _round_to_double(w, q)
        next_value, also = _round_to_double(w + np.uint64(1), q)
        if sure != EXACT or also != EXACT or value != next_value:
            return 0.0, position, UNSURE
        return sign * value, position, EXACT
    while (w >> np.uint64(53)) > 0 and w % ten == 0:
        w //= ten
        q += 1
    if (w >> np.uint64(53)) == 0 and -22 <= q <= 22:
        value = float(np.int64(w))
        value = value / _EXACT_POWERS[-q] if q < 0 else value * _EXACT_POWERS[q]
        return sign * value, position, EXACT
    value, sure = _round_to_double(w, q)
    return sign * value, position, sure
