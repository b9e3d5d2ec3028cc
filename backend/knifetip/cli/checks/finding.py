"""Findings of the checks of an installation."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum


class Grade(IntEnum):
    """How serious a finding is; the value is the exit code of ``knifetip doctor``."""

    OK = 0
    WARNING = 1
    PROBLEM = 2


@dataclass(frozen=True, slots=True)
class Finding:
    """The result of a check, as a line of text, and what to do about it."""

    grade: Grade
    subject: str  #: what was checked, such as ``disk``
    text: str
    advice: str = ""  #: empty if there is nothing to do


def ok(subject: str, text: str) -> Finding:
    """Return the finding that a subject is as it should be."""
    return Finding(Grade.OK, subject, text)


def warning(subject: str, text: str, advice: str) -> Finding:
    """Return the finding that a subject works, but not as it should."""
    return Finding(Grade.WARNING, subject, text, advice)


def problem(subject: str, text: str, advice: str) -> Finding:
    """Return the finding that a subject does not work."""
    return Finding(Grade.PROBLEM, subject, text, advice)


def run(subject: str, check: Callable[[], Iterator[Finding]]) -> Iterator[Finding]:
    """Yield the findings of a check; an unexpected error of the check is a problem itself."""
    try:
        yield from check()
    except Exception as reason:
        text = f"the check failed: {type(reason).__name__}: {reason}"
        yield problem(subject, text, "Report this error, with the output of knifetip doctor.")
