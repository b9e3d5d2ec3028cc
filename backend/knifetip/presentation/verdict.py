"""A verdict as JSON data and as packed arrays, for REST, the command line and the store.

All measures are finite, because JSON cannot represent infinity and NaN, see ``messages.finite``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from knifetip.errors import MOST_EDGES
from knifetip.geometry.columns import F64
from knifetip.messages import Message, finite, from_json, with_text
from knifetip.model.edge_figures import EDGE_FIGURES
from knifetip.model.verdict import Acceptance, Finding, Severity, UnreachedAreas, Verdict
from knifetip.model.verdict_summary import SUMMARY
from knifetip.presentation.columns import pack_columns

#: Greatest number of findings in the message about a refused program.
_MAX_FINDINGS: Final = 3


def finite_column(measures: F64) -> F64:
    """Return the array with ±1e9 in place of ±infinity and 1e9 in place of NaN, shape (n,)."""
    column: F64 = np.nan_to_num(
        measures, nan=finite(np.nan), posinf=finite(np.inf), neginf=finite(-np.inf)
    )
    return column


def verdict_summary(verdict: Verdict) -> dict[str, Any]:
    """Return the maxima and totals of the measurements in a verdict as JSON data.

    They are those of ``SUMMARY``.  ``faults`` and ``shortfalls`` count the findings that refuse the
    program, ``exceptions`` the accepted shortfalls.  ``accepted``, ``tolerance`` (mm) and
    ``seconds`` are copied from the verdict.
    """
    return {
        "accepted": bool(verdict.accepted),
        "tolerance": verdict.tolerance,
        **{
            name: one.value(verdict) if one.is_count else finite(one.value(verdict))
            for name, one in SUMMARY.items()
        },
        "seconds": finite(verdict.seconds),
        **count_findings(verdict.findings),
    }


def count_findings(findings: Sequence[Finding]) -> dict[str, int]:
    """Return the numbers of faults, open shortfalls and exceptions (accepted shortfalls)."""
    shortfalls = [found for found in findings if found.severity is Severity.SHORTFALL]
    opened = sum(found.refuses for found in shortfalls)
    return {
        "faults": sum(found.severity is Severity.FAULT for found in findings),
        "shortfalls": opened,
        "exceptions": len(shortfalls) - opened,
    }


def findings_json(verdict: Verdict, handles: Sequence[str]) -> list[dict[str, Any]]:
    """Return the findings of a verdict as JSON data.

    Each finding is a message with its kind, severity, measure, edge, all edges that the tool makes
    as one with it, handle of the edge and program line, whether it refuses the program, and who
    accepted it, if anyone.

    Parameters
    ----------
    handles : (n,)
        Handles of the edges of the drawing.
    """
    return [
        {
            "kind": finding.kind,
            "severity": finding.severity.value,
            "refuses": finding.refuses,
            "acceptance": acceptance_json(finding),
            **finding.message.as_json(),
            "measure": finite(finding.measure),
            "edge": finding.edge,
            "edges": list(finding.all_edges),
            "handle": handles[finding.edge] if 0 <= finding.edge < len(handles) else "",
            "line": finding.line,
        }
        for finding in verdict.findings
    ]


def finding_from_json(plain: Mapping[str, Any]) -> Finding:
    """Return the finding from one item of the JSON data that ``findings_json`` returned.

    A finding that an older version stored has no severity and is a fault.
    """
    acceptance = plain.get("acceptance")
    return Finding(
        plain["kind"],
        from_json(plain),
        plain["measure"],
        plain["edge"],
        plain["line"],
        Severity(plain.get("severity", Severity.FAULT)),
        None if acceptance is None else Acceptance(**acceptance),
        tuple(plain.get("edges", ())),
    )


def verdict_json(verdict: Verdict, handles: Sequence[str]) -> dict[str, Any]:
    """Return a verdict as JSON data: summary, findings with text, unreached areas, and edges.

    The data contain one item for each edge, with its handle and its measurements.

    Parameters
    ----------
    handles : (n,)
        Handles of the edges of the drawing.
    """
    columns = {name: finite_column(getattr(verdict, name)) for name in EDGE_FIGURES}
    return {
        **verdict_summary(verdict),
        "areas": areas_json(verdict.areas),
        "findings": [with_text(finding) for finding in findings_json(verdict, handles)],
        "edges": [
            {"handle": handle, **{name: float(column[row]) for name, column in columns.items()}}
            for row, handle in enumerate(handles)
        ],
    }


def areas_json(areas: UnreachedAreas) -> list[dict[str, Any]]:
    """Return the areas that no cutter reaches as JSON data, largest first.

    Each area has its ``area`` (mm²), its centre ``x``, ``y`` (mean of the vertices, mm) and its
    ``outline``: a list of [start, end, bulge], one for each line or arc; start and end are [x, y]
    (mm).
    """
    ends, bulge = areas.ends.tolist(), areas.bulge.tolist()
    rows = []
    for row in np.argsort(-areas.area, kind="stable").tolist():
        first, last = areas.first[row : row + 2].tolist()
        x, y = areas.ends[first:last, 0].mean(axis=0).tolist()
        outline = [[*ends[at], bulge[at]] for at in range(first, last)]
        rows.append({"area": float(areas.area[row]), "x": x, "y": y, "outline": outline})
    return rows


def unpack_areas(columns: Mapping[str, NDArray[Any]]) -> UnreachedAreas:
    """Return the areas that no cutter reaches from the arrays of a packed verdict.

    If an older version stored the verdict without these areas, the result is empty.
    """
    if "area_size" not in columns:
        return UnreachedAreas()
    return UnreachedAreas(*(columns[f"area_{name}"] for name in ("ends", "bulge", "first", "size")))


def pack_verdict(
    verdict: Verdict, findings: Sequence[Mapping[str, Any]], summary: Mapping[str, Any]
) -> bytes:
    """Return a verdict as a block of bytes, with findings and summary as metadata.

    Parameters
    ----------
    verdict
        The verifier's measurements per edge, which become arrays.
    findings
        The faults in the program as JSON data, from ``findings_json``.
    summary
        Maxima and totals as JSON data, from ``verdict_summary``; the caller may have added values.
    """
    return pack_columns(
        {
            **{name: finite_column(getattr(verdict, name)) for name in EDGE_FIGURES},
            "sample_edge": verdict.samples.edge,
            "sample_place": verdict.samples.place,
            "sample_deviation": finite_column(verdict.samples.deviation),
            "area_ends": verdict.areas.ends,
            "area_bulge": verdict.areas.bulge,
            "area_first": verdict.areas.first,
            "area_size": verdict.areas.area,
        },
        {"findings": findings, **summary},
    )


def refusal(findings: Sequence[Finding]) -> Message | None:
    """Return the message about a refused program; None if no finding refuses the program.

    The message contains the first findings that refuse the program, and the number of the others.
    If none of them is a fault, its hint names the acceptance of shortfalls.
    """
    reasons = [finding for finding in findings if finding.refuses]
    if not reasons:
        return None
    shown, more = reasons[:_MAX_FINDINGS], len(reasons) - _MAX_FINDINGS
    is_faulty = any(finding.severity is Severity.FAULT for finding in reasons)
    return Message(
        "job.program-refused" if is_faulty else "job.program-has-shortfalls",
        findings=[finding.located_message for finding in shown],
        more=Message("finding.more", count=more) if more > 0 else None,
    )


def refused_handles(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the first 200 handles of the edges because of which a program is refused, sorted.

    ``rows`` are the findings as JSON data, from ``findings_json``.
    """
    return sorted({str(row["handle"]) for row in rows if row["handle"] and row["refuses"]})[:200]


def refused_edges(rows: Sequence[Mapping[str, Any]]) -> list[int]:
    """Return the first 1000 edges because of which a program is refused, ascending.

    ``rows`` are the findings as JSON data, from ``findings_json``.
    """
    refused = (row.get("edges", [row["edge"]]) for row in rows if row["refuses"])
    return sorted({edge for edges in refused for edge in edges if edge >= 0})[:MOST_EDGES]


def acceptance_json(finding: Finding) -> dict[str, Any] | None:
    """Return the acceptance of a shortfall as JSON data; None if it is not accepted."""
    return None if finding.acceptance is None else asdict(finding.acceptance)
