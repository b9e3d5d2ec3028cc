"""words: columns of strings or messages without one Python object for each row.

distinct strings and their numbers, or one text and the ends of its parts -> Sequence[str]
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, TypeVar, overload

import numpy as np

from knifetip.geometry.columns import I32, I64

_T = TypeVar("_T")


class _Column(Sequence[_T]):
    """A sequence that compares equal to a tuple or list of the same items."""

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


class Repeated(_Column[_T]):
    """m strings or messages with few distinct values: each is an index into the distinct ones.

    Parameters
    ----------
    number : (m,)
        Indices into ``names``; -1 is the last.
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


def numbered(words: Sequence[str]) -> tuple[list[str], I32]:
    """Return the distinct strings, and the index of each string among them, (m,)."""
    number: dict[str, int] = {}
    if isinstance(words, Repeated):
        names = [number.setdefault(name, len(number)) for name in words.names]
        return list(number), np.array(names, np.int32)[words.number]
    each = [number.setdefault(word, len(number)) for word in words]
    return list(number), np.array(each, np.int32)


class Spelled(_Column[str]):
    """m mostly distinct strings, as slices of one text.

    Parameters
    ----------
    text
        UTF-8.
    end : (m,)
        End of each string, which is the start of the next.
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
