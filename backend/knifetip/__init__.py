"""knifetip puts the tip of the knife on the line.

Seven functions, each in a module of its own, and the records that travel between them::

    bytes → Drawing → Dieline → Operations → Toolpaths → Toolpath → Program → machine
        read    classify    plan    compensate   sequence   process    stream

``knifetip.pipeline`` calls them in this order; ``verify`` judges what came out.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from knifetip.classification.classify import classify
    from knifetip.compensation.compensate import compensate
    from knifetip.dxf.read import read
    from knifetip.gateway.stream import stream
    from knifetip.model.board import Board
    from knifetip.model.dieline import Dieline, LineType
    from knifetip.model.drawing import Drawing
    from knifetip.model.machine import Machine
    from knifetip.model.operation import Operation
    from knifetip.model.program import Program
    from knifetip.model.toolpath import Toolpath
    from knifetip.model.verdict import Verdict
    from knifetip.planning.plan import plan
    from knifetip.post.emit import process
    from knifetip.sequencing.sequence import sequence
    from knifetip.verification.verify import verify

__all__ = [
    "Board",
    "Dieline",
    "Drawing",
    "LineType",
    "Machine",
    "Operation",
    "Program",
    "Toolpath",
    "Verdict",
    "classify",
    "compensate",
    "plan",
    "process",
    "read",
    "sequence",
    "stream",
    "verify",
]

# Each name is fetched when it is first asked for: a gateway beside a table needs no DXF reader.
_PLACES = {
    "read": "dxf.read",
    "classify": "classification.classify",
    "plan": "planning.plan",
    "compensate": "compensation.compensate",
    "sequence": "sequencing.sequence",
    "process": "post.emit",
    "stream": "gateway.stream",
    "verify": "verification.verify",
    "Drawing": "model.drawing",
    "Dieline": "model.dieline",
    "LineType": "model.dieline",
    "Operation": "model.operation",
    "Toolpath": "model.toolpath",
    "Program": "model.program",
    "Verdict": "model.verdict",
    "Machine": "model.machine",
    "Board": "model.board",
}


def __getattr__(name: str) -> Any:
    try:
        place = _PLACES[name]
    except KeyError:
        raise AttributeError(f"module 'knifetip' has no attribute {name!r}") from None
    return getattr(import_module(f"knifetip.{place}"), name)
