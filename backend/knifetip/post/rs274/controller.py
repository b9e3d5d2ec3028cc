"""controller: differences between controllers that read RS274/NGC.

Source: ``docs.linuxcnc.org`` (G-code reference), and grbl 1.1's and grblHAL's own documentation;
each line for LinuxCNC is read back by its interpreter in ``tests/controllers``.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Dialect:
    """The variant of RS274/NGC that one controller reads."""

    name: str
    decimals: int  #: decimals of X Y Z C I J
    rotary: str  #: letter of the axis that turns the tool; some builds of grbl use A
    tool_table: bool  #: Tn M6 G43 adds the station's datum; otherwise the numbers include it
    blending: bool  #: supports G64 P Q
    inverse_arcs: bool  #: treats degrees as mm in G94, so an arc with C needs G93
    eager_outputs: bool  #: executes M64, M65 when it reads them, while earlier moves still run
    comments: bool  #: comments name the stations; notes are always written at the top
    radius: float  #: arcs larger than this are sent as chords (mm)
    line_limit: int  #: longest line, without its newline (bytes)
    end: str  #: word that ends a program
