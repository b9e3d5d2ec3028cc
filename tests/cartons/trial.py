"""Compile jobs as their users would: answer questions, accept shortfalls, and follow hints."""

from __future__ import annotations

import traceback
from collections import Counter
from dataclasses import dataclass, field, replace

import numpy as np

from knifetip import pipeline
from knifetip.errors import KnifetipError
from knifetip.geometry.columns import U8
from knifetip.model.acceptance import with_exceptions
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.machine import Machine
from knifetip.model.verdict import Acceptance, Severity, Verdict
from tests.cartons.hints import LEFT_OUT, follow
from tests.cartons.job import Job

#: Greatest number of hints that are followed one after the other.
_MOST_HINTS = 8


@dataclass(frozen=True, eq=False)
class Attempt:
    """What is compiled; hints change it."""

    drawing: Drawing
    line_type: U8  #: (n,) LineType of each edge
    machine: Machine
    board: Board
    dialect: str
    options: JobOptions

    @property
    def dieline(self) -> Dieline:
        """The edges of the drawing with their line types."""
        return pipeline.interpret(self.drawing, Interpretation(overrides=self.line_type.tobytes()))


@dataclass
class Outcome:
    """What became of a job."""

    fate: str = ""  #: "accepted", "excepted", "by hint", "left out", "stuck" or "error"
    #: code → number of findings or errors of that code in the first compile
    refusals: Counter[str] = field(default_factory=Counter)
    followed: list[str] = field(default_factory=list)  #: "code: what was done"
    text: str = ""  #: the last refusal, or the traceback of an internal error
    mistyped: int = 0  #: edges whose line type the classification got wrong without a question
    asked: int = 0  #: questions about line types and units
    shortfalls: Counter[str] = field(default_factory=Counter)
    attempt: Attempt | None = None
    compiled: pipeline.Compiled | None = None


def attempt_job(job: Job) -> Outcome:
    """Compile a job, following hints, until a program is accepted or no hint is left."""
    outcome = Outcome()
    try:
        _attempt(job, outcome)
    except Exception:
        outcome.fate, outcome.text = "error", traceback.format_exc()
    return outcome


def attempt_drawing(data: bytes, machine: Machine, board: Board) -> Outcome:
    """Compile a file whose questions are all answered with the likeliest choice, following hints.

    The fate of a file that cannot be read is "stuck".
    """
    outcome = Outcome()
    try:
        drawing = pipeline.read(data)
        asked = pipeline.questions(drawing, pipeline.interpret(drawing, Interpretation()))
        if asked and asked[0].kind == "unit":
            drawing = pipeline.read(data, asked[0].choices[0])
        dieline = pipeline.interpret(drawing, Interpretation())
        line_type = dieline.line_type.copy()
        for question in pipeline.questions(drawing, dieline):
            line_type[list(question.edges)] = LineType.from_word(question.choices[0])
        attempt = Attempt(drawing, line_type, machine, board, machine.dialect, JobOptions())
        _follow_hints(attempt, outcome)
    except KnifetipError as error:
        outcome.fate, outcome.text = "stuck", str(error)
        outcome.refusals[error.message.code] += 1
    except Exception:
        outcome.fate, outcome.text = "error", traceback.format_exc()
    return outcome


def _attempt(job: Job, outcome: Outcome) -> None:
    _follow_hints(_opened(job, outcome), outcome)


def _follow_hints(attempt: Attempt, outcome: Outcome) -> None:
    """Compile an attempt, following hints; write what became of it into ``outcome``."""
    for _ in range(_MOST_HINTS):
        outcome.attempt = attempt
        refusal = _compile(attempt, outcome)
        if refusal is None:
            if outcome.followed:
                left_out = any(step.endswith(LEFT_OUT) for step in outcome.followed)
                outcome.fate = LEFT_OUT if left_out else "by hint"
            return
        changed = follow(refusal, attempt)
        if changed is None:
            break
        done, attempt = changed
        outcome.followed.append(f"{refusal.code}: {done}")
    outcome.fate = "stuck"


@dataclass(frozen=True, eq=False)
class Refusal:
    """One reason why a job is refused."""

    code: str
    text: str
    arguments: dict[str, object]
    edges: tuple[int, ...]  #: rows of the drawing that the reason names


def _opened(job: Job, outcome: Outcome) -> Attempt:
    """Return the first attempt at a job, whose line types are those that were drawn."""
    drawing = pipeline.read(job.data)
    if not drawing.unit:
        outcome.asked += 1
        drawing = pipeline.read(job.data, "mm")
    decided = pipeline.interpret(drawing, Interpretation())
    outcome.asked += len(pipeline.questions(drawing, decided))
    truth = np.array(
        [
            job.truth[drawing.layers[layer], colour]
            for layer, colour in zip(drawing.layer.tolist(), drawing.colour.tolist(), strict=True)
        ],
        np.uint8,
    )
    wrong = (decided.line_type != truth) & (decided.line_type != LineType.UNCLASSIFIED)
    outcome.mistyped = int(wrong.sum())
    return Attempt(drawing, truth, job.machine, job.board, job.dialect, job.options)


def _compile(attempt: Attempt, outcome: Outcome) -> Refusal | None:
    """Compile an attempt; return why it is refused, None if the program is accepted."""
    first = not outcome.followed
    dieline = attempt.dieline
    asked = pipeline.questions(attempt.drawing, dieline, attempt.machine)
    if asked:
        question = asked[0]
        outcome.refusals[question.message.code] += first
        return Refusal(
            question.message.code, question.text, dict(question.message.arguments), question.edges
        )
    try:
        compiled = pipeline.compile(
            attempt.drawing,
            dieline,
            attempt.machine,
            attempt.board,
            options=attempt.options,
            dialect=attempt.dialect,
        )
    except KnifetipError as error:
        message = error.message
        outcome.text = str(error)
        while message.code == "error.at-edge":
            message = message.arguments["error"]
        outcome.refusals[message.code] += first
        return Refusal(message.code, str(error), dict(message.arguments), error.edges)
    for finding in compiled.verdict.findings:
        if finding.severity is Severity.FAULT:
            outcome.text = finding.text
            outcome.refusals[finding.message.code] += first
    for finding in compiled.verdict.findings:
        if finding.severity is Severity.FAULT:
            message = finding.message
            return Refusal(message.code, finding.text, dict(message.arguments), finding.all_edges)
    verdict = _excepted(compiled.verdict, outcome)
    outcome.compiled = replace(compiled, verdict=verdict)
    assert verdict.accepted
    return None


def _excepted(verdict: Verdict, outcome: Outcome) -> Verdict:
    """Return the verdict with all shortfalls accepted, and count them."""
    chosen = set()
    for finding in verdict.findings:
        if finding.severity is Severity.SHORTFALL:
            outcome.shortfalls[finding.message.code] += 1
            chosen.add((finding.edge, finding.message.code))
    outcome.fate = "excepted" if chosen else "accepted"
    return with_exceptions(verdict, chosen, Acceptance("tests", "as drawn", 0.0))
