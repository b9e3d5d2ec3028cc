"""controller: how the controllers that read RS274/NGC differ.

Source: ``docs.linuxcnc.org`` (G-code reference), and grbl 1.1's and grblHAL's own documentation;
each line for LinuxCNC is read back by its interpreter in ``tests/controllers``.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Dialect:
    """The words of one controller."""

    name: str
    decimals: int  #: of X Y Z C I J
    rotary: str  #: letter of the tool head's heading; some builds of grbl call it A
    tool_table: bool  #: Tn M6 G43 bring the station's datum; otherwise it is in the numbers
    blending: bool  #: knows G64 P Q
    inverse_arcs: bool  #: counts degrees as mm under G94, so an arc with C goes by G93
    eager_outputs: bool  #: switches M64, M65 when it reads them, while earlier moves still run
    comments: bool  #: stations are announced in comments; the notes always stand at the top
    radius: float  #: arcs larger than this are sent as chords (mm)
    line_limit: int  #: longest line, without its newline (bytes)
    end: str  #: the word that ends a program
