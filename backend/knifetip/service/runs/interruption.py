"""Position in the program at which an interrupted job stopped, and the message about it.

The position is the last line that the gateway reported.  If the gateway could not follow the
machine to its stop, the machine may have executed more lines.
"""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.contract.job import Confirmation, State
from knifetip.messages import Message
from knifetip.service.database.tables import Job
from knifetip.service.runs.stop_place import most_lines


@dataclass(frozen=True, slots=True)
class Interruption:
    """Line and copy at which an interrupted job stopped, and the message about the interruption."""

    line: int  #: executed lines of the interrupted copy
    at_most: int  #: most lines of it that may have been executed; ``line`` if this is exact
    copies_done: int
    message: Message


def interruption(
    row: Job,
    cause: Message,
    line: int | None = None,
    copies_done: int | None = None,
    at_most: int | None = None,
) -> Interruption:
    """Return the line and the copy at which a job was interrupted, with a message for operators.

    Parameters
    ----------
    row
        The job, before or after the change of its state to ``interrupted``.
    cause
        Cause of the interruption: the cause that the gateway reported, or the expiry of its lease.
    line
        Number of executed lines of the current copy, as the gateway reported last; None for the
        number stored in the job.
    copies_done
        Number of completed copies, as the gateway reported last; None for the number stored in the
        job.
    at_most
        Most lines of the current copy that the machine may have executed; None if not known.
    """
    at = row.line if line is None else min(line, row.lines)
    done = row.copies_done if copies_done is None else min(copies_done, row.copies)
    fully_executed = 0 < row.lines == at
    if fully_executed and row.state in (State.HELD, State.INTERRUPTED) and 0 < done < row.copies:
        # Between two copies ``line`` is the last line of the completed copy.
        at, fully_executed = 0, False
        if at_most is None and _waits_for_sheet(row):
            at_most = 0
    elif fully_executed and done + 1 < row.copies:
        at, done, fully_executed = 0, done + 1, False
        at_most = 0 if at_most is not None else None
    most = most_lines(row, at, at_most)
    if at == most == 0 and 0 < done < row.copies:
        message = Message(
            "job.interrupted-between-copies", copy=done, copies=row.copies, cause=cause
        )
        return Interruption(at, most, done, message)
    copy = None
    if row.copies > 1:
        copy = Message("job.of-copy", copy=min(done + 1, row.copies), copies=row.copies)
    if most > at:
        message = Message(
            "job.interrupted-unobserved",
            line=at,
            lines=row.lines,
            most=_most_lines_message(most, row.lines),
            copy=copy,
            cause=cause,
        )
        return Interruption(at, most, done, message)
    if at == 0 < row.lines:
        message = Message("job.interrupted-in-first-line", lines=row.lines, copy=copy, cause=cause)
        return Interruption(at, most, done, message)
    message = Message(
        "job.interrupted-at-end" if fully_executed else "job.interrupted",
        line=at,
        lines=row.lines,
        copy=copy,
        cause=cause,
    )
    return Interruption(at, most, done, message)


def _waits_for_sheet(row: Job) -> bool:
    """Return whether a job waits between two copies, and nobody has let the next one begin."""
    return row.requested_action != "resume" and row.confirmation == Confirmation.SHEET


def _most_lines_message(most: int, lines: int) -> Message:
    """Return a message about the last line that a machine may have executed."""
    if most >= lines:
        return Message("job.may-have-ended")
    return Message("job.may-have-gone-on", line=most)
