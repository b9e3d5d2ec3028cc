"""linuxcnc: write programs for LinuxCNC."""

from __future__ import annotations

from functools import partial
from typing import Final

from knifetip.post.rs274.controller import Dialect
from knifetip.post.rs274.program import write_program

DIALECT: Final = Dialect(
    name="linuxcnc",
    decimals=4,
    tool_table=True,
    blending=True,
    inverse_arcs=False,
    eager_outputs=False,
    comments=True,
    radius=1e6,
    line_limit=250,
    end="M2",
)

emit: Final = partial(write_program, dialect=DIALECT)
