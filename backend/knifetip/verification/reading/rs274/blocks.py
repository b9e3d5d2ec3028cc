"""Sort the words of an RS274/NGC program into columns: one row for each program line with words."""

from __future__ import annotations

import math
from collections.abc import Callable
from enum import IntEnum
from typing import Any, Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.kernels import F64_1, I32_1, I64_1, I64_2, U8_1, Bool_1, kernel
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
    4: Group.SPINDLE,
    5: Group.SPINDLE,
    6: Group.CHANGE,
    64: Group.OUTPUT,
    65: Group.OUTPUT,
}

#: Modal group of the codes 0 … 999 of G words and of M words, -1 for none, (2, 1000).
_GROUP_OF: Final = np.array(
    [[known.get(code, -1) for code in range(1000)] for known in (_G, _M)], np.int64
)
#: Messages about the letter and the number of a word, in the order of the kinds of
#: ``_fill_columns``.
_WORD_FAULTS: Final[tuple[Callable[[str, float], Message], ...]] = (
    lambda letter, value: Message("rs274.unknown-word", word=f"{letter}{value:g}"),
    lambda letter, value: Message("rs274.unknown-word", word=f"{letter}{value:g}"),
    lambda letter, _: Message("rs274.unknown-letter", letter=letter),
    lambda _letter, _value: Message("rs274.bad-line-number"),
    lambda _letter, _value: Message("rs274.repeated-word"),
)
#: Greatest number of faults of each kind that are listed.
_MOST_FAULTS: Final = 1000
_GROUPS: Final = len(Group)
_G_LETTER: Final = ord("G")
_M_LETTER: Final = ord("M")
_N_LETTER: Final = ord("N")


class ProgramBlocks:
    """The words of a program in columns: one row for each block (program line with words).

    ``letters`` are the letters of the axes of the machine; X and Y are the first two.
    """

    def __init__(
        self, words: ProgramWords, letters: str, faults: list[tuple[int, Message]]
    ) -> None:
        self.faults = faults
        self._masks: dict[str | tuple[Group, int | None], Bool] = {}
        count, used = _count_blocks(words.line, words.letter)
        if count > MAX_BLOCKS:
            raise ProgramUnreadable("program.too-many-lines", lines=count, limit=MAX_BLOCKS)
        self.count: int = count
        present = [letter for letter in _LETTERS if used[ord(letter)]]
        axis, column = np.full(256, -1), np.full(256, -1)
        axis[[ord(letter) for letter in letters]] = np.arange(len(letters))
        column[[ord(letter) for letter in present]] = np.arange(len(present))
        self.line: I32
        self.group: I32  #: (groups, count) code of the word of each modal group, -1 for none
        self.position: F64  #: (count, axes) NaN if the block has no word of the axis
        self.moves_axis: Bool  #: (count,) the block has a word of an axis
        self.line, self.group, self.position, self.moves_axis, numbers, wrong = _fill_columns(
            words.line, words.letter, words.value, count, _GROUP_OF, axis, column
        )
        # The letters that the program does not use share one column.
        self.number: dict[str, F64] = dict.fromkeys(_LETTERS, np.full(count, np.nan))
        self.number.update(zip(present, numbers, strict=True))
        for kind, block, word in wrong[np.argsort(wrong[:, 0], kind="stable")].tolist():
            fault_of = _WORD_FAULTS[kind]
            self._fault(block, fault_of(chr(words.letter[word]), float(words.value[word])))
        self.axes: Bool = ~np.isnan(self.position)

    def _fault(self, block: int, message: Message) -> None:
        self.faults.append((int(self.line[block]), message))

    def fault(self, mask: Bool, message: Message) -> None:
        """Add a fault with the text ``message`` for each block in ``mask``.

        If there are more than a thousand such blocks, only the first thousand get a fault.
        """
        self.fault_at(np.flatnonzero(mask), message)

    def fault_at(self, rows: I64, message: Message) -> None:
        """Add a fault with the text ``message`` for each of the blocks ``rows``, (k,), or for the
        first thousand of them.
        """
        for block in rows[:1000]:
            self._fault(block, message)

    def has(self, letter: str) -> Bool:
        """Return the mask of the blocks with a word of this letter, one entry per block."""
        return self._mask(letter, lambda: ~np.isnan(self.number[letter]))

    def has_code(self, group: Group, code: int | None = None) -> Bool:
        """Return the mask of the blocks that have a G or M word of a modal group, one entry per
        block.

        If ``code`` is not None, only blocks whose word has this code are in the mask.  The code of
        a G word is ten times its number; the code of an M word is its number.
        """
        column = self.group[group]
        if code is None:
            return self._mask((group, None), lambda: column >= 0)
        return self._mask((group, code), lambda: column == code)

    def _mask(self, key: str | tuple[Group, int | None], compute: Callable[[], Bool]) -> Bool:
        """Return the mask of the blocks with some word, which is computed only once for each
        ``key``.

        Many rules ask for the same words.  The mask is read-only.
        """
        if key not in self._masks:
            self._masks[key] = compute()
            self._masks[key].flags.writeable = False
        return self._masks[key]


@kernel
def _count_blocks(line: I32_1, letter: U8_1) -> Any:
    """Return the number of blocks of n words, and the mask of the letters that occur, (256,)."""
    used = np.zeros(256, np.bool_)
    count = 0
    for word in range(len(line)):
        used[letter[word]] = True
        if word == 0 or line[word] != line[word - 1]:
            count += 1
    return count, used


@kernel
def _fill_columns(
    line: I32_1,
    letter: U8_1,
    value: F64_1,
    count: int,
    group_of: I64_2,
    axis: I64_1,
    column: I64_1,
) -> Any:
    """Sort n words into columns of ``count`` blocks.

    If a block has two words of a modal group or a letter, the first one counts.

    ``line``, ``letter``, ``value`` (n,): program line of each word, its letter as an ASCII code,
    and its number.
    ``group_of`` (2, 1000): modal group of the codes of G words, and of those of M words; -1 for
    none.
    ``axis``, ``column`` (256,): for each letter its column in ``position``, and its row in
    ``numbers``; -1 for none.
    Returns ``line_of`` (count,): program line of each block; ``groups`` (g, count): code of the
    word of each modal group, -1 for none; ``position, moves_axis`` (count, a) and (count,): numbers
    of the words of the axes, NaN for none, and the mask of the blocks with such a word; ``numbers``
    (c, count): numbers of the words of other letters, NaN for none; ``wrong`` (k, 3): kind of each
    fault (0 and 1 an unknown G or M word, 2 an unknown letter, 3 a line number that is not the
    first word, 4 a repeated word), its block and its word.
    """
    line_of = np.empty(count, np.int32)
    groups = np.full((_GROUPS, count), -1, np.int32)
    position = np.full((count, axis.max() + 1), np.nan)
    moves_axis = np.zeros(count, np.bool_)
    numbers = np.full((column.max() + 1, count), np.nan)
    wrong = np.empty((5 * _MOST_FAULTS, 3), np.int64)
    faults, many, repeated = 0, np.zeros(5, np.int64), -1
    block = -1
    for word in range(len(line)):
        first = word == 0 or line[word] != line[word - 1]
        if first:
            block += 1
            line_of[block] = line[word]
        name, kind, twice = letter[word], -1, False
        if name in (_G_LETTER, _M_LETTER):
            scaled = value[word] * 10.0 if name == _G_LETTER else value[word]
            nearest = np.rint(scaled)
            table = 0 if name == _G_LETTER else 1
            group = -1
            if 0.0 <= nearest <= 999.0 and abs(nearest - scaled) <= 1e-9:
                group = group_of[table, int(nearest)]
            if group < 0:
                kind = table
            elif groups[group, block] >= 0:
                twice = True
            else:
                groups[group, block] = int(nearest)
        elif axis[name] >= 0:
            twice = not math.isnan(position[block, axis[name]])
            if not twice:
                position[block, axis[name]] = value[word]
                moves_axis[block] = True
        elif column[name] >= 0:
            twice = not math.isnan(numbers[column[name], block])
            if not twice:
                numbers[column[name], block] = value[word]
            if name == _N_LETTER and not first:
                kind = 3
        else:
            kind = 2
        # A block is listed once, however many of its words are repeated.
        again = twice and block != repeated
        if again:
            repeated = block
        for each in (kind, 4 if again else -1):
            if each >= 0 and many[each] < _MOST_FAULTS:
                wrong[faults, 0], wrong[faults, 1], wrong[faults, 2] = each, block, word
                faults += 1
                many[each] += 1
    return line_of, groups, position, moves_axis, numbers, wrong[:faults].copy()


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
