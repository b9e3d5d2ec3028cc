"""The length that each station works in the board, as a function of the executed program line.

The table is made once, when a program is compiled.  When a run of the program ends, also in the
middle, the lengths of the executed lines are added to the use of the tools.

A stored table is a sequence of records in little-endian order, ordered by line: number of the
program line (int32), number of the station (uint8), ``LineType`` of the worked edge (uint8) and
length (float32, mm).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, TypeAlias

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import I32, U8
from knifetip.model.dieline import LineType
from knifetip.model.toolpath import Motion, Toolpath

#: Lengths (mm) by number of the station and name of the line type.
Lengths: TypeAlias = Mapping[tuple[int, str], float]

_RECORD: Final = np.dtype(
    [("line", "<i4"), ("station", "u1"), ("line_type", "u1"), ("length", "<f4")]
)
#: Moves along which the tool is in the board.
_WORKING: Final = (Motion.LEAD_IN, Motion.FEED, Motion.LEAD_OUT)


def pack_lengths(path: Toolpath, line: I32, line_type: U8) -> bytes:
    """Return the lengths that stations work along a tool path, as a table to be stored.

    Moves between edges count for the line type of the edge before them.

    Parameters
    ----------
    path
        The tool path with n moves.
    line : (n,)
        Number of the program line after which each move is complete; -1 for none.
    line_type : (m,)
        ``LineType`` of each of the m edges to which ``path.source`` refers.
    """
    rows = np.arange(len(path))
    edge = path.source[np.maximum.accumulate(np.where(path.source >= 0, rows, 0))]
    worked = np.isin(path.motion, _WORKING) & (edge >= 0)
    length = arc.length(path.pose[:-1, :2], path.pose[1:, :2], path.bulge)
    worked &= length > 0.0
    # A move without a line of its own is part of the next line.
    last = np.iinfo(np.int32).max
    following = np.minimum.accumulate(np.where(line >= 0, line, last)[::-1])[::-1]
    table = np.zeros(np.count_nonzero(worked), _RECORD)
    table["line"] = following[worked]
    table["station"] = path.tool[worked]
    table["line_type"] = line_type[edge[worked]]
    table["length"] = length[worked]
    return table[np.argsort(table["line"], kind="stable")].tobytes()


def lengths_until(table: bytes | None, line: int | None = None) -> Lengths:
    """Return the lengths that the stations have worked after a program line.

    Parameters
    ----------
    table
        Result of ``pack_lengths``; None for jobs that an older version compiled, which count 0.
    line
        Number of executed lines of the program; None for the whole program.
    """
    records = np.frombuffer(table or b"", _RECORD)
    if line is not None:
        records = records[: np.searchsorted(records["line"], line, side="right")]
    key = records["station"].astype(np.int64) * 256 + records["line_type"]
    sums = np.bincount(key, records["length"].astype(np.float64))
    return {
        (int(row) // 256, LineType(int(row) % 256).word): float(sums[row])
        for row in np.flatnonzero(sums)
    }


def lengths_of_copies(table: bytes | None, copies: int, line: int) -> Lengths:
    """Return the lengths that the stations work in whole copies and in one that is not complete.

    Parameters
    ----------
    table
        Result of ``pack_lengths``, or None.
    copies
        Number of complete copies.
    line
        Number of executed lines of the further copy; 0 for no further copy.
    """
    whole, begun = lengths_until(table), lengths_until(table, line)
    return {key: copies * length + begun.get(key, 0.0) for key, length in whole.items()}
