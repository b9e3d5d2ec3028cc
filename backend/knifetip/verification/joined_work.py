"""Join the tip paths of a program with those of earlier programs for the same sheet.

A rest program continues a sheet on which earlier programs have done a part of the work.  Its checks
of edges and of the working order use the paths of all these programs, as if they were one program:
an edge may be made by an earlier program, and an earlier cut may have released a piece of board.

Work that was done and is made again counts for the working order only: it may have released a piece
of board, but the rest must make its edges.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np

from knifetip.model.earlier_work import EarlierWork
from knifetip.model.verdict import Finding
from knifetip.verification.columns import Bool
from knifetip.verification.kinematics import TipPaths


@dataclass(frozen=True, eq=False, slots=True)
class JoinedWork:
    """The tip paths of earlier programs and of the verified program, in the order of the work.

    The program lines of all programs are numbered consecutively: line 1 of the verified program has
    the number ``lines_before`` + 1.
    """

    paths: TipPaths
    earlier_count: int  #: number of the paths of earlier programs, which come first
    lines_before: int  #: number of lines of the earlier programs

    def own_line(self, finding: Finding) -> Finding:
        """Return a finding whose line counts from the verified program; -1 if an earlier program
        made it.
        """
        if finding.line <= self.lines_before:
            return replace(finding, line=-1)
        return replace(finding, line=finding.line - self.lines_before)


def join_work(
    paths: TipPaths,
    earlier: Sequence[EarlierWork],
    earlier_paths: Sequence[TipPaths],
    *,
    with_repeated: bool = False,
) -> JoinedWork:
    """Return the tip paths of a program, with the completed ones of earlier programs before them.

    Parameters
    ----------
    paths
        All tip paths of the verified program.
    earlier, earlier_paths
        The earlier programs in the order of their execution, and all tip paths of each.
    with_repeated
        Whether earlier work that is made again is included.
    """
    if not earlier:
        return JoinedWork(paths, 0, 0)
    parts, lines_before, tracks = [], 0, 0
    for work, traced in zip(earlier, earlier_paths, strict=True):
        ranges = work.lines + work.repeated if with_repeated else work.lines
        kept = traced.select(_are_in_ranges(traced, ranges))
        parts.append(_renumber(kept, lines_before, tracks))
        lines_before += work.text.count(b"\n") + 1
        tracks += int(traced.track.max(initial=-1)) + 1
    earlier_count = sum(len(part.z) for part in parts)
    parts.append(_renumber(paths, lines_before, tracks))
    columns = {
        field.name: np.concatenate([getattr(part, field.name) for part in parts])
        for field in fields(TipPaths)
    }
    return JoinedWork(TipPaths(**columns), earlier_count, lines_before)


def _are_in_ranges(paths: TipPaths, ranges: Sequence[tuple[int, int]]) -> Bool:
    """Return the mask of the n tip paths whose program line is in one of the ranges, (n,).

    Each range is its first and its last line.
    """
    inside = np.zeros(len(paths.line), np.bool_)
    for first, last in ranges:
        inside |= (paths.line >= first) & (paths.line <= last)
    return inside


def _renumber(paths: TipPaths, lines: int, tracks: int) -> TipPaths:
    """Return tip paths whose program lines and tracks are numbered higher by ``lines`` and
    ``tracks``.
    """
    return replace(
        paths,
        line=(paths.line + lines).astype(np.int32),
        track=(paths.track + tracks).astype(np.int32),
    )
