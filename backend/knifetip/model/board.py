"""Board: one material in one thickness, with its parameters for creasing and grooving."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Deflection:
    """Greatest deflection of a tool in this board: ΔXmax and ΔYmax of the radius paper."""

    tool: str  #: name of its station
    x: float  #: δx, greatest deflection in X (mm)
    y: float  #: δy, greatest deflection in Y (mm)


@dataclass(frozen=True, slots=True)
class Board:
    """One material in one thickness."""

    name: str
    title: str
    material: str  #: "greyboard", "corrugated" or "folding boxboard"
    caliper: float  #: T (mm)
    grain: float  #: azimuth of flute or grain on the sheet (degrees)
    crease_along: float  #: depth of a crease that runs along flute or grain (mm)
    crease_across: float  #: depth of a crease that runs across it (mm)
    end_clearance: float  #: setback of a crease at a free end (mm)
    groove_depth: float  #: of a V-groove below the top face (mm)
    groove_overcut: float  #: greatest overcut of a V-groove's blade at its ends (mm)
    half_cut_depth: float  #: below the top face (mm)
    perforation: tuple[float, float]  #: length of cut and of gap (mm)
    short_crease: str  #: "press" in place to a smaller depth, or "refuse"
    bridge_width: float = 0.0  #: width of a bridge (nick) (mm); 0 for no bridges
    bridge_spacing: float = 0.0  #: greatest distance between bridges along an outer cut (mm)
    double_crease: float = 0.0  #: distance of a double crease's lines (mm); 0: single creases
    groove_pass: float = 0.0  #: greatest depth of one pass of a V-groove (mm); 0 for no limit
    groove_curve: float = 0.0  #: greatest distance of chords from a curved groove (mm); 0: none
    deflection: tuple[Deflection, ...] = ()  #: of the tools that were measured in this board
