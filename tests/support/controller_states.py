"""States of controllers, and the way out of each: the table that the tests of the page share."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True, slots=True)
class Cell:
    """What is said in a state, and what leads out of it."""

    code: str  #: of the alarm or the obstacle; "" for none
    ways: tuple[str, ...]  #: operations, or commands of the job


@dataclass(frozen=True, slots=True)
class ControllerState:
    """One row: a state of a controller."""

    name: str
    controller: str  #: grbl or linuxcnc
    report: str | Mapping[str, str]  #: status report of grbl, or variables of LinuxCNC
    alarm: int  #: code of the alarm of grbl; 0 for none
    state: str  #: as the station reports it
    title: str  #: as the page names it
    free: Cell  #: without a job, while one waits for its confirmation, and between two copies
    cut: Cell  #: while the job is held in a cut
    ends_cut: bool  #: the state ends the job in a cut; ``cut`` is then ``free``

    def __str__(self) -> str:
        return f"{self.controller}-{self.name}"


def _cell(fields: Mapping[str, Any]) -> Cell:
    return Cell(fields["code"], tuple(fields["ways"]))


def _state(row: Mapping[str, Any]) -> ControllerState:
    free, ends = _cell(row["free"]), row["cut"] == "ends"
    return ControllerState(
        row["name"],
        row["controller"],
        row["report"],
        row["alarm"],
        row["state"],
        row["title"],
        free,
        free if ends else _cell(row["cut"]),
        ends,
    )


STATES = tuple(
    _state(row)
    for row in json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))
)
