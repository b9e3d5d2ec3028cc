"""compile_result: what a compile returns to the store."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, slots=True)
class CompileResult:
    """Program, tool path and verdict of a compiled job."""

    accepted: bool
    reason: str  #: of a refusal
    program: bytes
    sha256: str
    lines: int
    toolpath: bytes  #: see ``columns``
    verdict: bytes  #: see ``columns``
    judged: dict[str, Any]  #: the verdict in four figures
    source: list[str] = field(default_factory=list)
    #: stations that the program uses, in their order: number, name, kind
    tools: list[dict[str, Any]] = field(default_factory=list)
