"""Accept shortfalls in the stored verdict of a job, and find those of an earlier job."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, Final

from knifetip.model.acceptance import Shortfall, accept_shortfalls
from knifetip.model.verdict import Acceptance
from knifetip.presentation.columns import pack_columns, unpack_columns
from knifetip.presentation.verdict import (
    acceptance_json,
    count_findings,
    finding_from_json,
    refusal,
    refused_edges,
    refused_handles,
)
from knifetip.service.orders.order_models import ExceptionsIn
from knifetip.service.processes.compile_result import VerdictColumns

#: Greatest difference between the measures of two findings about the same shortfall.
_SAME_MEASURE: Final = 0.001


def chosen_shortfalls(exceptions: ExceptionsIn) -> set[Shortfall]:
    """Return the shortfalls that a request accepts: edge and code of each finding."""
    return {(one.edge, one.code) for one in exceptions.findings}


def accept_in_block(
    block: bytes,
    summary: Mapping[str, Any],
    chosen: Collection[Shortfall],
    acceptance: Acceptance,
) -> VerdictColumns:
    """Return a stored verdict in which the chosen shortfalls are accepted.

    For ``chosen``, ``acceptance`` and the errors see ``model.acceptance.accept_shortfalls``.

    Parameters
    ----------
    block
        The packed verdict, see ``presentation.verdict``.
    summary
        The summary of the verdict.
    """
    columns, meta = unpack_columns(block)
    rows = meta.pop("findings")
    findings = accept_shortfalls(tuple(finding_from_json(row) for row in rows), chosen, acceptance)
    for row, finding in zip(rows, findings, strict=True):
        row |= {"refuses": finding.refuses, "acceptance": acceptance_json(finding)}
    message = refusal(findings)
    changed = {"accepted": message is None, **count_findings(findings)}
    return VerdictColumns(
        pack_columns(columns, {"findings": rows, **meta, **changed}),
        {**summary, **changed},
        message,
        refused_handles(rows),
        refused_edges(rows),
    )


def find_same_exceptions(block: bytes, earlier: bytes) -> list[dict[str, Any]]:
    """Return the findings that refuse a program and are accepted in the verdict of an earlier job.

    Two findings are the same if their edge, their code and their measure agree.

    Parameters
    ----------
    block, earlier
        The packed verdicts of the present and of the earlier program.

    Returns
    -------
    The findings of the earlier verdict, as in ``presentation.verdict.findings_json``.
    """
    accepted = {
        (row["edge"], row["code"]): row
        for row in unpack_columns(earlier)[1]["findings"]
        if row.get("acceptance")
    }
    found = []
    for row in unpack_columns(block)[1]["findings"]:
        same = accepted.get((row["edge"], row["code"]))
        if (
            same is not None
            and row["refuses"]
            and row["handle"] == same["handle"]
            and abs(row["measure"] - same["measure"]) <= _SAME_MEASURE
        ):
            found.append(same)
    return found
