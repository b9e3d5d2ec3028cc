"""controller: records of the differences between the controllers that read RS274/NGC.

Source: ``docs.linuxcnc.org`` (G-code reference), and the documentation of grbl 1.1 and grblHAL.
The tests in ``tests/controllers`` read the programs for LinuxCNC back with LinuxCNC's interpreter.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Dialect:
    """Dialect of RS274/NGC that one controller reads."""

    name: str  #: name of the controller language
    decimals: int  #: number of decimals of positions and of I J
    tool_table: bool  #: whether Tn M6 G43 adds the datum of a station
    blending: bool  #: whether the controller supports G64 P Q
    inverse_arcs: bool  #: whether G94 counts degrees as mm, so that an arc with C needs G93
    eager_outputs: bool  #: whether M64 and M65 are executed while earlier moves still run
    comments: bool  #: whether comments name the stations; notes are always written
    radius: float  #: largest radius of an arc; larger arcs are written as chords (mm)
    line_limit: int  #: length of the longest line, without its newline (bytes)
    end: str  #: word that ends a program
