"""Record of work that an earlier program has done on the sheet that a program continues."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class EarlierWork:
    """An earlier program for the same sheet, and those of its lines that were executed."""

    text: bytes  #: the whole program
    lines: tuple[tuple[int, int], ...]  #: ranges of completed lines: first and last, from 1
    #: ranges of executed lines whose work is made again, although they may have released board
    repeated: tuple[tuple[int, int], ...] = ()
