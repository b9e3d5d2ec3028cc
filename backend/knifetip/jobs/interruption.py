"""Where an interrupted job stopped, and what the operator can do about it.

    interruption(row, "A belt tore.", line=34) -> line, copies done, reason, hint

The line is the last one that the gateway reported; the machine may have executed more.
"""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.jobs.job import State
from knifetip.jobs.tables import Job

_AGAIN = (
    "Look at the table. Queue the job again to cut a new sheet from the first line, mark it "
    "finished if the sheet is complete, or scrap it."
)
_LAST_LINE = (
    "Look at the table. Mark the job finished if the sheet is complete, otherwise scrap it."
)
_REST = (
    "Look at the table. Queue the job again for the remaining copies, mark it finished, or scrap "
    "it."
)


@dataclass(frozen=True, slots=True)
class Interruption:
    """Line, copies, reason and hint of an interrupted job."""

    line: int  #: executed lines of the interrupted copy
    copies_done: int
    reason: str
    hint: str


def interruption(
    row: Job, why: str, line: int | None = None, copies_done: int | None = None
) -> Interruption:
    """Return where a job stopped.

    Parameters
    ----------
    row
        The job before the interruption, or already interrupted.
    why
        Reason from the gateway or from the lease sweep.
    line, copies_done
        Last values reported by the gateway; by default those of the job.
    """
    at = row.line if line is None else min(line, row.lines)
    done = row.copies_done if copies_done is None else min(copies_done, row.copies)
    whole = 0 < row.lines == at
    if whole and row.state in (State.HELD, State.INTERRUPTED) and 0 < done < row.copies:
        # Between two copies ``line`` is the last line of the completed copy.
        at, whole = 0, False
    elif whole and done + 1 < row.copies:
        at, done, whole = 0, done + 1, False
    if at == 0 and 0 < done < row.copies:
        place = f"after copy {done} of {row.copies}, before a line of the next"
        hint = _REST
    else:
        copy = f" of copy {min(done + 1, row.copies)} of {row.copies}" if row.copies > 1 else ""
        place = f"at line {at} of {row.lines}{copy}"
        hint = _LAST_LINE if whole else _AGAIN
    return Interruption(at, done, f"Interrupted {place}. {why}".strip(), hint)
