"""Units of length, and records of the evidence for the unit of a drawing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from knifetip.errors import NoSuchUnit
from knifetip.messages import Message

#: Millimetres in one unit.  File headers state only the first five units; page layout programs
#: write points or pixels without a statement.
MILLIMETRES: Final[Mapping[str, float]] = {
    "mm": 1.0,
    "cm": 10.0,
    "m": 1000.0,
    "in": 25.4,
    "ft": 304.8,
    "pt": 25.4 / 72.0,
    "px": 25.4 / 96.0,
    # Pixels of Inkscape before version 0.92.
    "px-90": 25.4 / 90.0,
}
#: Units in which cartons are designed; points and pixels result from file conversion only.
DRAWN_IN: Final = ("mm", "cm", "m", "in", "ft")


def factor(unit: str) -> float:
    """Return the number of millimetres in a unit; 1 for "", the unknown unit of a drawing.

    Raises
    ------
    NoSuchUnit
        ``unit`` is not the name of a unit.
    """
    if unit == "":
        return 1.0
    try:
        return MILLIMETRES[unit]
    except KeyError:
        raise NoSuchUnit("unit.unsupported", unit=unit, known=MILLIMETRES) from None


@dataclass(frozen=True, slots=True)
class UnitHint:
    """A setting in the header of a file that makes one unit likely, without naming the unit."""

    #: "metric", "imperial", "inches", "pixels", "written in mm" and "modelled in mm" by the program
    #: that wrote the file, or "shown × 25.4": the factor between lengths and the values that
    #: dimensions show
    kind: str
    message: Message  #: the setting, as it is in the file


@dataclass(frozen=True, slots=True)
class UnitEvidence:
    """One observation in a drawing that makes one unit more likely."""

    unit: str
    message: Message  #: the observation, with its measured value
    weight: (
        float  #: log-likelihood of the observation in this unit, relative to the least likely unit
    )
    kind: str  #: "header", "size", "features", "paper", "grid" or "words"


@dataclass(frozen=True, slots=True)
class UnitFinding:
    """The unit of a drawing that the evidence supports, and the evidence for each possible unit."""

    unit: str  #: empty if the user must choose
    conclusive: bool
    evidence: tuple[UnitEvidence, ...]  #: highest weight first
    ranking: tuple[str, ...]  #: all units, most likely first
    margin: float  #: weight of the first unit of the ranking minus the weight of the second
    warnings: tuple[Message, ...] = ()  #: possible faults that the user should check
