"""Defines the stored result of compiling a job, and the stored form of its verdict."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from knifetip.messages import Message


@dataclass(frozen=True, slots=True)
class CompileResult:
    """Program, tool path, verdict and tools of a compiled job, as they are stored."""

    accepted: bool
    message: Message | None  #: why the job was refused; None if the verdict is accepted
    program: bytes
    sha256: str
    lines: int
    toolpath: bytes  #: see ``presentation.toolpath``
    verdict: bytes  #: see ``presentation.verdict``
    verdict_summary: dict[
        str, Any
    ]  #: greatest deviations and durations, see ``presentation.verdict``
    source: list[str] = field(default_factory=list)
    #: rows of the edges because of which the program is refused
    edges: list[int] = field(default_factory=list)
    #: stations that the program uses, ordered by number: number, name, kind
    tools: list[dict[str, Any]] = field(default_factory=list)
    lengths: bytes = b""  #: see ``worked_lengths``
    facts: dict[str, Any] = field(default_factory=dict)  #: the fields of ``ProgramFacts``


@dataclass(frozen=True, slots=True)
class VerdictColumns:
    """A verdict as a job stores it."""

    verdict: bytes  #: see ``presentation.verdict``
    verdict_summary: dict[str, Any]  #: see ``presentation.verdict``
    message: Message | None  #: why the program is refused; None if it is accepted
    source: list[str]  #: handles of the edges because of which the program is refused
    edges: list[int]  #: rows of these edges
