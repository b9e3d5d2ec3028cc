"""Compare the jobs in a database with the records of the tables."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from knifetip.contract.job import State
from tests.failures.watched_table import Run

_COMMENT: Final = re.compile(rb"\([^)]*\)|^N\d+ *")


@dataclass(frozen=True)
class JobRecord:
    """A job, as the database stores it."""

    id: str
    state: str
    codes: Counter[str]  #: codes of its events
    program: bytes

    @property
    def decisions(self) -> int:
        """How often the operator decided to make it again, from its first line."""
        return self.codes["job.requeued"]

    @property
    def confirmations(self) -> int:
        """How often the operator confirmed the sheet on the table."""
        return self.codes["job.confirmed-table"]


@dataclass
class Violations:
    """Violations; each list has a line for each case."""

    lost: list[str] = field(default_factory=list)  #: accepted jobs that are not stored
    stuck: list[str] = field(default_factory=list)  #: jobs that are not done
    cut_twice: list[str] = field(default_factory=list)  #: begun again without a decision
    unconfirmed: list[str] = field(default_factory=list)  #: started without the operator
    not_executed: list[str] = field(default_factory=list)  #: done, but not made to the end
    heads_down: list[str] = field(default_factory=list)  #: tables that stayed unsafe

    @property
    def cases(self) -> dict[str, list[str]]:
        """The lists by name."""
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    def __bool__(self) -> bool:
        return any(self.cases.values())

    def __str__(self) -> str:
        return ", ".join(f"{name} {len(rows)}" for name, rows in self.cases.items())


def check_jobs(
    accepted: Mapping[str, str],
    stored: Mapping[str, JobRecord],
    runs: Sequence[Run],
    violations: Violations,
) -> None:
    """Add the violations by jobs.

    Parameters
    ----------
    accepted
        SHA-256 of the drawing of each accepted job by its id; each job has a drawing of its own.
    stored
        The jobs of the database by id.
    runs
        Programs that the tables executed.
    violations
        The cases are added to its lists.
    """
    cuts = [run for run in runs if run.has_cut]
    for id, sha256 in accepted.items():
        own = [run for run in cuts if run.is_of(sha256)]
        if id not in stored:
            violations.lost.append(id)
            continue
        job = stored[id]
        seen = f"{id} {job.state}: {[len(run.lines) for run in own]} lines; {dict(job.codes)}"
        if job.state != State.DONE:
            violations.stuck.append(seen)
        elif not any(_plain(run.lines) == _plain(job.program.splitlines()) for run in own):
            violations.not_executed.append(seen)
        if len(own) > 1 + job.decisions:
            violations.cut_twice.append(seen)
        if len(own) > job.confirmations:
            violations.unconfirmed.append(seen)
    for run in cuts:
        if not any(run.is_of(sha256) for sha256 in accepted.values()):
            violations.unconfirmed.append(f"a run without a job: {run.lines[:3]}")


def _plain(lines: Iterable[bytes]) -> list[bytes]:
    """Return program lines without comments, line numbers, spaces and empty lines."""
    plain = (_COMMENT.sub(b"", line).replace(b" ", b"").strip() for line in lines)
    return [line for line in plain if line]
