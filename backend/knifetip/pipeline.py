"""The one place that knows the order of the stages.

bytes → Drawing → Dieline → Cleaned → Operations → Toolpaths → Toolpath → Program → Verdict
    read    classify    clean    plan     compensate   sequence  process    verify

Whoever calls knows the rows of the drawing; what is planned and judged are the cleaned edges.  All
that goes out of here is told of the drawing's rows again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Final

import numpy as np

from knifetip.classification import classify
from knifetip.classification import rules as matching
from knifetip.cleaning.back import on_drawn
from knifetip.cleaning.clean import clean
from knifetip.compensation import deflection
from knifetip.compensation.compensate import compensate
from knifetip.errors import (
    CompensationError,
    KnifetipError,
    OpenQuestions,
    PlanError,
    TravelExceeded,
)
from knifetip.geometry.columns import I32, U8
from knifetip.intake.kind import kind_of
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.cleaned import Cleaned
from knifetip.model.corners import Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, extents
from knifetip.model.machine import Machine
from knifetip.model.profile import LineRules, ProposedRule
from knifetip.model.program import Program
from knifetip.model.question import Question
from knifetip.model.toolpath import Toolpath
from knifetip.model.unit import NAMES, UnitFinding
from knifetip.model.verdict import Verdict
from knifetip.planning.plan import check_corners, missing, plan
from knifetip.post.emit import process
from knifetip.sequencing.duration import duration
from knifetip.sequencing.sequence import sequence
from knifetip.sequencing.turning import retracted
from knifetip.units.evidence import judge
from knifetip.units.question import question as unit_question
from knifetip.units.rescale import rescaled
from knifetip.verification import verify as judging
from knifetip.verification.tidied import tidied
from knifetip.verification.verify import placement_of

__all__ = [
    "NO_OVERRIDE",
    "TOLERANCE",
    "Calibration",
    "Compiled",
    "calibrated",
    "check_corners",
    "clean",
    "compiled",
    "dieline",
    "learned",
    "placement",
    "placement_of",
    "questions",
    "read_drawing",
    "taken",
    "unit_finding",
    "verify",
    "with_unit",
]

_Reader = Callable[[bytes, str | None], Drawing]
#: Modules that read a file of each kind, each imported when the first such file is read.
_READERS: Final[Mapping[str, str]] = {
    "dxf": "knifetip.dxf.read",
    "cf2": "knifetip.cf2.read",
    "svg": "knifetip.svg.read",
    "pdf": "knifetip.pdf.read",
}
#: How far the tip may be from the line (mm).
TOLERANCE = 0.01
#: In a column of overrides: this edge has none.
NO_OVERRIDE = 255


@dataclass(frozen=True, eq=False, slots=True)
class Compiled:
    """What a drawing became for one machine and one board."""

    toolpath: Toolpath
    program: Program
    verdict: Verdict
    placement: tuple[float, float]  #: added to the drawing's coordinates on the sheet (mm)
    seconds: float  #: that the machine will take, its accelerations counted
    seconds_retracted: float  #: that it would take if every turn were a full retract


@dataclass(frozen=True, slots=True)
class Calibration:
    """How far a cutter gives way in a board, from measured points."""

    x: float  #: δx (mm)
    y: float  #: δy (mm)
    residual: float  #: the farthest that a point is from what these two say (mm)


def read_drawing(data: bytes, unit: str | None = None) -> Drawing:
    """Return the drawing in the bytes of a file, told by its content: DXF, CF2, SVG or PDF.

    ``unit`` overrules what the file says.  Where nobody gives one, the file's word is weighed
    against what is drawn: it stands, or another unit is so much likelier that it is taken, or the
    drawing stays in file units and asks.

    Raises
    ------
    ReadError
        The bytes are not a drawing that can be used.
    """
    reader: _Reader = import_module(_READERS[kind_of(data)]).read
    drawing = reader(data, unit)
    if unit:
        return drawing
    found = judge(drawing)
    if found.unit == drawing.unit:
        return drawing
    if drawing.unit and not drawing.evidence.startswith("$INSUNITS"):
        # Only a DXF states a unit that nobody has chosen: that of the template.
        return drawing
    # Curves are fitted to a tolerance in mm, so they are read again.
    better = reader(data, found.unit) if found.unit else rescaled(drawing, "")
    return replace(better, evidence=f"{drawing.evidence}; {_outcome(found, drawing.stated)}")


def _outcome(found: UnitFinding, stated: str) -> str:
    best = found.ranking[0]
    if best == stated:
        return f"what is drawn says too little for {NAMES[best]}"
    reason = next(one.text for one in found.evidence if one.unit == best)
    return f"what is drawn speaks for {NAMES[best]}: {reason}"


def with_unit(drawing: Drawing, unit: str) -> Drawing:
    """Return the drawing with its unit given: "mm", "cm", "m", "in", "ft", "pt" or "px"."""
    return rescaled(drawing, unit)


def dieline(drawing: Drawing, rules: LineRules, overrides: U8 | None = None) -> Dieline:
    """Return the drawing's edges with their line types.

    Parameters
    ----------
    overrides : (n,) LineType, or ``NO_OVERRIDE``
    """
    classified = classify.classify(drawing, rules, load.conventions())
    return classified if overrides is None else classify.overridden(classified, overrides)


def taken(drawing: Drawing, rules: LineRules) -> I32:
    """Return which rule of a profile takes each edge, (n,): -1 where none does."""
    styles = matching.styles(drawing)
    return matching.match(styles, rules).rule[styles.of]


def learned(drawing: Drawing, rules: LineRules, overrides: U8) -> list[ProposedRule]:
    """Return rules that would have said what somebody corrected, those that explain most first."""
    from knifetip.classification import learn

    return learn.learned(
        drawing, classify.classify(drawing, rules, load.conventions()), overrides, rules
    )


def unit_finding(drawing: Drawing) -> UnitFinding:
    """Return what speaks for the unit of a drawing's file, whatever was decided."""
    return judge(drawing)


def questions(drawing: Drawing, dieline: Dieline, machine: Machine | None = None) -> list[Question]:
    """Return what somebody must decide before the drawing can be made (on that machine)."""
    unit = None if drawing.unit else unit_question(drawing, judge(drawing))
    asked = ([unit] if unit else []) + classify.questions(drawing, dieline)
    if machine is not None:
        asked += _without_tool(dieline, machine)
    return asked


def _without_tool(dieline: Dieline, machine: Machine) -> list[Question]:
    asked = []
    for kind in LineType:
        edges = np.flatnonzero(dieline.line_type == kind)
        if len(edges) and missing(kind, machine):
            choices = [
                other.word
                for other in LineType
                if other != LineType.UNCLASSIFIED and not missing(other, machine)
            ]
            asked.append(
                Question(
                    kind="tool",
                    message=Message(
                        "question.tool", edges=len(edges), type=kind.word, machine=machine.title
                    ),
                    choices=tuple(choices),
                    edges=tuple(int(edge) for edge in edges),
                )
            )
    return asked


def placement(dieline: Dieline, machine: Machine) -> tuple[float, float]:
    """Return what puts the lower left corner of the worked edges on the machine's origin (mm).

    Raises
    ------
    TravelExceeded
        The drawing is larger than the table.
    """
    worked = ~np.isin(dieline.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    low_x, low_y, high_x, high_y = extents(dieline.ends[worked], dieline.bulge[worked])
    x, y = machine.origin
    if high_x - low_x > machine.width - x or high_y - low_y > machine.height - y:
        raise TravelExceeded(
            f"The drawing is {high_x - low_x:.1f} × {high_y - low_y:.1f} mm, and {machine.title} "
            f"has room for {machine.width - x:.0f} × {machine.height - y:.0f} mm.",
            "Check the unit of the drawing, turn it, or choose a larger machine.",
        )
    # To the last place that a program prints, so that its header says it exactly.
    return round(x - float(low_x), 4), round(y - float(low_y), 4)


def _placed(error: KnifetipError, drawing: Drawing, source: I32) -> KnifetipError:
    """Return the error of a stage, which knows rows of edges, in the words of the drawing."""
    rows = [int(source[int(row)]) for row in error.source]
    if rows:
        layer, handles = drawing.layers[drawing.layer[rows[0]]], drawing.handles
        error.message = f'{error.message.rstrip(".")} (handle {handles[rows[0]]}, layer "{layer}").'
        error.source = tuple(handles[row] for row in rows)
    return error


def compiled(
    drawing: Drawing,
    dieline: Dieline,
    machine: Machine,
    board: Board,
    *,
    corners: Corners | None = None,
    dialect: str = "",
    notes: Sequence[str] = (),
    progress: Callable[[str, float], None] = lambda _stage, _share: None,
) -> Compiled:
    """Return the program that makes a dieline, and what the judge says of it.

    Parameters
    ----------
    corners
        How a cutter goes round corners; None leaves it to the machine's accelerations.
    dialect
        Name of a controller language; the machine's own where none is given.
    notes
        More comments for the head of the program.
    progress
        Is told the stage and how much of all is done, 0 … 1.

    Raises
    ------
    OpenQuestions
        The unit, an edge or a tool is not decided.
    PlanError, CompensationError
        The drawing cannot be made on this machine and board.
    """
    machine = with_language(machine, dialect)
    asked = questions(drawing, dieline, machine)
    if asked:
        raise OpenQuestions([question.as_json() for question in asked])
    progress("clean", 0.02)
    tidy = clean(dieline)
    where = placement(tidy.dieline, machine)
    placed = replace(tidy.dieline, ends=tidy.dieline.ends + np.array(where))
    try:
        progress("plan", 0.05)
        chosen = None if corners is None else replace(corners, placement=where)
        operations = plan(placed, machine, board, chosen)
        progress("compensate", 0.2)
        toolpaths = [compensate(operation) for operation in operations]
        progress("sequence", 0.4)
        toolpath = sequence(toolpaths, machine)
    except (PlanError, CompensationError) as error:
        raise _placed(error, drawing, tidy.dieline.source) from None
    toolpath = _shown(toolpath, tidy)
    progress("process", 0.5)
    head = (
        f"machine {machine.name}",
        f"board {board.name} caliper {board.caliper:g}",
        f"placement X{where[0]:.4f} Y{where[1]:.4f}",
        *notes,
    )
    program = process(toolpath, machine, tolerance=TOLERANCE, notes=head)
    progress("verify", 0.7)
    verdict = _judged(program.text, dieline, tidy, where, machine, board)
    progress("done", 1.0)
    full = duration(retracted(toolpath, machine), machine)
    return Compiled(toolpath, program, verdict, where, duration(toolpath, machine), full)


def verify(
    text: bytes,
    dieline: Dieline,
    placement: tuple[float, float],
    machine: Machine,
    board: Board,
    *,
    tolerance: float = TOLERANCE,
) -> Verdict:
    """Return the verdict on a program that somebody brings, of the edges as they were drawn.

    Raises
    ------
    ProgramUnreadable, ProgramError, GeometryError
        As ``verification.verify`` says.
    """
    return _judged(text, dieline, clean(dieline), placement, machine, board, tolerance)


def _judged(
    text: bytes,
    dieline: Dieline,
    tidy: Cleaned,
    where: tuple[float, float],
    machine: Machine,
    board: Board,
    tolerance: float = TOLERANCE,
) -> Verdict:
    """Return whether a program makes the cleaned edges, and whether those are what was drawn."""
    verdict = judging.verify(text, tidy.dieline, where, machine, board, tolerance=tolerance)
    told = on_drawn(verdict, tidy, dieline)
    lost = tidied(dieline, tidy)
    if not lost:
        return told
    return replace(told, accepted=False, findings=(*lost, *told.findings))


def _shown(toolpath: Toolpath, tidy: Cleaned) -> Toolpath:
    """Return the head's path with the rows of the drawing that it is about."""
    source = tidy.dieline.source[np.maximum(toolpath.source, 0)]
    return replace(toolpath, source=np.where(toolpath.source < 0, -1, source))


def calibrated(
    azimuth: Sequence[float], measured: Sequence[tuple[float, float]], side: int = 1
) -> Calibration:
    """Return how far a cutter gives way, from points measured on a contour that it cut.

    Parameters
    ----------
    azimuth : degrees
        In which direction the cutter ran along the contour at each point, 0 along X.
    measured : mm
        ΔX and ΔY at each: where the contour came to lie, less where it was drawn.
    side
        +1 if the cutter ran on the left of travel, as knifetip has it, -1 on the right.

    Raises
    ------
    CompensationError
        The points say too little, with what else to measure.
    """
    angle = np.radians(np.array(azimuth, np.float64))
    tangent = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    moved = np.array(measured, np.float64).reshape(-1, 2)
    x, y = deflection.calibrated(tangent, moved, side)
    off = moved - deflection.deflection(tangent, side, x, y)
    return Calibration(x, y, float(np.hypot(*off.T).max()))
