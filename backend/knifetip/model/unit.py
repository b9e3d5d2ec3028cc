"""Units of length, and what speaks for a drawing being in one of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from knifetip.errors import NoSuchUnit

#: Millimetres to one unit: the five that headers state, then points and pixels, which programs
#: that draw pages write without saying so.
MILLIMETRES: Final[Mapping[str, float]] = {
    "mm": 1.0,
    "cm": 10.0,
    "m": 1000.0,
    "in": 25.4,
    "ft": 304.8,
    "pt": 25.4 / 72.0,
    "px": 25.4 / 96.0,
}
#: Units that people draw in; points and pixels are what a file turns out to be in.
DRAWN_IN: Final = ("mm", "cm", "m", "in", "ft")
#: Their names in a sentence.
NAMES: Final[Mapping[str, str]] = {
    "mm": "mm",
    "cm": "cm",
    "m": "metres",
    "in": "inches",
    "ft": "feet",
    "pt": "points",
    "px": "pixels",
}


def factor(unit: str) -> float:
    """Return the millimetres to one unit; 1 for the empty unit, that of the file.

    Raises
    ------
    NoSuchUnit
        No unit has this name.
    """
    if unit == "":
        return 1.0
    try:
        return MILLIMETRES[unit]
    except KeyError:
        raise NoSuchUnit("unit.unsupported", unit=unit, known=MILLIMETRES) from None


@dataclass(frozen=True, slots=True)
class Hint:
    """What a file says that has to do with its unit, besides stating it."""

    #: "metric", "imperial", "inches", "pixels", "points", or "shown × 25.4": what dimensions are
    #: shown in
    says: str
    text: str  #: as the file has it: "$MEASUREMENT = 1"


@dataclass(frozen=True, slots=True)
class UnitEvidence:
    """One thing that speaks for a unit."""

    unit: str
    text: str  #: what it is, with its measure
    weight: float  #: natural logarithm of how much likelier it is in this unit than in the worst
    kind: str  #: "header", "size", "features", "paper", "grid" or "words"


@dataclass(frozen=True, slots=True)
class UnitFinding:
    """What all evidence together says."""

    unit: str  #: empty where it must be asked
    conclusive: bool
    evidence: tuple[UnitEvidence, ...]  #: the heaviest first
    ranking: tuple[str, ...]  #: all units, the likeliest first
    margin: float  #: by how much the first leads the second (natural logarithm)
    warnings: tuple[str, ...] = ()  #: what somebody should look at, whatever the unit
