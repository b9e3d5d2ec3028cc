"""group_values: kernels that parse names and integers, and check values that are not stored."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.dxf.byte_scan import bytes_equal, hash_bytes
from knifetip.dxf.decimals import WRONG, number
from knifetip.dxf.fast_reader import state as s
from knifetip.dxf.value_types import DECIMAL, HEX, INTEGER
from knifetip.kernels import U8_1, OutI32_1, OutI64_1, OutI64_2, inline_kernel

#: Largest number of probes; a file with more collisions is an attack.
_MOST_STEPS: Final = 64
#: Returned by ``whole_at`` for a value that is no integer.
NONE: Final = -(1 << 62)


@inline_kernel
def name_at(
    data: U8_1, low: int, high: int, spans: OutI64_2, slots: OutI32_1, state: OutI64_1
) -> Any:
    """Return the index of the name ``data[low:high]`` in the table of names of the file.

    A name that is not in the table is added.  Returns -1 if the name begins or ends with a blank,
    or if the table is full.  ``spans`` contains the positions of the names in the file, ``slots``
    is the hash table of names, whose length is a power of two, and ``state`` contains the number of
    names.
    """
    if high > low and (data[low] <= 32 or data[high - 1] <= 32):
        return -1
    slot = np.int64(hash_bytes(data, low, high) & np.uint64(len(slots) - 1))
    for _ in range(_MOST_STEPS):
        stored = slots[slot]
        if stored < 0:
            number = state[s.NAMES]
            if number == len(spans):
                return -1
            spans[number, 0], spans[number, 1] = low, high
            slots[slot] = number
            state[s.NAMES] = number + 1
            return number
        first = spans[stored, 0]
        if spans[stored, 1] - first == high - low and bytes_equal(
            data, first, data, low, high - low
        ):
            return stored
        slot = (slot + 1) & (len(slots) - 1)
    return -1


@inline_kernel
def integer_at(data: U8_1, low: int, high: int) -> int:
    """Return the integer that is written in ``data[low:high]``.

    The constant ``NONE`` is returned if these bytes are not an integer of up to 18 digits with
    optional blanks around it.
    """
    while low < high and data[low] == 32:
        low += 1
    while low < high and data[high - 1] == 32:
        high -= 1
    negative = low < high and data[low] == 45
    if negative:
        low += 1
    if low == high or high - low > 18:
        return NONE
    result = 0
    for position in range(low, high):
        if not 48 <= data[position] <= 57:
            return NONE
        result = result * 10 + int(data[position]) - 48
    return -result if negative else result


@inline_kernel
def valid(data: U8_1, low: int, high: int, value_type: int) -> bool:
    """Return whether the bytes ``data[low:high]`` are a valid value of the type ``value_type``.

    The types ``DECIMAL``, ``INTEGER`` and ``HEX`` of ``group_codes`` are checked; values of any
    other type are always valid.
    """
    if value_type == DECIMAL:
        _, _, sure = number(data, np.uint64(low), np.uint64(high))
        return bool(sure != WRONG)
    if value_type == INTEGER:
        return integer_at(data, low, high) != NONE
    if value_type == HEX:
        for position in range(low, high):
            sign = data[position] | 32
            if not (48 <= data[position] <= 57 or 97 <= sign <= 102):
                return False
        return (high - low) % 2 == 0
    return True
