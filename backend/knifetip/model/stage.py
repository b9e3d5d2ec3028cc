"""Stage: the steps from a file to a verified program, as progress reports name them."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TypeAlias


class Stage(StrEnum):
    """A step of reading or compiling a drawing, in the order in which they happen."""

    PREPARE = "prepare"  #: kernels are compiled, once after an installation
    READ = "read"  #: the file becomes a Drawing
    CLASSIFY = "classify"  #: each edge gets its line type
    STORE = "store"  #: the reading is packed for the store
    CLEAN = "clean"
    PLAN = "plan"
    COMPENSATE = "compensate"
    SEQUENCE = "sequence"
    PROCESS = "process"  #: the tool path becomes a program
    VERIFY = "verify"
    DONE = "done"


#: Called with the stage that begins and the completed share of the whole, 0 … 1.
Progress: TypeAlias = Callable[[Stage, float], None]


def no_progress(_stage: Stage, _share: float) -> None:
    """Ignore progress."""
