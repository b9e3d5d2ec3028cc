"""verdict: a verdict as plain data, the same in REST, in reports of the CLI and in the store.

    Verdict -> summary; findings with the handles of their edges; columns with one row per edge

All measures are finite, since JSON has no other numbers: 1e9 stands for an infinite one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.verdict import Verdict

#: Columns of a verdict with one row per edge.
EDGE_COLUMNS = (
    "deviation",
    "overcut",
    "uncut",
    "setback",
    "width",
    "web",
    "flank",
    "unreached",
    "bottom_uncut",
    "top_overcut",
    "tidied",
)
_FAR = 1e9


def finite(measure: float) -> float:
    """Return a measure that JSON can hold."""
    return float(np.nan_to_num(measure, nan=_FAR, posinf=_FAR, neginf=-_FAR))


def finite_column(measures: F64) -> F64:
    """Return measures that JSON can hold."""
    column: F64 = np.nan_to_num(measures, nan=_FAR, posinf=_FAR, neginf=-_FAR)
    return column


def verdict_summary(verdict: Verdict) -> dict[str, Any]:
    """Return the figures of a verdict.

    ``deviation``, ``overcut`` and ``uncut`` are the greatest of any edge (mm), ``uncut_total`` and
    ``setback_total`` the sums over all edges (mm), ``unreached`` is an area (mm²).
    """
    return {
        "accepted": bool(verdict.accepted),
        "tolerance": verdict.tolerance,
        "deviation": finite(verdict.deviation.max(initial=0.0)),
        "overcut": finite(verdict.overcut.max(initial=0.0)),
        "uncut": finite(verdict.uncut.max(initial=0.0)),
        "uncut_total": finite(verdict.uncut.sum()),
        "setback_total": finite(verdict.setback.sum()),
        "unreached": float(verdict.areas.area.sum()),
        "unreached_places": len(verdict.areas),
        "seconds": finite(verdict.seconds),
    }


def findings_of(verdict: Verdict, handles: Sequence[str]) -> list[dict[str, Any]]:
    """Return the findings of a verdict: each a message, with kind, measure and place.

    Parameters
    ----------
    handles : (n,)
        Of the drawing's edges.
    """
    return [
        {
            "kind": finding.kind,
            **finding.message.as_json(),
            "measure": finite(finding.measure),
            "edge": finding.edge,
            "handle": handles[finding.edge] if 0 <= finding.edge < len(handles) else "",
            "line": finding.line,
        }
        for finding in verdict.findings
    ]
