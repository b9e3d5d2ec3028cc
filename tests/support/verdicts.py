"""Ask a verdict whether the program itself is right, whatever the tool cannot make."""

from knifetip.model.verdict import Severity, Verdict


def has_faults(verdict: Verdict) -> bool:
    """Return whether a finding of the verdict is a fault, not a shortfall or a note."""
    return any(found.severity is Severity.FAULT for found in verdict.findings)
