"""Records of a board: material, caliper, and parameters for creasing, grooving and cutting."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Deflection:
    """Measured maximum deflection of one cutter under load in one board (mm), along X and Y.

    The two values are ΔXmax and ΔYmax in the paper "Tool radius compensation", whose method the
    module ``compensation.deflection`` implements.
    """

    tool: str  #: name of the station that holds the cutter
    x: float  #: δx, maximum deflection in X (mm)
    y: float  #: δy, maximum deflection in Y (mm)


@dataclass(frozen=True, slots=True)
class ToolLimits:
    """How fast and how deep the tools of one kind may work in a board, and which of them suits."""

    kind: str  #: word of the kind of tool in TOML files, such as "knife"
    feed: float = 0.0  #: greatest feed in the board (mm/min); 0: no limit
    step: float = 0.0  #: greatest depth of one pass of a cutter or a knife (mm); 0: no limit
    #: radius of a curve below which the feed of a knife is lower in proportion (mm); 0: nowhere
    slow_radius: float = 0.0
    #: kind of knife that suits the board: "oscillating", "fixed", or "" for any
    blade: str = ""


@dataclass(frozen=True, slots=True)
class Board:
    """A board: one material in one thickness, with the parameters of its operations."""

    name: str
    title: str
    #: "corrugated", "folding boxboard", "solid board", "greyboard" or "foam board"
    material: str
    caliper: float  #: thickness T (mm)
    grain: float  #: azimuth of flute or grain on the sheet (degrees)
    crease_along: float  #: depth of a crease that runs along flute or grain (mm)
    crease_across: float  #: depth of a crease across flute or grain (mm)
    end_clearance: float  #: setback of a crease at a free end (mm)
    groove_depth: float  #: depth of a V-groove below the top face (mm)
    groove_overcut: float  #: maximum overcut of the blade at the ends of a V-groove (mm)
    half_cut_depth: float  #: depth of a half cut below the top face (mm)
    perforation: tuple[float, float]  #: length of a cut and of a gap (mm)
    short_crease: str  #: "press" a too short crease in place, or "refuse" it
    bridge_width: float = 0.0  #: width of a bridge (nick) (mm); 0 for no bridges
    bridge_spacing: float = 0.0  #: maximum distance of bridges along an outer cut (mm)
    double_crease: float = 0.0  #: distance of the two parallel creases (mm); 0: single
    groove_pass: float = 0.0  #: maximum depth of one pass of a V-groove (mm); 0: no limit
    groove_curve: float = 0.0  #: maximum chord error of a curved groove (mm); 0: refused
    groove_shift: float = 0.3  #: maximum shift of a V-groove away from a cut beside it (mm)
    fold_angle: float = 90.0  #: angle by which the board must fold at a V-groove (degrees)
    #: greatest distance at which a wheel presses beside a bent crease (mm)
    crease_tolerance: float = 0.25
    #: creasing base for which the depths of creases are given: "rigid", "soft", or "" for any
    crease_base: str = ""
    cut_tolerance: float = 0.1  #: greatest distance of a cut in the top face from its line (mm)
    least_radius: float = 0.0  #: smallest radius of a bend that a knife cuts (mm); 0: no limit
    deflection: tuple[Deflection, ...] = ()  #: deflection of each cutter measured in this board
    limits: tuple[ToolLimits, ...] = ()  #: limits for kinds of tools; others have none
    version: int = 0  #: version of a user's board; 0 for a board of the library or of a file
