"""Place at which a machine stopped a job: executed lines, position and station.

A gateway that follows a run to its end knows the executed lines.  After a lost connection, or if
the gateway itself was gone, only a lower bound is known: the machine may have executed more lines,
up to ``at_most``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from knifetip.service.database.tables import Job


@dataclass(frozen=True, slots=True)
class StopPlace:
    """Place at which a machine stopped a job, as its gateway reports it."""

    position: Sequence[float] | None = None  #: on the sheet: x, y, z (mm) and c (degrees)
    station: int | None = None  #: number of the station in use; None if none or unknown
    #: most lines of the present copy that the machine may have executed; None if not known
    at_most: int | None = None


def most_lines(row: Job, line: int, at_most: int | None) -> int:
    """Return the most program lines of the present copy that a machine may have executed.

    Parameters
    ----------
    row
        The job.
    line
        Number of lines that were executed for certain.
    at_most
        Greatest number that its gateway reported; None if it is not known.
    """
    return row.lines if at_most is None else max(line, min(at_most, row.lines))


def executed_at_most(row: Job) -> int:
    """Return the most lines of the last copy that the machine of a stored job may have executed.

    It is greater than ``row.line`` if the place where the machine stopped is not known exactly.
    """
    if row.stopped_at is None:
        return row.line
    # Stops that an older version stored are lower bounds.
    return max(row.line, int(row.stopped_at.get("at_most", row.lines)))


def stopped(line: int, at_most: int, place: StopPlace) -> dict[str, Any]:
    """Return the columns of a job that record where the machine stopped it.

    Parameters
    ----------
    line
        Number of executed lines of the present copy.
    at_most
        Most lines of this copy that may have been executed.
    place
        Position and station.
    """
    position = None if place.position is None else list(place.position)
    where = {"line": line, "at_most": at_most, "position": position, "station": place.station}
    return {"stopped_at": where, "position": position}
