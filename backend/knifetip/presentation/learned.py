"""Answers from earlier drawings of a customer, as JSON data."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from knifetip.messages import printable
from knifetip.model.customer_answers import LearnedAnswer, learned_from_text
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing


def learned_json(drawing: Drawing, dieline: Dieline, learned: str) -> list[dict[str, Any]]:
    """Return the learned answers that decided edges of a drawing, with the rows of these edges.

    Parameters
    ----------
    drawing, dieline
        The drawing, and its edges with their line types.
    learned
        Learned answers, see ``customer_answers.learned_text``.
    """
    from knifetip.classification.customer_answers import learned_edges

    found = learned_edges(drawing, dieline, learned_from_text(learned))
    return [{**answer_json(one), "edges": rows.tolist()} for one, rows in found.items()]


def answer_json(answer: LearnedAnswer) -> dict[str, Any]:
    """Return a learned answer as JSON data: its look, its line type and its drawings."""
    return {
        **asdict(answer.look),
        "type": answer.line_type.word,
        "drawings": [printable(name) for name in answer.drawings],
    }
