"""Dialect: what one kind of controller understands, and how it wants to be told.

    "grblhal" -> Dialect

Source: ``docs.linuxcnc.org`` (G-code reference), and grbl 1.1's and grblHAL's own documentation;
each line of ``linuxcnc`` is read back by LinuxCNC's interpreter in ``tests/controllers``.
"""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.errors import LibraryError


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


_DIALECTS = {
    dialect.name: dialect
    for dialect in (
        Dialect(
            name="linuxcnc",
            decimals=4,
            rotary="C",
            tool_table=True,
            blending=True,
            inverse_arcs=False,
            eager_outputs=False,
            comments=True,
            radius=1e6,
            line_limit=250,
            end="M2",
        ),
        # Its numbers are of 32 bits: at a radius of 16 m the last place is worth 0.002 mm.
        Dialect(
            name="grblhal",
            decimals=4,
            rotary="C",
            tool_table=False,
            blending=False,
            inverse_arcs=True,
            eager_outputs=True,
            comments=False,
            radius=16e3,
            line_limit=80,
            end="M30",
        ),
    )
}


def dialect_of(name: str) -> Dialect:
    """Return the dialect of this name.

    Raises
    ------
    LibraryError
        No controller that we write for speaks it.
    """
    try:
        return _DIALECTS[name]
    except KeyError:
        raise LibraryError(
            f"There is no dialect {name!r}.", f"There are {', '.join(_DIALECTS)}."
        ) from None
