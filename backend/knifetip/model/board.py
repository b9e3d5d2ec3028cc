"""Board: what lies on the table, and how it likes to be creased and grooved."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Deflection:
    """How far a tool gives way in this board: the radius paper's ΔXmax and ΔYmax."""

    tool: str  #: name of its station
    x: float  #: δx, the most in X (mm)
    y: float  #: δy, the most in Y (mm)


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
    end_clearance: float  #: a crease stops this far before its free end (mm)
    groove_depth: float  #: of a V-groove below the top face (mm)
    groove_overcut: float  #: the most by which a V-groove's blade may run past its ends (mm)
    half_cut_depth: float  #: below the top face (mm)
    perforation: tuple[float, float]  #: length of cut and of gap (mm)
    short_crease: str  #: "press" in place at the depth that fits, or "refuse"
    bridge_width: float = 0.0  #: of a bridge (nick) that holds the part (mm); 0 for none
    bridge_spacing: float = 0.0  #: the longest way between two bridges along an outer cut (mm)
    double_crease: float = 0.0  #: between the lines of a double crease (mm); 0 for a single one
    groove_pass: float = 0.0  #: the deepest that one pass of a V-groove may go (mm); 0 for all
    groove_curve: float = 0.0  #: the most that a groove of chords may leave its arc (mm); 0: none
    deflection: tuple[Deflection, ...] = ()  #: of the tools that were measured in it
