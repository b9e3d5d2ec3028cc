"""byte_scan: kernels that scan the lines of a DXF file, eight bytes at a time.

They parse group codes, find the end of a line, and compare and hash texts.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.geometry.columns import I64
from knifetip.kernels import U8_1, U64, inline_kernel

#: Positions are unsigned, because numba then does not check for negative indices; a sum with this
#: constant remains unsigned.
ONE: Final = np.uint64(1)
#: Returned by ``code_at`` if the line is not a group code.
NO_CODE: Final = -1
_THREE: Final = np.uint64(3)
_EIGHT: Final = np.uint64(8)
#: Value of a digit by its character; 0 for a blank, a large number for all others.
_DIGIT: Final[I64] = np.full(256, 1 << 20)
_DIGIT[48:58] = range(10)
_DIGIT[32] = 0
#: Masks for the first n bytes of a word.
_FIRST: Final = np.array([(1 << 8 * count) - 1 for count in range(8)], np.uint64)


@inline_kernel
def code_at(data: U8_1, position: U64, size: U64) -> Any:
    """Return the group code on the line at byte ``position``, and the start of the next line.

    ``size`` is the number of bytes of the file.  If the line does not contain a group code, the
    code is negative, and the second value is the position at which parsing stopped.
    """
    if position + _THREE < size and data[position + _THREE] == 10:
        first, second, third = data[position], data[position + ONE], data[position + ONE + ONE]
        code = _DIGIT[first] * 100 + _DIGIT[second] * 10 + _DIGIT[third]
        if code < 1000 and third != 32 and (second != 32 or first == 32):
            return code, position + _THREE + ONE
    while position < size and data[position] == 32:
        position += ONE
    code, digits = 0, 0
    while position < size and 48 <= data[position] <= 57:
        code = code * 10 + int(data[position]) - 48
        digits += 1
        position += ONE
    if digits == 0 or digits > 4:
        return NO_CODE, position
    while position < size and data[position] == 32:
        position += ONE
    if position < size and data[position] == 13:
        position += ONE
    if position >= size or data[position] != 10:
        return NO_CODE, position
    return code, position + ONE


@inline_kernel
def eight_bytes_at(data: U8_1, position: U64) -> Any:
    """Return the eight bytes at position ``position`` as a little-endian integer."""
    word = np.uint64(0)
    for offset in range(8):
        word |= np.uint64(data[position + np.uint64(offset)]) << np.uint64(8 * offset)
    return word


@inline_kernel
def end_of_line(data: U8_1, position: U64, size: U64) -> Any:
    """Return the position of the first CR or LF at or after byte ``position``, or ``size`` if none.

    ``size`` is the number of bytes of ``data`` that are searched.
    """
    while position + _EIGHT <= size:
        word = eight_bytes_at(data, position)
        # The lowest byte that is not 0 marks the first character below 16.
        low = (word - np.uint64(0x1010101010101010)) & ~word & np.uint64(0x8080808080808080)
        if low == 0:
            position += _EIGHT
            continue
        lowest = (low & (~low + ONE)) >> np.uint64(7)
        position += (lowest * np.uint64(0x0001020304050607)) >> np.uint64(56)
        if data[position] == 10 or data[position] == 13:
            return position
        position += ONE
    while position < size and data[position] != 10 and data[position] != 13:
        position += ONE
    return position


@inline_kernel
def bytes_equal(data: U8_1, low: int, other_data: U8_1, first: int, count: int) -> bool:
    """Return whether ``count`` bytes of two arrays are equal.

    The bytes begin at ``data[low]`` and at ``other_data[first]``.
    """
    position, other_position = np.uint64(low), np.uint64(first)
    remaining = np.uint64(count)
    if position + remaining + _EIGHT <= np.uint64(
        len(data)
    ) and other_position + remaining + _EIGHT <= np.uint64(len(other_data)):
        while remaining >= _EIGHT:
            if eight_bytes_at(data, position) != eight_bytes_at(other_data, other_position):
                return False
            position += _EIGHT
            other_position += _EIGHT
            remaining -= _EIGHT
        unlike = eight_bytes_at(data, position) ^ eight_bytes_at(other_data, other_position)
        return bool(unlike & _FIRST[remaining] == 0)
    for offset in range(count):
        if data[position + np.uint64(offset)] != other_data[other_position + np.uint64(offset)]:
            return False
    return True


@inline_kernel
def hash_bytes(data: U8_1, low: int, high: int) -> Any:
    """Return a hash of the bytes ``data[low:high]``."""
    position, end = np.uint64(low), np.uint64(high)
    key = end - position
    while position < end:
        if position + _EIGHT <= np.uint64(len(data)):
            word = eight_bytes_at(data, position)
            if end - position < _EIGHT:
                word &= _FIRST[end - position]
        else:
            word = np.uint64(0)
            for offset in range(end - position):
                word |= np.uint64(data[position + np.uint64(offset)]) << np.uint64(8 * offset)
        key = (key ^ word) * np.uint64(0x9E3779B97F4A7C15)
        key ^= key >> np.uint64(47)
        position += _EIGHT
    return key
