"""Record of the work that remains to be done on a sheet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from knifetip.geometry.columns import I64
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.toolpath import Toolpath


@dataclass(frozen=True, eq=False, slots=True)
class Rest:
    """Tracks of an earlier toolpath that remain to be made, and the work that is complete."""

    toolpath: Toolpath  #: toolpath of the program that the rest continues
    tracks: I64  #: (k,) numbers of its tracks that are to be made, ascending
    earlier: Sequence[EarlierWork]  #: the completed work, in the order of its execution
