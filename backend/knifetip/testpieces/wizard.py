"""wizard: the records of a wizard: the table for which it draws, its measures and its figures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from pydantic import Field

from knifetip.errors import PieceRefused
from knifetip.fields import Table
from knifetip.languages.registry import find_language
from knifetip.library.definition import Shelf
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Tool
from knifetip.testpieces.piece import Piece

#: Path of a value in the file of a machine or a board, as in TOML.
KeyPath: TypeAlias = tuple[str | int, ...]
Unit: TypeAlias = Literal["mm", "degrees", "factor", "per-mm"]

#: Greatest plausible error of a length of a piece (mm); a greater one is a typing error.
MOST_ERROR: Final = 5.0


class Measures(Table):
    """Base class of the measures of a wizard."""

    reading: float = Field(
        default=0.05,
        gt=0.0,
        le=1.0,
        title="Accuracy of reading",
        description="How exactly you can read the measures (mm): about 0.1 with a ruler, 0.05 with "
        "a calliper, 0.02 with a measuring loupe",
    )


@dataclass(frozen=True, slots=True)
class Bench:
    """The machine, the station and the board that are measured."""

    machine: Machine
    board: Board
    station: Station

    @property
    def station_path(self) -> KeyPath:
        """Path of the station in the file of the machine."""
        numbers = [station.number for station in self.machine.stations]
        return "station", numbers.index(self.station.number)

    def makes(self, line_type: LineType) -> Station | None:
        """Return the station that makes a line type in the board; None if there is none."""
        machine = self.machine.for_board(self.board)
        return machine.station_for(line_type, self.board.caliper)

    def check_makes(self, line_type: LineType, kinds: tuple[type[Tool], ...]) -> None:
        """Raise ``PieceRefused`` unless the station makes a line type with a tool of ``kinds``."""
        if not isinstance(self.station.tool, kinds):
            raise PieceRefused("testpiece.other-tool", station=self.station.number)
        maker = self.makes(line_type)
        if maker is None or maker.number != self.station.number:
            raise PieceRefused(
                "testpiece.other-station",
                type=line_type.word,
                station=self.station.number,
                other=0 if maker is None else maker.number,
            )

    def check_sets_depth(self) -> None:
        """Raise ``PieceRefused`` if programs of the machine do not set depths."""
        if not find_language(self.machine.dialect).sets_pose:
            raise PieceRefused("testpiece.no-depth", machine=self.machine.title)


class Figure(NamedTuple):
    """A setting that follows from the measures."""

    code: str  #: code of the message that names it, such as "testpiece.figure.back"
    shelf: Shelf | None  #: MACHINES or BOARDS: the file that has it; None for the controller
    path: KeyPath  #: place in the file; empty for the controller
    before: float
    after: float
    uncertainty: float  #: half the width of the interval in which the true value lies
    unit: Unit

    @property
    def name(self) -> str:
        """Short name, such as "back"."""
        return self.code.rpartition(".")[2]

    @property
    def label(self) -> Message:
        """What the figure is."""
        return Message(self.code)

    @property
    def is_significant(self) -> bool:
        """Whether the value changes by more than its uncertainty."""
        return abs(self.after - self.before) > self.uncertainty


@dataclass(frozen=True, slots=True)
class Wizard:
    """A wizard: a piece to cut, what to measure on it, and the settings that follow."""

    code: str  #: such as "knife-depth"
    name: Message
    description: Message  #: what is cut, in one line
    instruction: Message  #: how the piece is measured
    kinds: tuple[str, ...]  #: kinds of tools that are measured, by the names of ``KINDS``
    measures: type[Measures]
    draw: Callable[[Bench], Piece]
    figures: Callable[[Bench, Any], Sequence[Figure]]  #: with an instance of ``measures``


def check_length(name: str, measured: float, drawn: float, most: float = MOST_ERROR) -> float:
    """Return how much longer a length was measured than drawn (mm).

    Raises
    ------
    PieceRefused
        The difference is greater than ``most`` mm, so the measure is probably mistyped.
    """
    if abs(measured - drawn) > most:
        raise PieceRefused(
            "testpiece.implausible", measure=name, value=measured, drawn=drawn, source=(name,)
        )
    return measured - drawn


def check_changed(name: str, value: float, least: float) -> float:
    """Return a new value of a setting; raise ``PieceRefused`` if it is less than ``least``."""
    if value < least:
        raise PieceRefused("testpiece.impossible", value=value, least=least, source=(name,))
    return value
