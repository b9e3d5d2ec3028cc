"""Statistics of the runs of machines: jobs, copies, sheets, lengths, time and interruptions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Literal, TypeAlias
from zoneinfo import ZoneInfo

import sqlalchemy as sa

from knifetip.jobs.database import Database
from knifetip.jobs.job import State
from knifetip.jobs.tables import MachineRun, RunLength

Step: TypeAlias = Literal["day", "week", "month"]


@dataclass(slots=True)
class Statistics:
    """Sums of the runs of one machine that ended in one period."""

    machine: str
    start: float  #: begin of the period (seconds since 1970)
    runs: int = 0
    jobs: int = 0  #: jobs that became done
    copies: int = 0
    interruptions: int = 0  #: runs that were interrupted
    seconds: float = 0.0  #: time from the starts of the runs to their ends
    sheets: dict[str, int] = field(default_factory=dict)  #: used sheets by board
    lengths: dict[str, float] = field(default_factory=dict)  #: worked length by line type (mm)

    def add(self, run: MachineRun, lengths: Iterable[tuple[str, float]]) -> None:
        """Add one run, with pairs of line types and worked lengths (mm)."""
        self.runs += 1
        self.jobs += run.outcome == State.DONE
        self.copies += run.copies
        self.interruptions += run.outcome == State.INTERRUPTED
        self.seconds += run.ended - run.started
        if run.sheets:
            self.sheets[run.board] = self.sheets.get(run.board, 0) + run.sheets
        for line_type, length in lengths:
            self.lengths[line_type] = self.lengths.get(line_type, 0.0) + length


class StatisticsStore:
    """Repository of statistics."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def sums(
        self, since: float, until: float, step: Step, zone: ZoneInfo, machine: str = ""
    ) -> list[Statistics]:
        """Return the statistics of each machine and period in which runs ended, in this order.

        Parameters
        ----------
        since, until
            First end and end before which runs are counted (seconds since 1970).
        step
            Length of the periods.
        zone
            Time zone in which the periods begin at midnight.
        machine
            Name of the only machine; empty for all.
        """
        ended = sa.and_(MachineRun.ended > 0.0, MachineRun.ended >= since, MachineRun.ended < until)
        if machine:
            ended = sa.and_(ended, MachineRun.machine == machine)
        lengths: dict[int, list[tuple[str, float]]] = {}
        found: dict[tuple[str, float], Statistics] = {}
        columns = sa.select(RunLength.run, RunLength.line_type, RunLength.length)
        with self._db.reading() as session:
            for run, line_type, length in session.execute(columns.join(MachineRun).where(ended)):
                lengths.setdefault(run, []).append((line_type, length))
            for one in session.scalars(sa.select(MachineRun).where(ended)):
                key = one.machine, period_start(one.ended, step, zone)
                found.setdefault(key, Statistics(*key)).add(one, lengths.get(one.id, ()))
        return [found[key] for key in sorted(found)]


def period_start(at: float, step: Step, zone: ZoneInfo) -> float:
    """Return the begin of the day, the week (Monday) or the month of a time.

    Parameters
    ----------
    at
        The time (seconds since 1970).
    step
        Length of the period.
    zone
        Time zone in which the period begins at midnight.
    """
    day = datetime.fromtimestamp(at, zone).replace(hour=0, minute=0, second=0, microsecond=0)
    if step == "week":
        day -= timedelta(days=day.weekday())
    elif step == "month":
        day = day.replace(day=1)
    return day.timestamp()
