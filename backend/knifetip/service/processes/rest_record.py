"""The work that remains on the sheet of a job, as the job that makes this rest stores it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

#: Pairs of the first and the last number of a range.
Ranges = tuple[tuple[int, int], ...]


class ExecutedWork(NamedTuple):
    """The work of an earlier job on the same sheet."""

    job: str  #: id of the job
    lines: Ranges  #: ranges of its program lines whose work is complete
    repeated: Ranges = ()  #: ranges of its executed lines whose work is made again


@dataclass(frozen=True, slots=True)
class RestRecord:
    """Tracks that a job makes, and the work of earlier jobs on the same sheet."""

    tracks: Ranges  #: ranges of the tracks of the continued program, numbered from 0
    made: tuple[ExecutedWork, ...]  #: in the order of the work

    def as_json(self) -> dict[str, Any]:
        """Return the record as JSON data."""
        return {
            "tracks": [list(one) for one in self.tracks],
            "made": [
                {
                    "job": work.job,
                    "lines": [list(one) for one in work.lines],
                    "repeated": [list(one) for one in work.repeated],
                }
                for work in self.made
            ],
        }

    @classmethod
    def from_json(cls, plain: dict[str, Any]) -> RestRecord:
        """Return the record from the JSON data that ``as_json`` returned."""
        return cls(
            _ranges(plain["tracks"]),
            tuple(
                # Records of older versions have no repeated lines.
                ExecutedWork(one["job"], _ranges(one["lines"]), _ranges(one.get("repeated", ())))
                for one in plain["made"]
            ),
        )


@dataclass(frozen=True, slots=True)
class StoredRest:
    """The work that remains on a sheet, with the stored data of the jobs that began it."""

    toolpath: bytes  #: packed tool path of the continued program
    tracks: Ranges  #: ranges of its tracks that remain, numbered from 0
    #: program of each earlier job, and ranges of its completed and of its repeated lines
    made: tuple[tuple[bytes, Ranges, Ranges], ...]


def _ranges(plain: Sequence[Sequence[int]]) -> Ranges:
    return tuple((int(first), int(last)) for first, last in plain)
