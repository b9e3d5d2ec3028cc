"""handle_set: check the handles of all entities, and write them as text for the import report.

An entity without a handle gets ``#17`` if it is the 17th entity of model space or of its block.  An
entity of a block that an INSERT places gets the handle of the INSERT, a slash and its own handle.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import state as s
from knifetip.geometry.columns import I32, I64
from knifetip.kernels import I32_1, I64_1, U8_1, OutI64_1, OutU8_1, inline_kernel, kernel
from knifetip.model.words import TextSlices

#: Largest number of digits of a handle.
_DIGITS: Final = 15
#: Handles are mostly consecutive numbers.  A table of all numbers is used up to this many numbers
#: per handle, and sorting beyond it.
_DENSE: Final = 4
#: Length of the handle ``#17`` of an entity without a handle: a number sign and up to 11 digits.
_NUMBER: Final = 12


def handles_of(data: bytes, entity: I32, blocks: int, other_handles: I64) -> TextSlices | None:
    """Return the handles of all entities of a file, in upper case.

    An entity without a handle gets ``#`` and its number in model space or in its block.  None is
    returned if a handle is invalid or occurs twice.

    Parameters
    ----------
    data
        Content of the file.
    entity
        The array ``Scan.entity``.
    blocks
        Number of block definitions in the file.
    other_handles
        Values of the handles of objects that are not entities; an entity must not have one of them.
    """
    start, size, block = entity[:, f.HANDLE], entity[:, f.HANDLE_SIZE], entity[:, f.BLOCK]
    text = np.empty(int(size.sum()) + _NUMBER * int((size == 0).sum()), np.uint8)
    end = np.empty(len(entity), np.int64)
    number = np.zeros(len(entity), np.int64)
    count = np.zeros(blocks + 1, np.int64)
    if not _spell(np.frombuffer(data, np.uint8), start, size, block, count, text, end, number):
        return None
    number = np.concatenate([number[number > 0], other_handles])
    if _has_duplicate(number):
        return None
    return TextSlices(text[: end[-1] if len(end) else 0].tobytes(), end)


def _has_duplicate(number: I64) -> bool:
    """Return whether any number in the array ``number`` occurs more than once.

    All numbers must be positive.
    """
    if number.max(initial=0) <= _DENSE * len(number):
        return bool(np.bincount(number).max(initial=0) > 1)
    number = np.sort(number)
    return bool((number[1:] == number[:-1]).any())


def paths_of(handles: TextSlices, placed: list[str], own: I64, insert: I64) -> TextSlices:
    """Return the handles of all m rows of the import report.

    The handle of an entity in a block is preceded by the handle of its INSERT and a slash.

    Parameters
    ----------
    handles
        Handles of the e entities of the file.
    placed
        Complete handles of the rows whose entities were expanded by ``BlockExpansion``.
    own : (m,)
        Index i of the handle of each row.  If i < e, the handle is element i of ``handles``; if
        i ≥ e, it is ``placed[i - e]``.
    insert : (m,)
        Index into ``handles`` of the INSERT that places the entity of each row; -1 for entities of
        model space and for rows with a handle in ``placed``.
    """
    last = np.array([len(word.encode()) for word in placed], np.int64)
    text = np.frombuffer(handles.text + "".join(placed).encode(), np.uint8)
    end = np.concatenate([handles.end, np.cumsum(last) + len(handles.text)])
    out_end = np.empty(len(own), np.int64)
    out_text = np.empty(_measure(end, own, insert, out_end), np.uint8)
    _join(text, end, own, insert, out_text)
    return TextSlices(out_text.tobytes(), out_end)


@inline_kernel
def value_at(data: U8_1, low: int, high: int) -> Any:
    """Return the value of the hexadecimal handle ``data[low:high]``, 0 if it is not valid."""
    if high - low > _DIGITS:
        return 0
    value = 0
    for position in range(low, high):
        sign = data[position] | 32
        if 48 <= data[position] <= 57:
            value = value * 16 + int(sign) - 48
        elif 97 <= sign <= 102:
            value = value * 16 + int(sign) - 87
        else:
            return 0
    return value


@inline_kernel
def take_handle(data: U8_1, low: int, high: int, other_handles: OutI64_1, state: OutI64_1) -> int:
    """Append the value of the handle ``data[low:high]`` to ``other_handles``.

    The handle belongs to an object that is not an entity.  Returns ``ON`` if the scan continues,
    ``REFUSED`` if the handle is invalid or ``other_handles`` is full.
    """
    value, row = value_at(data, low, high), state[s.OTHERS]
    if value == 0 or row == state[s.MOST_OTHERS]:
        return s.REFUSED
    other_handles[row] = value
    state[s.OTHERS] = row + 1
    return s.ON


@kernel(allocates=False)
def _spell(
    data: U8_1,
    start: I32_1,
    size: I32_1,
    block: I32_1,
    count: OutI64_1,
    text: OutU8_1,
    end: OutI64_1,
    number: OutI64_1,
) -> bool:
    """Write the handles of all e entities as text and as numbers; return whether all are valid.

    ``start``, ``size`` (e,): position and length of the handle of each entity in ``data``.
    ``block`` (e,): row of the block that contains each entity, -1 for an entity of model space.
    ``count``: array of zeros that receives the number of entities of each block; the last element
    is for model space.
    ``text``: array that receives the text of all handles.
    ``end`` (e,): array that receives the end of each handle in ``text``.
    ``number`` (e,): array that receives the value of each handle, 0 for an entity without a handle.
    """
    written = 0
    for row in range(len(start)):
        count[block[row]] += 1
        value = value_at(data, start[row], start[row] + size[row])
        if size[row] > 0 and value == 0:
            return False
        for position in range(start[row], start[row] + size[row]):
            text[written] = data[position] - 32 if data[position] >= 97 else data[position]
            written += 1
        if size[row] == 0:
            text[written] = 35
            digits, rest = 1, count[block[row]]
            while rest >= 10:
                digits, rest = digits + 1, rest // 10
            rest = count[block[row]]
            for position in range(digits, 0, -1):
                text[written + position] = 48 + rest % 10
                rest //= 10
            written += digits + 1
        end[row] = written
        number[row] = value
    return True


@kernel(allocates=False)
def _measure(end: I64_1, own: I64_1, insert: I64_1, out_end: OutI64_1) -> int:
    """Compute the ends of the handles of m report rows in the text in which they are joined.

    Writes the ends, positions in bytes, into ``out_end``, (m,).  Returns the length of the text in
    bytes.

    ``end``: end of the handle of each entity in the text of all entity handles (bytes).
    ``own`` (m,): index into ``end`` of the handle of the entity in each row.
    ``insert`` (m,): index into ``end`` of the handle of the INSERT that precedes the handle of the
    entity, separated by a slash; -1 if no INSERT precedes it.
    """
    total = 0
    for row in range(len(own)):
        if insert[row] >= 0:
            total += end[insert[row]] - (end[insert[row] - 1] if insert[row] > 0 else 0) + 1
        total += end[own[row]] - (end[own[row] - 1] if own[row] > 0 else 0)
        out_end[row] = total
    return total


@kernel(allocates=False)
def _join(text: U8_1, end: I64_1, own: I64_1, insert: I64_1, out_text: OutU8_1) -> None:
    written = 0
    for row in range(len(own)):
        outer = insert[row]
        if outer >= 0:
            for sign in range(end[outer - 1] if outer > 0 else 0, end[outer]):
                out_text[written] = text[sign]
                written += 1
            out_text[written] = 47
            written += 1
        for sign in range(end[own[row] - 1] if own[row] > 0 else 0, end[own[row]]):
            out_text[written] = text[sign]
            written += 1
