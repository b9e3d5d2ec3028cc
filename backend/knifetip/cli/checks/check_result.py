"""Results of the checks of an installation."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum


class Grade(IntEnum):
    """Severity of a result; the value is the exit code of ``knifetip doctor``."""

    OK = 0
    WARNING = 1
    PROBLEM = 2


@dataclass(frozen=True, slots=True)
class CheckResult:
    """The result of a check: its grade, a line of text, and what to do."""

    grade: Grade
    subject: str  #: what was checked, such as ``disk``
    text: str
    advice: str = ""  #: empty if there is nothing to do


def ok(subject: str, text: str) -> CheckResult:
    """Return the result of a check without a fault."""
    return CheckResult(Grade.OK, subject, text)


def warning(subject: str, text: str, advice: str) -> CheckResult:
    """Return the result of a check of a subject that works with a restriction."""
    return CheckResult(Grade.WARNING, subject, text, advice)


def problem(subject: str, text: str, advice: str) -> CheckResult:
    """Return the result of a check of a subject that does not work."""
    return CheckResult(Grade.PROBLEM, subject, text, advice)


def run(subject: str, check: Callable[[], Iterator[CheckResult]]) -> Iterator[CheckResult]:
    """Yield the results of a check; an unexpected error of the check becomes a problem."""
    try:
        yield from check()
    except Exception as reason:
        text = f"the check failed: {type(reason).__name__}: {reason}"
        yield problem(subject, text, "Report this error, with the output of knifetip doctor.")
