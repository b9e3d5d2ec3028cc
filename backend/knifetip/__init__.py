"""knifetip compiles carton dielines into compensated, verified machine programs.

The stages are functions, and records travel between them::

    bytes → Drawing → Dieline → Cleaned → Operations → Toolpaths → Toolpath → Program → Verdict
        read    classify    clean    plan     compensate   sequence  process    verify

``compile`` runs all stages from ``clean`` on.  They are the functions of ``knifetip.pipeline``;
``stream`` sends a program to a controller.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from knifetip.gateway.stream import stream
    from knifetip.model.board import Board
    from knifetip.model.cleaned import Cleaned
    from knifetip.model.dieline import Dieline, LineType
    from knifetip.model.drawing import Drawing
    from knifetip.model.machine import Machine
    from knifetip.model.operation import Operation
    from knifetip.model.program import Program
    from knifetip.model.toolpath import Toolpath
    from knifetip.model.verdict import Verdict
    from knifetip.pipeline import (
        Compiled,
        classify,
        clean,
        compensate,
        compile,
        plan,
        process,
        questions,
        read,
        sequence,
        verify,
    )

__all__ = [
    "Board",
    "Cleaned",
    "Compiled",
    "Dieline",
    "Drawing",
    "LineType",
    "Machine",
    "Operation",
    "Program",
    "Toolpath",
    "Verdict",
    "classify",
    "clean",
    "compensate",
    "compile",
    "plan",
    "process",
    "questions",
    "read",
    "sequence",
    "stream",
    "verify",
]

# Imported when it is first used: a gateway needs no reader, and ``knifetip --help`` no stage.
_MODULES = {
    "stream": "gateway.stream",
    "Board": "model.board",
    "Cleaned": "model.cleaned",
    "Dieline": "model.dieline",
    "Drawing": "model.drawing",
    "LineType": "model.dieline",
    "Machine": "model.machine",
    "Operation": "model.operation",
    "Program": "model.program",
    "Toolpath": "model.toolpath",
    "Verdict": "model.verdict",
}


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module 'knifetip' has no attribute {name!r}")
    return getattr(import_module(f"knifetip.{_MODULES.get(name, 'pipeline')}"), name)
