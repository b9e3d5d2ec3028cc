"""Sort the words of an RS274/NGC program into columns: one row for each program line with words."""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.kernels import F64_1, F64_2, Bool_1, kernel
from knifetip.messages import Message
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.reading.rs274.parse import ProgramWords

#: Greatest number of lines with words.
MAX_BLOCKS: Final = 2_000_000
#: Letters of the words with numbers, besides those of the axes.
_LETTERS: Final = "FIJNPQST"


class Group(IntEnum):
    """Modal group of a G or M word; a line may contain at most one word of each group."""

    MOTION = 0
    DWELL = 1
    PLANE = 2
    UNITS = 3
    DISTANCE = 4
    CENTRES = 5
    FEED = 6
    RADIUS = 7
    LENGTH = 8
    SYSTEM = 9
    PATH = 10
    END = 11
    SPINDLE = 12
    CHANGE = 13
    OUTPUT = 14
    SHIFT = 15


#: Number of a G word times ten -> modal group.
_G: Final = {
    0: Group.MOTION,
    10: Group.MOTION,
    20: Group.MOTION,
    30: Group.MOTION,
    40: Group.DWELL,
    170: Group.PLANE,
    210: Group.UNITS,
    900: Group.DISTANCE,
    911: Group.CENTRES,
    921: Group.SHIFT,
    930: Group.FEED,
    940: Group.FEED,
    400: Group.RADIUS,
    430: Group.LENGTH,
    490: Group.LENGTH,
    540: Group.SYSTEM,
    640: Group.PATH,
}
#: Number of an M word -> modal group.
_M: Final = {
    2: Group.END,
    30: Group.END,
    3: Group.SPINDLE,
    5: Group.SPINDLE,
    6: Group.CHANGE,
    64: Group.OUTPUT,
    65: Group.OUTPUT,
}


class ProgramBlocks:
    """The words of a program in columns: one row for each block (program line with words).

    ``letters`` are the letters of the axes of the machine; X and Y are the first two.
    """

    def __init__(
        self, words: ProgramWords, letters: str, faults: list[tuple[int, Message]]
    ) -> None:
        self.faults = faults
        new = np.ones(len(words.line), np.bool_)
        new[1:] = words.line[1:] != words.line[:-1]
        block = np.cumsum(new) - 1
        self.line: I32 = words.line[new]
        count = len(self.line)
        if count > MAX_BLOCKS:
            raise ProgramUnreadable("program.too-many-lines", lines=count, limit=MAX_BLOCKS)
        self.count = count
        groups = np.full((len(Group), count), -1, np.int32)
        numbers = {letter: np.full(count, np.nan) for letter in _LETTERS + letters}
        kind = np.zeros(len(words.line), np.int64)
        for letter, known in (("G", _G), ("M", _M)):
            rows = np.flatnonzero(words.letter == ord(letter))
            scaled = words.value[rows] * (10.0 if letter == "G" else 1.0)
            codes = np.rint(scaled).astype(np.int64)
            table = np.full(1000, -1, np.int64)
            table[list(known)] = list(known.values())
            group = table[np.clip(codes, 0, 999)]
            group[(codes < 0) | (codes > 999) | (np.abs(codes - scaled) > 1e-9)] = -1
            for row in rows[group < 0][:1000]:
                word = f"{letter}{words.value[row]:g}"
                self._fault(block[row], Message("rs274.unknown-word", word=word))
            known_rows = rows[group >= 0]
            # If a line has two words of a group, use the first; the second is a fault below.
            groups[group[group >= 0][::-1], block[known_rows][::-1]] = codes[group >= 0][::-1]
            kind[rows] = np.where(group >= 0, 100 + group, -1)
        for letter, column in numbers.items():
            rows = np.flatnonzero(words.letter == ord(letter))
            column[block[rows][::-1]] = words.value[rows][::-1]
            kind[rows] = 200 + ord(letter)
        for row in np.flatnonzero(kind == 0)[:1000]:
            letter = chr(words.letter[row])
            self._fault(block[row], Message("rs274.unknown-letter", letter=letter))
        for row in np.flatnonzero((words.letter == ord("N")) & ~new)[:1000]:
            self._fault(block[row], Message("rs274.bad-line-number"))
        words_used = np.flatnonzero(kind >= 100)
        key = np.sort(block[words_used] * 1000 + kind[words_used])
        for twice in np.unique(key[1:][key[1:] == key[:-1]] // 1000)[:1000]:
            self._fault(twice, Message("rs274.repeated-word"))
        self.group = groups
        self.number = numbers
        if len(words_used):
            self.position = np.stack([numbers[letter] for letter in letters], axis=1)
        else:
            self.position = np.full((count, len(letters)), np.nan)
        self.axes: Bool = ~np.isnan(self.position)

    def _fault(self, block: int, message: Message) -> None:
        self.faults.append((int(self.line[block]), message))

    def fault(self, mask: Bool, message: Message) -> None:
        """Add a fault with the text ``message`` for each block in ``mask``.

        If there are more than a thousand such blocks, only the first thousand get a fault.
        """
        for block in np.flatnonzero(mask)[:1000]:
            self._fault(block, message)

    def has(self, letter: str) -> Bool:
        """Return the mask of the blocks with a word of this letter, one entry per block."""
        result: Bool = ~np.isnan(self.number[letter])
        return result

    def has_code(self, group: Group, code: int | None = None) -> Bool:
        """Return the mask of the blocks that have a G or M word of a modal group, one entry per
        block.

        If ``code`` is not None, only blocks whose word has this code are in the mask.  The code of
        a G word is ten times its number; the code of an M word is its number.
        """
        column = self.group[group]
        result: Bool = column >= 0 if code is None else column == code
        return result


def latest_block(mask: Bool) -> I64:
    """For each of n blocks, return the index of the nearest block in ``mask`` at or before it,
    (n,).

    The index is -1 if there is none.  ``mask`` is a mask of the n blocks.
    """
    rows: I64 = _latest(np.ascontiguousarray(mask))
    return rows


@kernel
def _latest(mask: Bool_1) -> Any:
    """Return the index of the nearest marked entry at or before each entry, (n,); -1 for none."""
    rows = np.empty(len(mask), np.int64)
    latest = -1
    for row in range(len(mask)):
        if mask[row]:
            latest = row
        rows[row] = latest
    return rows


def value_in_force(values: F64, mask: Bool, initial: float = np.nan) -> F64:
    """Return the value in force at each of n blocks, (n,).

    The value is set by the block itself, or by the last earlier block that sets it.

    Parameters
    ----------
    values : (n,)
        Value of each block, if the block sets it.
    mask : (n,)
        Mask of the blocks that set the value.
    initial
        Value before the first block that sets it.
    """
    result: F64 = _in_force(
        np.ascontiguousarray(values), np.ascontiguousarray(mask), float(initial)
    )
    return result


@kernel
def _in_force(values: F64_1, mask: Bool_1, initial: float) -> Any:
    """Return the value in force at each of n blocks, (n,); see ``value_in_force``."""
    result = np.empty(len(values))
    value = initial
    for row in range(len(values)):
        if mask[row]:
            value = values[row]
        result[row] = value
    return result


@kernel
def last_known(values: F64_2) -> Any:
    """Return n rows of values, each NaN replaced by the last earlier value of its column.

    ``values`` is (n, k).  A NaN without an earlier value remains.
    """
    result = values.copy()
    for row in range(1, len(values)):
        for column in range(values.shape[1]):
            if math.isnan(result[row, column]):
                result[row, column] = result[row - 1, column]
    return result
