"""plotter: the records of an HPGL device and its pens.

The emitter and the verifier's reader of HPGL share these records, but no computation.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Final

#: Number of mm/min in 1 cm/s.
CM_PER_SECOND: Final = 600.0


class PenWork(StrEnum):
    """Operation that a pen makes in the board: cut, half-cut or crease."""

    CUT = "cut"  #: through the board
    HALF_CUT = "half-cut"
    CREASE = "crease"


@dataclass(frozen=True, slots=True)
class Device:
    """A type of plotter or flat cutter, with its units, reachable area and limits."""

    title: str
    units: float  #: plotter units per millimetre
    area: tuple[int, int, int, int]  #: x0 y0 x1 y1 of the reachable area (plotter units)
    zero: tuple[float, float]  #: position of unit 0, 0 on the table (mm)
    pens: int  #: number of pens that SP can select
    speed: tuple[int, int] | None  #: least and greatest VS (cm/s); None without VS
    force: tuple[int, int] | None  #: least and greatest FS; None without FS
    comments: bool  #: whether the device supports the comment instruction CO


@dataclass(frozen=True, slots=True)
class Pen:
    """One pen number of an HPGL device: a tool in a station, used for one kind of operation."""

    number: int  #: argument of SP
    station: int  #: number of the machine's station
    work: PenWork
    force: int  #: argument of FS; 0 if the device lacks FS


@dataclass(frozen=True, slots=True)
class Plotter:
    """Settings of an HPGL machine: its device and its pens."""

    device: Device
    pens: tuple[Pen, ...]
