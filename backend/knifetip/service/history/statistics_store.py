"""Statistics of the runs of machines: jobs, copies, sheets, lengths, time and interruptions."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Final, Literal, NamedTuple, TypeAlias
from zoneinfo import ZoneInfo

import sqlalchemy as sa

from knifetip.contract.job import State
from knifetip.service.database.engine import Database
from knifetip.service.database.tables import MachineRun, RunLength

_QUARTER: Final = 900.0  # seconds

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

    def add(self, runs: _Runs) -> None:
        """Add runs with one board and one outcome."""
        self.runs += runs.number
        self.jobs += runs.number if runs.outcome == State.DONE else 0
        self.copies += runs.copies
        self.interruptions += runs.number if runs.outcome == State.INTERRUPTED else 0
        self.seconds += runs.seconds
        if runs.sheets:
            self.sheets[runs.board] = self.sheets.get(runs.board, 0) + runs.sheets

    def add_length(self, line_type: str, length: float) -> None:
        """Add a worked length (mm) of a line type."""
        self.lengths[line_type] = self.lengths.get(line_type, 0.0) + length


class _Runs(NamedTuple):
    """Sums of the runs with one board and one outcome."""

    board: str
    outcome: str
    number: int
    copies: int
    sheets: int
    seconds: float


class StatisticsStore:
    """Computes statistics of ended jobs from the tables."""

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
        # The end of a run is 0 while the job is on the machine.
        first = max(since, sys.float_info.min)
        ended = sa.and_(MachineRun.ended >= first, MachineRun.ended < until)
        if machine:
            ended = sa.and_(ended, MachineRun.machine == machine)
        # The database adds up each quarter of an hour: midnight of every zone begins one.
        quarter = sa.func.floor(MachineRun.ended / _QUARTER)
        keys = MachineRun.machine, quarter
        total = sa.func.sum
        runs = (
            sa.select(
                *keys,
                MachineRun.board,
                MachineRun.outcome,
                sa.func.count(),
                total(MachineRun.copies),
                total(MachineRun.sheets),
                total(MachineRun.ended - MachineRun.started),
            )
            .where(ended)
            .group_by(*keys, MachineRun.board, MachineRun.outcome)
        )
        lengths = (
            sa.select(*keys, RunLength.line_type, total(RunLength.length))
            .join(MachineRun)
            .where(ended)
            .group_by(*keys, RunLength.line_type)
        )
        starts: dict[float, float] = {}
        found: dict[tuple[str, float], Statistics] = {}

        def period(machine: str, number: float) -> Statistics:
            if number not in starts:
                starts[number] = period_start(float(number) * _QUARTER, step, zone)
            key = machine, starts[number]
            return found.setdefault(key, Statistics(*key))

        with self._db.reading() as session:
            for machine, number, *sums in session.execute(runs):
                period(machine, number).add(_Runs(*sums))
            for machine, number, line_type, length in session.execute(lengths):
                period(machine, number).add_length(line_type, length)
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
