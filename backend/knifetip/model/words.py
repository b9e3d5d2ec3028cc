"""Columns of strings or messages that need no separate Python object for each row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, TypeVar, overload

import numpy as np

from knifetip.geometry.columns import I32, I64

_T = TypeVar("_T")


class _Column(Sequence[_T]):
    """Base class of columns of values.

    A column is equal (==) to a tuple, list or column with the same items.
    """

    @overload
    def __getitem__(self, row: int) -> _T: ...
    @overload
    def __getitem__(self, row: slice) -> tuple[_T, ...]: ...
    def __getitem__(self, row: int | slice) -> _T | tuple[_T, ...]:
        if isinstance(row, slice):
            return tuple(self._word(one) for one in range(*row.indices(len(self))))
        if not -len(self) <= row < len(self):
            raise IndexError(row)
        return self._word(int(row) % len(self))

    def _word(self, row: int) -> _T:
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, tuple | list | _Column):
            return NotImplemented
        return len(self) == len(other) and all(
            mine == yours for mine, yours in zip(self, other, strict=True)
        )

    def __hash__(self) -> int:
        return hash(tuple(self))

    def __repr__(self) -> str:
        return repr(tuple(self))


class RepeatedValues(_Column[_T]):
    """A column of m strings or messages with few distinct values.

    Parameters
    ----------
    names
        The distinct values.
    number : (m,)
        Index into ``names`` for each row; -1 means the last element, as in Python.
    """

    def __init__(self, names: Sequence[_T], number: I32) -> None:
        self.names = tuple(names)
        self.number = number

    def __len__(self) -> int:
        return len(self.number)

    def _word(self, row: int) -> _T:
        return self.names[int(self.number[row])]

    def __iter__(self) -> Iterator[_T]:
        return map(self.names.__getitem__, self.number.tolist())

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        names = np.empty(len(self.names), object)
        names[:] = self.names
        return names[self.number].astype(dtype or object, copy=False)


def number_words(words: Sequence[str]) -> tuple[list[str], I32]:
    """Return the distinct strings in ``words``, in the order of first use, and indices into them.

    The indices have the shape (m,), one for each of the m strings in ``words``.
    """
    number: dict[str, int] = {}
    if isinstance(words, RepeatedValues):
        names = [number.setdefault(name, len(number)) for name in words.names]
        return list(number), np.array(names, np.int32)[words.number]
    indices = [number.setdefault(word, len(number)) for word in words]
    return list(number), np.array(indices, np.int32)


class TextSlices(_Column[str]):
    """A column of m mostly distinct strings, stored as slices of one text.

    Parameters
    ----------
    text
        All strings one after the other, in UTF-8.
    end : (m,)
        End of each string in ``text`` (bytes), which is the start of the next string.
    """

    def __init__(self, text: bytes, end: I64) -> None:
        self.text = text
        self.end = end

    def __len__(self) -> int:
        return len(self.end)

    def _word(self, row: int) -> str:
        first = self.end[row - 1] if row else 0
        return self.text[first : self.end[row]].decode()

    def __iter__(self) -> Iterator[str]:
        first = 0
        for end in self.end.tolist():
            yield self.text[first:end].decode()
            first = end
