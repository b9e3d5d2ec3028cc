"""setup: the record of the machine, the board and the station for which an operation is planned."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.geometry.path import Paths
from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import LineType
from knifetip.model.job_options import ContourLead, CutDepth, EdgeTool
from knifetip.model.machine import Machine, Station
from knifetip.model.operation import Operation
from knifetip.planning.chosen_bridges import ChosenBridge


@dataclass(frozen=True, eq=False, slots=True)
class Setup:
    """One station of a machine, and the board on the machine's table."""

    machine: Machine
    board: Board
    station: Station
    chosen: ChosenWork = field(default_factory=dict)  #: choices for the edges of the dieline
    bridges: Sequence[ChosenBridge] = ()  #: bridges that the user has placed

    def depth_groups(self, rows: I32, usual: float) -> Iterator[tuple[I64, float, int]]:
        """Yield the m edges in groups of equal passes and depth.

        Each group is its indices in ``rows``, its depth (mm), and its number of passes, 0 for as
        many as the tool needs.

        Parameters
        ----------
        rows : (m,)
            Indices of the edges in the dieline.
        usual : mm
            Depth of edges for which none is chosen.
        """
        if CutDepth not in self.chosen:
            yield np.arange(len(rows)), usual, 0
            return
        chosen = self.chosen[CutDepth]
        depth, passes = chosen.numbers("depth", usual), chosen.numbers("passes", 0.0)
        group = chosen.index[rows]
        for number in np.unique(group):
            own = np.flatnonzero(group == number)
            first = rows[own[0]]
            yield own, float(depth[first]), int(passes[first])

    def chosen_stations(self, rows: I32) -> I64:
        """Return the number of the station that is chosen for each of m edges, (m,); 0 for none.

        A choice of another kind of tool than that of this station does not count: on a combi line,
        it is for the other half of the work.

        Parameters
        ----------
        rows : (m,)
            Indices of the edges in the dieline.
        """
        if EdgeTool not in self.chosen:
            return np.zeros(len(rows), np.int64)
        chosen = self.chosen[EdgeTool].numbers("station", 0.0)[rows].astype(np.int64)
        same = [station.number for station in self.machine.stations_like(self.station)]
        return np.where(np.isin(chosen, same), chosen, 0)

    def tool_groups(self, rows: I32) -> Iterator[tuple[I64, Setup]]:
        """Yield the m edges in groups with the same station: their indices in ``rows``, and the
        setup of the station.

        Parameters
        ----------
        rows : (m,)
            Indices of the edges in the dieline.
        """
        if EdgeTool not in self.chosen:
            yield np.arange(len(rows)), self
            return
        chosen = self.chosen_stations(rows)
        numbers = np.where(chosen > 0, chosen, self.station.number)
        for number in np.unique(numbers).tolist():
            yield np.flatnonzero(numbers == number), self.with_station(number)

    def with_station(self, number: int) -> Setup:
        """Return the setup of another station of the machine."""
        return replace(self, station=self.machine.station(number))

    def chosen_leads(self, rows: I32) -> I64:
        """Return the number of the lead-in that is chosen for each of m edges, (m,), from 1; 0 for
        none.

        ``rows`` (m,): indices of the edges in the dieline.
        """
        if ContourLead not in self.chosen:
            return np.zeros(len(rows), np.int64)
        return self.chosen[ContourLead].index[rows].astype(np.int64) + 1

    def with_lead(self, number: int) -> Setup:
        """Return the setup with the lead-in of a number of ``chosen_leads``."""
        if number == 0:
            return self
        choice = self.chosen[ContourLead].choices[number - 1]
        assert isinstance(choice, ContourLead)
        tool: Any = self.station.tool
        lead = tool.lead if choice.length is None else choice.length
        approach = tool.approach if choice.approach is None else choice.approach
        tool = replace(tool, lead=lead, approach=approach)
        return replace(self, station=replace(self.station, tool=tool))

    @property
    def through_depth(self) -> float:
        """Depth below the board's top face of a through cut on this machine and board (mm)."""
        return self.board.caliper + self.machine.into_mat

    def operation(
        self, line_type: LineType, paths: Paths, source: I32, depth: F64, ends: tuple[U8, U8]
    ) -> Operation:
        """Return the operation that moves this station's tool along p paths of n segments.

        Parameters
        ----------
        line_type
            Line type that the operation makes.
        source : (n,)
            Index in the dieline of the edge of each segment.
        depth : (n, k) mm
            Depth of each segment in each of k passes.
        ends : (p,) and (p,)
            Kinds of the starts and of the finishes of the paths, see ``End``.
        """
        machine, board, tool = self.machine, self.board, self.station.tool
        c = machine.carriage_of(self.station).axes[3]
        return Operation(
            paths=paths,
            line_type=line_type,
            tool=tool,
            station=self.station.number,
            depth=depth,
            caliper=board.caliper,
            clearance=machine.clearance,
            feed=tool.feed,
            plunge=tool.plunge,
            swivel=c.velocity * 60.0,
            turn_limits=(c.low - self.station.c, c.high - self.station.c),
            end_clearance=board.end_clearance,
            overcut=board.groove_overcut,
            short_crease=board.short_crease,
            start=ends[0],
            finish=ends[1],
            source=source,
            run_out=np.zeros((len(paths), 2)),
            side=0,
        )
