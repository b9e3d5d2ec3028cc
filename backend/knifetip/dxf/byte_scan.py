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
def code_at(data: U8_1, at: U64, size: U64) -> Any:
    """Return the group code on the line that starts at byte ``at``, and the start of the next line.

    ``size`` is the number of bytes of the file.  The code is negative if the line does not contain
    a group code.
    """
    if at + _THREE < size and data[at + _THREE] == 10:
        first, second, third = data[at], data[at + ONE], data[at + ONE + ONE]
        code = _DIGIT[first] * 100 + _DIGIT[second] * 10 + _DIGIT[third]
        if code < 1000 and third != 32 and (second != 32 or first == 32):
            return code, at + _THREE + ONE
    while at < size and data[at] == 32:
        at += ONE
    code, digits = 0, 0
    while at < size and 48 <= data[at] <= 57:
        code = code * 10 + int(data[at]) - 48
        digits += 1
        at += ONE
    if digits == 0 or digits > 4:
        return NO_CODE, at
    while at < size and data[at] == 32:
        at += ONE
    if at < size and data[at] == 13:
        at += ONE
    if at >= size or data[at] != 10:
        return NO_CODE, at
    return code, at + ONE


@inline_kernel
def eight_at(data: U8_1, at: U64) -> Any:
    """Return the eight bytes at position ``at`` as a little-endian integer."""
    word = np.uint64(0)
    for place in range(8):
        word |= np.uint64(data[at + np.uint64(place)]) << np.uint64(8 * place)
    return word


@inline_kernel
def end_of_line(data: U8_1, at: U64, size: U64) -> Any:
    """Return the position of the first CR or LF from byte ``at`` on, or ``size`` if there is none.

    ``size`` is the number of bytes to search.
    """
    while at + _EIGHT <= size:
        word = eight_at(data, at)
        # The lowest byte that is not 0 marks the first character below 16.
        low = (word - np.uint64(0x1010101010101010)) & ~word & np.uint64(0x8080808080808080)
        if low == 0:
            at += _EIGHT
            continue
        lowest = (low & (~low + ONE)) >> np.uint64(7)
        at += (lowest * np.uint64(0x0001020304050607)) >> np.uint64(56)
        if data[at] == 10 or data[at] == 13:
            return at
        at += ONE
    while at < size and data[at] != 10 and data[at] != 13:
        at += ONE
    return at


@inline_kernel
def same(data: U8_1, low: int, other: U8_1, first: int, count: int) -> bool:
    """Return whether ``count`` bytes from ``data[low]`` on equal those from ``other[first]`` on."""
    here, there = np.uint64(low), np.uint64(first)
    left = np.uint64(count)
    if here + left + _EIGHT <= np.uint64(len(data)) and there + left + _EIGHT <= np.uint64(
        len(other)
    ):
        while left >= _EIGHT:
            if eight_at(data, here) != eight_at(other, there):
                return False
            here += _EIGHT
            there += _EIGHT
            left -= _EIGHT
        unlike = eight_at(data, here) ^ eight_at(other, there)
        return bool(unlike & _FIRST[left] == 0)
    for place in range(count):
        if data[here + np.uint64(place)] != other[there + np.uint64(place)]:
            return False
    return True


@inline_kernel
def hashed(data: U8_1, low: int, high: int) -> Any:
    """Return a hash of the bytes ``data[low:high]``."""
    at, end = np.uint64(low), np.uint64(high)
    key = end - at
    while at < end:
        if at + _EIGHT <= np.uint64(len(data)):
            word = eight_at(data, at)
            if end - at < _EIGHT:
                word &= _FIRST[end - at]
        else:
            word = np.uint64(0)
            for place in range(end - at):
                word |= np.uint64(data[at + np.uint64(place)]) << np.uint64(8 * place)
        key = (key ^ word) * np.uint64(0x9E3779B97F4A7C15)
        key ^= key >> np.uint64(47)
        at += _EIGHT
    return key
