"""Run a campaign: compile many jobs, count what becomes of them, and check some programs."""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from tests.cartons.job import Job, random_job
from tests.cartons.trial import Outcome, attempt_job

FATES = ("accepted", "excepted", "by hint", "left out", "stuck", "error", "wrongly accepted")


@dataclass
class Tally:
    """Counts of a campaign."""

    by_machine: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    by_style: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    refusals: Counter[str] = field(default_factory=Counter)  #: jobs by code
    shortfalls: Counter[str] = field(default_factory=Counter)  #: findings by code
    hints: Counter[str] = field(default_factory=Counter)  #: "code: what was done → fate"
    asked: int = 0
    mistyped: int = 0
    checked: int = 0
    seconds: float = 0.0

    @property
    def jobs(self) -> int:
        """Number of jobs."""
        return sum(sum(fates.values()) for fates in self.by_machine.values())

    @property
    def failures(self) -> int:
        """Number of jobs that ended without an accepted, correct program."""
        return sum(
            fates[fate]
            for fates in self.by_machine.values()
            for fate in ("left out", "stuck", "error", "wrongly accepted")
        )

    def add(self, job: Job, outcome: Outcome) -> None:
        """Count a job."""
        self.by_machine[job.machine.name][outcome.fate] += 1
        self.by_style[job.style][outcome.fate] += 1
        self.refusals.update(list(outcome.refusals))
        self.shortfalls.update(outcome.shortfalls)
        end = "accepted" if outcome.fate == "by hint" else outcome.fate
        self.hints.update(f"{step} → {end}" for step in outcome.followed)
        self.asked += outcome.asked > 0
        self.mistyped += outcome.mistyped > 0

    def table(self) -> str:
        """Return all counts as text."""
        lines = []
        for counts in (self.by_machine, self.by_style):
            lines.append(f"{'':24}" + "".join(f"{fate:>10}" for fate in FATES))
            for name, fates in sorted(counts.items()):
                lines.append(f"{name:24}" + "".join(f"{fates[fate]:>10}" for fate in FATES))
        for title, found in (
            ("jobs refused at first, by code", self.refusals),
            ("hints followed", self.hints),
            ("accepted shortfalls, by code", self.shortfalls),
        ):
            lines.append(f"{title}:")
            lines += [f"{count:8}  {name}" for name, count in found.most_common()]
        lines.append(
            f"{self.asked} jobs with questions, {self.mistyped} with a line type that was wrong "
            f"without a question"
        )
        lines.append(
            f"{self.jobs} jobs, {self.failures} failures, {self.checked} programs checked, "
            f"{self.seconds:.0f} s"
        )
        return "\n".join(lines)


def run(
    count: int,
    seed: int,
    tally: Tally,
    *,
    first: int = 0,
    check: Callable[[Job, Outcome], str] | None = None,
    every: int = 0,
    bodies: bool = False,
) -> Iterator[tuple[Job, Outcome]]:
    """Compile jobs, count them, and yield those that fail.

    Parameters
    ----------
    first
        Number of the first job.
    check
        Returns what is wrong with an accepted program, "" if nothing.
    every
        The programs of one in so many jobs are checked; 0 for none.
    bodies
        Whether the jobs have bends and lines side by side, see ``random_job``.
    """
    begin = time.perf_counter()
    for number in range(first, first + count):
        job = random_job(seed, number, bodies=bodies)
        outcome = attempt_job(job)
        if check is not None and every and number % every == 0 and outcome.compiled is not None:
            tally.checked += 1
            if fault := check(job, outcome):
                outcome.fate, outcome.text = "wrongly accepted", fault
        tally.add(job, outcome)
        tally.seconds = time.perf_counter() - begin
        if outcome.fate in ("left out", "stuck", "error", "wrongly accepted"):
            yield job, outcome
