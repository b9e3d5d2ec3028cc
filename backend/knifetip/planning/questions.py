"""questions: create the questions for the user about line types for which a machine has no tool."""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.question import Question
from knifetip.planning.tool_steps import lacks_tool


def tool_questions(dieline: Dieline, machine: Machine) -> list[Question]:
    """Return one question for each line type of the dieline that the machine cannot make."""
    return [
        Question(
            kind="tool",
            message=Message(
                "question.tool", edges=len(edges), type=kind.word, machine=machine.title
            ),
            choices=_makeable(machine),
            edges=tuple(edges.tolist()),
        )
        for kind in LineType
        if len(edges := np.flatnonzero(dieline.line_type == kind)) and lacks_tool(machine, kind)
    ]


def _makeable(machine: Machine) -> tuple[str, ...]:
    """Return the names of the line types that the machine can make."""
    return tuple(
        kind.word
        for kind in LineType
        if kind != LineType.UNCLASSIFIED and not lacks_tool(machine, kind)
    )
