"""Names of the stages from a file to a verified program, as used in progress reports."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TypeAlias


class Stage(StrEnum):
    """A stage of reading or compiling a drawing; the members are in the order of execution."""

    PREPARE = "prepare"  #: compile kernels, once after an installation
    READ = "read"  #: convert the file to a Drawing
    CLASSIFY = "classify"  #: determine the line type of each edge
    STORE = "store"  #: pack the classified drawing for the store
    CLEAN = "clean"
    PLAN = "plan"
    COMPENSATE = "compensate"
    SEQUENCE = "sequence"
    PROCESS = "process"  #: write the tool path as a program
    VERIFY = "verify"
    DONE = "done"


#: Callback that receives the stage that begins and the completed fraction of the task, 0 … 1.
Progress: TypeAlias = Callable[[Stage, float], None]


def no_progress(_stage: Stage, _fraction: float) -> None:
    """Do nothing: a progress callback for callers that show no progress."""
