"""Position in the program at which an interrupted job stopped, and the message about it.

The position is the last line that the gateway reported; the machine may have executed more lines.
"""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.jobs.job import State
from knifetip.jobs.tables import Job
from knifetip.messages import Message


@dataclass(frozen=True, slots=True)
class Interruption:
    """Line and copy at which an interrupted job stopped, and the message about the interruption."""

    line: int  #: executed lines of the interrupted copy
    copies_done: int
    message: Message


def interruption(
    row: Job, cause: Message, line: int | None = None, copies_done: int | None = None
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
    """
    at = row.line if line is None else min(line, row.lines)
    done = row.copies_done if copies_done is None else min(copies_done, row.copies)
    fully_executed = 0 < row.lines == at
    if fully_executed and row.state in (State.HELD, State.INTERRUPTED) and 0 < done < row.copies:
        # Between two copies ``line`` is the last line of the completed copy.
        at, fully_executed = 0, False
    elif fully_executed and done + 1 < row.copies:
        at, done, fully_executed = 0, done + 1, False
    if at == 0 and 0 < done < row.copies:
        message = Message(
            "job.interrupted-between-copies", copy=done, copies=row.copies, cause=cause
        )
        return Interruption(at, done, message)
    copy = None
    if row.copies > 1:
        copy = Message("job.of-copy", copy=min(done + 1, row.copies), copies=row.copies)
    message = Message(
        "job.interrupted-at-end" if fully_executed else "job.interrupted",
        line=at,
        lines=row.lines,
        copy=copy,
        cause=cause,
    )
    return Interruption(at, done, message)
