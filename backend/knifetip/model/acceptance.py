"""Accepted exceptions: a user accepts shortfalls of a program, each by its edge and its code."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from knifetip.errors import RequestError
from knifetip.model.verdict import Acceptance, Finding, Severity, Verdict

#: Row of an edge in the dieline, and code of the shortfall's message.
Shortfall = tuple[int, str]


@dataclass(frozen=True, slots=True)
class Exceptions:
    """Shortfalls that a user accepts before the program is made, as when an order is repeated."""

    shortfalls: tuple[Shortfall, ...]
    acceptance: Acceptance

    def as_json(self) -> dict[str, Any]:
        """Return the exceptions as JSON data."""
        return {"shortfalls": [list(one) for one in self.shortfalls], **asdict(self.acceptance)}

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> Exceptions:
        """Return the exceptions from the JSON data that ``as_json`` returned."""
        fields = dict(plain)
        shortfalls = tuple((int(edge), str(code)) for edge, code in fields.pop("shortfalls"))
        return cls(shortfalls, Acceptance(**fields))


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
    severities = _severities(findings)
    for edge, code in chosen:
        found = severities.get((edge, code))
        if found is None:
            raise RequestError("verify.no-such-shortfall", edge=edge, code=code)
        if Severity.SHORTFALL not in found or Severity.FAULT in found:
            raise RequestError("verify.not-acceptable", edge=edge, code=code)
    return tuple(
        replace(finding, acceptance=acceptance)
        if finding.severity is Severity.SHORTFALL
        and finding.acceptance is None
        and (finding.edge, finding.message.code) in chosen
        else finding
        for finding in findings
    )


def with_exceptions(
    verdict: Verdict, chosen: Collection[Shortfall], acceptance: Acceptance
) -> Verdict:
    """Return a verdict in which the chosen shortfalls are accepted.

    The verdict is accepted if no other finding refuses the program.  For the parameters and errors
    see ``accept_shortfalls``.
    """
    findings = accept_shortfalls(verdict.findings, chosen, acceptance)
    accepted = not any(finding.refuses for finding in findings)
    return replace(verdict, findings=findings, accepted=accepted)


def with_ordered_exceptions(verdict: Verdict, exceptions: Exceptions) -> Verdict:
    """Return a verdict in which the shortfalls that an order accepts are accepted.

    The program may have other shortfalls than the order expects: those that it does not have are
    disregarded, and all others still refuse it, as do faults.
    """
    severities = _severities(verdict.findings)
    chosen = [one for one in exceptions.shortfalls if severities.get(one) == {Severity.SHORTFALL}]
    return with_exceptions(verdict, chosen, exceptions.acceptance)


def _severities(findings: tuple[Finding, ...]) -> dict[Shortfall, set[Severity]]:
    """Return the severities of the findings with the same edge and code."""
    result: dict[Shortfall, set[Severity]] = {}
    for finding in findings:
        key = (finding.edge, finding.message.code)
        result.setdefault(key, set()).add(finding.severity)
    return result
