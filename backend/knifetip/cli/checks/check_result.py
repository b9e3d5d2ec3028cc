"""Results of the checks of an installation."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum

from knifetip.messages import Message, hint, render


class Grade(IntEnum):
    """Severity of a result; the value is the exit code of ``knifetip doctor``."""

    OK = 0
    WARNING = 1
    PROBLEM = 2


@dataclass(frozen=True, slots=True)
class CheckResult:
    """The result of a check: its grade, and a message with a hint if there is something to do."""

    grade: Grade
    subject: str  #: what was checked, such as ``disk``
    message: Message

    @property
    def text(self) -> str:
        """English text of the message."""
        return render(self.message)

    @property
    def advice(self) -> str:
        """What to do, in English; empty if there is nothing to do."""
        return hint(self.message)


def ok(subject: str, message: Message) -> CheckResult:
    """Return the result of a check without a fault."""
    return CheckResult(Grade.OK, subject, message)


def warning(subject: str, message: Message) -> CheckResult:
    """Return the result of a check of a subject that works with a restriction."""
    return CheckResult(Grade.WARNING, subject, message)


def problem(subject: str, message: Message) -> CheckResult:
    """Return the result of a check of a subject that does not work."""
    return CheckResult(Grade.PROBLEM, subject, message)


def run(subject: str, check: Callable[[], Iterator[CheckResult]]) -> Iterator[CheckResult]:
    """Yield the results of a check; an unexpected error of the check becomes a problem."""
    try:
        yield from check()
    except Exception as reason:
        cause = f"{type(reason).__name__}: {reason}"
        yield problem(subject, Message("doctor.failed", reason=cause))
