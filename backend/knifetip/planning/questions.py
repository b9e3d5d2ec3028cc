"""questions: create the questions for the user about line types for which a machine has no tool."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.question import Question
from knifetip.planning.tool_steps import lacks_tool

#: Line types that come nearest to one for which there is no tool, the nearest first.
_INSTEAD: Final[Mapping[LineType, tuple[LineType, ...]]] = {
    LineType.CREASE: (LineType.PERFORATION, LineType.HALF_CUT),
    LineType.COMBI: (LineType.PERFORATION, LineType.CREASE, LineType.HALF_CUT),
    LineType.V_GROOVE: (LineType.CREASE, LineType.PERFORATION, LineType.HALF_CUT),
}


def tool_questions(dieline: Dieline, machine: Machine) -> list[Question]:
    """Return one question for each line type of the dieline that the machine cannot make."""
    questions = []
    for kind in LineType:
        edges = np.flatnonzero(dieline.line_type == kind)
        if len(edges) and lacks_tool(machine, kind):
            choices = _makeable(machine, kind)
            # Only a knife makes perforations, and it makes half-cuts too.
            as_perforation = choices[0] == LineType.PERFORATION
            message = Message(
                "question.tool-for-folds" if as_perforation else "question.tool",
                edges=len(edges),
                type=kind.word,
                machine=machine.title,
            )
            words = tuple(choice.word for choice in choices)
            questions.append(
                Question(kind="tool", message=message, choices=words, edges=tuple(edges.tolist()))
            )
    return questions


def _makeable(machine: Machine, kind: LineType) -> tuple[LineType, ...]:
    """Return the line types that the machine can make, those nearest to ``kind`` first."""
    makeable = [
        other
        for other in LineType
        if other != LineType.UNCLASSIFIED and not lacks_tool(machine, other)
    ]
    nearest = [other for other in _INSTEAD.get(kind, ()) if other in makeable]
    return (*nearest, *(other for other in makeable if other not in nearest))
