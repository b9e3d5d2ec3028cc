"""cutters: choose the router bit that makes the cuts of a job, of those that a machine carries.

A thick cutter is stiff and fast, but it leaves inner corners and narrow openings uncut, and makes
slits as wide as itself.  Whether it serves is what the verifier finds in its program: the thickest
cutter is tried first, then thinner ones.  If none serves, cutters that could be fitted are tried
too, so that the user learns which one would.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Generic, Protocol, TypeVar

from knifetip.errors import CompensationError, PlanError
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Cutter
from knifetip.model.verdict import Severity, Verdict


class ProgramWithVerdict(Protocol):
    """A compiled program with its verdict."""

    @property
    def verdict(self) -> Verdict:
        """The verdict on the program."""


Compiled = TypeVar("Compiled", bound=ProgramWithVerdict)


@dataclass(frozen=True, slots=True)
class _Trial(Generic[Compiled]):
    """A compiled program, and what is wrong with it because of the cutter."""

    station: Station  #: station of the cutter
    compiled: Compiled
    faults: int  #: number of faults
    unreached: int  #: number of edges that the cutter does not reach
    slits: int  #: number of slits that become as wide as the cutter

    @property
    def rank(self) -> tuple[int, int, int]:
        """Numbers by which trials are compared, least first; zeros if the cutter serves."""
        return self.faults, self.unreached, self.slits


def cutting_station(machine: Machine) -> Station | None:
    """Return the station whose router bit makes cuts, or None if another kind of tool does."""
    station = machine.station_for(LineType.CUT)
    return station if station is not None and isinstance(station.tool, Cutter) else None


def with_best_cutter(
    attempt: Callable[[Machine], Compiled],
    machine: Machine,
    cutters: Callable[[], Mapping[str, Cutter]],
    *,
    fixed: bool = False,
) -> tuple[Compiled, list[Message]]:
    """Return the program of the thickest router bit of a machine that makes all cuts, and notes.

    If none makes all cuts, it is the program with the fewest faults and shortfalls, with a note
    about a cutter that has fewer.  Machines that cut with other tools have one program and no note.

    Parameters
    ----------
    attempt
        Compiles for a machine, of which the first cutter makes the cuts.
    machine
        The machine of the job.
    cutters
        Returns cutters that can be fitted, by title.
    fixed
        Whether the user has chosen the cutters of all cuts, so that there is one program.

    Raises
    ------
    PlanError, CompensationError
        The drawing cannot be made with any cutter of the machine.
    """
    if fixed or cutting_station(machine) is None:
        return attempt(machine), []
    carried = [one for one in machine.stations if isinstance(one.tool, Cutter)]
    carried.sort(key=lambda one: -one.tool.diameter)
    best: _Trial[Compiled] | None = None
    for station in carried:
        try:
            trial = _compile_with_cutter(attempt, machine, station)
        except (PlanError, CompensationError):
            if station is carried[-1] and best is None:
                raise
            continue
        # Of equally good cutters, the thinner one makes narrower slits.
        best = trial if best is None or trial.rank <= best.rank else best
        if not any(best.rank):
            break
    assert best is not None
    notes = []
    if best.station is not carried[0]:
        notes.append(
            Message(
                "cutter.thinner-chosen",
                station=best.station.number,
                diameter=best.station.tool.diameter,
                thickest=carried[0].tool.diameter,
            )
        )
    hint = _thinner_cutter_note(attempt, machine, best, cutters()) if any(best.rank) else None
    return best.compiled, notes if hint is None else [*notes, hint]


def _compile_with_cutter(
    attempt: Callable[[Machine], Compiled], machine: Machine, station: Station
) -> _Trial[Compiled]:
    """Compile with a cutter in place of the cutter that has the same station number."""
    others = (one for one in machine.stations if one.number != station.number)
    compiled = attempt(replace(machine, stations=(station, *others)))
    found = [finding for finding in compiled.verdict.findings if finding.refuses]
    return _Trial(
        station,
        compiled,
        sum(finding.severity is Severity.FAULT for finding in found),
        sum(finding.kind == "unreached" for finding in found),
        sum(finding.kind == "kerf" for finding in found),
    )


def _thinner_cutter_note(
    attempt: Callable[[Machine], Compiled],
    machine: Machine,
    best: _Trial[Compiled],
    cutters: Mapping[str, Cutter],
) -> Message | None:
    """Return a note about a thinner cutter that makes more of the edges, or narrower slits.

    It is the thickest cutter that leaves the fewest edges uncut; if all edges are reached, it is
    the thinnest one for the slits.

    ``attempt``, ``machine``: see ``with_best_cutter``.
    ``best``: the best program of the machine's own cutters.
    ``cutters``: cutters that can be fitted, by title.
    """
    own = best.station.tool.diameter
    thinner = sorted(
        (item for item in cutters.items() if item[1].diameter < own),
        key=lambda item: -item[1].radius,
    )
    reached: tuple[int, str, Cutter] | None = None
    for title, tool in thinner if best.unreached else ():
        try:
            trial = _compile_with_cutter(attempt, machine, replace(best.station, tool=tool))
        except (PlanError, CompensationError):
            continue
        left = best.unreached if reached is None else reached[0]
        if trial.faults <= best.faults and trial.unreached < left:
            reached = trial.unreached, title, tool
        if trial.unreached == 0:
            break
    if reached is not None:
        left, title, tool = reached
        return Message(
            "cutter.thinner-needed",
            own=own,
            total=best.unreached,
            count=best.unreached - left,
            diameter=tool.diameter,
            title=title,
        )
    if best.slits and thinner:
        title, tool = thinner[-1]
        return Message(
            "cutter.narrower-slits",
            count=best.slits,
            width=own,
            diameter=tool.diameter,
            title=title,
        )
    return None
