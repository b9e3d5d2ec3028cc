"""grblhal: write programs for grblHAL and grbl 1.1."""

from __future__ import annotations

from functools import partial
from typing import Final

from knifetip.post.rs274.controller import Dialect
from knifetip.post.rs274.program import write_program

DIALECT: Final = Dialect(
    name="grblhal",
    decimals=4,
    tool_table=False,
    blending=False,
    inverse_arcs=True,
    eager_outputs=True,
    comments=False,
    # grbl computes with 32-bit floats: at a radius of 16 m their resolution is 0.002 mm.
    radius=16e3,
    line_limit=80,
    end="M30",
)

emit: Final = partial(write_program, dialect=DIALECT)
