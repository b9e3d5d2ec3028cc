"""grblhal: programs for grblHAL and grbl 1.1."""

from __future__ import annotations

from functools import partial
from typing import Final

from knifetip.post.rs274.controller import Dialect
from knifetip.post.rs274.program import write_program

DIALECT: Final = Dialect(
    name="grblhal",
    decimals=4,
    rotary="C",
    tool_table=False,
    blending=False,
    inverse_arcs=True,
    eager_outputs=True,
    comments=False,
    # Its numbers are of 32 bits: at a radius of 16 m the last place is worth 0.002 mm.
    radius=16e3,
    line_limit=80,
    end="M30",
)

emit: Final = partial(write_program, dialect=DIALECT)
