"""Accepted exceptions: a user accepts shortfalls of a program, each by its edge and its code."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from knifetip.errors import RequestError
from knifetip.model.verdict import Acceptance, Finding, Severity, Verdict

#: Row of an edge in the dieline, and code of the shortfall's message.
Shortfall = tuple[int, str]


def accept_shortfalls(
    findings: tuple[Finding, ...], chosen: Collection[Shortfall], acceptance: Acceptance
) -> tuple[Finding, ...]:
    """Return findings in which the chosen shortfalls are accepted.

    A shortfall that is already accepted keeps its acceptance.

    Parameters
    ----------
    findings
        Findings of the verifier.
    chosen
        Edge and code of each shortfall to accept.
    acceptance
        Who accepts the shortfalls, when and why.

    Raises
    ------
    RequestError
        There is no such finding, or it is a fault or a note.
    """
    severities: dict[Shortfall, set[Severity]] = {}
    for finding in findings:
        key = (finding.edge, finding.message.code)
        severities.setdefault(key, set()).add(finding.severity)
    for edge, code in chosen:
        found = severities.get((edge, code))
        if found is None:
            raise RequestError("verify.no-such-shortfall", edge=edge, code=code)
        if found != {Severity.SHORTFALL}:
            raise RequestError("verify.not-acceptable", edge=edge, code=code)
    return tuple(
        replace(finding, acceptance=acceptance)
        if finding.acceptance is None and (finding.edge, finding.message.code) in chosen
        else finding
        for finding in findings
    )


def with_exceptions(
    verdict: Verdict, chosen: Collection[Shortfall], acceptance: Acceptance
) -> Verdict:
    """Return a verdict in which the chosen shortfalls are accepted.

    The verdict is accepted if no other finding refuses the program.

    Parameters
    ----------
    chosen
        Edge and code of each shortfall to accept.
    acceptance
        Who accepts the shortfalls, when and why.

    Raises
    ------
    RequestError
        There is no such finding, or it is a fault or a note.
    """
    findings = accept_shortfalls(verdict.findings, chosen, acceptance)
    accepted = not any(finding.refuses for finding in findings)
    return replace(verdict, findings=findings, accepted=accepted)
