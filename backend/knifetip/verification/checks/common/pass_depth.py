"""Compare the passes of a cut: report stretches of tip paths that are too deep for one pass, and
find stretches that only shallow passes follow.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.context import DEPTH_TOLERANCE, CheckContext
from knifetip.verification.columns import F64, I32, Bool
from knifetip.verification.curves.curve import azimuth_at
from knifetip.verification.curves.intervals import uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import angle_between
from knifetip.verification.findings import MAX_FINDINGS


class Passes(NamedTuple):
    """n tip paths of one tool in the order of the program."""

    curve: F64  #: (n, 6) lines and arcs as rows of six numbers, see ``curves.curve``
    deep: F64  #: (n,) mm, depth of the tip below the top of the board
    line: I32  #: (n,) 1-based line of the program


def report_deep_passes(
    context: CheckContext,
    tool: str,
    passes: Passes,
    step: float,
    slack: float,
    *,
    one_way: bool = False,
) -> None:
    """Add a finding for each stretch of a tip path that is too deep for one pass.

    Such a stretch is more than a step deeper than all earlier passes.

    Parameters
    ----------
    context
        Inputs and results of the verification; the findings are added to it.
    tool
        Name of the tool or of its operation, for the findings.
    passes
        The tip paths of the tool.
    step : mm
        Greatest permitted depth of one pass; 0 permits any depth.
    slack : mm
        A stretch that is not longer gives no finding.
    one_way
        True if only earlier passes in the same direction count.
    """
    if step <= 0.0:
        return
    rows, spans = _too_deep_spans(passes, step, context.tolerance, one_way=one_way)
    size = np.diff(spans)[:, 0]
    for k in np.flatnonzero(size > slack)[:MAX_FINDINGS]:
        deep = float(passes.deep[rows[k]])
        message = Message("verify.pass-too-deep", tool=tool, depth=deep, length=size[k], step=step)
        context.findings.add("depth", message, deep - step, line=int(passes.line[rows[k]]))


def _too_deep_spans(passes: Passes, step: float, near: float, *, one_way: bool) -> tuple[I32, F64]:
    """Return the stretches of tip paths that are more than a step deeper than all earlier passes.

    Returns the index of the tip path of each of k stretches, (k,), and the start and end of the
    stretch along that path, (k, 2) mm.

    ``step`` mm: greatest permitted depth of one pass.
    ``near`` mm: greatest distance at which an earlier tip path is a pass of the same cut.
    ``one_way``: only earlier passes in the same direction count.
    """
    curve, deep = passes.curve, passes.deep
    late = np.flatnonzero(deep > step + DEPTH_TOLERANCE)
    if len(late) == 0:
        return np.zeros(0, np.int32), np.zeros((0, 2))
    overlaps = find_overlaps(curve[late], curve, np.zeros(len(curve)), curve[:, 5], near)
    ready = overlaps.edge < late[overlaps.curve]
    ready &= deep[overlaps.edge] >= deep[late[overlaps.curve]] - step - DEPTH_TOLERANCE
    if one_way:
        own = azimuth_at(curve[late[overlaps.curve]], overlaps.along.mean(axis=1))
        ready &= (
            angle_between(own, azimuth_at(curve[overlaps.edge], overlaps.place.mean(axis=1))) < 90.0
        )
    earlier = replace(overlaps, curve=overlaps.curve[ready], along=overlaps.along[ready])
    path_rows, spans = uncovered_curves(earlier, curve[late])
    return late[path_rows].astype(np.int32), spans


def unfinished_spans(curve: F64, is_final: Bool, near: float) -> tuple[I32, F64]:
    """Return the stretches of tip paths that no pass at the final depth repeats.

    Parameters
    ----------
    curve : (n, 6)
        Tip paths: lines and arcs as rows of six numbers (see ``curves.curve``).
    is_final : (n,)
        Mask of the tip paths at the final depth.
    near : mm
        Greatest distance between two passes of the same cut.

    Returns
    -------
    Index of the tip path of each of k stretches (k,), and the start and end of the stretch along
    that path (k, 2) mm.
    """
    shallow = np.flatnonzero(~is_final)
    final = curve[is_final]
    overlaps = find_overlaps(curve[shallow], final, np.zeros(len(final)), final[:, 5], near)
    path_rows, spans = uncovered_curves(overlaps, curve[shallow])
    return shallow[path_rows].astype(np.int32), spans
