"""chosen_tools: refuse tools that cannot make the edges for which the user has chosen them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import I64
from knifetip.messages import Message
from knifetip.model.chosen_work import ChosenWork
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import EdgeTool
from knifetip.model.machine import Machine, Station
from knifetip.planning.tool_steps import makers, steps_of

#: Field of the choice.
_STATION: Final = "station"


def check_tools(work: ChosenWork, dieline: Dieline, machine: Machine) -> None:
    """Raise ``PlanError`` if a chosen station is missing, or its tool does not make an edge.

    The cuts of a sheet are made by one kind of tool: a knife cuts on the line, a cutter beside it.

    Parameters
    ----------
    work
        What is chosen for the edges.
    dieline
        The edges with their line types.
    """
    if EdgeTool not in work:
        return
    numbers = work[EdgeTool].numbers(_STATION, 0.0).astype(np.int64)
    chosen = np.flatnonzero(numbers > 0)
    pairs = np.column_stack([numbers[chosen], dieline.line_type[chosen]])
    for number, line_type in np.unique(pairs, axis=0).tolist():
        rows = chosen[(pairs == (number, line_type)).all(axis=1)]
        _check_station(number, LineType(line_type), rows, machine)


def _check_station(number: int, line_type: LineType, rows: I64, machine: Machine) -> None:
    """Raise ``PlanError`` if the tool of a station does not make edges of a line type.

    ``rows`` are the indices in the dieline of the edges for which it is chosen.
    """
    edge, suited = int(rows[0]), makers(machine, line_type)
    if not steps_of(line_type):
        raise PlanError("tool-choice.not-made", edge=edge, type=line_type.word, at_edges=rows)
    if not suited or number in {station.number for station in suited}:
        # A line type without any tool is refused when it is planned.
        return
    names = _names(suited)
    found = next((station for station in machine.stations if station.number == number), None)
    if found is None:
        raise PlanError(
            "tool-choice.no-station",
            edge=edge,
            station=number,
            machine=machine.title,
            suited=names,
            at_edges=rows,
        )
    raise PlanError(
        "tool-choice.other-kind",
        edge=edge,
        type=line_type.word,
        station=number,
        name=found.name,
        suited=names,
        at_edges=rows,
    )


def _names(stations: Sequence[Station]) -> list[Message]:
    """Return the numbers and names of stations, for a message."""
    return [
        Message("tool-choice.station", station=station.number, name=station.name)
        for station in stations
    ]


def all_cuts_chosen(work: ChosenWork, dieline: Dieline) -> bool:
    """Return whether the tool is chosen for every cut of a dieline."""
    if EdgeTool not in work:
        return False
    numbers = work[EdgeTool].numbers(_STATION, 0.0)
    return bool((numbers[dieline.line_type == LineType.CUT] > 0.0).all())
